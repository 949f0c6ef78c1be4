"""
Who may import whom, read from the source of every module (docs/architecture.md), and by running.

A module is what is below ros2_ws/src/PACKAGE/PACKAGE. Imports inside functions count too. `pure` is
all that does not know ROS: the mathematics and the blocks, which the graph and the loop in one
process share.
"""

import ast
from pathlib import Path
import subprocess
import sys

import pytest

SRC = Path(__file__).resolve().parents[1] / 'ros2_ws' / 'src'
ORDER = ['rvd_interfaces', 'rvd_dynamics', 'rvd_groundstation', 'rvd_missions', 'rvd_campaign']
ROS = {'rclpy', 'rvd_interfaces', 'ament_index_python', 'builtin_interfaces', 'rcl_interfaces',
       'rosidl_runtime_py', 'rpyutils'}

# Who may import ROS: the runtime of a diagram, the nodes of the console and of the joystick, the
# command that follows a flight, the benchmark, and the recorder's look-up of installed message
# definitions.
MAY_IMPORT_ROS = ['rvd_dynamics.diagram.ros', 'rvd_groundstation.console.node',
                  'rvd_groundstation.joystick.node', 'rvd_campaign.flight', 'rvd_campaign.bench',
                  'rvd_dynamics.recording.definitions']
WORLD = ['rvd_dynamics.world']
ONBOARD = ['rvd_dynamics.onboard']
# What the ground may use of rvd_dynamics: mathematics and vocabulary of both sides. The craft, the
# world, and what the link does on the way it knows through frames alone.
SHARED = [f'rvd_dynamics.{top}' for top in (
    'bad_input', 'compiled', 'constants', 'frames', 'motion', 'geometry', 'commands', 'link.frame',
    'link.signals', 'diagram', 'given', 'lifeline', 'recording.messages', 'recording.whole')]
NOT_GROUND = [*WORLD, *ONBOARD, *(f'rvd_dynamics.link.{part}' for part in (
    'models', 'plan', 'play_out', 'channel', 'leg'))]
RUNTIME = ['rvd_dynamics.diagram.ros']          # runs blocks of any segment
# The console's server deals with pages, which live by the wall clock; so do files and devices.
NO_MATHEMATICS = ['rvd_groundstation.console', 'rvd_groundstation.joystick',
                  'rvd_dynamics.recording', *MAY_IMPORT_ROS]
STREAMS = ['rvd_dynamics.diagram.streams', 'rvd_dynamics.diagram.seeding']


def name_of(path):
    """Return the dotted name of the module in this file."""
    parts = path.relative_to(SRC).with_suffix('').parts[1:]
    return '.'.join(parts[:-1] if parts[-1] == '__init__' else parts)


FILES = {name_of(path): path for package in ORDER
         for path in sorted((SRC / package / package).rglob('*.py'))}
TREES = {name: ast.parse(path.read_text(encoding='utf-8')) for name, path in FILES.items()}


def imported_by(name):
    """Return the dotted names of the modules that a module imports, ours resolved to files."""
    names = set()
    for node in ast.walk(TREES[name]):
        if isinstance(node, ast.Import):
            names.update(alias.name for alias in node.names)
        elif isinstance(node, ast.ImportFrom):
            assert node.level == 0, f'{name}:{node.lineno}: relative import'
            for alias in node.names:
                inner = f'{node.module}.{alias.name}'
                names.add(inner if inner in FILES else node.module)
    return names


IMPORTS = {name: imported_by(name) for name in FILES}


def package_of(name):
    """Return the top-level package of a module."""
    return name.split('.')[0]


def below(name, tops):
    """Tell whether `name` is one of these modules, or inside one."""
    return any(name == top or name.startswith(f'{top}.') for top in tops)


def is_ros(name):
    """Tell whether this is a package of ROS 2 or of generated messages."""
    return package_of(name) in ROS or package_of(name).endswith('_msgs')


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


def circles():
    """Return groups of modules that reach each other by imports (Tarjan's algorithm)."""
    number, lowest, stack, found = {}, {}, [], []

    def visit(name):
        number[name] = lowest[name] = len(number)
        stack.append(name)
        for other in IMPORTS[name] & FILES.keys():
            if other not in number:
                visit(other)
            if other in stack:
                lowest[name] = min(lowest[name], lowest[other])
        if lowest[name] == number[name]:
            group = stack[stack.index(name):]
            del stack[stack.index(name):]
            if len(group) > 1 or name in IMPORTS[name]:
                found.append(sorted(group))

    for name in FILES:
        if name not in number:
            visit(name)
    return found


PURE = [name for name in FILES if not below(name, MAY_IMPORT_ROS)]
MATHEMATICS = [name for name in FILES
               if package_of(name) != 'rvd_campaign' and not below(name, NO_MATHEMATICS)]
