"""
Messages out of MCAP files: which, in which order, and what a bad file is.
"""

from io import BytesIO

from mcap.records import Chunk
from mcap.stream_reader import StreamReader
from mcap.writer import CompressionType, Writer
import pytest

from rvd_dynamics.recording.messages import files_of, MessageFile


def cdr(text):
    """Serialise a std_msgs/String."""
    data = text.encode() + b'\0'
    return b'\0\1\0\0' + len(data).to_bytes(4, 'little') + data


def content(messages, compression=CompressionType.NONE, encoding='ros2msg', finish=True):
    """Return the bytes of a file with (topic, data) messages and one topic without any."""
    stream = BytesIO()
    writer = Writer(stream, chunk_size=200, compression=compression)
    writer.start('ros2', 'test')
    schema = writer.register_schema('std_msgs/msg/String', encoding, b'string data')
    channels = {topic: writer.register_channel(topic, 'cdr', schema)
                for topic in ('/silent', *dict(messages))}
    for i, (topic, data) in enumerate(messages):
        writer.add_message(channels[topic], i, data, 1000 + i)
    if finish:
        writer.add_metadata('note', {'key': 'value'})
        writer.finish()
    return stream.getvalue()


@pytest.fixture
def path(tmp_path):
    return tmp_path / 'a.mcap'


MESSAGES = [('/a', cdr('0')), ('/b', cdr('1')), ('/a', cdr('2')), ('/b', cdr('3'))] * 5


@pytest.mark.parametrize('compression', CompressionType)
def test_messages_come_in_the_order_of_the_file(path, compression):
    path.write_bytes(content(MESSAGES, compression))
    found = list(MessageFile(path))
    assert [(s.topic, s.data) for s in found] == MESSAGES
    assert [s.message.data for s in found[:4]] == ['0', '1', '2', '3']
    assert [s.log_ns for s in found] == list(range(20))
    assert [s.publish_ns for s in found] == list(range(1000, 1020))


def test_unwanted_topics_are_counted_and_not_given(path):
    path.write_bytes(content(MESSAGES))
    file = MessageFile(path, {'/b', '/silent'})
    assert [(s.topic, s.number, s.message.data) for s in file][:2] == [
        ('/b', 1, '1'), ('/b', 2, '3')]
    assert {s.topic: (s.kind, s.count) for s in file.sources} == {
        '/silent': ('std_msgs/msg/String', 0), '/a': ('std_msgs/msg/String', 10),
        '/b': ('std_msgs/msg/String', 10)}
    assert file.notes['note'] == {'key': 'value'} and file.complete


def test_a_file_that_was_cut_off_is_not_complete(path):
    path.write_bytes(content(MESSAGES)[:-40])
    file = MessageFile(path, refuse_damage=True)
    assert len(list(file)) == 20 and not file.complete


@pytest.mark.parametrize('compression, magic', [
    (CompressionType.ZSTD, b'\x28\xb5\x2f\xfd'), (CompressionType.LZ4, b'\x04\x22\x4d\x18')])
def test_a_damaged_chunk_is_left_out_and_said_or_refused_by_name(path, compression, magic):
    whole = content(MESSAGES, compression)
    chunks = [record for record in StreamReader(BytesIO(whole), emit_chunks=True).records
              if isinstance(record, Chunk)]
    lost = range(chunks[1].message_start_time, chunks[1].message_end_time + 1)
    second = whole.index(magic, whole.index(magic) + 1)
    path.write_bytes(whole[:second] + bytes(4) + whole[second + 4:])
    file = MessageFile(path)
    found = list(file)
    assert 0 < lost.start < lost.stop < 20 and file.complete
    assert [(s.log_ns, s.topic, s.data) for s in found] == [
        (i, *message) for i, message in enumerate(MESSAGES) if i not in lost]
    assert len(file.damage) == 1 and 'a chunk of messages: cannot be unpacked' in file.damage[0]
    with pytest.raises(ValueError, match='a.mcap: not a readable MCAP file'):
        list(MessageFile(path, refuse_damage=True))


@pytest.mark.parametrize('data, encoding', [
    (b'', 'ros2msg'), (b'\xff' * 7, 'ros2msg'), (b'\xff' * 7, 'ros2idl')])
def test_bytes_that_are_none_of_their_type_are_refused_by_topic_and_number(path, data, encoding):
    path.write_bytes(content([('/a', cdr('x')), ('/a', data)], encoding=encoding))
    last = list(MessageFile(path))[-1]
    with pytest.raises(ValueError, match='a.mcap, /a message 2: cannot be decoded: .'):
        last.message


def test_a_type_of_ros_itself_needs_no_definition_that_can_be_read(path):
    path.write_bytes(content([('/a', cdr('x'))], encoding='ros2idl'))
    assert [m.message.data for m in MessageFile(path)] == ['x']


def test_the_parts_of_a_long_bag_come_as_they_were_recorded(tmp_path):
    for number in (0, 1, 2, 10, 11):
        (tmp_path / f'bag_{number}.mcap').touch()
    assert [file.stem for file in files_of(tmp_path)] == ['bag_0', 'bag_1', 'bag_2', 'bag_10',
                                                          'bag_11']
