"""
The ground segment of the approach: predictor, operators, law and blender as blocks.
"""

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.codes import BY_PILOT, KIND_ABORT, KIND_THRUST, REASON_ABORT
from rvd_dynamics.commands.levels import LevelForm, stick_levels, StickParams
from rvd_dynamics.diagram.block import Block
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.params import build
from rvd_dynamics.diagram.run import Legs, Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.streams import PilotDraws
from rvd_dynamics.geometry.cone import SLOWEST_RATE
from rvd_dynamics.geometry.keep_out import Stop
from rvd_dynamics.motion.orbit import OrbitParams, ScatterParams, StartParams
from rvd_groundstation.guidance import Law
from rvd_groundstation.guidance.keep_out import among, Map, uses_covariance
from rvd_groundstation.operators.operation import MODES, Operation
from rvd_groundstation.operators.pilot import PilotForm
from rvd_groundstation.operators.tape import read_tape, Tape
from rvd_groundstation.prediction.abort import AbortProfile
from rvd_groundstation.prediction.newest import Newest
from rvd_groundstation.prediction.predictor import Predictor, PredictorParams
from rvd_groundstation.prediction.score import Score
from rvd_groundstation.sharing import decide
from rvd_groundstation.sharing.decision import Sharing
from rvd_missions.lunar_approach.settings import Obstacles
from rvd_missions.lunar_approach.signals import (
    AUTO, COMMAND, ESTIMATE, MODE, PREDICTION, READING, SCORE, STICK, UNTOLD, UPLINK)

THRUST, ABORT = np.uint8(KIND_THRUST), np.uint8(KIND_ABORT)


# -- parts that blocks and laws ask for by name ------------------------------------------------

def sharing(scenario: Scenario) -> Sharing:
    """Return how two commands become one."""
    return scenario.settings('command_blender').selected


def law(scenario: Scenario) -> Law:
    """Return the guidance law, with what it asks for besides its settings."""
    return scenario.wired(scenario.settings('auto_controller').selected)


def pilot(scenario: Scenario) -> PilotForm:
    """Return the form of the model pilot, with what it asks for besides its settings."""
    return scenario.wired(scenario.settings('operator_model').selected)


def approach_rate_m_s(scenario: Scenario) -> float:
    """
    Return the closing rate for which the control boundary is drawn [m/s].

    The one that the law assumes; that of the start where it assumes none, or the one that the
    pilot keeps where the approach does not close when it starts.
    """
    assumed = getattr(scenario.settings('auto_controller').selected, 'closing_rate_m_s', None)
    if assumed is not None:
        return assumed
    start = scenario.part('start').velocity_m_s[0]
    kept = getattr(scenario.settings('operator_model').selected, 'closing_rate_m_s', 0.0)
    return start if start >= SLOWEST_RATE else max(kept, SLOWEST_RATE)


def tape(scenario: Scenario) -> Tape:
    """
    Return the tape that the operator replays.

    Raises
    ------
    ValueError
        If none is named or it cannot be played.
    """
    settings = scenario.settings('joystick_replay')
    if not settings.tape:
        raise BadInput('operator replay needs a tape: joystick_replay: tape names none')
    return read_tape(settings.tape, settings.tape_topic)


def start_scatter(scenario: Scenario) -> NDArray[np.float64]:
    """
    Return the standard deviations of the start (6,), which the ground knows [m, m/s].

    The rest of that section is the world's, and the ground does not load its modules.
    """
    given, prefix = scenario.sections.get('spacecraft_dynamics', {}), 'scatter.'
    return build(ScatterParams, {key[len(prefix):]: value for key, value in given.items()
                                 if key.startswith(prefix)}, label=prefix).sigma


# -- blocks ------------------------------------------------------------------------------------

class StatePredictor:
    """Filter of the telemetry, prediction across the loop, and its score."""

    def __init__(self, settings: PredictorParams, run: Run, legs: Legs, orbit: OrbitParams,
                 start: StartParams, form: LevelForm, abort_profile: AbortProfile,
                 start_scatter: NDArray, batch: tuple, wanted: frozenset[str]) -> None:
        scored = 'score' in wanted
        track = scored or bool({'estimate.covariance', 'prediction.covariance'} & wanted)
        self._predictor = Predictor(settings, run, legs, orbit, start, form, batch, track,
                                    abort_profile, start_scatter) \
            if settings.prediction else Newest(batch, track)
        self._loop = legs.loop
        self.news = self._predictor.news
        self._score = Score(legs, batch) if scored else None

    def step(self, k: int, telemetry: Any, command: Any, late: Mapping[int, Any] | None = None
             ) -> dict[str, Any]:
        """Return what the ground knows at step k; `late`: commands that were missing before."""
        made_up_for = {step: (missed.command, _is_abort(missed))
                       for step, missed in (late or {}).items()}
        p = self._predictor.advance(k, telemetry.state, telemetry.received,
                                    None if k == 0 else command.command, _is_abort(command),
                                    made_up_for, self._acted(k, telemetry))
        known = {'estimate': ESTIMATE(state=p.estimate, covariance=p.estimate_covariance,
                                      valid=p.valid),
                 'prediction': PREDICTION(state=p.predicted, covariance=p.covariance,
                                          valid=p.valid)}
        if self._score is not None:
            known['score'] = SCORE(**self._score.advance(
                p, telemetry.state, telemetry.received)._asdict())
        return known


    def _acted(self, k: int, telemetry: Any) -> NDArray | None:
        """Return whether the command acted that was due just before the sample of step k."""
        if telemetry.accepted is None:
            return None
        return telemetry.accepted >= k - self._loop         # number of its frame


