// Numbers, section of the corridor, thrust levels, round trip: what a pilot reads.

import { BY, REASONS, S, fill } from './strings.js';
import { COLOUR, begin, ring, say, text } from './canvas.js';
import { interpolate } from './craft.js';

const $ = (id) => document.getElementById(id);
const AXES = ['x', 'y', 'z'];

export function number(value, digits) {
  if (value === null || value === undefined || !Number.isFinite(value)) return S.unknown;
  return value.toFixed(digits).replace('-', '−');
}

export function measures(state) {
  if (!state) return {};
  const [x, y, z, vx, vy, vz] = state;
  return { range: Math.hypot(x, y, z), closing: vx, offset: Math.hypot(y, z),
    lateral: Math.hypot(vy, vz), x, y, z };
}

const ROWS = [
  ['range', S.range, 'm', 2], ['closing', S.closing, 'm/s', 3], ['offset', S.offset, 'm', 2],
  ['lateral', S.lateral, 'm/s', 3], ['margin', S.margin, 'm', 2],
];

export class Motion {
  constructor() {
    for (const [key, name, unit] of ROWS) {
      const row = document.querySelector(`[data-row=${key}]`);
      row.innerHTML = `<span>${name}</span><b class="measured" id="m-${key}"></b><b class="predicted" id="p-${key}"></b><u class="unit">${unit}</u><u id="l-${key}"></u>`;
      
    }
  }

  setRun(run) {
    $('l-closing').textContent = `< ${run.limits.closing}`;
    $('l-lateral').textContent = `< ${run.limits.lateral}`;
  }

  show(first, second, run, stale) {
    const made = [measures(first), measures(second)];
    for (const m of made) {
      if (m.x === undefined) continue;
      m.wall = run.limits.offset - Math.min(m.x, 0) * Math.tan((run.half_angle_deg * Math.PI) / 180);
      m.margin = (m.wall - m.offset) * Math.cos((run.half_angle_deg * Math.PI) / 180);
    }
    for (const [key, , , digits] of ROWS) {
      made.forEach((m, i) => {
        const cell = $(`${i ? 'p' : 'm'}-${key}`);
        say(cell, number(m[key], digits));
        cell.classList.toggle('stale-value', stale && i === 0);
        cell.classList.toggle('bad', this.bad(key, m, run));
      });
    }
    const wall = made[1].wall ?? made[0].wall;
    say($('l-offset'), wall === undefined ? '' : `< ${wall.toFixed(2)}`);
    say($('l-margin'), '> 0');
    return made;
  }

  bad(key, m, run) {
    if (key === 'closing') return m.closing >= run.limits.closing || m.closing <= 0;
    if (key === 'lateral') return m.lateral >= run.limits.lateral;
    if (key === 'offset') return m.offset >= m.wall;
    return key === 'margin' && m.margin < 0;
  }
}

// The corridor cut at the predicted station, seen from behind: z to the right, y up.
export function bullseye(canvas, run, first, second, sigma, outlook, truth) {
  const { pen, w, h, rem } = begin(canvas);
  const [cx, cy] = [w / 2, h / 2];
  const size = Math.min(w, h) / 2 - 0.9 * rem;
  const at = (second || first || [run.start[0], 0, 0])[0];
  const station = Math.max(run.geometry.x[0], Math.min(at, 0));
  const wall = interpolate(run.geometry.x, run.geometry.wall, station);
  const boundary = interpolate(run.geometry.x, run.geometry.boundary, station);
  const scale = size / Math.max(wall * 1.12, 0.36);
  pen.strokeStyle = COLOUR.line;
  pen.beginPath();
  pen.moveTo(cx - size, cy); pen.lineTo(cx + size, cy);
  pen.moveTo(cx, cy - size); pen.lineTo(cx, cy + size);
  pen.stroke();
  ring(pen, cx, cy, wall * scale, COLOUR.wall);
  ring(pen, cx, cy, boundary * scale, COLOUR.boundary, [rem * 0.3, rem * 0.25]);
  ring(pen, cx, cy, run.limits.offset * scale, COLOUR.ok);
  text(pen, `${wall.toFixed(2)} m`, cx + wall * scale * 0.72, cy - wall * scale * 0.72 - rem * 0.3, COLOUR.wall);
  text(pen, 'y', cx + rem * 0.3, cy - size, COLOUR.dim);
  text(pen, 'z', cx + size, cy - rem * 0.6, COLOUR.dim, 'right');
  const spot = (p) => [cx + p[2] * scale, cy - p[1] * scale];
  if (outlook && outlook.hit && second) {
    const [x, y] = [cx + outlook.hit[1] * scale, cy - outlook.hit[0] * scale];
    const [px, py] = spot(second);
    pen.strokeStyle = COLOUR.predicted;
    pen.setLineDash([rem * 0.2, rem * 0.2]);
    pen.beginPath(); pen.moveTo(px, py); pen.lineTo(x, y); pen.stroke();
    pen.setLineDash([]);
    cross(pen, x, y, rem * 0.32);
  }
  if (first) {
    const [x, y] = spot(first);
    pen.fillStyle = COLOUR.measured;
    pen.beginPath(); pen.arc(x, y, rem * 0.3, 0, 7); pen.fill();
  }
  if (second) {
    const [x, y] = spot(second);
    pen.strokeStyle = COLOUR.predicted;
    const r = Math.max(rem * 0.3, 2 * (sigma ? Math.max(sigma[1], sigma[2]) : 0) * scale);
    pen.fillStyle = '#ffb65230';
    pen.beginPath(); pen.arc(x, y, r, 0, 7); pen.fill(); pen.stroke();
    const v = 10 * scale; // where it goes in 10 s
    pen.beginPath(); pen.moveTo(x, y); pen.lineTo(x + second[5] * v, y - second[4] * v); pen.stroke();
  }
  if (truth) {
    const [x, y] = spot(truth);
    pen.strokeStyle = COLOUR.truth;
    cross(pen, x, y, rem * 0.3);
  }
  say($('section-at'), fill(S.section_at, { x: number(station, 1) }));
}

