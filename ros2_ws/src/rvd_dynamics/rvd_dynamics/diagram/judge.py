"""
What a judge declares and what it returns: measures, reasons, verdicts.

A mission's judge names the numbers by which a run is judged (`Measure`) and the reasons for
which a run ends. Tables, summaries, reports, terminal and console iterate over them and name
none themselves.

Batch   a `Verdict` holds arrays of the batch's shape; a `Judgement` is one run, ready to be shown,
        with the fields of `rvd_interfaces/Verdict`.
Limits  a good value lies strictly between `low` and `high`; NaN means that there is no such limit.
"""

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from math import isfinite, isnan
from typing import Any, NamedTuple, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput

NAN = float('nan')
# Reason of a run in which an ABORT came into force (`aborts`), and its words, in every mission.
ABORTED, ABORTED_WORDS = 'aborted', 'aborted'


@dataclass(frozen=True)
class Measure:
    """
    One number by which a run is judged.

    Raises
    ------
    ValueError
        If the name does not end in the unit, or no value can lie between the limits.
    """

    name: str                   # with the unit at its end: 'min_corridor_margin_m'
    unit: str                   # 'm/s'; empty: dimensionless
    words: str                  # what it is, for people: 'least corridor margin'
    low: float = NAN            # [unit] a good value is above this
    high: float = NAN           # [unit] a good value is below this
    digits: int = 3             # decimals worth showing
    of_all: bool = False        # its mean is over all runs, and not only over those that succeeded

    def __post_init__(self) -> None:
        if not self.name.isidentifier() or not self.name.endswith(_suffix(self.unit)):
            raise BadInput(f'measure {self.name!r} must be a plain word that ends in its unit, '
                           f'{_suffix(self.unit)!r}')
        if self.low >= self.high:
            raise BadInput(f'measure {self.name}: no value lies between the limits {self.low:g} '
                           f'and {self.high:g}')

    def ok(self, value: ArrayLike) -> NDArray[np.bool_]:
        """Return whether each value breaks no limit; an unknown one breaks every limit."""
        value = np.asarray(value, dtype=float)
        return ((value > self.low) | isnan(self.low)) & ((value < self.high) | isnan(self.high))


class Verdict(NamedTuple):
    """Judgement of runs, each field of the batch's shape (plain numbers for a single run)."""

    success: Any                # [bool]  every criterion held
    reason: Any                 # [text]  a key of the judge's `reasons`, or ABORTED; empty so far
    duration: Any               # [s]     from the start to the end of the run, or so far
    values: dict[str, Any]      # name of each measure: its value [its unit]; NaN while unknown
    happened: Any = None        # [s]     from the start to what the reason names; NaN, or None for
    #                                     all: with the end of the run, or not known


class Judge(Protocol):
    """
    Follows the truth of one run, or of a batch of runs, step by step.

    Its constructor names what it needs, as that of a block does (`diagram.build`), `batch` among
    it. Rows do not influence each other; a row that has ended keeps its judgement whatever comes.
    """

    measures: Sequence[Measure]
    reasons: Mapping[str, str]  # code: words for people, in the order in which they are listed

    def follow(self, k: int, truth: Any) -> None:
        """
        Take the truth of step k, a value of the plant's signal with a part `final`.

        Steps come in order, each once; the judge sees every step, up to the final one.
        """

    def verdict(self, final: bool = False) -> Verdict:
        """Return the verdict so far; with `final`, a run still under way has timed out."""


class Judged(NamedTuple):
    """A measure with its value in one run; the fields of `rvd_interfaces/Measure`."""

    name: str
    words: str
    unit: str
    value: float                # [unit] NaN while unknown
    low: float                  # [unit] NaN: no lower limit
    high: float                 # [unit] NaN: no upper limit
    ok: bool                    # no limit is broken
    digits: int

    @property
    def known(self) -> bool:
        """Whether there is a value."""
        return isfinite(self.value)

    @property
    def limited(self) -> bool:
        """Whether there is a limit on either side."""
        return not (isnan(self.low) and isnan(self.high))

    @property
    def limit(self) -> float:
        """The limit that files name: the upper one where there is one, NaN where there is none."""
        return self.low if isnan(self.high) else self.high

    @property
    def said(self) -> str:
        """Value and unit; a dash where it is unknown."""
        return f'{self.value:.{self.digits}f} {self.unit}'.strip() if self.known else '\u2013'

    @property
    def limits(self) -> str:
        """Where a good value lies; empty where there is no limit."""
        if not self.limited:
            return ''
        if isnan(self.low):
            return f'below {self.high:g} {self.unit}'.strip()
        if isnan(self.high):
            return f'above {self.low:g} {self.unit}'.strip()
        return f'between {self.low:g} and {self.high:g} {self.unit}'.strip()


