"""
`./rvd bench console`: from a stick in the page to `/joy`, what the bridge costs, 50 watchers.

A real flight in real time with the page drawn by a headless Chromium; this process listens to
`/joy` and matches each message by the number that its frame_id carries with the instant at
which the page sampled the stick. Both clocks are this machine's.
"""

import asyncio
import os
import subprocess
import sys
import tempfile
import time
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rvd_campaign import catalogue
from rvd_campaign.cpu import cpu_s
from rvd_campaign.exits import CannotRun
from rvd_campaign.flight.domain import reserved_domain

WATCHERS = 50
TURNS = 4                       # alone and watched: a p99 of 700 samples moves by a fifth by itself
PART_S = 15.0                   # [s] wall time of each measurement
GOALS = {'stick_p50_ms': 4.0, 'stick_p99_ms': 15.0, 'bridge_percent': 15.0,
         'bundle_bytes': 1_000_000, 'usable_s': 1.0, 'watchers_ratio': 1.2}
# WebGL by software; the page itself is put together as on any machine without a graphics
# processor, not by an emulated one.
FLAGS = ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader',
         '--disable-gpu-compositing', '--disable-quic', '--no-first-run',
         '--disable-background-networking', '--disable-component-update', '--disable-sync']


def measure(quick: bool = False) -> dict[str, Any]:
    """
    Return the figures of the console, alone and watched in turns (shorter when `quick`).

    Raises
    ------
    CannotRun
        If playwright or Chromium is missing, or the flight does not start.
    """
    try:
        from playwright.sync_api import sync_playwright
    except ImportError:
        raise CannotRun('bench console needs playwright: pip install playwright') from None
    browser = _which('chromium', 'chromium-browser', 'google-chrome')
    part_s = PART_S / 3.0 if quick else PART_S
    figures: dict[str, Any] = {'bundle_bytes': bundle_bytes()}
    with reserved_domain() as free:
        domain = int(free)                      # the flight is given it, and we listen there
    with tempfile.TemporaryDirectory() as folder, sync_playwright() as play:
        flying = _start(Path(folder), domain)
        try:
            url = _url(flying, Path(folder))
            chrome = play.chromium.launch(executable_path=browser, args=FLAGS)
            _open(chrome, url)                  # the first one reads Chromium from the disk
            chrome.close()
            chrome = play.chromium.launch(executable_path=browser, args=FLAGS)
            figures.update(_measure(chrome, url, flying.pid, domain, part_s))
            chrome.close()
        finally:
            flying.terminate()
            flying.wait(30.0)
    return figures


def bundle_bytes() -> int:
    """Return the size of the built page."""
    from rvd_groundstation.console.server import STATIC
    return sum(file.stat().st_size for file in STATIC.rglob('*') if file.is_file())


def _which(*names: str) -> str:
    import shutil
    found = next((path for path in map(shutil.which, names) if path), None)
    if found is None:
        raise CannotRun('bench console needs Chromium: apt-get install -y chromium')
    return found


def _start(folder: Path, domain: int) -> subprocess.Popen:
    return subprocess.Popen(
        [sys.executable, '-m', 'rvd_campaign.cli', 'fly', 'hand', '--operator', 'console',
         '--port', '0', '--headless', '--mode', 'auto'], cwd=folder, start_new_session=True,
        stdout=(folder / 'out').open('w'), stderr=subprocess.STDOUT,
        env={**os.environ, 'RVD_ROOT': str(catalogue.root()), 'ROS_DOMAIN_ID': str(domain)})


def _url(flying: subprocess.Popen, folder: Path) -> str:
    for _ in range(300):
        for line in (folder / 'out').read_text().splitlines():
            if line.startswith('open '):
                return line[5:]
        if flying.poll() is not None:
            raise CannotRun('the flight for the benchmark did not start')
        time.sleep(0.1)
    raise CannotRun('the console did not come up')


def _open(chrome: Any, url: str) -> tuple[Any, float]:
    """Return the page and after how many seconds its socket was open and it had a picture."""
    page = chrome.new_page(viewport={'width': 1280, 'height': 720})
    page.goto('about:blank')
    begun = time.monotonic()
    page.goto(url)
    _until(page, 'window.rvd?.store.connected && rvd.scene.drawn > 0')
    return page, time.monotonic() - begun


