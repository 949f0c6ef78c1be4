"""
What a law needs around it, on board or on the ground: past samples, and the command that acted.

A sample that was lost is replaced by the straight line through the two before it, up to BRIDGED
times in a row; then the attitude is unknown and the command neutral.
"""

from collections import deque

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram.params import choice
from rvd_missions.attitude_hold.commands import TorqueForm
from rvd_missions.attitude_hold.laws import Law, LAWS
from rvd_missions.attitude_hold.settings import Attitude

ControllerParams = choice('ControllerParams', 'law', LAWS, 'golden_section',
                          'Law that holds the axis.')
BRIDGED = 4                     # samples in a row that may be missing
INSIDE = 3                      # numbers that a law may show of what it believes


class Control:
    """A law with its samples and commands."""

    def __init__(self, law: Law, form: TorqueForm, attitude: Attitude, step_s: float,
                 loop_steps: int, batch: tuple) -> None:
        self._law, self._form = law.controller(step_s, batch), form
        self._reference, self._step_s = attitude, step_s
        unknown = np.full(batch, np.nan)
        self._samples = deque([unknown]*3, maxlen=3)                # newest first
        self._missing = deque([np.ones(batch, dtype=bool)]*3, maxlen=3)
        self._gap = np.zeros(batch, dtype=np.int64)
        # The newest sample is the end of the interval on which the oldest of these acted.
        self._effects = deque([np.zeros(batch)]*(loop_steps + 1), maxlen=loop_steps + 1)

    def command(self, k: int, angle: NDArray, received: NDArray) -> NDArray[np.float64]:
        """Return the command (..., 1) of step k for a measured angle (...) [rad], if one came."""
        first, second = self._samples[0], self._samples[1]
        self._gap = np.where(received, 0, self._gap + 1)
        bridged = np.where(self._gap > BRIDGED, np.nan, 2.0*first - second)
        self._samples.appendleft(np.where(received, angle, bridged))
        self._missing.appendleft(~received)
        self.reference = self._reference.at(k, self._step_s)
        errors = tuple(sample - self.reference for sample in self._samples)
        self.error = errors[0]
        fresh = ~(self._missing[0] | self._missing[1] | self._missing[2])
        # The first command of a run has one sample behind it: the axis is taken to be at rest.
        errors = (errors[0], *(np.where(np.isfinite(e), e, errors[0]) for e in errors[1:]))
        wanted = self._law.wanted(errors, self._effects[0], fresh)
        command = self._form.quantise(wanted[..., np.newaxis])
        self._effects.append(self._form.effect(command)[..., 0])
        return command

    @property
    def inside(self) -> NDArray[np.float64]:
        """Return (..., 3) what the law believes or remembers; NaN where it has fewer numbers."""
        shown = list(self._law.inside.values())[:INSIDE]
        blank = np.full(np.shape(self.error), np.nan)
        return np.stack([*shown, *[blank]*(INSIDE - len(shown))], axis=-1)
