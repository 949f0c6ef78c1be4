"""Tapes: what plays when, and that a bad one is refused with its line."""

from io import BytesIO
from pathlib import Path
import sqlite3
import subprocess

from mcap.writer import CompressionType, Writer
from mcap_ros2.writer import Writer as RosWriter
import numpy as np
import pytest
from rosbags.rosbag2 import CompressionFormat, CompressionMode, StoragePlugin, Writer as Bag
from rosbags.typesys import get_typestore, Stores

from rvd_dynamics.commands.levels import stick_levels, StickParams
from rvd_groundstation.operators.tape import read_tape

CSV = """# a recorded stick
t_s,axis_0,axis_1,button_0
10.0,0.0,0.5,1
10.5,-1.0,0.25,1
11.75,0.333333343,0,0
"""
JOY = """std_msgs/Header header
float32[] axes
int32[] buttons
================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id
================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
"""
SAMPLES = [(10_000_000_000, [0.0, 0.5], [1]), (10_500_000_000, [-1.0, 0.25], [1]),
           (11_750_000_000, [0.3333333432674408, 0.0], [0])]


def csv_tape(tmp_path, text):
    path = tmp_path / 'tape.csv'
    path.write_text(text)
    return path


def bag(path, samples, topic='/joy', chunk_bytes=1):
    """Write a bag as rosbag2 would, with another topic beside the stick."""
    with path.open('wb') as file:
        writer = RosWriter(file, chunk_size=chunk_bytes, compression=CompressionType.NONE)
        schema = writer.register_msgdef('sensor_msgs/msg/Joy', JOY)
        for stamp, axes, buttons in samples:
            joy = {'header': {'stamp': {'sec': stamp // 10**9, 'nanosec': stamp % 10**9},
                              'frame_id': 'joy'}, 'axes': axes, 'buttons': buttons}
            writer.write_message('/other', schema, {**joy, 'axes': [9.0]}, log_time=1)
            writer.write_message(topic, schema, joy, log_time=2)
        writer.finish()
    return path


def both(tmp_path):
    yield read_tape(csv_tape(tmp_path, CSV))
    yield read_tape(bag(tmp_path / 'tape.mcap', SAMPLES))
    folder = tmp_path / 'bag'
    folder.mkdir()
    bag(folder / 'bag_2.mcap', SAMPLES[:2])
    bag(folder / 'bag_10.mcap', SAMPLES[2:])
    yield read_tape(folder)


def test_sample_holds_from_its_stamp_until_the_next(tmp_path):
    for tape in both(tmp_path):
        assert tape.at(0) == ((0.0, 0.5), (1,))
        assert tape.at(499_999_999) == ((0.0, 0.5), (1,))
        assert tape.at(500_000_000) == ((-1.0, 0.25), (1,))
        assert tape.at(1_749_999_999) == ((-1.0, 0.25), (1,))
        axes, buttons = tape.at(1_750_000_000)
        assert axes == pytest.approx((1/3, 0.0)) and buttons == (0,)


def test_first_stamp_is_time_zero_and_the_last_is_the_end(tmp_path):
    for tape in both(tmp_path):
        assert (tape.stamps_ns[0], tape.end_ns) == (0, 1_750_000_000)


def test_axes_of_both_kinds_are_what_a_message_would_carry(tmp_path):
    """Otherwise a flight over DDS and one in process could part at a threshold."""
    rows = 't_s,axis_0,axis_1\n0,0.3333333333333333,1.00000000001\n'
    tape = read_tape(csv_tape(tmp_path, rows))
    assert tape.axes == ((0.3333333432674408, 1.0),)
    with pytest.raises(ValueError, match='axis_0 must be finite'):
        read_tape(csv_tape(tmp_path, 't_s,axis_0\n0,1e300\n'))


@pytest.mark.parametrize('button', [4, -1])
def test_ended_tape_is_no_valid_stick_with_any_map(tmp_path, button):
    tape = read_tape(csv_tape(tmp_path, CSV))
    stick = StickParams(axis_x=1, axis_y=0, axis_z=2, deadman_button=button)
    for t_ns in (tape.end_ns + 1, 10**18):
        assert stick_levels(*tape.at(t_ns), stick)[1] is False


def test_stamps_are_exact_on_a_fine_grid(tmp_path):
    rows = ''.join(f'{k * 0.05:.2f},0.1\n' for k in range(4001))
    tape = read_tape(csv_tape(tmp_path, 't_s,axis_0\n' + rows))
    assert tape.stamps_ns == tuple(k * 50_000_000 for k in range(4001))


@pytest.mark.parametrize('text, line, complaint', [
    ('t_s,axis_0\n0,0\n1,0\n1,0\n', 4, 'time must rise, got 1 s after 1 s'),
    ('t_s,axis_0\n0,0\n-1,0\n', 3, 'time must rise, got -1 s after 0 s'),
    ('t_s,axis_0\n0,nan\n', 2, 'axis_0 must be finite, got nan'),
    ('t_s,axis_0\n0,inf\n', 2, 'axis_0 must be finite, got inf'),
    ('t_s,axis_0\nnan,0\n', 2, 't_s must be within 9e+09 s, got nan'),
    ('t_s,axis_0\n1e300,0\n', 2, 't_s must be within 9e+09 s, got 1e300'),
    ('t_s,axis_0,button_0\n0,0\n', 2, '3 columns expected, got 2'),
    ('t_s,axis_0\n0,0,0\n', 2, '2 columns expected, got 3'),
    ('t_s,axis_0\n0,left\n', 2, "axis_0 must be a number, got 'left'"),
    ('t_s,axis_0,button_0\n0,0,0.5\n', 2, 'button_0 must be 0 or 1, got 0.5'),
    ('t_s,axis_0,button_0\n0,0,-1\n', 2, 'button_0 must be 0 or 1, got -1'),
    ('# remark\n0,0.5\n', 2, 'the header must be t_s,axis_0,...,button_0,..., got 0,0.5'),
    ('t_s,axis_1\n0,0\n', 1, 'the header must be'),
    ('t_s,button_0,axis_0\n0,0,0\n', 1, 'the header must be'),
    ('t_s,button_0\n0,0\n', 1, 'the header must be'),
])
def test_bad_csv_is_refused_with_file_and_line(tmp_path, text, line, complaint):
    path = csv_tape(tmp_path, text)
    with pytest.raises(ValueError) as refusal:
        read_tape(path)
    assert str(refusal.value).startswith(f'{path}, line {line}: {complaint}')


@pytest.mark.parametrize('text, complaint', [
    ('', 'no header'), ('# nothing\n', 'no header'), ('t_s,axis_0\n', 'holds no sample')])
def test_empty_csv_is_refused(tmp_path, text, complaint):
    with pytest.raises(ValueError, match=complaint):
        read_tape(csv_tape(tmp_path, text))


def test_missing_or_unreadable_tapes_are_refused_by_name(tmp_path):
    with pytest.raises(ValueError, match='cannot read tape .*none.csv: No such file'):
        read_tape(tmp_path / 'none.csv')
    with pytest.raises(ValueError,
                       match='holds no bag: there is no .mcap or .db3 file in the folder'):
        read_tape(tmp_path)
    for name, content in (('noise.csv', bytes(range(256))), ('noise.mcap', b'no mcap at all')):
        (tmp_path / name).write_bytes(content)
        with pytest.raises(ValueError, match=name):
            read_tape(tmp_path / name)


def test_bad_message_is_refused_with_file_and_number(tmp_path):
    path = bag(tmp_path / 'tape.mcap', [SAMPLES[0], SAMPLES[1], SAMPLES[0]])
    with pytest.raises(ValueError, match='tape.mcap, /joy message 3: time must rise'):
        read_tape(path)
    path = bag(tmp_path / 'nan.mcap', [SAMPLES[0], (11 * 10**9, [float('nan')], [])])
    with pytest.raises(ValueError, match='nan.mcap, /joy message 2: axis_0 must be finite'):
        read_tape(path)


def test_bag_with_the_stick_elsewhere_says_where_and_is_played_when_told(tmp_path):
    path = bag(tmp_path / 'tape.mcap', SAMPLES, topic='/teleop/joy')
    with pytest.raises(ValueError, match=r'no sample on /joy; sensor_msgs/msg/Joy is on /other '
                       r'\(3 messages\), /teleop/joy \(3 messages\): pick one with --tape-topic'):
        read_tape(path)
    assert read_tape(path, '/teleop/joy') == read_tape(bag(tmp_path / 'b.mcap', SAMPLES))


def test_topic_for_a_csv_tape_is_refused(tmp_path):
    with pytest.raises(ValueError, match=r'a topic \(/teleop/joy\) can be picked from a bag only'):
        read_tape(csv_tape(tmp_path, CSV), '/teleop/joy')


def test_joy_of_another_type_is_refused(tmp_path):
    buffer = BytesIO()
    writer = Writer(buffer)
    writer.start('ros2', 'test')
    schema = writer.register_schema('std_msgs/msg/String', 'ros2msg', b'string data')
    writer.register_channel('/joy', 'cdr', schema)
    writer.finish()
    (tmp_path / 'tape.mcap').write_bytes(buffer.getvalue())
    with pytest.raises(ValueError, match='/joy must be sensor_msgs/msg/Joy in cdr, got std_msgs'):
        read_tape(tmp_path / 'tape.mcap')


def test_bag_that_was_cut_off_plays_what_it_holds(tmp_path):
    whole = bag(tmp_path / 'whole.mcap', SAMPLES).read_bytes()
    lengths = set()
    for size in range(len(whole) // 4, len(whole), 7):
        (tmp_path / 'cut.mcap').write_bytes(whole[:size])
        try:
            tape = read_tape(tmp_path / 'cut.mcap')
        except ValueError as refusal:
            assert 'cut.mcap' in str(refusal)           # nothing whole in it
            continue
        lengths.add(len(tape.stamps_ns))
        assert tape.at(0) == ((0.0, 0.5), (1,))
    assert lengths == {1, 2, 3}


def test_bag_that_was_damaged_is_refused_by_name(tmp_path):
    path = bag(tmp_path / 'tape.mcap', SAMPLES)
    whole = path.read_bytes()
    at = whole.rindex(b'joy\0')                     # the name in the header of the last sample
    path.write_bytes(whole[:at - 4] + b'\xff\xff\xff\x7f' + whole[at:])
    with pytest.raises(ValueError, match='tape.mcap, /joy message 3: cannot be decoded'):
        read_tape(path)
    path.write_bytes(b'\0' + whole[1:])
    with pytest.raises(ValueError, match='tape.mcap: not a readable MCAP file'):
        read_tape(path)


# -- what other programs write -----------------------------------------------------------------

SECOND = 10**9


def ros_bag(path, samples, storage='mcap', mode=None, topic='/joy'):
    """Write a bag (header stamp, log time, axes) as `ros2 bag record` does, all kinds of it."""
    types = get_typestore(Stores.ROS2_JAZZY)
    joy, header, time = (types.types[name] for name in (
        'sensor_msgs/msg/Joy', 'std_msgs/msg/Header', 'builtin_interfaces/msg/Time'))
    writer = Bag(path, version=9, storage_plugin=StoragePlugin[storage.upper()])
    if mode:
        writer.set_compression(CompressionMode[mode.upper()], CompressionFormat.ZSTD)
    with writer:
        connection = writer.add_connection(topic, joy.__msgtype__, typestore=types)
        for stamp, log, axes in samples:
            message = joy(header(time(stamp // SECOND, stamp % SECOND), 'joy'),
                          np.array(axes, np.float32), np.array([1], np.int32))
            writer.write(connection, log, types.serialize_cdr(message, joy.__msgtype__))
    return path


STAMPED = [(5 * SECOND, 7, [0.0, 0.5]), (6 * SECOND, 8, [-1.0, 0.25]), (8 * SECOND, 9, [0.5, 0.0])]


@pytest.mark.parametrize('storage', ['mcap', 'sqlite3'])
@pytest.mark.parametrize('mode', [None, 'message', 'file'])
def test_storages_and_compressions_give_the_same_tape(tmp_path, storage, mode):
    folder = ros_bag(tmp_path / 'bag', STAMPED, storage, mode)
    folder = folder.rename(tmp_path / "a #b? it's 100 %")
    tape = read_tape(folder)
    assert tape.stamps_ns == (0, SECOND, 3 * SECOND)
    assert tape.axes == ((0.0, 0.5), (-1.0, 0.25), (0.5, 0.0)) and set(tape.buttons) == {(1,)}
    file, = (f for f in folder.iterdir() if f.name != 'metadata.yaml')
    assert file.name.endswith('.zstd') == (mode == 'file')
    assert read_tape(file) == tape
    if mode == 'file':                          # the unpacked file beside it is not read twice
        file.with_suffix('').write_bytes(subprocess.run(
            ['python3', '-c', 'import sys, zstandard; zstandard.ZstdDecompressor().copy_stream('
             'sys.stdin.buffer, sys.stdout.buffer)'],
            input=file.read_bytes(), capture_output=True, check=True).stdout)
        assert read_tape(folder) == tape


def test_sqlite_bag_without_definitions_is_read_by_those_of_ros(tmp_path):
    """As rosbag2 wrote them until Humble."""
    folder = ros_bag(tmp_path / 'old', STAMPED, 'sqlite3')
    with sqlite3.connect(folder / 'old.db3') as base:
        base.executescript('DROP TABLE message_definitions; DROP TABLE schema;')
    assert read_tape(folder).stamps_ns == (0, SECOND, 3 * SECOND)


@pytest.mark.parametrize('spoil', [lambda data: b'SQLite nonsense', lambda data: data[:5000],
                                   lambda data: b''])
def test_spoilt_sqlite_bag_is_refused_by_name(tmp_path, spoil):
    path = ros_bag(tmp_path / 'bag', STAMPED, 'sqlite3') / 'bag.db3'
    path.write_bytes(spoil(path.read_bytes()))
    with pytest.raises(ValueError, match='bag.db3: not a readable SQLite file of rosbag2: '):
        read_tape(path)


@pytest.mark.parametrize('stamps', [(0, 0, 0), (5 * SECOND, 5 * SECOND, 6 * SECOND),
                                    (0, 1_700_000_000 * SECOND, 1_700_000_001 * SECOND),
                                    (3 * SECOND, 2 * SECOND, 4 * SECOND)])
def test_header_stamps_that_tell_no_time_give_way_to_log_times(tmp_path, stamps):
    logs = [10**18, 10**18 + SECOND, 10**18 + 5 * SECOND // 2]
    tape = read_tape(ros_bag(tmp_path / 'bag', [(s, t, [0.0]) for s, t in zip(stamps, logs)]))
    assert tape.stamps_ns == (0, SECOND, 5 * SECOND // 2)
    assert tape.note == (f'{tmp_path}/bag: header stamps of /joy are zero or repeated: the log '
                         'times of the bag are used')


def test_good_header_stamps_are_used_without_a_word(tmp_path):
    assert read_tape(ros_bag(tmp_path / 'bag', STAMPED)).note == ''


def test_bag_of_ros_1_is_refused_with_the_command_that_converts_it(tmp_path):
    path = tmp_path / 'old stick.bag'
    path.write_bytes(b'#ROSBAG V2.0\n')
    with pytest.raises(ValueError, match="rosbags-convert --src '.*/old stick.bag' --dst"):
        read_tape(path)


DATA = Path(__file__).parent / 'tapes'          # one stick, as different programs save it
SHIPPED = Path(__file__).resolve().parents[4] / 'tapes'
PLAIN = 't_s,axis_0,axis_1,button_0\n0,0,0.5,1\n0.05,-1,0.25,1\n1.75,0.25,0,0\n'


@pytest.mark.parametrize('content', [
    b'\xef\xbb\xbf' + PLAIN.encode(),
    b'\xef\xbb\xbf# with a remark\r\n' + PLAIN.replace('\n', '\r\n').encode(),
    PLAIN.replace('\n', '\r').encode(),
    PLAIN.replace('\n0,', '\n1700000000.25,').replace('\n0.05', '\n1700000000.30').replace(
        '\n1.75', '\n1700000002.00').encode()])
def test_marks_line_ends_and_epoch_times_do_not_change_a_tape(tmp_path, content):
    (tmp_path / 'tape.csv').write_bytes(content)
    assert read_tape(tmp_path / 'tape.csv') == read_tape(csv_tape(tmp_path, PLAIN))


@pytest.mark.parametrize('content, why', [
    (PLAIN.encode('utf-16'), 'the tape is UTF-16 or binary, .* iconv -f UTF-16 -t UTF-8'),
    (PLAIN.encode('utf-16-be'), 'the tape is UTF-16 or binary'),
    (PLAIN.replace(',', ';').encode(), 'line 1: the columns are separated by semicolons.*sed'),
    (PLAIN.replace(',', '\t').encode(), 'line 1: the columns are separated by tabs.*sed'),
    ('# für\n'.encode('latin-1') + PLAIN.encode(), 'line 1: the byte 0xfc is not UTF-8'),
    (b't_s,axis_0\n0,0\n1700000000,0\n', r'line 3: time must rise by at most 1e\+06 s')])
def test_other_tables_are_refused_in_one_line_with_the_cure(tmp_path, content, why):
    (tmp_path / 'tape.csv').write_bytes(content)
    with pytest.raises(ValueError, match=why) as refusal:
        read_tape(tmp_path / 'tape.csv')
    assert '\n' not in str(refusal.value)


@pytest.mark.parametrize('name', ['tape_bom', 'tape_epoch'])
def test_shipped_stick_as_other_programs_save_it(name):
    saved, shipped = read_tape(DATA / f'{name}.csv'), read_tape(SHIPPED / 'docking.csv')
    assert saved == shipped


@pytest.mark.parametrize('name, why', [('tape_semicolon', 'semicolons'), ('tape_utf16', 'UTF-16')])
def test_stick_in_a_format_that_is_not_ours_is_refused(name, why):
    with pytest.raises(ValueError, match=why):
        read_tape(DATA / f'{name}.csv')
