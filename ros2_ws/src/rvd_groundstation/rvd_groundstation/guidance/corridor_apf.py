"""
Artificial potential field of the corridor wall: repulsion inwards near the wall and outside it.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes.
Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, eq. 9-11 with the control boundary of
        eq. 24. With e the unit vector towards the nearest wall point q, D the distance to it:
        W = l1/D + l2 v.e,      U = -grad_p W - grad_v W = -l1 e/D^2 - M - l2 e,
        where M = l2 grad_p(v.e). Here D is signed and at least `least_distance_m`, so that the
        repulsion does not reverse outside; M is left out; only the lateral components act, and
        wherever rho > R_cb. The paper prints +grad in eq. 10 and for M a scalar minus a
        vector, meant as l2 [(v.e)e - v]/D, which holds for q frozen; but q moves with the
        chaser, and then M = l2 cos(alpha) v_t / rho, v_t the velocity round the axis.
Limits  no damping: l2 pushes with the same strength at any speed. No band is left at the
        docking plane. docs/models/corridor_apf.md shows what each printed variant does.
"""

from math import cos
from typing import ClassVar

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.geometry.cone import (
    Cone, control_boundary, outward_normal, radius, ray_nearest_point, signed_distance)
from rvd_dynamics.motion.orbit import OrbitParams
from rvd_dynamics.diagram.params import param, settings, wiring
from rvd_dynamics.diagram.run import LegParams

Array = NDArray[np.float64]


