// What a pilot reads: instruments, the cross-section, commands, round trip, the marks on the camera.

import { pointTo } from './beyond.js';
import { BLEND, cause, sentence, whoFlies } from './decided.js';
import { S, fill } from './strings.js';
import { COLOUR, begin, ring, say, small, text } from './canvas.js';
import { drawPixels } from './cockpit.js';
import { along, amount, number as read, part, place, sample } from './data.js';

const $ = (id) => document.getElementById(id);
const MOST_ABREAST = 4; // axes of a command side by side
const COLUMNS = ['measured', 'predicted', 'truth', 'plain'];

export function number(value, digits) {
  if (value === null || value === undefined || !Number.isFinite(value)) return S.unknown;
  const words = value.toFixed(digits);
  return Number(words) === 0 ? words.replace('-', '') : words.replace('-', '−'); // no minus before zero
}

// A limit as it stands beside a value: one that never changes as it was given.
const bound = (limit, value, digits) => (typeof limit === 'number' ? String(limit).replace('-', '−') : number(value, digits));

export function limitWords(frame, { low, high }, digits) {
  const [least, most] = [amount(frame, low), amount(frame, high)];
  if (least === undefined && most === undefined) return '';
  if (most === undefined) return `> ${bound(low, least, digits)}`;
  return least === undefined ? `< ${bound(high, most, digits)}` : `${bound(low, least, digits)}…${bound(high, most, digits)}`;
}

export class Instruments {
  setDisplay(display) {
    const panel = display.instruments;
    $('instruments').hidden = !panel;
    this.rows = [];
    if (!panel) return;
    $('instruments-title').textContent = panel.title;
    const used = COLUMNS.filter((role) => panel.rows.some((row) => row.readings.some((one) => one.role === role)));
    $('instruments').style.setProperty('--columns', used.length);
    const head = element('div', 'head');
    head.append(...[['', ''], ...used.map((role) => [S.columns[role], role]), ['', ''], [S.limit, 'dim']].map(([words, tone]) => element('span', tone, words)));
    $('instruments-rows').replaceChildren(head, ...panel.rows.map((row) => {
      const line = element('div', 'row');
      const cells = new Map(used.map((role) => [role, element('b', role)]));
      const limit = element('u');
      line.append(element('span', '', row.label), ...cells.values(), element('u', 'unit', row.unit), limit);
      this.rows.push({ row, cells, limit });
      return line;
    }));
  }

  show(frame, stale) {
    for (const { row, cells, limit } of this.rows) {
      let words = '';
      for (const reading of row.readings) {
        const value = read(frame, reading.value);
        const cell = cells.get(reading.role);
        say(cell, number(value, row.digits));
        cell.classList.toggle('stale-value', stale && reading.role === 'measured');
        cell.classList.toggle('bad', value <= amount(frame, reading.low) || value >= amount(frame, reading.high));
        words = limitWords(frame, reading, row.digits) || words;
      }
      say(limit, words);
    }
  }
}

function element(kind, tone = '', words = '') {
  const made = document.createElement(kind);
  if (tone) made.className = tone;
  made.textContent = words;
  return made;
}

// -- the cross-section --------------------------------------------------------------------------

export function setSection(section) {
  $('cut').hidden = !section;
  if (!section) return;
  $('section-title').textContent = section.title;
  $('section').setAttribute('aria-label', section.alt);
  $('foot').hidden = !section.foot;
  if (section.foot) $('foot-label').textContent = section.foot.label;
}

const MARKS = {
  dot(pen, x, y, colour, rem) {
    pen.fillStyle = colour;
    pen.beginPath(); pen.arc(x, y, rem * 0.3, 0, 7); pen.fill();
  },
  ring(pen, x, y, colour, rem, spread) {
    pen.fillStyle = `${colour}30`;
    pen.beginPath(); pen.arc(x, y, Math.max(rem * 0.3, spread), 0, 7); pen.fill(); pen.stroke();
  },
  cross(pen, x, y, colour, rem) {
    const r = rem * 0.32;
    pen.beginPath();
    pen.moveTo(x - r, y - r); pen.lineTo(x + r, y + r);
    pen.moveTo(x - r, y + r); pen.lineTo(x + r, y - r);
    pen.stroke();
  },
  square(pen, x, y, colour, rem) {
    pen.strokeRect(x - rem * 0.35, y - rem * 0.35, rem * 0.7, rem * 0.7);
  },
};

