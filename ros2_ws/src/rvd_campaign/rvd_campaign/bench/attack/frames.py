"""
Hostile frames, in process: through the link's channel and play-out, the codecs, gate and guard.

A case is a volley at one scenario, new each time. In each step the ground sends a frame of its own
or a hostile one stands in its place, and hostile ones arrive beside what the link hands over. What
is accepted must be a frame of the ground's, and come no more than once.

Hostile are random bytes, damaged and cut and lengthened frames, old ones once more, and frames
with a right checksum that no sender makes: another version, key or session, an unknown kind, a
command outside the form, from the future, too old, with an old sequence number. Left out are those
that a sender could have made: whoever knows the layout can make one, since a checksum is no key.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random
from struct import error as StructError
from struct import pack, Struct
from typing import Any, NamedTuple
from zlib import crc32

import numpy as np

from rvd_campaign import catalogue
from rvd_campaign.bench.attack import Case, Kind, Outcome
from rvd_dynamics.commands import codes
from rvd_dynamics.diagram.build import made, needs
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_dynamics.link.channel import Channel
from rvd_dynamics.link.play_out import Frame

VOLLEY = 1000                   # hostile frames of a case
HEAD = Struct('<BHQQqB')        # version, key, session, sequence, generated [ns], kind
LONGEST = 70_000                # [bytes] longer than any buffer along the way
LARGE = (0, 1, 127, 128, 255, (1 << 16) - 1, 1 << 31, 1 << 32, 1 << 62, (1 << 63) - 1)
FLOATS = (float('nan'), float('inf'), float('-inf'), 1e308, -1e308, 5e-324)
# One scenario for each mission, and each command form, that has a link.
SCENARIOS = ('paper', 'rough_link', 'docking_delay', 'tether_delay', 'tether', 'ellipse',
             'obstacles', 'attitude')


def attack() -> Kind:
    """Return this kind."""
    return Kind('frames', 'hostile frames through link, play-out, gate, guard and decoders, in '
                'process', 'frames', 1_000_000, 20_000, _open, VOLLEY,
                zero=('accepted', 'crashes'))


@contextmanager
def _open(_: Path) -> Iterator[Case]:
    scenarios = [load(catalogue.find('scenarios', name, ('.yaml',))) for name in SCENARIOS]
    yield lambda seed: volley(scenarios[seed % len(scenarios)], seed)


class Leg(NamedTuple):
    """One leg, with what a node at either end of it holds."""

    name: str
    channel: Channel
    sender: Any                 # codec
    receiver: Any               # codec
    value: Any                  # of the signal that is sent
    form: Any                   # of commands; None: what comes down
    body: int                   # [bytes] between head and checksum


def legs_of(scenario: Scenario, events: list) -> list[Leg]:
    """Return the legs of a scenario as they are at the start of a run."""
    run, found = scenario.run, []

    def available(own: dict[str, Any]) -> Any:
        return lambda name: own[name] if name in own else scenario.part(name)

    def coded(signal: Any) -> Any:
        return made(signal.codec, available({
            'signal': signal, 'run': run,
            'event': lambda code, text: events.append((code, text))}), signal.name)
    for leg in scenario.diagram.legs():
        drawn = leg.draws['chance']
        channel = Channel(drawn.of_run(run.seed, run.run, run.last_step + 1), drawn.hold_steps,
                          run.step_ns)
        content = leg.reads['content'].signal
        names = needs(content.codec, content.name)
        form = next((scenario.part(name) for name in ('hand_form', 'form') if name in names), None)
        width = form.wire.size if form is not None else (
            8 * content.parts[0].shape[0] + 9)
        found.append(Leg(leg.name, channel, coded(content), coded(leg.writes['arrival']),
                         content.initial(()), form, width))
    return found


def guard_of(scenario: Scenario, arrival: Any) -> Any:
    """Return the step of the block that reads what comes up and nothing else, or None."""
    block = next((block for block in scenario.diagram.blocks
                  if [read.signal.name for read in block.reads.values()] == [arrival.name]), None)
    if block is None:
        return None
    own = {'run': scenario.run, 'batch': (), 'block': block, 'runs': [scenario.run.run],
           'steps': scenario.run.last_step + 1, 'abort_step': None, 'wanted': frozenset()}
    if block.settings:
        own['settings'] = scenario.settings(block.section)
    return made(block.make, lambda name: own[name] if name in own else scenario.part(name),
                block.name).step


def volley(scenario: Scenario, seed: int) -> Outcome:
    """Send a volley at each leg of a scenario in turn; return what came of it."""
    rng, outcome, events = Random(seed), Outcome(), []
    for leg in legs_of(scenario, events):
        try:
            _fire(scenario, leg, rng, outcome)
        except Exception as error:              # noqa: B902 - any is a crash of the node
            outcome.counts['crashes'] += 1
            outcome.failures.append(f'{scenario.name}, {leg.name}: {type(error).__name__}: {error}')
    outcome.counts['refusals that were said'] += len(events)
    return outcome


def _fire(scenario: Scenario, leg: Leg, rng: Random, outcome: Outcome) -> None:
    from rclpy.serialization import deserialize_message

    from rvd_dynamics.diagram.ros.frame_codecs import FrameOfLink
    from rvd_interfaces.msg import LinkFrame
    run, hostile = scenario.run, Hostile(leg, scenario, rng)
    guard = guard_of(scenario, leg.receiver.signal) if leg.form is not None else None
    steps = min(run.last_step + 1, VOLLEY)
    share = -(-VOLLEY // (2 * steps))           # hostile ones of a step; there are two legs
    left, ours, spent = VOLLEY // 2, {}, set()
    for k in range(steps):
        genuine = leg.sender.encode(k, hostile.value(k)).payload
        ours[genuine] = k
        hostile.seen(genuine)
        instead = left > 0 and rng.random() < 0.3
        left -= instead
        sent = Frame(sequence=k + 1, sent_ns=k * run.step_ns, expedited=rng.random() < 0.05,
                     payload=hostile.payload(k) if instead else genuine)
        due = leg.channel.advance(k, sent)
        passed = FrameOfLink(k, empty=True) if due is None else FrameOfLink(
            k, due.sequence, due.sent_ns, due.arrived_ns, due.released_ns, False, due.expedited,
            due.payload)
        came = [passed]
        for _ in range(min(left, share)):
            came.insert(rng.randint(0, len(came)), hostile.envelope(k))
            left -= 1
        arrival = None
        for frame in came:
            message = deserialize_message(frame.serialised(), LinkFrame)
            value = leg.receiver.decode(k, message)
            complaint = leg.receiver.signal.complaint(value, ())
            if complaint:
                raise ValueError(f'decoded at step {k}: {complaint}')
            if value.received:
                _judge(leg, k, frame.payload, ours, spent, outcome)
                arrival = value
            elif arrival is None:
                arrival = value
            if value.received and leg.form is not None:
                hostile.accepted = leg.receiver._gate.accepted_sequence
        if guard is not None:
            _check_thrust(leg, guard(k, arrival))
    outcome.counts['of the ground, accepted'] += len(spent)


def _judge(leg: Leg, k: int, payload: bytes, ours: dict[bytes, int], spent: set[bytes],
           outcome: Outcome) -> None:
    """Count an accepted frame."""
    if payload not in ours:
        outcome.counts['accepted'] += 1
        outcome.failures.append(f'{leg.name} accepted at step {k}: {payload.hex()}')
    elif payload in spent:
        outcome.counts['accepted'] += 1
        outcome.failures.append(f'{leg.name} accepted a second time at step {k}: frame of step '
                                f'{ours[payload]}')
    spent.add(payload)


def _check_thrust(leg: Leg, outputs: dict[str, Any]) -> None:
    command = outputs['thrust'].command
    if not leg.form.legal(tuple(np.asarray(command).tolist())):
        raise ValueError(f'the guard commands {np.asarray(command).tolist()}')


class Hostile:
    """Makes hostile frames for one leg."""

    def __init__(self, leg: Leg, scenario: Scenario, rng: Random) -> None:
        self._leg, self._rng = leg, rng
        self._run = scenario.run
        self._hold_ns = leg.channel._buffer._hold_steps * self._run.step_ns
        self._old: list[bytes] = []
        self.accepted = 0                       # sequence number that the gate has accepted last

    def value(self, k: int) -> Any:
        """Return what the ground, or the craft, sends in step k."""
        value = self._leg.value
        if self._leg.form is None:
            state = np.array([self._rng.uniform(-100.0, 100.0) for _ in
                              range(len(np.ravel(value[0])))]).reshape(np.shape(value[0]))
            return value._replace(**{value._fields[0]: state})
        command, form = self._leg.form.neutral, self._leg.form
        if hasattr(form, 'quantise'):           # an alphabet of thrusts, else of orders
            made = form.quantise(np.array([self._rng.gauss(0.0, 0.1) for _ in command]))
            command = made if form.legal(tuple(made.tolist())) else command
        return value._replace(command=command)

    def seen(self, payload: bytes) -> None:
        """Be told a frame that was sent: to be sent again."""
        self._old.append(payload)

    def payload(self, k: int) -> bytes:
        """Return hostile bytes."""
        return self._rng.choice((self._noise, self._damaged, self._cut, self._longer,
                                 self._forged, self._forged))(k)

    def envelope(self, k: int) -> Any:
        """Return a hostile frame beside the link: any envelope, hostile bytes, or old ones."""
        from rvd_dynamics.diagram.ros.frame_codecs import FrameOfLink
        rng, whole = self._rng, lambda: self._whole(0, (1 << 64) - 1)
        again = rng.random() < 0.1
        payload = rng.choice(self._old) if again else self.payload(k)
        if again and not self._is_spent(payload):       # still on its way: it would be in time
            payload = payload[:-1]
        return FrameOfLink(whole(), whole(), *(self._whole(-1 << 63, (1 << 63) - 1)
                                               for _ in range(3)),
                           rng.random() < 0.02, rng.random() < 0.5, payload)

    def _is_spent(self, payload: bytes) -> bool:
        return self._leg.form is None or HEAD.unpack(payload[:HEAD.size])[3] <= self.accepted

    def _whole(self, low: int, high: int) -> int:
        rng = self._rng
        chosen = rng.choice((rng.randint(low, high), rng.choice(LARGE), -rng.choice(LARGE), low,
                             high, rng.randint(0, 1000)))
        return min(max(chosen, low), high)

    def _noise(self, k: int) -> bytes:
        size = self._rng.choice((0, 1, self._size() - 1, self._size(), self._size(),
                                 self._size() + 1, self._rng.randint(0, 200)))
        if self._rng.random() < 0.001:
            size = LONGEST
        return self._rng.randbytes(size)

    def _size(self) -> int:
        return HEAD.size + self._leg.body + 4

    def _damaged(self, k: int) -> bytes:
        data = bytearray(self._rng.choice(self._old[-20:]))
        before = bytes(data)
        for _ in range(self._rng.choice((1, 1, 2, 3, 8, 64))):
            data[self._rng.randrange(len(data))] ^= 1 << self._rng.randrange(8)
        return bytes(data) if data != before else before[1:]

    def _cut(self, k: int) -> bytes:
        data = self._rng.choice(self._old[-20:])
        return data[:self._rng.randrange(len(data))]

    def _longer(self, k: int) -> bytes:
        data = self._rng.choice(self._old[-20:])
        return self._rng.choice((data + self._rng.randbytes(self._rng.randint(1, 40)), b'\0' + data,
                                 data + data))

    def _forged(self, k: int) -> bytes:
        """Return a frame with a right checksum in which at least one field is wrong."""
        rng, ns = self._rng, self._run.step_ns
        field = {'version': 1, 'key': 0, 'session': 0, 'sequence': 1 << 40, 'generated': k * ns,
                 'kind': codes.KIND_THRUST if self._leg.form is not None else 0}
        body = self._body()
        wrong = rng.choice(('version', 'key', 'session', 'kind') if self._leg.form is None else
                           ('version', 'key', 'session', 'kind', 'generated', 'sequence', 'body'))
        if wrong == 'version':
            field['version'] = rng.choice((0, 2, 255))
        elif wrong in ('key', 'session'):
            field[wrong] = rng.randint(1, 0xffff)
        elif wrong == 'kind' and self._leg.form is None:
            field['kind'] = rng.randint(1, 255)
        elif wrong == 'kind':
            field['kind'] = rng.choice([n for n in range(256) if n not in (
                codes.KIND_THRUST, codes.KIND_ABORT)])
        elif wrong == 'sequence':               # an ABORT of any age, too
            field['sequence'] = rng.randint(0, self.accepted)
            field['kind'] = rng.choice((codes.KIND_THRUST, codes.KIND_ABORT))
            field['generated'] = self._whole(-1 << 63, (1 << 63) - 1)
        elif wrong == 'generated':              # by more than it may spend on its way
            off = self._hold_ns + rng.randint(1, 1 << 40)
            field['generated'] = rng.choice((k * ns + off, k * ns - off, (1 << 63) - 1, -1 << 63))
        else:
            body = self._illegal()
        data = HEAD.pack(*field.values()) + body
        return data + pack('<I', crc32(data))

    def _body(self) -> bytes:
        form = self._leg.form
        if form is None:
            return self._rng.randbytes(self._leg.body)
        return form.wire.pack(*form.neutral.tolist())

    def _illegal(self) -> bytes:
        """Return the bytes of a command that is none of the form."""
        form, rng = self._leg.form, self._rng
        while True:
            numbers = list(form.neutral.tolist())
            at = rng.randrange(len(numbers))
            numbers[at] = rng.choice(FLOATS) if isinstance(numbers[at], float) else rng.randint(
                -128, 127)
            try:
                made_of = form.wire.pack(*numbers)
            except StructError:                 # a number that has no place there
                continue
            if not form.legal(form.wire.unpack(made_of)):
                return made_of
