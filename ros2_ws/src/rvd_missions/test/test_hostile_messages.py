"""
No message takes a node down: each field of each topic that is read, with values it should not have.

First every signal of every mission through its reader's boundary, then the nodes of the approach at
both paces: they raise nothing, and give what an untouched twin gives. The last tests are the other
way round: without the boundary the same messages do harm.
"""

import contextlib
from functools import lru_cache
import time
from types import SimpleNamespace

import numpy as np
import pytest
import rclpy
from rclpy.serialization import deserialize_message, serialize_message
from rosgraph_msgs.msg import Clock
from std_msgs.msg import Bool, String, UInt64

from rvd_campaign import catalogue
from rvd_campaign.bench import hostile
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.block import Leg
from rvd_dynamics.diagram.ros import boundary, horizon, inputs, monitor
from rvd_dynamics.diagram.ros.boundary import content, Refused
from rvd_dynamics.diagram.ros.frame_codecs import Envelope
from rvd_dynamics.diagram.ros.conversions import time_at
from rvd_dynamics.diagram.ros.host import Host, message_type
from rvd_dynamics.diagram.ros.main import make
from rvd_dynamics.diagram.ros.process import listen_for_the_end
from rvd_dynamics.diagram.ros.writers import LOOK_S
from rvd_dynamics.diagram.scenario import load, parse
from rvd_dynamics.link.signals import FRAME
from rvd_interfaces.msg import Verdict
from rvd_interfaces.srv import RunControl
from sensor_msgs.msg import Joy

SCENARIOS = ('paper', 'hand', 'docking', 'docking_manual', 'ellipse', 'obstacles_moving', 'tether',
             'tether_delay', 'attitude')
STEP = 3
INFO = {'source_timestamp': 1, 'publication_sequence_number': None}    # of no writer that numbers


@lru_cache(maxsize=None)
def scenario(name):
    return load(catalogue.find('scenarios', name, ('.yaml',)))


def codec(of, signal, events=None):
    own = {'signal': signal, 'run': of.run,
           'event': (lambda *said: None) if events is None else lambda *said: events.append(said)}
    return made(signal.codec, lambda n: own[n] if n in own else of.part(n), signal.name)


def plausible(signal):
    """Return a value that a block may write: half of everything, and nothing beyond a limit."""
    parts = []
    for part in signal.parts:
        if part.dtype == 'O':
            parts.append(None)
            continue
        kind = np.dtype(part.dtype)
        fill = {'f': 0.5, 'b': part.name != 'final'}.get(kind.kind, 0)
        if part.name == 'command' and part.initial is not None:
            fill = part.initial
        value = np.full(part.shape, fill, dtype=kind)
        parts.append(np.broadcast_to(np.eye(part.shape[-1]), part.shape).copy() if part.spread
                     else value)
    return signal.type(*parts)


def good(of, signal, k):
    """Return an honest message of a signal at a step, as an object."""
    kind = message_type(signal.message)
    source = signal
    if signal.message == FRAME:                 # what comes out of a leg: what went in, later
        source = next((leg.reads['content'].signal for leg in of.diagram.legs()
                       if leg.writes['arrival'].name == signal.name), signal)
    encoded = codec(of, source).encode(k, plausible(source))
    if hasattr(encoded, 'serialised'):
        encoded = encoded.serialised()
    return deserialize_message(encoded, kind) if isinstance(encoded, bytes) else encoded


def attacks(message, k):
    yield from hostile.mutants(message)
    yield from hostile.at_steps(message, k)
    yield from (hostile.mutant(message, seed) for seed in range(50))


def reads_of(name):
    """Return each signal that a block of a scenario reads, once, and whether a leg reads it."""
    found = {}
    for block in scenario(name).diagram.blocks:
        if block.in_graph:
            for read in block.reads.values():
                found[read.signal.name, isinstance(block, Leg)] = read
    return found


