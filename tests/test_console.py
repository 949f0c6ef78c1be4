"""
The console end to end: the real graph, the real page in a headless browser, keys and gamepads.
"""

import urllib.error
import urllib.request

import pytest
from console_page import Console, fly_by_keys, open_page, serious, take_and_start, until
from runs import messages, rvd, verdict_of, wait_for

pytestmark = pytest.mark.slow
STEP_NS = 500_000_000           # of the scenario `barrier`
PARTS = ('chaser', 'ghost', 'corridor', 'station')
PAD = """
(() => {
  const pad = { id: 'stub', index: 0, mapping: 'standard', connected: true, axes: [0, 0, 0, 0],
    buttons: Array.from({ length: 8 }, () => ({ pressed: false, value: 0 })) };
  window.pad = pad;
  navigator.getGamepads = () => [pad];
})();
"""


@pytest.fixture(autouse=True)
def no_page_is_left(browser):
    yield
    for context in browser.contexts:
        context.close()


@pytest.fixture(scope='module')
def console(tmp_path_factory, browser):
    made = Console(tmp_path_factory.mktemp('console'), 'barrier', '--pace', '10', '--seed', '3')
    yield made
    made.close()


@pytest.fixture(scope='module')
def flown(console, browser):
    """A flight by keys, and what was seen on the way."""
    other = open_page(browser, console, look='plain')
    page = open_page(browser, console)
    take_and_start(page)
    until(page, 'rvd.store.frame && rvd.store.frame.t > 15')
    other.keyboard.press('t')
    until(other, 'Boolean(rvd.store.frame)')
    seen = {'other': other.evaluate('rvd.store.status.lease'),
            'other_frames': other.evaluate('rvd.store.frame.k'),
            'truth': page.evaluate("JSON.stringify(rvd.store.frame).includes('truth')"),
            'pixels': {part: page.evaluate(f"rvd.scene.covers('{part}')") for part in PARTS}}
    other.close()
    fly_by_keys(page)
    until(page, "document.querySelector('#verdict-words') !== null")
    seen['verdict'] = page.inner_text('#verdict-words')
    seen['problems'] = page.problems
    seen['run'] = console.folder / 'runs' / page.evaluate('rvd.store.status.run')
    until(page, "rvd.store.status.phase === 'ended'")
    wait_for(lambda: (seen['run'] / 'verdict.json').exists(), 'verdict.json')
    page.close()
    return seen


def test_a_flight_by_keys_docks_and_the_page_says_so(flown):
    assert 'Docked' in flown['verdict']
    assert verdict_of(flown['run'])['success']
    assert flown['problems'] == []


def test_chaser_ghost_corridor_and_station_are_really_drawn(flown):
    assert all(n > 20 for n in flown['pixels'].values()), flown['pixels']


def test_the_truth_is_not_in_what_a_live_page_gets(flown):
    assert not flown['truth']


def test_a_second_pilot_is_refused_and_watches(flown):
    assert flown['other'] == 'other'
    assert flown['other_frames'] > 0


def test_the_recorded_stick_is_a_tape(flown):
    from rvd_groundstation.operators.tape import read_tape
    tape = read_tape(flown['run'] / 'bag')
    assert any(any(abs(a) > 0.3 for a in axes) for axes in tape.axes)
    assert any(buttons[4] for buttons in tape.buttons)
    pilot = [m for m in messages(flown['run'], '/ground/command') if m.decided_by == 3]
    assert any(any(m.levels) for m in pilot)


def test_a_recorded_run_is_reviewed_with_its_truth(flown, console, browser):
    page = open_page(browser, console)
    page.keyboard.press('l')
    page.click(f'[data-run="{flown["run"].name}"]')
    until(page, 'rvd.review.on')
    last = page.evaluate('rvd.review.run.frames.filter((f) => f.signals.truth).at(-1)')
    truth = messages(flown['run'], '/truth/relative_state')
    there = next(m for m in truth if m.step == last['k'])
    assert last['signals']['truth']['parts']['position'] == pytest.approx(
        [there.position.x, there.position.y, there.position.z], abs=1e-5)
    sent = [f['signals']['/joy']['parts']['value']
            for f in page.evaluate('rvd.review.run.frames') if '/joy' in f['signals']]
    assert any(any(levels) for levels in sent)                          # what the stick said
    page.evaluate('rvd.review.go(40)')
    page.wait_for_timeout(300)
    assert page.evaluate("rvd.scene.covers('truth')") > 10            # it is drawn
    page.keyboard.press('Escape')
    assert not page.evaluate('rvd.review.on')
    page.close()


def test_a_gamepad_flies_only_while_its_dead_man_is_held(console, browser):
    page = open_page(browser, console, look='plain')
    page.add_init_script(PAD)
    page.reload()
    until(page, 'window.rvd?.store.connected')
    page.evaluate('pad.buttons[4].pressed = true')
    page.wait_for_timeout(100)
    page.evaluate('pad.axes[2] = 1')
    page.wait_for_timeout(100)
    state = page.evaluate('rvd.stick.state()')
    assert state['held'] and state['at'] == [0, 0, pytest.approx(1.0)]
    page.evaluate('pad.axes[2] = 0.07')          # inside the dead zone
    assert page.evaluate('rvd.stick.state().at') == [0, 0, 0]
    page.evaluate('pad.buttons[4].pressed = false')
    assert not page.evaluate('rvd.stick.state().held')
    page.close()


