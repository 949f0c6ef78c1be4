"""
Fly craft in Basilisk and write their time histories. It runs in Basilisk's own environment, where
nothing of this project is installed:

    .rvd/basilisk/bin/python scripts/basilisk_flights.py REQUEST.json OUT.npz

REQUEST maps names to flights: the keyword arguments of `craft` or `pulse` below, and `kind`, which
of the two. OUT holds NAME/WHAT for all that a flight returns.
"""

import json
import sys
import time

from Basilisk.architecture import messaging
from Basilisk.simulation import (
    extForceTorque, hingedRigidBodyStateEffector, linearSpringMassDamper, spacecraft,
    thrusterStateEffector)
from Basilisk.utilities import macros, SimulationBaseClass
import numpy as np


def craft(mass_kg, inertia, panels, tanks, rate, force, torque, push_s, until_s, step_s, recorded):
    """
    Push and turn a craft with panels and tanks, which starts at rest, in Runge-Kutta steps.

    Parameters
    ----------
    mass_kg, inertia : float, (3, 3)
        Of all of it, about its centre of mass with nothing bent or moved.
    panels : list of dict
        Rigid plates on a hinge along z: mass_kg, length_m, root_m along y, side (1: at +y, -1: at
        -y), omega_rad_s and damping of the locked hinge, bent_rad at the start.
    tanks : list of dict
        Particles on springs: mass_kg, place, axis, omega_rad_s, damping.
    rate : (3,)
        At the start [rad/s].
    force, torque : (3,)
        In body axes [N], [N m] for `push_s`.

    Returns
    -------
    dict
        cpu_s, and if `recorded` rate, place, velocity (steps, 3), angle (steps, panels).
    """
    sim = _simulation(step_s)
    body, parts = spacecraft.Spacecraft(), []
    hub, moment, inertia = mass_kg, np.zeros(3), np.array(inertia, dtype=float)

    def take(mass, place, own):                 # of the whole: the rest is the hub
        nonlocal hub, moment, inertia
        r = np.array(place, dtype=float)
        hub, moment = hub - mass, moment - mass*r
        inertia = inertia - own - mass*(r @ r*np.eye(3) - np.outer(r, r))

    for i, panel in enumerate(panels):
        h = hingedRigidBodyStateEffector.HingedRigidBodyStateEffector()
        mass, length, side = panel['mass_kg'], panel['length_m'], panel['side']
        own, about_hinge = mass*length*length/12, mass*length*length/3
        h.mass, h.d, h.k = mass, length/2, panel['omega_rad_s']**2*about_hinge
        h.c = 2*panel['damping']*panel['omega_rad_s']*about_hinge
        h.IPntS_S = [[0, 0, 0], [0, own, 0], [0, 0, own]]
        h.r_HB_B = _column([0, side*panel['root_m'], 0])
        h.dcm_HB = [[0, -side, 0], [side, 0, 0], [0, 0, 1]]
        h.thetaInit, h.nameOfThetaState, h.nameOfThetaDotState = panel['bent_rad'], f'a{i}', f'b{i}'
        take(mass, [0, side*(panel['root_m'] + length/2), 0], np.diag([own, 0, own]))
        parts.append(h)
    for i, tank in enumerate(tanks):
        s = linearSpringMassDamper.LinearSpringMassDamper()
        s.massInit, s.k = tank['mass_kg'], tank['mass_kg']*tank['omega_rad_s']**2
        s.c = 2*tank['damping']*tank['omega_rad_s']*tank['mass_kg']
        s.r_PB_B, s.pHat_B = _column(tank['place']), _column(tank['axis'])
        s.rhoInit, s.rhoDotInit = 0.0, 0.0
        s.nameOfRhoState, s.nameOfRhoDotState, s.nameOfMassState = f'r{i}', f's{i}', f'm{i}'
        take(tank['mass_kg'], tank['place'], 0.0)
        parts.append(s)
    for i, part in enumerate(parts):
        body.addStateEffector(part)
        if i < len(panels):
            sim.AddModelToTask('t', part)
    centre = moment/hub
    inertia = inertia - hub*(centre @ centre*np.eye(3) - np.outer(centre, centre))
    body.hub.mHub, body.hub.r_BcB_B = hub, _column(centre)
    body.hub.IHubPntBc_B, body.hub.omega_BN_BInit = inertia.tolist(), _column(rate)
    push = extForceTorque.ExtForceTorque()
    push.extForce_B, push.extTorquePntB_B = _column(force), _column(torque)
    body.addDynamicEffector(push)
    sim.AddModelToTask('t', body)
    sim.AddModelToTask('t', push)
    logs = []
    if recorded:
        logs = [body.scStateOutMsg.recorder(),
                *(h.hingedRigidBodyOutMsg.recorder() for h in parts[:len(panels)])]
        for log in logs:
            sim.AddModelToTask('t', log)
    sim.InitializeSimulation()
    began = time.process_time()
    sim.ConfigureStopTime(macros.sec2nano(push_s))
    sim.ExecuteSimulation()
    push.extForce_B, push.extTorquePntB_B = _column([0, 0, 0]), _column([0, 0, 0])
    sim.ConfigureStopTime(macros.sec2nano(until_s))
    sim.ExecuteSimulation()
    made = {'cpu_s': time.process_time() - began}
    if recorded:
        made |= {'rate': logs[0].omega_BN_B, 'place': logs[0].r_BN_N, 'velocity': logs[0].v_BN_N}
        if panels:
            made['angle'] = np.stack([np.ravel(log.theta) for log in logs[1:]], axis=-1)
    return made


def pulse(mass_kg, inertia, force_n, lag_s, on_s, until_s, step_s):
    """
    Fire a thruster of first order along x, beside the centre of mass; return thrust and impulse.

    `lag_s` is the time constant; `thrust` (steps,) [N], `impulse` [N s].
    """
    sim = _simulation(step_s)
    body, effector = spacecraft.Spacecraft(), thrusterStateEffector.ThrusterStateEffector()
    body.hub.mHub, body.hub.IHubPntBc_B = mass_kg, inertia
    thruster = thrusterStateEffector.THRSimConfig()
    thruster.thrLoc_B, thruster.thrDir_B = _column([0, 0.8, 0]), _column([1, 0, 0])
    thruster.MaxThrust, thruster.steadyIsp, thruster.cutoffFrequency = force_n, 290.0, 1.0/lag_s
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
    sim.ConfigureStopTime(macros.sec2nano(until_s))
    sim.ExecuteSimulation()
    return {'impulse': mass_kg*log.v_BN_N[-1, 0], 'thrust': np.ravel(thrust.thrustForce)}


def _simulation(step_s):
    sim = SimulationBaseClass.SimBaseClass()
    sim.CreateNewProcess('p').addTask(sim.CreateNewTask('t', macros.sec2nano(step_s)))
    return sim


def _column(v):
    return [[float(x)] for x in v]


def main():
    """Fly what is asked for."""
    request, out = sys.argv[1:]
    with open(request, encoding='utf-8') as file:
        flights = json.load(file)
    found = {}
    for name, flight in flights.items():
        made = {'craft': craft, 'pulse': pulse}[flight.pop('kind')](**flight)
        found |= {f'{name}/{what}': np.asarray(value) for what, value in made.items()}
    np.savez(out, **found)


if __name__ == '__main__':
    main()
