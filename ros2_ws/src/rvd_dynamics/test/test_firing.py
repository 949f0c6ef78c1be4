"""Blocks as nodes: the same bits at any rate in any grouping, late inputs, bad outputs by name."""

import time
from types import SimpleNamespace

from hypothesis import example
from hypothesis import given as drawn
from hypothesis import settings
from hypothesis import strategies as st
import numpy as np
import pytest
import rclpy
from rclpy.executors import SingleThreadedExecutor
import toy_mission
from toy_mission import WANTED

from rvd_dynamics.diagram import in_process
from rvd_dynamics.diagram.block import held, now
from rvd_dynamics.diagram.diagram import GROUPINGS
from rvd_dynamics.diagram.ros import inputs, plant_node
from rvd_dynamics.diagram.ros.codecs import Parts
from rvd_dynamics.diagram.ros.inputs import HELD_FOR_S, HeldInput
from rvd_dynamics.diagram.ros.host import Host
from rvd_dynamics.diagram.ros.main import make
from rvd_dynamics.diagram.ros.process import listen_for_the_end, run
from rvd_dynamics.diagram.ros.qos import DEPTH
from rvd_dynamics.diagram.ros.writers import UNKNOWN_NODE
from rvd_dynamics.pulse import PAGE, Pulse


@pytest.fixture(autouse=True)
def ros(monkeypatch):
    """Make ROS ready for nodes in this process, which hear nobody else."""
    monkeypatch.setenv('RVD_LEAN', '1')
    monkeypatch.setenv('ROS_AUTOMATIC_DISCOVERY_RANGE', 'OFF')
    rclpy.init()
    yield
    rclpy.try_shutdown()


def arguments(scenario):
    """Return what a process is told, with a scenario that stands in no file."""
    return SimpleNamespace(name='toy', scenario=scenario, run_id='/', text=lambda: '')


class Processes:
    """The processes of a run side by side in this one: each with its host and executor."""

    def __init__(self, scenario) -> None:
        first = Host(arguments(scenario))
        self.hosts = {}
        for process in first.roster.processes:
            host = self.hosts[process.name] = Host(arguments(scenario))
            make(host, process.nodes)
            listen_for_the_end(host)
        self._executors = {}
        for name, host in self.hosts.items():
            self._executors[name] = SingleThreadedExecutor()
            for node in host.nodes.values():
                self._executors[name].add_node(node)

    def node(self, name):
        return next(host.nodes[name] for host in self.hosts.values() if name in host.nodes)

    def turn(self):
        """Give every process a turn."""
        for name, host in self.hosts.items():
            if not host.ended:
                self._executors[name].spin_once(timeout_sec=0.0)
                host.work()

    def fly(self):
        deadline = time.monotonic() + 30.0
        try:
            while not all(host.ended for host in self.hosts.values()):
                assert time.monotonic() < deadline, [
                    (name, node.step) for host in self.hosts.values()
                    for name, node in host.nodes.items()]
                self.turn()
                for host in self.hosts.values():
                    if host.ended:
                        host.raise_error()
        finally:
            self.close()

    def close(self):
        for executor in self._executors.values():
            executor.shutdown(timeout_sec=0.0)
        for host in self.hosts.values():
            for node in host.nodes.values():
                node.destroy_node()


def noted(fly):
    """Return what every block was given in each of its firings."""
    toy_mission.LOG.clear()
    fly()
    return dict(toy_mission.LOG)


def test_no_attribute_of_a_node_hides_one_of_rclpy():
    plain = rclpy.create_node('plain', start_parameter_services=False, enable_rosout=False)
    host = Host(arguments(toy_mission.scenario(processes='one', nodes=(
        'plant', 'sensor', 'law', 'guard', 'mission_monitor'))))
    make(host, host.roster.processes[0].nodes)
    for node in host.nodes.values():
        hidden = [name for name, value in vars(plain).items()
                  if type(vars(node)[name]) is not type(value)]
        assert not hidden, node.get_name()


