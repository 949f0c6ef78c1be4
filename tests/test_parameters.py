"""
Every parameter of the project: its sentence, its unit, its bounds in all the ways to a setting.
"""

from dataclasses import replace
from math import inf, isfinite, nan, nextafter
import re
import runpy

from hypothesis import assume, given, HealthCheck, settings
from hypothesis import strategies as st
import pytest
import rclpy
from rclpy.parameter import Parameter
from runs import ROOT

from rvd_dynamics.diagram.params import build, default_of, leaves
from rvd_dynamics.diagram.ros.params import declare
from rvd_dynamics.frames import PlaneParams
from rvd_groundstation.console.params import ConsoleParams

SCRIPT = runpy.run_path(str(ROOT / 'scripts' / 'make_parameters.py'))
SECTIONS = SCRIPT['sections']()
CLASSES = dict.fromkeys([*(cls for found in SECTIONS.values() for _, cls in found),
                         ConsoleParams, PlaneParams])
PARAMETERS = {f'{cls.__name__}.{key}': (cls, key, field)
              for cls in CLASSES for key, field in leaves(cls)}

UNITS = {           # ending of the key: unit in the sentence; the first that fits counts
    '_m3_s2': 'm^3/s^2', '_m2_s': 'm^2/s', '_m_s2': 'm/s^2', '_m_s': 'm/s',
    '_per_s2': '1/s^2', '_per_s': '1/s',
    'slowing_per_m': '1/m', 'target_rate_per_m': '1/m', '_per_m': 'm/m',
    '_rad_s': 'rad/s', '_deg': 'deg', '_hz': 'Hz', '_m': 'm', '_s': 's', '_ms': 'ms',
    'autorepeat_rate': 'Hz'}
TWO_UNITS = {'process_variance_floor'}      # of positions and velocities, which no ending says

# Parameters that must fit another one: given the value under test together with it.
FITTING = {
    'low_fraction': ['high_fraction'], 'high_fraction': ['low_fraction'],
    'lead_min_s': ['lead_max_s'], 'lead_max_s': ['lead_min_s'],
    'level_2_m_s': ['level_3_m_s'], 'level_3_m_s': ['level_2_m_s'],
    'pulse_min_s': ['pulse_max_s'], 'pulse_max_s': ['pulse_min_s'], 'step_s': ['timeout_s']}
# What a value within its bounds must be besides, and has a test of its own elsewhere.
BESIDES = {
    'step_s': lambda v: abs(v*1e9 - round(v*1e9)) < 1e-3, 'timeout_s': lambda v: v >= 0.5,
    'seed': lambda v: v < 2**64, 'position_m': lambda v: v[0] < 0.0,
    'axis_x': lambda v: v not in (0, 4), 'axis_y': lambda v: v not in (1, 4),
    'axis_z': lambda v: v not in (0, 1), 'boundary_rate_m_s': lambda v: not 0.0 < v < 0.01,
    # odrrca: k < 0 and k1 > -k - q1/2, which test_odrrca.py shows
    'k': lambda v: -1010.0 < v < 0.0, 'k1': lambda v: v > 0.923 - 1010.0, 'q1': lambda v: v > 1.846}


def test_the_table_is_found():
    assert len(SECTIONS) > 8 and len(PARAMETERS) > 90


# -- what a parameter says of itself ------------------------------------------------------------

@pytest.mark.parametrize('name', PARAMETERS)
def test_the_doc_is_one_sentence(name):
    doc = PARAMETERS[name][2].metadata['doc']
    assert re.fullmatch(r'[A-Z][^\n]+[^\s.]\.', doc), doc
    assert not re.search(r'[.!?] +[A-Z]', doc), doc
    assert len(doc.split()) > 2, doc


@pytest.mark.parametrize('name', PARAMETERS)
def test_the_unit_in_the_key_is_the_unit_in_the_doc(name):
    _, key, field = PARAMETERS[name]
    said = re.findall(r'\[([^]]*)\]', field.metadata['doc'])
    unit = next((unit for ending, unit in UNITS.items() if key.endswith(ending)), None)
    if field.name not in TWO_UNITS:
        assert said == ([] if unit is None else [unit])


def test_the_page_is_the_one_that_the_generator_makes():
    assert SCRIPT['PAGE'].read_text(encoding='utf-8') == SCRIPT['page'](), (
        './rvd shell python scripts/make_parameters.py')


@pytest.mark.parametrize('path', sorted(SCRIPT['MISSIONS'].glob('*.md')),
                         ids=lambda path: path.stem)
def test_the_page_of_a_mission_has_the_parameters_that_it_alone_has(path):
    text = path.read_text(encoding='utf-8')
    assert path.stem == 'lunar_approach' or SCRIPT['PARAMETERS'].search(text)
    assert text == SCRIPT['filled'](path), './rvd shell python scripts/make_parameters.py'


# -- bounds -------------------------------------------------------------------------------------

BOUNDED = {name: found for name, found in PARAMETERS.items()
           if found[2].metadata['bounds'].meaning}


def allows(bounds, value) -> bool:
    """Tell whether a value is within bounds, by the words of their declaration."""
    if bounds.is_list:
        return (all(allows_one(bounds, v) for v in value)
                and bounds.length in (None, len(value))
                and not (bounds.rising and any(a >= b for a, b in zip(value, value[1:]))))
    return allows_one(bounds, value)


