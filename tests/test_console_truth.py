"""
What the page says of the line, the stick and who flies, without a graph: a cart on a rail.

The real server and a real browser; the cart's commands say whatever decision a test wants.
"""

import re
import socket
import time

import pytest
from console_page import open_page, until
from toy_console import STEP_S, ToyConsole, WaitingConsole

pytestmark = pytest.mark.slow
NO_STICK, NO_PILOT = 9, 11              # reasons
LIGHT_S = 30.0                          # [s] a loaded machine may take for what a page does at once


@pytest.fixture(autouse=True)
def no_page_is_left(browser):
    yield
    for context in browser.contexts:
        context.close()


@pytest.fixture()
def toy():
    made = ToyConsole()
    yield made
    made.close()


def words(page, selector='#banner'):
    return page.inner_text(selector)


def says(text, selector='#banner'):
    return f"document.querySelector('{selector}').textContent.includes('{text}')"


def flying(browser, toy, **options):
    """Return a page that has the stick of the cart, under way."""
    page = open_page(browser, toy, look='plain', **options)
    until(page, 'Boolean(rvd.store.measured)')
    page.keyboard.press('t')
    until(page, "rvd.store.status.lease === 'you'")
    return page


# -- who flies ------------------------------------------------------------------------------

@pytest.mark.parametrize('mode, by, reason, said', [
    ('manual', 0, NO_STICK, 'nobody flies'),
    ('shared', 2, NO_STICK, 'the automatic controller flies alone'),
    ('shared', 0, NO_PILOT, 'nobody flies')])
def test_a_lost_stick_says_who_flies_by_what_was_decided(browser, toy, mode, by, reason, said):
    """In the line of the stick, in the banner of a lost pilot, and below the commands."""
    other = open_page(browser, toy, look='plain')
    page = flying(browser, toy)
    toy.decision = {'by': by, 'reason': reason}
    toy.hub.feed.mode = mode
    until(page, says(said, '#why'))
    page.evaluate("rvd.stick.change({ holdSpace: true })")      # and the dead-man is open
    until(page, says(f'DEAD-MAN OPEN: {said}', '#stick-state'))
    page.close()
    until(other, says(f'PILOT LOST: {said}'))
    for text in (words(other), words(other, '#why')):
        assert ('automatic controller flies' in text) == (by == 2), text
    assert other.problems == []


def test_who_flies_is_not_told_of_before_it_has_been_decided(browser, toy):
    """The newest command is still the pilot's when his page goes."""
    other = open_page(browser, toy, look='plain')
    toy.decision = {'by': 1, 'reason': 8}
    page = flying(browser, toy)
    page.close()
    until(other, says('PILOT LOST'))
    assert words(other) == 'PILOT LOST'
    toy.decision = {'by': 0, 'reason': NO_STICK}
    until(other, says('PILOT LOST: nobody flies'))


# -- dialogs --------------------------------------------------------------------------------

@pytest.mark.parametrize('key', ['?', 'g', 'l', 'n'])
def test_an_open_dialog_releases_the_stick_and_says_so(browser, toy, key):
    page = flying(browser, toy)
    page.keyboard.down('d')
    until(page, 'rvd.stick.state().at[0] === 1')
    toy.decision = {'by': 0, 'reason': NO_STICK}
    toy.hub.feed.mode = 'manual'
    page.keyboard.press(key)
    until(page, "document.querySelector('#dialog').open")
    until(page, '!rvd.stick.state().held')
    until(page, says('STICK RELEASED while'))
    until(page, says('nobody flies'))
    assert 'STICK RELEASED' in words(page, '#dialog') and 'nobody flies' in words(page, '#dialog')
    deadline = time.monotonic() + LIGHT_S
    while toy.sticks[-1] != ([0.0], False):     # what is published
        assert time.monotonic() < deadline
        page.wait_for_timeout(20)
    page.keyboard.press('Escape')
    until(page, "!document.querySelector('#dialog').open")
    until(page, 'rvd.stick.state().held')       # and flies on
    assert page.evaluate('rvd.stick.state().at') == [0]         # the key is to be pressed anew
    until(page, '!' + says('STICK RELEASED'))
    page.keyboard.up('d')
    page.keyboard.down('d')
    until(page, 'rvd.stick.state().at[0] === 1')
    assert page.problems == []


