"""
Pilot who looks at the displays, acts in pulses by habit, makes errors and loses attention.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes, one
        pilot each. Inside, components come first: (6, n), axes x, y, z in this order.
Chance  comes as whole-run draws (`rvd_dynamics.diagram.streams.PilotDraws`): ten normals
        N0..N9 and six uniforms U0..U5 per step, used or not, so that a pilot in another
        condition draws the same numbers.
Source  the paper (Zhang, Li, Tang 2014) flew ten students and states no model. Every number
        here is ours: fitted to its condition 1 (manual, success .76) and to nothing else.
        docs/models/pilot.md says how, and what agreement does not prove.

Instants are counted in steps: the next decision is due at a real number of steps, compared with
whole steps by a margin far above rounding, so that 4 s are exactly 80 steps of 0.05 s.
"""

from math import exp, prod, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.levels import ThrustParams
from rvd_dynamics.geometry.cone import Cone, radius
from rvd_dynamics.diagram.params import param, require, settings, wiring
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.streams import PilotDraws

Array = NDArray[np.float64]
MARGIN = 1e-6                           # [steps] far above rounding, far below a step
TINIEST = np.finfo(float).tiny          # a uniform of 0 would give an endless lapse


@settings
class Pulses:
    """Pulses by habit; the defaults are pilot A of `PERSONS`."""

    run: Run = wiring()
    cone: Cone = wiring()
    thrust: ThrustParams = wiring()

    skill_gain: float = param(
        1.635, 'Skill factor of the median pilot, which multiplies errors, slips and lapses.',
        above=0.0)
    skill_spread: float = param(
        0.35, 'Standard deviation of the logarithm of the skill factor from person to person.',
        low=0.0)
    display: bool = param(True, 'Whether the pilot sees the predicted state.')
    display_trust: float = param(
        0.9, 'How far a pilot of skill factor 1 looks ahead with the display, as a fraction of '
        'the way from the estimate to the prediction.', low=0.0)
    no_display_trust: float = param(
        0.602, 'How far a pilot of skill factor 1 looks ahead without the display, as a fraction '
        'of the way from the estimate to the prediction.', low=0.0)
    reaction_s: float = param(
        1.0, 'Delay with which the pilot perceives what the displays show [s].', low=0.0)
    position_bias_m: float = param(
        0.010, 'Standard deviation of the error in the perceived offset at zero range [m].',
        low=0.0)
    position_bias_per_m: float = param(
        0.004, 'Growth of the standard deviation of the error in the perceived offset per metre '
        'of range [m/m].', low=0.0)
    rate_bias_m_s: float = param(
        0.006, 'Standard deviation of the errors in the perceived rates [m/s].', low=0.0)
    bias_time_s: float = param(
        15.0, 'Correlation time of the perception errors [s].', above=0.0)
    rate_threshold_m_s: float = param(
        0.003, 'Lateral rate below which the pilot perceives no motion [m/s].', low=0.0)
    dead_zone_fraction: float = param(
        0.1, 'Lateral offset that the pilot leaves uncorrected, as a fraction of the corridor '
        'radius.', low=0.0)
    lead_fraction: float = param(
        0.35, 'Time in which the pilot means to remove an offset, as a fraction of the time to '
        'go.', low=0.0)
    lead_min_s: float = param(
        6.0, 'Shortest time in which the pilot means to remove an offset [s].', above=0.0)
    lead_max_s: float = param(
        15.0, 'Longest time in which the pilot means to remove an offset [s].', above=0.0)
    max_rate_m_s: float = param(
        0.06, 'Highest lateral rate that the pilot aims for [m/s].', low=0.0)
    rate_error_m_s: float = param(
        0.016, 'Lateral rate error above which the pilot acts [m/s].', low=0.0)
    decision_interval_s: float = param(
        4.0, 'Median time between decisions on one lateral axis [s].', low=0.0)
    decision_spread: float = param(
        0.35, 'Standard deviation of the logarithm of the time between decisions on one lateral '
        'axis.', low=0.0)
    idle_interval_fraction: float = param(
        0.6, 'Time to the next decision when the pilot did not act, as a fraction of the usual '
        'time between decisions.', low=0.0)
    pulse_gain: float = param(
        0.9, 'Median velocity change of a lateral pulse, as a fraction of the one needed.',
        low=0.0)
    pulse_spread: float = param(
        0.25, 'Standard deviation of the logarithm of the velocity change of a lateral pulse.',
        low=0.0)
    level_2_m_s: float = param(
        0.015, 'Velocity change above which a lateral pulse uses level 2 [m/s].', low=0.0)
    level_3_m_s: float = param(
        0.03, 'Velocity change above which a lateral pulse uses level 3 [m/s].', low=0.0)
    pulse_min_s: float = param(1.5, 'Shortest lateral pulse [s].', low=0.0)
    pulse_max_s: float = param(5.0, 'Longest lateral pulse [s].', low=0.0)
    slip_fraction: float = param(
        0.01, 'Fraction of the lateral pulses that a pilot of skill factor 1 makes in the wrong '
        'direction.', low=0.0)
    closing_rate_m_s: float = param(
        0.25, 'Closing rate that the pilot keeps [m/s].', above=0.0)
    closing_error_m_s: float = param(
        0.03, 'Closing rate error above which the pilot acts [m/s].', low=0.0)
    closing_pulse_s: float = param(
        1.0, 'Duration of a pulse along x, which is at level 1 [s].', low=0.0)
    closing_interval_s: float = param(
        8.0, 'Time between decisions along x [s].', low=0.0)
    lapse_interval_s: float = param(
        120.0, 'Mean time between lapses of attention of a pilot of skill factor 1 [s].',
        above=0.0)
    lapse_s: float = param(8.0, 'Mean duration of a lapse of attention [s].', low=0.0)

    def __post_init__(self) -> None:
        for low, high in (('lead_min_s', 'lead_max_s'), ('level_2_m_s', 'level_3_m_s'),
                          ('pulse_min_s', 'pulse_max_s')):
            require(getattr(self, low) <= getattr(self, high), high, f'not be below {low}',
                    getattr(self, high))

    @property
    def fitted_first(self) -> str:
        """Name of the number that stands for what makes a manual flight fail."""
        return 'skill_gain' if self.display else 'no_display_trust'

    @property
    def idle(self) -> tuple[str, ...]:
        """Names of the numbers that do nothing with these settings."""
        return ('no_display_trust',) if self.display else ('display_trust',)

    def flying(self, draws: PilotDraws, skill_normal: ArrayLike, batch: tuple = ()
               ) -> 'PulsesPilot':
        """Return one pilot per row of the batch; see `pilot.PilotForm`."""
        return PulsesPilot(self, self.run.step_s, self.cone, self.thrust, draws, skill_normal,
                           batch)


