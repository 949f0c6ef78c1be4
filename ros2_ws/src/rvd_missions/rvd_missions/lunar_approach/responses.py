"""
Make a table of what people did at the desk, for the pilot of recorded responses.

    ./rvd shell python -m rvd_missions.lunar_approach.responses FOLDER ... --out responses.csv

FOLDER is a run or a session (`./rvd fly --operator console --session ...`); every manual flight in
it counts. In mode manual the command that was sent is the stick as it was read, step by step; of
any other flight the stick alone is not known so, and it is left out, in a line that says so.
"""

import argparse
from pathlib import Path
import sys

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.commands.codes import BY_NOBODY, BY_PILOT
from rvd_dynamics.recording import whole
from rvd_dynamics.recording.reader import read
from rvd_dynamics.recording.recording import Recording
from rvd_groundstation.operators.recorded import text_of_responses
from rvd_missions.lunar_approach import MISSION
from rvd_missions.lunar_approach.signals import COMMAND, PREDICTION

Flight = tuple[NDArray[np.float64], NDArray[np.int8]]


def response(run: Recording) -> Flight:
    """
    Return what a flight's display showed, states (K, 6), and where the stick stood, levels (K, 3).

    Raises
    ------
    ValueError
        If it is no manual flight of this mission, or its bag holds no step of it.
    """
    if run.scenario is None or run.scenario.mission.name != MISSION.name:
        raise BadInput(run.scenario_trouble or f'no flight of {MISSION.name}')
    shown, sent = run.of(PREDICTION), run.of(COMMAND)
    if not np.isin(sent.decided_by, (BY_PILOT, BY_NOBODY)).all():
        raise BadInput('not flown in mode manual')
    if (sent.decided_by == BY_NOBODY).all():
        raise BadInput('nobody has touched the stick')
    good = shown.valid & np.isfinite(shown.state).all(axis=1)
    steps, mine, its = np.intersect1d(shown.step[good], sent.step, return_indices=True)
    if not len(steps):
        raise BadInput('its bag holds no step with a display and a command')
    return shown.state[good][mine], sent.levels[its]


def collect(folders: list[Path]) -> tuple[list[Flight], float]:
    """
    Return the responses of all manual flights in folders, and their step [s].

    Raises
    ------
    ValueError
        If there is none, or two have different steps.
    """
    flights, steps = [], {}
    for folder in folders:
        if not folder.is_dir():
            raise BadInput(f'{folder}: no such folder of a run or a session')
        for verdict in sorted(folder.rglob('verdict.json')):
            try:
                run = read(verdict.parent)
                flights.append(response(run))
                steps[run.scenario.run.step_s] = verdict.parent
            except BadInput as error:
                print(f'{verdict.parent}: left out: {error}', file=sys.stderr)
    if not flights:
        raise BadInput(f'no manual flight in {", ".join(map(str, folders))}')
    if len(steps) > 1:
        raise BadInput('flights in different steps cannot be mixed: '
                       + ', '.join(f'{step:g} s in {where}' for step, where in steps.items()))
    return flights, next(iter(steps))


def main(arguments: list[str] | None = None) -> int:
    """Write the table; return the exit code."""
    parser = argparse.ArgumentParser(description='Make a table of recorded responses.')
    parser.add_argument('folders', nargs='+', type=Path, help='of runs or sessions')
    parser.add_argument('--out', required=True, type=Path, help='the table, a CSV file')
    args = parser.parse_args(arguments)
    try:
        flights, step_s = collect(args.folders)
        print(whole.save(args.out, text_of_responses(flights, step_s)))
    except (BadInput, OSError) as error:
        print(f'responses: {error}', file=sys.stderr)
        return 2
    print(f'{len(flights)} flights, {sum(len(levels) for _, levels in flights):,} steps of '
          f'{step_s:g} s')
    return 0


if __name__ == '__main__':
    sys.exit(main())
