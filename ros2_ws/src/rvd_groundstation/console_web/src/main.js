// The page: words into their places, messages into the store, the store onto the screen.

import { AlarmBar } from './alarmbar.js';
import { banner } from './banner.js';
import { say } from './canvas.js';
import { Coach } from './coach.js';
import { instead, sentence, whoFlies } from './decided.js';
import { Desk } from './desk.js';
import * as dialogs from './dialogs.js';
import { number } from './instruments.js';
import { inForce } from './ladder.js';
import { watchLayout } from './layout.js';
import { link } from './link.js';
import { Live } from './live.js';
import { inTurn, ofKey, showModes } from './modes.js';
import { Orders } from './orders.js';
import { padDialog } from './pads.js';
import { Panels } from './panels.js';
import { Review } from './review.js';
import { Scene } from './scene.js';
import { Stick, typing } from './stick.js';
import { remembers } from './storage.js';
import { Store } from './store.js';
import { S, fill } from './strings.js';

const $ = (id) => document.getElementById(id);
const FRAME_MS = 1000 / 30;
const [READ_MS, IDLE_MS] = [60, 120]; // between two looks of the instruments: a new frame, an old one
const STALE_S = 1.0; // beyond what the delay explains
const ARM_MS = 2000; // between the two presses of ABORT
const BLANK_MS = 1000; // between two pictures of nothing
const ANSWER_MS = 5000; // to a wish of a dialog

for (const element of document.querySelectorAll('[data-s]')) element.textContent = S[element.dataset.s];
for (const element of document.querySelectorAll('[data-a]')) element.setAttribute('aria-label', S[element.dataset.a]);

const store = new Store();
const scene = new Scene($('gl'), $('view'), $('camera'), $('labels'));
const panels = new Panels(scene, (mode) => setMode(mode));
scene.enabled = !new URLSearchParams(location.search).has('plain'); // for weak machines
let armedAt = -Infinity;
let drawnAt = 0;
let readAt = 0;
let readFrame = null;
let blankAt = 0;
let shownVerdict = null;
const stick = new Stick((state, now) => {
  coach.heard(state);
  link?.stick(state, now);
}, () => heldUp());
const desk = new Desk(link);
const orders = new Orders(link, store);
const review = new Review(link, panels, store, () => { refreshRun(); showLive(); }, () => (store.inFlight ? S.review_in_flight : ''));
const live = new Live(() => review.leave());
const alarms = new AlarmBar(store);
watchLayout(scene);
const coach = new Coach(store, scene, stick);

function take(message) {
  if (message.type === 'desk') {
    desk.show(message, store.status.lease === 'you');
    showName();
    return;
  }
  const { phase, lease } = store.status;
  store.take(message);
  if ((message.type === 'run' || message.type === 'hello') && !review.on) refreshRun();
  if (message.type === 'status') {
    if (message.phase === 'starting' && phase !== 'starting') {
      dialogs.close();
      if (review.on && message.lease === 'you') review.leave(); // who starts a run flies it
    }
    if (message.phase === 'refused' && phase !== 'refused' && message.lease === 'you') newRun(message.note);
    if (message.phase !== phase && dialogs.runsShown()) review.list();
    if (message.lease === 'you' && lease !== 'you') stick.taken();
    showStatus();
    desk.lease(message.lease === 'you');
  }
  if (message.type === 'verdict' && store.frame && shownVerdict !== message && !review.on && !store.can.desk) {
    shownVerdict = message;
    dialogs.verdict(message, store.can.fly && store.status.lease === 'you', () => newRun());
  }
  if (message.type === 'event') $('event').textContent = `${number(message.t, 1)} s · ${eventWords(message)}`;
  if (message.type === 'reply' && !message.ok) $('event').textContent = message.code ? dialogs.refused(message.code) : message.text;
  if (!message.type) {
    showStatus();
    showDead();
  }
}

// Of the stick that this page publishes a node knows a Joy and its buttons; a pilot does not.
function eventWords({ code, text }) {
  return (store.run?.operator === 'console' && S.stick_events[code]) || text;
}

