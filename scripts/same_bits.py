#!/usr/bin/env python3
"""
Show that results are those of another commit, bit for bit, on this machine.

    ./rvd shell python scripts/same_bits.py                     every campaign of the commit, whole
    ./rvd shell python scripts/same_bits.py table3 --runs 200   one of them, shortened

Sets up a git worktree of the commit, then flies with both trees' own `./rvd`: first a few
scenarios in process, of which every step is compared, then the campaigns, of which every column
of results.parquet is. Values are compared as they are decoded, with their type and in their
order: NaN equals NaN, and nothing else is forgiven, -0.0 for 0.0 neither.

Exit codes: 0 all is the same, 1 something differs, 2 could not compare, 130 Ctrl-C.
"""

import argparse
import json
import os
import shutil
import signal
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import NamedTuple

import numpy as np
import pyarrow
import pyarrow.parquet
from numpy.typing import NDArray

ROOT = Path(__file__).resolve().parents[1]
COMMIT = 'f472391'                      # the last one before the diagram
RENAMED: dict[str, str] = {}            # column of the commit: what it is called now
SCENARIOS = ('paper', 'rough_link', 'two_body', 'hand', 'barrier')
SEEDS = (1, 2)
AS_THEN = {                             # what has other defaults since the commit: its own
    'state_predictor': {'in_flight': 'as_sent', 'filter': 'scheduled', 'prior': 'kalman'},
    'spacecraft_dynamics': {'execution_noise_per': 'step'}}
MATTERS = ('numpy', 'scipy')            # packages whose version may change a last bit
SHOW_S, LOG_S = 0.2, 15.0               # [s] between two looks at a terminal, two lines in a log
STOPS = (signal.SIGINT, signal.SIGTERM)
STOP_S = 30.0                           # [s] a process may take to stop after Ctrl-C


class CannotCompare(Exception):
    """There is nothing to compare; the text is the one line that says why."""


class Tree(NamedTuple):
    """A set-up checkout of the project."""

    name: str                           # before or now
    root: Path

    def command(self, *arguments: str | Path) -> list[str]:
        """Return a call of this tree's `./rvd`."""
        return [str(self.root / 'rvd'), *map(str, arguments)]


# -- what is flown ---------------------------------------------------------------------------

def flown_before(scenario: Path, seed: int) -> dict[str, NDArray]:
    """Return truth and thrust of every step of run 0 as the commit flies it, shapes (steps, n)."""
    from rvd_campaign.loop import fly
    from rvd_campaign.scenario import load
    settings = load(scenario).with_values('/**', seed=seed).loop()
    history = fly(settings, [0], record=True).history
    return {'truth': history.truth[:, 0], 'acceleration': history.acceleration[:, 0],
            'executed': history.executed[:, 0]}


def flown_now(scenario: Path, seed: int) -> dict[str, NDArray]:
    """Return the same as `flown_before`, as this tree flies it."""
    from rvd_dynamics.diagram.in_process import fly
    from rvd_dynamics.diagram.scenario import load
    read = load(scenario).with_values('/**', seed=seed)
    for section, values in AS_THEN.items():
        read = read.with_values(section, **values)
    truth, thrust = read.diagram.truth.name, read.diagram.thrust
    history = fly(read, [0], record=[truth, thrust]).history
    return {'truth': history[truth].state[:, 0],
            'acceleration': history[truth].acceleration[:, 0],
            'executed': history[thrust].command[:, 0]}


FLOWN = {'before': flown_before, 'now': flown_now}


def fly_scenarios(tree: str, root: Path, out: Path) -> None:
    """Fly the scenarios of a tree, whose Python this is, and save every array."""
    np.savez(out, **{f'{name} {seed} {signal}': values
                     for name in SCENARIOS for seed in SEEDS
                     for signal, values in FLOWN[tree](root / 'scenarios' / f'{name}.yaml',
                                                       seed).items()})


def fly_campaign(tree: Tree, file: Path, runs: int | None, out: Path, log: Path) -> None:
    """Fly the file of a campaign, or the rest of one that was begun in the folder."""
    name = file.stem
    arguments = [file, '--resume' if (out / 'campaign.json').exists() else '--out', out]
    arguments += ['--runs', runs] if runs else []
    run(f'{name}, {tree.name}', tree.command('campaign', *arguments), log)


# -- comparing -------------------------------------------------------------------------------

