// Keyboard and gamepad as one stick: deflections in [-1, 1] along the axes of the mission's hand
// controller, and a dead-man.
//
// A gamepad flies when it is chosen (the only one there, or by hand), when each axis and the
// dead-man button are known (a standard mapping, or set up by hand), and each axis of it once it
// has been at neutral since the dead-man was closed: a trigger that rests at -1 commands nothing.

import { recall, remember } from './storage.js';

const POLL_MS = 20;
const STANDARD_BUTTON = 4; // left shoulder
const KEY = 'rvd.stick';
export const NO_AXIS = -1; // the pad has none for it

export function shaped(value, deadZone) {
  if (!Number.isFinite(value)) return 0;
  const size = Math.min(Math.abs(value), 1);
  return size <= deadZone ? 0 : (Math.sign(value) * (size - deadZone)) / (1 - deadZone);
}

export class Stick {
  // `barred` says what keeps the pilot from the stick, a dialog or a review; '' when nothing does.
  constructor(onChange, barred = () => '') {
    this.onChange = onChange;
    this.barred = barred;
    this.down = new Set();
    this.step = 1;
    this.source = 'keyboard';
    this.pads = []; // connected ones
    this.gamepad = null; // the chosen one
    this.settingUp = false;
    this.settings = load();
    this.setController(null);
    addEventListener('keydown', (event) => this.key(event, true));
    addEventListener('keyup', (event) => this.key(event, false));
    const release = () => { this.down.clear(); this.send(true); };
    addEventListener('blur', release);
    document.addEventListener('visibilitychange', release);
    setInterval(() => this.poll(), POLL_MS);
  }

  setController(controller) {
    this.axes = controller?.axes || [];
    this.deflections = controller?.key_deflections || [1];
    this.step = Math.min(this.step, this.deflections.length);
    this.keys = new Map(); // code: [axis, sense]
    this.buttons = controller?.buttons || [];
    this.axes.forEach((axis, i) => axis.keys.forEach(([up, down]) => this.keys.set(up, [i, 1]).set(down, [i, -1])));
    this.disarm();
  }

  // The stick has been taken: what is deflected now was not deflected for this.
  taken() {
    this.down.clear();
    this.disarm();
  }

  disarm() {
    this.armed = this.axes.map(() => false); // axes of the pad that have been at neutral since
  }

  // -- which pad, and what its axes mean ----------------------------------------------------

  // { axis, sign } of an axis, null when that is not known; a standard pad begins as the mission says.
  wiring(pad, axis) {
    const own = this.settings.pads[pad.id]?.axes[axis.name];
    if (own) return own.axis < pad.axes.length ? own : null;
    if (pad.mapping === 'standard' && axis.pad_pair) return axis.pad_pair.every((b) => b < pad.buttons.length) ? { pair: axis.pad_pair, sign: 1 } : null;
    if (pad.mapping !== 'standard' || axis.pad_axis >= pad.axes.length) return null;
    return { axis: axis.pad_axis, sign: axis.pad_inverted ? -1 : 1 };
  }

  // The dead-man button of a pad, null when it is not known.
  button(pad) {
    const own = this.settings.pads[pad.id]?.button ?? (pad.mapping === 'standard' ? STANDARD_BUTTON : null);
    return own !== null && own < pad.buttons.length ? own : null;
  }

  ready(pad) {
    return !this.settingUp && this.button(pad) !== null && this.axes.every((axis) => this.wiring(pad, axis) !== null);
  }

  // What keeps the pads from flying: '', 'choose' or 'setup'.
  lacks() {
    if (!this.pads.length) return '';
    return !this.gamepad ? 'choose' : this.ready(this.gamepad) ? '' : 'setup';
  }

  pick(pad) {
    this.change({ chosen: { id: pad.id, index: pad.index ?? 0 } });
  }

  // Remember axes by name and button of a pad; what is left out stays.
  setUp(pad, { axes = {}, button }) {
    const old = this.settings.pads[pad.id] || { axes: {}, button: null };
    const now = { axes: { ...old.axes, ...axes }, button: button ?? old.button };
    this.change({ pads: { ...this.settings.pads, [pad.id]: now } });
  }

  change(settings) {
    this.settings = { ...this.settings, ...settings };
    this.disarm();
    remember('local', KEY, JSON.stringify(this.settings));
  }

  // The chosen one of the connected pads; an index alone says nothing, so of several none is taken.
  choose() {
    const { chosen } = this.settings;
    const same = this.pads.filter((pad) => pad.id === chosen?.id);
    if (same.length === 1) return same[0];
    if (same.length > 1) return same.find((pad) => pad.index === chosen.index) || null;
    return this.pads.length === 1 ? this.pads[0] : null;
  }

  // Deflection of each axis of a pad, whether it flies or not; null where that is not known.
  deflection(pad) {
    return this.axes.map((axis) => {
      const wiring = this.wiring(pad, axis);
      if (!wiring) return null;
      if (wiring.pair) return shaped(amountOf(pad, wiring.pair[0]) - amountOf(pad, wiring.pair[1]), this.settings.deadZone);
      return wiring.axis === NO_AXIS ? 0 : wiring.sign * shaped(pad.axes[wiring.axis], this.settings.deadZone);
    });
  }

  // -- what it says -------------------------------------------------------------------------

