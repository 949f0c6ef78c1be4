"""
The rules of diagrams, each with a small diagram that breaks it; and what flies in one process.

Blocks here are toys that write down what they were given. What several rates come to is held
against a table made by hand.
"""

from dataclasses import replace
import pickle
from zlib import crc32

from hypothesis import given
from hypothesis import strategies as st
import numpy as np
from numpy.testing import assert_array_equal
import pytest

from rvd_dynamics.diagram import mission as missions
from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.block import (
    Block, External, GROUND, held, last, Leg, LINK, now, ONBOARD, Read, WATCH, WORLD)
from rvd_dynamics.diagram.control import Change, Control
from rvd_dynamics.diagram.diagram import Diagram, DiagramError
from rvd_dynamics.diagram.in_process import draw, fly
from rvd_dynamics.diagram.judge import Verdict
from rvd_dynamics.diagram.mission import find, Mission
from rvd_dynamics.diagram.scenario import parse, Scenario, ScenarioError
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.diagram.streams import Normals, StartNormals

LAST_STEP = 12


def number(name, **keys):
    """Return a signal of one whole number, -1 before its writer has fired."""
    return Signal(name, (Part('value', (), '', 'i8', -1),), **keys)


TRUTH = Signal('/truth/count', (Part('value', (), '', 'i8', -1), Part('final', (), '', '?')),
               truth=True)
MEASURED, SENT = number('/onboard/measured'), number('/onboard/sent')
HEARD, ASKED = number('/ground/heard'), number('/ground/asked')
ARRIVED, THRUST = number('/onboard/arrived'), number('/onboard/thrust')


def toy(name, segment, reads=None, writes=None, make='Toy', **keys):
    """Return a block whose code is in this file."""
    kind = Leg if segment == LINK else Block
    return kind(name, f'{__name__}:{make}', segment, reads or {}, writes or {}, **keys)


PLANT = toy('plant', WORLD, {'thrust': last(THRUST)}, {'truth': TRUTH}, make='Plant')
SENSOR = toy('sensor', WORLD, {'truth': now(TRUTH)}, {'measured': MEASURED})
DOWN = toy('down', LINK, {'content': now(MEASURED)}, {'heard': HEARD})
PILOT = toy('pilot', GROUND, {'heard': now(HEARD)}, {'asked': ASKED})
UP = toy('up', LINK, {'content': now(ASKED)}, {'arrived': ARRIVED})
GUARD = toy('guard', ONBOARD, {'arrived': now(ARRIVED)}, {'thrust': THRUST})
WHOLE = (PLANT, SENSOR, DOWN, PILOT, UP, GUARD)


def diagram(*blocks, **keys):
    """Return a diagram of these blocks, in which those of `WHOLE` are replaced by name."""
    mine = {block.name: block for block in (*WHOLE, *blocks)}
    return Diagram(tuple(mine.values()), **{
        'plant': 'plant', 'guard': 'guard', 'thrust': THRUST.name, **keys})


def changed(block, **keys):
    """Return a block with other reads or writes beside its own."""
    return replace(block, **{key: {**getattr(block, key), **value}
                             if isinstance(value, dict) else value for key, value in keys.items()})


# -- rules ------------------------------------------------------------------------------------

def test_a_whole_diagram_is_in_order_and_knows_who_writes_what():
    whole = diagram()
    assert [b.name for b in whole.order] == [b.name for b in WHOLE]
    assert whole.writer_of[HEARD.name].name == 'down' and whole.truth is TRUTH
    assert [b.name for b in whole.readers_of(HEARD.name)] == ['pilot']
    assert {name: [b.name for b in group] for name, group in whole.groups('segments').items()} == {
        'world': ['plant', 'sensor'], 'onboard': ['guard'], 'link': ['down', 'up'],
        'ground': ['pilot']}


