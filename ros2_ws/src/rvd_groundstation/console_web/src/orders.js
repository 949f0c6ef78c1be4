// Requests that steer the run. Each is answered in time, or the page says that it was not; an
// ABORT, which may be asked any number of times, is asked again for as long as the run goes on.

import { label } from './modes.js';
import { S, fill } from './strings.js';

const WAIT_MS = 2500; // the server answers within 2 s, whatever the graph does
const AGAIN_MS = 500;
const QUIET_MS = 800; // an answer that comes within this is no matter
const SAID_MS = 8000;

const pause = (ms) => new Promise((resolve) => { setTimeout(resolve, ms); });

export class Orders {
  constructor(link, store) {
    Object.assign(this, { link, store, wanted: null, unanswered: null });
  }

  async steer(wish) {
    this.unanswered = null;
    const reply = await this.link.ask({ ...wish, run: this.store.run?.name }, WAIT_MS);
    if (reply.code === 'NO_ANSWER') this.unanswered = { wish, at: performance.now() };
  }

  async abort() {
    const run = this.store.run?.name;
    if (this.wanted && !this.wanted.accepted && this.goesOn(this.wanted)) return; // it is being asked for
    const wanted = { run, times: 0, since: performance.now(), accepted: false };
    this.wanted = wanted;
    do {
      wanted.times += 1;
      const reply = await this.link.ask({ do: 'abort', run }, WAIT_MS);
      wanted.accepted = reply.ok;
      if (!reply.ok) await pause(AGAIN_MS);
    } while (!wanted.accepted && this.goesOn(wanted));
  }

  // Whether the run that an ABORT was for is still flown, as far as this page can know.
  goesOn({ run }) {
    const { store } = this;
    return store.run !== null && store.run.name === run && !store.verdict
      && (store.status.phase === 'flying' || !store.connected);
  }

  // What is to be said of them: words, small words.
  words() {
    const { store, wanted, unanswered } = this;
    const offline = store.connected ? '' : `${S.socket_closed}. `;
    if (wanted && !this.goesOn(wanted)) this.wanted = null;
    else if (wanted && !wanted.accepted) {
      if (performance.now() - wanted.since < QUIET_MS) return [S.abort_asked, ''];
      return [S.abort_unconfirmed, offline + fill(S.abort_again, { n: wanted.times })];
    } else if (wanted && store.abortAt === null && store.connected) return [S.abort_accepted, store.frame?.paused ? S.paused : ''];
    if (!unanswered || performance.now() - unanswered.at > SAID_MS || this.done(unanswered.wish)) return null;
    const name = unanswered.wish.do === 'mode' ? label(store.display, unanswered.wish.mode) : S[unanswered.wish.do];
    return [fill(S.unconfirmed, { name: name.toUpperCase() }), offline + S.unconfirmed_hint];
  }

  done(wish) {
    const { frame, verdict, connected } = this.store;
    if (verdict) return true;
    if (!frame || !connected) return false;
    if (wish.do === 'stop') return this.store.status.phase !== 'flying';
    return wish.do === 'mode' ? frame.mode === wish.mode : Boolean(frame.paused) === (wish.do === 'pause');
  }
}
