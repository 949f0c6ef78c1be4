"""The bag: what was given is there, for readers that are not ours, whatever ends the writer."""

import os
from pathlib import Path
import signal
import subprocess
import sys

from mcap.reader import make_reader
from mcap.records import Footer, Message
import pytest
from rclpy.serialization import serialize_message
from rosbags.highlevel import AnyReader
from rosbags.rosbag2 import Reader
from rosbags.typesys import Stores, get_typestore
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Joy
from std_msgs.msg import String
import yaml

from rvd_dynamics.diagram.ros.conversions import header_at, time_at
from rvd_dynamics.diagram.roster import Roster
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.diagram.signal import VALUES
from rvd_dynamics.recording import bag_writer, definitions, mcap_file
from rvd_dynamics.recording.bag_writer import BagWriter, repair
from rvd_dynamics.recording.rosbag2 import qos_words
from rvd_dynamics.recording.steps import (
    HEADER_THEN_STEP, STAMP_FIRST, STEP_FIRST, StepLedger, step_reader)
from rvd_interfaces import msg as interfaces
from rvd_interfaces.msg import LinkFrame, ThrustCommand

STEP_NS = 500_000_000
ROSTER = Roster(parse('/**: {ros__parameters: {}}', 'written'))
COMMAND, FRAME, TEXT = '/ground/command', '/ground/uplink', '/run/scenario'
TOPICS = {COMMAND: 'rvd_interfaces/msg/ThrustCommand', FRAME: 'rvd_interfaces/msg/LinkFrame',
          TEXT: 'std_msgs/msg/String'}
QOS = qos_words(2000, True, True)
WORTH = {TEXT: 0, COMMAND: 1, FRAME: 2}


def command(step: int) -> ThrustCommand:
    return ThrustCommand(header=header_at(step * STEP_NS, 'target_lvlh'), step=step,
                         levels=[step % 7 - 3, 0, 1], valid=True, pilot_weight=0.7)


def frame(step: int) -> LinkFrame:
    return LinkFrame(step=step, sequence=step, sent=step * STEP_NS, payload=bytes(step % 64))


def published(steps: int) -> list[tuple[str, bytes, int]]:
    """Return (topic, bytes, log time) of a small run, the scenario first."""
    messages = [(TEXT, serialize_message(String(data='step_s: 0.5')), 0)]
    for k in range(steps):
        messages += [(COMMAND, serialize_message(command(k)), k * STEP_NS),
                     (FRAME, serialize_message(frame(k)), k * STEP_NS)]
    return messages


def write(directory: Path, messages, close=True) -> BagWriter:
    bag = BagWriter(directory)
    for topic, kind in TOPICS.items():
        bag.add_topic(topic, kind, QOS)
    for i, (topic, data, log_ns) in enumerate(messages):
        assert bag.write(topic, data, log_ns, 1_700_000_000_000_000_000 + i, i)
    if close:
        bag.close({'note': {'key': 'value'}})
    return bag


def stored(path: Path) -> list[tuple[str, bytes, int]]:
    """Return what the file holds, read record by record."""
    topics, found = {}, []
    for record in mcap_file.records(path):
        if hasattr(record, 'topic'):
            topics[record.id] = record.topic
        elif isinstance(record, Message):
            found.append((topics[record.channel_id], record.data, record.log_time))
    return found


# -- definitions and steps ----------------------------------------------------------------------

@pytest.mark.parametrize('kind', sorted({*ROSTER.topics.values(), VALUES}))
def test_definition_is_what_rosbags_parses_and_its_hash_is_the_one_ros_announces(kind):
    from rosbags.typesys import get_types_from_msg
    parsed = get_types_from_msg(definitions.schema_text(kind), kind)
    assert kind in parsed
    package, _, name = kind.split('/')
    module = __import__(f'{package}.msg', fromlist=[name])
    announced = getattr(module, name)
    assert {f[0] for f in parsed[kind][1]} == set(announced.get_fields_and_field_types())
    store = get_typestore(Stores.ROS2_JAZZY)
    store.register({k: v for k, v in parsed.items() if k not in store.types})
    assert store.hash_rihs01(kind) == definitions.type_hash(kind)


