"""A run to be reviewed in a browser, and what of the page is looked at, for the tests."""

import base64

from console_page import open_page, until

# Ten steps a second, so that there are more commands than a live page remembers; another limit
# than the console's own scenario has; a change of mode on the way.
SCENARIO = '''
/**: {ros__parameters: {step_s: 0.1, timeout_s: 200.0, mode: shared, operator: model,
                        pace: lockstep, processes: one,
                        docking: {max_closing_rate_m_s: 0.31}}}
'''
# What a page shows: words, what is pressed, how much is drawn.
SHOWN = """(() => {
  const find = (id) => document.getElementById(id);
  const ink = (c) => {
    const d = c.getContext('2d').getImageData(0, 0, c.width, c.height).data;
    let n = 0;
    for (let i = 3; i < d.length; i += 4) n += d[i] > 0;
    return n;
  };
  return {
    words: find('app').innerText, title: find('run-name').title, page: document.body.className,
    pressed: [...document.querySelectorAll('[aria-pressed=true]')].map((b) => b.textContent),
    banner: [find('banner').textContent, find('banner').className],
    ink: ['section', 'ladder', 'dial', 'reticle'].map((id) => ink(find(id))),
    bodies: rvd.scene.moving.filter(({ object }) => object.visible).length,
    curves: document.querySelectorAll('#charts .uplot').length,
  };
})()"""
# Parts of the bar of a review that overlap, or are not in the window.
OVERLAPS = """((inside) => {
  const shown = [...document.querySelectorAll(inside)].filter((e) => e.offsetWidth);
  const boxes = shown.map((e) => e.getBoundingClientRect());
  const [right, bottom] = [innerWidth + 0.5, innerHeight + 0.5];
  const found = shown.length < 13 ? [`${shown.length} shown`] : [];
  boxes.forEach((a, i) => {
    if (a.left < -0.5 || a.right > right || a.bottom > bottom) found.push(`${shown[i].id} is out`);
    boxes.slice(i + 1).forEach((b, j) => {
      const x = Math.min(a.right, b.right) - Math.max(a.left, b.left);
      const y = Math.min(a.bottom, b.bottom) - Math.max(a.top, b.top);
      if (x > 1 && y > 1) found.push(`${shown[i].id} on ${shown[i + 1 + j].id}`);
    });
  });
  return found;
})('#scrubber button, #scrubber select, #review-track, #review-now')"""
# Size and colours of a picture, by roles of what is drawn.
COLOURS = """async (data) => {
  const image = await createImageBitmap(await (await fetch(data)).blob());
  const canvas = new OffscreenCanvas(image.width, image.height);
  const pen = canvas.getContext('2d');
  pen.drawImage(image, 0, 0);
  const { data: d } = pen.getImageData(0, 0, image.width, image.height);
  const is = (i, r, g, b) => [r, g, b].every((c, j) => Math.abs(d[i + j] - c) < 9);
  const found = { width: image.width, height: image.height };
  Object.assign(found, { measured: 0, predicted: 0, bright: 0, goal: 0 });
  for (let i = 0; i < d.length; i += 4) {
    found.measured += is(i, 0x7c, 0xc4, 0xff);
    found.predicted += is(i, 0xff, 0xb6, 0x52);
    found.goal += is(i, 0x56, 0xd6, 0xb0);
    found.bright += d[i] + d[i + 1] + d[i + 2] > 300;
  }
  return found;
}"""
# Size, length and content of a video, of its first picture and between that and its last one.
VIDEO = """async (data) => {
  const video = document.createElement('video');
  const heard = (what) => new Promise((go, no) => {
    video.addEventListener(what, go, { once: true });
    video.onerror = () => no(new Error(video.error.message));
  });
  video.src = URL.createObjectURL(await (await fetch(data)).blob());
  await heard('loadeddata');
  video.currentTime = 0.001; // its first picture: at 0 Chromium may hand out none
  await heard('seeked');
  const canvas = new OffscreenCanvas(video.videoWidth, video.videoHeight);
  const pen = canvas.getContext('2d', { willReadFrequently: true });
  const shot = () => {
    pen.drawImage(video, 0, 0);
    return pen.getImageData(0, 0, canvas.width, canvas.height).data;
  };
  const first = shot();
  video.currentTime = 1e6; // to its end
  await heard('seeked');
  const count = (data, is) => {
    let n = 0;
    for (let i = 0; i < data.length; i += 4) n += is(i);
    return n;
  };
  let changed = 0; // a busy machine may hand out the picture of before for a moment
  for (const end = performance.now() + 5000; changed <= 1000 && performance.now() < end;) {
    const last = shot();
    const apart = (i) => Math.abs(first[i] - last[i]);
    changed = count(last, (i) => apart(i) + apart(i + 1) > 60);
    await new Promise((go) => setTimeout(go, 100));
  }
  const bright = count(first, (i) => first[i] + first[i + 1] + first[i + 2] > 240);
  return { width: video.videoWidth, height: video.videoHeight, length: video.currentTime,
    bright, changed };
}"""


def reviewed(browser, console, run='flown', **options):
    """Return a page with the review of a run."""
    page = open_page(browser, console, **options)
    page.set_viewport_size({'width': 1280, 'height': 720})
    page.keyboard.press('Escape')
    page.keyboard.press('l')
    page.click(f'[data-run="{run}"]')
    until(page, 'rvd.review.on')
    page.wait_for_timeout(400)
    return page



def saved(page, button: str):
    """Press a button and return what the browser saves."""
    with page.expect_download(timeout=120_000) as download:
        page.click(button)
    return download.value


def looked_at(browser, look: str, kind: str, content: bytes) -> dict:
    """Open a file in a page without a policy and return what `look` (see above) sees."""
    page = browser.new_page()
    seen = page.evaluate(look, f'data:{kind};base64,{base64.b64encode(content).decode()}')
    page.close()
    return seen
