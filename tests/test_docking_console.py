"""The mission docking in a browser: its panels in a flight, its forms, a flight by hand."""

import asyncio
from dataclasses import replace
import re

import numpy as np
import pytest
from console_page import Console, open_page, serious, stop, until
from runs import messages
from toy_console import ToyConsole

from rvd_dynamics.diagram.in_process import fly
from rvd_dynamics.diagram.scenario import parse
from rvd_dynamics.recording.reader import read
from rvd_groundstation.console.provider import facts_of
from rvd_missions.docking.display import DockingDisplay
from rvd_missions.docking.signals import TRUTH

pytestmark = pytest.mark.slow
SCENARIO = '''
/**: {ros__parameters: {mission: docking, timeout_s: 60.0, limits: {from_s: 0.5},
                        pace: lockstep, processes: one}}
onboard_guard: {ros__parameters: {abort_burn_s: 2.0}}
'''
BY_HAND = '''
/**: {ros__parameters: {mission: docking, steering: aboard, operator: model, timeout_s: 60.0,
                        limits: {from_s: 0.5}, seeing: {camera: simple}, processes: segments}}
'''
PAD = '''
(() => {
  window.pad = { id: 'stub', index: 0, mapping: 'standard', connected: true, axes: [0, 0, 0, 0],
    buttons: Array.from({ length: 17 }, () => ({ pressed: false, value: 0 })) };
  navigator.getGamepads = () => [window.pad];
})();
'''


def field(page, key: str) -> str:
    return f'[data-setting="{key}"]'


def ink(page, canvas: str) -> int:
    """Return how many pixels of a canvas are drawn."""
    return page.evaluate(f"""(() => {{
      const c = document.getElementById('{canvas}');
      const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
      let n = 0;
      for (let i = 3; i < d.length; i += 4) n += d[i] > 0;
      return n;
    }})()""")


def test_a_flight_with_settings_from_the_page_and_its_review(browser, tmp_path, console_web):
    (tmp_path / 'short.yaml').write_text(SCENARIO)
    console = Console(tmp_path, 'short.yaml', '--seed', '1')
    try:
        page = open_page(browser, console, bypass_csp=True)         # for axe
        page.set_viewport_size({'width': 1280, 'height': 800})
        page.keyboard.press('t')
        until(page, "rvd.store.status.lease === 'you'")
        page.keyboard.press('n')
        page.fill(field(page, '/** start.position_m'), '6, 0, 0')
        page.click('#new-start')
        until(page, "document.querySelector('#new-error')?.textContent.length > 0")
        error = page.inner_text('#new-error')
        assert 'start.position_m' in error and 'x < 0' in error and '\n' not in error
        assert page.input_value(field(page, '/** start.position_m')) == '6, 0, 0'

        page.fill(field(page, '/** start.position_m'), '-5.5, 0.1, 0')
        page.fill(field(page, '/** timeout_s'), '5')
        page.fill(field(page, 'docking_controller profile.fast_m_s'), '0.045')
        page.click('#new-start')
        until(page, "rvd.store.frame?.t > 1.5 && Boolean(rvd.store.measured)")
        assert serious(page, console_web) == []
        derived = page.evaluate('rvd.store.frame.signals.derived.parts')
        assert 2.3 < derived['distance'] < 2.51                     # as was written: 2.5 m
        assert 'truth' not in page.evaluate('Object.keys(rvd.store.frame.signals)')
        for panel in ('attitude', 'lamps', 'cut', 'camera', 'strips', 'commands'):
            assert page.is_visible(f'#{panel}'), panel
        for panel in ('ladder-panel', 'trip', 'modes', 'clock-rx'):
            assert not page.is_visible(f'#{panel}'), panel
        assert page.inner_text('#foot-words') == 'NOMINAL'
        assert page.evaluate("rvd.scene.covers('chaser')") > 200
        assert ink(page, 'ball') > 500 and ink(page, 'lights') > 500
        assert page.evaluate("rvd.store.frame.signals.derived.parts.used.join('')") == '1'*6 + '0'*6

        until(page, 'Boolean(rvd.store.verdict)', 60.0)
        until(page, "rvd.store.status.phase === 'ended'", 60.0)
        page.keyboard.press('Escape')
        page.keyboard.press('l')
        page.click('[data-run]')
        until(page, 'rvd.review.on')
        truth = page.evaluate('rvd.review.frame().signals.truth.parts')
        assert all(abs(v) < 5.0 for v in truth['error_mm'])
        assert len(truth['panel_0']) == 11
        assert page.evaluate("rvd.scene.covers('panel_0')") > 20
        row = page.query_selector('#instruments .row').inner_text()
        measured, true = re.findall(r'\d+', row)[:2]
        assert abs(int(measured) - int(true)) <= 5                  # [mm]
        assert page.problems == []
        page.close()
    finally:
        console.close()


class HandsConsole(ToyConsole):
    """The page of a craft that is steered by two hand controllers, without a graph."""

    async def _fly(self) -> None:
        scenario = parse(SCENARIO, 'test')
        facts = replace(facts_of(scenario), operator='console', mode='manual')
        self.provider = DockingDisplay(facts, scenario)
        self.joys: list = []
        self.hub.begin('hands', self.provider, self)
        await asyncio.sleep(1e6)

    def joy(self, stick) -> list[float]:
        made = self.provider.joys(stick)
        self.joys.append(made)
        return [self.provider.heard_joy(topic, *joy)[0] for topic, joy in made.items()][-1]


