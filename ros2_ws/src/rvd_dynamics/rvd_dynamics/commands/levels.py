"""
Thrust levels -3 .. 3 along x, y, z of the target orbital frame.

Shapes  levels, accelerations and deflections carry x, y, z on the last axis; leading axes
        are batch axes.
Source  Zhang, Li, Tang 2014, Table 2 (accelerations). The paper does not say how a force
        becomes a level; here it is the nearest one, with thresholds half-way between levels.
"""

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from math import isnan
from struct import Struct
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.layouts import LAYOUTS
from rvd_dynamics.diagram.params import param, require, settings

HIGHEST = 3                             # levels run from -HIGHEST to HIGHEST
LEVELS = range(-HIGHEST, HIGHEST + 1)
AXES = np.arange(3, dtype=np.int8)
NEUTRAL = np.zeros(3, dtype=np.int8)
NEUTRAL.flags.writeable = False
ROUNDING = 1e-6                         # a float32 at full deflection may be 1.0000001


@settings
class ThrustParams:
    """Thrust acceleration of the levels 1, 2, 3 (Table 2)."""

    x_m_s2: tuple = param(
        (0.01, 0.02, 0.03), 'Accelerations of the levels 1, 2, 3 along x [m/s^2].',
        above=0.0, length=3, rising=True)
    lateral_m_s2: tuple = param(
        (0.005, 0.01, 0.02), 'Accelerations of the levels 1, 2, 3 along y and z [m/s^2].',
        above=0.0, length=3, rising=True)