GROUND = [name for name in FILES if package_of(name) == 'rvd_groundstation']
GROUND_OF_MISSIONS = [name for name in FILES if package_of(name) == 'rvd_missions'
                      and name.endswith('.ground')]
DIAGRAMS = [name for name in FILES if package_of(name) == 'rvd_missions'
            and name.endswith('.diagram')]


def test_the_tree_is_found():
    assert len(FILES) > 100
    assert {package_of(name) for name in FILES} == set(ORDER[1:])
    assert all(any(below(name, [top]) for name in FILES)
               for top in {*MAY_IMPORT_ROS, *SHARED, *NOT_GROUND, *NO_MATHEMATICS, *STREAMS})
    assert GROUND_OF_MISSIONS and len(GROUND_OF_MISSIONS) == len(DIAGRAMS)
    assert len(MATHEMATICS) > 60


def test_a_rule_that_is_broken_would_be_seen(monkeypatch):
    """The reading itself: an import in a function, a circle, and what is reached through others."""
    inner = ast.parse('def f():\n    from rvd_dynamics.world import settings\n    import time\n')
    monkeypatch.setitem(TREES, 'rvd_dynamics.motion.cw', inner)
    monkeypatch.setitem(IMPORTS, 'rvd_dynamics.motion.cw', imported_by('rvd_dynamics.motion.cw'))
    assert IMPORTS['rvd_dynamics.motion.cw'] == {'rvd_dynamics.world.settings', 'time'}
    assert 'rvd_dynamics.world.settings' in reached_from('rvd_groundstation.prediction.filter')
    assert any('rvd_dynamics.motion.cw' in group for group in circles())


# -- who imports whom -----------------------------------------------------------------------------

@pytest.mark.parametrize('name', FILES)
def test_imports_run_one_way(name):
    rank = ORDER.index(package_of(name))
    later = [module for module in IMPORTS[name]
             if package_of(module) in ORDER and ORDER.index(package_of(module)) > rank]
    assert not later, f'{name} imports {later}'


@pytest.mark.parametrize('name', FILES)
def test_every_module_of_ours_that_is_imported_exists(name):
    gone = [module for module in IMPORTS[name] if package_of(module) in ORDER[1:]
            and module not in FILES]
    assert not gone, f'{name} imports {gone}'


def test_there_is_no_circle_of_imports():
    assert circles() == []


# -- ROS ------------------------------------------------------------------------------------------

@pytest.mark.parametrize('name', PURE)
def test_only_the_runtime_and_the_commands_import_ros(name):
    assert not [module for module in IMPORTS[name] if is_ros(module)]


@pytest.mark.parametrize('name', MATHEMATICS)
def test_importing_the_mathematics_loads_no_ros(name):
    assert not [module for module in reached_from(name) if is_ros(module)]


# -- segments -------------------------------------------------------------------------------------

@pytest.mark.parametrize('name', GROUND)
def test_the_ground_uses_only_what_both_sides_share(name):
    other = [module for module in IMPORTS[name]
             if package_of(module) == 'rvd_dynamics' and not below(module, SHARED)]
    assert not other, f'{name} imports {other}'


@pytest.mark.parametrize('name', [name for name in FILES
                                  if below(name, SHARED) and not below(name, RUNTIME)])
def test_what_is_shared_does_not_load_the_other_side(name):
    assert not [module for module in reached_from(name) if below(module, NOT_GROUND)]


@pytest.mark.parametrize('name', [name for name in FILES if below(name, ONBOARD)])
def test_the_craft_does_not_load_the_world(name):
    assert not [module for module in reached_from(name) if below(module, WORLD)]


@pytest.mark.parametrize('name', [name for name in FILES if below(name, RUNTIME)])
def test_the_runtime_does_not_load_the_world_until_a_block_asks_for_it(name):
    assert not [module for module in reached_from(name) if below(module, WORLD)]


@pytest.mark.parametrize('name', GROUND_OF_MISSIONS)
def test_the_ground_of_a_mission_loads_neither_its_space_nor_the_other_side(name):
    space = name.removesuffix('.ground') + '.space'
    assert space in FILES
    assert not [module for module in reached_from(name) if below(module, [space, *NOT_GROUND])]


@pytest.mark.parametrize('name', DIAGRAMS)
def test_a_diagram_names_blocks_as_text_and_loads_none_of_them(name):
    home = name.removesuffix('.diagram')
    loaded = reached_from(name)
    assert not [module for module in loaded
                if below(module, [f'{home}.space', f'{home}.ground', *WORLD])]


