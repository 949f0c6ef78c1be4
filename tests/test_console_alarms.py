"""Alarms, digits at the reticle, keys beside the craft: in a real browser, and a real flight."""

import re

import numpy as np
import pytest
from console_page import Console, open_page, take_and_start, until
from placed_console import GOOD, PlacedConsole

from rvd_dynamics.commands.codes import BY_NOBODY, REASON_MODE, REASON_PILOT_INVALID

pytestmark = pytest.mark.slow
PLACES = '#top, #alarms, #left > *, #centre > *, #right > *, #bottom'
BOXES = f"""[...document.querySelectorAll('{PLACES}')].map((e) => {{
    const r = e.getBoundingClientRect(); return [e.id, r.left, r.top, r.width, r.height]; }})"""
OUT = (-12.0, 2.5, 0.0, 0.25, 0.0, 0.0)                 # the wall is at 0.94 m there
FAST = (-12.0, 0.1, 0.0, 0.36, 0.0, 0.0)                # the limit is 0.3 m/s
INK = """(() => {
  const c = document.getElementById('section');
  const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
  let n = 0;
  for (let i = 0; i < d.length; i += 4) n += d[i] === %d && d[i + 1] === %d && d[i + 2] === %d;
  return n;
})()"""
MEASURED = INK % (0x7c, 0xc4, 0xff)


@pytest.fixture(scope='module')
def placed():
    made = PlacedConsole()
    yield made
    made.close()


@pytest.fixture()
def page(browser, placed):
    placed.put(GOOD)
    placed.comes_down, placed.reason, placed.by = True, REASON_MODE, 2
    made = open_page(browser, placed, look='plain')
    made.set_viewport_size({'width': 1280, 'height': 720})
    until(made, 'Boolean(rvd.store.measured)')
    until(made, 'rvd.alarms.alarms.standing.size === 0')
    made.wait_for_timeout(600)                          # the page has taken its new size
    yield made
    assert made.problems == []
    made.close()


def words(page) -> str:
    return page.inner_text('#alarm-words')


def says(page, text: str) -> None:
    until(page, f"document.querySelector('#alarm-words').textContent === '{text}'")


def test_an_alarm_names_value_and_limit_and_nothing_jumps(page, placed):
    quiet = page.evaluate(BOXES)
    assert words(page) == 'no alarm' and page.is_disabled('#alarm-ack')
    placed.put(GOOD, FAST)
    says(page, 'TOO FAST')
    assert page.get_attribute('#alarms', 'class') == 'warning'
    assert page.inner_text('#alarm-detail') == 'predicted closing rate 0.360 m/s, limit 0.300'
    assert page.evaluate(BOXES) == quiet
    box = page.query_selector('#alarms').bounding_box()
    assert box['width'] > 0.98*1280
    page.keyboard.press('g')                            # what lies over the line says it, too
    until(page, "document.querySelector('#dialog-note')?.textContent === "
                "'TOO FAST: predicted closing rate 0.360 m/s, limit 0.300'")
    placed.put(GOOD)
    until(page, "document.querySelector('#dialog-note').hidden")
    page.keyboard.press('Escape')
    says(page, 'no alarm')                              # it goes by itself, and nothing jumps
    assert page.evaluate(BOXES) == quiet


def test_an_acknowledged_alarm_is_silent_until_the_next_one(page, placed):
    assert not page.evaluate('rvd.alarms.sound.on')     # off by default
    page.keyboard.press('o')
    assert page.evaluate('rvd.alarms.sound.on') and 'Sound on' in page.inner_text('#alarm-sound')
    placed.put(FAST)
    until(page, 'rvd.alarms.sound.sung > 1')
    page.keyboard.press('k')
    assert page.get_attribute('#alarms', 'class') == 'seen'
    page.wait_for_timeout(150)
    sung = page.evaluate('rvd.alarms.sound.sung')
    page.wait_for_timeout(1500)
    assert page.evaluate('rvd.alarms.sound.sung') == sung
    assert words(page) == 'TOO FAST'                    # it still stands
    placed.put((*OUT[:3], *FAST[3:]))
    says(page, 'OUTSIDE THE CORRIDOR')                  # what is new comes first
    assert 'TOO FAST' in page.inner_text('#alarm-more')
    until(page, f'rvd.alarms.sound.sung > {sung}')
    page.click('#alarm-ack')
    assert page.get_attribute('#alarms', 'class') == 'seen'
    page.keyboard.press('o')
    assert not page.evaluate('rvd.alarms.sound.on')


