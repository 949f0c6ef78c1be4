"""What the page says in a flight by the real graph, against what the bag holds of it."""

import socket

import numpy as np
import pytest
from console_page import Console, open_page, take_and_start, until
from runs import messages, wait_for

from rvd_groundstation.console.tokens import own_folder

pytestmark = pytest.mark.slow
BY_NOBODY, BY_AUTO, PILOT_INVALID, ABORT = 0, 2, 9, 3
DEAD_MAN = 4                            # button of the Joy


@pytest.fixture(autouse=True)
def no_page_is_left(browser):
    yield
    for context in browser.contexts:
        context.close()


def says(text, selector='#banner'):
    return f"document.querySelector('{selector}').textContent.includes('{text}')"


def step_of(page):
    return page.evaluate('rvd.store.sent.k')


@pytest.fixture(scope='module')
def console(tmp_path_factory, browser):
    made = Console(tmp_path_factory.mktemp('truth'), 'hand')
    yield made
    made.close()


@pytest.fixture(scope='module')
def flown(console, browser):
    """
    A flight in manual and then in shared mode, with dialogs, a review, a pause and watchers.

    What was seen, by what was done; steps are those of the newest command at that time.
    """
    seen = {}
    first = open_page(browser, console, look='plain')
    take_and_start(first, 'manual')
    until(first, 'Boolean(rvd.store.measured)')
    seen['reviewed'] = end_run(first, console)
    page = open_page(browser, console, look='plain')
    page.set_viewport_size({'width': 1280, 'height': 720})
    page.keyboard.press('Escape')
    take_and_start(page, 'manual')
    until(page, 'Boolean(rvd.store.measured)')
    until(page, says('the pilot flies alone', '#why'))
    seen['live'] = page.inner_text('#why')

    page.keyboard.press('?')                    # manual, with a dialog open
    until(page, says('STICK RELEASED while “Keys” is open: nobody flies'))
    until(page, says('nobody flies: no valid stick', '#why'))
    seen['open'] = [step_of(page)]
    seen['manual'] = {name: page.inner_text(f'#{name}')
                      for name in ('banner', 'stick-state', 'why', 'dialog')}
    page.wait_for_timeout(800)
    seen['open'].append(step_of(page))
    page.keyboard.press('Escape')
    until(page, says('the pilot flies alone', '#why'))
    seen['closed'] = step_of(page)

    page.keyboard.press('m')                    # shared, likewise
    until(page, "rvd.store.frame.mode === 'shared'")
    page.keyboard.press('g')
    until(page, says('the automatic controller flies alone', '#why'))
    until(page, says('is open: the automatic controller flies alone'))
    seen['shared'] = [step_of(page)]
    page.wait_for_timeout(500)
    seen['shared'].append(step_of(page))
    page.keyboard.press('Escape')

    page.keyboard.press('l')                    # a review in flight
    until(page, "document.querySelector('#review-warning') !== null")
    seen['warning'] = page.inner_text('#review-warning')
    page.click(f'[data-run="{seen["reviewed"].name}"]')
    until(page, 'rvd.review.on')
    until(page, says('STICK RELEASED', '#live'))
    seen['live_flight'] = page.inner_text('#live')
    seen['live_at'] = [page.inner_text('#live-head')]
    page.wait_for_timeout(700)
    seen['live_at'].append(page.inner_text('#live-head'))
    seen['live_box'], seen['abort_box'] = (page.query_selector(f'#{name}').bounding_box()
                                           for name in ('live', 'abort'))
    page.click('#live-back')
    until(page, '!rvd.review.on && rvd.stick.state().held')
    seen['live_hidden'] = page.is_hidden('#live')

    page.keyboard.press('p')                    # a watcher who comes in a pause
    until(page, 'rvd.store.frame.paused')
    page.wait_for_timeout(500)
    seen['paused'] = page.evaluate('rvd.store.frame.k')
    late = open_page(browser, console, look='plain', url=console.watch_url)
    until(late, says('PAUSED'))
    until(late, 'Boolean(rvd.store.frame)')
    seen['late'] = late.evaluate('rvd.store.frame.k')
    for key in 'xxtp':
        late.keyboard.press(key)
    late.wait_for_timeout(500)
    seen['late_words'] = late.inner_text('#abort') + late.inner_text('#lease')
    seen['still_paused'] = page.evaluate('rvd.store.frame.paused')
    page.keyboard.press('p')
    until(late, f'rvd.store.frame.k > {seen["paused"]}')
    seen['problems'] = page.problems + late.problems
    late.close()
    seen['run'] = end_run(page, console)
    return seen