def numbers(value):
    return np.concatenate([np.ravel(np.asarray(part, dtype=float)) for part in value
                           if part is not None and not isinstance(part, tuple)] or [np.zeros(0)])


@pytest.mark.parametrize('name', SCENARIOS)
def test_what_gets_past_the_boundary_is_within_what_the_signal_declares(name):
    of, refused = scenario(name), 0
    for (topic, is_leg), read in reads_of(name).items():
        signal = read.signal
        coder = Envelope(signal, of.run) if is_leg else codec(of, signal)
        taken, message = content(signal, coder, read.optional), good(of, signal, STEP)
        honest = taken(STEP, message)           # as it is, it passes
        assert is_leg or coder.frames or signal.complaint(honest, ()) == ''
        for _, attack in attacks(message, STEP):
            try:
                value = taken(STEP, attack)
                if is_leg:
                    assert 0 <= value.sent <= STEP*of.run.step_ns or value.empty
                    continue
                value = coder.decode(STEP, value) if coder.frames else value
            except Refused as why:
                assert 0 < len(str(why)) < 2000, topic
                refused += 1
                continue
            found = numbers(value)
            known = found[~np.isnan(found)]
            assert not np.isinf(found).any() and (np.abs(known) <= 1e15).all(), topic
    assert refused > 100


# -- nodes -------------------------------------------------------------------------------------

@pytest.fixture(autouse=True)
def ros(monkeypatch):
    monkeypatch.setenv('RVD_LEAN', '1')
    monkeypatch.setenv('ROS_AUTOMATIC_DISCOVERY_RANGE', 'OFF')
    rclpy.init()
    yield
    rclpy.try_shutdown()


class Alone:
    """A node by itself in its process: what it hears is handed to it, what it says is kept."""

    def __init__(self, name, pace='lockstep', bag_dir=''):
        text = ('/**: {ros__parameters: {timeout_s: 20.0, pace: %s}}' % pace
                + ('\nbag_recorder: {ros__parameters: {bag_dir: %s}}' % bag_dir if bag_dir else ''))
        self.of = parse(text, 'hostile')
        self.host = Host(SimpleNamespace(name=name, scenario=self.of, run_id='/', text=lambda: ''))
        self.said, self.events = [], []
        self.host.publish = lambda publisher, topic, step, message, by_hand=None: self.said.append(
            (topic, step, message if isinstance(message, bytes) else serialize_message(message)))
        self.host.event = lambda node, code, text: self.events.append((code, text))
        self.host.begun = True
        make(self.host, (name,))
        listen_for_the_end(self.host)
        self.node = self.host.nodes[name]
        self.signals = {read.signal.name: read.signal for read in getattr(
            getattr(self.node, 'block', None), 'reads', {}).values()}

    def hear(self, topic, message):
        self.node.subscriptions_of[topic].callback(message, INFO)
        self.host.work()
        self.host.raise_error()

    def hear_raw(self, topic, data):
        self.node.subscriptions_of[topic].callback(data, INFO)
        self.host.raise_error()

    def step(self, k):
        """Let the node have what it needs for step k, and what it is to have for the next."""
        if '/clock' in self.node.subscriptions_of:
            self.hear('/clock', Clock(clock=time_at(k*self.of.run.step_ns)))
        if self.node.get_name() == 'spacecraft_dynamics' and k == 0:
            self.node._started_ns = 1
            self.host.work()
        for topic, signal in self.signals.items():
            self.hear(topic, good(self.of, signal, k))

    def outputs(self):
        return [entry for entry in self.said if entry[0] not in ('/diagnostics', '/run/events')]

    def close(self):
        self.node.destroy_node()


