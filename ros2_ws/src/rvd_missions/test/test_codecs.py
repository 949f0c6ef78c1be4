"""
Every signal of the approach through its message and back, and what passes by hand instead.

Values are drawn at random. What another process decodes from the serialised message must be equal
to the bit, and of the same types, as what a reader in the same process is handed.
"""

from functools import lru_cache

from hypothesis import assume, given
from hypothesis import strategies as st
from hypothesis.extra import numpy as hnp
import numpy as np
import pytest
from rclpy.serialization import deserialize_message, serialize_message

from rvd_campaign.catalogue import root
from rvd_dynamics.commands.codes import KIND_ABORT, KIND_THRUST
from rvd_dynamics.commands.levels import StickParams
from rvd_dynamics.diagram.block import Leg
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.ros.codecs import Parts
from rvd_dynamics.diagram.ros.conversions import ns_of
from rvd_dynamics.diagram.ros.frame_codecs import FrameOfLink, Telemetry
from rvd_dynamics.diagram.ros.host import message_type
from rvd_dynamics.diagram.scenario import load, parse
from rvd_dynamics.diagram.signal import Part, Signal
from rvd_dynamics.link.frame import pack_downlink
from rvd_dynamics.link.signals import FRAME_CODECS
from rvd_missions.lunar_approach.signals import DOWNLINK, FAR, STICK, UPLINK

STEPS = st.integers(0, 86_400_000)              # a day of milliseconds
STATES = hnp.arrays('f8', (6,), elements=st.floats(width=64))
LEVELS = hnp.arrays('i1', (3,), elements=st.integers(-3, 3))
SCENARIOS = sorted(file.stem for file in (root() / 'scenarios').glob('*.yaml'))
ONE_LEG = ('/ground/telemetry', '/onboard/command')     # their readers see a frame


@lru_cache(maxsize=1)
def scenario():
    return parse('/**: {ros__parameters: {step_s: 0.1}}', 'coded')


SIGNALS = {name: signal for name, signal in scenario().diagram.signals.items()}
VALUES = {name: s for name, s in SIGNALS.items()
          if name not in (DOWNLINK.name, UPLINK.name, *ONE_LEG)}
READ = {read.signal.name for block in scenario().diagram.blocks for read in block.reads.values()}
READ_PARTS = {read.signal.name: set(read.optional) for block in scenario().diagram.blocks
              for read in block.reads.values()}


def codec(signal, events=None):
    """Make the codec of a signal as a node does."""
    own = {'signal': signal, 'run': scenario().run,
           'event': lambda code, text: events.append((code, text))}
    return made(signal.codec, lambda name: own[name] if name in own else scenario().part(name),
                f'signal {signal.name}')


def values_of(signal):
    """Return the values of a signal that a block may write."""
    def part(p):
        if p.name == 'raw':
            return st.none()
        if p.name == 'command':
            return LEVELS
        elements = {'f': st.floats(width=64), 'b': st.booleans(),
                    'u': st.integers(0, 255),
                    'i': st.integers(0, 2**63 - 1)}[np.dtype(p.dtype).kind]
        return hnp.arrays(p.dtype, p.shape, elements=elements)
    return st.builds(signal.type, *(part(p) for p in signal.parts))


def over_the_wire(encoded, kind):
    """Return what a reader in another process gets."""
    if hasattr(encoded, 'serialised'):
        encoded = encoded.serialised()
    elif not isinstance(encoded, bytes):
        encoded = serialize_message(encoded)
    return deserialize_message(encoded, kind)


def assert_same(a, b, parts):
    """Equal to the bit, NaN for NaN, in the parts named."""
    assert type(a) is type(b)
    for name in parts:
        x, y = np.asarray(getattr(a, name)), np.asarray(getattr(b, name))
        assert x.shape == y.shape and x.dtype == y.dtype, name
        np.testing.assert_array_equal(x, y, err_msg=name)
        if x.dtype.kind == 'f':                 # 0.0 and -0.0
            known = ~np.isnan(x)
            np.testing.assert_array_equal(np.signbit(x)[known], np.signbit(y)[known])


@pytest.mark.parametrize('name', sorted(set(VALUES) & READ))
@given(data=st.data())
def test_what_is_decoded_is_what_was_written_and_what_passes_by_hand(name, data):
    signal = SIGNALS[name]
    coder, k, value = codec(signal), data.draw(STEPS), data.draw(values_of(signal))
    if name == STICK.name and not value.valid:
        value = value._replace(command=np.zeros(3, 'i1'))       # nobody's stick is at level 0
    message = over_the_wire(coder.encode(k, value), message_type(signal.message))
    decoded, by_hand = coder.decode(k, message), coder.wired(value)
    parts = [p.name for p in signal.parts if not p.optional or p.name in READ_PARTS[name]
             or name == '/onboard/thruster_command']
    assert_same(decoded, value, parts)
    assert_same(decoded, by_hand, parts)
    assert signal.complaint(decoded, ()) == ''


