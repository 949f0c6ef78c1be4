"""A flight that is aborted says so: on /run/verdict, in verdict.json and in its report."""

import os
from pathlib import Path
import subprocess
import sys

import pytest
from runs import end, in_flight, messages, node_pid, start_rvd, verdict_of

from rvd_dynamics.commands.codes import KIND_ABORT

pytestmark = [pytest.mark.slow, pytest.mark.patient]
SCENARIO = """
/**:
  ros__parameters: {pace: realtime, pace_factor: 20.0, step_s: 0.5, timeout_s: 200.0, processes: %s}
"""
ASK = """
import rclpy
from rvd_interfaces.srv import RunControl
rclpy.init()
node = rclpy.create_node('somebody')
client = node.create_client(RunControl, '/run/control')
assert client.wait_for_service(30.0)
future = client.call_async(RunControl.Request(action=RunControl.Request.ABORT))
rclpy.spin_until_future_complete(node, future, timeout_sec=30.0)
assert future.result().accepted
node.destroy_node()
rclpy.shutdown()
"""
NODES = {'blocks': 'onboard_guard', 'segments': 'onboard', 'one': 'one'}


def environment_of(pid: int) -> dict[str, str]:
    """Return the environment of a node: its domain and how it may be heard."""
    words = Path(f'/proc/{pid}/environ').read_bytes().decode().split('\0')
    return dict(word.split('=', 1) for word in words if '=' in word)


@pytest.mark.parametrize('processes', NODES)
def test_an_aborted_flight_says_so_everywhere(processes, tmp_path):
    (tmp_path / 'fast.yaml').write_text(SCENARIO % processes)
    process = start_rvd('fly', 'fast.yaml', '--headless', '--out', 'run', cwd=tmp_path)
    try:
        run = tmp_path / 'run'
        in_flight(run, 20)
        environment = {**os.environ, **environment_of(node_pid(process.pid, NODES[processes]))}
        asked = subprocess.run([sys.executable, '-c', ASK], env=environment, timeout=90,
                               capture_output=True, text=True)
        assert asked.returncode == 0, asked.stderr
        assert process.wait(120) == 1               # flown, and no success
    finally:
        end(process)
    told = verdict_of(run)
    assert (told['success'], told['reason']) == (False, 'aborted')
    assert told['trusted'] and told['bag_agrees'], told
    assert told['flown']['aborted'] and told['flown']['modes']['abort'] > 0.3
    final = [m for m in messages(run, '/run/verdict') if m.final]
    since = 0.5*next(m.step for m in messages(run, '/onboard/thruster_command')
                     if m.kind == KIND_ABORT)
    assert [(m.reason, m.words) for m in final] == [('aborted', f'aborted at {since:.1f} s')]
    assert all(m.reason == '' for m in messages(run, '/run/verdict') if not m.final)
    assert (f'Failed: {final[0].words}; the run ended after {told["duration_s"]:.1f} s'
            in (run / 'report.html').read_text())
