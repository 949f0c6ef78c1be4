#!/usr/bin/env python3
"""
Make the pictures of the console in docs/images: a flight by keys, and its review.

    ./rvd shell scripts/console_pictures.py

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


def main() -> None:
    """Fly and take the pictures."""
    images = ROOT / 'docs' / 'images'
    images.mkdir(exist_ok=True)
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
    main()
