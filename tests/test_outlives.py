"""
Nothing outlives the command: whatever ends `./rvd fly`, at whatever moment, its processes go, too.

What belongs to a run is found by a mark in the environment that every child inherits.
"""

import os
import random
import signal
import subprocess
import time
import uuid
from pathlib import Path

import pytest
from runs import in_flight

ROOT = Path(__file__).resolve().parents[1]
GONE_S = 20.0                   # [s] the bring-up gives its processes 13 s before it kills them,
KILLED_S = 5.0                  # [s] and 4 where nobody waits for it any more
MARK = 'RVD_TEST_MARK'


def marked(mark: str) -> dict[int, str]:
    """Return command lines by pid of the living processes that carry `mark`."""
    found = {}
    for folder in Path('/proc').iterdir():
        if not folder.name.isdigit():
            continue
        try:
            alive = (folder / 'stat').read_text().rsplit(')', 1)[1].split()[0] != 'Z'
            if alive and f'{MARK}={mark}'.encode() in (folder / 'environ').read_bytes():
                found[int(folder.name)] = (folder / 'cmdline').read_text().replace('\0', ' ')
        except OSError:
            continue
    return found


def left_after(seconds: float, mark: str) -> dict[int, str]:
    """Wait until no marked process is left, at most for `seconds`; return those that are."""
    deadline = time.monotonic() + seconds
    while (left := marked(mark)) and time.monotonic() < deadline:
        time.sleep(0.1)
    return left


def start(folder: Path, mark: str, *options: str) -> subprocess.Popen:
    """Start a flight that would last for half a minute."""
    return subprocess.Popen(
        [ROOT / 'rvd', 'fly', 'hand', '--out', str(folder), *options],
        stdin=subprocess.DEVNULL, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, text=True,
        start_new_session=True, preexec_fn=_hear_signals, env={**os.environ, MARK: mark})


def _hear_signals() -> None:
    """A test run in the background, or under nohup, hands on that these are ignored."""
    for number in (signal.SIGINT, signal.SIGHUP):
        signal.signal(number, signal.SIG_DFL)


def ends(flights: dict[str, subprocess.Popen], end, patience_s: float = GONE_S) -> None:
    """End each flight by `end`; check that nothing of any of them stays."""
    try:
        for flight in flights.values():
            end(flight)
        for mark, flight in flights.items():
            left = left_after(patience_s, mark)
            assert not left, f'left behind: {left}'
            assert 'Traceback' not in flight.stderr.read()
    finally:
        for mark, flight in flights.items():
            for pid in marked(mark):
                os.kill(pid, signal.SIGKILL)
            flight.wait()
            flight.stderr.close()


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('number', [signal.SIGINT, signal.SIGTERM, signal.SIGHUP, signal.SIGKILL],
                         ids=lambda number: number.name)
def test_a_signal_at_any_moment_leaves_no_process(tmp_path, number):
    instants = random.Random(int(number))       # the same ten in every run
    for pair in range(5):                       # two at a time: one disturbs the other
        flights = {}
        for one in range(2):
            mark = uuid.uuid4().hex
            flights[mark] = start(tmp_path / f'{pair}{one}', mark,
                                  '--processes', ('blocks', 'segments')[one])
        begun = time.monotonic()
        due = sorted(instants.uniform(0.0, 4.0) for _ in flights)

        def end(flight):
            time.sleep(max(0.0, begun + due.pop(0) - time.monotonic()))
            flight.send_signal(number)
        ends(flights, end, KILLED_S if number == signal.SIGKILL else GONE_S)


def children_named(word: str, mark: str) -> list[int]:
    return [pid for pid, line in marked(mark).items() if word in line]


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('word', ['scripts/bringup.sh', '__node:=state_predictor'])
def test_what_is_killed_inside_takes_the_rest_with_it(tmp_path, word):
    """The bring-up itself, and one of its nodes."""
    mark = uuid.uuid4().hex
    flight = start(tmp_path / 'run', mark)

    def end(_):
        in_flight(tmp_path / 'run')
        os.kill(children_named(word, mark)[0], signal.SIGKILL)
    ends({mark: flight}, end)
    assert flight.returncode == 2


@pytest.mark.slow
@pytest.mark.patient
def test_both_supervisors_killed_at_once_leave_no_node(tmp_path):
    mark = uuid.uuid4().hex
    flight = start(tmp_path / 'run', mark)

    def end(_):
        in_flight(tmp_path / 'run')
        above = [flight.pid, *children_named('scripts/bringup.sh', mark)]
        for pid in above:
            os.kill(pid, signal.SIGSTOP)        # neither sees the other go
        for pid in above:
            os.kill(pid, signal.SIGKILL)
    ends({mark: flight}, end, patience_s=3.0)


@pytest.mark.slow
@pytest.mark.patient
def test_a_bring_up_that_is_stopped_does_not_keep_a_run_whose_command_was_killed(tmp_path):
    """The nodes see that the command has gone, and let the bring-up go on."""
    mark = uuid.uuid4().hex
    flight = start(tmp_path / 'run', mark, '--pace', '1')
    try:
        in_flight(tmp_path / 'run', 2)
        os.kill(children_named('scripts/bringup.sh', mark)[0], signal.SIGSTOP)
        os.kill(flight.pid, signal.SIGKILL)
        assert not (left := left_after(KILLED_S, mark)), left
    finally:
        for pid in marked(mark):
            os.kill(pid, signal.SIGKILL)
        flight.wait()
        flight.stderr.close()


@pytest.mark.slow
@pytest.mark.patient
def test_a_bring_up_by_hand_ends_all_when_one_fails(tmp_path):
    mark = uuid.uuid4().hex
    bringup = subprocess.Popen(
        [ROOT / 'rvd', 'shell', ROOT / 'scripts' / 'bringup.sh', ROOT / 'scenarios' / 'hand.yaml',
         tmp_path / 'run'], stdout=subprocess.PIPE, text=True, env={**os.environ, MARK: mark})
    try:
        in_flight(tmp_path / 'run')
        os.kill(children_named('__node:=state_predictor', mark)[0], signal.SIGKILL)
        said = bringup.communicate(timeout=GONE_S)[0].splitlines()
    finally:
        bringup.kill()
    assert not left_after(1.0, mark)
    ends_of = [line.split()[1:] for line in said if line.startswith('exit ')]
    assert ['state_predictor', '137'] in ends_of and bringup.returncode == 137
    assert ends_of[-1] == ['bag_recorder', '0']         # it has heard the others to the end
