"""The review in a browser: a flown run found in the list, scrubbed, given away, and left."""

import csv
import json
import re
import shutil
import time

import pytest
from console_page import open_page, serious, until
from review_page import (
    COLOURS, looked_at, OVERLAPS, reviewed, saved, SCENARIO, SHOWN, VIDEO)
from runs import messages, rvd, verdict_of, wait_for
from toy_console import ToyConsole, WaitingConsole

pytestmark = [pytest.mark.slow, pytest.mark.patient]


@pytest.fixture(scope='module')
def runs(tmp_path_factory):
    """A folder of runs with a flown one, `flown`, and one without report and bag, `stopped`."""
    folder = tmp_path_factory.mktemp('review')
    (folder / 'reviewed.yaml').write_text(SCENARIO)
    done = rvd('fly', 'reviewed.yaml', '--seed', '3', '--headless', '--out', 'runs/flown',
               cwd=folder, timeout=300.0)
    assert done.returncode == 0, done.stdout + done.stderr
    stopped = folder / 'runs' / 'stopped'
    stopped.mkdir()
    verdict = verdict_of(folder / 'runs' / 'flown')
    (stopped / 'verdict.json').write_text(json.dumps(
        {**verdict, 'success': False, 'reason': 'interrupted', 'mode': 'manual', 'seed': 77,
         'flown': {**verdict['flown'], 'modes': {'manual': 0.004, 'auto': 0.966, 'abort': 0.03}}}))
    return folder / 'runs'


@pytest.fixture(scope='module')
def waiting(runs):
    """A console on which nothing has been flown yet."""
    made = WaitingConsole(runs)
    yield made
    made.close()


@pytest.fixture(scope='module')
def toy(runs):
    """A console on which another mission flies."""
    made = ToyConsole(runs)
    yield made
    made.close()


def shared_page(browser, waiting, look: str):
    """A review for several tests: read once, begun anew for each."""
    made = reviewed(browser, waiting, look=look)

    def anew():
        made.set_viewport_size({'width': 1280, 'height': 720})
        made.evaluate("rvd.review.on && rvd.review.leave(); rvd.review.start(); "
                      "rvd.review.setSpeed(4)")
        made.wait_for_timeout(400)
        return made
    yield anew
    made.close()


@pytest.fixture(scope='module')
def plain_page(browser, waiting):
    yield from shared_page(browser, waiting, 'plain')   # a scene takes a test machine its time


@pytest.fixture(scope='module')
def drawn_page(browser, waiting):
    yield from shared_page(browser, waiting, '')


@pytest.fixture
def page(plain_page):
    made = plain_page()
    yield made
    assert made.problems == []


@pytest.fixture
def drawn(drawn_page):
    made = drawn_page()
    yield made
    assert made.problems == []


def at(page) -> int:
    return page.evaluate('rvd.review.at')


# -- the list -----------------------------------------------------------------------------

def test_the_list_says_when_what_and_how_long_was_flown(browser, waiting, runs):
    page = open_page(browser, waiting, look='plain')
    page.keyboard.press('l')
    page.wait_for_selector('[data-run=flown]')
    row = page.locator('tr', has=page.locator('[data-run=flown]')).inner_text().split('\t')
    verdict = verdict_of(runs / 'flown')
    ended = time.strftime('%Y-%m-%d %H:%M', time.localtime(
        (runs / 'flown' / 'verdict.json').stat().st_mtime))
    assert [cell.strip() for cell in row[:8]] == [
        ended, 'flown', 'reviewed', 'Shared', 'model', '3', f'{verdict["duration_s"]:.1f} s',
        '✓ Docked']
    other = page.locator('tr', has=page.locator('[data-run=stopped]')).inner_text().split('\t')
    assert other[3].strip() == 'Manual < 1 % · Auto 97 %'  # began manual, and was not
    assert page.is_enabled('[data-report=flown]')
    assert page.is_disabled('[data-report=stopped]')            # there is none
    page.close()


