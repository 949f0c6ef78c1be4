"""An environment in which no run can come up is refused before it starts: one line, exit 2."""

import os
import subprocess
import time

import pytest
from runs import command, environment

from rvd_campaign.exits import CannotRun
from rvd_campaign.flight import preflight

CANNOT = [
    ('RMW_IMPLEMENTATION', 'rmw_cyclonedds_cpp', 'unset it to use rmw_fastrtps_cpp'),
    ('RMW_IMPLEMENTATION', 'fastrtps', 'unset it to use rmw_fastrtps_cpp'),
    ('ROS_DISCOVERY_SERVER', '127.0.0.1:11811', 'unset it'),
    ('ROS_DISCOVERY_SERVER', ';10.0.0.7:42100', 'unset it'),
    ('ROS_AUTOMATIC_DISCOVERY_RANGE', 'OFF', 'set it to LOCALHOST or SUBNET'),
    ('ROS_AUTOMATIC_DISCOVERY_RANGE', 'localhost', 'set it to LOCALHOST or SUBNET'),
    ('FASTDDS_BUILTIN_TRANSPORTS', 'UDPV4', 'set it to UDPv4'),
    ('FASTDDS_BUILTIN_TRANSPORTS', 'NONE', 'unset it'),
    ('FASTRTPS_DEFAULT_PROFILES_FILE', '/no/such/profiles.xml', 'unset it'),
    ('FASTDDS_DEFAULT_PROFILES_FILE', '/dev/null', 'not valid XML'),
]


@pytest.mark.parametrize('name, value, remedy', CANNOT)
def test_a_variable_that_keeps_nodes_apart_is_refused_with_the_remedy(
        name, value, remedy, tmp_path):
    begun = time.monotonic()
    done = subprocess.run(command('fly', '--out', str(tmp_path / 'run')), cwd=tmp_path,
                          env={**environment(), name: value}, capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (2, '')
    assert done.stderr.count('\n') == 1 and remedy in done.stderr
    assert f'{name}={value}' in done.stderr
    assert not (tmp_path / 'run').exists()
    assert time.monotonic() - begun < 5.0       # instead of a minute, on a busy machine


@pytest.mark.parametrize('value', ['', 'LOCALHOST', 'SUBNET', 'SYSTEM_DEFAULT'])
def test_what_lets_nodes_find_each_other_is_let_be(value):
    preflight.check({**os.environ, 'ROS_AUTOMATIC_DISCOVERY_RANGE': value,
                     'RMW_IMPLEMENTATION': 'rmw_fastrtps_cpp' if value else ''})


@pytest.mark.parametrize('value', ['', 'UDPv4', 'DEFAULT', 'LARGE_DATA?max_msg_size=1MB'])
def test_a_transport_of_fast_dds_is_let_be(value):
    preflight.check({**os.environ, 'FASTDDS_BUILTIN_TRANSPORTS': value})


def test_a_file_of_profiles_is_let_be(tmp_path):
    (tmp_path / 'profiles.xml').write_text('<?xml version="1.0"?><dds/>')
    preflight.check({'FASTRTPS_DEFAULT_PROFILES_FILE': str(tmp_path / 'profiles.xml')})
    (tmp_path / 'profiles.xml').write_text('<dds>')
    with pytest.raises(CannotRun, match='not valid XML'):
        preflight.check({'FASTRTPS_DEFAULT_PROFILES_FILE': str(tmp_path / 'profiles.xml')})


def test_a_loopback_that_is_down_is_named(tmp_path):
    apart = ['unshare', '--map-root-user', '--net']     # a network of its own: lo is there and down
    try:
        subprocess.run([*apart, 'true'], check=True, capture_output=True)
    except (OSError, subprocess.CalledProcessError):
        pytest.skip('this machine lets nobody have a network of his own')
    done = subprocess.run([*apart, *command('fly', '--out', str(tmp_path / 'run'))], cwd=tmp_path,
                          env=environment(), capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (2, '')
    assert done.stderr.count('\n') == 1 and 'sudo ip link set lo up' in done.stderr


def test_an_interface_that_is_not_there_is_not_up():
    assert preflight._is_up('lo') and not preflight._is_up('no_such_one')