class PulsesPilot:
    """One pilot per row of the batch; called once per step, in order."""

    def __init__(self, params: Pulses, step_s: float, cone: Cone, thrust: ThrustParams,
                 draws: PilotDraws, skill_normal: ArrayLike, batch: tuple = ()) -> None:
        """
        Start with a neutral stick.

        Parameters
        ----------
        params : Pulses
        step_s : float
            Time between two calls [s].
        cone : Cone
            The corridor that the pilot keeps to.
        thrust : ThrustParams
            What the levels do.
        draws : PilotDraws
            Draws of the runs, with leading axes `batch`.
        skill_normal : array_like, shape `batch`
            Standard normal draw of each person's skill.
        batch : tuple
            Shape of the leading axes.
        """
        n = prod(batch)
        self._params, self._cone, self._batch = params, cone, batch
        self._step_s, self._lateral = step_s, thrust.lateral_m_s2
        self._per_s = 1.0 / step_s                      # steps per second
        self._normals = draws.normals.reshape(n, -1, 10)
        self._uniforms = draws.uniforms.reshape(n, -1, 6)
        skill = np.asarray(skill_normal, dtype=float).reshape(n)
        self._gain = params.skill_gain * np.exp(params.skill_spread * skill)
        trust = params.display_trust if params.display else params.no_display_trust
        self._trust = np.clip(1.0 - (1.0 - trust)*self._gain, 0.0, 1.0)
        self._bias = np.ascontiguousarray(draws.initial_normals.reshape(n, 6).T)
        self._keep = exp(-step_s / params.bias_time_s)
        self._shock = sqrt(1.0 - self._keep*self._keep)
        first = draws.initial_uniforms.reshape(n, 3).T
        self._decide_at = params.decision_interval_s*self._per_s * first     # (3, n) [steps]
        self._pulse_end = np.zeros((3, n))                                   # [steps]
        self._pulse = np.zeros((3, n))                                       # level
        self._lapse_end = np.zeros(n)                                        # [steps]
        late = round(params.reaction_s * self._per_s)
        self._displays = np.full((late + 1, 6, n), np.nan)      # ring buffer of what was shown
        self._seen = np.zeros(n, dtype=bool)
        steps = np.rint(np.array([params.pulse_min_s, params.pulse_max_s]) * self._per_s)
        self._shortest, self._longest = max(steps[0], 1.0), max(steps[1], 1.0)
        self._closing_pulse = max(round(params.closing_pulse_s * self._per_s), 1)

    def advance(self, step: int, estimate: ArrayLike, predicted: ArrayLike,
                valid: ArrayLike) -> NDArray[np.int8]:
        """Return the levels at which the stick stands in this step; see `pilot.Pilot`."""
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
        """Return what the pilot perceives, (6, n): the displays of one reaction time ago."""
        valid = np.asarray(valid, dtype=bool).reshape(-1)
        d = np.ascontiguousarray(np.reshape(estimate, (-1, 6)).T)
        p = np.ascontiguousarray(np.reshape(predicted, (-1, 6)).T)
        ring = self._displays
        last = ring[(step - 1) % len(ring)]
        now = np.where(valid, d + self._trust*(p - d), last)
        ring[step % len(ring)] = now
        first = valid & ~self._seen
        if first.any():                                 # until then, the first sample
            ring[:, :, first] = now[:, first]
            self._seen = self._seen | valid
        return ring[(step + 1) % len(ring)]

    def _awake(self, step: int, uniforms: Array) -> NDArray[np.bool_]:
        """Return who is attentive; a lapse may begin in any step outside one."""
        chance = self._gain * (self._step_s / self._params.lapse_interval_s)
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

        Few axes decide in a step, so arrays are (m,), one entry for each axis that does; `at` is
        its index when the y of all pilots is followed by the z of all.
        """
        at = np.flatnonzero(ready)
        if at.size == 0:
            return
        p, who = self._params, at % ready.shape[1]
        error = self._rate_error(shown, at, who)
        size = np.abs(error)
        change = p.pulse_gain*np.exp(p.pulse_spread*_at(normals[7:9], at)) * size   # N7 y, N8 z
        first, second, third = self._lateral
        above_2, above_3 = change > p.level_2_m_s, change > p.level_3_m_s
        level = 1.0 + above_2 + above_3
        accel = np.where(above_3, third, np.where(above_2, second, first))
        steps = np.rint(change * self._per_s / accel)
        steps = np.minimum(np.maximum(steps, self._shortest), self._longest)
        slips = _at(uniforms[2:4], at) < p.slip_fraction*self._gain[who]            # U2 y, U3 z
        side = np.where(slips, -np.sign(error), np.sign(error))
        acts = size > p.rate_error_m_s
        lateral = at + ready.shape[1]                           # index when x comes before y
        self._start_pulse(step, lateral[acts], (side*level)[acts], steps[acts])
        pause = p.decision_interval_s*self._per_s * np.exp(p.decision_spread*normals[9, who])
        again = np.where(acts, pause + steps, p.idle_interval_fraction*pause)
        np.put(self._decide_at, lateral, step + again)

    def _rate_error(self, shown: Array, at: NDArray[np.int64], who: NDArray[np.int64]) -> Array:
        """Return the lateral rate that is wanted minus the one perceived, (m,) [m/s]."""
        p, gain = self._params, self._gain[who]
        to_go = np.maximum(-shown[0, who], 0.0)
        blur = gain * (p.position_bias_m + p.position_bias_per_m*to_go)
        offset = _at(shown[1:3], at) + blur*_at(self._bias[1:3], at)
        rate = _at(shown[4:6], at) + gain*(p.rate_bias_m_s*_at(self._bias[4:6], at))
        rate = np.where(np.abs(rate) < p.rate_threshold_m_s, 0.0, rate)
        dead_zone = p.dead_zone_fraction * radius(-to_go, self._cone)     # it shrinks on the way
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
    """Return the elements (m,) of `rows` (2, n) at flat indices."""
    return rows.reshape(-1)[at]
