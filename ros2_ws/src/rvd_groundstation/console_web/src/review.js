// Review: a finished run in the same page, scrubbed, with the truth beside what was predicted.

import * as dialogs from './dialogs.js';
import { History, sample } from './data.js';
import { number } from './instruments.js';
import { rungAt, rungOf } from './ladder.js';
import { showModes } from './modes.js';
import { S, fill } from './strings.js';

const $ = (id) => document.getElementById(id);
const SPEED = 4; // simulated seconds per second when played

export class Review {
  // `warning` gives what is to be said to who opens a review now.
  constructor(link, panels, back, warning = () => '') {
    Object.assign(this, { link, panels, back, warning, on: false, run: null, at: 0, playing: false });
    $('review-close').onclick = () => this.leave();
    $('review-play').onclick = () => this.play(!this.playing);
    $('review-time').oninput = () => this.go(Number($('review-time').value));
    addEventListener('keydown', (event) => { if (this.on && event.key === 'Escape' && !$('dialog').open) this.leave(); });
  }

  async list() {
    try {
      const rows = await this.link.get('api/runs');
      dialogs.runList(rows, (name, error) => this.open(name, error), this.warning());
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
    this.history = new History(run.display, Infinity);
    for (const frame of run.frames) this.history.add(frame);
    this.rungs = run.ladder.map(rungOf);
    $('scrubber').hidden = false;
    $('bottom').hidden = true;
    $('review-time').max = String(run.frames.length - 1);
    this.panels.setDisplay(run.display);
    if (run.display.camera) $('camera-tag').textContent = run.display.camera.review_title;
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
    $('camera-tag').textContent = this.run.display.camera?.title || '';
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

  frame() {
    return this.run.frames[this.at];
  }

  show() {
    this.advance();
    const { run } = this;
    const frame = this.frame();
    const measured = sample(frame, run.display.measured);
    this.banner();
    showModes(run.display, frame, frame.mode, false);
    this.panels.clocks(frame, frame.t, measured ? fill(S.age, { s: number(frame.t - measured.t, 1) }) : '', '', false);
    this.panels.show({ run, frame, history: this.history, now: frame.t, stale: false, until: frame.t,
      rungs: this.rungs.filter((rung) => rung.sent <= frame.k).map((rung) => rungAt(rung, frame.k)) });
  }

  banner() {
    const element = $('banner');
    const last = this.at === this.run.frames.length - 1 && this.run.verdict;
    const words = last ? dialogs.sentence(this.run.verdict.words) : '';
    if (element.dataset.said !== words) {
      element.dataset.said = words;
      element.textContent = words;
    }
    element.classList.toggle('alarm', Boolean(last) && !this.run.verdict.success);
  }
}
