"""
In real time a process that is behind takes what has arrived in its order, topic by topic.

The executor serves one message of each topic in turn: of a backlog, an input of every tenth step
would be read before nine steps of another, and these would count as missing.
"""

import os
import signal
import time

import numpy as np
import pytest
from runs import end, messages, node_pid, start_rvd, wait_for

from rvd_campaign.bench.pace import KEPT
from rvd_dynamics.recording.reader import read
from rvd_missions.docking.signals import ESTIMATE, TRUTH

STOPPED_S = 0.6                 # [s] 60 steps
SCENARIO = """/**: {ros__parameters: {mission: docking, processes: segments, timeout_s: 6.0,
                                      seeing: {camera: simple}, limits: {from_s: 5.0}}}
"""


@pytest.mark.slow
def test_a_craft_whose_computer_stood_still_reads_all_of_its_samples(tmp_path):
    (tmp_path / 's.yaml').write_text(SCENARIO)
    process = start_rvd('fly', str(tmp_path / 's.yaml'), '--pace', 'realtime', '--headless',
                        '--out', str(tmp_path / 'run'), cwd=tmp_path)
    try:
        pid = node_pid(process.pid, 'onboard')
        bag = tmp_path / 'run' / 'bag' / 'bag_0.mcap'
        wait_for(lambda: bag.exists() and bag.stat().st_size > 100_000, 'the first steps')
        watch = node_pid(process.pid, 'watch')          # goes behind those that keep the pace
        assert os.getpriority(os.PRIO_PROCESS, watch) > os.getpriority(os.PRIO_PROCESS, pid)
        os.kill(pid, signal.SIGSTOP)
        time.sleep(STOPPED_S)
        os.kill(pid, signal.SIGCONT)
        assert process.wait(90.0) in (0, 1)
    finally:
        end(process)
    events = messages(tmp_path / 'run', '/run/events')
    kept, = [event for event in events if event.code == 'PACE']
    missed, steps, _ = map(float, KEPT.search(kept.text).groups())      # as the bench reads it
    assert kept.step == 600 and steps == 601
    assert missed >= 100*STOPPED_S - 5          # while the computer of the thrusters stood still
    late = [event.text for event in events
            if event.code == 'LATE' and event.node == 'docking_navigation']
    assert len(late) < 2, late                  # told at the 1st, 10th, 100th missing input
    run = read(tmp_path / 'run' / 'bag')
    off = np.asarray(run.of(ESTIMATE)['position'])[-50:] - np.asarray(
        run.of(TRUTH)['position'])[-50:]
    assert np.abs(off).max() < 0.02
