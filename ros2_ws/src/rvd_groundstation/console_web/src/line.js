// The line to the server, by this page's own clock: connected, silent, gone, or a server that does not know our token.

import { S, fill } from './strings.js';

export class Line {
  constructor() {
    this.state = 'opening'; // opening, open, silent, closed, stranger, none (this page has no token)
    this.heardAt = performance.now();
    this.wasOpen = false;
  }

  // From the worker: anything that was heard, or how the socket stands.
  take(message) {
    if (!message.link) {
      this.heardAt = performance.now();
      return;
    }
    this.state = message.link;
    this.wasOpen ||= message.link === 'open';
    if (message.link === 'open') this.heardAt = performance.now();
    if (message.since !== undefined && this.wasOpen) this.heardAt = performance.now() - message.since;
  }

  get up() { return this.state === 'open'; }

  // Whether what is shown is dead: it was alive, and nothing comes any more.
  get dead() { return this.wasOpen && !this.up; }

  // Seconds since the server was heard.
  age() { return (performance.now() - this.heardAt) / 1000; }

  // Large and small words for the banner; null while the line is up, or is being opened for the first time.
  words() {
    if (this.up || (this.state === 'opening' && !this.wasOpen)) return null;
    if (this.state === 'none') return [S.no_token_title, S.no_page_token];
    if (this.state === 'stranger') return [S.wrong_token, S.wrong_token_text];
    const s = this.age().toFixed(0);
    return this.state === 'silent' ? [fill(S.line_silent, { s }), S.line_old] : [fill(S.line_lost, { s }), this.wasOpen ? S.line_again_old : S.line_again];
  }

  // A word or two for the bottom line.
  get short() { return S.line[this.state]; }
}
