"""Two runs that meet in one domain, of two users or machines: neither takes the other's data."""

import os
import re
import signal
import time

import pytest
import rclpy
from rclpy.serialization import serialize_message
from runs import end, in_flight, messages, ROOT, rvd, start_rvd, verdict_of, wait_for
from std_msgs.msg import String

from rvd_campaign.flight.domain import reserved_domain
from rvd_dynamics.diagram import identity
from rvd_dynamics.diagram.ros.arguments import parsed
from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.ros.main import make

OTHER = r'another run (is in|has come into) ROS_DOMAIN_ID=(\d+): .*run [0-9a-f]{32} of machine \w+'


# -- identity by itself ----------------------------------------------------------------------------

def test_no_two_runs_have_the_same_identity_and_ros_takes_it():
    runs = {identity.new_run() for _ in range(100)}
    assert len(runs) == 100
    assert all(re.fullmatch(r'(/[A-Za-z0-9_]+)+', run) for run in runs)


def test_a_node_says_that_it_is_ready_in_its_run_and_by_hand_in_any():
    run, other = identity.new_run(), identity.new_run()
    assert identity.who_is_ready(identity.ready_words('guard', run), other) == ('guard', run)
    assert identity.who_is_ready(identity.ready_words('guard', '/'), run) == ('guard', run)


@pytest.mark.parametrize('mine', [identity.new_run(), '/'], ids=['of fly', 'by hand'])
def test_only_a_node_that_can_be_taken_for_one_of_ours_is_foreign(mine):
    other = identity.new_run()
    ours = [('guard', '/', mine), ('rviz', '/', '/'), ('guard', '/elsewhere', other),
            ('rosbag2_recorder', '/', other)]
    assert identity.foreign(ours, ['guard', 'link_back'], mine) == ''
    assert identity.in_words(other) in identity.foreign(
        [*ours, ('link_back', '/', other)], ['guard', 'link_back'], mine)


def test_the_enclave_that_ros_is_told_last_counts(monkeypatch):
    assert identity.own_run(['node', '--ros-args', '-r', '__node:=x']) == '/'
    assert identity.own_run(['node', '--ros-args', '--enclave', '/a', '-e', '/b']) == '/b'
    monkeypatch.setenv('ROS_SECURITY_ENCLAVE_OVERRIDE', '/secured')
    assert identity.own_run(['node', '--ros-args', '--enclave', '/a']) == '/secured'


@pytest.fixture
def plant(own_domain, monkeypatch):
    """Return the plant of a run, of whose nodes no other has yet been heard."""
    monkeypatch.setenv('RVD_LEAN', '1')
    words = ['/x/spacecraft_dynamics', '--ros-args', '--enclave', identity.new_run()]
    rclpy.init(args=words)
    host = Host(parsed(words))
    make(host, ('spacecraft_dynamics',))
    yield host.nodes['spacecraft_dynamics']
    host.nodes['spacecraft_dynamics'].destroy_node()
    rclpy.try_shutdown()


def is_ready(plant, node, run, at_ns):
    """Let a plant hear that a node of a run was ready at a time, by the clock of its writer."""
    plant._heard_ready(serialize_message(String(data=identity.ready_words(node, run))),
                       {'source_timestamp': at_ns})


def start(plant):
    for node in plant.roster.names:
        is_ready(plant, node, plant.host.run_id, time.time_ns())
    return plant._started_ns


def test_a_run_in_flight_goes_on_when_another_is_ready_later_and_says_so_once(plant):
    told = []
    plant.event = lambda code, text: told.append((code, text))
    later, other = start(plant) + 1, identity.new_run()
    for node in ('auto_controller', 'command_blender'):
        is_ready(plant, node, other, later)
    assert [code for code, _ in told] == ['STRANGER'] and identity.in_words(other) in told[0][1]


@pytest.mark.parametrize('started', [False, True])
def test_a_run_ends_when_another_was_ready_before_it_started(plant, started):
    before = start(plant) if started else time.time_ns()
    with pytest.raises(ValueError, match='another run has come into ROS_DOMAIN_ID='):
        is_ready(plant, 'link_back', identity.new_run(), before)


# -- one user: the domain is locked ----------------------------------------------------------------

