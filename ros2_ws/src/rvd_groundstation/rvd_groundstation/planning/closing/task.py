"""
The task of a closing: motion, cost and limits that the planners share.

Frame   Hill: origin at the target, +x along its velocity, +y opposite to the orbit normal, +z to
        nadir; it turns at (0, -n, 0). The chaser comes from -x, its docking face at +x.
State   (x, y, z, vx, vy, vz) [m, m/s] of the chaser's centre of mass; acceleration (ax, ay, az) by
        its thrusters [m/s^2], along the same axes.
Source  An Hao, Qu Zhenshen, Wang Changhong, J. System Simulation 27(6), 2015, equations (1) and
        (10): X'' + A X' + B X + C(X) = a, with gravity to second order in separation;
        J = k1 (tf - tnom)^2 + k2 int |a|^2 dt. Weights, bounds and geometry are assumed: the paper
        does not give them.
"""

from dataclasses import dataclass
from math import inf, radians, sqrt, tan
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import MU_MOON, RADIUS_MOON
from rvd_dynamics.diagram.params import param, require, settings

SAMPLES = 2001                          # of a plan whose limits are looked at


@settings
class ClosingLimits:
    """What a closing may do, and what it costs."""

    duration_s: tuple = param(
        (60.0, 120.0), 'Least and greatest duration [s].', length=2, above=0.0)
    time_weight: float = param(1e-3, 'Weight k1 of the square of the time off nominal [1/s^2].',
                               low=0.0)
    effort_weight: float = param(
        100.0, 'Weight k2 of the integral of squared acceleration [s^3/m^2].', above=0.0)
    max_acceleration_m_s2: float = param(
        0.02, 'Greatest acceleration along each axis [m/s^2].', above=0.0)
    max_speed_m_s: float = param(0.08, 'Greatest speed [m/s].', above=0.0)
    view_half_angle_deg: float = param(
        20.0, 'Half angle of the cone of view of the port, in which the docking face stays [deg].',
        above=0.0, below=90.0)
    keep_out_radius_m: float = param(
        2.5, 'Radius about the target that the centre of mass stays out of [m].', low=0.0)

    def __post_init__(self) -> None:
        require(self.duration_s[0] <= self.duration_s[1], 'duration_s', 'rise',
                list(self.duration_s))


@settings
class ClosingParams(ClosingLimits):
    """The limits, and where it happens."""

    orbit_radius_m: float = param(
        RADIUS_MOON + 210e3, 'Radius of the circular target orbit [m].', above=0.0)
    gravitational_parameter_m3_s2: float = param(
        MU_MOON, 'Gravitational parameter of the central body [m^3/s^2].', above=0.0)
    nominal_s: float = param(80.0, 'Nominal duration tnom [s].', above=0.0)
    port_to_centres_m: float = param(
        3.0, 'Distance of the centres of mass when the docking faces touch [m].', low=0.0)

    @property
    def mean_motion(self) -> float:
        """Orbital rate n of the target [rad/s]."""
        return sqrt(self.gravitational_parameter_m3_s2/self.orbit_radius_m)/self.orbit_radius_m

    def drift(self, x: Any) -> tuple:
        """Return A X' + B X + C(X), of six scalars or arrays: what thrust must overcome."""
        n, a = self.mean_motion, self.orbit_radius_m
        g, px, py, pz, vx, vz = n*n, x[0], x[1], x[2], x[3], x[5]
        return (-2.0*n*vz + 3.0*g*px*pz/a,
                g*py + 3.0*g*py*pz/a,
                2.0*n*vx - 3.0*g*pz + 1.5*g*(px*px + py*py - 2.0*pz*pz)/a)

    def cost(self, duration: Any, effort: Any) -> Any:
        """Return J of a duration [s] and the integral of squared acceleration [m^2/s^3]."""
        late = duration - self.nominal_s
        return self.time_weight*late*late + self.effort_weight*effort

    def speed_squared(self, x: Any) -> Any:
        """Return the square of the speed [m^2/s^2] of six scalars or arrays."""
        return x[3]*x[3] + x[4]*x[4] + x[5]*x[5]

    def view(self, x: Any) -> Any:
        """
        Return the squares of the offset from the axis minus that of the cone there [m^2].

        Not above 0 within the cone, whose tip is the target's port.
        """
        gap = -x[0] - self.port_to_centres_m
        edge = tan(radians(self.view_half_angle_deg))*gap
        return x[1]*x[1] + x[2]*x[2] - edge*edge

    def distance_squared(self, x: Any) -> Any:
        """Return the square of the distance from the target [m^2]."""
        return x[0]*x[0] + x[1]*x[1] + x[2]*x[2]


class Reference(Protocol):
    """What a planner of a closing returns."""

    duration_s: float
    cost: float

    def at(self, time_s: ArrayLike) -> tuple[NDArray, NDArray]:
        """Return states (..., 6) and accelerations (..., 3) at times (...) [s] from its start."""


@dataclass(frozen=True)
class Ends:
    """Where a closing begins and ends: states (6,)."""

    initial: NDArray
    final: NDArray

    def __post_init__(self) -> None:
        for name in ('initial', 'final'):
            value = np.asarray(getattr(self, name), dtype=float)
            if value.shape != (6,) or not np.isfinite(value).all():
                raise BadInput(f'{name} must be 6 finite numbers, got {value.tolist()}')
            object.__setattr__(self, name, value)


class Margins(NamedTuple):
    """How far a plan stays from its limits; negative: beyond."""

    speed_m_s: float
    acceleration_m_s2: float
    view_m: float
    keep_out_m: float

    def check(self, task: ClosingParams) -> None:
        """
        Refuse a plan that breaks a limit.

        Raises
        ------
        BadInput
            Names the limit that is broken most.
        """
        limits = {'speed_m_s': ('speed', task.max_speed_m_s, 'm/s'),
                  'acceleration_m_s2': ('acceleration', task.max_acceleration_m_s2, 'm/s^2'),
                  'view_m': ('cone of view', 0.0, 'm'),
                  'keep_out_m': ('keep-out', task.keep_out_radius_m, 'm')}
        scales = (task.max_speed_m_s, task.max_acceleration_m_s2, 1.0, 1.0)
        name, margin, _ = min(zip(self._fields, self, scales), key=lambda m: m[1]/m[2])
        if margin < -1e-9:
            word, limit, unit = limits[name]
            raise BadInput(f'plan infeasible: {word} breaks its limit of {limit:g} {unit} by '
                           f'{-margin:.4g} {unit}')


def margins(task: ClosingParams, plan: Reference) -> Margins:
    """Return the margins of a plan, from samples of it."""
    state, accel = plan.at(np.linspace(0.0, plan.duration_s, SAMPLES))
    x = np.moveaxis(state, -1, 0)
    edge = np.tan(np.radians(task.view_half_angle_deg))*(-x[0] - task.port_to_centres_m)
    offset = np.sqrt(x[1]*x[1] + x[2]*x[2])
    return Margins(
        float(task.max_speed_m_s - np.sqrt(task.speed_squared(x)).max()),
        float(task.max_acceleration_m_s2 - np.abs(accel).max()),
        float((edge - offset).min()),
        float(np.sqrt(task.distance_squared(x)).min() - task.keep_out_radius_m)
        if task.keep_out_radius_m > 0.0 else inf)
