"""
Two laws compared run by run: differences of the measures with intervals, from a campaign's table.

    ./rvd shell python -m rvd_missions.attitude_hold.comparison runs/<folder of a campaign>

Conditions named LAW,CELL are compared cell by cell. Runs of one number share their draws, so the
differences are paired; runs in which a measure is unknown with either law are left out and counted.
The interval of a mean is 95 % by Student's t for each difference on its own: of twenty without any
effect one is expected to exclude 0.
"""

from collections.abc import Mapping
from pathlib import Path
import sys
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from rvd_dynamics.bad_input import BadInput

MEASURES = 'rms_final_deg', 'rms_after_deg', 'overshoot_deg', 'settling_s', 'impulse_N_m_s'
LAWS = 'golden_section', 'pid'
RESULTS = 'results.parquet'
Table = Mapping[str, NDArray]


class Mean(NamedTuple):
    """A mean with its 95 % interval."""

    value: float
    low: float
    high: float
    runs: int                           # in which it is known

    @property
    def sign(self) -> int:
        """1 or -1 where the interval excludes 0, else 0."""
        return int(self.low > 0.0) - int(self.high < 0.0)


class Row(NamedTuple):
    """One measure in one cell."""

    cell: str
    measure: str
    first: Mean
    second: Mean
    difference: Mean                    # first minus second, run by run


def mean(values: ArrayLike) -> Mean:
    """Return the mean of the known values with its interval; NaN where there are too few."""
    from scipy.stats import t
    values = np.asarray(values, dtype=float)
    values = values[np.isfinite(values)]
    n = values.size
    if n < 2:
        return Mean(float(values.mean()) if n else np.nan, np.nan, np.nan, n)
    middle = float(values.mean())
    reach = float(t.ppf(0.975, n - 1) * values.std(ddof=1) / np.sqrt(n))
    return Mean(middle, middle - reach, middle + reach, n)


def cells(names: Mapping[str, object] | list[str], laws: tuple[str, str] = LAWS) -> list[str]:
    """Return the cells that both laws have flown, in the order of the names."""
    found = [name.partition(',')[2] for name in names if name.partition(',')[0] == laws[0]]
    return [cell for cell in found if named(laws[1], cell) in names]


def named(law: str, cell: str) -> str:
    """Return the name of a condition."""
    return f'{law},{cell}' if cell else law


def rows(tables: Mapping[str, Table], measures: tuple[str, ...] = MEASURES,
         laws: tuple[str, str] = LAWS) -> list[Row]:
    """
    Return each measure in each cell.

    Raises
    ------
    ValueError
        If the two conditions of a cell have not the same runs.
    """
    made = []
    for cell in cells(tables, laws):
        first, second = (tables[named(law, cell)] for law in laws)
        if not np.array_equal(first['run'], second['run']):
            raise BadInput(f'{cell}: the conditions of a pair must have the same runs')
        for measure in measures:
            a, b = np.asarray(first[measure]), np.asarray(second[measure])
            made.append(Row(cell, measure, mean(a), mean(b), mean(a - b)))
    return made


def read(folder: Path) -> dict[str, dict[str, NDArray]]:
    """Return the table of each condition of a campaign's folder; ValueError if there is none."""
    import pyarrow.parquet
    path = folder / RESULTS
    if not path.is_file():
        raise BadInput(f'{path} is not there: give the folder of a finished campaign')
    whole = pyarrow.parquet.read_table(path).to_pydict()
    names = np.array(whole.pop('condition'))
    columns = {name: np.array(values) for name, values in whole.items()}
    return {str(name): {key: values[names == name] for key, values in columns.items()}
            for name in dict.fromkeys(names.tolist())}


def in_words(found: list[Row], laws: tuple[str, str] = LAWS) -> str:
    """Return the rows as text, and in how many cells which law has the smaller measure."""
    width = max(len(row.cell) for row in found)
    lines = []
    for measure in dict.fromkeys(row.measure for row in found):
        chosen = [row for row in found if row.measure == measure]
        signs = [row.difference.sign for row in chosen]
        lines.append(f'{measure}: smaller with {laws[0]} in {signs.count(-1)} cells, '
                     f'with {laws[1]} in {signs.count(1)}, undecided in {signs.count(0)}')
        lines += [f'  {row.cell:<{width}}  {row.first.value:9.5f}  {row.second.value:9.5f}  '
                  f'{row.difference.value:+9.5f} [{row.difference.low:+.5f}, '
                  f'{row.difference.high:+.5f}]  {row.difference.runs} runs' for row in chosen]
    return '\n'.join(lines)


if __name__ == '__main__':
    if len(sys.argv) != 2:
        sys.exit(__doc__.strip())
    try:
        print(in_words(rows(read(Path(sys.argv[1])))))
    except BadInput as error:
        print(f'comparison: {error}', file=sys.stderr)
        sys.exit(2)
