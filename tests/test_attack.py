"""
A sample of `./rvd bench attack`: that it holds, and that what it says is so.

Each kind has a twin: without the protection, or with a fault put in, it says NOT held.
"""

import json
import os
from pathlib import Path
import signal
import subprocess
import sys
import time
from types import SimpleNamespace

import numpy as np
import pytest
from runs import rvd

from rvd_campaign import bench, catalogue
from rvd_campaign.bench import attack
from rvd_campaign.bench.attack import dds, flying, frames, kills, limits, texts
from rvd_campaign.flight.domain import reserved_domain
from rvd_dynamics.bad_input import BadInput
from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.link import frame
from rvd_dynamics.link.frame import Refusal, ReplayWindow
from rvd_dynamics.onboard.guard.gate import Gate


def sample(name, count, seed=0, keep=Path('.')):
    """Attack, and return the result and the lines of the table."""
    chosen = attack.kind(name)
    result = attack.run(chosen, count, seed, keep)
    return result, attack.table(chosen, result)


def held(name, count, **more):
    result, lines = sample(name, count, **more)
    assert result['failures'] == [] and not any('NOT held' in line for line in lines), lines
    return result['counts']


# -- frames ------------------------------------------------------------------------------------

def test_no_hostile_frame_is_accepted_and_those_of_the_ground_are():
    counts = held('frames', 8000)
    assert counts['of the ground, accepted'] > 4000 and counts['refusals that were said'] > 2000


def test_the_same_seed_makes_the_same_frames():
    paper = load(catalogue.find('scenarios', 'paper', ('.yaml',)))
    assert frames.volley(paper, 7) == frames.volley(paper, 7) != frames.volley(paper, 8)


@pytest.mark.parametrize('without', ['checksum', 'order', 'age', 'range'])
def test_twin_without_one_check_of_the_gate_hostile_frames_are_accepted(without, monkeypatch):
    refusal = Gate._refusal
    left_out = {'order': Refusal.ORDER, 'age': Refusal.AGE, 'range': Refusal.RANGE}

    def lax(self, step, command):
        found = refusal(self, step, command)
        return None if found is left_out.get(without) else found
    monkeypatch.setattr(Gate, '_refusal', lax)
    if without == 'checksum':
        broken = frame._broken
        monkeypatch.setattr(frame, '_broken', lambda payload, size: (
            found if (found := broken(payload, size)) is Refusal.LENGTH else None))
    paper = load(catalogue.find('scenarios', 'paper', ('.yaml',)))
    outcome = frames.volley(paper, 0)
    # a command that is none of the form goes no further than the codec or the guard
    assert outcome.counts['accepted'] + outcome.counts['crashes'] > 0, outcome.counts
    assert outcome.failures


def test_twin_without_the_replay_window_old_telemetry_is_accepted(monkeypatch):
    paper = load(catalogue.find('scenarios', 'paper', ('.yaml',)))
    assert frames.volley(paper, 0).failures == []
    monkeypatch.setattr(ReplayWindow, 'takes', lambda self, number: True)
    outcome = frames.volley(paper, 0)
    assert outcome.counts['accepted'] > 0
    assert all('link_back accepted a second time' in what for what in outcome.failures)


# -- texts and limits ----------------------------------------------------------------------------

def test_hostile_texts_are_read_or_refused_in_one_line(monkeypatch):
    held('texts', 300)
    from rvd_campaign.bench import hostile_texts
    monkeypatch.setattr(hostile_texts, 'parse', lambda text, name: 1 / 0)
    result, lines = sample('texts', 3)          # the twin
    assert result['counts'] == {'not in one line, or too slow': 3}
    assert 'ZeroDivisionError' in result['failures'][0]['what']
    assert result['failures'][2]['again'] == './rvd bench attack texts --seed 2 --count 1'
    assert sum('NOT held' in line for line in lines) == 1


def test_a_text_that_never_ends_is_a_hang(monkeypatch):
    from rvd_campaign.bench import hostile_texts
    monkeypatch.setattr(texts, 'LIMIT_S', 0.2)
    monkeypatch.setattr(hostile_texts, 'parse', lambda text, name: time.sleep(60))
    outcome = texts.one(0)
    assert outcome.counts == {'hangs': 1} and 'test_attack.py' in outcome.failures[0]


def test_a_child_answers_is_ended_or_dies_of_its_limit_and_none_is_left():
    assert limits.in_child(lambda: {'a': 1}, 20.0, 1 << 30) == {'a': 1}
    with pytest.raises(limits.Hung):
        limits.in_child(lambda: time.sleep(60), 0.3, 1 << 30)
    with pytest.raises(RuntimeError, match='ZeroDivisionError'):
        limits.in_child(lambda: 1 / 0, 20.0, 1 << 30)
    with pytest.raises(RuntimeError, match='MemoryError'):
        limits.in_child(lambda: bytearray(1 << 30), 20.0, 1 << 28)
    with pytest.raises(RuntimeError, match='signal 9'):
        limits.in_child(lambda: os.kill(os.getpid(), signal.SIGKILL), 20.0, 1 << 30)
    with pytest.raises(ChildProcessError):
        os.waitpid(-1, os.WNOHANG)


