"""
The ground segment, and whoever holds the hand controllers, aboard or on the ground.
"""

from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.commands.hand import HandParams, read, together
from rvd_dynamics.diagram.control import Control
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.motion import attitude
from rvd_groundstation.operators.hand_pilot import HandPilot as Pilot, HandPilotParams
from rvd_groundstation.operators.tape import read_tape, Tape
from rvd_missions.docking import markers
from rvd_missions.docking.hand_signals import COMMAND, ROTATION, TRANSLATION, UPLINK
from rvd_missions.docking.settings import Aim

AXES, BUTTONS = 3, 3                    # of each controller on a tape, translation first


def tape(scenario: Scenario) -> Tape:
    """
    Return the tape that the operator replays.

    Raises
    ------
    BadInput
        If none is named, or it has not the axes and buttons of two controllers.
    """
    settings = scenario.settings('joystick_replay')
    if not settings.tape:
        raise BadInput('operator replay needs a tape: joystick_replay: tape names none')
    found = read_tape(settings.tape, settings.tape_topic)
    least = min((len(a), len(b)) for a, b in zip(found.axes, found.buttons))
    if least < (2*AXES, 0) or min(len(b) for b in found.buttons) < 2*BUTTONS:
        raise BadInput(f'{settings.tape}: two hand controllers have {2*AXES} axes and {2*BUTTONS} '
                       f'buttons on a tape, got {least[0]} and '
                       f'{min(len(b) for b in found.buttons)}')
    return found


class HandReplay:
    """A tape of both controllers, in simulation time; it looks at the display for its pace only."""

    def __init__(self, tape: Tape, run: Run, hand: HandParams) -> None:
        self._tape, self._hand, self._step_ns = tape, hand, run.step_ns

    def step(self, k: int, display: Any) -> dict[str, Any]:
        """Return what the tape holds for step k, the same in all rows; nobody's outside of it."""
        axes, buttons = self._tape.at(k*self._step_ns)
        return {name: signal(**read(axes[i*AXES:(i + 1)*AXES], buttons[i*BUTTONS:(i + 1)*BUTTONS],
                                    self._hand)._asdict())
                for i, (name, signal) in enumerate((('translation', TRANSLATION),
                                                    ('rotation', ROTATION)))}


class HandPilot:
    """The pilot model: looks at the display, moves both controllers."""

    def __init__(self, settings: HandPilotParams, hand: HandParams, run: Run, aim: Aim,
                 batch: tuple) -> None:
        self._batch = batch
        rows = int(np.prod(batch, dtype=int))
        self._pilot = Pilot(settings, hand, run.step_s, rows)
        self._aim = np.array([-aim.distance_m, 0.0, 0.0])

    def step(self, k: int, display: Any) -> dict[str, Any]:
        """Return where both controllers stand in step k."""
        r, v, q = (np.reshape(np.asarray(getattr(display, name), dtype=float), (-1, size))
                   for name, size in (('position', 3), ('velocity', 3), ('attitude', 4)))
        arm = attitude.rotate(q, np.broadcast_to(markers.CHASER_PORT, r.shape))
        port = r + arm - markers.TARGET_PORT
        hands = self._pilot.advance(k, self._aim - port, v, attitude.rotation_vector(q))
        return {name: signal.type(*(self._out(part) for part in hold))
                for name, signal, hold in zip(('translation', 'rotation'),
                                              (TRANSLATION, ROTATION), hands)}

    def _out(self, rows: NDArray) -> NDArray:
        return rows.reshape((*self._batch, *rows.shape[1:]))


class HandUplink:
    """Makes one command of both controllers and the uplink that carries it; an ABORT goes first."""

    def __init__(self, batch: tuple) -> None:
        self._batch = batch

    def step(self, k: int, translation: Any, rotation: Any, prediction: Any, control: Control
             ) -> dict[str, Any]:
        """Return the command of step k."""
        command = np.broadcast_to(together(translation, rotation), (*self._batch, 7))
        kind = np.uint8(KIND_ABORT if control.abort else KIND_THRUST)
        return {'command': COMMAND(command=command, kind=kind),
                'uplink': UPLINK(command=command, kind=kind, expedited=np.bool_(control.abort))}
