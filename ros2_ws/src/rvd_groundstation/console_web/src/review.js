// Review: a finished run in the same page, scrubbed, with the truth beside what was predicted.

import { banner } from './banner.js';
import * as dialogs from './dialogs.js';
import { History, sample } from './data.js';
import { number } from './instruments.js';
import { inForce, rungAt, rungOf } from './ladder.js';
import { label, showModes } from './modes.js';
import { Film, figure, save, table } from './review_export.js';
import { showRuns } from './review_list.js';
import './review.css';
import { typing } from './stick.js';
import { S, fill } from './strings.js';

const $ = (id) => document.getElementById(id);
const SPEEDS = [0.25, 0.5, 1, 2, 4, 8, 16]; // simulated seconds per second when played
const USUAL = 4;
const FRESH_S = 5; // for so long an event is written out
const LIVE_KEYS = new Set(['KeyM', 'KeyP', 'KeyT']); // they change the flight, which is not in view

export class Review {
  // `back` is called when a review is left; `warning` gives what is to be said to who opens one now.
  constructor(link, panels, store, back, warning = () => '') {
    Object.assign(this, { link, panels, store, back, warning, on: false, run: null, at: 0, playing: false, speed: USUAL, film: null });
    const presses = {
      'review-close': () => this.leave(), 'review-play': () => this.play(!this.playing),
      'review-step-back': () => this.step(-1), 'review-step-on': () => this.step(1),
      'review-event-back': () => this.jump(-1), 'review-event-on': () => this.jump(1),
      'review-report': () => this.report(this.run.name, $('review-now')),
      'review-png': () => this.saveFigure(), 'review-csv': () => save(`${this.file()}.csv`, table(this.run), 'text/csv'),
      'review-webm': () => this.record(),
    };
    for (const [id, press] of Object.entries(presses)) $(id).onclick = press;
    for (const id of ['report', 'png', 'csv', 'webm']) $(`review-${id}`).title = S[`review_${id}_hint`];
    $('review-webm').disabled = !Film.possible;
    if (!Film.possible) $('review-webm').title = S.review_webm_none;
    $('review-time').oninput = () => this.seek(Number($('review-time').value));
    $('review-speed').replaceChildren(...SPEEDS.map((n) => new Option(fill(S.review_times, { n }), n)));
    $('review-speed').value = USUAL;
    $('review-speed').onchange = () => { this.setSpeed(Number($('review-speed').value)); $('review-time').focus(); };
    $('review-events').onchange = () => {
      this.toEvent(this.run.events[Number($('review-events').value)]);
      $('review-events').value = '';
      $('review-time').focus();
    };
    // Before anybody else: here an arrow moves the review, and no craft.
    addEventListener('keydown', (event) => this.key(event), true);
  }

  // -- the list, and its reports --------------------------------------------------------------

  list() {
    showRuns(this);
  }

  async open(row, errorBox) {
    errorBox.textContent = S.review_loading;
    try {
      this.run = await this.link.get(`api/runs/${path(row.name)}`);
    } catch (problem) {
      errorBox.textContent = problem.message;
      return;
    }
    this.row = row;
    dialogs.close();
    if (this.on) this.end();
    this.start();
  }

  // The report is a page of its own: the server gives it an address that needs no token.
  async report(name, errorBox) {
    const tab = window.open('', '_blank'); // now, while the press still counts as one
    if (!tab) {
      errorBox.textContent = S.review_no_tab;
      return;
    }
    tab.opener = null;
    try {
      const { url } = await this.link.get(`api/reports/${path(name)}`);
      tab.location.replace(new URL(url, location.href));
    } catch (problem) {
      tab.close();
      errorBox.textContent = problem.message;
    }
  }

  // -- coming and going -----------------------------------------------------------------------

  start() {
    const { run } = this;
    this.on = true;
    this.history = new History(run.display, Infinity);
    for (const frame of run.frames) this.history.add(frame);
    this.rungs = run.ladder.map(rungOf);
    this.shownRungs = { k: -1, rungs: [] };
    $('scrubber').hidden = false;
    $('bottom').hidden = true;
    document.body.classList.add('reviewing');
    document.body.classList.remove('stale');
    $('review-time').max = String(run.frames.length - 1);
    this.panels.setDisplay(run.display);
    if (run.display.camera) $('camera-tag').textContent = run.display.camera.review_title;
    $('run-name').textContent = [fill(S.review_of, { name: run.name }), ...this.facts()].join(' · ');
    $('run-name').title = $('run-name').textContent;
    this.marks();
    this.play(false);
    this.go(run.frames.length - 1);
    $('review-time').focus();
  }

