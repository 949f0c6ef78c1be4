"""
Model pilots: who moves the stick when nobody sits at it.

`PILOTS` lists their forms by the name a scenario gives. Each is a frozen dataclass of settings
with `flying(draws, skill_normal, batch)`, which returns pilots at the displays, one per row. What
a form must know besides its settings (the run, the cone, the thrust levels, the legs of the
link) it names as a field made by `wiring()`, and gets that and nothing else. Add one: one file,
one line here.

`PERSONS` lists pilots with numbers of their own, fitted or assumed, by the name that a campaign
gives (`pilot: A`).
"""

from dataclasses import fields, make_dataclass
from typing import Any, Protocol

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.diagram.params import flatten, param
from rvd_dynamics.diagram.streams import PilotDraws
from rvd_groundstation.operators.human_control import HumanControl
from rvd_groundstation.operators.pulses import Pulses
from rvd_groundstation.operators.recorded import Recorded


class Pilot(Protocol):
    """What flies: called once per step, in order."""

    def advance(self, step: int, estimate: ArrayLike, predicted: ArrayLike, valid: ArrayLike
                ) -> NDArray[np.int8]:
        """
        Return the levels at which the stick stands in this step.

        Parameters
        ----------
        step : int
            0, 1, 2, ... in order.
        estimate : array_like, shape (..., 6)
            What the display of the telemetry shows: the state as it was.
        predicted : array_like, shape (..., 6)
            What the display of the prediction shows: the state when a command will act.
        valid : array_like of bool, shape (...)
            Rows in which both are known.

        Returns
        -------
        ndarray of int8, shape (..., 3)
            Levels -3..3; neutral until the first displays.
        """


class PilotForm(Protocol):
    """
    What `PILOTS` lists.

    `./rvd calibrate` asks for two properties more: `fitted_first`, the name of the number that it
    fits to the success rate, and `idle`, the names of those that do nothing with these settings.
    """

    def flying(self, draws: PilotDraws, skill_normal: ArrayLike, batch: tuple = ()) -> Pilot:
        """
        Return pilots with a neutral stick, one per row.

        Parameters
        ----------
        draws : PilotDraws
            Draws of the runs, with leading axes `batch`: all chance that a pilot has. A form uses
            what it needs, and all forms are given the same.
        skill_normal : array_like, shape `batch`
            Standard normal draw of each person's skill.
        batch : tuple
            Shape of the leading axes.
        """


FIRST = 'pulses'                        # its numbers stand in the section itself
PILOTS = {
    FIRST: Pulses,
    'human_control': HumanControl,
    'recorded': Recorded,
}


PERSONS = {
    'A': Pulses(),
    'B': Pulses(skill_gain=1.0, display=False),         # with the display only in condition 2
    'C': Pulses(skill_gain=1.77, skill_spread=0.20),
    'H': HumanControl(),
}


def form_of(pilot: PilotForm) -> str:
    """
    Return the name of a pilot's form.

    Raises
    ------
    LookupError
        If the form is none of `PILOTS`.
    """
    for name, form in PILOTS.items():
        if type(pilot) is form:
            return name
    raise LookupError(f'{type(pilot).__name__} is none of the forms in PILOTS')


def keys_of(pilot: PilotForm) -> dict[str, Any]:
    """Return the keys of the section `operator_model` that make a pilot, `form` first."""
    name = form_of(pilot)
    return {'form': name, **flatten(pilot, '' if name == FIRST else f'{name}.')}


class _Section:
    """What the section `operator_model` can do besides holding numbers."""

    @property
    def selected(self) -> PilotForm:
        """The form that flies, with its numbers."""
        if self.form != FIRST:
            return getattr(self, self.form)
        return PILOTS[FIRST](**{f.name: getattr(self, f.name) for f in fields(PILOTS[FIRST])})

    def operator_of(self, run: int) -> int:
        """Return the operator who flies a run, which is the key of `skill_normal`."""
        return run // self.runs_per_operator


def _section() -> type:
    """Return the settings class of the section: `form`, who flies how often, and all numbers."""
    common = [
        ('form', str, param(FIRST, 'Form of the model pilot: how he decides and acts.',
                            choices=PILOTS)),
        ('runs_per_operator', int, param(
            1, 'Number of consecutive runs that are flown by one person.', low=1))]
    others = [(name, form, param(form, f'Settings of {name}.'))
              for name, form in PILOTS.items() if name != FIRST]
    first = PILOTS[FIRST]
    return make_dataclass(
        'OperatorParams', common + others, bases=(_Section, first), frozen=True, namespace={
            '__doc__': 'Model pilot.\n\n`form` says which. The numbers of the first, '
                       f'`{FIRST}`, stand here, those of any other under its name.',
            '__post_init__': first.__post_init__, '__module__': __name__})


OperatorParams = _section()
