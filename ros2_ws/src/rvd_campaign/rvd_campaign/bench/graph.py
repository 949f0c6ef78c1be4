"""
The graph in lock step against a hollow rclpy graph of the same shape, turn about.

With `processes: blocks`, which is what the hollow one copies; and the same run with `segments` and
with `one`, and by another checkout of the project where one is given. Every few steps the CPU time
of every node process is noted; the figures are differences between a note in flight and the last
one, so that start-up and end do not count. Our own flights are followed by the page that they share
with who started them; the others by `/run/recorded_step`, which the recorder (hollow or not)
publishes. In one process a flight is over in a third of a second, before DDS has found who listens.
"""

from contextlib import suppress
from dataclasses import dataclass, field
import json
import os
from pathlib import Path
from statistics import median
import subprocess
import sys
import tempfile
import time
from typing import Any, Callable

from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.node import Node
from rclpy.parameter import Parameter
from std_msgs.msg import UInt64

from rvd_campaign import catalogue
from rvd_campaign.bench.before import BringUp, Checkout
from rvd_campaign.cpu import cpu_s
from rvd_campaign.flight.domain import reserved_domain
from rvd_campaign.flight.supervisor import Supervisor
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.identity import new_run
from rvd_dynamics.diagram.ros import qos
from rvd_dynamics.diagram.roster import listed, Roster
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_dynamics.recording.messages import files_of, MessageFile

SCENARIO = 'hand'               # ten steps a second
WARM_UP_STEPS = 96              # [steps] in flight before the measurement begins
MAX_CPU_RATIO = 1.5
MAX_CPU_OF_BEFORE = 1.0
MIN_STEPS_PER_S = 120.0         # 12 times real time at ten steps a second
MIN_SPEED = {'segments': 2.0, 'one': 8.0}       # steps per second, times those of `blocks`
LOCKSTEP = {'pace': 'lockstep', 'operator': 'model', 'joy_input': 'stepped'}
LEAST_STEPS = {'blocks': 128, 'bare': 112, 'segments': 64, 'one': 64}       # to be measured
STRIDE = 4                      # [steps] at least, between two notes from the page
LOOK_S = 0.002                  # [s] wall time between two looks at the page of a flight
ATTEMPTS = 4                    # the observer may find the nodes too late
FRESH_NS = 100_000_000          # [ns] wall time after which a step is old news
PATIENCE_S = 120.0              # [s] wall time for one flight, start included


class Unheard(BadInput):
    """A flight that could not be measured: too few steps were heard while they were new."""


@dataclass
class Meter:
    """CPU time of processes by step, noted as the steps go by."""

    steps: list[int] = field(default_factory=list)
    times: list[float] = field(default_factory=list)                # [s] wall
    used: list[dict[str, float]] = field(default_factory=list)      # [s] CPU by node

    def note(self, step: int, pids: dict[str, int]) -> None:
        """Note how much each node has used when the recorder has seen `step`."""
        if step >= WARM_UP_STEPS:
            self.steps.append(step)
            self.times.append(time.monotonic())
            self.used.append({name: cpu_s(pid) for name, pid in pids.items()})

    def result(self, least: int) -> dict:
        """
        Return steps, steps per second and CPU time per step, by node and all together.

        Raises
        ------
        ValueError
            If fewer than `least` steps lie between the first note and the last.
        """
        steps = self.steps[-1] - self.steps[0] if self.steps else 0
        if steps < least:
            raise Unheard(f'the flight is too short to measure, or was heard too late: {steps} of '
                          f'at least {least} steps after the first {WARM_UP_STEPS}')
        by_node = {name: round(1e6 * (self.used[-1][name] - before) / steps, 1)
                   for name, before in self.used[0].items()}
        return {'steps': steps,
                'steps_per_s': round(steps / (self.times[-1] - self.times[0]), 1),
                'cpu_us_per_step': round(sum(by_node.values()), 1),
                'by_node': by_node}