# -- rates -------------------------------------------------------------------------------------

@st.composite
def rates(draw):
    """Draw periods and delays that a diagram may have."""
    periods = [draw(st.integers(1, 5)) for _ in range(3)]
    sensor, law, guard = periods

    def delay(writer, reader):
        return draw(st.integers(int(writer > reader), 4))
    return {'sensor_period': sensor, 'law_period': law, 'guard_period': guard,
            'truth_delay': delay(1, sensor), 'measured_delay': delay(sensor, law),
            'wanted_delay': delay(law, guard)}


@settings(max_examples=12)
@example({'sensor_period': 3, 'law_period': 4, 'guard_period': 1, 'truth_delay': 0,
          'measured_delay': 0, 'wanted_delay': 1}, 18, 'blocks')   # the law needs nothing of 19, 20
@drawn(rates(), st.integers(12, 31), st.sampled_from(GROUPINGS))
def test_blocks_of_any_rate_get_the_same_bits_as_in_one_process(chosen, steps, processes):
    scenario = toy_mission.scenario(timeout_s=0.5 * steps, processes=processes, **chosen)
    alone = noted(lambda: in_process.fly(scenario, [0]))
    assert max(k for name, k in alone if name == 'plant') == steps
    graph = noted(lambda: Processes(scenario).fly())
    assert graph.keys() == alone.keys()
    assert [key for key in graph if graph[key] != alone[key]] == []


def test_the_last_firing_of_a_slow_block_is_the_last_before_the_end():
    scenario = toy_mission.scenario(timeout_s=10.0, law_period=7, measured_delay=1, wanted_delay=1)
    graph = noted(lambda: Processes(scenario).fly())
    assert [k for name, k in graph if name == 'law'] == [0, 7, 14]
    assert max(k for name, k in graph if name == 'guard') == 20


@settings(max_examples=12)
@drawn(rates(), st.sampled_from(['plant', 'sensor', 'law', 'guard']), st.integers(0, 10))
def test_a_block_of_any_rate_that_stops_is_the_one_that_owes(chosen, dead, until):
    side_by_side = Processes(toy_mission.scenario(**chosen))
    nodes = {name: side_by_side.node(name) for name in ('plant', 'sensor', 'law', 'guard')}
    frozen = nodes[dead]
    alive = frozen.may_fire
    frozen.may_fire = lambda: frozen._next < until and alive()
    roster = frozen.roster
    steps, still = None, 0
    while still < 50 or not nodes['plant'].started:            # turns without a step
        side_by_side.turn()
        before, steps = steps, {name: node.step for name, node in nodes.items()}
        still = still + 1 if steps == before else 0
    side_by_side.close()
    last = {topic: steps[name] for name in nodes for topic in roster.emits(name)}
    assert roster.who_owes(last) == [dead]


# -- bad outputs -------------------------------------------------------------------------------

FAULTS = {
    ('law', 'nan'):
        'block law writes /onboard/wanted at step 3: a command must be finite, got [nan]',
    ('guard', 'inf'): 'block guard writes /onboard/thrust at step 3: a command must be finite, got',
    ('law', 'shape'): 'block law writes /onboard/wanted at step 3: command must have shape (1,), '
                      'got (2,)',
    ('sensor', 'shape'): 'block sensor writes /onboard/measured at step 3: state must have shape '
                         '(2,), got (4,)',
    ('sensor', 'missing'): 'block sensor: step must return a value for each of measured by name, '
                           'got dict',
    ('law', 'extra'): 'block law: step must return a value for each of wanted by name, got more, '
                      'wanted',
    ('plant', 'nothing'): 'block plant: step must return a value for each of truth by name, got '
                          'NoneType',
    ('sensor', 'number'): 'block sensor writes /onboard/measured at step 3: must be a value of '
                          '/onboard/measured, got float',
}


