"""The page in windows of all sizes: nothing overlaps, ABORT is on screen, no text is too small."""

import pytest
from console_page import open_page, until
from placed_console import PlacedConsole, WaitingFor
from toy_console import ToyConsole

pytestmark = [pytest.mark.slow, pytest.mark.patient]
DESK = [(1280, 720, 1), (1024, 640, 1), (1920, 1080, 1)]
SMALL = [(640, 360, 2), (820, 1180, 1), (390, 844, 3)]          # 200 % zoom, tablet, phone
WAITING = {
    'docking': '/**: {ros__parameters: {mission: docking}}',
    'by hand': '/**: {ros__parameters: {mission: docking, steering: remote, operator: console}}',
    'tether': '/**: {ros__parameters: {mission: tether}}',
    'tether_delay': '/**: {ros__parameters: {mission: tether_delay}}'}
# Pairs of parts of the page that share pixels, and what is cut off or beyond the window's edges.
FAULTS = """(() => {
  const shown = (e) => e.offsetParent !== null && e.getBoundingClientRect().width > 0;
  const all = (s) => [...document.querySelectorAll(s)].filter(shown);
  const name = (e) => e.id || e.textContent.trim().slice(0, 20) || e.tagName;
  const faults = [];
  const apart = (parts) => parts.forEach((a, i) => parts.slice(i + 1).forEach((b) => {
    const [p, q] = [a.getBoundingClientRect(), b.getBoundingClientRect()];
    const w = Math.min(p.right, q.right) - Math.max(p.left, q.left);
    const h = Math.min(p.bottom, q.bottom) - Math.max(p.top, q.top);
    if (w > 1 && h > 1) faults.push(`${name(a)} overlaps ${name(b)}`);
  }));
  const sticks = (e) => getComputedStyle(e).position === 'sticky';
  const panels = all('#top, #alarms, #left > *, #centre > *, #right > *, #bottom');
  apart(panels.filter((e) => !sticks(e)));
  for (const s of ['#top', '#alarms', '#bottom', '#view', '#view-top', '#camera']) {
    apart(all(`${s} > *`).filter((e) => !['CANVAS'].includes(e.tagName)
      && !['labels', 'coach', 'banner'].includes(e.id)));
  }
  for (const e of panels) {
    const r = e.getBoundingClientRect();
    if (r.left < -1 || r.right > innerWidth + 1) faults.push(`${name(e)} is beyond the edge`);
    if (e.classList.contains('panel') && e.scrollHeight > e.clientHeight + 2)
      faults.push(`${name(e)} is cut off by ${e.scrollHeight - e.clientHeight}`);
  }
  for (const e of all('#alarms > *')) {
    const shownWhole = getComputedStyle(e).overflow === 'visible' && e.clientWidth > 0;
    if (shownWhole && e.scrollWidth > e.clientWidth + 1)
      faults.push(`${name(e)} runs out of its box`);
  }
  if (document.documentElement.scrollWidth > innerWidth + 1) faults.push('sideways overflow');
  for (const e of all('#view, #camera, #section, #charts > div')) {
    const r = e.getBoundingClientRect();
    if (r.height < 55 || r.width < 60) faults.push(`${name(e)} is ${r.width} by ${r.height}`);
  }
  return faults;
})()"""
# An alarm with as many words as there are.
CALLING = """(() => {
  rvd.alarms.look = () => {};
  document.getElementById('alarms').className = 'warning';
  for (const [id, words] of [['words', 'DRIFTING OUT WITHIN THE DELAY'],
    ['detail', 'nobody flies: neither a valid stick nor a valid automatic command'],
    ['more', 'TOO FAST SIDEWAYS · NEAR THE WALL · TELEMETRY LOST · NOBODY HOLDS THE STICK']])
    document.getElementById(`alarm-${id}`).textContent = words;
})()"""
ABORT = """(() => {
  const r = document.getElementById('abort').getBoundingClientRect();
  const top = document.elementFromPoint((r.left + r.right)/2, (r.top + r.bottom)/2);
  return r.left >= 0 && r.right <= innerWidth && r.top >= 0 && r.bottom <= innerHeight
    && Boolean(top.closest('#abort'));
})()"""
SIZES = """(() => {
  const found = [];
  const walker = document.createTreeWalker(document.body, NodeFilter.SHOW_TEXT);
  while (walker.nextNode()) {
    const e = walker.currentNode.parentElement;
    if (!walker.currentNode.data.trim() || !e.offsetParent) continue;
    const size = parseFloat(getComputedStyle(e).fontSize);
    const words = walker.currentNode.data.trim().slice(0, 20);
    if (size < 10.99) found.push(`${e.tagName} ${e.className} ${size} ${words}`);
  }
  return found;
})()"""
# Sizes of the fonts that canvases are written with.
WATCH = """(() => {
  window.fonts = new Set();
  const write = CanvasRenderingContext2D.prototype.fillText;
  CanvasRenderingContext2D.prototype.fillText = function (...given) {
    window.fonts.add(parseFloat(/([\\d.]+)px/.exec(this.font)[1]) / this.getTransform().a
      / (this.canvas.closest('.uplot') ? devicePixelRatio : 1));
    return write.apply(this, given);
  };
})()"""


