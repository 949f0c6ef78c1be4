// The command ladder: each command is a cell that travels from the ground over the link to the
// craft, and its answer back. Columns are places, time is what moves them.

import { LADDER, S } from './strings.js';
import { COLOUR, begin, text } from './canvas.js';

const [SENT, DUE, EXECUTED, SEEN, REFUSED, MISSED, UNKNOWN] = [0, 1, 2, 3, 4, 5, 6];
const KNOWN_S = 6; // how long known commands stay on the strip
const MARK = { [EXECUTED]: '✓', [SEEN]: '✓', [REFUSED]: '✗', [MISSED]: '✗', [UNKNOWN]: '?' };

// Where on the strip [0..1] a command is: up to .42 on the way out, .5 at the craft, then back.
export function place(rung, k, run) {
  const step = run.step_s;
  const out = Math.max(rung.due - rung.sent, 1);
  if (rung.told >= 0) return 0.8 + 0.2 * Math.min(1, ((k - rung.told) * step) / KNOWN_S);
  if (k < rung.due) return 0.05 + 0.37 * ((k - rung.sent) / out);
  const back = Math.max(run.back_s / step, 1);
  return 0.46 + 0.34 * Math.min(1, (k - rung.due) / back);
}

export function ladder(canvas, run, rungs, now) {
  const { pen, w, h, rem } = begin(canvas);
  const k = now / run.step_s;
  const top = rem * 1.35;
  const columns = [[0, 0.05, S.ladder_ground], [0.05, 0.42, S.ladder_link], [0.42, 0.5, S.ladder_craft],
    [0.5, 0.8, S.ladder_back], [0.8, 1, S.ladder_known]];
  for (const [from, to, name] of columns) {
    pen.fillStyle = name === S.ladder_craft ? '#17222e' : '#0a1018';
    pen.fillRect(from * w + 1, top, (to - from) * w - 2, h - top);
    if (from !== 0) text(pen, name, ((from + to) / 2) * w, rem * 0.55, COLOUR.dim, 'center');
  }
  text(pen, S.ladder_ground, 0, rem * 0.55, COLOUR.dim);
  const lanes = (h - top) / 3;
  ['x', 'y', 'z'].forEach((axis, i) => text(pen, axis, rem * 0.35, top + lanes * (i + 0.5), COLOUR.dim));
  const width = Math.max(2, (0.37 * w) / Math.max(run.forward_s / run.step_s, 8) - 1);
  for (const rung of rungs) {
    const at = place(rung, k, run);
    if (at >= 1 || (rung.told >= 0 && (k - rung.told) * run.step_s > KNOWN_S)) continue;
    draw(pen, rung, at * w, top, lanes, Math.min(width, rem), h, rem);
  }
}

function draw(pen, rung, x, top, lanes, width, h, rem) {
  const bad = rung.state === REFUSED || rung.state === MISSED;
  const busy = rung.levels.some((level) => level !== 0);
  const colour = rung.kind === 3 ? COLOUR.alarm : bad ? COLOUR.alarm
    : rung.state === SEEN ? COLOUR.ok : rung.state === EXECUTED ? COLOUR.ok
      : rung.state === UNKNOWN ? COLOUR.dim : rung.state === DUE ? COLOUR.predicted : COLOUR.measured;
  pen.fillStyle = colour;
  if (!busy && !bad && rung.kind !== 3) { // a neutral command: a tick only
    pen.globalAlpha = rung.state === SEEN ? 0.25 : 0.5;
    for (let i = 0; i < 3; i += 1) pen.fillRect(x, top + lanes * (i + 0.5) - 1, Math.max(width * 0.5, 1), 2);
    pen.globalAlpha = 1;
    return;
  }
  if (rung.kind === 3 || bad) pen.fillRect(x, top, Math.max(1.5, width * 0.4), h - top);
  rung.levels.forEach((level, i) => {
    if (!level) return;
    const size = (Math.abs(level) / 3) * lanes * 0.46;
    const y = top + lanes * (i + 0.5);
    if (rung.state === SENT) { // hollow until it is there
      pen.globalAlpha = 0.85;
    }
    pen.fillRect(x, level > 0 ? y - size : y, width, size);
    pen.globalAlpha = 1;
  });
  if (MARK[rung.state] && bad) text(pen, MARK[rung.state], x, top + rem * 0.4, colour);
}

export function counts(rungs) {
  const made = {};
  for (const rung of rungs) made[rung.state] = (made[rung.state] || 0) + 1;
  const underWay = (made[SENT] || 0);
  const parts = [`${underWay} ${S.ladder_link}`];
  for (const state of [EXECUTED, SEEN, REFUSED, MISSED, UNKNOWN]) {
    if (made[state]) parts.push(`${made[state]} ${LADDER[state]}`);
  }
  return parts.join(' · ');
}