def test_unknown_type_is_a_lookup_error_that_names_it():
    with pytest.raises(LookupError, match='nowhere/msg/Nothing'):
        definitions.schema_text('nowhere/msg/Nothing')
    with pytest.raises(LookupError, match='std_msgs/msg/Nothing'):
        definitions.type_hash('std_msgs/msg/Nothing')


@pytest.mark.parametrize('kind', sorted(HEADER_THEN_STEP | STEP_FIRST))
@pytest.mark.parametrize('frame_id', ['x' * n for n in range(9)] + ['target_lvlh'])
def test_step_is_read_from_the_bytes(kind, frame_id):
    message = getattr(interfaces, kind.split('/')[-1])(step=0x0123456789abcdef)
    if hasattr(message, 'header'):
        message.header = header_at(-1, frame_id)
    assert step_reader(kind, STEP_NS)(serialize_message(message)) == 0x0123456789abcdef


def test_step_of_what_carries_none_is_its_stamp():
    joy = Joy(header=header_at(41 * STEP_NS, 'stick'), axes=[0.5])
    assert step_reader('sensor_msgs/msg/Joy', STEP_NS)(serialize_message(joy)) == 41
    clock = Clock(clock=time_at(41 * STEP_NS))
    assert step_reader('rosgraph_msgs/msg/Clock', STEP_NS)(serialize_message(clock)) == 41
    assert step_reader('std_msgs/msg/String', STEP_NS) is None


def test_every_topic_that_is_written_once_per_step_tells_its_step():
    kinds = {ROSTER.topics[topic] for topic in ROSTER.owed}
    assert kinds <= HEADER_THEN_STEP | STEP_FIRST | STAMP_FIRST


def test_ledger_counts_the_steps_that_never_came():
    ledger = StepLedger()
    ledger.expect('a')
    ledger.expect('b')
    for step in (0, 1, 4, 4, 3, 5):
        ledger.saw('a', step)
    assert ledger.missing == {'a': 2, 'b': 0} and not ledger.reached(5)
    ledger.end(6)
    assert ledger.missing == {'a': 3, 'b': 7} and ledger.reached(6)


def test_ledger_expects_a_slow_node_at_its_firings_only():
    ledger = StepLedger()
    ledger.expect('a', 4)
    for step in (0, 4, 12):
        ledger.saw('a', step)
    assert ledger.missing == {'a': 1}
    assert ledger.reached(15) and not ledger.reached(16)
    ledger.end(15)
    assert ledger.missing == {'a': 1}
    ledger.end(25)                              # without the firings of 16, 20 and 24
    assert ledger.missing == {'a': 4} and ledger.reached(25)


# -- a bag that was closed ----------------------------------------------------------------------

def test_rosbags_reads_back_what_was_written(tmp_path):
    messages = published(30)
    write(tmp_path / 'bag', messages)
    with Reader(tmp_path / 'bag') as reader:
        assert {c.topic: c.msgcount for c in reader.connections} == {COMMAND: 30, FRAME: 30,
                                                                     TEXT: 1}
        assert [(c.topic, bytes(d), t) for c, t, d in reader.messages()] == messages
        assert reader.duration == 29 * STEP_NS + 1
    with AnyReader([tmp_path / 'bag']) as reader:
        decoded = [(c.topic, reader.deserialize(d, c.msgtype))
                   for c, _, d in reader.messages() if c.topic != TEXT]
    assert [m.levels[0] for t, m in decoded if t == COMMAND] == [k % 7 - 3 for k in range(30)]
    assert [bytes(m.payload) for t, m in decoded if t == FRAME] == [bytes(k)
                                                                   for k in range(30)]