def allows_one(bounds, value) -> bool:
    if bounds.choices:
        return value in bounds.choices
    return (isfinite(value)
            and not (bounds.low is not None and value < bounds.low)
            and not (bounds.high is not None and value > bounds.high)
            and not (bounds.above is not None and value <= bounds.above)
            and not (bounds.below is not None and value >= bounds.below))


def one_value(bounds):
    """Return a strategy of values in, at the edge of and out of bounds."""
    if bounds.choices:
        others = st.text() if bounds.kind is str else st.integers(-5, 5)
        return st.sampled_from(bounds.choices) | others
    edges = [end for end in (bounds.low, bounds.high, bounds.above, bounds.below)
             if end is not None]
    if bounds.kind is int:
        return st.integers() | st.sampled_from([int(e) + d for e in edges for d in (-1, 0, 1)])
    near = [e for end in edges for e in (nextafter(end, -inf), float(end), nextafter(end, inf))]
    return st.sampled_from([*near, nan, inf, -inf]) | st.floats()


def values_of(field):
    """Return a strategy of values of a parameter: of a list, with any one element changed."""
    bounds, default = field.metadata['bounds'], default_of(field)
    if not bounds.is_list:
        return one_value(bounds)
    changed = st.tuples(st.integers(0, len(default) - 1), one_value(bounds)).map(
        lambda c: (*default[:c[0]], c[1], *default[c[0] + 1:]))
    return changed | st.lists(one_value(bounds), min_size=1, max_size=4).map(tuple)


def attempt(make, *args, **values):
    """Return what is made and None, or None and the refusal."""
    try:
        return make(*args, **values), None
    except ValueError as error:
        return None, str(error)


@pytest.mark.parametrize('name', BOUNDED)
@given(data=st.data())
@settings(max_examples=40, suppress_health_check=[         # half of all numbers is no `k`
    HealthCheck.too_slow, HealthCheck.filter_too_much])
def test_file_and_python_agree_on_every_bound(name, data):
    cls, key, field = BOUNDED[name]
    prefix = key[:-len(field.name)]
    bounds, value = field.metadata['bounds'], data.draw(values_of(field))
    if field.name == 'outage_windows_s':            # whole windows, which do not end early
        value = tuple(v for v in value for _ in range(2))
    given_together = {other: value for other in [field.name, *FITTING.get(field.name, [])]}
    made, refused = attempt(build, cls, {prefix + k: v for k, v in given_together.items()})
    default = attribute(build(cls, {}), prefix.rstrip('.'))
    direct, refused_directly = attempt(replace, default, **given_together)
    if (field.name, value) == ('model', 'empirical'):   # asks for a file, too
        assert refused == refused_directly and 'file' in refused
    elif allows(bounds, value):
        assume(BESIDES.get(field.name, lambda v: True)(value))
        assert refused is None and refused_directly is None
        assert getattr(direct, field.name) == value
        if not hasattr(cls, 'preset'):          # in a file, keys left out follow the layout
            assert attribute(made, prefix.rstrip('.')) == direct
    else:
        assert refused == prefix + refused_directly
        assert '\n' not in refused or '\n' in str(value)
        named = [k for k in given_together if refused.startswith(prefix + k)]
        bad = (next((v for v in value if not allows_one(bounds, v)), list(value))
               if bounds.is_list else value)
        assert named and refused.endswith(f', got {bad}')


def attribute(made, dotted):
    """Return the part of a settings object that a dotted key names; of no key, the whole."""
    for part in filter(None, dotted.split('.')):
        made = getattr(made, part)
    return made


# -- on nodes -----------------------------------------------------------------------------------

@pytest.fixture(scope='module')
def context():
    context = rclpy.Context()
    rclpy.init(context=context)
    yield context
    rclpy.try_shutdown(context=context)


def declared(context, cls, values):
    """Return a node with the parameters of a settings class, and the settings that it got."""
    node = rclpy.create_node(
        'trial', context=context, start_parameter_services=False, enable_rosout=False,
        parameter_overrides=[Parameter(key, value=value) for key, value in values.items()])
    try:
        made = declare(node, cls)
        return made, {key: node.describe_parameter(key) for key, _ in leaves(cls)}
    finally:
        node.destroy_node()


@pytest.mark.parametrize('cls', CLASSES)
def test_a_node_takes_defaults_and_describes_every_parameter(context, cls):
    made, described = declared(context, cls, {})
    assert made == build(cls, {})
    for key, field in leaves(cls):
        bounds, told = field.metadata['bounds'], described[key]
        assert told.description == field.metadata['doc']
        ranges = [*told.integer_range, *told.floating_point_range]
        if bounds.low is not None and bounds.high is not None and not bounds.is_list:
            assert [(r.from_value, r.to_value, r.step) for r in ranges] == [
                (bounds.low, bounds.high, 0)]
            assert told.additional_constraints == ''
        else:
            assert not ranges and told.additional_constraints == bounds.meaning


@pytest.mark.parametrize('end', ['low', 'high'])
@pytest.mark.parametrize('cls', CLASSES)
def test_a_node_takes_both_ends_of_every_range_and_whole_numbers_for_floats(context, cls, end):
    values = {key: getattr(field.metadata['bounds'], end) for key, field in leaves(cls)
              if field.metadata['bounds'].closed and key not in BESIDES}
    whole = {key: int(value) if value == int(value) else value for key, value in values.items()}
    for given_values in (values, whole):
        made, _ = declared(context, cls, given_values)
        assert made == build(cls, values)