def test_the_list_knows_the_run_under_way_and_what_ends_while_it_is_open(browser, runs):
    toy = ToyConsole(runs)
    try:
        page = open_page(browser, toy, look='plain')
        until(page, 'Boolean(rvd.store.frame)')
        page.keyboard.press('l')
        page.wait_for_selector('[data-run=flown]')
        assert re.search(r'cart\s+under way', page.inner_text('#runs-table'))
        toy._loop.call_soon_threadsafe(toy.hub.told, 'closing', '', 'cart')
        until(page, "/cart\\s+its bag is being closed/.test("
                    "document.getElementById('runs-table').innerText)")
        shutil.copytree(runs / 'stopped', runs / 'cart')
        toy._loop.call_soon_threadsafe(toy.hub.told, 'ended', '', 'cart')
        page.wait_for_selector('[data-run=cart]')
        shutil.copytree(runs / 'stopped', runs / 'elsewhere')   # by another command
        page.wait_for_selector('[data-run=elsewhere]')
        page.keyboard.press('Escape')
        until(page, "!document.getElementById('dialog').open")
        page.close()
    finally:
        toy.close()
        for name in ('cart', 'elsewhere'):
            shutil.rmtree(runs / name, ignore_errors=True)


def test_a_report_opens_in_a_tab_of_its_own_which_never_has_the_token(browser, waiting):
    page = open_page(browser, waiting, look='plain')
    page.keyboard.press('l')
    token = waiting.url.split('#')[1]
    with page.expect_popup() as opened:
        page.click('[data-report=flown]')
    tab = opened.value
    tab.wait_for_selector('h1')
    assert 'docked' in tab.inner_text('body').lower()
    assert len(tab.query_selector_all('svg')) > 2               # and its figures
    assert re.search(r'/report/[\w-]{22,}$', tab.url) and token not in tab.url
    assert tab.evaluate('getComputedStyle(document.querySelector("main")).maxWidth') != 'none'
    tab.close()
    assert page.problems == []
    page.close()


# -- what is shown ------------------------------------------------------------------------

def test_the_ladder_of_a_review_is_there_from_the_first_command_on(page, runs):
    sent = messages(runs / 'flown', '/ground/command')
    assert len(sent) > 900                      # more than a live page remembers
    assert page.evaluate('rvd.review.rungs.map((r) => r.sent)') == [m.step for m in sent]
    page.evaluate("rvd.review.go(rvd.review.run.frames.findIndex((f) => f.t >= 20))")
    page.wait_for_timeout(300)
    k = page.evaluate('rvd.review.frame().k')
    now = page.evaluate(f'rvd.review.ladderAt({k})')
    assert len(now) == k + 1
    assert all(rung['told'] <= k for rung in now)               # nothing of what came later
    assert now[0]['told'] >= 0 and now[-1]['told'] == -1
    words = page.inner_text('#ladder-counts')
    assert sum(map(int, re.findall(r'\d+', words))) + sum(
        rung['state'] == 1 for rung in now) == k + 1, words


def test_mode_and_limits_are_those_of_the_reviewed_run(page):
    assert page.get_attribute('[data-mode=shared]', 'aria-pressed') == 'true'
    assert page.is_disabled('[data-mode=manual]')
    assert '0…0.31' in page.inner_text('#instruments-rows')
    words = 'Review: flown · Shared at the start · 5 s + 5 s · seed 3'
    assert page.inner_text('#run-name') == words
    page.keyboard.press('Escape')
    until(page, '!rvd.review.on')
    assert '0…0.31' not in page.inner_text('#instruments-rows')


