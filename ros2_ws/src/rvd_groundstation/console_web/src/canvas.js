// What is shown beside the scene: words, and 2D canvases that keep sharp, sized to their box and
// drawn in units of rem.

// By role (see diagram/display.py), and of the page itself.
export const COLOUR = {
  measured: '#7cc4ff', predicted: '#ffb652', truth: '#f2f5f8', target: '#dbe5ee', plain: '#dbe5ee',
  pilot: '#7cc4ff', automatic: '#d59bf6', sent: '#56d6b0', limit: '#8aa4bd', guide: '#b9c2a0', goal: '#56d6b0',
  ok: '#56d6b0', alarm: '#ff7a5c', dim: '#8fa1b3', line: '#263544', text: '#dbe5ee',
};

// Whether WebGL is drawn by the processor, or there is none: there each picture of a canvas that goes through it
// costs more than drawing it at once, and so does every smoothed edge.
export const SOFTWARE = !new URLSearchParams(location.search).has('fine')
  && /swiftshader|llvmpipe|softpipe|software|basic render/i.test(renderer());

function renderer() {
  const gl = document.createElement('canvas').getContext('webgl2');
  if (!gl) return 'software';
  const info = gl.getExtension('WEBGL_debug_renderer_info');
  const name = String(gl.getParameter(info ? info.UNMASKED_RENDERER_WEBGL : gl.RENDERER));
  gl.getExtension('WEBGL_lose_context')?.loseContext();
  return name;
}

// Put words into an element; the same words again cost nothing, where setting them would paint.
export function say(element, words) {
  if (element.textContent !== words) element.textContent = words;
}

// Boxes of canvases and the size of a rem: asked for when they change, as asking in the midst of
// writing costs a layout.
const boxes = new Map();
let rem = 12;
const observer = new ResizeObserver((entries) => entries.forEach(({ target }) => measure(target)));

function measure(canvas) {
  const { width, height } = canvas.getBoundingClientRect();
  boxes.set(canvas, { w: width, h: height });
  rem = parseFloat(getComputedStyle(document.documentElement).fontSize);
}

// The size of small words on a canvas: none is smaller than 11 px.
export const small = (size) => Math.max(11, 0.74 * size);
let pixels = () => Math.min(devicePixelRatio || 1, 2); // of a canvas, per pixel of the page

// Do something with so many pixels in each canvas that is drawn meanwhile.
export function finely(many, work) {
  const usual = pixels;
  pixels = () => many;
  try {
    work();
  } finally {
    pixels = usual;
  }
}

export function begin(canvas) {
  if (!boxes.has(canvas)) {
    measure(canvas);
    observer.observe(canvas);
  }
  const { w, h } = boxes.get(canvas);
  const ratio = pixels();
  const width = Math.max(1, Math.round(w * ratio));
  const height = Math.max(1, Math.round(h * ratio));
  if (canvas.width !== width || canvas.height !== height) Object.assign(canvas, { width, height });
  const pen = canvas.getContext('2d', { willReadFrequently: SOFTWARE });
  pen.setTransform(ratio, 0, 0, ratio, 0, 0);
  pen.clearRect(0, 0, w, h);
  pen.font = `${small(rem)}px system-ui, sans-serif`;
  pen.lineWidth = rem / 12;
  return { pen, w, h, rem };
}

export function ring(pen, x, y, r, colour, dash) {
  pen.strokeStyle = colour;
  pen.setLineDash(dash || []);
  pen.beginPath();
  pen.arc(x, y, Math.max(r, 0), 0, 7);
  pen.stroke();
  pen.setLineDash([]);
}

export function text(pen, words, x, y, colour, align = 'left', base = 'middle') {
  pen.fillStyle = colour;
  pen.textAlign = align;
  pen.textBaseline = base;
  pen.fillText(words, x, y);
}
