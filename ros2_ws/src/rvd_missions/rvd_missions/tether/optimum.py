"""
The optimal approach: orbit, attitude and tension planned together, by Gauss pseudospectral
transcription.

States  r, v of the gripper from the platform, in I; roll, pitch, yaw; body rates: 12.
Controls tension; thruster force along the tether frame; torque about body axes: 7.
Cost    int (|F / F_max|^2 + |tau / tau_max|^2 + w (T / T_max)^2) dt, each axis over its own limit
        [A]: the paper's weights are lost. The small last term makes the tension's arcs regular.
Source  Hu et al. (docs/missions/tether.md), equations (5) to (23) in the forms derived there.
"""

from dataclasses import dataclass
from functools import cached_property, lru_cache
from typing import Any

import numpy as np

from rvd_dynamics.diagram.params import param, settings
from rvd_dynamics.diagram.run import Run
from rvd_groundstation.planning.plan import Plan, straight
from rvd_groundstation.planning.problem import End, Path, Problem, Quantity
from rvd_groundstation.planning.report import PlanReport, report
from rvd_groundstation.planning.transcription import FREE, Solver
from rvd_missions.tether.geometry import goal
from rvd_missions.tether.settings import ApproachParams, GripperParams, OrbitParams, TetherParams

ENDS = np.array([FREE]*6 + [0.0]*6)     # the rest of the end is a condition on time and place
KEPLER = 8                              # Newton steps, which square the error each time


@settings
class PlannerParams:
    """How the approach is planned."""

    nodes: int = param(40, 'Number of Gauss nodes K.', low=10, high=80)
    tension_weight: float = param(
        1e-4, 'Weight of the squared tension over its limit in the cost.', above=0.0)


def problem(orbit: OrbitParams, gripper: GripperParams, tether: TetherParams,
            approach: ApproachParams, planner: PlannerParams) -> Problem:
    """Return the optimal control problem of an approach; see the module."""
    import casadi as ca
    limit, away = approach.angle_limit, approach.baseline_m
    force, torque = gripper.max_force_n, gripper.max_torque_n_m

    def rate(t: Any, x: Any, u: Any, p: Any) -> list:
        return rates(orbit, gripper, t, x, u)

    def running(t: Any, x: Any, u: Any, p: Any) -> Any:
        return (sum((f/force)**2 for f in u[1:4]) + sum((m/torque)**2 for m in u[4:7])
                + planner.tension_weight*(u[0]/tether.most_n)**2)

    def sight(t: Any, x: Any) -> tuple:
        place, _ = target(orbit, away, t)
        a, b, c = (d - r for d, r in zip(place, x[:3]))
        return ca.atan2(b, a), ca.atan2(c, ca.sqrt(a*a + b*b))

    def left(i: int) -> Any:
        """Return what is left of the end condition of position (i < 3) or velocity."""
        def of(x0: Any, xf: Any, t0: Any, tf: Any, p: Any) -> Any:
            place, moving = target(orbit, away, tf)
            wanted = [place[0] - approach.final_range_m, *place[1:], *moving]
            return xf[i] - wanted[i]
        return of

    angles = Quantity('roll', 'rad', 0.1), *(
        Quantity(name, 'rad', 0.1, -limit, limit) for name in ('pitch', 'yaw'))
    return Problem(
        states=(Quantity('x', 'm', 80.0), Quantity('y', 'm', 5.0), Quantity('z', 'm', 5.0),
                Quantity('vx', 'm/s', 1.0), Quantity('vy', 'm/s', 0.1),
                Quantity('vz', 'm/s', 0.1), *angles,
                *(Quantity(f'body rate {axis}', 'rad/s', 0.01) for axis in 'xyz')),
        controls=(Quantity('tension', 'N', tether.most_n, tether.least_n, tether.most_n),
                  *(Quantity(f'force {axis}', 'N', force, -force, force)
                    for axis in ('along the tether', 'in plane', 'out of plane')),
                  *(Quantity(f'torque {axis}', 'N m', torque, -torque, torque) for axis in 'xyz')),
        rate=rate, running=running,
        paths=(Path('alpha0', lambda t, x, u, p: sight(t, x)[0], -limit, limit, 'rad', 0.1),
               Path('beta0', lambda t, x, u, p: sight(t, x)[1], -limit, limit, 'rad', 0.1)),
        ends=tuple(End(f'final {name}', left(i), unit=unit, scale=scale) for i, (name, unit, scale)
                   in enumerate((*((f'offset {a}', 'm', 1.0) for a in 'xyz'),
                                 *((f'speed {a}', 'm/s', 0.1) for a in 'xyz')))))