@pytest.mark.parametrize('where', ['waiting', 'toy'])
def test_nothing_of_a_review_is_left_when_it_is_left(browser, request, where):
    console = request.getfixturevalue(where)
    page = open_page(browser, console)
    page.set_viewport_size({'width': 1280, 'height': 720})
    if where == 'toy':                          # its numbers go on: compare those that stand
        until(page, 'rvd.store.frame?.t > 4')   # some commands are known
    page.wait_for_timeout(1000)

    def shown():
        seen = page.evaluate(SHOWN)
        if where == 'toy':
            seen['words'] = re.sub(r'[−+]?\d+(\.\d+)?', '0', seen['words'])
            seen['ink'] = [n > 0 for n in seen['ink']]
        return seen
    before = shown()
    page.keyboard.press('l')
    page.click('[data-run=flown]')
    until(page, 'rvd.review.on')
    page.wait_for_timeout(600)
    assert page.inner_text('#banner') == 'Docked'
    assert shown() != before
    page.keyboard.press('Escape')
    until(page, '!rvd.review.on')
    page.wait_for_timeout(600)
    assert shown() == before
    assert page.problems == []
    page.close()


# -- keys and speed -----------------------------------------------------------------------

def test_keys_scrub_the_review_and_no_craft(page):
    last = at(page)
    assert last == page.evaluate('rvd.review.run.frames.length - 1')
    page.keyboard.press('Home')
    assert at(page) == 0
    page.keyboard.press('ArrowRight')
    page.keyboard.press('ArrowRight')
    page.keyboard.press('ArrowLeft')
    assert at(page) == 1
    page.keyboard.down('ArrowUp')               # a key of this mission's hand controller
    assert page.evaluate('rvd.stick.down.size') == 0
    assert page.evaluate('rvd.review.speed') == 8
    page.keyboard.up('ArrowUp')
    page.keyboard.press('ArrowDown')
    page.keyboard.press('ArrowDown')
    assert page.evaluate('rvd.review.speed') == 2
    assert page.input_value('#review-speed') == '2'
    page.keyboard.press(' ')
    assert page.evaluate('rvd.review.playing') and page.inner_text('#review-play') == 'Stop'
    until(page, 'rvd.review.at > 3')
    page.keyboard.press(' ')
    assert not page.evaluate('rvd.review.playing')
    page.keyboard.press('End')
    assert at(page) == last
    page.keyboard.press('?')
    keys = page.inner_text('#dialog')
    assert 'In a review:' in keys and re.search(r'Space\s+play, stop', keys)
    page.keyboard.press('Escape')               # the list of keys, not the review
    assert page.evaluate('rvd.review.on')
    page.keyboard.press('Escape')
    assert not page.evaluate('rvd.review.on')


def test_space_on_a_button_presses_it_once(page):
    page.focus('#review-step-back')
    before = at(page)
    page.keyboard.press(' ')
    assert at(page) == before - 1 and not page.evaluate('rvd.review.playing')


def test_keys_of_the_flight_change_nothing_of_it_from_a_review(browser, toy):
    page = open_page(browser, toy, look='plain')
    until(page, 'Boolean(rvd.store.frame)')
    page.keyboard.press('t')
    until(page, "rvd.store.status.lease === 'you'")
    page.keyboard.press('p')
    until(page, 'rvd.store.frame.paused')
    page.keyboard.press('p')
    until(page, '!rvd.store.frame.paused')
    asked = list(toy.asked)
    page.keyboard.press('l')
    page.click('[data-run=flown]')
    until(page, 'rvd.review.on')
    for key in 'pmt':
        page.keyboard.press(key)
    page.keyboard.press('Escape')
    page.wait_for_timeout(300)
    assert toy.asked == asked
    assert page.evaluate('rvd.store.status.lease') == 'you'
    page.keyboard.press('t')
    until(page, "rvd.store.status.lease === 'free'")
    page.close()


def test_in_a_review_abort_is_abort_and_who_starts_a_run_leaves_it(browser, runs):
    toy = ToyConsole(runs)
    try:
        page, other = (reviewed(browser, toy, look='plain') for _ in range(2))
        page.keyboard.press('x')
        page.keyboard.press('x')
        until(page, "rvd.review.on")
        wait_for(lambda: toy.asked == ['abort'], 'the abort')
        page.evaluate("(() => { rvd.link.ask({ do: 'take' }); })()")
        until(page, "rvd.store.status.lease === 'you'")
        toy._loop.call_soon_threadsafe(toy.hub.told, 'starting', '', 'next')
        until(page, '!rvd.review.on')
        until(other, "rvd.store.status.phase === 'starting'")
        assert other.evaluate('rvd.review.on')  # who watches reads on
        for one in (page, other):
            assert one.problems == []
            one.close()
    finally:
        toy.close()