@settings
class CorridorApf:
    """Potential field of the corridor wall, beyond the control boundary (eq. 9-24, corrected)."""

    cone: Cone = wiring()
    orbit: OrbitParams = wiring()
    leg_params: LegParams = wiring()
    uses_stick: ClassVar[bool] = False

    lambda_1_m3_s2: float = param(
        2e-4, 'Strength of the push that grows with the inverse square of the distance to the '
        'wall [m^3/s^2].', low=0.0)
    lambda_2_m_s2: float = param(
        5e-3, 'Strength of the push that is the same in the whole band [m/s^2].', low=0.0)
    least_distance_m: float = param(
        0.02, 'Distance to the wall below which the push grows no further [m].', low=0.01)
    band_m: float = param(
        0.0, 'Depth of a fixed band at the wall, l0 of eq. 9, where 0 selects the control '
        'boundary instead [m].', low=0.0)
    damping_per_s: float = param(
        0.0, 'Deceleration per unit of speed towards the wall, which is not in the paper [1/s].',
        low=0.0)
    damp_return: bool = param(False, 'Whether motion away from the wall is damped as well.')
    sphere_band_m: float = param(
        1.5, 'Distance to the surface of an obstacle within which it pushes as the wall does [m].',
        low=0.0)
    closing_rate_m_s: float = param(
        0.25, 'Closing rate for which the control boundary is computed [m/s].', low=0.01)
    gradient: str = param(
        'descent', 'Sign of the gradient in eq. 10: descent, or, for study, printed_ascent.',
        choices=('descent', 'printed_ascent'))
    tangential: str = param(
        'dropped', 'Middle term of eq. 11: dropped, or, for study, frozen_q or moving_q.',
        choices=('dropped', 'frozen_q', 'moving_q'))
    along_x: bool = param(False, 'Whether the force also acts along x, for study only.')
    distance: str = param(
        'signed', 'Distance to the wall: signed, or, for study, printed_unsigned as in eq. 13 '
        'and 17.', choices=('signed', 'printed_unsigned'))
    nearest_point: str = param(
        'normal', 'Direction to the wall: normal to it, or, for study, printed_ray as in eq. 14 '
        'and 15.', choices=('normal', 'printed_ray'))
    boundary_rate: str = param(
        'at_arrival', 'Place at which the drift rate of eq. 22 is taken: at_arrival, or, for '
        'study, printed_at_station.', choices=('at_arrival', 'printed_at_station'))
    boundary_sign: str = param(
        'clamped', 'Control boundary below zero: clamped, or, for study, printed_squared as in '
        'eq. 24.', choices=('clamped', 'printed_squared'))

    def wanted(self, prediction: ArrayLike, stick: ArrayLike | None) -> Array:
        """Return `repulsion` (..., 3); see `Law.wanted`."""
        return self.repulsion(prediction)

    def repulsion(self, state: ArrayLike) -> Array:
        """
        Return the acceleration (..., 3) [m/s^2] that the field asks for at `state` (..., 6).

        Zero inside the control boundary; lateral components NaN where the state is unknown.
        """
        state = np.asarray(state, dtype=float)
        x, y, z = state[..., 0], state[..., 1], state[..., 2]
        rho = np.sqrt(y*y + z*z)
        at_rest = rho <= self.boundary(x)               # false also where x or rho is unknown
        force = self._force(state, rho)
        if not self.along_x:
            force[..., 0] = 0.0
        return np.where(at_rest[..., None], 0.0, force)

    def from_sphere(self, state: Array, place: Array, radius_m: float) -> Array:
        """
        Return the push (..., 3) [m/s^2] of a sphere at `place` (..., 3), within `sphere_band_m`.

        Eq. 11 without its middle term, with e towards the centre and D the distance to the
        surface; it also acts along x, where a wall does not stand but a sphere may.
        """
        away = [state[..., i] - place[..., i] for i in range(3)]
        x, y, z = away
        far = np.sqrt(x*x + y*y + z*z)
        closing = -(x*state[..., 3] + y*state[..., 4] + z*state[..., 5]) / np.maximum(far, 1e-9)
        d = np.maximum(far - radius_m, self.least_distance_m)
        push = self.lambda_1_m3_s2/(d*d) + self.lambda_2_m_s2
        braked = closing if self.damp_return else np.maximum(closing, 0.0)
        push = push + self.damping_per_s*braked
        push = np.where(far - radius_m <= self.sphere_band_m, push, 0.0) / np.maximum(far, 1e-9)
        return np.stack([push*part for part in away], axis=-1)

    def boundary(self, x: ArrayLike) -> Array:
        """Return the radius [m] at stations `x` [m] (...) beyond which the field acts."""
        corridor = self.cone
        if self.band_m > 0.0:
            return np.maximum(radius(x, corridor) - self.band_m/cos(corridor.alpha), 0.0)
        found = control_boundary(
            x, corridor, self.orbit.mean_motion, self.closing_rate_m_s, self.leg_params.loop_s,
            at_arrival=self.boundary_rate == 'at_arrival',
            clamp=self.boundary_sign == 'clamped')
        return np.abs(found)                    # eq. 24 squares it; no change if clamped

    def _force(self, state: Array, rho: Array) -> Array:
        """Return eq. 11 everywhere, whether in the band or not."""
        position, velocity = state[..., :3], state[..., 3:]
        d = signed_distance(position, self.cone)
        e = self._towards_wall(position, d)
        d = np.abs(d) if self.distance == 'printed_unsigned' else d
        d = np.maximum(d, self.least_distance_m)
        closing = (velocity[..., 0]*e[..., 0] + velocity[..., 1]*e[..., 1]
                   + velocity[..., 2]*e[..., 2])
        push = self.lambda_1_m3_s2/(d*d) + self.lambda_2_m_s2
        braked = closing if self.damp_return else np.maximum(closing, 0.0)
        push = push + self.damping_per_s*braked
        force = -(push[..., None]*e)
        if self.tangential == 'frozen_q':
            force -= self.lambda_2_m_s2*(closing[..., None]*e - velocity) / d[..., None]
        elif self.tangential == 'moving_q':
            force -= self._tangential(state, rho)
        return force if self.gradient == 'descent' else -force

    def _towards_wall(self, position: Array, d: Array) -> Array:
        """Return e_pq (eq. 17): the normal, which does not turn round outside."""
        corridor = self.cone
        if self.nearest_point == 'printed_ray':
            e = ray_nearest_point(position, corridor, printed=True) - position
            length = np.sqrt(e[..., 0]*e[..., 0] + e[..., 1]*e[..., 1] + e[..., 2]*e[..., 2])
            return e / np.where(length > 0.0, length, 1.0)[..., None]
        e = outward_normal(position, corridor)
        if self.distance == 'printed_unsigned':
            e = np.where((d < 0.0)[..., None], -e, e)
        return e

    def _tangential(self, state: Array, rho: Array) -> Array:
        """Return l2 cos(alpha) v_t / rho, the gradient of v.e when q moves with the chaser."""
        _, y, z, _, vy, vz = np.moveaxis(state, -1, 0)
        away = np.where(rho > 0.0, rho, 1.0)
        spin = (y*vz - z*vy) / (away*away*away)         # v_t / rho per metre of (-z, y)
        scale = self.lambda_2_m_s2 * cos(self.cone.alpha)
        return scale * np.stack([np.zeros_like(spin), -z*spin, y*spin], axis=-1)
