"""
Telemetry comes down once: the window against a plain set of numbers, and the ground's reader.

What a link makes twice on purpose, or lets come late, is taken as before; a frame that is sent once
more is not. Without the window it is.
"""

from hypothesis import given
from hypothesis import strategies as st
import numpy as np
import pytest

from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.ros.frame_codecs import FrameOfLink, Telemetry
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.signal import Part
from rvd_dynamics.link.channel import Channel
from rvd_dynamics.link.frame import pack_downlink, ReplayWindow
from rvd_dynamics.link.models import LinkParams
from rvd_dynamics.link.plan import draw_plan
from rvd_dynamics.link.play_out import Frame
from rvd_dynamics.link.signals import telemetry

RUN = Run(step_s=0.5)
SIGNAL = telemetry(Part('state', (2,), 'm, m/s'))


@given(st.integers(1, 9), st.lists(st.integers(0, 40) | st.integers(0, (1 << 64) - 1), max_size=60))
def test_the_window_is_a_set_of_numbers_that_forgets_what_is_old(size, numbers):
    window, taken = ReplayWindow(size), set()
    for number in numbers:
        newest = max(taken, default=0)
        new = number >= 1 and number not in taken and number > newest - size
        assert window.takes(number) == new
        taken |= {number} if new else set()


def test_the_bound_of_the_window():
    window = ReplayWindow(4)
    assert [window.takes(n) for n in (10, 7, 6, 7, 11, 7, 8)] == [
        True, True, False, False, True, False, True]
    with pytest.raises(ValueError, match='size must be at least 1'):
        ReplayWindow(0)


def frame(k, sent):
    """Return the frame of step `sent` as it comes out of the link in step k."""
    payload = pack_downlink(sequence=sent + 1, generated_ns=sent*RUN.step_ns, state=(-sent, 0.5))
    return FrameOfLink(k, sent + 1, sent*RUN.step_ns, k*RUN.step_ns, k*RUN.step_ns, False, False,
                       payload)


def reader():
    events = []
    codec = Telemetry(SIGNAL, RUN, lambda code, text: events.append((code, text)))

    def heard(k, sent):
        value = codec.decode(k, frame(k, sent))
        return -int(value.state[0]) if value.received else None
    return heard, codec, events


def test_a_frame_that_comes_once_more_is_refused_counted_and_said():
    heard, _, events = reader()
    assert [heard(k, k - 2) for k in range(2, 8)] == [0, 1, 2, 3, 4, 5]
    assert [heard(k, sent) for k, sent in ((8, 5), (9, 0), (10, 8))] == [None, None, 8]
    assert events == [('REFUSED', f'telemetry refused: ORDER, {n} so far') for n in (1, 2)]


def test_frames_that_overtake_each_other_are_taken_once_each():
    heard, _, events = reader()
    order = (0, 3, 1, 2, 2, 6, 4, 3, 5)
    assert [heard(10 + k, sent) for k, sent in enumerate(order)] == [
        0, 3, 1, 2, None, 6, 4, None, 5]
    assert len(events) == 2


def test_a_number_that_no_craft_can_have_given_yet_does_not_shut_the_window():
    heard, codec, events = reader()
    assert heard(3, 1) == 1
    assert heard(4, 5) is None and 'ORDER' in events[-1][1]
    assert heard(5, 2) == 2


def test_a_fast_reader_may_look_at_the_same_frame_again():
    _, codec, events = reader()
    same = frame(4, 2)
    first, again = codec.decode(4, same), codec.decode(4, same)
    assert first.received and again.received and events == []
    np.testing.assert_array_equal(first.state, again.state)


def test_twin_without_the_window_it_is_accepted(monkeypatch):
    monkeypatch.setattr(ReplayWindow, 'takes', lambda self, number: True)
    heard, _, events = reader()
    assert [heard(k, 0) for k in (2, 3, 4)] == [0, 0, 0] and events == []


@pytest.mark.parametrize('fault', [
    {'duplicate_fraction': 1.0}, {'duplicate_fraction': 0.5, 'loss_fraction': 0.3},
    {'duplicate_fraction': 1.0, 'corrupt_fraction': 0.4}])
def test_of_a_link_that_makes_two_of_each_nothing_is_refused_for_its_number(fault):
    steps, hold = 400, 10
    params = LinkParams(model='gamma', **fault)
    plan = draw_plan(params, streams.generator(3, 0, 'link_back'), steps, RUN.step_ns, hold)
    channel, (_, codec, events) = Channel(plan, hold, RUN.step_ns), reader()
    out, bare = [], []
    for k in range(steps):
        sent = frame(k, k)
        due = channel.advance(k, Frame(k + 1, k*RUN.step_ns, payload=sent.payload))
        if due is not None:
            came = FrameOfLink(k, due.sequence, due.sent_ns, due.arrived_ns, due.released_ns, False,
                               False, due.payload)
            out.append(bool(codec.decode(k, came).received))
            bare.append(due.payload == frame(k, due.sequence - 1).payload)
    assert channel.counts.duplicated > 100 and out == bare and any(out)
    assert not any('ORDER' in text for _, text in events)
