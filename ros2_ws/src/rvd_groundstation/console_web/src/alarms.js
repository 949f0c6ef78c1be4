// Alarms: which stand, and which of them have been acknowledged. Judged from what the page shows.

import { amount, number } from './data.js';

const HOLD_S = 2; // wall time for which a reading must be back inside before its alarm goes
const TELL_S = 0.6; // likewise, for which nobody must hold the stick
const STALE_S = 1; // beyond what the delay explains

// How far a reading is beyond its limit, with value and limit; undefined while it is not known.
export function beyond(frame, { role, value, low, high }) {
  const seen = number(frame, value);
  const [least, most] = [amount(frame, low), amount(frame, high)];
  if (seen === undefined) return undefined;
  const found = [];
  if (least !== undefined) found.push({ role, value: seen, limit: least, over: least - seen, sense: '<' });
  if (most !== undefined) found.push({ role, value: seen, limit: most, over: seen - most, sense: '>' });
  return found.sort((a, b) => b.over - a.over)[0];
}

// The reading of an alarm that is furthest beyond its limit.
export function worst(frame, alarm) {
  return alarm.readings.map((reading) => beyond(frame, reading)).filter(Boolean)
    .sort((a, b) => b.over - a.over)[0];
}

// Those of a display. `stands` says whether one has been raised: what is not known changes nothing.
export function ofDisplay(frame, alarms, stands) {
  return alarms.map((alarm) => {
    const seen = worst(frame, alarm);
    const before = stands(alarm.words);
    const on = !seen ? before : seen.over >= 0 || (before && seen.over > -alarm.back);
    return { words: alarm.words, level: alarm.level, on, seen: seen && { ...seen, label: alarm.label, unit: alarm.unit, digits: alarm.digits } };
  });
}

// Those of the page, whatever is flown: telemetry that does not come, a stick that nobody holds.
// `flies` is what `decided` found in the newest command.
export function ofPage({ run, frame, measured, flies, silence, connected, pilotLost }, words) {
  const pace = Math.max(run.pace, 1);
  const patience = STALE_S + run.step_s / run.pace; // wall time: a frame comes with each step
  const quiet = connected ? silence : Math.max(silence, patience);
  const age = Math.max(frame.t, measured?.received ?? 0) + quiet * run.pace - (measured ? measured.t : 0);
  const lost = quiet >= patience || age > run.back_s + 2 * run.step_s + STALE_S * pace;
  const nobody = run.operator === 'console' && flies?.unheld;
  return [
    { words: words.telemetry, level: 'warning', on: lost, age },
    { words: words.pilot, level: 'warning', on: Boolean(pilotLost), flies },
    { words: words.nobody, level: 'caution', on: Boolean(nobody && !pilotLost), flies, after: TELL_S },
  ];
}

export class Alarms {
  constructor() {
    this.standing = new Map(); // words: { level, seen, age, flies, last, acknowledged }
    this.pending = new Map(); // words: since when
  }

  stands(words) {
    return this.standing.has(words);
  }

  clear() {
    this.standing.clear();
    this.pending.clear();
  }

  // `found` are rows { words, level, on, seen, age, flies, after } in the order of their weight.
  judge(found, now) {
    for (const one of found) {
      const old = this.standing.get(one.words);
      if (!one.on) this.pending.delete(one.words);
      else if (!this.pending.has(one.words)) this.pending.set(one.words, now);
      const on = one.on && (old || now - this.pending.get(one.words) >= (one.after || 0));
      if (on) this.standing.set(one.words, { acknowledged: false, ...old, ...one, last: now });
      else if (old && now - old.last >= HOLD_S) this.standing.delete(one.words);
      else if (old) Object.assign(old, { seen: one.seen ?? old.seen, age: one.age, flies: one.flies });
    }
    const places = new Map(found.map(({ words }, i) => [words, i]));
    for (const words of this.standing.keys()) if (!places.has(words)) this.standing.delete(words);
    const weight = (one) => [one.acknowledged ? 1 : 0, one.level === 'warning' ? 0 : 1, places.get(one.words)];
    this.shown = [...this.standing.values()].sort((a, b) => {
      const [x, y] = [weight(a), weight(b)];
      return x[0] - y[0] || x[1] - y[1] || x[2] - y[2];
    });
    return this.shown;
  }

  acknowledge() {
    for (const one of this.standing.values()) one.acknowledged = true;
  }

  // The gravest level that calls for attention: '', 'caution' or 'warning'.
  get loud() {
    const calling = [...this.standing.values()].filter((one) => !one.acknowledged);
    return calling.some((one) => one.level === 'warning') ? 'warning' : calling.length ? 'caution' : '';
  }
}
