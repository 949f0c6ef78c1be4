"""
Bags that are damaged or made to do harm: what can be read is shown, and what cannot is said.

The bag that is damaged is a small run, written as the recorder writes one.
"""

from contextlib import closing, suppress
import io
import json
import os
import shutil
import sqlite3
import struct
import subprocess
import sys
import threading

from mcap.stream_reader import StreamReader
from mcap.writer import CompressionType
import numpy as np
import pytest
from rclpy.serialization import deserialize_message, serialize_message

import small_run
from rvd_campaign.bench import damaged
from rvd_campaign.bench.damaged import bombs, of_tables
from rvd_campaign.bench.damaged.content import content_of, string, written
from rvd_campaign.report import replay
from rvd_campaign.report.run import page, write_report
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.recording import limits, mcap_records, messages
from rvd_dynamics.recording.bag_writer import repair
from rvd_dynamics.recording.messages import MessageFile
from rvd_dynamics.recording.reader import read
from rvd_groundstation.console import review
from rvd_groundstation.operators.tape import read_tape
from rvd_interfaces.msg import RelativeState

LIMIT = 1536 << 20              # [B] of address space in which a bomb of 2 GB has no room


@pytest.fixture(scope='module')
def base(tmp_path_factory):
    """The bag of a small run."""
    run = tmp_path_factory.mktemp('base') / 'run'
    small_run.write_run(run)
    return run / 'bag'


@pytest.fixture
def run(base, tmp_path):
    """A copy of it, to be damaged."""
    shutil.copytree(base.parent, tmp_path / 'run')
    (tmp_path / 'run' / 'verdict.json').write_text('{}')
    return tmp_path / 'run'


def file_of(run):
    """Return the file of a run's bag."""
    return run / 'bag' / 'bag_0.mcap'


def refusal(call, *args):
    """Return what is refused, which is one line."""
    with pytest.raises(BadInput) as refused:
        call(*args)
    assert str(refused.value).isprintable()
    return str(refused.value)


SEEDS = '''
import sys
from pathlib import Path
from rvd_campaign.bench import damaged
damaged.limited()
for seed, run in damaged.cases(int(sys.argv[1]), int(sys.argv[2]), Path(sys.argv[3]),
                               Path(sys.argv[4])):
    for fault in damaged.faults(run):
        print(seed, fault)
'''


@pytest.mark.slow
@pytest.mark.patient
def test_damaged_bags_are_shown_or_refused(base, tmp_path):
    done = subprocess.run(
        [sys.executable, '-c', SEEDS, '2000', '12', str(base), str(tmp_path / 'run')],
        capture_output=True, text=True)
    assert (done.returncode, done.stdout) == (0, ''), done.stdout + done.stderr[-2000:]


def test_a_reader_that_does_anything_else_is_found(run, monkeypatch):
    """The negative twin."""
    assert not damaged.faults(run)              # what it imports binds the real readers
    monkeypatch.setattr(replay, 'load', lambda runs, name: {}['frames'])
    monkeypatch.setattr('rvd_groundstation.operators.tape.read_tape',
                        lambda path: print('on its own', file=sys.stderr))
    found = damaged.faults(run)
    assert [f.split(':')[0] for f in found] == ['review', 'tape', 'tape after the report']
    assert 'KeyError' in found[0] and 'on its own' in found[1]


# -- a file that is damaged ------------------------------------------------------------------------

def test_what_comes_before_a_damage_is_read_and_the_rest_is_said(run):
    """A length that leads nowhere: of 60 s the first part is read."""
    whole = read(run)
    data = file_of(run).read_bytes()
    at = len(mcap_records.MAGIC)
    for _ in range(3):                          # header, and two chunks
        at += 9 + struct.unpack_from('<Q', data, at + 1)[0]
    file_of(run).write_bytes(data[:at + 1] + b'\xff' * 8 + data[at + 9:])
    assert not repair(run / 'bag')              # what cannot be read is not thrown away
    found = read(run)
    count = len(found.of('/truth/relative_state'))
    assert 0 < count < len(whole.of('/truth/relative_state'))
    np.testing.assert_array_equal(found.of('/truth/relative_state').state,
                                  whole.of('/truth/relative_state').state[:count])
    said, = found.damage
    assert said.startswith(f'bag_0.mcap: the first {0.5 * (count - 1):g} of 60 s could be read; '
                           f'the rest is damaged: byte {at}: a length leads beyond the end')
    text = write_report(run).read_text()
    assert 'of 60 s could be read; the rest is damaged' in text
    shown = json.loads(replay.load(run.parent, run.name))
    assert shown['frames'] and 'damaged' in shown['events'][-1]['text']
    assert 'not a readable MCAP file: byte' in refusal(read_tape, run / 'bag')


