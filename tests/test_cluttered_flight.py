"""The lunar approach among keep-out spheres over DDS: the same bits as in one process."""

from conftest import Flown
import numpy as np
import pytest
from runs import flown_again

COMPARED = {                            # by signal: its part, and the column of the bag's series
    '/truth/relative_state': {'state': 'state', 'acceleration': 'accel'},
    '/onboard/thruster_command': {'command': 'levels'},
    '/ground/auto_command': {'command': 'levels'}}
NOT_FLYABLE = """
/**:
  ros__parameters:
    obstacles: {number: 1, radius_m: [0.4], position_m: [-0.1, 0.2, 0.0]}
state_predictor:
  ros__parameters: {filter: adaptive}
"""


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('processes', ['blocks', 'one'])
def test_the_graph_flies_as_in_process_to_the_last_bit(processes, tmp_path):
    flown = Flown(tmp_path / 'run', 'cluttered', '--processes', processes, '--pace', 'lockstep',
                  '--headless', '--seed', '4')
    assert flown.code in (0, 1), flown.err
    recorded, loop = flown_again(flown.run, list(COMPARED))
    for topic, parts in COMPARED.items():
        series, history = recorded.of(topic), loop.history[topic]
        assert len(series) == loop.end_step[0] + 1
        for part, column in parts.items():
            ours = np.asarray(getattr(history, part)[:, 0], dtype=float)
            theirs = np.asarray(getattr(series, column)).reshape(ours.shape)
            np.testing.assert_array_equal(theirs, ours, err_msg=f'{topic} {part}')
    assert 'least clearance of an obstacle' in (flown.run / 'report.html').read_text()


def test_an_obstacle_on_the_port_is_refused_in_one_line(tmp_path):
    scenario = tmp_path / 'blocked.yaml'
    scenario.write_text(NOT_FLYABLE)
    flown = Flown(tmp_path / 'run', str(scenario), '--headless')
    assert flown.code == 2 and len(flown.err.strip().splitlines()) == 1
    assert ('obstacles.position_m of obstacle 1 must be more than 0.7 m from the docking port'
            in flown.err)
