"""
Limits of a signal's numbers: what a reader believes of a message, and a block of its own estimate.

A part declares `low`, `high`, `codes`, `counts` or `spread` (`diagram.signal.Part`). Where it does
not, this holds:

    float           NaN, which is "unknown", or within -LARGEST to LARGEST; a `command` is known
    whole number    what its type holds, and beyond 32 bits what a float64 holds exactly
    enumeration     the codes of the message that its unit names: KIND_*, BY_*, REASON_*

`checker` reads a signal's declaration once and returns a function that looks at one value, as
codecs decode it, in a few microseconds. Nothing here runs where a diagram is flown in one process.
"""

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.signal import Part, Signal

LARGEST = 1e15                  # of any unit here; its fourth power is far from the largest float
EXACT = 2**53                   # largest whole number up to which float64 has every one
ENUMERATIONS = {'KIND_*': codes.KIND_RESUME, 'BY_*': codes.BY_GUARD, 'REASON_*': codes.REASON_ABORT}
ROUNDING = 1e-6                 # of a correlation: covariances are not symmetric to the last bit

Test = Callable[[Any, int], str]        # value of a part, step: what is wrong; '' if nothing


def bounds(part: Part) -> tuple[float, float]:
    """Return the least and the largest number that a part may hold."""
    kind = np.dtype(part.dtype)
    if kind.kind == 'f':
        low, high = -LARGEST, LARGEST
    elif kind.kind == 'b':
        low, high = 0, 1
    else:
        info = np.iinfo(kind)
        low, high = max(int(info.min), -EXACT), min(int(info.max), EXACT)
        high = ENUMERATIONS.get(part.unit, high)
        low = 0 if part.unit in ENUMERATIONS else low
    return (low if part.low is None else part.low), (high if part.high is None else part.high)


def checker(signal: Signal, optional: tuple = ()) -> Callable[[Any, int], str]:
    """
    Return a function of a value, without batch axes, and the step in which it was emitted.

    It returns in a few words why the value cannot be; nothing if it can. Shapes are right already.
    A covariance that may be left out is looked at where `optional` names it, since it takes
    longest.
    """
    tests = [(i, part.name, test) for i, part in enumerate(signal.parts)
             for test in _tests(part, not part.optional or part.name in optional)]
    names = [part.name for part in signal.parts]
    known = names.index('state') if {'state', 'valid'} <= set(names) else -1
    valid = names.index('valid') if known >= 0 else -1

    def complaint(value: Any, step: int) -> str:
        for i, name, test in tests:
            given = value[i]
            if given is not None:               # an optional part that was left out
                why = test(given, step)
                if why:
                    return f'{name} {why}'
        if known >= 0 and value[valid] and any(x != x for x in _numbers(value[known])):
            return 'state must be known where valid is true, got NaN'
        return ''
    return complaint


def _tests(part: Part, used: bool) -> list[Test]:
    """Return what a part must pass."""
    if part.dtype == 'O':
        return []
    kind = np.dtype(part.dtype).kind
    found: list[Test] = []
    if kind == 'f' and part.spread:
        return [_covariance if used else _no_number_beyond]
    if part.codes:
        found.append(_one_of(part))
    elif kind == 'f' or _narrower(part):
        found.append(_within(part))
    if part.counts:
        found.append(_counted)
    return found


def _narrower(part: Part) -> bool:
    """Say whether a whole number has limits that its type does not hold it to."""
    info = np.iinfo(part.dtype) if np.dtype(part.dtype).kind in 'iu' else None
    return info is not None and bounds(part) != (int(info.min), int(info.max))


def _numbers(given: Any) -> list:
    if isinstance(given, np.ndarray) and given.ndim:
        return given.ravel().tolist()
    return [given.item() if isinstance(given, (np.generic, np.ndarray)) else given]


def _within(part: Part) -> Test:
    low, high = bounds(part)
    unknown = np.dtype(part.dtype).kind == 'f' and part.name != 'command'

    def test(given: Any, _: int) -> str:
        for x in _numbers(given):
            if not low <= x <= high and not (unknown and x != x):
                return f'must be from {low:g} to {high:g}, got {x:g}'
        return ''
    return test


def _one_of(part: Part) -> Test:
    allowed = frozenset(part.codes)
    words = ', '.join(map(str, part.codes))

    def test(given: Any, _: int) -> str:
        for x in _numbers(given):
            if x not in allowed:
                return f'must be one of {words}, got {x}'
        return ''
    return test


def _counted(given: Any, step: int) -> str:
    for x in _numbers(given):
        if x > step + 1:
            return f'must be {step + 1} at most in step {step}, got {x:g}'
    return ''


def _no_number_beyond(given: NDArray, _: int) -> str:
    beyond = given[np.abs(given) > LARGEST]
    if beyond.size:
        return f'must be from {-LARGEST:g} to {LARGEST:g}, got {beyond[0]:g}'
    return ''


def _covariance(given: NDArray, step: int) -> str:
    """Say what keeps numbers (..., n, n) from being covariances."""
    n, beyond = given.shape[-1], _no_number_beyond(given, step)
    if beyond or given.ravel()[0] != given.ravel()[0]:
        return beyond                           # or nothing is estimated: the rest says nothing
    rows = given.reshape(-1, n, n)
    if np.isnan(rows).any():
        return 'must be NaN from its first element on where nothing is estimated'
    variance = np.diagonal(rows, 0, 1, 2)
    if not (variance >= 0.0).all():
        return f'is no covariance: a variance is {variance.min():g}'
    scale = np.sqrt(np.where(variance > 0.0, variance, 1.0))
    correlation = rows/(scale[:, :, None]*scale[:, None, :])
    if not (np.abs(correlation - correlation.transpose(0, 2, 1)) <= ROUNDING).all():
        return 'is no covariance: it is not symmetric'
    try:
        np.linalg.cholesky(correlation + ROUNDING*np.eye(n))
    except np.linalg.LinAlgError:
        return 'is no covariance: it is not positive semi-definite'
    return ''


def held_by(dtype: np.dtype) -> tuple[int, int]:
    """
    Return the least and the largest whole number of a type, or of flags, that a float64 holds.
    """
    if dtype.kind == 'b':
        return 0, 1
    return max(int(np.iinfo(dtype).min), -EXACT), min(int(np.iinfo(dtype).max), EXACT)
