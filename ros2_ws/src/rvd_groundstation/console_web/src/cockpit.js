// What a craft with six axes has beside its instruments: the attitude indicator, lamps, and the
// points that a camera's image was found to hold.

import { COLOUR, begin, ring, say, small, text } from './canvas.js';
import { number as read, part } from './data.js';
import { number, readout } from './instruments.js';

const $ = (id) => document.getElementById(id);
const ROLL_SHARE = 0.75 * Math.PI; // of the roll's mark at full scale, from the top

// -- attitude -----------------------------------------------------------------------------------

export function setAttitude(panel) {
  $('attitude').hidden = !panel;
  if (!panel) return;
  $('attitude-title').textContent = panel.title;
  $('ball').setAttribute('aria-label', panel.alt);
}

const holds = (scales, values) => {
  const most = Math.max(0, ...values.filter((v) => v !== undefined).map(Math.abs));
  return scales.find((scale) => most <= scale) ?? scales[scales.length - 1];
};
const share = (value, scale) => Math.max(-1, Math.min(1, value / scale));
const signed = (value, digits) => (value > 0 ? `+${number(value, digits)}` : number(value, digits));

// Up is pitch up, right is yaw to the right (about the axis that points down), clockwise is roll.
export function drawAttitude(panel, frame) {
  const { pen, w, h, rem } = begin($('ball'));
  const size = Math.min(w * 0.6, h) / 2 - 0.95 * rem;
  const [cx, cy] = [size + 1.1 * rem, h / 2];
  const of = (numbers) => numbers?.map((one) => read(frame, one));
  const first = panel.needles[0];
  const [angles, rates] = [of(first.angles), of(first.rates)];
  const scale = holds(panel.scales, angles);
  const rateScale = rates ? holds(panel.rate_scales, rates) : 1;
  pen.fillStyle = '#0a1420';
  pen.beginPath(); pen.arc(cx, cy, size, 0, 7); pen.fill();
  ring(pen, cx, cy, size, COLOUR.dim);
  pen.strokeStyle = COLOUR.line;
  pen.beginPath();
  pen.moveTo(cx - size, cy); pen.lineTo(cx + size, cy); pen.moveTo(cx, cy - size); pen.lineTo(cx, cy + size);
  for (const k of [-0.5, 0.5]) {
    pen.moveTo(cx + k * size, cy - rem * 0.25); pen.lineTo(cx + k * size, cy + rem * 0.25);
    pen.moveTo(cx - rem * 0.25, cy + k * size); pen.lineTo(cx + rem * 0.25, cy + k * size);
  }
  for (const k of [-1, -0.5, 0, 0.5, 1]) { // of the roll
    const a = k * ROLL_SHARE - Math.PI / 2;
    pen.moveTo(cx + size * Math.cos(a), cy + size * Math.sin(a));
    pen.lineTo(cx + (size - rem * 0.4) * Math.cos(a), cy + (size - rem * 0.4) * Math.sin(a));
  }
  pen.stroke();
  if (panel.limit !== null && panel.limit <= scale) ring(pen, cx, cy, (panel.limit / scale) * size, COLOUR.limit, [rem * 0.3, rem * 0.25]);
  for (const needles of [...panel.needles].reverse()) {
    const [roll, pitch, yaw] = of(needles.angles);
    if (roll === undefined) continue;
    const colour = COLOUR[needles.role];
    pen.strokeStyle = colour;
    pen.fillStyle = colour;
    const inner = size - 0.15 * rem;
    const [x, y] = [cx + share(yaw, scale) * inner, cy - share(pitch, scale) * inner];
    const across = (d) => Math.sqrt(Math.max(inner * inner - d * d, 0)) * 0.8;
    pen.lineWidth = rem * (needles === first ? 0.16 : 0.08);
    pen.beginPath();
    pen.moveTo(cx - across(y - cy), y); pen.lineTo(cx + across(y - cy), y);
    pen.moveTo(x, cy - across(x - cx)); pen.lineTo(x, cy + across(x - cx));
    pen.stroke();
    const a = share(roll, scale) * ROLL_SHARE - Math.PI / 2;
    const tip = (r, b) => [cx + r * Math.cos(b), cy + r * Math.sin(b)];
    pen.beginPath();
    pen.moveTo(...tip(size, a)); pen.lineTo(...tip(size - rem * 0.8, a - 0.09)); pen.lineTo(...tip(size - rem * 0.8, a + 0.09)); pen.closePath();
    if (needles === first) pen.fill(); else { pen.lineWidth = rem / 12; pen.stroke(); }
  }
  pen.lineWidth = rem / 12;
  if (rates && rates[0] !== undefined) edges(pen, cx, cy, size, rem, rates.map((v) => share(v, rateScale)), COLOUR[first.role]);
  pen.strokeStyle = COLOUR.text; // the craft
  pen.beginPath();
  pen.moveTo(cx - rem * 0.9, cy); pen.lineTo(cx - rem * 0.3, cy); pen.moveTo(cx + rem * 0.3, cy); pen.lineTo(cx + rem * 0.9, cy);
  pen.stroke();
  numbers(pen, panel, { angles, rates, scale, rateScale, w, h, rem });
}