def test_a_lost_page_is_a_lost_pilot_and_abort_needs_no_lease(console, browser):
    watcher = open_page(browser, console, look='plain')
    page = open_page(browser, console, look='plain')
    take_and_start(page, 'shared', 8)
    until(page, 'rvd.store.frame.t > 12')
    run = console.folder / 'runs' / page.evaluate('rvd.store.status.run')
    page.close()                                # mid-flight
    until(watcher, 'rvd.store.status.pilot_lost')
    until(watcher, "document.querySelector('#banner').textContent.includes('PILOT LOST')")
    until(watcher, 'rvd.store.sent.parts.reason === 9')         # stick invalid: automatic alone
    watcher.keyboard.press('x')
    watcher.keyboard.press('x')
    until(watcher, 'rvd.store.abortAt !== null')
    until(watcher, "document.querySelector('#banner').textContent.includes('ABORTED')")
    watcher.keyboard.press('t')
    until(watcher, "rvd.store.status.lease === 'you'")
    watcher.evaluate("(() => { rvd.link.ask({ do: 'stop' }); })()")
    until(watcher, "rvd.store.status.phase === 'ended'")
    wait_for(lambda: (run / 'verdict.json').exists(), 'verdict.json')   # the bag is closed
    frames = [m for m in messages(run, '/onboard/command') if not m.empty]
    first = next(m for m in frames if m.expedited)
    acts = next(m for m in messages(run, '/onboard/thruster_command') if m.kind == 3)
    assert 0 <= first.released - first.arrived < STEP_NS        # skips the play-out buffer,
    assert acts.step == first.step                              # acts in the step it arrives in
    assert any(m.released - m.arrived >= STEP_NS for m in frames if not m.expedited)
    assert list(acts.levels) == [-3, 0, 0]
    assert any(m.code == 'PILOT_LOST' for m in messages(run, '/run/events'))
    watcher.close()


def test_pause_stops_simulation_time_and_resume_goes_on(console, browser):
    page = open_page(browser, console, look='plain')
    take_and_start(page, 'auto', 9)
    until(page, 'rvd.store.frame.t > 5')
    page.keyboard.press('p')
    until(page, 'rvd.store.frame.paused')
    page.wait_for_timeout(300)
    before = page.evaluate('rvd.store.frame.k')
    page.wait_for_timeout(700)
    assert page.evaluate('rvd.store.frame.k') == before
    assert page.inner_text('#banner') == 'PAUSED'
    page.keyboard.press('m')
    until(page, "rvd.store.frame.mode === 'manual'")
    page.keyboard.press('p')
    until(page, f'rvd.store.frame.k > {before} + 5')
    until(page, 'rvd.store.sent.parts.reason === 8 || rvd.store.sent.parts.by === 1')
    page.evaluate("(() => { rvd.link.ask({ do: 'stop' }); })()")
    until(page, "rvd.store.status.phase === 'ended'")
    page.close()


def test_strangers_are_refused(console):
    def code(path: str, **headers: str) -> int:
        request = urllib.request.Request(f'http://{console.address}{path}', headers=headers)
        try:
            with urllib.request.urlopen(request, timeout=10) as answer:
                return answer.status
        except urllib.error.HTTPError as error:
            return error.code
    good = f'Bearer {console.token}'
    assert code('/') == 200
    assert code('/', Host='evil.example') == 403
    assert code('/', Origin='http://evil.example') == 403
    assert code('/api/runs') == 403
    assert code('/api/runs', Authorization='Bearer no') == 403
    assert code('/api/runs', Authorization=good) == 200
    assert code('/api/runs/..%2f..%2fetc', Authorization=good) == 404


@pytest.mark.parametrize('args, words', [
    (('--bind', '192.168.1.4'), 'needs TLS'), (('--bind', '0.0.0.0'), 'give the one address'),
    (('--bind', '127.0.0.2', '--tls-cert', 'no.pem', '--tls-key', 'no.pem'), 'no.pem'),
    (('--port', '99999'), 'port must be 0 to 65535'),
    (('--session', 'none.yaml', '--out', 'x'), 'cannot read session none.yaml')])
def test_what_the_console_cannot_do_is_one_line(tmp_path, args, words):
    done = rvd('fly', '--operator', 'console', *args, cwd=tmp_path)
    assert done.returncode == 2
    assert words in done.stderr and done.stderr.count('\n') == 1


def test_axe_finds_nothing_serious(console, browser, console_web):
    page = open_page(browser, console, look='plain', bypass_csp=True)
    page.keyboard.press('Escape')
    for dialog in (None, '#open-help', '#open-settings'):
        if dialog:
            page.click(dialog)
        assert serious(page, console_web) == []
        page.keyboard.press('Escape')
    page.close()
