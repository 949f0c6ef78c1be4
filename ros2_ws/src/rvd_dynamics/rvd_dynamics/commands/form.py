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
from rvd_dynamics.diagram.params import choice, param, settings
from rvd_dynamics.diagram.scenario import Scenario
from rvd_dynamics.diagram.signal import Part


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

UNITS = {'f': 'm/s^2', 'i': 'levels'}


def thruster_form(scenario: Scenario) -> CommandForm:
    """Return the command form that the settings `thrust` of a scenario pick."""
    return scenario.wired(scenario.part('thrust').selected)


def part(form: CommandForm) -> Part:
    """Return the part of a signal that carries commands of a form of thrusters."""
    kind = form.neutral.dtype
    most = getattr(form, 'max_m_s2', None) if kind.kind == 'f' else None
    return Part('command', form.neutral.shape, UNITS[kind.kind], kind.str[1:], initial=0.0,
                low=None if most is None else -most, high=most)


def thrusters(max_m_s2: float) -> type:
    """
    Return the settings of thrusters along three axes: `form` and the settings of each form.

    `max_m_s2` is their largest acceleration [m/s^2] where a scenario says nothing.
    """
    def of_size(form: type) -> type:
        most = param(max_m_s2, form.__dataclass_fields__['max_m_s2'].metadata['doc'],
                     above=0.0, high=1000.0)
        return settings(type(form.__name__, (form,), {
            '__doc__': form.__doc__, '__annotations__': {'max_m_s2': float}, 'max_m_s2': most}))

    return choice('ThrusterParams', 'form', {
        name: of_size(form) for name, form in FORMS.items() if name != 'levels'},
        'continuous', 'Alphabet of the thrusters.')
