"""The tethered gripper over DDS: every grouping gives the bits of the loop in one process."""

import json

from conftest import Flown
import numpy as np
import pytest
from runs import ROOT

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import load, parse
from rvd_dynamics.recording.reader import read
from rvd_missions.tether.signals import SITUATION, THRUST, TRACKING, TRUTH

SHORT = {'step_s': 0.1, 'timeout_s': 20.0, 'approach__duration_s': [20.0, 20.0],
         'approach__baseline_m': 41.0, 'planner__nodes': 12}
CHANGES = {                                     # shared, sections by name
    'segments': ({}, {}),
    'one': ({'forward_delay_s': 0.4, 'back_delay_s': 0.3},
            {'gripper_sensors': {'bearing_sigma_rad': 1e-3, 'encoder_sigma_m': 0.01}}),
    'blocks': ({}, {'gripper_dynamics': {'elastic': True}}),
}


@pytest.mark.slow
@pytest.mark.parametrize('processes', CHANGES)
def test_a_flight_is_the_loop_in_one_process_to_the_last_bit(processes, tmp_path):
    shared, sections = CHANGES[processes]
    chosen = load(ROOT / 'scenarios' / 'tether.yaml').with_values('/**', **SHORT, **shared)
    for section, values in sections.items():
        chosen = chosen.with_values(section, **values)
    (tmp_path / 'short.yaml').write_text(chosen.dump())
    flight = Flown(tmp_path / 'run', str(tmp_path / 'short.yaml'), '--seed', '5', '--headless',
                   '--pace', 'lockstep', '--processes', processes)
    assert flight.code in (0, 1), flight.err
    run = read(flight.run / 'bag')
    alone = fly(parse((flight.run / 'scenario.yaml').read_text(), 'flown'), [0], record=True)
    for signal, parts in ((TRUTH, ('state', 'tension', 'target')), (THRUST, ('command',)),
                          (TRACKING, ('measured', 'planned')), (SITUATION, ('gripper', 'error'))):
        for part in parts:
            there = run.of(signal)[part]
            here = getattr(alone.history[signal.name], part)
            here = here[:, 0] if np.ndim(here) > 1 else here
            assert len(there) == alone.end_step[0] + 1
            np.testing.assert_array_equal(there, here[:len(there)], err_msg=f'{signal.name} {part}')
    verdict = json.loads((flight.run / 'verdict.json').read_text())
    assert verdict['mission'] == 'tether' and verdict['reason'] == alone.verdict.reason[0]
    assert verdict['measures']['range_error_m']['value'] == (
        alone.verdict.values['range_error_m'][0])


@pytest.mark.slow
def test_a_plan_that_cannot_be_made_is_one_line_and_exit_code_2(tmp_path):
    chosen = load(ROOT / 'scenarios' / 'tether.yaml').with_values('/**', **{
        **SHORT, 'approach__lateral_m_s': [3.0, 0.0]})
    (tmp_path / 'short.yaml').write_text(chosen.dump())
    flight = Flown(tmp_path / 'run', str(tmp_path / 'short.yaml'), '--headless')
    assert flight.code == 2
    said, *_ = [line for line in flight.err.splitlines() if 'plan infeasible: ' in line]
    assert 'must be at' in said and 'reaches' in said and 'Traceback' not in flight.err