@pytest.mark.parametrize('make, words', {
    'two writers': (
        lambda: diagram(changed(SENSOR, writes={'thrust': THRUST})),
        'block guard writes /onboard/thrust as thrust, which sensor.thrust writes too: a signal '
        'has one writer'),
    'one writer, twice': (
        lambda: diagram(changed(SENSOR, writes={'again': MEASURED})),
        'block sensor writes /onboard/measured as again, which sensor.measured writes too: a '
        'signal has one writer'),
    'a writer from outside': (
        lambda: diagram(externals=(External('desk', 'p', 'e', GROUND, writes=(ASKED.name,)),)),
        'block pilot writes /ground/asked as asked, which desk writes too: a signal has one '
        'writer'),
    'no writer': (
        lambda: diagram(changed(PILOT, reads={'wind': now(number('/ground/wind'))})),
        'block pilot reads /ground/wind as wind, which nobody writes: a signal has one writer'),
    'two layouts': (
        lambda: diagram(changed(PILOT, reads={'heard': now(Signal(HEARD.name, (
            Part('value', (3,)),)))})),
        'block pilot reads /ground/heard with another layout than down writes: a signal has one '
        'layout'),
    'a cycle': (
        lambda: diagram(changed(PLANT, reads={'thrust': now(THRUST)})),
        'blocks plant -> guard -> up -> pilot -> down -> sensor -> plant wait for each other: a '
        'cycle needs a delay of at least one step'),
    'a block that reads itself': (
        lambda: diagram(changed(PILOT, reads={'before': now(ASKED)})),
        'blocks pilot -> pilot wait for each other: a cycle needs a delay of at least one step'),
    'truth to the ground': (
        lambda: diagram(changed(PILOT, reads={'truth': now(TRUTH)})),
        'block pilot of segment ground reads /truth/count: truth is for the world and the '
        'watchers alone'),
    'truth to the craft': (
        lambda: diagram(changed(GUARD, reads={'truth': last(TRUTH)})),
        'block guard of segment onboard reads /truth/count: truth is for the world and the '
        'watchers alone'),
    'truth to the link': (
        lambda: diagram(changed(DOWN, reads={'content': now(TRUTH)})),
        'block down of segment link reads /truth/count: truth is for the world and the watchers '
        'alone'),
    'truth to the desk': (
        lambda: diagram(externals=(External('desk', 'p', 'e', GROUND, reads=(TRUTH.name,)),)),
        'desk of segment ground reads /truth/count: truth is for the world and the watchers '
        'alone'),
    'truth from the ground': (
        lambda: diagram(changed(PILOT, writes={'guess': number('/truth/guess', truth=True)})),
        'block pilot of segment ground writes /truth/guess: truth is written by the world'),
    'past the link, down': (
        lambda: diagram(changed(PILOT, reads={'measured': now(MEASURED)})),
        'block pilot of segment ground reads /onboard/measured of segment world: only a leg of '
        'the link joins them'),
    'past the link, up': (
        lambda: diagram(changed(GUARD, reads={'asked': now(ASKED)})),
        'block guard of segment onboard reads /ground/asked of segment ground: only a leg of the '
        'link joins them'),
    'past the link, to the desk': (
        lambda: diagram(externals=(External('desk', 'p', 'e', GROUND, reads=(THRUST.name,)),)),
        'desk of segment ground reads /onboard/thrust of segment onboard: only a leg of the link '
        'joins them'),
    'the ground steers the world': (
        lambda: diagram(changed(PLANT, reads={'asked': last(ASKED)})),
        'block plant of segment world reads /ground/asked of segment ground: only a leg of the '
        'link joins them'),
    'a link that is no leg': (
        lambda: diagram(Block('wire', f'{__name__}:Toy', LINK, {'asked': now(ASKED)})),
        'block wire of segment link is no leg: only a leg of the link joins craft and ground'),
    'somebody else writes thrust': (
        lambda: diagram(guard='sensor'),
        '/onboard/thrust is written by guard: the guard sensor is the only writer of thrust'),
    'nobody writes thrust': (
        lambda: diagram(thrust='/onboard/torque'),
        '/onboard/torque is written by nobody: the guard guard is the only writer of thrust'),
    'from slow to fast': (
        lambda: diagram(replace(SENSOR, period=2)),
        'block down (period 1) reads /onboard/measured of sensor (period 2) without delay: what a '
        'slower block writes is read at least one step later'),
    'two blocks of one name': (
        lambda: Diagram((*WHOLE, PILOT), 'plant', 'guard', THRUST.name),
        'block pilot is declared twice: names are unique'),
    'a desk with the name of a block': (
        lambda: diagram(externals=(External('pilot', 'p', 'e', GROUND),)),
        'block pilot is declared twice: names are unique'),
    'no plant': (
        lambda: diagram(plant='moon'),
        "the plant must be one of the blocks plant, sensor, down, pilot, up, guard, got 'moon'"),
    'no guard': (
        lambda: diagram(guard='moon'),
        "the guard must be one of the blocks plant, sensor, down, pilot, up, guard, got 'moon'"),
    'no end': (
        lambda: diagram(plant='sensor'),
        'block sensor is the plant, but no signal of it has a part final: the plant says when a '
        'run ends'),
    'nothing to wait for': (
        lambda: diagram(replace(PILOT, reads={'heard': held(HEARD)})),
        'block pilot reads nothing that makes it fire: a block fires when its inputs are '
        'complete'),
    'one stream twice': (
        lambda: diagram(changed(PLANT, draws={'noise': Normals('measurement', 2)}),
                        changed(SENSOR, draws={'more': StartNormals('measurement')})),
        'block sensor draws more (measurement) from the stream of noise (measurement) of block '
        'plant: each draw has a stream of its own'),
    'one stream twice in one block': (
        lambda: diagram(changed(PLANT, draws={'a': Normals('start', 2), 'b': Normals('start', 2)})),
        'block plant draws b (start) from the stream of a (start) of block plant: each draw has a '
        'stream of its own'),
    'two purposes of one CRC-32': (
        lambda: diagram(changed(PLANT, draws={'a': Normals('toy/plant/plumless', 1),
                                              'b': Normals('toy/plant/buckeroo', 1)})),
        'block plant draws b (toy/plant/buckeroo) from the stream of a (toy/plant/plumless) of '
        'block plant: each draw has a stream of its own'),
    'a purpose that is none': (
        lambda: diagram(changed(PLANT, draws={'noise': Normals('noise', 2)})),
        'block plant draws noise: purpose must be one of start, measurement, execution, '
        'link_forward, link_back, pilot, pilot_skill, or of the form mission/block/purpose, got '
        "'noise'"),
}.values(), ids=lambda value: '' if callable(value) else value.split(':')[-1].strip())
def test_what_breaks_a_rule_is_refused_in_one_line(make, words):
    with pytest.raises(DiagramError) as refusal:
        make()
    assert str(refusal.value) == words


