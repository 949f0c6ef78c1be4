"""
What becomes of runs among obstacles: counted by whether the start was feasible.

`./rvd shell python -m rvd_missions.lunar_approach.cluttered FOLDER` prints the table of a finished
campaign, best first among the conditions of a field, for docs/cluttered.md.
"""

import argparse
from collections.abc import Mapping
from pathlib import Path
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.recording.drawing import (
    beside, canvas, GREEN, INK, MUTED, ORANGE, VERMILLION)
from rvd_dynamics.recording.worded import worded

NORMAL_95 = 1.959963984540054
COLUMNS = ('success', 'reason', 'start_room_m', 'clearance_m', 'delta_v_m_s')


class Outcomes(NamedTuple):
    """Counts of the runs of one condition; all but the first two are of feasible starts."""

    runs: int
    infeasible: int
    infeasible_contacts: int
    docked: int
    contacts: int
    deadlocks: int                      # whose time was up: short of an obstacle, or held up by one
    others: int                         # left the corridor, or beyond the limits at docking
    delta_v_m_s: float                  # mean of the docked
    clearance_m: tuple[float, float]    # least and median

    @property
    def feasible(self) -> int:
        """How many starts were feasible."""
        return self.runs - self.infeasible


def outcomes(table: Mapping[str, NDArray]) -> Outcomes:
    """Return the counts of a result table of runs among obstacles."""
    free = table['start_room_m'] >= 0.0
    reason = np.where(free, table['reason'], '')
    docked, contact = reason == 'docked', reason == 'contact'
    late = (reason == 'deadlock') | (reason == 'timeout')
    clearance = table['clearance_m'][free]
    return Outcomes(
        len(free), int((~free).sum()), int((table['reason'][~free] == 'contact').sum()),
        int(docked.sum()), int(contact.sum()), int(late.sum()),
        int(free.sum() - docked.sum() - contact.sum() - late.sum()),
        float(table['delta_v_m_s'][docked].mean()) if docked.any() else np.nan,
        (float(clearance.min()), float(np.median(clearance))) if free.any() else (np.nan, np.nan))


def interval(count: int, of: int) -> tuple[float, float]:
    """Return Wilson's 95 % interval of a share; (0, 1) of nothing."""
    if not of:
        return 0.0, 1.0
    share, z = count/of, NORMAL_95
    centre, half = share + z*z/(2*of), z*np.sqrt(share*(1 - share)/of + z*z/(4*of*of))
    return float((centre - half)/(1 + z*z/of)), float((centre + half)/(1 + z*z/of))


def draw(results: Any) -> tuple[Any, str]:
    """Draw what becomes of the runs of each condition."""
    names = [condition.name for condition in results.shown]
    found = [outcomes(results.tables[name]) for name in names]
    words = [worded(name) for name in names]
    figure = canvas(1.0 + 0.3*len(names), left=beside(words), top=0.5, wspace=0.06)
    bars, room = figure.subplots(1, 2, sharey=True, width_ratios=[2.4, 1.0])
    left = np.zeros(len(names))
    at = np.arange(len(names))
    for field, colour, label in (('docked', GREEN, 'docked'), ('others', MUTED, 'other failures'),
                                 ('deadlocks', ORANGE, 'deadlock'),
                                 ('contacts', VERMILLION, 'contact')):
        share = np.array([100.0*getattr(o, field)/max(o.feasible, 1) for o in found])
        bars.barh(at, share, left=left, color=colour, label=label, height=0.72)
        left += share
    for i, o in enumerate(found):
        low, high = interval(o.docked, o.feasible)
        bars.plot([100*low, 100*high], [i, i], color=INK, linewidth=1.4)
        clearance = results.tables[names[i]]['clearance_m']
        clearance = clearance[results.tables[names[i]]['start_room_m'] >= 0.0]
        if len(clearance):
            room.plot(np.quantile(clearance, [0.0, 0.95]), [i, i], color=MUTED, linewidth=1.2)
            room.plot(np.quantile(clearance, [0.25, 0.75]), [i, i], color=INK, linewidth=4.0,
                      solid_capstyle='butt')
    bars.set_yticks(at, words)
    bars.invert_yaxis()
    bars.set(xlim=(0, 100), xlabel='runs from feasible starts [%]')
    room.axvline(0.0, color=VERMILLION, linewidth=1.0)
    room.set(xlabel='clearance [m]')
    bars.legend(ncols=4, loc='lower left', bbox_to_anchor=(0.0, 1.0), frameon=False)
    infeasible = sorted({(o.infeasible, o.runs) for o in found})
    return figure, (
        'What becomes of runs from feasible starts, with the 95 % interval of those that dock '
        '(black), and their least clearance: from the least to 95 %, thick the quartiles. '
        'Infeasible starts, left out: '
        + ', '.join(f'{few} of {of}' for few, of in infeasible) + '.')


def main(arguments: list[str] | None = None) -> None:
    """Print the table of a campaign's folder."""
    parser = argparse.ArgumentParser(description=__doc__.split('\n')[1])
    parser.add_argument('folder', type=Path)
    folder = parser.parse_args(arguments).folder
    file = folder / 'results.parquet'
    if not file.is_file():
        raise SystemExit(f'{folder}: no results.parquet; give the folder of a finished campaign')
    try:
        print('\n'.join(rows(file)))
    except BadInput as error:
        raise SystemExit(str(error)) from None


def rows(file: Path) -> list[str]:
    """Return the table of a result file in Markdown; ValueError where it has no obstacles."""
    import pyarrow.parquet
    names = pyarrow.parquet.read_schema(file).names
    if 'start_room_m' not in names:
        raise BadInput(f'{file}: no column start_room_m: its runs are not among obstacles')
    whole = pyarrow.parquet.read_table(file, columns=['condition', *COLUMNS])
    table = {name: whole[name].to_numpy(zero_copy_only=False) for name in whole.column_names}
    made: dict[str, Outcomes] = {}
    for name in dict.fromkeys(table['condition'].tolist()):
        where = table['condition'] == name
        made[name] = outcomes({column: table[column][where] for column in COLUMNS})

    def share(count: int, of: int) -> str:
        low, high = interval(count, of)
        return f'{count}/{of} [{low:.3f}, {high:.3f}]'
    lines = ['| condition | infeasible | docked | contact | deadlock | other | Δv [m/s] | '
             'clearance, least and median [m] | contact, infeasible |', '| --- ' * 9 + '|']
    for name, o in sorted(made.items(), key=lambda item: (item[0].partition(',')[2],
                                                          -item[1].docked)):
        lines.append(
            f'| {name} | {o.infeasible}/{o.runs} | {share(o.docked, o.feasible)} | '
            f'{share(o.contacts, o.feasible)} | {share(o.deadlocks, o.feasible)} | {o.others} | '
            f'{o.delta_v_m_s:.2f} | {o.clearance_m[0]:.3f}, {o.clearance_m[1]:.3f} | '
            f'{o.infeasible_contacts}/{o.infeasible} |')
    return lines


if __name__ == '__main__':
    main()
