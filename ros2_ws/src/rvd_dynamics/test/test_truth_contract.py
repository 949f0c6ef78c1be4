"""
What every truth model, sensor and shared function must keep, run over their tables.

One run and a row of a batch are the same bits, at any batch size and memory layout, and no
row sees its neighbours: without that the node graph and a campaign would part.
"""

from dataclasses import fields, is_dataclass

import numpy as np
from numpy.testing import assert_allclose
import pytest

from rvd_dynamics import frames
from rvd_dynamics.geometry import cone
from rvd_dynamics.motion import cw
from rvd_dynamics.motion.orbit import OrbitParams
from rvd_dynamics.world.plants.relative import TRUTH_MODELS
from rvd_dynamics.diagram.params import build, flatten
from rvd_dynamics.world.sensors import SENSORS
from rvd_dynamics.commands import levels
from rvd_dynamics.world.spacecraft import thrusters
from rvd_dynamics.world.settings import SensorParams

ORBIT, THRUST, CONE = OrbitParams(), levels.ThrustParams(), cone.Cone()
N, STEP_S = ORBIT.mean_motion, 0.5
ROWS = 1000
RNG = np.random.default_rng(11)

STATES = RNG.normal(size=(ROWS, 6)) * [10.0, 0.5, 0.5, 0.3, 0.02, 0.02] - [20, 0, 0, 0, 0, 0]
ACCELS = RNG.normal(size=(ROWS, 3)) * 0.01
POSITIONS = STATES[:, :3].copy()
POSITIONS[:5, 1:] = 0.0                                 # on the axis too
STATIONS = np.linspace(-35.0, 1.0, ROWS)[:, np.newaxis]
DEFLECTIONS = RNG.uniform(-1.0, 1.0, size=(ROWS, 3))
LEVELS = RNG.integers(-3, 4, size=(ROWS, 3)).astype(np.int8)
NORMALS = RNG.normal(size=(ROWS, 6))

# name: (function of arguments with components on the last axis, those arguments)
FUNCTIONS = {
    'cw.propagate': (lambda s: cw.propagate(s, N, 5.0), [STATES]),
    'cw.propagate by times': (lambda s, t: cw.propagate(s, N, t[..., 0]), [STATES, STATIONS]),
    'cw.transition': (lambda t: cw.transition(N, t[..., 0]), [40*STATIONS]),
    'cw.input_matrix': (lambda t: cw.input_matrix(N, t[..., 0]), [40*STATIONS]),
    'cw.step': (lambda s, u: cw.step(s, u, cw.transition(N, 0.5), cw.input_matrix(N, 0.5)),
                [STATES, ACCELS]),
    'corridor.radius': (lambda x: cone.radius(x, CONE), [STATIONS]),
    'corridor.signed_distance': (lambda p: cone.signed_distance(p, CONE), [POSITIONS]),
    'corridor.unsigned_distance': (lambda p: cone.unsigned_distance(p, CONE), [POSITIONS]),
    'corridor.outward_normal': (lambda p: cone.outward_normal(p, CONE), [POSITIONS]),
    'corridor.nearest_point': (lambda p: cone.nearest_point(p, CONE), [POSITIONS]),
    'corridor.ray_nearest_point': (lambda p: cone.ray_nearest_point(p, CONE), [POSITIONS]),
    'corridor.ray_nearest_point printed': (
        lambda p: cone.ray_nearest_point(p, CONE, printed=True), [POSITIONS]),
    'corridor.control_boundary': (lambda x: cone.control_boundary(x, CONE, N), [STATIONS]),
    'corridor.drift_rate': (lambda y: cone.drift_rate(y, N), [abs(STATIONS)]),
    'levels.acceleration': (lambda v: levels.acceleration(v, THRUST), [LEVELS]),
    'levels.nearest_level': (lambda a: levels.nearest_level(a, THRUST), [ACCELS]),
    'levels.level_of_deflection': (levels.level_of_deflection, [DEFLECTIONS]),
    'thrusters.execute': (lambda a, e: thrusters.execute(a, e, 0.01), [ACCELS, NORMALS[:, :3]]),
    'frames.rotation': (lambda t: frames.rotation(t[..., 0], ORBIT), [STATIONS]),
    'frames.to_inertial': (lambda s, t: frames.to_inertial(s, t[..., 0], ORBIT),
                           [STATES, STATIONS]),
    'frames.to_target': (lambda s, t: frames.to_target(s, t[..., 0], ORBIT),
                         [STATES, STATIONS]),
}
for name, model in TRUTH_MODELS.items():
    FUNCTIONS[f'truth {name}'] = (model(ORBIT, STEP_S).advance, [STATES, ACCELS])
