"""What the console is told of the mission docking, without a graph and without a browser."""

import json

import numpy as np
from numpy.testing import assert_allclose
import pytest
from scipy.spatial.transform import Rotation

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.codes import BY_NOBODY, BY_PILOT
from rvd_dynamics.diagram.display import as_data, DERIVED, TRUTH
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse
from rvd_groundstation.console.decode import Sample
from rvd_groundstation.console.feed import Feed
from rvd_groundstation.console.forms import with_wishes
from rvd_groundstation.console.protocol import Stick
from rvd_groundstation.console.provider import display_of, facts_of, on_ground
from rvd_missions.docking.display import BEND, DockingDisplay, SLOSH
from rvd_missions.docking.display_parts import seen, seen_turn
from rvd_missions.docking.display_remote import PREDICTION, RemoteDisplay, TELEMETRY
from rvd_missions.docking.signals import ESTIMATE, FEATURES, GUIDANCE, POSE, THRUST, TRUTH as TRUE

TEXT = ('/**: {ros__parameters: {mission: docking, timeout_s: %g, limits: {from_s: 0.5}%s}}\n'
        'onboard_guard: {ros__parameters: {abort_burn_s: 2.0}}\n')
SIGNALS = (ESTIMATE, FEATURES, GUIDANCE, POSE, THRUST)


def sample(history, signal, k: int, step_s: float = 0.01) -> Sample:
    """Return step k of a recorded signal as the console's node hands it in."""
    parts = {}
    for part in (part for part in signal.parts if not part.optional):
        value = np.asarray(getattr(history[signal.name], part.name))
        value = value[k, 0] if value.ndim > 1 else value[k]
        parts[part.name] = value.ravel().tolist() if part.shape else float(value)
    ok = any(map(np.isfinite, np.concatenate([np.ravel(v) for v in parts.values()])))
    return Sample(k, k*step_s, bool(ok), parts)


@pytest.fixture(scope='module')
def flown():
    """Six seconds, as a feed has them step by step, and the truth at the end."""
    scenario = parse(TEXT % (6.0, ''), 'test')
    history = fly(scenario, [1], record=True).history
    feed = Feed(display_of(scenario))
    for k in range(601):
        for signal in SIGNALS[:-1]:
            feed.signal(signal.name, sample(history, signal, k))
        thrust = sample(history, THRUST, k)
        thrust.parts = {'value': [int(v) for v in thrust.parts['command']], 'kind': 0, 'by': 0,
                        'weight': np.nan, 'reason': 0, 'sequence': k + 1}
        feed.command(thrust)
    return scenario, history, feed


def test_the_scene_is_the_orbital_frame_turned_so_that_up_is_away_from_the_moon():
    assert_allclose(seen([[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]]), np.eye(3))
    q = Rotation.random(5, random_state=3)
    v = np.random.default_rng(4).normal(size=(5, 3))
    assert_allclose(Rotation.from_quat(seen_turn(q.as_quat())).apply(seen(v)), seen(q.apply(v)),
                    atol=1e-12)


def test_a_frame_shows_what_the_craft_knows_and_no_truth(flown):
    _, history, feed = flown
    frame = feed.frame()
    assert TRUTH not in frame['signals'] and frame['ladder'] == []
    made = frame['signals'][DERIVED]['parts']
    r = history[ESTIMATE.name].position[600, 0]
    assert_allclose(made['chaser'], [r[0], -r[2], r[1]])
    assert made['distance'] == pytest.approx(
        -(r + Rotation.from_quat(history[ESTIMATE.name].attitude[600, 0]).apply(
            [1.5, 0.0, 0.0]))[0] - 1.5, abs=1e-12)
    assert made['planned'] == pytest.approx(made['distance'], abs=0.03)
    assert made['safety'] == ['NOMINAL', False]
    assert all(0.05 < sigma < 5.0 for sigma in made['sigma_mm'])
    json.dumps(as_data(feed.display))


def test_the_markers_are_those_of_the_image_and_the_big_ones_count_far_away(flown):
    _, history, feed = flown
    made = feed.derived()
    pixels = np.reshape(made['pixels'], (12, 2))
    assert_allclose(pixels, history[FEATURES.name].pixels[600, 0])
    assert np.isfinite(pixels).all() and made['usable'] == 6.0
    assert made['used'] == [1]*6 + [0]*6