// Cut across the scene, `right` and `up` of it as the display says.
export function drawSection(section, frame) {
  const { pen, w, h, rem } = begin($('section'));
  const [cx, cy] = [w / 2, h / 2];
  const size = Math.min(w, h) / 2 - 0.9 * rem;
  pen.strokeStyle = COLOUR.line;
  pen.beginPath();
  pen.moveTo(cx - size, cy); pen.lineTo(cx + size, cy);
  pen.moveTo(cx, cy - size); pen.lineTo(cx, cy + size);
  pen.stroke();
  readout(section.note ? part(frame, section.note) : ['', false], $('section-note'), 'dim');
  if (section.foot) readout(part(frame, section.foot.words), $('foot-words'));
  const extent = amount(frame, section.extent_m);
  if (!extent) return;
  const scale = size / extent;
  for (const one of section.rings) {
    const radius = amount(frame, one.radius_m);
    if (radius === undefined) continue;
    ring(pen, cx, cy, radius * scale, COLOUR[one.role], one.dashed ? [rem * 0.3, rem * 0.25] : null);
    if (one.written) text(pen, `${radius.toFixed(2)} m`, cx + radius * scale * 0.72, cy - radius * scale * 0.72 - rem * 0.3, COLOUR[one.role]);
  }
  text(pen, section.names?.[1] ?? axisName(section.up), cx + rem * 0.3, cy - size, COLOUR.dim);
  text(pen, section.names?.[0] ?? axisName(section.right), cx + size, cy - rem * 0.6, COLOUR.dim, 'right');
  const said = []; // where words of arrows stand
  const at = (p) => [cx + along(section.right, p) * scale, cy - along(section.up, p) * scale];
  for (const spot of section.spots) {
    const p = place(frame, spot.place);
    if (!p) continue;
    const colour = COLOUR[spot.role];
    const [x, y] = at(p);
    pen.strokeStyle = colour;
    if (Math.hypot(x - cx, y - cy) > size + 0.5 * rem) { // it lies beyond what the cut shows
      pointTo(pen, [cx, cy], size, [x, y], colour, rem, spot.mark === 'cross' ? '' : `${(Math.hypot(x - cx, y - cy) / scale).toFixed(1)} m`, said);
      continue;
    }
    const from = spot.origin && place(frame, spot.origin);
    if (from) {
      pen.setLineDash([rem * 0.2, rem * 0.2]);
      pen.beginPath(); pen.moveTo(...at(from)); pen.lineTo(x, y); pen.stroke();
      pen.setLineDash([]);
    }
    MARKS[spot.mark](pen, x, y, colour, rem, spot.spread ? (read(frame, spot.spread) ?? 0) * scale : 0);
    const rate = spot.rate && place(frame, spot.rate);
    if (rate) {
      const reach = spot.ahead_s * scale;
      pen.beginPath(); pen.moveTo(x, y); pen.lineTo(x + along(section.right, rate) * reach, y - along(section.up, rate) * reach); pen.stroke();
    }
  }
}

const axisName = (direction) => direction.replace('+', '').replace('-', '−');

// Words that a mission derives, with their alarm.
export function readout(pair, target, tone = '') {
  const [words, alarm] = pair || [S.unknown, false];
  say(target, words);
  target.className = alarm ? 'alarm' : tone;
}

// -- commands -----------------------------------------------------------------------------------

export function commandText(value, digits) {
  const words = number(value, digits);
  return Number(value.toFixed(digits)) > 0 ? `+${words}` : words;
}

function barOf(colour) {
  const bar = element('div', 'bar');
  bar.append(document.createElement('i'), document.createElement('span'));
  bar.firstChild.style.background = colour;
  return bar;
}

export class Commands {
  setDisplay(display) {
    const { commands } = display;
    this.display = display;
    this.commands = commands;
    $('commands-title').textContent = commands.unit ? `${commands.title}, ${commands.unit}` : commands.title;
    const axes = commands.axes.map((axis) => element('span', 'dim', axis.name));
    const names = commands.rows.map((row) => element('span', row.role === 'automatic' ? 'auto' : '', row.label));
    this.rows = commands.rows.map((row) => ({ row, bars: commands.axes.map(() => barOf(COLOUR[row.role])) }));
    // A line for each sender; where there are too many axes for that, one for each axis.
    const lines = axes.length <= MOST_ABREAST
      ? [[element('span'), ...axes], ...this.rows.map(({ bars }, i) => [names[i], ...bars])]
      : [[element('span'), ...names], ...axes.map((axis, i) => [axis, ...this.rows.map(({ bars }) => bars[i])])];
    $('bars').style.setProperty('--columns', lines[0].length - 1);
    $('bars').replaceChildren(...lines.flat());
  }

