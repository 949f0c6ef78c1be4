"""
Transit models of the link (how long a frame is on its way), and the settings of a link.

A model is a frozen dataclass with `delays(rng, size, hold_s) -> seconds`, NaN where the
frame never arrives. Transits scale with the play-out delay `hold_s` = nT of the leg, so one
setting serves every delay, and a direct link (hold_s = 0) is direct; only `empirical` is in
seconds, because its file is.

Source  Zhang, Li, Tang, J. Astronautics 35(3), 2014, section 1.3 leaves the transit open;
        gamma is chosen so that P(transit > nT) = P(Gamma(8, 1) > 16) = 0.010.
"""

from functools import cached_property
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.given import MAX_TABLE_BYTES, text_of

LONGEST_S = 1e6                 # [s] 11 days; transits beyond are refused, ns stay exact in int64
MOST_HOLDS = 100.0              # longest transit in play-out delays: beyond 1 a frame is late


class DelayModel(Protocol):
    """A transit model; its fields are its settings."""

    def delays(self, rng: np.random.Generator, size: tuple, hold_s: float) -> NDArray[np.float64]:
        """Return transits of shape `size` [s], not negative, NaN where a frame is lost."""


@settings
class Constant:
    """Every frame takes the same time."""

    transit_fraction: float = param(
        0.72, 'Transit time, as a fraction of the play-out delay.', low=0.0, high=MOST_HOLDS)

    def delays(self, rng: np.random.Generator, size: tuple, hold_s: float) -> NDArray[np.float64]:
        """Return transits [s] of shape `size`; draws nothing."""
        return np.full(size, self.transit_fraction * hold_s)


@settings
class Uniform:
    """Transit uniformly distributed between two bounds."""

    low_fraction: float = param(
        0.72, 'Shortest transit time, as a fraction of the play-out delay.',
        low=0.0, high=MOST_HOLDS)
    high_fraction: float = param(
        1.0, 'Longest transit time, as a fraction of the play-out delay.',
        low=0.0, high=MOST_HOLDS)

    def __post_init__(self) -> None:
        require(self.low_fraction <= self.high_fraction, 'high_fraction',
                f'not be below low_fraction {self.low_fraction:g}', self.high_fraction)

    def delays(self, rng: np.random.Generator, size: tuple, hold_s: float) -> NDArray[np.float64]:
        """Return transits [s] of shape `size`."""
        spread = (self.high_fraction - self.low_fraction) * hold_s
        return self.low_fraction * hold_s + spread * rng.random(size)


@settings
class Gamma:
    """A shortest transit plus a gamma-distributed queueing time."""

    offset_fraction: float = param(
        0.72, 'Shortest transit time, as a fraction of the play-out delay.',
        low=0.0, high=MOST_HOLDS)
    shape: float = param(
        8.0, 'Shape of the gamma distribution of the queueing time.', above=0.0, high=1000.0)
    scale_fraction: float = param(
        0.0175, 'Scale of the gamma distribution of the queueing time, as a fraction of the '
        'play-out delay.', low=0.0, high=MOST_HOLDS)

    def delays(self, rng: np.random.Generator, size: tuple, hold_s: float) -> NDArray[np.float64]:
        """Return transits [s] of shape `size`."""
        queueing = self.scale_fraction * hold_s * rng.standard_gamma(self.shape, size)
        return self.offset_fraction * hold_s + queueing


@settings
class Empirical:
    """Transits drawn with replacement from a file of measured ones."""

    file: str = param('', 'Text file of measured transit times in seconds, one per line after an '
                      'optional header line.')

    @cached_property
    def transits_s(self) -> NDArray[np.float64]:
        """Transits of the file [s], shape (m,); read once."""
        return read_transits(self.file)

    def delays(self, rng: np.random.Generator, size: tuple, hold_s: float) -> NDArray[np.float64]:
        """Return transits [s] of shape `size`; `hold_s` does not scale them."""
        return self.transits_s[rng.integers(0, len(self.transits_s), size)]


MODELS = {'constant': Constant, 'uniform': Uniform, 'gamma': Gamma, 'empirical': Empirical}