def _is_abort(command: Any) -> bool:
    """Say whether a command is an ABORT, which it is in all rows or in none."""
    return bool(np.ravel(command.kind)[0] == KIND_ABORT)


class OperatorModel:
    """The model pilot: looks at the displays, moves the stick."""

    def __init__(self, pilot: PilotForm, chance: tuple[PilotDraws, Any], batch: tuple) -> None:
        draws, skill = chance
        self._pilot = pilot.flying(draws, skill, batch)
        self._valid = np.ones(batch, dtype=bool)

    def step(self, k: int, estimate: Any, prediction: Any) -> dict[str, Any]:
        """Return where the stick is in step k."""
        levels = self._pilot.advance(k, estimate.state, prediction.state,
                                     estimate.valid & prediction.valid)
        return {'stick': STICK(command=levels, valid=self._valid)}


class JoystickReplay:
    """A tape, played in simulation time; it looks at the prediction for its pace only."""

    def __init__(self, tape: Tape, run: Run, stick: StickParams) -> None:
        self._tape, self._stick, self._step_ns = tape, stick, run.step_ns

    def step(self, k: int, prediction: Any) -> dict[str, Any]:
        """Return what the tape holds for step k; it is the same in all rows."""
        raw = self._tape.at(k * self._step_ns)
        levels, valid = stick_levels(*raw, self._stick)
        return {'stick': STICK(command=levels, valid=np.bool_(valid), raw=raw)}


class AutoController:
    """
    The guidance law; the command form makes a command of what it wants.

    A law that looks at the stick is told nothing of it in mode auto, where nobody blends. The mode
    is the blender's of this step, which told it in the step before; where that is missing, the
    last one told.
    """

    def __init__(self, law: Law, form: LevelForm, operation: Operation, obstacles: Obstacles,
                 run: Run, legs: Legs, runs: Sequence[int], batch: tuple, block: Block,
                 stop: Stop | None) -> None:
        level = getattr(law, 'blind_level', 0)
        self._blind = np.broadcast_to(np.array([level, 0, 0], dtype=np.int8), (*batch, 3))
        self._blind_steps = legs.back if level else 0
        self._asks = bool(obstacles.count) and uses_covariance(law)
        if obstacles.count:             # the map is known before the flight
            law = among(law, Map(obstacles.places(run.seed, runs, batch), obstacles.radii, stop))
        self._law, self._form, self._mode = law, form, operation.mode
        self._tells = 'reading' in block.writes

    def step(self, k: int, prediction: Any, stick: Any = None, mode: Any = None
             ) -> dict[str, Any]:
        """Return the automatic command of step k, and the reading of a held stick."""
        if mode is not None:
            told = int(np.ravel(mode.mode)[0])      # the same in all rows
            self._mode = self._mode if told == UNTOLD else MODES[told]
        seen = None
        if stick is not None and self._mode != 'auto' and np.any(stick.valid):
            seen = np.broadcast_to(stick.command, (*prediction.state.shape[:-1], 3))
        if k < self._blind_steps:
            made = {'auto': AUTO(command=self._blind, valid=np.ones_like(prediction.valid))}
        else:
            well = {'covariance': prediction.covariance} if self._asks else {}
            wanted = self._law.wanted(prediction.state, seen, **well)
            made = {'auto': AUTO(command=self._form.quantise(wanted), valid=prediction.valid)}
        return made | ({'reading': _reading(stick)} if self._tells else {})


class CommandBlender:
    """
    Who decides, and what goes up the link.

    A held stick is read once in a step: by the law where it looks at it, which hands its reading
    on, and else, or where that is missing with the law's command, by the blender.
    """

    def __init__(self, sharing: Sharing, form: LevelForm, batch: tuple, block: Block) -> None:
        self._sharing, self._batch = sharing, batch
        self._tells_reading = 'reading' in block.writes
        self._tells_mode = 'mode' in block.writes
        self._nothing = STICK.initial(batch)
        self._neutral = np.broadcast_to(form.neutral, (*batch, len(form.neutral)))

    def step(self, k: int, auto: Any, control: Control, stick: Any = None, reading: Any = None
             ) -> dict[str, Any]:
        """Return the command of step k and the uplink that carries it."""
        stick = self._nothing if stick is None else stick
        if reading is not None and np.all(reading.taken):
            stick = reading
        pilot, valid = stick.command, stick.valid
        if pilot.ndim == 1:                         # a tape, the same in all rows
            pilot = np.broadcast_to(pilot, self._neutral.shape)
            valid = np.broadcast_to(valid, self._batch)
        d = decide(control.mode, self._sharing, pilot, valid, auto.command, auto.valid)
        levels, by, reason, kind = d.levels, d.decided_by, d.reason, THRUST
        if control.abort:
            levels, kind = self._neutral, ABORT
            by = np.full(self._batch, BY_PILOT, dtype=np.uint8)
            reason = np.full(self._batch, REASON_ABORT, dtype=np.uint8)
        made = {'command': COMMAND(command=levels, kind=kind, decided_by=by,
                                   pilot_weight=d.pilot_weight, reason=reason),
                'uplink': UPLINK(command=levels, kind=kind, expedited=np.bool_(control.abort))}
        if self._tells_reading:
            made['reading'] = _reading(stick)
        if self._tells_mode:
            made['mode'] = MODE(mode=np.uint8(MODES.index(control.next_mode)))
        return made


def _reading(stick: Any) -> Any:
    """Return what was read of a held stick, for whoever decides after it."""
    return READING(command=stick.command, valid=stick.valid, taken=np.bool_(True))
