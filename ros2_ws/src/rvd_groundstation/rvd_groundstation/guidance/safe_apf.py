"""
Artificial potential field for close proximity: attraction, obstacles, alarms, approach speed.

Frame   target orbital, target at the origin. State (x, y, z, vx, vy, vz) [m, m/s] on the last axis;
        leading axes are batch axes. Obstacles (..., M, 6) likewise.
Source  Xu Dandan, Zhang Jin, Chinese J. Theor. Appl. Mech. 52(6). The scan lost equations and
        tables: [S] stands in the source, [D] is derived from it, [A] is a reconstruction.

    a = (v_g + v_m + sum v_o - v) / dt                                          [S] form, [A] v once
    v_g = -k v_max (1 - exp(-b_g r)) (1 - exp(-t/1 s)) r_c / r                  [A] parameters [S]
    v_o = k_o (r_co / sigma^2) exp(-|r_co|^2 / 2 sigma^2), while alarmed       [D] of a Gaussian [S]
    sigma = (L_o + D) / 3                                                       [S]
    D = d_0 (L_o + D_stop), or d_0' + L_o + D_stop;  D_stop = v^2 / 2 a_max     [A]; [D]
    v_m = -v_g exp(-k_s (r - L))                                                [A]
    k_s = 0.8 [1 - exp(-(r^2 - L^2)/2)] in the speed corridor                   [S], units [A]

with r_co = r_c - r_o, L and L_o the sums of radii, v in D_stop relative to the obstacle. The alarm
of an obstacle is its distance (|r_co| <= D) or the collision probability (P_c >= P_th) [S].

A law without obstacles is a function of the state, as all laws are (`wanted`). What must be
remembered, which alarms are on, is the caller's: `alarmed` takes it and returns it.
"""

from typing import Any, ClassVar, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require, settings, wiring
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.geometry import collision
from rvd_dynamics.geometry.speed_corridor import SpeedCorridor

Array = NDArray[np.float64]
RISE_S = 1.0                            # [s] of the soft start, 1 - exp(-t)
ALWAYS_S = 1e9                          # [s] long after the start
TARGET_RATE_PER_M = 0.8                 # [1/m] largest k_s in the corridor, as printed


class Encounter(NamedTuple):
    """What the law knows of each obstacle, all (..., M) but the components."""

    away: tuple[Array, Array, Array]    # [m] from the obstacle to the chaser, x, y, z
    distance: Array                     # [m] of the centres
    zone: Array                         # [m] D
    radius: NDArray                     # [m] (M,) L_o


