"""
Scenarios: one ROS parameter file for all nodes, checked before anything starts.

ROS ignores unknown keys silently, reads `2e-4` as a number where YAML says text, and refuses
`step_s: 1` because 1 is whole; so one validator reads scenarios: floats accept whole numbers,
unknown keys are refused with the nearest known one, shared keys stand under `/**` only.
"""

import difflib
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, lru_cache
from pathlib import Path
from typing import Any

import yaml

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram import mission as missions
from rvd_dynamics.diagram.build import loaded, made, wired
from rvd_dynamics.diagram.diagram import Diagram
from rvd_dynamics.diagram.mission import Mission
from rvd_dynamics.diagram.params import build, dotted, flatten, leaves
from rvd_dynamics.diagram.run import DEFAULT_MISSION, Run
from rvd_dynamics.given import mapping_of, MAX_DEPTH, text_of

SHARED = '/**'
SET_AT_BRING_UP = {(SHARED, 'nodes'), ('bag_recorder', 'bag_dir')}


class ScenarioError(BadInput):
    """A scenario that cannot be flown; the text is one line that names the value."""


@dataclass(frozen=True)
class Scenario:
    """
    A checked scenario of one mission.

    `part(name)` is what blocks ask for: shared settings and what the mission builds of them. A
    copy made by `with_values` keeps the settings that it does not change, so that a campaign
    makes thousands of scenarios in little time.
    """

    name: str
    mission: Mission
    sections: dict[str, dict[str, Any]] = field(repr=False)     # dotted keys as given
    _settings: dict[tuple[str, str], Any] = field(default_factory=dict, repr=False, compare=False)
    _parts: dict[str, Any] = field(default_factory=dict, repr=False, compare=False)

    def __reduce__(self) -> tuple:
        """Travel to another process as it was given; what is built of it is built again there."""
        return Scenario, (self.name, self.mission, self.sections)

    def check(self) -> 'Scenario':
        """
        Build all settings, so that nothing is found out later; return the scenario.

        Raises
        ------
        ScenarioError
            If a value is refused, or two do not fit together.
        """
        for section, name in _groups(self.mission):
            self._get(section, name)
        try:
            for part in self.mission.checked:
                self.part(part)
        except BadInput as error:
            raise ScenarioError(f'scenario {self.name}: {error}') from None
        return self

    def _get(self, section: str, name: str) -> Any:
        found = self._settings.get((section, name))
        if found is None:
            found = self._settings[section, name] = self._built(section, name)
        return found

    def _built(self, section: str, name: str) -> Any:
        text, prefix = _groups(self.mission)[section, name]
        settings = loaded(text)
        given = self.sections.get(section, {})
        if section == SHARED:
            known = _keys(settings)
            given = {key[len(prefix):]: value for key, value in given.items()
                     if key.startswith(prefix) and key[len(prefix):] in known}
        try:
            made = build(settings, given, label=prefix)
            for key, value in given.items():
                if isinstance(value, int) and not -2**63 <= value < 2**63:
                    _check_fits(prefix + key, flatten(made)[key])
            return made
        except BadInput as error:
            where = '' if section == SHARED else f'{section}: '
            raise ScenarioError(f'scenario {self.name}: {where}{error}') from None

    def settings(self, section: str) -> Any:
        """Return the settings of a node's section, defaults filled in; errors as `check`."""
        return self._get(section, '')

    @property
    def run(self) -> Run:
        """Time grid, seed and pace."""
        return self._get(SHARED, 'run')

    def part(self, name: str) -> Any:
        """
        Return shared settings by name, or an object that the mission builds.

        Raises
        ------
        LookupError
            If the mission has nothing of that name.
        """
        if name == 'scenario':
            return self
        if (SHARED, name) in _groups(self.mission):
            return self._get(SHARED, name)
        if name not in self._parts:
            if name not in self.mission.parts:
                raise LookupError(name)
            maker = self.mission.parts[name]
            self._parts[name] = made(maker, self.part, f'mission {self.mission.name}')
        return self._parts[name]

    def has_shared(self, key: str) -> bool:
        """Say whether the mission has this key under `/**`."""
        return self.has_key(SHARED, key)

    def has_key(self, section: str, key: str) -> bool:
        """Say whether a section of the mission has this key."""
        return key in _known(self.mission, section)

    def wired(self, settings: Any) -> Any:
        """Return settings with what they ask for besides parameters; see `diagram.build`."""
        return wired(settings, self.part)

    @cached_property
    def diagram(self) -> Diagram:
        """The blocks and signals of a run of this scenario."""
        return loaded(self.mission.diagram)(self)

    def with_values(self, section: str, **values: Any) -> 'Scenario':
        """Return a copy in which dotted keys of one section are set (`__` stands for a dot)."""
        named = {key.replace('__', '.'): value for key, value in values.items()}
        check_keys(self.name, self.mission, section, named)
        sections = {**self.sections, section: {**self.sections.get(section, {}), **named}}
        if section == SHARED and named.get('mission', self.mission.name) != self.mission.name:
            raise ScenarioError(f'scenario {self.name}: a scenario of mission '
                                f'{self.mission.name} cannot become one of {named["mission"]}')
        changed = {_known(self.mission, section)[key] for key in named}
        kept = {key: settings for key, settings in self._settings.items() if key not in changed}
        return Scenario(self.name, self.mission, sections, kept).check()

    def renamed(self, name: str) -> 'Scenario':
        """Return the scenario under another name."""
        return replace(self, name=name, _settings=dict(self._settings), _parts={})

    def resolved(self) -> dict[str, Any]:
        """Return the whole scenario with every default written out, as ROS takes it."""
        tree: dict[str, Any] = {}
        for (section, name), (settings, prefix) in _groups(self.mission).items():
            wanted = _keys(loaded(settings))
            flat = {prefix + key: value
                    for key, value in flatten(self._get(section, name)).items()
                    if key in wanted and (section, prefix + key) not in SET_AT_BRING_UP}
            if flat:
                body = tree.setdefault(section, {'ros__parameters': {}})['ros__parameters']
                _merge(body, flat)
        return tree

    def dump(self) -> str:
        """Return the resolved scenario as the text of a ROS parameter file."""
        return (f'# Scenario {self.name} as flown, every default resolved.\n'
                + yaml.dump(self.resolved(), Dumper=_Dumper, sort_keys=False))


