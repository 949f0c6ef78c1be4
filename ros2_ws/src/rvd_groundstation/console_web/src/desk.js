// The experiment desk: one dialog after the other leads a volunteer through a session.

import { close, escape, open, refused, sentence } from './dialogs.js';
import { label } from './modes.js';
import { S, fill } from './strings.js';

const D = S.desk;
const STEP = 5;

export class Desk {
  constructor(link) {
    this.link = link;
    this.task = { hint: '', goal: '', display: null }; // the display's
    this.state = null;
    this.mine = false;
    this.page = null; // draws what is open, with what has been answered so far
    // Help and stick settings may be opened over a page of the session; it comes back after them.
    document.getElementById('dialog').addEventListener('close', ({ target }) => {
      if (!target.querySelector('[data-desk]')) setTimeout(() => { if (!target.open) this.reopen(); });
    });
  }

  show(message, mine) {
    const same = (one) => JSON.stringify({ ...one, rest_s: 0, closing: false });
    const changed = !this.state || same(this.state) !== same(message);
    this.state = message;
    this.mine = mine;
    if (message.stage === 'rest' && changed) this.restUntil = performance.now() + message.rest_s * 1000;
    if (changed) this.draw();
    else this.wait(); // the rest of what is open stays as it was filled in
  }

  lease(mine) {
    if (mine === this.mine) return;
    this.mine = mine;
    if (!mine) this.shut();
    else if (this.page) this.page();
    else if (this.state) this.draw();
  }

  draw() {
    clearInterval(this.timer);
    const stage = this.state.stage;
    this.page = null;
    if (!this.mine) return;
    if (stage === 'flying') close();
    else this.turn(() => this[stage]());
  }

  turn(page) {
    this.page = page;
    page();
  }

  // Open again what the session waits for: it may be closed to look at the page.
  reopen() {
    if (this.mine && this.page) this.page();
  }

  shut() {
    if (document.querySelector('#dialog [data-desk]')) close();
  }

  // Which session this is, and where it stands: for everybody who looks.
  title() {
    if (!this.state) return '';
    const { title, who, stage, training, mode } = this.state;
    const parts = who ? [stage === 'done' ? who : this.heading()] : []; // what changes first: there may be little room
    if (mode) parts.push(label(this.task.display, mode), training ? D.is_training : D.is_counted);
    return [...parts, fill(D.session, { title })].join(' · ');
  }

  async ask(act, extra, dialog) {
    const reply = await this.link.ask({ do: 'desk', act, ...extra });
    const error = dialog?.querySelector('.error');
    if (!reply.ok && error) error.textContent = D.errors[reply.code] || refused(reply.code);
    return reply.ok;
  }

  frame(title, body, buttons, onOpen) {
    const dialog = open(`<h3 data-desk>${escape(title)}</h3>${body}<p class="error alarm" role="alert"></p><div class="buttons">${buttons}</div>`, onOpen);
    dialog.onclose = null;
    this.wait();
    return dialog;
  }

  // What cannot go on before the recording of the last flight is whole waits for that.
  wait() {
    const button = document.querySelector('#dialog [data-waits]');
    if (!button) return;
    button.disabled = this.state.closing;
    document.querySelector('#dialog .error').textContent = this.state.closing ? D.errors.CLOSING : '';
    if (!this.state.closing) button.focus();
  }

  door() {
    this.frame(this.state.title, `<p>${D.door}</p><p><label>${D.volunteer} <input id="volunteer" inputmode="numeric" size="5"></label></p>`,
      `<button class="primary" id="desk-go">${D.begin}</button>`, (dialog) => {
        const go = () => this.ask('begin', { volunteer: Number(dialog.querySelector('#volunteer').value) }, dialog);
        dialog.querySelector('#desk-go').onclick = go;
        dialog.querySelector('#volunteer').onkeydown = (event) => { if (event.key === 'Enter') go(); };
        dialog.querySelector('#volunteer').focus();
      });
  }

  heading() {
    return fill(D.heading, { who: this.state.who, n: this.state.number, of: this.state.of });
  }

