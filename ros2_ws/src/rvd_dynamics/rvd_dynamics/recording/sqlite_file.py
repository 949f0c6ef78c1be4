"""
A SQLite file of rosbag2 as the records of an MCAP file, so that both are read alike.

Source  rosbag2_storage_sqlite3: tables `topics` and `messages` since its first version, and
        `message_definitions` since the fourth; older files bring no definitions.
"""

from collections.abc import Iterator
from contextlib import closing, contextmanager
from pathlib import Path
import shutil
import sqlite3
import tempfile
from urllib.parse import quote

from mcap.records import Channel, Footer, McapRecord, Message, Schema
import zstandard

from rvd_dynamics.bad_input import BadInput


def records(path: Path, refuse_damage: bool = False) -> Iterator[McapRecord]:
    """
    Yield schemas and channels, then messages in the order of recording, then a `Footer`.

    A file that is damaged from some row on yields the messages before it, and no `Footer`.

    Raises
    ------
    ValueError
        If it is no SQLite file of rosbag2, or, with `refuse_damage`, if it is damaged; names it.
    OSError
        If it cannot be read.
    """
    with path.open('rb'):                       # says why it cannot be opened, as SQLite does not
        pass
    try:
        with _unpacked(path) as file, closing(
                sqlite3.connect(f'file:{quote(str(file.absolute()))}?mode=ro', uri=True)) as base:
            yield from _topics(base)
            try:
                for channel, log_ns, data in base.execute(
                        'SELECT topic_id, timestamp, data FROM messages ORDER BY id'):
                    yield Message(channel_id=channel, sequence=0, log_time=log_ns,
                                  publish_time=log_ns, data=data)
            except sqlite3.Error:
                if refuse_damage:
                    raise
                return
            yield Footer(summary_start=0, summary_offset_start=0, summary_crc=0)
    except (sqlite3.Error, zstandard.ZstdError) as error:
        raise BadInput(f'{path}: not a readable SQLite file of rosbag2: {error}') from None


def _topics(base: sqlite3.Connection) -> Iterator[McapRecord]:
    tables = {name for name, in base.execute('SELECT name FROM sqlite_master')}
    known = {}
    if 'message_definitions' in tables:
        known = {kind: (encoding, text) for kind, encoding, text in base.execute(
            'SELECT topic_type, encoding, encoded_message_definition FROM message_definitions')}
    for number, topic, kind, encoding in base.execute(
            'SELECT id, name, type, serialization_format FROM topics ORDER BY id').fetchall():
        language, text = known.get(kind, ('', ''))
        yield Schema(id=number, name=kind, encoding=language, data=text.encode())
        yield Channel(id=number, topic=topic, message_encoding=encoding, metadata={},
                      schema_id=number)


@contextmanager
def _unpacked(path: Path) -> Iterator[Path]:
    """Give the file, or for as long as it is needed an unpacked copy of a compressed one."""
    if path.suffix != '.zstd':
        yield path
        return
    with tempfile.NamedTemporaryFile(suffix='.db3') as copy:
        with path.open('rb') as file:
            shutil.copyfileobj(zstandard.ZstdDecompressor().stream_reader(
                file, read_across_frames=True), copy)
        copy.flush()
        yield Path(copy.name)
