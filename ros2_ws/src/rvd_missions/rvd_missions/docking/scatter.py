"""
What differs from run to run: the craft itself, its thrusters, how its camera is mounted.

The craft's own computers know nothing of it. Normals with one sigma, but for the centre of mass,
which is off by a fixed length with a sign by chance, and two uniform ones: products of inertia and
frequencies of the tanks. Source of the sizes in the campaign `docking`: the mission's page.

A draw can be impossible: a mass below zero, an inertia that no body has, panels with more inertia
than all of the craft. Then the whole craft of that run is drawn again, so what is flown is the
distribution less its impossible part; the column `redrawn` says how often. Every run has CANDIDATES
draws, used or not, and a run for which all are impossible is refused.
"""

from dataclasses import replace
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.params import param, require, settings
from rvd_dynamics.diagram.run import Run
from rvd_dynamics.diagram.streams import StartNormals
from rvd_missions.docking.commands import COUNT
from rvd_missions.docking.settings import Chaser

Array = NDArray[np.float64]
CANDIDATES = 8
# normals of one candidate: mass, inertia, products, both panels' modes (frequency, participation),
# tanks (mass, frequency), centre, camera (turn, place), thrusters
MODES, WIDTH = 8, 1 + 3 + 3 + 4*8 + 4 + 3 + 6 + COUNT
PROPERTIES = StartNormals('docking/dynamics/properties', CANDIDATES*WIDTH)


@settings
class Scatter:
    """By how much the craft of a run differs from the one that the settings describe."""

    mass: float = param(0.0, 'Standard deviation of the mass, as a fraction.', low=0.0, high=1.0)
    inertia: float = param(
        0.0, 'Standard deviation of each moment of inertia, as a fraction.', low=0.0, high=1.0)
    products_kg_m2: float = param(
        0.0, 'Greatest change of each product of inertia, all equally likely [kg m^2].', low=0.0,
        high=1e9)
    mode_frequency: float = param(
        0.0, 'Standard deviation of the frequency of each mode of each panel, as a fraction.',
        low=0.0, high=1.0)
    participation: float = param(
        0.0, 'Standard deviation of the participation of each of them, as a fraction.', low=0.0,
        high=1.0)
    slosh_mass: float = param(
        0.0, 'Standard deviation of the liquid that moves in each tank, as a fraction.', low=0.0,
        high=1.0)
    slosh_rad_s: tuple = param(
        (0.0, 0.0), 'Least and greatest frequency of each tank, all between equally likely; 0 and '
        '0 leave those of the tanks [rad/s].', low=0.0, high=100.0, length=2)
    centre_m: float = param(
        0.0, 'Length by which the centre of mass is off along each axis, its sign by chance [m].',
        low=0.0, high=1.0)
    thrust: float = param(
        0.0, 'Standard deviation of the thrust of each thruster, as a fraction.', low=0.0, high=1.0)
    alignment_deg: float = param(
        0.0, 'Standard deviation of the camera\'s alignment about each axis [deg].', low=0.0,
        high=5.0)
    camera_m: float = param(
        0.0, 'Standard deviation of the camera\'s place along each axis [m].', low=0.0, high=0.1)

    def __post_init__(self) -> None:
        low, high = self.slosh_rad_s
        require(low < high or low == high == 0.0, 'slosh_rad_s',
                'be 0 and 0, or rise', list(self.slosh_rad_s))
        require(high == 0.0 or low > 0.0, 'slosh_rad_s[0]', 'be above 0', low)

    @property
    def of_craft(self) -> bool:
        """Whether the craft differs; else there is one for all runs."""
        return any((self.mass, self.inertia, self.products_kg_m2, self.mode_frequency,
                    self.participation, self.slosh_mass, *self.slosh_rad_s))


class Drawn(NamedTuple):
    """What the runs of a batch have; rows N."""

    craft: Any                  # Spacecraft, one for all, or a row each
    centre: Array               # (N, 3) centre of mass in the drawing [m]
    alignment: Array            # (N, 3) turn of the camera [deg]
    camera: Array               # (N, 3) its place from where it should be [m]
    thrust: Array               # (N, T) factor on the thrust of each thruster
    redrawn: NDArray[np.int64]  # (N,) draws that were impossible