  ready() {
    const words = this.state.training ? D.training : D.counts;
    const why = this.state.why ? `<p class="alarm">${escape(this.state.why)}</p>` : '';
    this.frame(this.heading(), `${why}<p>${words}</p><p>${fill(D.condition, { mode: escape(label(this.task.display, this.state.mode)) })}</p><p class="dim">${escape(this.task.hint)} ${D.clock}</p>`,
      `<button class="primary" id="desk-go" data-waits>${D.fly}</button>`, (dialog) => {
        dialog.querySelector('#desk-go').onclick = () => this.ask('fly', {}, dialog);
      });
  }

  // A flight that does not count.
  broken() {
    this.frame(this.heading(), `<p class="verdict alarm" id="desk-why">${escape(fill(D.broken, { why: this.state.why }))}</p><p>${D.flown_again}</p>`,
      `<button class="primary" id="desk-go" data-waits>${D.go_on}</button>`, (dialog) => {
        dialog.querySelector('#desk-go').onclick = () => this.ask('go_on', {}, dialog);
      });
  }

  closing() {
    this.frame(this.heading(), `<p>${D.errors.CLOSING}</p>`, '');
  }

  rest() {
    this.frame(D.rest_title, `<p>${D.rest}</p><p class="verdict" id="rest-left"></p>`,
      `<button class="primary" id="desk-go">${D.go_on}</button>`, (dialog) => {
        const button = dialog.querySelector('#desk-go');
        const words = dialog.querySelector('#rest-left');
        button.onclick = () => this.ask('go_on', {}, dialog);
        const tick = () => {
          const left = Math.max(0, (this.restUntil - performance.now()) / 1000);
          words.textContent = `${left.toFixed(0)} s`;
          button.disabled = left > 0;
        };
        tick();
        clearInterval(this.timer);
        this.timer = setInterval(tick, 500);
      });
  }

  done() {
    this.frame(D.done_title, `<p>${fill(D.done, { who: this.state.who })}</p>`, `<button id="desk-go">${D.next}</button>`,
      (dialog) => { dialog.querySelector('#desk-go').onclick = () => this.ask('leave', {}, dialog); });
  }

  rate() {
    this.answers = {};
    this.scales = new Map();
    this.turn(() => this.question('controllable'));
  }

  // The decision tree of Cooper and Harper: three questions, then a choice among at most three.
  question(key) {
    const { verdict } = this.state;
    const yesNo = `<button data-answer="yes">${D.yes}</button><button data-answer="no">${D.no}</button>`;
    this.frame(`${this.heading()} · Cooper-Harper`, `<p class="${verdict.success ? 'ok' : ''}">${escape(sentence(verdict.words || ''))}</p>${this.state.why ? `<p class="alarm">${escape(this.state.why)}</p>` : ''}<p>${escape(fill(D.tree[key], { goal: this.task.goal }))}</p>`, yesNo, (dialog) => {
      dialog.querySelector('[data-answer=yes]').focus();
      for (const button of dialog.querySelectorAll('[data-answer]')) {
        button.onclick = () => this.answered(key, button.dataset.answer === 'yes');
      }
    });
  }

  answered(key, yes) {
    const order = ['controllable', 'adequate', 'satisfactory'];
    this.answers[key] = yes;
    if (!yes) for (const later of order.slice(order.indexOf(key) + 1)) this.answers[later] = false;
    const next = order[order.indexOf(key) + 1];
    this.turn(yes && next ? () => this.question(next) : () => this.pick());
  }

  pick() {
    const { controllable, adequate, satisfactory } = this.answers;
    const range = !controllable ? [10] : !adequate ? [7, 8, 9] : !satisfactory ? [4, 5, 6] : [1, 2, 3];
    const buttons = range.map((n) => `<button data-rating="${n}"><b>${n}</b> ${D.ratings[n]}</button>`).join('');
    this.frame(`${this.heading()} · Cooper-Harper`, `<p>${D.pick}</p><div class="choices">${buttons}</div>`, `<button id="desk-back">${D.again}</button>`, (dialog) => {
      dialog.querySelector('#desk-back').onclick = () => this.rate();
      for (const button of dialog.querySelectorAll('[data-rating]')) {
        button.onclick = () => {
          this.answers.rating = Number(button.dataset.rating);
          this.turn(() => this.tlx());
        };
      }
      dialog.querySelector('[data-rating]').focus();
    });
  }