def test_books_of_the_valves_are_pulses_and_propellant_of_the_run(flown):
    _, history, feed = flown
    made = feed.derived()
    valves = history[THRUST.name].command[:, 0].astype(int)
    rises = (np.diff(valves, axis=0, prepend=0) > 0).sum(axis=0)
    groups = [slice(0, 1), slice(1, 13), slice(13, 25), slice(25, 37)]
    assert made['pulses'] == [int(rises[g].sum()) for g in groups] and sum(made['pulses']) > 10
    true = float(history[TRUE.name].propellant[600, 0])
    assert made['spent'] == pytest.approx(true, rel=0.06)       # amplitude and delay are not known
    glow, last = np.array(made['glow']), 600 - np.argmax(valves[::-1] > 0, axis=0)
    ever = valves.any(axis=0)
    assert_allclose(glow[ever], np.maximum(1.0 - (600 - last[ever])*0.01/0.7, 0.0), atol=0.006)
    assert (glow[~ever] == 0.0).all()


def test_beside_it_a_review_shows_the_truth_with_bending_and_slosh_enlarged(flown):
    _, history, feed = flown
    truth = sample(history, TRUE, 600).parts
    shown = {DERIVED: feed.derived()}
    made = feed.provider.beside(shown, truth)
    r, q = history[TRUE.name].position[600, 0], history[TRUE.name].attitude[600, 0]
    error = history[ESTIMATE.name].position[600, 0] - r
    assert_allclose(made['error_mm'], 1000.0*error, atol=1e-2)  # the target is at rest to that
    assert np.abs(made['error_mm']).max() < 5.0 and np.abs(made['error_deg']).max() < 0.3
    bending = history[TRUE.name].bending[600, 0]
    assert np.abs(bending).max() > 1e-4
    back = Rotation.from_quat(made['turn']).inv()
    rows = back.apply(np.array(made['panel_0']) - made['seen'])
    assert_allclose(rows[4, 1], -BEND*bending[0, 3], atol=1e-9)         # normal z is down
    liquid = back.apply(np.array(made['liquid_1']) - made['seen'])
    assert_allclose(liquid, seen([0.3, 0.0, 0.0] + SLOSH*history[TRUE.name].sloshing[600, 0, 1]),
                    atol=1e-9)
    assert q.shape == (4,)


def test_a_stiff_craft_neither_bends_nor_sloshes():
    scenario = parse(TEXT % (1.0, ', panels: {flexible: false}, tanks: {sloshing: false}'), 'test')
    truth = fly(scenario, [1], record=[TRUE.name]).history[TRUE.name]
    assert not truth.bending.any() and not truth.sloshing.any()
    names = {line.name for line in display_of(scenario).display.lines}
    assert names == {'flown', 'true_path'}


def test_a_mission_without_ground_shows_what_is_on_board_and_never_the_truth():
    diagram = parse(TEXT % (6.0, ''), 'test').diagram
    assert TRUE.name not in on_ground(diagram) and ESTIMATE.name in on_ground(diagram)


def test_the_simple_camera_has_no_image():
    display = display_of(parse(TEXT % (6.0, ', seeing: {camera: simple}'), 'test')).display
    assert display.camera.pixels is None


# -- forms ------------------------------------------------------------------------------------

@pytest.fixture(scope='module')
def plain():
    return parse(TEXT % (6.0, ''), 'test')


def test_what_is_written_into_the_forms_is_flown(plain):
    made = with_wishes(plain, display_of(plain).display.forms, {
        '/** start.position_m': '-5, 0.1, 0', '/** seeing.camera': 'simple',
        'docking_controller profile.fast_m_s': '0.06', 'docking_controller safety.active': 'false'})
    assert made.part('start').position_m == (-5.0, 0.1, 0.0)
    assert made.part('seeing').camera == 'simple'
    controller = made.settings('docking_controller')
    assert (controller.profile.fast_m_s, controller.safety.active) == (0.06, False)


