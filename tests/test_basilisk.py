"""
The craft with panels and tanks, and its thrusters, against Basilisk (`bsk`), another simulator.

`rvd_campaign.bench.basilisk` says what is compared, and sets Basilisk up beside the project, on
first need; only where it has no wheel the test is left out.
"""

import numpy as np
import pytest

from rvd_campaign.bench import basilisk
from rvd_dynamics.commands.thruster_set import ThrusterSet
from rvd_dynamics.world.spacecraft.reaction_control import DRAWS, ReactionControl, ThrusterParams

pytestmark = [pytest.mark.slow, pytest.mark.skipif(
    bool(basilisk.missing_wheel()), reason=basilisk.missing_wheel())]
patient = pytest.mark.patient

FORCE, TORQUE = (5.0, 8.0, -6.0), (4.0, -3.0, 2.0)          # [N], [N m] for 5 s
PUSH_S, UNTIL_S = 5.0, 20.0
TURN = (0.001, 0.0, 0.0)                                    # [rad/s] at the start
PUSHED = {'until_s': UNTIL_S, 'rate': TURN, 'force': FORCE, 'torque': TORQUE, 'push_s': PUSH_S}
ON_S, THRUST_N, FINE_S = 0.1, 20.0, 2.5e-4                  # of the pulse, in steps of its own
BENT = {'little': 1e-3, 'much': 1e-2}                       # [rad] at the start


@pytest.fixture(scope='module')
def flown():
    """Return Basilisk's time histories."""
    return basilisk.fly({
        'tanks': basilisk.theirs(False, **PUSHED),
        **{name: basilisk.theirs(True, bent_rad=bent, **PUSHED) for name, bent in BENT.items()},
        'pulse': {'kind': 'pulse', 'mass_kg': basilisk.MASS_KG, 'until_s': 0.3, 'step_s': FINE_S,
                  'inertia': basilisk.INERTIA.tolist(), 'force_n': THRUST_N, 'lag_s': 0.01,
                  'on_s': ON_S}})


def differences(flown, name, panels, bent=0.0):
    """Return the greatest differences of rate [rad/s], place [m], angle [rad], and the angle."""
    rate, place = flown[f'{name}/rate'], flown[f'{name}/place']
    made, root = basilisk.ours(panels), np.sqrt(basilisk.HINGE)
    more = {'panel_0': root*bent} if panels else {}
    state = made.state(1, rate=np.array(TURN), velocity=flown[f'{name}/velocity'][0], **more)
    on, history = np.tile(np.concatenate([FORCE, TORQUE]), (1, 3, 1)), [state[0]]
    for i in range(round(UNTIL_S/basilisk.STEP_S)):
        pushed = on if i < round(PUSH_S/basilisk.STEP_S) else 0.0*on
        state = made.advance(state, pushed, basilisk.STEP_S).state
        history.append(state[0])
    history, at = np.array(history), made.states
    assert len(rate) == len(history)
    moved = history[:, at['position'][0]]
    off = {'rate': history[:, at['rate'][0]] - rate,
           'place': moved - moved[0] - (place - place[0])}
    ours = np.zeros((len(history), 0))
    if panels:
        ours = np.stack([history[:, at[f'panel_{i}'][0]][:, 0]/root for i in (0, 1)], axis=-1)
        off['angle'] = ours - flown[f'{name}/angle']
    return *(np.abs(off[what]).max() if what in off else 0.0 for what in ('rate', 'place', 'angle')
             ), np.abs(ours).max(initial=0.0)


@patient
def test_the_tanks_are_basilisks_springs_and_particles(flown):
    rate, place, _, _ = differences(flown, 'tanks', False)
    print(f'\ntanks: rate {rate:.1e} rad/s, place {place:.1e} m')
    assert rate < 1e-10 and place < 1e-8


@patient
@pytest.mark.parametrize('name', BENT)
def test_the_panels_are_basilisks_hinged_plates_but_for_the_square_of_the_angle(flown, name):
    rate, place, off, angle = differences(flown, name, True, BENT[name])
    print(f'\npanels at {angle:.1e} rad: rate {rate:.1e} rad/s, place {place:.1e} m, '
          f'angle {off:.1e} rad')
    assert off < 5e-3*angle and rate < 5e-6 and place < 1e-5 and angle > 0.9*BENT[name]


@patient
def test_a_pulse_is_basilisks_first_order_thruster(flown):
    """Thrust on its rise, and the impulse to within a fraction of Basilisk's step."""
    theirs = float(flown['pulse/impulse'])
    made = ReactionControl(
        ThrusterSet(np.array([[0.0, 0.8, 0.0]]), np.array([[1.0, 0, 0]]), np.array([THRUST_N]),
                    ('J2',)),
        ThrusterParams(delay_s=0.0, least_on_s=0.01, amplitude_sigma=0.0, direction_sigma=0.0),
        0.01, 10, np.zeros((1, DRAWS)))
    ours, mean = [], 0.0
    for k in range(30):
        fired = made.step(k, np.array([[k < 10]]))
        ours.append(fired.wrench[0, :-1:2, 0])
        mean += 0.01*THRUST_N*fired.mean[0, 0]
    rise = flown['pulse/thrust'][:400:4] - np.concatenate(ours)[:100]
    print(f'\npulse: impulse {mean:.6f} against {theirs:.6f} N s, rise within '
          f'{np.abs(rise).max():.1e} N')
    assert mean == pytest.approx(THRUST_N*ON_S, rel=1e-9)
    assert abs(theirs - mean) < THRUST_N*FINE_S and np.abs(rise).max() < 0.01


def test_the_plant_is_at_least_ten_times_as_fast():
    found = basilisk.race(turns=1)
    print(f'\na step of 2.5 ms: ours {found["step_us"]:.2f} us, Basilisk '
          f'{found["basilisk_us"]:.1f} us, {found["basilisk_ratio"]:.0f} times')
    assert found['basilisk_ratio'] > 10.0