@settings
class StickParams:
    """
    How a `sensor_msgs/Joy` becomes levels; the defaults are those of the `joy` ecosystem.

    A key that a scenario gives counts before what its `layout` says.
    """

    layout: str = param(
        'xbox', 'Pad or stick whose axes and dead-man button are the defaults of the keys below.',
        choices=LAYOUTS)
    axis_x: int = param(1, 'Index of the axis that commands x.', low=0, high=63)
    axis_y: int = param(0, 'Index of the axis that commands y.', low=0, high=63)
    axis_z: int = param(4, 'Index of the axis that commands z.', low=0, high=63)
    sign_x: int = param(1, 'Sense of the x axis, where -1 reverses it.', choices=(1, -1))
    sign_y: int = param(1, 'Sense of the y axis, where -1 reverses it.', choices=(1, -1))
    sign_z: int = param(1, 'Sense of the z axis, where -1 reverses it.', choices=(1, -1))
    dead_zone: float = param(
        0.05, 'Deflection up to which an axis counts as neutral, as a fraction of full '
        'deflection.', low=0.0, below=1.0)
    deadman_button: int = param(
        4, 'Index of the button that must be held, where -1 means none.', low=-1, high=63)

    @staticmethod
    def preset(given: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return the values of the keys that are not given, where the layout names them."""
        return LAYOUTS.get(given.get('layout', 'xbox'), {})

    def __post_init__(self) -> None:
        require(len({self.axis_x, self.axis_y, self.axis_z}) == 3, 'axis_x, axis_y, axis_z',
                'differ', [self.axis_x, self.axis_y, self.axis_z])


@lru_cache(maxsize=16)
def _accelerations(thrust: ThrustParams) -> NDArray[np.float64]:
    """Return the acceleration [m/s^2] of level l along axis i at `[l + HIGHEST, i]`."""
    rising = np.array([thrust.x_m_s2, thrust.lateral_m_s2, thrust.lateral_m_s2]).T
    return np.concatenate([-rising[::-1], np.zeros((1, 3)), rising])


@lru_cache(maxsize=16)
def _thresholds(thrust: ThrustParams) -> NDArray[np.float64]:
    """Return the mid-point [m/s^2] below level l = 1, 2, 3 of axis i at `[l - 1, i]`."""
    table = _accelerations(thrust)[HIGHEST:]
    return (table[:-1] + table[1:]) / 2.0


def acceleration(levels: ArrayLike, thrust: ThrustParams) -> NDArray[np.float64]:
    """
    Return the nominal acceleration of levels.

    Parameters
    ----------
    levels : array_like of int, shape (..., 3)
        Levels, -3 to 3.
    thrust : ThrustParams
        Table 2.

    Returns
    -------
    ndarray, shape (..., 3)
        Acceleration [m/s^2].

    Raises
    ------
    ValueError
        If a level is not a whole number from -3 to 3.
    """
    levels = np.asarray(levels)
    if levels.dtype.kind not in 'iu':
        raise BadInput(f'levels must be whole numbers, got {levels.tolist()}')
    index = levels + HIGHEST
    if index.size and not (index.min() >= 0 and index.max() <= 2 * HIGHEST):
        raise BadInput(f'levels must be -3 to 3, got {levels[abs(levels) > 3].tolist()}')
    # transposed there and back: in a batch the components come first in memory
    return _accelerations(thrust).ravel().take((3*index + AXES).T).T


def nearest_level(accel: ArrayLike, thrust: ThrustParams) -> NDArray[np.int8]:
    """
    Return the level whose acceleration is nearest, shape (..., 3); a tie takes the larger.

    A value that is not finite gives level 0; that it is invalid must be passed on separately.
    """
    accel = np.asarray(accel, dtype=float)
    size = np.abs(accel)
    first, second, third = _thresholds(thrust)
    level = (size >= first).view(np.int8)           # bytes all the way: a third less time
    level += (size >= second).view(np.int8)
    level += (size >= third).view(np.int8)
    level *= np.isfinite(size).view(np.int8)
    level *= 1 - 2*(accel < 0.0).view(np.int8)
    return level


def level_of_deflection(deflection: ArrayLike, dead_zone: float = 0.05) -> NDArray[np.int8]:
    """
    Return the level of stick deflections of any shape: sign(a) floor(3 |a| + 0.5).

    A deflection up to `dead_zone` is neutral. A stick at level / 3, where tapes and models put
    it, gives that level.

    Raises
    ------
    ValueError
        If a deflection is NaN or beyond -1 .. 1.
    """
    deflection = np.asarray(deflection, dtype=float)
    size = np.abs(deflection)
    if not np.all(size <= 1.0):                     # also refuses NaN
        raise BadInput(f'deflection must be -1 to 1, got {deflection.tolist()}')
    level = np.floor(3.0 * size + 0.5).astype(np.int8)
    level *= size > dead_zone
    return np.where(deflection < 0.0, -level, level)


def stick_axes(deflection: Sequence[float], held: bool, stick: StickParams
               ) -> tuple[list[float], list[int]]:
    """
    Return axes and buttons of a `sensor_msgs/Joy`, of which `stick_levels` makes levels again.

    Parameters
    ----------
    deflection : sequence of float, length 3
        Along x, y, z, each -1 to 1.
    held : bool
        The dead-man button is held; nothing says so where `stick` has none.
    """
    wanted = (stick.axis_x, stick.axis_y, stick.axis_z)
    axes = [0.0] * (1 + max(wanted))
    for axis, sign, value in zip(wanted, (stick.sign_x, stick.sign_y, stick.sign_z), deflection):
        axes[axis] = sign*value + 0.0                   # not -0.0
    buttons = [0] * stick.deadman_button + [int(held)] if stick.deadman_button >= 0 else []
    return axes, buttons


def stick_fault(axes: Sequence[float], buttons: Sequence[int], stick: StickParams) -> str:
    """
    Return in a few words why one `sensor_msgs/Joy` is invalid; nothing if it is valid.

    Only the axes and the button that `stick` names count: triggers rest at 1, and drivers send NaN
    or more than 1 on axes that nobody uses. The words name no reading, so that a stick that
    stays at fault is said once.
    """
    for name, axis in (('x', stick.axis_x), ('y', stick.axis_y), ('z', stick.axis_z)):
        if axis >= len(axes):
            return (f'axis {axis} ({name}) is not there: Joy has {len(axes)} axes' if len(axes)
                    else 'Joy has no axes')
        if isnan(axes[axis]):
            return f'axis {axis} ({name}) is not a number'
        if not abs(axes[axis]) <= 1.0 + ROUNDING:
            return f'axis {axis} ({name}) is beyond -1 to 1'
    deadman = stick.deadman_button
    if deadman >= len(buttons):
        return f'dead-man button {deadman} is not there: Joy has {len(buttons)} buttons'
    if deadman >= 0 and buttons[deadman] != 1:
        return f'dead-man button {deadman} is not held'
    return ''


def stick_levels(axes: Sequence[float], buttons: Sequence[int],
                 stick: StickParams) -> tuple[NDArray[np.int8], bool]:
    """
    Return the levels (3,) of one `sensor_msgs/Joy` and whether the message is valid.

    One that `stick_fault` finds fault with is invalid as a whole, and its levels are 0.
    """
    if stick_fault(axes, buttons, stick):
        return NEUTRAL.copy(), False
    wanted = [axes[i] for i in (stick.axis_x, stick.axis_y, stick.axis_z)]
    levels = level_of_deflection(np.clip(wanted, -1.0, 1.0), stick.dead_zone)
    return levels * np.array((stick.sign_x, stick.sign_y, stick.sign_z), dtype=np.int8), True


@dataclass(frozen=True)
class LevelForm:
    """
    The command form of level thrusters; see `commands.form`.

    A command is three whole levels -3..3 along x, y, z, shape (..., 3) of int8.
    """

    thrust: ThrustParams = ThrustParams()

    alphabet = np.arange(-HIGHEST, HIGHEST + 1, dtype=np.int8)      # of each axis
    neutral = NEUTRAL
    retreat = np.array((-HIGHEST, 0, 0), dtype=np.int8)             # brake and back away
    wire = Struct('<3b')

    def effect(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return the nominal acceleration (..., 3) [m/s^2] of commands (..., 3)."""
        return acceleration(command, self.thrust)

    def quantise(self, wanted: ArrayLike) -> NDArray[np.int8]:
        """Return the command nearest to accelerations (..., 3) [m/s^2]; neutral where unknown."""
        return nearest_level(wanted, self.thrust)

    def follow(self, last: ArrayLike, wanted: ArrayLike) -> NDArray[np.int8]:
        """Return the command after `last`: levels have no memory."""
        return self.quantise(wanted)

    def legal(self, command: Sequence) -> bool:
        """Say whether a command, as it came over the wire, is one (NaN and 1.5 are not)."""
        return all(level in LEVELS for level in command)