@pytest.mark.parametrize('processes', ['one', 'blocks'])
@pytest.mark.parametrize('block, fault', FAULTS, ids=map('-'.join, FAULTS))
def test_a_bad_output_names_block_signal_and_rule_at_any_firing(block, fault, processes):
    scenario = toy_mission.scenario(processes=processes, fault=fault, fault_block=block,
                                    fault_step=3)
    with pytest.raises(ValueError) as caught:
        Processes(scenario).fly()
    assert str(caught.value).startswith(FAULTS[block, fault])
    assert '\n' not in str(caught.value)
    assert caught.value.rvd_node.block.name == block


@pytest.mark.parametrize('block, fault', [('law', 'shape'), ('sensor', 'extra'), ('law', 'number')])
def test_a_batch_refuses_the_same_outputs_at_its_first_step(block, fault):
    scenario = toy_mission.scenario(fault=fault, fault_block=block)
    with pytest.raises(ValueError, match=f'block {block} (writes /onboard/|returns .more.)'):
        in_process.fly(scenario, [0, 1])


def test_a_process_with_a_bad_block_ends_with_code_2_and_one_line(capsys):
    rclpy.shutdown()                            # `run` begins with it
    told = arguments(toy_mission.scenario(processes='one', fault='nan', fault_step=2))
    with pytest.raises(SystemExit) as ended:
        run(lambda host: make(host, host.roster.processes[0].nodes), told, ['toy'])
    assert ended.value.code == 2
    assert capsys.readouterr().err == (
        'law: block law writes /onboard/wanted at step 2: a command must be finite, got [nan]\n')


def test_a_fault_of_a_block_itself_is_passed_on_with_its_node():
    scenario = toy_mission.scenario(processes='one', fault='raises', fault_block='sensor')
    with pytest.raises(RuntimeError, match='the block is broken') as caught:
        Processes(scenario).fly()
    assert caught.value.rvd_node.block.name == 'sensor'


# -- real time ---------------------------------------------------------------------------------

def test_in_real_time_a_fault_within_anothers_firing_is_named_by_its_own_block():
    """The sensor fires when the truth of the next step arrives, within the firing of the plant."""
    scenario = toy_mission.scenario(processes='one', pace='realtime', pace_factor=20.0,
                                    fault='raises', fault_block='sensor', fault_step=1)
    with pytest.raises(RuntimeError, match='the block is broken') as caught:
        Processes(scenario).fly()
    assert caught.value.rvd_node.block.name == 'sensor'


@pytest.fixture
def guard():
    """Return the guard of a run in real time, alone in its process; it reads two signals."""
    host = Host(arguments(toy_mission.scenario(pace='realtime', wanted_delay=1)))
    host.begun = True
    make(host, ('guard',))
    host.nodes['guard']._on_clock(100, None)
    yield host.nodes['guard']
    host.nodes['guard'].destroy_node()


def send(node, name, k, **parts):
    """Let an input of a node arrive, as from another process."""
    signal = node.block.reads[name].signal
    value = signal.type(**{part: np.asarray(number) for part, number in parts.items()})
    node._came(name, k, Parts(signal, node.run).encode(k, value))
    node.host.work()


def test_in_real_time_a_block_fires_late_with_what_it_holds_and_counts_what_is_missing(guard):
    toy_mission.LOG.clear()
    guard.host.work()                           # firing 0 needs nothing that was sent
    send(guard, 'wanted', 0, command=[0.5], count=0)
    assert ('guard', 1) not in toy_mission.LOG              # it still waits for the measurement
    send(guard, 'measured', 0, state=[1.0, 2.0])
    assert given('guard', 1) == [1.0, 2.0, 0.5, 0.0] and guard.missing_count == 0
    send(guard, 'wanted', 1, command=[0.6], count=1)
    send(guard, 'wanted', 2, command=[0.7], count=2)        # of the next: 2 fires with what is here
    np.testing.assert_array_equal(given('guard', 2), [np.nan, np.nan, 0.6, 1.0])
    assert guard.missing_count == 1 and guard.late_count == 0
    send(guard, 'measured', 1, state=[3.0, 4.0])            # too late, and never used
    assert guard.late_count == 1
    send(guard, 'measured', 2, state=[5.0, 6.0])
    assert given('guard', 3) == [5.0, 6.0, 0.7, 2.0]
    assert guard.trouble == {'missing': '1 inputs missing so far',
                             'late': '1 messages came after their step'}