@pytest.mark.parametrize('speed', ['0.25', '4', '16'])
def test_a_second_played_is_as_long_as_the_speed_says(page, speed):
    page.select_option('#review-speed', speed)
    gone = page.evaluate("""(() => {
      const { review } = rvd;
      review.go(0);
      review.play(true);
      review.playTo(4000); // as if four seconds had gone by
      review.play(false);
      return review.frame().t;
    })()""")
    assert gone == pytest.approx(4.0 * float(speed), abs=0.31)  # three steps to a picture


def test_one_can_jump_from_event_to_event(page):
    page.evaluate("""(() => { // this flight was a quiet one
      rvd.review.run.events = [
        { t: 12, node: 'a', code: 'X', text: 'the first <b>of them</b>' },
        { t: 12.04, node: 'a', code: 'X', text: 'soon after' },
        { t: 50, node: 'b', code: 'Y', text: 'the last' }];
      rvd.review.marks();
    })()""")
    page.keyboard.press('Home')
    page.keyboard.press('Shift+ArrowRight')
    assert page.inner_text('#review-now').startswith('12.0 s · the first <b>of them</b>')
    page.click('#review-event-on')
    page.click('#review-event-on')
    assert '50.1 s · the last' == page.inner_text('#review-now')
    page.click('#review-event-on')              # there is none
    assert '50.1 s · the last' == page.inner_text('#review-now')
    page.keyboard.press('Shift+ArrowLeft')
    assert 'soon after' in page.inner_text('#review-now')
    assert page.inner_text('#review-events option:first-child') == 'Events (3)'
    page.select_option('#review-events', '2')
    assert '50.1 s · the last' == page.inner_text('#review-now')
    marks, thumb = page.evaluate("""(() => {
      const track = document.getElementById('review-time').getBoundingClientRect();
      const share = rvd.review.at / (rvd.review.run.frames.length - 1);
      const middle = ({ left, width }) => left + width / 2;
      return [[...document.querySelectorAll('#review-marks i')]
        .map((mark) => middle(mark.getBoundingClientRect())),
      track.left + 8 + share * (track.width - 16)];
    })()""")
    assert marks[-1] == pytest.approx(thumb, abs=1.0)           # over the thumb


# -- what it gives away -------------------------------------------------------------------


def test_a_figure_is_a_png_of_what_is_shown(drawn, browser):
    page = drawn
    page.evaluate("rvd.review.go(rvd.review.run.frames.findIndex((f) => f.t >= 60))")
    page.wait_for_timeout(400)
    done = saved(page, '#review-png')
    assert done.suggested_filename == 'flown-60.0s.png'
    seen = looked_at(browser, COLOURS, 'image/png', done.path().read_bytes())
    assert seen['width'] > 1500 and seen['height'] > 900        # finer than the screen
    assert all(n > 150 for n in seen.values()), seen            # words and marks of each role
    assert page.evaluate('rvd.scene.quality') <= 1              # the page goes on as it was


def test_the_numbers_are_a_table_of_all_instants(page, runs):
    done = saved(page, '#review-csv')
    assert done.suggested_filename == 'flown.csv'
    rows = list(csv.reader(done.path().read_text().splitlines()))
    head, body = rows[0], rows[1:]
    assert len(body) == page.evaluate('rvd.review.run.frames.length')
    assert {len(row) for row in rows} == {len(head)} and len(set(head)) == len(head)
    column = {name: [row[i] for row in body] for i, name in enumerate(head)}
    truth = {m.step: m for m in messages(runs / 'flown', '/truth/relative_state')}
    for k, x in list(zip(column['step'], column['truth position 0']))[::50]:
        assert float(x) == pytest.approx(truth[int(k)].position.x, abs=2e-6)
    sent = {m.step: m for m in messages(runs / 'flown', '/ground/command')}
    for k, level in list(zip(column['step'], column['sent y']))[::50]:
        assert int(level) == sent[int(k)].levels[1]
    assert set(column['mode']) == {'shared'}
    assert column['range measured [m]'][0] == ''                # nothing had come down
    assert float(column['range measured [m]'][-1]) > 0.0


