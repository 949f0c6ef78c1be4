// What a review gives away: a figure (PNG), the numbers of all its instants (CSV), a video (WebM).

import { COLOUR, finely, text } from './canvas.js';
import { number as read, sample } from './data.js';
import { NO_PICTURE, TABLE_HEAD } from './review_words.js';

const $ = (id) => document.getElementById(id);
const FINE = 2; // pixels of a figure per pixel of the screen
const [FILM_WIDTH, FILM_MS, FILM_BITS] = [1280, 66, 4e6]; // [px], [ms] between two pictures, [bit/s]
const FILM_HEAD = 1000; // [byte] of a video without a picture
// [ms] after the end in which the last picture is drawn; without anything more recorded, after which
// all is, or PATIENCE times the longest time that a picture has taken; and at most. The encoder of a
// busy machine is seconds behind, and drops that when it is stopped.
const [FILM_LAST_MS, FILM_QUIET_MS, FILM_END_MS, PATIENCE] = [150, 1000, 20000, 3];
const KINDS = ['video/webm;codecs=vp8', 'video/webm;codecs=vp9', 'video/webm'];
const KEPT_MS = 60000; // a browser may take a while to save what an address stands for
const [STRIP, TABLE, LINE] = [15, 25, 1.5]; // [rem] strip below the scene, table in it, line of that
const NAMES = 0.3; // part of the table
const MOST_NUMBERS = 16; // of a part that becomes columns: states do, drawn paths do not

export function save(name, content, kind) {
  const blob = content instanceof Blob ? content : new Blob([content], { type: kind });
  const link = document.createElement('a');
  link.href = URL.createObjectURL(blob);
  link.download = name;
  link.click();
  setTimeout(() => URL.revokeObjectURL(link.href), KEPT_MS);
}

// -- numbers ------------------------------------------------------------------------------------

