// What the page knows of a run: its display, the newest frame, the ladder, what has been.

import { History, sample } from './data.js';
import { ABORT, rungOf } from './ladder.js';

const KEEP = 6000; // points of a history

export class Store {
  constructor() {
    this.status = { phase: 'idle', lease: 'free', pages: 0, note: '' };
    this.can = { fly: false, desk: false };
    this.connected = false;
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
    if (run) {
      this.display = run.display;
      this.history = new History(run.display, KEEP);
      this.history.begin(run.trails);
      this.rungs(run.ladder || []);
    }
  }

  take(message) {
    switch (message.type) {
      case 'hello':
        this.can = message.can;
        this.asked = message.mode || '';
        if (message.display && !this.display) this.display = message.display;
        break;
      case 'run': this.reset(message); break;
      case 'status': this.status = message; break;
      case 'frame': this.takeFrame(message); break;
      case 'ladder': this.rungs(message.ladder); break;
      case 'verdict': this.verdict = message; break;
      case 'event': this.events.push(message); break;
      default:
    }
    if (!message.type && message.link) { // from the worker: the socket itself
      this.connected = message.link === 'open';
      if (message.why) this.why = message.why;
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

  // Simulated seconds now: frames come per step, the page counts on between them.
  now() {
    if (!this.frame) return 0;
    if (this.frame.paused || this.verdict || this.status.phase !== 'flying') return this.frame.t;
    const since = ((performance.now() - this.frameAt) / 1000) * this.run.pace;
    return this.frame.t + Math.min(since, this.run.step_s);
  }

  // Wall seconds since the last frame of a run that should be stepping; 0 when all is well.
  silence() {
    if (!this.frame || this.verdict || this.frame.paused || this.status.phase !== 'flying') return 0;
    return (performance.now() - this.frameAt) / 1000;
  }
}
