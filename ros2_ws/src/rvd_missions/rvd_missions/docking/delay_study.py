"""
What the predictor is worth: docking by hand through the link at several delays.

    ./rvd shell python -m rvd_missions.docking.delay_study [LOOP_S ...] [--runs N] [--display NAME]

flies the scenario docking_delay in process, with the model pilot who looks at the predicted craft
or at the delayed telemetry, and prints one row of a table for each: how far the display was from
the true craft at the instant at which a command sent then acted (predicted / delayed, root mean
square of one axis over all steps and runs), and how the runs went.
"""

import argparse
from pathlib import Path
import sys

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_dynamics.motion import attitude
from rvd_missions.docking.hand_signals import ESTIMATE, PREDICTION
from rvd_missions.docking.signals import TRUTH

DISPLAYS = ('predicted', 'delayed')
LENGTH_S, FROM_S = 200.0, 150.0


def scenario(path: Path, loop_s: float, display: str, seconds: float = LENGTH_S) -> Scenario:
    """Return the shipped scenario with half of a delay on each leg, and what the pilot looks at."""
    changed = load(path).with_values(
        '/**', forward_delay_s=0.5*loop_s, back_delay_s=0.5*loop_s, timeout_s=seconds,
        **{'limits.from_s': min(FROM_S, seconds - 1.0)})
    return changed.with_values('hand_pilot', display=display)


def errors(history: dict, forward: int) -> dict[str, tuple[float, float]]:
    """
    Return the error of the predicted and of the delayed craft [m], [m/s], [rad], rms.

    What was known at step k counts against the truth of step k + forward; rms of one axis.
    """
    truth = history[TRUTH.name]
    steps = len(truth.position) - forward

    def rms(of, name: str) -> float:
        known, true = getattr(of, name)[:steps], getattr(truth, name)[forward:]
        if name == 'attitude':
            off = attitude.rotation_vector(attitude.multiply(attitude.conjugate(known), true))
        else:
            off = known - true
        return float(np.sqrt(np.nanmean(off*off)))
    shown = history[PREDICTION.name], history[ESTIMATE.name]
    return {name: tuple(rms(of, name) for of in shown)
            for name in ('position', 'velocity', 'attitude')}


def row(loop_s: float, display: str, runs: int, path: Path) -> str:
    """Return one row of the table."""
    chosen = scenario(path, loop_s, display)
    flown = fly(chosen, range(runs), record=[TRUTH.name, PREDICTION.name, ESTIMATE.name])
    off, v = errors(flown.history, chosen.part('legs').forward), flown.verdict.values

    def pair(name: str, factor: float) -> str:
        return ' / '.join(f'{factor*value:.2f}' for value in off[name])

    def span(values: NDArray, digits: int) -> str:
        known = values[np.isfinite(values)]
        return f'{known.min():.{digits}f} .. {known.max():.{digits}f}' if known.size else 'never'
    return (f'| {loop_s:g} s, {display} | {pair("position", 1e3)} | {pair("velocity", 1e3)} | '
            f'{pair("attitude", np.degrees(1.0))} | {flown.verdict.success.sum()} of {runs} | '
            f'{span(v["hover_min_m"], 3)}, {span(v["hover_max_m"], 3)} | '
            f'{span(v["settled_s"], 0)} | {span(v["propellant_kg"], 2)} | {span(v["pulses"], 0)} |')


def main(arguments: list[str]) -> int:
    """Print the table; return the exit code."""
    parser = argparse.ArgumentParser(prog='delay_study')
    parser.add_argument('loop_s', nargs='*', type=float, default=[0.0, 2.0, 5.0])
    parser.add_argument('--runs', type=int, default=2)
    parser.add_argument('--display', choices=DISPLAYS)
    parser.add_argument('--scenario', type=Path, default=Path('scenarios/docking_delay.yaml'))
    args = parser.parse_args(arguments)
    print('| loop, display | position [mm] | velocity [mm/s] | attitude [deg] | hovering | '
          'distance [m] | in the band [s] | propellant [kg] | pulses |')
    print('| --- | --- | --- | --- | --- | --- | --- | --- | --- |')
    try:
        for loop_s in args.loop_s:
            for display in [args.display] if args.display else DISPLAYS:
                print(row(loop_s, display, args.runs, args.scenario), flush=True)
    except BadInput as error:
        print(f'delay_study: {error}', file=sys.stderr)
        return 2
    return 0


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))
