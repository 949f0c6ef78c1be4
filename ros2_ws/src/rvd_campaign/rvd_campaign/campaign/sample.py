"""
Points of a campaign: what is not known of a scenario's numbers, as a design over their ranges.

    sample:
      latin_hypercube: 240      # points, for bands
      sobol: 32                 # base of Saltelli's design, for indices: 32 (groups + 2) points
      numbers:
        GROUP:                  # numbers that are attributed together
          operator_model.skill_gain: 0.3                # 30 % either way of its value
          operator_model.skill_spread: [0.2, 0.5]       # from, to

Without groups each number is one by itself. Every condition is flown as it is, and once at each
point. Within its range a number is uniform, and independent of the others.

Chance  of the designs: streams of their own, keyed by the campaign's seed.
Source  M. D. McKay, R. J. Beckman, W. J. Conover, Technometrics 21, 1979, 239-245 (scipy's);
        A. Saltelli et al., Comput. Phys. Commun. 181, 2010, 259-270 (SALib's).
"""

from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram import streams
from rvd_dynamics.diagram.params import flatten
from rvd_dynamics.diagram.scenario import nearest, Scenario, SHARED

MAX_POINTS = 5000
DESIGNS = ('latin_hypercube', 'sobol')
DIGITS = 6                              # of a number at a point: what is flown is what is written


@dataclass(frozen=True)
class Number:
    """A number of the scenario and its range."""

    section: str
    key: str
    low: float
    high: float
    group: str

    @property
    def name(self) -> str:
        """Section and key."""
        return f'{self.section}.{self.key}'


@dataclass(frozen=True)
class Sample:
    """Ranges and designs; points count from 0, those of the Latin hypercube first."""

    numbers: tuple[Number, ...]
    latin_hypercube: int = 0            # points
    sobol: int = 0                      # base of the design

    @property
    def groups(self) -> tuple[str, ...]:
        """What variance is attributed to, in the order of the file."""
        return tuple(dict.fromkeys(n.group for n in self.numbers))

    @property
    def sobol_points(self) -> int:
        """Number of points of Saltelli's design."""
        return self.sobol * (len(self.groups) + 2)

    @property
    def count(self) -> int:
        """Number of points of both designs."""
        return self.latin_hypercube + self.sobol_points

    @property
    def problem(self) -> dict[str, Any]:
        """The ranges as SALib wants them."""
        return {'num_vars': len(self.numbers), 'names': [n.name for n in self.numbers],
                'groups': [n.group for n in self.numbers],
                'bounds': [[n.low, n.high] for n in self.numbers]}

    def points(self, seed: int) -> NDArray[np.float64]:
        """Return the values (points, numbers) of all numbers at all points."""
        low, high = np.array([(n.low, n.high) for n in self.numbers]).T
        made = []
        if self.latin_hypercube:
            from scipy.stats import qmc
            chance = streams.generator(seed, 0, 'campaign/sample/latin_hypercube')
            cube = qmc.LatinHypercube(len(low), seed=chance).random(self.latin_hypercube)
            made.append(low + (high - low)*cube)
        if self.sobol:
            from SALib.sample import sobol
            chance = streams.generator(seed, 0, 'campaign/sample/sobol')
            made.append(sobol.sample(self.problem, self.sobol, calc_second_order=False,
                                     seed=int(chance.integers(2**31))))
        return np.concatenate(made)

    def changes(self, seed: int) -> Iterator[dict[str, dict[str, float]]]:
        """Yield what each point changes: section, key, value."""
        for values in self.points(seed):
            tree: dict[str, dict[str, float]] = {}
            for number, value in zip(self.numbers, values.tolist()):
                tree.setdefault(number.section, {})[number.key] = float(f'{value:.{DIGITS}g}')
            yield tree

    def as_dict(self) -> dict[str, Any]:
        """Return what a folder keeps."""
        return {'latin_hypercube': self.latin_hypercube, 'sobol': self.sobol,
                'numbers': [vars(n) for n in self.numbers]}


SHAPE = {'latin_hypercube': int, 'sobol': int, 'numbers': [
    {'section': str, 'key': str, 'low': (int, float), 'high': (int, float), 'group': str}]}


