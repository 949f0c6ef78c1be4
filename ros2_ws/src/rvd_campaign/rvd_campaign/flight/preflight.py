"""
What in the environment would keep the nodes of a run from finding each other, said before it
starts.

The middleware says it late or not at all: a node ends with code 102, or a run waits for a minute.
"""

from collections.abc import Mapping
import fcntl
import os
from pathlib import Path
import socket
import struct
import subprocess
import sys
from xml.etree import ElementTree

from rvd_campaign.exits import CannotRun

USUAL_RMW = 'rmw_fastrtps_cpp'
RANGES = ('LOCALHOST', 'SUBNET', 'SYSTEM_DEFAULT')
# Of Fast DDS 2.14; it takes any other word for DEFAULT. With '?' come options of LARGE_DATA.
TRANSPORTS = ('UDPv4', 'UDPv6', 'SHM', 'DEFAULT', 'DEFAULTv6', 'LARGE_DATA', 'LARGE_DATAv6')
PROFILES = ('FASTRTPS_DEFAULT_PROFILES_FILE', 'FASTDDS_DEFAULT_PROFILES_FILE')
GET_FLAGS, IS_UP = 0x8913, 0x1          # SIOCGIFFLAGS and IFF_UP, linux/sockios.h and net/if.h


def check(environment: Mapping[str, str] = os.environ) -> None:
    """
    Refuse an environment in which no run can come up.

    Raises
    ------
    CannotRun
        With one line that names the variable, or the interface, and the remedy.
    """
    if environment.get('ROS_DISCOVERY_SERVER'):
        raise CannotRun(f'ROS_DISCOVERY_SERVER={environment["ROS_DISCOVERY_SERVER"]}: the nodes of '
                        'a run find each other by themselves, not through a server: unset it')
    reach = environment.get('ROS_AUTOMATIC_DISCOVERY_RANGE') or RANGES[0]
    if reach not in RANGES:
        raise CannotRun(f'ROS_AUTOMATIC_DISCOVERY_RANGE={reach}: the nodes of a run must find each '
                        f'other: unset it, or set it to {" or ".join(RANGES[:2])}')
    for name in PROFILES:
        if environment.get(name):
            _check_profiles(name, Path(environment[name]))
    if reach != 'SUBNET' and not _is_up('lo'):
        raise CannotRun('the loopback interface lo is down, through which the nodes of a run find '
                        'each other: sudo ip link set lo up')
    middleware = environment.get('RMW_IMPLEMENTATION') or USUAL_RMW
    transports = environment.get('FASTDDS_BUILTIN_TRANSPORTS', '')
    if middleware == USUAL_RMW and transports.partition('?')[0] not in ('', *TRANSPORTS):
        raise CannotRun(f'FASTDDS_BUILTIN_TRANSPORTS={transports}: no word of Fast DDS with which '
                        f'nodes find each other: unset it, or set it to {" or ".join(TRANSPORTS)}')
    if middleware != USUAL_RMW and not _loads(environment):
        raise CannotRun(f'RMW_IMPLEMENTATION={middleware} is not installed here, or does not load: '
                        f'unset it to use {USUAL_RMW}')


def _check_profiles(name: str, path: Path) -> None:
    try:
        ElementTree.parse(path)
    except OSError as error:
        raise CannotRun(f'{name}={path} cannot be read ({error.strerror}): unset it, or name a '
                        'file of profiles') from None
    except (ElementTree.ParseError, ValueError) as error:
        raise CannotRun(f'{name}={path} is not valid XML ({error}): mend it, or unset {name}'
                        ) from None


def _is_up(interface: str) -> bool:
    """Say whether a network interface of this network namespace is up; /sys shows another's."""
    with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as any_socket:
        try:
            found = fcntl.ioctl(any_socket, GET_FLAGS,
                                struct.pack('16sH14x', interface.encode(), 0))
        except OSError:                         # there is none of that name
            return False
    return bool(struct.unpack('16sH14x', found)[1] & IS_UP)


def _loads(environment: Mapping[str, str]) -> bool:
    """Say whether ROS starts; one that does not find its middleware ends the whole process."""
    return subprocess.run([sys.executable, '-c', 'import rclpy; rclpy.init()'],
                          env=dict(environment), stdin=subprocess.DEVNULL,
                          stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0
