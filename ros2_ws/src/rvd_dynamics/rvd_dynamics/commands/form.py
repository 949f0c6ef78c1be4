"""
Command forms: the alphabet of commands, and what each command does.

A law says what it wants in SI units; the form makes a command of it. Sharing and the guard work on
commands. A form is a frozen dataclass; `quantise(effect(c)) == c` for every command c, which a
contract test asks of each entry of FORMS.
"""

from collections.abc import Sequence
from struct import Struct
from typing import Any, Protocol

from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.acceleration import BangBang, Continuous, Pulses, RateLimited
from rvd_dynamics.commands.levels import LevelForm
from rvd_dynamics.diagram.params import choice


class CommandForm(Protocol):
    """What blocks ask of a command form; commands have shape (..., n)."""

    neutral: NDArray                    # (n,) no effect
    retreat: NDArray                    # (n,) what an ABORT commands: brake and back away
    wire: Struct                        # layout of one command in a frame, little-endian

    def effect(self, command: ArrayLike) -> NDArray[Any]:
        """Return what commands do, in SI units; their nominal acceleration, for instance."""

    def quantise(self, wanted: ArrayLike) -> NDArray[Any]:
        """Return the commands nearest to what is wanted; neutral where it is not finite."""

    def follow(self, last: ArrayLike, wanted: ArrayLike) -> NDArray[Any]:
        """Return the commands nearest to what is wanted that can come a step after `last`."""

    def legal(self, command: Sequence) -> bool:
        """Say whether numbers from the wire are a command of this form."""


FORMS = {'levels': LevelForm, 'continuous': Continuous, 'rate_limited': RateLimited,
         'bang_bang': BangBang, 'pulses': Pulses}
ThrusterParams = choice(
    'ThrusterParams', 'form', {name: form for name, form in FORMS.items() if name != 'levels'},
    'continuous', 'Alphabet of the thrusters.')
