"""
The study of the limit cycles: a table, the branches, the flights, and a page of figures.
"""

from dataclasses import replace
from math import degrees
from pathlib import Path

import numpy as np

from rvd_campaign import catalogue
from rvd_campaign.exits import EXIT_DONE
from rvd_campaign.flight.run_folder import new_folder
from rvd_campaign.report.page import Drawn, render
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, Scenario
from rvd_dynamics.recording import whole
from rvd_dynamics.recording.drawing import png, svg
from rvd_dynamics.recording.history import of_history
from rvd_missions.elliptic_rendezvous import cycle_figures
from rvd_missions.elliptic_rendezvous.figures import FIGURES
from rvd_missions.elliptic_rendezvous.gains import CycleCase
from rvd_missions.elliptic_rendezvous.limit_cycles import Branch, Cycle, follow
from rvd_missions.elliptic_rendezvous.signals import GUIDANCE, TRUTH

FARTHEST = 0.9                  # eccentricity that branches are followed to
FLIGHTS = {     # by the paper's figures: scenario, changes, which of our figures
    'RRCA (Figures 7 to 9)': ('ellipse', {}, ('trajectory', 'direction', 'distance')),
    'ODRRCA (Figures 10 and 11)': (
        'ellipse', {'guidance.law': 'odrrca', 'start.direction_deg': -120.0},
        ('trajectory', 'direction')),
    'combined (Figures 12 and 13)': ('ellipse_combined', {}, ('trajectory', 'fly_around')),
}


def study(case: CycleCase, out: str | None, flights: bool) -> int:
    """Compute all, say how far it is, and leave a folder with a page and pictures."""
    folder = new_folder(out, 'limit-cycles')
    print('cycles (the first time, code is compiled) ...', flush=True)
    found = cycle_figures.cycles(case)
    heads, rows = table(found)
    for row in [heads, *rows]:
        print('  ' + '  '.join(f'{cell:<26}' for cell in row).rstrip())
    print('branches ...', flush=True)
    branches = {name: follow(replace(case, e=0.0, **changes), 'e', 0.0, FARTHEST)
                for name, changes in cycle_figures.FORMS.items()}
    events = [f'RRCA, k2 = 0, {name}: {_followed(branch)}' for name, branch in branches.items()]
    for line in events:
        print(f'  {line}')
    drawn = [
        _drawn(folder, 'cycles', 'Limit cycles', 'Limit cycles of the direction angle for four '
               'eccentricities; dashed ones are unstable.',
               lambda: cycle_figures.portraits(found)),
        _drawn(folder, 'branches', 'Branches', 'The branch that begins at the equilibrium of the '
               'circular orbit, followed in the eccentricity by pseudo-arclength: RRCA, k2 = 0. '
               'Thick: stable. Dot: period doubling; diamond: fold. Blue: exp(-pi).',
               lambda: cycle_figures.branches(branches))]
    for title, (name, changes, figures) in (FLIGHTS if flights else {}).items():
        print(f'flying {title} ...', flush=True)
        scenario = load(catalogue.find('scenarios', name, ('.yaml',))).with_values('/**', **changes)
        drawn += _flown(folder, title, scenario, figures)
    page = folder / 'report.html'
    whole.write_text(page, render(
        'cycles.html.j2', title='Limit cycles of range-rate control',
        gains=f'k = {case.k:g}, k1 = {case.k1:g}, q = {case.q:g}, form {case.form.upper()}',
        heads=heads, rows=rows, events=events, figures=drawn))
    print(page)
    return EXIT_DONE


def table(found: cycle_figures.Cycles) -> tuple[list[str], list[list[str]]]:
    """Return heads and rows of the corridors, a row for each eccentricity."""
    heads = ['e', *(title.partition(': ')[2] for title in found)]
    return heads, [[f'{e:g}', *(_corridor(row[e]) for row in found.values())]
                   for e in cycle_figures.ECCENTRICITIES]


def _corridor(one: Cycle | None) -> str:
    if one is None:
        return 'none'
    return (f'{degrees(one.phi_min):.2f} .. {degrees(one.phi_max):.2f} '
            f'({abs(one.multipliers[0]):.4g})')


def _followed(branch: Branch) -> str:
    """Return in words what happens on a branch."""
    said = [f'{event.kind} at e = {event.at:.4f}' for event in branch.events]
    return ', '.join([*said, f'followed to e = {np.abs(branch.at).max():.4f}'])


def _flown(folder: Path, title: str, scenario: Scenario, figures: tuple[str, ...]) -> list[Drawn]:
    batch = fly(scenario, [0], record=[TRUTH.name, GUIDANCE.name])
    run = of_history(scenario, batch)
    law = title.partition(' ')[0]
    return [_drawn(folder, f'{law.lower()}_{name}', f'{title}: {FIGURES[name].title.lower()}',
                   FIGURES[name].caption, lambda name=name: FIGURES[name].draw(run))
            for name in figures]


def _drawn(folder: Path, name: str, title: str, caption: str, draw) -> Drawn:
    png(folder / f'{name}.png', draw)
    return Drawn(title, svg(name, draw), caption)
