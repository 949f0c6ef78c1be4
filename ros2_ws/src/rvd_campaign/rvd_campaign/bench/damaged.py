"""
Bags that are damaged or made to do harm: changes of a real small bag, by a seed.

`made(seed, base, folder)` leaves a run folder with a changed copy of the bag `base`; the same seed
makes the same one. `faults(run)` gives it to everything that reads bags, as `./rvd report`, the
console's review and `--tape` do, and returns what went wrong: each has to show what it can, or to
refuse it in one line, within `MOST_S` of CPU time. A bomb that is not noticed takes all memory:
call it in a process with a limit (`limited`).
"""

from collections.abc import Callable, Iterator
from contextlib import closing, redirect_stderr, suppress
from dataclasses import dataclass
from functools import lru_cache
from io import BytesIO, StringIO
import os
from pathlib import Path
from random import Random
import resource
import shutil
import socket
import sqlite3
import struct
import subprocess
import sys
import time
from typing import Any
import warnings

from mcap.records import Channel, Message, Metadata, Schema
from mcap.writer import CompressionType, Writer
import zstandard

from rvd_campaign.bench import hostile_texts
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.recording import mcap_file, mcap_records
from rvd_dynamics.recording.messages import files_of

MOST_S = 60.0                           # [s] of CPU time that one reader may take
MEMORY = 3 << 30                        # [B] of address space that all of them may take
SHORT = '/**: {ros__parameters: {timeout_s: 15.0}}\n'   # what `flown` flies: 30 steps
DOUBLES = [struct.pack('<d', x) for x in (
    float('nan'), float('inf'), -float('inf'), 1e308, -1e308, 1e30, -0.0, 5e-324, 0.0)]
WHOLES = [struct.pack('<Q', x) for x in (0, 1, 2**31, 2**32 - 1, 2**53, 2**62, 2**63, 2**64 - 1)]
ESCAPES = '\x1b]0;owned\x07\x1b[2J\x1b[31m<script>alert(1)</script>\u202e\x00&lt;'


def flown(folder: Path) -> Path:
    """Fly a short run into a new folder; return its bag."""
    scenario = folder.with_suffix('.yaml')
    scenario.write_text(SHORT, encoding='utf-8')
    subprocess.run([sys.executable, '-m', 'rvd_campaign.cli', 'fly', str(scenario), '--pace',
                    'lockstep', '--processes', 'one', '--headless', '--out', str(folder)],
                   capture_output=True, check=False)
    return folder / 'bag'


def limited() -> None:
    """Give this process a limit of memory, as a bomb needs it."""
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))


# -- what reads bags -------------------------------------------------------------------------------

def faults(run: Path) -> list[str]:
    """Give a run folder to every reader of bags; return what went wrong, one entry for each."""
    from rvd_campaign.report.replay import load
    from rvd_campaign.report.run import write_report
    from rvd_groundstation.operators.tape import read_tape
    tape = run / 'bag'
    readers: dict[str, Callable[[], Any]] = {
        'review': lambda: load(run.parent, run.name),
        'tape': lambda: read_tape(tape),
        'report': lambda: write_report(run),            # last: it may repair the bag
        'tape after the report': lambda: read_tape(tape)}
    return [f'{name}: {said}' for name, read in readers.items() if (said := _fault(read))]


def _fault(read: Callable[[], Any]) -> str:
    begun, said, noise, warned = time.process_time(), '', StringIO(), []
    try:
        with redirect_stderr(noise), warnings.catch_warnings(record=True) as warned:
            warnings.simplefilter('default')
            read()
    except (BadInput, FileNotFoundError) as error:
        text = str(error)
        if isinstance(error, BadInput) and (not text or not text.isprintable()):
            said = f'the refusal is no line: {text!r}'
    except Exception as error:                  # noqa: B902 - that is what is looked for
        place = error.__traceback__
        while place.tb_next is not None:
            place = place.tb_next
        said = (f'{type(error).__name__}: {error} at '
                f'{place.tb_frame.f_code.co_filename}:{place.tb_lineno}')
    spent = time.process_time() - begun
    told = noise.getvalue() + ''.join(f'{w.message} at {w.filename}:{w.lineno}' for w in warned)
    if not said and told:
        said = f'it says on its own: {told[:300]!r}'
    return said or (f'it took {spent:.0f} s' if spent > MOST_S else '')


