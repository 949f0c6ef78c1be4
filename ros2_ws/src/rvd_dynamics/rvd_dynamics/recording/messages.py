"""
The messages of recorded MCAP files, topic by topic, as bytes or decoded; no ROS needed.
"""

from collections.abc import Collection, Iterator
from functools import cached_property
from pathlib import Path
from typing import Any, Callable, NamedTuple

from mcap.records import Channel, Footer, Message, Metadata, Schema
from mcap_ros2.decoder import DecoderFactory

from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.recording.mcap_file import records


def files_of(path: Path) -> list[Path]:
    """
    Return the MCAP files of a run folder, a bag folder or a file, in the order of recording.

    Raises
    ------
    ValueError
        If there is none.
    """
    if path.is_file():
        return [path]
    folder = path / 'bag' if (path / 'bag').is_dir() else path
    found = list(folder.glob('*.mcap'))
    if not found:
        raise ValueError(f'{path} holds no bag: there is no .mcap file in the folder')
    return sorted(found, key=lambda file: (len(file.name), file.name))     # bag_2 before bag_10


def stamp_ns(stamp: Any) -> int:
    """Return the instant of a decoded stamp [ns]."""
    return stamp.sec * NS_PER_S + stamp.nanosec


class Source:
    """A topic of a file: its type, and how its messages are decoded."""

    def __init__(self, path: Path, channel: Channel, schema: Schema | None,
                 factory: DecoderFactory) -> None:
        self.topic = channel.topic
        self.encoding = channel.message_encoding        # cdr
        self.kind = schema.name if schema else ''       # pkg/msg/Type
        self.count = 0                                  # messages that were met so far
        self._path, self._schema, self._factory = path, schema, factory

    @cached_property
    def _decoder(self) -> Callable[[bytes], Any]:
        made = self._factory.decoder_for(self.encoding, self._schema)
        if made is None:
            raise ValueError(f'needs a ros2msg schema and cdr, has '
                             f'{self._schema.encoding if self._schema else "no"} schema and '
                             f'{self.encoding}')
        return made

    def decoded(self, data: bytes, number: int) -> Any:
        """
        Return a message with the fields of its type.

        Raises
        ------
        ValueError
            If its bytes are none of this type; names file, topic and number.
        """
        try:
            return self._decoder(data)
        except Exception as error:              # whatever made-up bytes or schemas lead to
            raise ValueError(f'{self._path}, {self.topic} message {number}: cannot be decoded: '
                             f'{str(error) or type(error).__name__}') from None


class Stored(NamedTuple):
    """One message as the file holds it."""

    source: Source
    number: int                                 # in its topic, from 1
    data: bytes                                 # serialised
    log_ns: int                                 # simulation time, where our recorder wrote it
    publish_ns: int                             # wall time, likewise

    @property
    def topic(self) -> str:
        """The name of its topic."""
        return self.source.topic

    @property
    def message(self) -> Any:
        """The message decoded; raises as `Source.decoded`."""
        return self.source.decoded(self.data, self.number)


class MessageFile:
    """
    The messages of one file in its order, and what else it says, known once they are through.

    Parameters
    ----------
    path : Path
        An MCAP file, which may be cut off, or damaged from some byte on: then it ends there.
    topics : collection of str, optional
        Those whose messages are wanted; by default all.
    refuse_damage : bool
        Raise ValueError where a file is damaged rather than cut off.
    """

    def __init__(self, path: Path, topics: Collection[str] | None = None,
                 refuse_damage: bool = False) -> None:
        self.sources: list[Source] = []         # topics in the file, wanted or not
        self.notes: dict[str, dict[str, str]] = {}      # metadata records
        self.complete = False                   # the file has its end
        self._path, self._topics, self._refuse_damage = path, topics, refuse_damage

    def __iter__(self) -> Iterator[Stored]:
        factory, schemas, channels = DecoderFactory(), {}, {}
        for record in records(self._path, self._refuse_damage):
            if isinstance(record, Message):
                source, wanted = channels.get(record.channel_id, (None, False))
                if source is not None:
                    source.count += 1
                if wanted:
                    yield Stored(source, source.count, record.data, record.log_time,
                                 record.publish_time)
            elif isinstance(record, Schema):
                schemas[record.id] = record
            elif isinstance(record, Channel) and record.id not in channels:
                source = Source(self._path, record, schemas.get(record.schema_id), factory)
                self.sources.append(source)
                channels[record.id] = (
                    source, self._topics is None or source.topic in self._topics)
            elif isinstance(record, Metadata):
                self.notes[record.name] = record.metadata
            self.complete = isinstance(record, Footer)
