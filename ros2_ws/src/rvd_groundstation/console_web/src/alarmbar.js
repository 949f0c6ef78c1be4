// The line of alarms across the page: its place is always there, so that nothing jumps.

import './alarms.css';
import { Alarms, ofDisplay, ofPage } from './alarms.js';
import { say } from './canvas.js';
import { sentence, whoFlies } from './decided.js';
import { number } from './instruments.js';
import { Sound } from './sound.js';
import { A, S, fill } from './strings.js';

const $ = (id) => document.getElementById(id);
const LOOK_MS = 100; // also of a page that nobody sees, which draws nothing

export class AlarmBar {
  constructor(store) {
    this.store = store;
    this.alarms = new Alarms();
    this.sound = new Sound();
    this.run = null;
    $('alarm-ack').onclick = () => this.acknowledge();
    $('alarm-sound').onclick = () => this.toggleSound();
    this.look();
    setInterval(() => this.look(), LOOK_MS);
  }

  acknowledge() {
    this.alarms.acknowledge();
    this.look();
  }

  toggleSound() {
    this.sound.toggle();
    this.look();
  }

  look() {
    const { store, alarms } = this;
    const now = performance.now();
    const { run, frame, display, status } = store;
    if (run !== this.run) alarms.clear();
    this.run = run;
    const flown = run && frame && !store.verdict && status.phase === 'flying';
    if (!flown) alarms.clear();
    else if (!frame.paused || !store.connected) {
      const facts = { run, frame, measured: store.measured, silence: store.silence(),
        connected: store.connected, pilotLost: status.pilot_lost,
        flies: store.dead() ? null : whoFlies(display, frame) };
      alarms.judge([...ofPage(facts, A), ...ofDisplay(frame, display.alarms, (words) => alarms.stands(words))], now / 1000);
    }
    this.show();
    this.sound.sing(alarms.loud, now);
  }

  // What calls, for a dialog that lies over the line.
  words() {
    const [first] = this.alarms.loud ? this.alarms.shown : [];
    return first ? [first.words, detail(first)].filter(Boolean).join(': ') : '';
  }

  show() {
    const shown = [...this.alarms.standing.values()].length ? this.alarms.shown : [];
    const [first, ...others] = shown;
    $('alarms').className = first ? (first.acknowledged ? 'seen' : first.level) : '';
    say($('alarm-words'), first ? first.words : A.none);
    say($('alarm-detail'), first ? detail(first) : '');
    say($('alarm-more'), others.map((one) => one.words).join(' · '));
    $('alarm-ack').disabled = !this.alarms.loud;
    say($('alarm-sound'), this.sound.on ? A.sound_on : A.sound_off);
    $('alarm-sound').setAttribute('aria-pressed', String(this.sound.on));
  }
}

// What is beyond which limit, and whether that was measured or is predicted; who flies where no pilot does.
function detail({ seen, age, flies }) {
  if (age !== undefined) return fill(S.age, { s: number(age, 1) });
  if (flies) return sentence(flies);
  if (!seen?.label) return '';
  const unit = seen.unit ? ` ${seen.unit}` : '';
  const said = seen.role === 'plain' ? '' : `${S.columns[seen.role]} `;
  return fill(A.beyond, { said, label: seen.label, value: `${number(seen.value, seen.digits)}${unit}`, limit: number(seen.limit, seen.digits) });
}
