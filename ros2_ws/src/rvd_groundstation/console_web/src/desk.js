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
  }

  show(message, mine) {
    const changed = !this.state || JSON.stringify({ ...this.state, rest_s: 0 }) !== JSON.stringify({ ...message, rest_s: 0 });
    this.state = message;
    this.mine = mine;
    if (changed) this.draw();
  }

  lease(mine) {
    if (mine === this.mine) return;
    this.mine = mine;
    if (this.state) this.draw();
  }

  draw() {
    clearInterval(this.timer);
    if (!this.mine) return;
    const stage = this.state.stage;
    if (stage === 'flying') close();
    else this[stage]();
  }

  async ask(act, extra, dialog) {
    const reply = await this.link.ask({ do: 'desk', act, ...extra });
    const error = dialog?.querySelector('.error');
    if (!reply.ok && error) error.textContent = D.errors[reply.code] || refused(reply.code);
    return reply.ok;
  }

  frame(title, body, buttons, onOpen) {
    const dialog = open(`<h3>${escape(title)}</h3>${body}<p class="error alarm" role="alert"></p><div class="buttons">${buttons}</div>`, onOpen);
    dialog.oncancel = (event) => event.preventDefault();
    return dialog;
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
    this.frame(this.heading(), `<p>${words}</p><p>${fill(D.condition, { mode: escape(label(this.task.display, this.state.mode)) })}</p><p class="dim">${escape(this.task.hint)} ${D.clock}</p>`,
      `<button class="primary" id="desk-go">${D.fly}</button>`, (dialog) => {
        dialog.querySelector('#desk-go').onclick = () => this.ask('fly', {}, dialog);
        dialog.querySelector('#desk-go').focus();
      });
  }

  rest() {
    const until = performance.now() + this.state.rest_s * 1000;
    this.frame(D.rest_title, `<p>${D.rest}</p><p class="verdict" id="rest-left"></p>`,
      `<button class="primary" id="desk-go">${D.go_on}</button>`, (dialog) => {
        const button = dialog.querySelector('#desk-go');
        button.onclick = () => this.ask('go_on', {}, dialog);
        const tick = () => {
          const left = Math.max(0, (until - performance.now()) / 1000);
          dialog.querySelector('#rest-left').textContent = `${left.toFixed(0)} s`;
          button.disabled = left > 0;
        };
        tick();
        this.timer = setInterval(tick, 500);
      });
  }

  done() {
    this.frame(D.done_title, `<p>${fill(D.done, { who: this.state.who })}</p>`, `<button id="desk-go">${D.next}</button>`,
      (dialog) => { dialog.querySelector('#desk-go').onclick = () => this.ask('leave', {}, dialog); });
  }

  rate() {
    this.answers = {};
    this.question('controllable');
  }

  // The decision tree of Cooper and Harper: three questions, then a choice among at most three.
  question(key) {
    const { verdict } = this.state;
    const yesNo = `<button data-answer="yes">${D.yes}</button><button data-answer="no">${D.no}</button>`;
    this.frame(`${this.heading()} · Cooper-Harper`, `<p class="${verdict.success ? 'ok' : ''}">${escape(sentence(verdict.words || ''))}</p><p>${escape(fill(D.tree[key], { goal: this.task.goal }))}</p>`, yesNo, (dialog) => {
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
    if (yes && next) this.question(next);
    else this.pick();
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
          this.tlx();
        };
      }
      dialog.querySelector('[data-rating]').focus();
    });
  }

  tlx() {
    const rows = Object.entries(D.tlx).map(([key, [name, question, low, high]]) => `<fieldset><legend>${name}</legend>
      <label for="tlx-${key}">${question}</label><input type="range" id="tlx-${key}" data-tlx="${key}" min="0" max="100" step="${STEP}" value="50">
      <div class="scale-ends"><span>${low}</span><output id="out-${key}">–</output><span>${high}</span></div></fieldset>`).join('');
    this.frame(`${this.heading()} · NASA-TLX`, rows, `<button class="primary" id="desk-go" disabled>${D.save}</button>`, (dialog) => {
      const touched = new Set();
      const touch = (input) => {
        touched.add(input.dataset.tlx);
        dialog.querySelector(`#out-${input.dataset.tlx}`).textContent = input.value;
        dialog.querySelector('#desk-go').disabled = touched.size < Object.keys(D.tlx).length;
      };
      for (const input of dialog.querySelectorAll('[data-tlx]')) {
        input.oninput = () => touch(input);
        input.onkeydown = (event) => { if (event.key === 'Enter') touch(input); };
        input.onpointerup = () => touch(input);
      }
      dialog.querySelector('#desk-go').onclick = () => {
        const values = Object.fromEntries([...dialog.querySelectorAll('[data-tlx]')].map((i) => [i.dataset.tlx, Number(i.value)]));
        this.ask('rate', { cooper_harper: this.answers, tlx: values }, dialog);
      };
    });
  }

  // Which of two scales counted more, for all pairs: the weights of NASA-TLX.
  weigh(chosen = []) {
    const { pairs } = this.state;
    const choices = pairs[chosen.length].map((key) => `<button data-scale="${key}"><b>${D.tlx[key][0]}</b> ${D.tlx[key][1]}</button>`).join('');
    const title = `${this.heading()} · NASA-TLX · ${fill(D.pair, { n: chosen.length + 1, of: pairs.length })}`;
    this.frame(title, `<p>${D.weigh}</p><div class="choices">${choices}</div>`, `<button id="desk-back">${D.again}</button>`, (dialog) => {
      dialog.querySelector('#desk-back').onclick = () => this.weigh();
      for (const button of dialog.querySelectorAll('[data-scale]')) {
        button.onclick = () => {
          const now = [...chosen, button.dataset.scale];
          if (now.length < pairs.length) this.weigh(now);
          else this.ask('weigh', { chosen: now }, dialog);
        };
      }
      dialog.querySelector('[data-scale]').focus();
    });
  }
}
