"""
Who opens what a user gives: `rvd_dynamics.given` and nobody else, read from every module's source.

YAML, JSON and tables from a file have limits there. Whoever parses a text that came another way
(over a pipe of ours, from the installation) or writes files is named here, with the reason.
"""

import ast

from test_layering import FILES, TREES

PARSERS = {
    'yaml': {'load', 'safe_load', 'load_all', 'safe_load_all', 'full_load', 'unsafe_load', 'parse',
             'compose'},
    'json': {'load', 'loads'}, 'csv': {'reader', 'DictReader'}, 'pickle': {'load', 'loads'},
    'np': {'load', 'loadtxt', 'genfromtxt', 'fromfile', 'memmap'}, 'tomllib': {'load', 'loads'}}
READERS = {'read_text', 'read_bytes'}           # of a path
NOT_GIVEN = {
    'rvd_dynamics.given': 'the one place',
    'rvd_dynamics.recording.definitions': 'of the installed interface packages',
    'rvd_campaign.bench': 'what the benchmark has written itself',
    'rvd_campaign.flight.console': 'wishes over a pipe of our own process',
    'rvd_campaign.flight.supervisor': 'the log of a node, in a run folder of our own',
    'rvd_campaign.flight.domain': 'what the kernel says of sockets',
    'rvd_campaign.flight.kept': 'the bag that our own recorder has just written',
    'rvd_campaign.flight.leftovers': 'what the kernel says of processes and shared memory',
    'rvd_campaign.campaign.software': 'our own sources',
    'rvd_campaign.campaign.standstill': 'what the kernel says of processes',
    'rvd_campaign.cpu': 'what the kernel says of processes',
    'rvd_dynamics.diagram.ros.writers': 'what the kernel says of its load',
    'rvd_groundstation.console.server': 'the page as it is installed',
    'rvd_dynamics.pulse': 'a page of memory of our own processes',
    'rvd_dynamics.lifeline': 'what the kernel says of processes',
    'rvd_groundstation.console.protocol': 'messages of the page, with a limit of their own',
    'rvd_groundstation.console.attach': 'a socket of our own processes',
    'rvd_groundstation.console.process': 'what our own process has written for it',
    'rvd_groundstation.console.hub': 'messages of the page, with a limit of their own'}


def calls(tree):
    """Yield (line, words) of each call that reads or parses a file."""
    for node in ast.walk(tree):
        if not isinstance(node, ast.Call) or not isinstance(node.func, (ast.Attribute, ast.Name)):
            continue
        if isinstance(node.func, ast.Name):
            if node.func.id == 'open' and not writes(node, 1):
                yield node.lineno, 'open'
            continue
        name, owner = node.func.attr, node.func.value
        if isinstance(owner, ast.Name) and name in PARSERS.get(owner.id, ()):
            yield node.lineno, f'{owner.id}.{name}'
        elif name in READERS:
            yield node.lineno, name
        elif name == 'open' and not (isinstance(owner, ast.Name) and owner.id == 'os') and (
                not node.args or isinstance(node.args[0], ast.Constant)) and not writes(node, 0):
            yield node.lineno, '.open'


def writes(call, at):
    """Tell whether a call of `open` is one for writing: by its mode, which stands at `at`."""
    given = [a for a in call.args[at:at + 1]] + [k.value for k in call.keywords if k.arg == 'mode']
    mode = given[0] if given else ast.Constant('r')
    return not isinstance(mode, ast.Constant) or bool(set(str(mode.value)) & set('wxa+'))


def excused(name):
    """Tell whether a module is named above."""
    return any(name == top or name.startswith(f'{top}.') for top in NOT_GIVEN)


def test_nobody_else_opens_what_a_user_gives():
    found = [f'{name}:{line}: {words}' for name in FILES if not excused(name)
             for line, words in calls(TREES[name])]
    assert not found, ('read it by rvd_dynamics.given, which has limits, or say in this test why '
                       'nobody can give it:\n' + '\n'.join(found))


def test_the_look_finds_what_it_is_for():
    """The negative twin."""
    text = '''
yaml.safe_load(text); json.loads(x); csv.reader(f); np.loadtxt('f'); open(path); path.open()
path.read_text(); open(path, 'rb'); path.open('rb', buffering=0)
path.open('w'); open(path, 'x'); open(path, mode='wb'); os.open(path, flags); bag.open(share)
'''
    assert [line for line, _ in calls(ast.parse(text))] == [2] * 6 + [3] * 3


def test_who_is_excused_is_still_there():
    later = ('rvd_campaign.flight.kept', 'rvd_campaign.flight.leftovers', 'rvd_dynamics.pulse',
             'rvd_dynamics.diagram.ros.writers')
    assert not [name for name in NOT_GIVEN if name not in later
                and not any(excused and module == name or module.startswith(f'{name}.')
                            for module in FILES)]
