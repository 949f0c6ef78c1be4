"""The page without WebGL, without storage, without an answer: it goes on and says so."""

import json
import re

import pytest
from console_page import chromium, FLAGS, open_page, until
from toy_console import ToyConsole, VERDICT, WaitingConsole

pytestmark = pytest.mark.slow
NO_WEBGL = ['--no-sandbox', '--disable-gpu', '--disable-webgl', '--disable-3d-apis']
FULL = ('Storage.prototype.setItem = '
        "() => { throw new DOMException('full', 'QuotaExceededError'); }")
LOSE = """(() => { document.querySelector('#gl').getContext('webgl2')
    .getExtension('WEBGL_lose_context').loseContext(); })()"""


@pytest.fixture()
def toy():
    made = ToyConsole()
    yield made
    made.close()


def banner(words):
    return f"document.querySelector('#banner').textContent.includes('{words}')"


def fly_a_little(page, toy):
    """Take the stick, push and see that it moves, and end with the verdict."""
    until(page, 'Boolean(rvd.store.measured)')
    page.keyboard.press('t')
    until(page, "rvd.store.status.lease === 'you'")
    page.keyboard.down('d')
    page.wait_for_timeout(300)
    page.keyboard.up('d')
    assert ([0.5], True) in toy.sticks
    before = page.evaluate('rvd.store.measured.parts.x')
    until(page, f'rvd.store.measured.parts.x !== {before}')
    assert page.evaluate("rvd.scene.covers('cart')") > 20
    assert page.evaluate("rvd.scene.covers('rail')") > 10


def finish(page, toy):
    toy.finish()
    until(page, "document.querySelector('#verdict-words') !== null")


# -- no WebGL -------------------------------------------------------------------------------

def test_without_webgl_the_page_flies_by_lines_and_says_so_once(play, toy):
    browser = play.chromium.launch(executable_path=chromium(), args=NO_WEBGL)
    waiting = WaitingConsole()
    try:
        page = open_page(browser, toy)
        fly_a_little(page, toy)
        assert 'No WebGL' in page.inner_text('#notes')
        assert page.inner_text('body').count('No WebGL') == 1
        finish(page, toy)
        assert page.problems == []
        page.close()
        page = open_page(browser, waiting)      # flat views, a camera, surfaces: the lunar approach
        for view in ('Orbit', 'Side', 'Top'):
            page.evaluate('(name) => document.querySelector(`[data-view=${name}]`).click()',
                          view.lower())
            page.wait_for_timeout(300)
            for part in ('corridor', 'station'):
                assert page.evaluate(f"rvd.scene.covers('{part}')") > 20, (view, part)
        assert page.problems == []
    finally:
        waiting.close()
        browser.close()


def test_webgl_that_is_lost_in_flight_leaves_the_lines(browser, toy):
    page = open_page(browser, toy)
    until(page, 'Boolean(rvd.store.measured)')
    page.wait_for_timeout(300)
    assert page.evaluate('rvd.scene.webgl') and page.inner_text('#notes') == ''
    page.evaluate(LOSE)
    until(page, '!rvd.scene.webgl')
    fly_a_little(page, toy)
    assert 'No WebGL' in page.inner_text('#notes')
    finish(page, toy)
    assert page.problems == []
    page.close()


# -- no storage -----------------------------------------------------------------------------

def test_with_storage_blocked_by_the_browser_the_page_works_and_says_so(play, toy, tmp_path):
    (tmp_path / 'Default').mkdir()
    (tmp_path / 'Default/Preferences').write_text(json.dumps(
        {'profile': {'default_content_setting_values': {'cookies': 2}}}))
    context = play.chromium.launch_persistent_context(
        str(tmp_path), executable_path=chromium(), args=FLAGS)
    try:
        page = open_page(context, toy)
        assert page.evaluate(
            '(() => { try { return typeof localStorage; } catch (e) { return e.name; } })()'
        ) == 'SecurityError'
        fly_a_little(page, toy)
        assert 'settings are not remembered' in page.inner_text('#notes')
        page.keyboard.press('g')
        page.check('#hold-space')               # it holds until the page is left
        assert page.evaluate('rvd.stick.settings.holdSpace')
        assert 'settings are not remembered' in page.inner_text('#dialog')
        page.keyboard.press('Escape')
        assert toy.url.split('#')[1] not in page.url
        page.reload()                           # the token comes along
        until(page, 'Boolean(window.rvd?.store.measured)')
        finish(page, toy)
        assert page.problems == []
    finally:
        context.close()


def test_a_full_storage_is_no_reason_to_stop(browser, toy):
    context = browser.new_context()
    context.add_init_script(FULL)
    page = open_page(context, toy, look='plain')
    until(page, 'Boolean(rvd.store.measured)')
    page.wait_for_timeout(300)
    assert 'settings are not remembered' in page.inner_text('#notes')
    page.reload()
    until(page, 'window.rvd?.store.connected')
    assert page.problems == []
    context.close()


