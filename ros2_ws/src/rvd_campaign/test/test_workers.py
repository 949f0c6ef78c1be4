"""Workers of a campaign that are killed or stopped: said, or flown by another, with one hash."""

import io
import os
import re
import signal
import subprocess
import sys
import threading
import time

import pytest

from rvd_campaign.campaign import engine, standstill
from rvd_campaign.campaign.engine import fly_campaign, how_it_ended, PARTS, start, Workers
from rvd_campaign.campaign.progress import Progress
from rvd_campaign.campaign.spec import CampaignError, parse_campaign
from rvd_campaign.campaign.standstill import Standstill, workers
from rvd_campaign.campaign.summary import finish

TEXT = '''
seed: 8
runs: 40
set: {pilot: A}
conditions: {manual: {/**: {mode: manual}}, shared: {}}
'''
WORKER = 'import time; time.sleep(600)'


def waited(condition, seconds=60.0):
    """Wait until a condition holds; fail if it does not come to."""
    begun = time.monotonic()
    while not condition():
        assert time.monotonic() - begun < seconds
        time.sleep(0.02)


@pytest.fixture
def worker():
    """A process that looks like a worker of this one."""
    made = subprocess.Popen([sys.executable, '-c', WORKER, 'popen_loky'])
    waited(lambda: made.pid in workers())
    yield made
    made.kill()
    made.wait()


@pytest.fixture
def quick(monkeypatch):
    """Wait less than a user does."""
    monkeypatch.setattr(standstill, 'STOPPED_S', 0.6)
    monkeypatch.setattr(standstill, 'LOOK_S', 0.05)


def test_a_worker_that_stands_still_is_ended(worker, quick):
    worker.send_signal(signal.SIGSTOP)
    with Standstill() as watched:
        waited(lambda: worker.poll() is not None)
    assert watched.ended == [worker.pid]


def test_one_that_works_or_goes_on_in_time_is_let_be(worker, quick, monkeypatch):
    """The negative twin."""
    monkeypatch.setattr(standstill, 'STOPPED_S', 30.0)
    with Standstill() as watched:
        for _ in range(4):
            worker.send_signal(signal.SIGSTOP)
            time.sleep(0.1)
            worker.send_signal(signal.SIGCONT)
            waited(lambda: workers()[worker.pid] not in standstill.STOPPED)
            time.sleep(0.15)                # a look in between
    assert watched.ended == [] and worker.poll() is None


def test_time_in_which_this_process_was_stopped_does_not_count(worker, quick, monkeypatch):
    worker.send_signal(signal.SIGSTOP)
    monkeypatch.setattr(standstill, 'GAP_S', 0.0)       # as after each look
    with Standstill() as watched:
        time.sleep(1.5)
    assert watched.ended == [] and worker.poll() is None


def test_other_children_are_nobodys_business(quick):
    other = subprocess.Popen([sys.executable, '-c', WORKER])
    other.send_signal(signal.SIGSTOP)
    with Standstill() as watched:
        time.sleep(1.0)
    assert watched.ended == [] and other.poll() is None
    other.kill()
    other.wait()


def test_how_a_worker_ended_is_said_in_words():
    said = how_it_ended(engine.BrokenExecutor('The exit codes of the workers are {SIGKILL(-9)}'))
    assert said == 'was ended by SIGKILL (by somebody or for want of memory)'
    assert how_it_ended(engine.BrokenExecutor('broken')) == 'has ended'


def flown(folder, campaign, hit, said):
    """Fly a campaign on two workers; give one of them a signal when it has begun."""
    folder.mkdir()
    start(campaign, folder)

    def disturb():
        waited(lambda: len(list((folder / PARTS).iterdir())) > 2 and len(workers()) == 2)
        os.kill(min(workers()), hit)
    threading.Thread(target=disturb, daemon=True).start()
    fly_campaign(campaign, folder, Workers(2, batch=2), Progress(said))


@pytest.mark.slow
@pytest.mark.patient
def test_killed_or_stopped_workers_change_no_result(tmp_path, quick):
    campaign, said = parse_campaign(TEXT, 'small'), io.StringIO()
    folder = tmp_path / 'a folder'
    with pytest.raises(CampaignError) as killed:
        flown(folder, campaign, signal.SIGKILL, said)
    assert re.fullmatch(
        r'a worker was ended by SIGKILL \(by somebody or for want of memory\); finished runs are '
        rf"kept: go on with ./rvd campaign --resume '{folder}'", str(killed.value))
    kept = len(list((folder / PARTS).iterdir()))
    assert 2 < kept < 40
    fly_campaign(campaign, folder, Workers(), Progress(said))       # as --resume does
    flown(tmp_path / 'stopped', campaign, signal.SIGSTOP, said)
    assert re.search(r'worker \d+ was stopped for .* s: its runs are flown by another',
                     said.getvalue())
    (tmp_path / 'calm').mkdir()
    start(campaign, tmp_path / 'calm')
    fly_campaign(campaign, tmp_path / 'calm', Workers(), Progress(said))
    assert len({finish(campaign, tmp_path / name)['result_hash']
                for name in ('a folder', 'stopped', 'calm')}) == 1