@pytest.mark.parametrize('make, words', [
    (lambda: Block('b', 'm:C', 'orbit'),
     "block b: segment must be one of world, onboard, link, ground, watch, got 'orbit'"),
    (lambda: Block('b', 'm:C', WORLD, period=0), 'block b: period must be at least 1, got 0'),
    (lambda: Read(MEASURED, -1), '/onboard/measured: a delay must not be negative, got -1'),
    (lambda: Signal('count', ()), "signal 'count': the name is a topic and begins with a slash"),
    (lambda: Signal('/n', (Part('a'), Part('a'))), 'signal /n: two parts have one name: a, a'),
    (lambda: Signal('/n', (Part('a', optional=True), Part('b'))),
     'signal /n: optional parts come last: a, b'),
    (lambda: diagram().groups('pairs'), "processes must be one of blocks, segments, one, got "
                                        "'pairs'")])
def test_a_declaration_that_cannot_be_is_refused_in_one_line(make, words):
    with pytest.raises(ValueError) as refusal:
        make()
    assert str(refusal.value) == words


def test_watchers_may_read_everything():
    reads = {name: now(signal) for name, signal in diagram().signals.items()}
    arguments = {f'in_{i}': read for i, read in enumerate(reads.values())}
    assert diagram(toy('watch', WATCH, arguments)).order[-1].name == 'watch'


def test_what_is_held_comes_first_unless_it_waits_for_its_reader():
    stick = number('/joy')
    hand = toy('hand', GROUND, {'heard': now(HEARD)}, {'stick': stick})
    reader = changed(PILOT, reads={'stick': held(stick)})
    names = [b.name for b in diagram(reader, hand).order]
    assert names.index('hand') < names.index('pilot')
    echo = toy('hand', GROUND, {'asked': now(ASKED)}, {'stick': stick})
    names = [b.name for b in diagram(reader, echo).order]
    assert names.index('pilot') < names.index('hand')


# -- flown in one process ---------------------------------------------------------------------

class Toy:
    """Writes the step in which it fires; keeps what it was given."""

    def __init__(self, block, batch):
        self.block, self.batch, self.given = block, batch, []
        SEEN[block.name] = self.given

    def step(self, k, control=None, **inputs):
        self.given.append((k, {name: np.ravel(value[0])[0] for name, value in inputs.items()},
                           control))
        return {name: self.value(k, signal) for name, signal in self.block.writes.items()}

    def value(self, k, signal):
        return signal(value=np.full(self.batch, k))


