// What the browser keeps for this page. A browser may forbid it, by throwing at the mere mention,
// or be full: then nothing is remembered, the page works, and `remembers` is false.

function open(name) {
  try {
    const storage = window[name];
    storage.setItem('rvd.probe', '1');
    storage.removeItem('rvd.probe');
    return storage;
  } catch {
    return null;
  }
}

const stores = { local: open('localStorage'), session: open('sessionStorage') };

export let remembers = stores.local !== null;

export function recall(kind, key) {
  return stores[kind]?.getItem(key) ?? null;
}

export function remember(kind, key, text) {
  try {
    stores[kind]?.setItem(key, text);
  } catch { // full since
    if (kind === 'local') remembers = false;
  }
}
