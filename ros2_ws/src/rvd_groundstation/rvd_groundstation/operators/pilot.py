"""
Stochastic pilot: looks at the displays, decides in pulses, errs, and loses attention.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes, one
        pilot each. Inside, components come first: (6, n), axes x, y, z in this order.
Chance  comes as whole-run draws (`rvd_dynamics.diagram.streams.PilotDraws`): ten normals N0..N9 and
        six uniforms U0..U5 per step, used or not, so that a pilot in another condition draws
        the same numbers.
Source  the paper (Zhang, Li, Tang 2014) flew ten students and states no model. Every number
        here is ours: fitted to its condition 1 (manual, success .76) and to nothing else.
        docs/models/pilot.md tells how, and what agreement does not prove.

Instants are counted in steps: next decisions are real numbers of steps, compared with whole
ones by a margin far above their rounding, so that 4 s are 80 steps of 0.05 s exactly.
"""

from dataclasses import dataclass, fields
from math import exp, inf, prod, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.geometry.cone import radius
from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.params import param, require
from rvd_dynamics.diagram.streams import PilotDraws

Array = NDArray[np.float64]
MARGIN = 1e-6                           # [steps] far above rounding, far below a step
TINIEST = np.finfo(float).tiny          # a uniform of 0 would make an endless lapse


@dataclass(frozen=True)
class PilotParams:
    """Settings of the pilot model; the defaults are pilot A of `PILOTS`."""

    skill_gain: float = param(1.635, 'Errors of the median pilot, as a multiple.')
    skill_spread: float = param(0.35, 'Deviation of the logarithm of that multiple.')
    runs_per_operator: int = param(1, 'So many runs in a row are flown by one person.')
    display: bool = param(True, 'Whether the pilot sees the predicted state.')
    display_trust: float = param(0.9, 'Share of the loop that a perfect pilot sees ahead.')
    no_display_trust: float = param(0.602, 'Share that he imagines without the display.')
    reaction_s: float = param(1.0, 'Displays are seen so late [s].')
    position_bias_m: float = param(0.010, 'Deviation of the perceived offset at the target [m].')
    position_bias_per_m: float = param(0.004, 'What each metre of range adds to it.')
    rate_bias_m_s: float = param(0.006, 'Deviation of the perceived rates [m/s].')
    bias_time_s: float = param(15.0, 'Correlation time of these errors [s].')
    rate_threshold_m_s: float = param(0.003, 'Slower lateral motion is not seen [m/s].')
    dead_zone_fraction: float = param(0.1, 'Offset that is let be, of the corridor radius.')
    lead_fraction: float = param(0.35, 'Offsets shall vanish in this share of the time to go,')
    lead_min_s: float = param(6.0, 'but not faster [s]')
    lead_max_s: float = param(15.0, 'nor slower [s].')
    max_rate_m_s: float = param(0.06, 'Fastest lateral rate he asks for [m/s].')
    rate_error_m_s: float = param(0.016, 'Lateral rate error that makes him act [m/s].')
    decision_interval_s: float = param(4.0, 'Median time between decisions of an axis [s].')
    decision_spread: float = param(0.35, 'Deviation of its logarithm.')
    idle_interval_fraction: float = param(0.6, 'He looks again sooner when he did not act.')
    pulse_gain: float = param(0.9, 'Median velocity change that he makes, of the one he wants.')
    pulse_spread: float = param(0.25, 'Deviation of its logarithm.')
    level_2_m_s: float = param(0.015, 'Velocity changes above take level 2 [m/s],')
    level_3_m_s: float = param(0.03, 'above this level 3 [m/s].')
    pulse_min_s: float = param(1.5, 'Shortest lateral pulse [s].')
    pulse_max_s: float = param(5.0, 'Longest lateral pulse [s].')
    slip_fraction: float = param(0.01, 'Pulses to the wrong side, of all.')
    closing_rate_m_s: float = param(0.25, 'Closing rate that he keeps [m/s].')
    closing_error_m_s: float = param(0.03, 'Closing rate error that makes him act [m/s].')
    closing_pulse_s: float = param(1.0, 'Length of his pulses along x, at level 1 [s].')
    closing_interval_s: float = param(8.0, 'Time between decisions along x [s].')
    lapse_interval_s: float = param(120.0, 'Mean time between lapses of attention [s].')
    lapse_s: float = param(8.0, 'Mean length of a lapse [s].')

    def __post_init__(self) -> None:
        positive = ('skill_gain', 'runs_per_operator', 'bias_time_s', 'lead_min_s',
                    'closing_rate_m_s', 'lapse_interval_s')
        for f in fields(self):
            value = getattr(self, f.name)
            if f.name in positive:
                require(0.0 < value < inf, f.name, 'be positive', value)
            else:
                require(0.0 <= value < inf, f.name, 'be a number, not negative', value)
        for low, high in (('lead_min_s', 'lead_max_s'), ('level_2_m_s', 'level_3_m_s'),
                          ('pulse_min_s', 'pulse_max_s')):
            require(getattr(self, low) <= getattr(self, high), high, f'not be below {low}',
                    getattr(self, high))

    def operator_of(self, run: int) -> int:
        """Return who flies a run: the key of his `skill_normal`."""
        return run // self.runs_per_operator


