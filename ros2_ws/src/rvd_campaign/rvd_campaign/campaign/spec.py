"""
The campaign file: which conditions are flown, how often, and with which seed.

    scenario: paper             # base: a name in `rvd list scenarios` or a file
    seed: 1
    runs: 10000                 # of each condition
    set: CHANGES                # in every condition
    conditions: {NAME: CHANGES}
    grid: {AXIS: VALUES}        # every condition times every cell
    compare: [[NAME, NAME]]     # differences to state; left out: each with the first
    replicates: {operators: 10, runs: 10}
    sample: {latin_hypercube: 240, sobol: 32, numbers: {...}}   # see `sample`
    accept: {reference: WORDS, standard_errors: 2}              # points that agree; `ensemble`
    fitted: {NAME: WORDS}       # conditions whose result was fitted, and to what
    reference: {WORDS: {condition: NAME, runs: 100, successes: 76, means: {...}}}
    confirm: {seed: 2, runs: 10000}     # see `claims`, as for more of a reference
    beside: {FILE: {NAME: NAME}}        # what other campaigns say; see `beside`
    figures: [NAME], notes: [WORDS]

CHANGES maps a section of the scenario to its keys, and knows short words: `loop_delay_s`, where
the mission's link has two delays, and those of the mission (the lunar approach has `pilot`: A, B,
C or a file of `rvd calibrate`). An AXIS is a key with its section
(`command_blender.eq25.eta: [0.5, 0.7]`), a short word, or a name with labelled CHANGES. Later
ones win: set, condition, axes in their order. Every condition is built before the first run.
"""

import itertools
import os
import re
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from rvd_campaign import catalogue
from rvd_campaign.campaign import beside, sample as sampling
from rvd_campaign.campaign.checked import (
    Campaign, CampaignError, changed, check_runs, Condition, MAX_CONDITIONS, runs_per_person)
from rvd_campaign.campaign.claims import Confirmation, confirmation, reference
from rvd_campaign.campaign.grid import Cells, legs
from rvd_campaign.campaign.sample import Sample
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram import in_process
from rvd_dynamics.diagram.build import loaded
from rvd_dynamics.diagram.mission import Mission
from rvd_dynamics.diagram.scenario import (
    flat_keys, load, nearest, Scenario, ScenarioError, SHARED)
from rvd_dynamics.given import mapping_of, text_of

KEYS = ('scenario', 'seed', 'runs', 'set', 'conditions', 'grid', 'compare', 'replicates', 'fitted',
        'reference', 'confirm', 'figures', 'notes', 'sample', 'accept', 'beside')
LOOP_DELAY = 'loop_delay_s'             # the short word for both delays of the link
DELAYS = ('forward_delay_s', 'back_delay_s')
OF_THE_CAMPAIGN = ('mission', 'seed', 'run', 'nodes', 'processes')  # no condition may change them
NAME = re.compile(r'[A-Za-z0-9][\w.+ -]*')


def load_campaign(name: str, runs: int | None = None) -> Campaign:
    """
    Read and check a campaign: a file, or a shipped one by its name.

    Raises
    ------
    ValueError
        With one line that names the campaign and what is wrong in it.
    """
    path = catalogue.find('campaigns', name, ('.yaml',))
    return parse_campaign(text_of(path, 'campaign'), path.stem, path.parent, runs)


def parse_campaign(text: str, name: str, folder: Path = Path(), runs: int | None = None
                   ) -> Campaign:
    """Check the text of a campaign file that lies in `folder`; errors as `load_campaign`."""
    return _Reader(name, folder).read(text, runs)


