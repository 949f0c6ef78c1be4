// Keyboard and gamepad as one stick: deflections in [-1, 1] along x, y, z and a dead-man.
// Seen from the chaser: x forward, y up (radially outward), z right.

const KEYS = {
  KeyW: ['x', 1], KeyS: ['x', -1],
  KeyR: ['y', 1], ArrowUp: ['y', 1], KeyF: ['y', -1], ArrowDown: ['y', -1],
  KeyD: ['z', 1], ArrowRight: ['z', 1], KeyA: ['z', -1], ArrowLeft: ['z', -1],
};
const LEVELS = { Digit1: 1, Digit2: 2, Digit3: 3, Numpad1: 1, Numpad2: 2, Numpad3: 3 };
const POLL_MS = 20;

export const DEFAULTS = {
  x: { axis: 1, sign: -1 }, y: { axis: 3, sign: -1 }, z: { axis: 2, sign: 1 },
  button: 4, deadZone: 0.08, holdSpace: false,
};

export function shaped(value, deadZone) {
  if (!Number.isFinite(value)) return 0;
  const size = Math.min(Math.abs(value), 1);
  return size <= deadZone ? 0 : (Math.sign(value) * (size - deadZone)) / (1 - deadZone);
}

export class Stick {
  constructor(onChange) {
    this.onChange = onChange;
    this.down = new Set();
    this.level = 1;
    this.source = 'keyboard';
    this.gamepad = null;
    this.settings = { ...DEFAULTS, ...load() };
    addEventListener('keydown', (event) => this.key(event, true));
    addEventListener('keyup', (event) => this.key(event, false));
    const release = () => { this.down.clear(); this.send(true); };
    addEventListener('blur', release);
    document.addEventListener('visibilitychange', release);
    setInterval(() => this.poll(), POLL_MS);
  }

  change(settings) {
    this.settings = { ...this.settings, ...settings };
    localStorage.setItem('rvd.stick', JSON.stringify(this.settings));
  }

  key(event, pressed) {
    if (event.ctrlKey || event.metaKey || event.altKey || typing(event.target)) return;
    // Sliders and dialogs have their own arrow keys; what comes up is let go of in any case.
    if (pressed && event.target instanceof Element && event.target.closest('input, select, dialog')) return;
    if (pressed && LEVELS[event.code]) {
      this.level = LEVELS[event.code];
      this.send(true);
      return;
    }
    if (!KEYS[event.code] && event.code !== 'Space') return;
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

  state() {
    const there = document.visibilityState === 'visible' && document.hasFocus();
    if (this.source === 'gamepad') {
      const s = this.settings;
      const read = (part) => part.sign * shaped(this.gamepad.axes[part.axis], s.deadZone);
      return { held: there && pressed(this.gamepad, s.button), x: read(s.x), y: read(s.y),
        z: read(s.z) };
    }
    const made = { held: there && (!this.settings.holdSpace || this.down.has('Space')),
      x: 0, y: 0, z: 0 };
    for (const code of this.down) {
      if (KEYS[code]) made[KEYS[code][0]] += KEYS[code][1];
    }
    for (const axis of ['x', 'y', 'z']) {
      made[axis] = (Math.max(-1, Math.min(1, made[axis])) * this.level) / 3;
    }
    return made;
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