# -- the command -----------------------------------------------------------------------------

def test_the_command_says_what_held_and_its_code_says_so_too(tmp_path, monkeypatch, capsys):
    done = rvd('bench', 'attack', 'frames', '--count', '1000', '--seed', '4', '--out', 'a.json',
               cwd=tmp_path)
    assert done.returncode == 0, done.stdout + done.stderr
    content = json.loads((tmp_path / 'a.json').read_text())['attack']['frames']
    assert content['count'] == 1000 and content['next_seed'] == 5 and content['failures'] == []
    assert 'accepted                                                0   0          held' in \
        done.stdout
    from rvd_campaign.cli import parser
    args = parser().parse_args(['bench', 'attack', 'texts', '--count', '2'])
    from rvd_campaign.bench import hostile_texts
    monkeypatch.setattr(hostile_texts, 'fault', lambda text: 'it is \x1b[31mwrong')
    monkeypatch.setattr(attack, 'all_like_ctrl_c', lambda: None)
    assert bench.main(args) == 1
    assert 'it is \\x1b[31mwrong' in capsys.readouterr().out


@pytest.mark.parametrize('args, words', [
    (('attack', 'nukes'), 'there are: frames, messages'), (('loop', 'frames'), 'go with'),
    (('loop', '--count', '3'), 'go with'), (('attack', '--count', '0'), '--count must be 1'),
    (('attack', '--seed', '-1'), '--seed must be from 0')])
def test_what_it_cannot_do_is_one_line(args, words, tmp_path):
    done = rvd('bench', *args, cwd=tmp_path)
    assert done.returncode == 2 and done.stderr.count('\n') == 1 and words in done.stderr


# -- flights ---------------------------------------------------------------------------------

def test_a_flight_is_found_by_its_mark_whatever_it_starts(tmp_path, monkeypatch):
    """What stands for `fly` here leaves a process in a session of its own, and ends."""
    program = ('import subprocess, sys; subprocess.Popen([sys.executable, "-c", '
               '"import time; time.sleep(60)"], start_new_session=True)')
    start = subprocess.Popen
    monkeypatch.setattr(flying.subprocess, 'Popen', lambda command, **more: start(
        [sys.executable, '-c', program], **more))
    monkeypatch.setattr(flying, 'GONE_S', 1.0)
    with flying.Flying(tmp_path / 'f') as one:
        assert one.wait(20.0) == 0
        left, = one.orphans()
        pid = int(left.split()[0])
        assert 'time.sleep(60)' in left
    deadline = time.monotonic() + 10.0
    while Path(f'/proc/{pid}').exists() and time.monotonic() < deadline:
        time.sleep(0.05)
    state = Path(f'/proc/{pid}/stat')
    assert not state.exists() or state.read_text().rsplit(')', 1)[1].split()[0] == 'Z'
    assert one.orphans() == []


def test_who_is_named_is_a_whole_word_of_what_fly_says():
    paper = load(catalogue.find('scenarios', 'paper', ('.yaml',)))
    plan = kills.Plan('segments', 'lockstep', 'ground', signal.SIGKILL, True, 1.0)

    def names(text, **changed):
        return kills._names(paper, plan._replace(**changed), text)
    assert names('rvd fly: ground was ended by signal 9')
    assert names('no step for 10 s of wall time: state_predictor (process ground) owes a message')
    assert names('rvd fly: state_predictor is silent')
    assert not names('paper: mission lunar_approach, operator ground\ndocked')
    assert not names('rvd fly: background work') and not names('rvd fly: /ground/estimate'[:9])
    assert names('rvd fly: bringup ended', victim=kills.BRINGUP)
    assert not names('rvd fly: link_forward ended', processes='blocks', victim='link_back')


def test_a_node_that_ended_is_told_from_what_fly_says():
    said = ('0.5 s monitor: hello\nrvd fly: guard ended with code 1: boom; sensor: bad; after it '
            'all is well\nrvd fly: logs are in x\nrvd fly: after the flight law was ended by '
            'signal 9')
    assert dds.ended_nodes(said, {'guard', 'sensor', 'law', 'monitor'}) == [
        'guard ended with code 1: boom', 'sensor: bad', 'law was ended by signal 9']


def test_plans_of_signals_are_of_every_kind_and_the_same_for_the_same_seed():
    paper = load(catalogue.find('scenarios', 'paper', ('.yaml',)))
    plans = [kills.planned(paper, seed) for seed in range(200)]
    assert plans == [kills.planned(paper, seed) for seed in range(200)]
    assert {p.processes for p in plans} == {'blocks', 'segments', 'one'}
    assert {p.number.name for p in plans} == set(kills.SIGNALS)
    assert {p.victim for p in plans} >= {'bringup', 'bag_recorder', 'mission_monitor', 'watch',
                                         'one', 'ground', 'onboard_guard'}