  show(frame) {
    const sent = frame.signals[this.commands.sent];
    for (const { row, bars } of this.rows) {
      // What was sent without anybody's valid word is neutral, and that is known.
      const said = row.value.signal === this.commands.sent ? sent : sample(frame, row.value.signal);
      const values = said?.parts[row.value.part];
      this.commands.axes.forEach((axis, i) => this.bar(bars[i], values?.[i] ?? null, axis.highest));
    }
    const found = whoFlies(this.display, frame);
    const words = found ? [sentence(found)] : [cause(sent?.parts.reason)];
    if (found?.pilot && sent.parts.weight !== null && sent.parts.by === BLEND) words.push(`${S.weight} ${sent.parts.weight}`);
    say($('why'), words.filter(Boolean).join(' · '));
  }

  bar(bar, value, highest) {
    const share = Math.min(Math.abs(value || 0) / highest, 1) * 48;
    bar.firstChild.style.left = `${value < 0 ? 50 - share : 50}%`;
    bar.firstChild.style.width = `${share}%`;
    say(bar.lastChild, value === null ? S.unknown : commandText(value, this.commands.digits));
  }
}

// -- clocks and link ----------------------------------------------------------------------------

export function clock(id, seconds, age, stale) {
  const box = $(`clock-${id}`);
  say(box, seconds === undefined ? S.unknown : `${number(seconds, 1)} s`);
  say($(`clock-${id}-age`), age);
  box.parentElement.classList.toggle('stale', Boolean(stale));
}

// Round trip: what the loop should take, what the last acknowledged command took.
export function dial(canvas, run, roundTrip, transit) {
  const { pen, w, h, rem } = begin(canvas);
  const [cx, cy, r] = [w / 2, h * 0.56, Math.min(w / 2, h * 0.56) - rem * 0.5];
  const nominal = run.forward_s + run.back_s;
  const most = Math.max(nominal * 1.5, 1);
  const angle = (s) => Math.PI * (0.8 + 1.4 * Math.max(0, Math.min(1, s / most)));
  pen.lineWidth = rem * 0.45;
  pen.strokeStyle = '#1b2733';
  pen.beginPath(); pen.arc(cx, cy, r, angle(0), angle(most)); pen.stroke();
  if (roundTrip !== undefined) {
    pen.strokeStyle = roundTrip > nominal + 1 ? COLOUR.alarm : COLOUR.measured;
    pen.beginPath(); pen.arc(cx, cy, r, angle(0), angle(roundTrip)); pen.stroke();
  }
  if (transit) {
    pen.lineWidth = rem * 0.16;
    pen.strokeStyle = COLOUR.guide;
    pen.beginPath(); pen.arc(cx, cy, r - rem * 0.5, angle(0), angle(transit)); pen.stroke();
  }
  pen.strokeStyle = COLOUR.text;
  pen.lineWidth = rem * 0.12;
  const a = angle(nominal);
  pen.beginPath();
  pen.moveTo(cx + (r - rem * 0.4) * Math.cos(a), cy + (r - rem * 0.4) * Math.sin(a));
  pen.lineTo(cx + (r + rem * 0.4) * Math.cos(a), cy + (r + rem * 0.4) * Math.sin(a));
  pen.stroke();
  pen.font = `600 ${1.35 * rem}px system-ui, sans-serif`;
  text(pen, roundTrip === undefined ? S.unknown : `${roundTrip.toFixed(1)} s`, cx, cy - rem * 0.05, COLOUR.text, 'center');
  pen.font = `${small(rem)}px system-ui, sans-serif`;
  const legs = `${run.forward_s} + ${run.back_s} s`;
  if (pen.measureText(legs).width < 1.55 * r) text(pen, legs, cx, cy + rem * 1.2, COLOUR.dim, 'center');
}

export function linkCounts(frame, measured, step, now) {
  const { link, gap } = frame;
  const rows = [[S.link.transit, measured ? `${number(measured.transit, 2)} s` : S.unknown]];
  if (link) {
    rows.push([S.link.p99, `${number(link.delay_p99, 2)} s`], [S.link.lost, link.lost + link.outage],
      [S.link.late, link.late], [S.link.corrupted, link.corrupted]);
  }
  rows.push([S.link.gap, gap ? fill(S.ago, { s: number(Math.max(now - gap.k * step, 0), 0) }) : S.unknown]);
  const html = rows.map(([name, value]) => `<dt>${name}</dt><dd>${value}</dd>`).join('');
  if ($('link-counts').innerHTML !== html) $('link-counts').innerHTML = html;
}

// -- marks on the camera ------------------------------------------------------------------------