  key(event, pressed) {
    if (event.ctrlKey || event.metaKey || event.altKey || typing(event.target)) return;
    // Sliders and dialogs have their own arrow keys; what comes up is let go of in any case.
    if (pressed && event.target instanceof Element && event.target.closest('input, select, dialog')) return;
    const step = Number(/^(?:Digit|Numpad)([1-9])$/.exec(event.code)?.[1]);
    if (pressed && step <= this.deflections.length) {
      this.step = step;
      this.send(true);
      return;
    }
    const button = this.buttons.some((one) => one.key === event.code);
    if (!this.keys.has(event.code) && !button && event.code !== 'Space') return;
    if (event.code === 'Space' && !this.settings.holdSpace) return;
    event.preventDefault();
    if (event.repeat) return; // held since before the stick was taken or the page left
    const had = this.down.has(event.code);
    if (pressed) this.down.add(event.code);
    else this.down.delete(event.code);
    if (pressed) this.source = 'keyboard';
    if (had !== pressed) this.send(true);
  }

  poll() {
    if (this.barred()) this.down.clear(); // what is held then was not meant for flying
    this.pads = connected();
    const pad = this.choose();
    if (pad?.id !== this.gamepad?.id || pad?.index !== this.gamepad?.index) this.disarm();
    this.gamepad = pad;
    if (pad && this.ready(pad) && pressed(pad, this.button(pad))) this.source = 'gamepad';
    if (!this.holds()) this.disarm();
    else this.deflection(pad).forEach((value, i) => { if (value === 0) this.armed[i] = true; });
    this.send(false);
  }

  // Whether there is somebody who looks at the flight.
  free() {
    return there() && !this.barred();
  }

  // Whether the dead-man of the gamepad is held, and counts.
  holds() {
    const pad = this.gamepad;
    return this.source === 'gamepad' && this.free() && pad !== null && this.ready(pad) && pressed(pad, this.button(pad));
  }

  // Whether the gamepad that was flown with is not there any more: nobody flies until a key does.
  gone() {
    return this.source === 'gamepad' && this.gamepad === null;
  }

  // Names of the axes that do not fly, as they have not been at neutral.
  stuck() {
    return this.holds() ? this.axes.filter((_, i) => !this.armed[i]).map((axis) => axis.name) : [];
  }

  // Bits of the buttons beside the dead-man that are held.
  pressed() {
    const pad = this.source === 'gamepad' ? this.gamepad : null;
    return this.buttons.reduce((bits, one, i) => {
      const down = pad ? pad.mapping === 'standard' && pressed(pad, one.pad_button) : this.down.has(one.key);
      return bits | (down ? 1 << i : 0);
    }, 0);
  }

  withButtons(state) {
    return this.buttons.length ? { ...state, buttons: this.pressed() } : state;
  }

  // `at`: the deflection of each axis.
  state() {
    if (this.source === 'gamepad') {
      const held = this.holds();
      return this.withButtons({ held, at: held ? this.deflection(this.gamepad).map((v, i) => (this.armed[i] ? v : 0)) : this.axes.map(() => 0) });
    }
    const at = this.axes.map(() => 0);
    for (const code of this.down) {
      if (this.keys.has(code)) at[this.keys.get(code)[0]] += this.keys.get(code)[1];
    }
    const deflection = this.deflections[this.step - 1];
    return this.withButtons({ held: this.free() && (!this.settings.holdSpace || this.down.has('Space')),
      at: at.map((v) => Math.max(-1, Math.min(1, v)) * deflection) });
  }

  send(now) {
    this.onChange(this.state(), now);
  }
}

const there = () => document.visibilityState === 'visible' && document.hasFocus();

// A page may be forbidden to see gamepads, by throwing.
function connected() {
  try {
    return [...(navigator.getGamepads?.() || [])].filter((pad) => pad && pad.connected !== false);
  } catch {
    return [];
  }
}

function pressed(pad, index) {
  return Boolean(pad.buttons[index]?.pressed);
}

// How far a button is pressed: a trigger says it by degrees.
function amountOf(pad, index) {
  const button = pad.buttons[index];
  return button ? Math.max(button.value ?? 0, button.pressed && !button.value ? 1 : 0) : 0;
}

export function typing(target) {
  return target instanceof Element
    && Boolean(target.closest('input:not([type=range]):not([type=radio]):not([type=checkbox]), textarea, select, [contenteditable]'));
}

// What was remembered, as far as it makes sense: it may be of an older page, or of anybody.
function load() {
  let said = null;
  try {
    said = JSON.parse(recall('local', KEY));
  } catch { /* no JSON: as if nothing had been said */ }
  const pads = {};
  for (const [id, pad] of Object.entries(said?.pads ?? {})) {
    const axes = Object.entries(pad?.axes ?? {}).filter(([, w]) => Number.isInteger(w?.axis) && w.axis >= NO_AXIS && Math.abs(w.sign) === 1);
    pads[id] = { axes: Object.fromEntries(axes), button: Number.isInteger(pad?.button) && pad.button >= 0 ? pad.button : null };
  }
  return { pads, chosen: typeof said?.chosen?.id === 'string' ? said.chosen : null, holdSpace: said?.holdSpace === true,
    deadZone: said?.deadZone >= 0 && said.deadZone <= 0.4 ? Number(said.deadZone) : 0.08 };
}
