"""How a run ends when it does not end well: Ctrl-C, killed and hung nodes, a killed recorder."""

import os
import signal
import subprocess
import sys
import time
from pathlib import Path
from types import SimpleNamespace

import pytest
from runs import (
    alive, in_flight, messages, node_pid, pids_under, rvd, verdict_of,
    wait_for)

from rvd_campaign.flight import fly, supervisor, vigil
from rvd_campaign.flight.supervisor import Supervisor
from rvd_campaign.report.run import page, write_report
from rvd_dynamics.diagram.roster import Process
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.pulse import Pulse
from rvd_dynamics.recording.reader import read


@pytest.fixture
def flying(start, tmp_path):
    """Return a starter of flights without a display."""
    return lambda *args: start('fly', '--out', str(tmp_path / 'run'), '--headless', *args)


def test_ctrl_c_ends_every_process_and_leaves_a_readable_bag(flying, tmp_path):
    process = flying('--pace', '5')
    in_flight(tmp_path / 'run')
    nodes = pids_under(process.pid)
    assert len(nodes) >= 11
    process.send_signal(signal.SIGINT)
    assert process.wait(60.0) == 130
    wait_for(lambda: not any(alive(pid) for pid in nodes), 'the end of every node', 2.0)
    steps = [m.step for m in messages(tmp_path / 'run', '/truth/relative_state')]
    assert len(steps) > 5 and steps == list(range(len(steps)))
    assert verdict_of(tmp_path / 'run')['reason'] == 'interrupted'


@pytest.mark.parametrize('victim', ['state_predictor', 'link_forward', 'spacecraft_dynamics'])
def test_a_killed_node_is_named_and_the_run_ends_with_2(victim, flying, tmp_path):
    process = flying('--pace', '5')
    in_flight(tmp_path / 'run')
    os.kill(node_pid(process.pid, victim), signal.SIGKILL)
    assert process.wait(60.0) == 2
    assert f'{victim} was ended by signal 9' in (tmp_path / 'out').read_text()


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('victim, scenario', [
    ('auto_controller', 'paper'), ('link_back', 'paper'), ('bag_recorder', 'paper'),
    ('operator_model', 'barrier')])             # there the law waits for the stick, too
def test_a_hung_node_is_named_and_the_run_ends_with_2(victim, scenario, flying, tmp_path):
    """
    In lock step all stand still together: who is stopped is told at once, the run given up later.
    """
    process = flying(scenario, '--pace', 'lockstep')
    pid = node_pid(process.pid, victim)
    in_flight(tmp_path / 'run', 50)
    os.kill(pid, signal.SIGSTOP)
    stopped = f's {victim} has given no sign of life for 2.'
    wait_for(lambda: stopped in (tmp_path / 'out').read_text(), 'its name', 3.0)
    assert process.wait(60.0) == 2
    said = (tmp_path / 'out').read_text()
    assert said.count('no sign of life') == 2, said             # of nobody else
    assert (f'{victim} has given no sign of life for 10 s of wall time: {victim} owes a message; '
            'it is stopped') in said, said
    assert not alive(pid)


@pytest.mark.slow
def test_a_flight_that_nobody_watched_has_its_verdict(flying, tmp_path):
    """Nodes wait for the recorder, not for `fly`: it may not have heard one message."""
    scenario = tmp_path / 'short.yaml'
    scenario.write_text('/**: {ros__parameters: {timeout_s: 20.0}}')
    process = flying(str(scenario), '--pace', 'lockstep')
    nodes = wait_for(lambda: len(pids_under(process.pid)) >= 12 and pids_under(process.pid),
                     'every node')
    os.kill(process.pid, signal.SIGSTOP)
    wait_for(lambda: not any(alive(pid) for pid in nodes), 'the end of every node')
    os.kill(process.pid, signal.SIGCONT)
    assert process.wait(60.0) == 1, (tmp_path / 'out').read_text()
    verdict = verdict_of(tmp_path / 'run')
    assert verdict['reason'] == 'timeout' and verdict['duration_s'] == 20.0
    assert verdict['link']['forward']['sent'] == len(messages(tmp_path / 'run', '/ground/uplink'))