// What keeps the pilot from the stick in flight: the heading of a dialog, or a review; '' when nothing does.
function heldUp() {
  return store.inFlight ? dialogs.title() || (review.on ? S.review : '') : '';
}

function refreshRun() {
  const { display } = store;
  if (!display) return;
  panels.setDisplay(display);
  stick.setController(display.controller);
  desk.task = { hint: display.hint, goal: display.goal, display };
  if (!store.run) panels.blank();
  showName();
}

// Of a run its folder and delays; of a session where it stands.
function showName() {
  const { run, display } = store;
  const name = store.can.desk ? desk.title() : run?.name || '';
  $('run-name').textContent = run && display.link ? `${name} · ${run.forward_s} s + ${run.back_s} s` : name;
  $('run-name').title = $('run-name').textContent;
}

// -- what the pilot does ------------------------------------------------------------------

async function toggleLease() {
  await link.ask({ do: store.status.lease === 'you' ? 'drop' : 'take' });
}

function setMode(mode) {
  if (store.frame) orders.steer({ do: 'mode', mode });
}

function togglePause() {
  if (store.frame) orders.steer({ do: store.frame.paused ? 'resume' : 'pause' });
}

function abort() {
  if (!store.can.steer) return;
  const now = performance.now();
  if (now - armedAt < ARM_MS) {
    armedAt = -Infinity;
    orders.abort();
  } else {
    armedAt = now;
  }
  showAbort();
  setTimeout(showAbort, ARM_MS + 50);
}

function showAbort() {
  const armed = performance.now() - armedAt < ARM_MS;
  $('abort').classList.toggle('armed', armed);
  $('abort').disabled = !store.can.steer;
  $('abort').querySelector('small').textContent = !store.can.steer ? S.abort_watch : armed ? S.abort_armed : S.abort_hint;
}

const endRun = () => orders.steer({ do: 'stop' });

function newRun(error = '') {
  if (!store.can.steer) {
    dialogs.message(S.new_run, dialogs.refused('WATCH'));
    return;
  }
  if (store.can.desk) { // what is flown is the session's
    desk.reopen();
    return;
  }
  if (store.status.lease !== 'you') link.ask({ do: 'take' });
  dialogs.newRun(store, (wish) => link.ask(wish, ANSWER_MS), error, store.status.phase === 'flying' ? endRun : null);
}

function nextMode() {
  const names = inTurn(store.display).map((mode) => mode.name);
  if (names.length) setMode(names[(names.indexOf(store.frame?.mode) + 1) % names.length]);
}

const PRESSES = {
  KeyT: toggleLease, KeyP: togglePause, KeyX: abort, KeyN: () => newRun(), KeyV: () => panels.nextView(),
  KeyL: () => review.list(), KeyG: () => padDialog(stick, store.display), Slash: () => dialogs.help(store.display),
  KeyM: () => { if (!review.on) nextMode(); }, KeyK: () => alarms.acknowledge(), KeyO: () => alarms.toggleSound(),
  Equal: () => scene.zoom(0.85), Minus: () => scene.zoom(1.18),
  BracketLeft: () => scene.turn(0.15, 0), BracketRight: () => scene.turn(-0.15, 0),
};
addEventListener('keydown', (event) => {
  if (event.repeat || event.ctrlKey || event.metaKey || event.altKey || typing(event.target)) return;
  if (!['KeyX', 'KeyK', 'KeyO'].includes(event.code) && dialogs.takesKey(event.code)) return;
  const mode = ofKey(store.display, event.code);
  if (PRESSES[event.code] && link) PRESSES[event.code]();
  else if (mode && link && !review.on) setMode(mode.name);
});
$('lease').onclick = toggleLease;
$('pause').onclick = togglePause;
$('abort').onclick = abort;
$('end-run').onclick = endRun;
$('restart').onclick = () => newRun();
$('open-review').onclick = () => review.list();
$('open-settings').onclick = () => padDialog(stick, store.display);
$('open-help').onclick = () => dialogs.help(store.display);

