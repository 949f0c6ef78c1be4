"""
A stranger's frames over DDS into a flight in progress: no node ends of them, none is obeyed.

Real processes: `fly`, and beside it a publisher (`publisher.py`) in the same domain that writes on
every topic of frames, and mutated messages on the others of the ring. A second writer ends the
flight, as it should, so a case is one flight, and as many messages as reach it until then.
"""

from collections.abc import Collection, Iterator
from contextlib import contextmanager
import os
from pathlib import Path
import re
import subprocess
import sys
import tempfile
from typing import Any

from rvd_campaign import catalogue
from rvd_campaign.bench.attack import Case, Kind, Outcome
from rvd_campaign.bench.attack.flights import last_line
from rvd_campaign.bench.attack.flying import Flying
from rvd_campaign.flight.domain import reserved_domain
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.diagram import GROUPINGS
from rvd_dynamics.diagram.roster import listed
from rvd_dynamics.diagram.scenario import load

SCENARIO = 'paper'
PACES = ('lockstep', '10')
EACH = 10_000                   # messages that are sent at most in a case
BEGUN_S = 120.0                 # [s] wall time in which the flight has begun
SENT_S = 90.0                   # [s] wall time for the publisher
TRIES = 4                       # of a flight that is over too soon
LIMIT_S = 120.0                 # [s] wall time in which `fly` has ended
# What `fly` says of a node that ended by itself: how, or what it complained of last.
ENDED = re.compile(r'^(\S+) (?:ended with code \d+|was ended by signal \d+)|^(\w+): ')


def attack() -> Kind:
    """Return this kind."""
    return Kind('dds', 'frames and messages of a stranger over DDS into a flight', 'messages',
                100_000, 2000, _open, EACH,
                zero=('nodes ended', 'accepted', 'no end', 'orphans'))


@contextmanager
def _open(keep: Path) -> Iterator[Case]:
    scenario = load(catalogue.find('scenarios', SCENARIO, ('.yaml',)))
    names = {name for form in GROUPINGS for process in listed(
        scenario.with_values('/**', processes=form), headless=True).processes
        for name in (process.name, *process.nodes)}
    forward = scenario.part('leg_params').on(scenario.run).forward
    with tempfile.TemporaryDirectory(prefix='rvd-attack-') as top:
        yield lambda seed: one(seed, Path(top) / f'{seed}', keep, names, forward)


def one(seed: int, folder: Path, keep: Path, names: Collection[str], forward: int) -> Outcome:
    """Attack one flight; another one where it was over before the stranger had come."""
    for attempt in range(TRIES - 1):
        outcome = _flown(seed, folder / f'{attempt}', keep, names, forward)
        if outcome.attacked:
            return outcome
    outcome = _flown(seed, folder / f'{TRIES}', keep, names, forward)
    if not outcome.attacked:
        outcome.failures.append('nothing reached it')
        outcome.attacked = EACH
    return outcome


def _flown(seed: int, folder: Path, keep: Path, names: Collection[str], forward: int
           ) -> Outcome:
    outcome = Outcome(attacked=0)
    form, pace = GROUPINGS[seed % len(GROUPINGS)], PACES[seed // len(GROUPINGS) % len(PACES)]
    with reserved_domain() as domain:           # free a moment ago: `fly` takes it, or says why not
        number = int(domain)
    with Flying(folder, SCENARIO, '--pace', pace, '--processes', form, domain=number
                ) as flying, _stranger(number, seed, folder) as stranger:
        if not flying.until(flying.flies, BEGUN_S):
            outcome.failures.append(f'{form}, {pace}: the flight did not begin: '
                                    f'{last_line(flying.said())}')
            return outcome
        outcome.attacked = _sent(stranger)
        code = flying.wait(LIMIT_S)
        outcome.counts[f'exit code {code}'] += 1
        bad = [] if code is not None else ['no end']
        outcome.counts['no end'] += code is None
        ended = ended_nodes(flying.said(), names)
        ended += [f'{name} has a traceback' for name, text in flying.logs().items()
                  if 'Traceback (most recent call last)' in text]
        outcome.counts['nodes ended'] += len(ended)
        obeyed = _obeyed(flying.run, forward)
        outcome.counts['accepted'] += len(obeyed)
        left = flying.orphans() if code is not None else []
        outcome.counts['orphans'] += len(left)
        bad += [*ended, *obeyed, *(f'left: {one}' for one in left)]
        if bad:
            place = flying.kept(keep / f'attack-dds-{seed}')
            outcome.failures.append(f'{form}, {pace}: {"; ".join(bad)} (kept in {place})')
    return outcome


def ended_nodes(said: str, names: Collection[str]) -> list[str]:
    """Return the parts of what `fly` says in the end that tell of one of these as ended."""
    return [part for line in said.splitlines() if line.startswith('rvd fly: ')
            for part in line.removeprefix('rvd fly: ').removeprefix('after the flight ').split('; ')
            if (found := ENDED.match(part)) and (found[1] or found[2]) in names]


@contextmanager
def _stranger(domain: int, seed: int, folder: Path) -> Iterator[subprocess.Popen]:
    """Start the publisher: it comes into the domain when it is told."""
    path = catalogue.find('scenarios', SCENARIO, ('.yaml',))
    stranger = subprocess.Popen(
        [sys.executable, '-m', 'rvd_campaign.bench.attack.publisher', str(path), str(seed),
         str(EACH)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL,
        text=True, cwd=folder, env={**os.environ, 'ROS_DOMAIN_ID': str(domain)})
    try:
        yield stranger
    finally:
        stranger.kill()
        stranger.wait()


def _sent(stranger: subprocess.Popen) -> int:
    """Let the publisher write into the flight; return how many messages it has sent."""
    try:
        out, _ = stranger.communicate('go\n', timeout=SENT_S)
    except subprocess.TimeoutExpired:
        return 0
    words = out.split()
    return int(words[-1]) if words and words[-1].isdigit() else 0


def _obeyed(run: Path, forward: int) -> list[str]:
    """Return what the guard accepted in the bag and the ground never sent; it came `forward`."""
    from rvd_dynamics.recording.reader import read
    try:
        series = read(run).series
        ground, thrust = series['/ground/command'], series['/onboard/thruster_command']
    except (BadInput, LookupError):
        return []
    return unsent(ground, thrust, forward)


def unsent(ground: Any, thrust: Any, forward: int) -> list[str]:
    """
    Return the commands of the thrusters that the ground did not send `forward` steps before.

    The stranger writes no command of the ground on `/ground/command`: what stands there is its.
    The bag of a flight that was ended as not to be trusted may lack the last messages of a topic:
    a command is judged where the bag has what the ground sent in the step that was due.
    """
    known = {int(step) for step in ground.step}
    sent = {int(n): tuple(levels) for n, levels in zip(ground.sequence, ground.levels)}
    return [f'command {int(n)} {tuple(int(level) for level in levels)} was never sent'
            for step, n, levels, valid in zip(thrust.step, thrust.sequence, thrust.levels,
                                              thrust.valid)
            if valid and n > 0 and int(step) - forward in known
            and sent.get(int(n)) != tuple(levels)]
