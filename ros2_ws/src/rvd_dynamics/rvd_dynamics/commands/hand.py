"""
Two hand controllers: what a deflection, a click and a button mean to the craft.

A translation hand controller pushes along x, y, z and a rotation hand controller turns about
x, y, z, both in the craft's body axes. Each works one of two ways, and its button `switch` turns it
over while it is held:

    pulse   one click is one pulse of a stated length of the thrusters of that axis; between clicks
            the craft drifts. A click is a deflection of `click` or more after one within the dead
            zone, so that a stick that is held does not repeat.
    rate    the deflection commands a velocity, or an angular velocity; neutral holds place, or
            attitude. So does a controller that nobody holds, whichever way it works.

Command  (..., 7) of int8: six deflections in percent, x, y, z, about x, y, z, and a sum of FLAGS.
         It is what goes up the link, so that craft and predictor make the same of it.
Source   An, Qu, Wang 2015, section 2.6, has "translation by pulses, rotation by rates" and a dead
         zone of 5 %; all other numbers are assumed.
"""

from collections.abc import Sequence
from dataclasses import dataclass, field
from math import isnan
from struct import Struct
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import param, require, settings

WAYS = ('pulse', 'rate')
PERCENT = 100
HELD, TURN_HELD, SWITCHED, TURN_SWITCHED, RESUME = FLAGS = (1, 2, 4, 8, 16)
DEADMAN_BUTTON, SWITCH_BUTTON, RESUME_BUTTON = range(3)
ROUNDING = 1e-6                         # a float32 at full deflection may be 1.0000001


@settings
class HandParams:
    """What the two hand controllers mean."""

    translation: str = param('pulse', 'How the translation hand controller works.', choices=WAYS)
    rotation: str = param('rate', 'How the rotation hand controller works.', choices=WAYS)
    dead_zone: float = param(
        0.05, 'Deflection up to which an axis counts as neutral, as a fraction of full deflection.',
        low=0.0, below=0.5)
    click: float = param(0.5, 'Deflection from which it is a click, as a fraction of full '
                         'deflection.', above=0.0, high=1.0)
    pulse_s: float = param(0.1, 'On-time of the thrusters for one click, 40 N of translation and '
                           '16 N m of rotation [s].', low=0.04, high=10.0)
    speed_m_s: float = param(0.05, 'Speed at full deflection [m/s].', above=0.0, high=1.0)
    rate_deg_s: float = param(0.3, 'Angular velocity at full deflection [deg/s].', above=0.0,
                              high=2.0)
    hold_s: float = param(0.5, 'Time for which the craft goes on with a command when no newer one '
                          'comes [s].', low=0.0, high=10.0)
    deadman: bool = param(True, 'Whether button 0 of a controller must be held for it to count.')

    def __post_init__(self) -> None:
        require(self.click > self.dead_zone, 'click', f'be above dead_zone, {self.dead_zone:g}',
                self.click)


class Hold(NamedTuple):
    """Where one controller stands."""

    deflection: NDArray[np.int8]        # (..., 3) percent
    switched: NDArray[np.bool_]         # (...) button 1 is held
    resume: NDArray[np.bool_]           # (...) button 2 is held
    valid: NDArray[np.bool_]            # (...) somebody holds it


def fault(axes: Sequence[float], buttons: Sequence[int], hand: HandParams) -> str:
    """Return in a few words why one `sensor_msgs/Joy` is nobody's; nothing if it is valid."""
    if len(axes) < 3:
        return f'a hand controller has three axes: Joy has {len(axes)}'
    for i, name in enumerate('xyz'):
        if isnan(axes[i]):
            return f'axis {i} ({name}) is not a number'
        if not abs(axes[i]) <= 1.0 + ROUNDING:
            return f'axis {i} ({name}) is beyond -1 to 1'
    if hand.deadman and not (buttons and buttons[DEADMAN_BUTTON] == 1):
        return f'dead-man button {DEADMAN_BUTTON} is not held'
    return ''


def read(axes: Sequence[float], buttons: Sequence[int], hand: HandParams) -> Hold:
    """Return where the controller of one `sensor_msgs/Joy` stands; neutral if it is nobody's."""
    valid = not fault(axes, buttons, hand)
    deflection = np.zeros(3, dtype=np.int8)
    if valid:
        deflection = np.rint(PERCENT*np.clip(axes[:3], -1.0, 1.0)).astype(np.int8)

    def down(button: int) -> np.bool_:
        return np.bool_(valid and len(buttons) > button and buttons[button] == 1)
    return Hold(deflection, down(SWITCH_BUTTON), down(RESUME_BUTTON), np.bool_(valid))