def test_keys_and_a_gamepad_move_two_hand_controllers(browser):
    console = HandsConsole()
    try:
        page = open_page(browser, console, look='plain')
        page.keyboard.press('?')
        words = page.inner_text('#dialog')
        for row in ('W / S', 'go forward / back (x)', 'E / Q', 'go right / left (roll)',
                    'translation by pulses or by rates, while held'):
            assert row in words, row
        page.keyboard.press('Escape')
        page.keyboard.press('t')
        until(page, "rvd.store.status.lease === 'you'")

        def said(after_ms: int = 150) -> dict:
            page.wait_for_timeout(after_ms)
            return console.joys[-1]
        page.keyboard.press('3')
        for key in ('w', 'ArrowUp', 'c'):
            page.keyboard.down(key)
        assert said() == {'/joy/translation': ([1.0, 0.0, 0.0], [1, 1, 0]),
                          '/joy/rotation': ([0.0, 1.0, 0.0], [1, 0])}
        for key in ('w', 'ArrowUp', 'c'):
            page.keyboard.up(key)
        assert said() == {'/joy/translation': ([0.0]*3, [1, 0, 0]),
                          '/joy/rotation': ([0.0]*3, [1, 0])}

        page.evaluate(PAD)
        said()
        page.evaluate('pad.buttons[4] = {pressed: true, value: 1}')             # the dead-man
        said()
        page.evaluate('''pad.buttons[7] = {pressed: true, value: 1}; pad.axes[2] = -1;
                         pad.axes[3] = 1; pad.buttons[14] = {pressed: true, value: 1}''')
        assert said() == {'/joy/translation': ([1.0, 0.0, 0.0], [1, 0, 0]),
                          '/joy/rotation': ([-1.0, -1.0, -1.0], [1, 0])}
        page.evaluate('pad.buttons[4] = {pressed: false, value: 0}')
        assert said() == {'/joy/translation': ([0.0]*3, [0, 0, 0]),
                          '/joy/rotation': ([0.0]*3, [0, 0])}
        console.hub.post('event', {
            't': 1.0, 'node': 'docking_controller', 'code': 'STICK_LOST',
            'text': '/joy/rotation does not count: dead-man button 0 is not held'})
        until(page, "document.querySelector('#event').textContent.includes('dead-man is open')")
        assert 'button' not in page.inner_text('#event')            # keys have none
        assert page.problems == []
        page.close()
    finally:
        console.close()


def test_keys_and_a_gamepad_fly_the_craft_by_both_hand_controllers(browser, tmp_path):
    """The whole way: page, server, both Joys, graph; the truth in the bag has what was asked."""
    (tmp_path / 'by_hand.yaml').write_text(BY_HAND)
    fly(parse(BY_HAND.replace('60.0', '0.6'), 'test'), [0])     # compiles
    console = Console(tmp_path, 'by_hand.yaml', '--seed', '1', '--pace', '1')
    try:
        page = open_page(browser, console, look='plain')
        page.keyboard.press('t')
        until(page, "rvd.store.status.lease === 'you'")
        page.keyboard.press('n')
        page.click('#new-start')
        until(page, 'rvd.store.frame?.t > 0.5')
        rate = 'rvd.store.frame.signals.derived.parts.rates'        # as navigation has it [deg/s]
        page.keyboard.press('3')                # full deflection
        keys = ('c', 'd', 'ArrowUp')            # to the right, by rates; nose up
        for key in keys:
            page.keyboard.down(key)
        until(page, f'({rate} || [])[1] > 0.2', 20.0)                       # of 0.3
        for key in keys:
            page.keyboard.up(key)
        page.evaluate(PAD)
        page.evaluate('pad.buttons[4] = {pressed: true, value: 1}')             # the dead-man
        page.wait_for_timeout(150)
        by_keys = page.evaluate('rvd.store.frame.t')
        page.evaluate('''pad.buttons[5] = {pressed: true, value: 1};
                         pad.axes[0] = -1; pad.axes[2] = -1''')     # left; nose left
        until(page, f'({rate} || [])[2] < -0.2', 20.0)
        run = stop(page, console)
    finally:
        console.close()
    truth, end = read(run).of(TRUTH), round(by_keys/0.01)
    speed, turn = truth['velocity'][:, 1], np.degrees(truth['rate'] - truth['rate'][0])
    assert np.abs(speed[:50]).max() < 1e-3                          # [m/s] before it is steered
    assert speed[:end].max() > 0.01 and turn[:end, 1].max() > 0.12
    assert speed[end:].min() < speed[:end].max() - 0.01 and turn[end:, 2].min() < -0.12
    assert turn[:end, 2].min() > -0.1                               # the keys did not ask for it
    for topic, axis in (('/joy/translation', 1), ('/joy/rotation', 1), ('/joy/rotation', 2)):
        axes = np.array([m.axes for m in messages(run, topic)])
        assert np.abs(axes[:, axis]).max() == 1.0, topic