  // A scale has no thumb before it has been set: there is no answer to be left as it is.
  tlx() {
    const rows = Object.entries(D.tlx).map(([key, [name, question, low, high]]) => `<fieldset><legend>${name}</legend>
      <label for="tlx-${key}">${question}</label><input type="range" class="unset" aria-valuetext="${D.unset}" id="tlx-${key}" data-tlx="${key}" min="0" max="100" step="${STEP}" value="50">
      <div class="scale-ends"><span>${low}</span><output id="out-${key}">–</output><span>${high}</span></div></fieldset>`).join('');
    this.frame(`${this.heading()} · NASA-TLX`, rows, `<button id="desk-back">${D.again}</button><button class="primary" id="desk-go" disabled>${D.save}</button>`, (dialog) => {
      const { scales } = this;
      const touch = (input) => {
        scales.set(input.dataset.tlx, Number(input.value));
        input.classList.remove('unset');
        input.removeAttribute('aria-valuetext');
        dialog.querySelector(`#out-${input.dataset.tlx}`).textContent = input.value;
        dialog.querySelector('#desk-go').disabled = scales.size < Object.keys(D.tlx).length;
      };
      for (const input of dialog.querySelectorAll('[data-tlx]')) {
        if (scales.has(input.dataset.tlx)) {
          input.value = scales.get(input.dataset.tlx);
          touch(input);
        }
        input.oninput = () => touch(input);
        input.onkeydown = (event) => { if (event.key === 'Enter') touch(input); };
        input.onpointerup = () => touch(input);
      }
      dialog.querySelector('#desk-back').onclick = () => this.rate();
      dialog.querySelector('#desk-go').onclick = () => this.ask('rate', { cooper_harper: this.answers, tlx: Object.fromEntries(scales) }, dialog);
    });
  }

  // Which of two scales counted more, for all pairs: the weights of NASA-TLX.
  weigh() {
    this.chosen = [];
    this.turn(() => this.pair(0));
  }

  pair(at) {
    const { chosen } = this;
    const { pairs } = this.state;
    const choices = pairs[at].map((key) => `<button data-scale="${key}" aria-pressed="${chosen[at] === key}"><b>${D.tlx[key][0]}</b> ${D.tlx[key][1]}</button>`).join('');
    const title = `${this.heading()} · NASA-TLX · ${fill(D.pair, { n: at + 1, of: pairs.length })}`;
    this.frame(title, `<p>${D.weigh}</p><div class="choices">${choices}</div>`, at > 0 ? `<button id="desk-back">${D.back}</button>` : '', (dialog) => {
      if (at > 0) dialog.querySelector('#desk-back').onclick = () => this.turn(() => this.pair(at - 1));
      for (const button of dialog.querySelectorAll('[data-scale]')) {
        button.onclick = () => {
          chosen[at] = button.dataset.scale;
          const open = pairs.findIndex((_, i) => !chosen[i]);
          this.turn(open < 0 ? () => this.pairs() : () => this.pair(open));
        };
      }
      (dialog.querySelector('[aria-pressed=true]') || dialog.querySelector('[data-scale]')).focus();
    });
  }

  // All choices, before they are saved: each can be changed by itself.
  pairs() {
    const { chosen } = this;
    const name = (key) => D.tlx[key][0];
    const rows = this.state.pairs.map((pair, i) => `<tr><td>${pair.map((key) => (key === chosen[i] ? `<b>${name(key)} ✓</b>` : name(key))).join(` ${S.or} `)}</td>
      <td><button data-pair="${i}" aria-label="${D.change} ${pair.map(name).join(` ${S.or} `)}">${D.change}</button></td></tr>`).join('');
    this.frame(`${this.heading()} · NASA-TLX`, `<p>${D.chosen}</p><table>${rows}</table>`, `<button class="primary" id="desk-go">${D.save_pairs}</button>`, (dialog) => {
      for (const button of dialog.querySelectorAll('[data-pair]')) button.onclick = () => this.turn(() => this.pair(Number(button.dataset.pair)));
      dialog.querySelector('#desk-go').onclick = () => this.ask('weigh', { chosen }, dialog);
      dialog.querySelector('#desk-go').focus();
    });
  }
}
