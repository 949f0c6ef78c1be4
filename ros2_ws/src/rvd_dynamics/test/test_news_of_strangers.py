"""What the recorder makes of the page of a run: each second writer once, in whoever's words."""

from types import SimpleNamespace

import pytest
from rclpy.serialization import serialize_message

from rvd_dynamics.diagram.ros.news import FLY, LONGEST, News
from rvd_dynamics.diagram.ros.writers import MANY
from rvd_dynamics.diagram.roster import RECORDER, SECOND_WRITER
from rvd_interfaces.msg import RunEvent

NAMED = 'a second writer on /run/end: node x'
NAMELESS = 'a second writer on /run/end: a node without a name'


def stored(said, marked, *read):
    """Return who says what in the end, of what `fly` said, what is marked and what was read."""
    said = [(SECOND_WRITER, 3, words) for words in said]
    news = News(SimpleNamespace(news=lambda: [said.pop() for _ in said[:]], traced=marked))
    for words in read:
        news.read(serialize_message(RunEvent(code=SECOND_WRITER, text=words)))
    assert news.take(5) == []                   # the monitor's word may yet come
    return [(s.node, s.step, s.text) for s in news.take(9, last=True)]


@pytest.mark.parametrize('said, marked, read, expected', [
    ([], [], [], []),
    ([NAMED], ['/run/end'], [], [(FLY, 3, NAMED)]),
    ([NAMED], ['/run/end'], [NAMED], []),
    ([], ['/run/end'], [], [(RECORDER, 9, NAMELESS)]),
    ([], ['/run/end'], [NAMED], []),
    ([NAMED], [], [NAMED.replace('end', 'pause')], [(FLY, 3, NAMED)])])
def test_a_second_writer_is_stored_once(said, marked, read, expected):
    assert stored(said, marked, *read) == expected


def test_what_else_was_said_is_stored_at_once():
    news = News(SimpleNamespace(news=lambda: [('SILENT', 2, 'law')], traced=[]))
    assert news.take(9) == [(FLY, 'SILENT', 2, 'law')]


def test_a_flood_of_such_events_fills_no_memory():
    news = News(SimpleNamespace(news=list, traced=[]))
    for size in [LONGEST]*3 + [9]*3*MANY:
        news.read(serialize_message(RunEvent(code=SECOND_WRITER, text='x'*size)))
    assert len(news._read) == 2*MANY and max(map(len, news._read)) < LONGEST
