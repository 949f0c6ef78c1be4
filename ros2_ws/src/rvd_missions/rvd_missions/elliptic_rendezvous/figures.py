"""
The figures of a rendezvous, drawn from its recording: the paper's Figures 7 to 13.
"""

from functools import lru_cache
from math import pi
from typing import Any, TYPE_CHECKING

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.recording.drawing import (
    ABOVE, BLUE, canvas, DASHED, Figure, GREEN, INK, MUTED, ORANGE, VERMILLION)
from rvd_dynamics.recording.recording import Recording
from rvd_groundstation.guidance.range_rate import line_of_sight
from rvd_missions.elliptic_rendezvous.gains import CycleCase
from rvd_missions.elliptic_rendezvous.laws import Rrca
from rvd_missions.elliptic_rendezvous.signals import GUIDANCE, TRUTH

if TYPE_CHECKING:
    from matplotlib.axes import Axes
    from matplotlib.figure import Figure as Canvas


def trajectory(run: Recording) -> 'Canvas':
    """Draw the way in the orbital plane, far and near (Figures 7, 10 and 12)."""
    figure = canvas(4.6, wspace=0.24)
    far, near = figure.subplots(1, 2)
    state = run.of(TRUTH).state
    hold = run.scenario.part('arrival').range_m
    _plane(far, state[:, 0]/1e3, state[:, 1]/1e3, 'km')
    _cone(far, run, float(np.abs(state[:, :2]).max(initial=1.0))/1e3)
    far.plot(state[:1, 0]/1e3, state[:1, 1]/1e3, 'o', color=INK, markersize=5, label='start')
    far.legend(loc='best')
    far.set_title('the whole approach')
    close = np.hypot(state[:, 0], state[:, 1]) < 20.0*hold
    _plane(near, state[close, 0], state[close, 1], 'm')
    _cone(near, run, 20.0*hold)
    _circle(near, hold)
    near.set_title(f'the last {20.0*hold:g} m')
    return figure


def direction(run: Recording) -> 'Canvas':
    """Draw the direction over orbits, with the corridor of the limit cycle (Figures 8 and 11)."""
    figure = canvas(3.6, left=0.08)
    axes = figure.subplots()
    orbits, phi, _ = _seen(run)
    axes.plot(orbits, np.degrees(phi), color=INK, label='true direction')
    corridor = _corridor(run)
    if corridor is not None and len(phi):
        arrived = _arrived(run, orbits)
        last = phi[max(0, arrived - 1)] if arrived else phi[-1]
        turn = pi if run.scenario.part('guidance').law != 'odrrca' else 2.0*pi
        middle = (corridor[0] + corridor[1])/2.0
        shift = turn*np.round((last - middle)/turn)
        for i, bound in enumerate(corridor):
            axes.axhline(np.degrees(bound + shift), color=VERMILLION, linestyle=DASHED,
                         linewidth=1.2, label='corridor of the limit cycle' if i else None)
    axes.set(xlabel='orbits of the target from perigee', ylabel='direction [deg]')
    axes.legend(**ABOVE, ncols=2)
    return figure


def distance(run: Recording) -> 'Canvas':
    """Draw the range and its rate over orbits (Figure 9)."""
    figure = canvas(3.8, hspace=0.12)
    top, bottom = figure.subplots(2, 1, sharex=True, height_ratios=[2, 1])
    orbits, _, los = _seen(run)
    top.semilogy(orbits, los.range, color=INK, label='true range')
    law = run.scenario.part('law')
    if len(orbits):
        top.semilogy(orbits, los.range[0]*np.exp(law.k*2.0*pi*(orbits - orbits[0])), color=MUTED,
                     linestyle=DASHED, label='exp(k nu)')
    top.axhline(run.scenario.part('arrival').range_m, color=GREEN, linewidth=1.2)
    top.set(ylabel='range [m]', ylim=(max(1.0, 0.5*np.nanmin(los.range, initial=50.0)), None))
    top.legend(**ABOVE, ncols=2)
    bottom.plot(orbits, los.range_rate, color=INK)
    if run.has(GUIDANCE.name):
        known = run.of(GUIDANCE)
        steps = np.minimum(known.step, len(orbits) - 1)
        bottom.plot(orbits[steps], known['reference_rate'], color=BLUE, linewidth=1.0,
                    linestyle=DASHED)
    bottom.set(xlabel='orbits of the target from perigee', ylabel='rate [m/s]')
    return figure


