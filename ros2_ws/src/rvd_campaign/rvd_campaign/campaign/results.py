"""
The result table of a campaign: one row per run, the parts it is made of, and its hash.

Table   `COLUMNS`, sorted by condition (order of the campaign) and run. Unknown is NaN.
Parts   `parts/cCCCC-rFIRST-nCOUNT.parquet`: a stretch of runs of one condition, written whole or
        not at all. Which stretches there are depends on how the work was
        split; the table and its hash do not.
Hash    SHA-256 over the conditions' names, the columns' names and types and the decoded values,
        not over the bytes of a Parquet file, which change with the version of its writer.
"""

import hashlib
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import IO, NamedTuple

import numpy as np
import pyarrow
import pyarrow.parquet
from numpy.typing import NDArray

from rvd_campaign.loop import Flight
from rvd_dynamics.recording import whole

Table = dict[str, NDArray]              # column: values of N runs

COLUMNS = {                             # name: type; text is kept as text
    'run': 'i8', 'success': '?', 'reason': 'U', 'duration_s': 'f8',
    'failed_at_s': 'f8', 'failed_x_m': 'f8', 'failed_y_m': 'f8', 'failed_z_m': 'f8',
    'x_rate_m_s': 'f8', 'offset_m': 'f8', 'lateral_rate_m_s': 'f8',
    'y_m': 'f8', 'z_m': 'f8', 'y_rate_m_s': 'f8', 'z_rate_m_s': 'f8',
    'min_corridor_margin_m': 'f8', 'delta_v_m_s': 'f8',
    'steps': 'i8', 'steps_nobody': 'i8', 'steps_pilot': 'i8', 'steps_auto': 'i8',
    'steps_blend': 'i8', 'steps_changed': 'i8'}
BYTES_PER_RUN = 250                     # on disk, parts and result together, rounded up
PART = re.compile(r'c(\d{4})-r(\d{10})-n(\d+)\.parquet')


class Stretch(NamedTuple):
    """Runs `first` to `first + count - 1` of one condition."""

    condition: int
    first: int
    count: int

    @property
    def runs(self) -> range:
        """The numbers of the runs."""
        return range(self.first, self.first + self.count)

    @property
    def file(self) -> str:
        """The name of its part."""
        return f'c{self.condition:04d}-r{self.first:010d}-n{self.count}.parquet'


def rows(flight: Flight) -> Table:
    """Return the rows of flown runs."""
    v, end = flight.verdict, flight.terminal
    left = ~np.isnan(v.exit_time)
    place = np.where(left[:, None], v.exit_position, end[:, :3])
    place = np.where(v.success[:, None], np.nan, place)
    failed_at = np.where(v.success, np.nan, np.where(left, v.exit_time, v.duration))
    nobody, pilot, auto, blend = flight.decided_steps.T
    values = (
        flight.runs, v.success, v.reason, v.duration, failed_at, *place.T, v.x_rate, v.offset,
        v.lateral_rate, end[:, 1], end[:, 2], end[:, 4], end[:, 5], v.min_corridor_margin,
        v.delta_v, flight.end_step, nobody, pilot, auto, blend, flight.changed_steps)
    return {name: np.asarray(value, dtype=None if kind == 'U' else kind)
            for (name, kind), value in zip(COLUMNS.items(), values, strict=True)}


def write_part(folder: Path, stretch: Stretch, table: Table, seconds: float) -> None:
    """Write a finished stretch; `seconds` is the time its flying took on one core."""
    made = _arrow(table).replace_schema_metadata({'seconds': repr(seconds)})
    with whole.draft(folder / stretch.file) as file:
        pyarrow.parquet.write_table(made, file, compression='zstd')


def finished(folder: Path) -> dict[Stretch, float]:
    """
    Return the stretches whose parts are whole, and the seconds each took.

    A part that cannot be read is left out, so that its runs are flown again.
    """
    found = {}
    for path in sorted(folder.glob('c*.parquet')):
        match = PART.fullmatch(path.name)
        if not match:
            continue
        stretch = Stretch(*map(int, match.groups()))
        try:
            kept = pyarrow.parquet.read_metadata(path)
            seconds = float((kept.metadata or {}).get(b'seconds', b'nan'))
        except (OSError, ValueError, pyarrow.ArrowException):
            continue
        if kept.num_rows == stretch.count:
            found[stretch] = seconds
    return found


def missing(stretches: list[Stretch], condition: int, runs: int) -> Iterator[range]:
    """Yield the gaps that the stretches leave in runs 0 .. runs - 1 of a condition."""
    at = 0
    for part in sorted(s for s in stretches if s.condition == condition):
        if part.first >= runs:
            break
        if part.first > at:
            yield range(at, part.first)
        at = max(at, part.first + part.count)
    if at < runs:
        yield range(at, runs)