@settings
class LinkParams:
    """Settings of one direction of the link; each fault is off by default."""

    model: str = param('gamma', 'Model of the transit times.', choices=MODELS)
    constant: Constant = param(Constant, 'Settings of the constant model.')
    uniform: Uniform = param(Uniform, 'Settings of the uniform model.')
    gamma: Gamma = param(Gamma, 'Settings of the gamma model.')
    empirical: Empirical = param(Empirical, 'Settings of the empirical model.')
    loss_fraction: float = param(
        0.0, 'Probability that a copy of a frame is lost.', low=0.0, high=1.0)
    duplicate_fraction: float = param(
        0.0, 'Probability that the link makes a second copy of a frame.', low=0.0, high=1.0)
    corrupt_fraction: float = param(
        0.0, 'Probability that the payload of a copy is damaged.', low=0.0, high=1.0)
    reorder_fraction: float = param(
        0.0, 'Probability that a copy is held up on its way.', low=0.0, high=1.0)
    reorder_delay_s: float = param(
        1.0, 'Additional delay of a copy that is held up on its way [s].',
        low=0.0, high=LONGEST_S)
    burst_fraction: float = param(
        0.0, 'Share of the time in which the link is bad, in bursts.', low=0.0, high=0.5)
    burst_mean_s: float = param(
        2.0, 'Mean duration of a burst, at least a step [s].', above=0.0, high=LONGEST_S)
    burst_loss_fraction: float = param(
        1.0, 'Probability that a frame sent in a burst is lost, with its copy.', low=0.0, high=1.0)
    outage_windows_s: tuple = param(        # not (): ROS cannot tell the type of an empty list
        (0.0, 0.0), 'Start and end of each outage in turn, where equal values mean no outage '
        '[s].', low=0.0, high=LONGEST_S)

    def __post_init__(self) -> None:
        windows = self.outage_windows_s
        require(len(windows) % 2 == 0, 'outage_windows_s', 'be pairs of start and end',
                list(windows))
        for start, end in zip(windows[::2], windows[1::2]):
            require(start <= end, 'outage_windows_s', 'have start <= end in each pair',
                    [start, end])
        if self.model == 'empirical':
            self.empirical.transits_s       # a bad file is refused at the start, not in flight

    @property
    def delay_model(self) -> DelayModel:
        """The transit model in use, with its settings."""
        return getattr(self, self.model)

    @property
    def has_faults(self) -> bool:
        """Say whether any frame may be lost, copied, damaged or held up by chance."""
        return max(self.loss_fraction, self.duplicate_fraction, self.corrupt_fraction,
                   self.reorder_fraction) > 0.0

    @property
    def lost_to_bursts(self) -> float:
        """Probability that a frame is lost to a burst, in the long run."""
        return self.burst_fraction * self.burst_loss_fraction

    @cached_property
    def outages_ns(self) -> tuple:
        """Pairs (start, end) of the outages that last [ns]; the end is not part of one."""
        ns = [round(t * NS_PER_S) for t in self.outage_windows_s]
        return tuple((a, b) for a, b in zip(ns[::2], ns[1::2]) if a < b)


def read_transits(path: str) -> NDArray[np.float64]:
    """
    Read transits [s], one per line; the first line may be a header, `#` begins a comment.

    Parameters
    ----------
    path : str
        Relative paths start at the current directory.

    Returns
    -------
    ndarray, shape (m,), m >= 1

    Raises
    ------
    ValueError
        If the file cannot be read, has no transit, or has one that is not a number, negative,
        NaN or longer than 1e6 s; the text names the file and the line.
    """
    if not path:
        raise BadInput('empirical.file must name a file of transits, got nothing')
    try:
        lines = text_of(path, 'list of transits', MAX_TABLE_BYTES).splitlines()
    except BadInput as problem:
        raise BadInput(f'empirical.file {path} cannot be read: {problem}') from None
    transits: list[float] = []
    header_allowed = True
    for number, line in enumerate(lines, start=1):
        text = line.split('#')[0].strip()
        if not text:
            continue
        transit = _number(text)
        if transit is None and header_allowed:
            header_allowed = False
            continue
        header_allowed = False
        if transit is None or not 0.0 <= transit <= LONGEST_S:
            raise BadInput(f'{path}, line {number}: a transit must be a number of seconds '
                           f'between 0 and {LONGEST_S:g}, got {text!r}')
        transits.append(transit)
    if not transits:
        raise BadInput(f'{path}: no transit in the file')
    return np.array(transits)


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None