def thrust(run: Recording) -> 'Canvas':
    """Draw what the thrusters did along and across the line of sight."""
    figure = canvas(3.4, hspace=0.12)
    panels = figure.subplots(2, 1, sharex=True)
    orbits, phi, _ = _seen(run)
    accel = run.of(TRUTH).accel
    s, side = np.sin(phi), np.cos(phi)
    for axes, values, name in zip(panels, (accel[:, 0]*s + accel[:, 1]*side,
                                           accel[:, 0]*side - accel[:, 1]*s), ('along', 'across')):
        axes.plot(orbits, values, color=BLUE, linewidth=1.0)
        axes.set_ylabel(f'{name} [m/s$^2$]')
    panels[-1].set_xlabel('orbits of the target from perigee')
    return figure


def fly_around(run: Recording) -> 'Canvas':
    """Draw the second stage of the combined mode (Figure 13)."""
    if not _arrived(run, np.empty(0)) or _arrived(run, np.empty(0)) >= run.last_step:
        figure = canvas(0.9)
        figure.text(0.5, 0.5, 'nothing was flown after an arrival', ha='center', color=MUTED)
        return figure
    figure = canvas(4.2, wspace=0.24, hspace=0.12)
    grid = figure.add_gridspec(2, 2)
    plane, over = figure.add_subplot(grid[:, 0]), figure.add_subplot(grid[0, 1])
    error = figure.add_subplot(grid[1, 1], sharex=over)
    orbits, phi, los = _seen(run)
    arrival = run.scenario.part('arrival')
    first = _arrived(run, orbits)
    state = run.of(TRUTH).state[first:]
    _plane(plane, state[:, 0], state[:, 1], 'm')
    _circle(plane, arrival.range_m)
    if len(state):
        plane.plot(state[:1, 0], state[:1, 1], 'o', color=INK, markersize=5)
        plane.plot(state[-1:, 0], state[-1:, 1], 'o', color=GREEN, markersize=7)
    wanted = getattr(getattr(run.scenario.part('law'), 'fly_around', None), 'phi_d_deg', 0.0)
    shown = np.degrees(phi[first:])
    shift = 360.0*np.round((shown[-1] - wanted)/360.0) if len(shown) else 0.0
    over.plot(orbits[first:], shown, color=INK)
    over.axhline(wanted + shift, color=GREEN, linewidth=1.2, linestyle=DASHED)
    over.set(ylabel='direction [deg]')
    over.tick_params(labelbottom=False)
    error.plot(orbits[first:], los.range[first:] - arrival.range_m, color=ORANGE)
    error.set(xlabel='orbits of the target from perigee', ylabel='range error [m]')
    return figure


def _seen(run: Recording) -> tuple[NDArray, NDArray, Any]:
    """Return orbits from perigee, the direction counted on, and the line of sight, by step."""
    truth, orbit = run.of(TRUTH), run.scenario.part('orbit')
    los = line_of_sight(truth.state)
    orbits = np.array([orbit.at(t).anomaly for t in truth.t.tolist()])/(2.0*pi)
    return orbits, np.unwrap(los.direction), los


def _arrived(run: Recording, orbits: NDArray) -> int:
    """Return the step of the arrival, 0 where there is none."""
    time = np.nan if run.verdict is None else run.verdict.value('arrival_s')
    return int(time/run.scenario.run.step_s) if np.isfinite(time) else 0