for name, sensor in SENSORS.items():
    FUNCTIONS[f'sensor {name}'] = (sensor().measure, [STATES, NORMALS])


@pytest.fixture(params=FUNCTIONS.values(), ids=FUNCTIONS.keys())
def function(request):
    return request.param


def same_bits(one, other):
    one, other = np.asarray(one), np.asarray(other)
    return (one.shape == other.shape and one.dtype == other.dtype
            and one.tobytes() == other.tobytes())


@pytest.mark.parametrize('size', [1, 7, ROWS])
def test_a_row_of_a_batch_is_the_single_run_to_the_bit(function, size):
    call, arguments = function
    batch = call(*(a[:size] for a in arguments))
    for i in range(size):
        single = call(*(a[i] for a in arguments))
        assert same_bits(batch[i].reshape(np.shape(single)), single), i


def test_memory_layout_and_leading_axes_do_not_matter(function):
    call, arguments = function
    batch = call(*arguments)
    columns = call(*(np.asfortranarray(a) for a in arguments))
    every_second = call(*(np.repeat(a, 2, axis=0)[::2] for a in arguments))
    folded = call(*(a.reshape(10, 100, -1) for a in arguments))
    assert same_bits(columns, batch)
    assert same_bits(every_second, batch)
    assert same_bits(folded.reshape(batch.shape), batch)


def test_arguments_are_left_alone(function):
    call, arguments = function
    before = [a.copy() for a in arguments]
    call(*arguments)
    assert all(same_bits(a, b) for a, b in zip(arguments, before))


def test_an_unknown_row_stays_its_own(function):
    call, arguments = function
    if arguments[0].dtype.kind != 'f' or call is levels.level_of_deflection:
        pytest.skip('refuses what is unknown')
    spoiled = [a.copy() for a in arguments]
    spoiled[0][3] = np.nan
    good, bad = call(*arguments), call(*spoiled)
    keep = np.arange(ROWS) != 3
    assert same_bits(bad[keep], good[keep])
    if bad.dtype.kind == 'f':
        unknown = np.isnan(bad[3])
        assert unknown.any() if bad.ndim > 2 else unknown.all()     # a matrix has constants


@pytest.fixture(params=TRUTH_MODELS.values(), ids=TRUTH_MODELS.keys())
def truth(request):
    return request.param


def test_truth_is_settled_by_orbit_and_step_alone(truth):
    assert is_dataclass(truth) and truth.__dataclass_params__.frozen
    assert [f.name for f in fields(truth)] == ['orbit', 'step_s']
    assert truth(ORBIT, STEP_S) == truth(OrbitParams(), STEP_S)


def test_truth_obeys_the_linear_motion_nearby(truth):
    # two steps of 0.5 s from the end of the approach, under thrust: CW to 1e-9 m
    state, accel = np.array([-1.0, 0.1, 0.1, 0.25, 0.01, 0.0]), np.array([0.01, -0.02, 0.005])
    model = truth(ORBIT, STEP_S)
    end = model.advance(model.advance(state, accel), accel)
    expected = cw.step(state, accel, cw.transition(N, 1.0), cw.input_matrix(N, 1.0))
    assert_allclose(end, expected, rtol=0.0, atol=1e-9)


def test_truth_steps_join_whatever_their_length(truth):
    state, accel = STATES[0], ACCELS[0]
    ends = []
    for step_s in (0.05, 0.1, 0.5, 1.0):
        model, end = truth(ORBIT, step_s), state
        for _ in range(round(10.0/step_s)):
            end = model.advance(end, accel)
        ends.append(end)
    assert_allclose(ends, np.broadcast_to(ends[0], (4, 6)), rtol=0.0, atol=1e-11)


@pytest.mark.parametrize('name', SENSORS)
def test_every_sensor_can_be_chosen_and_set_by_its_name(name):
    assert SensorParams(sensor=name).selected == SENSORS[name]()
    keys = [key for key in flatten(SensorParams()) if key.startswith(f'{name}.')]
    assert len(keys) == len(fields(SENSORS[name]))
    changed = build(SensorParams, {'sensor': name, 'multiplicative.noise_fraction': 0.5})
    assert flatten(changed)['multiplicative.noise_fraction'] == 0.5


def test_an_unknown_sensor_is_refused_with_the_ones_there_are():
    with pytest.raises(ValueError, match='sensor must be one of multiplicative.*, got lidar'):
        SensorParams(sensor='lidar')