  // Of the reviewed run: the mode it began in, delays, seed.
  facts() {
    const { run } = this;
    const mode = run.display.modes.length ? fill(S.review_flown, { mode: label(run.display, run.mode) }) : '';
    return [mode, run.display.link ? `${run.forward_s} s + ${run.back_s} s` : '', fill(S.review_seed, { n: run.seed })].filter(Boolean);
  }

  end() {
    this.film?.stop();
    this.on = false;
    this.playing = false;
  }

  // Nothing of it stays: what is shown next is shown on a page that is as new.
  leave() {
    this.end();
    $('scrubber').hidden = true;
    $('bottom').hidden = false;
    document.body.classList.remove('reviewing');
    $('run-name').textContent = '';
    $('run-name').title = '';
    $('camera-tag').textContent = this.run.display.camera?.title || '';
    banner('');
    this.panels.blank();
    this.back();
    document.activeElement?.blur(); // it may have been in the bar that is gone
  }

  // -- where it stands ------------------------------------------------------------------------

  key(event) {
    if (!this.on || $('dialog').open || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.code !== 'Escape' && typing(event.target)) return;
    if (event.code === 'Space' && event.target instanceof HTMLButtonElement) {
      event.stopImmediatePropagation(); // it presses that button, and is no dead-man
      return;
    }
    const act = {
      Escape: () => this.leave(), Space: () => event.repeat || this.play(!this.playing),
      ArrowLeft: () => (event.shiftKey ? this.jump(-1) : this.step(-1)), ArrowRight: () => (event.shiftKey ? this.jump(1) : this.step(1)),
      ArrowUp: () => this.faster(1), ArrowDown: () => this.faster(-1),
      Home: () => this.seek(0), End: () => this.seek(this.run.frames.length - 1),
    }[event.code];
    if (!act && !LIVE_KEYS.has(event.code)) return;
    event.preventDefault();
    event.stopImmediatePropagation();
    act?.();
  }

  play(on) {
    this.playing = on;
    $('review-play').textContent = on ? S.stop_play : S.play;
    if (on && this.at >= this.run.frames.length - 1) this.go(0);
    this.rebase();
  }

  // Played time counts from here.
  rebase() {
    this.playedAt = performance.now();
    this.playedFrom = this.run.frames[this.at].t;
    this.filmed = 0;
  }

  setSpeed(speed) {
    this.speed = speed;
    $('review-speed').value = String(speed);
    if (this.on) this.rebase();
  }

  faster(by) {
    this.setSpeed(SPEEDS[Math.max(0, Math.min(SPEEDS.length - 1, SPEEDS.indexOf(this.speed) + by))]);
  }

  step(by) {
    this.play(false);
    this.go(this.at + by);
  }

  // To the next picture on which something has happened, or back to the one before.
  jump(sense) {
    const stops = this.stops.filter((i) => (sense > 0 ? i > this.at : i < this.at));
    if (!stops.length) return;
    this.play(false);
    this.go(sense > 0 ? Math.min(...stops) : Math.max(...stops));
  }

  toEvent(event) {
    if (!event) return;
    this.play(false);
    this.go(this.pictureOf(event));
  }

  // The first picture in which an event has happened.
  pictureOf({ t }) {
    const i = this.run.frames.findIndex((frame) => frame.t >= t - 1e-9);
    return i < 0 ? this.run.frames.length - 1 : i;
  }

  go(index) {
    this.at = Math.max(0, Math.min(this.run.frames.length - 1, index));
    $('review-time').value = String(this.at);
    const now = this.run.frames[this.at].t;
    const last = this.run.events.findLast((event) => event.t <= now);
    const words = `${number(now, 1)} s${last && now - last.t < FRESH_S ? ` · ${this.eventWords(last)}` : ''}`;
    $('review-now').textContent = words;
    $('review-now').title = words;
    $('review-time').setAttribute('aria-valuetext', words);
  }

  // Go there, and play on from there where it plays.
  seek(index) {
    this.go(index);
    this.rebase();
  }

