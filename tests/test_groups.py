"""
Blocks that share processes: the same bits, every topic out, and whatever comes from outside gets
in.
"""

import os
from pathlib import Path
import re
import signal
import time

from mcap.records import Channel, Footer, Message, Schema
import numpy as np
import pytest
from conftest import Flown
from runs import alive, counts, in_flight, node_pid, ROOT, verdict_of, wait_for
from test_by_hand import Hand
from test_recording import columns
from test_repeat import assert_equals_loop

from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.ros.host import message_type
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording import mcap_file
from rvd_dynamics.recording.reader import read
from rvd_dynamics.recording.steps import step_reader
from rvd_interfaces.msg import RelativeState, RunEvent, ThrustCommand
from rvd_interfaces.srv import RunControl

GROUPED = ('segments', 'one')
PROCESSES = {'segments': ['world', 'onboard', 'link', 'ground', 'watch'], 'one': ['one']}
SCENARIOS = {'paper': ('flight', '3'), 'rough_link': ('rough_flight', '11'),
             'barrier': (None, '9')}    # as flown with a process for each block, and the seed


# -- flights in lock step ------------------------------------------------------------------------

@pytest.fixture(scope='module')
def grouped(tmp_path_factory):
    """Return a function that flies a scenario once with each grouping."""
    flown = {}

    def get(scenario, processes):
        key = scenario, processes
        if key not in flown:
            flown[key] = Flown(
                tmp_path_factory.mktemp('grouped') / 'run', scenario, '--processes', processes,
                '--seed', SCENARIOS[scenario][1], '--pace', 'lockstep', '--headless')
            assert flown[key].code in (0, 1), flown[key].err
        return flown[key].run
    return get


@pytest.mark.slow
@pytest.mark.parametrize('processes', GROUPED)
@pytest.mark.parametrize('scenario', SCENARIOS)
def test_groups_fly_to_the_last_bit_as_in_process(scenario, processes, grouped):
    assert_equals_loop(grouped(scenario, processes))


@pytest.mark.slow
@pytest.mark.parametrize('processes', GROUPED)
@pytest.mark.parametrize('scenario', ['paper', 'rough_link'])
def test_the_bag_of_groups_is_that_of_a_process_for_each_block(scenario, processes, grouped,
                                                               request):
    """Every column of every series, and as many messages of whatever is owed."""
    apart = request.getfixturevalue(SCENARIOS[scenario][0])
    run = grouped(scenario, processes)
    ours, theirs = read(run), read(apart.run)
    owed = Roster(ours.scenario).owed
    assert {t: ours.counts[t] for t in owed} == {t: theirs.counts[t] for t in owed}
    for topic in owed:
        mine, other = dict(columns(ours.of(topic))), dict(columns(theirs.of(topic)))
        assert mine.keys() == other.keys()
        for name in mine:
            np.testing.assert_array_equal(mine[name], other[name], err_msg=f'{topic} {name}')
    assert repr(ours.verdict) == repr(theirs.verdict)
    assert [(e.step, e.node, e.code, e.text) for e in ours.events if e.code == 'REFUSED'] == [
        (e.step, e.node, e.code, e.text) for e in theirs.events if e.code == 'REFUSED']
    assert ours.missing == {} or not any(ours.missing.values())
    assert ours.complete and ours.closed and ours.ended and not ours.trouble


@pytest.mark.slow
@pytest.mark.parametrize('processes', GROUPED)
def test_the_run_folder_is_that_of_any_flight(processes, grouped):
    run = grouped('paper', processes)
    assert {path.name for path in run.iterdir()} == {
        'bag', 'logs', 'report.html', 'scenario.yaml', 'verdict.json'}
    assert {path.stem for path in (run / 'logs').glob('*.log') if 'python' not in path.stem} == set(
        PROCESSES[processes])
    assert f'processes: {processes}' in (run / 'scenario.yaml').read_text()
    assert set(counts(run)) >= set(Roster(load(run / 'scenario.yaml')).topics) - {
        '/run/recorded_step'}


# -- by hand -----------------------------------------------------------------------------------

class Groups(Hand):
    """Starts the groups of a scenario."""

    def __init__(self, folder: Path, processes: str, **values) -> None:
        scenario = load(ROOT / 'scenarios' / 'paper.yaml').with_values(
            '/**', processes=processes, **values)
        path = folder / 'scenario.yaml'
        path.write_text(scenario.dump())
        super().__init__(path)
        self.roster = Roster(scenario)

    def look(self, seconds):
        until = time.monotonic() + seconds
        while time.monotonic() < until:
            self.executor.spin_once(timeout_sec=0.01)