@pytest.mark.parametrize('key, text, words', [
    ('/** start.position_m', '-5, 0.1', 'start.position_m'),
    ('/** start.position_m', '-5, 0.1, north', 'start.position_m'),
    ('/** start.position_m', '5, 0, 0', 'begin with x < 0'),
    ('/** aim.distance_m', '', 'aim.distance_m'),
    ('/** aim.distance_m', '[', 'aim.distance_m'),
    ('docking_controller position.gain', '-1', 'position.gain'),
    ('docking_controller profile.dock_m_s', '0.5', 'dock_m_s'),
    ('/** seed', '3', 'no setting of the page')])
def test_a_bad_setting_is_refused_in_one_line_that_names_it(plain, key, text, words):
    with pytest.raises(BadInput) as refused:
        with_wishes(plain, display_of(plain).display.forms, {key: text})
    assert words in str(refused.value) and '\n' not in str(refused.value)


# -- hand controllers -------------------------------------------------------------------------

@pytest.fixture(scope='module')
def steered(plain):
    """A display whose page holds both hand controllers."""
    from dataclasses import replace
    facts = replace(facts_of(plain), operator='console', mode='manual')
    return DockingDisplay(facts, plain)


def test_two_hand_controllers_are_two_joys(steered):
    assert steered.sticks == ('/joy/translation', '/joy/rotation')
    stick = Stick(True, 0, (0.5, -0.25, 0.0, 0.0, 1.0, -1.0), (True, False, True) + (False,)*4)
    joys = steered.joys(stick)
    assert joys == {'/joy/translation': ([0.5, -0.25, 0.0], [1, 1, 1]),
                    '/joy/rotation': ([0.0, 1.0, -1.0], [1, 0])}
    for topic, (axes, buttons) in joys.items():
        value, valid = steered.heard_joy(topic, axes, buttons)
    assert (value, valid) == ([0.5, -0.25, 0.0, 0.0, 1.0, -1.0], True)


def test_with_the_dead_man_open_no_button_counts(steered):
    made = steered.joys(Stick(False, 0, (0.0,)*6, (True,)*7))
    assert made == {'/joy/translation': ([0.0]*3, [0]*3), '/joy/rotation': ([0.0]*3, [0]*2)}


def test_without_an_operator_there_is_no_controller(plain):
    assert display_of(plain).display.controller is None


# -- from the ground --------------------------------------------------------------------------

def test_from_the_ground_the_craft_is_shown_as_it_was_and_as_it_will_be(plain):
    from dataclasses import replace
    remote = RemoteDisplay(replace(facts_of(plain), operator='console', mode='manual'), plain)
    level = [0.0, 0.0, 0.0, 1.0]
    down = remote.measured([-5.0, 0.1, 0.0, 0.02, 0.0, 0.0, *level, 0.0, 0.0, 0.0,
                            -4.9, 0.0, 0.2, *level, 1.0])
    made = remote.derive({
        TELEMETRY: Sample(500, 3.7, True, down),
        PREDICTION: Sample(500, 6.3, True, {
            'position': [-4.948, 0.1, 0.0], 'velocity': [0.02, 0.0, 0.0], 'attitude': level,
            'rate': [0.0]*3})})
    assert made['distance'] == pytest.approx(2.0) and made['distance_ahead'] == pytest.approx(1.948)
    assert made['closing'] == 0.02 and made['safety'] == ['HOLD', True]
    assert_allclose(made['wanted'], [-3.4, -0.2, 0.0])
    assert 'r' not in made                      # of another instant than the truth beside it
    display = remote.display
    assert display.link and display.lamps is None and display.camera.pixels is None
    assert {signal for signal in display.parts() if signal.startswith('/onboard')} == set()
    json.dumps(as_data(display))


def test_a_command_of_hands_is_the_pilots_only_while_one_is_held(plain):
    remote = RemoteDisplay(facts_of(plain), plain)
    for flags, by in ((0, BY_NOBODY), (1, BY_PILOT), (2, BY_PILOT), (16, BY_NOBODY)):
        said = Sample(1, 0.01, True, {'value': [0]*6 + [flags], 'by': 2})
        remote.sent(said)
        assert said.parts['by'] == by
    assert remote.pilot([0.5]*6, [1]) == ([50.0]*6, True)