PILOTS = {
    'A': PilotParams(),
    'B': PilotParams(skill_gain=1.0, display=False),    # with the display only in condition 2
    'C': PilotParams(skill_gain=1.77, skill_spread=0.20),
}


class Pilot:
    """One pilot per row of the batch; called once per step, in order."""

    def __init__(self, params: PilotParams, mission: Mission, draws: PilotDraws,
                 skill_normal: ArrayLike, batch: tuple = ()) -> None:
        """
        Sit down with neutral stick.

        Parameters
        ----------
        params : PilotParams
        mission : Mission
        draws : PilotDraws
            Of the run, with leading axes `batch`.
        skill_normal : array_like, shape `batch`
            Standard normal of the person's skill.
        batch : tuple
            Shape of the leading axes.
        """
        n = prod(batch)
        self._params, self._mission, self._batch = params, mission, batch
        self._per_s = 1.0 / mission.step_s                      # steps per second
        self._normals = draws.normals.reshape(n, -1, 10)
        self._uniforms = draws.uniforms.reshape(n, -1, 6)
        skill = np.asarray(skill_normal, dtype=float).reshape(n)
        self._gain = params.skill_gain * np.exp(params.skill_spread * skill)
        trust = params.display_trust if params.display else params.no_display_trust
        self._trust = np.clip(1.0 - (1.0 - trust)*self._gain, 0.0, 1.0)
        self._bias = np.ascontiguousarray(draws.initial_normals.reshape(n, 6).T)
        self._keep = exp(-mission.step_s / params.bias_time_s)
        self._shock = sqrt(1.0 - self._keep*self._keep)
        first = draws.initial_uniforms.reshape(n, 3).T
        self._decide_at = params.decision_interval_s*self._per_s * first     # (3, n) [steps]
        self._pulse_end = np.zeros((3, n))                                   # [steps]
        self._pulse = np.zeros((3, n))                                       # level
        self._lapse_end = np.zeros(n)                                        # [steps]
        late = round(params.reaction_s * self._per_s)
        self._displays = np.full((late + 1, 6, n), np.nan)      # ring: what was shown when
        self._seen = np.zeros(n, dtype=bool)
        steps = np.rint(np.array([params.pulse_min_s, params.pulse_max_s]) * self._per_s)
        self._shortest, self._longest = max(steps[0], 1.0), max(steps[1], 1.0)
        self._closing_pulse = max(round(params.closing_pulse_s * self._per_s), 1)

    def advance(self, step: int, estimate: ArrayLike, predicted: ArrayLike,
                valid: ArrayLike) -> NDArray[np.int8]:
        """
        Return where the stick is in this step.

        Parameters
        ----------
        step : int
            0, 1, 2, ... in order.
        estimate : array_like, shape (..., 6)
            What the display of the telemetry shows: the state as it was.
        predicted : array_like, shape (..., 6)
            What the display of the prediction shows: the state when a command will act.
        valid : array_like of bool, shape (...)
            Rows in which both are known; in the others the last displays stand.

        Returns
        -------
        ndarray of int8, shape (..., 3)
            Levels -3..3; the stick is neutral until the first displays.
        """
        normals = np.ascontiguousarray(self._normals[:, step].T)
        uniforms = np.ascontiguousarray(self._uniforms[:, step].T)
        self._bias = self._keep*self._bias + self._shock*normals[:6]
        shown = self._look(step, estimate, predicted, valid)
        awake = self._awake(step, uniforms) & self._seen
        ready = awake & (step >= self._decide_at - MARGIN) & (step >= self._pulse_end)
        self._decide_closing(step, ready[0], shown)
        self._decide_lateral(step, ready[1:], shown, normals, uniforms)
        levels = np.where(step < self._pulse_end, self._pulse, 0.0)
        return levels.astype(np.int8).T.reshape(*self._batch, 3)

    def _look(self, step: int, estimate: ArrayLike, predicted: ArrayLike,
              valid: ArrayLike) -> Array:
        """Return (6, n) what the pilot makes of the displays of one reaction time ago."""
        valid = np.asarray(valid, dtype=bool).reshape(-1)
        d = np.ascontiguousarray(np.reshape(estimate, (-1, 6)).T)
        p = np.ascontiguousarray(np.reshape(predicted, (-1, 6)).T)
        ring = self._displays
        last = ring[(step - 1) % len(ring)]
        now = np.where(valid, d + self._trust*(p - d), last)
        ring[step % len(ring)] = now
        first = valid & ~self._seen
        if first.any():                                 # before that, the first sample
            ring[:, :, first] = now[:, first]
            self._seen = self._seen | valid
        return ring[(step + 1) % len(ring)]

    def _awake(self, step: int, uniforms: Array) -> NDArray[np.bool_]:
        """Return who is attentive; a lapse may begin in any step outside one."""
        chance = self._gain * (self._mission.step_s / self._params.lapse_interval_s)
        begins = (step >= self._lapse_end) & (uniforms[0] < chance)
        if begins.any():
            length = self._params.lapse_s*self._per_s * -np.log(np.maximum(uniforms[1], TINIEST))
            self._lapse_end = np.where(begins, step + length, self._lapse_end)
        return step >= self._lapse_end

    def _decide_closing(self, step: int, ready: NDArray[np.bool_], shown: Array) -> None:
        """Keep the closing rate: level 1 against an error that is large enough to see."""
        p, who = self._params, np.flatnonzero(ready)
        error = (shown[3, who] - p.closing_rate_m_s
                 + self._gain[who]*(p.rate_bias_m_s*self._bias[3, who]))
        acts = np.abs(error) > p.closing_error_m_s
        self._start_pulse(step, who[acts], -np.sign(error[acts]), self._closing_pulse)
        self._decide_at[0, who] = step + p.closing_interval_s*self._per_s

    def _decide_lateral(self, step: int, ready: NDArray[np.bool_], shown: Array,
                        normals: Array, uniforms: Array) -> None:
        """
        Bring y and z, each by itself, towards the axis in pulses.

        Few axes decide in a step: arrays are (m,), one entry for each that does, and `at` is
        its place when the y of all pilots is followed by the z of all.
        """
        at = np.flatnonzero(ready)
        if at.size == 0:
            return
        p, who = self._params, at % ready.shape[1]
        error = self._rate_error(shown, at, who)
        size = np.abs(error)
        change = p.pulse_gain*np.exp(p.pulse_spread*_at(normals[7:9], at)) * size   # N7 y, N8 z
        first, second, third = self._mission.thrust.lateral_m_s2
        above_2, above_3 = change > p.level_2_m_s, change > p.level_3_m_s
        level = 1.0 + above_2 + above_3
        accel = np.where(above_3, third, np.where(above_2, second, first))
        steps = np.rint(change * self._per_s / accel)
        steps = np.minimum(np.maximum(steps, self._shortest), self._longest)
        slips = _at(uniforms[2:4], at) < p.slip_fraction*self._gain[who]            # U2 y, U3 z
        side = np.where(slips, -np.sign(error), np.sign(error))
        acts = size > p.rate_error_m_s
        lateral = at + ready.shape[1]                           # place when x comes before y
        self._start_pulse(step, lateral[acts], (side*level)[acts], steps[acts])
        pause = p.decision_interval_s*self._per_s * np.exp(p.decision_spread*normals[9, who])
        again = np.where(acts, pause + steps, p.idle_interval_fraction*pause)
        np.put(self._decide_at, lateral, step + again)

    def _rate_error(self, shown: Array, at: NDArray[np.int64], who: NDArray[np.int64]) -> Array:
        """Return the lateral rate that is wanted minus the one perceived, (m,) [m/s]."""
        p, corridor, gain = self._params, self._mission.corridor, self._gain[who]
        to_go = np.maximum(-shown[0, who], 0.0)
        blur = gain * (p.position_bias_m + p.position_bias_per_m*to_go)
        offset = _at(shown[1:3], at) + blur*_at(self._bias[1:3], at)
        rate = _at(shown[4:6], at) + gain*(p.rate_bias_m_s*_at(self._bias[4:6], at))
        rate = np.where(np.abs(rate) < p.rate_threshold_m_s, 0.0, rate)
        dead_zone = p.dead_zone_fraction * radius(-to_go, corridor)     # it shrinks on the way
        excess = np.sign(offset) * np.maximum(np.abs(offset) - dead_zone, 0.0)
        lead = p.lead_fraction/p.closing_rate_m_s * to_go
        lead = np.minimum(np.maximum(lead, p.lead_min_s), p.lead_max_s)
        wanted = np.minimum(np.maximum(-excess/lead, -p.max_rate_m_s), p.max_rate_m_s)
        return wanted - rate

    def _start_pulse(self, step: int, at: NDArray[np.int64], level: Array,
                     steps: ArrayLike) -> None:
        np.put(self._pulse_end, at, step + steps)
        np.put(self._pulse, at, level)


def _at(rows: Array, at: NDArray[np.int64]) -> Array:
    """Return the elements (m,) of `rows` (2, n) at their places in a row."""
    return rows.reshape(-1)[at]