def case_of(law: Rrca, name: str, eccentricity: float) -> CycleCase:
    """Return the case of the direction-angle equation that a law flies."""
    across = {key: getattr(law, key) for key in ('q', 'q1', 'phi_d_deg', 'ff')
              if hasattr(law, key)}
    return CycleCase(law='odrrca' if name == 'odrrca' else 'rrca', form=law.form, e=eccentricity,
                     k=law.k, k1=law.k1, k2=law.k2, **across)


def _corridor(run: Recording) -> tuple[float, float] | None:
    """Return the corridor that the limit cycle of the law makes [rad]; None if there is none."""
    part = run.scenario.part
    return _corridor_of(case_of(part('law'), part('guidance').law, part('orbit').eccentricity))


@lru_cache(maxsize=8)
def _corridor_of(case: CycleCase) -> tuple[float, float] | None:
    from rvd_missions.elliptic_rendezvous.limit_cycles import cycle     # numba
    found = cycle(case)
    return None if found is None else (found.phi_min, found.phi_max)


def _plane(axes: 'Axes', x: NDArray, y: NDArray, unit: str) -> None:
    axes.plot(x, y, color=INK, linewidth=1.6)
    axes.plot([0.0], [0.0], '+', color=VERMILLION, markersize=9)
    axes.set(xlabel=f'x, along track [{unit}]', ylabel=f'y, radial [{unit}]')
    axes.set_aspect('equal', adjustable='datalim')


def _circle(axes: 'Axes', radius: float) -> None:
    angle = np.linspace(0.0, 2.0*pi, 181)
    axes.plot(radius*np.sin(angle), radius*np.cos(angle), color=GREEN, linewidth=1.2,
              linestyle=DASHED)


def _cone(axes: 'Axes', run: Recording, reach: float) -> None:
    """Draw the corridor of the limit cycle, on the side on which the chaser comes."""
    corridor = _corridor(run)
    if corridor is None:
        return
    last = run.of(TRUTH).state[-1]
    middle = sum(corridor)/2.0
    flip = np.sign(last[0]*np.sin(middle) + last[1]*np.cos(middle)) or 1.0
    if run.scenario.part('law').flies_around:
        arrived = run.of(TRUTH).state[_arrived(run, np.empty(0))]
        flip = np.sign(arrived[0]*np.sin(middle) + arrived[1]*np.cos(middle)) or 1.0
    for i, bound in enumerate(corridor):
        axes.plot([0.0, flip*reach*np.sin(bound)], [0.0, flip*reach*np.cos(bound)],
                  color=VERMILLION, linestyle=DASHED, linewidth=1.2,
                  label='corridor of the limit cycle' if i else None, scalex=False, scaley=False)


FIGURES = {
    'trajectory': Figure(
        trajectory, 'Trajectory',
        'True way of the chaser in the orbital plane, the target at the cross. Dashed rays: the '
        'approach corridor of the limit cycle; dashed circle: the range at which the approach '
        'ends.', signals=(TRUTH.name,)),
    'direction': Figure(
        direction, 'Direction',
        'True direction of the line of sight, from radial-out, positive along the orbit. Dashed: '
        'the corridor of the limit cycle, into which the swing decays.', signals=(TRUTH.name,)),
    'distance': Figure(
        distance, 'Range',
        'True range and range rate; dashed grey: exp(k nu), dashed blue: the reference rate of '
        'the law. The range departs from exp(k nu) where the direction turns.',
        signals=(TRUTH.name,), also=(GUIDANCE.name,)),
    'thrust': Figure(
        thrust, 'Thrust', 'Acceleration by the thrusters along and across the line of sight.',
        signals=(TRUTH.name,)),
    'fly_around': Figure(
        fly_around, 'After the arrival',
        'The way, the direction and the range error after the arrival. Green: the range that is '
        'held and the direction that is wanted.', signals=(TRUTH.name,)),
}
