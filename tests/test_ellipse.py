"""The elliptic rendezvous over DDS and its commands, from the outside."""

import json

import numpy as np
import pytest
from conftest import Flown
from runs import messages, rvd, states

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse

SHORT = '''/**:
  ros__parameters:
    mission: elliptic_rendezvous
    step_s: 4.0
    timeout_s: 800.0
    forward_delay_s: 8.0
    back_delay_s: 4.0
    pace: lockstep
    start: {range_m: 60.0, range_rate_m_s: -0.1}
    guidance: {law: combined}
relative_sensor:
  ros__parameters: {position_sigma_m: 0.05}
'''


@pytest.mark.slow
@pytest.mark.parametrize('processes', ['blocks', 'one'])
def test_the_graph_flies_to_the_last_bit_as_the_loop_in_one_process(processes, tmp_path):
    (tmp_path / 'short.yaml').write_text(SHORT)
    flown = Flown(tmp_path / 'run', str(tmp_path / 'short.yaml'), '--processes', processes,
                  '--seed', '5', '--headless')
    assert flown.code == 1, flown.err                       # time is up before it has settled
    scenario = parse((tmp_path / 'run' / 'scenario.yaml').read_text(), 'flown')
    assert scenario.run.pace == 'lockstep'                 # the scenario's own: no --pace was given
    history = fly(scenario, [0], record=True).history
    truth = states(tmp_path / 'run', '/truth/relative_state')
    assert len(truth) == 201
    np.testing.assert_array_equal(truth[:, :6], history['/truth/relative_state'].state[:, 0])
    fired = np.array([m.values[:3] for m in messages(tmp_path / 'run',
                                                     '/onboard/thruster_command')])
    np.testing.assert_array_equal(fired, history['/onboard/thruster_command'].command[:, 0])
    assert np.abs(fired).max() > 0.0


def test_one_case_of_a_limit_cycle_is_printed_as_json(tmp_path):
    done = rvd('limit-cycles', '--json', '--law', 'odrrca', '--form', 'r1', '--e', '0.1', '--k',
               '-0.5',
               '--k1', '1', '--k2', '0', '--q', '10', '--phi-d-deg', '-90', cwd=tmp_path)
    assert done.returncode == 0 and done.stderr == ''
    found = json.loads(done.stdout)
    assert found['exists'] is True and found['stable'] is True
    assert found['phi_min_deg'] == pytest.approx(-83.77, abs=0.05)
    assert found['phi_max_deg'] == pytest.approx(-79.91, abs=0.05)
    (a, b), (c, d) = found['multipliers']
    assert (a, b) == pytest.approx((c, -d))
    assert np.hypot(a, b) == pytest.approx(np.exp(-np.pi), rel=1e-6)
    assert not list(tmp_path.iterdir())


def test_where_there_is_no_cycle_all_is_null(tmp_path):
    done = rvd('limit-cycles', '--json', '--form', 'r2', '--k1', '0.5', '--e', '0.45', cwd=tmp_path)
    assert json.loads(done.stdout) == {'exists': False, 'phi_min_deg': None, 'phi_max_deg': None,
                                       'multipliers': None, 'stable': None}


def test_a_branch_is_followed_and_its_changes_are_named(tmp_path):
    done = rvd('limit-cycles', '--e', '0.2', '--along', 'e', '--until', '0.3', cwd=tmp_path)
    assert done.returncode == 0
    assert 'period doubling at e = 0.2641' in done.stdout


BAD = {
    'eccentricity': (['--e', '1'], 'e must be below 1'),
    'no damping': (['--k1', '0.5'], 'k1 must be above -k = 0.5'),
    'sign of k': (['--k', '0.2'], 'k must not be positive'),
    'sign of q': (['--law', 'odrrca', '--q', '-1'], 'q must be positive'),
    'law': (['--law', 'pid'], 'pid'),
    'end of nothing': (['--until', '0.3'], '--along'),
    'branch without end': (['--along', 'e'], '--until'),
    'branch to nowhere': (['--along', 'e', '--until', '1.5'], 'e must be below 1'),
    'study of a case': (['--e', '0.2', '--out', 'x'], '--out'),
}


@pytest.mark.parametrize('args, said', BAD.values(), ids=BAD.keys())
def test_bad_input_is_one_line_and_exit_code_2(args, said, tmp_path):
    done = rvd('limit-cycles', *args, cwd=tmp_path)
    assert done.returncode == 2 and done.stdout == ''
    assert len(done.stderr.splitlines()) == 1 and said in done.stderr
    assert not list(tmp_path.iterdir())