// Arrows outside of the ring: rates of roll above, pitch at the right, yaw below.
function edges(pen, cx, cy, size, rem, [roll, pitch, yaw], colour) {
  pen.fillStyle = colour;
  const arrow = (x, y, dx, dy) => {
    pen.beginPath();
    pen.moveTo(x, y); pen.lineTo(x + dx * rem * 0.6 - dy * rem * 0.3, y + dy * rem * 0.6 + dx * rem * 0.3);
    pen.lineTo(x + dx * rem * 0.6 + dy * rem * 0.3, y + dy * rem * 0.6 - dx * rem * 0.3); pen.closePath(); pen.fill();
  };
  const out = size + rem * 0.25;
  arrow(cx + roll * size, cy - out, 0, -1);
  arrow(cx + out, cy - pitch * size, 1, 0);
  arrow(cx + yaw * size, cy + out, 0, 1);
}

function numbers(pen, panel, { angles, rates, scale, rateScale, w, h, rem }) {
  const right = w - rem * 0.2;
  const left = w * 0.6 + rem * 1.3;
  ['roll', 'pitch', 'yaw'].forEach((name, i) => {
    const y = h / 2 + (i - 1.4) * rem * 2.3;
    text(pen, name, left, y, COLOUR.dim);
    pen.font = `600 ${0.95 * rem}px system-ui, sans-serif`;
    const beyond = panel.limit !== null && Math.abs(angles[i]) > panel.limit;
    text(pen, `${beyond ? '▲ ' : ''}${signed(angles[i], panel.digits)}`, right, y, COLOUR[panel.needles[0].role], 'right');
    pen.font = `${small(rem)}px system-ui, sans-serif`;
    if (rates) text(pen, `${signed(rates[i], panel.digits + 1)} /s`, right, y + rem * 0.95, COLOUR.dim, 'right');
  });
  const words = [`ring ±${scale} ${panel.unit}`, ...(rates ? [`edge ±${rateScale} ${panel.unit}/s`] : [])];
  words.forEach((line, i) => text(pen, line, right, h - rem * (1.5 - i), COLOUR.dim, 'right'));
}

// -- lamps --------------------------------------------------------------------------------------

export function setLamps(panel) {
  $('lamps').hidden = !panel;
  if (!panel) return;
  $('lamps-title').textContent = panel.title;
  $('lights').setAttribute('aria-label', panel.alt);
  $('lights').style.height = `${2 * panel.groups.length}rem`;
}

export function drawLamps(panel, frame) {
  const { pen, w, h, rem } = begin($('lights'));
  const [on, glow, counts] = [panel.on, panel.glow, panel.counts].map((ref) => part(frame, ref));
  if (panel.note) readout(part(frame, panel.note) ?? ['', false], $('lamps-note'), 'dim');
  const most = Math.max(...panel.groups.map((group) => group.labels.length + changes(group.labels) * 0.5));
  const [from, to] = [11.5 * rem, w - 5.2 * rem];
  const pitch = Math.min((to - from) / most, 2.6 * rem);
  let n = 0;
  panel.groups.forEach((group, row) => {
    const y = (row + 0.36) * (h / panel.groups.length);
    text(pen, group.name, 0, y, COLOUR.text);
    text(pen, group.words, 1.8 * rem, y, COLOUR.dim);
    let x = from;
    group.labels.forEach((label, i) => {
      const fresh = i === 0 || group.labels[i - 1] !== label;
      if (fresh && i > 0) x += pitch * 0.5;
      const lit = Math.max(glow?.[n] ?? 0, on?.[n] ? 1 : 0);
      ring(pen, x, y, rem * 0.42, on?.[n] ? '#ffffff' : '#3a4f63');
      pen.globalAlpha = lit;
      pen.fillStyle = COLOUR[panel.role];
      pen.beginPath(); pen.arc(x, y, rem * 0.4, 0, 7); pen.fill();
      pen.globalAlpha = 1;
      let same = i;
      while (group.labels[same + 1] === label) same += 1;
      if (fresh) text(pen, label, x + ((same - i) * pitch) / 2, y + rem * 0.92, COLOUR.dim, 'center');
      x += pitch;
      n += 1;
    });
    if (counts) text(pen, `${counts[row]} pulses`, w, y, COLOUR.text, 'right');
  });
}

const changes = (labels) => labels.filter((label, i) => i > 0 && labels[i - 1] !== label).length;

// -- points of a camera's image -----------------------------------------------------------------

// Over the picture whose half height is the tangent `tan`: its sensor's edge, and each point:
// full where it is used, a ring where it is seen and not used.
export function drawPixels(pen, { w, h, rem }, pixels, frame, tan) {
  const scale = h / 2 / tan;
  const [cx, cy] = [w / 2, h / 2];
  const half = pixels.half_view * scale;
  pen.strokeStyle = COLOUR.limit;
  pen.strokeRect(cx - half, cy - half, 2 * half, 2 * half);
  const [at, used] = [part(frame, pixels.points), part(frame, pixels.used)];
  if (!at) return;
  const size = pixels.width_px;
  for (let i = 0; 2 * i < at.length; i += 1) {
    if (at[2 * i] === null || at[2 * i + 1] === null) continue;
    const x = cx + (at[2 * i] / size - 0.5) * 2 * half;
    const y = cy + (at[2 * i + 1] / size - 0.5) * 2 * half;
    pen.lineWidth = rem / 8;
    ring(pen, x, y, rem * 0.38, used?.[i] ? COLOUR.ok : COLOUR.dim);
    pen.lineWidth = rem / 12;
    if (!used?.[i]) continue;
    pen.fillStyle = COLOUR.ok;
    pen.beginPath(); pen.arc(x, y, rem * 0.14, 0, 7); pen.fill();
  }
}
