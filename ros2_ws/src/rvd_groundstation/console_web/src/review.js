// Review: a finished run in the same page, scrubbed, with the truth beside what was predicted.

import * as dialogs from './dialogs.js';
import { bullseye, clock, dial, errorRms, linkCounts, number } from './instruments.js';
import { counts, ladder } from './ladder.js';
import { S, fill } from './strings.js';

const $ = (id) => document.getElementById(id);
const SPEED = 4; // simulated seconds per second when played

export class Review {
  constructor(link, scene, charts, back) {
    Object.assign(this, { link, scene, charts, back, on: false, run: null, at: 0, playing: false });
    $('review-close').onclick = () => this.leave();
    $('review-play').onclick = () => this.play(!this.playing);
    $('review-time').oninput = () => this.go(Number($('review-time').value));
    addEventListener('keydown', (event) => { if (this.on && event.key === 'Escape' && !$('dialog').open) this.leave(); });
  }

  async list() {
    try {
      dialogs.runList(await this.link.get('api/runs'), (name, error) => this.open(name, error));
    } catch (problem) {
      dialogs.message(S.review_title, problem.message);
    }
  }

  async open(name, errorBox) {
    errorBox.textContent = S.review_loading;
    try {
      this.run = await this.link.get(`api/runs/${name.split('/').map(encodeURIComponent).join('/')}`);
    } catch (problem) {
      errorBox.textContent = problem.message;
      return;
    }
    dialogs.close();
    this.start();
  }

  start() {
    const { run } = this;
    this.on = true;
    this.errors = errorsOf(run.frames);
    this.trail = run.frames.filter((f) => f.est?.ok && f.pred?.ok).map((f) => [f.t, ...f.est.x.slice(0, 3),
      ...f.pred.x.slice(0, 3), f.pred.s ? Math.max(f.pred.s[1], f.pred.s[2]) : 0.05]);
    this.truths = run.frames.filter((f) => f.truth).map((f) => [f.t, ...f.truth.slice(0, 3)]);
    this.rungs = run.ladder.map(([seq, sent, due, x, y, z, kind, state, refusal, told]) => (
      { seq, sent, due, levels: [x, y, z], kind, state, refusal, told }));
    $('scrubber').hidden = false;
    $('bottom').hidden = true;
    $('review-time').max = String(run.frames.length - 1);
    document.querySelector('#camera .tag').textContent = S.camera_tag_review;
    this.scene.setRun(run);
    $('run-name').textContent = `${S.review}: ${run.name}`;
    this.marks();
    this.go(run.frames.length - 1);
    $('review-time').focus();
  }

  leave() {
    this.on = false;
    this.playing = false;
    $('scrubber').hidden = true;
    $('bottom').hidden = false;
    document.querySelector('#camera .tag').textContent = S.camera_tag;
    this.scene.place({ trail: [], tube: [] });
    this.back();
  }

  play(on) {
    this.playing = on;
    $('review-play').textContent = on ? S.stop_play : S.play;
    if (on && this.at >= this.run.frames.length - 1) this.go(0);
    this.playedAt = performance.now();
    this.playedFrom = this.run.frames[this.at].t;
  }

  go(index) {
    this.at = Math.max(0, Math.min(this.run.frames.length - 1, index));
    $('review-time').value = String(this.at);
    const now = this.run.frames[this.at].t;
    const events = this.run.events.filter((e) => e.t <= now);
    const last = events[events.length - 1];
    $('review-now').textContent = `${number(now, 1)} s${last && now - last.t < 5 ? ` · ${last.text}` : ''}`;
    $('review-time').setAttribute('aria-valuetext', $('review-now').textContent);
    if (this.playing) {
      this.playedAt = performance.now();
      this.playedFrom = now;
    }
    this.fresh = true;
  }

  advance() {
    if (!this.playing) return;
    const want = this.playedFrom + (SPEED * (performance.now() - this.playedAt)) / 1000;
    let i = this.at;
    while (i < this.run.frames.length - 1 && this.run.frames[i].t < want) i += 1;
    if (i !== this.at) {
      const [at, from] = [this.playedAt, this.playedFrom];
      this.go(i);
      Object.assign(this, { playedAt: at, playedFrom: from });
    }
    if (i >= this.run.frames.length - 1) this.play(false);
  }