def test_telemetry_that_stops_and_a_stick_that_nobody_holds_are_alarms(page, placed):
    placed.comes_down = False
    says(page, 'TELEMETRY LOST')
    assert re.fullmatch(r'age \d+\.\d s', page.inner_text('#alarm-detail'))
    placed.comes_down = True
    says(page, 'no alarm')
    placed.reason, placed.by = REASON_PILOT_INVALID, BY_NOBODY
    says(page, 'NOBODY HOLDS THE STICK')
    assert page.get_attribute('#alarms', 'class') == 'caution'


def test_the_ladder_of_a_craft_that_acknowledges_nothing_says_so(page):
    counts = "document.querySelector('#ladder-counts').textContent"
    until(page, f"/ on the link · .*\\d/.test({counts})")
    page.evaluate('rvd.store.run.acknowledged = false')
    until(page, f"/^\\d+ on the link · this craft acknowledges none$/.test({counts})")
    page.evaluate('rvd.store.run.acknowledged = true')


def test_the_section_shows_a_craft_outside_of_it(page, placed):
    ahead = (-9.0, -0.4, 0.0, 0.25, 0.0, 0.0)           # away from what is measured
    placed.put(GOOD, ahead)
    until(page, 'rvd.store.predicted.parts.position[1] === -0.4')
    page.wait_for_timeout(400)
    inside = page.evaluate(MEASURED)
    placed.put((-12.0, 0.0, 30.0, 0.25, 0.0, 0.0), ahead)       # beyond what the cut reaches to
    until(page, "rvd.store.measured.parts.position[2] === 30")
    page.wait_for_timeout(400)
    assert inside > 20 and page.evaluate(MEASURED) > 20


def test_digits_at_the_reticle_are_signed_and_predicted_beside_measured(page, placed):
    placed.put((-12.34, 0.16, -0.07, 0.251, 0.004, -0.002), (-9.5, -0.21, 0.08, 0.24, 0.0, 0.011))
    until(page, "document.querySelector('#digits b').textContent === '12.34'")
    cells = [cell.inner_text() for cell in page.query_selector_all('#digits b')]
    assert page.inner_text('#digits').split()[:2] == ['m', 'm/s']
    assert cells == ['12.34', '9.50', '0.251', '0.240', '+0.16', '−0.21', '+0.004', '0.000',
                     '−0.07', '+0.08', '−0.002', '+0.011']
    sizes = page.evaluate("[...document.querySelectorAll('#digits b.measured')]"
                          '.map((e) => parseFloat(getComputedStyle(e).fontSize))')
    assert min(sizes) >= 15.0


