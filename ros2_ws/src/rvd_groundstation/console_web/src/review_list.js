// The list of runs: those that can be reviewed, and before them the one that is not whole yet.

import * as dialogs from './dialogs.js';
import { number } from './instruments.js';
import { label } from './modes.js';
import { S, fill } from './strings.js';

const AGAIN_MS = 2000; // while it is open: other commands fly into the same folder
const { escape } = dialogs;
const two = (n) => String(n).padStart(2, '0');

let rows = null; // of the last time: shown at once, until the new ones are there
let again = 0;

// Local time as everybody reads it in the same way: 2027-03-01 14:05.
export function dateOf(seconds) {
  if (!Number.isFinite(seconds)) return S.unknown;
  const d = new Date(seconds * 1000);
  return `${d.getFullYear()}-${two(d.getMonth() + 1)}-${two(d.getDate())} ${two(d.getHours())}:${two(d.getMinutes())}`;
}

// Show it for a review, or look again where it is shown; it stays true as long as it is open.
export function showRuns(review) {
  if (!dialogs.runsShown()) {
    const warning = review.warning();
    dialogs.open(`<h3 id="runs">${S.review_title}</h3><p class="dim">${S.review_truth}</p>
      ${warning ? `<p class="alarm" id="review-warning">${escape(warning)}</p>` : ''}<div id="runs-table"></div><p id="review-error" class="alarm" role="alert"></p>
      <div class="buttons">${dialogs.closeButton}</div>`, (dialog) => {
      dialog.classList.add('wide');
      dialog.onclose = () => dialog.classList.remove('wide');
    });
  }
  body(review);
  look(review, document.getElementById('runs'));
}

// Ask for the rows, again and again as long as this list is the one that is shown.
async function look(review, title) {
  clearTimeout(again);
  const shown = () => title.isConnected && dialogs.runsShown();
  try {
    const now = await review.link.get('api/runs');
    const known = JSON.stringify(now) === JSON.stringify(rows);
    rows = now;
    if (shown() && !known) body(review);
  } catch (problem) {
    if (!shown()) return;
    document.getElementById('review-error').textContent = problem.message;
    if (rows === null) document.getElementById('runs-table').textContent = '';
  }
  clearTimeout(again);
  if (shown()) again = setTimeout(() => look(review, title), AGAIN_MS);
}

// The table anew; what had the focus has it again.
function body(review) {
  const place = document.getElementById('runs-table');
  const focus = document.activeElement?.dataset.run;
  const running = underWay(review.store);
  if (rows === null && !running) {
    place.innerHTML = `<p>${S.runs_loading}</p>`;
    return;
  }
  const listed = (rows || []).filter((row) => row.name !== running?.name);
  const lines = listed.map((row, i) => line(row, i, review.store.display));
  if (running) lines.unshift(`<tr class="dim"><td></td><td>${escape(running.name)}</td><td colspan="6">${escape(running.words)}</td><td></td></tr>`);
  const head = S.runs_columns.map((words) => `<th scope="col">${words}</th>`).join('');
  place.innerHTML = lines.length ? `<table class="runs"><tr>${head}<th></th></tr>${lines.join('')}</table>` : `<p>${rows === null ? S.runs_loading : S.review_none}</p>`;
  const error = document.getElementById('review-error');
  for (const button of place.querySelectorAll('[data-run]')) button.onclick = () => review.open(listed[button.dataset.row], error);
  for (const button of place.querySelectorAll('[data-report]')) button.onclick = () => review.report(button.dataset.report, error);
  if (focus) [...place.querySelectorAll('[data-run]')].find((button) => button.dataset.run === focus)?.focus();
}

// The run of this console that cannot be reviewed yet.
function underWay({ status }) {
  if (!status.run || !['starting', 'flying', 'closing'].includes(status.phase)) return null;
  return { name: status.run, words: status.phase === 'closing' ? S.runs_closing : S.runs_flying };
}

// What a run was flown in: each mode with its share where there was more than one.
function modesOf({ mode, modes }, display) {
  const flown = Object.entries(modes || {});
  if (flown.length < 2) return mode ? label(display, mode) : '';
  const percent = (share) => share < 0.01 ? '< 1' : number(100 * share, 0); // no share is said to be 0
  return flown.map(([name, share]) => `${label(display, name)} ${percent(share)} %`).join(' · ');
}

function line(row, i, display) {
  const words = (value) => `<td>${escape(value ?? '')}</td>`;
  const verdict = dialogs.sentence(String(row.reason ?? '').replaceAll('_', ' '));
  const report = row.report ? `title="${escape(fill(S.runs_report, { name: row.name }))}"` : `disabled title="${S.runs_no_report}"`;
  return `<tr>${words(dateOf(row.ended))}${words(row.name)}${words(row.scenario)}${words(modesOf(row, display))}
    ${words(row.operator)}${words(row.seed)}<td class="num">${number(row.duration_s, 1)} s</td>
    <td class="${row.success === true ? 'ok' : ''}">${row.success === true ? '✓' : '✗'} ${escape(verdict)}</td>
    <td class="acts"><button data-run="${escape(row.name)}" data-row="${i}" title="${escape(fill(S.runs_open, { name: row.name }))}">${S.review_open}</button>
    <button data-report="${escape(row.name)}" ${report}>${S.review_report}</button></td></tr>`;
}
