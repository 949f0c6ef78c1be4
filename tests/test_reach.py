"""Who reaches a run: this machine alone, unless somebody asks for more; then that is said."""

import json
import os
import shutil
import subprocess
import sys

import pytest
from runs import command, end, environment, in_flight, ROOT, start_rvd, wait_for

from rvd_campaign.flight import reach
from rvd_campaign.flight.domain import reserved_domain

LOOPBACK = str(ROOT / reach.OURS)
ALONE = {reach.RANGE: 'SYSTEM_DEFAULT', reach.PROFILES: LOOPBACK, reach.SKIP: '1'}
OPEN = {reach.TRANSPORTS: reach.UDP}            # where another than our file of profiles decides
NAMES = (reach.RANGE, reach.PROFILES, reach.SKIP, reach.ONLY_LOCAL, reach.STATIC_PEERS,
         reach.TRANSPORTS, 'RMW_IMPLEMENTATION')
# What a user has set; what it becomes; a word of the line that he gets, empty: none.
CASES = [
    ({}, ALONE, ''),
    ({reach.RANGE: 'LOCALHOST'}, ALONE, ''),
    (ALONE, ALONE, ''),                                 # in `./rvd shell`
    ({**ALONE, reach.PROFILES: f'/another/checkout/{reach.OURS}'}, ALONE, ''),
    ({reach.ONLY_LOCAL: '1'}, ALONE, ''),
    ({reach.STATIC_PEERS: '10.0.0.7'}, {**ALONE, reach.STATIC_PEERS: '10.0.0.7'}, '10.0.0.7'),
    ({reach.RANGE: 'SUBNET'}, {**OPEN, reach.RANGE: 'SUBNET'},
     'RANGE=SUBNET: open to the network'),
    ({reach.RANGE: 'SUBNET', reach.TRANSPORTS: ''}, {**OPEN, reach.RANGE: 'SUBNET'},
     'open to the network'),
    ({reach.RANGE: 'SUBNET', reach.TRANSPORTS: 'DEFAULT'},
     {reach.RANGE: 'SUBNET', reach.TRANSPORTS: 'DEFAULT'}, 'open to the network'),
    ({**ALONE, reach.RANGE: 'SUBNET'}, {**OPEN, reach.RANGE: 'SUBNET', reach.SKIP: '1'},
     'open to the network'),
    ({reach.RANGE: 'SYSTEM_DEFAULT'}, {**OPEN, reach.RANGE: 'SYSTEM_DEFAULT'},
     'open to the network'),
    ({reach.PROFILES: '/my.xml'},
     {**OPEN, reach.RANGE: 'LOCALHOST', reach.PROFILES: '/my.xml'}, '/my.xml'),
    ({**ALONE, 'RMW_IMPLEMENTATION': 'rmw_cyclonedds_cpp'},
     {**OPEN, reach.RANGE: 'LOCALHOST', reach.SKIP: '1',
      'RMW_IMPLEMENTATION': 'rmw_cyclonedds_cpp'},
     'rmw_cyclonedds_cpp'),
]


@pytest.mark.parametrize('given, becomes, said', CASES)
def test_this_machine_alone_is_the_default_and_what_opens_it_is_said(given, becomes, said):
    settled = dict(given)
    line = reach.settle(False, settled)
    assert settled == becomes
    assert said in line and bool(said) == bool(line) and '\n' not in line


@pytest.mark.parametrize('given', [given for given, _, _ in CASES])
def test_the_network_is_opened_on_purpose_and_that_is_said(given):
    settled = dict(given)
    line = reach.settle(True, settled)
    assert settled[reach.RANGE] == 'SUBNET'
    assert settled[reach.TRANSPORTS] == (given.get(reach.TRANSPORTS) or reach.UDP)
    assert settled.get(reach.PROFILES) == (given.get(reach.PROFILES) if given.get(
        reach.PROFILES) == '/my.xml' else None)
    assert line.startswith('--network: open to the network')


@pytest.mark.parametrize('given, becomes, _', CASES)
def test_the_environment_of_a_shell_is_that_of_a_flight(given, becomes, _):
    script = f'source {ROOT}/scripts/network.sh; source {ROOT}/scripts/network.sh; env -0'
    told = subprocess.run(['bash', '-euc', script], env={
        'PATH': os.environ['PATH'], 'RVD_ROOT': str(ROOT), **given}, check=True,
        capture_output=True, text=True).stdout
    found = dict(line.split('=', 1) for line in told.split('\0') if '=' in line)
    assert {name: found[name] for name in NAMES if name in found} == becomes


# -- the sockets of a process ---------------------------------------------------------------------

NODE = """
import os, rclpy
rclpy.init()
node = rclpy.create_node('alone')
mine = set()
for file in os.listdir('/proc/self/fd'):
    try:
        mine.add(os.readlink(f'/proc/self/fd/{file}'))
    except OSError:
        pass
for kind in 'udp', 'udp6', 'tcp', 'tcp6':
    for line in open(f'/proc/net/{kind}').readlines()[1:]:
        words = line.split()
        if f'socket:[{words[9]}]' in mine:
            print(kind, words[1].split(':')[0])
os._exit(0)
"""
LOCAL, ANY = '0100007F', '00000000'             # as /proc/net/udp writes 127.0.0.1 and 0.0.0.0