class Judgement(NamedTuple):
    """The verdict on one run; the fields of `rvd_interfaces/Verdict`."""

    success: bool
    reason: str                 # empty while the run goes on
    words: str                  # the reason for people, with the time of what came before the end;
    #                             empty while the run goes on
    duration: float             # [s]
    measures: tuple[Judged, ...]

    @property
    def headline(self) -> str:
        """What happened and when, in a few words; a failure may come long before the end."""
        after = f'after {self.duration:.1f} s'
        if self.success:
            return f'{self.words} {after}'
        ended = f'; the run ended {after}' if isfinite(self.duration) else ''
        return f'failed: {self.words}{ended}'

    def value(self, name: str) -> float:
        """Return the value of a measure; NaN while unknown, or where there is no such measure."""
        return next((m.value for m in self.measures if m.name == name), NAN)


def aborted(verdict: Verdict, since: ArrayLike) -> Verdict:
    """
    Return a verdict that says of which runs an ABORT was in force before they ended.

    They were aborted, whatever the truth says besides: that is in the measures, which stay. A run
    under way has no reason yet.

    Parameters
    ----------
    since : array_like of float, of the batch's shape
        From the start of the run to where it came into force [s]; NaN: it never did.
    """
    in_force = ~np.isnan(since)
    if not np.any(in_force):
        return verdict
    over = np.asarray(verdict.reason) != ''
    reason = np.where(over & in_force, ABORTED, verdict.reason)
    success = np.asarray(verdict.success) & ~in_force
    happened = np.where(over & in_force, since,
                        NAN if verdict.happened is None else verdict.happened)
    if reason.ndim == 0:                        # of a single run, plain numbers
        reason, success, happened = reason.item(), success.item(), happened.item()
    return verdict._replace(success=success, reason=reason, happened=happened)


def judgement(judge: Judge, verdict: Verdict, row: int | tuple[int, ...] = ()) -> Judgement:
    """Return the verdict on one run of a batch; `row` () is the only run there is."""
    def one(values: Any) -> Any:
        return np.asarray(values)[row].item()

    reason = one(verdict.reason)
    words = ABORTED_WORDS if reason == ABORTED else judge.reasons.get(reason, reason)
    happened = NAN if verdict.happened is None else one(verdict.happened)
    if reason and isfinite(happened):
        words = f'{words} at {happened:.1f} s'
    return Judgement(
        one(verdict.success), reason, words, one(verdict.duration),
        tuple(_judged(m, one(verdict.values[m.name])) for m in judge.measures))


def _judged(m: Measure, value: float) -> Judged:
    return Judged(m.name, m.words, m.unit, float(value), float(m.low), float(m.high),
                  bool(m.ok(value)), m.digits)


def from_message(message: Any) -> Judgement:
    """
    Return the verdict in a `rvd_interfaces/Verdict`, decoded by ROS or from a bag.

    A bag of a version whose verdict had neither measures nor words gives one without measures.
    """
    return Judgement(
        message.success, message.reason, getattr(message, 'words', message.reason),
        message.duration,
        tuple(Judged(*(getattr(m, field) for field in Judged._fields))
              for m in getattr(message, 'measures', ())))


def as_dict(judged: Judgement) -> dict[str, Any]:
    """Return the verdict on one run as `verdict.json` keeps it; what is unknown is None."""
    return {
        'success': judged.success, 'reason': judged.reason, 'duration_s': judged.duration,
        'measures': {m.name: {'value': m.value if m.known else None, 'unit': m.unit,
                              'limit': m.limit if m.limited else None, 'ok': m.ok}
                     for m in judged.measures}}


def in_words(judged: Judgement) -> str:
    """Return the verdict on one run as lines for a terminal; unknown measures are left out."""
    known = [m for m in judged.measures if m.known]
    width = max((len(m.words) for m in known), default=0)
    value_width = max((len(m.said) for m in known), default=0)
    lines = [judged.headline]
    for m in known:
        limits = f'  ({"" if m.ok else "NOT "}{m.limits})' if m.limited else ''
        lines.append(f'  {m.words:<{width}}  {m.said:<{value_width}}{limits}'.rstrip())
    return '\n'.join(lines)


def for_page(judged: Judgement) -> dict[str, Any]:
    """Return the verdict on one run as the console's page takes it."""
    return {**judged._asdict(), 'measures': [m._asdict() for m in judged.measures]}


def table_columns(verdict: Verdict) -> dict[str, NDArray]:
    """Return the verdict on N runs as columns (N,) of a table: name and values."""
    named = {'success': verdict.success, 'reason': verdict.reason,
             'duration_s': verdict.duration, **verdict.values}
    return {name: np.asarray(values) for name, values in named.items()}


def declared(measures: Iterable[Measure]) -> dict[str, dict[str, Any]]:
    """Return what a file says about measures without their limits, which settings may change."""
    return {m.name: {'words': m.words, 'unit': m.unit, 'digits': m.digits,
                     **({'of_all': True} if m.of_all else {})} for m in measures}


def bare_name(name: str, unit: str) -> str:
    """Return the name of a measure without its unit, as words: 'min corridor margin'."""
    return name.removesuffix(_suffix(unit)).replace('_', ' ')


def _suffix(unit: str) -> str:
    """Return what a name ends in: '_m_s2' for 'm/s^2'."""
    return f'_{unit}'.replace('^', '').replace('/', '_').replace(' ', '_') if unit else ''
