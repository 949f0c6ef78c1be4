"""What the reader of finished runs hands to a review: all of a run, to its last step."""

import json

import pytest
import small_run

from rvd_campaign.report import replay
from rvd_groundstation.console import ladder

STEPS = small_run.LAST + 1


@pytest.fixture(scope='module')
def run(tmp_path_factory):
    """A small run with a verdict."""
    folder = tmp_path_factory.mktemp('replay') / 'run'
    small_run.write_run(folder)
    (folder / 'verdict.json').write_text('{}')
    return folder


def shown(run):
    return json.loads(replay.load(run.parent, run.name))


def test_the_ladder_of_a_review_is_that_of_the_whole_run(run, monkeypatch):
    keep = ladder.Ladder.__init__.__defaults__
    monkeypatch.setattr(ladder.Ladder.__init__, '__defaults__',
                        tuple(30 if value == 600 else value for value in keep))
    rungs = shown(run)['ladder']
    assert [row[1] for row in rungs] == list(range(STEPS))      # a command in each step
    assert rungs[5][2] == 5 + small_run.HOLD


@pytest.mark.parametrize('most, every', [(900, 1), (60, 7), (7, 58)])
def test_the_last_picture_is_that_of_the_last_step(run, monkeypatch, most, every):
    monkeypatch.setattr(replay, 'MOST_FRAMES', most)
    frames = shown(run)['frames']
    assert frames[1]['k'] == every
    assert frames[-1]['k'] == small_run.LAST
    assert frames[-1]['signals']['/ground/prediction']['t'] == frames[-1]['t']  # and not beyond
    last = frames[-1]['signals']['truth']['parts']
    assert last['position'] == pytest.approx(small_run.true_state(small_run.LAST)[:3], abs=1e-5)
