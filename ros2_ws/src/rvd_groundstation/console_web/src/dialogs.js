// What opens over the page: help, stick settings, new run, verdict, the list of runs.

import { HELP, REFUSED, S, fill } from './strings.js';
import { number } from './instruments.js';

const box = () => document.getElementById('dialog');

export function open(html, onOpen) {
  const dialog = box();
  dialog.innerHTML = html;
  if (!dialog.open) dialog.showModal();
  for (const button of dialog.querySelectorAll('[data-close]')) button.onclick = () => dialog.close();
  if (onOpen) onOpen(dialog);
  return dialog;
}

export function close() {
  if (box().open) box().close();
}

export const closeButton = `<button data-close>${S.close}</button>`;

export function escape(words) {
  const span = document.createElement('span');
  span.textContent = words;
  return span.innerHTML;
}

export function message(title, text) {
  open(`<h3>${escape(title)}</h3><p>${escape(text)}</p><div class="buttons">${closeButton}</div>`);
}

export function help() {
  const rows = HELP.map(([keys, what]) => (keys
    ? `<tr><td><kbd>${keys}</kbd></td><td>${what}</td></tr>` : `<tr><td colspan="2">${what}</td></tr>`));
  open(`<h3>${S.help_title}</h3><table>${rows.join('')}</table><div class="buttons">${closeButton}</div>`);
}

export function refused(code) {
  return REFUSED[code] || code;
}

export function newRun(store, start) {
  if (!store.can.fly) {
    message(S.new_run, S.no_fly);
    return;
  }
  const mode = store.frame?.mode || store.run?.mode || 'shared';
  const options = ['manual', 'shared', 'auto'].map((m) => `<option value="${m}" ${m === mode ? 'selected' : ''}>${S[`mode_${m}`]}</option>`);
  open(`<h3>${S.new_run}</h3><p>${S.new_run_text}</p>
    <p><label>${S.mode} <select id="new-mode">${options.join('')}</select></label>
    &nbsp; <label>${S.seed} <input id="new-seed" size="8" inputmode="numeric" placeholder="${S.seed_hint}"></label></p>
    <p id="new-error" class="alarm"></p>
    <div class="buttons"><button data-close>${S.cancel}</button><button class="primary" id="new-start">${S.start}</button></div>`,
  (dialog) => {
    const go = async () => {
      const text = dialog.querySelector('#new-seed').value.trim();
      const wish = { do: 'fly', mode: dialog.querySelector('#new-mode').value };
      if (text) wish.seed = Number(text);
      const reply = await start(wish);
      if (reply.ok) dialog.close();
      else dialog.querySelector('#new-error').textContent = refused(reply.code);
    };
    dialog.querySelector('#new-start').onclick = go;
    dialog.querySelector('#new-seed').onkeydown = (event) => { if (event.key === 'Enter') go(); };
    dialog.querySelector('#new-start').focus();
  });
}

export function verdict(v, canFly, again) {
  const good = v.success;
  const row = (name, value, digits, unit) => `<tr><th>${name}</th><td>${number(value, digits)} ${unit}</td></tr>`;
  open(`<h3>${S.verdict_title}</h3>
    <p class="verdict ${good ? 'ok' : 'alarm'}" id="verdict-words">${good ? '✓' : '✗'} ${S.verdict[v.reason] || escape(v.reason)}</p>
    <table>${row(S.verdict_time, v.duration, 1, 's')}${row(S.verdict_closing, v.closing, 4, 'm/s')}
    ${row(S.verdict_offset, v.offset, 3, 'm')}${row(S.verdict_lateral, v.lateral, 4, 'm/s')}
    ${row(S.verdict_margin, v.margin, 3, 'm')}${row(S.verdict_dv, v.delta_v, 3, 'm/s')}</table>
    <div class="buttons">${closeButton}${canFly ? `<button class="primary" id="again">${S.fly_again}</button>` : ''}</div>`,
  (dialog) => {
    const button = dialog.querySelector('#again');
    if (button) button.onclick = () => { dialog.close(); again(); };
  });
}

export function stickSettings(stick) {
  const s = stick.settings;
  const row = (axis) => `<tr><td>${S[`settings_${axis}`]}</td>
    <td><label>${S.settings_axis} <input type="number" min="0" max="15" style="width:4em" data-axis="${axis}" value="${s[axis].axis}"></label></td>
    <td><label><input type="checkbox" data-invert="${axis}" ${s[axis].sign < 0 ? 'checked' : ''}> ${S.settings_invert}</label></td></tr>`;
  open(`<h3>${S.settings_title}</h3><p id="pad-name">${stick.gamepad ? escape(fill(S.settings_found, { name: stick.gamepad.id })) : S.settings_none}</p>
    <table>${row('x')}${row('y')}${row('z')}</table>
    <p><label>${S.settings_button} <input type="number" min="0" max="31" style="width:4em" id="pad-button" value="${s.button}"></label></p>
    <p><label>${S.settings_dead_zone} <input type="range" min="0" max="0.4" step="0.01" id="pad-zone" value="${s.deadZone}"></label></p>
    <p><label><input type="checkbox" id="hold-space" ${s.holdSpace ? 'checked' : ''}> ${S.settings_space}</label></p>
    <div class="buttons">${closeButton}</div>`,
  (dialog) => {
    dialog.onchange = () => {
      const part = (axis) => ({ axis: Number(dialog.querySelector(`[data-axis=${axis}]`).value),
        sign: dialog.querySelector(`[data-invert=${axis}]`).checked ? -1 : 1 });
      stick.change({ x: part('x'), y: part('y'), z: part('z'),
        button: Number(dialog.querySelector('#pad-button').value),
        deadZone: Number(dialog.querySelector('#pad-zone').value),
        holdSpace: dialog.querySelector('#hold-space').checked });
    };
  });
}

export function runsShown() {
  return box().open && box().querySelector('#runs') !== null;
}

export function runList(rows, choose) {
  const lines = rows.map((row) => `<tr><td>${escape(row.name)}</td><td>${escape(row.mode || '')}</td>
    <td class="${row.success ? 'ok' : ''}">${row.success ? '✓' : '✗'} ${escape(S.verdict[row.reason] || row.reason || '')}</td>
    <td><button data-run="${escape(row.name)}">${S.review_open}</button></td></tr>`);
  open(`<h3 id="runs">${S.review_title}</h3><p class="dim">${S.review_truth}</p>
    ${rows.length ? `<table>${lines.join('')}</table>` : `<p>${S.review_none}</p>`}
    <p id="review-error" class="alarm"></p><div class="buttons">${closeButton}</div>`,
  (dialog) => {
    for (const button of dialog.querySelectorAll('[data-run]')) {
      button.onclick = () => choose(button.dataset.run, dialog.querySelector('#review-error'));
    }
  });
}
