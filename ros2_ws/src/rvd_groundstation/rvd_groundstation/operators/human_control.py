"""
Pilot as a chain of perception, judgment, inference, decision and response, at a predictive display.

Frame   target orbital (+x along track, +y radially outward, +z completes the triad).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis; leading axes are batch axes, one pilot
        each. Inside, components come first: (6, n).
Source  B. Zhang, H. Y. Li, G. J. Tang, Human control model in teleoperation rendezvous, Sci. China
        Inf. Sci. 57(11), 2014: from its abstract the chain, the predictive display, phase-plane
        control along the way and fuzzy control across it. Its rules and numbers are not public.
        J. Y. Zhou et al., Chin. J. Aeronaut. 25, 2012, 622-630: the predictive factor, .9 for a
        skilled pilot. D. L. Kleinman, S. Baron, W. H. Levison, Automatica 6, 1970, 357-369: noise
        of observation in proportion to what is seen, 0.01 pi times its mean square per rad/s,
        and thresholds. D. T. McRuer, H. R. Jex, IEEE Trans. Hum. Factors Electron. 8, 1967,
        231-249: crossover, reaction, and the lead that a double integrator asks of a pilot.
        docs/models/pilot.md says what is known and what is assumed.

Perception  position and rate of each axis, a reaction late, with noise of deviation
            G sqrt(pi P / (2 f T)) times what is seen, plus what is seen of nothing; below its
            threshold a rate is none. T is the correlation time, f the share of attention.
Judgment    what he sees is d + phi (p - d), between telemetry d and prediction p.
Inference   across: offset E and rate C on seven triangles each, the rules -(E + C) (limited),
            mean of the singletons: -K (e + T_l v) where nothing is limited, of which crossover
            and lead set K. Along: the rate leaves a band, and thrust until it is at its middle.
Decision    the nearest level; the stick goes back only when the wish is well below it.
Response    a new position of the stick is kept for a while.
"""

from math import exp, pi, prod, sqrt

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.levels import ThrustParams
from rvd_dynamics.diagram.params import param, settings, wiring
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.streams import PilotDraws

Array = NDArray[np.float64]
HALF = 3.0                              # linguistic values on either side of zero


