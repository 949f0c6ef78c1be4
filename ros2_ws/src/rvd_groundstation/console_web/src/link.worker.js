// The socket and the 50 Hz sampling of the stick, away from the page's own thread: drawing
// cannot delay a stick sample. If the page's thread hangs, its beats stop and the stick is
// released here; if this worker hangs too, the server hears nothing and releases it there.

const SAMPLE_MS = 20;
const BEAT_MS = 350; // a page whose thread is silent for longer has let go of the stick
const RETRY_MS = 1000;
const STICK_KIND = 1;
const AXES = 6; // in a sample, whatever the mission has

let socket = null;
let address = null;
let stick = { held: false, at: [] };
let beatAt = 0;
let flying = false; // we hold the lease
let sequence = 0;
let lastFrame = 0;
let closedFor = '';
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

function open() {
  socket = new WebSocket(address.url, ['rvd.console.1', 'token.' + address.token]);
  socket.onopen = () => postMessage({ link: 'open' });
  socket.onmessage = (event) => {
    const message = JSON.parse(event.data);
    if (message.type === 'frame') {
      if (lastFrame && message.n > lastFrame + 40) ask({ do: 'ping', resync: true });
      lastFrame = message.n;
    } else if (message.type === 'status') {
      flying = message.lease === 'you';
    }
    postMessage(message);
  };
  socket.onclose = (event) => {
    flying = false;
    lastFrame = 0;
    closedFor = event.reason;
    postMessage({ link: 'closed', why: closedFor });
    setTimeout(open, RETRY_MS);
  };
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