# -- the bag that is changed -----------------------------------------------------------------------

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
def _read(base: Path) -> tuple[bytes, tuple]:
    file, = files_of(base)
    return file.read_bytes(), tuple(mcap_records.records(file))


def content_of(base: Path) -> Content:
    """Return the records of the bag that is changed."""
    made = Content({}, {}, [], [])
    for record in _read(base)[1]:
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
        head = mcap_records.MAGIC + mcap_file._bytes_of(
            mcap_file.Header(profile='ros2', library='none'))
        return head + b''.join(mcap_file._bytes_of(r) for r in (
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


def made(seed: int, base: Path, folder: Path) -> Path:
    """
    Leave the run folder `folder` with a damaged copy of the bag `base`; return the folder.

    What was in the folder is removed.
    """
    rng = Random(seed)
    shutil.rmtree(folder, ignore_errors=True)
    (folder / 'bag').mkdir(parents=True)
    (folder / 'verdict.json').write_text('{}', encoding='utf-8')
    rng.choice(DAMAGE)(rng, base, folder / 'bag')
    return folder


def cases(seed: int, count: int, base: Path, folder: Path) -> Iterator[tuple[int, Path]]:
    """Yield `count` damaged run folders with their seeds, each in place of the one before."""
    for each in range(seed, seed + count):
        yield each, made(each, base, folder)


# -- changes of bytes ------------------------------------------------------------------------------

def _any_file(rng: Random, base: Path) -> bytes:
    """Return the bag as one of the files that it can be."""
    kind = rng.randrange(5)
    if kind == 0:
        return written(content_of(base), closed=False)
    if kind == 1:
        return written(content_of(base), CompressionType.ZSTD)
    if kind == 2:
        return written(content_of(base), CompressionType.LZ4)
    return _read(base)[0]


def _cut(rng: Random, data: bytes) -> bytes:
    return data[:rng.randrange(len(data) + 1)]


def _flip(rng: Random, data: bytes) -> bytes:
    changed = bytearray(data)
    for _ in range(rng.choice((1, 1, 1, 3, 10, 100))):
        changed[rng.randrange(len(changed))] ^= 1 << rng.randrange(8)
    return bytes(changed)


def _overwrite(rng: Random, data: bytes) -> bytes:
    at = rng.randrange(len(data))
    new = rng.choice((bytes(rng.choice((8, 512, 4096))), b'\xff' * 8, rng.randbytes(64),
                      rng.choice(WHOLES), rng.choice(DOUBLES)))
    return data[:at] + new + data[at + len(new):]


def _insert(rng: Random, data: bytes) -> bytes:
    at, length = rng.randrange(len(data)), rng.choice((1, 8, 100, 5000))
    new = rng.choice((bytes(length), rng.randbytes(length), data[at:at + length]))
    return data[:at] + new + data[at:]


def _delete(rng: Random, data: bytes) -> bytes:
    at = rng.randrange(len(data))
    return data[:at] + data[at + rng.choice((1, 8, 100, 5000)):]


def _length(rng: Random, data: bytes) -> bytes:
    """Make the length of one record a wrong one."""
    places, at = [], len(mcap_records.MAGIC)
    while at + 9 <= len(data):
        places.append(at)
        at += 9 + struct.unpack_from('<Q', data, at + 1)[0]
    at = rng.choice(places or [0])
    return data[:at + 1] + rng.choice(WHOLES) + data[at + 9:]


def _tail(rng: Random, data: bytes) -> bytes:
    return data + rng.choice((bytes(1000), data, rng.randbytes(1000), mcap_records.MAGIC))


OF_BYTES = (_cut, _cut, _flip, _flip, _overwrite, _insert, _delete, _length, _tail)


def _bytes(rng: Random, base: Path, bag: Path) -> None:
    data = _any_file(rng, base)
    for _ in range(rng.choice((1, 1, 2, 4))):
        if data:
            data = rng.choice(OF_BYTES)(rng, data)
    if rng.random() < 0.1:
        packed = zstandard.compress(data)
        (bag / 'bag_0.mcap.zstd').write_bytes(
            rng.choice(OF_BYTES[:6])(rng, packed) if rng.random() < 0.5 else packed)
        return
    (bag / 'bag_0.mcap').write_bytes(data)


# -- changes of records ----------------------------------------------------------------------------

def _records(rng: Random, base: Path, bag: Path) -> None:
    content = content_of(base)
    for _ in range(rng.choice((1, 1, 2, 4))):
        rng.choice(OF_RECORDS)(rng, content)
    compression = rng.choice((CompressionType.NONE, CompressionType.ZSTD, CompressionType.LZ4))
    (bag / 'bag_0.mcap').write_bytes(written(content, compression, rng.random() < 0.7))


def _some(rng: Random, content: Content) -> list[Message]:
    """Return some messages: of one topic, or of all."""
    if not content.messages or not content.channels:
        return []
    if rng.random() < 0.5:
        number = rng.choice(list(content.channels))
        found = [m for m in content.messages if m.channel_id == number]
    else:
        found = content.messages
    return found if rng.random() < 0.3 or not found else rng.sample(found, min(len(found), 5))


def _data(rng: Random, content: Content) -> None:
    for m in _some(rng, content):
        m.data = rng.choice((
            lambda d: d[:rng.randrange(len(d) + 1)], lambda d: b'', lambda d: rng.randbytes(len(d)),
            lambda d: bytes(len(d)), lambda d: d + rng.randbytes(50),
            lambda d: b'\x28\xb5\x2f\xfd' + d, lambda d: zstandard.compress(d),
            lambda d: b'\x00\x00' + d[2:], lambda d: d * 50))(m.data)


def _numbers(rng: Random, content: Content) -> None:
    """Put numbers of eight bytes where such may stand."""
    for m in _some(rng, content):
        places = range(4, max(len(m.data) - 7, 5), 4)
        for _ in range(rng.choice((1, 1, 5))):
            at = rng.choice(places)
            m.data = m.data[:at] + rng.choice(DOUBLES + WHOLES) + m.data[at + 8:]


def _lengths(rng: Random, content: Content) -> None:
    """Put lengths of strings and arrays where such may stand."""
    for m in _some(rng, content):
        at = rng.choice(range(4, max(len(m.data) - 3, 5), 4))
        m.data = m.data[:at] + struct.pack('<I', rng.choice((0, 1, 255, 2**16, 2**31, 2**32 - 1))
                                           ) + m.data[at + 4:]


def _times(rng: Random, content: Content) -> None:
    for m in _some(rng, content):
        m.log_time = rng.choice((0, 1, 2**63, 2**64 - 1, m.log_time * 1000 % 2**64))


def _topics(rng: Random, content: Content) -> None:
    if len(content.channels) > 1:
        a, b = rng.sample(list(content.channels.values()), 2)
        change = rng.randrange(5)
        if change == 0:
            a.schema_id = b.schema_id
        elif change == 1:
            a.topic = b.topic
        elif change == 2:
            a.schema_id = rng.choice((0, 999))
        elif change == 3:
            a.topic = rng.choice(('', '/', ESCAPES, 'x' * 60_000, '/run/scenario', '/joy'))
        else:
            a.message_encoding = rng.choice(('', 'json', 'ros1', 'cdr2'))


def _types(rng: Random, content: Content) -> None:
    """Change the definition of a type."""
    if not content.schemas:
        return
    schema = rng.choice(list(content.schemas.values()))
    text = schema.data.decode(errors='replace')
    lines = text.split('\n')
    name = schema.name.replace('/msg/', '/')
    change = rng.randrange(12)
    if change == 0:
        rng.shuffle(lines)
        text = '\n'.join(lines)
    elif change == 1:
        text = f'{name} again\n' + text                                 # in itself
    elif change == 2:
        text += '\n# ' + 'x' * 1_000_000
    elif change == 3:
        text = ''.join(f'float64 f{i}\n' for i in range(50_000))
    elif change == 4:
        text = f'{name}[] again\n'
    elif change == 5:
        text = 'x/E[4294967295] all\n' + '=' * 80 + '\nMSG: x/E\n'      # of nothing, often
    elif change == 6:
        text = 'float64[1000000000] many\n'
    elif change == 7:
        text = text.replace('float64', rng.choice(('string', 'uint8', 'wstring', 'float64[]')))
    elif change == 8:
        text = ''.join(f'x/T{i + 1} t\n' + '=' * 80 + f'\nMSG: x/T{i + 1}\n' for i in range(3000))
    elif change == 9:
        schema.encoding = rng.choice(('', 'ros2idl', 'protobuf'))
    elif change == 10:
        schema.name = rng.choice(('', 'x', 'a/b/c/d', ESCAPES, 'std_msgs/msg/String',
                                  'sensor_msgs/msg/Joy'))
    else:
        del lines[rng.randrange(len(lines))]
        text = '\n'.join(lines)
    schema.data = text.encode(errors='replace')


def _order(rng: Random, content: Content) -> None:
    change = rng.randrange(5)
    if change == 0:
        rng.shuffle(content.messages)
    elif change == 1:
        content.messages.reverse()
    elif change == 2:
        content.messages += content.messages
    elif change == 3 and content.channels:
        gone = rng.choice(list(content.channels))
        content.messages = [m for m in content.messages if m.channel_id != gone]
    elif content.messages:
        content.messages = content.messages[:rng.randrange(len(content.messages))]


def _notes(rng: Random, content: Content) -> None:
    junk = rng.choice(('x', '', '-1', '9' * 50, '1e5', 'nan', ESCAPES))
    name = rng.choice(('rvd_missing', 'rvd_lost', 'rvd_recording', 'rosbag2'))
    keys = rng.choice((['/joy', '/truth/relative_state'], ['closed', 'trouble'], ['x' * 1000] * 3,
                       [f'/t{i}' for i in range(5000)]))
    content.notes = [n for n in content.notes if n.name != name]
    content.notes.append(Metadata(name=name, metadata=dict.fromkeys(keys, junk)))


def _string(text: str) -> bytes:
    data = text.encode(errors='replace') + b'\0'
    return b'\x00\x01\x00\x00' + struct.pack('<I', len(data)) + data


def _scenario(rng: Random, content: Content) -> None:
    for i in content.of('/run/scenario'):
        text = hostile_texts.text_of(rng.randrange(10**9))
        content.messages[i].data = _string(
            f'# Scenario {rng.choice(("x", ESCAPES))} as flown, every default resolved.\n{text}')


def _end(rng: Random, content: Content) -> None:
    for i in content.of('/run/end'):
        content.messages[i].data = b'\x00\x01\x00\x00' + rng.choice(WHOLES)


def _words(rng: Random, content: Content) -> None:
    """Put escape sequences where text stands."""
    for topic in ('/run/events', '/run/verdict', '/run/scenario', '/joy'):
        for i in content.of(topic):
            m = content.messages[i]
            for word in (b'docked', b'target_lvlh', b'lunar', b'/m'):
                m.data = m.data.replace(word, b'\x1b[2J<b>$_{'[:len(word)].ljust(len(word), b'\\'))


OF_RECORDS: tuple[Callable[[Random, Content], None], ...] = (
    _data, _data, _numbers, _numbers, _lengths, _times, _topics, _types, _types, _order, _notes,
    _scenario, _scenario, _end, _words)


# -- bombs -----------------------------------------------------------------------------------------

def _bomb(rng: Random, base: Path, bag: Path) -> None:
    head = mcap_records.MAGIC + mcap_file._bytes_of(
        mcap_file.Header(profile='ros2', library='none'))
    kind = rng.randrange(6)
    if kind == 0:                               # 60 kB to 2 GB, the file
        (bag / 'bag_0.mcap.zstd').write_bytes(_zstd_zeros(head, 2 << 30))
    elif kind == 1:
        (bag / 'bag_0.db3.zstd').write_bytes(_zstd_zeros(b'', 2 << 30))
    else:                                       # a chunk, or one message
        word = rng.choice(('zstd', 'lz4', '', 'none', ESCAPES))
        said = rng.choice((0, 1 << 20, 200 << 20, 2 << 30, 2**63))
        data = _zstd_zeros(b'', 2 << 30) if word != 'lz4' else _lz4_zeros(256 << 20)
        body = struct.pack('<QQQI', 0, 1, said, 0) + struct.pack(
            '<I', len(word.encode())) + word.encode() + struct.pack('<Q', len(data)) + data
        chunk = struct.pack('<BQ', 6, len(body)) + body
        if kind == 5:
            content = content_of(base)
            for m in _some(rng, content):
                m.data = data
            (bag / 'bag_0.mcap').write_bytes(written(content))
        else:
            (bag / 'bag_0.mcap').write_bytes(head + chunk * rng.choice((1, 50)))


@lru_cache(maxsize=4)
def _zstd_zeros(head: bytes, size: int) -> bytes:
    packer, made = zstandard.ZstdCompressor(level=3).compressobj(), []
    made.append(packer.compress(head))
    block = bytes(1 << 24)
    for _ in range(size // len(block)):
        made.append(packer.compress(block))
    return b''.join(made) + packer.flush()


@lru_cache(maxsize=1)
def _lz4_zeros(size: int) -> bytes:
    import lz4.frame
    return lz4.frame.compress(bytes(size))


# -- SQLite ----------------------------------------------------------------------------------------

TABLES = '''
CREATE TABLE topics(id INTEGER PRIMARY KEY, name TEXT NOT NULL, type TEXT NOT NULL,
  serialization_format TEXT NOT NULL, offered_qos_profiles TEXT NOT NULL,
  type_description_hash TEXT NOT NULL);
CREATE TABLE message_definitions(id INTEGER PRIMARY KEY, topic_type TEXT NOT NULL,
  encoding TEXT NOT NULL, encoded_message_definition TEXT NOT NULL,
  type_description_hash TEXT NOT NULL);
CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id INTEGER NOT NULL,
  timestamp INTEGER NOT NULL, data BLOB NOT NULL);
'''
ENDLESS = ('WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT i + 1 FROM n) '
           "SELECT i AS id, 1 AS topic_id, i AS timestamp, x'00' AS data FROM n")
HOSTILE = (
    f'DROP TABLE messages; CREATE VIEW messages AS {ENDLESS};',
    f'DROP TABLE messages; CREATE VIEW messages AS {ENDLESS.replace("i + 1", "i")};',
    'DROP TABLE messages; CREATE TABLE messages(id INTEGER PRIMARY KEY, topic_id, timestamp, '
    'data BLOB GENERATED ALWAYS AS (zeroblob(900000000)) VIRTUAL);'
    'INSERT INTO messages(topic_id, timestamp) VALUES (1, 1), (1, 2), (1, 3);',
    'DROP TABLE topics; CREATE VIEW topics AS WITH RECURSIVE n(i) AS (SELECT 1 UNION ALL SELECT '
    "i + 1 FROM n) SELECT i AS id, 'x' AS name, 'y' AS type, 'cdr' AS serialization_format FROM n;",
    'DROP TABLE topics;', 'DROP TABLE messages;', 'DROP TABLE message_definitions;',
    'ALTER TABLE messages RENAME COLUMN data TO datum;', 'DELETE FROM topics;',
    "UPDATE messages SET data = 'text';", 'UPDATE messages SET data = 5;',
    'UPDATE messages SET timestamp = -1;', "UPDATE messages SET timestamp = 'x' WHERE id % 2;",
    'UPDATE messages SET topic_id = 99;',
    'UPDATE messages SET data = zeroblob(3000000) WHERE id < 20;',
    "UPDATE topics SET name = x'ff00ff';", "UPDATE topics SET name = CAST(x'ff' AS TEXT);",
    'UPDATE topics SET type = 7;', "UPDATE message_definitions SET encoded_message_definition = "
    "hex(zeroblob(1000000));", 'PRAGMA journal_mode=WAL;', 'PRAGMA encoding="UTF-16";',
    "CREATE TRIGGER t AFTER INSERT ON messages BEGIN SELECT 1; END;",
    "DROP TABLE messages; CREATE VIRTUAL TABLE messages USING fts5(id, topic_id, timestamp, data);")


def _sqlite(rng: Random, base: Path, bag: Path) -> None:
    content, path = content_of(base), bag / 'bag_0.db3'
    with closing(sqlite3.connect(path)) as made:
        made.executescript(TABLES)
        for number, c in content.channels.items():
            made.execute('INSERT INTO topics VALUES (?, ?, ?, ?, ?, ?)', (
                number, c.topic, content.schemas[c.schema_id].name, c.message_encoding, '', ''))
        for number, s in content.schemas.items():
            made.execute('INSERT INTO message_definitions VALUES (?, ?, ?, ?, ?)', (
                number, s.name, s.encoding, s.data.decode(), ''))
        made.executemany('INSERT INTO messages(topic_id, timestamp, data) VALUES (?, ?, ?)', (
            (m.channel_id, m.log_time, m.data) for m in content.messages))
        made.commit()
        if rng.random() < 0.6:
            with suppress(sqlite3.Error):       # an old SQLite does not know all of it
                made.executescript(rng.choice(HOSTILE))
                made.commit()
    data = path.read_bytes()
    if rng.random() < 0.4:
        data = rng.choice(OF_BYTES)(rng, data)
    path.write_bytes(data)
    beside = rng.randrange(8)
    if beside == 0:
        os.mkfifo(f'{path}-wal')
    elif beside == 1:
        Path(f'{path}-wal').write_bytes(rng.randbytes(5000))
    elif beside == 2:
        Path(f'{path}-journal').write_bytes(rng.randbytes(5000))
    elif beside == 3:
        Path(f'{path}-wal').symlink_to('/dev/zero')
    elif beside == 4:
        path.rename(f'{path}.plain')
        Path(f'{path}.zstd').write_bytes(zstandard.compress(data))


# -- what else can lie at a path -------------------------------------------------------------------

def _place(rng: Random, base: Path, bag: Path) -> None:
    path = bag / f'bag_0{rng.choice((".mcap", ".db3", ".mcap.zstd", ".db3.zstd"))}'
    kind = rng.randrange(10)
    if kind == 0:
        os.mkfifo(path)
    elif kind == 1:
        path.mkdir()
    elif kind == 2:
        path.symlink_to(rng.choice(('/dev/zero', '/dev/random', '/dev/full', '/proc/self/mem')))
    elif kind == 3:
        path.symlink_to(path.name)              # to itself
    elif kind == 4:
        path.symlink_to('nowhere')
    elif kind == 5:
        with closing(socket.socket(socket.AF_UNIX)) as made:
            here = os.open(bag, os.O_RDONLY)
            try:
                made.bind(f'/proc/self/fd/{here}/{path.name}')      # of 107 bytes at most
            finally:
                os.close(here)
    elif kind == 6:
        path.write_bytes(b'')
    elif kind == 7:
        with path.open('wb') as file:
            file.write(_read(base)[0][:rng.choice((0, 8, 5000))])
            file.truncate(1 << 40)              # a terabyte of nothing
    elif kind == 8:
        for i in range(1200):
            (bag / f'bag_{i}.mcap').write_bytes(b'')
    else:
        path.write_bytes(rng.randbytes(10_000))
    if rng.random() < 0.3:                      # beside one that is whole
        (bag / 'bag_1.mcap').write_bytes(_read(base)[0])


def _metadata(rng: Random, base: Path, bag: Path) -> None:
    (bag / 'bag_0.mcap').write_bytes(_read(base)[0])
    path = bag / 'metadata.yaml'
    kind = rng.randrange(6)
    if kind == 0:
        os.mkfifo(path)
    elif kind == 1:
        path.symlink_to('/dev/zero')
    elif kind == 2:
        path.mkdir()
    else:
        path.write_text(rng.choice(hostile_texts.LARGE_ONES)(rng), encoding='utf-8')
    kind = rng.randrange(6)                     # and what the review looks for
    verdict = bag.parent / 'verdict.json'
    if kind < 4:
        verdict.unlink()
        (lambda: os.mkfifo(verdict), lambda: verdict.symlink_to('/dev/zero'), verdict.mkdir,
         lambda: verdict.write_text('[' * 100_000, encoding='utf-8'))[kind]()


DAMAGE: tuple[Callable[[Random, Path, Path], None], ...] = (
    _bytes, _bytes, _bytes, _records, _records, _records, _records, _sqlite, _sqlite, _place, _bomb,
    _metadata)