class Observer:
    """Listens to the recorder's steps, in a context of its own."""

    def __init__(self, domain: int) -> None:
        self._context = Context()
        self._context.init(domain_id=domain)
        self._node = Node('rvd_bench', context=self._context, enable_rosout=False,
                          start_parameter_services=False, parameter_overrides=[
                              Parameter('start_type_description_service', value=False)])
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self._steps: list[int] = []
        self._node.create_subscription(UInt64, '/run/recorded_step', self._hear,
                                       qos.of('/run/recorded_step'))

    def _hear(self, message: UInt64, info: dict) -> None:
        """Leave out what was sent before the writer was discovered, and comes all at once."""
        if time.time_ns() - info['source_timestamp'] < FRESH_NS:
            self._steps.append(message.data)

    def follow(self, ended: Callable[[], bool], pids: Callable[[], dict[str, int]]) -> Meter:
        """
        Note every step that is reported in time until `ended()`; `pids()` are the nodes by name.

        Raises
        ------
        ValueError
            If it does not end in time.
        """
        meter, deadline = Meter(), time.monotonic() + PATIENCE_S
        while not ended():
            self._executor.spin_once(timeout_sec=0.2)
            for step in self._steps:
                meter.note(step, pids())
            self._steps.clear()
            _in_time(deadline)
        return meter

    def close(self) -> None:
        """Leave the graph."""
        self._executor.shutdown()
        self._node.destroy_node()
        self._context.try_shutdown()


def fly_ours(scenario: Path, folder: Path, domain: int) -> Meter:
    """
    Fly the scenario with the real graph; return the notes.

    Raises
    ------
    ValueError
        If a node fails, or the flight does not end in time.
    """
    (folder / 'logs').mkdir(parents=True)
    supervisor = Supervisor(catalogue.root() / 'scripts' / 'bringup.sh', scenario, folder,
                            False, domain, listed(load(scenario), headless=False), new_run())
    meter, deadline, due = Meter(), time.monotonic() + PATIENCE_S, 0
    try:
        while not supervisor.ended:
            supervisor.poll()
            if (step := supervisor.pulse.flown) >= due:
                meter.note(step, supervisor.pids)
                due = step + STRIDE
            _in_time(deadline)
            time.sleep(LOOK_S)
    finally:
        supervisor.stop()
    for name, code in supervisor.failures().items():
        raise Unheard(f'{name} ended with code {code}: {supervisor.last_words(name)}')
    return meter


def _in_time(deadline: float) -> None:
    if time.monotonic() > deadline:
        raise BadInput(f'a measured flight did not end in {PATIENCE_S:g} s')


def sent(folder: Path, roster: Roster) -> dict[str, str]:
    """Return, as hex, the longest message that the bag of a run has of each stepped topic."""
    wanted = {topic for name in roster.names for topic in roster.emits(name)}
    longest: dict[str, bytes] = {}
    for file in files_of(folder):
        for stored in MessageFile(file, wanted):
            if len(stored.data) > len(longest.get(stored.topic, b'')):
                longest[stored.topic] = stored.data
    return {topic: data.hex() for topic, data in longest.items()}


def fly_bare(scenario: Path, steps: int, roster: Roster, messages: Path, domain: int) -> Meter:
    """Run the hollow graph of the same nodes for as many steps."""
    environment = {**os.environ, 'ROS_DOMAIN_ID': str(domain)}
    observer = Observer(domain)
    processes = {name: subprocess.Popen(
        [sys.executable, '-m', 'rvd_campaign.bench.bare', name, str(scenario), str(steps),
         str(messages)], env=environment, stdin=subprocess.DEVNULL) for name in roster.names}
    try:
        return observer.follow(lambda: any(p.poll() is not None for p in processes.values()),
                               lambda: {name: p.pid for name, p in processes.items()})
    finally:
        observer.close()
        for process in processes.values():
            try:
                process.wait(5.0)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()


def fly_before(checkout: Checkout, scenario: Path, folder: Path, domain: int) -> Meter:
    """Fly a scenario with another checkout's own bring-up; return the notes."""
    observer = Observer(domain)
    flight = BringUp(checkout, scenario, folder, domain)
    try:
        meter = observer.follow(flight.ended, flight.pids)
    except BaseException:                       # Ctrl-C, too
        with suppress(BadInput):
            flight.stop()
        raise
    finally:
        observer.close()
    try:
        flight.stop()
    except BadInput as error:                   # a node hung as it left, or the checkout is wrong
        raise Unheard(str(error)) from None
    return meter


