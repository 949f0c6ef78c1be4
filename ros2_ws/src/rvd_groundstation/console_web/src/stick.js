// Keyboard and gamepad as one stick: deflections in [-1, 1] along the axes of the mission's hand
// controller, and a dead-man.

const POLL_MS = 20;
const DEFAULTS = { axes: {}, button: 4, deadZone: 0.08, holdSpace: false };

export function shaped(value, deadZone) {
  if (!Number.isFinite(value)) return 0;
  const size = Math.min(Math.abs(value), 1);
  return size <= deadZone ? 0 : (Math.sign(value) * (size - deadZone)) / (1 - deadZone);
}

export class Stick {
  constructor(onChange) {
    this.onChange = onChange;
    this.down = new Set();
    this.step = 1;
    this.source = 'keyboard';
    this.gamepad = null;
    this.settings = { ...DEFAULTS, ...load() };
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
    this.axes.forEach((axis, i) => axis.keys.forEach(([up, down]) => this.keys.set(up, [i, 1]).set(down, [i, -1])));
  }

  // Which axis of a gamepad an axis hangs on, and its sign: as chosen here, else as the mission says.
  wiring(axis) {
    return this.settings.axes[axis.name] || { axis: axis.pad_axis, sign: axis.pad_inverted ? -1 : 1 };
  }

  change(settings) {
    this.settings = { ...this.settings, ...settings };
    localStorage.setItem('rvd.stick', JSON.stringify(this.settings));
  }

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
    if (!this.keys.has(event.code) && event.code !== 'Space') return;
    if (event.code === 'Space' && !this.settings.holdSpace) return;
    event.preventDefault();
    const had = this.down.has(event.code);
    if (pressed) this.down.add(event.code);
    else this.down.delete(event.code);
    if (pressed) this.source = 'keyboard';
    if (had !== pressed) this.send(true);
  }

  poll() {
    const pads = navigator.getGamepads ? [...navigator.getGamepads()].filter(Boolean) : [];
    this.gamepad = pads.find((pad) => pad.connected !== false) || null;
    if (this.gamepad && pressed(this.gamepad, this.settings.button)) this.source = 'gamepad';
    if (!this.gamepad && this.source === 'gamepad') this.source = 'keyboard';
    this.send(false);
  }

  // `at`: the deflection of each axis.
  state() {
    const there = document.visibilityState === 'visible' && document.hasFocus();
    if (this.source === 'gamepad') {
      const read = ({ axis, sign }) => sign * shaped(this.gamepad.axes[axis], this.settings.deadZone);
      return { held: there && pressed(this.gamepad, this.settings.button), at: this.axes.map((axis) => read(this.wiring(axis))) };
    }
    const at = this.axes.map(() => 0);
    for (const code of this.down) {
      if (this.keys.has(code)) at[this.keys.get(code)[0]] += this.keys.get(code)[1];
    }
    const deflection = this.deflections[this.step - 1];
    return { held: there && (!this.settings.holdSpace || this.down.has('Space')),
      at: at.map((v) => Math.max(-1, Math.min(1, v)) * deflection) };
  }

  send(now) {
    this.onChange(this.state(), now);
  }
}

function pressed(pad, index) {
  return Boolean(pad.buttons[index] && pad.buttons[index].pressed);
}

export function typing(target) {
  return target instanceof Element
    && Boolean(target.closest('input:not([type=range]):not([type=radio]):not([type=checkbox]), textarea, select, [contenteditable]'));
}

function load() {
  try {
    return JSON.parse(localStorage.getItem('rvd.stick')) || {};
  } catch {
    return {};
  }
}