def test_reference_library_finds_index_profile_and_metadata(tmp_path):
    messages = published(2000)                  # several chunks
    bag = write(tmp_path / 'bag', messages)
    with bag.path.open('rb') as stream:
        reader = make_reader(stream, validate_crcs=True)
        summary = reader.get_summary()
        assert reader.get_header().profile == 'ros2'
        assert summary.statistics.message_count == len(messages)
        assert len(summary.chunk_indexes) > 1
        assert all(c.message_index_length > 0 for c in summary.chunk_indexes)
        late = list(reader.iter_messages(topics=[COMMAND], starting_at=1990 * STEP_NS))
        assert [m.data for _, _, m in late] == [data for topic, data, log_ns in messages
                                                if topic == COMMAND and log_ns >= 1990 * STEP_NS]
        assert len(late) == 10
        notes = {m.name: m.metadata for m in reader.iter_metadata()}
        for channel in summary.channels.values():
            assert channel.metadata['topic_type_hash'].startswith('RIHS01_')
            assert yaml.safe_load(channel.metadata['offered_qos_profiles']) == QOS
    assert notes['note'] == {'key': 'value'}
    assert notes['rvd_recording'] == {'closed': 'true', 'trouble': ''}
    assert set(notes) == {'note', 'rvd_recording', 'rvd_lost', 'rosbag2'}
    inner = yaml.safe_load(notes['rosbag2']['serialized_metadata'])
    outer = yaml.safe_load((tmp_path / 'bag/metadata.yaml').read_text())
    assert outer == {'rosbag2_bagfile_information': inner}


def test_metadata_has_every_key_of_version_9_and_spells_the_quality_of_service(tmp_path):
    write(tmp_path / 'bag', published(3))
    info = yaml.safe_load((tmp_path / 'bag/metadata.yaml').read_text())[
        'rosbag2_bagfile_information']
    assert set(info) == {
        'version', 'storage_identifier', 'duration', 'starting_time', 'message_count',
        'topics_with_message_count', 'compression_format', 'compression_mode',
        'relative_file_paths', 'files', 'custom_data', 'ros_distro'}
    assert info['version'] == 9 and info['message_count'] == 7
    assert info['relative_file_paths'] == ['bag_0.mcap'] == [f['path'] for f in info['files']]
    for entry in info['topics_with_message_count']:
        assert set(entry['topic_metadata']) == {
            'name', 'type', 'serialization_format', 'offered_qos_profiles',
            'type_description_hash'}
        assert entry['topic_metadata']['offered_qos_profiles'][0]['reliability'] == 'reliable'


def test_metadata_is_there_from_the_beginning(tmp_path):
    BagWriter(tmp_path / 'bag')
    assert yaml.safe_load((tmp_path / 'bag/metadata.yaml').read_text())[
        'rosbag2_bagfile_information']['message_count'] == 0


def test_a_directory_that_holds_something_is_refused(tmp_path):
    (tmp_path / 'precious').write_text('data')
    with pytest.raises(ValueError, match='not empty'):
        BagWriter(tmp_path)


# -- a bag that was not ---------------------------------------------------------------------------

def test_a_file_cut_at_any_byte_gives_whole_messages_from_the_first_on(tmp_path):
    messages = published(6)
    bag = write(tmp_path / 'bag', messages, close=False)
    whole = bag.path.read_bytes()
    cut = tmp_path / 'cut.mcap'
    counts = []
    text = len(whole) - 500                     # before that: definitions, for the most part
    for size in (*range(0, text, 17), *range(text, len(whole) + 1)):
        cut.write_bytes(whole[:size])
        found = stored(cut)
        assert found == messages[:len(found)]
        counts.append(len(found))
    assert counts == sorted(counts) and counts[-1] == len(messages)