def test_a_dialog_of_who_watches_says_nothing_of_a_stick(browser, toy):
    page = open_page(browser, toy, look='plain')
    until(page, 'Boolean(rvd.store.measured)')
    page.keyboard.press('?')
    page.wait_for_timeout(500)
    assert 'STICK' not in words(page) and 'RELEASED' not in words(page, '#dialog')


def test_the_keys_of_a_dialog_do_what_it_says(browser, toy):
    toy.hub._ask = lambda wish: None            # somebody flies again
    page = flying(browser, toy)
    toy.finish()
    until(page, "document.querySelector('#verdict-words') !== null")
    assert 'Fly again (N)' in words(page, '#dialog')
    page.keyboard.press('n')
    until(page, "document.querySelector('#new-start') !== null")
    page.keyboard.press('Escape')
    assert not page.evaluate("document.querySelector('#dialog').open")
    page.keyboard.press('?')
    assert words(page, '#dialog h3') == 'Keys'
    page.keyboard.press('?')
    assert not page.evaluate("document.querySelector('#dialog').open")
    page.keyboard.press('?')
    page.keyboard.press('g')                    # as the list says
    assert words(page, '#dialog h3') == 'The stick'
    page.keyboard.press('n')                    # which that dialog does not offer
    assert words(page, '#dialog h3') == 'The stick'
    assert page.problems == []


# -- the line -------------------------------------------------------------------------------

GREY = """() => getComputedStyle(document.querySelector('#instruments')).filter"""


def test_a_server_that_falls_silent_greys_all_within_a_second_and_its_age_counts(browser, toy):
    page = flying(browser, toy)
    assert page.evaluate(GREY) == 'none'
    page.evaluate('''(() => {
        new MutationObserver(() => {
            if (document.body.classList.contains('dead')) window.deadAt ??= rvd.store.line.age();
        }).observe(document.body, { attributes: true }); })()''')
    after = []
    while len(after) < 5 and not (after and min(after) < 1.0):      # a busy machine gets more tries
        page.evaluate('window.deadAt = null')
        with toy.silent():
            until(page, 'window.deadAt !== null')
        after.append(page.evaluate('window.deadAt'))
        until(page, "!document.body.classList.contains('dead')")
    assert 0.5 < min(after) < 1.0, after
    with toy.silent():
        until(page, "document.body.classList.contains('dead')")
        assert 'grayscale' in page.evaluate(GREY)
        assert not page.evaluate('rvd.store.connected')
        assert 'NOTHING HEARD' in words(page, '#socket-state')
        until(page, says('STICK NOT HEARD', '#stick-state'))
        assert 'connected' not in words(page, '#socket-state')
        until(page, says('nothing heard for 2 s'))
        ages = []
        for _ in range(2):
            ages.append(float(re.search(r'age ([\d.]+) s', words(page, '#clock-gen-age'))[1]))
            page.wait_for_timeout(700)
        # 1.5 s of silence, rounded, and the 0.5 s of the link
        assert ages[0] >= 2.0 and ages[1] > ages[0] + 0.3
    until(page, 'rvd.store.connected')
    until(page, "!document.body.classList.contains('dead')")
    until(page, '!' + says('nothing heard'))
    assert page.evaluate(GREY) == 'none'
    assert page.problems == []


def test_a_page_that_is_idle_hears_that_the_server_lives(browser):
    waiting = WaitingConsole()
    try:
        page = open_page(browser, waiting, look='plain')
        page.wait_for_timeout(2500)
        assert page.evaluate('rvd.store.connected') and 'Ready' in words(page)
        with waiting.silent():
            until(page, says('NO CONNECTION'))
        until(page, says('Ready'))
    finally:
        waiting.close()


def test_a_run_that_makes_no_step_greys_too(browser, toy):
    page = flying(browser, toy)
    toy.stands = True
    until(page, says('NO DATA FOR'))
    assert page.evaluate('rvd.store.connected')
    assert 'grayscale' in page.evaluate(GREY)
    toy.stands = False
    until(page, "!document.body.classList.contains('dead')")


# -- tokens ---------------------------------------------------------------------------------

def free_port():
    with socket.socket() as one:
        one.bind(('127.0.0.1', 0))
        return one.getsockname()[1]


