// What a display refers to, looked up in a frame. Unknown is undefined, whatever the reason.

export const DIRECTIONS = { '+x': [1, 0, 0], '-x': [-1, 0, 0], '+y': [0, 1, 0], '-y': [0, -1, 0], '+z': [0, 0, 1], '-z': [0, 0, -1] };

export function sample(frame, signal) {
  const found = frame?.signals[signal];
  return found?.ok ? found : undefined;
}

export function part(frame, ref) {
  return ref ? sample(frame, ref.signal)?.parts[ref.part] ?? undefined : undefined;
}

const component = (value, i) => (Array.isArray(value) ? value[i] : value);

// A component of a part, or the length of several, which is negative where component `past` is positive.
export function number(frame, { signal, part: name, index, factor, past }) {
  const value = sample(frame, signal)?.parts[name];
  if (value === undefined || value === null) return undefined;
  const picked = index.map((i) => component(value, i));
  if (picked.some((v) => v === null || v === undefined)) return undefined;
  const sign = past !== null && past !== undefined && component(value, past) > 0 ? -1 : 1;
  return factor * (picked.length === 1 ? picked[0] : sign * Math.hypot(...picked));
}

// A limit or a radius: a number that stands, or one of a signal.
export function amount(frame, value) {
  return value !== null && typeof value === 'object' ? number(frame, value) : value ?? undefined;
}

// The numbers of a part as a point; those that a mission with fewer axes does not have are 0.
export function point(value, axes = 'xyz') {
  if (value === undefined || value === null) return undefined;
  const made = [0, 0, 0];
  for (let i = 0; i < axes.length; i += 1) {
    const v = component(value, i);
    if (v === null || v === undefined) return undefined;
    made['xyz'.indexOf(axes[i])] = v;
  }
  return made;
}

// Where a thing is: a point that stands, or a part of a signal.
export function place(frame, at, axes) {
  return Array.isArray(at) ? at : point(part(frame, at), axes);
}

export function along(direction, p) {
  const d = DIRECTIONS[direction];
  return d[0] * p[0] + d[1] * p[1] + d[2] * p[2];
}

// What the page remembers of a run: trails and charts, filled from frames as they come.
export class History {
  constructor(display, keep) {
    this.display = display;
    this.keep = keep;
    this.trails = new Map(); // name: rows [t of the frame, instant it is valid for, x, y, z, spread]
    for (const line of display?.lines || []) if (line.kind === 'trail') this.trails.set(line.name, []);
    this.charts = (display?.charts?.strips || []).map((strip) => ({ t: [], curves: strip.curves.map(() => []), spread: [] }));
  }

  // Rows [t, instant, place..., spread] of the time before this page was there.
  begin(trails) {
    for (const line of this.display.lines) {
      for (const row of trails?.[line.name] || []) {
        const at = point(row.slice(2, -1), line.axes);
        if (at) this.trails.get(line.name).push([row[0], row[1], ...at, row[row.length - 1] ?? 0]);
      }
    }
  }

  add(frame) {
    for (const line of this.display.lines) {
      if (line.kind === 'trail') this.extend(line, frame);
    }
    this.display.charts?.strips.forEach((strip, i) => this.plot(strip, this.charts[i], frame));
  }

  extend(line, frame) {
    const rows = this.trails.get(line.name);
    const at = place(frame, line.place, line.axes);
    if (!at || (rows.length && frame.t <= rows[rows.length - 1][0])) return;
    const spread = line.spread ? number(frame, line.spread) ?? 0 : 0;
    rows.push([frame.t, frame.signals[line.place.signal].t, ...at, spread]);
    if (rows.length > this.keep) rows.shift();
  }

  plot(strip, chart, frame) {
    const signals = [...strip.curves, strip.spread].filter(Boolean).map((one) => one.signal);
    const newest = sample(frame, signals.find((signal) => signal !== 'truth') ?? 'truth');
    if (!newest || newest.t <= (chart.t[chart.t.length - 1] ?? -Infinity)) return;
    chart.t.push(newest.t);
    strip.curves.forEach((curve, i) => chart.curves[i].push(number(frame, curve) ?? null));
    const spread = strip.spread ? number(frame, strip.spread) : undefined;
    chart.spread.push(spread === undefined ? null : spread * strip.spread_factor);
  }
}

// The points of a trail as rows of x, y, z and spread from `at` on, `n` of them: all until `now`,
// or with `since` the way from there to the newest.
export function trailOf(line, rows, frame, now, most) {
  let n = rows.length;
  while (n > 0 && rows[n - 1][0] > now) n -= 1;
  if (!line.since) return { rows, at: 2, n };
  const begin = sample(frame, line.since.signal);
  const end = place(frame, line.place, line.axes);
  const from = place(frame, line.since, line.axes);
  if (!begin || !end || !from) return { rows: [], at: 0, n: 0 };
  const spread = line.spread ? number(frame, line.spread) ?? 0 : 0;
  const made = [[...from, line.since_spread ? number(frame, line.since_spread) ?? 0 : 0]];
  const anew = part(frame, line.anew);
  if (anew) { // other commands act than those that were predicted with
    for (const row of anew) made.push([...point(row, line.axes), spread]);
  } else {
    const until = sample(frame, line.place.signal).t; // after the end less is shown than was predicted
    while (n > 0 && rows[n - 1][1] > until) n -= 1;
    let first = n;
    while (first > 0 && rows[first - 1][1] > begin.t) first -= 1;
    const stride = Math.max(1, Math.floor((n - first) / most));
    for (let i = first; i < n; i += stride) made.push(rows[i].slice(2));
  }
  made.push([...end, spread]);
  return { rows: made, at: 0, n: made.length };
}
