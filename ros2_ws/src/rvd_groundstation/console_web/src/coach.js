// Until the first command: which key moves what, beside the craft, and what a good approach is.

import './coach.css';
import { DIRECTIONS, number as read, place } from './data.js';
import { keyName, keyRows } from './dialogs.js';
import { escape } from './escape.js';
import { guidanceHtml } from './guidance.js';
import { C } from './strings.js';

const $ = (id) => document.getElementById(id);
const OUT_REM = 5; // from the craft to a key
const ASIDE = 0.12; // an axis that is seen as short as this beside the longest points at the eye

export class Coach {
  constructor(store, scene, stick) {
    Object.assign(this, { store, scene, stick, run: null, moved: false, caps: [], said: '', display: null });
  }

  // Hear how the stick stands: the first command of a run is what this was for.
  heard({ held, at }) {
    if (this.store.run !== this.run) Object.assign(this, { run: this.store.run, moved: false });
    if (this.store.status.phase === 'flying' && held && at.some((v) => v !== 0)) this.moved = true;
  }

  wanted(reviewed) {
    const { store } = this;
    const flying = store.status.phase === 'flying';
    const before = ['idle', 'starting', 'refused'].includes(store.status.phase);
    return !reviewed && store.status.lease === 'you' && Boolean(store.display?.controller)
      && ((before && !store.can.desk) || (flying && !this.moved && !store.verdict));
  }

  show(reviewed) {
    const { display, frame } = this.store;
    const wanted = this.wanted(reviewed);
    $('coach').hidden = !wanted;
    if (!wanted) return;
    if (display !== this.display) this.build(display);
    const distance = display.guidance?.distance.map((one) => read(frame, one)).find((v) => v !== undefined);
    this.place(frame);
    const capped = $('coach-caps').hidden ? [] : display.controller.axes.map((axis) => axis.along && axis.keys.length > 0);
    const keys = this.stick.source === 'keyboard' ? keyRows(display).filter((_, i) => !capped[i]).map(([names, what]) => `<tr><th><kbd>${escape(names)}</kbd></th><td>${escape(what)}</td></tr>`).join('') : '';
    const html = (display.guidance ? guidanceHtml(display.guidance, distance) : '') + (keys ? `<h4 class="keys">${C.keys}</h4><table class="keys">${keys}</table>` : '');
    if (html !== this.said) {
      this.said = html;
      $('coach-card').innerHTML = html;
    }
  }

  build(display) {
    this.display = display;
    this.caps = [];
    for (const axis of display.controller.axes.filter((one) => one.along && one.keys.length)) {
      [[axis.keys[0][0], axis.positive, 1], [axis.keys[0][1], axis.negative, -1]].forEach(([code, words, sense]) => {
        const cap = document.createElement('span');
        cap.innerHTML = `<kbd>${escape(keyName(code))}</kbd> ${escape(words)}`;
        this.caps.push({ cap, towards: DIRECTIONS[axis.along].map((c) => c * sense) });
      });
    }
    $('coach-caps').replaceChildren(...this.caps.map(({ cap }) => cap));
  }

  // Put each key where its push would take the craft on the screen.
  place(frame) {
    const { scene, stick } = this;
    const body = scene.moving?.find(({ item }) => item.kind === 'body' && item.role === 'measured');
    const at = body && place(frame, body.item.place, body.item.axes);
    const from = at && scene.onView(at);
    $('coach-caps').hidden = !from || stick.source !== 'keyboard';
    if ($('coach-caps').hidden) return;
    const ways = this.caps.map(({ towards }) => {
      const to = scene.onView(at.map((c, i) => c + 0.5 * towards[i]));
      return to ? [to[0] - from[0], to[1] - from[1]] : [0, 0];
    });
    const most = Math.max(...ways.map(([x, y]) => Math.hypot(x, y)), 1e-9);
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    this.caps.forEach(({ cap }, i) => {
      const length = Math.hypot(...ways[i]);
      cap.hidden = length < ASIDE * most;
      if (cap.hidden) return;
      cap.style.left = `${Math.round(from[0] + (ways[i][0] / length) * OUT_REM * rem * 1.25)}px`;
      cap.style.top = `${Math.round(from[1] + (ways[i][1] / length) * OUT_REM * rem)}px`;
    });
  }
}
