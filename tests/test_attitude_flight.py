"""Attitude hold over DDS: every grouping gives the bits of the loop in one process."""

import json

from conftest import Flown
import numpy as np
import pytest
from runs import flown_again, ROOT

from rvd_dynamics.diagram.scenario import load
from rvd_missions.attitude_hold.signals import LAW, THRUST, TRUTH

SHORT = {'timeout_s': 60.0, 'attitude__step_at_s': 20.0, 'faults__actuator_at_s': 25.0,
         'faults__sensor_at_s': 20.0, 'limits__window_s': 20.0}
FLIGHTS = {                                     # scenario, changes, grouping
    'blocks': ('attitude', {}, 'blocks'),
    'segments': ('attitude', {'forward_delay_s': 1.0, 'back_delay_s': 0.5}, 'segments'),
    'one': ('attitude', {'back_delay_s': 0.5}, 'one'),
    'on board': ('attitude_onboard', {}, 'segments'),
}


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('case', FLIGHTS)
def test_a_flight_is_the_loop_in_one_process_to_the_last_bit(case, tmp_path):
    name, changes, processes = FLIGHTS[case]
    chosen = load(ROOT / 'scenarios' / f'{name}.yaml').with_values('/**', **SHORT, **changes)
    (tmp_path / 'short.yaml').write_text(chosen.dump())
    flight = Flown(tmp_path / 'run', str(tmp_path / 'short.yaml'), '--seed', '5', '--headless',
                   '--pace', 'lockstep', '--processes', processes)
    assert flight.code in (0, 1), flight.err
    run, alone = flown_again(flight.run, True)
    for signal, parts in ((TRUTH, ('state', 'torque')), (THRUST, ('command',)),
                          (LAW, ('error', 'inside'))):
        for part in parts:
            there = run.of(signal)[part]
            here = getattr(alone.history[signal.name], part)
            here = here[:, 0] if here.ndim > 1 else here
            assert len(there) == alone.end_step[0] + 1
            np.testing.assert_array_equal(there, here[:len(there)], err_msg=f'{signal.name} {part}')
    verdict = json.loads((flight.run / 'verdict.json').read_text())
    assert verdict['mission'] == 'attitude_hold'
    assert verdict['reason'] == alone.verdict.reason[0]
    assert verdict['measures']['rms_after_deg']['value'] == alone.verdict.values['rms_after_deg'][0]
