"""Diagrams: each rule by a small diagram that breaks it, and the loop on several rates."""

from dataclasses import replace
from zlib import crc32

import numpy as np
from numpy.testing import assert_array_equal
import pytest
import toys
from toys import GUARD, HERE, number, PLANT, SENSOR, THRUST, TRUTH, watcher

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram import in_process, mission as missions, streams
from rvd_dynamics.diagram.block import (
    Block, External, GROUND, held, last, Leg, LINK, now, ONBOARD, Read, WATCH, WORLD)
from rvd_dynamics.diagram.control import Change
from rvd_dynamics.diagram.diagram import Diagram, DiagramError
from rvd_dynamics.diagram.scenario import parse, ScenarioError
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.diagram.streams import Normals, StartNormals

A, B = number('/a'), number('/b')
SKY = Signal('/truth/sky', (Part('value'),), truth=True)


def block(name, segment=GROUND, reads=None, writes=None, **more):
    """Return a block of no use."""
    return Block(name, f'{HERE}:Counter', segment, reads=reads or {}, writes=writes or {}, **more)


def diagram(*blocks, plant='plant', guard='guard', thrust=THRUST.name, base=(PLANT, SENSOR, GUARD),
            **more):
    """Return a diagram with these blocks beside plant, sensor and guard."""
    return Diagram((*base, *blocks), plant, guard, thrust, **more)


def leg(name, reads, writes):
    """Return a leg of no use."""
    return Leg(name, f'{HERE}:Counter', LINK, reads=reads, writes=writes)


ONE = block('one', reads={'b': last(B)}, writes={'a': A})
OTHER = block('other', reads={'a': now(A)}, writes={'b': B})


def test_a_diagram_that_breaks_no_rule():
    d = diagram(OTHER, ONE)
    order = [b.name for b in d.order]
    assert order.index('one') < order.index('other')            # it reads what the other writes now
    assert d.truth is TRUTH and d.writer_of['/a'] is ONE
    assert [b.name for b in d.readers_of('/a')] == ['other']
    assert set(d.signals) == {'/truth', '/sensed', '/thrust', '/a', '/b'}