// -- what the page shows ------------------------------------------------------------------

function showStatus() {
  const { status } = store;
  const mine = status.lease === 'you';
  $('lease').textContent = !store.can.steer ? S.watch_only : mine ? S.drop : status.lease === 'other' ? S.taken : S.take;
  $('lease').disabled = status.lease === 'other' || !store.can.steer || !store.connected;
  $('lease').classList.toggle('primary', status.lease === 'free' && !$('lease').disabled);
  $('pages').textContent = status.pages === 1 ? S.pages_one : fill(S.pages, { n: status.pages });
  $('socket-state').textContent = store.line.short;
  $('socket-state').className = store.connected ? 'ok' : 'alarm';
  for (const id of ['pause', 'restart']) $(id).disabled = !mine || !store.connected;
  if (store.can.desk) {
    $('pause').disabled = true;
    $('restart').textContent = S.desk.open;
  }
  showAbort();
}

function showBanner(silence) {
  const { status, frame, run, verdict } = store;
  const ordered = orders.words();
  const line = store.line.words();
  if (ordered) banner(...ordered, true);
  else if (line) banner(...line, store.line.state !== 'opening');
  else if (status.phase === 'idle') banner(S.idle, store.can.desk ? S.desk.idle : S.idle_text);
  else if (status.phase === 'starting' || (status.phase === 'flying' && !frame)) banner(S.starting, status.progress || status.run || '');
  else if (status.phase === 'refused') banner(S.run_refused, status.note, true);
  else if (status.note?.startsWith('failed')) banner(S.run_failed, status.note.slice(7), true);
  else if (status.phase === 'ended' && !verdict && status.note) banner(dialogs.sentence(status.note), '');
  else if (silence) banner(fill(S.stale_frames, { s: silence.toFixed(0) }), '', true);
  else if (store.abortAt !== null && !verdict && frame) {
    const acts = !store.display.link || [...store.ladder.values()].some(inForce);
    const does = store.display.abort;
    const since = frame.t - store.abortAt;
    // Telemetry of the step in which it acts at the latest has come down by then, if any has.
    const late = since > run.forward_s + run.back_s + 2 * run.step_s + STALE_S;
    if (acts) banner(does ? fill(S.aborted_so, { does }) : S.aborted, '', true);
    else if (late) banner(S.abort_untold, fill(S.abort_untold_hint, { s: since.toFixed(0) }), true);
    else banner(fill(S.abort_sent, { s: Math.max(0, run.forward_s - since).toFixed(0) }), '', true);
  } else if (status.pilot_lost) banner(instead(S.pilot_lost, flying()), '', true);
  else if (heldUp() && status.lease === 'you') banner(released(), stickBack(), true);
  else if (frame?.paused) banner(S.paused, '');
  else if (frame && !store.measured && status.phase === 'flying') banner(S.no_telemetry, fill(S.first_in, { s: Math.max(0, run.back_s - frame.t).toFixed(0) }));
  else if (verdict) banner(dialogs.sentence(verdict.words), '', !verdict.success);
  else banner('');
}

// Who flies by the newest command; null where that is not told, or not known any more.
function flying() {
  return store.inFlight && !store.dead() ? whoFlies(store.display, store.frame) : null;
}

function released() {
  return instead(fill(S.stick_released, { what: heldUp() }), flying());
}

// After an ABORT there is nothing to fly on.
const stickBack = () => (store.abortAt === null ? S.stick_back : '');

// How the stick stands, and who flies where it does not.
function stickWords(held, stuck) {
  if (!stick.axes.length) return S.stick_none;
  if (!store.connected) return S.stick_unheard;
  const found = flying();
  if (heldUp()) return released();
  if (stick.gone()) return instead(S.stick_gone, found);
  if (stuck.length) return fill(S.stick_stuck, { axes: stuck.join(', ') });
  return held ? instead(`${S.stick_held} · ${S[stick.source]}`, found) : instead(document.hasFocus() ? S.stick_open : S.stick_away, found);
}

