"""
A counted flight is what its condition says: whoever breaks into it breaks it, and is told so.

One session in a real browser with the real graph: keys that would change the condition do nothing,
an aborted flight does not count and is flown again, and every file and report says the same.
"""

import csv
import json

import pytest
from console_page import Console, open_page, take_and_start, until
from runs import messages, rvd, verdict_of, wait_for

pytestmark = [pytest.mark.slow, pytest.mark.patient]
SESSION = """
title: A session of one flight
seed: 3
conditions: {manual: {mode: manual}}
training: 0
flights: 1
break_after: 0
"""
# Keeps what the line of events has said: others come, too, on a machine that has more to do.
TELLS_ALL = """(() => {
  const line = document.getElementById('event');
  window.told = [];
  new MutationObserver(() => told.push(line.textContent)).observe(
    line, { childList: true, characterData: true, subtree: true });
})()"""
NOT_PAUSED = 'A flight of a session is not paused.'
HEADING = "document.querySelector('#dialog h3').textContent"


def start_flight(page):
    page.wait_for_selector('#desk-go:not([disabled])')
    page.click('#desk-go')
    until(page, "rvd.store.status.phase === 'flying' && Boolean(rvd.store.frame)")


def rate(page):
    page.click('[data-answer=no]')
    page.click('[data-rating="10"]')
    for scale in page.query_selector_all('[data-tlx]'):
        scale.focus()
        page.keyboard.press('ArrowRight')
    page.click('#desk-go')


@pytest.fixture(scope='module')
def session(browser, tmp_path_factory):
    """What was seen of the session, and its folder."""
    folder, seen = tmp_path_factory.mktemp('session'), {}
    (folder / 'session.yaml').write_text(SESSION)
    console = Console(folder, 'barrier', '--pace', '10', '--session', 'session.yaml',
                      '--out', 'people')
    try:
        page = open_page(browser, console, look='plain')
        until(page, "document.querySelector('#run-name').textContent !== ''")
        seen['first'] = page.inner_text('#run-name')
        page.keyboard.press('t')
        page.fill('#volunteer', '1')
        page.keyboard.press('Enter')
        page.wait_for_selector('#desk-go')
        page.keyboard.press('Escape')
        seen['closed'] = not page.evaluate("document.querySelector('#dialog').open")
        page.keyboard.press('?')
        seen['help'] = page.evaluate(HEADING)
        page.keyboard.press('Escape')
        until(page, f"{HEADING}.includes('P01')")       # the session's page is back
        page.keyboard.press('Escape')
        page.keyboard.press('n')
        seen['n'] = page.evaluate(HEADING)
        start_flight(page)
        until(page, 'rvd.store.frame.t > 6')
        seen['buttons'] = page.evaluate("[...document.querySelectorAll('#modes button, #pause')]"
                                        '.map((b) => b.disabled)')
        page.evaluate(TELLS_ALL)
        for key in ('m', 'm', 'p'):
            page.keyboard.press(key)
            page.wait_for_timeout(300)
        until(page, f'told.includes({NOT_PAUSED!r})')
        page.keyboard.press('n')
        seen['mode'] = page.evaluate('[rvd.store.frame.mode, rvd.store.frame.paused]')
        seen['no button'] = page.is_hidden('#end-run')
        page.keyboard.press('x')
        page.keyboard.press('x')
        until(page, "document.querySelector('#banner').textContent.startsWith('ABORTED')")
        seen['ladder'] = page.inner_text('#ladder-counts')
        page.click('#end-run')
        page.wait_for_selector('#desk-why')
        seen['why'] = page.inner_text('#desk-why')
        page.wait_for_selector('#desk-go:not([disabled])')
        until(page, "document.querySelector('#banner').textContent"
                    " === 'Aborted, and ended from the console'")
        page.click('#desk-go')
        until(page, "document.querySelector('#dialog').textContent.includes('This flight counts')")
        start_flight(page)
        page.wait_for_selector('[data-answer=no]', timeout=120_000)
        rate(page)
        until(page, "document.querySelector('#dialog').textContent.includes('Thank you')")
        assert page.problems == []
        page.close()
    finally:
        console.close()
    return seen, folder