class Plant(Toy):
    """Ends the run."""

    def value(self, k, signal):
        return signal(value=np.full(self.batch, k), final=np.full(self.batch, k >= LAST_STEP))


class Judge:
    """Judges nothing."""

    measures, reasons = (), {'over': 'over'}

    def __init__(self, batch=()):
        self._batch = batch

    def follow(self, k, truth):
        pass

    def verdict(self, final=False):
        return Verdict(np.ones(self._batch, dtype=bool), np.full(self._batch, 'over'),
                       np.ones(self._batch), {})


SEEN, FLOWN = {}, {}


def flown_diagram(scenario):
    """Return what the test at hand flies."""
    return FLOWN['diagram']


MISSION = Mission('toy', 'Counts.', shared=(), sections={}, diagram=f'{__name__}:flown_diagram',
                  judge=f'{__name__}:Judge')


def fly_toys(*blocks, runs=range(3), **keys):
    """Fly a diagram of toys; return the batch."""
    FLOWN['diagram'] = diagram(*blocks)
    SEEN.clear()
    scenario = Scenario('toy', MISSION, {'/**': {'timeout_s': 20.0, 'mission': 'toy'}}).check()
    return fly(scenario, runs, **keys)


def given_to(block):
    """Return the steps in which a toy fired, and what it read as each input."""
    steps = [k for k, _, _ in SEEN[block]]
    inputs = {name: [int(values[name]) for _, values, _ in SEEN[block]]
              for name in SEEN[block][0][1]}
    return steps, inputs


A, B, C = number('/toy/a'), number('/toy/b'), number('/toy/c')
RATES = (
    toy('one', WORLD, {'truth': now(TRUTH)}, {'a': A}),
    toy('two', WORLD, {'a0': now(A), 'c1': last(C)}, {'b': B}, period=2),
    toy('five', WORLD, {'a2': Read(A, 2), 'b0': now(B)}, {'c': C}, period=5),
    toy('look', WATCH, {'a0': now(A), 'a1': last(A), 'a3': Read(A, 3), 'b1': last(B),
                        'b2': Read(B, 2), 'c1': last(C), 'c4': Read(C, 4)}))
TABLE = {                   # by hand, for the steps 0 .. 12: which step's value is read
    'look': (list(range(13)), {
        'a0': [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12],
        'a1': [-1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11],
        'a3': [-1, -1, -1, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9],
        'b1': [-1, 0, 0, 2, 2, 4, 4, 6, 6, 8, 8, 10, 10],
        'b2': [-1, -1, 0, 0, 2, 2, 4, 4, 6, 6, 8, 8, 10],
        'c1': [-1, 0, 0, 0, 0, 0, 5, 5, 5, 5, 5, 10, 10],
        'c4': [-1, -1, -1, -1, 0, 0, 0, 0, 0, 5, 5, 5, 5]}),
    'two': ([0, 2, 4, 6, 8, 10, 12], {
        'a0': [0, 2, 4, 6, 8, 10, 12],
        'c1': [-1, 0, 0, 5, 5, 5, 10]}),
    'five': ([0, 5, 10], {
        'a2': [-1, 3, 8],
        'b0': [0, 4, 10]}),
}


def test_rates_and_delays_are_those_of_the_table():
    batch = fly_toys(*RATES, record=True)
    for block, expected in TABLE.items():
        assert given_to(block) == expected, block
    assert batch.end_step.tolist() == [LAST_STEP]*3
    assert batch.history['/toy/b'].value[:, 0].tolist() == [0, 0, 2, 2, 4, 4, 6, 6, 8, 8, 10, 10,
                                                            12]


def test_the_order_in_which_blocks_are_declared_changes_nothing():
    fly_toys(*RATES[::-1])
    for block, expected in TABLE.items():
        assert given_to(block) == expected, block


