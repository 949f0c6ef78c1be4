"""Lock step: the same bits every time, over DDS and in one process."""

import numpy as np
import pytest
from conftest import Flown
from runs import messages, ROOT, states

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, parse


def thrust(run):
    return np.array([[*m.levels, m.valid, m.kind, m.reason, m.sequence]
                     for m in messages(run, '/onboard/thruster_command')])


def test_a_second_run_is_the_same_to_the_last_bit(flight, tmp_path):
    again = Flown(tmp_path / 'run', '--pace', 'lockstep', '--seed', '3', '--headless')
    for topic in ('/truth/relative_state', '/ground/prediction'):
        np.testing.assert_array_equal(states(again.run, topic), states(flight.run, topic))
    np.testing.assert_array_equal(thrust(again.run), thrust(flight.run))


@pytest.mark.parametrize('which', ['flight', 'rough_flight'])
def test_graph_equals_the_loop_in_one_process(which, request):
    run = request.getfixturevalue(which).run
    assert_equals_loop(run)


CASES = {
    'manual': ('--mode', 'manual', '--seed', '5'),
    'auto': ('--mode', 'auto', '--operator', 'none', '--seed', '6'),
    'two_body': ('two_body', '--seed', '7'),
    'ten_steps_a_second': ('hand', '--seed', '8'),
}


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('args', CASES.values(), ids=CASES.keys())
def test_other_runs_equal_the_loop_too(args, tmp_path):
    flown = Flown(tmp_path / 'run', *args, '--pace', 'lockstep', '--headless')
    assert flown.code in (0, 1), flown.err
    assert_equals_loop(flown.run)


BARRIER = {     # the law sees the stick and must know what the blender will do
    'eq25': 'sharing: eq25',
    'other_weight': 'sharing: eq25\n    eq25: {eta: 0.45}',
    'filter': 'sharing: filter',
    'hands_off': 'sharing: eq25',
}


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('case', BARRIER)
def test_barrier_equals_the_loop_with_any_sharing(case, tmp_path):
    text = (ROOT / 'scenarios' / 'barrier.yaml').read_text()
    head, _, _ = text.partition('    sharing:')
    (tmp_path / 'own.yaml').write_text(f'{head}    {BARRIER[case]}\n')
    args = ['--operator', 'none'] if case == 'hands_off' else []
    flown = Flown(tmp_path / 'run', str(tmp_path / 'own.yaml'), *args, '--seed', '9',
                  '--pace', 'lockstep', '--headless')
    assert flown.code in (0, 1), flown.err
    assert_equals_loop(flown.run)


def assert_equals_loop(run):
    scenario = parse((run / 'scenario.yaml').read_text(), 'flown')
    alone = fly(scenario, [scenario.run.run], record=True).history
    truth = states(run, '/truth/relative_state')
    history = alone['/truth/relative_state'].state[:, 0]
    np.testing.assert_array_equal(truth[:, :6], history[:len(truth)])
    levels = thrust(run)[:, :3]
    executed = alone['/onboard/thruster_command'].command[:, 0]
    np.testing.assert_array_equal(levels, executed[:len(levels)])
    auto = np.array([m.levels for m in messages(run, '/ground/auto_command')])
    np.testing.assert_array_equal(auto, alone['/ground/auto_command'].command[:len(auto), 0])


def test_random_streams_do_not_see_the_mode():
    shared = load(ROOT / 'scenarios' / 'paper.yaml')
    manual = shared.with_values('/**', mode='manual')
    a, b = (fly(s, [0, 1], record=True).history['/truth/relative_state'].state
            for s in (shared, manual))
    np.testing.assert_array_equal(a[:20], b[:20])                   # before a command acts
    assert not np.array_equal(a[-1], b[-1])