def test_a_closed_file_cut_or_damaged_anywhere_is_read_up_to_there(tmp_path):
    messages = published(150)
    bag = write(tmp_path / 'bag', messages)
    whole = bag.path.read_bytes()
    cut = tmp_path / 'cut.mcap'
    for size in range(0, len(whole), 997):
        cut.write_bytes(whole[:size])
        found = stored(cut)
        assert found == messages[:len(found)]
    for at in range(0, len(whole), 1999):
        cut.write_bytes(whole[:at] + bytes([whole[at] ^ 0xff]) + whole[at + 1:])
        try:
            stored(cut)                         # content may be wrong, reading must end
        except KeyError:
            pass                                # a message of a channel whose id was hit


WRITER = '''
import sys, pathlib
sys.path.insert(0, {test!r})
import test_bag_writer as t
bag = t.write(pathlib.Path(sys.argv[1]), [], close=False)
print('open', flush=True)
for i, (topic, data, log_ns) in enumerate(t.published(2000)):
    bag.write(topic, data, log_ns, i)
    print(i, flush=True)
'''


def test_kill_9_loses_nothing_that_was_taken(tmp_path):
    directory = tmp_path / 'bag'
    process = subprocess.Popen(
        [sys.executable, '-c', WRITER.format(test=str(Path(__file__).parent)), str(directory)],
        stdout=subprocess.PIPE, text=True)
    last = -1
    for line in process.stdout:
        if line.strip().isdigit():
            last = int(line)
        if last == 500:
            process.send_signal(signal.SIGKILL)
    process.wait()
    count = len(stored(directory / 'bag_0.mcap'))
    assert last >= 500 and last + 1 <= count <= last + 2

    assert repair(directory) and not repair(directory)
    with Reader(directory) as reader:           # needs end and index
        assert sum(1 for _ in reader.messages()) == reader.message_count == count
    notes = [r for r in mcap_file.records(directory / 'bag_0.mcap')
             if getattr(r, 'name', '') == 'rvd_recording']
    assert notes[0].metadata['closed'] == 'false'


def test_a_bag_that_is_being_written_is_not_repaired(tmp_path):
    bag = write(tmp_path / 'bag', published(3), close=False)
    size = bag.path.stat().st_size
    assert not repair(tmp_path / 'bag') and bag.path.stat().st_size == size
    bag.close()
    assert isinstance(list(mcap_file.records(bag.path))[-1], Footer)


# -- a disk that is full ------------------------------------------------------------------------

class SmallDisk:
    """Stands for `os.write` on a disk that takes `room` bytes; the last write is cut short."""

    def __init__(self, room: int) -> None:
        self.room = room
        self._write = os.write

    def __call__(self, file: int, data: bytes) -> int:
        if self.room <= 0:
            raise OSError(28, 'No space left on device')
        written = self._write(file, data[:self.room])
        self.room -= written
        return written


class CuttingDisk(SmallDisk):
    """Takes whole what fits; what does not is cut short, and taken back by the writer."""

    def __call__(self, file: int, data: bytes) -> int:
        if len(data) > self.room:
            return self._write(file, data[:self.room])
        return super().__call__(file, data)


def test_full_disk_costs_what_is_worth_least_and_every_loss_is_counted(tmp_path, monkeypatch):
    """R1: whole records up to the limit, one complaint, commands go on when there is room."""
    bag = BagWriter(tmp_path / 'bag', worth=WORTH.get)
    for topic, kind in TOPICS.items():
        bag.add_topic(topic, kind, QOS)
    messages = published(200)
    disk = SmallDisk(5000)
    monkeypatch.setattr(mcap_file.os, 'write', disk)
    taken = []
    for i, (topic, data, log_ns) in enumerate(messages):
        if i == 300:
            disk.room = 1 << 30                 # room again
        if bag.write(topic, data, log_ns, i):
            taken.append((topic, data, log_ns))
    assert bag.trouble.startswith('cannot write bag_0.mcap: No space left')
    bag.close()
    found = stored(bag.path)
    assert found == taken
    assert {t for t, _, _ in taken[-40:]} == {COMMAND, FRAME}       # once off, off
    assert sum(bag.lost.values()) + len(found) == len(messages)
    notes = {r.name: r.metadata for r in mcap_file.records(bag.path) if hasattr(r, 'metadata')
             and hasattr(r, 'name')}
    assert {t: int(n) for t, n in notes['rvd_lost'].items()} == dict(bag.lost)
    assert notes['rvd_recording']['trouble'] == bag.trouble