def rates(orbit: OrbitParams, gripper: GripperParams, t: Any, x: Any, u: Any) -> list:
    """Return the time derivatives of the 12 states, of casadi scalars."""
    import casadi as ca
    rx, ry, rz, vx, vy, vz, phi, theta, psi, wx, wy, wz = x
    tension, f_l, f_a, f_b, mx, my, mz = u
    gravity, turn, _, _ = motion(orbit, t)
    s, c = ca.sin(turn), ca.cos(turn)                       # the radial direction is (s, -c, 0)
    flat = ca.sqrt(rx*rx + ry*ry)
    l1 = ca.sqrt(rx*rx + ry*ry + rz*rz)
    ca_, sa, cb, sb = rx/flat, ry/flat, flat/l1, rz/l1
    pull, m = f_l - tension, gripper.mass_kg
    fx = pull*cb*ca_ - f_a*sa - f_b*sb*ca_
    fy = pull*cb*sa + f_a*ca_ - f_b*sb*sa
    fz = pull*sb + f_b*cb
    outward = 3.0*(s*rx - c*ry)
    # y and z components, in the body, of the direction of the tether
    cf, sf, ct, st = ca.cos(phi), ca.sin(phi), ca.cos(theta), ca.sin(theta)
    cp, sp = ca.cos(psi), ca.sin(psi)
    tx, ty, tz = cb*ca_, cb*sa, sb
    by = (sf*st*cp - cf*sp)*tx + (sf*st*sp + cf*cp)*ty + sf*ct*tz
    bz = (cf*st*cp + sf*sp)*tx + (cf*st*sp - sf*cp)*ty + cf*ct*tz
    arm = gripper.attachment_m*tension
    ix, iy, iz = gripper.inertia_kg_m2
    return [vx, vy, vz,
            gravity*(outward*s - rx) + fx/m,
            gravity*(-outward*c - ry) + fy/m,
            -gravity*rz + fz/m,
            wx + (sf*wy + cf*wz)*st/ct, cf*wy - sf*wz, (sf*wy + cf*wz)/ct,
            (mx - (iz - iy)*wy*wz)/ix,
            (my - arm*bz - (ix - iz)*wz*wx)/iy,
            (mz + arm*by - (iy - ix)*wx*wy)/iz]


def motion(orbit: OrbitParams, t: Any) -> tuple:
    """
    Return mu / r^3, nu - nu0, r / r0 and nu' of the target at a casadi time.

    Kepler's equation is solved by Newton's method, a fixed number of steps from the anomaly of
    uniform motion.
    """
    import casadi as ca
    e, nu0, mu = orbit.eccentricity, orbit.at(0.0).anomaly, orbit.gravitational_parameter_m3_s2
    if e == 0.0:
        n = orbit.mean_motion
        return n*n, n*t, 1.0, n
    b = e/(1.0 + np.sqrt(1.0 - e*e))
    first = nu0 - 2.0*np.arctan2(b*np.sin(nu0), 1.0 + b*np.cos(nu0))
    mean = first - e*np.sin(first) + orbit.mean_motion*t
    eccentric = first + orbit.mean_motion*t/(1.0 - e*np.cos(first))
    for _ in range(KEPLER):
        eccentric -= (eccentric - e*ca.sin(eccentric) - mean)/(1.0 - e*ca.cos(eccentric))
    nu = eccentric + 2.0*ca.atan2(b*ca.sin(eccentric), 1.0 - b*ca.cos(eccentric))
    c, p = 1.0 + e*ca.cos(nu), orbit.parameter
    return mu*(c/p)**3, nu - nu0, (1.0 + e*np.cos(nu0))/c, np.sqrt(mu/p)/p*c*c


def target(orbit: OrbitParams, length: float, t: Any) -> tuple:
    """Return place and velocity of the target from the platform, at a casadi time."""
    import casadi as ca
    _, turn, size, rate = motion(orbit, t)
    c, s, now = ca.cos(turn), ca.sin(turn), length*size
    e, nu = orbit.eccentricity, orbit.at(0.0).anomaly + turn
    growth = rate*e*ca.sin(nu)/(1.0 + e*ca.cos(nu)) if e > 0.0 else 0.0
    return ((now*c, now*s, 0.0), (now*(growth*c - rate*s), now*(growth*s + rate*c), 0.0))


@lru_cache(maxsize=4)
def solver(orbit: OrbitParams, gripper: GripperParams, tether: TetherParams,
           approach: ApproachParams, planner: PlannerParams) -> Solver:
    """Return the solver of an approach; the last four are kept."""
    return Solver(problem(orbit, gripper, tether, approach, planner), planner.nodes)


@lru_cache(maxsize=8)
def plan(orbit: OrbitParams, gripper: GripperParams, tether: TetherParams,
         approach: ApproachParams, planner: PlannerParams) -> Plan:
    """
    Return the optimal approach from its planned start; the last eight are kept.

    Raises
    ------
    BadInput
        If there is none: names the constraint in the way.
    """
    start, middle = approach.initial(orbit.at(0.0).rate), 0.5*sum(approach.duration_s)
    # the tension that takes all speed away over the whole time
    steady = gripper.mass_kg*approach.speed_m_s/middle
    guess = straight(start, goal(orbit, approach, middle),
                     [np.clip(steady, tether.least_n, tether.most_n), *np.zeros(6)], 0.0, middle,
                     planner.nodes)
    return solver(orbit, gripper, tether, approach, planner).solve(
        start, ENDS, approach.duration_s, guess=guess)


@dataclass(frozen=True)
class Preparation:
    """The plan of a scenario, made when it is first asked for."""

    orbit: OrbitParams
    gripper: GripperParams
    tether: TetherParams
    approach: ApproachParams
    planner: PlannerParams

    @property
    def plan(self) -> Plan:
        """The plan; BadInput if there is none."""
        return plan(self.orbit, self.gripper, self.tether, self.approach, self.planner)

    @cached_property
    def report(self) -> PlanReport:
        """What is to be said of the plan."""
        made = solver(self.orbit, self.gripper, self.tether, self.approach, self.planner)
        return report(made, self.plan)

    def last_step(self, run: Run) -> int:
        """Return the first step at or after the end of the approach; a free one is planned."""
        shortest, longest = self.approach.duration_s
        end_s = longest if shortest == longest else self.plan.end_s
        return min(run.last_step, int(np.ceil(end_s/run.step_s - 1e-9)))
