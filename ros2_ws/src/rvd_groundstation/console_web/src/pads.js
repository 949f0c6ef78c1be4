// The dialog of the stick: the connected gamepads with what they say now, which one flies, and what
// its axes and buttons mean, by numbers or step by step.

import { closeButton, escape, open } from './dialogs.js';
import { commandText, number } from './instruments.js';
import { say } from './canvas.js';
import { remembers } from './storage.js';
import { NO_AXIS } from './stick.js';
import { S, fill } from './strings.js';

const LOOK_MS = 60;
const [MOVED, LET_GO] = [0.5, 0.3]; // of an axis, from its rest

// What a display shows for a deflection: the command where there is one component for each axis.
function shown(display, value, i) {
  if (value === null) return S.unknown;
  const { axes, digits } = display.commands;
  return axes.length === display.controller.axes.length ? commandText(value * axes[i].highest, digits) : commandText(value, 2);
}

class PadDialog {
  constructor(stick, display) {
    Object.assign(this, { stick, display, seen: null, lead: null });
    this.dialog = open(`<h3>${S.settings_title}</h3><p id="pad-note" role="status"></p>
      <fieldset id="pads"><legend>${S.settings_pads}</legend></fieldset><p id="pad-lead" role="status"></p><div id="pad-steps" class="buttons"></div>
      <table id="pad-axes"></table>
      <p><label>${S.settings_dead_zone} <input type="range" min="0" max="0.4" step="0.01" id="pad-zone" value="${stick.settings.deadZone}"></label></p>
      <p><label><input type="checkbox" id="hold-space" ${stick.settings.holdSpace ? 'checked' : ''}> ${S.settings_space}</label></p>
      ${remembers ? '' : `<p class="alarm">${S.no_storage}</p>`}<div class="buttons">${closeButton}</div>`);
    this.body = this.$('#pads');
    this.dialog.onchange = (event) => this.changed(event.target);
    this.timer = setInterval(() => this.look(), LOOK_MS);
    this.look();
  }

  $(selector) { return this.dialog.querySelector(selector); }

  // Every few hundredths of a second: what is there, and what it says.
  look() {
    const { stick } = this;
    if (!this.dialog.open || !this.dialog.contains(this.body)) {
      clearInterval(this.timer);
      stick.settingUp = false;
      return;
    }
    const pad = stick.gamepad;
    const seen = JSON.stringify([stick.pads.map((one) => [one.id, one.index]), pad?.index, stick.settings.pads, stick.settings.chosen]);
    if (seen !== this.seen) {
      if (this.lead && this.lead.index !== pad?.index) this.stop();
      this.seen = seen;
      this.build();
    }
    stick.pads.forEach((one, i) => say(this.$(`[data-live="${i}"]`), fill(S.pad_live, {
      axes: one.axes.map((v) => number(v, 2)).join(' '),
      buttons: one.buttons.flatMap((b, n) => (b.pressed ? [n] : [])).join(' ') || S.pad_nothing })));
    if (!pad) return;
    stick.deflection(pad).forEach((value, i) => say(this.$(`[data-now="${stick.axes[i].name}"]`), shown(this.display, value, i)));
    if (this.lead) this.follow(pad);
  }

  build() {
    const { stick } = this;
    const pad = stick.gamepad;
    this.$('#pads').hidden = !stick.pads.length;
    this.$('#pads').innerHTML = `<legend>${S.settings_pads}</legend>${stick.pads.map((one, i) => `<p><label><input type="radio" name="pad" value="${i}" ${one === pad ? 'checked' : ''}>
      ${escape(one.id)}${one.mapping === 'standard' ? '' : ` (${S.pad_plain})`}</label><br><small class="dim num" data-live="${i}"></small></p>`).join('')}`;
    const ready = pad && stick.ready(pad);
    const note = !stick.pads.length ? S.settings_none : !pad ? S.pad_choose : ready || this.lead ? S.pad_ready : S.pad_setup;
    say(this.$('#pad-note'), this.lead ? '' : note);
    this.$('#pad-note').className = !pad || ready ? '' : 'alarm';
    this.$('#pad-axes').innerHTML = pad ? this.table(pad) : '';
    if (!this.lead) this.buttons(pad && stick.axes.length ? [['pad-start', S.pad_start, () => this.begin(pad)]] : []);
  }

