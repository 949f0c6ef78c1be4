"""
The closed loop in one process: what the node graph computes, on arrays of N runs.

Step    truth k -> measurement k -> back link (releases sample k - nb) -> predictor (and the
        command of step k - 1) -> pilot -> law -> blender (command k) -> forward link
        (releases command k - nf) -> guard -> thrusters, which act on [k, k + 1).
State   (x, y, z, vx, vy, vz) [m, m/s] on the last axis, target orbital frame; one row per run.
End     the first step with x >= 0 or at the time limit, each row for itself; a row that has
        ended is carried along and no longer counts.

It calls the functions that the nodes call, in their order, so a row is equal to the bit to
the same run over DDS, alone or in any batch. Two things are short here because they are
settled before the run: a play-out buffer turns transits into a constant delay plus erasures
(`LinkPlan.intact_in_time`), and the guard has nothing to refuse but frames that it does not get.
"""

from collections import deque
from collections.abc import Sequence
from dataclasses import dataclass, field, fields
from typing import NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.judge import Verdict
from rvd_dynamics.judge import ended, Judge
from rvd_dynamics.link.models import LinkParams
from rvd_dynamics.link.plan import intact_of_runs
from rvd_dynamics.mission import Mission
from rvd_dynamics.world.plants.relative import TRUTH_MODELS
from rvd_dynamics.commands.levels import stick_levels
from rvd_dynamics.world.spacecraft.thrusters import execute
from rvd_dynamics.world.settings import DynamicsParams, SensorParams
from rvd_groundstation.guidance import Law
from rvd_groundstation.operators.pilot import Pilot, PilotParams
from rvd_groundstation.operators.tape import Tape
from rvd_groundstation.prediction.predictor import Prediction, Predictor, PredictorParams
from rvd_groundstation.sharing import decide, Decision, Eq25
from rvd_groundstation.sharing.decision import Sharing

Array = NDArray[np.float64]
Levels = NDArray[np.int8]
STEPPED = ('model', 'replay', 'none')   # operators that need no wall clock


@dataclass(frozen=True)
class LoopSettings:
    """Everything that a flight depends on besides the run number."""

    mission: Mission
    law: Law
    dynamics: DynamicsParams = field(default_factory=DynamicsParams)
    sensor: SensorParams = field(default_factory=SensorParams)
    link_forward: LinkParams = field(default_factory=LinkParams)
    link_back: LinkParams = field(default_factory=LinkParams)
    predictor: PredictorParams = field(default_factory=PredictorParams)
    sharing: Sharing = field(default_factory=Eq25)
    pilot: PilotParams = field(default_factory=PilotParams)
    tape: Tape | None = None            # of operator `replay`

    def __post_init__(self) -> None:
        operator = self.mission.operator
        if operator not in STEPPED:
            raise ValueError(f'operator must be one of {", ".join(STEPPED)} in a loop without '
                             f'wall clock, got {operator}')
        if operator == 'replay' and self.tape is None:
            raise ValueError('operator replay needs a tape')


@dataclass(frozen=True)
class History:
    """What happened, by step and run; NaN and 0 after the end of a run."""

    truth: Array                        # (steps, N, 6) state at the step
    acceleration: Array                 # (steps, N, 3) executed over the step that ends there
    measured: Array                     # (steps, N, 6) what the sensor said on board
    received: NDArray[np.bool_]         # (steps, N)    a sample came down in this step
    estimate: Array                     # (steps, N, 6) of the instant k - back_steps
    predicted: Array                    # (steps, N, 6) for the instant k + forward_steps
    pilot: Levels                       # (steps, N, 3)
    auto: Levels                        # (steps, N, 3)
    command: Levels                     # (steps, N, 3) as sent
    decided_by: NDArray[np.uint8]       # (steps, N)
    executed: Levels                    # (steps, N, 3) what acts from this step to the next


@dataclass(frozen=True)
class Flight:
    """N flown runs."""

    runs: NDArray[np.int64]             # (N,) numbers of the runs
    end_step: NDArray[np.int64]         # (N,) step of the last truth
    verdict: Verdict                    # fields (N,)
    terminal: Array                     # (N, 6) state at the docking plane; NaN: not reached
    decided_steps: NDArray[np.int64]    # (N, 4) steps by nobody, pilot, auto, blend (codes.BY_*)
    changed_steps: NDArray[np.int64]    # (N,) steps whose command was not the pilot's
    history: History | None             # when it was asked for


class Draws(NamedTuple):
    """All chance of N runs, whatever is flown with it; row k of a block belongs to step k."""

    key: tuple                          # what the draws depend on
    start: Array                        # (N, 6)
    measurement: Array                  # (N, steps, 6)
    execution: Array                    # (N, steps, 3)
    back_intact: NDArray[np.bool_]      # (N, steps) the sample of k comes down in time
    forward_intact: NDArray[np.bool_]   # (N, steps) the command of k goes up in time
    pilot: streams.PilotDraws | None    # when a model flies
    skill: Array | None                 # (N,)


