#!/usr/bin/env python3
"""
Make the pictures of the console in docs/images: a flight by keys, and its review; missions watched.

    ./rvd shell scripts/console_pictures.py             # the lunar approach, flown by keys
    ./rvd shell scripts/console_pictures.py docking     # a mission that is watched
    ./rvd shell scripts/console_pictures.py tether
    ./rvd shell scripts/console_pictures.py tether_delay    # ordered by the buttons GO and HOLD

Needs playwright and Chromium, like the browser tests, whose scripted pilot flies here.
"""

import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path.insert(0, str(ROOT / 'tests'))

from console_page import (                      # noqa: E402
    chromium, Console, FLAGS, fly_by_keys, open_page, playwright, take_and_start, until)

SIZE = {'width': 1280, 'height': 720}
SHARP = ('(() => { Object.assign(rvd.scene, {adaptive: false, quality: 2}); '
         'rvd.scene.resize(); })()')
FAST = SHARP.replace('quality: 2', 'quality: 0.5')


# Of a mission that is watched: when the live picture is taken, and where the review stands [s];
# what is written into the forms before.
WATCHED = {'docking': (40.0, 8.0, {'/** timeout_s': '100'}), 'tether': (60.0, 14.0, {})}
TALL = {'width': 1280, 'height': 800}


def main(mission: str = '') -> None:
    """Fly and take the pictures."""
    images = ROOT / 'docs' / 'images'
    images.mkdir(exist_ok=True)
    if mission == 'tether_delay':
        ordered(images)
    elif mission:
        watched(mission, images)
    else:
        by_keys(images)


def watched(mission: str, images: Path) -> None:
    """Watch a mission: its settings, if it has forms, a moment of the run, one of the review."""
    live_s, review_s, wishes = WATCHED[mission]
    console = Console(Path(tempfile.mkdtemp()), mission, '--pace', 'lockstep', '--processes', 'one',
                      '--seed', '1')
    try:
        with playwright()() as play:
            browser = play.chromium.launch(executable_path=chromium(), args=FLAGS)
            page = open_page(browser, console, look='fine')
            page.set_viewport_size(TALL)
            page.keyboard.press('t')
            until(page, "rvd.store.status.lease === 'you'")
            page.keyboard.press('n')
            for key, text in wishes.items():
                page.fill(f'[data-setting="{key}"]', text)
            page.evaluate(FAST)
            if wishes:
                page.wait_for_timeout(500)
                page.screenshot(path=images / f'{mission}-console-forms.png')
            page.click('#new-start')
            until(page, f'rvd.store.frame?.t > {live_s} || Boolean(rvd.store.verdict)', 600.0)
            page.evaluate(SHARP)
            page.wait_for_timeout(700)
            page.screenshot(path=images / f'{mission}-console.png')
            page.evaluate(FAST)
            until(page, 'Boolean(rvd.store.verdict)', 600.0)
            until(page, "rvd.store.status.phase === 'ended'", 120.0)
            page.keyboard.press('Escape')
            page.keyboard.press('l')
            page.click('[data-run]')
            until(page, 'rvd.review.on', 120.0)
            page.evaluate('rvd.review.go(rvd.review.run.frames.findIndex('
                          f'(f) => f.t > {review_s}))')
            page.evaluate(SHARP)
            page.wait_for_timeout(2500)
            page.screenshot(path=images / f'{mission}-console-review.png')
            browser.close()
    finally:
        console.close()


def ordered(images: Path) -> None:
    """Order GO, and HOLD when 62 m are shown: a moment after it, while the craft still flies."""
    console = Console(Path(tempfile.mkdtemp()), 'tether_delay', '--mode', 'hold', '--pace', '1',
                      '--seed', '1', '--processes', 'segments')
    try:
        with playwright()() as play:
            browser = play.chromium.launch(executable_path=chromium(), args=FLAGS)
            page = open_page(browser, console, look='fine')
            page.set_viewport_size(TALL)
            page.evaluate(FAST)
            page.keyboard.press('t')
            until(page, "rvd.store.status.lease === 'you'")
            page.keyboard.press('n')
            page.click('#new-start')
            until(page, 'Boolean(rvd.store.measured)')
            page.keyboard.press('f')
            until(page, 'rvd.store.frame.signals.derived.parts.does?.[1] === 1', 120.0)   # it flies
            until(page, "rvd.store.frame.signals['/ground/situation'].parts.range < 62", 120.0)
            page.keyboard.press('h')
            page.evaluate(SHARP)
            page.wait_for_timeout(900)
            page.screenshot(path=images / 'tether_delay-console.png')
            browser.close()
    finally:
        console.close()


def by_keys(images: Path) -> None:
    """Fly the lunar approach by keys."""
    console = Console(Path(tempfile.mkdtemp()), 'hand', '--pace', '1', '--seed', '12')
    try:
        with playwright()() as play:
            browser = play.chromium.launch(executable_path=chromium(), args=FLAGS)
            page = open_page(browser, console, look='fine')
            page.set_viewport_size(SIZE)
            take_and_start(page, 'shared')
            fly_by_keys(page, over='rvd.store.frame.t > 62')
            page.evaluate(SHARP)
            page.wait_for_timeout(1500)
            page.screenshot(path=images / 'console-flight.png')
            page.evaluate(FAST)
            fly_by_keys(page, over='rvd.store.frame.t > 100')
            until(page, 'Boolean(rvd.store.verdict)', 120.0)
            until(page, "rvd.store.status.phase === 'ended'", 120.0)
            page.evaluate(SHARP)
            page.wait_for_timeout(1500)
            page.screenshot(path=images / 'console-verdict.png')
            page.evaluate(FAST)
            page.keyboard.press('Escape')
            until(page, "!document.getElementById('dialog').open")
            page.keyboard.press('l')
            page.wait_for_selector('[data-run]')
            page.click('[data-run]')
            until(page, 'rvd.review.on')
            page.evaluate('rvd.review.go(Math.round(rvd.review.run.frames.length * 0.72))')
            page.click('[data-view=side]')
            page.evaluate(SHARP)
            page.wait_for_timeout(2500)
            page.screenshot(path=images / 'console-review.png')
            browser.close()
    finally:
        console.close()


if __name__ == '__main__':
    main(*sys.argv[1:2])
