"""After the rehearsal of a run in real time nothing is left to load or to compile in flight."""

import json
import subprocess
import sys

import pytest
from runs import environment

from rvd_campaign import catalogue

CHECK = """
import gc, json, sys
from pathlib import Path
from rvd_dynamics.diagram.in_process import draw, Loop
from rvd_dynamics.diagram.rehearsal import rehearse, REHEARSED_S
from rvd_dynamics.diagram.scenario import load

def there():
    from numba.core.dispatcher import Dispatcher
    return set(sys.modules), {(d.py_func.__module__, d.__name__, str(signature))
                              for d in gc.get_objects() if isinstance(d, Dispatcher)
                              for signature in d.signatures}

scenario = load(Path(sys.argv[1]))
first = set(sys.modules)
flown = rehearse(scenario)
modules, compiled = there()
runs = [scenario.run.run]
loop = Loop(scenario, runs, draw(scenario, runs, whole=True), False, ())
for k in range(flown + round(2.0 / scenario.run.step_s)):
    loop.advance(k)
later = there()
print(json.dumps({'flown_s': flown*scenario.run.step_s, 'wanted_s': REHEARSED_S,
                  'loaded': len(modules - first), 'compiled': len(compiled),
                  'more': sorted(later[0] - modules) + sorted(map(str, later[1] - compiled))}))
"""


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('scenario', ['docking', 'docking_manual', 'docking_planned', 'tether'])
def test_nothing_is_loaded_or_compiled_after_the_rehearsal(scenario):
    done = subprocess.run(
        [sys.executable, '-c', CHECK, catalogue.find('scenarios', scenario, ('.yaml',))],
        capture_output=True, text=True, env=environment())
    assert done.returncode == 0, done.stderr
    found = json.loads(done.stdout)
    assert found['flown_s'] == pytest.approx(found['wanted_s'])
    assert found['loaded'] > 50 and found['compiled'] >= 1       # it would be left to the flight
    assert found['more'] == []
