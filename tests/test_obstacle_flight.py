"""The approach among obstacles over DDS: the same bits as in one process, in every grouping."""

from conftest import Flown
import numpy as np
import pytest
from runs import flown_again

# Noise, scatter, losses, a delay and engines that are on or off, in a run cut short.
ROUGH = """
/**:
  ros__parameters:
    mission: obstacle_field
    step_s: 1.0
    timeout_s: 140.0
    forward_delay_s: 2.0
    back_delay_s: 1.0
    seed: 5
    obstacles: {radius_m: [0.6, 0.9], motion: [orbit, static]}
    thrust: {form: bang_bang}
    speed_corridor: {form: linear}
spacecraft_dynamics:
  ros__parameters:
    execution_noise_fraction: 0.01
    obstacles:
      position_m: [14.89, -2.93, -7.47, 35.0, -9.5, -19.0]
      velocity_m_s: [0.0067, 0.0084, -0.011, 0.0, 0.0, 0.0]
    scatter: {position_m: 0.3, velocity_m_s: 0.003, obstacle_m: 0.1}
relative_sensor:
  ros__parameters: {position_sigma_m: 0.02, velocity_sigma_m_s: 0.001,
                    obstacle_position_sigma_m: 0.05}
link_back:
  ros__parameters: {loss_fraction: 0.1}
link_forward:
  ros__parameters: {loss_fraction: 0.1}
auto_controller:
  ros__parameters: {safe_apf: {alarm: probability, covariance: general, alarm_probability: 0.001}}
"""
COMPARED = {'/truth/state': ('state', 'acceleration', 'obstacles'),
            '/onboard/thruster_command': ('command',), '/ground/alarm': ('on', 'distance', 'zone'),
            '/ground/obstacles': ('obstacles', 'covariance')}


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('processes', ['blocks', 'segments', 'one'])
def test_every_grouping_flies_as_in_process_to_the_last_bit(processes, tmp_path):
    scenario = tmp_path / 'rough.yaml'
    scenario.write_text(ROUGH)
    flown = Flown(tmp_path / 'run', str(scenario), '--processes', processes, '--pace', 'lockstep',
                  '--headless')
    assert flown.code in (0, 1), flown.err
    recorded, loop = flown_again(flown.run, list(COMPARED))
    for topic, parts in COMPARED.items():
        series, history = recorded.of(topic), loop.history[topic]
        assert len(series) == loop.end_step[0] + 1
        for part in parts:
            ours = np.asarray(getattr(history, part)[:, 0], dtype=float)
            np.testing.assert_array_equal(series[part].reshape(ours.shape), ours,
                                          err_msg=f'{topic} {part}')
