"""
The plan as inputs over time: how the values at the nodes are joined, and what is to be seen then.

Source  Hu et al. (docs/missions/tether.md): the paper splines its inputs and blames the drift of
        case 1 on the fit of the tension. Which spline, and whether it was clipped, it does not say.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, settings
from rvd_groundstation.planning.plan import Plan
from rvd_missions.tether import geometry
from rvd_missions.tether.settings import ApproachParams, GripperParams, OrbitParams, TetherParams

SPLINES = ('clipped', 'unclipped', 'pchip', 'lagrange', 'hold')
UNLIMITED = ('unclipped', 'lagrange')           # they leave the limits, and are let


@settings
class InputParams:
    """How the planned inputs are joined between the nodes."""

    spline: str = param(
        'clipped', 'Inputs between the nodes: a cubic spline, clipped to the limits or not, pchip, '
        'which stays between its nodes, the polynomial of the plan itself (lagrange), or the value '
        'of the nearest node (hold). Those named unclipped and lagrange leave the limits of the '
        'actuators, which are then not enforced.', choices=SPLINES)

    @property
    def limited(self) -> bool:
        """Whether the limits of the actuators are enforced."""
        return self.spline not in UNLIMITED


def limits(gripper: GripperParams, tether: TetherParams) -> tuple[NDArray, NDArray]:
    """Return the least and greatest command (7,)."""
    most = np.array([tether.most_n, *[gripper.max_force_n]*3, *[gripper.max_torque_n_m]*3])
    return np.array([tether.least_n, *-most[1:]]), most


def joined(plan: Plan, spline: str, time_s: ArrayLike, low: NDArray,
           high: NDArray) -> NDArray[np.float64]:
    """Return the inputs (..., 7) at times (...) [s]; constant beyond the first and last node."""
    from scipy.interpolate import CubicSpline, PchipInterpolator
    nodes, values = plan.node_s, plan.controls
    t = np.clip(np.asarray(time_s, dtype=float), plan.begin_s, plan.end_s)
    if spline == 'lagrange':
        return plan.control_at(t)
    t = np.clip(t, nodes[0], nodes[-1])
    if spline == 'pchip':
        return PchipInterpolator(nodes, values)(t)
    if spline == 'hold':
        return values[np.searchsorted(0.5*(nodes[1:] + nodes[:-1]), t)]
    cubic = CubicSpline(nodes, values)(t)               # not-a-knot
    return np.clip(cubic, low, high) if spline == 'clipped' else cubic


class Reference(NamedTuple):
    """What the plan says of each instant (...)."""

    inputs: NDArray                     # (..., 7)
    seen: NDArray                       # (..., 6) ls [m], alpha0, beta0, roll, pitch, yaw [rad]
    range_m: NDArray                    # (...) l0


def reference(plan: Plan, spline: str, time_s: ArrayLike, orbit: OrbitParams,
              gripper: GripperParams, tether: TetherParams, approach: ApproachParams,
              stretched: bool) -> Reference:
    """
    Return inputs, and lengths and angles to be measured, at times (n,) [s].

    The encoder reads the unstretched length. With `stretched` what it should read is known to be
    ls = l1/(1 + T/EA); without, it is taken for l1, up to 8 mm more.
    """
    t = np.clip(np.asarray(time_s, dtype=float), plan.begin_s, plan.end_s)
    inputs = joined(plan, spline, t, *limits(gripper, tether))
    states = plan.state_at(t)
    place = np.stack([geometry.baseline(orbit, approach.baseline_m, at).place for at in t])
    sight, out = geometry.line(place - states[:, :3]), geometry.line(states[:, :3])
    wound = out.length/(1.0 + stretched*inputs[:, 0]/tether.stiffness_n)
    return Reference(inputs, np.stack([wound, sight.alpha, sight.beta, *states[:, 6:9].T], axis=-1),
                     sight.length)
