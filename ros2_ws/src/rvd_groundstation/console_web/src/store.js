// What the page knows: the newest frame, the run's geometry, the trail, the ladder.

const KEEP = 6000; // points of a history

export class Store {
  constructor() {
    this.status = { phase: 'idle', lease: 'free', pages: 0, note: '' };
    this.can = { fly: false, desk: false };
    this.connected = false;
    this.reset(null);
  }

  reset(run) {
    this.run = run;
    this.frame = null;
    this.frameAt = 0;
    this.verdict = null;
    this.trail = []; // [t, est xyz, pred xyz, sigma of pred yz]
    this.ladder = new Map();
    this.errors = { t: [], e: [[], [], [], [], [], []], s: [[], [], [], [], [], []] };
    this.events = [];
    this.abortAt = null;
    if (run) {
      for (const row of run.trail || []) this.trail.push([...row, 0.1]);
      this.rungs(run.ladder || []);
    }
  }

  take(message) {
    switch (message.type) {
      case 'hello': this.can = message.can; break;
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
    const { est, pred, score } = frame;
    if (est && pred && pred.ok) {
      const last = this.trail[this.trail.length - 1];
      if (!last || frame.t > last[0]) {
        const sigma = pred.s ? Math.max(pred.s[1], pred.s[2]) : 0.05;
        this.trail.push([frame.t, ...est.x.slice(0, 3), ...pred.x.slice(0, 3), sigma]);
        if (this.trail.length > KEEP) this.trail.shift();
      }
    }
    const errors = this.errors;
    if (score && (!errors.t.length || score.t > errors.t[errors.t.length - 1])) {
      errors.t.push(score.t);
      for (let i = 0; i < 6; i += 1) {
        const unit = i < 3 ? 100 : 1000;
        errors.e[i].push(score.e[i] === null ? null : score.e[i] * unit);
        errors.s[i].push(score.s[i] === null ? null : 2 * score.s[i] * unit);
      }
    }
    if (frame.cmd && frame.cmd.kind === 3 && this.abortAt === null) this.abortAt = frame.t;
  }

  rungs(rows) {
    for (const row of rows) {
      const [seq, sent, due, x, y, z, kind, state, refusal, told] = row;
      this.ladder.set(seq, { seq, sent, due, levels: [x, y, z], kind, state, refusal, told });
    }
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