  marks() {
    const box = $('review-time').getBoundingClientRect();
    const bar = $('review-marks');
    const end = this.run.frames[this.run.frames.length - 1].t || 1;
    bar.style.left = `${$('review-time').offsetLeft}px`;
    bar.style.width = `${box.width}px`;
    bar.innerHTML = '';
    for (const event of this.run.events) {
      const mark = document.createElement('i');
      mark.style.left = `${(event.t / end) * 100}%`;
      mark.title = `${number(event.t, 1)} s ${event.node}: ${event.text}`;
      bar.append(mark);
    }
  }

  camera() {
    const frame = this.run.frames[this.at];
    return { state: frame.truth || frame.tm?.x, predicted: null };
  }

  show({ motion, thrust }) {
    this.advance();
    const { run } = this;
    const frame = run.frames[this.at];
    const first = frame.tm?.x;
    const second = frame.pred?.ok ? frame.pred.x : null;
    this.banner();
    clock('gen', frame.tm ? frame.tm.gen : null, frame.tm ? fill(S.age, { s: number(frame.t - frame.tm.gen, 1) }) : '');
    clock('rx', frame.tm ? frame.tm.rx : null, '');
    clock('pred', second ? frame.pred.t : null, second ? fill(S.ahead, { s: number(frame.pred.t - frame.t, 1) }) : '');
    motion.show(first, second, run, false);
    bullseye($('bullseye'), run, first, second, frame.pred?.s, frame.margin, frame.truth);
    $('leave-time').textContent = frame.margin?.leave == null ? S.leave_never : `${frame.margin.leave.toFixed(0)} s`;
    thrust.show(frame.pilot, frame.auto, frame.cmd);
    dial($('dial'), run, frame.rtt, frame.tm?.transit);
    linkCounts(frame, run.step_s);
    const then = this.rungs.filter((r) => r.sent <= frame.k).map((r) => (r.told <= frame.k && r.told >= 0 ? r
      : { ...r, state: frame.k < r.due ? 0 : 1, told: -1 }));
    ladder($('ladder'), run, then, frame.t);
    $('ladder-counts').textContent = counts(then);
    const past = (rows) => rows.filter((row) => row[0] <= frame.t);
    const tube = past(this.trail).filter((row) => row[0] > frame.t - run.back_s - run.forward_s)
      .map((row) => [...row.slice(4, 7), 2 * row[7]]);
    this.scene.place({ measured: first?.slice(0, 3), predicted: second?.slice(0, 3), truth: frame.truth?.slice(0, 3),
      trail: past(this.trail).map((row) => row.slice(1, 4)), tube, drift: frame.margin?.path,
      truthTrail: past(this.truths).map((row) => row.slice(1)) });
    if (this.fresh) {
      this.fresh = false;
      this.charts.show(this.errors, frame.t);
      errorRms(frame.score);
    }
  }

  banner() {
    const element = $('banner');
    const last = this.at === this.run.frames.length - 1 && this.run.verdict;
    const words = last ? S.verdict[this.run.verdict.reason] || this.run.verdict.reason : '';
    if (element.dataset.said !== words) {
      element.dataset.said = words;
      element.textContent = words;
    }
    element.classList.toggle('alarm', Boolean(last) && !this.run.verdict.success);
  }
}

function errorsOf(frames) {
  const errors = { t: [], e: [[], [], [], [], [], []], s: [[], [], [], [], [], []] };
  for (const { score } of frames) {
    if (!score || score.t <= (errors.t[errors.t.length - 1] ?? -1)) continue;
    errors.t.push(score.t);
    for (let i = 0; i < 6; i += 1) {
      const unit = i < 3 ? 100 : 1000;
      errors.e[i].push(score.e[i] === null ? null : score.e[i] * unit);
      errors.s[i].push(score.s[i] === null ? null : 2 * score.s[i] * unit);
    }
  }
  return errors;
}
