"""
What the thrusters really do: valves that take their time, thrust that is never quite the same.

Model   a command holds over a base step. A valve stays open for a least time; thrust follows it
        after a delay, by a first-order lag; each pulse has an amplitude of its own, each thruster
        a fixed error of direction. A failure holds from a step on: stuck off, stuck on, or weak.
Valid   constant specific impulse and mass; no supply pressure, no plume.
Source  An, Qu, Wang 2015, section 2.2: a first-order lag, delay, least on-time, random amplitude,
        four groups. They print no number.

numba is imported with the first object that is made.
"""

from dataclasses import dataclass
from functools import lru_cache
from math import ceil
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.thruster_set import ThrusterSet
from rvd_dynamics.diagram.params import param, settings

Array = NDArray[np.float64]
G0 = 9.80665                            # [m/s^2] standard gravity, of the specific impulse
PULSES = 128                            # amplitudes drawn for each thruster, used in turn
DRAWS = 2 + PULSES                      # normals of each thruster of a run
KINDS = {'sound': 0, 'stuck_off': 1, 'stuck_on': 2, 'weak': 3}


@settings
class ThrusterParams:
    """How thrusters answer a command."""

    lag_s: float = param(0.010, 'Time constant with which thrust follows its valve [s].',
                         above=0.0, high=1.0)
    delay_s: float = param(0.015, 'Delay between a command and its valve [s].', low=0.0, high=1.0)
    least_on_s: float = param(
        0.040, 'Least time for which a valve stays open [s].', low=0.0, high=10.0)
    amplitude_sigma: float = param(
        0.025, 'Standard deviation of the thrust of a pulse, as a fraction of the nominal one.',
        low=0.0, high=0.3)
    direction_sigma: float = param(
        0.01, 'Standard deviation of each of the two errors of a thruster\'s direction [rad].',
        low=0.0, high=0.3)
    specific_impulse_s: float = param(290.0, 'Specific impulse [s].', above=0.0, high=1e4)


@dataclass(frozen=True)
class Failure:
    """
    One thruster, or one in each row (N,), that fails at a step.

    `kind` of KINDS; `factor` is what a weak one keeps.
    """

    thruster: int | NDArray[np.int64]
    kind: str
    step: int = 0
    factor: float = 0.5


class Fired(NamedTuple):
    """What thrusters did over a step; rows N."""

    wrench: Array               # (N, 2 K + 1, 6) force and torque at the nodes of K sub-steps
    mean: Array                 # (N, T) mean thrust of each as a fraction of its nominal one
    spent: Array                # (N,) propellant [kg]


class ReactionControl:
    """
    Thrusters of N rows and what they remember.

    Parameters
    ----------
    thrusters : ThrusterSet
    settings : ThrusterParams
    step_s, sub_steps
        Base step [s], and the number K of the plant's steps in it.
    normals : array_like, shape (N, T * DRAWS)
        Standard normal draws: two errors of direction and PULSES amplitudes for each thruster.
    centre : array_like, shape (..., 3)
        True centre of mass [m].
    scale : array_like, shape (N, T), (N,) or ()
        True thrust as a fraction of the nominal one.
    failures : tuple of Failure
    """

    def __init__(self, thrusters: ThrusterSet, settings: ThrusterParams, step_s: float,
                 sub_steps: int, normals: ArrayLike, centre: ArrayLike = (0.0, 0.0, 0.0),
                 scale: ArrayLike = 1.0, failures: tuple[Failure, ...] = ()) -> None:
        count = len(thrusters)
        normals = np.asarray(normals, dtype=float)
        rows = len(normals)
        drawn = normals.reshape(rows, count, DRAWS)
        self._flow = thrusters.force/(settings.specific_impulse_s*G0)          # [kg/s]
        self._step_s = step_s
        self._columns = _columns(thrusters, settings.direction_sigma*drawn[..., :2], centre)
        scale = np.asarray(scale, dtype=float)
        if scale.ndim < 2:
            scale = np.broadcast_to(scale, (rows,))[:, np.newaxis]
        self._amplitudes = np.maximum(scale[:, :, np.newaxis]*(
            1.0 + settings.amplitude_sigma*drawn[..., 2:]), 0.0)
        self._kinds, self._since, self._factor = _failing(failures, rows, count)
        self._least_on = ceil(settings.least_on_s/step_s - 1e-9)
        whole, rest = divmod(settings.delay_s + 1e-12, step_s)
        rest = 0.0 if rest < 1e-9 else rest
        times = np.arange(2*sub_steps + 1)*step_s/(2*sub_steps)
        self._early = np.exp(-times/settings.lag_s)
        self._late = np.exp(-np.maximum(times - rest, 0.0)/settings.lag_s)
        self._switch = int(np.searchsorted(times, rest))
        self._lag = (settings.lag_s, rest)
        self._opened = np.zeros((rows, count), dtype=np.int64)
        self._line = np.zeros((rows, int(whole) + 2, count))
        self._thrust, self._amplitude = np.zeros((2, rows, count))
        self.pulses = np.zeros((rows, count), dtype=np.int64)

    def step(self, k: int, command: ArrayLike) -> Fired:
        """Carry all over step k under a command (N, T), true where a valve is to be open."""
        command = np.ascontiguousarray(command, dtype=bool)
        wrench, mean, spent = _compiled().fire(
            command, self._opened, self._line, self._thrust, self._amplitude, self.pulses,
            self._amplitudes, self._kinds, self._since, self._factor, k, self._least_on,
            self._columns, self._early, self._late, self._switch, self._lag, self._step_s,
            self._flow)
        return Fired(wrench, mean, spent)


def _columns(thrusters: ThrusterSet, tilt: Array, centre: ArrayLike) -> Array:
    """Return the wrench of each thruster (N, T, 6), its direction tilted by two small angles."""
    d = thrusters.directions
    other = np.where(np.abs(d[:, :1]) < 0.9, [1.0, 0.0, 0.0], [0.0, 1.0, 0.0])
    u = np.cross(d, other)
    u /= np.sqrt(np.sum(u*u, axis=1))[:, np.newaxis]
    w = np.cross(d, u)
    push = d + tilt[..., 0:1]*u + tilt[..., 1:2]*w
    push *= thrusters.force[:, np.newaxis]/np.sqrt(np.sum(push*push, axis=-1))[..., np.newaxis]
    arm = thrusters.places - np.asarray(centre, dtype=float)[..., np.newaxis, :]
    return np.concatenate([push, np.cross(arm, push)], axis=-1)


def _failing(failures: tuple[Failure, ...], rows: int, count: int) -> tuple:
    """Return kind, first step and factor of each thruster (N, T)."""
    kinds, since = np.zeros((2, rows, count), dtype=np.int64)
    factor = np.ones((rows, count))
    for failure in failures:
        which = np.broadcast_to(failure.thruster, (rows,))
        if not np.all((which >= 0) & (which < count)):
            raise BadInput(f'failure: thruster must be between 0 and {count - 1}, '
                           f'got {failure.thruster}')
        if failure.kind not in KINDS:
            raise BadInput(f'failure: kind must be one of {", ".join(KINDS)}, '
                           f'got {failure.kind!r}')
        at = np.arange(rows), which
        kinds[at], since[at], factor[at] = KINDS[failure.kind], failure.step, failure.factor
    return kinds, since, factor


@lru_cache(maxsize=1)
def _compiled() -> Any:
    from rvd_dynamics.world.spacecraft import reaction_control_compiled     # numba
    return reaction_control_compiled
