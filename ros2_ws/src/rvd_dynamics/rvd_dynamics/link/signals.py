"""
The signals at the two ends of the link, and the guard's command, for any state and command form.

A mission gives its state and its command as parts named `state` and `command`; the rest is what
codecs, legs and guard agree on. A command's initial value is what the thrusters do where none has
come in time. All but the thrust are frames of bytes to the link. This module imports nothing of
the link itself, so that the ground may name them.
"""

from rvd_dynamics.commands.codes import KIND_THRUST
from rvd_dynamics.diagram.signal import Part, Signal, VALUES

CODECS = 'rvd_dynamics.diagram.ros.codecs'
FRAME_CODECS = 'rvd_dynamics.diagram.ros.frame_codecs'
FRAME = 'rvd_interfaces/msg/LinkFrame'

# number of the frame whose command the guard accepted last, when the sample was taken
ACCEPTED = Part('accepted', (), 'sequence', 'i8', optional=True, low=0, counts=True)
KIND = Part('kind', (), 'KIND_*', 'u1', KIND_THRUST)
RECEIVED = Part('received', (), '', '?')
# number of the frame in which a command came: the ground sends one a step, the first is 1
SEQUENCE = Part('sequence', (), '', 'i8', optional=True, low=0, counts=True)


def downlink(state: Part) -> Signal:
    """Return what the craft sends down: a state, and what became of the commands."""
    refusal = Part('refusal', (), 'REASON_*', 'u1', optional=True)
    return Signal('/onboard/downlink', (state, ACCEPTED, refusal), FRAME,
                  f'{FRAME_CODECS}:Downlink')


def telemetry(state: Part) -> Signal:
    """Return what comes down: a state, whether a frame was received, and what it acknowledges."""
    return Signal('/ground/telemetry', (state, RECEIVED, ACCEPTED), FRAME,
                  f'{FRAME_CODECS}:Telemetry')


def uplink(command: Part) -> Signal:
    """Return what the ground sends up: a command, its kind, and whether it skips the buffer."""
    return Signal('/ground/uplink', (command, KIND, Part('expedited', (), '', '?')), FRAME,
                  f'{FRAME_CODECS}:Uplink')


def arrival(command: Part) -> Signal:
    """Return what comes up, as the guard reads it."""
    return Signal('/onboard/command', (
        command, KIND, RECEIVED, Part('reason', (), 'REASON_*', 'u1', optional=True),
        SEQUENCE), FRAME, f'{FRAME_CODECS}:Arrival')


def thrust(command: Part, message: str = VALUES, codec: str = f'{CODECS}:Parts') -> Signal:
    """Return what the guard writes: the command that the thrusters carry out, and why."""
    return Signal('/onboard/thruster_command', (
        command, Part('kind', (), 'KIND_*', 'u1', optional=True),
        Part('valid', (), '', '?', optional=True),
        Part('reason', (), 'REASON_*', 'u1', optional=True),
        SEQUENCE,
        Part('decided_by', (), 'BY_*', 'u1', optional=True)), message, codec)


def status(leg: str) -> Signal:
    """Return what a leg, `link_back` say, counts; a graph only."""
    return Signal(f'/link/{leg.removeprefix("link_")}/status', (),
                  'rvd_interfaces/msg/LinkStatus', '')