@pytest.mark.slow
def test_a_killed_recorder_loses_nothing_it_had_received(flying, tmp_path):
    process = flying('--pace', '5')
    in_flight(tmp_path / 'run')
    os.kill(node_pid(process.pid, 'bag_recorder'), signal.SIGKILL)
    assert process.wait(60.0) == 2
    recording = read(tmp_path / 'run')
    steps = recording.of('/truth/relative_state').step
    assert len(steps) > 5 and list(steps) == list(range(len(steps)))
    why = 'bag_recorder was ended by signal 9'          # it could not store that itself
    verdict = verdict_of(tmp_path / 'run')
    assert (verdict['success'], verdict['reason'], verdict['given_up']) == (False, 'given_up', why)
    assert why not in page(recording)
    assert f'The flight was given up: {why}.' in write_report(tmp_path / 'run').read_text()


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('name', ['bag_recorder', 'mission_monitor'])
def test_a_run_does_not_go_on_without_a_node_that_somebody_has_ended(name, flying, tmp_path):
    process = flying('--pace', '1')
    in_flight(tmp_path / 'run', steps=2)
    os.kill(node_pid(process.pid, name), signal.SIGTERM)
    assert process.wait(60.0) == 2
    said = (tmp_path / 'out').read_text()
    assert f's {name} has ended, and the run is not over' in said
    assert f'{name} ended before the run was over' in said


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('number, words', [
    ('SIGTERM', 'the bring-up was told to end (SIGTERM)'),
    ('SIGKILL', 'the bring-up was ended by SIGKILL')])
def test_a_signal_to_the_bring_up_is_named(number, words, flying, tmp_path):
    process = flying('--pace', 'realtime', '--processes', 'one')
    in_flight(tmp_path / 'run', steps=2)
    node = node_pid(process.pid, 'one')
    bring_up = int(Path(f'/proc/{node}/stat').read_text().rsplit(')', 1)[1].split()[1])
    os.kill(bring_up, signal.Signals[number])
    assert process.wait(60.0) == 2
    assert f'rvd fly: {words} before the run was over' in (tmp_path / 'out').read_text()
    assert not alive(node)


BRING_UP = '''#!/bin/bash
trap 'TOLD; kill $!; wait $!; echo exit law 143; exit 143' TERM
sleep 60 >/dev/null &
echo start law $!
wait
'''


@pytest.mark.parametrize('told', [True, False])
def test_what_processes_answer_to_the_end_of_the_bring_up_is_no_failure_of_theirs(
        told, monkeypatch, tmp_path):
    """One that only starts ends with 143; a bring-up that says nothing leaves it to be blamed."""
    script = tmp_path / 'bringup.sh'
    script.write_text(BRING_UP.replace('TOLD', 'echo told SIGTERM' if told else ':'))
    script.chmod(0o755)
    roster = SimpleNamespace(processes=(), diagram=SimpleNamespace(externals=()))
    monkeypatch.setattr(supervisor, 'lines', lambda *arguments: [])
    flight = object.__new__(fly.Flight)
    flight._scenario = parse('{}', 'plain')
    flight._stop_asked = lambda: False
    flight._roster = roster
    flight._supervisor = Supervisor(script, tmp_path / 's.yaml', tmp_path, True, 0, roster, 'run')
    flight._watch = SimpleNamespace(steps=1, verdict=None, strangers=[])
    monkeypatch.setattr(flight, '_look', lambda s: time.sleep(0.05) or 0.0)
    monkeypatch.setattr(flight, '_outcome', lambda: (None, {}))
    try:
        wait_for(lambda: flight._supervisor.poll() or flight._supervisor.pids, 'its first word')
        os.kill(flight._supervisor._process.pid, signal.SIGTERM)
        wait_for(lambda: flight._supervisor.poll() or flight._supervisor.codes, 'the end')
        assert flight._follow() == (
            'the bring-up was told to end (SIGTERM) before the run was over' if told
            else 'law was ended by signal 15')
    finally:
        flight._supervisor.stop()


@pytest.mark.parametrize('said, failures', [
    ('exit law 2; exit guard 143; exit link 0', {'law': 2}),
    ('exit law 1; exit guard 143; exit link 2', {'law': 1, 'link': 2}),
    ('exit guard 143; exit law 1; exit link 143', {'guard': 143, 'law': 1}),
    ('exit guard 143; exit law 0; exit link 0', {'guard': 143})])
def test_who_is_told_to_end_in_his_start_has_not_failed_beside_one_that_has(
        said, failures, monkeypatch, tmp_path):
    """The bring-up ends all when one has failed; the first was ended by somebody else."""
    script = tmp_path / 'bringup.sh'
    script.write_text('#!/bin/sh\n' + '\n'.join(
        f'echo {word.strip()}' for word in ('start law 1;start guard 1;start link 1;' + said
                                            ).split(';')))
    script.chmod(0o755)
    roster = SimpleNamespace(processes=(), diagram=SimpleNamespace(externals=()))
    monkeypatch.setattr(supervisor, 'lines', lambda *arguments: [])
    started = Supervisor(script, tmp_path / 's.yaml', tmp_path, True, 0, roster, 'run')
    try:
        wait_for(lambda: started.poll() or len(started.codes) == 3, 'all ends')
        assert started.failures() == failures
    finally:
        started.stop()


