// What a good approach is, as the display says it: gates from far to near, then the limits at contact.

import { escape } from './escape.js';
import { number } from './instruments.js';
import { C } from './strings.js';

// Rows of what a good approach is; `next` is the gate that is ahead of a distance.
export function gateRows(guidance, distance) {
  const next = guidance.gates.findIndex((gate) => distance === undefined || gate.at < distance);
  const rows = guidance.gates.map((gate, i) => ({ at: `${number(gate.at, Number.isInteger(gate.at) ? 0 : 1)} ${guidance.unit}`, wanted: gate.wanted, next: i === next && distance !== undefined }));
  return guidance.contact.length ? [...rows, { at: guidance.contact_label, wanted: guidance.contact, next: distance !== undefined && next < 0 }] : rows;
}

export function guidanceHtml(guidance, distance) {
  const lines = gateRows(guidance, distance).map(({ at, wanted, next }) => `<tr class="${next ? 'next' : ''}"><th>${escape(at)}</th><td>${escape(wanted.join(', '))}</td></tr>`);
  return `<h4>${C.good}</h4><table>${lines.join('')}</table>`;
}
