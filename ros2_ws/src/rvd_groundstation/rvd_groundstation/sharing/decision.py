"""
Who decides: mode, sharing and the validity of both inputs determine one command.

manual  the pilot's levels; an invalid stick is level 0.
shared  both valid, even if the stick is neutral: the sharing. Stick invalid or no pilot: the
        automatic levels themselves (eta = 0), because blended with a zeroed stick they would
        come out as level 1 at most. Automatic command invalid: it counts as level 0.
auto    the automatic levels themselves; invalid is level 0.

A command with a level outside -3..3 or not whole is invalid as a whole, whatever its flag says.
"""

from math import isnan
from typing import NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands import codes
from rvd_groundstation.operators.operation import MODES

# As one byte each: numbers of Python would make every choice below eight times as wide.
NOBODY, PILOT, AUTO, BLEND = np.array(
    (codes.BY_NOBODY, codes.BY_PILOT, codes.BY_AUTO, codes.BY_BLEND), dtype=np.uint8)
NONE, MODE, PILOT_INVALID, AUTO_INVALID, BOTH_INVALID = np.array(
    (codes.REASON_NONE, codes.REASON_MODE, codes.REASON_PILOT_INVALID, codes.REASON_AUTO_INVALID,
     codes.REASON_BOTH_INVALID), dtype=np.uint8)


class Sharing(Protocol):
    """What `SHARING` lists."""

    @property
    def pilot_weight(self) -> float:
        """Weight of the pilot 0..1; NaN where nothing is weighted."""

    def share(self, pilot: ArrayLike, auto: ArrayLike) -> NDArray[np.int8]:
        """Combine two commands into one, shapes (..., 3)."""


class Decision(NamedTuple):
    """A command and its origin; one entry per row of the batch."""

    levels: NDArray[np.int8]            # (..., 3) -3..3 along x, y, z; 0 when not valid
    valid: NDArray[np.bool_]            # (...)    false: no input was valid
    decided_by: NDArray[np.uint8]       # (...)    BY_*
    pilot_weight: NDArray[np.float64]   # (...)    0..1; NaN when nothing was blended
    reason: NDArray[np.uint8]           # (...)    REASON_*


def decide(mode: str, sharing: Sharing, pilot: ArrayLike, pilot_valid: ArrayLike,
           auto: ArrayLike, auto_valid: ArrayLike) -> Decision:
    """
    Return the command of this step.

    Parameters
    ----------
    mode : str
        manual, shared or auto.
    sharing : Sharing
        An entry of `SHARING`; used in mode shared only.
    pilot, auto : array_like, shape (..., 3)
        Levels.
    pilot_valid, auto_valid : array_like of bool, shape (...)

    Returns
    -------
    Decision

    Raises
    ------
    ValueError
        If the mode is unknown.
    """
    if mode not in MODES:
        raise BadInput(f'mode must be one of {", ".join(MODES)}, got {mode}')
    pilot, pilot_valid = usable(pilot, pilot_valid)
    auto, auto_valid = usable(auto, auto_valid)
    if mode == 'manual':
        return _alone(pilot, pilot_valid, PILOT, PILOT_INVALID)
    if mode == 'auto':
        return _alone(auto, auto_valid, AUTO, AUTO_INVALID)
    return _shared(sharing, pilot, pilot_valid, auto, auto_valid)


def usable(levels: ArrayLike, valid: ArrayLike) -> tuple[NDArray[np.int8], NDArray[np.bool_]]:
    """Return levels as int8, 0 where invalid, and which rows are valid: whole and -3..3."""
    levels = np.asarray(levels)
    whole = (levels >= -3) & (levels <= 3)              # NaN compares false
    if levels.dtype.kind == 'f':
        whole &= levels == np.rint(levels)
    good = whole[..., 0] & whole[..., 1] & whole[..., 2] & np.asarray(valid, dtype=bool)
    if not good.all():
        levels = np.where(good[..., None], levels, 0)
    return levels.astype(np.int8, copy=False), good


def _alone(levels: NDArray, valid: NDArray, by: np.uint8, reason_invalid: np.uint8) -> Decision:
    """Pass one source on, as the mode says."""
    return Decision(levels, valid, np.where(valid, by, NOBODY), np.full(valid.shape, np.nan),
                    np.where(valid, MODE, reason_invalid))


def _shared(sharing: Sharing, pilot: NDArray, pilot_valid: NDArray, auto: NDArray,
            auto_valid: NDArray) -> Decision:
    levels, by, weight, reason = sharing.share(pilot, auto), BLEND, sharing.pilot_weight, NONE
    if isnan(weight):                                   # a filter: did the pilot's levels pass?
        same = levels == pilot
        by = np.where(same[..., 0] & same[..., 1] & same[..., 2], PILOT, AUTO)
    if not (pilot_valid.all() and auto_valid.all()):
        levels = np.where(pilot_valid[..., None], levels, auto)
        by = np.where(pilot_valid, by, np.where(auto_valid, AUTO, NOBODY))
        weight = np.where(pilot_valid, weight, np.where(auto_valid, 0.0, np.nan))
        reason = np.where(pilot_valid, np.where(auto_valid, NONE, AUTO_INVALID),
                          np.where(auto_valid, PILOT_INVALID, BOTH_INVALID))
    valid = pilot_valid | auto_valid
    return Decision(levels, valid, _full(by, np.uint8, valid), _full(weight, float, valid),
                    _full(reason, np.uint8, valid))


def _full(value: ArrayLike, dtype: type, like: NDArray) -> NDArray:
    """Return a value for each row, or as it is if it has one for each."""
    return value if np.ndim(value) else np.full(like.shape, value, dtype=dtype)
