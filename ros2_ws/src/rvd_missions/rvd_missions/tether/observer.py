"""
The observer on board: where the gripper is, how fast, and by how much the baseline is off.

Motion across the sight is known from the commands and seen as an angle: their quotient is range.
An extended Kalman filter of (r, v, d, q): place and velocity from the platform in I, error of the
baseline [m], and of the mass as a fraction, without which an error of the mass would be one of
the range.

    r'' = mu/r^3 (3 (rhat . r) rhat - r) + (1 - q) (F - T x_t)/m,   d' = q' = 0
    z = (|r|, alpha0, beta0) of the encoder, corrected for stretch, and of (D0 + d) dhat - r

Valid   the commands are carried out; what disturbs is white and small. A constant force that is not
        known is taken for range. The Jacobian leaves out how thrust across turns with the tether.
Source  ours: the paper has no range at all. Filter: Bar-Shalom, Li, Kirubarajan, Estimation with
        Applications to Tracking and Navigation, 2001, section 10.3.
"""

from math import atan2, sqrt

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.compiled import compiled
from rvd_dynamics.diagram.news import begun_anew, News
from rvd_dynamics.diagram.params import param, settings
from rvd_missions.tether.settings import ApproachParams, GripperParams, OrbitParams, TetherParams

STATES = 8
ANEW = -1                       # in place of a count: taken although it is an outlier
MEASURED = ('length of the tether', 'bearing in the orbit plane', 'bearing out of the orbit plane')


@settings
class ObserverParams:
    """What the observer believes before and between measurements."""

    on: bool = param(
        False, 'Whether the tracker follows the plan by what the observer estimates, the baseline '
        'included; otherwise by the measurements and the assumed baseline.')
    baseline_sigma_m: float = param(
        1.0, 'Standard deviation of the baseline before the release [m].', low=0.0)
    release_sigma_m_s: float = param(
        0.03, 'Standard deviation of the speed of the release along each axis [m/s].', above=0.0)
    mass_sigma: float = param(
        0.01, 'Standard deviation of the mass, as a fraction.', low=0.0, below=0.3)
    encoder_sigma_m: float = param(0.005, 'Noise of the encoder [m].', above=0.0)
    bearing_sigma_rad: float = param(
        7e-4, 'Noise of each inertial angle of the bearing, that of the attitude included [rad].',
        above=0.0)
    gate_nis: float = param(
        1e4, 'Innovation squared over its variance above which a measurement is an outlier and '
        'left out.', above=0.0)
    gate_patience: int = param(
        10, 'Outliers of one kind in a row after which the next measurement is taken, with a '
        'covariance made wide enough for it.', low=1)
    force_sigma_n_rt_s: float = param(
        5e-4, 'Density of the white force that is not known, along each axis [N s^0.5].', above=0.0)


@compiled
def predict(x, cov, u, orbit, mass, density, h):
    """Carry states (N, 8) and covariances (N, 8, 8) over `h` [s] under commands, in place."""
    g, s, c = orbit[0], orbit[1], orbit[2]
    jump, work = np.zeros((STATES, STATES)), np.zeros((STATES, STATES))
    for row in range(len(x)):
        p, command = x[row], u[row]
        rx, ry, rz = p[0], p[1], p[2]
        flat = sqrt(rx*rx + ry*ry)
        l1 = sqrt(flat*flat + rz*rz)
        ca, sa, cb, sb = rx/flat, ry/flat, flat/l1, rz/l1
        e = (cb*ca, cb*sa, sb)
        pull = (command[1] - command[0])/mass
        force = (pull*e[0] + (-command[2]*sa - command[3]*sb*ca)/mass,
                 pull*e[1] + (command[2]*ca - command[3]*sb*sa)/mass,
                 pull*e[2] + command[3]*cb/mass)
        outward, part = 3.0*(s*rx - c*ry), 1.0 - p[7]
        grad = (g*(outward*s - rx), g*(-outward*c - ry), -g*rz)
        jump[:] = 0.0
        for i in range(STATES):
            jump[i, i] = 1.0
        for i in range(3):
            a = grad[i] + part*force[i]
            p[i] += h*(p[3 + i] + 0.5*h*a)
            p[3 + i] += h*a
            jump[i, 3 + i] = h
            jump[i, 7], jump[3 + i, 7] = -0.5*h*h*force[i], -h*force[i]
            for j in range(3):
                turning = pull*part/l1*((1.0 if i == j else 0.0) - e[i]*e[j])
                jump[i, j] += 0.5*h*h*turning
                jump[3 + i, j] = h*turning
        for i in range(STATES):
            for j in range(STATES):
                total = 0.0
                for k in range(STATES):
                    total += jump[i, k]*cov[row, k, j]
                work[i, j] = total
        for i in range(STATES):
            for j in range(STATES):
                total = 0.0
                for k in range(STATES):
                    total += work[i, k]*jump[j, k]
                cov[row, i, j] = total
        for i in range(3):
            cov[row, 3 + i, 3 + i] += h*(density/mass)**2