BAD = {
    'two writers': (
        lambda: diagram(ONE, OTHER, block('third', reads={'a': now(A)}, writes={'x': A})),
        'block third writes /a as x, which one.a writes too: a signal has one writer'),
    'one writer, twice': (
        lambda: diagram(replace(ONE, writes={'a': A, 'x': A}), OTHER),
        'block one writes /a as x, which one.a writes too: a signal has one writer'),
    'a writer from outside': (
        lambda: diagram(ONE, OTHER, externals=(External('desk', 'p', 'e', GROUND,
                                                        writes=('/a',)),)),
        'block one writes /a as a, which desk writes too: a signal has one writer'),
    'nobody writes': (
        lambda: diagram(OTHER),
        'block other reads /a as a, which nobody writes: a signal has one writer'),
    'two layouts': (
        lambda: diagram(ONE, OTHER, block('third', reads={'x': now(number('/a', dtype='i8'))})),
        'block third reads /a with another layout than one writes: a signal has one layout'),
    'still, and read': (
        lambda: diagram(replace(ONE, writes={'a': replace(A, still=True)}), OTHER),
        'block other reads /a, which is still: it is published once, for viewers'),
    'cycle': (
        lambda: diagram(replace(ONE, reads={'b': now(B)}), OTHER),
        'blocks one -> other -> one wait for each other: a cycle needs a delay of at least one '
        'step'),
    'waits for itself': (
        lambda: diagram(block('one', reads={'a': now(A)}, writes={'a': A})),
        'blocks one -> one wait for each other: a cycle needs a delay of at least one step'),
    'truth on the ground': (
        lambda: diagram(block('one', GROUND, reads={'sky': last(TRUTH)}, writes={'a': A})),
        'block one of segment ground reads /truth: truth is for the world and the watchers alone'),
    'truth on board': (
        lambda: diagram(block('one', ONBOARD, reads={'sky': last(TRUTH)}, writes={'a': A})),
        'block one of segment onboard reads /truth: truth is for the world and the watchers '
        'alone'),
    'truth on the link': (
        lambda: diagram(leg('one', {'sky': last(TRUTH)}, {'a': A})),
        'block one of segment link reads /truth: truth is for the world and the watchers alone'),
    'truth to the desk': (
        lambda: diagram(externals=(External('desk', 'p', 'e', GROUND, reads=('/truth',)),)),
        'desk of segment ground reads /truth: truth is for the world and the watchers alone'),
    'truth from a watcher': (
        lambda: diagram(block('one', WATCH, reads={'t': now(TRUTH)}, writes={'sky': SKY})),
        'block one of segment watch writes /truth/sky: truth is written by the world'),
    'truth from on board': (
        lambda: diagram(block('one', ONBOARD, reads={'t': now(toys.SENSED)},
                              writes={'sky': SKY})),
        'block one of segment onboard writes /truth/sky: truth is written by the world'),
    'ground reads the craft': (
        lambda: diagram(block('one', GROUND, reads={'t': now(THRUST)}, writes={'a': A})),
        'block one of segment ground reads /thrust of segment onboard: only a leg of the link '
        'joins them'),
    'ground reads the world': (
        lambda: diagram(block('one', GROUND, reads={'s': now(toys.SENSED)})),
        'block one of segment ground reads /sensed of segment world: only a leg of the link joins '
        'them'),
    'craft reads the ground': (
        lambda: diagram(ONE, OTHER, block('third', ONBOARD, reads={'a': now(A)})),
        'block third of segment onboard reads /a of segment ground: only a leg of the link joins '
        'them'),
    'world reads the ground': (
        lambda: diagram(ONE, OTHER, block('third', WORLD, reads={'a': now(A)})),
        'block third of segment world reads /a of segment ground: only a leg of the link joins '
        'them'),
    'the desk reads the craft': (
        lambda: diagram(externals=(External('desk', 'p', 'e', GROUND, reads=('/thrust',)),)),
        'desk of segment ground reads /thrust of segment onboard: only a leg of the link joins '
        'them'),
    'a link that is no leg': (
        lambda: diagram(block('wire', LINK, reads={'s': now(toys.SENSED)}, writes={'a': A})),
        'block wire of segment link is no leg: only a leg of the link joins craft and ground'),
    'thrust by another': (
        lambda: diagram(replace(GUARD, writes={'thrust': B}),
                        block('one', ONBOARD, reads={'s': now(toys.SENSED)},
                              writes={'thrust': THRUST}), base=(PLANT, SENSOR)),
        '/thrust is written by one: the guard guard is the only writer of thrust'),
    'thrust by nobody': (
        lambda: diagram(thrust='/jets'),
        '/jets is written by nobody: the guard guard is the only writer of thrust'),
    'slow to fast': (
        lambda: diagram(replace(ONE, period=4), OTHER),
        'block other (period 1) reads /a of one (period 4) without delay: what a slower block '
        'writes is read at least one step later'),
    'two purposes of one checksum': (
        lambda: diagram(with_chance('x', Normals('toy/x/plumless', 1)),
                        with_chance('y', Normals('toy/x/buckeroo', 1))),
        'block y draws noise from toy/x/buckeroo, which has the stream of toy/x/plumless of block '
        'x: give it another name'),
    'a purpose that is none': (
        lambda: diagram(with_chance('x', Normals('noise', 1))),
        'block x draws noise: purpose must be one of start, measurement, execution, link_forward, '
        "link_back, pilot, pilot_skill, or of the form mission/block/purpose, got 'noise'"),
    'no final': (
        lambda: diagram(plant='sensor'),
        'block sensor is the plant, but no signal of it has a part final: the plant says when a '
        'run ends'),
    'two of one name': (
        lambda: diagram(ONE, OTHER, block('other', reads={'a': now(A)})),
        'block other is declared twice: names are unique'),
    'an external of that name': (
        lambda: diagram(ONE, OTHER, externals=(External('one', 'p', 'e', GROUND),)),
        'block one is declared twice: names are unique'),
    'reads nothing': (
        lambda: diagram(block('one', writes={'a': A})),
        'block one reads nothing that makes it fire: a block fires when its inputs are complete'),
    'reads held alone': (
        lambda: diagram(OTHER, block('one', reads={'b': held(B)}, writes={'a': A})),
        'block one reads nothing that makes it fire: a block fires when its inputs are complete'),
    'no such plant': (
        lambda: diagram(plant='moon'),
        "the plant must be one of the blocks plant, sensor, guard, got 'moon'"),
    'no such guard': (
        lambda: diagram(guard='angel'),
        "the guard must be one of the blocks plant, sensor, guard, got 'angel'"),
    'no such segment': (
        lambda: block('one', 'orbit'),
        "block one: segment must be one of world, onboard, link, ground, watch, got 'orbit'"),
    'period': (lambda: block('one', period=0), 'block one: period must be at least 1, got 0'),
    'delay': (lambda: Read(A, -1), '/a: a delay must not be negative, got -1'),
    'optional first': (
        lambda: Signal('/s', (Part('a', optional=True), Part('b'))),
        'signal /s: optional parts come last: a, b'),
    'parts of one name': (
        lambda: Signal('/s', (Part('a'), Part('a'))), 'signal /s: two parts have one name: a, a'),
    'no slash': (
        lambda: Signal('s', (Part('a'),)),
        "signal 's': the name is a topic and begins with a slash"),
}