def _check_fits(key: str, value: Any) -> None:
    """Refuse a whole number that a parameter of ROS cannot hold: nodes would, one by one."""
    if isinstance(value, int):
        raise BadInput(f'{key} must be from -2^63 to 2^63 - 1, got {value}')


@lru_cache(maxsize=None)
def _keys(settings: type) -> frozenset[str]:
    return frozenset(key for key, _ in leaves(settings))


_GROUPS: dict[str, tuple] = {}


def _groups(mission: Mission) -> dict[tuple[str, str], tuple[str, str]]:
    """Return the settings classes by (section, name of shared settings), with key prefixes."""
    kept = _GROUPS.get(mission.name)
    if kept is None or kept[0] is not mission:
        groups = {(SHARED, s.name): (s.settings, s.prefix) for s in mission.shared}
        groups |= {(section, ''): (name, '') for section, name in mission.sections.items()}
        kept = _GROUPS[mission.name] = mission, groups, {}
    return kept[1]


def _known(mission: Mission, section: str) -> Mapping[str, tuple[str, str]]:
    """
    Return the keys that a section may have, and which settings each belongs to.

    Raises
    ------
    LookupError
        If the mission has no such section.
    """
    groups = _groups(mission)
    known = _GROUPS[mission.name][2]
    if section not in known:
        found = {prefix + key: (section, name)
                 for (where, name), (settings, prefix) in groups.items() if where == section
                 for key, _ in leaves(loaded(settings))}
        if not any(where == section for where, _ in groups):
            raise LookupError(section)
        known[section] = found
    return known[section]


def sections_of(mission: Mission, only: Collection[str] = ()) -> dict[str, list[tuple[str, type]]]:
    """Return the settings classes of all or some sections, with the prefixes of their keys."""
    made_of: dict[str, list[tuple[str, type]]] = {}
    for (section, _), (settings, prefix) in _groups(mission).items():
        if section in only or not only:
            made_of.setdefault(section, []).append((prefix, loaded(settings)))
    return made_of


NOT_TEXT = ('y', 'n', 'yes', 'no', 'on', 'off', 'true', 'false', 'inf', 'infinity', 'nan', 'null')


class _Dumper(yaml.SafeDumper):
    """Writes short lists in one line and floats so that ROS reads floats."""


_Dumper.add_representer(list, lambda d, v: d.represent_sequence(
    'tag:yaml.org,2002:seq', v, flow_style=True))


def _text(dumper: _Dumper, text: str) -> Any:
    """
    Quote what ROS, which knows more numbers and truth values than PyYAML, would not read as text.
    """
    bare = re.match('[A-Za-z_/]', text) and text.lower() not in NOT_TEXT
    return dumper.represent_scalar('tag:yaml.org,2002:str', text, style=None if bare else "'")


_Dumper.add_representer(str, _text)


def load(path: Path) -> Scenario:
    """
    Read and check a scenario file.

    Raises
    ------
    ScenarioError
        With one line that names the file and what is wrong in it.
    """
    try:
        text = text_of(path, 'scenario')
    except BadInput as error:
        raise ScenarioError(str(error)) from None
    return parse(text, path.stem)


def parse(text: str, name: str) -> Scenario:
    """Return the scenario in a text, checked; errors as `load`."""
    tree = sections_in(text, f'scenario {name}')
    mission = mission_of(tree, name)
    sections = {}
    for section, body in tree.items():
        if section != SHARED and section not in mission.sections:
            raise ScenarioError(f'scenario {name}: no node {section!r}'
                                + nearest(str(section), (SHARED, *mission.sections)))
        flat = parameters_of(body, section, f'scenario {name}')
        check_keys(name, mission, section, flat)
        sections[section] = flat
    return Scenario(name, mission, sections).check()


