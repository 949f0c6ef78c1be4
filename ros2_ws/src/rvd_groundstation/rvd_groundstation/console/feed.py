"""
What the pilot's page is shown, made from what the ground knows.

Frame   target orbital; states (x, y, z, vx, vy, vz) [m, m/s].
Clocks  every shown state carries the instant it was generated on board, received on the
        ground, or is predicted for [s of simulation time].
Truth   never enters here: the feed is filled from `/ground/*`, the back link and `/run/*`.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.geometry.cone import control_boundary, distance_at, radius, signed_distance
from rvd_dynamics.mission import Mission
from rvd_dynamics.motion import cw
from rvd_groundstation.console.ladder import Ladder

NS = 1e-9
DRIFT_POINTS = 24               # points of the line where the chaser drifts if nothing is done
STATION_COUNT = 61              # stations at which the corridor is drawn
FARTHEST = -36.0                # [m] first station
TRAIL_S = 0.5                   # [s] between two points of the trail that late pages get
NOMINAL_RATE = 0.25             # [m/s] the boundary's approach rate (spec of eq. 18)


class Feed:
    """The newest of everything, and the ladder; `frame` makes one message of it."""

    def __init__(self, mission: Mission) -> None:
        self.mission = mission
        self.ladder = Ladder(mission.forward_steps, mission.step_s)
        self.step = -1
        self.paused = False
        self.mode = mission.mode
        self._parts: dict[str, Any] = {}
        self.trail: list[list[float]] = []      # rows t, estimate x y z, prediction x y z
        horizon = np.linspace(0.0, 240.0, 241)
        self._horizon = horizon
        self._drift = cw.transition(mission.orbit.mean_motion, horizon)

    # -- what comes in --------------------------------------------------------------------

    def telemetry(self, step: int, sent_ns: int, arrived_ns: int, generated_ns: int,
                  state: tuple, accepted: int, refusal: int) -> None:
        """Take in an intact downlink that came down in `step`."""
        m = self.mission
        self._parts['tm'] = {'k': step, 'gen': generated_ns * NS, 'rx': step * m.step_s,
                             'x': list(state), 'transit': (arrived_ns - sent_ns) * NS}
        self.ladder.heard(step, generated_ns // m.step_ns, accepted, refusal)

    def telemetry_lost(self, step: int, why: str) -> None:
        """Note that nothing intact came down in `step`."""
        self._parts['gap'] = {'k': step, 'why': why}

    def state(self, name: str, step: int, stamp_ns: int, state: NDArray, sigma: NDArray | None,
              valid: bool) -> None:
        """Take in an estimate ('est') or a prediction ('pred'); `sigma` is (6,) or None."""
        self._parts[name] = {
            'k': step, 't': stamp_ns * NS, 'ok': valid, 'x': state.tolist(),
            's': None if sigma is None else sigma.tolist()}

    def score(self, step: int, stamp_ns: int, error: list, sigma: list, rms: list, count: int
              ) -> None:
        """Take in a prediction held against what was received later."""
        self._parts['score'] = {'k': step, 't': stamp_ns * NS, 'e': error, 's': sigma,
                                'rms': rms, 'n': count}

    def automatic(self, levels: list, valid: bool) -> None:
        """Take in the automatic command."""
        self._parts['auto'] = {'lv': levels, 'ok': valid}

    def pilot(self, levels: list, valid: bool) -> None:
        """Take in what the stick says now."""
        self._parts['pilot'] = {'lv': levels, 'ok': valid}

    def command(self, step: int, sequence: int, kind: int, levels: list, by: int, weight: float,
                reason: int) -> None:
        """Take in the command that was sent in `step`."""
        self.step = max(self.step, step)
        self._parts['cmd'] = {'k': step, 'seq': sequence, 'kind': kind, 'lv': levels, 'by': by,
                              'w': weight, 'why': reason}
        self.ladder.sent(step, sequence, tuple(levels), kind)
        self.ladder.tick(step)
        self._extend_trail(step * self.mission.step_s)

    def _extend_trail(self, t: float) -> None:
        est, pred = self._parts.get('est'), self._parts.get('pred')
        if est is None or pred is None or not pred['ok']:
            return
        if not self.trail or t - self.trail[-1][0] >= TRAIL_S:
            self.trail.append([t, *est['x'][:3], *pred['x'][:3]])

    def link(self, status: dict[str, Any]) -> None:
        """Take in the counts of the back link."""
        self._parts['link'] = status

    # -- what goes out --------------------------------------------------------------------

    def frame(self, since: int = 0) -> dict[str, Any]:
        """Return one frame: parts, margin, round trip, ladder changes after version `since`."""
        m = self.mission
        made = {'type': 'frame', 'k': self.step, 't': max(self.step, 0) * m.step_s,
                'mode': self.mode, 'paused': self.paused, **self._parts,
                'ladder': self.ladder.changes(since)}
        if self.ladder.round_trip_steps is not None:
            made['rtt'] = self.ladder.round_trip_steps * m.step_s
        prediction = self._parts.get('pred')
        if prediction is not None and prediction['ok']:
            made['margin'] = self.outlook(np.array(prediction['x']))
        return made

    def outlook(self, state: NDArray) -> dict[str, Any]:
        """
        Return where a state (6,) stands in the corridor and where it drifts unpowered.

        `d` margin [m], `r` wall radius and `cb` control boundary at its station [m], `leave`
        [s] until the drift leaves the corridor (None: it does not), `plane` [s] until it
        reaches the docking plane (None: never), `hit` (y, z) there, `path` rows (x, y, z).
        """
        corridor, n = self.mission.corridor, self.mission.orbit.mean_motion
        station = min(float(state[0]), 0.0)
        made: dict[str, Any] = {
            'd': float(signed_distance(state[:3], corridor)),
            'r': float(radius(station, corridor)),
            'cb': float(control_boundary(station, corridor, n, NOMINAL_RATE, self.loop_s)),
            'leave': None, 'plane': None, 'hit': None}
        path = np.einsum('kij,j->ki', self._drift[:, :3], state)
        y, z = path[:, 1], path[:, 2]
        margin = distance_at(path[:, 0], np.sqrt(y*y + z*z), corridor)
        plane = _crossing(self._horizon, -path[:, 0])
        leave = _crossing(self._horizon, margin)
        end = float(self._horizon[-1]) if plane is None else plane
        if leave is not None and leave <= end:
            made['leave'] = leave
        if plane is not None:
            made['plane'] = plane
            made['hit'] = [float(np.interp(plane, self._horizon, c)) for c in (y, z)]
        times = np.linspace(0.0, end, DRIFT_POINTS)
        made['path'] = [[round(float(np.interp(t, self._horizon, path[:, i])), 3)
                         for i in range(3)] for t in times]
        return made

    @property
    def loop_s(self) -> float:
        """Delay around the loop [s]."""
        return self.mission.forward_delay_s + self.mission.back_delay_s

    def run_message(self, name: str) -> dict[str, Any]:
        """Return what a page needs once per run: grid, delays, limits, geometry."""
        m = self.mission
        x = np.linspace(FARTHEST, 0.0, STATION_COUNT)
        boundary = [float(control_boundary(s, m.corridor, m.orbit.mean_motion, NOMINAL_RATE,
                                           self.loop_s)) for s in x]
        return {
            'type': 'run', 'name': name, 'step_s': m.step_s, 'timeout_s': m.timeout_s,
            'forward_s': m.forward_delay_s, 'back_s': m.back_delay_s, 'mode': m.mode,
            'operator': m.operator, 'seed': m.seed, 'pace': m.pace_factor,
            'start': list(m.start.position_m), 'rate': m.start.velocity_m_s[0],
            'limits': {'offset': m.corridor.docking_radius_m,
                       'closing': m.docking.max_closing_rate_m_s,
                       'lateral': m.docking.max_lateral_rate_m_s},
            'half_angle_deg': m.corridor.half_angle_deg,
            'geometry': {'x': x.tolist(), 'wall': radius(x, m.corridor).tolist(),
                         'boundary': boundary}}


def _crossing(times: NDArray, values: NDArray) -> float | None:
    """Return the first instant at which `values` falls below zero, None when it does not."""
    below = np.flatnonzero(values < 0.0)
    if not below.size:
        return None
    i = int(below[0])
    if i == 0:
        return 0.0
    share = values[i - 1] / (values[i - 1] - values[i])
    return float(times[i - 1] + share * (times[i] - times[i - 1]))
