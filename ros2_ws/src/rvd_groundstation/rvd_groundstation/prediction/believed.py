"""
What the predictor takes commands for, where that is not what they do.

An ablation: the model of the thrust is wrong by a factor, the craft is as it is. Every command
counts for so much more or less, in flight, in the filter and in an ABORT.
"""

from dataclasses import dataclass

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.commands.form import CommandForm


@dataclass(frozen=True)
class Believed:
    """A command form for those who only ask what commands do: `bias` times what `form` says."""

    form: CommandForm
    bias: float

    @property
    def neutral(self) -> NDArray:
        """The command that does nothing."""
        return self.form.neutral

    @property
    def retreat(self) -> NDArray:
        """The command of an ABORT."""
        return self.form.retreat

    def effect(self, command: ArrayLike) -> NDArray[np.float64]:
        """Return what is believed of a command (..., n) [m/s^2]."""
        return self.bias*self.form.effect(command)


def believed(form: CommandForm, bias: float) -> CommandForm | Believed:
    """Return the form as it is believed to be; itself, where it is believed as it is."""
    return form if bias == 1.0 else Believed(form, bias)
