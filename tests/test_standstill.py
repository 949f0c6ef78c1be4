"""Ctrl-Z, a paused container: a run that stood still goes on, and is not given up for a stall."""

import contextlib
import os
import random
import signal
import subprocess
import sys
import time

from mcap.reader import make_reader
import pytest
from rclpy.context import Context
from rclpy.node import Node
from runs import end, pids_under, start_rvd, states, verdict_of, wait_for

from rvd_campaign.flight.reach import OURS, PROFILES, RANGE

STILL_S = 12.0                  # [s] longer than the 10 s without a step that a run is granted
LONG_S = 24.0                   # [s] longer than the 20 s after which DDS takes one for dead
PACE = 5
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
        stand_still([process.pid, *(pids_under(process.pid) if who == 'the computer' else ())],
                    STILL_S)
        assert process.wait(60.0) == 1
    finally:
        end(process)
    said = (tmp_path / 'out').read_text()
    assert 'rvd fly was stopped for 12 s' in said
    assert ('stood still for 12 s of wall time; simulation time goes on' in said) == \
        (who == 'the computer')
    assert verdict_of(tmp_path / 'run')['reason'] == 'timeout'
    assert len(states(tmp_path / 'run', '/truth/relative_state')) == 25    # of 0.5 s, none left out


@pytest.mark.slow
@pytest.mark.patient
def test_a_paused_container_goes_on_and_nothing_of_the_flight_is_lost(tmp_path):
    """Of six flights that stood still like this one was given up, and of one a part was lost."""
    process = start_rvd('fly', '--pace', f'{PACE}', '--processes', 'segments', '--seed', '0',
                        '--out', str(tmp_path / 'run'), cwd=tmp_path)
    try:
        wait_for(lambda: 'range' in (tmp_path / 'out').read_text(), 'the first steps', 60.0)
        stand_still([process.pid, *pids_under(process.pid)], LONG_S)
        code = process.wait(180.0)
    finally:
        end(process)
    said = (tmp_path / 'out').read_text()
    assert code in (0, 1), said                 # as the flight was, on this machine
    assert 'rvd fly was stopped for 24 s' in said and 'stood still for 24 s of wall time' in said
    assert 'second writer' not in said and 'sign of life' not in said
    verdict = verdict_of(tmp_path / 'run')
    assert (verdict['trusted'], verdict['doubts'], verdict['bag_agrees']) == (True, [], True)
    steps = states(tmp_path / 'run', '/truth/relative_state')[:, -1]
    assert list(steps) == list(range(len(steps)))
    assert verdict['recording'] == {'complete': True, 'steps_flown': len(steps),
                                    'steps_stored': len(steps), 'missing': {}}
    with (tmp_path / 'run' / 'bag' / 'bag_0.mcap').open('rb') as bag:
        sent = [message.publish_time/1e9 for *_, message in make_reader(bag).iter_messages(
            topics=['/truth/relative_state'])]
    # What it stood still is not made up for: a plant that hurries would make 240 steps at once.
    assert sent[-1] - sent[0] > LONG_S + 0.95*(len(sent) - 1)*0.5/PACE


def stand_still(pids, seconds):
    """Let processes stand still, in any order."""
    random.shuffle(pids)
    for number, wait_s in ((signal.SIGSTOP, seconds), (signal.SIGCONT, 0.0)):
        for pid in pids:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, number)
        time.sleep(wait_s)


NODE = """
import rclpy, sys, time
rclpy.init()
node = rclpy.create_node(sys.argv[1], enable_rosout=False, start_parameter_services=False)
time.sleep(300)
"""


@pytest.mark.slow
@pytest.mark.patient
def test_a_process_that_stands_still_is_not_taken_for_dead(own_domain):
    """Its twin has not our profile of Fast DDS: it is forgotten."""
    assert os.environ[PROFILES].endswith(OURS)
    without = {name: value for name, value in os.environ.items() if name != PROFILES}
    context = Context()
    context.init(domain_id=own_domain)
    watch = Node('watch', context=context)
    nodes = {name: subprocess.Popen([sys.executable, '-c', NODE, name], env=env) for name, env in
             {'ours': os.environ, 'twin': {**without, RANGE: 'LOCALHOST'}}.items()}
    try:
        wait_for(lambda: nodes.keys() <= set(watch.get_node_names()), 'both nodes')
        for node in nodes.values():
            node.send_signal(signal.SIGSTOP)
        wait_for(lambda: 'twin' not in watch.get_node_names(), 'its end', 60.0)
        time.sleep(3.0)
        assert 'ours' in watch.get_node_names()
    finally:
        for node in nodes.values():
            node.kill()
            node.wait()
        watch.destroy_node()
        context.try_shutdown()