def refused_by(node, topic, k):
    """Return the attacks at step k that are to be as if they had not come."""
    signal, found = node.signals[topic], []
    given = next(g for g in node.node._given if g.topic == topic)
    taken = content(signal, given.codec)
    for _, attack in attacks(good(node.of, signal, k), k):
        try:
            same = boundary.step_of(attack, node.of.run.step_ns) == k
            taken(k, attack)
            if not same and boundary.step_of(attack, node.of.run.step_ns) > node.of.run.last_step:
                found.append(attack)
        except Refused:
            found.append(attack)
    return found


BLOCKS = tuple(b.name for b in parse('/**: {ros__parameters: {}}', 'names').diagram.blocks
               if b.in_graph)


def flown(name, attacked, pace='lockstep', kind=refused_by):
    node = Alone(name, pace)
    try:
        for k in range(4):
            for topic in node.signals if attacked else ():
                for attack in kind(node, topic, k):
                    node.hear(topic, attack)
            node.step(k)
        return node.outputs(), node.events, node.node
    finally:
        node.close()


@pytest.mark.parametrize('name', BLOCKS)
def test_a_node_that_is_attacked_gives_what_its_untouched_twin_gives(name):
    attacked, events, node = flown(name, True)
    alone, quiet, _ = flown(name, False)
    assert attacked == alone and len(alone) >= 3 and quiet == []
    said = [text for code, text in events if code == 'REFUSED']
    assert len(said) == len(node.refused_count) == len(node.block.reads)      # once for each topic
    assert min(node.refused_count.values()) > 10
    assert f'{sum(node.refused_count.values())} left out' in node.trouble['refused']


def any_attack(node, topic, k):
    return [attack for _, attack in attacks(good(node.of, node.signals[topic], k), k)]


@pytest.mark.parametrize('pace', ['lockstep', 'realtime'])
@pytest.mark.parametrize('name', BLOCKS)
def test_whatever_comes_a_node_raises_nothing_and_goes_on_with_the_next_step(name, pace):
    """Attacks that look right may count; what comes of them is finite, and not far ahead."""
    outputs, _, node = flown(name, True, pace, any_attack)
    assert node.step <= 3 + horizon.AHEAD*3 or pace == 'lockstep' and node.step <= 40
    if pace == 'lockstep' or name == 'spacecraft_dynamics':
        return
    kinds = {s.name: message_type(s.message) for s in node.block.writes.values()}
    for topic, _, data in outputs:
        if topic in kinds and kinds[topic].__name__ == 'RelativeState':
            message = deserialize_message(data, kinds[topic])
            if message.valid:
                p, v = message.position, message.velocity
                assert np.isfinite([p.x, p.y, p.z, v.x, v.y, v.z]).all(), topic


@pytest.mark.parametrize('pace', ['lockstep', 'realtime'])
def test_the_world_is_moved_by_its_own_clock_alone(pace):
    node = Alone('spacecraft_dynamics', pace)
    try:
        node.node._started_ns = 1
        thrust = good(node.of, node.signals['/onboard/thruster_command'], 0)
        for k in (5, 39, 40, 2**63, 2**64 - 1):
            thrust.step = k
            node.hear('/onboard/thruster_command', thrust)
        assert node.node.step == (0 if pace == 'lockstep' else -1)
        assert node.node._inputs['thrust'].held == {}
    finally:
        node.close()


@pytest.mark.parametrize('pace', ['lockstep', 'realtime'])
def test_a_command_of_a_step_that_was_there_is_not_taken_for_one_that_comes_late(pace):
    def predicted(attacked):
        node = Alone('state_predictor', pace)
        try:
            for k in range(20):
                node.step(k)
                if attacked and k > 3:
                    again = good(node.of, node.signals['/ground/command'], k - 2)
                    again.levels[:] = [3, -3, 3]
                    node.hear('/ground/command', again)
            assert node.node.late_count == 0
            return [entry for entry in node.outputs()]
        finally:
            node.close()
    assert predicted(True) == predicted(False)