function showStick() {
  const mine = store.status.lease === 'you';
  const held = stick.state().held;
  const stuck = stick.stuck();
  const good = held && !stuck.length && store.connected;
  say($('stick-state'), mine ? stickWords(held, stuck) : S.stick_watch);
  $('stick-state').className = !mine ? 'dim' : good ? 'ok' : 'alarm';
  const step = store.display?.controller?.step_name;
  say($('step'), mine && stick.source === 'keyboard' && stick.deflections.length > 1 ? `${step} ${stick.step}` : '');
}

// What this browser cannot do, and what its pads lack.
function showNotes() {
  const notes = [scene.webgl ? '' : S.no_webgl, remembers ? '' : S.no_storage, stick.axes.length ? S.pad_notes[stick.lacks()] : ''];
  say($('notes'), notes.filter(Boolean).join(' · '));
  $('notes').title = $('notes').textContent;
}

function showClocks(frame, now) {
  const { run, measured } = store;
  const age = measured ? store.clock() - measured.t : null;
  const stale = age !== null && age > run.back_s + STALE_S * Math.max(run.pace, 1);
  panels.clocks(frame, store.clock(), age === null ? '' : fill(S.age, { s: number(age, 1) }),
    measured ? fill(S.ago, { s: number(Math.max(store.clock() - measured.received, 0), 1) }) : '', stale);
  return stale;
}

function showFrame() {
  const { frame, run, history } = store;
  const silence = store.silence();
  showBanner(silence);
  const held = heldUp() && store.status.lease === 'you' ? `${released()}. ${stickBack()}` : '';
  dialogs.note([alarms.words(), held].filter(Boolean).join(' · '));
  showStick();
  showNotes();
  $('end-run').hidden = !(store.abortAt !== null && store.status.phase === 'flying' && store.status.lease === 'you' && !store.verdict);
  say($('pause'), frame?.paused ? S.resume : S.pause);
  showModes(store.display, frame, frame?.mode || run?.mode, store.status.lease === 'you' && !store.can.desk);
  if (!run && store.display && performance.now() - blankAt > BLANK_MS) { // boxes change until the page has settled
    blankAt = performance.now();
    panels.blank();
  }
  if (!run || !frame) return;
  const now = store.now();
  const stale = showClocks(frame, now) || store.dead();
  panels.show({ run, frame, history, rungs: [...store.ladder.values()], now, stale });
  if (store.dead()) say($('why'), S.unknown); // who flies is not known any more
}

function showDead() {
  document.body.classList.toggle('dead', store.dead() && !review.on);
}

// The flight under way, beside a review of another.
function showLive() {
  if (!review.on || !store.inFlight) {
    live.hide();
    return;
  }
  const found = flying();
  live.show(store, [
    store.line.words()?.slice(0, 1).concat(true) ?? [orders.words()?.[0], true],
    store.status.lease === 'you' ? [released(), true] : [found ? sentence(found) : '', found?.alarm],
    [store.frame.paused ? S.paused : '', false],
    [store.silence() ? fill(S.stale_frames, { s: store.silence().toFixed(0) }) : '', true]]);
}

// The scene moves in every picture; what is read changes with a frame, and no eye reads faster.
function draw(at) {
  requestAnimationFrame(draw);
  if (at - drawnAt < FRAME_MS - 2) return;
  scene.adapt(at - drawnAt);
  drawnAt = at;
  const due = at - readAt > (store.frame === readFrame && !review.on ? IDLE_MS : READ_MS);
  if (due) {
    readAt = at;
    readFrame = store.frame;
    showDead();
    if (review.on) review.show();
    else showFrame();
    showLive();
  }
  scene.draw();
  if (due) coach.show(review.on);
  if (due) panels.showReticle(review.on ? review.frame() : store.frame);
}

showStatus();
if (link) link.listen(take);
else {
  take({ link: 'none' });
  dialogs.message(S.no_token_title, S.no_page_token);
}
requestAnimationFrame(draw);
window.rvd = { store, scene, stick, review, link, panels, alarms }; // for tests and the curious