@pytest.fixture
def groups(tmp_path):
    made = []

    def start(processes, **values):
        made.append(Groups(tmp_path, processes, **values))
        return made[-1]
    yield start
    for hand in made:
        hand.close()


@pytest.mark.slow
@pytest.mark.parametrize('processes', GROUPED)
def test_every_topic_is_published_though_nobody_in_the_graph_needs_it(processes, groups):
    """A stranger who listens gets every step of every topic, what passes by hand too."""
    hand = groups(processes, timeout_s=30.0)
    heard = {topic: hand.listen(topic, message_type(hand.roster.topics[topic]))
             for topic in (*hand.roster.owed, '/run/end', '/run/scenario')}
    hand.start_ring(waits=True)
    hand.go()
    hand.until(lambda: heard['/run/end'], 'the end of the run')
    hand.until(lambda: all(len(heard[t]) == 61 for t in set(hand.roster.owed) - {'/clock'}),
               {topic: len(messages) for topic, messages in heard.items()})
    for topic in set(hand.roster.owed) - {'/clock', '/joy'}:
        assert [m.step for m in heard[topic]] == list(range(61)), topic
    assert heard['/clock']                      # keeps ten and forgets: all of them is too much
    for name, process in hand.processes.items():
        assert process.wait(20.0) == 0, name


class Control:
    """Calls /run/control."""

    def __init__(self, hand) -> None:
        self.hand = hand
        self.client = hand.node.create_client(RunControl, '/run/control')

    def __call__(self, action, mode=''):
        self.hand.until(self.client.service_is_ready, 'the service')
        future = self.client.call_async(RunControl.Request(action=action, mode=mode))
        self.hand.until(future.done, 'an answer')
        assert future.result().accepted, future.result().message


LONG = {'step_s': 0.1, 'timeout_s': 900.0, 'start__position_m': [-200.0, 0.0, 0.0]}
PACES = [('segments', 'lockstep', 1.0), ('segments', 'realtime', 40.0), ('one', 'lockstep', 1.0),
         ('one', 'realtime', 40.0), ('one', 'realtime', 1000.0)]        # the last: for ever behind


@pytest.mark.slow
@pytest.mark.parametrize('processes, pace, factor', PACES)
def test_pause_resume_mode_and_abort_get_through(processes, pace, factor, groups):
    """A process that fires without a rest still hears what it is told."""
    hand = groups(processes, pace=pace, pace_factor=factor, **LONG)
    truth = hand.listen('/truth/relative_state', RelativeState)
    commands = hand.listen('/ground/command', ThrustCommand)
    thrust = hand.listen('/onboard/thruster_command', ThrustCommand)
    control = Control(hand)
    hand.start_ring(waits=True)
    hand.go()
    hand.until(lambda: len(truth) > 50, 'fifty steps')
    begun = time.monotonic()
    control(RunControl.Request.PAUSE)
    assert time.monotonic() - begun < 3.0
    hand.look(0.5)
    at_pause = truth[-1].step
    hand.look(0.5)
    assert truth[-1].step == at_pause < 8000
    control(RunControl.Request.RESUME)
    hand.until(lambda: truth[-1].step > at_pause + 50, 'steps after the pause')
    control(RunControl.Request.MODE, 'manual')
    hand.until(lambda: commands[-1].decided_by == ThrustCommand.BY_PILOT, 'the pilot alone')
    control(RunControl.Request.ABORT)
    hand.until(lambda: thrust[-1].kind == ThrustCommand.KIND_ABORT, 'the abort on board')
    assert not truth[-1].final


