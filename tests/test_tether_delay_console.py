"""The orders of mission tether_delay as buttons of the page: pressed in a flight that obeys."""

from itertools import groupby

import numpy as np
import pytest
from console_page import Console, open_page, stop, until
from runs import messages, ROOT

from rvd_dynamics.diagram.scenario import load
from rvd_dynamics.recording.reader import read
from rvd_missions.tether_delay.signals import BRAKING, CRAFT, FLYING, LATCHED, STANDING, TRUTH

pytestmark = pytest.mark.slow
SHORT = {'mode': 'hold', 'step_s': 0.1, 'timeout_s': 300.0, 'planner__nodes': 16,
         'ground__solve_s': 1.0, 'ground__lead_s': 1.0, 'forward_delay_s': 2.0, 'back_delay_s': 2.0,
         'hold__braking_m_s2': 0.1, 'hold__settle_s': 1.0}
RANGE = "rvd.store.frame.signals['/ground/situation'].parts.range"


def in_turn(values) -> list:
    return [value for value, _ in groupby(values)]


def reads(hold: str, go: str) -> str:
    """Return the condition that the two buttons say this of ground and craft."""
    return ' && '.join(
        f"document.querySelector('[data-mode={mode}] small').textContent === '{words}'"
        for mode, words in (('hold', hold), ('go', go)))


def order(page, key: str, shown: str) -> None:
    """Order by a key while the run is paused, so that what is then shown cannot pass unseen."""
    page.keyboard.press('p')
    until(page, 'rvd.store.frame.paused')
    page.keyboard.press(key)
    until(page, shown)
    page.keyboard.press('p')
    until(page, '!rvd.store.frame.paused')


def test_hold_and_go_are_pressed_in_a_flight_and_stop_the_gripper_and_send_it_on(browser, tmp_path):
    chosen = load(ROOT / 'scenarios' / 'tether_delay.yaml').with_values('/**', **SHORT)
    chosen = chosen.with_values('flight_director', go_s=0.0, hold_range_m=0.0)   # orders nothing
    (tmp_path / 'short.yaml').write_text(chosen.dump())
    console = Console(tmp_path, 'short.yaml', '--pace', 'lockstep', '--seed', '5',
                      '--processes', 'segments')
    try:
        page = open_page(browser, console, look='plain')
        page.keyboard.press('?')
        for words in ('HOLD: come to rest', 'GO: fly the plan', 'stand-in'):
            assert words in page.inner_text('#dialog')
        assert 'in turn' not in page.inner_text('#dialog')          # each has a key of its own
        page.keyboard.press('Escape')
        assert page.is_disabled('[data-mode=go]')                   # not without the stick
        page.keyboard.press('t')
        until(page, "rvd.store.status.lease === 'you'")
        page.keyboard.press('n')
        assert page.input_value('#new-mode') == 'hold'              # as the scenario has it
        page.click('#new-start')
        until(page, 'Boolean(rvd.store.measured)')
        until(page, reads('ground', ''))                            # on its latch it obeys neither

        page.click('[data-mode=go]')
        until(page, reads('', 'ground'))
        until(page, reads('', 'ground · on board'))
        until(page, f'{RANGE} < 95')
        order(page, 'h', reads('ground', 'on board'))               # ordered, and not there yet
        until(page, reads('ground · on board', ''))
        until(page, 'rvd.store.frame.signals.derived.parts.does[3] === 1')
        stands, at = page.evaluate(RANGE), page.evaluate('rvd.store.frame.t')
        until(page, f'rvd.store.frame.t > {at} + 3')
        assert page.evaluate(RANGE) == pytest.approx(stands, abs=0.05)

        order(page, 'f', reads('on board', 'ground'))               # stands until there is a plan
        until(page, reads('', 'ground · on board'))
        until(page, f'{RANGE} < {stands} - 1')
        run = stop(page, console)
    finally:
        console.close()
    recorded = read(run)
    doing, state = recorded.of(CRAFT)['doing'], recorded.of(TRUTH)['state']
    said = [m.text for m in messages(run, '/run/events') if m.code == 'MODE']
    assert said == ['mode go', 'mode hold', 'mode go']
    assert in_turn(doing)[:5] == [LATCHED, FLYING, BRAKING, STANDING, FLYING]
    n = min(len(doing), len(state))             # it was stopped within a step
    doing, speed = doing[:n], np.linalg.norm(state[:n, 3:6], axis=-1)
    assert speed[doing == FLYING].max() > 0.5 and speed[doing == STANDING].max() < 0.1
