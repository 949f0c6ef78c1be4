// What opens over the page: help, stick settings, new run, verdict, the list of runs.

import { escape } from './escape.js';
import { guidanceHtml } from './guidance.js';
import { REVIEW_HELP } from './review_words.js';
import { HELP, KEYS, REFUSED, S, fill } from './strings.js';
import { limitWords, number } from './instruments.js';
import { modeRows } from './modes.js';

const box = () => document.getElementById('dialog');

export function open(html, onOpen) {
  const dialog = box();
  dialog.oncancel = null; // of the dialog before
  delete dialog.dataset.passes;
  dialog.innerHTML = html;
  if (!dialog.open) dialog.showModal();
  for (const button of dialog.querySelectorAll('[data-close]')) button.onclick = () => dialog.close();
  if (onOpen) onOpen(dialog);
  return dialog;
}

export function close() {
  if (box().open) box().close();
}

// The heading of the dialog that is open; '' when none is.
export function title() {
  return box().open ? box().querySelector('h3')?.textContent || S.dialog : '';
}

// What a key does while a dialog is open: true when it belongs to the dialog, or to nobody.
export function takesKey(code) {
  const dialog = box();
  if (!dialog.open) return false;
  const button = dialog.querySelector(`[data-key="${code}"]`);
  if (button) button.click();
  else if (dialog.dataset.passes !== undefined) { // a list of the keys: they do what it says
    dialog.close();
    return false;
  }
  return true;
}

// Say something in the dialog that is open, above all else in it.
export function note(words) {
  const dialog = box();
  let line = dialog.querySelector('#dialog-note');
  if (!line && words) {
    line = document.createElement('p');
    Object.assign(line, { id: 'dialog-note', className: 'alarm' });
    line.setAttribute('role', 'alert');
    dialog.querySelector('h3')?.after(line);
  }
  if (line && line.textContent !== words) line.textContent = words;
  if (line) line.hidden = !words;
}

export const closeButton = `<button data-close>${S.close}</button>`;

export { escape };

export function message(title, text) {
  open(`<h3>${escape(title)}</h3><p>${escape(text)}</p><div class="buttons">${closeButton}</div>`);
}

export const keyName = (code) => KEYS[code] || code.replace(/^Key/, '');

// The keys of the hand controller, then those of the page.
export function keyRows(display) {
  const controller = display?.controller;
  const rows = (controller?.axes || []).map((axis) => [
    axis.keys.map((pair) => pair.map(keyName).join(' / ')).join(` ${S.or} `),
    `${controller.verb} ${axis.positive} / ${axis.negative} (${axis.name})`]);
  for (const button of controller?.buttons || []) rows.push([keyName(button.key), button.words]);
  const steps = controller?.key_deflections.length || 0;
  if (steps > 1) rows.push([Array.from({ length: steps }, (_, i) => i + 1).join(' '), fill(S.help_step, { name: controller.step_name })]);
  return rows;
}

export function help(display) {
  const abort = display?.abort ? `: ${display.abort}` : '';
  const [[takeKey, takeWords], ...others] = HELP.map(([keys, what]) => [keys, fill(what, { abort })]);
  const rows = [[takeKey, takeWords], ...keyRows(display), ...modeRows(display), ...others, ...REVIEW_HELP].map(([keys, what]) => (keys
    ? `<tr><td><kbd>${escape(keys)}</kbd></td><td>${escape(what)}</td></tr>` : `<tr><td colspan="2">${escape(what)}</td></tr>`));
  const good = display?.guidance ? guidanceHtml(display.guidance) : '';
  open(`<h3>${S.help_title}</h3><table>${rows.join('')}</table>${good}<div class="buttons"><button data-close data-key="Slash">${S.close}</button></div>`,
  (dialog) => { dialog.dataset.passes = ''; });
}

export function refused(code) {
  return REFUSED[code] || code;
}

// Fields of a form of the display, filled with what was written last or with what they are.
function formRows(form, written) {
  const rows = form.fields.map((field) => {
    const name = `${field.section} ${field.key}`;
    const now = written[name] ?? field.value;
    const mark = `data-setting="${escape(name)}" title="${escape(`${field.key}: ${field.hint}`)}"`;
    const input = field.choices.length
      ? `<select ${mark}>${field.choices.map((c) => `<option ${c === now ? 'selected' : ''}>${escape(c)}</option>`).join('')}</select>`
      : `<input ${mark} value="${escape(now)}" maxlength="200">`;
    return `<label>${escape(field.label)} ${input} <span class="dim">${escape(field.unit)}</span></label>`;
  });
  return `<fieldset><legend>${escape(form.title)}</legend>${rows.join('')}</fieldset>`;
}