@pytest.mark.parametrize('name', sorted(set(VALUES)))
@given(data=st.data())
def test_a_message_says_its_step_and_the_instant_that_it_is_valid_for(name, data):
    signal, k = SIGNALS[name], data.draw(STEPS)
    message = over_the_wire(codec(signal).encode(k, data.draw(values_of(signal))),
                            message_type(signal.message))
    step_ns = scenario().run.step_ns
    if name == STICK.name:                      # a Joy has no step
        assert ns_of(message.header.stamp) == k * step_ns
        return
    assert message.step == k
    assert ns_of(message.header.stamp) == max(0, k + signal.ahead) * step_ns
    assert message.header.frame_id == scenario().run.frame_id


def test_content_of_the_loop_lies_one_delay_ahead_or_behind():
    assert SIGNALS['/ground/estimate'].ahead == -50
    assert {SIGNALS[name].ahead for name in ('/ground/prediction', '/ground/command',
                                             '/ground/auto_command')} == {50}


@given(st.data())
def test_covariances_and_scores_reach_their_messages(data):
    """Nobody in the ring reads them; a person and the reports do."""
    estimate, score = SIGNALS['/ground/estimate'], SIGNALS['/ground/prediction_score']
    value = data.draw(values_of(estimate))
    message = over_the_wire(codec(estimate).encode(3, value), message_type(estimate.message))
    np.testing.assert_array_equal(np.asarray(message.covariance), value.covariance.ravel())
    value = data.draw(values_of(score))
    message = over_the_wire(codec(score).encode(3, value), message_type(score.message))
    np.testing.assert_array_equal(message.sigma, value.sigma)
    np.testing.assert_array_equal(message.rms, value.rms)
    error = [getattr(v, axis) for v in (message.position_error, message.velocity_error)
             for axis in 'xyz']
    np.testing.assert_array_equal(error, value.error)
    assert (message.valid, message.scored) == (value.valid, value.scored)


@pytest.mark.parametrize('deadman', [-1, 4])
@pytest.mark.parametrize('valid', [True, False])
def test_a_stick_that_nobody_holds_can_be_said_with_and_without_a_button(deadman, valid):
    own = {'signal': STICK, 'run': scenario().run, 'stick': StickParams(deadman_button=deadman)}
    coder = made(STICK.codec, own.__getitem__, 'stick')
    value = STICK(command=np.array((0, 3, -1), 'i1') * valid, valid=np.bool_(valid))
    message = over_the_wire(coder.encode(0, value), message_type(STICK.message))
    assert_same(coder.decode(0, message), value, ('command', 'valid'))


@given(st.lists(st.floats(-1.0, 1.0, width=32), min_size=5, max_size=8),
       st.lists(st.integers(0, 1), min_size=5, max_size=8))
def test_what_a_tape_holds_goes_out_as_it_is(axes, buttons):
    """A tape is kept as a Joy carries it, so its levels are the same on both sides."""
    coder = codec(STICK)
    message = over_the_wire(coder.encode(7, STICK(
        command=np.zeros(3, 'i1'), valid=np.True_, raw=(tuple(axes), tuple(buttons)))),
        message_type(STICK.message))
    assert (list(message.axes), list(message.buttons)) == (axes, buttons)


# -- the link ----------------------------------------------------------------------------------

@given(STEPS, STATES, st.one_of(st.integers(0, 3), st.integers(0, 2**63 - 1)),
       st.integers(0, 255))
def test_a_downlink_arrives_as_it_was_sent_by_hand_or_not(k, state, accepted, refusal):
    sent = DOWNLINK(state=state, accepted=accepted, refusal=refusal)
    frame, events = codec(DOWNLINK).encode(k, sent), []
    telemetry = SIGNALS['/ground/telemetry']
    got = [codec(telemetry, events).decode(k, f)
           for f in (frame, over_the_wire(frame, message_type(DOWNLINK.message)))]
    assert_same(*got, ('state', 'received'))
    sent_by_now = k + 1                         # commands: one a step
    if ((np.abs(state) <= FAR) | np.isnan(state)).all() and accepted <= sent_by_now:
        np.testing.assert_array_equal(got[0].state, state)
        assert got[0].accepted == accepted
        assert got[0].received == np.isfinite(state).all() and events == []
    else:                                       # intact, and none that the signal can have
        assert np.isnan(got[0].state).all() and not got[0].received
        assert [code for code, _ in events] == ['REFUSED']*2
        assert 'RANGE' in events[0][1]


