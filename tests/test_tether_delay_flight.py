"""The tethered gripper behind a link over DDS: the bits of one process, and one-line refusals."""

import json

from conftest import Flown
import numpy as np
import pytest
from runs import flown_again, ROOT

from rvd_dynamics.diagram.scenario import load
from rvd_missions.tether_delay.signals import CRAFT, SITUATION, THRUST, TRUTH

SHORT = {'step_s': 0.1, 'timeout_s': 62.0, 'approach__duration_s': [25.0, 25.0],
         'approach__baseline_m': 41.0, 'planner__nodes': 12, 'ground__solve_s': 0.5,
         'ground__lead_s': 0.5, 'ground__least_s': 20.0, 'forward_delay_s': 0.4,
         'back_delay_s': 0.3, 'hold__settle_s': 2.0, 'ground__replan_m': 0.3}


@pytest.mark.slow
@pytest.mark.patient
def test_a_flight_planned_anew_twice_is_the_loop_in_one_process_to_the_last_bit(tmp_path):
    chosen = load(ROOT / 'scenarios' / 'tether_delay.yaml').with_values('/**', **SHORT)
    chosen = chosen.with_values('flight_director', hold_range_m=34.0, look_s=1.0)
    chosen = chosen.with_values('gripper_sensors', encoder_sigma_m=0.005)
    chosen = chosen.with_values('gripper_dynamics', velocity_error_m_s=[0.4, 0.0, 0.0])
    chosen = chosen.with_values('link_forward', loss_fraction=0.1)
    (tmp_path / 'short.yaml').write_text(chosen.dump())
    flight = Flown(tmp_path / 'run', str(tmp_path / 'short.yaml'), '--seed', '5', '--headless',
                   '--pace', 'lockstep', '--processes', 'segments')
    assert flight.code in (0, 1), flight.err
    run, alone = flown_again(flight.run, True)
    # one from the latch, one joined in flight, one from where it stood
    assert alone.columns['plans'][0] == 3 and alone.columns['joined_m'][0] < 0.1
    for signal, parts in ((TRUTH, ('state', 'tension')), (THRUST, ('command',)),
                          (CRAFT, ('doing', 'plan')), (SITUATION, ('range', 'ahead'))):
        for part in parts:
            there = run.of(signal)[part]
            here = getattr(alone.history[signal.name], part)[:, 0]
            assert len(there) == alone.end_step[0] + 1
            np.testing.assert_array_equal(there, here[:len(there)], err_msg=f'{signal.name} {part}')
    verdict = json.loads((flight.run / 'verdict.json').read_text())
    assert verdict['reason'] == alone.verdict.reason[0]