def unequal(before: NDArray, now: NDArray) -> NDArray[np.bool_]:
    """Say which elements of two arrays of one shape and type differ in any bit; NaN is NaN."""
    if before.dtype.kind != 'f':
        return np.asarray(before != now, dtype=bool)
    bits = f'u{before.dtype.itemsize}'
    differs = np.ascontiguousarray(before).view(bits) != np.ascontiguousarray(now).view(bits)
    return differs & ~(np.isnan(before) & np.isnan(now))


def array_difference(before: NDArray, now: NDArray) -> str:
    """Return how two arrays of shape (steps, n) differ, or nothing."""
    if before.dtype != now.dtype or before.shape != now.shape:
        return f'{before.dtype} {before.shape}, now {now.dtype} {now.shape}'
    rows = np.flatnonzero(unequal(before, now).any(axis=1))
    if not rows.size:
        return ''
    first = rows[0]
    return (f'{rows.size:,} of {len(before):,} steps differ, first step {first}: '
            f'{before[first].tolist()}, now {now[first].tolist()}')


def column_difference(before: pyarrow.ChunkedArray, now: pyarrow.ChunkedArray,
                      row_name: list[str]) -> str:
    """Return how two columns with the same number of rows differ, or nothing."""
    if before.type != now.type:
        return f'type {before.type}, now {now.type}'
    a, b = decoded(before), decoded(now)
    missing = [np.asarray(column.is_null().to_numpy()) for column in (before, now)]
    rows = np.flatnonzero(unequal(a, b) | (missing[0] != missing[1]))
    if not rows.size:
        return ''
    first = int(rows[0])
    return (f'{rows.size:,} of {len(a):,} rows differ, first {row_name[first]}: '
            f'{before[first].as_py()!r}, now {now[first].as_py()!r}')


def decoded(column: pyarrow.ChunkedArray) -> NDArray:
    """Return the values of a column, text as objects."""
    if pyarrow.types.is_dictionary(column.type):
        column = column.cast(column.type.value_type)
    if pyarrow.types.is_string(column.type):
        return np.asarray(column.to_pylist(), dtype=object)
    return column.to_numpy()


def compare_flights(before: Path, now: Path) -> bool:
    """Print how the arrays of flown scenarios compare; say whether all are the same."""
    same = True
    with np.load(before) as old, np.load(now) as new:
        for name in SCENARIOS:
            for seed in SEEDS:
                print(f'scenario {name}, seed {seed}:', flush=True)
                for key in (key for key in old if key.startswith(f'{name} {seed} ')):
                    difference = array_difference(old[key], new[key])
                    say(key.split()[-1], difference)
                    same &= not difference
    return same


def compare_results(name: str, before: Path, now: Path) -> bool:
    """Print how the results of a campaign compare; say whether all columns are the same."""
    old, new = (pyarrow.parquet.read_table(folder / 'results.parquet') for folder in (before, now))
    hashes = [json.loads((folder / 'summary.json').read_text(encoding='utf-8'))['result_hash']
              for folder in (before, now)]
    print(f'campaign {name}, {old.num_rows:,} rows:', flush=True)
    print(f'  result hash {hashes[0]}\n          now {hashes[1]}')
    if old.num_rows != new.num_rows:
        print(f'  {old.num_rows:,} rows, now {new.num_rows:,}')
        return False
    row_name = [f'{condition}, run {number}' for condition, number in
                zip(old['condition'].to_pylist(), old['run'].to_pylist())]
    same, taken = True, set()
    for column in old.column_names:
        called = RENAMED.get(column, column)
        taken.add(called)
        difference = (column_difference(old[column], new[called], row_name)
                      if called in new.column_names else 'not there any more')
        say(column if called == column else f'{column}, now {called}', difference)
        same &= not difference
    for column in new.column_names:
        if column not in taken:
            print(f'  {column:<24} new')
    return same


def say(what: str, difference: str) -> None:
    """Print one line of a comparison."""
    print(f'  {what:<24} {difference or "same"}', flush=True)


# -- the two trees ---------------------------------------------------------------------------

def git(*arguments: str | Path, root: Path = ROOT) -> str:
    """Return what git prints, or refuse with the last line of what it complains about."""
    done = subprocess.run(['git', '-C', root, *arguments], capture_output=True, text=True,
                          check=False)
    if done.returncode:
        complaint = done.stderr.strip().splitlines() or [f'exit code {done.returncode}']
        raise CannotCompare(f'git {" ".join(map(str, arguments))}: {complaint[-1]}')
    return done.stdout.strip()


