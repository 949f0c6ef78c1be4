"""Ctrl-Z, a paused container: a run that stood still goes on, and is not given up for a stall."""

import os
import signal
import time

import pytest
from runs import end, pids_under, start_rvd, states, verdict_of, wait_for

STILL_S = 12.0                  # [s] longer than the 10 s without a step that a run is granted
SCENARIO = """/**:
  ros__parameters:
    processes: segments
    timeout_s: 12.0
"""


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('who', ['the command', 'the computer'])
def test_a_run_that_stood_still_flies_to_its_end(tmp_path, who):
    (tmp_path / 's.yaml').write_text(SCENARIO)
    process = start_rvd('fly', str(tmp_path / 's.yaml'), '--pace', 'realtime',
                        '--out', str(tmp_path / 'run'), cwd=tmp_path)
    try:
        wait_for(lambda: 'range' in (tmp_path / 'out').read_text(), 'the first steps')
        stopped = [process.pid, *(pids_under(process.pid) if who == 'the computer' else ())]
        for number, seconds in ((signal.SIGSTOP, STILL_S), (signal.SIGCONT, 0.0)):
            for pid in stopped:
                os.kill(pid, number)
            time.sleep(seconds)
        assert process.wait(60.0) == 1
    finally:
        end(process)
    said = (tmp_path / 'out').read_text()
    assert 'rvd fly was stopped for 12 s' in said
    assert ('stood still for 12 s of wall time; simulation time goes on' in said) == \
        (who == 'the computer')
    assert verdict_of(tmp_path / 'run')['reason'] == 'timeout'
    assert len(states(tmp_path / 'run', '/truth/relative_state')) == 25    # of 0.5 s, none left out
