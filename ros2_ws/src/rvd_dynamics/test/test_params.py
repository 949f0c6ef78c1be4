"""Parameters: what is out of bounds cannot be made, in Python, from a file or on a ROS node."""

from dataclasses import dataclass, field, replace
from math import inf, nan
import pickle

import pytest
import rclpy
from rclpy.parameter import Parameter

from rvd_dynamics.diagram.params import (
    build, choice, flatten, Impossible, leaves, param, require, settings)
from rvd_dynamics.diagram.ros.params import declare


@settings
class Pump:
    """One parameter of each kind."""

    flow_m_s: float = param(1.0, 'Flow [m/s].', low=0.0, high=2.0)
    drag_fraction: float = param(0.5, 'Drag.', low=0.0, below=1.0)
    gain: float = param(1.0, 'Gain.', above=0.0)
    offset: float = param(0.0, 'Offset.')
    limit: float = param(inf, 'Limit.', low=1.0, high=inf)
    stages: int = param(2, 'Stages.', low=1, high=4)
    index: int = param(0, 'Index.', low=0)
    fluid: str = param('water', 'Fluid.', choices=('water', 'oil'))
    sense: int = param(1, 'Sense.', choices=(-1, 1))
    name: str = param('', 'Name.')
    primed: bool = param(True, 'Primed.')
    weights: tuple = param((1.0, 2.0), 'Weights.', low=0.0)
    points: tuple = param((1.0, 2.0, 3.0), 'Points.', above=0.0, length=3, rising=True)


@settings
class Plant:
    """A part that is settings itself, wiring, and two parameters that must fit each other."""

    name: str = field(default='none')
    pump: Pump = param(Pump, 'Pump.')
    low_m: float = param(0.0, 'Low [m].', low=0.0)
    high_m: float = param(1.0, 'High [m].', low=0.0)

    def __post_init__(self) -> None:
        require(self.low_m <= self.high_m, 'high_m', 'not be below low_m', self.high_m)


@settings
class Small(Plant):
    """A plant with a bound of its own."""

    high_m: float = param(0.5, 'High [m].', low=0.0, high=0.5)


Choice = choice('Choice', 'part', {'pump': Pump, 'plant': Plant}, 'pump', 'Part of the choice.')

REFUSED = [
    ('flow_m_s', -0.1, 'flow_m_s must be between 0 and 2, got -0.1'),
    ('flow_m_s', 2.1, 'flow_m_s must be between 0 and 2, got 2.1'),
    ('flow_m_s', nan, 'flow_m_s must be between 0 and 2, got nan'),
    ('drag_fraction', 1.0, 'drag_fraction must be at least 0 and below 1, got 1.0'),
    ('gain', 0.0, 'gain must be positive, got 0.0'),
    ('gain', inf, 'gain must be finite, got inf'),
    ('gain', nan, 'gain must be finite, got nan'),
    ('offset', -inf, 'offset must be finite, got -inf'),
    ('limit', nan, 'limit must be at least 1, got nan'),
    ('stages', 5, 'stages must be between 1 and 4, got 5'),
    ('index', -1, 'index must not be negative, got -1'),
    ('fluid', 'wine', 'fluid must be one of water, oil, got wine'),
    ('sense', 0, 'sense must be one of -1, 1, got 0'),
    ('weights', (1.0, -1.0), 'weights[1] must not be negative, got -1.0'),
    ('weights', (nan,), 'weights[0] must be finite, got nan'),
    ('points', (1.0, 2.0), 'points must be 3 numbers, got [1.0, 2.0]'),
    ('points', (1.0, 2.0, 2.0), 'points must be rising numbers, got [1.0, 2.0, 2.0]'),
    ('points', (0.0, 2.0, 3.0), 'points[0] must be positive, got 0.0'),
]


def refusal(make, *args, **values) -> str:
    with pytest.raises(ValueError) as refused:
        make(*args, **values)
    return str(refused.value)


@pytest.mark.parametrize('key, bad, said', REFUSED)
def test_what_is_out_of_bounds_cannot_be_made_in_any_way(key, bad, said):
    assert refusal(Pump, **{key: bad}) == said
    assert refusal(replace, Pump(), **{key: bad}) == said
    assert refusal(build, Pump, {key: bad}) == said
    assert refusal(build, Plant, {f'pump.{key}': bad}) == f'pump.{said}'
    assert refusal(build, Choice, {f'plant.pump.{key}': bad}) == f'plant.pump.{said}'


@pytest.mark.parametrize('key, bad', [('flow_m_s', 'fast'), ('gain', None), ('stages', '2')])
def test_what_is_no_number_is_refused_as_that(key, bad):
    assert refusal(Pump, **{key: bad}) == f'{key} must be a number, got {bad!r}'
    assert refusal(Pump, weights=3.0) == 'weights must be a list, got 3.0'


@pytest.mark.parametrize('values', [
    {'flow_m_s': 0.0}, {'flow_m_s': 2.0}, {'flow_m_s': 1}, {'drag_fraction': 0.0},
    {'drag_fraction': 1.0 - 2**-53}, {'gain': 5e-324}, {'gain': 1.7976931348623157e308},
    {'offset': -1e308}, {'limit': inf}, {'stages': 1}, {'stages': 4}, {'index': 10**400},
    {'fluid': 'oil'}, {'sense': -1}, {'weights': ()}, {'weights': (0.0,)}])