def fly(settings: LoopSettings, runs: Sequence[int], record: bool = False,
        draws: Draws | None = None) -> Flight:
    """
    Fly runs to their end.

    Parameters
    ----------
    settings : LoopSettings
        The seed is the mission's; its run number is not used.
    runs : sequence of int
        Numbers of the runs; each is the same whichever others fly with it.
    record : bool
        Keep the history (0.3 kB per step and run: leave it out of campaigns).
    draws : Draws, optional
        What `draw` returned for these runs. Drawing takes more time than flying, and conditions
        that share seed, links and time grid share the draws.

    Returns
    -------
    Flight

    Raises
    ------
    ValueError
        If there is no run, or `draws` are of other runs or settings.
    """
    if len(runs) == 0:
        raise ValueError('runs must name at least one run, got none')
    if draws is None or record:                     # a history is of whole runs
        draws = draw(settings, runs, whole=record)
    if draws.key != draws_key(settings, runs):
        raise ValueError('draws are of other runs, seed, links, delays or time grid')
    loop = _Loop(settings, draws)
    steps: list[dict] = []
    for step in range(draws.measurement.shape[1]):
        row = loop.advance(step)
        if record:
            steps.append(row)
        if loop.ended.all():
            break
    history = _history(steps, loop.end_step) if record else None
    flight = Flight(np.asarray(runs, dtype=np.int64), loop.end_step, loop.judge.verdict(),
                    loop.judge.terminal, loop.decided_steps, loop.changed_steps, history)
    return flight if loop.ended.all() else _with_late_ones(settings, flight, loop.ended)


def _with_late_ones(settings: LoopSettings, flight: Flight, over: NDArray[np.bool_]) -> Flight:
    """Fly again, with all the draws there are, the few runs that outlast the usual ones."""
    late = np.flatnonzero(~over)
    runs = flight.runs[late].tolist()
    whole = fly(settings, runs, draws=draw(settings, runs, whole=True))

    def merged(mine: NDArray, theirs: NDArray) -> NDArray:
        mine = mine.astype(np.result_type(mine, theirs))    # the longest reason is the widest
        mine[late] = theirs
        return mine

    usual, later = flight.verdict, whole.verdict
    verdict = Verdict(*map(merged, usual[:3], later[:3]), {
        name: merged(values, later.values[name]) for name, values in usual.values.items()})
    return Flight(flight.runs, merged(flight.end_step, whole.end_step), verdict,
                  merged(flight.terminal, whole.terminal),
                  merged(flight.decided_steps, whole.decided_steps),
                  merged(flight.changed_steps, whole.changed_steps), None)