const quoted = (words) => (/[",\n]/.test(words) ? `"${words.replaceAll('"', '""')}"` : words);
const named = (words, role, unit) => `${[words, role === 'plain' ? '' : role].filter(Boolean).join(' ')}${unit ? ` [${unit}]` : ''}`;

// Columns of a run: its instruments as they are read, its commands, and what the truth holds.
function columns({ display, frames }) {
  const made = [];
  for (const row of display.instruments?.rows || []) {
    for (const { role, value } of row.readings) made.push([named(row.label, role, row.unit), (frame) => read(frame, value)]);
  }
  const { axes, rows, unit } = display.commands;
  for (const { label, value } of rows) {
    axes.forEach((axis, i) => made.push([named(`${label} ${axis.name}`, '', unit), (frame) => frame.signals[value.signal]?.parts[value.part]?.[i]]));
  }
  const parts = new Map();
  for (const frame of frames) {
    for (const [name, value] of Object.entries(sample(frame, 'truth')?.parts || {})) {
      if (!parts.has(name) && numbers(value)) parts.set(name, numbers(value).length);
    }
  }
  for (const [name, n] of parts) {
    for (let i = 0; i < n; i += 1) made.push([`truth ${name}${n > 1 ? ` ${i}` : ''}`, (frame) => numbers(sample(frame, 'truth')?.parts[name])?.[i]]);
  }
  return made;
}

// A part as a few numbers, or undefined where it is something else.
function numbers(value) {
  const list = Array.isArray(value) ? value : [value];
  return list.length && list.length <= MOST_NUMBERS && list.every((one) => typeof one === 'number' || one === null) ? list : undefined;
}

// One line per picture of the review; what is unknown is empty.
export function table(run) {
  const made = columns(run);
  const cell = (value) => (Number.isFinite(value) ? String(Number(value.toFixed(6))) : '');
  const lines = [[...TABLE_HEAD, ...made.map(([name]) => name)].map(quoted)];
  for (const frame of run.frames) lines.push([cell(frame.t), cell(frame.k), quoted(frame.mode || ''), ...made.map(([, of]) => cell(of(frame)))]);
  return `${lines.map((cells) => cells.join(',')).join('\n')}\n`;
}

// -- a picture ----------------------------------------------------------------------------------

// What is drawn together: the scene with the camera beside it, below them cross-section, numbers and
// ladder; what a mission does not have is left out. [px of the page]
function layout(panels) {
  const box = (id) => $(id).getBoundingClientRect();
  const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
  const [view, head, gap] = [box('view'), 1.9 * rem, 0.5 * rem];
  const parts = [];
  let width = view.width;
  const [eye, cut, way, rows] = ['camera', 'section', 'ladder', 'instruments-rows'].map(box);
  if (eye.width) {
    const wide = Math.min((eye.width / eye.height) * view.height, view.width);
    parts.push({ draw: camera, x: width + gap, y: head, width: wide, height: (wide * eye.height) / eye.width });
    width += gap + wide;
  }
  const [below, tall] = [head + view.height + gap, Math.max(LINE * rem * $('instruments-rows').children.length, STRIP * rem)];
  let x = 0;
  const push = (draw, wide, high = tall) => {
    parts.push({ draw, x, y: below + (tall - high) / 2, width: wide, height: high });
    x += wide + 2 * gap;
  };
  if (cut.width) push(section, tall); // its rings are round
  if (rows.width) push(numbersOf, Math.min(TABLE * rem, width - x), LINE * rem * $('instruments-rows').children.length);
  const left = width - x;
  if (way.width && left > way.width / 3) push(ladder, Math.min(left, way.width), (Math.min(left, way.width) * way.height) / way.width);
  return { rem, head, parts, view, panels, width, height: parts.some(({ y }) => y > head) ? below + tall + gap : head + view.height };
}

function compose(canvas, { rem, head, parts, view, panels, width }, caption) {
  const pen = canvas.getContext('2d');
  const scale = canvas.width / width;
  pen.setTransform(scale, 0, 0, scale, 0, 0);
  pen.fillStyle = '#080c12';
  pen.fillRect(0, 0, width, canvas.height / scale);
  pen.font = `600 ${0.9 * rem}px system-ui, sans-serif`;
  pen.fillStyle = COLOUR.text;
  pen.textBaseline = 'middle';
  pen.textAlign = 'left';
  pen.fillText(caption, 0.5 * rem, head / 2, width - rem);
  scenePart(pen, panels.scene, 'view', { x: 0, y: head, width: view.width, height: view.height });
  overView(pen, view, head, rem);
  for (const part of parts) part.draw(pen, part, rem, panels);
}

const whole = (pen, id, { x, y, width, height }) => pen.drawImage($(id), x, y, width, height);

function camera(pen, to, rem, panels) {
  scenePart(pen, panels.scene, 'camera', to);
  whole(pen, 'reticle', to);
  pen.font = `${0.76 * rem}px system-ui, sans-serif`;
  text(pen, $('camera-tag').textContent, to.x + 0.6 * rem, to.y + 0.9 * rem, COLOUR.measured);
}

// Its middle alone: on the page it may be wider or taller.
function section(pen, { x, y, width, height }) {
  const canvas = $('section');
  const high = Math.min(canvas.height, (canvas.width * height) / width);
  const wide = Math.min(canvas.width, (canvas.height * width) / height);
  pen.drawImage(canvas, (canvas.width - wide) / 2, (canvas.height - high) / 2, wide, high, x, y, width, height);
}

const ladder = (pen, to) => whole(pen, 'ladder', to);

// A part of the canvas that the scene is drawn into.
function scenePart(pen, scene, name, to) {
  const { left, bottom, width, height } = scene.places[name];
  const { canvas } = scene;
  const ratio = canvas.width / parseFloat(canvas.style.width);
  if (width > 0 && height > 0) pen.drawImage(canvas, left * ratio, canvas.height - (bottom + height) * ratio, width * ratio, height * ratio, to.x, to.y, to.width, to.height);
}

// The words over the scene: names of bodies and lines, the legend, the scale.
function overView(pen, view, head, rem) {
  pen.save();
  pen.beginPath();
  pen.rect(0, head, view.width, view.height);
  pen.clip();
  for (const mark of $('labels').children) {
    if (mark.style.display === 'none') continue;
    const body = mark.className === 'body';
    pen.font = `${body ? 600 : 400} ${0.72 * rem}px system-ui, sans-serif`;
    text(pen, mark.textContent, parseFloat(mark.style.left), head + parseFloat(mark.style.top) - (body ? 1.15 * rem : 0), mark.style.color || '#93a7ba', 'center');
  }
  pen.font = `${0.76 * rem}px system-ui, sans-serif`;
  for (const entry of $('legend').children) {
    const box = entry.getBoundingClientRect();
    const [x, y] = [box.left - view.left, head + box.top - view.top + box.height / 2];
    pen.fillStyle = entry.style.color;
    for (const [from, to] of entry.className === 'dash' ? [[0, 0.22], [0.36, 0.58], [0.72, 0.9]] : [[0, 0.9]]) pen.fillRect(x + from * rem, y - 0.1 * rem, (to - from) * rem, 0.2 * rem);
    text(pen, entry.textContent, x + 1.25 * rem, y, entry.style.color);
  }
  text(pen, $('scale').textContent, view.width - 0.7 * rem, head + view.height - rem, COLOUR.dim, 'right');
  pen.restore();
}

// The instruments as they stand on the page.
function numbersOf(pen, { x, y, width }, rem) {
  [...$('instruments-rows').children].forEach((row, i) => {
    const cells = [...row.children];
    const share = (width * (1 - NAMES)) / Math.max(cells.length - 1, 1);
    cells.forEach((cell, j) => {
      pen.font = `${cell.tagName === 'B' ? 600 : 400} ${0.8 * rem}px system-ui, sans-serif`;
      text(pen, cell.textContent, j ? x + width * NAMES + share * j : x, y + LINE * rem * (i + 0.5), getComputedStyle(cell).color, j ? 'right' : 'left');
    });
  });
}

// What is shown now as a canvas; `draw` puts it onto the page once more, finely.
export function figure(panels, caption, draw) {
  const { scene } = panels;
  const { adaptive, quality } = scene;
  Object.assign(scene, { adaptive: false, quality: FINE });
  scene.resize();
  const canvas = document.createElement('canvas');
  finely(FINE, () => {
    draw();
    scene.draw();
    const shape = layout(panels);
    Object.assign(canvas, { width: Math.round(shape.width * FINE), height: Math.round(shape.height * FINE) });
    compose(canvas, shape, caption);
  });
  Object.assign(scene, { adaptive, quality });
  scene.resize();
  draw();
  scene.draw();
  return canvas;
}

// -- a video ------------------------------------------------------------------------------------

export class Film {
  static kind = KINDS.find((kind) => globalThis.MediaRecorder?.isTypeSupported(kind));

  static get possible() {
    return Film.kind !== undefined && Boolean(HTMLCanvasElement.prototype.captureStream);
  }

  // Begins at once. Before each picture after the first one `next(ms)` is called, so that none is
  // left out by a slow machine: there the video takes longer. It ends when that returns false, or by
  // `stop`; then `done(blob, problem)`.
  constructor(panels, caption, next, done) {
    const shape = layout(panels);
    const canvas = document.createElement('canvas');
    const even = (n) => 2 * Math.round(n / 2); // as the encoders want it
    Object.assign(canvas, { width: FILM_WIDTH, height: even((FILM_WIDTH * shape.height) / shape.width) });
    Object.assign(this, { parts: [], bytes: 0, heard: Infinity, slowest: 0, ending: Infinity, done });
    const stream = canvas.captureStream(1000 / FILM_MS);
    compose(canvas, shape, caption()); // once there is a stream: before, nobody sees it
    this.recorder = new MediaRecorder(stream, { mimeType: Film.kind, videoBitsPerSecond: FILM_BITS });
    this.recorder.ondataavailable = ({ data }) => {
      this.parts.push(data);
      this.bytes += data.size;
      const now = performance.now();
      this.slowest = Math.max(this.slowest, now - this.heard);
      this.heard = now;
    };
    this.recorder.onerror = (event) => { this.problem = event.error; };
    this.recorder.onstop = () => this.over();
    this.recorder.start(1); // hands over each picture as soon as it is encoded
    this.timer = setInterval(() => {
      if (this.ending === Infinity && !next(FILM_MS)) this.stop();
      const waited = performance.now() - this.ending;
      if (waited > FILM_END_MS || (waited > FILM_LAST_MS && this.bytes > FILM_HEAD)) this.drain(waited);
      else compose(canvas, shape, caption());
    }, FILM_MS);
  }

  // Nothing is drawn any more: wait until the encoder has done what it has.
  drain(waited) {
    const quiet = performance.now() - Math.max(this.heard, this.ending);
    const enough = quiet > Math.max(FILM_QUIET_MS, PATIENCE * this.slowest);
    if (this.recorder.state !== 'inactive' && (enough || waited > FILM_END_MS)) this.recorder.stop();
  }

  // What has been recorded is kept, the last picture and at least one of them.
  stop() {
    if (this.ending === Infinity) this.ending = performance.now();
  }

  over() {
    clearInterval(this.timer);
    const problem = this.problem ?? (this.bytes > FILM_HEAD ? undefined : new Error(NO_PICTURE));
    this.done(new Blob(this.parts, { type: 'video/webm' }), problem);
  }
}
