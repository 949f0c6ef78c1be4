"""
`./rvd bench`: how fast it is, as figures that can be compared within one run.

The machine is whatever it is, so a figure is held against another one of the same minutes (the
graph against a hollow one) or has a wide margin. Nothing fails for being slow: the table says what
is met. A part is a module with `measure() -> dict` and a function here that makes rows of it.
"""

import argparse
import json
import time
from collections.abc import Callable
from pathlib import Path
from typing import NamedTuple

from rvd_campaign.bench import processes
from rvd_campaign.bench.before import Checkout, HOW
from rvd_campaign.exits import CannotRun, check_file
from rvd_dynamics.recording import whole


class Row(NamedTuple):
    """One line of the table; `met` is None where there is no target."""

    what: str
    figure: str
    target: str = ''
    met: bool | None = None


def main(args: argparse.Namespace) -> int:
    """Measure what is asked for, print the table, write the JSON; return the exit code."""
    if args.part == 'attack':                   # how much is held, not how fast
        from rvd_campaign.bench import attack
        return attack.main(args)
    if args.kinds or args.count is not None or args.seed is not None:
        raise CannotRun('kinds, --count and --seed go with `bench attack`')
    if args.out:
        check_file('--out', args.out, new=False)
    # only when asked for: the console's needs a browser, and a leak takes half an hour
    names = [args.part] if args.part != 'all' else [
        name for name in PARTS if name not in ('console', 'leak')]
    before = Checkout(Path(args.before)) if args.before else None
    content = {'machine': processes.machine(), 'time': time.strftime('%Y-%m-%dT%H:%M:%SZ',
                                                                     time.gmtime())}
    print(in_words(content['machine']), flush=True)
    if content['machine']['load_1_min'] > 0.3:
        print('other work is going on: ratios hold, times do not', flush=True)
    for name in names:
        measure, rows = PARTS[name]
        content[name] = measure(args.quick, before)
        print(f'\n{name}')
        for row in rows(content[name]):
            print(line(row._replace(met=None) if args.quick else row), flush=True)
    if args.quick:
        print('\nquick: too little was measured to hold against the targets')
    if args.out:
        whole.save(Path(args.out), json.dumps(content, indent=2) + '\n')
        print(f'\n{args.out}')
    return 0


def in_words(machine: dict) -> str:
    """Return the machine as one line."""
    return (f'{machine["cores"]} x {machine["cpu"]}, load {machine["load_1_min"]:.1f}, Python '
            f'{machine["python"]}, numpy {machine["numpy"]}, rclpy {machine["rclpy"]}')


def line(row: Row) -> str:
    """Return a row as it is printed."""
    verdict = {True: 'met', False: 'NOT met', None: ''}[row.met]
    return f'  {row.what:<58} {row.figure:>12}   {row.target:<16} {verdict}'.rstrip()


# -- the parts ----------------------------------------------------------------------------


def _graph(quick: bool, before: Checkout | None) -> dict:
    from rvd_campaign.bench import graph
    return graph.measure(1 if quick else 5, before=before)