@pytest.mark.parametrize('broken, said', BAD.values(), ids=BAD.keys())
def test_each_rule_is_refused_in_one_line_that_names_block_signal_and_rule(broken, said):
    with pytest.raises(ValueError) as refusal:
        broken()
    assert str(refusal.value) == said


def test_what_comes_from_outside_may_be_read_and_joins_no_cycle():
    console = External('console', 'p', 'e', GROUND, writes=('/a',))
    assert diagram(OTHER, externals=(console,)).readers_of('/a') == [OTHER]


def test_what_is_held_comes_first_unless_it_waits_for_its_reader():
    """In a graph the newest one counts, in one process that of the same step where it can."""
    ear = block('ear', reads={'b': held(B), 's': now(A)})
    order = [b.name for b in diagram(ear, ONE, OTHER).order]
    assert order.index('other') < order.index('ear')
    reader = replace(ONE, reads={'b': held(B), 'x': last(B)})
    order = [b.name for b in diagram(OTHER, reader).order]
    assert order.index('one') < order.index('other')


def test_a_leg_joins_craft_and_ground():
    down = leg('down', {'content': now(toys.SENSED)}, {'a': A})
    d = diagram(down, OTHER)
    assert list(d.legs()) == [down]


def test_groups_of_processes():
    d = diagram(ONE, OTHER, watcher('ear', {'a': now(A)}))
    assert {name: [b.name for b in group] for name, group in d.groups('segments').items()} == {
        'world': ['plant', 'sensor'], 'onboard': ['guard'], 'ground': ['one', 'other']}
    assert set(d.groups('blocks')) == {'plant', 'sensor', 'guard', 'one', 'other'}
    assert len(d.groups('one')['one']) == 5                     # the ear has no node
    with pytest.raises(ValueError, match="^processes must be one of blocks, .*, got 'two'$"):
        d.groups('two')


# -- several rates ----------------------------------------------------------------------------

def heard_at(k, delay, period):
    """Return what a read gives by hand: the writer's last firing at or before k - delay."""
    fired = [step for step in range(0, k - delay + 1) if step % period == 0]
    return float(fired[-1]) if fired else np.nan


@pytest.mark.parametrize('writer', [1, 2, 5])
@pytest.mark.parametrize('reader', [1, 2, 5])
@pytest.mark.parametrize('ear_first', [True, False])
def test_a_read_gives_the_last_firing_at_or_before_its_instant(writer, reader, ear_first):
    """Whatever the order of declaration, delays 0 to 7; before the first firing: unknown."""
    delays = [d for d in range(8) if d > 0 or writer <= reader]
    count = Block('count', f'{HERE}:Counter', WORLD, reads={'truth': now(TRUTH)},
                  writes={'a': A}, period=writer)
    ear = watcher('ear', {f'd{d}': Read(A, d) for d in delays}, period=reader)
    heard = toys.fly(*((ear, count) if ear_first else (count, ear))).heard['ear']
    assert list(heard) == list(range(0, 21, reader))
    for k, values in heard.items():
        expected = {f'd{d}': heard_at(k, d, writer) for d in delays}
        assert repr(values) == repr(expected), k