@pytest.fixture()
def again(tmp_path, monkeypatch):
    """Return what starts a console at one port again and again; tokens are kept in `tmp_path`."""
    monkeypatch.setenv('XDG_RUNTIME_DIR', str(tmp_path))
    tmp_path.chmod(0o700)
    number, made = free_port(), []

    def start(kind=ToyConsole):
        made.append(type('Again', (kind,), {'port': number})())
        return made[-1]
    yield start
    for one in made:
        one.close()


def test_a_page_comes_back_by_itself_to_a_server_that_was_started_anew(browser, again, tmp_path):
    first = again()
    page = flying(browser, first)
    first.close()
    until(page, says('NOT CONNECTED: no server for'))
    assert 'NOT CONNECTED' in words(page, '#socket-state')
    second = again()
    assert second.url == first.url
    until(page, 'rvd.store.connected')
    until(page, 'rvd.store.frame && rvd.store.frame.t < 3')         # of the new run
    second.close()
    until(page, '!rvd.store.connected')
    third = again(WaitingConsole)               # where nothing is flown
    until(page, 'rvd.store.connected')
    until(page, says('Ready'))
    assert page.evaluate('rvd.store.frame') is None
    rows = page.query_selector_all('#instruments .row')
    assert all(not re.search(r'\d', row.query_selector('b').inner_text()) for row in rows)
    third.close()


def test_no_token_a_wrong_one_and_a_lost_server_say_different_things(browser, again, tmp_path):
    first = again()
    page = open_page(browser, first, look='plain')
    base = first.url.split('#')[0]
    bare = browser.new_context().new_page()
    bare.goto(base)
    until(bare, says('No token'))
    assert 'Ready' not in words(bare) and 'NO TOKEN' in words(bare, '#socket-state')
    assert bare.evaluate('rvd.link') is None
    wrong = browser.new_context().new_page()
    wrong.goto(f'{base}#AAAAAAAAAAAAAAAAAAAAAA')
    until(wrong, says('WRONG TOKEN'))
    assert 'WRONG TOKEN' in words(wrong, '#socket-state')
    assert not wrong.evaluate('rvd.store.connected')
    with wrong.expect_event('load'):            # the right one, in the same tab
        wrong.goto(first.url)
    until(wrong, 'window.rvd?.store.connected')
    first.close()
    until(page, says('NOT CONNECTED: no server for'))
    for file in (tmp_path / 'rvd-console').glob('*.json'):
        file.unlink()
    second = again()                            # with another token
    assert second.url != first.url
    until(page, says('WRONG TOKEN'))
    assert not any('NOT CONNECTED' in words(page, one) for one in ('#banner', '#socket-state'))


def test_a_page_does_not_show_its_token_to_who_has_taken_the_place_of_its_server(browser, again):
    """A server that cannot prove that it knows the token is not told it."""
    first = again()
    page = open_page(browser, first, look='plain')
    first.close()
    until(page, '!rvd.store.connected')
    other = again(Impostor)
    until(page, says('WRONG TOKEN'))
    page.wait_for_timeout(2500)
    assert other.asked_for_proof >= 2 and other.shown == []


class Impostor(ToyConsole):
    """Answers whatever it is asked for a proof."""

    asked_for_proof, shown = 0, []

    async def _serve(self, up):
        from aiohttp import web

        async def proof(request):
            self.asked_for_proof += 1
            return web.json_response(['0' * 64])

        async def ws(request):
            self.shown.append(request.headers['Sec-WebSocket-Protocol'])
            return web.Response(status=403)
        app = web.Application()
        app.add_routes([web.get('/api/proof', proof), web.get('/ws', ws)])
        runner = web.AppRunner(app)
        await runner.setup()
        await web.TCPSite(runner, '127.0.0.1', self.port).start()
        self.url = ''
        up.set()
        await self._over.wait()
        await runner.cleanup()


# -- who watches ----------------------------------------------------------------------------

def test_a_watchers_token_never_flies_steers_or_aborts_and_the_page_says_so(browser, toy):
    toy.hub._ask = lambda wish: None
    page = open_page(browser, toy, look='plain', url=toy.watch_url)
    until(page, 'Boolean(rvd.store.measured)')
    assert page.is_disabled('#abort') and page.is_disabled('#lease')
    assert 'not from here' in words(page, '#abort') and words(page, '#lease') == 'Watching only'
    for key in ('x', 'x', 't', 'p', 'm'):
        page.keyboard.press(key)
    page.keyboard.press('n')
    assert 'watches only' in words(page, '#dialog')
    for wish in ('abort', 'take', 'pause', 'mode', 'fly', 'stop', 'quit', 'desk'):
        reply = page.evaluate(f"rvd.link.ask({{ do: '{wish}', mode: 'auto' }}, 5000)")
        assert not reply['ok'] and reply['code'] in ('WATCH', 'MODE'), wish
    assert toy.asked == [] and toy.hub.lease.holder is None
    pilot = flying(browser, toy)                # with the other one all of it goes
    assert pilot.evaluate("rvd.link.ask({ do: 'abort' }, 5000)")['ok']
    assert toy.asked == ['abort'] and page.problems == []