def test_what_a_run_says_about_itself_is_held_against_what_can_be():
    node = Alone('spacecraft_dynamics')
    try:
        node.step(0)
        for words in ('', 'a b c', 'x'*10**6, '/rvd/x', 'spacecraft_dynamics /rvd/x', '\x1b[2J'):
            node.hear_raw('/run/ready', serialize_message(String(data=words)))
        for seed in range(300):
            node.hear_raw('/run/ready',
                          hostile.broken(serialize_message(String(data='guard')), seed))
        for step in (2**63, 2**64 - 1, 40):
            node.hear('/run/recorded_step', UInt64(data=step)) \
                if '/run/recorded_step' in node.node.subscriptions_of else None
        for data in (True, False):
            node.hear('/run/pause', Bool(data=data))
        assert node.node._pace_kept().startswith('0 commands missing')     # none was due
    finally:
        node.close()


def test_a_request_is_answered_in_one_short_line():
    node = Alone('command_blender')
    try:
        for action in range(256):
            for mode in ('', 'auto', 'x'*10**6, '\x1b[2J'):
                answer = node.node._on_control(RunControl.Request(action=action, mode=mode),
                                               RunControl.Response())
                assert answer.accepted == (action in (0, 1, 3) or (action == 2 and mode == 'auto'))
                assert 0 < len(answer.message) < 500 and answer.message.isprintable()
    finally:
        node.close()


@pytest.mark.parametrize('now, step, told', [
    (7, 0, 'this is step 7'), (7, 6, 'this is step 7'), (-1, 41, 'longer than 40'),
    (7, 2**63, 'longer than 40')])
def test_an_end_that_cannot_be_ends_nobody(now, step, told):
    node = Alone('auto_controller')
    try:
        node.node.step = now
        node.host.ending.hear(UInt64(data=step))
        assert node.host.final_step is None and not node.host.ended and told in node.events[0][1]
    finally:
        node.close()


def test_an_end_after_which_the_run_goes_on_was_none():
    node = Alone('auto_controller')
    try:
        for k in (0, 1):
            node.step(k)
        node.host.ending.hear(UInt64(data=1))
        assert node.node.finished and not node.host.ended       # it waits for a moment
        node.step(2)
        assert node.node.step == 2 and not node.node.finished and node.host.final_step is None
        assert 'was not the last' in node.events[-1][1]
        node.host.ending.hear(UInt64(data=2))                   # and now it is
        assert node.node.finished
        node.host.ending._heard -= 1.0
        node.host.look()
        assert node.host.ended
    finally:
        node.close()


def test_the_first_stamp_by_the_clock_on_the_wall_is_told_in_plain_words():
    text = '/**: {ros__parameters: {operator: joy, joy_input: stepped}}'
    node = Alone('command_blender')
    try:
        joy = good(node.of, node.signals['/joy'], 0)
        joy.header.stamp.sec, joy.header.stamp.nanosec = 1_790_000_000, 5
        node.hear('/joy', joy)
        node.hear('/joy', joy)
        (code, said), = node.events
        assert code == 'REFUSED' and text and node.node.refused_count == {'/joy': 2}
        assert 'stamped with wall time (2026-09-21 ' in said
        assert '/joy carries the simulation time of its step' in said
        node.step(0)
        assert node.node.step == 0
    finally:
        node.close()


# -- watchers ------------------------------------------------------------------------------------

def test_the_judge_hears_the_truth_in_order_whatever_else_is_there():
    node = Alone('mission_monitor')
    truth = node.of.diagram.truth
    try:
        taken = content(truth, codec(node.of, truth))
        for k in range(6):
            for _, attack in attacks(good(node.of, truth, k), k):
                if attack.step == k:
                    with contextlib.suppress(Refused):
                        taken(k, attack)
                        continue                # that one may be the truth
                node.hear(truth.name, attack)
            assert node.node.step == k - 1
            node.hear(truth.name, good(node.of, truth, k))
            assert node.node.step == k
    finally:
        node.close()


