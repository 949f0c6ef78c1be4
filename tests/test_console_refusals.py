"""What the console refused is told by `fly` at its end, and nothing else of it."""

import io
import queue
from types import SimpleNamespace
import threading

from rvd_campaign.flight.console import ConsoleProcess


def page(said):
    """Return a console process that has said this and ended."""
    made = object.__new__(ConsoleProcess)
    made._process = SimpleNamespace(stdout=io.StringIO(said), stdin=io.StringIO(),
                                    wait=lambda seconds: 0)
    made._wishes, made._held, made._refused = queue.Queue(), None, ''
    made._reader = threading.Thread(target=made._read)
    made._reader.start()
    return made


def test_fly_hears_what_was_refused_beside_the_wishes(capsys):
    one = page('{"do": "quit"}\nnot for us\n[1]\n'
               '{"refused": "console refused 2 requests: 2 other"}\n')
    assert one.stop() == 'console refused 2 requests: 2 other'
    assert one.wish() == {'do': 'quit'} and one._wishes.empty()
    assert capsys.readouterr().out == 'not for us\n[1]\n'


def test_nothing_is_told_where_nothing_was_refused():
    assert page('{"refused": ""}\n').stop() == '' == page('').stop()
