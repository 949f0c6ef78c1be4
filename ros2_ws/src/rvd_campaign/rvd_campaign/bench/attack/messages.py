"""
Mutated messages to every node of a run, at both paces: none ends, none hangs.

The nodes of a run as processes have them, each with its host and executor, side by side in one
process that hears nobody else. What their subscriptions are handed is what they would be handed by
the middleware: an object of the right type, or, where the node asks for bytes, bytes. The run goes
on meanwhile; where a message ends it, as a step that is believed does, another one begins.
"""

from collections.abc import Iterator
from contextlib import contextmanager, ExitStack
import inspect
import os
from pathlib import Path
from random import Random
import shutil
import tempfile
import time
from types import SimpleNamespace
from typing import Any

from rvd_campaign import catalogue
from rvd_campaign.bench import hostile
from rvd_campaign.bench.attack import Case, Kind, Outcome
from rvd_campaign.bench.attack.limits import Hung, in_child, within
from rvd_campaign.flight.domain import reserved_domain
from rvd_dynamics.diagram.roster import MARKERS
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_dynamics.pulse import PAGE, Pulse

SCENARIOS = ('paper', 'tether_delay', 'obstacles', 'attitude')
PACES = ('lockstep', 'realtime')
STEPS_HZ = 40.0                 # steps a second in real time: one process for all has more to do
EACH = 250                      # messages to each node in a case
WARM_UP = 5                     # steps before the first: messages are made of what was said
TURNS = 20                      # callbacks between two messages to each node
DRAW_EVERY = 25                 # messages to each node between two pictures, which are slow
BEGIN_S = 120.0                 # [s] wall time for the warm-up
CALL_S = 5.0                    # [s] wall time for one message, and for one turn of all
CASE_S = 600.0                  # [s] wall time for a case
EXTRA_BYTES = 3 << 30           # of address space
EVENT = {'source_timestamp': 1, 'received_timestamp': 1, 'publication_sequence_number': 1,
         'reception_sequence_number': 1}


def attack() -> Kind:
    """Return this kind."""
    return Kind('messages', 'mutated messages to every node, at both paces',
                'messages to each node', 20_000, EACH, _open, EACH,
                zero=('nodes ended', 'hangs', 'ended'))


@contextmanager
def _open(_: Path) -> Iterator[Case]:
    yield one


