"""
Two studies of the mission, as numbers and pictures: the gain error borne, and the noise rules.

    ./rvd shell python -m rvd_missions.attitude_hold.studies [gain|noise|all] [FOLDER]

prints what docs/missions/attitude_hold.md quotes, and writes pictures into FOLDER if there is one.
"""

from collections.abc import Callable
from pathlib import Path
import sys
from typing import Any, NamedTuple, TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.diagram import streams
from rvd_dynamics.recording.drawing import (
    BLUE, canvas, DASHED, GREEN, INK, MUTED, ORANGE, png, VERMILLION)
from rvd_missions.attitude_hold import noise_rules
from rvd_missions.attitude_hold.noise_rules import (
    axis, best_gain, consistent_gain, experiment, Found, I, minimum, P, RULES, stationary)
from rvd_missions.attitude_hold.stability import (
    loop, ONE_TAP, poles, radius, range_of_gain, TWO_TAPS)

if TYPE_CHECKING:
    from matplotlib.figure import Figure as Canvas

MODELS = {'one tap': (ONE_TAP, BLUE, '-'), 'two taps': (TWO_TAPS, VERMILLION, DASHED)}
DELAYS = range(6)
SEED = 7                                        # of the experiments
Q_OVER_SIGNAL = np.geomspace(0.01, 1e5, 15)     # variance of the noise over that of c x
FLOWN = {P: (1.0, 10.0, 100.0, 1e3, 1e4), I: (10.0, 30.0, 100.0, 1e3, 1e4)}
BEST = {P: (1.0, 10.0, 100.0), I: (1.0, 3.0, 10.0)}     # where the minimum is flown, too
SPREAD = np.array([0.8, 0.9, 1.0, 1.11, 1.25])    # of the gains about a minimum


# -- gain error -------------------------------------------------------------------------------

def gain_numbers() -> str:
    """Return poles and stable ranges of both loops as text."""
    lines = []
    for name, (taps, _, _) in MODELS.items():
        found = ', '.join(f'{p.real:.4f}{p.imag:+.4f}i' if abs(p.imag) > 1e-6 else f'{p.real:.4f}'
                          for p in poles(1.0, *loop(taps)))
        lines.append(f'{name}: poles {found}; |pole| {radius(1.0, *loop(taps)):.4f}')
        for delay in DELAYS:
            lines.append(f'  {delay} steps of delay: stable for a gain error {_range(taps, delay)}')
    return '\n'.join(lines)


def _range(taps: tuple[float, ...], delay: int) -> str:
    try:
        low, high = range_of_gain(*loop(taps, delay=delay))
    except ValueError:
        return 'of no positive size'
    return f'between {low:.0f} and {high:.4f}'


def gain_picture() -> 'Canvas':
    """Draw the poles in the plane, and the farthest one over the gain error and the delay."""
    figure = canvas(3.9, top=0.35, wspace=0.24)
    left, middle, right = figure.subplots(1, 3)
    circle = np.exp(1j*np.linspace(0.0, 2*np.pi, 200))
    left.plot(circle.real, circle.imag, color=MUTED, linewidth=1.0)
    rho = np.linspace(0.01, 5.0, 500)
    for name, (taps, colour, style) in MODELS.items():
        base, change = loop(taps)
        locus = np.array([np.roots(base + r*change) for r in rho])
        left.plot(locus.real, locus.imag, '.', color=colour, markersize=1.2, alpha=0.6)
        at = poles(1.0, base, change)
        left.plot(at.real, at.imag, 'o', color=colour, markersize=6, markerfacecolor='none',
                  label=f'{name}, gain error 1')
        middle.plot(rho, radius(rho, base, change), color=colour, linestyle=style, label=name)
        edge = range_of_gain(base, change)[1]
        middle.axvline(edge, color=colour, linestyle=':', linewidth=1.0)
        middle.annotate(f'{edge:.3f}', (edge, 0.42 if taps == ONE_TAP else 0.32), color=colour,
                        xytext=(4, 0), textcoords='offset points', fontsize=8.0)
    left.set(xlim=(-1.35, 1.35), ylim=(-1.35, 1.35), aspect='equal', title='Poles over gain error')
    left.legend(loc='lower left', fontsize=7.5)
    middle.axhline(1.0, color=INK, linewidth=1.0)
    middle.set(xlabel='gain error (true / model)', ylabel='|farthest pole|', ylim=(0.2, 1.7),
               title='Without delay')
    middle.legend(loc='upper left')
    for delay, colour in zip(range(5), (VERMILLION, ORANGE, GREEN, BLUE, INK)):
        right.plot(rho, radius(rho, *loop(TWO_TAPS, delay=delay)), color=colour,
                   label=f'{delay} steps')
    right.axhline(1.0, color=INK, linewidth=1.0)
    right.set(xlabel='gain error (true / model)', ylim=(0.7, 1.7), xlim=(0.0, 3.0),
              title='Two taps behind a delay')
    right.legend(loc='lower right', ncols=2)
    return figure


# -- noise rules ------------------------------------------------------------------------------

