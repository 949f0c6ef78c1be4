"""
An optimal control problem, said once, for the planner that solves it.

Minimise    end(x0, xf, t0, tf, p) + integral over time of running(t, x, u, p)
subject to  x' = rate(t, x, u, p), bounds on states and controls, path constraints and end
            conditions.

The functions take and return scalars of casadi, and are called while a solver is built, never
while it runs: they may use operators and the functions of casadi on them.
"""

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from math import inf, isfinite
from typing import Any

Scalars = Sequence[Any]                 # of casadi.SX


@dataclass(frozen=True)
class Quantity:
    """A state or a control; `scale` is its usual size, in which errors are counted."""

    name: str
    unit: str = ''
    scale: float = 1.0
    low: float = -inf
    high: float = inf

    def __post_init__(self) -> None:
        if not (isfinite(self.scale) and self.scale > 0.0):
            raise ValueError(f'{self.name}: scale must be positive, got {self.scale}')
        if not self.low <= self.high:
            raise ValueError(f'{self.name}: low {self.low} must not be above high {self.high}')


@dataclass(frozen=True)
class Path:
    """A constraint at every node: low <= of(t, x, u, p) <= high."""

    name: str
    of: Callable[[Any, Scalars, Scalars, Scalars], Any]
    low: float = -inf
    high: float = inf
    unit: str = ''
    scale: float = 1.0
    # What a person is told of it where it is not what is computed: the square of a speed, say.
    shown: Callable[[float], float] | None = None


@dataclass(frozen=True)
class End:
    """A condition on both ends: low <= of(x0, xf, t0, tf, p) <= high."""

    name: str
    of: Callable[[Scalars, Scalars, Any, Any, Scalars], Any]
    low: float = 0.0
    high: float = 0.0
    unit: str = ''
    scale: float = 1.0
    shown: Callable[[float], float] | None = None


@dataclass(frozen=True)
class Problem:
    """
    What is to be planned.

    Attributes
    ----------
    states, controls : tuple of Quantity
        Their bounds hold at all nodes and at the end; the start is what it is.
    rate : callable
        (t, x, u, p) -> the time derivative of each state.
    running, end : callable
        Cost rate (t, x, u, p), and cost of the ends (x0, xf, t0, tf, p); None: there is none.
    paths, ends : tuple
        Constraints at every node, and on the ends.
    parameters : tuple of str
        Names of numbers that may change from one solution to the next.
    """

    states: tuple[Quantity, ...]
    controls: tuple[Quantity, ...]
    rate: Callable[[Any, Scalars, Scalars, Scalars], Scalars]
    running: Callable[[Any, Scalars, Scalars, Scalars], Any] | None = None
    end: Callable[[Scalars, Scalars, Any, Any, Scalars], Any] | None = None
    paths: tuple[Path, ...] = ()
    ends: tuple[End, ...] = ()
    parameters: tuple[str, ...] = ()