@pytest.mark.slow
@pytest.mark.parametrize('processes', ['blocks', *GROUPED])
def test_an_abort_and_a_change_of_mode_fly_as_in_process_when_they_come_in_the_same_steps(
        processes, groups):
    hand = groups(processes, pace='lockstep', seed=21, step_s=0.1, timeout_s=150.0,
                  start__position_m=[-60.0, 0.0, 0.0])
    truth = hand.listen('/truth/relative_state', RelativeState)
    commands = hand.listen('/ground/command', ThrustCommand)
    thrust = hand.listen('/onboard/thruster_command', ThrustCommand)
    predicted = hand.listen('/ground/prediction', RelativeState)
    events = hand.listen('/run/events', RunEvent)
    control = Control(hand)
    hand.start_ring(waits=True)
    hand.go()
    hand.until(lambda: len(truth) > 150, 'the beginning')
    control(RunControl.Request.MODE, 'manual')
    hand.until(lambda: len(truth) > truth[0].step + 400, 'a while')
    control(RunControl.Request.ABORT)
    hand.until(lambda: truth[-1].final, 'the end', timeout=120.0)
    hand.until(lambda: len(thrust) == len(commands) == len(predicted) == len(truth),
               'every command')

    changed = next(e.step for e in events if e.code == 'MODE') + 1
    aborted = next(c.step for c in commands if c.kind == ThrustCommand.KIND_ABORT)
    assert aborted == next(e.step for e in events if e.code == 'ABORT') + 1
    assert 100 < changed < aborted < len(truth) - 100
    history = fly(load(hand.scenario), [0], record=True, schedule=[
        Change(changed, mode='manual'), Change(aborted, abort=True)]).history
    state = np.array([[m.position.x, m.position.y, m.position.z,
                       m.velocity.x, m.velocity.y, m.velocity.z] for m in truth])
    np.testing.assert_array_equal(state, history['/truth/relative_state'].state[:, 0])
    state = np.array([[m.position.x, m.position.y, m.position.z,
                       m.velocity.x, m.velocity.y, m.velocity.z] for m in predicted])
    np.testing.assert_array_equal(state, history['/ground/prediction'].state[:, 0])
    executed = history['/onboard/thruster_command']
    np.testing.assert_array_equal([m.levels for m in thrust], executed.command[:, 0])
    np.testing.assert_array_equal([m.kind for m in thrust], executed.kind[:, 0])
    np.testing.assert_array_equal([m.valid for m in thrust], executed.valid[:, 0])
    sent = history['/ground/command']
    np.testing.assert_array_equal([m.levels for m in commands], sent.command[:, 0])
    np.testing.assert_array_equal([m.decided_by for m in commands], sent.decided_by[:, 0])
    acts = next(m.step for m in thrust if m.kind == ThrustCommand.KIND_ABORT)
    assert 36 <= acts - aborted <= 55           # a transit, and no wait in the play-out buffer
    away = [m.levels[0] for m in thrust if m.kind == ThrustCommand.KIND_ABORT]
    assert away[:160] == [-3] * 160 and not any(away[160:])


# -- endings -----------------------------------------------------------------------------------

@pytest.fixture
def flying(start, tmp_path):
    """Return a starter of runs, which waits until they are in flight."""
    def fly(processes, *args):
        process = start('fly', '--out', str(tmp_path / 'run'), '--headless', '--processes',
                        processes, *(args or ('--pace', '5')))
        in_flight(tmp_path / 'run')
        return process
    return fly


def steps_in(run):
    """Return the steps of the truth in a bag that can be read."""
    steps = list(read(run).of('/truth/relative_state').step)
    assert len(steps) > 5 and steps == list(range(len(steps)))
    return steps


@pytest.mark.slow
@pytest.mark.parametrize('processes', GROUPED)
def test_ctrl_c_ends_groups_and_leaves_a_closed_bag(processes, flying, tmp_path):
    process = flying(processes)
    pids = [node_pid(process.pid, name) for name in PROCESSES[processes]]
    process.send_signal(signal.SIGINT)
    assert process.wait(60.0) == 130
    wait_for(lambda: not any(map(alive, pids)), 'the end of every process', 2.0)
    steps_in(tmp_path / 'run')
    assert isinstance(list(mcap_file.records(tmp_path / 'run' / 'bag' / 'bag_0.mcap'))[-1], Footer)
    assert verdict_of(tmp_path / 'run')['reason'] == 'interrupted'
    for name in PROCESSES[processes]:
        assert (tmp_path / 'run' / 'logs' / f'{name}.log').read_text() == ''


@pytest.mark.slow
@pytest.mark.parametrize('processes, victim', [
    ('one', 'one'), ('segments', 'ground'), ('segments', 'world'), ('segments', 'watch')])
def test_a_killed_group_is_named_and_its_bag_can_be_read(processes, victim, flying, tmp_path):
    process = flying(processes)
    os.kill(node_pid(process.pid, victim), signal.SIGKILL)
    assert process.wait(60.0) == 2
    assert f'{victim} was ended by signal 9' in (tmp_path / 'out').read_text()
    steps_in(tmp_path / 'run')


