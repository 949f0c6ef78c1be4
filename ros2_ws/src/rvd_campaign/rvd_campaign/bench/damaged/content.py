"""The bag that is changed: its records, read and written again, and what is put into them."""

from dataclasses import dataclass
from functools import lru_cache
from io import BytesIO
from pathlib import Path
from random import Random
import struct

from mcap.records import Channel, Message, Metadata, Schema
from mcap.writer import CompressionType, Writer

from rvd_dynamics.recording import mcap_file, mcap_records
from rvd_dynamics.recording.messages import files_of

DOUBLES = [struct.pack('<d', x) for x in (
    float('nan'), float('inf'), -float('inf'), 1e308, -1e308, 1e30, -0.0, 5e-324, 0.0)]
WHOLES = [struct.pack('<Q', x) for x in (0, 1, 2**31, 2**32 - 1, 2**53, 2**62, 2**63, 2**64 - 1)]
ESCAPES = '\x1b]0;owned\x07\x1b[2J\x1b[31m<script>alert(1)</script>\u202e\x00&lt;'
HEAD = mcap_records.MAGIC + mcap_file.bytes_of(     # of an MCAP file
    mcap_file.Header(profile='ros2', library='none'))


@dataclass
class Content:
    """The records of a bag, to be changed and written again."""

    schemas: dict[int, Schema]
    channels: dict[int, Channel]
    messages: list[Message]
    notes: list[Metadata]

    def of(self, topic: str) -> list[int]:
        """Return where the messages of a topic are."""
        numbers = {n for n, c in self.channels.items() if c.topic == topic}
        return [i for i, m in enumerate(self.messages) if m.channel_id in numbers]


@lru_cache(maxsize=4)
def read(base: Path) -> tuple[bytes, tuple]:
    """Return the file of the bag that is changed, and its records."""
    file, = files_of(base)
    return file.read_bytes(), tuple(mcap_records.records(file))


def content_of(base: Path) -> Content:
    """Return the records of the bag that is changed."""
    made = Content({}, {}, [], [])
    for record in read(base)[1]:
        if isinstance(record, Message):
            made.messages.append(Message(**vars(record)))
        elif isinstance(record, Schema):
            made.schemas[record.id] = Schema(**vars(record))
        elif isinstance(record, Channel):
            made.channels[record.id] = Channel(**vars(record))
        elif isinstance(record, Metadata):
            made.notes.append(Metadata(**vars(record)))
    return made


def written(content: Content, compression: CompressionType = CompressionType.NONE,
            closed: bool = True) -> bytes:
    """Return the file of some records: with chunks and an index, or as it is while it grows."""
    if not closed:
        return HEAD + b''.join(mcap_file.bytes_of(r) for r in (
            *content.schemas.values(), *content.channels.values(), *content.messages,
            *content.notes))
    buffer = BytesIO()
    writer = Writer(buffer, compression=compression, chunk_size=64 << 10)
    writer.start('ros2', 'none')
    schemas = {n: writer.register_schema(s.name, s.encoding, s.data)
               for n, s in content.schemas.items()}
    channels = {n: writer.register_channel(c.topic, c.message_encoding,
                                           schemas.get(c.schema_id, 0), c.metadata)
                for n, c in content.channels.items()}
    for m in content.messages:
        writer.add_message(channels.get(m.channel_id, m.channel_id), m.log_time, m.data,
                           m.publish_time, m.sequence)
    for note in content.notes:
        writer.add_metadata(note.name, note.metadata)
    writer.finish()
    return buffer.getvalue()


def some(rng: Random, content: Content) -> list[Message]:
    """Return some messages: of one topic, or of all."""
    if not content.messages or not content.channels:
        return []
    if rng.random() < 0.5:
        number = rng.choice(list(content.channels))
        found = [m for m in content.messages if m.channel_id == number]
    else:
        found = content.messages
    return found if rng.random() < 0.3 or not found else rng.sample(found, min(len(found), 5))


def string(text: str) -> bytes:
    """Return a std_msgs/String in CDR, little-endian."""
    data = text.encode(errors='replace') + b'\0'
    return b'\x00\x01\x00\x00' + struct.pack('<I', len(data)) + data
