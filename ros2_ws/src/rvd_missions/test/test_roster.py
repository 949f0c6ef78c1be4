"""Who takes part in a run, read from the diagram: closed, without a deadlock, and who owes."""

from dataclasses import replace
from functools import lru_cache
from itertools import product
import shlex
from types import SimpleNamespace

from hypothesis import given
from hypothesis import strategies as st
import pytest

from rvd_dynamics.diagram.block import GROUND
from rvd_dynamics.diagram.diagram import GROUPINGS
from rvd_dynamics.diagram.roster import COMMON, lines, listed, RECORDER_LEAD, Roster, RUN_TOPICS
from rvd_dynamics.diagram.scenario import parse
from rvd_groundstation.guidance import LAWS
from rvd_groundstation.operators.operation import JOY_INPUTS, OPERATORS

RUNS = list(product(OPERATORS, JOY_INPUTS, sorted(LAWS), GROUPINGS))


@lru_cache(maxsize=None)
def scenario(operator, joy_input, law, processes):
    return parse(f"""
/**: {{ros__parameters: {{pace: realtime, operator: {operator}, joy_input: {joy_input},
                          processes: {processes}}}}}
auto_controller: {{ros__parameters: {{law: {law}}}}}
""", 'played')


@lru_cache(maxsize=None)
def whole(run):
    """Return the roster of a whole run: blocks, watchers, markers and externals."""
    return listed(scenario(*run), headless=False)


@lru_cache(maxsize=None)
def ring(run):
    """Return the roster of the nodes without which a run cannot step."""
    return Roster(scenario(*run))


@pytest.fixture(params=RUNS, ids='-'.join)
def run(request):
    return request.param


# -- topics ------------------------------------------------------------------------------------

def test_every_topic_of_a_node_is_in_the_table_of_topics(run):
    roster = whole(run)
    for name in roster.names:
        assert roster.reads(name) | roster.writes(name) <= set(roster.topics), name


def test_every_topic_has_one_writer_among_the_nodes_of_a_run(run):
    roster = whole(run)
    for topic in set(roster.topics) - set(COMMON):
        assert len([n for n in roster.names if topic in roster.writes(n)]) == 1, topic
        assert roster.expected(topic)[0] == 1, topic


def test_every_input_is_written_by_the_ring_or_by_whoever_holds_the_stick(run):
    roster = ring(run)
    written = {t for name in roster.names for t in roster.emits(name)}
    outside = {t for external in roster.diagram.externals for t in external.writes}
    assert outside == ({'/joy'} if run[0] in ('console', 'joy') else set())
    for name in roster.names:
        block = roster.blocks[name]
        assert {read.signal.name for read in block.reads.values()} <= written | outside, name


def test_what_a_node_writes_at_each_firing_is_part_of_what_it_writes(run):
    roster = whole(run)
    for name in roster.names:
        assert set(roster.emits(name)) <= roster.writes(name)
        assert not set(roster.emits(name)) & (set(RUN_TOPICS) - {'/clock'})


def test_nothing_but_the_guard_writes_thrust_and_no_ground_node_reads_what_is_out_there(run):
    roster = whole(run)
    assert [n for n in roster.names if '/onboard/thruster_command' in roster.writes(n)] == [
        'onboard_guard']
    nodes = roster.blocks | roster.externals
    ground = [name for name, node in nodes.items() if node.segment == GROUND]
    assert {'state_predictor', 'auto_controller', 'command_blender'} <= set(ground)
    for name in ground:
        assert not [t for t in roster.reads(name) if t.startswith(('/truth', '/onboard'))], name


@pytest.mark.parametrize('operator, joy_input, fires, watches', [
    ('model', 'stepped', True, False), ('console', 'held', False, True),
    ('joy', 'held', False, True), ('none', 'stepped', False, False)])
def test_a_law_that_uses_the_stick_gets_it_as_the_blender_does(operator, joy_input, fires,
                                                               watches):
    seeing = ring((operator, joy_input, 'barrier', 'blocks'))
    for node in ('auto_controller', 'command_blender'):
        sticks = [r for r in seeing.blocks[node].reads.values() if r.signal.name == '/joy']
        assert [r.held for r in sticks] == ([watches] if fires or watches else [])
        assert all(r.delay == 0 for r in sticks)
    blind = ring((operator, joy_input, 'corridor_apf', 'blocks'))
    assert '/joy' not in blind.reads('auto_controller')


@pytest.mark.parametrize('driver, process, foreign', [
    ('joystick', 'joystick', False), ('joy_node', 'joy_node', True), ('external', None, True)])
def test_the_driver_of_a_held_stick_is_ours_or_foreign_or_started_by_somebody_else(
        driver, process, foreign):
    roster = listed(parse(f"""
/**: {{ros__parameters: {{pace: realtime, operator: joy, joy_input: held, joy_driver: {driver}}}}}
""", 'played'), headless=True)
    [external] = roster.diagram.externals
    assert external.foreign == foreign and roster.process_of.get(external.name) == process
    assert roster.expected('/joy') == (1, 2)        # the blender and the recorder wait for a writer
    assert roster.expected('/run/end')[1] == len(roster.processes) - 1 - (driver == 'joy_node')