def _graph_rows(r: dict) -> list[Row]:
    from rvd_campaign.bench.graph import (
        cost, MAX_CPU_OF_BEFORE, MAX_CPU_RATIO, MIN_SPEED, MIN_STEPS_PER_S)
    rows = [Row('CPU per step, of a hollow rclpy graph', f'{r["cpu_ratio"]:.2f}',
                f'<= {MAX_CPU_RATIO}', r['cpu_ratio'] <= MAX_CPU_RATIO),
            against('CPU per step, of the other checkout', r.get('cpu_of_before'),
                    f'<= {MAX_CPU_OF_BEFORE}', lambda ratio: ratio <= MAX_CPU_OF_BEFORE),
            Row('steps per second', f'{r["steps_per_s"]:.0f}', f'>= {MIN_STEPS_PER_S:g}',
                r['steps_per_s'] >= MIN_STEPS_PER_S),
            Row('  that the cores have CPU time for', f'{r["steps_per_s_possible"]:.0f}'),
            Row('times real time', f'{r["steps_per_s"] * r["step_s"]:.1f}'),
            *(Row(f'processes {name}: steps per second, of blocks', f'{times:.1f}',
                  f'>= {MIN_SPEED[name]:g}', times >= MIN_SPEED[name])
              for name, times in r['times_blocks'].items())]
    for name, flights in (('blocks', r['ours']), ('hollow', r['bare']),
                          ('before', r.get('before', ())),
                          *((name, r[name]) for name in MIN_SPEED)):
        rows += [Row(f'  {name} {i + 1}: {f["steps"]} steps at {f["steps_per_s"]:.0f}/s',
                     f'{cost(f) / 1000:.2f} ms/step') for i, f in enumerate(flights)]
    ours, hollow = r['ours'][-1]['by_node'], r['bare'][-1]['by_node']
    return rows + [Row(f'  {name}', f'{ours[name]:.0f} us', f'hollow {hollow[name]:.0f} us')
                   for name in sorted(ours, key=ours.get, reverse=True)]


def _flight(quick: bool, _: Checkout | None) -> dict:
    from rvd_campaign.bench import flight
    return flight.measure(repeats=1 if quick else 3)


