"""The pilots over DDS: a tape gives the flight it was recorded in, nobody leaves it to the law."""

import numpy as np
import pytest
from conftest import Flown
from runs import messages, states, verdict_of


@pytest.mark.slow
def test_the_bag_of_a_flight_is_a_tape_that_flies_it_again(flight, tmp_path):
    again = Flown(tmp_path / 'run', '--tape', str(flight.run / 'bag'), '--seed', '3',
                  '--pace', 'lockstep', '--headless')
    assert again.code == flight.code, again.err
    np.testing.assert_array_equal(states(again.run, '/truth/relative_state'),
                                  states(flight.run, '/truth/relative_state'))
    assert verdict_of(again.run)['operator'] == 'replay'


def test_the_shipped_tape_docks(tmp_path):
    flown = Flown(tmp_path / 'run', '--tape', 'docking', '--pace', 'lockstep', '--headless')
    assert flown.code == 0, flown.err
    assert verdict_of(flown.run)['reason'] == 'docked'


@pytest.mark.slow
def test_a_stuck_stick_fails_with_the_reason_and_exit_code_1(tmp_path):
    flown = Flown(tmp_path / 'run', '--tape', 'stuck_stick', '--mode', 'manual',
                  '--pace', 'lockstep', '--headless')
    assert flown.code == 1, flown.err
    verdict = verdict_of(flown.run)
    assert verdict['reason'] == 'left_corridor'
    assert verdict['measures']['exit_time_s']['value'] > 45.0
    assert 'left the corridor at' in flown.out


@pytest.mark.slow
def test_without_a_pilot_the_law_decides_alone(tmp_path):
    flown = Flown(tmp_path / 'run', '--operator', 'none', '--pace', 'lockstep', '--headless')
    assert flown.code in (0, 1), flown.err
    sent = messages(flown.run, '/ground/command')
    automatic = messages(flown.run, '/ground/auto_command')
    assert [list(m.levels) for m in sent] == [list(m.levels) for m in automatic]
    assert any(any(m.levels) for m in sent)
    assert {m.reason for m in sent[12:]} == {9}         # PILOT_INVALID: the stick has no say


@pytest.mark.slow
def test_real_time_at_ten_times_follows_the_clock_and_docks(tmp_path):
    """No step is held up, so a command may be missing; the approach must still come out."""
    flown = Flown(tmp_path / 'run', '--seed', '3')
    assert flown.code == 0, flown.err + flown.out
    bag = messages(flown.run, '/truth/relative_state')
    assert [m.step for m in bag] == list(range(len(bag)))
    lines = [line for line in flown.out.splitlines() if line.startswith('t ')]
    assert len(lines) >= 5                      # live progress, line by line, all of it known
    assert not [line for line in lines[3:] if 'nan' in line or 'pilot' not in line], flown.out


@pytest.mark.slow
@pytest.mark.parametrize('step_s, delay_s', [(1.0, 5.0), (0.05, 0.5)])
def test_other_steps_fly_too(step_s, delay_s, tmp_path):
    scenario = tmp_path / 'steps.yaml'
    scenario.write_text(f'/**: {{ros__parameters: {{step_s: {step_s}, forward_delay_s: {delay_s}, '
                        f'back_delay_s: {delay_s}, timeout_s: 30.0}}}}')
    flown = Flown(tmp_path / 'run', str(scenario), '--pace', 'lockstep', '--headless')
    assert flown.code == 1 and verdict_of(flown.run)['reason'] == 'timeout', flown.err
    assert len(messages(flown.run, '/truth/relative_state')) == round(30.0 / step_s) + 1
