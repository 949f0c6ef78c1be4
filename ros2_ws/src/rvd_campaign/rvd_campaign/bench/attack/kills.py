"""
Signals to the processes of a flight: the victim is named, nothing is left, the bag can be read.

Node, recorder, monitor or bring-up; SIGKILL, SIGSTOP, SIGTERM or SIGINT; at any time, while the
graph starts or in flight; each form of processes; lock step or real time. A signal that came when
the flight was over is sent again, sooner, in another flight.
"""

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from random import Random
import re
import signal
import tempfile
from typing import NamedTuple

from rvd_campaign import catalogue
from rvd_campaign.bench.attack import Case, Kind, Outcome
from rvd_campaign.bench.attack.flights import last_line
from rvd_campaign.bench.attack.flying import Flying, send
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.diagram import GROUPINGS
from rvd_dynamics.diagram.roster import listed, MONITOR, RECORDER
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_dynamics.recording.reader import read

SCENARIO = 'paper'
SIGNALS = ('SIGKILL', 'SIGSTOP', 'SIGTERM', 'SIGINT')
PACES = ('lockstep', '20')      # 20 times real time: 10 s of flight
STARTED_S = 120.0               # [s] wall time in which a process has started, or the flight begun
LIMIT_S = 120.0                 # [s] wall time in which `fly` has ended after the signal
BRINGUP = 'bringup'
TRIES = 6                       # of a signal that comes too late


class Plan(NamedTuple):
    """What is done to a flight."""

    processes: str
    pace: str
    victim: str                 # process
    number: signal.Signals
    in_flight: bool             # else while the graph starts
    after_s: float              # [s] wall time after the process has started, or the flight begun

    def __str__(self) -> str:
        when = 'flight' if self.in_flight else 'start'
        return (f'{self.number.name} to {self.victim} ({self.processes}, {self.pace}) '
                f'{self.after_s:.1f} s into the {when}')


def attack() -> Kind:
    """Return this kind."""
    return Kind('kills', 'signals to the processes of a flight, each form of processes', 'flights',
                200, 3, _open, all=('victim named, or unharmed', 'bag readable'),
                zero=('orphans', 'not ended by itself'))


@contextmanager
def _open(keep: Path) -> Iterator[Case]:
    scenario = load(catalogue.find('scenarios', SCENARIO, ('.yaml',)))
    with tempfile.TemporaryDirectory(prefix='rvd-attack-') as top:
        yield lambda seed: one(scenario, seed, Path(top), keep)


def planned(scenario: Scenario, seed: int) -> Plan:
    """Return what a seed means."""
    rng = Random(seed)
    form, pace = rng.choice(GROUPINGS), rng.choice(PACES)
    names = [process.name for process in _roster(scenario, form).processes]
    homes = _roster(scenario, form).process_of
    victim = rng.choice((*names, BRINGUP, homes[RECORDER], homes[MONITOR]))
    in_flight = rng.random() < 0.75
    most = (2.0 if pace == 'lockstep' else 8.0) if in_flight else 3.0
    return Plan(form, pace, victim, signal.Signals[rng.choice(SIGNALS)], in_flight,
                rng.uniform(0.0, most))


def _roster(scenario: Scenario, form: str):
    return listed(scenario.with_values('/**', processes=form), headless=True)


def one(scenario: Scenario, seed: int, top: Path, keep: Path) -> Outcome:
    """Fly, send the signal, and see what is said and left."""
    plan = planned(scenario, seed)
    for attempt in range(TRIES):
        outcome = _flown(scenario, plan._replace(after_s=plan.after_s / 2**attempt), seed,
                         top / f'{seed}-{attempt}', keep)
        if outcome is not None:
            return outcome
    return Outcome(failures=[f'{plan}: the flight was over each time'])


