// The panels as a display describes them, filled from a frame: of a flight or of a review alike.

import { Charts } from './charts.js';
import { Commands, Instruments, clock, dial, drawSection, linkCounts, number, reticle, setSection } from './instruments.js';
import { COLOUR, begin, say } from './canvas.js';
import { CameraDigits } from './digits.js';
import { drawAttitude, drawLamps, setAttitude, setLamps } from './cockpit.js';
import { History, sample } from './data.js';
import { counts, ladder } from './ladder.js';
import { setModes } from './modes.js';
import { scaleText } from './scene.js';
import { S, fill } from './strings.js';

const $ = (id) => document.getElementById(id);
const CANVASES = ['section', 'lights', 'ladder', 'reticle', 'ball', 'dial'];
const CHARTS_MS = 250; // between two looks at the charts

const ahead = (s) => fill(s < 0 ? S.before : S.ahead, { s: number(Math.abs(s), 1) });

export class Panels {
  // `choose` is called with the name of a mode whose button is pressed.
  constructor(scene, choose) {
    Object.assign(this, { scene, choose });
    this.instruments = new Instruments();
    this.commands = new Commands();
    this.charts = new Charts();
    this.digits = new CameraDigits();
    this.chartsAt = 0;
    this.text = '';
  }

  // Whether the page has to be built anew for it.
  setDisplay(display) {
    const words = JSON.stringify(display);
    if (words === this.text) {
      this.scene.place(null, null, 0, false);
      return;
    }
    this.text = words;
    this.display = display;
    this.instruments.setDisplay(display);
    this.commands.setDisplay(display);
    this.charts.setDisplay(display);
    this.digits.setDisplay(display.camera);
    setSection(display.section);
    setAttitude(display.attitude);
    setLamps(display.lamps);
    for (const id of ['trip', 'ladder-panel']) $(id).hidden = !display.link;
    $('clock-rx').parentElement.hidden = !display.link;
    $('camera').hidden = !display.camera;
    $('clock-pred').parentElement.hidden = !display.predicted;
    if (display.camera) {
      $('camera').setAttribute('aria-label', display.camera.title);
      $('camera-tag').textContent = display.camera.title;
    }
    setModes(display, this.choose);
    $('legend').replaceChildren(...display.legend.map(({ role, words: meaning, dashed }) => {
      const entry = document.createElement('span');
      entry.className = dashed ? 'dash' : '';
      entry.style.color = COLOUR[role];
      entry.textContent = meaning;
      return entry;
    }));
    this.scene.setDisplay(display);
    for (const id of CANVASES) begin($(id)); // also of a panel that this display has not
    $('views').replaceChildren(...display.views.map((view, i) => {
      const button = document.createElement('button');
      button.textContent = view.label;
      button.dataset.view = view.label.toLowerCase();
      button.onclick = () => this.setView(i);
      return button;
    }));
    $('views').hidden = display.views.length < 2;
    this.setView(this.scene.chosen);
  }

  setView(chosen) {
    this.scene.chosen = chosen;
    [...$('views').children].forEach((button, i) => button.setAttribute('aria-pressed', String(i === chosen)));
    $('scale').textContent = scaleText(this.display.views[chosen]);
  }

  nextView() {
    if (this.display) this.setView((this.scene.chosen + 1) % this.display.views.length);
  }

  // `age`, `since` words beside the first two clocks.
  clocks(frame, now, age, since, stale) {
    const measured = sample(frame, this.display.measured);
    const predicted = sample(frame, this.display.predicted);
    clock('gen', measured?.t, age, stale);
    clock('rx', measured?.received, since, stale);
    clock('pred', predicted?.t, predicted ? ahead(predicted.t - now) : '', stale);
  }

  show({ run, frame, rungs, history, now, stale, until }) {
    const { display } = this;
    const measured = sample(frame, display.measured);
    this.instruments.show(frame, stale);
    if (display.section) drawSection(display.section, frame);
    if (display.attitude) drawAttitude(display.attitude, frame);
    if (display.lamps) drawLamps(display.lamps, frame);
    this.commands.show(frame);
    this.digits.show(frame, stale);
    if (display.link) this.showLink(run, frame, measured, rungs, now);
    this.scene.place(frame, history, now, stale);
    if (performance.now() - this.chartsAt > CHARTS_MS) {
      this.chartsAt = performance.now();
      this.charts.show(history.charts, frame, until);
    }
  }

  // Show that nothing is known: no number, line or mark of what was shown stays.
  blank() {
    const { display } = this;
    if (!display) return;
    const frame = { signals: {} };
    this.clocks(frame, 0, '', '', false);
    for (const panel of [this.instruments, this.commands, this.digits]) panel.show(frame, false);
    if (display.section) drawSection(display.section, frame);
    if (display.attitude) drawAttitude(display.attitude, frame);
    if (display.lamps) drawLamps(display.lamps, frame);
    for (const id of ['dial', 'ladder']) begin($(id));
    for (const id of ['ladder-counts', 'link-counts']) $(id).textContent = '';
    this.charts.blank(new History(display, 0));
    this.scene.place(null, null, 0, false);
    this.showReticle(frame);
  }

  showLink(run, frame, measured, rungs, now) {
    dial($('dial'), run, frame.round_trip, measured?.transit);
    linkCounts(frame, measured, run.step_s, now);
    ladder($('ladder'), run, this.display.commands.axes, rungs, now);
    say($('ladder-counts'), counts(rungs, run.acknowledged));
  }

  showReticle(frame) {
    if (!this.display?.camera || !frame) return;
    reticle($('reticle'), this.scene, this.display.camera, frame, this.digits.height);
    this.digits.field(this.scene.cameraTan);
  }
}