@compiled
def correct(x, cov, z, sigma, along, length, gate, patience, missed):
    """
    Take measurements (N, 3), NaN where there is none, in place.

    One whose innovation squared is above `gate` times its variance is left out and counted in
    `missed` (N, 3); after `patience` of them in a row the covariance is widened until it is within,
    and `missed` is ANEW.

    `sigma` (3,) is their noise, `along` (2,) the direction of the baseline in the orbit plane,
    `length` its assumed value now [m].
    """
    slope = np.zeros(STATES)
    for row in range(len(x)):
        p = x[row]
        for which in range(3):
            if not np.isfinite(z[row, which]):
                continue
            slope[:] = 0.0
            sx = (length + p[6])*along[0] - p[0]
            sy, sz = (length + p[6])*along[1] - p[1], -p[2]
            flat = sqrt(sx*sx + sy*sy)
            far = flat*flat + sz*sz
            if which == 0:
                size = sqrt(p[0]*p[0] + p[1]*p[1] + p[2]*p[2])
                said = size
                slope[0], slope[1], slope[2] = p[0]/size, p[1]/size, p[2]/size
            elif which == 1:
                said = atan2(sy, sx)
                tx, ty = -sy/(flat*flat), sx/(flat*flat)
                slope[0], slope[1], slope[6] = -tx, -ty, tx*along[0] + ty*along[1]
            else:
                said = atan2(sz, flat)
                tx, ty, tz = -sz*sx/(flat*far), -sz*sy/(flat*far), flat/far
                slope[0], slope[1], slope[2] = -tx, -ty, -tz
                slope[6] = tx*along[0] + ty*along[1]
            spread, gain = sigma[which]*sigma[which], np.zeros(STATES)
            for i in range(STATES):
                for j in range(STATES):
                    gain[i] += cov[row, i, j]*slope[j]
            for i in range(STATES):
                spread += slope[i]*gain[i]
            off = z[row, which] - said
            if not off*off <= gate*spread:
                missed[row, which] = max(missed[row, which], 0) + 1
                if missed[row, which] <= patience or not off*off < np.inf:
                    continue
                wider = off*off/(gate*spread)
                for i in range(STATES):
                    for j in range(STATES):
                        cov[row, i, j] *= wider
                    gain[i] *= wider
                spread = wider*(spread - sigma[which]*sigma[which]) + sigma[which]*sigma[which]
                missed[row, which] = ANEW
            else:
                missed[row, which] = 0
            for i in range(STATES):
                p[i] += gain[i]*off/spread
            for i in range(STATES):
                for j in range(i, STATES):
                    left = cov[row, i, j] - gain[i]*gain[j]/spread
                    cov[row, i, j], cov[row, j, i] = left, left


