// What a review gives away: a figure (PNG), the numbers of all its instants (CSV), a video (WebM).

import { COLOUR, finely, text } from './canvas.js';
import { number as read, sample } from './data.js';
import { TABLE_HEAD } from './review_words.js';

const $ = (id) => document.getElementById(id);
const FINE = 2; // pixels of a figure per pixel of the screen
const [FILM_WIDTH, FILM_MS, FILM_BITS] = [1280, 66, 4e6]; // [px], [ms] between two pictures, [bit/s]
const KINDS = ['video/webm;codecs=vp8', 'video/webm;codecs=vp9', 'video/webm'];
const KEPT_MS = 60000; // a browser may take a while to save what an address stands for
const COLUMN = 0.44; // width of what stands beside the scene, in widths of the scene
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

// What is drawn together: the scene, beside it camera, cross-section and numbers. [px of the page]
function layout(panels) {
  const view = $('view').getBoundingClientRect();
  const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
  const column = Math.round(Math.min(view.width * COLUMN, 26 * rem));
  const [head, gap] = [1.9 * rem, 0.5 * rem];
  const boxes = [];
  let y = head;
  for (const id of ['camera', 'section', 'instruments-rows']) {
    const box = $(id).getBoundingClientRect();
    if (!box.width || !box.height) continue; // this mission has none
    const height = id === 'instruments-rows' ? 1.5 * rem * $(id).children.length : (box.height / box.width) * column;
    boxes.push({ id, x: view.width + gap, y, width: column, height });
    y += height + (id === 'section' ? 2 : 1) * gap;
  }
  return { rem, head, boxes, view, panels, width: view.width + (boxes.length ? gap + column : 0), height: Math.max(view.height + head, y) };
}

function compose(canvas, shape, caption) {
  const { rem, head, boxes, view, panels, width } = shape;
  const pen = canvas.getContext('2d');
  const scale = canvas.width / width;
  pen.setTransform(scale, 0, 0, scale, 0, 0);
  pen.fillStyle = '#080c12';
  pen.fillRect(0, 0, width, canvas.height / scale);
  pen.font = `600 ${0.9 * rem}px system-ui, sans-serif`;
  pen.fillStyle = COLOUR.text;
  pen.textBaseline = 'middle';
  pen.fillText(caption, 0.5 * rem, head / 2, width - rem);
  scenePart(pen, panels.scene, 'view', { x: 0, y: head, width: view.width, height: view.height });
  overView(pen, view, head, rem);
  for (const box of boxes) {
    if (box.id === 'instruments-rows') {
      table2d(pen, box, rem);
    } else if (box.id === 'section') {
      pen.drawImage($('section'), box.x, box.y, box.width, box.height);
    } else {
      scenePart(pen, panels.scene, 'camera', box);
      pen.drawImage($('reticle'), box.x, box.y, box.width, box.height);
      pen.font = `${0.76 * rem}px system-ui, sans-serif`;
      text(pen, $('camera-tag').textContent, box.x + 0.6 * rem, box.y + 0.9 * rem, COLOUR.measured);
    }
  }
}

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
function table2d(pen, box, rem) {
  [...$('instruments-rows').children].forEach((row, i) => {
    const cells = [...row.children];
    const y = box.y + 1.5 * rem * (i + 0.5);
    const share = (box.width * 0.68) / Math.max(cells.length - 1, 1);
    cells.forEach((cell, j) => {
      pen.font = `${cell.tagName === 'B' ? 600 : 400} ${0.8 * rem}px system-ui, sans-serif`;
      const colour = getComputedStyle(cell).color;
      if (j === 0) text(pen, cell.textContent, box.x, y, colour);
      else text(pen, cell.textContent, box.x + box.width * 0.32 + share * j, y, colour, 'right');
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

  // Begins at once and ends when `goesOn()` does not or `stop` is called; then `done(blob, problem)`.
  constructor(panels, caption, goesOn, done) {
    const shape = layout(panels);
    const canvas = document.createElement('canvas');
    const even = (n) => 2 * Math.round(n / 2); // as the encoders want it
    Object.assign(canvas, { width: FILM_WIDTH, height: even((FILM_WIDTH * shape.height) / shape.width) });
    compose(canvas, shape, caption());
    const parts = [];
    this.recorder = new MediaRecorder(canvas.captureStream(1000 / FILM_MS), { mimeType: Film.kind, videoBitsPerSecond: FILM_BITS });
    this.recorder.ondataavailable = (event) => { if (event.data.size) parts.push(event.data); };
    this.recorder.onerror = (event) => { this.problem = event.error; };
    this.recorder.onstop = () => {
      clearInterval(this.timer);
      const problem = this.problem ?? (parts.length ? undefined : new Error('no picture was recorded'));
      done(new Blob(parts, { type: 'video/webm' }), problem);
    };
    this.recorder.start();
    this.timer = setInterval(() => {
      compose(canvas, shape, caption());
      if (!goesOn()) this.stop();
    }, FILM_MS);
  }

  stop() {
    clearInterval(this.timer);
    setTimeout(() => { if (this.recorder.state !== 'inactive') this.recorder.stop(); }, 2 * FILM_MS); // the last picture, too
  }
}