@pytest.mark.parametrize('room', [100, 2500, 5000, 5001, 1 << 30])
def test_messages_stored_together_are_those_that_would_be_stored_one_by_one(
        tmp_path, monkeypatch, room):
    """On a disk that takes them all, or gives up within a batch; every loss is counted."""
    found, lost = [], []
    real = os.write
    sent = list(published(60))              # once: padding is whatever the memory held
    for name, together in (('one', 1), ('batches', 37)):
        monkeypatch.setattr(mcap_file.os, 'write', real)
        bag = BagWriter(tmp_path / name, worth=WORTH.get)
        for topic, kind in TOPICS.items():
            bag.add_topic(topic, kind, QOS)
        messages = [(topic, data, log_ns, i, i)
                    for i, (topic, data, log_ns) in enumerate(sent)]
        messages.insert(3, ('/nobody', b'x', 0, 0, 0))
        monkeypatch.setattr(mcap_file.os, 'write', CuttingDisk(room))
        for at in range(0, len(messages), together):
            bag.write_all(messages[at:at + together])
        monkeypatch.setattr(mcap_file.os, 'write', real)
        bag.close()
        found.append(stored(bag.path))
        lost.append(dict(bag.lost))
        assert bag.contents.count == len(found[-1])
        assert len(found[-1]) + sum(bag.lost.values()) == len(messages)
        assert bool(bag.trouble) == (room < 1 << 30)
    assert found[0] == found[1] and lost[0] == lost[1]


def test_a_disk_that_is_nearly_full_is_left_to_what_is_worth_it(tmp_path, monkeypatch):
    free = 40_000
    monkeypatch.setattr(bag_writer, '_free', lambda directory: free)
    bag = BagWriter(tmp_path / 'bag', worth=WORTH.get)
    for topic, kind in TOPICS.items():
        bag.add_topic(topic, kind, QOS)
    some, one = serialize_message(String(data='x' * 1000)), serialize_message(command(0))
    assert bag.write(TEXT, some, 0, 0) and not bag.trouble
    free = 9_000                                # below a quarter of what there was
    assert bag.write(TEXT, some, 0, 0)          # the look comes after it
    assert not bag.write(TEXT, some, 0, 0) and bag.write(COMMAND, one, 0, 0)
    assert bag.trouble.startswith('only 8 KiB left on the disk')
    free = 2_000
    while bag.write(COMMAND, one, 0, 0):
        assert bag.lost[COMMAND] == 0
    assert bag.lost == {TEXT: 1, COMMAND: 1}
    assert bag.write(FRAME, serialize_message(frame(0)), 0, 0)
    bag.close()                                 # without an index: no room for a second file
    assert isinstance(list(mcap_file.records(bag.path))[-1], Footer)
    with Reader(bag.directory) as reader:
        assert sum(1 for _ in reader.messages()) == reader.message_count == len(stored(bag.path))


def test_a_message_takes_31_bytes_on_the_disk_besides_itself(tmp_path):
    bag = write(tmp_path / 'bag', [], close=False)
    data = serialize_message(command(1))
    bag.write(COMMAND, data, 0, 0)              # with the schema of its topic
    before = bag.path.stat().st_size
    for k in range(100):
        bag.write(COMMAND, data, k, k)
    assert bag.path.stat().st_size - before == 100 * (31 + len(data))