def test_a_console_may_watch_any_run_and_holds_the_stick_where_it_is_the_operator(run):
    roster = listed(scenario(*run), headless=True, console=True)
    assert roster.names.count('console') == 1 and roster.process_of['console'] == 'console'
    assert roster.writes('console') == ({'/joy'} if run[0] == 'console' else set())
    assert {'/run/end', '/run/pause', '/run/events', '/run/verdict'} <= roster.reads('console')
    assert roster.names[-2:] == ('mission_monitor', 'bag_recorder')


# -- processes ---------------------------------------------------------------------------------

def test_where_a_console_writes_the_page_of_the_run_does_not_count(run):
    """It was there before the page: what it said on /run/events passed for a stranger's."""
    watched = listed(scenario(*run), headless=True, console=True)
    assert watched.counted == {'/run/pause', '/run/end'}
    nobody = listed(scenario('model', *run[1:]), headless=True)
    assert nobody.counted == {'/run/pause', '/run/end', '/run/events'}


def test_every_node_has_one_process_and_externals_have_their_own(run):
    roster = whole(run)
    held = [node for process in roster.processes for node in process.nodes]
    unstarted = {e.name for e in roster.diagram.externals if not e.started}
    assert sorted(held) == sorted(set(roster.names) - unstarted)
    externals = [external.name for external in roster.diagram.externals if external.started]
    for name in externals:
        assert roster.process_of[name] == name
    groups = [p for p in roster.processes if p.name not in externals]
    if run[3] == 'blocks':
        assert all(p.nodes == (p.name,) and not p.grouped for p in groups)
    else:
        assert all(p.grouped for p in groups)
        assert [p.name for p in groups] == (
            ['one'] if run[3] == 'one' else ['world', 'onboard', 'link', 'ground', 'watch'])


def test_the_bring_up_gets_one_line_a_process_that_a_shell_can_read(run):
    roster = whole(run)
    made = lines(roster, '/run/with a blank', '/rvd/here/run_1')
    processes = {process.name: process for process in roster.processes}
    assert [line.split()[0] for line in made][-1] == roster.process_of['bag_recorder']
    assert sorted(line.split()[0] for line in made) == sorted(processes)
    for line in made:
        name, package, executable, *arguments = shlex.split(line)
        process = processes[name]
        assert (name, package, executable) == process[:3]
        assert arguments[arguments.index('--enclave') + 1] == '/rvd/here/run_1'
        assert f'nodes:=[{",".join(roster.names)}]' in arguments
        told = [a for a in arguments if a.startswith(('__node:=', 'group:='))]
        assert told == [f'group:={name}' if process.grouped else f'__node:={name}']
        assert ('bag_recorder:bag_dir:="/run/with a blank/bag"' in arguments) == (
            'bag_recorder' in process.nodes)


EXPECTED = {    # processes, topic: (publishers, subscriptions of other processes)
    ('blocks', '/truth/relative_state'): (1, 4),        # sensor, monitor, recorder, markers
    ('segments', '/truth/relative_state'): (1, 1),      # the watchers share a process
    ('one', '/truth/relative_state'): (1, 0),
    ('blocks', '/ground/prediction'): (1, 4),           # pilot, law, recorder, markers
    ('segments', '/ground/prediction'): (1, 1),
    ('blocks', '/ground/uplink'): (1, 2),               # forward link, recorder
    ('segments', '/ground/uplink'): (1, 2),
    ('one', '/ground/uplink'): (1, 0),
    ('blocks', '/onboard/thruster_command'): (1, 4),    # dynamics, sensor, recorder, monitor
    ('segments', '/onboard/thruster_command'): (1, 2),
    ('blocks', '/run/end'): (1, 11),                    # all but the dynamics, which write it
    ('segments', '/run/end'): (1, 4),
    ('one', '/run/end'): (1, 0),
    ('blocks', '/run/recorded_step'): (1, 1),
    ('segments', '/run/recorded_step'): (1, 1),
    ('one', '/run/recorded_step'): (1, 0),
}


@pytest.mark.parametrize('processes, topic', EXPECTED, ids=map(' '.join, EXPECTED))
def test_expected_endpoints_are_those_of_other_processes(processes, topic):
    roster = whole(('model', 'stepped', 'corridor_apf', processes))
    assert len(roster.names) == 12
    assert roster.expected(topic) == EXPECTED[processes, topic]


# -- the data flow, played by hand -------------------------------------------------------------

