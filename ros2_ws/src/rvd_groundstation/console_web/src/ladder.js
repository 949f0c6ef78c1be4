// The command ladder: each command is a cell that travels from the ground over the link to the
// craft, and its answer back. Columns are places, time is what moves them.

import { LADDER, S } from './strings.js';
import { COLOUR, begin, text } from './canvas.js';

const [SENT, DUE, EXECUTED, SEEN, REFUSED, MISSED, UNKNOWN] = [0, 1, 2, 3, 4, 5, 6];
export const ABORT = 3; // kind of a command
const NARROW_REM = 44; // a strip below this width has shorter names
const KNOWN_S = 6; // how long known commands stay on the strip
const MARK = { [EXECUTED]: '✓', [SEEN]: '✓', [REFUSED]: '✗', [MISSED]: '✗', [UNKNOWN]: '?' };

// A rung from its row in a message.
export function rungOf([seq, sent, due, kind, state, refusal, told, ...value]) {
  return { seq, sent, due, kind, state, refusal, told, value };
}

// A rung as it was known in step k.
export function rungAt(rung, k) {
  return rung.told >= 0 && rung.told <= k ? rung : { ...rung, state: k < rung.due ? SENT : DUE, told: -1 };
}

export const inForce = (rung) => rung.kind === ABORT && (rung.state === EXECUTED || rung.state === SEEN);

// Where on the strip [0..1] a command is: up to .42 on the way out, .5 at the craft, then back.
export function place(rung, k, run) {
  const step = run.step_s;
  const out = Math.max(rung.due - rung.sent, 1);
  if (rung.told >= 0) return 0.8 + 0.2 * Math.min(1, ((k - rung.told) * step) / KNOWN_S);
  if (k < rung.due) return 0.05 + 0.37 * ((k - rung.sent) / out);
  const back = Math.max(run.back_s / step, 1);
  return 0.46 + 0.34 * Math.min(1, (k - rung.due) / back);
}

export function ladder(canvas, run, axes, rungs, now) {
  const { pen, w, h, rem } = begin(canvas);
  const k = now / run.step_s;
  const top = rem * 1.35;
  const [ground, link, craft, back, known] = w < NARROW_REM * rem ? S.ladder_narrow
    : [S.ladder_ground, S.ladder_link, S.ladder_craft, S.ladder_back, S.ladder_known];
  const columns = [[0, 0.05, ground], [0.05, 0.42, link], [0.42, 0.5, craft], [0.5, 0.8, back], [0.8, 1, known]];
  for (const [from, to, name] of columns) {
    pen.fillStyle = name === craft ? '#17222e' : '#0a1018';
    pen.fillRect(from * w + 1, top, (to - from) * w - 2, h - top);
    if (from !== 0) text(pen, name, ((from + to) / 2) * w, rem * 0.55, COLOUR.dim, 'center');
  }
  text(pen, ground, 0, rem * 0.55, COLOUR.dim);
  const lane = (h - top) / axes.length;
  axes.forEach((axis, i) => text(pen, axis.name, rem * 0.35, top + lane * (i + 0.5), COLOUR.dim));
  const width = Math.max(2, (0.37 * w) / Math.max(run.forward_s / run.step_s, 8) - 1);
  const box = { top, lane, bottom: h, width: Math.min(width, rem), rem };
  for (const rung of rungs) {
    const at = place(rung, k, run);
    if (at >= 1 || (rung.told >= 0 && (k - rung.told) * run.step_s > KNOWN_S)) continue;
    draw(pen, rung, at * w, axes, box);
  }
}

function draw(pen, rung, x, axes, { top, lane, bottom, width, rem }) {
  const bad = rung.state === REFUSED || rung.state === MISSED;
  const busy = rung.value.some((v) => v !== 0);
  const colour = rung.kind === ABORT || bad ? COLOUR.alarm
    : rung.state === SEEN || rung.state === EXECUTED ? COLOUR.ok
      : rung.state === UNKNOWN ? COLOUR.dim : rung.state === DUE ? COLOUR.predicted : COLOUR.measured;
  pen.fillStyle = colour;
  if (!busy && !bad && rung.kind !== ABORT) { // a neutral command: a tick only
    pen.globalAlpha = rung.state === SEEN ? 0.25 : 0.5;
    axes.forEach((_, i) => pen.fillRect(x, top + lane * (i + 0.5) - 1, Math.max(width * 0.5, 1), 2));
    pen.globalAlpha = 1;
    return;
  }
  if (rung.kind === ABORT || bad) pen.fillRect(x, top, Math.max(1.5, width * 0.4), bottom - top);
  axes.forEach((axis, i) => {
    const value = rung.value[i];
    if (!value) return;
    const size = Math.min(Math.abs(value) / axis.highest, 1) * lane * 0.46;
    const y = top + lane * (i + 0.5);
    if (rung.state === SENT) pen.globalAlpha = 0.85; // paler until it is there
    pen.fillRect(x, value > 0 ? y - size : y, width, size);
    pen.globalAlpha = 1;
  });
  if (MARK[rung.state] && bad) text(pen, MARK[rung.state], x, top + rem * 0.4, colour);
}

export function counts(rungs, acknowledged) {
  const made = {};
  for (const rung of rungs) made[rung.state] = (made[rung.state] || 0) + 1;
  const underWay = (made[SENT] || 0);
  const parts = [...(rungs.some(inForce) ? [S.aborted] : []), `${underWay} ${S.ladder_link}`];
  if (!acknowledged) return [...parts, S.ladder_untold].join(' · '); // all others are unknown
  for (const state of [EXECUTED, SEEN, REFUSED, MISSED, UNKNOWN]) {
    if (made[state]) parts.push(`${made[state]} ${LADDER[state]}`);
  }
  return parts.join(' · ');
}