def test_the_edges_are_allowed(values):
    assert build(Pump, values) == Pump(**values)


def test_own_checks_come_after_the_bounds_and_are_inherited():
    assert refusal(Plant, low_m=2.0) == 'high_m must not be below low_m, got 1.0'
    assert refusal(Plant, low_m=2.0, high_m=-1.0) == 'high_m must not be negative, got -1.0'
    assert refusal(Small, low_m=0.6) == 'high_m must not be below low_m, got 0.5'
    assert refusal(Small, high_m=0.6) == 'high_m must be between 0 and 0.5, got 0.6'
    assert refusal(Small, low_m=-1.0) == 'low_m must not be negative, got -1.0'
    assert refusal(build, Choice, {'plant.low_m': 2.0}).startswith('plant.high_m must not be below')


def test_a_choice_is_one_of_its_table():
    assert refusal(Choice, part='pipe') == 'part must be one of pump, plant, got pipe'
    assert Choice(part='plant').selected == Plant()


def test_wiring_is_not_a_parameter():
    assert 'name' not in dict(leaves(Plant))
    assert build(Plant, {'low_m': 0.5}).name == Plant().name


def test_settings_survive_the_way_through_a_file():
    assert build(Choice, flatten(Choice())) == Choice()


def test_bounds_that_nothing_would_check_are_a_mistake_found_at_once():
    @dataclass(frozen=True)
    class Loose:
        gain: float = param(1.0, 'Gain.', above=0.0)

    @dataclass(frozen=True)
    class Looser(Plant):
        def __post_init__(self) -> None:
            pass

    for cls in (Loose, Looser):
        with pytest.raises(TypeError, match=f'{cls.__name__} declares bounds .* with @settings'):
            list(leaves(cls))


def test_a_default_out_of_its_own_bounds_is_a_mistake_found_at_once():
    with pytest.raises(ValueError, match='default must be between 0 and 1, got 2.0'):
        param(2.0, 'Share.', low=0.0, high=1.0)


def test_a_refusal_survives_the_way_between_processes():
    with pytest.raises(Impossible) as refused:
        Pump(gain=-1.0)
    again = pickle.loads(pickle.dumps(refused.value))
    assert (str(again), again.key) == ('gain must be positive, got -1.0', 'gain')


# -- on a node ----------------------------------------------------------------------------------

@pytest.fixture(scope='module')
def context():
    context = rclpy.Context()
    rclpy.init(context=context)
    yield context
    rclpy.try_shutdown(context=context)


@pytest.fixture
def node_with(context):
    nodes = []

    def make(**values):
        nodes.append(rclpy.create_node(
            'pump', context=context, start_parameter_services=False, enable_rosout=False,
            parameter_overrides=[Parameter(key, value=value) for key, value in values.items()]))
        return nodes[-1]
    yield make
    for node in nodes:
        node.destroy_node()


def test_a_node_describes_ranges_and_says_the_other_bounds_in_words(node_with):
    node = node_with()
    assert declare(node, Pump) == Pump()
    told = {key: node.describe_parameter(key) for key, _ in leaves(Pump)}
    flow, = told['flow_m_s'].floating_point_range
    assert (flow.from_value, flow.to_value, flow.step) == (0.0, 2.0, 0.0)
    stages, = told['stages'].integer_range
    assert (stages.from_value, stages.to_value, stages.step) == (1, 4, 0)
    assert {key: d.additional_constraints for key, d in told.items()} == {
        'flow_m_s': '', 'drag_fraction': 'at least 0 and below 1', 'gain': 'positive',
        'offset': 'finite', 'limit': 'at least 1', 'stages': '',
        'index': 'not negative', 'fluid': 'one of water, oil', 'sense': 'one of -1, 1',
        'name': '', 'primed': '', 'weights': 'numbers, each not negative',
        'points': '3 rising numbers, each positive'}
    for key, parameter in leaves(Pump):
        assert told[key].description == parameter.metadata['doc'] and told[key].read_only


@pytest.mark.parametrize('values', [
    {'flow_m_s': 0.0}, {'flow_m_s': 2.0}, {'flow_m_s': 1}, {'flow_m_s': 0.1 + 0.2},
    {'stages': 1}, {'stages': 3}, {'stages': 4}, {'gain': 3}, {'weights': [1, 2]},
    {'weights': [0.5]}, {'points': [1, 2, 3]}])
def test_a_node_takes_every_value_in_range_and_whole_numbers_for_floats(node_with, values):
    made = declare(node_with(**values), Pump)
    assert made == build(Pump, values)


@pytest.mark.parametrize('key, bad, said', [
    *REFUSED, ('flow_m_s', 3, 'flow_m_s must be between 0 and 2, got 3.0'),
    # rclpy itself lets pass what is within 1e-6 of a bound
    ('flow_m_s', 2.0000000001, 'flow_m_s must be between 0 and 2, got 2.0000000001'),
    ('stages', 2.5, 'stages must be a whole number, got 2.5'),
    ('flow_m_s', True, 'flow_m_s must be a number, got True')])
def test_a_node_refuses_in_the_same_words(node_with, key, bad, said):
    bad = list(bad) if isinstance(bad, tuple) else bad
    assert refusal(declare, node_with(**{key: bad}), Pump) == said