class Played:
    """Processes that fire their blocks, each when its own inputs are there."""

    def __init__(self, roster, steps, dead=None, dead_from=0):
        self.roster, self.steps = roster, steps
        self.dead, self.dead_from = dead, dead_from
        self.count = dict.fromkeys(roster.names, 0)
        self.writer = {t: n for n in roster.names for t in roster.emits(n)}

    def may_fire(self, name):
        k = self.count[name]
        if k >= self.steps or name == self.dead and k >= self.dead_from:
            return False
        return all(read.held or read.signal.name not in self.writer or k < read.delay
                   or self.count[self.writer[read.signal.name]] > k - read.delay
                   for read in self.roster.blocks[name].reads.values())

    def ready(self):
        """Return the processes in which a block may fire."""
        return [p for p in self.roster.processes if any(map(self.may_fire, p.nodes))]

    def let(self, process):
        """Let a process fire what it can, in its order, as long as it can."""
        moved = True
        while moved:
            moved = False
            for name in process.nodes:
                while self.may_fire(name):
                    self.count[name] += 1
                    moved = True

    def last_steps(self):
        return {topic: self.count[name] - 1 for name in self.count
                for topic in self.roster.emits(name)}


@given(st.sampled_from(RUNS), st.data())
def test_every_block_fires_once_per_step_without_a_deadlock(run, data):
    """Whichever process has its turn next, all of them get through."""
    played = Played(ring(run), steps=5)
    while ready := played.ready():
        played.let(data.draw(st.sampled_from(ready)))
    assert played.count == dict.fromkeys(played.roster.names, 5)


@given(st.sampled_from(RUNS), st.data())
def test_a_node_that_stops_is_the_one_that_owes(run, data):
    roster = ring(run)
    dead = data.draw(st.sampled_from(roster.names))
    until = data.draw(st.integers(0, 20))
    played = Played(roster, until + 30, dead, until)
    while ready := played.ready():
        played.let(ready[0])
    last = played.last_steps()
    if run[0] in ('console', 'joy') and run[1] == 'stepped':
        last['/joy'] = until + 30               # the hand has answered every step
    if all(read.held for block in roster.blocks.values() for read in block.reads.values()
           if read.signal.name in roster.emits(dead)):          # nobody waits for this hand
        assert min(n for name, n in played.count.items() if name != dead) == until + 30
        assert dead in roster.who_owes(last)
    else:
        assert roster.who_owes(last) == [dead]


@pytest.mark.parametrize('run', [run for run in RUNS if run[2:] == ('barrier', 'blocks')],
                         ids='-'.join)
def test_no_block_of_the_approach_is_ahead_of_the_world(run):
    """By another road: let each fire as far as it can while the world stands at a step."""
    roster = ring(run)
    reached = dict.fromkeys(roster.blocks, -1)
    for _ in range(3 * len(reached)):
        for name, block in roster.blocks.items():
            if name == roster.diagram.plant:
                reached[name] = 5               # the world; pilots and pages are further
                continue
            may = [99] if not roster.follows_clock(name) else [5]
            for read in block.reads.values():
                writer = roster.diagram.writer_of.get(read.signal.name)
                if writer is not None and not read.held:
                    may.append(reached[writer.name] + read.delay)
            reached[name] = min(may)
    assert {name for name, step in reached.items() if step > 5} == set()
    assert roster.follow_world == set(roster.blocks)


def test_a_block_that_waits_for_a_pilot_alone_may_be_ahead_of_the_world():
    roster = Roster(scenario('joy', 'stepped', 'corridor_apf', 'blocks'))
    blender = roster.blocks['command_blender']
    alone = replace(blender, reads={name: read for name, read in blender.reads.items()
                                    if read.signal.name not in roster.diagram.writer_of})
    assert [read.signal.name for read in alone.reads.values()] == ['/joy']
    roster.blocks['command_blender'] = alone
    order = tuple(alone if block.name == alone.name else block for block in roster.diagram.order)
    roster.diagram = SimpleNamespace(plant=roster.diagram.plant, order=order,
                                     writer_of=roster.diagram.writer_of)
    assert set(roster.blocks) - roster.follow_world >= {'command_blender', 'link_forward',
                                                        'onboard_guard'}


@pytest.mark.parametrize('processes', GROUPINGS)
def test_a_recorder_that_is_far_behind_owes(processes):
    roster = whole(('model', 'stepped', 'corridor_apf', processes))
    last = {topic: 80 for name in roster.names for topic in roster.emits(name)}
    last['/run/recorded_step'] = 80 - RECORDER_LEAD
    assert 'bag_recorder' in roster.who_owes(last)
    last['/run/recorded_step'] += 1
    assert 'bag_recorder' not in roster.who_owes(last)


def test_a_pilot_who_answers_every_step_and_says_nothing_is_the_one_that_owes():
    roster = whole(('joy', 'stepped', 'corridor_apf', 'blocks'))
    assert 'external_stick' in roster.names
    last = {topic: 0 for name in roster.names for topic in roster.emits(name)}
    for topic in roster.emits('command_blender') + roster.emits('link_forward') \
            + roster.emits('onboard_guard'):
        last[topic] = -1
    assert roster.who_owes(last) == ['external_stick']
    assert roster.who_owes({**last, '/joy': 0}) == ['command_blender']      # that one has it all