function cross(pen, x, y, r) {
  pen.beginPath();
  pen.moveTo(x - r, y - r); pen.lineTo(x + r, y + r);
  pen.moveTo(x - r, y + r); pen.lineTo(x + r, y - r);
  pen.stroke();
}

export class Thrust {
  constructor() {
    const rows = [['', ''], ['pilot', S.pilot], ['auto', S.auto], ['sent', S.sent]];
    $('levels').innerHTML = rows.map(([key, name]) => (key
      ? `<span class="${key === 'auto' ? 'auto' : ''}">${name}</span>${AXES.map((a) => `<div class="bar" id="lv-${key}-${a}"><i></i><span></span></div>`).join('')}`
      : `<span></span>${AXES.map((a) => `<span class="dim">${a}</span>`).join('')}`)).join('');
  }

  show(pilot, auto, cmd) {
    this.bars('pilot', pilot, '#7cc4ff');
    this.bars('auto', auto, COLOUR.auto);
    this.bars('sent', cmd && { lv: cmd.lv, ok: true }, COLOUR.ok);
    const words = cmd ? [BY[cmd.by]] : [];
    if (cmd && cmd.w !== null && cmd.by === 3) words.push(`${S.weight} ${cmd.w}`);
    if (cmd && REASONS[cmd.why]) words.push(REASONS[cmd.why]);
    say($('why'), words.join(' · '));
  }

  bars(key, part, colour) {
    AXES.forEach((axis, i) => {
      const bar = $(`lv-${key}-${axis}`);
      const level = part && part.ok ? part.lv[i] : null;
      const fillBar = bar.firstChild;
      fillBar.style.background = colour;
      fillBar.style.left = `${level < 0 ? 50 + (level / 3) * 48 : 50}%`;
      fillBar.style.width = `${(Math.abs(level || 0) / 3) * 48}%`;
      say(bar.lastChild, level === null ? S.unknown : level > 0 ? `+${level}` : `${level}`.replace('-', '−'));
    });
  }
}

export function clock(id, seconds, age, stale) {
  const box = $(`clock-${id}`);
  say(box, seconds === null ? S.unknown : `${number(seconds, 1)} s`);
  say($(`clock-${id}-age`), age);
  box.parentElement.classList.toggle('stale', Boolean(stale));
}

export function errorRms(score) {
  const rms = score?.rms;
  say($('error-rms'), rms && rms[0] !== null ? fill(S.rms, { p: number(100 * Math.hypot(rms[0], rms[1], rms[2]), 1),
    v: number(1000 * Math.hypot(rms[3], rms[4], rms[5]), 1) }) : '');
}