  table(pad) {
    const { stick } = this;
    const rows = stick.axes.map((axis) => {
      const wiring = stick.wiring(pad, axis);
      return `<tr><td>${escape(`${axis.positive} / ${axis.negative}`)}</td>
        <td>${wiring?.pair ? `${fill(S.settings_pair, { plus: wiring.pair[0], minus: wiring.pair[1] })} ` : ''}<label>${S.settings_axis} <input type="number" class="short" min="${NO_AXIS}" max="${pad.axes.length - 1}" data-axis="${axis.name}" value="${wiring?.axis ?? ''}"></label></td>
        <td><label><input type="checkbox" data-invert="${axis.name}" ${wiring?.sign < 0 ? 'checked' : ''}> ${S.settings_invert}</label></td>
        <td>${S.settings_now} <b data-now="${axis.name}"></b></td></tr>`;
    });
    return `${rows.join('')}<tr><td>${S.settings_button}</td><td colspan="3"><input type="number" class="short" min="0" max="${pad.buttons.length - 1}"
      id="pad-button" aria-label="${S.settings_button}" value="${stick.button(pad) ?? ''}"></td></tr>`;
  }

  changed(input) {
    const { stick } = this;
    const pad = stick.gamepad;
    if (input.name === 'pad') stick.pick(stick.pads[Number(input.value)]);
    else if (input.id === 'pad-zone') stick.change({ deadZone: Number(input.value) });
    else if (input.id === 'hold-space') stick.change({ holdSpace: input.checked });
    else if (pad && input.validity.valid && (input.type === 'checkbox' || input.value !== '')) {
      const name = input.dataset.axis || input.dataset.invert;
      if (input.id === 'pad-button') stick.setUp(pad, { button: Number(input.value) });
      else if (name && this.$(`[data-axis="${name}"]`).value !== '') {
        stick.setUp(pad, { axes: { [name]: { axis: Number(this.$(`[data-axis="${name}"]`).value),
          sign: this.$(`[data-invert="${name}"]`).checked ? -1 : 1 } } });
      }
    }
  }

  // -- step by step -------------------------------------------------------------------------

  buttons(list) {
    this.$('#pad-steps').replaceChildren(...list.map(([id, words, act]) => {
      const button = document.createElement('button');
      Object.assign(button, { id, textContent: words, onclick: act });
      return button;
    }));
  }

  begin(pad) {
    this.stick.settingUp = true; // it does not fly meanwhile
    this.lead = { index: pad.index, at: -1, axes: {}, back: null };
    this.seen = null;
    this.say(S.pad_rest);
    this.buttons([['pad-next', S.pad_next, () => {
      Object.assign(this.lead, { rest: [...this.stick.gamepad.axes], down: this.stick.gamepad.buttons.map((b) => b.pressed) });
      this.next();
    }], ['pad-stop', S.pad_stop, () => this.stop()]]);
  }

  say(words) { say(this.$('#pad-lead'), words); }

  stop() {
    this.stick.settingUp = false;
    this.lead = null;
    this.seen = null;
    this.say('');
  }

  next() {
    const { lead, stick } = this;
    lead.at += 1;
    const axis = stick.axes[lead.at];
    if (!axis) {
      this.say(S.pad_hold);
      this.buttons([['pad-stop', S.pad_stop, () => this.stop()]]);
      return;
    }
    this.say(fill(S.pad_move, { what: axis.positive, name: axis.name }));
    this.buttons([['pad-skip', S.pad_skip, () => {
      lead.axes[axis.name] = { axis: NO_AXIS, sign: 1 };
      this.next();
    }], ['pad-stop', S.pad_stop, () => this.stop()]]);
  }

  // Look for what the step asks to be moved.
  follow(pad) {
    const { lead, stick } = this;
    if (lead.at < 0) return;
    const away = pad.axes.map((v, i) => v - lead.rest[i]);
    if (lead.back !== null) {
      if (Math.abs(away[lead.back]) > LET_GO) return;
      lead.back = null;
      this.next();
      return;
    }
    const axis = stick.axes[lead.at];
    if (!axis) {
      const button = pad.buttons.findIndex((b, i) => b.pressed && !lead.down[i]);
      if (button < 0) return;
      const { axes } = lead;
      this.stop();
      stick.setUp(pad, { axes, button });
      return;
    }
    const used = Object.values(lead.axes).map((w) => w.axis);
    const moved = away.map((v, i) => (used.includes(i) ? 0 : Math.abs(v)));
    const most = moved.indexOf(Math.max(...moved));
    if (!(moved[most] > MOVED)) return;
    if (Math.abs(lead.rest[most]) > LET_GO) {
      this.say(`${fill(S.pad_trigger, { axis: most })} ${fill(S.pad_move, { what: axis.positive, name: axis.name })}`);
      return;
    }
    lead.axes[axis.name] = { axis: most, sign: Math.sign(away[most]) };
    lead.back = most;
    this.say(S.pad_back);
  }
}

export function padDialog(stick, display) {
  return new PadDialog(stick, display);
}