@contextmanager
def tree_of(commit: str, given: str | None, kept: str | None, scratch: Path) -> Iterator[Tree]:
    """Yield the worktree of a commit: the given one, the kept one, or one for this run only."""
    wanted = git('rev-parse', '--verify', f'{commit}^{{commit}}')
    root = Path(given or kept or scratch / 'before').resolve()
    if given or (kept and root.exists()):
        check_tree(root, commit, wanted)
        yield Tree('before', root)
        return
    try:
        git('worktree', 'add', '--detach', root, wanted)
        yield Tree('before', root)
    finally:
        ignore_stops()
        if not kept:
            subprocess.run(['git', '-C', ROOT, 'worktree', 'remove', '--force', root],
                           capture_output=True, check=False)


def check_tree(root: Path, commit: str, wanted: str) -> None:
    """Refuse a folder that is not an untouched checkout of the commit."""
    if not (root / 'rvd').is_file():
        raise CannotCompare(f'{root} is no checkout of the project: give one, or leave it out')
    here = git('rev-parse', 'HEAD', root=root)
    if here != wanted:
        raise CannotCompare(f'{root} holds commit {here[:7]}, not {commit}: check that out there, '
                            f'or give --commit {here[:7]}')
    changed = git('status', '--porcelain', '--untracked-files=no', root=root)
    if changed:
        raise CannotCompare(f'{root} has changes that are not in commit {commit}: '
                            f'{changed.splitlines()[0].strip()}')


def check_versions(trees: list[Tree], log: Path) -> None:
    """Refuse to compare what two versions of a package computed."""
    code = ('import importlib.metadata as m, sys; print("versions", sys.version.split()[0], '
            f'*(m.version(name) for name in {MATTERS}))')
    found = []
    for tree in trees:
        run(f'versions, {tree.name}', tree.command('shell', 'python', '-c', code), log)
        found.append(log.read_text(encoding='utf-8').rpartition('versions ')[2].split())
        print(f'{tree.name}: {tree.root}, Python {found[-1][0]}, ' + ', '.join(
            f'{name} {version}' for name, version in zip(MATTERS, found[-1][1:])), flush=True)
    for name, before, now in zip(MATTERS, found[0][1:], found[1][1:]):
        if before != now:
            raise CannotCompare(f'{name} is {before} in {trees[0].root} and {now} here: last bits '
                                'depend on it; set both up with one version')


# -- processes -------------------------------------------------------------------------------

def run(label: str, command: list[str], log: Path) -> None:
    """
    Run a command to its end and show on stderr what it says last.

    Its group of processes is its own, so that Ctrl-C reaches it through us, once.

    Raises
    ------
    CannotCompare
        If it fails.
    """
    begun = shown = time.monotonic()
    live = sys.stderr.isatty()
    with log.open('wb') as out:
        process = subprocess.Popen(command, stdin=subprocess.DEVNULL, stdout=out,
                                   stderr=subprocess.STDOUT, start_new_session=True)
    try:
        while True:
            try:
                process.wait(SHOW_S)
                break
            except subprocess.TimeoutExpired:
                now = time.monotonic()
                if now - shown >= (SHOW_S if live else LOG_S):
                    shown = now
                    width = shutil.get_terminal_size().columns - 1
                    line = f'{label}: {now - begun:.0f} s  {last_line(log)}'[:width]
                    print(f'\r\x1b[K{line}' if live else line, end='' if live else '\n',
                          file=sys.stderr, flush=True)
    finally:
        if process.poll() is None:
            stop(process)
        if live:
            print('\r\x1b[K', end='', file=sys.stderr, flush=True)
    if process.returncode:
        raise CannotCompare(f'{label}: exit code {process.returncode}: {last_line(log)}')


def stop(process: subprocess.Popen) -> None:
    """End a process and its children, with force if they take their time."""
    try:
        os.killpg(process.pid, signal.SIGINT)
        process.wait(STOP_S)
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        process.wait()


def last_line(log: Path) -> str:
    """Return the last line of a log that says something."""
    text = log.read_bytes()[-2000:].decode(errors='replace').replace('\r', '\n')
    return next((line.strip() for line in reversed(text.splitlines()) if line.strip()), '')


@contextmanager
def scratch_folder() -> Iterator[Path]:
    """Yield a folder that is gone afterwards."""
    folder = Path(tempfile.mkdtemp(prefix='same_bits-'))
    try:
        yield folder
    finally:
        ignore_stops()
        shutil.rmtree(folder, ignore_errors=True)


def take_stops() -> None:
    """Stop at the first Ctrl-C or SIGTERM; further ones do not disturb the clearing up."""
    def leave(*_: object) -> None:
        ignore_stops()
        raise KeyboardInterrupt
    for number in STOPS:
        signal.signal(number, leave)