def one(seed: int) -> Outcome:
    """Send EACH messages to each node of a run, in a child."""
    name = SCENARIOS[seed // len(PACES) % len(SCENARIOS)]
    pace = PACES[seed % len(PACES)]
    try:
        counts, failures = in_child(lambda: _attacked(name, pace, seed), CASE_S, EXTRA_BYTES)
    except Hung as error:
        return Outcome(failures=[f'{name}, {pace}: {error}'],
                       counts=_counted('hangs'))
    except RuntimeError as error:
        return Outcome(failures=[f'{name}, {pace}: {error}'], counts=_counted('ended'))
    outcome = Outcome(failures=[f'{name}, {pace}: {what}' for what in failures])
    outcome.counts.update(counts)
    return outcome


def _counted(what: str) -> Any:
    return Outcome().counts + type(Outcome().counts)([what])


class Rig:
    """The processes of a run side by side in this one."""

    def __init__(self, scenario: Scenario, folder: Path) -> None:
        import rclpy
        from rclpy.executors import SingleThreadedExecutor

        from rvd_dynamics.diagram.ros.host import Host
        from rvd_dynamics.diagram.ros.process import listen_for_the_end
        from rvd_dynamics.diagram.ros.main import make
        from rvd_dynamics.diagram.roster import listed, Roster
        shutil.rmtree(folder, ignore_errors=True)
        folder.mkdir(parents=True)
        rclpy.init(args=[])
        roster = listed(scenario.with_values('/**', processes='blocks'), headless=False)
        ours = [name for name in roster.names if name not in roster.externals]
        scenario = scenario.with_values('/**', nodes=ours, processes='blocks')
        scenario = scenario.with_values('bag_recorder', bag_dir=str(folder / 'bag'))
        if 'markers' in scenario.mission.sections:
            scenario = scenario.with_values('markers', rate_hz=0.1)     # and see `draw`
        arguments = SimpleNamespace(name='attack', scenario=scenario, run_id='/',
                                    text=scenario.dump)
        self.said: dict[str, bytes] = {}        # the last message on each topic
        self.hosts: dict[str, Host] = {}
        page = Pulse.shared(len(Roster(scenario, ours).processes))      # as a bring-up hands it on
        os.environ[PAGE] = str(page.file)
        for process in roster.processes:
            if process.name in roster.externals:        # a page, or somebody else's program
                continue
            host = self.hosts[process.name] = Host(arguments)
            make(host, process.nodes)
            listen_for_the_end(host)
            for node in host.nodes.values():
                for topic in host.roster.writes(node.get_name()):
                    host.keep(topic, lambda _, data, topic=topic: self.said.update({topic: data}))
        page.handed_on()
        self._executor = SingleThreadedExecutor()       # one: it looks at all of them at once
        for node in self.nodes.values():
            self._executor.add_node(node)

    @property
    def nodes(self) -> dict[str, Any]:
        """All nodes by their names."""
        return {name: node for host in self.hosts.values() for name, node in host.nodes.items()}

    def turn(self) -> None:
        """Serve one callback, and let every process work; an error of a node is raised."""
        self._executor.spin_once(timeout_sec=0.0)
        for host in self.hosts.values():
            if not host.ended:
                host.work()
            host.raise_error()

    def draw(self) -> None:
        """
        Draw the pictures of now; by itself their node rests meanwhile, and all others with it.
        """
        for name, node in self.nodes.items():
            if name == MARKERS and not node.host.ended:
                for timer in node.timers:
                    timer.cancel()
                node.guarded(node._draw)(True)
                node.host.raise_error()

    @property
    def over(self) -> bool:
        """Whether a process has ended, as each does with its run."""
        return any(host.ended for host in self.hosts.values())

    def close(self) -> None:
        """End all; what is left to say goes nowhere."""
        import rclpy
        self._executor.shutdown(timeout_sec=0.0)
        for node in self.nodes.values():
            node.destroy_node()
        rclpy.try_shutdown()


def _attacked(name: str, pace: str, seed: int) -> tuple[dict[str, int], list[str]]:
    os.environ.update(RVD_LEAN='1', ROS_AUTOMATIC_DISCOVERY_RANGE='OFF')
    os.environ.pop('ROS_DOMAIN_ID', None)       # a flight of its own
    with open(os.devnull, 'wb') as nowhere:     # broken bytes make the middleware talk
        os.dup2(nowhere.fileno(), 1)
        os.dup2(nowhere.fileno(), 2)
    scenario = load(catalogue.find('scenarios', name, ('.yaml',)))
    scenario = scenario.with_values('/**', pace=pace, pace_factor=STEPS_HZ*scenario.run.step_s)
    if scenario.has_shared('operator'):
        operator = scenario.part('operation').operator
        if operator in ('console', 'joy'):
            scenario = scenario.with_values('/**', operator='none', joy_input='stepped')
    rng, failures = Random(seed), []
    counts = {'delivered': 0, 'runs': 0}
    with ExitStack() as stack:
        folder = Path(stack.enter_context(tempfile.TemporaryDirectory(prefix='rvd-attack-')))
        os.environ['ROS_DOMAIN_ID'] = str(int(stack.enter_context(reserved_domain())))
        left = EACH
        while left > 0 and len(failures) < 20:
            counts['runs'] += 1
            left = _one_run(scenario, folder, rng, left, counts, failures)
    return counts, failures


def _one_run(scenario: Scenario, folder: Path, rng: Random, left: int, counts: dict[str, int],
             failures: list[str]) -> int:
    """Attack one run until it is over; return how many messages to each node are left."""
    rig = Rig(scenario, folder)
    last = 'nothing'
    try:
        deadline = time.monotonic() + BEGIN_S
        plant = rig.nodes[next(iter(rig.hosts.values())).roster.diagram.plant]
        while plant.step < WARM_UP and not rig.over:
            rig.turn()
            if time.monotonic() > deadline:
                failures.append(f'the run did not begin: step {plant.step}')
                return 0
        rig.draw()
        while left > 0 and not rig.over:
            left -= 1
            for name, node in rig.nodes.items():
                last = name
                words = _deliver(node, rig.said, plant.step, rng)
                if words is None:
                    continue
                last = f'{name} after {words}'
                counts['delivered'] += 1
                node.host.raise_error()
            if left % DRAW_EVERY == 0:
                last = MARKERS
                with within(CALL_S):
                    rig.draw()
            for _ in range(TURNS):
                with within(CALL_S):
                    rig.turn()
    except Hung as error:
        counts['hangs'] = counts.get('hangs', 0) + 1
        failures.append(f'{last}: {error}')
    except Exception as error:                  # noqa: B902 - that is what is looked for
        counts['nodes ended'] = counts.get('nodes ended', 0) + 1
        node = getattr(error, 'rvd_node', None)
        failures.append(f'{node.get_name() if node is not None else "?"} ended, {last}: '
                        f'{type(error).__name__}: {error}')
    finally:
        rig.close()
    return left


def _deliver(node: Any, said: dict[str, bytes], step: int, rng: Random) -> str | None:
    """Hand a node a hostile message on one of its topics; return it in words, None: it has none."""
    from rclpy.serialization import deserialize_message, serialize_message
    topics = sorted(node.subscriptions_of)
    if not topics:
        return None
    topic = rng.choice(topics)
    subscription = node.subscriptions_of[topic]
    kind = subscription.msg_type
    base = deserialize_message(said[topic], kind) if topic in said else kind()
    way = rng.random()
    if way < 0.25:
        words, message = rng.choice(list(hostile.at_steps(base, max(step, 0))) or [('', base)])
    else:
        words, message = hostile.mutant(base, rng.getrandbits(32))
        if rng.random() < 0.5 and hasattr(message, 'step'):     # of a step that is waited for
            message.step = max(step, 0) + rng.randint(0, 2)
    data = serialize_message(message)
    if way > 0.9:
        data = hostile.broken(data, rng.getrandbits(32))
        words = 'broken bytes'
    if subscription.raw:
        item: Any = data
    else:
        try:
            item = deserialize_message(data, kind)
        except Exception:                       # noqa: B902 - the middleware drops it, too
            return None
    with within(CALL_S):
        call = subscription.callback
        call(item, dict(EVENT)) if _takes(call) > 1 else call(item)
    return f'{topic} with {words[:120]}'


def _takes(call: Any) -> int:
    return len(inspect.signature(call).parameters)