def test_a_number_that_was_changed_is_noticed_by_its_checksum(run):
    data = bytearray(file_of(run).read_bytes())
    value = struct.pack('<d', small_run.true_state(30)[0])
    data[data.index(value) + 6] ^= 1
    file_of(run).write_bytes(data)
    said, = read(run).damage
    assert 'its checksum does not match: numbers in it may be wrong' in said
    assert read(run).judged and 'may be wrong' in page(read(run))


def test_an_undamaged_bag_is_not_called_damaged(run):
    """The negative twin, also of a bag that was merely cut off."""
    assert read(run).damage == () and 'damaged' not in page(read(run))
    data = file_of(run).read_bytes()
    file_of(run).write_bytes(data[:len(data) // 2])
    assert read(run).damage == () and not read(run).complete
    assert repair(run / 'bag')


def changed(run, topic, change):
    """Change the messages of a topic by `change(data)`."""
    content = content_of(run / 'bag')
    for i in content.of(topic):
        content.messages[i].data = change(content.messages[i].data)
    file_of(run).write_bytes(written(content))


@pytest.mark.parametrize('topic, change, said', [
    ('/truth/relative_state', lambda data: data[:50], '/truth/relative_state: 100 messages left'),
    ('/run/verdict', lambda data: data[:20], '/run/verdict: 100 messages left out'),
    ('/run/end', lambda data: data[:4] + b'\xff' * 8, '/run/end: 1 message left out'),
    ('/run/scenario', lambda data: string('&a [*a]'), 'aliases are not allowed')])
def test_a_topic_that_cannot_be_read_takes_no_other_with_it(run, topic, change, said):
    changed(run, topic, change)
    text = page(read(run))
    assert said in text
    assert ('<svg' in text) == (topic != '/run/scenario')


@pytest.mark.parametrize('name', ['', 'status', '/status', '//'])
def test_a_status_of_a_link_is_shown_whatever_its_topic_is_called(run, name):
    content = content_of(run / 'bag')
    for channel in content.channels.values():
        if channel.topic == '/run/scenario':        # or the scenario would say which legs there are
            channel.topic = '/elsewhere'
        elif channel.topic == '/link/forward/status':
            channel.topic = name
    file_of(run).write_bytes(written(content))
    links = read(run).links
    assert len(links) == 2 and len(links.pop('back').history) == len(links.popitem()[1].history) > 0
    assert damaged.faults(run) == []


def test_numbers_that_no_run_has_are_reviewed_without_a_word_on_the_side(run):
    """Their squares are more than the largest float."""
    def huge(data):
        state = deserialize_message(data, RelativeState)
        state.position.y = 1e200
        return serialize_message(state)
    changed(run, '/ground/prediction', huge)
    assert damaged.faults(run) == []


def test_a_step_beyond_the_run_is_none(run):
    content = content_of(run / 'bag')
    at = content.of('/truth/relative_state')[7]
    message = content.messages[at]
    step = message.data.index(struct.pack('<Q', 7), 8)
    message.data = message.data[:step] + struct.pack('<Q', 2**63) + message.data[step + 8:]
    file_of(run).write_bytes(written(content))
    found = read(run)
    assert found.last_step == small_run.LAST
    assert found.missing['/truth/relative_state'] == 1
    assert len(found.of('/truth/relative_state')) == small_run.LAST
    assert 'is of step 9223372036854775808' in page(read(run))


def test_escape_sequences_of_a_bag_stay_in_it(run):
    file_of(run).unlink()
    (run / 'bag' / 'x\x1b[2J.mcap').write_bytes(b'nonsense')
    assert 'x\\x1b[2J.mcap' in refusal(read_tape, run / 'bag')
    assert 'x\\x1b[2J.mcap' in refusal(write_report, run)


# -- what costs more than it may -------------------------------------------------------------------

BOMB = '''
import resource, sys
from pathlib import Path
resource.setrlimit(resource.RLIMIT_AS, ({limit}, {limit}))
sys.path.insert(0, {test!r})
import test_damaged
test_damaged.{what}(Path(sys.argv[1]))
'''


def bomb(path):
    """Write a chunk of 60 kB that unpacks to 2 GB."""
    data = bombs.zstd_zeros(b'', 2 << 30)
    body = struct.pack('<QQQI', 0, 1, 2 << 30, 0) + struct.pack('<I4sQ', 4, b'zstd', len(data))
    path.write_bytes(mcap_records.MAGIC + struct.pack('<BQ', 6, len(body) + len(data)) + body
                     + data)
    assert path.stat().st_size < 100_000


def read_it(path):
    """Read a bomb as we do."""
    file = MessageFile(path)
    assert not list(file)
    print(*file.damage)


def read_it_plainly(path):
    """Read a bomb as the library of the format does: the negative twin."""
    with path.open('rb') as file, suppress(EOFError):
        list(StreamReader(file).records)


@pytest.mark.parametrize('what, fails', [('read_it', ''), ('read_it_plainly', 'MemoryError')])
def test_a_bomb_is_not_unpacked(tmp_path, what, fails):
    bomb(tmp_path / 'x.mcap')
    done = subprocess.run(
        [sys.executable, '-c', BOMB.format(limit=LIMIT, test=os.path.dirname(__file__), what=what),
         str(tmp_path / 'x.mcap')], capture_output=True, text=True)
    if fails:
        assert done.returncode != 0
    else:
        assert done.returncode == 0, done.stderr[-1000:]
        assert 'a chunk of messages: 2147483648 bytes' in done.stdout


def test_bombs_that_are_messages_are_unpacked_once(base, tmp_path, monkeypatch):
    content, packed = content_of(base), bombs.zstd_zeros(b'', 1 << 30)
    for message in content.messages[:200]:
        message.data = packed
    (tmp_path / 'x.mcap').write_bytes(written(content))
    monkeypatch.setattr(messages, 'TIMES', 2)
    spent = []
    monkeypatch.setattr(messages, 'unpacked', lambda kind, data, most: (
        spent.append(most), limits.unpacked(kind, data, most))[1])
    file = MessageFile(tmp_path / 'x.mcap')
    assert len(list(file)) == len(content.messages) - 200 and len(spent) == 200
    assert sum(spent) <= messages.SOME + 2 * (tmp_path / 'x.mcap').stat().st_size
    assert 'unpacks to more than' in file.damage[0]


def test_a_file_of_zstd_is_unpacked_as_far_as_its_size_allows(tmp_path):
    (tmp_path / 'x.mcap.zstd').write_bytes(
        bombs.zstd_zeros(mcap_records.MAGIC + struct.pack('<BQ', 0x80, 1 << 30), 2 << 30))
    file = MessageFile(tmp_path / 'x.mcap.zstd')
    assert not list(file) and 'unpacks to more than' in file.damage[0]


def tables(path):
    """Write an empty SQLite file of rosbag2."""
    with closing(sqlite3.connect(path)) as base:
        base.executescript(of_tables.TABLES)
        base.execute("INSERT INTO topics VALUES (1, '/joy', 'sensor_msgs/msg/Joy', 'cdr', '', '')")
        base.commit()


def alter(path, script):
    with closing(sqlite3.connect(path)) as base:
        base.executescript(script)


@pytest.mark.parametrize('script, said', [
    (of_tables.HOSTILE[0], 'messages is a view'), (of_tables.HOSTILE[1], 'messages is a view'),
    (of_tables.HOSTILE[2], 'columns that are computed'), (of_tables.HOSTILE[3], 'topics is a view'),
    ('DROP TABLE topics;', 'no table topics')])
def test_a_table_that_is_a_program_is_refused(tmp_path, script, said):
    tables(tmp_path / 'x.db3')
    alter(tmp_path / 'x.db3', script)
    assert said in refusal(read, tmp_path / 'x.db3')


def test_a_query_without_an_end_is_one_for_sqlite(tmp_path):
    """The negative twin: it would be read for ever."""
    tables(tmp_path / 'x.db3')
    alter(tmp_path / 'x.db3', of_tables.HOSTILE[0])
    with closing(sqlite3.connect(tmp_path / 'x.db3')) as base:
        assert len(base.execute('SELECT data FROM messages').fetchmany(100_000)) == 100_000


def test_a_pipe_beside_a_table_is_refused(tmp_path):
    tables(tmp_path / 'x.db3')
    os.mkfifo(tmp_path / 'x.db3-wal')
    assert 'x.db3-wal is no regular file' in refusal(read, tmp_path / 'x.db3')


# -- what is no file -------------------------------------------------------------------------------

@pytest.mark.parametrize('make', [
    os.mkfifo, os.mkdir, lambda path: os.symlink('/dev/zero', path),
    lambda path: os.symlink(path, path), lambda path: os.symlink('nowhere', path)])
@pytest.mark.parametrize('name', ['bag_0.mcap', 'bag_0.db3', 'bag_0.mcap.zstd'])
def test_what_is_no_file_is_refused_by_everything(run, make, name):
    file_of(run).unlink()
    make(run / 'bag' / name)
    for reader in (write_report, read, lambda path: read_tape(path / 'bag'),
                   lambda path: replay.load(path.parent, path.name)):
        refusal(reader, run)
    assert damaged.faults(run) == []


def test_one_file_that_is_none_does_not_hide_the_others(run):
    os.mkfifo(run / 'bag' / 'bag_1.mcap')
    found = read(run)
    assert found.judged and 'is a pipe or a device' in found.damage[0]


def test_a_trap_in_the_folder_of_the_runs_does_not_stop_the_list(run):
    for name, make in (('a', os.mkfifo), ('b', lambda path: os.symlink('/dev/zero', path)),
                       ('c', lambda path: os.symlink('nowhere', path)), ('d', os.mkdir)):
        (run.parent / name).mkdir()
        make(run.parent / name / 'verdict.json')
    (run.parent / 'e').mkdir()
    (run.parent / 'e' / 'verdict.json').write_text('[]')
    listed = []
    thread = threading.Thread(target=lambda: listed.extend(review.listing(run.parent)), daemon=True)
    thread.start()
    thread.join(30.0)
    assert not thread.is_alive() and [row['name'] for row in listed] == ['run']


def test_a_draft_that_somebody_has_planted_is_not_written_through(run):
    precious = run.parent / 'precious'
    precious.write_text('years of work')
    (run / 'report.html.draft').symlink_to(precious)
    write_report(run)
    assert precious.read_text() == 'years of work' and (run / 'report.html').exists()
    (run / 'twin.draft').symlink_to(precious)           # the negative twin: a plain open
    with (run / 'twin.draft').open('wb') as file:
        file.write(b'gone')
    assert precious.read_text() == 'gone'


def test_a_chunk_of_any_compression_is_read_as_it_was_written(base, tmp_path):
    content, whole = content_of(base), None
    for kind in CompressionType:
        (tmp_path / 'x.mcap').write_bytes(written(content, kind))
        got = [(s.topic, s.data, s.log_ns) for s in MessageFile(tmp_path / 'x.mcap')]
        whole = whole or got
        assert got == whole and len(got) == len(content.messages)


def test_records_are_those_of_the_library(base):
    path = base / 'bag_0.mcap'
    ours = [r for r in mcap_records.records(path) if isinstance(r, mcap_records.Message)]
    theirs = [r for r in StreamReader(io.BytesIO(path.read_bytes())).records
              if isinstance(r, mcap_records.Message)]
    assert ours == theirs and len(ours) > 1000
