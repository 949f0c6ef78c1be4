"""
The craft with panels and tanks, and its thrusters, against Basilisk (`bsk`), another simulator.

Basilisk wants an older matplotlib and pillow than the rest of the project, and stands in
requirements-basilisk.txt: `./rvd shell pip install --no-deps -r requirements-basilisk.txt`. Its
hinged panel is a rigid plate on a spring, whose one mode here is phi = xi/sqrt(J): the same but for
terms of second order in the angle, which the plate's tip makes by moving on a circle. Its spring
and particle is our tank.
"""

from functools import lru_cache
import time

import numpy as np
import pytest

from rvd_dynamics.commands.thruster_set import ThrusterSet
from rvd_dynamics.world.spacecraft.effectors import Panel, Tank
from rvd_dynamics.world.spacecraft.reaction_control import DRAWS, ReactionControl, ThrusterParams
from rvd_dynamics.world.spacecraft.spacecraft import Spacecraft

pytest.importorskip('Basilisk', reason='see requirements-basilisk.txt')
pytestmark = pytest.mark.slow

MASS, INERTIA = 2000.0, np.diag([2200.0, 3000.0, 2800.0])
M, L, ROOT = 18.0, 4.0, 0.9                                 # [kg], [m], [m] a panel
J, OMEGA, XI = M*L*L/3.0, 2*np.pi*0.25, 0.005
TANKS = ((60.0, (-1.0, 0.0, 0.0), (0.0, 1.0, 0.0), 0.25),   # [kg], [m], axis, [rad/s]
         (140.0, (0.3, 0.0, 0.0), (0.0, 0.0, 1.0), 0.35))
FORCE, TORQUE = np.array([5.0, 8.0, -6.0]), np.array([4.0, -3.0, 2.0])      # [N], [N m] for 5 s
STEP, PUSH_S, UNTIL_S = 0.0025, 5.0, 20.0
TURN = np.array([0.001, 0.0, 0.0])                          # [rad/s] at the start


def column(v):
    return [[float(x)] for x in v]


def basilisk(panels, bent, recorded=True, until_s=UNTIL_S):
    """Fly Basilisk's craft; times, angular velocity, place, panel angles, CPU time [s]."""
    from Basilisk.simulation import (
        extForceTorque, hingedRigidBodyStateEffector, linearSpringMassDamper, spacecraft)
    from Basilisk.utilities import macros, SimulationBaseClass
    sim = SimulationBaseClass.SimBaseClass()
    sim.CreateNewProcess('p').addTask(sim.CreateNewTask('t', macros.sec2nano(STEP)))
    craft, parts = spacecraft.Spacecraft(), []
    hub, moment, inertia = MASS, np.zeros(3), INERTIA.copy()

    def take(mass, place, own):
        nonlocal hub, moment, inertia
        r = np.array(place)
        hub, moment = hub - mass, moment - mass*r
        inertia = inertia - own - mass*(r @ r*np.eye(3) - np.outer(r, r))

    for i, side in enumerate((1.0, -1.0) if panels else ()):
        h, own = hingedRigidBodyStateEffector.HingedRigidBodyStateEffector(), M*L*L/12
        h.mass, h.d, h.k, h.c = M, L/2, OMEGA**2*J, 2*XI*OMEGA*J
        h.IPntS_S = [[0, 0, 0], [0, own, 0], [0, 0, own]]
        h.r_HB_B, h.dcm_HB = column([0, side*ROOT, 0]), [[0, -side, 0], [side, 0, 0], [0, 0, 1]]
        h.thetaInit, h.nameOfThetaState, h.nameOfThetaDotState = bent*(1 - i), f'a{i}', f'b{i}'
        craft.addStateEffector(h)
        sim.AddModelToTask('t', h)
        take(M, [0, side*(ROOT + L/2), 0], np.diag([own, 0, own]))
        parts.append(h)
    for i, (mass, place, axis, omega) in enumerate(TANKS):
        s = linearSpringMassDamper.LinearSpringMassDamper()
        s.k, s.c, s.massInit = mass*omega**2, 2*0.01*omega*mass, mass
        s.r_PB_B, s.pHat_B, s.rhoInit, s.rhoDotInit = column(place), column(axis), 0.0, 0.0
        s.nameOfRhoState, s.nameOfRhoDotState, s.nameOfMassState = f'r{i}', f's{i}', f'm{i}'
        craft.addStateEffector(s)
        take(mass, place, 0.0)
        parts.append(s)
    centre = moment/hub
    inertia = inertia - hub*(centre @ centre*np.eye(3) - np.outer(centre, centre))
    craft.hub.mHub, craft.hub.r_BcB_B = hub, column(centre)
    craft.hub.IHubPntBc_B, craft.hub.omega_BN_BInit = inertia.tolist(), column(TURN)
    push = extForceTorque.ExtForceTorque()
    push.extTorquePntB_B, push.extForce_B = column(TORQUE), column(FORCE)
    craft.addDynamicEffector(push)
    sim.AddModelToTask('t', craft)
    sim.AddModelToTask('t', push)
    logs = []
    if recorded:
        logs = [craft.scStateOutMsg.recorder(),
                *(h.hingedRigidBodyOutMsg.recorder() for h in parts[:2 if panels else 0])]
        for log in logs:
            sim.AddModelToTask('t', log)
    sim.InitializeSimulation()
    began = time.process_time()
    sim.ConfigureStopTime(macros.sec2nano(PUSH_S))
    sim.ExecuteSimulation()
    push.extTorquePntB_B, push.extForce_B = column([0, 0, 0]), column([0, 0, 0])
    sim.ConfigureStopTime(macros.sec2nano(until_s))
    sim.ExecuteSimulation()
    return logs, time.process_time() - began


