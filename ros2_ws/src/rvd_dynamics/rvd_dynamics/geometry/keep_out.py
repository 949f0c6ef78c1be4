"""
Keep-out spheres behind a delay: from which states a chaser can still stop short of them.

Frame   target orbital. In here components come first: positions and velocities (3, ...) [m, m/s].
Stop    each axis brakes by itself at a deceleration a_i that it surely has:
        p_i(t) = p_i + v_i s - sign(v_i) a_i s^2 / 2,   s = min(t, |v_i| / a_i).
Body    sphere k, widened along each axis by the box E: the points whose distance from the box
        about the centre is below R_k. It is the set of centres that a point known to within E may
        have touched, exactly, and it is convex.
Safe    is a state whose whole stop stays outside all bodies. Source: docs/cluttered.md.
"""

from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.form import CommandForm
from rvd_dynamics.commands.levels import HIGHEST
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.motion import cw

Array = NDArray[np.float64]
SAMPLES = 24                            # of a stop, after its beginning
SLACK_M = 0.01                          # [m] for what lies between samples, and for whole levels
FASTEST_M_S = 0.3                       # [m/s] for which the Coriolis term is allowed for
WEAKER = 0.05                           # share of the thrust that may be missing


@settings
class StopParams:
    """What the ground counts on when it plans to stop short of an obstacle."""

    brake_level: int = param(
        2, 'Level of each axis that a stop counts on.', low=1, high=3)
    error_sigmas: float = param(
        4.0, 'Error of the prediction that is allowed for, in its standard deviations.', low=0.0,
        high=10.0)
    lost_commands: int = param(
        1, 'Commands of the highest level that may be lost within one loop delay.', low=0, high=20)
    first_error_m: tuple = param(
        (1.0, 0.05, 0.05), 'Error of the first prediction along x, y and z for which a feasible '
        'start leaves room [m].', low=0.0, high=100.0, length=3)


class Stop(NamedTuple):
    """How a chaser stops: what `StopParams` mean for its thrust, orbit and delay."""

    decelerations: Array                # (3,) a_i [m/s^2]
    brake_level: int
    lost_m_s: Array                     # (3,) what lost commands may change of the rate [m/s]
    error_sigmas: float
    first_error_m: Array                # (3,)
    loop_s: float                       # [s] loop delay
    learn_s: float                      # [s] until commands take into account that one was lost

    def box(self, sigma: Array, velocity: Array) -> Array:
        """
        Return E (3, ...) [m] for standard deviations (6, ...) of a predicted state.

        An error of the rate, too, moves the place of the stop: by itself times the time it takes.
        A command that is lost is an error of both, of which the ground learns a loop delay later.
        """
        brake = _tailed(self.decelerations, velocity)
        lost, time = _tailed(self.lost_m_s, velocity), np.abs(velocity) / brake
        error = self.error_sigmas * (sigma[:3] + sigma[3:]*time)
        return error + lost*(self.learn_s + time + lost/(2.0*brake))


def stop_of(params: StopParams, form: CommandForm, mean_motion: float, step_s: float,
            loop_s: float) -> Stop:
    """
    Return how a chaser with whole thrust levels stops.

    Raises
    ------
    ValueError
        If the brake level is weaker than what the orbit pulls.
    """
    level = form.effect(np.full(3, params.brake_level, dtype=np.int8))
    drift = 2.0 * mean_motion * FASTEST_M_S
    decelerations = level * (1.0 - WEAKER) - drift
    require(bool(np.all(decelerations > 0.0)), 'brake_level',
            f'give more than {drift/(1.0 - WEAKER):.3g} m/s^2, what the orbit takes from a stop',
            f'level {params.brake_level} of {level.tolist()} m/s^2')
    highest = form.effect(np.full(3, HIGHEST, dtype=np.int8))
    return Stop(decelerations, params.brake_level, params.lost_commands * highest * step_s,
                params.error_sigmas, np.array(params.first_error_m), loop_s,
                loop_s + 2.0*step_s)


def times(velocity: Array, decelerations: Array) -> Array:
    """Return sample times (SAMPLES + 1, ...) of stops from (3, ...), about even in distance [s]."""
    longest = (np.abs(velocity) / _tailed(decelerations, velocity)).max(axis=0)
    share = 1.0 - np.sqrt(1.0 - np.arange(SAMPLES + 1) / SAMPLES)
    return share.reshape(-1, *[1]*longest.ndim) * longest


def stopping(position: Array, velocity: Array, deceleration: ArrayLike, at_s: Array) -> Array:
    """Return where one axis of a stop is at times [s]; shapes broadcast."""
    s = np.minimum(at_s, np.abs(velocity) / deceleration)
    return position + (velocity - np.sign(velocity) * (0.5*deceleration) * s) * s


def beyond(position: Array, place: ArrayLike, box: ArrayLike) -> Array:
    """Return the square of what one axis is outside the box about a place [m^2]."""
    out = np.maximum(np.abs(position - place) - box, 0.0)
    return out * out


def room(state: Array, places: Array, radii: Array, box: Array, stop: Stop) -> Array:
    """
    Return how far a stop from states stays outside all bodies, shape (n,); negative: inside.

    Parameters
    ----------
    state : ndarray, shape (6, n)
    places : ndarray, shape (M, 3, n)
    radii : ndarray, shape (M,)
    box : ndarray, shape (3, n)
        E.
    stop : Stop
    """
    at_s = times(state[3:], stop.decelerations)
    path = [stopping(state[i], state[3 + i], stop.decelerations[i], at_s) for i in range(3)]
    least = np.full(state.shape[1], np.inf)
    for place, radius in zip(places, radii):
        square = sum(beyond(path[i], place[i], box[i]) for i in range(3))
        np.minimum(least, np.sqrt(square.min(axis=0)) - radius, out=least)
    return least - SLACK_M


def start_room(state: ArrayLike, places: Array, radii: Array, stop: Stop, mean_motion: float,
               step_s: float) -> Array:
    """
    Return the room [m] of starts: from one that is not negative no contact is forced.

    A start is feasible if the chaser, without thrust, touches nothing until the first command that
    knows of it acts, one loop delay later, and if it can then be stopped although the ground is
    wrong by `first_error_m`: seen from the prediction, it must be able to stop although the truth
    is elsewhere, hence twice the box.

    Parameters
    ----------
    state : array_like, shape (..., 6)
        True states at the start.
    places : ndarray, shape (..., M, 3)
    radii : ndarray, shape (M,)

    Returns
    -------
    ndarray, shape (...)
    """
    state = np.asarray(state, dtype=float)
    batch = state.shape[:-1]
    now = np.ascontiguousarray(state.reshape(-1, 6).T)
    where = np.moveaxis(np.broadcast_to(places, (*batch, *places.shape[-2:])).reshape(
        -1, *places.shape[-2:]), 0, -1)
    phi = cw.transition(mean_motion, step_s)
    least = np.full(now.shape[1], np.inf)
    for step in range(round(stop.loop_s / step_s) + 1):
        if step:
            now = cw.product(phi, now.T).T
        for place, radius in zip(where, radii):
            x, y, z = now[:3] - place
            np.minimum(least, np.sqrt(x*x + y*y + z*z) - radius - SLACK_M, out=least)
    lost = stop.box(np.zeros_like(now), now[3:])
    box = 2.0 * (stop.first_error_m[:, None] + lost)
    return np.minimum(least, room(now, where, radii, box, stop)).reshape(batch)


def _tailed(vector: Array, like: Array) -> Array:
    """Return (3,) with as many axes after it as `like` has."""
    return vector.reshape(3, *[1]*(like.ndim - 1))
