"""
Scenarios: one ROS parameter file for all nodes, checked before anything starts.

ROS ignores unknown keys silently, reads `2e-4` as a number where YAML says text, and refuses
`step_s: 1` because 1 is whole; so one validator reads scenarios: floats accept whole numbers,
unknown keys are refused with the nearest known one, shared keys stand under `/**` only.
"""

import difflib
from dataclasses import dataclass, field, replace
from pathlib import Path
from typing import Any

import yaml

from rvd_campaign.loop import LoopSettings
from rvd_dynamics.onboard.guard.guard import GuardParams
from rvd_dynamics.link.models import LinkParams
from rvd_dynamics.mission import Mission
from rvd_dynamics.diagram.params import build, dotted, flatten, leaves
from rvd_dynamics.recording.params import MarkerParams, RecorderParams
from rvd_dynamics.world.settings import DynamicsParams, SensorParams
from rvd_groundstation.operators.pilot import PilotParams
from rvd_groundstation.prediction.predictor import PredictorParams
from rvd_groundstation.settings import BlenderParams, ControllerParams, ReplayParams

SHARED = '/**'
SETTINGS = {                    # section of the file: its settings
    SHARED: Mission,
    'spacecraft_dynamics': DynamicsParams,
    'relative_sensor': SensorParams,
    'onboard_guard': GuardParams,
    'link_back': LinkParams,
    'link_forward': LinkParams,
    'state_predictor': PredictorParams,
    'auto_controller': ControllerParams,
    'command_blender': BlenderParams,
    'operator_model': PilotParams,
    'joystick_replay': ReplayParams,
    'bag_recorder': RecorderParams,
    'markers': MarkerParams,
}
MAX_BYTES = 1 << 20             # a scenario is a page; a gigabyte is an accident or an attack
MAX_DEPTH = 20
SET_AT_BRING_UP = {(SHARED, 'nodes'), ('bag_recorder', 'bag_dir')}


class ScenarioError(ValueError):
    """A scenario that cannot be flown; the text is one line that names the value."""


@dataclass(frozen=True)
class Scenario:
    """A checked scenario: the shared mission and the settings of every node."""

    name: str
    sections: dict[str, dict[str, Any]] = field(repr=False)     # dotted keys as given

    def __post_init__(self) -> None:
        for section in SETTINGS:                # build all, so that nothing is found out later
            self.settings(section)

    def settings(self, section: str) -> Any:
        """
        Return the settings of one section, defaults filled in.

        Raises
        ------
        ScenarioError
            If the settings class refuses a value.
        """
        wiring = {} if section == SHARED else {'mission': self.mission}
        if section == 'auto_controller':
            wiring['sharing'] = self.settings('command_blender').selected
        try:
            return build(SETTINGS[section], self.sections.get(section, {}), **wiring)
        except ValueError as error:
            where = '' if section == SHARED else f'{section}: '
            raise ScenarioError(f'scenario {self.name}: {where}{error}') from None

    @property
    def mission(self) -> Mission:
        """The shared settings."""
        return self.settings(SHARED)

    def loop(self) -> LoopSettings:
        """Return what the in-process loop needs to fly this scenario."""
        from rvd_groundstation.operators.tape import read_tape
        replay = self.mission.operator == 'replay'
        return LoopSettings(
            mission=self.mission,
            law=self.settings('auto_controller').selected,
            dynamics=self.settings('spacecraft_dynamics'),
            sensor=self.settings('relative_sensor'),
            link_forward=self.settings('link_forward'),
            link_back=self.settings('link_back'),
            predictor=self.settings('state_predictor'),
            sharing=self.settings('command_blender').selected,
            pilot=self.settings('operator_model'),
            tape=read_tape(self.settings('joystick_replay').tape) if replay else None)

    def with_values(self, section: str, **values: Any) -> 'Scenario':
        """Return a copy in which dotted keys of one section are set (`__` stands for a dot)."""
        named = {key.replace('__', '.'): value for key, value in values.items()}
        check_keys(self.name, section, named)
        sections = dict(self.sections)
        sections[section] = {**sections.get(section, {}), **named}
        return replace(self, sections=sections)

    def resolved(self) -> dict[str, Any]:
        """Return the whole scenario with every default written out, as ROS takes it."""
        tree = {}
        for section, settings in SETTINGS.items():
            wanted = {key for key, _ in leaves(settings)}
            flat = {key: value for key, value in flatten(self.settings(section)).items()
                    if key in wanted and (section, key) not in SET_AT_BRING_UP}
            if flat:
                tree[section] = {'ros__parameters': _nested(flat)}
        return tree

    def dump(self) -> str:
        """Return the resolved scenario as the text of a ROS parameter file."""
        return (f'# Scenario {self.name} as flown, every default resolved.\n'
                + yaml.dump(self.resolved(), Dumper=_Dumper, sort_keys=False))


class _Dumper(yaml.SafeDumper):
    """Writes short lists in one line and floats so that ROS reads floats."""