class _Loop:
    """The parts of the graph and what is on its way between them."""

    def __init__(self, s: LoopSettings, draws: Draws) -> None:
        mission, n = s.mission, len(draws.start)
        self._settings, self._draws, self._batch = s, draws, (n,)
        self._truth_model = TRUTH_MODELS[s.dynamics.truth_model](mission)
        self._state = s.dynamics.start(mission, draws.start)
        self._acceleration = np.full((n, 3), np.nan)
        self._predictor = Predictor(s.predictor, mission, (n,), track=False)
        self._pilot = (Pilot(s.pilot, mission, draws.pilot, draws.skill, (n,))
                       if mission.operator == 'model' else None)
        self.judge = Judge(mission, (n,))
        self.ended = np.zeros(n, dtype=bool)
        self.end_step = np.full(n, -1, dtype=np.int64)
        self.decided_steps = np.zeros((4, n), dtype=np.int64).T
        self.changed_steps = np.zeros(n, dtype=np.int64)
        # on its way down and up: [0] is released in this step, [-1] has just been sent
        self._down: deque[Array] = deque(maxlen=mission.back_steps + 1)
        self._up: deque[Levels] = deque(maxlen=mission.forward_steps + 1)
        self._command: Levels | None = None
        self._executed: Levels | None = None

    def advance(self, step: int) -> dict:
        """Do everything that the graph does in one step; return it by the names of History."""
        self._move(step)
        measured = self._settings.sensor.selected.measure(
            self._state, self._draws.measurement[:, step])
        sample, received = self._receive(step, measured)
        prediction = self._predictor.advance(step, sample, received, self._command)
        pilot, pilot_valid = self._stick(step, prediction)
        auto = self._settings.law.levels(prediction.predicted, pilot if pilot_valid else None)
        decision = self._decide(pilot, pilot_valid, auto, prediction.valid)
        self._tally(decision, pilot)
        self._command = decision.levels
        self._executed = self._transmit(step, decision.levels)
        return {'truth': self._state, 'acceleration': self._acceleration, 'measured': measured,
                'received': received, 'estimate': prediction.estimate,
                'predicted': prediction.predicted, 'pilot': pilot, 'auto': auto,
                'command': decision.levels, 'decided_by': decision.decided_by,
                'executed': self._executed}

    def _move(self, step: int) -> None:
        """Take the truth to this step, judge it, and note which runs end here."""
        s = self._settings
        if step == 0:
            self.judge.start(self._state)
        else:
            self._acceleration = execute(
                self._executed, s.mission.thrust, self._draws.execution[:, step - 1],
                s.dynamics.execution_noise_fraction)
            self._state = self._truth_model.advance(self._state, self._acceleration)
            self.judge.advance(step, self._state, self._acceleration)
        over = ended(step, self._state, s.mission.last_step)
        self.end_step[over & ~self.ended] = step
        self.ended |= over

    def _receive(self, step: int, measured: Array) -> tuple[Array | None, NDArray[np.bool_]]:
        """Send a sample down; return the one that the back link releases."""
        self._down.append(measured)
        sent = step - self._settings.mission.back_steps
        if sent < 0:
            return None, np.zeros(self._batch, dtype=bool)
        return self._down[0], self._draws.back_intact[:, sent]

    def _transmit(self, step: int, levels: Levels) -> Levels:
        """Send a command up; return what the guard makes of the one that is released."""
        self._up.append(levels)
        sent = step - self._settings.mission.forward_steps
        if sent < 0:
            return np.zeros_like(levels)
        return np.where(self._draws.forward_intact[:, sent, None], self._up[0], np.int8(0))

    def _stick(self, step: int, prediction: Prediction) -> tuple[Levels, bool]:
        s = self._settings
        if s.mission.operator == 'model':
            return self._pilot.advance(step, prediction.estimate, prediction.predicted,
                                       prediction.valid), True
        levels, valid = np.zeros(3, dtype=np.int8), False
        if s.mission.operator == 'replay':
            levels, valid = stick_levels(*s.tape.at(step * s.mission.step_ns), s.mission.stick)
        return np.tile(levels, (*self._batch, 1)), valid

    def _tally(self, decision: Decision, pilot: Levels) -> None:
        """Count who decided, in the runs under way."""
        live = ~self.ended
        for by, steps in enumerate(self.decided_steps.T):
            steps += live & (decision.decided_by == by)
        differs = decision.levels != pilot
        self.changed_steps += live & (differs[:, 0] | differs[:, 1] | differs[:, 2])

    def _decide(self, pilot: Levels, pilot_valid: bool, auto: Levels,
                auto_valid: NDArray[np.bool_]) -> Decision:
        s = self._settings
        return decide(s.mission.mode, s.sharing, pilot, np.full(self._batch, pilot_valid),
                      auto, auto_valid)


def draw(settings: LoopSettings, runs: Sequence[int], whole: bool = False) -> Draws:
    """
    Draw what the world, the links and the pilots will do in runs; see `fly`.

    Enough for a tenth more than the nominal approach, which few runs outlast; `whole` for all
    the steps that a run may take. The shorter blocks are the beginning of the longer ones.
    """
    mission = settings.mission
    closing = max(mission.start.velocity_m_s[0], 1e-9)
    usual = 1.1 * -mission.start.position_m[0] / closing / mission.step_s
    steps = mission.last_step + 1
    if not whole:
        steps = int(min(steps, usual + 10.0))
    seed, flown = mission.seed, mission.operator == 'model'

    def intact(params: LinkParams, purpose: str, hold_steps: int) -> NDArray[np.bool_]:
        return intact_of_runs(params, streams.generators(seed, runs, purpose), len(runs), steps,
                              mission.step_ns, hold_steps)

    return Draws(
        key=draws_key(settings, runs),
        start=streams.start_normals_of_runs(seed, runs),
        measurement=streams.normals_of_runs(seed, runs, 'measurement', steps, 6),
        execution=streams.normals_of_runs(seed, runs, 'execution', steps, 3),
        back_intact=intact(settings.link_back, 'link_back', mission.back_steps),
        forward_intact=intact(settings.link_forward, 'link_forward', mission.forward_steps),
        pilot=streams.pilot_draws_of_runs(seed, runs, steps) if flown else None,
        skill=streams.skill_normals(
            seed, [settings.pilot.operator_of(run) for run in runs]) if flown else None)


def draws_key(s: LoopSettings, runs: Sequence[int]) -> tuple:
    """Return what must be equal for settings to share the draws of runs."""
    mission = s.mission
    return (tuple(runs), mission.seed, mission.last_step, mission.step_ns, mission.back_steps,
            mission.forward_steps, s.link_back, s.link_forward, mission.operator == 'model',
            s.pilot.runs_per_operator)


def _history(steps: list[dict], end_step: NDArray[np.int64]) -> History:
    """Stack the steps and blank what lies after the end of each run."""
    after = np.arange(len(steps))[:, None] > end_step
    stacked = {}
    for f in fields(History):
        values = np.stack([np.broadcast_to(row[f.name], np.shape(steps[-1][f.name]))
                           for row in steps])
        values[after] = np.nan if values.dtype.kind == 'f' else 0
        stacked[f.name] = values
    return History(**stacked)