def test_what_only_a_node_can_refuse_is_told_in_one_line(tmp_path):
    (tmp_path / 's.yaml').write_text("""
/**: {ros__parameters: {mission: docking, panels: {mass_kg: 3000.0}}}
""")
    done = rvd('fly', 's.yaml', '--headless', '--processes', 'segments', cwd=tmp_path)
    assert done.returncode == 2
    said, = done.stderr.splitlines()
    # both have the craft to make, in processes of their own: the first to come to it speaks
    assert said.startswith(('rvd fly: docking_dynamics: ', 'rvd fly: mission_monitor: ')), said
    assert said.count('positive') == 1, said


def after_a_flight(monkeypatch, folder, spin):
    """Return a flight that waits for its nodes, one of which does not end; `spin` is its time."""
    monkeypatch.setattr(fly, 'END_S', 0.1)
    flight = object.__new__(fly.Flight)
    flight._scenario = parse('{}', 'plain')
    flight._run_dir, flight._headless, flight._on_line = folder, True, False
    flight._roster = SimpleNamespace(diagram=SimpleNamespace(externals=()), processes=())
    flight._supervisor = supervisor = SimpleNamespace(
        pids={'a': 1, 'link_forward': 2}, codes={'a': 0}, ended=False, failures=dict,
        end_if_left=lambda names: None, let_go_on=list,
        pulse=SimpleNamespace(flown=3, final=9),
        left=lambda: {n: p for n, p in supervisor.pids.items() if n not in supervisor.codes})
    flight._run = SimpleNamespace(pace='lockstep', step_s=0.5)
    flight._vigil = SimpleNamespace(look=list, waits=False)
    flight._watch = SimpleNamespace(spin=spin, new_events=list, steps=1)
    return flight


def test_a_node_that_hangs_after_the_flight_does_not_take_the_verdict_with_it(
        monkeypatch, tmp_path, capsys):
    """The supervisor is played here: hanging in the middleware cannot be had on demand."""
    after_a_flight(monkeypatch, tmp_path, lambda s: time.sleep(0.01))._wait_for_the_nodes()
    assert 'link_forward did not end after the flight' in capsys.readouterr().err


def test_only_who_is_alive_did_not_end(monkeypatch, tmp_path, capsys):
    """A bring-up that is stopped tells of no end, and its dead are not buried."""
    dead = subprocess.Popen(['true'])
    os.waitid(os.P_PID, dead.pid, os.WEXITED | os.WNOWAIT)      # a zombie from now on
    flight = after_a_flight(monkeypatch, tmp_path, lambda s: time.sleep(0.01))
    supervisor = object.__new__(Supervisor)
    supervisor.pids, supervisor.codes = {'a': dead.pid, 'link_forward': os.getpid()}, {}
    monkeypatch.setattr(supervisor, 'poll', lambda: None, raising=False)
    flight._supervisor.left = supervisor.left
    flight._wait_for_the_nodes()
    assert 'rvd fly: link_forward did not end' in capsys.readouterr().err
    dead.wait()


def test_a_recorder_that_still_writes_is_waited_for(monkeypatch, tmp_path, capsys):
    (tmp_path / 'bag').mkdir()
    draft, looks = tmp_path / 'bag' / 'bag_0.mcap.draft', []

    def spin(seconds):
        looks.append(draft.write_bytes(b'.'*len(looks)))
        time.sleep(0.02)
        flight._supervisor.ended = len(looks) == 20         # four times as long as a hung one gets
        flight._supervisor.codes['link_forward'] = 0
    flight = after_a_flight(monkeypatch, tmp_path, spin)
    flight._wait_for_the_nodes()
    assert len(looks) == 20 and capsys.readouterr().err == ''


@pytest.mark.parametrize('does, given_up_s',
                         [('time.sleep(60)', 0.6), ('while True:\n    pass', 2.5)])