// Over its picture: a cross, the marks of the display, a gauge, the distance; the lowest `covered`
// pixels are left to what stands there.
export function reticle(canvas, scene, camera, frame, covered) {
  const { pen, w, h, rem } = begin(canvas);
  const [cx, cy] = [w / 2, h / 2];
  pen.strokeStyle = '#dbe5ee90';
  pen.beginPath();
  pen.moveTo(cx - w * 0.3, cy); pen.lineTo(cx - rem, cy); pen.moveTo(cx + rem, cy); pen.lineTo(cx + w * 0.3, cy);
  pen.moveTo(cx, cy - h * 0.36); pen.lineTo(cx, cy - rem); pen.moveTo(cx, cy + rem); pen.lineTo(cx, cy + h * 0.36);
  for (let i = -3; i <= 3; i += 1) {
    if (i) { pen.moveTo(cx + i * w * 0.1, cy - rem * 0.25); pen.lineTo(cx + i * w * 0.1, cy + rem * 0.25); }
  }
  pen.stroke();
  const carrier = scene.known(camera.carried_by);
  if (!carrier) {
    text(pen, S.no_telemetry, cx, cy + h * 0.36 + rem, COLOUR.dim, 'center');
    return;
  }
  const isTruth = carrier.item.role === 'truth'; // a prediction belongs to what was measured
  for (const mark of camera.marks) {
    const at = place(frame, mark.at);
    const seen = at && !(isTruth && mark.role === 'predicted') && scene.onCamera(at);
    if (!seen) continue;
    const colour = COLOUR[mark.role];
    const [x, y] = [cx + (seen[0] * w) / 2, cy - (seen[1] * h) / 2];
    pen.strokeStyle = colour;
    if (mark.radius_m === null) {
      MARKS.square(pen, x, y, colour, rem);
      continue;
    }
    const range = Math.max(along(camera.look, at) - along(camera.look, carrier.at), 0.05);
    ring(pen, x, y, Math.min((mark.radius_m / range / scene.cameraTan) * (h / 2), h), colour);
    pen.strokeStyle = `${colour}80`; // the line of sight
    pen.beginPath(); pen.moveTo(cx, cy); pen.lineTo(x, y); pen.stroke();
  }
  if (camera.pixels) drawPixels(pen, { w, h, rem }, camera.pixels, frame, scene.cameraTan);
  if (camera.gauge) drawGauge(pen, w, h - covered, rem, camera.gauge, frame, isTruth);
  if (camera.numbers) return;
  const distance = camera.distance.map((one) => read(frame, one.value)).find((v) => v !== undefined);
  if (distance !== undefined) text(pen, `${number(distance, camera.digits)} ${camera.unit}`, rem * 0.6, h - rem * 0.9, COLOUR.measured);
}

function drawGauge(pen, w, h, rem, gauge, frame, isTruth) {
  const [x, top, bottom] = [w - rem * 2.9, rem * 1.5, h - rem * 1.2];
  const { low, high } = gauge;
  const height = (v) => bottom - ((Math.max(low, Math.min(high, v)) - low) / (high - low)) * (bottom - top);
  pen.strokeStyle = '#dbe5eea0';
  pen.beginPath();
  pen.moveTo(x, top); pen.lineTo(x, bottom);
  for (let i = 0; low + i * gauge.tick <= high + 1e-9; i += 1) {
    const y = height(low + i * gauge.tick);
    const long = i % gauge.long_ticks === 0;
    pen.moveTo(x, y); pen.lineTo(x + rem * (long ? 0.5 : 0.25), y);
    if (long) text(pen, number(low + i * gauge.tick, gauge.digits), x + rem * 0.65, y, COLOUR.text);
  }
  pen.stroke();
  if (gauge.limit !== null) {
    pen.strokeStyle = COLOUR.alarm;
    pen.beginPath(); pen.moveTo(x - rem * 0.5, height(gauge.limit)); pen.lineTo(x + rem * 0.5, height(gauge.limit)); pen.stroke();
  }
  for (const { role, value } of gauge.readings) {
    const v = read(frame, value);
    if (v === undefined || (isTruth && role !== 'truth')) continue;
    const y = height(v);
    const colour = COLOUR[role === 'truth' ? 'measured' : role];
    pen.beginPath(); pen.moveTo(x - rem * 0.1, y); pen.lineTo(x - rem * 0.75, y - rem * 0.36); pen.lineTo(x - rem * 0.75, y + rem * 0.36); pen.closePath();
    if (role === 'predicted') { pen.strokeStyle = colour; pen.stroke(); } else { pen.fillStyle = colour; pen.fill(); }
  }
  text(pen, gauge.unit, x, top - rem * 0.7, COLOUR.dim, 'center');
}
