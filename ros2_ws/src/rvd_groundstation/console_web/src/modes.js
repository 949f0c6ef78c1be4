// The mission's modes as buttons: which is in force on the ground, which telemetry says is obeyed.

import { say } from './canvas.js';
import { part } from './data.js';
import { S, fill } from './strings.js';

const row = () => document.getElementById('modes');
const named = (display, name) => (display?.modes || []).find((mode) => mode.name === name);

export const keyed = (label, key) => (key ? `${label} (${key.replace(/^Key/, '')})` : label);
export const label = (display, name) => named(display, name)?.label ?? name;
export const ofKey = (display, code) => (display?.modes || []).find((mode) => mode.key && mode.key === code);
export const inTurn = (display) => (display?.modes || []).filter((mode) => !mode.key);

export function setModes(display, choose) {
  row().hidden = !display.modes.length;
  row().classList.toggle('told', display.on_board !== null);
  row().replaceChildren(...display.modes.map((mode) => {
    const button = document.createElement('button');
    button.dataset.mode = mode.name;
    button.title = mode.words;
    button.textContent = keyed(mode.label, mode.key);
    if (display.on_board) button.append(document.createElement('small'));
    button.onclick = () => choose(mode.name);
    return button;
  }));
}

// `mode` is in force on the ground; whether it may be changed is `free`.
export function showModes(display, frame, mode, free) {
  const there = part(frame, display?.on_board);
  for (const button of row().children) {
    const [here, obeyed] = [button.dataset.mode === mode, button.dataset.mode === there];
    button.disabled = !free;
    button.setAttribute('aria-pressed', String(here));
    const small = button.querySelector('small');
    if (small) say(small, [here ? S.mode_ground : '', obeyed ? S.mode_board : ''].filter(Boolean).join(' · '));
  }
}

// What the list of keys says of them: keys, what they do.
export function modeRows(display) {
  const turn = inTurn(display).map((mode) => mode.label.toLowerCase()).join(', ');
  const rows = (display?.modes || []).filter((mode) => mode.key).map((mode) => [mode.key.replace(/^Key/, ''), mode.words || mode.label]);
  return turn ? [['M', fill(S.mode_turn, { modes: turn })], ...rows] : rows;
}