def condition_table(folder: Path, stretches: list[Stretch], condition: int, runs: int) -> Table:
    """
    Return all runs of a condition from its parts, sorted.

    Raises
    ------
    ValueError
        If a run is missing or there twice.
    """
    parts = [read_table(folder / s.file) for s in sorted(stretches) if s.condition == condition]
    table = {name: np.concatenate([part[name] for part in parts]) for name in COLUMNS}
    order = np.argsort(table['run'], kind='stable')
    order = order[table['run'][order] < runs]
    if not np.array_equal(table['run'][order], np.arange(runs)):
        raise ValueError(f'{folder}: the parts of condition {condition} do not hold each run '
                         'once')
    return {name: values[order] for name, values in table.items()}


def read_table(path: Path, columns: list[str] | None = None) -> Table:
    """Read a part, or some columns of it."""
    return from_arrow(pyarrow.parquet.read_table(path, columns=columns))


def from_arrow(table: pyarrow.Table) -> Table:
    """Return the columns as arrays."""
    return {name: np.asarray(table[name].to_pylist()) if COLUMNS.get(name) == 'U'
            else table[name].to_numpy() for name in table.column_names}


def _arrow(table: Table) -> pyarrow.Table:
    return pyarrow.table({name: pyarrow.array(values.tolist(), pyarrow.string())
                          if COLUMNS[name] == 'U' else values for name, values in table.items()})


@contextmanager
def result_file(path: Path, seed: int) -> Iterator['ResultFile']:
    """Open a result file, which is there whole at the end of the block or not at all."""
    with whole.draft(path) as file:
        made = ResultFile(file, seed)
        try:
            yield made
        finally:
            made.close()                        # left open, it would write to a closed file


class ResultFile:
    """Writes `results.parquet`, one condition after the other, and hashes what it writes."""

    def __init__(self, file: IO[bytes], seed: int) -> None:
        self._seed = seed
        schema = pyarrow.schema([
            ('condition', pyarrow.dictionary(pyarrow.int32(), pyarrow.string())),
            ('seed', pyarrow.int64()),
            *((name, {'i8': pyarrow.int64(), '?': pyarrow.bool_(), 'f8': pyarrow.float64(),
                      'U': pyarrow.string()}[kind]) for name, kind in COLUMNS.items())])
        self._writer = pyarrow.parquet.ParquetWriter(file, schema, compression='zstd')
        self._hash = hashlib.sha256()

    def add(self, condition: str, table: Table) -> None:
        """Append the sorted runs of the next condition."""
        _feed(self._hash, condition, self._seed, table)
        n = len(table['run'])
        head = {'condition': pyarrow.DictionaryArray.from_arrays(
            np.zeros(n, dtype=np.int32), [condition]),
            'seed': np.full(n, self._seed, dtype=np.int64)}
        body = _arrow(table)
        columns = {**head, **{name: body[name] for name in COLUMNS}}
        self._writer.write_table(pyarrow.table(columns, schema=self._writer.schema))

    @property
    def hash(self) -> str:
        """The hash of the table so far."""
        return self._hash.hexdigest()

    def close(self) -> None:
        """Write the end of the file."""
        self._writer.close()


def _feed(made: 'hashlib._Hash', condition: str, seed: int, table: Table) -> None:
    made.update(f'{condition}\0{seed}\0{len(table["run"])}\0'.encode())
    for name, kind in COLUMNS.items():
        made.update(f'{name}\0{kind}\0'.encode())
        values = table[name]
        if kind == 'U':
            made.update('\0'.join(values.tolist()).encode())
            continue
        if kind == 'f8':
            values = np.where(np.isnan(values), np.nan, values)     # one NaN for all
        made.update(np.ascontiguousarray(values, dtype=np.dtype(kind).newbyteorder('<')))


def tables(path: Path, columns: list[str] | None = None) -> Iterator[tuple[str, Table]]:
    """Yield each condition of a result file with its runs."""
    file = pyarrow.parquet.ParquetFile(path)
    wanted = list(columns or COLUMNS)
    name, parts = None, []
    for group in range(file.num_row_groups):
        table = file.read_row_group(group, columns=['condition', *wanted])
        for here, rows_of in _spans(np.asarray(table['condition'].to_pylist())):
            if parts and here != name:
                yield name, from_arrow(pyarrow.concat_tables(parts))
                parts = []
            name = here
            parts.append(table.slice(rows_of.start, len(rows_of)).select(wanted))
    if parts:
        yield name, from_arrow(pyarrow.concat_tables(parts))


def _spans(names: NDArray) -> Iterator[tuple[str, range]]:
    """Yield each stretch of equal names with its rows."""
    edges = [0, *(np.flatnonzero(names[1:] != names[:-1]) + 1).tolist(), len(names)]
    for first, end in zip(edges, edges[1:]):
        yield str(names[first]), range(first, end)
