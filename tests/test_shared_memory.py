"""
What a killed process leaves in shared memory takes no run down: no node uses any.

Each test has a /dev/shm of its own, in which ports of Fast DDS are half made, as by a process that
was killed at that moment.
"""

import os
import shutil
import signal
import subprocess
import sys

import pytest
from runs import command, environment

from rvd_campaign.flight import reach

PORTS = range(7000, 7040)       # of /ros_discovery_info, in every domain
HALF_MADE = f'''
mount -t tmpfs none /dev/shm
for port in {' '.join(map(str, PORTS))}; do truncate -s 52400 /dev/shm/fastrtps_port$port; done
"$@"
code=$?
ls /dev/shm | grep fast >&2      # what is LTTng's is none of ours
exit $code
'''
NODE = '''
import os, rclpy
rclpy.init()
rclpy.create_node('alone')
os._exit(0)
'''


@pytest.fixture
def among_remains(tmp_path):
    """Return what runs a command on such a machine: its code, and what stands in /dev/shm then."""
    apart = ['unshare', '--mount', '--propagation', 'private']
    if not shutil.which('unshare') or subprocess.run([*apart, 'mount', '-t', 'tmpfs', 'none',
                                                      '/dev/shm'], capture_output=True).returncode:
        pytest.skip('this user may not mount a /dev/shm of his own: root may')

    def run(*words, **variables):
        done = subprocess.run([*apart, 'bash', '-c', HALF_MADE, 'bash', *words], cwd=tmp_path,
                              env={**environment(), **variables}, capture_output=True, text=True)
        return done.returncode, done.stderr.splitlines()
    return run


def test_a_flight_neither_needs_shared_memory_nor_leaves_any(among_remains, tmp_path):
    code, left = among_remains(*command('fly', '--pace', 'lockstep', '--seed', '3',
                                        '--out', str(tmp_path / 'run')))
    assert code == 0, left
    assert left == sorted(f'fastrtps_port{port}' for port in PORTS)


@pytest.mark.parametrize('transports, hangs', [(reach.UDP, False), ('DEFAULT', True)])
def test_a_node_on_the_network_does_not_hang_either(transports, hangs, among_remains, own_domain):
    """The twin, with what Fast DDS takes by itself, does: that is the cause."""
    # SIGTERM is not heard by a process that waits in there
    code, _ = among_remains('timeout', '--signal=KILL', '20', sys.executable, '-c', NODE, **{
        reach.PROFILES: '', reach.SKIP: '', reach.RANGE: 'SUBNET', reach.TRANSPORTS: transports,
        'ROS_DOMAIN_ID': os.environ['ROS_DOMAIN_ID']})
    assert code == (128 + signal.SIGKILL if hangs else 0)