@pytest.mark.parametrize('state', ['paused', 'ended'])
def test_who_joins_in_a_pause_or_after_the_end_gets_the_last_picture(browser, toy, state):
    page = flying(browser, toy)
    if state == 'paused':
        page.keyboard.press('p')
        until(page, 'rvd.store.frame.paused')
    else:
        toy.finish()
        until(page, 'Boolean(rvd.store.verdict)')
    toy.stands = True
    page.wait_for_timeout(round(3000 * STEP_S))
    last = page.evaluate('rvd.store.frame.k')
    late = open_page(browser, toy, look='plain', url=toy.watch_url)
    until(late, f'rvd.store.frame?.k === {last}')
    until(late, says('PAUSED' if state == 'paused' else 'Arrived at the buffer'))
    assert late.evaluate('rvd.store.measured.parts.x') is not None
    assert re.search(r'\d', late.query_selector('#instruments .row b').inner_text())
    assert late.problems == []


def test_before_telemetry_the_camera_shows_nothing(browser):
    """The lunar approach before its first run: a picture of one colour, and words."""
    waiting = WaitingConsole()
    try:
        page = open_page(browser, waiting)
        until(page, "Boolean(rvd.store.display) && rvd.scene.drawn > 3")
        assert page.evaluate(COLOURS) == 1
    finally:
        waiting.close()


COLOURS = """(() => {
    rvd.scene.draw();
    const { renderer, places: { camera } } = rvd.scene;
    const gl = renderer.getContext(), ratio = renderer.getPixelRatio();
    const [x, y, w, h] = [camera.left, camera.bottom, camera.width, camera.height].map(
        (v) => Math.round(v * ratio));
    const data = new Uint8Array(4 * (w - 4) * (h - 4));
    gl.readPixels(x + 2, y + 2, w - 4, h - 4, gl.RGBA, gl.UNSIGNED_BYTE, data);
    const seen = new Set();
    for (let i = 0; i < data.length; i += 4) {
        seen.add(data[i] << 16 | data[i + 1] << 8 | data[i + 2]);
    }
    return seen.size;
})()"""


# -- the browser's log ----------------------------------------------------------------------

def logged(page):
    """Return a list that gets what the browser logs of a page and its worker, and its issues."""
    found = []
    session = page.context.new_cdp_session(page)
    session.on('Log.entryAdded', lambda e: found.append(e['entry']['text']))
    session.on('Audits.issueAdded', lambda e: found.append(str(e['issue'])))
    page.on('console', lambda m: found.append(m.text))
    page.on('pageerror', lambda error: found.append(str(error)))
    for part in ('Log', 'Audits'):
        session.send(f'{part}.enable')
    return found


@pytest.mark.parametrize('kind', [ToyConsole, WaitingConsole])
def test_the_browser_logs_nothing_of_any_dialog_under_the_policy(browser, kind):
    toy = kind()
    try:
        page = browser.new_page()
        log = logged(page)
        page.goto(toy.url)
        until(page, 'Boolean(window.rvd?.store.connected && rvd.store.display)')
        page.keyboard.press('t')
        for key in '?gnlvm':
            page.keyboard.press(key)
            page.wait_for_timeout(150)
            page.keyboard.press('Escape')
        if kind is ToyConsole:
            toy.finish()
            until(page, "document.querySelector('#verdict-words') !== null")
        assert [line for line in log if 'GPU stall' not in line] == []
        page.evaluate("document.body.insertAdjacentHTML('beforeend', '<p style=\"color: red\">')")
        deadline = time.monotonic() + LIGHT_S
        while not any('Content Security Policy' in line for line in log):
            assert time.monotonic() < deadline, 'the log would not have told'
            page.wait_for_timeout(50)
    finally:
        toy.close()