def test_the_table_by_hand_itself():
    assert [heard_at(k, 0, 2) for k in range(5)] == [0.0, 0.0, 2.0, 2.0, 4.0]
    assert repr([heard_at(k, 3, 5) for k in range(10)]) == repr(
        [np.nan]*3 + [0.0]*5 + [5.0]*2)


def test_two_blocks_of_several_rates_read_each_other():
    one = Block('one', f'{HERE}:Counter', WORLD, reads={'t': now(TRUTH), 'b': Read(B, 2)},
                writes={'a': A}, period=2)
    other = Block('other', f'{HERE}:Counter', WORLD, reads={'a': now(A)}, writes={'b': B},
                  period=5)
    with pytest.raises(ValueError, match='without delay'):      # one is slower than the world
        diagram(one, replace(other, period=1))
    ear = watcher('ear', {'a': last(A), 'b': last(B)})
    heard = toys.fly(one, other, ear).heard['ear']
    for k, values in heard.items():
        assert repr(values) == repr({'a': heard_at(k, 1, 2), 'b': heard_at(k, 1, 5)})


@pytest.mark.parametrize('dtype, unknown', [('f8', np.nan), ('i8', 0), ('u1', 0), ('?', False)])
def test_before_the_first_firing_a_signal_is_initial(dtype, unknown):
    plain = Part('value', (3,), dtype=dtype)
    assert repr(plain.filled((2,)).tolist()) == repr([[unknown]*3]*2)
    assert Part('value', dtype='i8', initial=7).filled((2,)).tolist() == [7, 7]
    signal = Signal('/s', (plain, Part('more', optional=True)))
    assert signal.initial((2,)).more is None


def test_control_is_handed_to_who_asks_for_it():
    class Listener:
        seen = []

        def step(self, k, truth, control):
            self.seen.append((k, control))
            return {}

    toys.Listener = Listener
    toys.fly(Block('listener', f'{HERE}:Listener', WATCH, reads={'truth': now(TRUTH)},
                   control=True, executable=''),
             schedule=[Change(3, mode='auto'), Change(5, abort=True)])
    assert [(c.mode, c.abort) for _, c in Listener.seen[:7]] == [
        ('', False)]*3 + [('auto', False)]*2 + [('auto', True)]*2


# -- chance -----------------------------------------------------------------------------------

def with_chance(name, draw):
    return watcher(name, {'truth': now(TRUTH)}, 'Chance', draws={'noise': draw})


def test_a_purpose_of_its_own_gives_a_stream_of_its_own():
    toys.fly(*(with_chance(name, Normals(f'toy/{name}/noise', 2)) for name in 'xy'), runs=(4, 7))
    x, y = toys.Chance.drawn['x'], toys.Chance.drawn['y']
    assert x.shape == y.shape == (2, 21, 2) and not np.isin(x, y).any()
    key = np.random.SeedSequence(entropy=0, spawn_key=(7, crc32(b'toy/x/noise')))
    assert_array_equal(x[1], np.random.Generator(np.random.PCG64(key)).standard_normal((21, 2)))
    assert_array_equal(x[1], Normals('toy/x/noise', 2).of_run(0, 7, 21))


def test_equal_draws_are_the_same_numbers():
    toys.fly(*(with_chance(name, Normals('measurement', 6)) for name in 'xy'),
             with_chance('z', StartNormals()))
    assert_array_equal(toys.Chance.drawn['x'], toys.Chance.drawn['y'])
    assert_array_equal(toys.Chance.drawn['x'][0], streams.measurement_normals(0, 0, 21))
    assert_array_equal(toys.Chance.drawn['z'], [streams.start_normals(0, 0)])


def test_conditions_with_equal_draws_share_them():
    one = toys.mission(with_chance('x', Normals('toy/x/noise', 2)))
    draws = in_process.draw(one, [0, 1])
    other = one.with_values('knob', gain=3.0)
    in_process.fly(other, [0, 1], draws=draws)
    assert toys.Chance.drawn['x'] is draws.of['x', 'noise']
    with pytest.raises(ValueError, match='draws are of other runs'):
        in_process.fly(toys.mission(with_chance('x', Normals('toy/x/other', 2))), [0, 1],
                       draws=draws)


@pytest.mark.parametrize('purpose', ['noise', 'x/noise', 'a/b/c/d', ''])
def test_a_purpose_without_a_home_is_refused(purpose):
    with pytest.raises(ValueError, match='purpose must be one of start, .*mission/block/purpose'):
        Normals(purpose, 1).of_run(0, 0, 1)