def test_the_session_shows_from_the_first_page_and_its_dialogs_close(session):
    seen, _ = session
    assert seen['first'] == 'Session: A session of one flight'
    assert seen['closed'] and seen['help'] == 'Keys' and 'P01, flight 1 of 1' in seen['n']


def test_mode_and_pause_are_the_session_s_and_the_page_says_so(session):
    seen, _ = session
    assert all(seen['buttons'])
    assert seen['mode'] == ['manual', False]


def test_an_aborted_flight_says_so_everywhere_and_can_be_ended(session):
    seen, folder = session
    assert seen['no button'] and 'ABORTED' in seen['ladder']
    assert seen['why'] == 'This flight does not count: ABORT was pressed.'
    run = folder / 'people' / 'P01' / '01-manual'
    told = verdict_of(run)
    assert (told['success'], told['reason']) == (False, 'aborted')
    assert told['ended_by'] == 'ended from the console'
    sent = messages(run, '/ground/command')             # the bag is whole up to there
    aborted = sum(m.kind == 3 for m in sent)
    assert told['flown']['steps'] == len(sent) and aborted > 0
    assert told['flown']['modes'] == {'manual': pytest.approx(1 - aborted / len(sent)),
                                      'abort': pytest.approx(aborted / len(sent))}
    report = (run / 'report.html').read_text()
    assert 'No verdict: aborted, and ended from the console after' in report


def test_it_does_not_count_and_is_flown_again(session):
    _, folder = session
    first, again = (json.loads((folder / 'people' / 'P01' / name / 'ratings.json').read_text())
                    for name in ('01-manual', '01-manual.2'))
    assert (first['counted'], first['why']) == (False, 'ABORT was pressed')
    assert again['counted'] and again['seed'] == first['seed']
    assert verdict_of(folder / 'people' / 'P01' / '01-manual.2')['flown']['modes'] == {
        'manual': 1.0}
    done = rvd('report', 'people', cwd=folder)
    assert done.returncode == 0, done.stderr
    page = ' '.join((folder / 'people' / 'report.html').read_text().split())
    assert '1 volunteer, 1 rated flight including' in page and '1 not counted' in page
    assert 'ABORT was pressed' in page
    with (folder / 'people' / 'flights.csv').open() as file:
        rows = [(r['counted'], r['why'], r['cooper_harper']) for r in csv.DictReader(file)]
    assert rows == [('True', '', '10'), ('False', 'ABORT was pressed', '')]


def test_a_flight_that_is_ended_from_the_page_leaves_a_whole_folder(browser, tmp_path):
    console = Console(tmp_path, 'barrier', '--pace', '10')
    try:
        page = open_page(browser, console, look='plain')
        take_and_start(page, 'manual')
        until(page, 'rvd.store.frame.t > 6')
        page.keyboard.press('m')                        # no session: the mode is the pilot's
        until(page, "rvd.store.frame.mode === 'shared'")
        until(page, 'rvd.store.frame.t > 12')
        page.keyboard.press('n')
        page.click('#new-stop')
        until(page, "rvd.store.status.phase === 'ended'")
        until(page, "document.querySelector('#banner').textContent === 'Ended from the console'")
        run = tmp_path / 'runs' / page.evaluate('rvd.store.status.run')
        assert page.problems == []
        page.close()
        wait_for(lambda: (run / 'report.html').exists(), 'the report')
    finally:
        console.close()
    told = verdict_of(run)
    assert (told['reason'], told['ended_by']) == ('interrupted', 'ended from the console')
    shares = told['flown']['modes']
    assert set(shares) == {'manual', 'shared'} and sum(shares.values()) == pytest.approx(1.0)
    assert told['mode'] == 'manual'                     # as it was asked for
    report = (run / 'report.html').read_text()
    assert 'No verdict: ended from the console after' in report
    assert 'The bag was cut off' not in report
