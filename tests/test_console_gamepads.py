"""A gamepad flies when it is known what its axes mean, and each axis once it has been at rest."""

import json
from pathlib import Path

import pytest
from console_page import open_page, until
from toy_console import WaitingConsole

pytestmark = pytest.mark.slow
CASES = {case['name']: case for case in json.loads(
    (Path(__file__).parent / 'data/gamepads.json').read_text())['cases']}
FIREFOX, STANDARD, PHANTOM = CASES      # by name, in the order of the file
CONNECT = """
(pads) => {
  window.pads = pads.map((pad, index) => pad && ({ ...pad, index, connected: true,
    buttons: Array.from({ length: pad.buttons }, (_, i) => ({ pressed: pad.held.includes(i) })) }));
  navigator.getGamepads = () => window.pads;
}
"""
# Of the kind of the file's: the trigger of another driver, which rests at +1, is the mission's x.
WHEEL = {'id': '046d-c29b-wheel', 'mapping': '', 'axes': [0, 1, 1, 1, 0.02], 'buttons': 20,
         'held': [4, 0]}


@pytest.fixture(scope='module')
def console():
    made = WaitingConsole()
    yield made
    made.close()


@pytest.fixture()
def page(browser, console):
    made = open_page(browser, console, look='plain')
    yield made
    assert made.problems == []
    made.close()


def connect(page, *pads):
    page.evaluate(CONNECT, list(pads))
    page.wait_for_timeout(120)


def pads_of(name):
    pad = CASES[name]['pad']
    return pad if isinstance(pad, list) else [pad]


def push(page, script):
    page.evaluate(script)
    page.wait_for_timeout(120)
    return page.evaluate('rvd.stick.state()')


def text(page, selector='#dialog'):
    return page.inner_text(selector)


@pytest.mark.parametrize('pad', [pads_of(FIREFOX)[0], WHEEL], ids=['xbox', 'wheel'])
def test_a_pad_without_a_standard_mapping_flies_only_when_it_has_been_set_up(page, pad):
    connect(page, pad)
    trigger = max(range(len(pad['axes'])), key=lambda i: abs(pad['axes'][i]))
    rest, sticks = pad['axes'][trigger], [i for i, v in enumerate(pad['axes']) if abs(v) < 0.1][:2]
    state = push(page, f'pads[0].axes[{sticks[0]}] = 1')
    assert state['at'] == [0, 0, 0] and page.evaluate('rvd.stick.source') == 'keyboard'
    assert 'must be set up' in text(page, '#notes')
    push(page,
         f'pads[0].axes[{sticks[0]}] = 0; pads[0].buttons.forEach((b) => (b.pressed = false))')

    page.keyboard.press('g')
    assert 'no standard mapping' in text(page) and 'does not fly' in text(page)
    page.click('#pad-start')
    page.click('#pad-next')
    assert 'forward (x)' in text(page, '#pad-lead')
    push(page, f'pads[0].axes[{trigger}] = {-rest}')            # a trigger is no axis of a stick
    assert 'does not rest at 0' in text(page, '#pad-lead')
    push(page, f'pads[0].axes[{trigger}] = {rest}; pads[0].axes[{sticks[1]}] = -0.9')
    push(page, f'pads[0].axes[{sticks[1]}] = 0')
    assert 'up (y)' in text(page, '#pad-lead')
    push(page, f'pads[0].axes[{sticks[0]}] = 0.9')
    push(page, f'pads[0].axes[{sticks[0]}] = 0')
    page.click('#pad-skip')                                     # it has no third
    assert 'Press the button' in text(page, '#pad-lead')
    push(page, 'pads[0].buttons[7].pressed = true')
    assert 'is set up' in text(page)
    push(page, 'pads[0].buttons[7].pressed = false')
    page.keyboard.press('Escape')

    for _ in range(2):                                          # the second time as remembered
        push(page, 'pads[0].buttons[7].pressed = true')
        state = push(page, f'pads[0].axes[{sticks[1]}] = -1; pads[0].axes[{sticks[0]}] = -1')
        assert state == {'held': True, 'at': [1, -1, 0]}
        page.reload()
        until(page, 'window.rvd?.store.connected')
        connect(page, {**pad, 'held': []})