@settings
class TargetField:
    """Attraction and repulsion by the target, within a corridor of the approach speed."""

    uses_stick: ClassVar[bool] = False

    attraction: float = param(1.0, 'Gain k of the attraction.', above=0.0, high=100.0)
    max_speed_m_s: float = param(
        1.0, 'Speed far from the target, v_max [m/s].', above=0.0, high=100.0)
    slowing_per_m: float = param(
        0.0045, 'Rate b_g at which the speed dies away near the target [1/m].', above=0.0,
        high=10.0)
    target_repulsion: str = param(
        'corridor', 'Repulsion by the target: that of the speed corridor where it is kept, or the '
        'empirical one.', choices=('corridor', 'empirical'))
    target_rate_per_m: float = param(
        0.5, 'Rate k_s of the empirical repulsion by the target [1/m].', low=0.0, high=100.0)
    target_range_m: float = param(
        4.0, 'Distance to the target within which the empirical repulsion acts [m].', above=0.0,
        high=1000.0)

    run: Run | None = wiring()
    speed_corridor: SpeedCorridor | None = wiring()
    contact_m: float | None = wiring()          # L, the sum of the radii of chaser and target

    def __post_init__(self) -> None:
        if self.contact_m is not None and self.target_repulsion == 'empirical':
            require(self.target_range_m > self.contact_m, 'target_range_m',
                    f'be above the distance at contact, {self.contact_m:g}', self.target_range_m)

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None = None) -> Array:
        """Return the acceleration (..., 3) [m/s^2] wanted at states (..., 6) without obstacles."""
        return self.acceleration(np.asarray(prediction, dtype=float), ALWAYS_S, ())

    def acceleration(self, state: Array, t_s: float, pushes: Any) -> Array:
        """
        Return the acceleration wanted at states, with velocities added to those of the target.

        Parameters
        ----------
        state : ndarray, shape (..., 6)
        t_s : float
            Time since the start [s].
        pushes : three ndarrays (...), or ()
            What `repulsion` returned.
        """
        wish = self.approach(state, t_s)
        rate = 1.0 / self.run.step_s
        result = np.empty((3, *state.shape[:-1]))
        for i in range(3):
            pull = wish[i] - state[..., 3 + i]
            result[i] = (pull if not len(pushes) else pull + pushes[i]) * rate
        return result.transpose(*range(1, result.ndim), 0)

    def approach(self, state: Array, t_s: float) -> tuple[Array, Array, Array]:
        """Return v_g + v_m along x, y, z [m/s], within the speed corridor where it is kept."""
        x, y, z = state[..., 0], state[..., 1], state[..., 2]
        r = np.sqrt(x*x + y*y + z*z)
        share = -self.speed(r, t_s) / np.maximum(r, 1e-12)
        return share*x, share*y, share*z

    def speed(self, r: Array, t_s: float) -> Array:
        """Return the size of v_g + v_m (...) [m/s] at distances (...) [m] from the target."""
        speed = (self.attraction * self.max_speed_m_s * -np.expm1(-t_s / RISE_S)
                 * -np.expm1(-self.slowing_per_m * r))
        gap = r - self.contact_m
        if self.speed_corridor.kept and self.target_repulsion == 'corridor':
            # V_g - L^2/2, not the printed V_g - L_o/2, whose units do not fit
            beyond = np.maximum(0.5 * gap * (r + self.contact_m), 0.0)
            rate = TARGET_RATE_PER_M * -np.expm1(-beyond)
            speed = speed * -np.expm1(-rate * np.maximum(gap, 0.0))
        elif self.target_repulsion == 'empirical':
            slowed = speed * -np.expm1(-self.target_rate_per_m * np.maximum(gap, 0.0))
            speed = np.where(r < self.target_range_m, slowed, speed)
        if self.speed_corridor.kept:
            speed = np.minimum(speed, self.speed_corridor.limit(gap))
        return speed


