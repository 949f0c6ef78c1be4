// What an alarm sounds like: a warning is two tones again and again, a caution one low tone now and
// then. Off until somebody switches it on, as a browser lets no page sound before it is touched.

const TONES = { warning: { every: 900, notes: [[960, 0], [720, 0.16]] }, caution: { every: 3000, notes: [[520, 0]] } };
const [LENGTH_S, LOUD] = [0.13, 0.12];

export class Sound {
  constructor() {
    Object.assign(this, { on: false, context: null, level: '', at: -Infinity, sung: 0 });
  }

  toggle() {
    this.on = !this.on;
    if (this.on && !this.context) {
      const Kind = window.AudioContext || window.webkitAudioContext;
      if (Kind) this.context = new Kind();
    }
    this.context?.resume();
    this.at = -Infinity;
  }

  // Go on with the alarm of a level, '' for none; called a few times a second.
  sing(level, now) {
    if (level !== this.level) this.at = -Infinity;
    this.level = level;
    if (!this.on || !level || !this.context || now - this.at < TONES[level].every) return;
    this.at = now;
    this.sung += 1;
    for (const [hertz, after] of TONES[level].notes) this.note(hertz, after);
  }

  note(hertz, after) {
    const { context } = this;
    const from = context.currentTime + after;
    const [tone, gain] = [context.createOscillator(), context.createGain()];
    tone.frequency.value = hertz;
    gain.gain.setValueAtTime(0, from); // no click at either end
    gain.gain.linearRampToValueAtTime(LOUD, from + 0.015);
    gain.gain.setValueAtTime(LOUD, from + LENGTH_S - 0.03);
    gain.gain.linearRampToValueAtTime(0, from + LENGTH_S);
    tone.connect(gain).connect(context.destination);
    tone.start(from);
    tone.stop(from + LENGTH_S);
  }
}
