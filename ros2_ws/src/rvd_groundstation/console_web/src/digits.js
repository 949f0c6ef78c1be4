// Over the camera's picture: large digits of where the craft is and how it moves, and its field of view.

import './digits.css';
import { say } from './canvas.js';
import { number as read } from './data.js';
import { degrees } from './field.js';
import { number } from './instruments.js';
import { S, fill } from './strings.js';

const $ = (id) => document.getElementById(id);
const NEWS_MS = 5000; // how long a new field of view is said
const ROLES = ['measured', 'predicted'];

const signed = (value, digits) => {
  const words = number(value, digits);
  return value > 0 && Number(value.toFixed(digits)) !== 0 ? `+${words}` : words;
};

export class CameraDigits {
  constructor() {
    this.height = 0; // of the digits, in pixels of the page
    new ResizeObserver(([entry]) => { this.height = entry.borderBoxSize[0].blockSize; }).observe($('digits'));
  }

  setDisplay(camera) {
    const numbers = camera?.numbers;
    $('digits').hidden = !numbers;
    Object.assign(this, { cells: [], tan: undefined, changedAt: -Infinity });
    say($('camera-field'), '');
    if (!numbers) return;
    const used = ROLES.filter((role) => numbers.rows.some((row) => [...row.place, ...row.rate].some((one) => one.role === role)));
    $('digits').style.setProperty('--digits', used.length);
    const made = [];
    const cells = (readings, digits, isSigned) => used.map((role) => {
      const cell = made[made.push(document.createElement('b')) - 1];
      cell.className = role;
      const reading = readings.find((one) => one.role === role);
      cell.textContent = reading ? S.unknown : '';
      if (reading) this.cells.push({ cell, reading, digits, isSigned });
      return cell;
    });
    const words = (text, tone = '') => { Object.assign(made[made.push(document.createElement('span')) - 1], { textContent: text, className: tone }); };
    for (const unit of [numbers.place_unit, numbers.rate_unit]) ['', ...used.map((_, i) => (i ? '' : unit))].forEach((text) => words(text, 'unit'));
    for (const row of numbers.rows) {
      words(row.label);
      cells(row.place, numbers.place_digits, row.signed);
      words(row.rate_label);
      cells(row.rate, numbers.rate_digits, row.signed && !row.rate_label);
    }
    $('digits').replaceChildren(...made);
  }

  show(frame, stale) {
    for (const { cell, reading, digits, isSigned } of this.cells) {
      const value = frame ? read(frame, reading.value) : undefined;
      say(cell, value === undefined ? S.unknown : isSigned ? signed(value, digits) : number(value, digits));
      cell.classList.toggle('stale-value', Boolean(stale) && reading.role === 'measured');
    }
  }

  // `tan` is the tangent of half the field of view of the picture.
  field(tan) {
    if (tan === undefined) return;
    const now = performance.now();
    if (this.tan !== undefined && tan !== this.tan) Object.assign(this, { changedAt: now, was: this.tan });
    this.tan = tan;
    const news = now - this.changedAt < NEWS_MS;
    const words = fill(S.field, { deg: number(degrees(tan), 0) });
    say($('camera-field'), news ? `${words} ${fill(S.field_was, { deg: number(degrees(this.was), 0) })}` : words);
    $('camera-field').classList.toggle('news', news);
  }
}
