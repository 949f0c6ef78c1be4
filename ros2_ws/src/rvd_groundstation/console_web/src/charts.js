// Strip charts: curves against the instant they are of, over a band of their spread about zero.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import './charts.css';
import { small } from './canvas.js';
import { readout } from './instruments.js';
import { part } from './data.js';

const $ = (id) => document.getElementById(id);
const COLOURS = ['#7cc4ff', '#56d6b0', '#d59bf6', '#ffb652', '#f2f5f8', '#ff7a5c'];
const [BAND, EDGE] = ['#ffb65238', '#ffb652a0'];
const [TALL, LOW] = [5.8, 4.9]; // [rem] of a strip alone, and of one beside others
const MANY = 3; // strips that are drawn at once
const [LOW_PX, SHORT] = [690, 0.78]; // height of a window in which strips are shorter

// The truth among others is white, as everywhere.
const colourOf = ({ curves }, i) => (curves[i].signal === 'truth' && curves.some((one) => one.signal !== 'truth') ? '#f2f5f8' : COLOURS[i]);

// A number that is easily read and at most `most`, not by far.
function round(most) {
  const ten = 10 ** Math.floor(Math.log10(most));
  return [8, 6, 5, 4, 3, 2, 1.5, 1].map((n) => Number((n * ten).toPrecision(2))).find((n) => n <= most * (1 + 1e-9));
}

function options(strip, width, height, rem, beside) {
  const words = Math.round(small(rem)); // uPlot scales whole pixels alone: of 11.3px it would read 3px
  const axis = { stroke: '#a9b7c5', grid: { stroke: '#1b2733', width: 1 }, ticks: { stroke: '#1b2733', size: 4 }, font: `${words}px system-ui` };
  const edge = { stroke: EDGE, width: 1, points: { show: false } };
  const first = strip.curves.length + 1; // of the two edges of the band
  const tall = beside ? {} : { label: strip.title, labelSize: words * 1.35, labelFont: `${words}px system-ui` };
  const middle = strip.centred && beside ? {
    splits: (u, i, low, high) => [-round(high / 1.1), 0, round(high / 1.1)],
    values: (u, splits) => splits.map((v) => (v === 0 ? '' : String(v).replace('-', '−'))), // the line at 0 needs no number
  } : {};
  return {
    width, height, legend: { show: false }, cursor: { show: false }, padding: [words * (strip.names.length ? 1.2 : 0.5), words * 0.5, 0, 0],
    hooks: { draw: [(u) => mark(u, strip, words)] },
    bands: [{ series: [first, first + 1], fill: BAND }],
    scales: { x: { time: false }, y: { range: (u, low, high) => {
      if (!strip.centred) return around([low, high, ...strip.levels], strip.least);
      const most = Math.max(Math.abs(low || 0), Math.abs(high || 0), strip.least);
      return [-most * 1.1, most * 1.1];
    } } },
    axes: [{ ...axis, size: words * 1.7, gap: 1, space: words * 2.8 },
      { ...axis, size: words * (beside ? 2.8 : 3), gap: 1, space: words * 1.7, ...middle, ...tall }],
    series: [{}, ...strip.curves.map((_, i) => ({ stroke: colourOf(strip, i), width: beside ? 1.2 : 1.5, points: { show: false } })), edge, edge],
  };
}

// A range that holds all of some numbers, at least `least` wide.
function around(numbers, least) {
  const known = numbers.filter((v) => Number.isFinite(v));
  const [low, high] = known.length ? [Math.min(...known), Math.max(...known)] : [0, least];
  const more = Math.max((high - low) * 0.06, (least - (high - low)) / 2);
  return [low - more, high + more];
}