def _measure(chrome: Any, url: str, fly_pid: int, domain: int, part_s: float) -> dict[str, Any]:
    page, usable = _open(chrome, url)
    page.keyboard.press('t')
    _until(page, "rvd.store.status.lease === 'you'")
    page.evaluate("(() => { rvd.link.ask({ do: 'fly', mode: 'auto' }); })()")
    _until(page, "rvd.store.status.phase === 'flying' && Boolean(rvd.store.frame)")
    joys = Joys(domain)
    try:
        page.evaluate('''(() => { window.sent = [];
            rvd.link.worker.addEventListener('message', (e) => {
              if (e.data.type === 'sent') window.sent.push([e.data.sequence, e.data.at]); });
            rvd.link.worker.postMessage({ log: true }); })()''')
        bridge = _console_pid(fly_pid)
        alone, crowd = Part(), Part()
        for _ in range(TURNS):                  # in turns, as other work on the machine changes
            _measure_part(alone, page, joys, bridge, part_s)
            watchers = subprocess.Popen([sys.executable, __file__, url], stdin=subprocess.PIPE)
            _until(page, f'rvd.store.status.pages > {WATCHERS}')
            _measure_part(crowd, page, joys, bridge, part_s)
            watchers.terminate()
            watchers.wait()
            _until(page, 'rvd.store.status.pages === 1')
    finally:
        joys.close()
    return {
        'usable_s': usable, 'pictures_per_s': alone.pictures / alone.took_s,
        'sticks': len(alone.times_ms), 'stick_p50_ms': rank(alone.times_ms, 50),
        'stick_p99_ms': rank(alone.times_ms, 99),
        'bridge_percent': 100.0 * alone.cpu_s / alone.took_s,
        'watched_p50_ms': rank(crowd.times_ms, 50), 'watched_p99_ms': rank(crowd.times_ms, 99),
        'watched_bridge_percent': 100.0 * crowd.cpu_s / crowd.took_s,
        'watchers_ratio': rank(crowd.times_ms, 99) / rank(alone.times_ms, 99),
        'load_average': os.getloadavg()[0]}


@dataclass
class Part:
    """What was measured while the pilot was alone, or watched."""

    times_ms: list[float] = field(default_factory=list)     # from the stick to /joy
    cpu_s: float = 0.0              # of the bridge
    pictures: int = 0
    took_s: float = 0.0


def _measure_part(part: Part, page: Any, joys: 'Joys', bridge: int, part_s: float) -> None:
    """Measure for `part_s` and add it to `part`."""
    page.evaluate('(() => { window.sent = []; window.drawn = rvd.scene.drawn; })()')
    joys.heard.clear()
    cpu, begun = cpu_s(bridge), time.monotonic()
    while time.monotonic() - begun < part_s:
        page.wait_for_timeout(250)
    took = time.monotonic() - begun
    part.cpu_s += cpu_s(bridge) - cpu
    part.took_s += took
    sent = dict(page.evaluate('window.sent'))
    part.pictures += page.evaluate('rvd.scene.drawn - window.drawn')
    times = [joys.heard[n] - at for n, at in sent.items() if n in joys.heard]
    if not times:
        raise CannotRun('no stick sample reached /joy')
    part.times_ms += times


class Joys:
    """Listens to /joy on a thread of its own."""

    def __init__(self, domain: int) -> None:
        import threading

        from rclpy.context import Context
        from rclpy.executors import SingleThreadedExecutor
        from rclpy.node import Node
        from sensor_msgs.msg import Joy

        from rvd_dynamics.diagram.ros.qos import HELD_STICK
        self.heard: dict[int, float] = {}
        self._context = Context()
        self._context.init(domain_id=domain)
        self._node = Node('rvd_bench', context=self._context)
        self._node.create_subscription(Joy, '/joy', self._take, HELD_STICK)
        self._executor = SingleThreadedExecutor(context=self._context)
        self._executor.add_node(self._node)
        self._open = True
        self._thread = threading.Thread(target=self._spin, daemon=True)
        self._thread.start()

    def _spin(self) -> None:
        while self._open:
            self._executor.spin_once(timeout_sec=0.2)

    def _take(self, joy: Any) -> None:
        self.heard[int(joy.header.frame_id.split()[1])] = time.time() * 1e3

    def close(self) -> None:
        """Leave the graph."""
        self._open = False
        self._thread.join(2.0)
        self._node.destroy_node()
        self._context.try_shutdown()


def rank(values: list[float], percent: float) -> float:
    """Return the nearest-rank percentile."""
    ordered = sorted(values)
    return ordered[max(0, -(-len(ordered) * int(percent) // 100) - 1)]


def _until(page: Any, condition: str, timeout_s: float = 60.0) -> None:
    deadline = time.monotonic() + timeout_s
    while not page.evaluate(condition):
        if time.monotonic() > deadline:
            raise CannotRun(f'the page did not get there: {condition}')
        time.sleep(0.02)


def _console_pid(parent: int) -> int:
    for stat in Path('/proc').glob('[0-9]*/stat'):
        try:
            fields = stat.read_text().rsplit(')', 1)[1].split()
            words = (stat.parent / 'cmdline').read_bytes()
        except OSError:
            continue
        if int(fields[1]) == parent and b'--serve' in words:
            return int(stat.parent.name)
    raise CannotRun('the console process was not found')


async def _watch(url: str) -> None:
    """Be all the watchers, in a process that leaves the cores to the others: they sit elsewhere."""
    import aiohttp
    os.nice(19)
    address, token = url.split('/#')
    async with aiohttp.ClientSession() as session:
        async def one() -> None:
            async with session.ws_connect(
                    address + '/ws', protocols=('rvd.console.1', 'token.' + token),
                    headers={'Origin': address}) as socket:
                async for _ in socket:
                    pass
        await asyncio.gather(*(one() for _ in range(WATCHERS)))


if __name__ == '__main__':
    asyncio.run(_watch(sys.argv[1]))