def joy(hold: Hold, hand: HandParams) -> tuple[list[float], list[int]]:
    """Return axes and buttons of the `sensor_msgs/Joy` of which `read` makes the same again."""
    axes = [int(value)/PERCENT for value in hold.deflection]
    if not (hold.valid or hand.deadman):        # no button to say it with
        axes = [float('nan')]*3
    return axes, [int(hold.valid), int(hold.switched), int(hold.resume)]


def together(translation: Hold, rotation: Hold) -> NDArray[np.int8]:
    """Return the command (..., 7) of both controllers; one that nobody holds is neutral."""
    held, turn = np.asarray(translation.valid), np.asarray(rotation.valid)
    flags = (HELD*held + TURN_HELD*turn + SWITCHED*(held & translation.switched)
             + TURN_SWITCHED*(turn & rotation.switched) + RESUME*(held & translation.resume))
    return np.concatenate([
        np.where(held[..., np.newaxis], translation.deflection, 0),
        np.where(turn[..., np.newaxis], rotation.deflection, 0),
        flags[..., np.newaxis]], axis=-1).astype(np.int8)


@dataclass(frozen=True)
class HandForm:
    """The form of these commands, for the wire and the guard's gate; see `commands.form`."""

    hand: HandParams = field(default_factory=HandParams)

    neutral = np.zeros(7, dtype=np.int8)
    wire = Struct('<7b')

    def legal(self, command: Sequence) -> bool:
        """Say whether numbers, as they came over the wire, are a command."""
        return (len(command) == 7 and all(abs(value) <= PERCENT for value in command[:6])
                and 0 <= command[6] < 2*RESUME)


class Wish(NamedTuple):
    """What N rows of commands ask of the craft in one step; body axes."""

    push: NDArray[np.int8]              # (N, 6) -1, 0, 1: pulses of force and torque
    speed: NDArray[np.float64]          # (N, 3) [m/s]
    spin: NDArray[np.float64]           # (N, 3) [rad/s]
    drifts: NDArray[np.bool_]           # (N, 2) translation, rotation: by pulses, not by rates
    resume: NDArray[np.bool_]           # (N,) the button has just been pressed


class Hands:
    """
    Makes wishes of commands, for N rows: it remembers clicks and what is left of pulses.

    Craft and predictor have one each; equal commands give equal wishes.
    """

    def __init__(self, hand: HandParams, step_s: float, rows: int) -> None:
        self._hand, self._pulse = hand, max(round(hand.pulse_s/step_s), 1)
        self._armed = np.ones((rows, 6), dtype=bool)
        self._left = np.zeros((rows, 6), dtype=np.int64)       # steps of a pulse
        self._side = np.zeros((rows, 6), dtype=np.int8)
        self._resumed = np.zeros(rows, dtype=bool)
        self._by_pulse = np.array([hand.translation == 'pulse', hand.rotation == 'pulse'])

    def step(self, command: ArrayLike) -> Wish:
        """Return the wishes of this step for commands (N, 7)."""
        hand, command = self._hand, np.asarray(command)
        flags = command[:, 6]
        deflection = command[:, :6]/float(PERCENT)
        size = np.abs(deflection)
        switched = np.stack([(flags & SWITCHED) > 0, (flags & TURN_SWITCHED) > 0], axis=-1)
        held = np.stack([(flags & HELD) > 0, (flags & TURN_HELD) > 0], axis=-1)
        drifts = (self._by_pulse ^ switched) & held             # nobody there: place is held
        by_axis = np.repeat(drifts, 3, axis=-1)
        # whoever turns a stick over has to let go of it before it clicks
        clicked = self._armed & (size >= hand.click) & by_axis & (self._left == 0)
        self._armed = np.where(size <= hand.dead_zone, True,
                               self._armed & ~clicked & by_axis)
        self._side = np.where(clicked, np.sign(deflection), self._side).astype(np.int8)
        self._left = np.where(clicked, self._pulse, np.where(by_axis, self._left, 0))
        push = np.where(self._left > 0, self._side, 0).astype(np.int8)
        self._left = np.maximum(self._left - 1, 0)
        rate = np.where((size > hand.dead_zone) & ~by_axis, deflection, 0.0)
        pressed = (flags & RESUME) > 0
        resume, self._resumed = pressed & ~self._resumed, pressed
        return Wish(push, hand.speed_m_s*rate[:, :3], np.radians(hand.rate_deg_s)*rate[:, 3:],
                    drifts, resume)
