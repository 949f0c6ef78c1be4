"""
Who may import whom, read from the source of every module (docs/architecture.md).

A module is what is below ros2_ws/src/PACKAGE/PACKAGE. Imports inside functions count too. `pure` is
all that is not in a `ros/` or `nodes/` folder: the mathematics, which a node and an in-process loop
share.
"""

import ast
from pathlib import Path
import subprocess
import sys

import pytest

SRC = Path(__file__).resolve().parents[1] / 'ros2_ws' / 'src'
ORDER = ['rvd_interfaces', 'rvd_dynamics', 'rvd_groundstation', 'rvd_campaign']
ROS = {'rclpy', 'rvd_interfaces', 'ament_index_python', 'builtin_interfaces', 'rcl_interfaces',
       'rosidl_runtime_py', 'rpyutils'}

# What the ground may use of rvd_dynamics: mathematics and vocabulary of both sides. The rest of
# it is the world, which the ground knows through the link alone.
SHARED = ['constants', 'frames', 'motion', 'geometry', 'commands', 'link.frame', 'link.signals',
          'judge', 'diagram', 'mission', 'recording.messages', 'recording.whole']
WORLD = ['world', 'onboard', 'link.models', 'link.plan', 'link.play_out', 'link.channel', 'nodes']

# Outside of ros/ and nodes/ all the same: the live view of `rvd fly`, which listens to topics from
# within the command's own process; the recorder's look-up of installed message definitions; and the
# benchmark's graph of hollow nodes, with the view that follows it, and its ear on the stick; and
# the console's node, which is no block.
ALSO_ROS = {'rvd_campaign.flight.watch', 'rvd_dynamics.recording.definitions',
            'rvd_groundstation.console.node',
            'rvd_campaign.bench.bare', 'rvd_campaign.bench.graph', 'rvd_campaign.bench.console'}


def name_of(path):
    """Return the dotted name of the module in this file."""
    parts = path.relative_to(SRC).with_suffix('').parts[1:]
    return '.'.join(parts[:-1] if parts[-1] == '__init__' else parts)


FILES = {name_of(path): path for package in ORDER
         for path in sorted((SRC / package / package).rglob('*.py'))}


def imported_by(path):
    """Return the dotted names of the modules that this file imports, ours resolved to files."""
    names = set()
    for node in ast.walk(ast.parse(path.read_text(encoding='utf-8'))):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f'{path}:{node.lineno}: relative import'
            for alias in node.names:
                inner = f'{node.module}.{alias.name}'
                names.add(inner if inner in FILES else node.module)
    return names


IMPORTS = {name: imported_by(path) for name, path in FILES.items()}


def package_of(name):
    """Return the top-level package of a module."""
    return name.split('.')[0]


def below(name, tops):
    """Tell whether `name` is one of these modules of rvd_dynamics, or inside one."""
    return any(name == f'rvd_dynamics.{top}' or name.startswith(f'rvd_dynamics.{top}.')
               for top in tops)


def is_ros(name):
    """Tell whether this is a package of ROS 2 or of generated messages."""
    return package_of(name) in ROS or package_of(name).endswith('_msgs')


def is_pure(name):
    """Tell whether the module is outside of the folders that know ROS."""
    return not {'ros', 'nodes'} & set(name.split('.')) and name not in ALSO_ROS


def reached_from(name):
    """Return all that importing this module loads, following our own modules."""
    seen, waiting = set(), [name]
    while waiting:
        module = waiting.pop()
        parents = ['.'.join(module.split('.')[:n]) for n in range(1, module.count('.') + 1)]
        if module not in seen:
            seen.add(module)
            waiting += [*IMPORTS.get(module, ()), *(p for p in parents if p in FILES)]
    return seen - {name}


PURE = [name for name in FILES if is_pure(name)]
# The console's server deals with pages, which live by the wall clock.
MATHEMATICS = [name for name in PURE if package_of(name) != 'rvd_campaign'
               and not below(name, ['recording'])
               and not name.startswith('rvd_groundstation.console')]
GROUND = [name for name in FILES if package_of(name) == 'rvd_groundstation']


def test_the_tree_is_found():
    assert len(FILES) > 50
    assert {package_of(name) for name in FILES} == set(ORDER[1:])
    assert IMPORTS['rvd_dynamics.judge'] and ALSO_ROS <= set(FILES)


@pytest.mark.parametrize('name', PURE)
def test_only_ros_and_nodes_import_ros(name):
    assert not [module for module in IMPORTS[name] if is_ros(module)]


@pytest.mark.parametrize('name', MATHEMATICS)
def test_importing_the_mathematics_loads_no_ros(name):
    assert not [module for module in reached_from(name) if is_ros(module)]


@pytest.mark.parametrize('name', FILES)
def test_imports_run_one_way(name):
    rank = ORDER.index(package_of(name))
    later = [module for module in IMPORTS[name]
             if package_of(module) in ORDER and ORDER.index(package_of(module)) > rank]
    assert not later, f'{name} imports {later}'


@pytest.mark.parametrize('name', GROUND)
def test_the_ground_uses_only_what_both_sides_share(name):
    of_world = [module for module in IMPORTS[name]
                if package_of(module) == 'rvd_dynamics' and not below(module, SHARED)]
    assert not of_world, f'{name} imports {of_world}'


@pytest.mark.parametrize('name', [name for name in FILES if below(name, SHARED)])
def test_what_is_shared_does_not_load_the_world(name):
    assert not [module for module in reached_from(name) if below(module, WORLD)]


@pytest.mark.parametrize('name', GROUND)
def test_the_ground_names_no_topic_of_truth(name):
    tree = ast.parse(FILES[name].read_text(encoding='utf-8'))
    topics = [node.value for node in ast.walk(tree)
              if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    assert not [topic for topic in topics if topic.startswith('/truth')]


@pytest.mark.parametrize('name', MATHEMATICS)
def test_the_mathematics_has_no_clock_and_no_randomness_of_its_own(name):
    assert not {'time', 'datetime', 'random'} & IMPORTS[name]


def test_the_loop_in_one_process_runs_where_there_is_no_ros():
    """
    By another road than the source: the loop and all it loads, with ROS made unimportable.
    """
    script = ('import sys\n'
              f'for name in {sorted(ROS)!r}: sys.modules[name] = None\n'
              'from rvd_dynamics.diagram import in_process, scenario\n'
              'short = scenario.parse("/**: {ros__parameters: {timeout_s: 1.0}}", "short")\n'
              'assert len(in_process.fly(short, [0]).runs) == 1\n')
    done = subprocess.run([sys.executable, '-c', script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