def from_dict(kept: Mapping[str, Any]) -> Sample:
    """Return what `Sample.as_dict` wrote."""
    return Sample(tuple(Number(**n) for n in kept['numbers']), kept['latin_hypercube'],
                  kept['sobol'])


def parsed(given: Any, base: Scenario) -> Sample | None:
    """
    Return the sample that a campaign file asks for around a scenario; None: it asks for none.

    Raises
    ------
    BadInput
        If it is none; the text names the value.
    """
    if given is None:
        return None
    if not isinstance(given, dict) or not isinstance(given.get('numbers'), dict):
        raise BadInput(f'sample must have designs and numbers, got {given!r}')
    for key in given:
        if key not in (*DESIGNS, 'numbers'):
            raise BadInput(f'sample: unknown key {key}' + nearest(str(key), (*DESIGNS, 'numbers')))
    sizes = {design: given.get(design, 0) for design in DESIGNS}
    for design, size in sizes.items():
        if type(size) is not int or not 0 <= size <= MAX_POINTS:
            raise BadInput(f'sample: {design} must be a whole number from 0 to {MAX_POINTS}, '
                           f'got {size}')
    sobol = sizes['sobol']
    if sobol & (sobol - 1):
        raise BadInput(f'sample: sobol must be a power of two, got {sobol}')
    made = Sample(tuple(_numbers(given['numbers'], base)), **sizes)
    if not made.numbers:
        raise BadInput('sample: numbers are empty')
    if not 1 <= made.count <= MAX_POINTS:
        raise BadInput(f'sample: the designs have {made.count:,} points; give 1 to {MAX_POINTS:,}')
    return made


def acceptance(given: Any, sample: Sample | None, reference: Mapping[str, dict]
               ) -> dict[str, Any]:
    """Return which points a campaign file accepts, empty if it says nothing; errors as `parsed`."""
    if given is None:
        return {}
    if (not isinstance(given, dict) or set(given) != {'reference', 'standard_errors'}
            or not _is_number(given['standard_errors']) or not given['standard_errors'] > 0):
        raise BadInput('accept must be {reference: WORDS, standard_errors: NUMBER}, '
                       f'got {given!r}')
    if sample is None or not sample.latin_hypercube:
        raise BadInput('accept needs a sample with a latin_hypercube')
    name = given['reference']
    if name not in reference:
        raise BadInput(f'accept: no reference {name!r}' + nearest(str(name), reference))
    if 'condition' not in reference[name]:
        raise BadInput(f'accept: reference {name} names no condition')
    return dict(given)


def _numbers(tree: dict[str, Any], base: Scenario) -> Iterator[Number]:
    seen = set()
    for name, value in tree.items():
        grouped = value if isinstance(value, dict) else {name: value}
        for full, extent in grouped.items():
            if full in seen:
                raise BadInput(f'sample: {full} is given twice')
            seen.add(full)
            yield _number(str(full), extent, str(name), base)


def _number(full: str, extent: Any, group: str, base: Scenario) -> Number:
    sections = sorted((SHARED, *base.mission.sections), key=len, reverse=True)
    section = next((s for s in sections if full.startswith(f'{s}.')), None)
    if section is None:
        raise BadInput(f'sample: {full} must begin with a section of the scenario'
                       + nearest(full, [f'{s}.' for s in sections]))
    key = full[len(section) + 1:]
    known = flatten(base.settings(section)) if section != SHARED else base.resolved()[SHARED]
    value = known.get(key)
    if type(value) is not float:
        raise BadInput(f'sample: {full} is no number of the scenario'
                       + nearest(key, [k for k, v in known.items() if type(v) is float]))
    if isinstance(extent, list) and len(extent) == 2 and all(map(_is_number, extent)):
        low, high = map(float, extent)
    elif _is_number(extent) and 0.0 < extent < 1.0:
        low, high = sorted((value*(1.0 - extent), value*(1.0 + extent)))
    else:
        raise BadInput(f'sample: {full} must be a fraction between 0 and 1 or [low, high], '
                       f'got {extent!r}')
    if not low < high:
        raise BadInput(f'sample: {full} has no range: {low:g} to {high:g}')
    return Number(section, key, low, high, group)


def _is_number(value: Any) -> bool:
    return type(value) in (int, float) and np.isfinite(value)