@settings
class HumanControl:
    """Fuzzy control across, phase-plane control along; the defaults are pilot H of `PERSONS`."""

    run: Run = wiring()
    thrust: ThrustParams = wiring()

    skill_gain: float = param(
        2.722, 'Skill factor of the median pilot, which multiplies the noise of what he sees and '
        'the part of the way that he does not look ahead.', above=0.0)
    skill_spread: float = param(
        0.35, 'Standard deviation of the logarithm of the skill factor from person to person.',
        low=0.0)
    display: bool = param(True, 'Whether the pilot sees the predicted state.')
    display_factor: float = param(
        0.9, 'How far a pilot of skill factor 1 looks ahead with the display, as a fraction of '
        'the way from the estimate to the prediction.', low=0.0, high=1.0)
    predictive_factor: float = param(
        0.9, 'How far a pilot of skill factor 1 looks ahead without the display, as a fraction of '
        'the way from the estimate to the prediction.', low=0.0, high=1.0)
    reaction_s: float = param(0.5, 'Delay with which the pilot perceives the displays [s].',
                              low=0.0, high=60.0)
    noise_ratio: float = param(
        0.01, 'Noise of observation over the mean square of what is seen, per pi rad/s of '
        'bandwidth, at full attention.', low=0.0, high=1.0)
    attention: float = param(0.5, 'Share of attention that each lateral axis has.', above=0.0,
                             high=1.0)
    noise_time_s: float = param(1.0, 'Correlation time of the noise of observation [s].',
                                above=0.0, high=600.0)
    offset_floor_m: float = param(
        0.05, 'Offset that is seen as uncertainly as none [m].', low=0.0, high=10.0)
    rate_floor_m_s: float = param(
        0.01, 'Rate that is seen as uncertainly as none [m/s].', low=0.0, high=1.0)
    rate_threshold_m_s: float = param(
        0.003, 'Rate below which the pilot perceives no motion [m/s].', low=0.0, high=1.0)
    crossover_rad_s: float = param(
        0.1267, 'Crossover frequency of pilot and craft across the way [rad/s].', above=0.0,
        high=10.0)
    lead_s: float = param(
        6.0, 'Lead of the pilot across the way: offset plus lead times rate is what he nulls [s].',
        above=0.0, high=600.0)
    offset_span_m: float = param(
        1.0, 'Offset that is as large as the pilot has words for [m].', above=0.0, high=100.0)
    back_fraction: float = param(
        0.5, 'Part of the threshold of a level below which the stick goes back.', low=0.0,
        high=1.0)
    hold_s: float = param(1.0, 'Least time for which the stick is kept where it is [s].', low=0.0,
                          high=60.0)
    closing_rate_m_s: float = param(0.25, 'Closing rate that the pilot keeps [m/s].', above=0.0)
    closing_error_m_s: float = param(
        0.03, 'Closing rate error at which the pilot begins to thrust [m/s].', low=0.0)

    @property
    def fitted_first(self) -> str:
        """Name of the number that stands for what makes a manual flight fail."""
        return 'skill_gain'

    @property
    def idle(self) -> tuple[str, ...]:
        """Names of the numbers that do nothing with these settings."""
        return ('predictive_factor',) if self.display else ('display_factor',)

    @property
    def gain_per_s2(self) -> float:
        """K, for which K (1 + T_l s)/s^2 is 1 at the crossover [1/s^2]."""
        w, lead = self.crossover_rad_s, self.lead_s
        return w*w / sqrt(1.0 + w*w*lead*lead)

    def flying(self, draws: PilotDraws, skill_normal: ArrayLike, batch: tuple = ()
               ) -> 'HumanControlPilot':
        """Return one pilot per row of the batch; see `pilot.PilotForm`."""
        return HumanControlPilot(self, draws, skill_normal, batch)


def inferred(offset: ArrayLike, rate: ArrayLike) -> Array:
    """
    Return the wish -1 .. 1 that the rules make of offset and rate, each in units of its span.

    Both are described by seven values, whose triangles cross at one half; the rule for values i
    and j, -3 .. 3, is -(i + j), limited to -3 .. 3; the wish is the mean of what the rules say,
    weighted by the product of the memberships. Shapes broadcast.
    """
    e = np.clip(np.asarray(offset, dtype=float), -1.0, 1.0) * HALF
    c = np.clip(np.asarray(rate, dtype=float), -1.0, 1.0) * HALF
    i, j = np.minimum(np.floor(e), HALF - 1.0), np.minimum(np.floor(c), HALF - 1.0)
    u, v = e - i, c - j                     # memberships of the upper of two neighbours
    low, high = -HALF, HALF
    below = (1.0 - v)*np.clip(i + j, low, high) + v*np.clip(i + j + 1.0, low, high)
    above = (1.0 - v)*np.clip(i + j + 1.0, low, high) + v*np.clip(i + j + 2.0, low, high)
    return -((1.0 - u)*below + u*above) / HALF


