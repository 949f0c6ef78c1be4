"""Runs for the integration tests: the real command, the real processes, a bag read by rosbags."""

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

from mcap.records import Channel, Message
import numpy as np
from rosbags.highlevel import AnyReader

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.recording import mcap_file
from rvd_dynamics.recording.reader import read

ROOT = Path(__file__).resolve().parents[1]
STATE = ('x', 'y', 'z')


def rvd(*args: str, cwd: Path, timeout: float = 120.0) -> subprocess.CompletedProcess:
    """Run `rvd ARGS` to its end in `cwd`; the domain id is one that no other run holds."""
    return subprocess.run(command(*args), cwd=cwd, env=environment(), timeout=timeout,
                          capture_output=True, text=True)


def start_rvd(*args: str, cwd: Path, overlay: Path | None = None) -> subprocess.Popen:
    """
    Start `rvd ARGS` in a process group of its own, output kept in `cwd`/out.

    `overlay` is an install folder with further packages, loaded by the script `rvd`.
    """
    words, env = command(*args), environment()
    if overlay is not None:
        words, env = [str(ROOT / 'rvd'), *args], {**env, 'RVD_OVERLAY': str(overlay)}
    return subprocess.Popen(words, cwd=cwd, env=env, text=True,
                            stdout=(cwd / 'out').open('w'), stderr=subprocess.STDOUT,
                            start_new_session=True, preexec_fn=_hear_ctrl_c)


def _hear_ctrl_c() -> None:
    """Undo what a shell does to jobs in the background: they inherit a Ctrl-C that is ignored."""
    signal.signal(signal.SIGINT, signal.SIG_DFL)


def command(*args: str) -> list[str]:
    return [sys.executable, '-m', 'rvd_campaign.cli', *args]


def environment() -> dict[str, str]:
    return {**{k: v for k, v in os.environ.items() if k != 'ROS_DOMAIN_ID'},
            'RVD_ROOT': str(ROOT)}


def verdict_of(run: Path) -> dict:
    return json.loads((run / 'verdict.json').read_text())


def messages(run: Path, topic: str) -> list:
    """Return the messages of a topic as the independent reader decodes them."""
    with AnyReader([run / 'bag']) as reader:
        connections = [c for c in reader.connections if c.topic == topic]
        return [reader.deserialize(data, c.msgtype)
                for c, _, data in reader.messages(connections=connections)]


def counts(run: Path) -> dict[str, int]:
    with AnyReader([run / 'bag']) as reader:
        return {topic: info.msgcount for topic, info in reader.topics.items()}


def states(run: Path, topic: str) -> np.ndarray:
    """Return position, velocity, acceleration and step of a RelativeState topic, (steps, 10)."""
    return np.array([[*vector(m.position), *vector(m.velocity), *vector(m.acceleration), m.step]
                     for m in messages(run, topic)])


def flown_again(run: Path, signals: list[str] | bool) -> tuple:
    """Return a recorded run and the same one in process, when verdict and measures are equal."""
    recorded = read(run)
    loop = fly(recorded.scenario, [recorded.scenario.run.run], record=signals)
    assert recorded.verdict.reason == loop.verdict.reason[0]
    for measure in recorded.verdict.measures:
        np.testing.assert_array_equal(measure.value, loop.verdict.values[measure.name][0],
                                      err_msg=measure.name)
    return recorded, loop


def vector(v) -> tuple[float, float, float]:
    return v.x, v.y, v.z


def pids_under(root_pid: int) -> set[int]:
    """Return the living descendants of a process."""
    parents = {}
    for stat in Path('/proc').glob('[0-9]*/stat'):
        try:
            fields = stat.read_text().rsplit(')', 1)[1].split()
        except OSError:
            continue
        if fields[0] != 'Z':
            parents[int(stat.parent.name)] = int(fields[1])
    found, front = set(), {root_pid}
    while front:
        front = {pid for pid, parent in parents.items() if parent in front} - found
        found |= front
    return found


def alive(pid: int) -> bool:
    try:
        return Path(f'/proc/{pid}/stat').read_text().rsplit(')', 1)[1].split()[0] != 'Z'
    except OSError:
        return False


def node_pid(root_pid: int, name: str, itself: bool = False) -> int:
    """
    Return the process of node or group `name` of a run, once it is there.

    `itself`: it may also be the process `root_pid`.
    """
    def look() -> int | None:
        for pid in pids_under(root_pid) | ({root_pid} if itself else set()):
            try:
                words = Path(f'/proc/{pid}/cmdline').read_bytes().decode().split('\0')
            except OSError:
                continue
            if {f'__node:={name}', f'group:={name}'} & set(words) and 'python' in words[0]:
                return pid
        return None
    return wait_for(look, f'node {name}')


def wait_for(look, what: str, timeout: float = 30.0):
    """Poll `look` until it returns something true."""
    deadline = time.monotonic() + timeout
    while time.monotonic() < deadline:
        found = look()
        if found:
            return found
        time.sleep(0.05)
    raise AssertionError(f'{what} did not come in {timeout:g} s')


def in_flight(run: Path, steps: int = 10) -> None:
    """Wait until the bag of a run holds so many steps of the truth: until all of it flies."""
    def flies() -> bool:
        channels, seen = set(), 0
        for path in run.glob('bag/*.mcap'):
            for record in mcap_file.records(path):
                if isinstance(record, Channel) and record.topic == '/truth/relative_state':
                    channels.add(record.id)
                elif isinstance(record, Message):
                    seen += record.channel_id in channels
        return seen >= steps
    wait_for(flies, f'{steps} steps of the flight', 60.0)


def end(process: subprocess.Popen) -> None:
    """End a run that a test may have left: by pid, never by name."""
    if process.poll() is None:
        process.send_signal(signal.SIGINT)
        try:
            process.wait(20.0)
        except subprocess.TimeoutExpired:
            for pid in pids_under(process.pid):
                os.kill(pid, signal.SIGKILL)
            process.kill()
            process.wait()
