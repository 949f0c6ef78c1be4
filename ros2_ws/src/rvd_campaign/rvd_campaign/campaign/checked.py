"""
A campaign that was checked: conditions, and what is said about them; as a folder keeps it.
"""

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from typing import Any

from rvd_campaign.campaign import beside, sample as sampling
from rvd_campaign.campaign.claims import Confirmation
from rvd_campaign.campaign.sample import Sample
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.mission import Mission
from rvd_dynamics.diagram.scenario import nearest, parse, Scenario, SHARED

MAX_CONDITIONS = 1000
MAX_RUNS = 10_000_000           # of all conditions; a table of 2 GB

KEPT_SHAPE = {                  # of what `Campaign.as_dict` wrote
    'name': str, 'title': str, 'seed': int, 'runs': int, 'replicates': (list, type(None)),
    'compare': [[str, 2]], 'fitted': {'': str}, 'figures': [str], 'notes': [str], 'text': str,
    'reference': {'': {'runs': int, 'successes': int, 'means?': {'': (int, float)}}},
    'confirm?': (dict, type(None)),
    'conditions': [{'name': str, 'group': str, 'at': dict, 'scenario?': str, 'base?': str,
                    'point?': int, 'changes?': {'': {'': float}}}],
    'sample?': sampling.SHAPE,
    'accept?': {'reference?': str, 'standard_errors?': (int, float)}, 'beside?': beside.SHAPE}


class CampaignError(BadInput):
    """A campaign that cannot be flown; the text is one line that names the value."""


@dataclass(frozen=True)
class Condition:
    """One cell of a campaign."""

    name: str
    scenario: Scenario                  # with the seed of the campaign
    at: dict[str, Any]                  # the place in the grid: axis and value
    group: str                          # the name without the grid
    point: int | None = None            # of the sample, and with it:
    base: str = ''                      # the condition that is flown there
    changes: dict[str, dict[str, float]] = field(default_factory=dict)  # section, key, value

    def as_dict(self) -> dict[str, Any]:
        """Return what a folder keeps: at a point of the sample only what is other than in base."""
        kept = {'name': self.name, 'group': self.group, 'at': self.at}
        if self.point is None:
            return {**kept, 'scenario': self.scenario.dump()}
        return {**kept, 'base': self.base, 'point': self.point, 'changes': self.changes}

    def at_point(self, point: int, changes: dict[str, dict[str, float]]) -> 'Condition':
        """Return the condition as it is flown at a point of the sample."""
        return Condition(f'{self.name},sample={point}', changed(self.scenario, changes), self.at,
                         self.group, point, self.name, changes)


@dataclass(frozen=True)
class Campaign:
    """A checked campaign."""

    name: str
    title: str
    seed: int
    runs: int
    conditions: tuple[Condition, ...]
    replicates: tuple[int, int] | None = None           # operators, runs of each
    compare: tuple[tuple[str, str], ...] = ()
    fitted: dict[str, str] = field(default_factory=dict)
    reference: dict[str, dict] = field(default_factory=dict)
    figures: tuple[str, ...] = ()
    notes: tuple[str, ...] = ()
    text: str = field(default='', repr=False)           # the file as it was written
    confirm: Confirmation | None = None
    sample: Sample | None = None
    accept: dict[str, Any] = field(default_factory=dict)
    beside: tuple[dict[str, Any], ...] = ()             # of other campaigns; `beside`

    def __post_init__(self) -> None:
        check_runs(self.runs, len(self.conditions))

    @property
    def mission(self) -> Mission:
        """The mission that is flown, the same in all conditions."""
        return self.conditions[0].scenario.mission

    @property
    def again(self) -> 'Campaign | None':
        """The campaign that confirms this one, without a sample; None: there is none."""
        if self.confirm is None:
            return None
        seed = self.confirm.seed
        return replace(
            self, seed=seed, runs=self.confirm.runs, confirm=None, sample=None, accept={},
            conditions=tuple(replace(c, scenario=c.scenario.with_values(SHARED, seed=seed))
                             for c in self.conditions if c.point is None))

    def condition(self, name: str) -> Condition:
        """Return a condition by its name, or refuse it with the nearest one."""
        for condition in self.conditions:
            if condition.name == name:
                return condition
        raise CampaignError(f'campaign {self.name} has no condition {name!r}'
                            + nearest(name, [c.name for c in self.conditions]))

    def as_dict(self) -> dict[str, Any]:
        """Return everything that a folder keeps, every default resolved."""
        return {
            'name': self.name, 'title': self.title, 'seed': self.seed, 'runs': self.runs,
            'replicates': self.replicates, 'compare': self.compare, 'fitted': self.fitted,
            'reference': self.reference, 'figures': self.figures, 'notes': self.notes,
            'text': self.text, 'confirm': vars(self.confirm) if self.confirm else None,
            'conditions': [c.as_dict() for c in self.conditions], 'beside': self.beside,
            **({'sample': self.sample.as_dict(), 'accept': self.accept} if self.sample else {})}


def from_dict(kept: Mapping[str, Any]) -> Campaign:
    """Return the campaign that `Campaign.as_dict` wrote."""
    made: dict[str, Condition] = {}
    for c in kept['conditions']:
        made[c['name']] = made[c['base']].at_point(c['point'], c['changes']) if 'point' in c else (
            Condition(c['name'], parse(c['scenario'], c['name']), c['at'], c['group']))
    return Campaign(
        kept['name'], kept['title'], kept['seed'], kept['runs'], tuple(made.values()),
        tuple(kept['replicates']) if kept['replicates'] else None,
        tuple(tuple(pair) for pair in kept['compare']), kept['fitted'], kept['reference'],
        tuple(kept['figures']), tuple(kept['notes']), kept['text'],
        Confirmation(**kept['confirm']) if kept.get('confirm') else None,
        sampling.from_dict(kept['sample']) if 'sample' in kept else None, kept.get('accept', {}),
        tuple(kept.get('beside', ())))


def changed(scenario: Scenario, changes: Mapping[str, Mapping[str, Any]]) -> Scenario:
    """Return the scenario with other values: section, key (`eq25.eta` is one), value."""
    for section, flat in changes.items():
        scenario = scenario.with_values(
            section, **{key.replace('.', '__'): value for key, value in flat.items()})
    return scenario


def runs_per_person(scenario: Scenario) -> list[int]:
    """Return in how many consecutive runs each model pilot of a scenario is the same person."""
    return [draw.runs_per_operator for block in scenario.diagram.blocks
            for draw in block.draws.values() if hasattr(draw, 'runs_per_operator')]


def check_runs(runs: Any, conditions: int) -> None:
    """Refuse an impossible number of runs per condition."""
    if isinstance(runs, bool) or not isinstance(runs, int) or runs < 1:
        raise CampaignError(f'runs must be a whole number, at least 1, got {runs}')
    if runs * conditions > MAX_RUNS:
        raise CampaignError(f'{conditions} conditions of {runs:,} runs are {runs*conditions:,} '
                            f'runs; the limit is {MAX_RUNS:,}')