@pytest.mark.parametrize('alone', [True, False])
def test_no_socket_of_a_node_is_bound_to_anything_but_loopback(alone, own_domain, tmp_path):
    """The twin is what ROS_AUTOMATIC_DISCOVERY_RANGE=LOCALHOST gives without our profiles."""
    env = {k: v for k, v in os.environ.items() if k not in NAMES}
    env |= ALONE if alone else {reach.RANGE: 'LOCALHOST'}
    done = subprocess.run([sys.executable, '-c', NODE], env=env, cwd=tmp_path, check=True,
                          capture_output=True, text=True)
    sockets = [line.split() for line in done.stdout.splitlines()]
    assert len(sockets) >= 3 and {kind for kind, _ in sockets} == {'udp'}
    assert (ANY in {address for _, address in sockets}) == (not alone)
    if alone:
        assert {address for _, address in sockets} == {LOCAL}


# -- another machine ------------------------------------------------------------------------------

# What a stranger with `ROS_STATIC_PEERS` sees of a run in so many seconds, and can do to it once he
# sees the nodes named, as JSON.
STRANGER = """
import json, sys, time
import rclpy
from rvd_interfaces.srv import RunControl
rclpy.init()
node = rclpy.create_node('stranger')
client = node.create_client(RunControl, '/run/control')
until, wanted = time.monotonic() + float(sys.argv[1]), set(sys.argv[2:])
seen, answered = set(), False
while time.monotonic() < until and not answered:
    rclpy.spin_once(node, timeout_sec=0.1)
    seen |= set(node.get_node_names()) - {'stranger'}
    if client.service_is_ready() and wanted <= seen:
        future = client.call_async(RunControl.Request(action=RunControl.Request.ABORT))
        rclpy.spin_until_future_complete(node, future, timeout_sec=30.0)
        answered = bool(future.done() and future.result().accepted)
print(json.dumps({'seen': sorted(seen), 'aborted': answered}))
"""
OURS, HIS = '10.213.7.1', '10.213.7.2'
WANTED = {'spacecraft_dynamics', 'link_back'}   # of the spacecraft, and of the link
ABORTED = 'abort goes out with the next frame'


class Machine:
    """A network, a /dev/shm and an IPC namespace of its own; gone when its first process is."""

    def __init__(self) -> None:
        self.init = subprocess.Popen(
            ['unshare', '--net', '--mount', '--ipc', '--propagation', 'private', 'sh', '-c',
             'mount -t tmpfs none /dev/shm && ip link set lo up && echo up && exec sleep 600'],
            stdout=subprocess.PIPE, text=True)
        if self.init.stdout.readline() != 'up\n':
            self.close()
            pytest.skip('this user may not make namespaces of the network: root may')

    def words(self, *command: str) -> list[str]:
        return ['nsenter', '--target', str(self.init.pid), '--net', '--mount', '--ipc',
                f'--wd={os.getcwd()}', *command]

    def run(self, *command: str) -> None:
        subprocess.run(self.words(*command), check=True, capture_output=True)

    def close(self) -> None:
        self.init.kill()
        self.init.wait()
        self.init.stdout.close()


@pytest.fixture
def machines():
    """Return two machines and a cable between them."""
    if not all(map(shutil.which, ('ip', 'nsenter', 'unshare'))):
        pytest.skip('ip, nsenter and unshare make a second machine: not all are installed')
    made = [Machine()]
    try:
        made.append(Machine())
        made[0].run('ip', 'link', 'add', 'cable', 'type', 'veth', 'peer', 'name', 'cable', 'netns',
                    str(made[1].init.pid))
        for machine, address in zip(made, (OURS, HIS)):
            machine.run('ip', 'address', 'add', f'{address}/24', 'dev', 'cable')
            machine.run('ip', 'link', 'set', 'cable', 'up')
        yield made
    finally:
        for machine in made:
            machine.close()


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('options, open_to', [((), False), (('--network',), True)])
def test_a_stranger_on_another_machine_sees_nothing_and_aborts_nothing(
        options, open_to, machines, tmp_path, monkeypatch):
    """He knows the address and the domain; the twin, to which --network opens it, is aborted."""
    ours, his = machines
    with reserved_domain() as number:
        domain = str(int(number))
    env = {k: v for k, v in environment().items() if k not in NAMES} | {'ROS_DOMAIN_ID': domain}
    monkeypatch.setattr('runs.environment', lambda: env)
    monkeypatch.setattr('runs.command', lambda *words: ours.words(*command(*words)))
    process = start_rvd('fly', '--pace', '1', '--headless', '--out', str(tmp_path / 'run'),
                        *options, cwd=tmp_path)
    try:
        in_flight(tmp_path / 'run', 2)
        told = subprocess.run(
            his.words(sys.executable, '-c', STRANGER, '60' if open_to else '5', *WANTED),
            env={**env, reach.RANGE: 'SUBNET', reach.STATIC_PEERS: OURS}, cwd=tmp_path,
            check=True, capture_output=True, text=True).stdout
        assert process.poll() is None
        if open_to:                             # it is said with a frame of the ground: not at once
            wait_for(lambda: ABORTED in (tmp_path / 'out').read_text(), 'the abort')
    finally:
        end(process)
    found, out = json.loads(told), (tmp_path / 'out').read_text()
    assert ('open to the network' in out) == open_to
    if open_to:
        assert WANTED <= set(found['seen']) and found['aborted']
        assert ABORTED in out
    else:
        assert found == {'seen': [], 'aborted': False} and 'abort' not in out
