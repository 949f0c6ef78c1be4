"""Tapes: what plays when, and that a bad one is refused with its line."""

from io import BytesIO

from mcap.writer import CompressionType, Writer
from mcap_ros2.writer import Writer as RosWriter
import pytest

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
    ('t_s,axis_0\nnan,0\n', 2, 't_s must be within 1e+06, got nan'),
    ('t_s,axis_0\n1e300,0\n', 2, 't_s must be within 1e+06, got 1e300'),
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
    with pytest.raises(ValueError, match='none.csv: cannot read the tape: No such file'):
        read_tape(tmp_path / 'none.csv')
    with pytest.raises(ValueError, match='holds no bag: there is no .mcap file in the folder'):
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


def test_bag_without_a_stick_is_refused(tmp_path):
    with pytest.raises(ValueError, match='holds no sample'):
        read_tape(bag(tmp_path / 'tape.mcap', SAMPLES, topic='/stick'))


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