_Dumper.add_representer(list, lambda d, v: d.represent_sequence(
    'tag:yaml.org,2002:seq', v, flow_style=True))


class _Loader(yaml.SafeLoader):
    """Refuses what a scenario never needs: anchors (bombs) and keys given twice."""

    def compose_node(self, parent: Any, index: Any) -> Any:
        if self.check_event(yaml.events.AliasEvent):
            raise ScenarioError('anchors and aliases are not allowed')
        return super().compose_node(parent, index)

    def construct_mapping(self, node: Any, deep: bool = False) -> dict:
        keys = [key.value for key, _ in node.value]
        twice = {key for key in keys if keys.count(key) > 1}
        if twice:
            raise ScenarioError(f'line {node.start_mark.line + 1}: key given twice: '
                                f'{", ".join(sorted(map(str, twice)))}')
        return super().construct_mapping(node, deep)


def load(path: Path) -> Scenario:
    """
    Read and check a scenario file.

    Raises
    ------
    ScenarioError
        With one line that names the file and what is wrong in it.
    """
    return parse(text_of(path, 'scenario'), path.stem)


def parse(text: str, name: str) -> Scenario:
    """Check the text of a scenario; errors as `load`."""
    tree = mapping_of(text, f'scenario {name}')
    sections = {}
    for section, body in tree.items():
        if section not in SETTINGS:
            raise ScenarioError(f'scenario {name}: no node {section!r}'
                                + nearest(str(section), SETTINGS))
        parameters = body.get('ros__parameters') if isinstance(body, dict) else None
        if not isinstance(parameters, dict) or len(body) != 1:
            raise ScenarioError(f'scenario {name}: {section} must hold ros__parameters: '
                                'and nothing else')
        flat = flat_keys(parameters, f'scenario {name}')
        check_keys(name, section, flat)
        sections[section] = flat
    return Scenario(name, sections)


def check_keys(name: str, section: str, flat: dict[str, Any]) -> None:
    """Refuse unknown keys by name, with the nearest known one."""
    known = [key for key, _ in leaves(SETTINGS[section])]
    shared = {key for key, _ in leaves(Mission)}
    for key in flat:
        if key in known:
            continue
        if section != SHARED and key in shared:
            raise ScenarioError(f'scenario {name}: {section}: {key} is shared by all nodes and '
                                f'stands under {SHARED} only')
        raise ScenarioError(f'scenario {name}: {section}: unknown key {key}'
                            + nearest(key, known))


def text_of(path: Path, what: str) -> str:
    """Return a file that people write, or refuse it in one line."""
    try:
        if path.stat().st_size > MAX_BYTES:
            raise ScenarioError(f'{path} is larger than {MAX_BYTES >> 20} MiB')
        return path.read_text(encoding='utf-8')
    except OSError as error:
        raise ScenarioError(f'cannot read {what} {path}: {error.strerror}') from None
    except UnicodeDecodeError:
        raise ScenarioError(f'{path} is not a text file') from None


def mapping_of(text: str, what: str) -> dict:
    """Return the mapping that a YAML text holds, or refuse it in one line."""
    try:
        tree = yaml.load(text, Loader=_Loader)  # noqa: S506 - a SafeLoader
    except ScenarioError as error:
        raise ScenarioError(f'{what}: {error}') from None
    except RecursionError:
        raise ScenarioError(f'{what}: nested deeper than {MAX_DEPTH}') from None
    except (yaml.YAMLError, ValueError) as error:
        line = ' '.join(str(error).split())
        raise ScenarioError(f'{what} is not valid YAML: {line}') from None
    if not isinstance(tree, dict):
        raise ScenarioError(f'{what} is empty or not a mapping')
    return tree


def nearest(word: str, known: Any) -> str:
    """Return the end of a refusal: the nearest known word, or all of them."""
    close = difflib.get_close_matches(word, list(known), n=1, cutoff=0.5)
    return f'; did you mean {close[0]}?' if close else f'; known: {", ".join(known)}'


def flat_keys(tree: dict, what: str) -> dict[str, Any]:
    """Return nested keys as dotted ones; refuse what cannot be a tree of parameters."""
    _check_tree(tree, what)
    return dotted(tree)


def _check_tree(tree: dict, what: str, depth: int = 0) -> None:
    if depth > MAX_DEPTH:
        raise ScenarioError(f'{what}: nested deeper than {MAX_DEPTH}')
    for key, value in tree.items():
        if not isinstance(key, str):
            raise ScenarioError(f'{what}: key {key} is not text')
        if isinstance(value, dict):
            _check_tree(value, what, depth + 1)


def _nested(flat: dict[str, Any]) -> dict[str, Any]:
    tree: dict[str, Any] = {}
    for key, value in flat.items():
        *path, last = key.split('.')
        branch = tree
        for part in path:
            branch = branch.setdefault(part, {})
        branch[last] = value
    return tree
