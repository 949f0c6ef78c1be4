"""
The messages of recorded bags, topic by topic, as bytes or decoded; no ROS needed.

Storages of rosbag2: MCAP, and SQLite, whose rows are read as the records of an MCAP file; either
as it is, or compressed by zstd as a file or message by message.
"""

from collections.abc import Collection, Iterator
from contextlib import redirect_stderr
from functools import cached_property
from io import StringIO
from pathlib import Path
from typing import Any, Callable, NamedTuple

from mcap.records import Channel, Footer, Message, Metadata, Schema
from mcap_ros2.decoder import DecoderFactory

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.constants import NS_PER_S
from rvd_dynamics.recording import mcap_records, sqlite_file
from rvd_dynamics.recording.limits import (
    Damage, MAX_DEFINITION, MAX_RECORD, MOST_TOPICS, SOME, TIMES, unpacked)

STORAGES = {'.mcap': mcap_records.records, '.db3': sqlite_file.records}
PACKED = '.zstd'                                # behind the ending of a compressed file
MOST_FILES = 1000                               # of one bag
MOST_SAID = 5                                   # losses of a file that are told
ZSTD = b'\x28\xb5\x2f\xfd'                     # begins what is compressed, and no CDR


def storage_of(name: str) -> str:
    """Return the ending of a bag's file that says how it is stored; empty if it is none."""
    ending = Path(name.removesuffix(PACKED)).suffix
    return ending if ending in STORAGES else ''


def is_bag(path: Path) -> bool:
    """Say whether a path means a bag: a folder, or a file with an ending of rosbag2."""
    return path.is_dir() or bool(storage_of(path.name))


def files_of(path: Path) -> list[Path]:
    """
    Return the files of a bag: of a run folder, a bag folder or a file, in the order of recording.

    Raises
    ------
    ValueError
        If there is none.
    """
    if path.is_file():
        return [path]
    folder = path / 'bag' if (path / 'bag').is_dir() else path
    found = [file for file in folder.glob('*') if storage_of(file.name)]
    found = [file for file in found
             if file.suffix != PACKED or file.with_suffix('') not in found]     # unpacked beside it
    if not found:
        raise BadInput(f'{path} holds no bag: there is no .mcap or .db3 file in the folder')
    if len(found) > MOST_FILES:
        raise BadInput(f'{path} holds {len(found)} files of a bag; {MOST_FILES} are the most')
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
        self.path, self._schema, self._factory = path, schema, factory

    @cached_property
    def _decoder(self) -> Callable[[bytes], Any]:
        schema, factory = self._schema, self._factory
        if schema is None or schema.encoding != 'ros2msg' or not schema.data:
            schema, factory = _standard(self.kind) or schema, DecoderFactory()
        if schema is not None and len(schema.data) > MAX_DEFINITION:
            raise BadInput(f'its definition has {len(schema.data)} bytes, more than '
                           f'{MAX_DEFINITION}')
        with redirect_stderr(StringIO()):       # the parser prints what it cannot read
            made = factory.decoder_for(self.encoding, schema)
        if made is None:
            raise BadInput(f'needs a ros2msg schema and cdr, has '
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
            raise BadInput(f'{self.path}, {self.topic} message {number}: cannot be decoded: '
                           f'{str(error) or type(error).__name__}') from None


def _standard(kind: str) -> Schema | None:
    """Return the definition of a type of ROS itself: older bags bring none."""
    from rosbags.typesys import get_typestore, Stores, TypesysError
    try:
        text, _ = get_typestore(Stores.ROS2_JAZZY).generate_msgdef(kind, ros_version=2)
    except (KeyError, TypesysError):            # no such type
        return None
    return Schema(id=1, name=kind, encoding='ros2msg', data=text.encode())


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
        A file of a bag, which may be cut off or damaged: what can be read of it is read.
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
        self.damage: list[str] = []             # what cannot be read, the first MOST_SAID of it
        self.first_ns: int | None = None        # log times of what was read: first, latest
        self.last_ns = 0
        self.path, self._topics, self._refuse_damage = path, topics, refuse_damage

    def damaged(self, why: str) -> None:
        """Note damage, or refuse it."""
        if self._refuse_damage:
            raise BadInput(f'{self.path}: not a readable {self._kind}: {why}')
        if len(self.damage) < MOST_SAID:
            self.damage.append(why)

    @property
    def _storage(self) -> str:
        return storage_of(self.path.name) or '.mcap'

    @property
    def _kind(self) -> str:
        return 'MCAP file' if self._storage == '.mcap' else 'SQLite file of rosbag2'

    def __iter__(self) -> Iterator[Stored]:
        factory, schemas, channels = DecoderFactory(), {}, {}
        for record in STORAGES[self._storage](self.path, self.damaged):
            if isinstance(record, Message):
                source, wanted = channels.get(record.channel_id, (None, False))
                if source is None:
                    self.damaged(f'a message of no topic that is known ({record.channel_id})')
                    continue
                source.count += 1
                self.last_ns = max(self.last_ns, record.log_time)
                if self.first_ns is None:
                    self.first_ns = record.log_time
                if wanted:
                    data = self._plain(record.data, source)
                    if data is not None:
                        yield Stored(source, source.count, data, record.log_time,
                                     record.publish_time)
            elif isinstance(record, Schema):
                schemas[record.id] = record
            elif isinstance(record, Channel) and record.id not in channels:
                if len(channels) >= MOST_TOPICS:
                    self.damaged(f'more than {MOST_TOPICS} topics')
                    return
                source = Source(self.path, record, schemas.get(record.schema_id), factory)
                self.sources.append(source)
                channels[record.id] = (
                    source, self._topics is None or source.topic in self._topics)
            elif isinstance(record, Metadata):
                self.notes[record.name] = record.metadata
            self.complete = isinstance(record, Footer)

    def _plain(self, data: bytes, source: Source) -> bytes | None:
        """Return a message, unpacked where it was compressed by itself; None if it cannot be."""
        if data[:4] != ZSTD:
            return data
        most = min(self._unpacking, MAX_RECORD)
        try:
            made = unpacked('zstd', data, most)
        except Damage as error:
            if 'unpacks to more' in str(error):
                self._unpacking -= most         # that is what it took to find out
            self.damaged(f'{source.topic} message {source.count}: {error}')
            return None
        self._unpacking -= len(made)
        return made

    @cached_property
    def _unpacking(self) -> int:
        """How many bytes messages that are compressed by themselves may still unpack to."""
        return SOME + TIMES * self.path.stat().st_size