@pytest.mark.slow
def test_a_process_that_waits_has_written_all_of_its_step(flying, tmp_path):
    """It writes a step in one go; nothing of it stays behind in memory until the next."""
    process = flying('one', '--pace', '2')
    pid = node_pid(process.pid, 'one')
    owed = Roster(load(ROOT / 'scenarios' / 'paper.yaml')).owed

    def last_steps():
        """Return the last step of each topic; with 0.25 s to a step it sleeps nearly always."""
        os.kill(pid, signal.SIGSTOP)
        time.sleep(0.05)
        found = last_in(tmp_path / 'run' / 'bag' / 'bag_0.mcap')
        os.kill(pid, signal.SIGCONT)
        return {found[topic] for topic in owed}
    looks = []
    for _ in range(10):
        looks.append(last_steps())
        time.sleep(0.3)
    assert sum(len(steps) == 1 for steps in looks) >= 8, looks
    assert len(set.union(*looks)) > 5           # it went on meanwhile


def last_in(path):
    """Return the step of the last message of each topic in a file."""
    kinds, topics, found = {}, {}, {}
    for record in mcap_file.records(path):
        if isinstance(record, Schema):
            kinds[record.id] = record.name
        elif isinstance(record, Channel):
            topics[record.id] = record.topic, step_reader(kinds[record.schema_id], 500_000_000)
        elif isinstance(record, Message):
            topic, step_of = topics[record.channel_id]
            found[topic] = step_of(record.data) if step_of else None
    return found


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('victim, nodes', [
    ('ground', 'state_predictor'), ('link', 'link_back|link_forward|link_back, link_forward')])
def test_of_a_hung_group_the_block_that_owes_is_named(victim, nodes, flying, tmp_path):
    scenario = tmp_path / 'long.yaml'
    scenario.write_text('/**: {ros__parameters: {step_s: 0.05, forward_delay_s: 1.0, '
                        'back_delay_s: 1.0}}')
    process = flying('segments', str(scenario), '--pace', 'lockstep')
    os.kill(node_pid(process.pid, victim), signal.SIGSTOP)
    assert process.wait(90.0) == 2
    said = (tmp_path / 'out').read_text()
    assert re.search(rf'wall time: ({nodes}) \(process {victim}\) owes? a message', said), said


@pytest.mark.slow
@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM])
def test_a_group_told_to_stop_in_the_middle_of_its_work_says_nothing(number, groups):
    hand = groups('one', pace='lockstep', **LONG)
    truth = hand.listen('/truth/relative_state', RelativeState)
    hand.start_ring(waits=True)
    hand.go()
    hand.until(lambda: len(truth) > 200, 'two hundred steps')
    pid = wait_for(lambda: node_pid(hand.processes['one'].pid, 'one', itself=True), 'the process')
    os.kill(pid, number)
    out, err = hand.processes['one'].communicate(timeout=20.0)
    assert (hand.processes['one'].returncode, err) == (0, '')
    assert not truth[-1].final


# -- a long run --------------------------------------------------------------------------------

@pytest.mark.slow
def test_a_long_run_does_not_grow(tmp_path, flying):
    """Histories are full after 2,000 steps; from then on 5,000 more must cost no memory."""
    scenario = tmp_path / 'long.yaml'
    scenario.write_text('/**: {ros__parameters: {step_s: 0.05, timeout_s: 400.0, mode: manual, '
                        'operator: none, start: {position_m: [-200.0, 0.0, 0.0]}}}')
    process = flying('one', str(scenario), '--pace', 'lockstep')
    pid = node_pid(process.pid, 'one')
    log = tmp_path / 'run' / 'bag' / 'bag_0.mcap'
    seen = []                                   # (bytes in the bag, bytes in memory)
    while process.poll() is None and alive(pid):
        try:
            status = Path(f'/proc/{pid}/statm').read_text().split()
            seen.append((log.stat().st_size, int(status[1]) * os.sysconf('SC_PAGE_SIZE')))
        except (OSError, IndexError):
            break
        time.sleep(0.05)
    assert process.wait(60.0) == 1, (tmp_path / 'out').read_text()
    steps = steps_in(tmp_path / 'run')
    assert len(steps) == 8001
    whole = max(size for size, _ in seen)
    early = max(memory for size, memory in seen if size < 0.35 * whole)
    late = max(memory for size, memory in seen if size < 0.98 * whole)
    assert late - early < 4e6, (early, late)