LOOKS = round(monitor.GAP_S/LOOK_S)             # until what is due counts as lost


class Judge(Alone):
    """The judge alone; `noted`: newest and last step on the page of the run, None: no page."""

    def __init__(self, noted=None):
        super().__init__('mission_monitor')
        self.truth = self.of.diagram.truth
        self.host._is_told = noted is not None
        if noted is not None:
            self.note(*noted)

    def note(self, made, end=-1):
        self.host._pulse.flown, self.host._pulse.final = made, end

    def tell(self, *steps, final=False):
        for k in steps:
            message = good(self.of, self.truth, k)
            message.final = final
            self.hear(self.truth.name, message)

    def end(self, step):
        self.node.subscriptions_of['/run/end'].callback(UInt64(data=step), INFO)
        self.host.raise_error()

    def look(self, times=LOOKS):
        for _ in range(times):
            self.node._look()


@pytest.fixture
def judge():
    made = []

    def make_one(*noted):
        made.append(Judge(*noted))
        return made[-1]
    yield make_one
    for each in made:
        each.close()


@pytest.mark.parametrize('noted, rest, end', [
    ((40,), range(2, 30), None), ((40,), (2,), None),           # what the plant has made was sent
    ((29, 29), range(2, 30), 29), ((2, 2), (2,), 2),            # also next to the end of the run
    (None, range(2, 30), None), (None, (2,), 2)])
def test_a_gap_in_the_truth_that_is_none_of_a_strangers_still_ends_the_judge(
        noted, rest, end, judge):
    one = judge(noted)
    one.tell(0)
    if end is not None:
        one.end(end)
        assert one.host.final_step == end
    one.tell(*rest)
    one.look(LOOKS - 1)
    with pytest.raises(ValueError, match='truth jumps from step 0 to 2: a run with a gap'):
        one.look(1)


def test_a_gap_is_told_by_the_clock_of_the_process_itself(judge, monkeypatch):
    monkeypatch.setattr(monitor, 'GAP_S', 0.3)
    one, begun = judge((40,)), time.monotonic()
    one.tell(0, 2)
    with pytest.raises(ValueError, match='truth jumps from step 0 to 2'):
        one.host.spin(lambda: time.monotonic() - begun > 30.0)


def test_what_was_due_may_still_come_and_the_judge_goes_on(judge):
    one = judge((40,))
    one.tell(0, 2, 39)
    one.look(LOOKS - 1)
    one.tell(1)
    one.look(2*LOOKS)
    assert one.node.step == 1
    one.tell(2)
    assert one.node.step == 2 and one.node.refused_count == {one.truth.name: 2}


def test_a_forged_end_with_a_forged_truth_ends_nobody_also_while_the_run_is_paused(judge):
    one = judge((3,))
    one.tell(0, 1, 2, 3)
    for step in (3, 13, 40):                    # it stands at 3
        one.end(step)
        one.tell(step, final=True)
    one.tell(4, 4, final=True)                  # what is due next, before there is one
    one.look(3*LOOKS)
    assert not one.host.ended and one.host.final_step is None and one.node.step == 3
    assert one.node.refused_count == {'/run/end': 3, one.truth.name: 5}
    one.note(5, 5)
    one.tell(4, final=True)                     # made by now, but not the last
    assert one.node.step == 3
    one.end(5)
    one.tell(4)
    one.tell(5)                                 # the last, but does not say so
    assert one.node.step == 4 and not one.node.finished
    one.tell(5, final=True)
    assert one.node.finished and one.host.ended


def test_twin_without_the_word_of_the_plant_a_forged_end_and_truth_end_the_judge(judge):
    one = judge()
    one.tell(0, 1, 2, 3)
    one.end(13)
    one.tell(13, final=True)
    with pytest.raises(ValueError, match='truth jumps from step 3 to 13'):
        one.look(LOOKS)                         # nothing came: the run stood still