def test_in_real_time_a_jump_fires_every_step_between(guard, monkeypatch):
    toy_mission.LOG.clear()
    events = []
    monkeypatch.setattr(guard, 'event', lambda code, text: events.append((code, text)))
    guard.host.work()
    send(guard, 'wanted', 4, command=[0.5], count=4)
    assert sorted(k for _, k in toy_mission.LOG) == [0, 1, 2, 3, 4]
    assert guard.missing_count == 8
    assert [(code, text.split(';')[0]) for code, text in events] == [
        ('LATE', 'inputs missing at their step: 2 so far')]         # then from 10 on, from 100 on
    send(guard, 'measured', 4, state=[1.0, 2.0])
    assert given('guard', 5) == [1.0, 2.0, 0.5, 4.0]


def world_by(monkeypatch):
    """Return a clock that the test sets, and a world in real time by it, with steps of 1 s."""
    clock = SimpleNamespace(now=0.0)
    monkeypatch.setattr(plant_node, 'time', SimpleNamespace(monotonic=lambda: clock.now))
    host = Host(arguments(toy_mission.scenario(pace='realtime')))
    host.begun = True
    make(host, ('plant',))
    world = host.nodes['plant']
    world._step_s, world._origin, world._looked = 1.0, 0.0, 0.0
    return clock, world


def test_in_real_time_the_world_waits_half_a_step_for_its_thrust_and_no_longer(monkeypatch):
    clock, world = world_by(monkeypatch)
    late = []
    monkeypatch.setattr(world._lateness, 'add', late.append)

    def fired(at):
        clock.now, before = at, world.step
        world._tick()
        return list(range(before + 1, world.step + 1))
    try:
        assert fired(0.0) == [0] and fired(0.9) == []
        assert fired(1.0) == [] and fired(1.3) == []        # due; its thrust is not here
        send(world, 'thrust', 0, command=[0.1])
        assert fired(1.4) == [1] and world.missing_count == 0
        assert fired(2.4) == [] and fired(2.5) == [2] and world.missing_count == 1
        send(world, 'thrust', 2, command=[0.2])             # of the next, in time
        assert fired(2.9) == [] and fired(3.0) == [3] and world.missing_count == 1
        assert fired(4.9) == [4] and fired(6.7) == [5, 6]   # behind: what is overdue, at once
        assert late == pytest.approx([0.0, 0.4, 0.5, 0.0, 0.9, 1.7, 0.7])
    finally:
        world.destroy_node()


@pytest.mark.parametrize('where', ['between two looks', 'within a step', 'before a step goes out'])
def test_a_world_that_stood_still_goes_on_from_where_it_was(monkeypatch, where):
    """Stopped wherever it may be, it makes one step in the next 1.25 s, which is one step long."""
    clock, world = world_by(monkeypatch)
    events = []
    monkeypatch.setattr(world, 'event', lambda code, text: events.append((code, text)))

    def stopped(*arguments):
        monkeypatch.setattr(*restored)
        clock.now += 24.0
        return restored[2](*arguments)
    host = world.host
    restored = {'within a step': (host, 'work', host.work),
                'before a step goes out': (host, 'publish', host.publish)}.get(where)
    try:
        world._tick()
        clock.now = 1.6
        if restored:
            monkeypatch.setattr(*restored[:2], stopped)
        world._tick()
        clock.now += 24.0*(not restored)
        for _ in range(10):
            clock.now += 0.125
            world._tick()
    finally:
        world.destroy_node()
    assert world.step == 2
    said = [text for code, text in events if code == 'STILL']
    assert len(said) == 1 and 'stood still for 2' in said[0]