def test_a_bag_that_cannot_be_read_is_said(tmp_path):
    assert kills._of_the_bag(tmp_path, False) == '' != kills._of_the_bag(tmp_path, True)
    (tmp_path / 'bag').mkdir()
    (tmp_path / 'bag' / 'bag_0.mcap').write_bytes(b'')
    assert kills._of_the_bag(tmp_path, False) == ''     # nothing had been said yet
    (tmp_path / 'bag' / 'bag_0.mcap').write_bytes(b'nonsense' * 10_000)
    assert 'bag: ' in kills._of_the_bag(tmp_path, True)


@pytest.mark.slow
@pytest.mark.patient
def test_signals_name_their_victim_leave_nothing_and_a_bag(tmp_path):
    for seed in (7, 10):                        # SIGKILL to a group of two, to the one of all
        held('kills', 1, seed=seed, keep=tmp_path)
    assert held('flights', 1, keep=tmp_path)['ended by themselves'] == 1


@pytest.mark.slow
@pytest.mark.patient
def test_a_stranger_over_dds_ends_no_node(tmp_path):
    held('dds', 100, keep=tmp_path)


def test_a_command_that_the_ground_never_sent_is_told_as_far_as_the_bag_goes():
    """The ground says 1 to 40; each is at the thrusters 10 steps later."""
    steps = np.arange(40)
    ground = SimpleNamespace(step=steps, sequence=steps + 1, levels=np.c_[steps % 3, steps, steps])
    thrust = SimpleNamespace(step=steps + 10, sequence=steps + 1, levels=ground.levels.copy(),
                             valid=np.ones(40, bool))
    assert dds.unsent(ground, thrust, 10) == []
    cut = SimpleNamespace(**{name: column[:25] for name, column in vars(ground).items()})
    assert dds.unsent(cut, thrust, 10) == []            # 26 and later may have been sent
    thrust.sequence[24], thrust.levels[20] = 2**62, (2, 1, 0)
    assert len(dds.unsent(cut, thrust, 10)) == 2


@pytest.mark.slow
@pytest.mark.patient
def test_no_mutated_message_ends_a_node_and_one_that_does_is_told(tmp_path, monkeypatch):
    from rvd_campaign.bench.attack import messages
    monkeypatch.setattr(messages, 'EACH', 25)
    for seed in (0, 1):                         # lock step, real time
        outcome = messages.one(seed)
        assert outcome.failures == [] and outcome.counts['delivered'] > 150, outcome
    from rvd_dynamics.diagram.ros.firing import FiringNode

    def careless(self, name, step, item):
        raise BadInput(f'step {step} is too much')
    monkeypatch.setattr(FiringNode, '_came', careless)
    assert 'too much' in messages.one(0).failures[0]    # the twin: the child inherits it


@pytest.mark.slow
@pytest.mark.patient
@pytest.mark.parametrize('told', [True, False])
def test_a_forged_end_ends_no_process_of_a_paused_run_and_the_true_one_all(
        told, tmp_path, monkeypatch):
    """The second is the twin: where nobody looks at what the plant has noted, it ends them."""
    from std_msgs.msg import Bool, UInt64

    from rvd_campaign.bench.attack.messages import Rig
    from rvd_dynamics.diagram.ros.host import Host
    monkeypatch.setenv('RVD_PULSE', '')
    monkeypatch.setenv('RVD_LEAN', '1')
    monkeypatch.setenv('ROS_AUTOMATIC_DISCOVERY_RANGE', 'OFF')
    if not told:
        monkeypatch.setattr(Host, 'noted_end', None)
    scenario = load(catalogue.find('scenarios', 'paper', ('.yaml',))).with_values(
        '/**', timeout_s=20.0)
    with reserved_domain() as domain:
        monkeypatch.setenv('ROS_DOMAIN_ID', str(int(domain)))
        rig = Rig(scenario, tmp_path / 'rig')
        try:
            nodes, limit = rig.nodes, time.monotonic() + 300.0
            plant = nodes['spacecraft_dynamics']

            def turn_until(done):
                while not done():
                    rig.turn()
                    assert time.monotonic() < limit, {n: each.step for n, each in nodes.items()}

            def say(topic, message):
                for node in nodes.values():
                    heard = node.subscriptions_of.get(topic)
                    if heard is not None and not heard.raw:
                        heard.callback(message, {'publication_sequence_number': None,
                                                 'source_timestamp': 0})
            turn_until(lambda: plant.step >= 5)
            say('/run/pause', Bool(data=True))
            for _ in range(300):                # what is on its way arrives
                rig.turn()
            stood = plant.step
            say('/run/end', UInt64(data=stood))
            begun = time.monotonic()
            while time.monotonic() < begun + 0.5:
                rig.turn()
            if not told:
                assert sum(node.finished for node in nodes.values()) > 5 and rig.over
                return
            assert not rig.over and not any(node.finished for node in nodes.values())
            say('/run/pause', Bool(data=False))
            turn_until(lambda: all(host.ended for host in rig.hosts.values()))
            assert plant.step == 40 > stood and nodes['mission_monitor'].step == 40
        finally:
            rig.close()


@pytest.mark.slow
@pytest.mark.patient
def test_damaged_bags_are_shown_or_refused_in_a_line(tmp_path):
    held('bags', 3, keep=tmp_path)
