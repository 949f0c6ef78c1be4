// Strip charts of the prediction error: predicted against what was received later, and the two
// sigma that the prediction claimed for it.

import uPlot from 'uplot';
import 'uplot/dist/uPlot.min.css';
import { S } from './strings.js';

const COLOURS = ['#7cc4ff', '#56d6b0', '#d59bf6'];
const WINDOW = 60; // [s]

function options(title, width, height, rem) {
  const axis = { stroke: '#8fa1b3', grid: { stroke: '#1b2733', width: 1 }, ticks: { stroke: '#1b2733' },
    font: `${0.68 * rem}px system-ui`, size: 2.3 * rem };
  return {
    width, height, legend: { show: false }, cursor: { show: false }, padding: [rem * 0.3, rem * 0.4, 0, 0],
    scales: { x: { time: false }, y: { range: (u, low, high) => {
      const most = Math.max(Math.abs(low || 0), Math.abs(high || 0), 1);
      return [-most * 1.1, most * 1.1];
    } } },
    axes: [{ ...axis, size: 1.5 * rem, gap: 1 }, { ...axis, gap: 1, space: 1.5 * rem, label: title, labelSize: 1.1 * rem,
      labelFont: `${0.7 * rem}px system-ui` }],
    series: [{},
      ...['x', 'y', 'z'].map((label, i) => ({ label, stroke: COLOURS[i], width: 1.5, points: { show: false } })),
      { stroke: '#ffb65290', width: 1, dash: [4, 4], points: { show: false } },
      { stroke: '#ffb65290', width: 1, dash: [4, 4], points: { show: false } }],
  };
}

class Strip {
  constructor(id, title, offset) {
    this.element = document.getElementById(id);
    this.title = title;
    this.offset = offset;
  }

  size() {
    const rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
    const width = this.element.parentElement.clientWidth - 1.2 * rem;
    return { width: Math.max(width, 60), height: 6.4 * rem, rem };
  }

  show(errors, until) {
    const size = this.size();
    if (!this.plot || this.width !== size.width) {
      if (this.plot) this.plot.destroy();
      this.plot = new uPlot(options(this.title, size.width, size.height, size.rem), [[], [], [], [], [], []], this.element);
      this.width = size.width;
    }
    let end = errors.t.length;
    if (until !== undefined) while (end > 0 && errors.t[end - 1] > until) end -= 1;
    let from = end;
    while (from > 0 && errors.t[from - 1] > (errors.t[end - 1] ?? 0) - WINDOW) from -= 1;
    const cut = (list) => list.slice(from, end);
    const o = this.offset;
    const sigma = cut(errors.s[o + 1]);
    this.plot.setData([cut(errors.t), cut(errors.e[o]), cut(errors.e[o + 1]), cut(errors.e[o + 2]),
      sigma, sigma.map((v) => (v === null ? null : -v))]);
  }
}

export class Charts {
  constructor() {
    this.strips = [new Strip('chart-position', S.error_position, 0), new Strip('chart-rate', S.error_rate, 3)];
  }

  show(errors, until) {
    for (const strip of this.strips) strip.show(errors, until);
  }
}