class _Reader:
    """Turns the text of one campaign file into a campaign."""

    def __init__(self, name: str, folder: Path) -> None:
        self._what = f'campaign {name}'
        self._name, self._folder = name, folder
        self._words: tuple[str, ...] = ()       # short words
        self._sections: tuple[str, ...] = ()

    def read(self, text: str, runs: int | None) -> Campaign:
        """Return the checked campaign; `runs` takes the place of those in the file."""
        tree = mapping_of(text, self._what)
        for key in tree:
            if key not in KEYS:
                self._refuse(f'unknown key {key}' + nearest(str(key), KEYS))
        seed = tree.get('seed', 0)
        if isinstance(seed, bool) or not isinstance(seed, int) or not 0 <= seed < 2**63:
            self._refuse(f'seed must be a whole number from 0 to 2^63 - 1, got {seed}')
        scenario = self._scenario(tree.get('scenario', 'paper'), seed)
        groups = self._groups(tree.get('conditions', {'all': None}))
        cells = self._cells(tree.get('grid', {}), len(groups))
        asked, runs = runs, tree.get('runs', 1000) if runs is None else runs
        try:
            check_runs(runs, len(groups)*cells.count)
        except CampaignError as error:
            self._refuse(str(error))
        base = self._changed(scenario, 'set', tree.get('set'))
        conditions = tuple(self._conditions(base, groups, cells, 'conditions' in tree))
        names = [c.name for c in conditions]
        others = self._beside(tree.get('beside'), names)
        rows = beside.with_design_effects(self._reference(tree.get('reference'), names), others)
        sample, accept, points = self._sample(tree, conditions, rows, seed, runs)
        return Campaign(
            self._name, _title(text), seed, runs, (*conditions, *points),
            self._replicates(tree.get('replicates'), runs, conditions),
            self._pairs(tree.get('compare'), names),
            self._texts('fitted', tree.get('fitted'), names),
            rows, self._figures(base.mission, tree.get('figures', [])),
            self._notes(tree.get('notes', [])), text, self._confirm(tree, runs, asked, conditions),
            sample, accept, tuple(others))

    def _refuse(self, words: str) -> None:
        raise CampaignError(f'{self._what}: {words}')

    # -- conditions -----------------------------------------------------------------------

    def _scenario(self, name: Any, seed: int) -> Scenario:
        """Return the scenario that everything is a change of; it brings the words and sections."""
        beside = self._folder / str(name)
        path = beside if os.path.isfile(beside) else catalogue.find(
            'scenarios', str(name), ('.yaml',))
        base = load(path).with_values(SHARED, seed=seed, run=0)
        delays = (LOOP_DELAY,) if all(map(base.has_shared, DELAYS)) else ()
        self._words = (*base.mission.short_words, *delays)
        self._sections = (SHARED, *base.mission.sections)
        return base

    def _groups(self, groups: Any) -> dict[str, Any]:
        if not isinstance(groups, dict) or not groups:
            self._refuse('conditions must map names to changes')
        for name in groups:
            if not isinstance(name, str) or not NAME.fullmatch(name):
                self._refuse(f'a condition cannot be named {name!r}: letters, digits, space and '
                             '_ . + - only')
        return groups

    def _cells(self, grid: Any, groups: int) -> Cells:
        if not isinstance(grid, dict):
            self._refuse('grid must map axes to values')
        axes = {}
        for name, values in grid.items():
            if not isinstance(name, str):
                self._refuse(f'grid axis {name} must be text')
            if isinstance(values, list) and values:
                axes[name] = [(value, self._one_key(str(name), value)) for value in values]
            elif isinstance(values, dict) and values:
                axes[name] = list(values.items())
            else:
                self._refuse(f'grid axis {name} must be a list of values or map labels to '
                             f'changes, got {values!r}')
        cells = Cells(axes)
        if groups * cells.count > MAX_CONDITIONS:
            self._refuse(f'{groups} conditions times a grid of {cells.count:,} cells are '
                         f'{groups * cells.count:,} conditions; the limit is {MAX_CONDITIONS:,}')
        return cells

    def _one_key(self, axis: str, value: Any) -> dict[str, Any]:
        """Return the change that one value of an axis means."""
        if axis in self._words:
            return {axis: value}
        for section in self._sections:
            if axis.startswith(f'{section}.'):
                return {section: {axis[len(section) + 1:]: value}}
        known = [*self._words, *(f'{section}.' for section in self._sections)]
        self._refuse(f'grid axis {axis} must begin with a section of the scenario'
                     + nearest(axis, known))

    def _conditions(self, base: Scenario, groups: dict[str, Any], cells: Cells,
                    named: bool) -> Iterator[Condition]:
        seen = set()
        for group, changes in groups.items():
            of_group = self._changed(base, group, changes)
            for cell in cells:
                label = ','.join(f'{cells.short(axis)}={_shown(value)}'
                                 for axis, (value, _) in cell.items())
                name = ','.join(part for part in (group if named or not label else '', label)
                                if part)
                scenario = of_group
                for _, change in cell.values():
                    scenario = self._changed(scenario, name, change)
                if name in seen:
                    self._refuse(f'two conditions are named {name}')
                seen.add(name)
                self._buildable(name, scenario)
                yield Condition(name, scenario, {a: v for a, (v, _) in cell.items()}, group)

    def _buildable(self, name: str, scenario: Scenario) -> None:
        try:
            in_process.check(scenario)
        except BadInput as error:
            self._refuse(f'condition {name}: {_bare(error)}')

    def _changed(self, scenario: Scenario, where: str, changes: Any) -> Scenario:
        """Return the scenario with changes made in it."""
        if changes is None:
            return scenario
        try:
            if not isinstance(changes, dict):
                raise ScenarioError(f'changes must map sections to keys, got {changes!r}')
            for key in sorted(changes, key=lambda k: k not in self._words):
                scenario = self._change(scenario, key, changes[key])
        except CampaignError:
            raise
        except BadInput as error:
            self._refuse(f'condition {where}: {_bare(error)}' if where != 'set'
                         else f'set: {_bare(error)}')
        return scenario

    def _change(self, scenario: Scenario, key: Any, value: Any) -> Scenario:
        if key in scenario.mission.short_words:
            return changed(scenario, loaded(scenario.mission.short_words[key])(value, self._folder))
        if key == LOOP_DELAY and key in self._words:
            return scenario.with_values(SHARED, **legs(value, scenario.run.step_s))
        if key not in self._sections:
            raise ScenarioError(f'no section {key!r}'
                                + nearest(str(key), (*self._sections, *self._words)))
        if not isinstance(value, dict):
            raise ScenarioError(f'{key} must map keys to values, got {value!r}')
        flat = flat_keys(value, self._what)
        for name in OF_THE_CAMPAIGN:
            if key == SHARED and name in flat:
                raise ScenarioError(f'{name} belongs to the campaign, not to a condition')
        return changed(scenario, {key: flat})

    # -- what is said about the conditions --------------------------------------------------

    def _replicates(self, value: Any, runs: int, conditions: tuple) -> tuple[int, int] | None:
        if value is None:
            return None
        if (not isinstance(value, dict) or set(value) != {'operators', 'runs'}
                or not all(type(n) is int and n >= 1 for n in value.values())):
            self._refuse('replicates must be {operators: N, runs: M}, whole numbers, '
                         f'got {value!r}')
        size = value['operators'] * value['runs']
        if runs % size:
            self._refuse(f'runs must be a multiple of {size}, one replicate, got {runs}')
        for condition in conditions:
            for each in runs_per_person(condition.scenario):
                if each != value['runs']:
                    self._refuse(f'condition {condition.name}: runs_per_operator is {each}, the '
                                 f'replicates say {value["runs"]}')
        return value['operators'], value['runs']

    def _pairs(self, pairs: Any, names: list[str]) -> tuple[tuple[str, str], ...]:
        if pairs is None:
            return tuple((name, names[0]) for name in names[1:])
        if not isinstance(pairs, list) or not all(isinstance(p, list) and len(p) == 2
                                                  for p in pairs):
            self._refuse('compare must be a list of pairs of conditions')
        for name in itertools.chain(*pairs):
            self._known('compare', name, names)
        return tuple((a, b) for a, b in pairs)

    def _texts(self, key: str, texts: Any, names: list[str]) -> dict[str, str]:
        if texts is None:
            return {}
        if not isinstance(texts, dict):
            self._refuse(f'{key} must map conditions to words')
        for name in texts:
            self._known(key, name, names)
        return {name: str(words) for name, words in texts.items()}

    def _sample(self, tree: dict, conditions: tuple, reference: dict[str, dict], seed: int,
                runs: int) -> tuple[Sample | None, dict[str, Any], list[Condition]]:
        """Return the sample, which points are accepted, and every condition at every point."""
        try:
            sample = sampling.parsed(tree.get('sample'), conditions[0].scenario)
            check_runs(runs, len(conditions)*(1 + (sample.count if sample else 0)))
            accept = sampling.acceptance(tree.get('accept'), sample, reference)
            return sample, accept, [
                c.at_point(point, changes) for point, changes in enumerate(
                    sample.changes(seed) if sample else ()) for c in conditions]
        except BadInput as error:
            self._refuse(_bare(error))

    def _beside(self, given: Any, names: list[str]) -> list[dict[str, Any]]:
        try:
            return beside.parsed(given, self._folder, names)
        except BadInput as error:
            self._refuse(str(error))

    def _reference(self, rows: Any, names: list[str]) -> dict[str, dict]:
        if rows is None:
            return {}
        for label, row in rows.items() if isinstance(rows, dict) else [('', None)]:
            try:
                reference(label, row)
            except BadInput as error:
                self._refuse(str(error))
            if 'condition' in row:
                self._known('reference', row['condition'], names)
        return {str(label): row for label, row in rows.items()}

    def _confirm(self, tree: dict, runs: int, asked: int | None, conditions: tuple
                 ) -> Confirmation | None:
        try:
            found = confirmation(tree.get('confirm'), tree.get('seed', 0), runs, asked)
            if found:
                check_runs(found.runs, len(conditions))
        except BadInput as error:
            self._refuse(str(error))
        if found:
            self._replicates(tree.get('replicates'), found.runs, conditions)
        return found

    def _figures(self, mission: Mission, wanted: Any) -> tuple[str, ...]:
        from rvd_campaign.campaign.figures import figures_of
        known = figures_of(mission)
        for name in wanted if isinstance(wanted, list) else [wanted]:
            if not isinstance(name, str) or name not in known:
                self._refuse(f'unknown figure {name}' + nearest(str(name), known))
        return tuple(wanted)

    def _notes(self, notes: Any) -> tuple[str, ...]:
        if not isinstance(notes, list):
            self._refuse('notes must be a list of sentences')
        return tuple(str(note) for note in notes)

    def _known(self, key: str, name: Any, names: list[str]) -> None:
        if name not in names:
            self._refuse(f'{key}: no condition {name!r}' + nearest(str(name), names))


def _bare(error: ValueError) -> str:
    """Return the words of a refusal without the name of the base scenario."""
    return re.sub(r'^scenario [^:]*: ', '', str(error))


def _shown(value: Any) -> str:
    return f'{value:g}' if isinstance(value, float) else str(value)


def _title(text: str) -> str:
    first = text.splitlines()[0] if text else ''
    return first.lstrip('# ').strip() if first.startswith('#') else ''