def test_a_purpose_that_would_share_a_numbered_stream_is_refused(monkeypatch):
    monkeypatch.setattr(streams, 'crc32', lambda text: 3)
    with pytest.raises(ValueError, match="^purpose 'a/b/c' has the stream of another: give it "
                                         'another name$'):
        Normals('a/b/c', 1).of_run(0, 0, 1)


def test_the_checksum_of_a_purpose_is_that_of_its_name():
    assert streams.number_of('toy/x/noise') == crc32(b'toy/x/noise')
    assert {streams.number_of(name) for name in streams.PURPOSES} == set(range(7))


# -- what a block returns -----------------------------------------------------------------------

VALUE = A(value=np.zeros(1))


@pytest.mark.parametrize('returned, said', [
    (None, 'block odd: step must return a value for each output by name, got NoneType'),
    (VALUE, 'block odd: step must return a value for each output by name, got A'),
    ({'b': VALUE}, "block odd returns 'b', which it does not write; it writes a"),
    ({'a': np.zeros(1)}, 'block odd writes /a: must be a value of /a, got ndarray'),
    ({'a': B.type(value=np.zeros(2))}, 'block odd writes /a: value must have shape (1,), got (2,)'),
    ({'a': A(value=np.zeros((1, 3)))}, 'block odd writes /a: value must have shape (1,), got '
                                       '(1, 3)'),
    ({'a': A(value=np.array(['x']))}, 'block odd writes /a: value must be float64, got <U1'),
    ({'a': A(value=np.zeros(1, dtype=complex))},
     'block odd writes /a: value must be float64, got complex128')])
def test_what_a_block_must_not_return_is_refused_in_one_line(returned, said):
    toys.Returns.what = returned
    with pytest.raises(ValueError) as refusal:
        toys.fly(Block('odd', f'{HERE}:Returns', WORLD, reads={'truth': now(TRUTH)},
                       writes={'a': A}))
    assert isinstance(refusal.value, DiagramError) and str(refusal.value) == said


def test_a_value_may_leave_out_batch_axes_that_are_equal_in_all_rows():
    toys.Returns.what = {'a': A(value=np.float64(5.0))}
    odd = Block('odd', f'{HERE}:Returns', WORLD, reads={'truth': now(TRUTH)}, writes={'a': A})
    batch = toys.fly(odd, runs=(0, 1, 2), record=['/a']).batch
    assert batch.history['/a'].value.shape == (21, 3) and (batch.history['/a'].value == 5.0).all()


@pytest.mark.parametrize('make, said', [
    ('toys:Missing', 'block odd: module toys has no Missing'),
    ('toys.Counter', "block odd: 'toys.Counter' must be of the form module:NAME"),
    ('toys:Chance', "block odd: toys:Chance needs 'noise', which neither the scenario nor the "
                    'mission has')])
def test_a_block_that_cannot_be_made_is_refused_in_one_line(make, said):
    with pytest.raises(ValueError) as refusal:
        toys.fly(Block('odd', make, WATCH, reads={'truth': now(TRUTH)}, executable=''))
    assert str(refusal.value) == said


class Deaf:
    """Takes nothing but the step."""

    def step(self, k):
        return {}


class Curious(Deaf):
    """Takes what its block does not read."""

    def step(self, k, truth, wind, rain=0):
        return {}


@pytest.mark.parametrize('kind, said', [
    (Deaf, 'block odd reads truth, which its step does not take'),
    (Curious, 'block odd: step takes wind, which the block does not read')])
def test_a_step_takes_what_its_block_reads(kind, said, monkeypatch):
    monkeypatch.setattr(toys, kind.__name__, kind, raising=False)
    with pytest.raises(DiagramError) as refusal:
        toys.fly(Block('odd', f'{HERE}:{kind.__name__}', WATCH, reads={'truth': now(TRUTH)},
                       executable=''))
    assert str(refusal.value) == said


# -- scenarios ----------------------------------------------------------------------------------