def test_a_video_of_a_review_can_be_played(drawn, browser):
    page = drawn
    page.select_option('#review-speed', '16')
    page.evaluate('rvd.review.go(0)')
    with page.expect_download(timeout=120_000) as download:     # comes when it is at its end
        page.click('#review-webm')
        assert page.evaluate('rvd.review.playing')
        assert page.inner_text('#review-webm') == 'Stop the video'
    assert page.evaluate('rvd.review.at === rvd.review.run.frames.length - 1')
    assert download.value.suggested_filename == 'flown.webm'
    webm = download.value.path().read_bytes()
    assert webm[:4] == b'\x1aE\xdf\xa3'         # EBML
    seen = looked_at(browser, VIDEO, 'video/webm', webm)
    assert seen['width'] == 1280 and seen['height'] > 400
    assert seen['length'] > 7.0                 # 120 s at 16 times the speed, or slower
    assert seen['bright'] > 1000 and seen['changed'] > 1000, seen
    until(page, "document.getElementById('review-webm').textContent === 'WebM'")


# An encoder that is 1 s behind, and drops what it has when it is stopped, as Chromium's does.
BEHIND = """(() => {
  window.ToldAtOnce = window.MediaRecorder;
  window.handed = { over: 0, dropped: 0 };
  window.MediaRecorder = class extends ToldAtOnce {
    set ondataavailable(taken) {
      super.ondataavailable = (event) => setTimeout(() => {
        const late = this.state === 'inactive';
        handed[late ? 'dropped' : 'over'] += event.data.size > 1000;
        if (!late) taken(event);
      }, 1000);
    }
  };
})()"""


def test_a_video_has_its_end_on_a_busy_machine(drawn):
    """Pictures were left out that the encoder still had: up to 4 s on a machine with other work."""
    page = drawn
    page.evaluate('rvd.review.go(rvd.review.run.frames.length - 200)')      # 20 s before the end
    page.select_option('#review-speed', '8')
    page.evaluate(BEHIND)
    try:
        with page.expect_download(timeout=120_000):
            page.click('#review-webm')
        page.wait_for_timeout(1200)             # what it had when it was stopped
        handed = page.evaluate('handed')
    finally:
        page.evaluate('() => { window.MediaRecorder = window.ToldAtOnce; }')
    assert handed['over'] > 5 and handed['dropped'] <= 1        # what it hands over as it stops


def test_a_video_ends_with_the_review(page):
    page.evaluate('rvd.review.go(0)')
    with page.expect_download() as download:
        page.click('#review-webm')
        page.keyboard.press('Escape')
    assert len(download.value.path().read_bytes()) > 1000       # a picture, not a head alone
    assert not page.evaluate('rvd.review.on')


# -- how it looks -------------------------------------------------------------------------

@pytest.mark.parametrize('width, height', [
    (1280, 720), (1024, 640), (640, 360), (820, 1180), (390, 844)])
def test_the_bar_fits_into_every_window(page, width, height):
    page.set_viewport_size({'width': width, 'height': height})
    page.wait_for_timeout(300)
    assert page.evaluate(OVERLAPS) == []


def test_axe_finds_nothing_serious_in_list_and_review(browser, waiting, console_web):
    page = open_page(browser, waiting, look='plain', bypass_csp=True)
    page.keyboard.press('l')
    page.wait_for_selector('[data-run=flown]')
    assert serious(page, console_web) == []
    page.click('[data-run=flown]')
    until(page, 'rvd.review.on')
    assert serious(page, console_web) == []
    page.close()