def craft(panels):
    made = ()
    if panels:
        made = tuple(Panel((0, side*ROOT, 0), (0, side, 0), (0, 0, 1), np.array([M*L/2/np.sqrt(J)]),
                           np.array([np.sqrt(J)]), np.array([OMEGA]), np.array([XI]))
                     for side in (1.0, -1.0))
    tanks = tuple(Tank(place, np.array([axis]), mass, omega, 0.01)
                  for mass, place, axis, omega in TANKS)
    return Spacecraft(MASS, INERTIA, np.eye(3), made, tanks)


@lru_cache(maxsize=None)
def differences(panels, bent):
    """Return the greatest differences of rate [rad/s], place [m], angle [rad], and the angle."""
    logs, _ = basilisk(panels, bent)
    truth, angles = logs[0], logs[1:]
    made = craft(panels)
    more = {'panel_0': np.sqrt(J)*bent} if panels else {}
    state = made.state(1, rate=TURN, velocity=truth.v_BN_N[0], **more)
    on, history = np.tile(np.concatenate([FORCE, TORQUE]), (1, 3, 1)), [state[0]]
    for i in range(round(UNTIL_S/STEP)):
        state = made.advance(state, on if i < round(PUSH_S/STEP) else 0.0*on, STEP).state
        history.append(state[0])
    history, at = np.array(history), made.states
    rate = np.abs(history[:, at['rate'][0]] - truth.omega_BN_B).max()
    place = history[:, at['position'][0]]
    moved = np.abs(place - place[0] - truth.r_BN_N + truth.r_BN_N[0]).max()
    ours = [history[:, at[f'panel_{i}'][0]][:, 0]/np.sqrt(J) for i in range(len(angles))]
    off = max((np.abs(a - b.theta).max() for a, b in zip(ours, angles)), default=0.0)
    return rate, moved, off, max((np.abs(a).max() for a in ours), default=0.0)


def test_the_tanks_are_basilisks_springs_and_particles():
    rate, place, _, _ = differences(False, 0.0)
    print(f'\ntanks: rate {rate:.1e} rad/s, place {place:.1e} m')
    assert rate < 1e-10 and place < 1e-8