def test_without_the_word_of_the_plant_it_is_enough_that_the_run_goes_on(judge):
    one = judge()
    one.tell(0, 1, 2, 3)
    one.end(13)
    one.tell(13, final=True)
    one.look(LOOKS - 1)
    one.tell(4)
    one.look(LOOKS)
    assert one.node.step == 4 and not one.host.ended


@pytest.mark.parametrize('noted', [True, False])
def test_an_end_at_the_present_step_is_believed_if_the_plant_has_noted_it(noted):
    """The second case is the twin: by the message alone it cannot be told from the true one."""
    node = Alone('auto_controller')
    try:
        node.host._is_told, node.host._pulse.flown = noted, 1
        node.step(0)
        node.step(1)
        node.host.ending.hear(UInt64(data=1))
        assert node.node.finished != noted and (node.host.final_step is None) == noted
        if noted:
            assert node.events == [('REFUSED', '/run/end: step 1 is not the last: the run is at '
                                    'step 1 and goes on: left out, as if it had not come')]
            node.host._pulse.final = 1
            node.host.ending.hear(UInt64(data=1))
            assert node.host.ended              # at once: there is nothing to wait for
            node.host.ending.goes_on(2)         # nor does it begin again
            assert node.host.ended and node.host.final_step == 1
    finally:
        node.close()


@pytest.mark.parametrize('pace, told, reached', [
    ('realtime', True, 2 + horizon.AHEAD), ('realtime', False, 40), ('lockstep', True, 2),
    ('lockstep', False, 40)])
def test_steps_one_after_the_other_carry_no_node_past_what_the_plant_has_made(pace, told, reached):
    """Without the plant's word they do, one by one, to the end of the run: the twins."""
    node = Alone('onboard_guard', pace)
    try:
        node.host._is_told, node.host._pulse.flown = told, 2
        for k in range(41):
            node.hear('/onboard/command', good(node.of, node.signals['/onboard/command'], k))
        assert node.node.step == reached
        assert node.node.refused_count == ({'/onboard/command': 40 - reached} if told else {})
        node.host._pulse.flown = 4
        node.hear('/onboard/command', good(node.of, node.signals['/onboard/command'], 3))
        assert pace == 'realtime' or not told or node.node.step == 3    # the run goes on
    finally:
        node.close()


@pytest.mark.parametrize('pace', ['lockstep', 'realtime'])
def test_the_clock_is_never_ahead_of_the_plant(pace):
    node = Alone('operator_model', pace)
    try:
        if '/clock' not in node.node.subscriptions_of:
            node.node._limit, node.node._instants = -1, horizon.Horizon(node.of.run, 40)
        for told in (True, False):              # the second is the twin
            node.host._is_told, node.host._pulse.flown = told, 2
            for k in range(5):
                node.node._on_clock(-1, Clock(clock=time_at(k*node.of.run.step_ns)))
            assert node.node._limit == (2 if told else 4)
    finally:
        node.close()


def test_the_recorder_keeps_its_time_and_its_count(tmp_path):
    node = Alone('bag_recorder', bag_dir=tmp_path/'bag')
    try:
        node.host.publish = lambda *args: None
        signals = node.of.diagram.signals
        topics = [t for t in node.node.subscriptions_of if t in node.node._ledger.last]
        assert '/truth/relative_state' in topics
        seen = [t for t in topics if t in signals and signals[t].codec]
        for k in range(26):                     # at each step one attack on each topic
            for topic in seen:
                message = good(node.of, signals[topic], k)
                steps = list(hostile.at_steps(message, k))
                node.hear_raw(topic, serialize_message(steps[k % len(steps)][1]))
                node.hear_raw(topic, hostile.broken(serialize_message(message), k)[:8])
                node.hear_raw(topic, serialize_message(message))
        for step in (2**63, 2**64 - 1):
            node.hear_raw('/run/verdict', serialize_message(Verdict(step=step, final=True)))
        assert node.node.step <= 40 and node.node._judged_step == -1
        assert {node.node._ledger.last[t] for t in seen} == {25}
        assert {node.node._ledger.missing[t] for t in seen} == {0}
    finally:
        node.node.close()
        node.close()