@given(writes=st.integers(1, 5), reads=st.integers(1, 5), delay=st.integers(0, 7))
def test_a_read_gives_the_last_firing_at_or_before_its_delay(writes, reads, delay):
    if writes > reads and delay == 0:
        delay = 1                               # the rule asks for it
    fly_toys(toy('writer', WORLD, {'truth': now(TRUTH)}, {'a': A}, period=writes),
             toy('reader', WATCH, {'a': Read(A, delay)}, period=reads))
    steps, inputs = given_to('reader')
    assert steps == list(range(0, LAST_STEP + 1, reads))
    assert inputs['a'] == [(k - delay)//writes*writes if k >= delay else -1 for k in steps]


def test_the_loop_is_closed_with_its_delay():
    """The plant reads the thrust of the step before, the rest is of the same step."""
    fly_toys()
    assert given_to('plant')[1]['thrust'] == [-1, *range(LAST_STEP)]
    assert given_to('guard')[1]['arrived'] == list(range(LAST_STEP + 1))


def test_control_comes_from_the_schedule_and_an_abort_stays():
    fly_toys(replace(PILOT, control=True), schedule=[
        Change(3, mode='auto'), Change(5, abort=True), Change(8, mode='manual')])
    seen = [control for _, _, control in SEEN['pilot']]
    assert seen == [Control()]*3 + [Control('auto')]*2 + [Control('auto', True)]*3 + [
        Control('manual', True)]*5
    assert not any(control for _, _, control in SEEN['guard'])


# -- draws ------------------------------------------------------------------------------------

class Noisy(Toy):
    """Keeps its draws."""

    def __init__(self, block, batch, noise, start):
        super().__init__(block, batch)
        SEEN['noise'], SEEN['start'] = noise, start


def test_a_block_gets_the_draws_that_it_declares_keyed_by_the_name_of_their_purpose():
    noisy = changed(SENSOR, make=f'{__name__}:Noisy', draws={
        'noise': Normals('toy/sensor/noise', 2), 'start': StartNormals('toy/sensor/start', 4)})
    fly_toys(noisy, runs=[7, 2])
    assert SEEN['noise'].shape == (2, 41, 2) and SEEN['start'].shape == (2, 4)
    for row, run in enumerate([7, 2]):
        for name, rows in (('noise', SEEN['noise']), ('start', SEEN['start'])):
            key = crc32(f'toy/sensor/{name}'.encode())
            rng = np.random.Generator(np.random.PCG64(np.random.SeedSequence(
                entropy=0, spawn_key=(run, key))))
            assert_array_equal(rows[row], rng.standard_normal(rows[row].shape))


def test_draws_of_one_run_are_its_row_of_many():
    for chance in (Normals('toy/sensor/noise', 2), StartNormals('toy/sensor/start', 4)):
        many = chance.of_runs(5, [0, 3, 9], 20)
        for row, run in enumerate([0, 3, 9]):
            assert_array_equal(chance.of_run(5, run, 20), many[row])


def test_a_name_whose_number_is_that_of_an_old_purpose_is_refused(monkeypatch):
    monkeypatch.setitem(streams.PURPOSES, 'old', crc32(b'toy/sensor/noise'))
    with pytest.raises(DiagramError, match='^block sensor draws noise: purpose '
                                           "'toy/sensor/noise' has the stream of another"):
        diagram(changed(SENSOR, draws={'noise': Normals('toy/sensor/noise', 2)}))


def test_draws_of_other_blocks_are_refused():
    FLOWN['diagram'] = diagram()
    scenario = Scenario('toy', MISSION, {'/**': {'timeout_s': 20.0}}).check()
    draws = draw(scenario, [0])
    with pytest.raises(ValueError, match='draws are of other runs'):
        fly_toys(changed(SENSOR, draws={'noise': Normals('toy/sensor/noise', 2)}), runs=[0],
                 draws=draws)


# -- what a block returns -----------------------------------------------------------------------

BAD = {
    'nothing': (lambda toy: None,
                'block sensor: step must return a value for each output by name, got NoneType'),
    'no mapping': (lambda toy: MEASURED(value=np.zeros(toy.batch, dtype=int)),
                   'block sensor: step must return a value for each output by name, got '
                   'OnboardMeasured'),
    'unknown output': (lambda toy: {'measrued': MEASURED(value=np.zeros(toy.batch, dtype=int))},
                       "block sensor returns 'measrued', which it does not write; it writes "
                       'measured'),
    'another signal': (lambda toy: {'measured': TRUTH(value=0, final=False)},
                       'block sensor writes /onboard/measured: must be a value of '
                       '/onboard/measured, got TruthCount'),
    'a bare array': (lambda toy: {'measured': np.zeros(toy.batch)},
                     'block sensor writes /onboard/measured: must be a value of '
                     '/onboard/measured, got ndarray'),
    'another shape': (lambda toy: {'measured': MEASURED(value=np.zeros((3, 2), dtype=int))},
                      'block sensor writes /onboard/measured: value must have shape (3,), got '
                      '(3, 2)'),
    'another batch': (lambda toy: {'measured': MEASURED(value=np.zeros(4, dtype=int))},
                      'block sensor writes /onboard/measured: value must have shape (3,), got '
                      '(4,)'),
    'another type': (lambda toy: {'measured': MEASURED(value=np.zeros(toy.batch))},
                     'block sensor writes /onboard/measured: value must be int64, got float64'),
}


class Bad(Toy):
    """Returns what it must not."""

    def step(self, k, **inputs):
        return BAD[FLOWN['bad']][0](self)


@pytest.mark.parametrize('bad', BAD)
def test_a_value_of_the_wrong_form_is_refused_in_one_line(bad):
    FLOWN['bad'] = bad
    with pytest.raises(DiagramError) as refusal:
        fly_toys(replace(SENSOR, make=f'{__name__}:Bad'))
    assert str(refusal.value) == BAD[bad][1]


class Greedy(Toy):
    """Asks for what there is not."""

    def __init__(self, block, batch, crystal_ball):
        super().__init__(block, batch)


@pytest.mark.parametrize('make, words', [
    ('Greedy', f"block sensor: {__name__}:Greedy needs 'crystal_ball', which neither the "
               'scenario nor the mission has'),
    ('Gone', f'block sensor: module {__name__} has no Gone')])
def test_a_block_that_cannot_be_made_is_refused_in_one_line(make, words):
    with pytest.raises(ValueError) as refusal:
        fly_toys(replace(SENSOR, make=f'{__name__}:{make}'))
    assert str(refusal.value) == words


def test_what_comes_from_outside_takes_a_graph():
    stick = number('/joy')
    FLOWN['diagram'] = Diagram(
        (*WHOLE[:3], changed(PILOT, reads={'stick': held(stick)}), *WHOLE[4:]), 'plant', 'guard',
        THRUST.name, (External('desk', 'p', 'e', GROUND, writes=(stick.name,)),))
    scenario = Scenario('toy', MISSION, {'/**': {'timeout_s': 20.0}}).check()
    with pytest.raises(ValueError, match='^pilot reads /joy from desk, which takes a graph'):
        fly(scenario, [0])


# -- missions -----------------------------------------------------------------------------------

def test_a_scenario_of_a_mission_that_is_not_installed_is_refused_in_one_line():
    with pytest.raises(ScenarioError) as refusal:
        parse('/**: {ros__parameters: {mission: moon_base}}', 'mine')
    words = str(refusal.value)
    assert words.startswith("scenario mine: no mission 'moon_base' is installed; there are: ")
    assert 'lunar_approach' in words and '\n' not in words


class Point:
    """An entry point."""

    value = 'somewhere:MISSION'

    def __init__(self, found):
        self._found = found

    def load(self):
        if isinstance(self._found, Exception):
            raise self._found
        return self._found


@pytest.mark.parametrize('found, words', [
    (ImportError('No module named somewhere'),
     'mission mine cannot be loaded: No module named somewhere'),
    (AttributeError("module 'somewhere' has no attribute 'MISSION'"),
     "mission mine cannot be loaded: module 'somewhere' has no attribute 'MISSION'"),
    (MISSION, 'mission mine: somewhere:MISSION must be a Mission of that name'),
    ('a mission', 'mission mine: somewhere:MISSION must be a Mission of that name')])
def test_a_mission_that_cannot_be_had_is_refused_in_one_line(monkeypatch, found, words):
    monkeypatch.setattr(missions, 'installed', lambda: {'mine': Point(found)})
    find.cache_clear()
    with pytest.raises(ValueError) as refusal:
        find('mine')
    find.cache_clear()
    assert str(refusal.value) == words


def test_a_scenario_is_of_one_mission():
    scenario = Scenario('toy', MISSION, {'/**': {'mission': 'toy'}}).check()
    with pytest.raises(ScenarioError, match='of mission toy cannot become one of lunar_approach'):
        scenario.with_values('/**', mission='lunar_approach')
    with pytest.raises(ScenarioError, match="/\\*\\*: unknown key orbit.radius_m; known: "):
        scenario.with_values('/**', orbit__radius_m=1.0)


def test_a_scenario_goes_to_another_process_as_it_is():
    lunar = parse('/**: {ros__parameters: {seed: 4}}', 'mine')
    again = pickle.loads(pickle.dumps(lunar))
    assert again.resolved() == lunar.resolved() and again.name == 'mine'
    assert again.mission is lunar.mission and len(pickle.dumps(lunar)) < 1000