# -- no answer ------------------------------------------------------------------------------

def abort(page):
    page.keyboard.press('x')
    page.keyboard.press('x')


def test_an_abort_without_an_answer_is_asked_again_until_there_is_one(browser, toy):
    page = open_page(browser, toy, look='plain')
    until(page, 'Boolean(rvd.store.measured)')
    toy.answers = False
    abort(page)
    until(page, banner('ABORT NOT CONFIRMED'), 5.0)
    until(page, banner('asked 2 times'), 10.0)
    toy.answers = True
    until(page, banner('ABORT accepted'), 10.0)
    asked = toy.asked.count('abort')
    assert asked >= 2
    page.wait_for_timeout(3500)                 # and then no more
    assert toy.asked.count('abort') == asked
    page.close()


def test_an_abort_that_the_connection_swallowed_is_asked_again(browser, toy):
    page = open_page(browser, toy, look='plain')
    until(page, 'Boolean(rvd.store.measured)')
    toy.cut()
    until(page, '!rvd.store.connected')
    abort(page)
    until(page, banner('ABORT NOT CONFIRMED'), 5.0)
    until(page, banner('ABORT accepted'), 15.0)
    assert toy.asked == ['abort']
    page.close()


def test_an_abort_is_not_asked_of_the_next_run(browser, toy):
    page = open_page(browser, toy, look='plain')
    until(page, 'Boolean(rvd.store.measured)')
    toy.answers = False
    abort(page)
    until(page, banner('ABORT NOT CONFIRMED'), 5.0)
    finish(page, toy)
    page.wait_for_timeout(3500)
    asked = len(toy.asked)
    toy.hub.post('begin', 'next', toy.provider, toy)
    until(page, "rvd.store.run.name === 'next'")
    page.wait_for_timeout(3500)
    assert len(toy.asked) == asked
    page.close()


def test_a_server_that_has_gone_confirms_no_abort_and_the_page_says_so(browser, toy):
    page = open_page(browser, toy, look='plain')
    until(page, 'Boolean(rvd.store.measured)')
    toy.close()
    until(page, '!rvd.store.connected')
    abort(page)
    until(page, banner('ABORT NOT CONFIRMED'), 5.0)
    assert 'NOT CONNECTED' in page.inner_text('#banner')
    page.close()


def test_a_pause_without_an_answer_is_said_and_not_asked_again(browser, toy):
    page = open_page(browser, toy, look='plain')
    until(page, 'Boolean(rvd.store.measured)')
    page.keyboard.press('t')
    until(page, "rvd.store.status.lease === 'you'")
    toy.answers = False
    page.keyboard.press('p')
    until(page, banner('PAUSE NOT CONFIRMED'), 5.0)
    page.wait_for_timeout(3000)
    assert toy.asked == ['pause']
    toy.answers = True
    page.keyboard.press('p')
    until(page, 'rvd.store.frame.paused')
    until(page, '!' + banner('NOT CONFIRMED'))
    page.close()


def test_an_abort_that_went_out_and_is_not_acknowledged_does_not_stay_about_to_act(browser, toy):
    """The cart's commands say ABORT here, and its telemetry never says that one is in force."""
    page = open_page(browser, toy, look='plain')
    toy.kind = 3
    until(page, banner('ABORT sent, acting in about'), 5.0)
    until(page, banner('NOT ACKNOWLEDGED'), 10.0)
    assert re.search(r'sent \d+ s ago', page.inner_text('#banner'))
    page.close()


# -- what others say ------------------------------------------------------------------------

def test_names_and_words_with_html_and_escapes_are_text_on_the_page(browser, tmp_path):
    """A run's folder and verdict, and an event, that would be elements if they were not text."""
    name, words = 'a" class="evil" data-x="', '\x1b[31m"><img class="evil" src="x">'
    (tmp_path / name).mkdir()
    (tmp_path / name / 'verdict.json').write_text(json.dumps({
        'success': True, 'reason': words, 'mode': words, 'seed': words, 'scenario': words,
        'operator': words}))
    toy = ToyConsole(tmp_path)
    try:
        page = open_page(browser, toy, look='plain')
        toy.hub.post('event', {'t': 1.0, 'node': words, 'code': words, 'text': words})
        toy.hub.post('final', {**VERDICT, 'words': words, 'measures': [
            {**VERDICT['measures'][0], 'words': words, 'unit': words}]})
        until(page, "document.querySelector('#verdict-words') !== null")
        assert words.split('[31m')[1] in page.inner_text('#verdict-words').lower()
        assert page.evaluate("document.querySelectorAll('.evil').length") == 0
        page.keyboard.press('Escape')
        page.keyboard.press('l')
        until(page, "document.querySelector('#dialog [data-run]') !== null")
        assert page.evaluate("document.querySelector('#dialog [data-run]').dataset.run") == name
        assert page.evaluate("document.querySelectorAll('.evil, #dialog img').length") == 0
        assert page.problems == []
        page.close()
    finally:
        toy.close()
