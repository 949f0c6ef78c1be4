"""
Every process of a run gives signs of life, from its work: who is silent is named within 3 s.

A recorder that misses something does not hide it: terminal, verdict.json, bag and report say so.
"""

import contextlib
import os
import signal
import threading
import time

from diagnostic_msgs.msg import DiagnosticArray
import pytest
from runs import alive, in_flight, node_pid, states, verdict_of, wait_for
from test_by_hand import Hand

from rvd_campaign.report.run import page
from rvd_dynamics.recording.reader import read

NAMED_S = 3.0                   # [s] wall time
SCENARIO = '/**: {ros__parameters: {timeout_s: 30.0}}'
STEPS = 61                      # of 0.5 s
IN_FLIGHT = ('spacecraft_dynamics', 'relative_sensor', 'link_back', 'state_predictor',
             'operator_model', 'auto_controller', 'command_blender', 'link_forward',
             'onboard_guard', 'mission_monitor', 'bag_recorder', 'markers')


@pytest.fixture
def flying(start, tmp_path):
    """Return a starter of flights of the scenario."""
    (tmp_path / 's.yaml').write_text(SCENARIO)
    return lambda *args: start('fly', str(tmp_path / 's.yaml'), '--out', str(tmp_path / 'run'),
                               *args)


def said(folder):
    return (folder / 'out').read_text()


@pytest.mark.slow
@pytest.mark.patient
def test_every_process_that_is_stopped_is_named_and_one_that_stays_so_ends_the_flight(
        flying, tmp_path):
    """All at the same moment: that the others are silent, too, must not matter."""
    process = flying('--pace', '1')
    pids = {name: node_pid(process.pid, name) for name in IN_FLIGHT}
    in_flight(tmp_path / 'run', 4)
    assert 'no sign of life' not in said(tmp_path)
    for pid in pids.values():
        os.kill(pid, signal.SIGSTOP)
    stopped_at = time.monotonic()

    def named():
        return {name for name in pids for line in said(tmp_path).splitlines()
                if f' {name} ' in line and 'no sign of life' in line and 'is stopped' in line}
    wait_for(lambda: named() == set(pids), f'all of {set(pids)}', NAMED_S)
    time.sleep(max(0.0, stopped_at + 3.2 - time.monotonic()))
    for pid in pids.values():
        os.kill(pid, signal.SIGCONT)
    wait_for(lambda: said(tmp_path).count('goes on, after') == len(pids), 'their return', NAMED_S)
    in_flight(tmp_path / 'run', 8)              # it was not given up
    os.kill(pids['mission_monitor'], signal.SIGSTOP)            # to which nobody owes a thing
    assert process.wait(60.0) == 2
    last = [line for line in said(tmp_path).splitlines() if line.startswith('rvd fly: ')]
    assert last[0].startswith('rvd fly: mission_monitor has given no sign of life for 10 s')
    assert not any(alive(pid) for pid in pids.values())
    steps = states(tmp_path / 'run', '/truth/relative_state')[:, -1]
    assert list(steps) == list(range(len(steps)))
    told = read(tmp_path / 'run').events        # the recorder has it, too, that was stopped itself
    for name in pids:
        assert any(e.code == 'SILENT' and e.text.startswith(f'{name} ') for e in told), name
    assert [e.text for e in told if e.code == 'GIVEN_UP'] == [last[0].removeprefix('rvd fly: ')]
    why = last[0].removeprefix('rvd fly: ')
    assert why in page(read(tmp_path / 'run'))
    verdict = verdict_of(tmp_path / 'run')
    assert (verdict['reason'], verdict['given_up']) == ('given_up', why)
    assert len(verdict['silences']) > len(pids)