// The levels of a strip, and over it the names of its curves in their colours.
function mark(u, strip, words) {
  const pen = u.ctx;
  const ratio = uPlot.pxRatio; // of the plot's own canvas
  const { left, top, width } = u.bbox;
  pen.save();
  pen.strokeStyle = '#8aa4bd';
  pen.lineWidth = ratio;
  pen.setLineDash([3 * ratio, 3 * ratio]);
  for (const level of strip.levels) {
    const y = u.valToPos(level, 'y', true);
    pen.beginPath(); pen.moveTo(left, y); pen.lineTo(left + width, y); pen.stroke();
  }
  pen.font = `${words * ratio}px system-ui`;
  pen.textBaseline = 'bottom';
  pen.textAlign = 'right';
  let x = left + width - 0.4 * words * ratio;
  for (let i = strip.names.length - 1; i >= 0; i -= 1) {
    pen.fillStyle = colourOf(strip, i);
    pen.fillText(strip.names[i], x, top - 0.1 * words * ratio);
    x -= pen.measureText(strip.names[i]).width + 0.9 * words * ratio;
  }
  pen.restore();
}

class Strip {
  // One of several that stand beside each other has its title above it.
  constructor(strip, window, beside) {
    Object.assign(this, { strip, window, beside, element: document.createElement('div'), place: document.createElement('div') });
    this.element.classList.toggle('wide', !beside);
    if (beside) {
      const title = document.createElement('span');
      title.textContent = strip.title;
      this.element.append(title);
    }
    this.element.append(this.place);
  }

  // Its place is there before there is anything to draw, so that nothing moves.
  size() {
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    const width = Math.floor(this.element.clientWidth);
    const height = Math.round((this.beside ? LOW : TALL) * rem * (innerHeight < LOW_PX ? SHORT : 1));
    if (this.reserved !== height) this.place.style.height = `${height}px`;
    this.reserved = height;
    return { width: Math.max(width, 60), height, rem };
  }

  show({ t, curves, spread }, until) {
    const size = this.size();
    if (!this.plot || this.width !== size.width || this.height !== size.height) {
      if (this.plot) this.plot.destroy();
      this.plot = new uPlot(options(this.strip, size.width, size.height, size.rem, this.beside), [[], ...curves.map(() => []), [], []], this.place);
      Object.assign(this, { width: size.width, height: size.height });
    }
    let end = t.length;
    if (until !== undefined) while (end > 0 && t[end - 1] > until) end -= 1;
    let from = end;
    while (from > 0 && t[from - 1] > (t[end - 1] ?? 0) - this.window) from -= 1;
    const cut = (list) => list.slice(from, end);
    const above = cut(spread);
    this.plot.setData([cut(t), ...curves.map(cut), above, above.map((v) => (v === null ? null : -v))]);
  }
}

export class Charts {
  constructor() {
    this.strips = [];
    addEventListener('resize', () => this.strips.forEach((strip) => strip.size()));
  }

  setDisplay({ charts }) {
    $('strips').hidden = !charts;
    this.note = charts?.note;
    this.strips = (charts?.strips || []).map((strip) => new Strip(strip, charts.window_s, charts.columns > 1 && !strip.wide));
    $('charts').style.setProperty('--columns', charts?.columns ?? 1);
    $('charts').replaceChildren(...this.strips.map((strip) => strip.element));
    for (const strip of this.strips) strip.size();
    $('charts-title').textContent = charts?.title || '';
    const key = [['line', charts?.curve], ['band', charts?.band]].filter(([, words]) => words);
    $('charts-key').hidden = key.length === 0;
    $('charts-key').replaceChildren(...key.map(([kind, words]) => {
      const entry = document.createElement('span');
      entry.className = kind;
      entry.textContent = words;
      return entry;
    }));
  }

  // Strips without curves.
  blank({ charts }) {
    this.strips.forEach((strip, i) => strip.show(charts[i]));
    $('charts-note').textContent = '';
  }

  // Of many strips one half is drawn at a time: they cost what a few do.
  show(histories, frame, until) {
    this.turn = !this.turn;
    this.strips.forEach((strip, i) => {
      if (this.strips.length <= MANY || strip.plot === undefined || (i % 2 === 1) === this.turn) strip.show(histories[i], until);
    });
    if (this.note) readout(part(frame, this.note) ?? ['', false], $('charts-note'), 'dim');
  }
}