def test_keys_stand_beside_the_craft_until_the_first_command(browser, placed):
    placed.put(GOOD)
    page = open_page(browser, placed)                   # with the scene: places are of its picture
    page.set_viewport_size({'width': 1280, 'height': 720})
    until(page, 'Boolean(rvd.store.measured) && rvd.scene.drawn > 2')
    assert not page.is_visible('#coach')                # who watches is told nothing
    page.keyboard.press('t')
    until(page, "!document.querySelector('#coach').hidden")
    until(page, "!document.querySelector('#coach-caps').hidden")
    card = page.inner_text('#coach-card')
    assert 'level of the keys' in card and 'contact' in card
    assert 'thrust forward' not in card                 # it stands beside the craft
    assert 'closing slower than 0.3 m/s' in card and '10 m' in card
    assert '10 m' in page.inner_text('#coach-card tr.next')     # 12 m are to go
    caps = {cap.inner_text().split()[-1]: cap.bounding_box()
            for cap in page.query_selector_all('#coach-caps span') if cap.is_visible()}
    assert caps['up']['y'] < caps['down']['y']
    assert {'forward', 'back', 'up', 'down'} <= set(caps)
    page.keyboard.down('w')
    until(page, "document.querySelector('#coach').hidden")
    page.keyboard.up('w')
    page.wait_for_timeout(300)
    assert not page.is_visible('#coach')                # for the rest of the run
    page.keyboard.press('?')
    assert 'A good approach' in page.inner_text('#dialog')
    page.keyboard.press('Escape')
    page.keyboard.press('t')
    until(page, "rvd.store.status.lease === 'free'")
    assert page.problems == []
    page.close()


def test_the_field_of_view_stands_until_it_is_said_to_change(browser, placed):
    placed.put((-14.0, *GOOD[1:]))
    page = open_page(browser, placed)
    until(page, "document.querySelector('#camera-field').textContent.startsWith('field')")
    until(page, "!document.querySelector('#camera-field').classList.contains('news')")
    here = page.inner_text('#camera-field')
    tan = page.evaluate('rvd.scene.cameraTan')
    placed.put((-9.0, *GOOD[1:]))
    until(page, 'rvd.store.measured.parts.position[0] === -9')
    page.wait_for_timeout(500)
    assert page.evaluate('rvd.scene.cameraTan') == tan and page.inner_text('#camera-field') == here
    placed.put((-5.0, *GOOD[1:]))
    until(page, f'rvd.scene.cameraTan === {2*tan}')
    until(page, "document.querySelector('#camera-field').classList.contains('news')")
    assert re.fullmatch(r'field \d+° \(was \d+°\)', page.inner_text('#camera-field'))
    page.close()


@pytest.mark.patient
def test_a_flight_that_leaves_the_corridor_calls_before_it_has_left(browser, tmp_path):
    console = Console(tmp_path, 'barrier', '--pace', '5', '--seed', '3')
    try:
        page = open_page(browser, console, look='plain')
        page.evaluate("""(() => { window.counted = []; const seen = () => {
            const s = document.querySelector('#banner').textContent;
            if (/nodes ready/.test(s) && window.counted.at(-1) !== s) window.counted.push(s); };
            new MutationObserver(seen).observe(document.querySelector('#banner'),
                                               {childList: true, subtree: true}); })()""")
        page.set_viewport_size({'width': 1280, 'height': 720})
        page.wait_for_timeout(600)
        before = page.evaluate(BOXES)
        take_and_start(page, 'manual')
        assert page.evaluate('window.counted.length') > 0       # the start, node by node
        page.keyboard.down('ArrowUp')
        until(page, "rvd.alarms.alarms.standing.has('LEAVING THE CORRIDOR')"
                    ' || Boolean(rvd.store.verdict)', 240.0)
        assert not page.evaluate('Boolean(rvd.store.verdict)')
        assert page.evaluate(BOXES) == before           # from before the first number to here
        until(page, "document.querySelector('#alarm-words').textContent === 'LEAVING THE CORRIDOR'")
        assert page.inner_text('#alarm-detail').startswith('predicted margin −')
        predicted = page.evaluate('rvd.store.predicted.parts.position')
        assert np.hypot(*predicted[1:]) > 0.9*(0.3 - predicted[0]*np.tan(np.radians(3.0)))
        until(page, 'Boolean(rvd.store.verdict)', 240.0)
        page.keyboard.up('ArrowUp')
        assert not page.evaluate('rvd.store.verdict.success')
        until(page, "document.querySelector('#alarm-words').textContent === 'no alarm'")
        page.close()
    finally:
        console.close()
