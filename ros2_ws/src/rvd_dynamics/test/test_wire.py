"""Messages packed in one go are those that ROS makes, for every type that is packed so."""

from functools import reduce
import re
import struct

from geometry_msgs.msg import PoseStamped
from hypothesis import given
from hypothesis import strategies as st
import numpy as np
import pytest
from rclpy.serialization import deserialize_message, serialize_message
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import Joy
from std_msgs.msg import String

from rvd_dynamics.diagram.ros.wire import Layout
from rvd_interfaces.msg import (
    LinkFrame, LinkStatus, PredictionScore, RelativeState, ThrustCommand, Verdict)

WHOLE = {'B': (0, 255), 'b': (-128, 127), 'H': (0, 2**16 - 1), 'h': (-2**15, 2**15 - 1),
         'I': (0, 2**32 - 1), 'i': (-2**31, 2**31 - 1), 'Q': (0, 2**64 - 1),
         'q': (-2**63, 2**63 - 1)}
PACKED = {      # message class: its strings, its lists of varying length
    RelativeState: ('header.frame_id',), ThrustCommand: ('header.frame_id',),
    PredictionScore: ('header.frame_id',), LinkStatus: ('header.frame_id',),
    LinkFrame: (), Clock: (), Joy: ('header.frame_id',)}
LISTS = {LinkFrame: ('payload',), Joy: ('axes', 'buttons')}
FRAMES = st.text(st.characters(exclude_characters='\0', exclude_categories=('Cs',)), max_size=20)


def numbers(code):
    """Return what a field of this code may hold."""
    if code.endswith('s'):
        return st.binary(min_size=int(code[:-1]), max_size=int(code[:-1]))
    if code in 'fd':
        return st.floats(width=32 if code == 'f' else 64)
    return st.booleans() if code == '?' else st.integers(*WHOLE[code])


def parts(path):
    """Split 'a.b[3].c' into attribute names and indices."""
    return [int(word) if word.isdigit() else word for word in re.findall(r'\w+', path)]


def value(message, path):
    return reduce(lambda at, part: at[part] if isinstance(part, int) else getattr(at, part),
                  parts(path), message)


def put(message, path, what):
    """Set a field of a message; lists must have their length already."""
    *way, last = parts(path)
    at = reduce(lambda at, part: at[part] if isinstance(part, int) else getattr(at, part),
                way, message)
    if isinstance(last, int):
        at[last] = what
    else:
        setattr(at, last, what)


def as_bits(number):
    """Return a number so that equal means the same bits, NaN too."""
    if isinstance(number, (float, np.floating)):
        return np.float64(number).tobytes() if number == number else 'nan'
    return bytes(number) if not isinstance(number, (int, bool, np.integer, np.bool_)) \
        else int(number)


@given(st.sampled_from(list(PACKED)), st.data())
def test_a_packed_message_is_the_one_that_ros_serialises(kind, data):
    strings = {path: data.draw(FRAMES) for path in PACKED[kind]}
    sizes = {path: data.draw(st.integers(0, 40)) for path in LISTS.get(kind, ())}
    layout = Layout(kind, strings, sizes)
    given_numbers = [data.draw(numbers(code)) for code in layout.fields.values()]
    packed = layout.pack(*given_numbers)

    by_ros = kind()
    for path, text in strings.items():
        put(by_ros, path, text)
    for path, size in sizes.items():
        setattr(by_ros, path, bytes(size) if path == 'payload' else [0] * size)
    for path, number in zip(layout.fields, given_numbers):
        put(by_ros, path, number)
    serialised = serialize_message(by_ros)
    ours, theirs = (deserialize_message(m, kind) for m in (packed, serialised))

    assert len(packed) == len(serialised) and packed[:4] == serialised[:4]
    for path, number in zip(layout.fields, given_numbers, strict=True):
        assert as_bits(value(ours, path)) == as_bits(value(theirs, path)) == as_bits(number), path
    for path, text in strings.items():
        assert value(ours, path) == value(theirs, path) == text
    for path, size in sizes.items():
        assert len(value(ours, path)) == len(value(theirs, path)) == size


@pytest.mark.parametrize('kind', PACKED)
def test_every_field_of_a_message_is_packed(kind):
    """By another road: the numbers that a message object holds, counted by walking it."""
    def count(message):
        if not hasattr(message, 'get_fields_and_field_types'):
            return 1
        total = 0
        for name, text in message.get_fields_and_field_types().items():
            inner = getattr(message, name)
            if text == 'string':
                continue
            total += len(inner) if '[' in text else 1 if 'sequence' in text else count(inner)
        return total

    sizes = {path: 1 for path in LISTS.get(kind, ())}
    assert len(Layout(kind, dict.fromkeys(PACKED[kind], 'f'), sizes).fields) == count(kind())


@pytest.mark.parametrize('wrong, words', [
    ((1,), 'Clock takes 2 numbers, got 1'), ((1, 2, 3), 'Clock takes 2 numbers, got 3'),
    ((1, -1), 'format|range'), ((2**31, 0), 'format|range'), ((0.5, 0), 'integer')])
def test_numbers_that_do_not_fit_are_refused(wrong, words):
    with pytest.raises((ValueError, struct.error), match=words):
        Layout(Clock).pack(*wrong)


@pytest.mark.parametrize('kind, strings, words', [
    (Joy, {'header.frame_id': 'x'}, 'axes: a list of varying length needs a size'),
    (String, {}, 'data: a string needs a value'),
    (PoseStamped, {}, 'header.frame_id: a string needs a value'),
    (Verdict, {'header.frame_id': '', 'reason': '', 'words': ''}, 'measures: a list')])
def test_what_has_no_fixed_size_is_refused_by_its_path(kind, strings, words):
    with pytest.raises(ValueError, match=words):
        Layout(kind, strings)