def end_run(page, console):
    run = console.folder / 'runs' / page.evaluate('rvd.store.status.run')
    page.evaluate("(() => { rvd.link.ask({ do: 'stop' }); })()")
    until(page, "rvd.store.status.phase === 'ended'")
    wait_for(lambda: (run / 'verdict.json').exists(), 'verdict.json')
    page.close()
    return run


@pytest.fixture(scope='module')
def commands(flown):
    """Decided by and reason of each command, by step."""
    return {m.step: (m.decided_by, m.reason) for m in messages(flown['run'], '/ground/command')}


def test_in_manual_with_a_dialog_open_nobody_flies_and_the_page_says_so(flown, commands):
    first, last = flown['open']
    assert last > first
    assert {commands[k] for k in range(first, last + 1)} == {(BY_NOBODY, PILOT_INVALID)}
    for name, words in flown['manual'].items():
        assert 'nobody flies' in words, name
        assert name == 'dialog' or 'automatic' not in words, words      # that one lists the keys
    assert commands[flown['closed']][0] == 1


def test_the_joy_of_an_open_dialog_has_an_open_dead_man(flown):
    step_ns = 100_000_000
    first, last = flown['open']
    joys = messages(flown['run'], '/joy')
    at = np.array([m.header.stamp.sec*10**9 + m.header.stamp.nanosec for m in joys]) / step_ns
    held = np.array([m.buttons[DEAD_MAN] for m in joys])
    assert not held[(at >= first) & (at <= last)].any()
    assert held[at < first - 20].any() and held[at > last + 10].any()


def test_in_shared_the_automatic_controller_flies_alone_and_the_page_says_that(flown, commands):
    first, last = flown['shared']
    assert {commands[k] for k in range(first, last + 1)} == {(BY_AUTO, PILOT_INVALID)}


def test_a_review_in_flight_warns_and_keeps_the_flight_in_view(flown):
    assert 'A flight is under way' in flown['warning']
    assert 'LIVE FLIGHT' in flown['live_flight'] and 'range' in flown['live_flight']
    assert 'the automatic controller flies alone' in flown['live_flight']
    assert flown['live_at'][0] != flown['live_at'][1]           # it goes on
    box = flown['live_box']
    assert 0 <= box['x'] and box['x'] + box['width'] <= 1280 and box['y'] + box['height'] <= 720
    assert flown['abort_box'] is not None and flown['live_hidden']


def test_a_watcher_who_comes_in_a_pause_sees_the_last_picture_and_steers_nothing(flown):
    assert flown['late'] == flown['paused'] and flown['still_paused']
    assert 'not from here' in flown['late_words'] and 'Watching only' in flown['late_words']
    assert not any(m.kind == ABORT for m in messages(flown['run'], '/ground/command'))


def test_the_browser_has_nothing_to_complain_about(flown):
    assert flown['problems'] == []


def test_a_page_comes_back_by_itself_to_a_fly_that_was_killed_and_started_anew(
        browser, tmp_path_factory):
    with socket.socket() as one:
        one.bind(('127.0.0.1', 0))
        port = one.getsockname()[1]
    consoles = []

    def start():
        consoles.append(Console(tmp_path_factory.mktemp('again'), 'hand', port=port))
        return consoles[-1]
    try:
        first = start()
        page = open_page(browser, first, look='plain')
        page.keyboard.press('t')
        until(page, "rvd.store.status.lease === 'you'")
        first.process.kill()
        until(page, says('NOT CONNECTED: no server for'))
        assert page.is_disabled('#lease') and page.is_disabled('#restart')
        second = start()
        assert (second.url, second.watch_url) == (first.url, first.watch_url)
        until(page, 'rvd.store.connected')
        until(page, says('Ready'))
        page.keyboard.press('t')
        until(page, "rvd.store.status.lease === 'you'")
    finally:
        for console in consoles:
            console.close()
        (own_folder() / f'127.0.0.1-{port}.json').unlink(missing_ok=True)
