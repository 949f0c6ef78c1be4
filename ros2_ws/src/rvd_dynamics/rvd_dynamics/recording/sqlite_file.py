"""
A SQLite file of rosbag2 as the records of an MCAP file, so that both are read alike.

Such a file is a program as much as a table: views and generated columns are refused, and every
query is stopped that takes too long.

Source  rosbag2_storage_sqlite3: tables `topics` and `messages` since its first version, and
        `message_definitions` since the fourth; older files bring no definitions.
"""

from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
import sqlite3
import stat
import tempfile
from typing import Any
from urllib.parse import quote

from mcap.records import Channel, Footer, McapRecord, Message, Schema
import zstandard

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.given import opened
from rvd_dynamics.recording.limits import (
    Allowance, Damage, MAX_DEFINITION, MAX_RECORD, MOST_TOPICS, PIECE, zstd_stream)
from rvd_dynamics.recording.mcap_records import Damaged, ignored

BESIDE = ('-wal', '-shm', '-journal')           # files that SQLite opens by itself
TURNS = 100_000                                 # steps of its machine between two looks at the time
LARGEST = 2**64                                 # a time stamp of MCAP is less
TABLES = {'topics': ('id', 'name', 'type', 'serialization_format'),
          'messages': ('id', 'topic_id', 'timestamp', 'data'),
          'message_definitions': ('topic_type', 'encoding', 'encoded_message_definition')}


def records(path: Path, damaged: Damaged = ignored) -> Iterator[McapRecord]:
    """
    Yield schemas and channels, then messages in the order of recording, then a `Footer`.

    A file that is damaged from some row on yields the messages before it, and no `Footer`; rows
    that are none are left out. `damaged` is told either.

    Raises
    ------
    ValueError
        If it is no SQLite file of rosbag2; names it.
    OSError
        If it cannot be read.
    """
    _check_beside(path)
    try:
        with opened(path) as file, _unpacked(path, file) as (plain, allowance), closing(
                _connected(plain, allowance)) as base:
            yield from _topics(base)
            yield from _messages(base, allowance, damaged)
    except (sqlite3.Error, zstandard.ZstdError, Damage) as error:
        raise BadInput(f'{path}: not a readable SQLite file of rosbag2: {error}') from None


def _check_beside(path: Path) -> None:
    """Refuse a bag whose files of SQLite's own are traps: it would wait for a pipe."""
    for ending in BESIDE:
        other = path.with_name(path.name + ending)
        try:
            mode = other.lstat().st_mode
        except OSError:
            continue
        if not stat.S_ISREG(mode):
            raise BadInput(f'{other} is no regular file: remove it')


def _connected(path: Path, allowance: Allowance) -> sqlite3.Connection:
    base = sqlite3.connect(f'file:{quote(str(path.absolute()))}?mode=ro', uri=True)

    def over() -> bool:
        try:
            allowance.look()
        except Damage:
            return True
        return False
    base.set_progress_handler(over, TURNS)
    if hasattr(base, 'setlimit'):               # since Python 3.11
        base.setlimit(sqlite3.SQLITE_LIMIT_LENGTH, MAX_RECORD)
    for pragma in ('trusted_schema=OFF', 'query_only=ON', 'mmap_size=0'):
        base.execute(f'PRAGMA {pragma}')
    return base


def _has(base: sqlite3.Connection, table: str) -> bool:
    """Say whether a table is there; Damage if it is none, or computes what is read from it."""
    found = base.execute('SELECT type, sql FROM sqlite_master WHERE name = ?', (table,)).fetchone()
    if found is None:
        return False
    kind, text = found
    if kind != 'table' or not isinstance(text, str) or 'VIRTUAL' in text[:40].upper():
        raise Damage(f'{table} is a {kind} that computes what it holds')
    columns = base.execute(f'PRAGMA table_xinfo({table})').fetchall()
    if any(column[6] for column in columns):    # hidden: generated
        raise Damage(f'{table} has columns that are computed')
    missing = set(TABLES[table]) - {column[1] for column in columns}
    if missing:
        raise Damage(f'{table} has no column {min(missing)}')
    return True


def _topics(base: sqlite3.Connection) -> Iterator[McapRecord]:
    for table in ('topics', 'messages'):
        if not _has(base, table):
            raise Damage(f'it has no table {table}')
    known = {}
    if _has(base, 'message_definitions'):
        known = {kind: (encoding, text) for kind, encoding, text in base.execute(
            'SELECT topic_type, encoding, encoded_message_definition FROM message_definitions '
            f'WHERE length(encoded_message_definition) <= {MAX_DEFINITION} LIMIT {MOST_TOPICS}')
            if isinstance(encoding, str) and isinstance(text, str)}
    for number, topic, kind, encoding in base.execute(
            'SELECT id, name, type, serialization_format FROM topics ORDER BY id '
            f'LIMIT {MOST_TOPICS}').fetchall():
        if not (isinstance(number, int) and all(
                isinstance(word, str) for word in (topic, kind, encoding))):
            raise Damage('a topic whose names are no text')
        language, text = known.get(kind, ('', ''))
        yield Schema(id=number, name=kind, encoding=language, data=text.encode())
        yield Channel(id=number, topic=topic, message_encoding=encoding, metadata={},
                      schema_id=number)


def _messages(base: sqlite3.Connection, allowance: Allowance, damaged: Damaged
              ) -> Iterator[McapRecord]:
    rows, number = base.execute('SELECT topic_id, timestamp, data FROM messages ORDER BY id'), 0
    while True:
        try:
            row = next(rows, None)
            allowance.met()
        except (sqlite3.Error, Damage, OverflowError) as error:
            damaged(f'row {number + 1}: {error}')
            return
        if row is None:
            break
        number += 1
        if not _is_message(*row):
            damaged(f'row {number}: no message')
            continue
        channel, log_ns, data = row
        yield Message(channel_id=channel, sequence=0, log_time=log_ns, publish_time=log_ns,
                      data=data)
    yield Footer(summary_start=0, summary_offset_start=0, summary_crc=0)


def _is_message(channel: Any, log_ns: Any, data: Any) -> bool:
    return (isinstance(channel, int) and isinstance(log_ns, int) and 0 <= log_ns < LARGEST
            and isinstance(data, bytes))


@contextmanager
def _unpacked(path: Path, file: Any) -> Iterator[tuple[Path, Allowance]]:
    """Give the file, or for as long as it is needed an unpacked copy of a compressed one."""
    allowance = Allowance(file)
    if path.suffix != '.zstd':
        yield path, allowance
        return
    with tempfile.NamedTemporaryFile(suffix='.db3') as copy:
        stream = zstd_stream(file)
        while piece := stream.read(PIECE):
            allowance.unpack(len(piece))
            copy.write(piece)
        copy.flush()
        yield Path(copy.name), allowance