class HumanControlPilot:
    """One pilot per row of the batch; called once per step, in order."""

    def __init__(self, params: HumanControl, draws: PilotDraws, skill_normal: ArrayLike,
                 batch: tuple = ()) -> None:
        n, step_s = prod(batch), params.run.step_s
        self._params, self._batch = params, batch
        self._normals = draws.normals.reshape(n, -1, draws.normals.shape[-1])
        skill = np.asarray(skill_normal, dtype=float).reshape(n)
        self._gain = params.skill_gain * np.exp(params.skill_spread * skill)
        factor = params.display_factor if params.display else params.predictive_factor
        self._factor = np.clip(1.0 - (1.0 - factor)*self._gain, 0.0, 1.0)
        self._noise = np.ascontiguousarray(draws.initial_normals.reshape(n, 6).T)
        self._keep = exp(-step_s / params.noise_time_s)
        self._shock = sqrt(1.0 - self._keep*self._keep)
        self._scale = sqrt(pi*params.noise_ratio / (2.0*params.attention*params.noise_time_s))
        self._displays = np.full((round(params.reaction_s/step_s) + 1, 6, n), np.nan)
        self._seen = np.zeros(n, dtype=bool)
        self._hold = max(round(params.hold_s/step_s), 1)
        self._free_at = np.zeros((3, n))                        # [steps]
        self._stick = np.zeros((3, n))                          # level
        self._levels = np.array([0.0, *params.thrust.lateral_m_s2])

    def advance(self, step: int, estimate: ArrayLike, predicted: ArrayLike, valid: ArrayLike
                ) -> NDArray[np.int8]:
        """Return the levels at which the stick stands in this step; see `pilot.Pilot`."""
        normals = np.ascontiguousarray(self._normals[:, step, :6].T)
        self._noise = self._keep*self._noise + self._shock*normals
        shown = self._look(step, estimate, predicted, valid)
        place, rate = self._perceive(shown)
        wish = np.concatenate([self._along(rate[:1]), self._across(place[1:], rate[1:])])
        moves = self._seen & (step >= self._free_at) & (wish != self._stick)
        self._stick = np.where(moves, wish, self._stick)
        self._free_at = np.where(moves, step + self._hold, self._free_at)
        return self._stick.astype(np.int8).T.reshape(*self._batch, 3)

    def _look(self, step: int, estimate: ArrayLike, predicted: ArrayLike, valid: ArrayLike
              ) -> Array:
        """Return the displays (6, n) of one reaction ago, looked ahead; until then the first."""
        valid = np.asarray(valid, dtype=bool).reshape(-1)
        d = np.ascontiguousarray(np.reshape(estimate, (-1, 6)).T)
        p = np.ascontiguousarray(np.reshape(predicted, (-1, 6)).T)
        ring = self._displays
        now = np.where(valid, d + self._factor*(p - d), ring[(step - 1) % len(ring)])
        ring[step % len(ring)] = now
        first = valid & ~self._seen
        if first.any():
            ring[:, :, first] = now[:, first]
            self._seen = self._seen | valid
        return ring[(step + 1) % len(ring)]

    def _perceive(self, shown: Array) -> tuple[Array, Array]:
        """Return places and rates (3, n) as he perceives them [m], [m/s]; 0 before he sees any."""
        p = self._params
        known = np.where(self._seen, shown, 0.0)
        blur = self._gain * self._scale
        place = known[:3] + blur*np.hypot(known[:3], p.offset_floor_m)*self._noise[:3]
        # along the way he reads the error of the rate
        rate = known[3:] - np.array([[p.closing_rate_m_s], [0.0], [0.0]])
        rate = rate + blur*np.hypot(rate, p.rate_floor_m_s)*self._noise[3:]
        return place, np.where(np.abs(rate) < p.rate_threshold_m_s, 0.0, rate)

    def _along(self, error: Array) -> Array:
        """Return the level (1, n) along the way: out of the band, then until its middle."""
        stick = self._stick[:1]
        starts = np.where(np.abs(error) > self._params.closing_error_m_s, -np.sign(error), 0.0)
        goes_on = (stick != 0.0) & (stick*error < 0.0)
        return np.where(goes_on, stick, starts)

    def _across(self, offset: Array, rate: Array) -> Array:
        """Return the levels (2, n) of y and z."""
        p, a = self._params, self._levels
        wish = p.gain_per_s2*p.offset_span_m * inferred(
            offset/p.offset_span_m, p.lead_s*rate/p.offset_span_m)      # [m/s^2]
        size, stick = np.abs(wish), np.abs(self._stick[1:])
        edges = 0.5*(a[:-1] + a[1:])                        # nearest level, on the way up
        up = (size > edges[0]).astype(float) + (size > edges[1]) + (size > edges[2])
        back = p.back_fraction * edges                      # and on the way down
        down = (size > back[0]).astype(float) + (size > back[1]) + (size > back[2])
        same = np.sign(wish) == np.sign(self._stick[1:])
        level = np.where(same, np.maximum(up, np.minimum(down, stick)), up)
        return np.sign(wish)*level
