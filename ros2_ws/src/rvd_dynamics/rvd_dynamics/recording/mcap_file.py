"""
An MCAP file while it grows, and its reordering into an indexed one when it is complete.

While it grows records go to the operating system whole and nothing waits in a buffer of ours, so
that whatever ends the process, the file is a sequence of whole records. Such a file
has no index; `rewrite` makes one with an index, in which readers can seek by time and topic.

Source  MCAP specification, version 0.
"""

import fcntl
import os
import struct
from pathlib import Path
from typing import Any, Iterable

from mcap.data_stream import RecordBuilder
from mcap.records import (
    Channel, DataEnd, Footer, Header, McapRecord, Message, Metadata, Schema)
from mcap.writer import MCAP0_MAGIC, CompressionType, Writer

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.given import value_of
from rvd_dynamics.recording import whole
from rvd_dynamics.recording.mcap_records import records
from rvd_dynamics.recording.rosbag2 import Contents, Topic, dump

PROFILE = 'ros2'
LIBRARY = 'rvd_dynamics'
ROSBAG2 = 'rosbag2'                             # metadata record that rosbag2 looks for
CHUNK_BYTES = 256 * 1024                        # [B] a cut-off indexed file loses less than this
_MESSAGE = struct.Struct('<BQHIQQ')             # opcode, length, channel, sequence, log, publish
_MESSAGE_HEAD = _MESSAGE.size - 9               # [B] of a message record before its data


class GrowingFile:
    """
    An MCAP file to which whole records are appended.

    A record that does not fit is removed again, so that the file stays a sequence of whole
    records; the error is passed on to the caller.
    """

    def __init__(self, path: Path) -> None:
        flags = os.O_WRONLY | os.O_CREAT | os.O_EXCL | os.O_APPEND
        self._file = os.open(path, flags, 0o644)
        fcntl.flock(self._file, fcntl.LOCK_EX)  # for as long as this process has it open
        self.size = 0
        self._append(MCAP0_MAGIC + bytes_of(Header(profile=PROFILE, library=LIBRARY)))

    def _append(self, record: bytes) -> None:
        try:
            written = os.write(self._file, record)
            if written != len(record):
                raise OSError(28, 'No space left on device')
        except OSError:
            os.ftruncate(self._file, self.size)
            raise
        self.size += len(record)

    def append(self, *records: McapRecord) -> None:
        """Append records that belong together, all or none."""
        self._append(b''.join(map(bytes_of, records)))

    def append_messages(self, messages: Iterable[tuple[int, int, int, int, bytes]]) -> None:
        """
        Append messages (channel, sequence, log time, publish time, data), all or none.

        Without the library and in one write, for speed: every message comes this way.
        """
        pieces = []
        for channel, sequence, log_ns, publish_ns, data in messages:
            pieces += (_MESSAGE.pack(5, _MESSAGE_HEAD + len(data), channel,
                                     sequence & 0xffffffff, log_ns, publish_ns), data)
        self._append(b''.join(pieces))

    def finish(self) -> None:
        """Append the end of a file without an index."""
        end = bytes_of(DataEnd(data_section_crc=0)) + bytes_of(
            Footer(summary_start=0, summary_offset_start=0, summary_crc=0))
        self._append(end + MCAP0_MAGIC)

    def close(self) -> None:
        """Close the file and release it."""
        os.close(self._file)


def bytes_of(record: McapRecord) -> bytes:
    """Return a record as it stands in a file."""
    builder = RecordBuilder()
    record.write(builder)
    return builder.end()


def lock(path: Path) -> int | None:
    """Lock a file and return its handle, to be closed; None if a `GrowingFile` has it."""
    handle = os.open(path, os.O_RDWR)
    try:
        fcntl.flock(handle, fcntl.LOCK_EX | fcntl.LOCK_NB)
    except BlockingIOError:
        os.close(handle)
        return None
    return handle


def rewrite(path: Path, notes: dict[str, dict[str, str]]) -> Contents:
    """
    Replace a file by one with the same messages, chunks and an index; return what it holds.

    `notes` are metadata records to add to those that the file has. The old file stays until
    the new one is on the disk.

    Raises
    ------
    OSError
        If it cannot be written; the old file is then unchanged.
    """
    with whole.draft(path) as stream:
        return _copy(path, stream, notes)


def _copy(path: Path, stream: Any, notes: dict[str, dict[str, str]]) -> Contents:
    writer = Writer(stream, chunk_size=CHUNK_BYTES, compression=CompressionType.NONE)
    writer.start(PROFILE, LIBRARY)
    contents, schemas, channels = Contents(), {}, {}
    metadata: dict[str, dict[str, str]] = {}
    for record in records(path):
        if isinstance(record, Message):
            if record.channel_id not in channels:
                continue
            channel, topic = channels[record.channel_id]
            contents.add(topic, record.log_time)
            writer.add_message(channel, record.log_time, record.data, record.publish_time,
                               record.sequence)
        elif isinstance(record, Schema) and record.id not in schemas:
            schemas[record.id] = (
                writer.register_schema(record.name, record.encoding, record.data), record.name)
        elif isinstance(record, Channel) and record.id not in channels:
            schema, kind = schemas.get(record.schema_id, (0, ''))
            topic = Topic(record.topic, kind, record.metadata.get('topic_type_hash', ''),
                          _qualities(record.metadata.get('offered_qos_profiles', '[]')))
            contents.topics[record.topic] = topic
            channels[record.id] = (writer.register_channel(
                record.topic, record.message_encoding, schema, record.metadata), topic)
        elif isinstance(record, Metadata):
            metadata[record.name] = record.metadata
    metadata.update(notes)
    metadata[ROSBAG2] = {'serialized_metadata': dump(contents, path.name)}
    for name, values in metadata.items():
        writer.add_metadata(name, values)
    writer.finish()
    return contents


def _qualities(text: str) -> list:
    """Return the qualities of service in a record's metadata; none where it does not hold any."""
    try:
        found = value_of(text)
    except BadInput:
        return []
    return found if isinstance(found, list) else []
