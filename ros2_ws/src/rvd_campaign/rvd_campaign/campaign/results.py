"""
The result table of a campaign: one row per run, the parts it is made of, and its hash.

Table   run, success, reason, duration_s, the measures of the mission's judge, and the mission's
        own columns, or those of them that it orders (`Mission.columns`); sorted by condition
        (order of the campaign) and run.
        Unknown is NaN. Columns are text, bool, int64 or float64.
Parts   `parts/cCCCC-rFIRST-nCOUNT.parquet`: a stretch of runs of one condition, written whole or
        not at all. Which stretches there are depends on how the work was
        split; the table and its hash do not.
Hash    SHA-256 over the conditions' names, the columns' names and types and the decoded values,
        not over the bytes of a Parquet file, which change with the version of its writer.
"""

import hashlib
import re
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from pathlib import Path
from typing import Any, IO, NamedTuple

import numpy as np
import pyarrow
import pyarrow.parquet
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.build import loaded
from rvd_dynamics.diagram.judge import table_columns
from rvd_dynamics.diagram.mission import Mission
from rvd_dynamics.recording import whole

Table = dict[str, NDArray]              # column: values of N runs

KINDS = {'U': 'U', 'b': '?', 'i': 'i8', 'f': 'f8'}      # numpy's kind: type in table and hash
ARROW = {'U': pyarrow.string(), '?': pyarrow.bool_(), 'i8': pyarrow.int64(),
         'f8': pyarrow.float64()}
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


def order_of(mission: Mission) -> tuple[str, ...]:
    """Return the columns that a mission wants in its table, in their order; empty: all."""
    return tuple(loaded(mission.columns)) if mission.columns else ()


def rows(flown: Any, order: Sequence[str] = ()) -> Table:
    """
    Return the rows of a `Batch` of flown runs, with the columns named in `order`, or all.

    A name that ends in '?' is of a column that some scenarios have; elsewhere it is left out.

    Raises
    ------
    ValueError
        If a column is ordered that there is not, or one is neither text nor number.
    """
    made = {'run': flown.runs, **table_columns(flown.verdict), **flown.columns}
    order = [name.removesuffix('?') for name in order
             if not name.endswith('?') or name[:-1] in made]
    unknown = [name for name in order if name not in made]
    if unknown:
        raise BadInput(f'no column {unknown[0]}: there are {", ".join(made)}')
    return {name: _stored(name, made[name]) for name in order or made}


def _stored(name: str, values: NDArray) -> NDArray:
    kind = kind_of(name, values)
    return np.asarray(values, dtype=None if kind == 'U' else kind)


def kind_of(name: str, values: NDArray) -> str:
    """Return the type of a column in table and hash; ValueError if it can have none."""
    if values.dtype.kind not in KINDS:
        raise BadInput(f'column {name} must be text, bool, int or float, got {values.dtype}')
    return KINDS[values.dtype.kind]


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
    table = {name: np.concatenate([part[name] for part in parts]) for name in parts[0]} \
        if parts else {'run': np.zeros(0, dtype='i8')}
    order = np.argsort(table['run'], kind='stable')
    order = order[table['run'][order] < runs]
    if not np.array_equal(table['run'][order], np.arange(runs)):
        raise BadInput(f'{folder}: the parts of condition {condition} do not hold each run '
                       'once')
    return {name: values[order] for name, values in table.items()}


def read_table(path: Path, columns: list[str] | None = None) -> Table:
    """Read a part, or some columns of it."""
    return from_arrow(pyarrow.parquet.read_table(path, columns=columns))


def from_arrow(table: pyarrow.Table) -> Table:
    """Return the columns as arrays."""
    return {field.name: np.asarray(table[field.name].to_pylist(), dtype=str)
            if pyarrow.types.is_string(field.type) else table[field.name].to_numpy()
            for field in table.schema}


def _arrow(table: Table) -> pyarrow.Table:
    return pyarrow.table({name: pyarrow.array(values.tolist(), pyarrow.string())
                          if values.dtype.kind == 'U' else values
                          for name, values in table.items()})


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
        self._file, self._seed = file, seed
        self._writer: pyarrow.parquet.ParquetWriter | None = None
        self._hash = hashlib.sha256()

    def add(self, condition: str, table: Table) -> None:
        """Append the sorted runs of the next condition; all have the columns of the first."""
        if self._writer is None:
            self._writer = pyarrow.parquet.ParquetWriter(
                self._file, _schema(table), compression='zstd')
        _feed(self._hash, condition, self._seed, table)
        n = len(table['run'])
        head = {'condition': pyarrow.DictionaryArray.from_arrays(
            np.zeros(n, dtype=np.int32), [condition]),
            'seed': np.full(n, self._seed, dtype=np.int64)}
        body = _arrow(table)
        parts = {**head, **{name: body[name] for name in table}}
        self._writer.write_table(pyarrow.table(parts, schema=self._writer.schema))

    @property
    def hash(self) -> str:
        """The hash of the table so far."""
        return self._hash.hexdigest()

    def close(self) -> None:
        """Write the end of the file."""
        if self._writer is not None:
            self._writer.close()


def _schema(table: Table) -> pyarrow.Schema:
    return pyarrow.schema([
        ('condition', pyarrow.dictionary(pyarrow.int32(), pyarrow.string())),
        ('seed', pyarrow.int64()),
        *((name, ARROW[kind_of(name, values)]) for name, values in table.items())])


def _feed(made: 'hashlib._Hash', condition: str, seed: int, table: Table) -> None:
    made.update(f'{condition}\0{seed}\0{len(table["run"])}\0'.encode())
    for name, values in table.items():
        kind = kind_of(name, values)
        made.update(f'{name}\0{kind}\0'.encode())
        if kind == 'U':
            made.update('\0'.join(values.tolist()).encode())
            continue
        if kind == 'f8':
            values = np.where(np.isnan(values), np.nan, values)     # one NaN for all
        made.update(np.ascontiguousarray(values, dtype=np.dtype(kind).newbyteorder('<')))


def tables(path: Path, names: list[str] | None = None) -> Iterator[tuple[str, Table]]:
    """Yield each condition of a result file with its runs."""
    file = pyarrow.parquet.ParquetFile(path)
    wanted = names or [name for name in file.schema_arrow.names
                       if name not in ('condition', 'seed')]
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