@pytest.mark.slow
@pytest.mark.patient
def test_a_recorder_that_was_stopped_until_the_end_records_it_all(flying, tmp_path):
    """Nobody waits for it in real time; the nodes do when the run is over, and it is let go on."""
    process = flying('--pace', '12', '--headless')
    pid = node_pid(process.pid, 'bag_recorder')
    in_flight(tmp_path / 'run', 35)
    os.kill(pid, signal.SIGSTOP)
    assert process.wait(60.0) == 1
    assert 'bag_recorder was stopped; the run is over, and it is let go on' in said(tmp_path)
    verdict = verdict_of(tmp_path / 'run')
    assert verdict['reason'] == 'timeout' and verdict['link']['forward']['sent'] > 50
    assert verdict['recording'] == {'complete': True, 'steps_flown': STEPS, 'steps_stored': STEPS,
                                    'missing': {}}
    assert len(states(tmp_path / 'run', '/truth/relative_state')) == STEPS
    let_go = 'bag_recorder was stopped; the run is over, and it is let go on'
    assert let_go in [silence['said'] for silence in verdict['silences']]
    assert let_go in [e.text for e in read(tmp_path / 'run').events if e.code == 'SILENT']


class Stopped:
    """A process that is kept stopped, whoever lets it go on."""

    def __init__(self, pid: int) -> None:
        self._pid, self._over = pid, threading.Event()
        self._thread = threading.Thread(target=self._hold, daemon=True)
        self._thread.start()

    def _hold(self) -> None:
        while not self._over.wait(0.001):
            with contextlib.suppress(ProcessLookupError):
                os.kill(self._pid, signal.SIGSTOP)

    def kill(self) -> None:
        os.kill(self._pid, signal.SIGKILL)
        self._over.set()
        self._thread.join()


@pytest.mark.slow
@pytest.mark.patient
def test_a_recording_with_steps_missing_is_called_so_everywhere(flying, tmp_path):
    """The recorder is stopped, and killed when the verdict is known: a part of the run is lost."""
    process = flying('--pace', '12', '--headless')
    pid = node_pid(process.pid, 'bag_recorder')
    in_flight(tmp_path / 'run', 35)
    stopped = Stopped(pid)
    wait_for(lambda: 'the run is over' in said(tmp_path), 'the end of the run')
    stopped.kill()
    assert process.wait(60.0) == 2
    verdict = verdict_of(tmp_path / 'run')
    stored = len(read(tmp_path / 'run').of('/truth/relative_state').step)
    assert 35 <= stored < STEPS and verdict['reason'] == 'timeout'
    held = verdict['recording']
    assert (held['complete'], held['steps_flown'], held['steps_stored']) == (False, STEPS, stored)
    assert held['missing']['/truth/relative_state'] == STEPS - stored
    assert set(verdict['link']['forward'].values()) == {None}
    last = said(tmp_path).splitlines()[-1]
    assert last.startswith('rvd fly: the recording is incomplete: '
                           f'it holds {stored} of {STEPS} steps')
    assert 'The bag was cut off' in page(read(tmp_path / 'run'))


@pytest.mark.slow
@pytest.mark.patient
def test_a_node_that_has_nothing_to_do_gives_signs_of_life_all_the_same(tmp_path):
    """Of nodes started by hand, /diagnostics is the sign; a stopped one gives none."""
    (tmp_path / 's.yaml').write_text('/**: {ros__parameters: {}}')
    hand = Hand(tmp_path / 's.yaml')
    try:
        heard = hand.listen('/diagnostics', DiagnosticArray)
        hand.start('mission_monitor', '-p', 'nodes:=[mission_monitor]')
        hand.until(lambda: len(heard) >= 3, 'three signs of life')
        assert {status.name for message in heard for status in message.status} == {
            'mission_monitor'}
        monitor = hand.processes['mission_monitor']
        monitor.send_signal(signal.SIGSTOP)
        hand.until_still(heard, 2.5)
        monitor.send_signal(signal.SIGCONT)
        hand.until(lambda: 'stood still' in heard[-1].status[0].message, 'what it says of that')
    finally:
        hand.close()