def _flown(scenario: Scenario, plan: Plan, seed: int, folder: Path, keep: Path
           ) -> Outcome | None:
    """Return what came of a flight; None if the signal came when it was over."""
    outcome = Outcome()
    with Flying(folder, SCENARIO, '--pace', plan.pace, '--processes', plan.processes
                ) as flying:
        ignored = _sent(flying, plan)
        if ignored is None:
            return None
        code = flying.wait(LIMIT_S)
        said = flying.said()
        named = _names(scenario, plan, said)
        if code in (0, 1) and not named and not ignored:
            return None                         # it was over
        bad = []
        if code is None:
            bad.append('no end')
            outcome.counts['not ended by itself'] += 1
        if named or ignored and code in (0, 1):
            outcome.counts['victim named, or unharmed'] += 1
            outcome.counts['  of which unharmed: it ignores the signal'] += not named
        else:
            bad.append(f'not named: {last_line(said)}')
        left = flying.orphans() if code is not None else []
        outcome.counts['orphans'] += len(left)
        bad += [f'left: {one}' for one in left]
        trouble = _of_the_bag(flying.run, plan.in_flight)
        if trouble:
            bad.append(trouble)
        else:
            outcome.counts['bag readable'] += 1
        outcome.counts[f'exit code {code}'] += 1
        if bad:
            place = flying.kept(keep / f'attack-kills-{seed}')
            outcome.failures.append(f'{plan}: {"; ".join(bad)} (kept in {place})')
    return outcome


def _sent(flying: Flying, plan: Plan) -> bool | None:
    """
    Wait for the moment and send the signal; say whether it is ignored.

    None if there was nobody to get it. A shell starts what it starts in the background with a
    SIGINT that is ignored: a Ctrl-C is for `fly` alone.
    """
    pid = flying.until(lambda: _pid(flying, plan.victim), STARTED_S)
    if pid is None:
        return None
    if plan.in_flight and not flying.until(flying.flies, STARTED_S):
        return None
    flying.until(lambda: False, plan.after_s)
    if flying.process.poll() is not None or _pid(flying, plan.victim) != pid:
        return None
    ignored = _ignores(pid, plan.number)
    return ignored if send(pid, plan.number) else None


def _ignores(pid: int, number: int) -> bool:
    try:
        status = Path(f'/proc/{pid}/status').read_text(encoding='ascii', errors='replace')
    except OSError:
        return False
    masks = [line.split()[1] for line in status.splitlines() if line.startswith('SigIgn:')]
    return int(masks[0] if masks else '0', 16) >> number - 1 & 1 == 1


def _pid(flying: Flying, name: str) -> int | None:
    """Return the process of that name: a node's, a group's, or the bring-up's first one."""
    for pid, words in sorted(flying.pids().items()):
        is_it = any(word.endswith('/bringup.sh') for word in words[:3]) if name == BRINGUP else (
            {f'__node:={name}', f'group:={name}'} & set(words) and 'python' in words[0])
        if is_it:
            return pid
    return None


def _names(scenario: Scenario, plan: Plan, said: str) -> bool:
    """Say whether a line of `fly` names the victim: the process, or a node in it."""
    if plan.victim == BRINGUP:
        names = ('bringup', 'bring-up')
    else:
        roster = _roster(scenario, plan.processes)
        names = next(p.nodes for p in roster.processes if p.name == plan.victim)
        names = (*names, plan.victim)
    lines = [line for line in said.splitlines() if not line.startswith(f'{SCENARIO}: ')]
    return any(re.search(rf'(?<![\w-]){re.escape(name)}(?![\w-])', line)
               for line in lines for name in names)


def _of_the_bag(run: Path, flew: bool) -> str:
    """Return what is wrong with the bag; a run that never `flew` may have an empty one, or none."""
    if not any((run / 'bag').glob('*')):
        return 'bag: there is none' if flew else ''
    size = max(file.stat().st_size for file in (run / 'bag').glob('*'))
    try:
        recording = read(run)
        if flew and recording.last_step < 0:
            return f'bag: no step can be read of {size} bytes'
    except BadInput as error:
        return f'bag: {error}' if size or flew else ''      # begun and nothing said yet
    except Exception as error:                  # noqa: B902 - any is a fault of the reader
        return f'bag: {type(error).__name__}: {error}'
    return ''