def ignore_stops() -> None:
    """Let nothing interrupt what we do last."""
    for number in STOPS:
        signal.signal(number, signal.SIG_IGN)


# -- the command -----------------------------------------------------------------------------

class Parser(argparse.ArgumentParser):
    """Says what is wrong in one line."""

    def error(self, message: str) -> None:
        """Print one line and exit with code 2."""
        self.exit(2, f'{self.prog}: {message} (see {self.prog} --help)\n')


def parser() -> Parser:
    """Return the parser of the command line."""
    made = Parser(prog='same_bits', description='Show that this tree flies scenarios and campaigns '
                  'as another commit does, bit for bit, on this machine and with one numpy.',
                  epilog='Exit codes: 0 all is the same, 1 something differs, 2 could not compare, '
                         '130 Ctrl-C.')
    made.add_argument('campaigns', nargs='*', metavar='CAMPAIGN',
                      help='campaigns of the commit, as its files have them (default: all)')
    made.add_argument('--runs', type=int, metavar='N',
                      help='runs of each condition (default: those of the campaign)')
    made.add_argument('--commit', default=COMMIT, metavar='COMMIT',
                      help=f'what to compare with (default: {COMMIT})')
    place = made.add_mutually_exclusive_group()
    place.add_argument('--before', metavar='FOLDER', help='a worktree of the commit that is there')
    place.add_argument('--keep', metavar='FOLDER',
                       help='make the worktree of the commit here, or use it where it is there, '
                            'and keep it (default: a temporary one)')
    made.add_argument('--results', metavar='FOLDER',
                      help='keep what the commit flies in this folder, and fly nothing again that '
                           'is there (default: a temporary one)')
    made.add_argument('--fly-scenarios', nargs=3, metavar=('TREE', 'ROOT', 'FILE'),
                      help=argparse.SUPPRESS)           # what `compare` asks of either Python
    return made


def shipped(names: list[str], root: Path) -> list[str]:
    """Return the campaigns of the commit to fly: those named, or all."""
    known = sorted(path.stem for path in (root / 'campaigns').glob('*.yaml'))
    for name in names:
        if name not in known:
            raise CannotCompare(f'the commit has no campaign {name}: it has {", ".join(known)}')
    return list(dict.fromkeys(names)) or known


def compare(args: argparse.Namespace) -> int:
    """Fly and compare as the command line asks; return the exit code."""
    if args.runs is not None and args.runs < 1:
        raise CannotCompare(f'--runs must be at least 1, got {args.runs}')
    take_stops()
    with scratch_folder() as scratch, \
            tree_of(args.commit, args.before, args.keep, scratch) as before:
        names = shipped(args.campaigns, before.root)
        log, now = scratch / 'log', Tree('now', ROOT)
        run('setting up the commit', before.command('setup'), log)
        check_versions([before, now], log)
        saved = {tree: scratch / f'{tree.name}.npz' for tree in (before, now)}
        for tree, path in saved.items():
            run(f'scenarios, {tree.name}', tree.command(
                'shell', 'python', Path(__file__).resolve(), '--fly-scenarios', tree.name,
                tree.root, path), log)
        same = compare_flights(*saved.values())
        kept = Path(args.results).resolve() if args.results else scratch / 'results'
        kept.mkdir(parents=True, exist_ok=True)
        for name in names:
            file = before.root / 'campaigns' / f'{name}.yaml'       # seeds have changed since
            flown = {before: kept / (f'{name}-{args.runs}' if args.runs else name),
                     now: scratch / f'{name}-now'}
            for tree, folder in flown.items():
                fly_campaign(tree, file, args.runs, folder, log)
            same &= compare_results(name, *flown.values())
            shutil.rmtree(flown[now])
    print(f'all as commit {args.commit}' if same else f'not all as commit {args.commit}')
    return 0 if same else 1


def main() -> int:
    """Run the command line; return the exit code."""
    args = parser().parse_args()
    try:
        if args.fly_scenarios:
            tree, root, out = args.fly_scenarios
            fly_scenarios(tree, Path(root), Path(out))
            return 0
        return compare(args)
    except CannotCompare as error:
        print(f'same_bits: {error}', file=sys.stderr)
        return 2
    except OSError as error:
        print(f'same_bits: {error.filename or ""}: {error.strerror}', file=sys.stderr)
        return 2
    except KeyboardInterrupt:
        return 130


if __name__ == '__main__':
    sys.exit(main())