def test_in_lock_step_nothing_fires_with_an_input_missing():
    host = Host(arguments(toy_mission.scenario(wanted_delay=1)))
    host.begun = True
    make(host, ('guard',))
    node = host.nodes['guard']
    node._on_clock(100, None)
    toy_mission.LOG.clear()
    for k in (0, 1, 2):
        send(node, 'wanted', k, command=[0.5], count=k)
    assert sorted(toy_mission.LOG) == [('guard', 0)]
    send(node, 'measured', 0, state=[1.0, 2.0])
    assert sorted(toy_mission.LOG) == [('guard', 0), ('guard', 1)] and not node.trouble
    node.destroy_node()


def test_a_block_that_reads_only_what_is_past_does_not_run_ahead_of_the_world():
    host = Host(arguments(toy_mission.scenario(measured_delay=3)))
    host.begun = True
    make(host, ('law',))
    node = host.nodes['law']
    toy_mission.LOG.clear()
    for k in (0, 1, 2, 3):
        send(node, 'measured', k, state=[1.0, 2.0])
    assert toy_mission.LOG == {}                # firings 0 to 6 have all their inputs
    for k in (0, 1, 4):
        node._on_clock(k, None)
        host.work()
        assert max(toy_mission.LOG) == ('law', k)
    assert len(toy_mission.LOG) == 5
    node.destroy_node()


def given(name, k):
    """Return the numbers that a block was given."""
    return np.frombuffer(toy_mission.LOG[name, k]).tolist()


@pytest.mark.parametrize('processes, complete', [
    ('one', ('plant', 'sensor', 'law', 'guard')), ('segments', ('sensor',))])
def test_a_process_that_falls_behind_the_clock_gives_its_blocks_their_inputs(processes, complete):
    """Five steps are due at once after each nap of the sensor: none overtakes what is here."""
    side_by_side = Processes(toy_mission.scenario(
        timeout_s=10.0, processes=processes, pace='realtime', pace_factor=500.0, fault='sleeps',
        fault_block='sensor'))
    side_by_side.fly()
    for name in complete:
        node = side_by_side.node(name)
        assert (node.missing_count, node.late_count, node.step) == (0, 0, 20), name


# -- a step that cannot be ----------------------------------------------------------------------

HOSTILE = [2**64 - 1, 2**63, 10**6]


@pytest.mark.parametrize('step', HOSTILE)
def test_a_message_from_beyond_the_run_is_left_out_at_once_and_said_once(guard, step):
    said = []
    guard.event = lambda code, text: said.append((code, text))
    guard.host.work()
    for _ in range(3):
        send(guard, 'wanted', step, command=[9.0], count=9)
    given_to = guard._inputs['wanted']
    assert guard.step == 0 and given_to.held == {}
    (code, text), = said
    topic = guard.block.reads['wanted'].signal.name
    assert code == 'REFUSED' and all(str(word) in text for word in (step, topic, given_to.bound()))
    assert '3 left out' in guard.trouble['refused']
    send(guard, 'wanted', 0, command=[0.5], count=0)        # and the run goes on
    send(guard, 'measured', 0, state=[1.0, 2.0])
    assert guard.step == 1


def an_input(period=1, last_step=10**9):
    return inputs.Input(now(WANTED), period, None, last_step)


@pytest.mark.parametrize('period', [1, 5])
def test_no_more_is_held_than_a_queue_holds(period):
    given_to = an_input(period)
    given_to.need = 100 * period
    last_one = (100 + DEPTH) * period
    assert given_to.believes(last_one) and not given_to.believes(last_one + 1)


def test_a_reader_that_was_stopped_believes_a_writer_that_goes_on():
    stopped = an_input()
    assert not stopped.believes(50_000)
    assert stopped.believes(50_001)
    lone = an_input()
    assert not lone.believes(50_000) and lone.believes(3) and not lone.believes(400_000)


def test_nobody_goes_on_past_the_end_of_the_run():
    assert [an_input(last_step=400).believes(k) for k in (400, 401)] == [True, False]
    given_to = an_input(last_step=400)
    assert not any(given_to.believes(2**63 + i) for i in range(5))


