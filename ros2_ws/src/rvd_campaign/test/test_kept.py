"""What a bag holds, held against the steps that were flown; and what the verdict says of it."""

from types import SimpleNamespace

import pytest
from small_run import LAST, messages, ROSTER, SCENARIO, write_run

from rvd_campaign.flight import verdict
from rvd_campaign.flight.kept import kept, Kept
from rvd_campaign.report.run import page
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.link.channel import LINK_COUNTS
from rvd_dynamics.recording.bag_writer import BagWriter
from rvd_dynamics.recording import mcap_records
from rvd_dynamics.recording.reader import read

TRUTH = ROSTER.diagram.truth.name
GONE = 65                       # the step from which on the recorder heard nothing


def held(run, last=LAST):
    return kept(run, ROSTER.owed, TRUTH, last)


@pytest.fixture(scope='module')
def cut(tmp_path_factory):
    """Return a run that went on to its end while its recorder was stopped; closed, and not."""
    heard = [item for item in messages() if item[1] < GONE]
    top = tmp_path_factory.mktemp('runs')
    return (write_run(top / 'closed', heard, notes={'rvd_missing': dict.fromkeys(
                ROSTER.owed, str(LAST + 1 - GONE))}),
            write_run(top / 'killed', heard, close=False))


def test_a_whole_run_is_complete(tmp_path):
    for close in (True, False):
        found = held(write_run(tmp_path / f'{close}', close=close))
        assert found.complete and found == Kept(LAST + 1, LAST + 1, {})
        assert found.as_dict() == {'complete': True, 'steps_flown': LAST + 1,
                                   'steps_stored': LAST + 1, 'missing': {}}


def test_what_the_recorder_never_heard_is_counted_from_the_end_of_the_run(cut):
    for run in cut:
        found = held(run)
        assert not found.complete and (found.flown, found.stored) == (LAST + 1, GONE)
        assert found.missing == dict.fromkeys(ROSTER.owed, LAST + 1 - GONE)
        assert f'it holds {GONE} of {LAST + 1} steps' in found.in_words()
        assert f'{(LAST + 1 - GONE)*len(ROSTER.owed)} messages of {len(ROSTER.owed)} topics' in \
            found.in_words()
        assert held(run, GONE - 1).complete     # all of a run that was no longer


def test_what_the_disk_did_not_take_is_not_what_the_recorder_missed(tmp_path):
    run = write_run(tmp_path / 'run', [item for item in messages() if item[0] != '/joy'])
    assert held(run).missing == {'/joy': LAST + 1}
    bag = BagWriter(tmp_path / 'full' / 'bag')
    bag.lost.update(dict.fromkeys(ROSTER.owed, LAST + 1))
    bag.close()
    assert held(tmp_path / 'full').complete


def test_a_disk_without_room_for_a_note_is_known_by_what_the_recorder_says_it_gave_up(tmp_path):
    """But not what the recorder missed besides."""
    (tmp_path / 'bag').mkdir()
    (tmp_path / 'bag' / 'bag_0.mcap').write_bytes(mcap_records.MAGIC)
    owed = (LAST + 1)*len(ROSTER.owed)
    for given_up, complete in ((0, False), (owed - 1, False), (owed, True)):
        found = kept(tmp_path, ROSTER.owed, TRUTH, LAST, given_up)
        assert (found.stored, found.complete) == (0, complete)


def test_without_a_bag_all_is_missing(tmp_path):
    assert held(tmp_path).missing == dict.fromkeys(ROSTER.owed, LAST + 1)


def test_counts_of_a_link_that_are_not_of_the_end_are_unknown(cut):
    status = SimpleNamespace(step=GONE - 1, **dict.fromkeys(LINK_COUNTS, 5), delay_p50=4.0,
                             delay_p99=4.0, delay_max=4.0)
    scenario, judged = parse(SCENARIO, 'small'), verdict.outcome(None)
    made = verdict.as_dict(judged, {'forward': status, 'back': None}, scenario, held(cut[0]))
    assert set(made['link']['forward'].values()) == set(made['link']['back'].values()) == {None}
    assert made['recording']['steps_stored'] == GONE
    last = SimpleNamespace(**{**vars(status), 'step': LAST})
    made = verdict.as_dict(judged, {'forward': last}, scenario, held(cut[0]))
    assert made['link']['forward']['sent'] == 5
    made = verdict.as_dict(judged, {'forward': status}, scenario, None)     # interrupted
    assert made['link']['forward']['sent'] == 5 and 'recording' not in made


def test_report_and_reader_count_by_what_the_recorder_knew(tmp_path):
    """A recorder that was stopped has not heard the end; the plant has noted it for it."""
    heard = [item for item in messages() if item[1] < GONE]
    noted = tmp_path / 'noted'
    closing = BagWriter.close
    try:
        BagWriter.close = lambda self, notes=None: closing(self, notes, last_step=str(LAST))
        write_run(noted, heard)
    finally:
        BagWriter.close = closing
    run = read(noted)
    assert run.last_step == GONE - 1 and not run.ended
    assert run.missing[TRUTH] == LAST + 1 - GONE
    assert 'Steps missing from the bag' in page(run)
    assert read(write_run(tmp_path / 'blind', heard)).missing[TRUTH] == 0   # without that note
