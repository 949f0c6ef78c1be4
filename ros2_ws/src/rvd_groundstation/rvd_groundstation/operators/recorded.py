"""
Pilot made of what people did: stretches of recorded responses, drawn by the state they answered to.

Table   CSV with the header `flight,step,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s,level_x,level_y,level_z`:
        the predicted state that the display showed in a step of a flight, and where the stick
        stood; lines that begin with `#` are comments. `rvd_missions.lunar_approach.responses`
        makes it of the bags of manual flights.
Draw    stationary bootstrap (D. N. Politis, J. P. Romano, J. Am. Stat. Assoc. 89, 1994,
        1303-1313), conditioned on the state: on each axis by itself the stick does what it did in
        a recorded stretch of geometrically distributed length; then another stretch begins, at
        one of the recorded instants nearest to the present one in range, offset and rate.
Lost    docs/models/pilot.md: what lasts longer than a stretch, what one hand does for the other,
        how people differ, and every answer to a state in which nobody has been.
"""

from functools import lru_cache
from math import prod
from pathlib import Path

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.levels import HIGHEST
from rvd_dynamics.diagram.params import param, settings, wiring
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.streams import PilotDraws
from rvd_dynamics.geometry.cone import Cone, radius
from rvd_dynamics.given import bytes_of, rows_of

Array = NDArray[np.float64]
COLUMNS = ('flight', 'step', 'x_m', 'y_m', 'z_m', 'vx_m_s', 'vy_m_s', 'vz_m_s',
           'level_x', 'level_y', 'level_z')


@settings
class Recorded:
    """Recorded responses, resampled."""

    run: Run = wiring()
    cone: Cone = wiring()

    responses: str = param('', 'Table of recorded responses: a CSV file.')
    stretch_s: float = param(
        8.0, 'Mean length of a recorded stretch that is flown again [s].', above=0.0, high=3600.0)
    neighbours: int = param(
        5, 'Number of the nearest recorded instants of which one is drawn.', low=1, high=1000)
    range_span_m: float = param(
        10.0, 'Range that counts as much as the radius of the corridor across [m].', above=0.0,
        high=1e4)
    rate_span_m_s: float = param(
        0.05, 'Rate that counts as much as the radius of the corridor across [m/s].', above=0.0,
        high=10.0)

    @property
    def fitted_first(self) -> str:
        """Name of the number to fit; there is none: what was recorded is not fitted."""
        return ''

    @property
    def idle(self) -> tuple[str, ...]:
        """Names of numbers that are no numbers of a pilot."""
        return ('stretch_s', 'range_span_m', 'rate_span_m_s')

    def flying(self, draws: PilotDraws, skill_normal: ArrayLike, batch: tuple = ()
               ) -> 'RecordedPilot':
        """
        Return one pilot per row of the batch; see `pilot.PilotForm`.

        Raises
        ------
        ValueError
            If no table is named, it cannot be read, or its steps are not those of the run.
        """
        if not self.responses:
            raise BadInput('form recorded needs recorded.responses, a table that '
                           'rvd_missions.lunar_approach.responses makes of flights')
        return RecordedPilot(self, read_responses(self.responses), draws, batch)


class Responses:
    """A table of responses; D rows, one for each recorded step."""

    def __init__(self, state: Array, levels: NDArray[np.int8], last: NDArray[np.bool_],
                 step_s: float) -> None:
        self.state, self.levels, self.step_s = state, levels, step_s    # (D, 6), (D, 3)
        self.last = last                                                # (D,) of its flight


def text_of_responses(flights: list[tuple[Array, NDArray[np.int8]]], step_s: float) -> str:
    """Return the table of flights, each states (K, 6) and levels (K, 3), as text."""
    lines = [f'# step_s {step_s!r}', ','.join(COLUMNS)]
    for number, (state, levels) in enumerate(flights):
        lines += [','.join(map(str, (number, k, *map(repr, s), *held))) for k, (s, held) in
                  enumerate(zip(state.tolist(), levels.tolist()))]
    return '\n'.join(lines) + '\n'