def test_a_process_that_computes_is_given_longer_than_one_that_hangs(
        does, given_up_s, monkeypatch):
    """A first use compiles for longer than a step may take, with other programs about."""
    for name, seconds in (('STALL_S', 0.6), ('WORK_S', 2.5), ('SILENT_S', 0.4), ('LOOK_S', 0.05)):
        monkeypatch.setattr(vigil, name, seconds)
    process = subprocess.Popen([sys.executable, '-c', f'import time\nprint(flush=True)\n{does}'],
                               stdout=subprocess.PIPE)
    process.stdout.readline()
    try:
        page, begun = Pulse(), time.monotonic()
        page.beat(0, time.monotonic_ns())
        watched = vigil.Vigil((Process('law', '', '', ('law',), False),), page,
                              lambda: {'law': process.pid})
        while not watched.given_up():
            assert time.monotonic() < begun + 10.0
            time.sleep(0.05)
            watched.look()
        assert time.monotonic() - begun == pytest.approx(given_up_s, abs=0.9)
    finally:
        process.kill()
        process.wait()


@pytest.mark.parametrize('waited', [True, False])
def test_who_comes_back_gets_the_time_to_make_a_step(waited):
    """It has compiled for minutes, in which the ring made none."""
    flight = object.__new__(fly.Flight)
    flight._run = SimpleNamespace(pace='lockstep')
    flight._vigil = SimpleNamespace(waits=waited)
    flight._watch = SimpleNamespace(steps=1, paused=False, verdict=None, progress_at=100.0)
    assert flight._stalled(280.0) == (not waited)
    flight._vigil.waits = False
    assert flight._stalled(289.9) == (not waited)
    assert flight._stalled(290.1)


@pytest.mark.parametrize('final, early, said, words', [
    (-1, False, 'law ended before the run was over', 'the run is not over'),
    (9, True, 'law ended before the run was over', 'its work was not done'),
    (9, False, 'the run ended without a verdict: mission_monitor ended and had given none', '')])
def test_who_ended_before_it_should_have_is_named(
        final, early, said, words, monkeypatch, tmp_path, capsys):
    flight = object.__new__(fly.Flight)
    flight._scenario = parse('{}', 'plain')
    flight._headless, flight._on_line, flight._stop_asked = True, False, lambda: False
    flight._early, flight._silences = [], []
    flight._roster = SimpleNamespace(diagram=SimpleNamespace(externals=()),
                                     processes=(Process('law', '', '', ('law',), False),))
    page = Pulse()
    page.flown, page.final = 3, final
    page.leave(0, early)
    flight._run = SimpleNamespace(step_s=0.5)
    flight._supervisor = SimpleNamespace(codes={'law': 0}, ended=True, failures=dict, ended_by=str,
                                         complaint=str, pulse=page)
    flight._watch = SimpleNamespace(steps=4, verdict=None, strangers=[])
    monkeypatch.setattr(flight, '_look', lambda s: 0.0)
    monkeypatch.setattr(flight, '_outcome', lambda: (None, {}))
    assert flight._follow() == said
    out = f'law has ended, and {words}'
    assert (out in capsys.readouterr().out) == bool(words)
    assert page.heard(0)[0] == ([('ENDED_EARLY', 3, out)] if words else [])


@pytest.mark.parametrize('final', [True, False])
def test_a_node_that_fails_when_the_bag_has_the_verdict_takes_nothing_with_it(
        final, monkeypatch, tmp_path, capsys):
    """`fly` need not have heard the verdict: a short run is over before it knows the others."""
    flight = object.__new__(fly.Flight)
    flight._scenario = parse('{}', 'plain')
    flight._headless, flight._on_line, flight._stop_asked = True, False, lambda: False
    flight._run_dir, flight._progress = tmp_path, lambda words: None
    flight._starting = SimpleNamespace(progress=lambda ready: '')
    flight._roster = SimpleNamespace(diagram=SimpleNamespace(externals=()), processes=())
    flight._supervisor = SimpleNamespace(pids={'world': 1}, codes={'world': 1}, ended=True,
                                         failures=lambda: {'world': 1}, left=dict, ended_by=str,
                                         pulse=SimpleNamespace(final=9))
    flight._vigil = SimpleNamespace(look=list)
    flight._watch = SimpleNamespace(spin=lambda s: None, new_events=list, steps=0, verdict=None,
                                    strangers=[], ready=())
    monkeypatch.setattr(flight, '_outcome', lambda: (SimpleNamespace(final=final), {}))
    monkeypatch.setattr(flight, '_why', lambda failures: f'{failures}')
    assert flight._follow() == (None if final else "{'world': 1}")
    assert ("after the flight {'world': 1}" in capsys.readouterr().err) == final
