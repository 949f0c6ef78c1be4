// Strip charts: curves about zero against the instant they are of, between dashed lines of their spread.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { readout } from './instruments.js';
import { part } from './data.js';

const $ = (id) => document.getElementById(id);
const COLOURS = ['#7cc4ff', '#56d6b0', '#d59bf6', '#ffb652', '#f2f5f8', '#ff7a5c'];

// The truth among others is white, as everywhere.
const colourOf = ({ curves }, i) => (curves[i].signal === 'truth' && curves.some((one) => one.signal !== 'truth') ? '#f2f5f8' : COLOURS[i]);

function options(strip, width, height, rem) {
  const axis = { stroke: '#8fa1b3', grid: { stroke: '#1b2733', width: 1 }, ticks: { stroke: '#1b2733' },
    font: `${0.68 * rem}px system-ui`, size: 2.3 * rem };
  const dashed = { stroke: '#ffb65290', width: 1, dash: [4, 4], points: { show: false } };
  return {
    width, height, legend: { show: false }, cursor: { show: false }, padding: [rem * (strip.names.length ? 0.95 : 0.3), rem * 0.4, 0, 0],
    hooks: { draw: [(u) => mark(u, strip, rem)] },
    scales: { x: { time: false }, y: { range: (u, low, high) => {
      if (!strip.centred) return around([low, high, ...strip.levels], strip.least);
      const most = Math.max(Math.abs(low || 0), Math.abs(high || 0), strip.least);
      return [-most * 1.1, most * 1.1];
    } } },
    axes: [{ ...axis, size: 1.5 * rem, gap: 1 }, { ...axis, gap: 1, space: 1.2 * rem, label: strip.title, labelSize: 1.1 * rem,
      labelFont: `${0.7 * rem}px system-ui` }],
    series: [{}, ...strip.curves.map((_, i) => ({ stroke: colourOf(strip, i), width: 1.5, points: { show: false } })), dashed, dashed],
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
function mark(u, strip, rem) {
  const pen = u.ctx;
  const ratio = devicePixelRatio || 1;
  const { left, top, width } = u.bbox;
  pen.save();
  pen.strokeStyle = '#8aa4bd';
  pen.lineWidth = ratio;
  pen.setLineDash([3 * ratio, 3 * ratio]);
  for (const level of strip.levels) {
    const y = u.valToPos(level, 'y', true);
    pen.beginPath(); pen.moveTo(left, y); pen.lineTo(left + width, y); pen.stroke();
  }
  pen.font = `${0.68 * rem * ratio}px system-ui`;
  pen.textBaseline = 'bottom';
  pen.textAlign = 'right';
  let x = left + width - 0.3 * rem * ratio;
  for (let i = strip.names.length - 1; i >= 0; i -= 1) {
    pen.fillStyle = colourOf(strip, i);
    pen.fillText(strip.names[i], x, top - 0.1 * rem * ratio);
    x -= pen.measureText(strip.names[i]).width + 0.7 * rem * ratio;
  }
  pen.restore();
}

class Strip {
  constructor(strip, window) {
    Object.assign(this, { strip, window, element: document.createElement('div') });
  }

  size() {
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    const width = this.element.parentElement.clientWidth;
    return { width: Math.max(width, 60), height: 6.4 * rem, rem };
  }

  show({ t, curves, spread }, until) {
    const size = this.size();
    if (!this.plot || this.width !== size.width) {
      if (this.plot) this.plot.destroy();
      this.plot = new uPlot(options(this.strip, size.width, size.height, size.rem), [[], ...curves.map(() => []), [], []], this.element);
      this.width = size.width;
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
  setDisplay({ charts }) {
    $('strips').hidden = !charts;
    this.note = charts?.note;
    this.strips = (charts?.strips || []).map((strip) => new Strip(strip, charts.window_s));
    $('charts').replaceChildren(...this.strips.map((strip) => strip.element));
    $('charts-title').textContent = charts?.title || '';
  }

  show(histories, frame, until) {
    this.strips.forEach((strip, i) => strip.show(histories[i], until));
    if (this.note) readout(part(frame, this.note) ?? ['', false], $('charts-note'), 'dim');
  }
}
