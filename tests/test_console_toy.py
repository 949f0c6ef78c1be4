"""A mission of one axis, a box and two instruments, shown by the page that knows no mission."""

import json
import re
from pathlib import Path

import pytest
from console_page import open_page, serious, until, WEB
from runs import ROOT
from toy_console import (
    BACK_STEPS, command, place_at, PUSH, RAIL, telemetry, ToyConsole, ToyDisplay)

from rvd_groundstation.console.feed import Feed
from rvd_groundstation.console.protocol import encode

CONSOLE = ROOT / 'ros2_ws/src/rvd_groundstation/rvd_groundstation'
# Words of the lunar approach that neither the page nor what serves it may know.
LUNAR = re.compile(r'corridor|docking|lunar|moon|chaser|bullseye|drift|thrust.level|wall.margin|'
                   r'closing.rate|lateral.rate|control.boundary|half.angle.deg', re.IGNORECASE)


def flown(steps: int) -> Feed:
    feed = Feed(ToyDisplay())
    for step in range(steps):
        if step >= BACK_STEPS:
            feed.telemetry(telemetry(step))
        feed.command(command(step))
    return feed


def test_a_toy_display_goes_through_the_run_message():
    made = json.loads(encode(flown(1).run_message('cart')))
    shown = made['display']
    assert (made['step_s'], made['forward_s'], made['back_s']) == (0.1, 1.0, 0.5)
    assert made['acknowledged']                 # the ladder tells of every command
    assert [body['name'] for body in shown['bodies']] == ['cart']
    assert shown['bodies'][0]['axes'] == 'x'
    assert shown['bodies'][0]['shape'][0]['size_m'] == [1.0, 0.6, 0.6]
    assert [row['label'] for row in shown['instruments']['rows']] == ['position', 'speed']
    assert shown['camera'] is shown['section'] is shown['charts'] is None
    assert [axis['highest'] for axis in shown['commands']['axes']] == [0.5]


def test_and_its_frames_hold_what_it_shows_and_no_more():
    frame = json.loads(encode(flown(40).frame()))
    assert frame['k'] == 39 and frame['t'] == pytest.approx(3.9)
    cart = frame['signals'][RAIL]
    assert set(cart['parts']) == {'x', 'v'}
    assert cart['parts']['x'] == pytest.approx(place_at(3.4), abs=1e-6)
    assert (cart['t'], cart['received']) == (pytest.approx(3.4), pytest.approx(3.9))
    assert frame['signals'][PUSH]['parts']['value'] == command(39).parts['value']
    assert frame['signals']['derived']['parts'] == {}
    assert len(frame['ladder']) == 40 and all(len(row) == 7 + 1 for row in frame['ladder'])
    trail = flown(40).trails['been']            # for pages that come late
    assert trail[-1] == [pytest.approx(3.5), pytest.approx(3.0), place_at(3.0), None]
    assert frame['round_trip'] == pytest.approx(1.6)    # 1.0 s and 0.5 s, and the step it acts in


def test_a_mode_that_somebody_else_asked_for_is_shown_as_in_force():
    feed = flown(1)
    feed.event('MODE', 'mode manual')           # as the run says it
    assert feed.frame()['mode'] == 'manual'


def test_the_stick_of_one_axis_becomes_a_joy_and_a_command():
    toy = ToyDisplay()
    assert toy.joy((0.5, 0.0, 0.0, 0.0, 0.0, 0.0), True) == ([0.5], [1])
    assert toy.pilot([0.5], [1]) == ([0.25], True)
    for axes, buttons in (([0.5], [0]), ([], [1]), ([1.5], [1]), ([float('nan')], [1])):
        assert toy.pilot(axes, buttons) == ([0.0], False)


@pytest.mark.parametrize('file', [
    *sorted((WEB / 'src').glob('*.js')), *sorted((WEB / 'src').glob('*.css')), WEB / 'index.html',
    *sorted((CONSOLE / 'console').glob('*.py'))], ids=lambda path: path.name)
def test_page_and_server_know_no_mission(file: Path):
    text = file.read_text(encoding='utf-8')
    found = [line.strip() for line in text.splitlines() if LUNAR.search(line)]
    assert found == []


@pytest.mark.slow
@pytest.mark.patient
def test_the_page_shows_the_toy(browser, console_web):
    toy = ToyConsole()
    try:
        page = open_page(browser, toy, bypass_csp=True)     # for axe
        until(page, 'Boolean(rvd.store.measured)')
        page.wait_for_timeout(500)
        for panel in ('camera', 'cut', 'strips', 'modes', 'views'):
            assert not page.is_visible(f'#{panel}'), panel
        assert not page.is_visible('#clock-pred')           # nothing is predicted
        assert page.evaluate("rvd.scene.covers('cart')") > 20
        assert page.evaluate("rvd.scene.covers('rail')") > 20
        assert page.evaluate("rvd.store.history.trails.get('been').length") > 3
        rows = page.query_selector_all('#instruments .row')
        words = [row.inner_text().split() for row in rows]
        assert [row[0] for row in words] == ['position', 'speed']
        number = float(words[0][1].replace('−', '-'))
        there = page.evaluate('rvd.store.measured.parts.x')
        assert number == pytest.approx(there, abs=0.1)      # it has moved on since
        assert words[1][-1] == '−400…400'
        assert page.inner_text('#commands-title') == 'Force, N'
        assert len(page.query_selector_all('#bars .bar')) == 1
        assert page.inner_text('#scale') == '' and page.inner_text('#legend') == ''

        page.keyboard.press('?')
        assert 'push right / left (x)' in page.inner_text('#dialog')
        page.keyboard.press('Escape')
        page.keyboard.press('t')
        until(page, "rvd.store.status.lease === 'you'")
        page.keyboard.down('d')
        page.wait_for_timeout(300)
        assert ([0.5], True) in toy.sticks
        page.keyboard.up('d')
        assert serious(page, console_web) == []

        toy.finish()
        until(page, "document.querySelector('#verdict-words') !== null")
        dialog = page.inner_text('#dialog')
        assert 'Arrived at the buffer' in dialog and '12.3 s' in dialog
        assert re.search(r'speed at the buffer\s+0\.020 m/s\s+< 0\.1', dialog)
        assert 'delay' not in dialog                        # it has no value
        assert page.problems == []
    finally:
        toy.close()