@settings
class ObstacleField:
    """Repulsion by obstacles, each on while it alarms."""

    repulsion_m2_s: float = param(
        0.4, 'Product k_i k_o of the gains of the repulsion by obstacles [m^2/s].', low=0.0,
        high=1000.0)
    zone: str = param(
        'product', 'Braking zone: d_0 (L_o + D_stop), or the sum d_0 + L_o + D_stop.',
        choices=('product', 'sum'))
    zone_factor: float = param(
        1.8, 'Factor d_0 of the zone as a product.', above=0.0, high=100.0)
    zone_margin_m: float = param(
        1.28, 'Margin d_0 of the zone as a sum [m].', low=0.0, high=1000.0)
    braking_m_s2: float = param(
        0.01, 'Deceleration of the braking distance, a_max [m/s^2].', above=0.0, high=1000.0)
    braking_speed: str = param(
        'relative', 'Speed of the braking distance: the relative one, or what of it closes.',
        choices=('relative', 'closing'))
    alarm: str = param(
        'probability', 'What puts the repulsion by an obstacle on: its distance, the collision '
        'probability, or nothing.', choices=('distance', 'probability', 'none'))
    covariance: str = param(
        'sphere', 'Collision probability for the mean variance of the axes (sphere), or for the '
        'covariance as it is (general).', choices=('sphere', 'general'))
    alarm_probability: float = param(
        1e-4, 'Collision probability that raises the alarm, P_th.', above=0.0, below=1.0)
    release_distance_factor: float = param(
        1.0, 'Distance at which an alarm ends, in zones; above 1 it has hysteresis.', low=1.0,
        high=100.0)
    release_probability_factor: float = param(
        1.0, 'Probability at which an alarm ends, in alarm probabilities; below 1 it has '
        'hysteresis.', above=0.0, high=1.0)

    def encounter(self, state: Array, obstacles: Array, radius: Array) -> Encounter:
        """
        Return distances and braking zones.

        Parameters
        ----------
        state : ndarray, shape (..., 6)
        obstacles : ndarray, shape (..., M, 6) or (M, 6)
        radius : ndarray, shape (M,)
            Sums of the radii of chaser and obstacle [m].
        """
        away = tuple(state[..., i, None] - obstacles[..., i] for i in range(3))
        u, v, w = (state[..., i, None] - obstacles[..., i] for i in range(3, 6))
        x, y, z = away
        distance = np.sqrt(x*x + y*y + z*z)
        if self.braking_speed == 'relative':
            square = u*u + v*v + w*w
        else:
            closing = np.maximum(-(x*u + y*v + z*w), 0.0) / np.maximum(distance, 1e-12)
            square = closing*closing
        stop = square * (0.5 / self.braking_m_s2)
        zone = (self.zone_factor * (radius + stop) if self.zone == 'product'
                else self.zone_margin_m + radius + stop)
        return Encounter(away, distance, zone, radius)

    def alarmed(self, met: Encounter, covariance: Array, before: NDArray[np.bool_]
                ) -> tuple[NDArray[np.bool_], Array | None]:
        """
        Return which obstacles alarm, (..., M), and their collision probabilities.

        Parameters
        ----------
        met : Encounter
        covariance : ndarray, shape (..., M, 3, 3)
            Of the relative position [m^2]; axes in front that it lacks are those of `met`.
        before : ndarray of bool, shape (..., M)
            Which alarmed in the step before: hysteresis.

        The probabilities are None where the alarm is by another rule, or where they were not
        needed as numbers: bounds have decided.
        """
        if self.alarm == 'none':
            return np.zeros(met.distance.shape, dtype=bool), None
        if self.alarm == 'distance':
            on = met.distance <= met.zone
            if self.release_distance_factor > 1.0:
                on |= before & (met.distance <= self.release_distance_factor * met.zone)
            return on, None
        if self.covariance == 'sphere':
            sigma = np.sqrt((covariance[..., 0, 0] + covariance[..., 1, 1] + covariance[..., 2, 2])
                            / 3.0)
            p = collision.sphere_probability(met.distance, sigma, met.radius)
            on = p >= self.alarm_probability
            if self.release_probability_factor < 1.0:
                on |= before & (p >= self.release_probability_factor * self.alarm_probability)
            return on, p
        offset = np.stack(met.away, axis=-1)
        on = collision.reaches(offset, covariance, met.radius, self.alarm_probability).above
        if self.release_probability_factor < 1.0 and before.any():
            lower = self.release_probability_factor * self.alarm_probability
            on |= before & collision.reaches(offset, covariance, met.radius, lower).above
        return on, None

    def repulsion(self, met: Encounter, on: NDArray[np.bool_]) -> tuple[Array, ...]:
        """Return the velocities along x, y, z [m/s] by which alarmed obstacles push, each (...)."""
        if not on.any():
            return ()
        sigma = (met.radius + met.zone) / 3.0
        share = met.distance / sigma
        push = self.repulsion_m2_s / (sigma*sigma) * np.exp(-0.5*share*share)
        push = np.where(on, push, 0.0)
        return tuple(_added(push * component) for component in met.away)


@settings
class SafeApf(TargetField, ObstacleField):
    """Potential field with alarms for obstacles and a corridor of the approach speed."""


def _added(parts: Array) -> Array:
    """Return the sum over the last axis in its order: the same bits in any batch and layout."""
    total = parts[..., 0]
    for i in range(1, parts.shape[-1]):
        total = total + parts[..., i]
    return total