@pytest.mark.parametrize('name', [*GROUND, *GROUND_OF_MISSIONS])
def test_the_ground_names_no_topic_of_truth(name):
    constants = [node.value for node in ast.walk(TREES[name])
                 if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    assert not [topic for topic in constants if topic.startswith('/truth')]
    signals = {alias.name for node in ast.walk(TREES[name]) if isinstance(node, ast.ImportFrom)
               and node.module.endswith('.signals') for alias in node.names}
    signals |= {node.attr for node in ast.walk(TREES[name]) if isinstance(node, ast.Attribute)
                and isinstance(node.value, ast.Name) and node.value.id == 'signals'}
    assert 'TRUTH' not in signals


# -- mathematics ----------------------------------------------------------------------------------

@pytest.mark.parametrize('name', MATHEMATICS)
def test_the_mathematics_has_no_clock_and_no_randomness_of_its_own(name):
    assert not {'time', 'datetime', 'random', 'secrets', 'numpy.random'} & IMPORTS[name]
    if below(name, STREAMS):
        return
    made = {node.func.attr for node in ast.walk(TREES[name])
            if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute)
            and isinstance(node.func.value, ast.Attribute) and node.func.value.attr == 'random'}
    assert not made, f'{name} calls np.random.{made}: chance comes from diagram.streams'


# -- by another road than the source: what processes really load ----------------------------------

def output_of(script):
    """Return what a Python process prints; it must end well."""
    done = subprocess.run([sys.executable, '-c', script], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return done.stdout


def test_the_loop_in_one_process_flies_where_there_is_no_ros():
    """With ROS made unimportable."""
    found = output_of(f'''
import sys
class NoRos:
    def find_spec(self, name, path=None, target=None):
        if name.split('.')[0] in {sorted(ROS)!r} or name.split('.')[0].endswith('_msgs'):
            raise ImportError('there is no ' + name)
sys.meta_path.insert(0, NoRos())
from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse
batch = fly(parse('/**: {{ros__parameters: {{mission: lunar_approach}}}}', 'x'), range(3))
print(len(batch.end_step), len(batch.columns), *(r != '' for r in batch.verdict.reason))
''').split()
    assert found[0] == '3' and int(found[1]) > 5 and found[2:] == ['True'] * 3


LOADED = '''
import sys
from rvd_dynamics.diagram import mission
from rvd_dynamics.diagram.build import made
from rvd_dynamics.diagram.in_process import everything
from rvd_dynamics.diagram.scenario import Scenario
count = 0
for shared in {shared!r}:
    scenario = Scenario('x', mission.find('lunar_approach'), {{'/**': shared, **{sections!r}}})
    for block in scenario.diagram.blocks:
        if block.segment != {segment!r} or not block.in_graph:
            continue
        own = {{'batch': (), 'runs': [0], 'block': block, 'wanted': everything(block),
               'settings': scenario.settings(block.section),
               **{{n: d.of_run(0, 0, 401) for n, d in block.draws.items()}}}}
        made(block.make, lambda name: own[name] if name in own else scenario.part(name), block.name)
        count += 1
print(count, *sys.modules)
'''


def loaded_by(segment, sections=None):
    """Return the modules of a process that makes all blocks of a segment, as a node makes them."""
    shared = [{'operator': 'model'}, {'operator': 'none'}, {'operator': 'replay'}]
    count, *modules = output_of(LOADED.format(shared=shared, segment=segment,
                                              sections=sections or {})).split()
    assert int(count) >= 3
    return modules


@pytest.fixture
def tape(tmp_path):
    path = tmp_path / 'tape.csv'
    path.write_text('t_s,axis_0,axis_1,axis_2,axis_3,axis_4,button_0\n0,0,0,0,0,0,1\n')
    return {'joystick_replay': {'tape': str(path)}}


@pytest.mark.parametrize('law', ['corridor_apf', 'barrier'])
def test_a_process_of_the_ground_has_not_loaded_the_world(law, tape):
    modules = loaded_by('ground', {**tape, 'auto_controller': {'law': law}})
    assert 'rvd_missions.lunar_approach.ground' in modules
    assert not [m for m in modules if below(m, ['rvd_missions.lunar_approach.space', *WORLD,
                                                *ONBOARD])]


def test_a_process_of_the_craft_has_loaded_neither_world_nor_ground_blocks(tape):
    modules = loaded_by('onboard', tape)
    assert 'rvd_dynamics.onboard.guard.block' in modules
    assert not [m for m in modules if below(m, ['rvd_missions.lunar_approach.space',
                                                'rvd_missions.lunar_approach.ground', *WORLD])]


def test_the_same_look_sees_the_world_where_it_is():
    modules = loaded_by('world', {'joystick_replay': {'tape': 'none.csv'}})
    assert 'rvd_missions.lunar_approach.space' in modules and 'rvd_dynamics.world' in modules
