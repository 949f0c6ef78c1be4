// The socket and the 50 Hz sampling of the stick, away from the page's own thread: drawing
// cannot delay a stick sample. If the page's thread hangs, its beats stop and the stick is
// released here; if this worker hangs too, the server hears nothing and releases it there.

const SAMPLE_MS = 20;
const BEAT_MS = 350; // a page whose thread is silent for longer has let go of the stick
const RETRY_MS = 1000;
const [SILENT_MS, LOOK_MS] = [700, 100]; // a server speaks four times a second at least
const ABANDON_MS = 10000; // a line that is silent for so long is opened anew
const PROOF_MS = 2000;
const STICK_KIND = 1;
const AXES = 6; // in a sample, whatever the mission has

let socket = null;
let address = null;
let stick = { held: false, at: [] };
let beatAt = 0;
let flying = false; // we hold the lease
let sequence = 0;
let lastFrame = 0;
let heardAt = 0;
let silent = false;
let logging = false; // for the benchmark: tell when each sample went out

const bytes = new ArrayBuffer(4 + 4 * AXES + 8);
const view = new DataView(bytes);

function sample() {
  if (!flying || !socket || socket.readyState !== WebSocket.OPEN) return;
  if (socket.bufferedAmount > 2400) return; // the line is stuck: old sticks are worth nothing
  const alive = performance.now() - beatAt < BEAT_MS;
  const held = alive && stick.held;
  sequence = (sequence + 1) & 0xffff;
  view.setUint8(0, STICK_KIND);
  view.setUint8(1, held ? 1 | ((stick.buttons || 0) << 1) : 0);
  view.setUint16(2, sequence, true);
  for (let i = 0; i < AXES; i += 1) view.setFloat32(4 + 4 * i, (held && stick.at[i]) || 0, true);
  view.setFloat64(4 + 4 * AXES, performance.timeOrigin + performance.now(), true);
  socket.send(bytes);
  if (logging) postMessage({ type: 'sent', sequence, at: view.getFloat64(4 + 4 * AXES, true) });
}

// `proven`: the server that answers knows our token.
function open(proven = false) {
  const line = new WebSocket(address.url, ['rvd.console.1', 'token.' + address.token]);
  let opened = false;
  socket = line;
  line.onopen = () => {
    opened = true;
    heard();
    postMessage({ link: 'open' });
  };
  line.onmessage = (event) => {
    if (line !== socket) return; // abandoned
    heard();
    const message = JSON.parse(event.data);
    if (message.type === 'beat') return;
    if (message.type === 'frame') {
      if (lastFrame && message.n > lastFrame + 40) ask({ do: 'ping', resync: true });
      lastFrame = message.n;
    } else if (message.type === 'status') {
      flying = message.lease === 'you';
    }
    postMessage(message);
  };
  line.onclose = () => {
    if (line === socket) lost(opened || proven ? RETRY_MS : 0, proven && !opened ? 'full' : 'closed');
  };
}

// The line is gone: say so, and come back by itself.
function lost(wait, state = 'closed') {
  socket = null;
  flying = silent = false;
  lastFrame = 0;
  postMessage({ link: state, since: performance.now() - heardAt });
  setTimeout(again, wait);
}

async function again() {
  let state = 'closed';
  try {
    if (await knowsUs()) {
      open(true);
      return;
    }
    state = 'stranger';
  } catch { /* nobody is there */ }
  postMessage({ link: state });
  setTimeout(again, RETRY_MS);
}

const bytesOf = (words) => new TextEncoder().encode(words);
const hex = (data) => [...new Uint8Array(data)].map((byte) => byte.toString(16).padStart(2, '0')).join('');

// Whether the server that answers now has our token: it proves that it does, so that no other program that has taken
// its place is shown the token. Throws where nobody answers.
async function knowsUs() {
  const nonce = hex(crypto.getRandomValues(new Uint8Array(16)));
  const answer = await fetch(`/api/proof?nonce=${nonce}`, { cache: 'no-store', signal: AbortSignal.timeout(PROOF_MS) });
  if (!answer.ok) throw new Error(answer.statusText);
  const key = await crypto.subtle.importKey('raw', bytesOf(address.token), { name: 'HMAC', hash: 'SHA-256' }, false, ['sign']);
  const proof = await crypto.subtle.sign('HMAC', key, bytesOf(`${location.host} ${nonce}`));
  return (await answer.json()).includes(hex(proof));
}

function heard() {
  heardAt = performance.now();
  if (silent) postMessage({ link: 'open' });
  silent = false;
}

// A network that is gone closes no socket: it falls silent.
function listen() {
  if (!socket || socket.readyState !== WebSocket.OPEN) return;
  const since = performance.now() - heardAt;
  if (since > ABANDON_MS) {
    const old = socket;
    lost(0);
    old.close();
  } else if (since > SILENT_MS && !silent) {
    silent = true;
    postMessage({ link: 'silent', since });
  }
}

function ask(wish) {
  if (socket && socket.readyState === WebSocket.OPEN) socket.send(JSON.stringify(wish));
}

onmessage = (event) => {
  const said = event.data;
  if (said.open) {
    address = said.open;
    open();
    setInterval(sample, SAMPLE_MS);
    setInterval(listen, LOOK_MS);
  } else if (said.stick) {
    stick = said.stick;
    beatAt = performance.now();
    if (said.now) sample();
  } else if (said.log) {
    logging = true;
  } else if (said.ask) {
    ask(said.ask);
  }
};