def test_the_console_shows_what_can_be_and_nothing_else():
    from rvd_groundstation.console.node import ConsoleNode
    of, posts = parse('/**: {ros__parameters: {timeout_s: 20.0, operator: console, '
                      'joy_input: held, pace: realtime}}', 'watched'), []
    host = Host(SimpleNamespace(name='console', scenario=of, run_id='/', text=lambda: ''))
    host.event = host.publish = lambda *args, **more: None
    node = ConsoleNode(host, SimpleNamespace(post=lambda *what: posts.append(what)), None)
    try:
        node.connect()
        signals, topics = of.diagram.signals, host.roster.topics
        for topic, subscription in node.subscriptions_of.items():
            if topic in ('/run/verdict', '/run/pause'):
                continue
            kind = message_type(topics[topic])
            honest = good(of, signals[topic], 1) if topic in signals and signals[topic].codec \
                else kind()
            for i, (_, attack) in enumerate(attacks(honest, 1)):
                data = serialize_message(attack)
                subscription.callback(data if subscription.raw else attack, INFO)
                if subscription.raw:
                    node._decode_newest()
                    subscription.callback(hostile.broken(data[:2000], i), INFO)
                    node._decode_newest()
                host.raise_error()
        shown = [what[2] for what in posts if what[0] == 'signal']
        assert shown and node.step <= 40 and len(node.refused_count) >= 5
        for sample in shown:
            found = numbers([np.asarray(v, float) for v in sample.parts.values()])
            assert not np.isinf(found).any() and sample.step <= of.run.last_step
    finally:
        node.destroy_node()


# -- without the boundary -----------------------------------------------------------------------

@pytest.fixture
def open_boundary(monkeypatch):
    """Believe everything."""
    def believing(signal, coder, optional=()):
        return lambda step, message: message if coder.frames else coder.decode(step, message)
    monkeypatch.setattr(inputs.boundary, 'content', believing)
    monkeypatch.setattr(horizon.Horizon, 'believes', lambda self, step, need=0: True)


@pytest.mark.parametrize('name, topic, field, value', [
    ('spacecraft_dynamics', '/onboard/thruster_command', 'levels[0]', 4),
    ('state_predictor', '/ground/command', 'levels[0]', 4),
    ('link_forward', '/ground/uplink', 'sent', 2**62)])
def test_without_it_one_message_takes_a_node_down(open_boundary, name, topic, field, value):
    node = Alone(name)
    try:
        with pytest.raises((ValueError, OverflowError)):
            for k in range(4):
                for each, signal in node.signals.items():
                    message = good(node.of, signal, k)
                    if each == topic:
                        hostile.put(message, field, value)
                    if k == 0 and name == 'spacecraft_dynamics':
                        node.node._started_ns = 1
                        node.host.work()
                    node.hear(each, message)
    finally:
        node.close()


def test_without_it_a_message_of_the_future_runs_the_guard_to_the_end(open_boundary):
    node = Alone('onboard_guard', 'realtime')
    try:
        message = good(node.of, node.signals['/onboard/command'], 40)
        node.hear('/onboard/command', message)
        assert node.node.step == 40
    finally:
        node.close()


def test_a_joy_of_a_million_axes_is_left_out_and_one_without_any_is_nobodys():
    node = Alone('command_blender')
    try:
        for size in (65, 10**6):
            node.hear('/joy', Joy(axes=[0.0]*size))
        assert node.node._inputs['stick'].held == {} and node.node.refused_count == {'/joy': 2}
        node.hear('/joy', Joy())
        assert not node.node._inputs['stick'].held[0].valid
    finally:
        node.close()