@lru_cache(maxsize=4)
def read_responses(path: str) -> Responses:
    """
    Read a table of responses.

    Raises
    ------
    ValueError
        If there is no such file or it is no such table; one line that names file and line.
    """
    file = Path(path)
    try:
        text = bytes_of(file, 'table of responses').decode('utf-8-sig')
    except OSError as error:
        raise BadInput(f'cannot read responses {file}: {error.strerror or error}') from None
    except UnicodeDecodeError:
        raise BadInput(f'{file}: the table of responses is not UTF-8') from None
    step_s, header, values = 0.0, False, []
    for number, row in rows_of(text, str(file)):
        where = f'{file}, line {number}'
        if not row or row[0].startswith('#'):
            if row and row[0].startswith('# step_s '):
                step_s = _number(row[0].removeprefix('# step_s '), where)
        elif not header:
            header = True
            if tuple(row) != COLUMNS:
                raise BadInput(f'{where}: the header must be {",".join(COLUMNS)}, got '
                               f'{",".join(row)}')
        elif len(row) != len(COLUMNS):
            raise BadInput(f'{where}: {len(COLUMNS)} columns expected, got {len(row)}')
        else:
            values.append([_number(cell, where) for cell in row])
    if not values or not step_s > 0.0:
        raise BadInput(f'{file}: no recorded step, or no line "# step_s SECONDS": make the table '
                       'with rvd_missions.lunar_approach.responses')
    table = np.array(values)
    if not np.isin(table[:, 8:], range(-HIGHEST, HIGHEST + 1)).all():
        raise BadInput(f'{file}: levels must be whole numbers from -{HIGHEST} to {HIGHEST}')
    last = np.append(table[1:, 0] != table[:-1, 0], True)
    return Responses(table[:, 2:8], table[:, 8:].astype(np.int8), last, step_s)


def _number(text: str, where: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = float('nan')
    if not abs(value) <= 1e8:
        raise BadInput(f'{where}: a number expected, got {text.strip()!r}')
    return value


class RecordedPilot:
    """One pilot per row of the batch; called once per step, in order."""

    def __init__(self, params: Recorded, found: Responses, draws: PilotDraws,
                 batch: tuple = ()) -> None:
        from scipy.spatial import KDTree        # most of a second, and only of this form
        if abs(found.step_s - params.run.step_s) > 1e-9:
            raise BadInput(f'{params.responses} was recorded in steps of {found.step_s:g} s, the '
                           f'run has step_s {params.run.step_s:g}')
        n = prod(batch)
        self._params, self._found, self._batch = params, found, batch
        self._uniforms = draws.uniforms.reshape(n, -1, draws.uniforms.shape[-1])
        self._chance = params.run.step_s / params.stretch_s     # that a stretch ends in a step
        self._count = min(params.neighbours, len(found.state))
        state = found.state.T
        self._trees = [KDTree(self._features(state, axis)) for axis in range(3)]
        self._at = np.full((3, n), -1)                          # recorded step that is flown again

    def advance(self, step: int, estimate: ArrayLike, predicted: ArrayLike, valid: ArrayLike
                ) -> NDArray[np.int8]:
        """Return the levels at which the stick stands in this step; see `pilot.Pilot`."""
        state = np.reshape(predicted, (-1, 6)).T
        seen = np.asarray(valid, dtype=bool).reshape(-1) & np.isfinite(state).all(axis=0)
        levels = np.zeros((3, len(seen)), dtype=np.int8)
        for axis in range(3):
            at, u = self._at[axis], self._uniforms[:, step]
            ends = (at < 0) | self._found.last[at] | (u[:, axis + 3] < self._chance)
            at = np.where(at < 0, at, np.minimum(at + 1, len(self._found.last) - 1))
            new = np.flatnonzero(ends & seen)
            if new.size:
                _, near = self._trees[axis].query(
                    self._features(state[:, new], axis), self._count)
                pick = np.minimum((u[new, axis]*self._count).astype(int), self._count - 1)
                at[new] = near.reshape(new.size, -1)[np.arange(new.size), pick]
            lost = ends & ~seen                 # no display, no new stretch: he lets go
            self._at[axis] = at = np.where(lost, -1, at)
            levels[axis] = np.where(at < 0, 0, self._found.levels[at, axis])
        return levels.T.reshape(*self._batch, 3)

    def _features(self, state: Array, axis: int) -> Array:
        """Return what states (6, m) are compared by on an axis, (m, 3)."""
        p = self._params
        to_go = np.maximum(-state[0], 0.0)
        offset = np.zeros_like(to_go) if axis == 0 else state[axis] / radius(-to_go, p.cone)
        return np.stack([to_go/p.range_span_m, offset, state[3 + axis]/p.rate_span_m_s], axis=-1)
