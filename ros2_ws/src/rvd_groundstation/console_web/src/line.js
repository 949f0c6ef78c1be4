// The line to the server, by this page's own clock: connected, silent, gone, or a server that does not know our token.

import { S, fill } from './strings.js';

const WORDS = { opening: [S.connecting, ''], none: [S.no_token_title, S.no_page_token], stranger: [S.wrong_token, S.wrong_token_text],
  full: [S.line_full, S.line_again] };

export class Line {
  constructor() {
    this.state = 'opening'; // opening, open, silent, closed, full, stranger, none (this page has no token)
    this.heardAt = performance.now();
    this.wasOpen = false;
  }

  // From the worker: anything that was heard, or how the socket stands.
  take(message) {
    if (message.type || !message.link) { // a frame has counts of the link to the craft
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

  // Large and small words for the banner, null while the line is up.
  words() {
    if (this.up) return null;
    if (this.state in WORDS) return WORDS[this.state];
    const s = this.age().toFixed(0);
    return this.state === 'silent' ? [fill(S.line_silent, { s }), S.line_old] : [fill(S.line_lost, { s }), this.wasOpen ? S.line_again_old : S.line_again];
  }

  // A word or two for the bottom line.
  get short() { return S.line[this.state]; }
}