@pytest.fixture
def domain(monkeypatch):
    """Return a domain that no run of this machine uses, as the user's own."""
    with reserved_domain() as number:
        pass
    monkeypatch.setattr('runs.environment', lambda: {
        **os.environ, 'RVD_ROOT': str(ROOT), 'ROS_DOMAIN_ID': str(number)})
    return int(number)


def other_user(monkeypatch, place, number):
    """From now on runs are those of somebody whose locks stand elsewhere."""
    place.mkdir(mode=0o700)
    monkeypatch.setattr('runs.environment', lambda: {
        **os.environ, 'RVD_ROOT': str(ROOT), 'ROS_DOMAIN_ID': str(number),
        'XDG_RUNTIME_DIR': str(place)})


@pytest.mark.slow
def test_a_second_run_with_the_same_exported_domain_says_who_holds_it(tmp_path, domain):
    first = start_rvd('fly', '--pace', 'realtime', '--headless', '--out', 'first', cwd=tmp_path)
    try:
        wait_for(lambda: (tmp_path / 'first' / 'bag').exists(), 'the first run')
        second = rvd('fly', '--pace', 'lockstep', '--out', 'second', cwd=tmp_path)
        assert second.returncode == 2 and second.stderr.count('\n') == 1
        assert f'ROS_DOMAIN_ID={domain} is held by another run (process {first.pid}, ' \
               f'{tmp_path}/first, since ' in second.stderr
        assert not (tmp_path / 'second').exists()
        assert first.poll() is None
    finally:
        end(first)


# -- two users or machines: nodes tell runs apart --------------------------------------------------

@pytest.mark.slow
def test_a_run_that_comes_into_anothers_domain_ends_and_the_other_one_flies_on(
        tmp_path, domain, monkeypatch):
    first = start_rvd('fly', '--pace', '3', '--headless', '--seed', '3', '--out', 'first',
                      cwd=tmp_path)
    try:
        in_flight(tmp_path / 'first')
        other_user(monkeypatch, tmp_path / 'locks', domain)
        second = rvd('fly', '--pace', 'lockstep', '--headless', '--seed', '4', '--out', 'second',
                     cwd=tmp_path)
        assert second.returncode == 2, second.stdout + second.stderr
        assert re.search(OTHER, second.stderr), second.stderr
        kept = verdict_of(tmp_path / 'second')
        assert not kept['success'] and kept['reason'] == 'given_up'
        assert re.search(OTHER, kept['given_up']), kept
        assert first.poll() is None
        first.send_signal(signal.SIGINT)
        assert first.wait(30.0) == 130, (tmp_path / 'out').read_text()
    finally:
        end(first)
    told = messages(tmp_path / 'first', '/run/scenario')
    assert len(told) == 1 and 'seed: 3' in told[0].data
    ready = [m.data.split() for m in messages(tmp_path / 'first', '/run/ready')]
    ours = [node for node, run in ready if run == ready[0][1]]
    assert len(ours) == len(set(ours)) == 11  # the other may have said that it was ready, as itself
    steps = [m.step for m in messages(tmp_path / 'first', '/onboard/measurement')]
    assert steps == list(range(len(steps)))     # one writer, from first to last


@pytest.mark.slow
@pytest.mark.parametrize('processes', ['blocks', 'one'])
def test_two_runs_that_start_at_once_do_not_both_fly(tmp_path, domain, monkeypatch, processes):
    """In steps so short that a flight outlasts the 3 s in which DDS makes itself heard again."""
    for place in 'ab':
        (tmp_path / place).mkdir()
        (tmp_path / place / 'fine.yaml').write_text('/**: {ros__parameters: {step_s: 0.05}}')
    fly = ('fly', 'fine.yaml', '--headless', '--pace', 'lockstep', '--processes', processes,
           '--out', 'run')
    flights = [start_rvd(*fly, cwd=tmp_path / 'a')]
    other_user(monkeypatch, tmp_path / 'locks', domain)
    flights.append(start_rvd(*fly, cwd=tmp_path / 'b'))
    try:
        codes = [flight.wait(90.0) for flight in flights]
    finally:
        for flight in flights:
            end(flight)
    told = [(tmp_path / place / 'out').read_text() for place in 'ab']
    refused = [bool(re.search(OTHER, words)) for words in told]
    assert any(refused), told
    # one that flies on where the other had written before it left says so
    for code, words, other in zip(codes, told, refused):
        assert code == 2 if other or 'not to be trusted: a second writer on' in words else \
            code == 0, (code, words)
