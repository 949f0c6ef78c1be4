"""
The command line of a node process, as ROS 2 writes it: parameter files, overrides, the name.

Every process of a run is given the same parameter file and reads the scenario from it, whole:
what two nodes must know stands in it once. rclpy reads the same arguments for the parameters that
it serves.
"""

from dataclasses import dataclass, field
from functools import cached_property
from pathlib import Path
from typing import Any

from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram import scenario as scenarios
from rvd_dynamics.diagram.identity import own_run
from rvd_dynamics.diagram.params import dotted
from rvd_dynamics.diagram.scenario import check_keys, nearest, Scenario, SHARED
from rvd_dynamics.given import NotYaml, text_of, value_of

OF_THE_PROCESS = ('group',)             # parameters that are no part of the scenario


@dataclass(frozen=True)
class Arguments:
    """What a process was told."""

    executable: str                     # name under which it was started
    name: str                           # of the node; the executable's unless remapped
    files: tuple[Path, ...] = ()
    overrides: tuple[tuple[str, str, Any], ...] = ()        # node or '', key, value
    process: dict[str, Any] = field(default_factory=dict)   # OF_THE_PROCESS
    run_id: str = '/'                   # enclave of the run; see `diagram.identity`

    @cached_property
    def scenario(self) -> Scenario:
        """
        The scenario of the run; of its settings only those are built that are asked for.

        Raises
        ------
        ValueError
            If a file cannot be read or is no parameter file, a key that this process knows is
            wrong, or what the mission checks does not fit together.
        """
        tree = self._tree()
        shared = tree.setdefault(SHARED, {})
        named = [value for node, key, value in self.overrides if (node, key) == ('', 'mission')]
        mission = scenarios.mission_of(
            {SHARED: {'ros__parameters': {**shared, **({'mission': named[-1]} if named else {})}}},
            self._title())
        sections = {section: values for section, values in tree.items()
                    if section == SHARED or section in mission.sections}
        made = Scenario(self._title(), mission, sections)
        for node, key, value in self.overrides:
            section = self._section(made, node, key)
            check_keys(made.name, mission, section, {key: value})
            sections.setdefault(section, {})[key] = value
        for section in {SHARED, self.name} & set(sections):
            check_keys(made.name, mission, section, sections[section])
        made = Scenario(self._title(), mission, sections)
        for part in mission.checked:
            made.part(part)
        return made

    def _tree(self) -> dict[str, dict[str, Any]]:
        """Return what the parameter files say, by section and dotted key; a later file wins."""
        tree: dict[str, dict[str, Any]] = {}
        for file in self.files:
            text = text_of(file, 'parameter file')
            for name, body in scenarios.sections_in(text, str(file)).items():
                if name not in (SHARED, self.name):         # of another node: its own business
                    values = body.get('ros__parameters') if isinstance(body, dict) else None
                    flat = dotted(values) if isinstance(values, dict) else {}
                else:
                    flat = scenarios.parameters_of(body, name, str(file))
                tree.setdefault(name, {}).update(flat)
        return tree

    def _section(self, scenario: Scenario, node: str, key: str) -> str:
        """Return the section that an override means: that of a node, where it names one."""
        if not node:
            own = self.name in scenario.mission.sections
            return self.name if own and scenario.has_key(self.name, key) else SHARED
        if node != SHARED and node not in scenario.mission.sections:
            raise BadInput(f'-p {node}:{key}: no node {node!r} has parameters of its own'
                           + nearest(node, scenario.mission.sections))
        return node

    def _title(self) -> str:
        return self.files[0].stem if self.files else 'default'

    def text(self) -> str:
        """Return the text of the first parameter file, empty when there is none."""
        return text_of(self.files[0], 'parameter file') if self.files else ''


def parsed(argv: list[str]) -> Arguments:
    """
    Return what a command line says.

    Raises
    ------
    ValueError
        If an override has not the form NAME:=VALUE, its value is not YAML, or a word stands
        where ROS would not read it.
    """
    _check_words(argv[1:])
    executable = argv[0].rsplit('/', 1)[-1].removesuffix('.py')
    name, files, overrides, process = executable, [], [], {}
    for flag, word in zip(argv[1:], argv[2:]):
        if flag == '--params-file':
            files.append(Path(word))
        elif flag in ('-r', '--remap') and word.split(':=')[0].endswith('__node'):
            name = word.split(':=', 1)[1]
        elif flag in ('-p', '--param'):
            key, found, value = word.partition(':=')
            if not found:
                raise BadInput(f'{flag} must be followed by NAME:=VALUE, got {word!r}')
            node, _, key = key.rpartition(':')
            try:
                given = value_of(value)
            except NotYaml as error:
                raise BadInput(f'{flag} {word}: the value is {error}') from None
            except BadInput as error:
                raise BadInput(f'{flag} {word}: {error}') from None
            if key in OF_THE_PROCESS:
                process[key] = given
            else:
                overrides.append((node, key, given))
    return Arguments(executable, name, tuple(files), tuple(overrides), process, own_run(argv))


def _check_words(words: list[str]) -> None:
    """Refuse what ROS would leave unread: a node takes nothing but ROS arguments."""
    of_ros = False
    for word in words:
        if word == '--ros-args':
            of_ros = True
        elif word == '--':
            of_ros = False
        elif not of_ros:
            raise BadInput(f'unknown argument {word!r}: a node takes ROS arguments, after '
                           '--ros-args, such as --params-file FILE, -p NAME:=VALUE, '
                           '-r __node:=NAME')