class Observer:
    """The filter of N rows; called once per step, in order."""

    def __init__(self, settings: ObserverParams, orbit: OrbitParams, gripper: GripperParams,
                 tether: TetherParams, approach: ApproachParams, step_s: float, rows: int) -> None:
        self._orbit, self._h = orbit, step_s
        self._mass, self._stiffness = gripper.mass_kg, tether.stiffness_n
        self._length, self._density = approach.baseline_m, settings.force_sigma_n_rt_s
        self._sigma = np.array([settings.encoder_sigma_m, *[settings.bearing_sigma_rad]*2])
        start = approach.initial(orbit.at(0.0).rate)
        self.state = np.tile([*start[:6], 0.0, 0.0], (rows, 1))
        spread = np.array([*[1e-3]*3, *[settings.release_sigma_m_s]*3, settings.baseline_sigma_m,
                           settings.mass_sigma])
        self.covariance = np.tile(np.diag(spread*spread), (rows, 1, 1))
        self._command = np.tile([tether.least_n, *[0.0]*6], (rows, 1))
        self._gate, self._patience = settings.gate_nis, settings.gate_patience
        self._missed = np.zeros((rows, 3), dtype=np.int64)
        self._seen = np.zeros((rows, 3), dtype=bool)

    def take(self, k: int, seen: NDArray) -> NDArray[np.float64]:
        """Return what should be seen (N, 3): length and angles, after those of step k (N, 3)."""
        if k > 0:
            now, start = self._orbit.at((k - 0.5)*self._h), self._orbit.at(0.0)
            turn = now.anomaly - start.anomaly
            g = self._orbit.gravitational_parameter_m3_s2/(now.radius*now.radius*now.radius)
            predict(self.state, self.covariance, self._command,
                    np.array([g, np.sin(turn), np.cos(turn)]), self._mass, self._density, self._h)
        stretch = 1.0 + self._command[:, 0]/self._stiffness
        now, start = self._orbit.at(k*self._h), self._orbit.at(0.0)
        self._seen = np.isfinite(seen)
        turn, size = now.anomaly - start.anomaly, self._length*now.radius/start.radius
        along = np.array([np.cos(turn), np.sin(turn)])
        correct(self.state, self.covariance, np.stack(
            [seen[:, 0]*stretch, seen[:, 1], seen[:, 2]], axis=-1), self._sigma, along, size,
            self._gate, self._patience, self._missed)
        r = self.state[:, :3]
        length = np.sqrt(r[:, 0]*r[:, 0] + r[:, 1]*r[:, 1] + r[:, 2]*r[:, 2])
        x, y = (size + self.state[:, 6])*along[0] - r[:, 0], (
            size + self.state[:, 6])*along[1] - r[:, 1]
        return np.stack([length/stretch, np.arctan2(y, x),
                         np.arctan2(-r[:, 2], np.sqrt(x*x + y*y))], axis=-1)

    def sent(self, commands: NDArray) -> None:
        """Note the commands (N, 7) of this step, which act until the next one."""
        self._command = np.ascontiguousarray(commands)

    def news(self) -> News:
        """Return which measurements, of any row, were taken last although they were outliers."""
        anew = self._seen & (self._missed == ANEW)
        if not anew.any():
            return []
        return [begun_anew(MEASURED[i], self._patience) for i in np.flatnonzero(anew.any(axis=0))]


def shifted(place: NDArray, target: NDArray, error: NDArray, part: float) -> NDArray[np.float64]:
    """
    Return length, alpha, beta and range (N, 4) of the plan for baselines that are off.

    The planned place (3,) moves along the baseline by a part of each error (N,) [m], the target
    (3,) by all of it.
    """
    along = target/np.sqrt((target*target).sum())
    there = place + part*error[:, np.newaxis]*along
    sight = target + error[:, np.newaxis]*along - there
    x, y, z = sight[:, 0], sight[:, 1], sight[:, 2]
    flat = np.sqrt(x*x + y*y)
    return np.stack([np.sqrt((there*there).sum(axis=-1)), np.arctan2(y, x), np.arctan2(z, flat),
                     np.sqrt(flat*flat + z*z)], axis=-1)
