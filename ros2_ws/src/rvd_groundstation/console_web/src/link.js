// The page's side of the worker that holds the socket.

import { recall, remember } from './storage.js';

class Link {
  constructor(token) {
    this.token = token;
    this.waiting = new Map();
    this.number = 0;
    this.early = []; // what came before anybody listened
    this.onMessage = (message) => this.early.push(message);
    this.worker = new Worker(new URL('./link.worker.js', import.meta.url), { type: 'module' });
    this.worker.onmessage = (event) => this.take(event.data);
    const scheme = location.protocol === 'https:' ? 'wss' : 'ws';
    this.worker.postMessage({ open: { url: `${scheme}://${location.host}/ws`, token } });
  }

  listen(onMessage) {
    this.onMessage = onMessage;
    for (const message of this.early.splice(0)) onMessage(message);
  }

  take(message) {
    if (message.type === 'reply' && this.waiting.has(message.id)) {
      this.waiting.get(message.id)(message);
      this.waiting.delete(message.id);
    }
    this.onMessage(message);
  }

  // Say how the stick stands; also the beat that shows that this thread is alive.
  stick(state, now) {
    this.worker.postMessage({ stick: state, now });
  }

  // Ask for something; the promise gives the reply, or NO_ANSWER when none comes in `wait` ms.
  ask(wish, wait = Infinity) {
    const id = ++this.number;
    return new Promise((resolve) => {
      this.waiting.set(id, resolve);
      if (wait < Infinity) {
        setTimeout(() => { if (this.waiting.delete(id)) resolve({ ok: false, code: 'NO_ANSWER' }); }, wait);
      }
      this.worker.postMessage({ ask: { ...wish, id } });
    });
  }

  async get(path) {
    const response = await fetch(path, { headers: { Authorization: `Bearer ${this.token}` } });
    if (!response.ok) throw new Error((await response.text()).trim());
    return response.json();
  }
}

// Where storage is blocked, the entry of the tab's history carries the token across a reload.
const token = decodeURIComponent(location.hash.slice(1)) || recall('session', 'rvd.token') || history.state?.token || '';
if (token) {
  remember('session', 'rvd.token', token);
  history.replaceState({ token }, '', location.pathname + location.search); // the token does not stay on a shared screen
}

// Another address in the bar, with another token, loads no page by itself.
addEventListener('hashchange', () => location.reload());

export const link = token ? new Link(token) : null;