// Round trip: what the loop should take, what the last acknowledged command took.
export function dial(canvas, run, rtt, transit) {
  const { pen, w, h, rem } = begin(canvas);
  const [cx, cy, r] = [w / 2, h * 0.56, Math.min(w / 2, h * 0.56) - rem * 0.5];
  const nominal = run.forward_s + run.back_s;
  const most = Math.max(nominal * 1.5, 1);
  const angle = (s) => Math.PI * (0.8 + 1.4 * Math.max(0, Math.min(1, s / most)));
  pen.lineWidth = rem * 0.45;
  pen.strokeStyle = '#1b2733';
  pen.beginPath(); pen.arc(cx, cy, r, angle(0), angle(most)); pen.stroke();
  if (rtt !== undefined) {
    pen.strokeStyle = rtt > nominal + 1 ? COLOUR.alarm : COLOUR.measured;
    pen.beginPath(); pen.arc(cx, cy, r, angle(0), angle(rtt)); pen.stroke();
  }
  if (transit) {
    pen.lineWidth = rem * 0.16;
    pen.strokeStyle = COLOUR.boundary;
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
  text(pen, rtt === undefined ? S.unknown : `${rtt.toFixed(1)} s`, cx, cy - rem * 0.05, COLOUR.text, 'center');
  pen.font = `${0.7 * rem}px system-ui, sans-serif`;
  text(pen, `${run.forward_s} + ${run.back_s} s`, cx, cy + rem * 1.05, COLOUR.dim, 'center');
}

export function linkCounts(frame, step) {
  const { link, tm, gap } = frame;
  const rows = [[S.link.transit, tm ? `${number(tm.transit, 2)} s` : S.unknown]];
  if (link) {
    rows.push([S.link.p99, `${number(link.delay_p99, 2)} s`], [S.link.lost, link.lost + link.outage],
      [S.link.late, link.late], [S.link.corrupted, link.corrupted]);
  }
  rows.push([S.link.gap, gap ? fill(S.ago, { s: number((frame.k - gap.k) * step, 0) }) : S.unknown]);
  const html = rows.map(([name, value]) => `<dt>${name}</dt><dd>${value}</dd>`).join('');
  if ($('link-counts').innerHTML !== html) $('link-counts').innerHTML = html;
}

// Reticle of the docking camera: cross, corridor, predicted place, closing-rate scale.
export function reticle(canvas, scene, run, state, predicted) {
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
  if (!state) return;
  const port = scene.onCamera([0, 0, 0]);
  if (port) { // docking circle at the port, and the line of sight to it
    const x = cx + (port[0] * w) / 2;
    const y = cy - (port[1] * h) / 2;
    const r = (run.limits.offset / Math.max(-state[0], 0.05) / scene.dockTan) * (h / 2);
    ring(pen, x, y, Math.min(r, h), COLOUR.ok);
    pen.strokeStyle = '#56d6b080';
    pen.beginPath(); pen.moveTo(cx, cy); pen.lineTo(x, y); pen.stroke();
  }
  if (predicted && state[0] < -0.2) { // where the port will appear once a command sent now acts
    const aim = scene.onCamera([0, state[1] - predicted[1], state[2] - predicted[2]]);
    if (aim) {
      pen.strokeStyle = COLOUR.predicted;
      const x = cx + (aim[0] * w) / 2;
      const y = cy - (aim[1] * h) / 2;
      pen.strokeRect(x - rem * 0.35, y - rem * 0.35, rem * 0.7, rem * 0.7);
    }
  }
  rateScale(pen, w, h, rem, run, state[3], predicted ? predicted[3] : null);
  text(pen, `${number(Math.hypot(state[0], state[1], state[2]), 1)} m`, rem * 0.6, h - rem * 0.9, COLOUR.measured);
}

function rateScale(pen, w, h, rem, run, rate, predicted) {
  const [x, top, bottom] = [w - rem * 2.9, rem * 1.5, h - rem * 1.2];
  const most = run.limits.closing * 1.34;
  const place = (v) => bottom - (Math.max(0, Math.min(most, v)) / most) * (bottom - top);
  pen.strokeStyle = '#dbe5eea0';
  pen.beginPath();
  pen.moveTo(x, top); pen.lineTo(x, bottom);
  for (let v = 0; v <= most + 1e-9; v += 0.05) {
    const long = Math.round(v * 100) % 10 === 0;
    pen.moveTo(x, place(v)); pen.lineTo(x + rem * (long ? 0.5 : 0.25), place(v));
    if (long) text(pen, v.toFixed(1), x + rem * 0.65, place(v), COLOUR.text);
  }
  pen.stroke();
  pen.strokeStyle = COLOUR.alarm;
  pen.beginPath(); pen.moveTo(x - rem * 0.5, place(run.limits.closing)); pen.lineTo(x + rem * 0.5, place(run.limits.closing)); pen.stroke();
  const arrow = (v, colour, hollow) => {
    if (v === null || !Number.isFinite(v)) return;
    const y = place(v);
    pen.beginPath(); pen.moveTo(x - rem * 0.1, y); pen.lineTo(x - rem * 0.75, y - rem * 0.36); pen.lineTo(x - rem * 0.75, y + rem * 0.36); pen.closePath();
    if (hollow) { pen.strokeStyle = colour; pen.stroke(); } else { pen.fillStyle = colour; pen.fill(); }
  };
  arrow(rate, COLOUR.measured, false);
  arrow(predicted, COLOUR.predicted, true);
  text(pen, 'm/s', x, top - rem * 0.7, COLOUR.dim, 'center');
}