class Rule(NamedTuple):
    """What one theorem gives over the noise; gains [1/s^2 or 1/s^2 per step]."""

    q: NDArray                          # (n,) relative to the variance of c x without control
    theorem: NDArray                    # (n,) NaN where no gain is the best for its own loop
    best: NDArray                       # (n,) 0 where no control at all is best
    flown: dict[float, tuple[float, Found]]     # formula and experiment, by relative q
    flown_best: dict[float, tuple[float, Found]]


def noise(rule: str) -> Rule:
    """Return formulas and experiments of a rule on the axis of `noise_rules.axis`."""
    plant = axis()
    signal = float(plant.c @ stationary(plant, P, 0.0, 1.0).x @ plant.c)

    def theorem(relative: float) -> float:
        try:
            return consistent_gain(plant, rule, relative*signal).gain
        except ValueError:
            return float('nan')

    def best(relative: float) -> float:
        found = best_gain(plant, rule, relative*signal).gain
        return 0.0 if abs(found) < 1e-7 else found

    def rng(what: str, relative: float) -> np.random.Generator:
        return streams.generator(SEED, round(relative), f'attitude_hold/{what}/{rule}')

    flown = {r: (theorem(r), experiment(plant, rule, theorem(r), r*signal, rng('next_step', r)))
             for r in FLOWN[rule] if np.isfinite(theorem(r))}
    flown_best = {r: (best(r), minimum(plant, rule, best(r)*SPREAD, r*signal, rng('minimum', r)))
                  for r in BEST[rule] if best(r) != 0.0}
    return Rule(Q_OVER_SIGNAL, np.array([theorem(r) for r in Q_OVER_SIGNAL]),
                np.array([best(r) for r in Q_OVER_SIGNAL]), flown, flown_best)


def noise_numbers(rules: dict[str, Rule]) -> str:
    """Return formulas and experiments as text."""
    lines = []
    for name, rule in rules.items():
        known = np.isfinite(rule.theorem) & (rule.q >= 999.0)
        lines.append(f'{name}: slope of the gain of the theorem over Q, Q >= 1000 c X c^T: '
                     f'{noise_rules.slope(rule.q[known], rule.theorem[known]):+.4f}')
        for what, table in (('next step', rule.flown), ('for good', rule.flown_best)):
            lines += [f'  {what:<9} Q = {q:<7g} c X c^T: formula {gain:+.6f}, flown '
                      f'{found.value:+.6f} [{found.low:+.6f}, {found.high:+.6f}]'
                      for q, (gain, found) in table.items()]
        gone = rule.q[rule.best == 0.0]
        if gone.size:
            lines.append(f'  for good: no control is best from Q = {gone.min():g} c X c^T on '
                         '(of the grid)')
    return '\n'.join(lines)


def noise_picture(rules: dict[str, Rule]) -> 'Canvas':
    """Draw the gains over the noise, formula as lines and experiments as bars."""
    figure = canvas(3.9, top=0.35, wspace=0.20)
    for axes, (name, rule) in zip(figure.subplots(1, 2), rules.items()):
        known = np.isfinite(rule.theorem)
        axes.loglog(rule.q[known], -rule.theorem[known], color=BLUE,
                    label='best for the next step (theorem)')
        some = rule.best != 0.0
        axes.loglog(rule.q[some], -rule.best[some], color=VERMILLION, linestyle=DASHED,
                    label='best for good (stationary)')
        for table, colour, marker in ((rule.flown, BLUE, 'o'), (rule.flown_best, VERMILLION, 's')):
            for q, (_, found) in table.items():
                axes.plot([q, q], [-found.high, -found.low], color=colour, linewidth=2.4)
                axes.plot(q, -found.value, marker, color=colour, markersize=4.5)
        last = rule.q[known][-1], -rule.theorem[known][-1]
        far = rule.q[rule.q >= 10.0]
        axes.loglog(far, last[1]*last[0]/far, color=INK, linewidth=0.9, linestyle=':',
                    label='1/Q')
        axes.set(xlabel='Q / c X c\u1d40', ylabel=f'\u2212k{name[0]}',
                 title=f'{name.capitalize()} gain')
        axes.legend(loc='lower left')
    return figure


# -- the command ------------------------------------------------------------------------------

def main(what: str = 'all', folder: Path | None = None) -> None:
    """Print the numbers asked for, and draw the pictures if there is a folder for them."""
    pictures: dict[str, Callable[[], Any]] = {}
    if what in ('gain', 'all'):
        print(gain_numbers())
        pictures['attitude-gain'] = gain_picture
    if what in ('noise', 'all'):
        rules = {rule: noise(rule) for rule in RULES}
        print(noise_numbers(rules))
        pictures['attitude-noise'] = lambda: noise_picture(rules)
    for name, draw in pictures.items():
        if folder is not None:
            png(folder / f'{name}.png', draw)


if __name__ == '__main__':
    given = sys.argv[1:]
    if len(given) > 2 or (given and given[0] not in ('gain', 'noise', 'all')):
        sys.exit(__doc__.strip())
    main(given[0] if given else 'all', Path(given[1]) if len(given) == 2 else None)