def drawn(scatter: Scatter, craft: Any, chaser: Chaser, normals: Array) -> Drawn:
    """
    Return what N runs have, of draws (..., CANDIDATES WIDTH); `craft` is the nominal Spacecraft.

    Raises
    ------
    BadInput
        If no candidate of a run is possible.
    """
    candidates = np.reshape(normals, (-1, CANDIDATES, WIDTH))
    rows = len(candidates)
    chosen, redrawn = candidates[:, 0].copy(), np.zeros(rows, dtype=np.int64)
    if _why_not(scatter, craft, chosen):        # of all at once: most often every one can be
        for row in range(rows):
            for candidate in candidates[row]:
                why = _why_not(scatter, craft, candidate[np.newaxis])
                if not why:
                    break
                redrawn[row] += 1
            else:
                raise BadInput(f'scatter: none of {CANDIDATES} draws of a run is a possible craft; '
                               f'the last: {why}')
            chosen[row] = candidate
    parts = _split(chosen)
    return Drawn(_craft(scatter, craft, chosen) if scatter.of_craft else craft,
                 np.array(chaser.centre_m) + scatter.centre_m*np.sign(parts['centre']),
                 scatter.alignment_deg*parts['alignment'], scatter.camera_m*parts['camera'],
                 1.0 + scatter.thrust*parts['thrust'], redrawn)


def centre(scatter: Scatter, craft: Any, chaser: Chaser, run: Run,
           runs: list[int] | None, batch: tuple) -> Array:
    """Return the centre of mass (*batch, 3) or (3,) of runs, None: of the run's own, [m]."""
    if not scatter.centre_m:
        return np.array(chaser.centre_m)
    normals = PROPERTIES.of_runs(run.seed, [run.run] if runs is None else runs, 1)
    return drawn(scatter, craft, chaser, normals).centre.reshape((*batch, 3))


def _split(normals: Array) -> dict[str, Array]:
    """Return the normals (N, WIDTH) of each part."""
    sizes = {'mass': 1, 'inertia': 3, 'products': 3, 'frequency': 2*MODES,
             'participation': 2*MODES, 'slosh_mass': 2, 'slosh': 2, 'centre': 3, 'alignment': 3,
             'camera': 3, 'thrust': COUNT}
    parts, at = {}, 0
    for name, size in sizes.items():
        parts[name] = normals[:, at:at + size]
        at += size
    return parts


def _why_not(scatter: Scatter, craft: Any, normals: Array) -> str:
    """Return why candidates (N, WIDTH) cannot all be, or nothing."""
    parts = _split(normals)
    for name, sigma, what in (
            ('mass', scatter.mass, 'mass'), ('slosh_mass', scatter.slosh_mass, 'mass of liquid'),
            ('frequency', scatter.mode_frequency, 'frequency of a mode'),
            ('participation', scatter.participation, 'participation of a mode'),
            ('thrust', scatter.thrust, 'thrust')):
        least = float((1.0 + sigma*parts[name]).min())
        if not least > 0.0:
            return f'{what} must be positive, got {least:.3g} of the nominal one'
    try:
        if scatter.of_craft:
            _craft(scatter, craft, normals)
    except BadInput as error:
        return str(error)
    return ''


def _craft(scatter: Scatter, craft: Any, normals: Array) -> Any:
    """Return the craft of draws (N, WIDTH), a row each."""
    from scipy.special import ndtr
    parts, rows = _split(normals), len(normals)
    moments = 1.0 + scatter.inertia*parts['inertia']
    inertia = np.zeros((rows, 3, 3))
    inertia[...] = craft.inertia
    for i in range(3):
        inertia[:, i, i] *= moments[:, i]
    products = scatter.products_kg_m2*(2.0*ndtr(parts['products']) - 1.0)
    for k, (i, j) in enumerate(((0, 1), (0, 2), (1, 2))):
        inertia[:, i, j] += products[:, k]
        inertia[:, j, i] += products[:, k]
    frequency = 1.0 + scatter.mode_frequency*parts['frequency'].reshape(rows, 2, MODES)
    share = 1.0 + scatter.participation*parts['participation'].reshape(rows, 2, MODES)
    liquid = 1.0 + scatter.slosh_mass*parts['slosh_mass']
    low, high = scatter.slosh_rad_s
    slosh = low + (high - low)*ndtr(parts['slosh'])
    return replace(
        craft, mass=craft.mass*(1.0 + scatter.mass*parts['mass'][:, 0]), inertia=inertia,
        panels=tuple(replace(
            p, first_moment=p.first_moment*share[:, i, :p.modes],
            second_moment=p.second_moment*share[:, i, :p.modes],
            frequency=p.frequency*frequency[:, i, :p.modes])
            for i, p in enumerate(craft.panels)),
        tanks=tuple(replace(
            t, mass=t.mass*liquid[:, j], frequency=slosh[:, j] if high else t.frequency)
            for j, t in enumerate(craft.tanks)))
