"""The mission docking over DDS: every grouping gives the bits of the loop in one process."""

from conftest import Flown
import numpy as np
import pytest
from runs import flown_again

from rvd_missions.docking.signals import ESTIMATE, GUIDANCE, POSE, THRUST, TRUTH

SHORT = '''
/**: {ros__parameters: {mission: docking, timeout_s: 4.0, limits: {from_s: 1.0},
                        seeing: {camera: %s}, planner: %s}}
'''
FLIGHTS = {                                     # grouping: camera, planner
    'blocks': ('pinhole', 'velocity_profile'), 'segments': ('simple', 'pseudospectral'),
    'one': ('pinhole', 'velocity_profile')}


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('processes', FLIGHTS)
def test_a_flight_is_the_loop_in_one_process_to_the_last_bit(processes, tmp_path):
    (tmp_path / 'short.yaml').write_text(SHORT % FLIGHTS[processes])
    flight = Flown(tmp_path / 'run', str(tmp_path / 'short.yaml'), '--seed', '5', '--headless',
                   '--pace', 'lockstep', '--processes', processes)
    assert flight.code in (0, 1), flight.err
    run, alone = flown_again(flight.run, True)
    for signal in (TRUTH, POSE, ESTIMATE, GUIDANCE, THRUST):
        there, here = run.of(signal), alone.history[signal.name]
        for part in (p.name for p in signal.parts if not p.optional):
            values = getattr(here, part)[:, 0]
            values = values[::10] if signal is POSE else values
            np.testing.assert_array_equal(np.asarray(there[part]), values,
                                          err_msg=f'{signal.name} {part}')
    assert len(run.of(TRUTH)['final']) == 401