def test_the_panels_are_basilisks_hinged_plates_but_for_the_square_of_the_angle():
    for bent in (1e-3, 1e-2):
        rate, place, off, angle = differences(True, bent)
        print(f'\npanels at {angle:.1e} rad: rate {rate:.1e} rad/s, place {place:.1e} m, '
              f'angle {off:.1e} rad')
        assert off < 5e-3*angle and rate < 5e-6 and place < 1e-5


def test_a_pulse_is_basilisks_first_order_thruster():
    """Thrust on its rise, and the impulse to within a fraction of Basilisk's step."""
    from Basilisk.architecture import messaging
    from Basilisk.simulation import spacecraft, thrusterStateEffector
    from Basilisk.utilities import macros, SimulationBaseClass
    step, on_s, force = 2.5e-4, 0.1, 20.0
    sim = SimulationBaseClass.SimBaseClass()
    sim.CreateNewProcess('p').addTask(sim.CreateNewTask('t', macros.sec2nano(step)))
    body, effector = spacecraft.Spacecraft(), thrusterStateEffector.ThrusterStateEffector()
    body.hub.mHub, body.hub.IHubPntBc_B = MASS, INERTIA.tolist()
    thruster = thrusterStateEffector.THRSimConfig()
    thruster.thrLoc_B, thruster.thrDir_B = column([0, 0.8, 0]), column([1, 0, 0])
    thruster.MaxThrust, thruster.steadyIsp, thruster.cutoffFrequency = force, 290.0, 100.0
    effector.addThruster(thruster)
    effector.kappaInit = messaging.DoubleVector([0.0])
    body.addStateEffector(effector)
    command = messaging.THRArrayOnTimeCmdMsgPayload()
    command.OnTimeRequest = [on_s]
    message = messaging.THRArrayOnTimeCmdMsg().write(command, 0)
    effector.cmdsInMsg.subscribeTo(message)
    for model in (effector, body):
        sim.AddModelToTask('t', model)
    log, thrust = body.scStateOutMsg.recorder(), effector.thrusterOutMsgs[0].recorder()
    for model in (log, thrust):
        sim.AddModelToTask('t', model)
    sim.InitializeSimulation()
    sim.ConfigureStopTime(macros.sec2nano(0.3))
    sim.ExecuteSimulation()
    theirs = MASS*log.v_BN_N[-1, 0]
    made = ReactionControl(
        ThrusterSet(np.array([[0.0, 0.8, 0.0]]), np.array([[1.0, 0, 0]]), np.array([force]),
                    ('J2',)),
        ThrusterParams(delay_s=0.0, least_on_s=0.01, amplitude_sigma=0.0, direction_sigma=0.0),
        0.01, 10, np.zeros((1, DRAWS)))
    ours, mean = [], 0.0
    for k in range(30):
        fired = made.step(k, np.array([[k < 10]]))
        ours.append(fired.wrench[0, :-1:2, 0])
        mean += 0.01*force*fired.mean[0, 0]
    rise = np.ravel(thrust.thrustForce)[:400:4] - np.concatenate(ours)[:100]
    print(f'\npulse: impulse {mean:.6f} against {theirs:.6f} N s, rise within '
          f'{np.abs(rise).max():.1e} N')
    assert mean == pytest.approx(force*on_s, rel=1e-9)
    assert abs(theirs - mean) < force*step and np.abs(rise).max() < 0.01


def test_the_plant_is_at_least_ten_times_as_fast():
    """The same craft, the same Runge-Kutta steps, CPU time, nothing recorded; 100 rows of ours."""
    _, theirs = basilisk(True, 1e-2, recorded=False, until_s=60.0)
    theirs /= 60.0/STEP
    made, rows, sub = craft(True), 100, 40
    state, still = made.state(rows), np.zeros((rows, 2*sub + 1, 6))
    made.advance(state, still, sub*STEP)                    # compiled
    began = time.process_time()
    for _ in range(50):
        state = made.advance(state, still, sub*STEP).state
    ours = (time.process_time() - began)/(50*sub*rows)
    print(f'\na step of 2.5 ms: ours {1e6*ours:.2f} us, Basilisk {1e6*theirs:.1f} us, '
          f'{theirs/ours:.0f} times')
    assert theirs > 10.0*ours
