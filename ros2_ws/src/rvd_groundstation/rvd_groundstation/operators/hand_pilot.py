"""
A pilot of two hand controllers: clicks for translation, rates for rotation.

On each axis he wants a velocity towards the aim, slower the nearer, and clicks when the one that he
sees is off by more than he cares; he turns the craft straight with the other hand. He looks at one
display, a reaction time late, and draws no chance: runs differ by what the craft does. All numbers
are assumed; no person was measured.

Shapes   (N, 3) positions, velocities [m, m/s] in LVLH and rotation vectors [rad]; N rows.
"""

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands.hand import HandParams, Hold, PERCENT
from rvd_dynamics.diagram.params import param, require, settings

Array = NDArray[np.float64]


@settings
class HandPilotParams:
    """A pilot of two hand controllers."""

    display: str = param(
        'predicted', 'What a remote pilot looks at: the predicted craft, or the one that the '
        'telemetry shows, delayed; aboard there is only the present one.',
        choices=('predicted', 'delayed'))
    reaction_s: float = param(0.3, 'Delay with which he sees the display [s].', low=0.0, high=10.0)
    interval_s: float = param(0.4, 'Time between two clicks on one axis [s].', low=0.1, high=60.0)
    press_s: float = param(0.2, 'Time for which he presses for a click [s].', low=0.01, high=10.0)
    fast_m_s: float = param(0.05, 'Highest speed that he wants [m/s].', above=0.0, high=1.0)
    slow_m_s: float = param(0.02, 'Highest speed that he wants within slow_m [m/s].', above=0.0,
                            high=1.0)
    slow_m: float = param(0.5, 'Way to the aim from which he is slow [m].', low=0.0, high=100.0)
    brake_m_s2: float = param(0.002, 'Deceleration by which he chooses the speed [m/s^2].',
                              above=0.0, high=1.0)
    approach_s: float = param(10.0, 'Time in which he wants to be there, near the aim [s].',
                              above=0.0, high=1000.0)
    still_m: float = param(0.010, 'Offset from the aim that he leaves [m].', low=0.0, high=1.0)
    careless_m_s: float = param(0.0014, 'Error of a velocity that he leaves [m/s].', low=0.0,
                                high=1.0)
    straight_s: float = param(8.0, 'Time in which he wants the craft straight [s].', above=0.0,
                              high=1000.0)
    careless_deg: float = param(0.05, 'Attitude angle that he leaves [deg].', low=0.0, high=10.0)

    def __post_init__(self) -> None:
        require(self.press_s < self.interval_s, 'press_s',
                f'be below interval_s, {self.interval_s:g}', self.press_s)


class HandPilot:
    """N pilots, called once per step, in order."""

    def __init__(self, params: HandPilotParams, hand: HandParams, step_s: float, rows: int
                 ) -> None:
        self._params, self._hand = params, hand
        self._late = round(params.reaction_s/step_s)
        self._interval = max(round(params.interval_s/step_s), 1)
        self._press = max(round(params.press_s/step_s), 1)
        self._seen: list[tuple[Array, Array, Array]] = []
        self._next = np.zeros((rows, 3), dtype=np.int64)       # [steps] of his next decisions
        self._until = np.zeros((rows, 3), dtype=np.int64)
        self._side = np.zeros((rows, 3), dtype=np.int8)

    def advance(self, k: int, way: Array, velocity: Array, lean: Array) -> tuple[Hold, Hold]:
        """
        Return where both controllers stand in step k.

        `way` is from the port to where it is to be, `lean` the craft's attitude; NaN: no display.
        """
        self._seen.append((way, velocity, lean))
        way, velocity, lean = self._seen[0]
        if len(self._seen) > self._late:
            self._seen.pop(0)
        p, held = self._params, np.ones(len(way), dtype=bool)
        nothing = np.zeros(len(way), dtype=bool)
        self._decide(k, self.wanted(way) - velocity)
        push = np.where(k < self._until, self._side*np.int8(PERCENT), 0).astype(np.int8)
        rate = np.where(np.abs(lean) > np.radians(p.careless_deg), -lean/p.straight_s, 0.0)
        share = np.clip(np.nan_to_num(rate)/np.radians(self._hand.rate_deg_s), -1.0, 1.0)
        # below the dead zone he moves it just out of it
        least = np.floor(PERCENT*self._hand.dead_zone) + 1.0
        turn = np.sign(share)*np.where(share == 0.0, 0.0, np.maximum(np.abs(PERCENT*share), least))
        return (Hold(push, nothing, nothing, held),
                Hold(np.rint(turn).astype(np.int8), nothing, nothing, held))

    def wanted(self, way: Array) -> Array:
        """Return the velocity (N, 3) that he wants with a way (N, 3) to go."""
        p = self._params
        left = np.maximum(np.abs(way) - p.still_m, 0.0)
        most = np.where(left > p.slow_m, p.fast_m_s, p.slow_m_s)
        return np.sign(way)*np.minimum(np.minimum(
            np.sqrt(2.0*p.brake_m_s2*left), left/p.approach_s), most)

    def _decide(self, k: int, error: Array) -> None:
        """Click where a velocity is off; then look at that axis again a little later."""
        acts = (k >= self._next) & (np.abs(error) > self._params.careless_m_s)     # no for NaN
        self._side = np.where(acts, np.sign(np.nan_to_num(error)), self._side).astype(np.int8)
        self._until = np.where(acts, k + self._press, self._until)
        self._next = np.where(acts, k + self._interval, self._next)