@pytest.fixture(scope='module')
def placed():
    made = PlacedConsole()
    yield made
    made.close()


def look_at(browser, console, width, height, ratio, ready):
    context = browser.new_context(viewport={'width': width, 'height': height},
                                  device_scale_factor=ratio)
    context.add_init_script(WATCH)
    page = open_page(context, console, look='plain')
    page.set_viewport_size({'width': width, 'height': height})
    until(page, ready)
    page.wait_for_timeout(700)
    return context, page


@pytest.mark.parametrize('width, height, ratio', DESK + SMALL)
def test_nothing_overlaps_and_abort_is_on_screen(browser, placed, width, height, ratio):
    context, page = look_at(browser, placed, width, height, ratio,
                            'Boolean(rvd.store.measured && rvd.store.predicted)')
    assert page.evaluate(FAULTS) == []
    assert page.evaluate(ABORT)
    before = page.evaluate('document.querySelector("#centre").getBoundingClientRect().top')
    page.evaluate(CALLING)
    assert page.evaluate(FAULTS) == []
    assert page.evaluate('document.querySelector("#centre").getBoundingClientRect().top') == before
    page.evaluate('scrollTo(0, document.documentElement.scrollHeight)')
    page.wait_for_timeout(200)
    assert page.evaluate(ABORT)
    assert page.evaluate('document.querySelector("#alarms").getBoundingClientRect().top') >= 0
    if (width, height, ratio) in DESK:
        assert page.evaluate('scrollY') == 0            # all of it is there at once
        assert page.evaluate(SIZES) == []
        assert page.evaluate('Math.min(...window.fonts)') >= 10.99
    assert page.problems == []
    context.close()


@pytest.mark.parametrize('mission', [*WAITING, 'toy'])
def test_nor_in_other_missions(browser, mission):
    console = ToyConsole() if mission == 'toy' else WaitingFor(WAITING[mission])
    try:
        for width, height, ratio in [*DESK[:2], *SMALL]:
            context, page = look_at(browser, console, width, height, ratio,
                                    'Boolean(rvd.store.display)')
            assert page.evaluate(FAULTS) == [], (width, height)
            assert page.evaluate(ABORT), (width, height)
            context.close()
    finally:
        console.close()


@pytest.mark.parametrize('ratio', [1, 1.25, 2, 3])
def test_ticks_of_the_charts_are_apart_at_every_pixel_ratio(browser, placed, ratio):
    context, page = look_at(browser, placed, 1280, 720, ratio,
                            'rvd.store.frame?.t > 6 && Boolean(rvd.panels.charts.strips[0].plot)')
    crowded = page.evaluate("""rvd.panels.charts.strips.flatMap(({ plot, strip }) => {
      const pen = document.createElement('canvas').getContext('2d');
      return plot.axes.flatMap((axis, i) => {
        pen.font = axis.font[0];
        const seen = (axis._values || []).map((w, k) => [w, axis._splits[k]]);
        const vertical = i === 1;
        const at = seen.filter(([w]) => w).map(([w, v]) => [plot.valToPos(v, i ? 'y' : 'x', true),
          vertical ? parseFloat(/([\\d.]+)px/.exec(pen.font)[1]) : pen.measureText(w).width]);
        at.sort((a, b) => a[0] - b[0]);
        return at.slice(1).filter(([x, size], k) => x - at[k][0] < (size + at[k][1])/2)
          .map(() => `${strip.title} ${vertical ? 'y' : 'x'}`).concat(
            at.length < 2 && vertical ? [`${strip.title}: ${at.length} ticks`] : []);
      });
    })""")
    assert crowded == []
    sizes = page.evaluate("""rvd.panels.charts.strips.flatMap(({ plot }) => plot.axes.map(
      (axis) => parseFloat(/([\\d.]+)px/.exec(axis.font[0])[1]) / devicePixelRatio))""")
    assert all(10.9 < size < 20.0 for size in sizes), sizes
    assert page.inner_text('#charts-key').split('\n') == ['predicted − received', '±2σ as claimed']
    assert len(page.query_selector_all('#charts > div')) == 6       # each component its own
    context.close()