  eventWords({ code, text }) {
    return (this.run.operator === 'console' && S.stick_events[code]) || text;
  }

  // By the clock, unless a video is made: then by its pictures.
  advance() {
    if (this.playing && !this.film) this.playTo(performance.now() - this.playedAt);
  }

  playTo(ms) {
    const want = this.playedFrom + (this.speed * ms) / 1000;
    let i = this.at;
    while (i < this.run.frames.length - 1 && this.run.frames[i].t < want) i += 1;
    if (i !== this.at) this.go(i);
    if (i >= this.run.frames.length - 1) this.play(false);
  }

  filmOn(ms) {
    this.filmed += ms;
    if (this.on && this.playing) this.playTo(this.filmed);
    return this.on && this.playing;
  }

  // Events on the slider, where its thumb stands when they have happened, and in their list.
  marks() {
    const { events, frames } = this.run;
    const most = Math.max(frames.length - 1, 1);
    this.stops = [...new Set(events.map((event) => this.pictureOf(event)))];
    $('review-marks').replaceChildren(...this.stops.map((i) => {
      const mark = document.createElement('i');
      mark.style.left = `${(i / most) * 100}%`;
      return mark;
    }));
    const title = events.length ? fill(S.review_events_some, { n: events.length }) : S.review_events_none;
    $('review-events').disabled = !events.length;
    $('review-events').replaceChildren(new Option(title, ''), ...events.map((event, i) => new Option(`${number(event.t, 1)} s · ${this.eventWords(event)}`, i)));
  }

  frame() {
    return this.run.frames[this.at];
  }

  // -- what it shows --------------------------------------------------------------------------

  show() {
    this.advance();
    const { run } = this;
    const frame = this.frame();
    const measured = sample(frame, run.display.measured);
    const rungs = this.ladderAt(frame.k);
    this.say(rungs);
    showModes(run.display, frame, frame.mode, false);
    this.panels.clocks(frame, frame.t, measured ? fill(S.age, { s: number(frame.t - measured.t, 1) }) : '', '', false);
    this.panels.show({ run, frame, history: this.history, now: frame.t, stale: false, until: frame.t, rungs });
  }

  // The commands that had been sent by step k, as they were known then.
  ladderAt(k) {
    if (this.shownRungs.k !== k) {
      const sent = this.rungs.findIndex((rung) => rung.sent > k);
      this.shownRungs = { k, rungs: this.rungs.slice(0, sent < 0 ? this.rungs.length : sent).map((rung) => rungAt(rung, k)) };
    }
    return this.shownRungs.rungs;
  }

  say(rungs) {
    const { run, row } = this;
    if (this.at === run.frames.length - 1) {
      const words = run.verdict?.words ?? (row?.reason ? String(row.reason).replaceAll('_', ' ') : '');
      banner(words && dialogs.sentence(words), '', !(run.verdict?.success ?? row?.success));
    } else if (rungs.some(inForce)) {
      const does = run.display.abort;
      banner(does ? fill(S.aborted_so, { does }) : S.aborted, '', true);
    } else {
      banner('');
    }
  }

  // -- what it gives away ---------------------------------------------------------------------

  // Name of a file of this run, without its ending.
  file() {
    return this.run.name.replaceAll(/[^\w.-]+/g, '_');
  }

  // One line over a picture or a video.
  caption() {
    return [this.run.name, ...this.facts(), $('review-now').textContent, $('banner').textContent].filter(Boolean).join(' · ');
  }

  async saveFigure() {
    const made = figure(this.panels, this.caption(), () => {
      this.show();
      this.panels.showReticle(this.frame());
    });
    const blob = await new Promise((resolve) => { made.toBlob(resolve, 'image/png'); });
    if (blob) save(`${this.file()}-${number(this.frame().t, 1)}s.png`, blob);
  }

  record() {
    if (this.film) {
      this.film.stop();
      return;
    }
    this.play(true);
    $('review-webm').textContent = S.review_webm_stop;
    this.film = new Film(this.panels, () => this.caption(), (ms) => this.filmOn(ms), (blob, problem) => {
      this.film = null;
      $('review-webm').textContent = S.review_webm;
      if (problem) $('review-now').textContent = fill(S.review_failed, { why: problem.message });
      else save(`${this.file()}.webm`, blob);
    });
  }
}

const path = (name) => name.split('/').map(encodeURIComponent).join('/');
