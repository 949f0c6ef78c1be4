// What the page knows of a run: its display, the newest frame, the ladder, what has been.

import { History, sample } from './data.js';
import { ABORT, rungOf } from './ladder.js';
import { Line } from './line.js';

const KEEP = 6000; // points of a history
const STALE_S = 0.8; // [s] of wall time, beyond what steps and delays explain

export class Store {
  constructor() {
    this.status = { phase: 'idle', lease: 'free', pages: 0, note: '' };
    this.can = { fly: false, desk: false, steer: true };
    this.line = new Line();
    this.display = null;
    this.asked = ''; // mode of a run that has not begun
    this.reset(null);
  }

  reset(run) {
    this.run = run;
    this.frame = null;
    this.frameAt = 0;
    this.verdict = null;
    this.ladder = new Map();
    this.events = [];
    this.abortAt = null;
    this.display = run?.display ?? this.display;
    this.history = new History(this.display, KEEP);
    if (run) {
      this.history.begin(run.trails);
      this.rungs(run.ladder || []);
    }
  }

  get connected() { return this.line.up; }

  take(message) {
    this.line.take(message);
    switch (message.type) {
      case 'hello':
        this.can = message.can;
        this.asked = message.mode || '';
        if (message.display && !this.display) this.display = message.display;
        if (!this.run || !message.flown) this.reset(null); // a server that was started anew knows of no run
        break;
      case 'run': this.reset(message); break;
      case 'status': this.status = message; break;
      case 'frame': this.takeFrame(message); break;
      case 'ladder': this.rungs(message.ladder); break;
      case 'verdict': this.verdict = message; break;
      case 'event': this.events.push(message); break;
      default:
    }
  }

  takeFrame(frame) {
    this.frame = frame;
    this.frameAt = performance.now();
    this.rungs(frame.ladder);
    this.history.add(frame);
    if (this.sent?.parts.kind === ABORT && this.abortAt === null) {
      const first = [...this.ladder.values()].find((rung) => rung.kind === ABORT);
      this.abortAt = (first?.sent ?? frame.k) * this.run.step_s;
    }
  }

  // The newest of what is shown as measured, as predicted, and of the command that was sent.
  get measured() { return sample(this.frame, this.display?.measured); }

  get predicted() { return sample(this.frame, this.display?.predicted); }

  get sent() { return this.frame?.signals[this.display.commands.sent]; }

  rungs(rows) {
    for (const row of rows) this.ladder.set(row[0], rungOf(row));
    while (this.ladder.size > 700) this.ladder.delete(this.ladder.keys().next().value);
  }

  // Whether a run is being flown, as far as this page knows.
  get inFlight() { return this.frame !== null && !this.verdict && this.status.phase === 'flying'; }

  // Simulated seconds now: frames come per step, the page counts on between them. Where the ground does not keep up
  // with what comes down, that tells how late it is.
  now() {
    if (!this.frame) return 0;
    const t = Math.max(this.frame.t, this.measured?.received ?? 0);
    if (this.frame.paused || !this.inFlight) return t;
    return t + Math.min(this.sinceFrame(), this.run.step_s);
  }

  // The same by this page's own clock, which goes on where frames do not: for the age of what is shown.
  clock() {
    const late = this.frame && this.dead() && this.inFlight && !this.frame.paused;
    return this.now() + (late ? Math.max(this.sinceFrame() - this.run.step_s, 0) : 0);
  }

  sinceFrame() {
    return ((performance.now() - this.frameAt) / 1000) * this.run.pace;
  }

  // Wall seconds since the last frame of a run that should be stepping; 0 when all is well.
  silence() {
    if (!this.inFlight || this.frame.paused) return 0;
    const s = (performance.now() - this.frameAt) / 1000;
    return s > STALE_S + this.run.step_s / this.run.pace ? s : 0;
  }

  // Whether nothing comes any more: from the server, or of a run that should be stepping.
  dead() {
    return this.line.dead || this.silence() > 0;
  }
}
