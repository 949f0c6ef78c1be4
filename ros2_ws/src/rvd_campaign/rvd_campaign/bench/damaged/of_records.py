"""Changes of records: whole MCAP files whose content no recorder writes."""

from collections.abc import Callable
from pathlib import Path
from random import Random
import struct

from mcap.records import Metadata
from mcap.writer import CompressionType
import zstandard

from rvd_campaign.bench import hostile_texts
from rvd_campaign.bench.damaged.content import (
    Content, content_of, DOUBLES, ESCAPES, some, string, WHOLES, written)


def damage(rng: Random, base: Path, bag: Path) -> None:
    """Leave the bag with changes of its records."""
    content = content_of(base)
    for _ in range(rng.choice((1, 1, 2, 4))):
        rng.choice(OF_RECORDS)(rng, content)
    compression = rng.choice((CompressionType.NONE, CompressionType.ZSTD, CompressionType.LZ4))
    (bag / 'bag_0.mcap').write_bytes(written(content, compression, rng.random() < 0.7))


def _data(rng: Random, content: Content) -> None:
    for m in some(rng, content):
        m.data = rng.choice((
            lambda d: d[:rng.randrange(len(d) + 1)], lambda d: b'', lambda d: rng.randbytes(len(d)),
            lambda d: bytes(len(d)), lambda d: d + rng.randbytes(50),
            lambda d: b'\x28\xb5\x2f\xfd' + d, lambda d: zstandard.compress(d),
            lambda d: b'\x00\x00' + d[2:], lambda d: d * 50))(m.data)


def _numbers(rng: Random, content: Content) -> None:
    """Put numbers of eight bytes where such may stand."""
    for m in some(rng, content):
        places = range(4, max(len(m.data) - 7, 5), 4)
        for _ in range(rng.choice((1, 1, 5))):
            at = rng.choice(places)
            m.data = m.data[:at] + rng.choice(DOUBLES + WHOLES) + m.data[at + 8:]


def _lengths(rng: Random, content: Content) -> None:
    """Put lengths of strings and arrays where such may stand."""
    for m in some(rng, content):
        at = rng.choice(range(4, max(len(m.data) - 3, 5), 4))
        m.data = m.data[:at] + struct.pack('<I', rng.choice((0, 1, 255, 2**16, 2**31, 2**32 - 1))
                                           ) + m.data[at + 4:]


def _times(rng: Random, content: Content) -> None:
    for m in some(rng, content):
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


def _scenario(rng: Random, content: Content) -> None:
    for i in content.of('/run/scenario'):
        text = hostile_texts.text_of(rng.randrange(10**9))
        content.messages[i].data = string(
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