def _flight_rows(r: dict) -> list[Row]:
    from rvd_campaign.bench.flight import PARTS as parts
    rows = []
    for timed in (r, r['one']):
        middle = sorted(timed['flights'], key=lambda f: f['wall_s'])[len(timed['flights']) // 2]
        rows += [Row(timed['command'], f'{timed["wall_s"]:.2f} s', f'< {timed["limit_s"]:g} s',
                     timed['wall_s'] < timed['limit_s']),
                 *(Row(f'  {words}', f'{middle[key]:.2f} s') for key, words in parts.items())]
    return rows


def _loop(quick: bool, _: Checkout | None) -> dict:
    from rvd_campaign.bench import loop
    return loop.measure(batch=50 if quick else loop.BATCH)


def _loop_rows(r: dict) -> list[Row]:
    from rvd_campaign.bench.loop import MAX_ALONE_S, MAX_SCENARIO_MS
    return [Row(f'one run of {r["steps"]} steps in process', f'{r["alone_s"]:.3f} s',
                f'< {MAX_ALONE_S:g} s', r['alone_s'] < MAX_ALONE_S),
            Row('  the first one, imports of the filter included', f'{r["first_s"]:.2f} s'),
            Row(f'  a run in a batch of {r["batch"]}', f'{r["batch_ms_per_run"]:.2f} ms'),
            Row('a scenario with one key changed', f'{r["scenario_ms"]:.3f} ms',
                f'< {MAX_SCENARIO_MS:g} ms', r['scenario_ms'] < MAX_SCENARIO_MS)]


def _console(quick: bool, _: Checkout | None) -> dict:
    from rvd_campaign.bench import console
    return console.measure(quick)


def _console_rows(r: dict) -> list[Row]:
    from rvd_campaign.bench.console import GOALS
    return [Row(name, f'{value:.4g}', f'< {GOALS[name]:g}' if name in GOALS else '',
                value < GOALS[name] if name in GOALS else None) for name, value in r.items()]


def _campaign(quick: bool, before: Checkout | None) -> dict:
    from rvd_campaign.bench import campaign
    return campaign.measure(quick, before)


def _campaign_rows(r: dict) -> list[Row]:
    from rvd_campaign.bench import campaign as c
    return [Row('runs per core-second, draws included', f'{r["runs_per_core_s"]}',
                f'>= {c.MIN_RUNS_PER_CORE_S}', r['runs_per_core_s'] >= c.MIN_RUNS_PER_CORE_S),
            against('  of table3, of the other checkout', r.get('rate_of_before'),
                    f'>= {c.MIN_RATE_OF_BEFORE}', lambda ratio: ratio >= c.MIN_RATE_OF_BEFORE),
            Row('  one filterpy and one pilot object per run', f'{r["one_by_one_per_core_s"]}'),
            Row('  times that', f'{r["ratio"]:.0f}', f'>= {c.MIN_RATIO}',
                r['ratio'] >= c.MIN_RATIO),
            Row('with the default predictor, of the paper\'s', f'{r["default_of_paper"]:.2f}',
                f'>= {c.MIN_RATE_OF_PAPER}', r['default_of_paper'] >= c.MIN_RATE_OF_PAPER),
            Row('flying on two processes, of one', f'{r["speed_up_on_two"]:.2f}',
                f'>= {c.MIN_SPEED_UP}', r['speed_up_on_two'] >= c.MIN_SPEED_UP),
            Row(f'table3, {r["table_runs"]} runs a condition, two workers',
                f'{r["table3_s"]:.1f} s', f'< {c.MAX_TABLE_S:g} s',
                r['table3_s'] < c.MAX_TABLE_S)]


def _laws(quick: bool, _: Checkout | None) -> dict:
    from rvd_campaign.bench import laws
    return laws.measure(quick)


def _laws_rows(r: dict) -> list[Row]:
    from rvd_campaign.bench.laws import GOALS
    return _goal_rows(r, GOALS)


def _tether(quick: bool, _: Checkout | None) -> dict:
    from rvd_campaign.bench import tether
    return tether.measure(quick)


def _tether_rows(r: dict) -> list[Row]:
    from rvd_campaign.bench.tether import GOALS
    return _goal_rows(r, GOALS)


def _docking(quick: bool, _: Checkout | None) -> dict:
    from rvd_campaign.bench import docking
    return docking.measure(quick)


def _docking_rows(r: dict) -> list[Row]:
    from rvd_campaign.bench.docking import GOALS
    return _goal_rows(r, GOALS)


def _leak(quick: bool, _: Checkout | None) -> dict:
    from rvd_campaign.bench import leak
    return leak.measure(quick)


def _leak_rows(r: dict) -> list[Row]:
    from rvd_campaign.bench.leak import MAX_BYTES
    rows = []
    for sharing, found in r.items():
        most = max(found['bytes_per_step'].values())
        rows.append(Row(f'processes {sharing}, {found["steps"]:,} steps: most growth, a step',
                        f'{most:.2f} B', f'< {MAX_BYTES:g} B', most < MAX_BYTES))
        rows += [Row(f'  {name}, {found["megabytes"][name]:.0f} MB, '
                     f'{found["kilobytes_in_all"][name]} kB more than after the warm-up: a step',
                     f'{growth:.2f} B') for name, growth in found['bytes_per_step'].items()]
    return rows


def _goal_rows(r: dict, goals: dict) -> list[Row]:
    rows = []
    for name, value in r.items():
        goal = goals[name]
        met = None if goal.low is goal.high else (
            value >= goal.low if goal.high is None else value < goal.high)
        target = '' if met is None else (
            f'>= {goal.low:,g}' if goal.high is None else f'< {goal.high:g} {goal.unit}')
        rows.append(Row(goal.words, f'{value:,.0f}' if value >= 1000 else
                        f'{value:.3g} {goal.unit}'.strip(), target, met))
    return rows


def against(what: str, ratio: float | None, target: str, met: Callable[[float], bool]) -> Row:
    """Return the row of a ratio to another checkout, or how to get it."""
    if ratio is None:
        return Row(what, '-', f'needs {HOW}')
    return Row(what, f'{ratio:.2f}', target, met(ratio))


Measure = Callable[[bool, Checkout | None], dict]
PARTS: dict[str, tuple[Measure, Callable[[dict], list[Row]]]] = {
    'loop': (_loop, _loop_rows),
    'campaign': (_campaign, _campaign_rows),
    'graph': (_graph, _graph_rows),
    'flight': (_flight, _flight_rows),
    'laws': (_laws, _laws_rows),
    'tether': (_tether, _tether_rows),
    'docking': (_docking, _docking_rows),
    'leak': (_leak, _leak_rows),
    'console': (_console, _console_rows),
}
