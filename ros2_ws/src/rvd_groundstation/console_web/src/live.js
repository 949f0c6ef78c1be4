// The flight that goes on while a finished run is reviewed: what it says, and the way back to it.

import { say } from './canvas.js';
import { limitWords, number } from './instruments.js';
import { amount, number as read } from './data.js';
import { label } from './modes.js';
import { S, fill } from './strings.js';

const $ = (id) => document.getElementById(id);
const MOST_ROWS = 5; // of the instruments
const SHOWN = ['measured', 'predicted', 'plain']; // a flight has no truth

export class Live {
  constructor(back) {
    $('live-back').onclick = back;
    this.rows = null;
  }

  // `words` are [text, alarm] each: what is to be known of it now.
  show(store, words) {
    const { display, frame } = store;
    $('live').hidden = !frame;
    if (!frame) return;
    say($('live-head'), fill(S.live_head, { t: number(frame.t, 1), mode: label(display, frame.mode) }));
    this.say($('live-words'), words.map(([text, alarm]) => [text, alarm ? 'alarm' : '']));
    const rows = (display.instruments?.rows || []).slice(0, MOST_ROWS).flatMap((row) => {
      const found = row.readings.filter((one) => SHOWN.includes(one.role)).map((one) => [one, read(frame, one.value)]);
      if (!found.length) return [];
      const bad = found.some(([one, v]) => v <= amount(frame, one.low) || v >= amount(frame, one.high));
      const values = found.map(([, v]) => number(v, row.digits)).join(' / ');
      return [[`${row.label} ${values} ${row.unit}${bad ? ` ▲ ${limitWords(frame, found[0][0], row.digits)}` : ''}`, bad ? 'alarm' : '']];
    });
    this.say($('live-rows'), rows);
    $('live').classList.toggle('dead', !store.connected);
  }

  // Put lines of words into an element, if they are others than before.
  say(element, lines) {
    const now = JSON.stringify(lines);
    if (element.dataset.said === now) return;
    element.dataset.said = now;
    element.replaceChildren(...lines.filter(([words]) => words).map(([words, tone]) => {
      const line = document.createElement('span');
      line.textContent = words;
      if (tone) line.className = tone;
      return line;
    }));
  }

  hide() {
    $('live').hidden = true;
  }
}