def test_a_standard_pad_flies_with_the_axes_of_the_mission(page):
    connect(page, *pads_of(STANDARD))
    state = push(page, 'pads[0].axes = [0, -1, 0.5, 0]')
    assert state['held'] and state['at'] == [1, 0, pytest.approx(0.42 / 0.92)]
    page.keyboard.press('g')
    page.wait_for_timeout(150)
    assert '0.00 −1.00 0.50 0.00 · pressed 4' in text(page)
    assert text(page, '[data-now=x]') == '+3' and text(page, '[data-now=y]') == '0'


@pytest.mark.parametrize('pads', [pads_of(PHANTOM), [*pads_of(STANDARD), None, WHEEL]],
                         ids=['phantom', 'two'])
def test_of_several_pads_none_is_taken_before_the_pilot_chooses_and_the_choice_is_remembered(
        page, pads):
    connect(page, *pads)
    real = next(i for i, pad in enumerate(pads) if pad and pad['mapping'] == 'standard')
    state = push(page, f'pads[{real}].axes[1] = -1')
    assert state['at'] == [0, 0, 0] and 'choose one' in text(page, '#notes')
    push(page, f'pads[{real}].axes[1] = 0')
    page.keyboard.press('g')
    page.wait_for_timeout(150)
    for pad in filter(None, pads):
        assert pad['id'] in text(page)
    assert '−1.00 −1.00 −1.00 −1.00' in text(page) or '0.00 1.00 1.00 1.00 0.02' in text(page)
    page.click(f'label:has-text("{pads[real]["id"]}") input')
    page.keyboard.press('Escape')
    page.reload()
    until(page, 'window.rvd?.store.connected')
    connect(page, *reversed(pads))                              # and not by where it stands
    real = len(pads) - 1 - real
    assert push(page, f'pads[{real}].axes[1] = -1')['at'] == [1, 0, 0]
    assert text(page, '#notes') == ''


@pytest.mark.parametrize('axis, name', [(1, 'x'), (2, 'z')])
def test_an_axis_that_is_not_at_rest_when_the_stick_is_taken_does_not_fly(page, axis, name):
    at = 'xyz'.index(name)
    connect(page, {**pads_of(STANDARD)[0], 'held': []})
    push(page, f'pads[0].axes[{axis}] = -1')
    page.keyboard.press('t')
    until(page, "rvd.store.status.lease === 'you'")
    assert push(page, 'pads[0].buttons[4].pressed = true') == {'held': True, 'at': [0, 0, 0]}
    page.wait_for_timeout(200)
    assert f'NOT AT REST: {name}' in text(page, '#stick-state')
    assert push(page, 'pads[0].axes[3] = -1')['at'][1] == 1     # the others fly
    push(page, f'pads[0].axes[{axis}] = 0.03')
    assert abs(push(page, f'pads[0].axes[{axis}] = -1')['at'][at]) == 1
    page.keyboard.press('t')
    until(page, "rvd.store.status.lease === 'free'")
    page.keyboard.press('t')                                    # taken again, still deflected
    until(page, "rvd.store.status.lease === 'you'")
    assert page.evaluate('rvd.stick.state().at') == [0, 0, 0]
    assert 'GAMEPAD GONE' not in text(page, '#stick-state')
    assert not push(page, 'pads.length = 0')['held']            # unplugged: no pilot
    page.wait_for_timeout(200)
    assert 'GAMEPAD GONE' in text(page, '#stick-state')
    page.keyboard.down('w')
    assert page.evaluate('rvd.stick.state()')['held']
    page.keyboard.up('w')
    page.keyboard.press('t')
    until(page, "rvd.store.status.lease === 'free'")


def test_what_was_remembered_and_makes_no_sense_is_as_if_nothing_had_been(page):
    for stored in ('{"pads": {"Xbox (STANDARD GAMEPAD)": {"axes": {"x": {"axis": "a"}}}}}', '[',
                   '7',
                   '{"chosen": 3, "pads": [null], "deadZone": "wide"}', 'null'):
        page.evaluate('(text) => localStorage.setItem("rvd.stick", text)', stored)
        page.reload()
        until(page, 'window.rvd?.store.connected')
        connect(page, *pads_of(STANDARD))
        assert push(page, 'pads[0].axes[1] = -1')['at'] == [1, 0, 0]
