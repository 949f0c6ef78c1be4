"""
Who reaches a run over the network: nobody but this machine, unless somebody asks for more.

The environment of `./rvd` (`scripts/network.sh`) binds the nodes to 127.0.0.1 by a file of Fast DDS
profiles; a flight that was started in another environment gets the same here. Whatever opens a run
is said in one line, by name.
"""

from collections.abc import MutableMapping
import os

from rvd_campaign import catalogue

RANGE, STATIC_PEERS = 'ROS_AUTOMATIC_DISCOVERY_RANGE', 'ROS_STATIC_PEERS'
PROFILES, ONLY_LOCAL = 'FASTRTPS_DEFAULT_PROFILES_FILE', 'ROS_LOCALHOST_ONLY'
# With '1' no DEFAULT_FASTRTPS_PROFILES.xml of the working folder adds to the file that is named.
SKIP = 'SKIP_DEFAULT_XML_FILE'
# What Fast DDS takes where no file of profiles says it: no shared memory, which a process that is
# killed may leave so that all the others hang.
TRANSPORTS, UDP = 'FASTDDS_BUILTIN_TRANSPORTS', 'UDPv4'
OURS = 'config/fastdds_loopback.xml'
USUAL_RMW = 'rmw_fastrtps_cpp'
OPEN = ('SUBNET', 'SYSTEM_DEFAULT')
WARNING = ('open to the network: whoever reaches an interface of this machine sees this run, may '
           'write to it and may abort it')


def settle(network: bool = False, environment: MutableMapping[str, str] = os.environ) -> str:
    """
    Set what decides who reaches the nodes of a run, before any of ROS is loaded.

    Parameters
    ----------
    network : bool
        The user has asked for the network.
    environment : mapping
        Is changed: of this process and all that it starts.

    Returns
    -------
    str
        One line for the user if others may reach the run, or if a variable does not act as one
        may think; empty where this machine alone does.
    """
    asked, profiles = environment.get(RANGE, ''), environment.get(PROFILES, '')
    if profiles.endswith(f'/{OURS}'):           # of this shell, or of another checkout
        profiles = ''
        asked = '' if asked == 'SYSTEM_DEFAULT' else asked
    middleware = environment.get('RMW_IMPLEMENTATION') or USUAL_RMW
    alone = not (network or profiles) and asked in ('', 'LOCALHOST') and middleware == USUAL_RMW
    if not alone:
        environment[TRANSPORTS] = environment.get(TRANSPORTS) or UDP
    if network:
        environment.pop(ONLY_LOCAL, None)
        _put(environment, RANGE, 'SUBNET')
        _put(environment, PROFILES, profiles)
        return f'--network: {WARNING}'
    if alone:
        environment.pop(ONLY_LOCAL, None)       # with it rmw listens on 0.0.0.0 again
        environment[RANGE], environment[SKIP] = 'SYSTEM_DEFAULT', '1'
        environment[PROFILES] = str(catalogue.root() / OURS)
        peers = environment.get(STATIC_PEERS, '')
        return peers and f'{STATIC_PEERS}={peers} does not act without --network: this run is ' \
                         'heard on this machine alone'
    _put(environment, RANGE, asked or 'LOCALHOST')
    _put(environment, PROFILES, profiles)
    if asked in OPEN and not profiles:
        return f'{RANGE}={asked}: {WARNING}'
    what = f'{PROFILES}={profiles}' if profiles else f'RMW_IMPLEMENTATION={middleware}'
    return f'{what}: on which interfaces this run listens is for that to say, and it may be all'


def _put(environment: MutableMapping[str, str], name: str, value: str) -> None:
    if value:
        environment[name] = value
    else:
        environment.pop(name, None)