def measure(repeats: int = 5, name: str = SCENARIO, before: Checkout | None = None
            ) -> dict[str, Any]:
    """
    Fly the real graph, the hollow one, and the real one in fewer processes, turn about.

    With `before`, fly the same scenario with that checkout, too, in between.

    Raises
    ------
    ValueError
        If a flight does not come to its end.
    """
    base = lockstep(load(catalogue.find('scenarios', name, ('.yaml',))))
    roster = listed(base, headless=False)
    ours, bare = [], []
    fewer: dict[str, list[dict]] = {processes: [] for processes in MIN_SPEED}
    others: list[dict] = []
    with tempfile.TemporaryDirectory(prefix='rvd-bench-') as top, reserved_domain() as domain:
        paths = {}
        for processes in ('blocks', *fewer):
            paths[processes] = Path(top) / f'{processes}.yaml'
            paths[processes].write_text(base.with_values('/**', processes=processes).dump(),
                                        encoding='utf-8')
        messages = Path(top) / 'messages.json'
        if before is not None:
            paths['before'] = Path(top) / 'before.yaml'
            paths['before'].write_text(before.scenario(name, **LOCKSTEP), encoding='utf-8')
        for repeat in range(repeats):
            made, last, folder = heard(lambda attempt: _flown(
                paths['blocks'], Path(top) / f'run{repeat}.{attempt}', domain))
            messages.write_text(json.dumps(sent(folder, roster)), encoding='utf-8')
            ours.append(made)
            bare.append(heard(lambda _: fly_bare(
                paths['blocks'], last, roster, messages, domain).result(LEAST_STEPS['bare'])))
            if before is not None:
                others.append(heard(lambda attempt: fly_before(
                    before, paths['before'], folder / f'before{attempt}', domain).result(
                        LEAST_STEPS['blocks'])))
            for processes, flown in fewer.items():
                flown.append(heard(lambda attempt: fly_ours(
                    paths[processes], folder / f'{processes}{attempt}', domain).result(
                        LEAST_STEPS[processes])))
    speed = median(o['steps_per_s'] for o in ours)
    compared = {} if before is None else {
        'before': others, 'cpu_of_before': round(median(
            cost(o) / cost(b) for o, b in zip(ours, others)), 3)}
    return {**compared, 'scenario': name, 'nodes': list(roster.names),
            'ours': ours, 'bare': bare, **fewer,
            'cpu_ratio': median(cost(o) / cost(b) for o, b in zip(ours, bare)),
            'steps_per_s': speed,
            'steps_per_s_possible':
                1e6 * len(os.sched_getaffinity(0)) / median(cost(o) for o in ours),
            'times_blocks': {
                processes: round(median(
                    f['steps_per_s'] / o['steps_per_s'] for f, o in zip(flown, ours)), 2)
                for processes, flown in fewer.items()},
            'step_s': base.run.step_s}


def _flown(scenario: Path, folder: Path, domain: int) -> tuple[dict, int, Path]:
    meter = fly_ours(scenario, folder, domain)
    return meter.result(LEAST_STEPS['blocks']), meter.steps[-1], folder


def heard(fly: Callable[[int], Any]) -> Any:
    """
    Return what `fly(attempt)` returns, again where the flight could not be measured.

    The observer may find the nodes too late; and of some hundred processes one hangs in Fast DDS
    when it leaves, for some seconds (see `lifeline.leaving`).
    """
    for attempt in range(ATTEMPTS - 1):
        try:
            return fly(attempt)
        except Unheard:
            continue
    return fly(ATTEMPTS - 1)


def cost(result: dict) -> float:
    """Return the CPU time per step of one flight [us]."""
    return result['cpu_us_per_step']


def lockstep(scenario: Scenario) -> Scenario:
    """Return the scenario as fast as it goes, with the pilot that needs no hand."""
    return scenario.with_values('/**', **LOCKSTEP)