// What was written into the forms and is not what the scenario has, by 'section key'.
function changed(dialog, forms) {
  const found = {};
  for (const form of forms) {
    for (const field of form.fields) {
      const name = `${field.section} ${field.key}`;
      const now = [...dialog.querySelectorAll('[data-setting]')].find((one) => one.dataset.setting === name).value;
      if (now.trim() !== field.value) found[name] = now;
    }
  }
  return found;
}

let written = {}; // into the forms, for the next time they are open

export function newRun(store, start, error = '', stop = null) {
  if (!store.can.fly) {
    message(S.new_run, S.no_fly);
    return;
  }
  const modes = store.display?.modes || [];
  const forms = store.display?.forms || [];
  const mode = store.frame?.mode || store.run?.mode || store.asked;
  const options = modes.map((m) => `<option value="${m.name}" ${m.name === mode ? 'selected' : ''}>${escape(m.label)}</option>`);
  open(`<h3>${S.new_run}</h3><p>${S.new_run_text}</p>
    <p>${modes.length ? `<label>${S.mode} <select id="new-mode">${options.join('')}</select></label> &nbsp;` : ''}
    <label>${S.seed} <input id="new-seed" size="15" inputmode="numeric" placeholder="${S.seed_hint}"></label></p>
    <div class="forms">${forms.map((form) => formRows(form, written)).join('')}</div>
    <p id="new-error" class="alarm" role="alert">${escape(error)}</p>
    <div class="buttons"><button data-close>${S.cancel}</button>${stop ? `<button id="new-stop" title="${S.stop_hint}">${S.stop_run}</button>` : ''}<button class="primary" id="new-start">${S.start}</button></div>`,
  (dialog) => {
    dialog.classList.toggle('wide', forms.length > 0);
    dialog.onclose = () => dialog.classList.remove('wide');
    const go = async () => {
      const text = dialog.querySelector('#new-seed').value.trim();
      const wish = { do: 'fly', mode: dialog.querySelector('#new-mode')?.value ?? null };
      if (text) wish.seed = Number(text);
      if (forms.length) wish.settings = written = changed(dialog, forms);
      const reply = await start(wish);
      if (reply.ok) dialog.close();
      else dialog.querySelector('#new-error').textContent = refused(reply.code);
    };
    dialog.querySelector('#new-start').onclick = go;
    if (stop) dialog.querySelector('#new-stop').onclick = () => { dialog.close(); stop(); };
    dialog.querySelector('#new-seed').onkeydown = (event) => { if (event.key === 'Enter') go(); };
    dialog.querySelector('#new-start').focus();
  });
}

export function verdict(v, canFly, again) {
  const good = v.success;
  const row = (name, value, limit, ok) => `<tr><th>${escape(name)}</th><td class="${ok === false ? 'alarm' : ''}">${escape(value)}</td><td class="dim">${escape(limit)}</td></tr>`;
  const rows = v.measures.filter((m) => m.value !== null).map((m) => row(m.words, `${number(m.value, m.digits)} ${m.unit}`, limitWords(null, m, m.digits), m.ok));
  open(`<h3>${S.verdict_title}</h3>
    <p class="verdict ${good ? 'ok' : 'alarm'}" id="verdict-words">${good ? '✓' : '✗'} ${escape(sentence(v.words))}</p>
    <table>${row(S.verdict_time, `${number(v.duration, 1)} s`, '', null)}${rows.join('')}</table>
    <div class="buttons">${closeButton}${canFly ? `<button class="primary" id="again" data-key="KeyN">${S.fly_again}</button>` : ''}</div>`,
  (dialog) => {
    const button = dialog.querySelector('#again');
    if (button) button.onclick = () => { dialog.close(); again(); };
  });
}

export function runsShown() {
  return box().open && box().querySelector('#runs') !== null;
}

export const sentence = (words) => words.charAt(0).toUpperCase() + words.slice(1);
