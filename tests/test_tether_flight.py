"""The tethered gripper over DDS: every grouping gives the bits of the loop in one process."""

import json

from conftest import Flown
import numpy as np
import pytest
from runs import flown_again, ROOT

from rvd_campaign.cli import main
from rvd_dynamics.diagram.scenario import load
from rvd_missions.tether.signals import SITUATION, THRUST, TRACKING, TRUTH

SHORT = {'step_s': 0.1, 'timeout_s': 20.0, 'approach__duration_s': [20.0, 20.0],
         'approach__baseline_m': 41.0, 'planner__nodes': 12}
CHANGES = {                                     # shared, sections by name
    'segments': ({}, {}),
    'one': ({'forward_delay_s': 0.4, 'back_delay_s': 0.3},
            {'gripper_sensors': {'bearing_sigma_rad': 1e-3, 'encoder_sigma_m': 0.01},
             'gripper_tracker': {'observer.on': True}}),
    'blocks': ({}, {'gripper_dynamics': {'elastic': True}}),
}


@pytest.mark.slow
@pytest.mark.patient
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
    run, alone = flown_again(flight.run, True)
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
@pytest.mark.patient
def test_a_plan_that_cannot_be_made_is_one_line_and_exit_code_2(tmp_path):
    chosen = load(ROOT / 'scenarios' / 'tether.yaml').with_values('/**', **{
        **SHORT, 'approach__lateral_m_s': [3.0, 0.0]})
    (tmp_path / 'short.yaml').write_text(chosen.dump())
    flight = Flown(tmp_path / 'run', str(tmp_path / 'short.yaml'), '--headless')
    assert flight.code == 2
    said, *_ = [line for line in flight.err.splitlines() if 'plan infeasible: ' in line]
    assert 'must be at' in said and 'reaches' in said and 'Traceback' not in flight.err


BAD = {                                         # changes under /**; what the line must say
    'slack': ({'tether__least_n': 0.0},
              'tether.least_n must be above 0: the tether could go slack, got 0'),
    'bounds crossed': ({'tether__least_n': 12.0},
                       'tether.least_n must be below most_n, 10, got 12'),
    'abort outside': ({'tether__abort_n': 11.0},
                      'abort_n must be between least_n and most_n, 0.02 and 10, got 11'),
    'short tether': ({'approach__baseline_m': 20.5},
                     'the tether would be shorter than the geometry, got 20.5'),
    'out of view': ({'approach__attitude_rad': [0.0, 0.0, 0.5]},
                    'have the target in the field of view at the start, '
                    '0.4 rad from the boresight, got 0.5 rad'),
    'coarse step': ({'step_s': 1.0}, 'step_s must be at most 0.5'),
    'no time': ({'timeout_s': 10.0}, 'timeout_s must be at least the approach takes, 20 s'),
    'no plan': ({'planner__nodes': 10, 'approach__duration_s': [8.0, 8.0]},
                'plan infeasible: tension must be at least 0.02 N, and the nearest motion reaches'),
}


@pytest.mark.parametrize('name', BAD)
@pytest.mark.parametrize('mission', ['tether', 'tether_delay'])
def test_what_cannot_be_flown_is_one_line_and_exit_code_2(mission, name, tmp_path, capsys):
    """A campaign of one run: the line of `fly`, without bringing the graph up."""
    changes, words = BAD[name]
    changed = {k.replace('__', '.'): v for k, v in {**SHORT, **changes}.items()}
    (tmp_path / 'bad.yaml').write_text(json.dumps({
        'scenario': mission, 'runs': 1, 'set': {'/**': changed}, 'conditions': {'it': {}}}))
    code = main(['campaign', str(tmp_path / 'bad.yaml'), '--workers', '1', '--out',
                 str(tmp_path / 'out')])
    said = [line for line in capsys.readouterr().err.splitlines() if line.strip()]
    assert code == 2
    assert words in said[-1] and not any('Traceback' in line for line in said)