def parse_known(text: str, name: str) -> tuple[Scenario, list[str]]:
    """
    Return the scenario in a text of another version, and the keys and nodes that were left out.

    What this version does not know is left out; for all else errors are those of `load`. A text
    without a mission is of the default one only if its nodes are: they cannot tell of another.
    """
    tree = sections_in(text, f'scenario {name}')
    mission = mission_of(tree, name)
    if not _names_mission(tree):
        strange = [str(section) for section in tree
                   if section != SHARED and section not in mission.sections]
        if strange or not tree:
            raise ScenarioError(f'scenario {name}: names no mission'
                                + (f', and {mission.name} has no node {", ".join(strange)}'
                                   if strange else ' and holds nothing'))
    sections, unknown = {}, []
    for section, body in tree.items():
        if section != SHARED and section not in mission.sections:
            unknown.append(str(section))
            continue
        flat = parameters_of(body, section, f'scenario {name}')
        known = _known(mission, section)
        sections[section] = {key: value for key, value in flat.items() if key in known}
        unknown += [f'{section}: {key}' for key in flat if key not in known]
    return Scenario(name, mission, sections).check(), unknown


def mission_of(tree: dict[str, Any], name: str) -> Mission:
    """Return the mission that a scenario's tree names, or refuse it in one line."""
    word = DEFAULT_MISSION                              # what else is wrong is found out later
    if _names_mission(tree):
        word = tree[SHARED]['ros__parameters']['mission']
    try:
        return missions.find(str(word))
    except BadInput as error:
        raise ScenarioError(f'scenario {name}: {error}') from None


def _names_mission(tree: dict[str, Any]) -> bool:
    body = tree.get(SHARED)
    parameters = body.get('ros__parameters') if isinstance(body, dict) else None
    return isinstance(parameters, dict) and 'mission' in parameters


def check_keys(name: str, mission: Mission, section: str, flat: Mapping[str, Any]) -> None:
    """Refuse unknown keys by name, with the nearest known one."""
    known = _known(mission, section)
    for key in flat:
        if key in known:
            continue
        if key == 'use_sim_time':
            raise ScenarioError(f'scenario {name}: {section}: leave out use_sim_time: nodes of a '
                                'run go by its steps and read no clock')
        if section != SHARED and key in _known(mission, SHARED):
            raise ScenarioError(f'scenario {name}: {section}: {key} is shared by all nodes and '
                                f'stands under {SHARED} only')
        raise ScenarioError(f'scenario {name}: {section}: unknown key {key}'
                            + nearest(key, known))


def sections_in(text: str, what: str) -> dict[str, Any]:
    """
    Return what a parameter file holds by the names of nodes, or refuse it in one line.

    As in ROS, `/node` is the node `node`.
    """
    tree: dict[str, Any] = {}
    try:
        given = mapping_of(text, what)
    except BadInput as error:
        raise ScenarioError(str(error)) from None
    for key, body in given.items():
        name = str(key) if key == SHARED else str(key).removeprefix('/')
        if name in tree:
            raise ScenarioError(f'{what}: {name} is given twice, as {name} and as /{name}')
        tree[name] = body
    return tree


def nearest(word: str, known: Any) -> str:
    """Return the end of a refusal: the nearest known word, or all of them."""
    close = difflib.get_close_matches(word, list(known), n=1, cutoff=0.5)
    return f'; did you mean {close[0]}?' if close else f'; known: {", ".join(known)}'


def parameters_of(body: Any, section: str, what: str) -> dict[str, Any]:
    """Return what a section of a parameter file holds, by dotted keys, or refuse it."""
    parameters = body.get('ros__parameters') if isinstance(body, dict) else None
    if not isinstance(parameters, dict) or len(body) != 1:
        raise ScenarioError(f'{what}: {section} must hold ros__parameters: and nothing else')
    return flat_keys(parameters, what)


def flat_keys(tree: dict, what: str) -> dict[str, Any]:
    """Return nested keys as dotted ones; refuse what cannot be a tree of parameters."""
    _check_tree(tree, what)
    try:
        return dotted(tree)
    except BadInput as error:
        raise ScenarioError(f'{what}: {error}') from None


def _check_tree(tree: dict, what: str, depth: int = 0) -> None:
    if depth > MAX_DEPTH:
        raise ScenarioError(f'{what}: nested deeper than {MAX_DEPTH}')
    for key, value in tree.items():
        if not isinstance(key, str):
            raise ScenarioError(f'{what}: key {key} is not text')
        if isinstance(value, dict):
            _check_tree(value, what, depth + 1)
        if value == {}:
            raise ScenarioError(f'{what}: {key} holds nothing: give it a value or leave it out')


def _merge(tree: dict[str, Any], flat: dict[str, Any]) -> None:
    """Put dotted keys into a tree."""
    for key, value in flat.items():
        *path, last = key.split('.')
        branch = tree
        for part in path:
            branch = branch.setdefault(part, {})
        branch[last] = value