@pytest.mark.parametrize('name', SCENARIOS)
def test_frames_of_numbers_come_through_in_every_scenario(name):
    flown = load(root() / 'scenarios' / f'{name}.yaml')
    for signal in flown.diagram.signals.values():
        if signal.codec != f'{FRAME_CODECS}:Telemetry':
            continue
        values, events = np.linspace(0.1, 0.2, signal.parts[0].shape[0]), []
        frame = FrameOfLink(8, 8, payload=pack_downlink(8, 0, values, 3, 0))
        got = Telemetry(signal, flown.run, lambda *event: events.append(event)).decode(8, frame)
        assert events == [] and got.received
        np.testing.assert_array_equal(getattr(got, signal.parts[0].name), values)


@given(STEPS, LEVELS, st.sampled_from([KIND_THRUST, KIND_ABORT]))
def test_an_uplink_passes_the_gate_as_it_was_sent_by_hand_or_not(k, levels, kind):
    sent = UPLINK(command=levels, kind=np.uint8(kind), expedited=np.bool_(kind == KIND_ABORT))
    frame, events = codec(UPLINK).encode(k, sent), []
    arrival = SIGNALS['/onboard/command']
    got = [codec(arrival, events).decode(k, f)
           for f in (frame, over_the_wire(frame, message_type(UPLINK.message)))]
    assert_same(*got, [p.name for p in arrival.parts])
    assert_same(got[0], arrival.type(levels, np.uint8(kind), np.True_, np.uint8(0), k + 1),
                ('command', 'kind', 'received', 'reason'))
    assert got[0].sequence == k + 1 and events == []
    assert frame.expedited == (kind == KIND_ABORT)


@given(STEPS, LEVELS, st.data())
def test_a_damaged_frame_is_refused_and_said(k, levels, data):
    frame, events = codec(UPLINK).encode(k, UPLINK(
        command=levels, kind=np.uint8(KIND_THRUST), expedited=np.False_)), []
    at = data.draw(st.integers(0, len(frame.payload) - 1))
    flip = data.draw(st.integers(1, 255))
    damaged = bytearray(frame.payload)
    damaged[at] ^= flip
    assume(bytes(damaged) != frame.payload)
    got = codec(SIGNALS['/onboard/command'], events).decode(
        k, frame._replace(payload=bytes(damaged)))
    assert not got.received and not got.command.any() and got.reason
    assert [code for code, _ in events] == ['REFUSED']


def test_an_abort_that_a_later_one_has_overtaken_is_not_said():
    events = []
    frame, gate = codec(UPLINK).encode, codec(SIGNALS['/onboard/command'], events)
    sent = [frame(k, UPLINK(command=np.zeros(3, np.int8), kind=np.uint8(kind),
                            expedited=np.bool_(kind == KIND_ABORT)))
            for k, kind in enumerate([KIND_THRUST, KIND_THRUST, KIND_ABORT, KIND_ABORT])]
    took = [gate.decode(4 + i, sent[k]).received for i, k in enumerate([1, 0, 3, 2])]
    assert took == [True, False, True, False]
    assert events == [('REFUSED', 'command refused: ORDER, 1 so far')]      # before the ABORT


@pytest.mark.parametrize('name', ONE_LEG)
def test_a_frame_that_holds_nothing_is_nothing_received(name):
    coder, events = codec(SIGNALS[name], []), []
    writer = scenario().diagram.writer_of[name]
    assert isinstance(writer, Leg)
    empty = message_type(SIGNALS[name].message)(step=4, sent=-1, arrived=-1, released=-1,
                                                empty=True)
    for got in (coder.decode(4, empty), coder.missing(5)):
        assert not got.received
        assert SIGNALS[name].complaint(got, ()) == ''
    assert events == []


# -- any other signal --------------------------------------------------------------------------

ANY = Signal('/any',
             (Part('state', (2,), 'm, m/s'), Part('turn', (3, 3)), Part('flag', (), '', '?'),
                      Part('count', (), '', 'i8'), Part('kind', (), '', 'u1'),
                      Part('command', (1,), 'm/s^2')))


@given(STEPS, st.builds(
    ANY.type, hnp.arrays('f8', (2,)), hnp.arrays('f8', (3, 3)), hnp.arrays('?', ()),
    hnp.arrays('i8', (), elements=st.integers(-2**53, 2**53)), hnp.arrays('u1', ()),
    hnp.arrays('f8', (1,))))
def test_a_signal_without_a_message_of_its_own_goes_as_values(k, value):
    coder = Parts(ANY, scenario().run)
    message = over_the_wire(coder.encode(k, value), message_type(ANY.message))
    assert message.step == k
    assert message.layout == 'state[2], turn[3,3], flag, count, kind, command[1]'
    assert_same(coder.decode(k, message), value, ANY.type._fields)
    assert_same(coder.wired(value), value, ANY.type._fields)


def test_values_of_another_layout_are_refused():
    other = Parts(Signal('/any', (Part('state', (3,)),)), scenario().run)
    message = other.encode(0, other.signal(state=np.zeros(3)))
    with pytest.raises(ValueError, match=r'/any must hold state\[2\], turn.*, got state\[3\]'):
        Parts(ANY, scenario().run).decode(0, message)