# -- a held stick ------------------------------------------------------------------------------

@pytest.fixture
def clock(monkeypatch):
    now = [100.0]
    monkeypatch.setattr(inputs.time, 'monotonic', lambda: now[0])
    return now


@pytest.fixture
def said():
    return []


@pytest.fixture
def stick(said):
    return HeldInput(held(WANTED), SimpleNamespace(
        missing=lambda k: f'nobody at {k}', decode=lambda k, message: (k, message),
        fault=lambda message: message if 'bad' in message else ''), said.append)


def test_nobody_has_touched_it(clock, stick):
    assert stick.value(3) == 'nobody at 3'


def test_the_newest_counts_until_it_is_too_old(clock, stick):
    stick.keep('first')
    clock[0] += 0.4
    stick.keep('second')
    clock[0] += HELD_FOR_S
    assert stick.value(7) == (7, 'second')
    clock[0] += 0.01
    assert stick.value(8) == 'nobody at 8'
    stick.keep('third')
    assert stick.value(9) == (9, 'third')


def test_each_change_of_what_is_wrong_is_said_once(clock, stick, said):
    for message in (None, None, 'good', 'good', 'bad axis', 'bad axis', 'bad button', 'good'):
        if message:
            stick.keep(message)
        stick.value(0)
        stick.value(1)
    clock[0] += HELD_FOR_S + 0.01
    stick.value(2)
    stick.value(3)
    assert said == ['no message yet', '', 'bad axis', 'bad button', '',
                    'the newest message is older than 0.5 s']


def test_a_stick_that_is_good_from_the_start_is_not_talked_about(clock, stick, said):
    stick.keep('good')
    stick.value(0)
    assert said == []


# -- the end ---------------------------------------------------------------------------------

@pytest.fixture
def closing(monkeypatch):
    """Return a process that waits for the recorder as it closes, and what happens meanwhile."""
    host = Host(arguments(toy_mission.scenario(processes='blocks', nodes=(
        'plant', 'sensor', 'law', 'guard', 'bag_recorder'))))
    make(host, ('sensor',))
    looks = host._recorder_is_here

    def meanwhile(happens):
        monkeypatch.setattr(host, '_recorder_is_here', lambda: (happens(), looks())[1])
        host.close()
    return meanwhile


def test_a_process_that_is_told_to_stop_while_it_closes_leaves_quietly(closing):
    closing(rclpy.shutdown)


def test_but_an_error_of_ours_in_that_wait_is_not_kept_quiet(closing):
    """The negative twin: the graph is still there."""
    def fails():
        raise RuntimeError('of ours')
    with pytest.raises(RuntimeError, match='of ours'):
        closing(fails)


def test_the_recorder_is_waited_for_though_the_graph_does_not_know_it_any_more(monkeypatch):
    """After DDS took it for dead and found it again it has no name; the page says that it works."""
    scenario = toy_mission.scenario(processes='blocks', nodes=('sensor', 'bag_recorder'))
    homes = [process.name for process in Host(arguments(scenario)).roster.processes]
    page = Pulse.shared(len(homes))
    for paged in (True, False):
        if paged:
            monkeypatch.setenv(PAGE, str(page.file))
        else:                                   # by hand: only the graph is asked
            monkeypatch.delenv(PAGE)
        host = Host(arguments(scenario))
        make(host, ('sensor',))
        try:
            page.beat(homes.index('bag_recorder'), 1)
            assert host._recorder_is_here() == paged
            page.leave(homes.index('bag_recorder'))
            assert not host._recorder_is_here()
            for name, here in (('bag_recorder', True), (UNKNOWN_NODE, not paged), ('other', False)):
                monkeypatch.setattr(host.lead, 'get_subscriptions_info_by_topic',
                                    lambda topic, name=name: [SimpleNamespace(node_name=name)])
                assert host._recorder_is_here() == here
        finally:
            host.nodes['sensor'].destroy_node()