def test_a_mission_that_is_not_installed_is_refused_with_those_that_are():
    with pytest.raises(ScenarioError) as refusal:
        parse('/**: {ros__parameters: {mission: mars}}', 'far')
    there = ', '.join(missions.installed())
    assert str(refusal.value) == (f"scenario far: no mission 'mars' is installed; there are: "
                                  f'{there} (RVD_OVERLAY names further prefixes)')


def test_with_values_keeps_the_settings_that_it_does_not_change():
    one = toys.mission()
    other = one.with_values('knob', gain=3.0)
    assert (one.settings('knob').gain, other.settings('knob').gain) == (1.0, 3.0)
    assert other.settings('lever') is one.settings('lever')
    assert other.run is one.run and other.part('common') is one.part('common')
    third = one.with_values('/**', common__radius_m=4.0)
    assert third.part('common').radius_m == 4.0 and third.run is one.run
    assert third.settings('knob') is one.settings('knob')
    assert one.sections['/**'] == {'timeout_s': 10.0, 'mission': 'toy'}     # left alone


def test_changing_a_key_makes_no_other_settings_again():
    one = toys.mission()
    toys.MADE.clear()
    for gain in range(5):
        one.with_values('knob', gain=float(gain))
    assert toys.MADE == {'Knob': 5}
    one.with_values('/**', seed=7)
    assert toys.MADE == {'Knob': 5}
    one.with_values('/**', common__radius_m=1.0).renamed('other').check()
    assert toys.MADE == {'Knob': 5, 'Common': 1}


def test_parts_are_made_once_and_anew_for_a_changed_scenario():
    def both(knob_of, common):
        return (knob_of, common)

    toys.knob_of, toys.both = (lambda scenario: scenario.settings('knob')), both
    one = toys.mission(parts={'knob_of': f'{HERE}:knob_of', 'both': f'{HERE}:both'})
    assert one.part('both') is one.part('both')
    assert one.part('both') == (one.settings('knob'), one.part('common'))
    other = one.with_values('knob', gain=2.0)
    assert other.part('both')[0].gain == 2.0 and one.part('both')[0].gain == 1.0
    with pytest.raises(LookupError):
        one.part('neither')


def test_a_part_that_does_not_fit_is_refused_as_soon_as_the_scenario_is_read():
    def fits(common, run):
        if common.radius_m > run.timeout_s:
            raise BadInput(f'common.radius_m must be at most {run.timeout_s:g}')

    toys.fits = fits
    one = toys.mission(parts={'fits': f'{HERE}:fits'}, checked=('fits',))
    with pytest.raises(ScenarioError, match='^scenario toy: common.radius_m must be at most 10$'):
        one.with_values('/**', common__radius_m=11.0)


@pytest.mark.parametrize('section, values, said', [
    ('knob', {'gian': 1.0}, 'scenario toy: knob: unknown key gian; did you mean gain?'),
    ('knob', {'seed': 1}, 'scenario toy: knob: seed is shared by all nodes and stands under /** '
                          'only'),
    ('/**', {'gain': 1.0}, 'scenario toy: /**: unknown key gain'),
    ('knob', {'gain': -1.0}, 'scenario toy: knob: gain must be between 0 and 10, got -1.0'),
    ('/**', {'common__radius_m': 0.0}, 'scenario toy: common.radius_m must be positive, got 0.0'),
    ('/**', {'mission': 'lunar_approach'},
     'scenario toy: a scenario of mission toy cannot become one of lunar_approach')])
def test_a_change_that_cannot_be_is_refused_in_one_line(section, values, said):
    with pytest.raises(ScenarioError) as refusal:
        toys.mission().with_values(section, **values)
    assert str(refusal.value).startswith(said) and '\n' not in str(refusal.value)


class ByName:
    """Takes what its block reads by name only, as a graph hands it over."""

    seen: list = []

    def step(self, k, *, truth):
        self.seen.append((k, truth))
        return {}


def test_a_step_may_take_its_inputs_by_name_only(monkeypatch):
    monkeypatch.setattr(toys, 'ByName', ByName, raising=False)
    ByName.seen.clear()
    toys.fly(Block('odd', f'{HERE}:ByName', WATCH, reads={'truth': now(TRUTH)}, executable=''))
    assert [k for k, _ in ByName.seen] == list(range(len(ByName.seen))) and ByName.seen
    assert all(isinstance(truth, TRUTH.type) for _, truth in ByName.seen)
