// The scene: one WebGL canvas behind the page, drawn into the rectangles of two elements: the
// view (orbit, side or top) and the docking camera.

import * as THREE from 'three';
import { COLOURS, Path, Tube, chaser, corridor, ghost, sky, target } from './craft.js';
import { SOFTWARE } from './canvas.js';
import { S, fill } from './strings.js';

export const VIEWS = ['orbit', 'side', 'top'];
const EXAGGERATED = 4; // of the lateral axis in side and top views
const SPAN = 40; // [m] along x in side and top views
const BODY = 1; // layer of the chaser itself, which its own camera does not see
const MAX_PIXELS = 2.2e6;
const [SLOW_MS, FAST_MS, LEAST_QUALITY] = [60, 38, 0.35]; // between two pictures
const MOST_QUALITY = SOFTWARE ? 0.5 : 1; // pixels that the processor draws it lacks for the loop

export class Scene {
  constructor(canvas, view, camera, labels) {
    this.elements = { view, camera, labels };
    this.canvas = canvas;
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: !SOFTWARE, alpha: false,
      powerPreference: 'high-performance', preserveDrawingBuffer: true }); // see `draw`
    this.renderer.autoClear = false;
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.HemisphereLight(0xdfe9ff, 0x2a2a2a, 0.9));
    const sun = new THREE.DirectionalLight(0xffffff, 2.3);
    sun.position.set(-6, 9, 5);
    this.scene.add(sun);
    this.far = new THREE.Scene();
    this.far.add(sky());
    this.static = null;
    this.measured = chaser();
    this.ghost = ghost(COLOURS.predicted);
    this.truth = ghost(COLOURS.truth);
    for (const body of [this.measured, this.ghost, this.truth]) body.visible = false;
    this.measured.traverse((part) => part.layers.set(BODY));
    for (const body of [this.truth, this.ghost]) body.traverse((part) => part.layers.set(BODY));
    this.tube = new Tube(COLOURS.predicted);
    this.lines = {
      measured: new Path(COLOURS.measured, 800), predicted: new Path(COLOURS.predicted, 200),
      drift: new Path(COLOURS.predicted, 32, true), truth: new Path(COLOURS.truth, 2500),
    };
    this.scene.add(this.measured, this.ghost, this.truth, this.tube.mesh,
      ...Object.values(this.lines).map((path) => path.line));
    for (const path of Object.values(this.lines)) path.line.layers.set(BODY);
    this.tube.mesh.layers.set(BODY);
    this.perspective = new THREE.PerspectiveCamera(32, 1, 0.1, 2000);
    this.ortho = new THREE.OrthographicCamera(-1, 1, 1, -1, -100, 200);
    this.dock = new THREE.PerspectiveCamera(20, 1, 0.02, 2000);
    this.dock.up.set(0, 1, 0);
    for (const lens of [this.perspective, this.ortho]) lens.layers.enable(BODY);
    this.orbit = { azimuth: 2.35, height: 0.34, zoom: 1, focus: new THREE.Vector3(-13, 0, 0) };
    this.kind = 'orbit';
    Object.assign(this, { enabled: true, drawn: 0, quality: MOST_QUALITY, adaptive: true, pace: 33, since: 0 });
    this.marks = new Map();
    this.follow(view);
    this.resize();
    const observer = new ResizeObserver(() => this.resize());
    for (const element of [view, camera]) observer.observe(element);
    addEventListener('resize', () => this.resize());
  }

  // A slow machine gets fewer pixels rather than fewer pictures: called once per picture drawn.
  adapt(elapsed) {
    if (!this.adaptive) return;
    this.pace = this.pace * 0.8 + Math.min(elapsed, 400) * 0.2;
    this.since += 1;
    const slow = this.pace > SLOW_MS && this.quality > LEAST_QUALITY;
    const fast = this.pace < FAST_MS && this.quality < MOST_QUALITY;
    if (this.since < (fast ? 150 : 6) || !(slow || fast)) return;
    this.quality = Math.max(LEAST_QUALITY, Math.min(MOST_QUALITY, this.quality * (slow ? 0.7 : 1.25)));
    this.since = 0;
    this.resize();
  }

  setRun(run) {
    if (this.static) this.scene.remove(this.static);
    this.static = new THREE.Group();
    this.start = run.start;
    this.station = target(run.limits.offset);
    this.static.add(this.station, corridor(run.geometry));
    this.scene.add(this.static);
    this.shot = [];
    for (const path of Object.values(this.lines)) path.set([]);
    this.tube.set([]);
  }

  // The canvas covers what is drawn into and no more: where the processor puts the page together,
  // each picture costs by the area. Places are asked for here alone, as asking costs a layout.
  resize() {
    const [view, camera] = [this.elements.view, this.elements.camera].map((e) => e.getBoundingClientRect());
    const [left, top] = [Math.min(view.left, camera.left), Math.min(view.top, camera.top)];
    const width = Math.max(view.right, camera.right) - left;
    const height = Math.max(view.bottom, camera.bottom) - top;
    const inside = (r) => ({ left: r.left - left, bottom: top + height - r.bottom, width: r.width, height: r.height });
    this.places = { view: inside(view), camera: inside(camera) };
    const { canvas } = this;
    Object.assign(canvas.style, { left: `${left}px`, top: `${top}px`, width: `${width}px`, height: `${height}px` });
    const ratio = Math.min(devicePixelRatio || 1, Math.sqrt(MAX_PIXELS / Math.max(width * height, 1)));
    this.renderer.setPixelRatio(ratio * this.quality);
    this.renderer.setSize(width, height, false);
    this.renderer.setScissorTest(false); // what shows between the panels
    this.renderer.setClearColor(0x080c12, 1);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    this.shot = []; // where the docking camera was in its last picture
    this.tall = parseFloat(getComputedStyle(this.elements.labels).fontSize); // of a label, nearly
  }

  // Drag turns, wheel zooms; keys do the same for who has no mouse.
  follow(element) {
    let at = null;
    element.addEventListener('pointerdown', (e) => {
      if (e.target.closest('button')) return;
      at = [e.clientX, e.clientY];
      element.setPointerCapture(e.pointerId);
    });
    element.addEventListener('pointermove', (e) => {
      if (!at) return;
      this.turn((e.clientX - at[0]) * 0.005, (e.clientY - at[1]) * 0.005);
      at = [e.clientX, e.clientY];
    });
    element.addEventListener('pointerup', () => { at = null; });
    element.addEventListener('wheel', (e) => {
      e.preventDefault();
      this.zoom(Math.exp(e.deltaY * 0.001));
    }, { passive: false });
  }

  turn(azimuth, height) {
    this.orbit.azimuth += azimuth;
    this.orbit.height = Math.max(-1.4, Math.min(1.4, this.orbit.height + height));
  }

  zoom(by) {
    this.orbit.zoom = Math.max(0.15, Math.min(4, this.orbit.zoom * by));
  }

  // Put the bodies where the content says. `tube` rows [x, y, z, radius].
  place({ measured, predicted, truth, trail, tube, drift, truthTrail, stale }) {
    put(this.measured, measured);
    put(this.ghost, predicted);
    put(this.truth, truth);
    this.measured.material.emissive.setHex(stale ? 0x30353a : 0x0d2233);
    this.lines.measured.set(trail);
    this.lines.predicted.set(tube);
    this.lines.drift.set(drift || []);
    this.lines.truth.set(truthTrail || []);
    this.tube.set(tube);
    this.seen = { measured, predicted, truth };
  }

  draw() {
    if (!this.enabled) return;
    this.drawn += 1;
    const { view, camera } = this.places;
    const squeeze = this.kind === 'orbit' ? 1 : 1 / EXAGGERATED;
    const bodies = [this.measured, this.ghost, this.truth, this.station].filter(Boolean);
    for (const body of bodies) {
      body.scale.set(1, this.kind === 'side' ? squeeze : 1, this.kind === 'top' ? squeeze : 1);
    }
    const lens = this.lens(view);
    this.into(view, lens, this.kind === 'orbit');
    this.label(lens, view);
    for (const body of bodies) body.scale.set(1, 1, 1);
    const eye = (this.seen && (this.seen.truth || this.seen.measured)) || this.start || [-30, 0, 0];
    // The docking camera sees what does not move, so its picture changes with its place alone.
    if (camera.height > 20 && eye.some((c, i) => c !== this.shot[i])) {
      this.shot = eye.slice(0, 3);
      this.aim(eye, camera);
      this.into(camera, this.dock, true);
    }
  }

  lens(rect) {
    const aspect = rect.width / Math.max(rect.height, 1);
    if (this.kind === 'orbit') {
      const at = this.seen?.measured || this.seen?.truth;
      const o = this.orbit;
      o.focus.x += (0.56 * Math.min(-1, at ? at[0] : -30) - o.focus.x) * 0.08; // both stay in view
      const far = o.zoom * (4 + 2.25 * Math.abs(o.focus.x)) * Math.max(1, 1.45 / aspect);
      const c = Math.cos(o.height);
      this.perspective.position.set(o.focus.x + far * c * Math.cos(o.azimuth),
        o.focus.y + far * Math.sin(o.height), o.focus.z + far * c * Math.sin(o.azimuth));
      this.perspective.lookAt(o.focus);
      this.perspective.aspect = aspect;
      this.perspective.updateProjectionMatrix();
      return this.perspective;
    }
    const lens = this.ortho;
    const half = SPAN / 2;
    const up = half / aspect / EXAGGERATED;
    Object.assign(lens, { left: -half, right: half, top: up, bottom: -up });
    const middle = -SPAN / 2 + 3.5;
    if (this.kind === 'side') { // x to the right, y up
      lens.position.set(middle, 0, 50);
      lens.up.set(0, 1, 0);
    } else { // from above: x to the right, z down the screen, as the camera's right
      lens.position.set(middle, 50, 0);
      lens.up.set(0, 0, -1);
    }
    lens.lookAt(middle, 0, 0);
    lens.updateProjectionMatrix();
    return lens;
  }

  aim(eye, rect) {
    this.dock.position.set(eye[0], eye[1], eye[2]);
    this.dock.lookAt(eye[0] + 10, eye[1], eye[2]); // attitude is held along x
    const range = Math.max(-eye[0], 0.4);
    this.dockTan = Math.max(0.085, Math.min(0.9, 1.35 / range));
    this.dock.fov = (2 * Math.atan(this.dockTan) * 180) / Math.PI;
    this.dock.aspect = rect.width / Math.max(rect.height, 1);
    this.dock.updateProjectionMatrix();
    this.dock.updateMatrixWorld();
  }

  into(rect, lens, withSky) {
    this.renderer.setViewport(rect.left, rect.bottom, rect.width, rect.height);
    this.renderer.setScissor(rect.left, rect.bottom, rect.width, rect.height);
    this.renderer.setClearColor(0x05080c, 1);
    this.renderer.clear(true, true);
    if (withSky) {
      const place = lens.position.clone();
      lens.position.set(0, 0, 0);
      lens.updateMatrixWorld();
      this.renderer.render(this.far, lens);
      lens.position.copy(place);
      lens.updateMatrixWorld();
      this.renderer.clearDepth();
    }
    this.renderer.render(this.scene, lens);
  }

  label(lens, rect) {
    const wanted = new Map();
    for (let x = -35; x < 0; x += 5) wanted.set(`−${-x} m`, { at: [x, 0, 0], drop: 1 });
    if (this.seen?.measured) wanted.set(S.measured, { at: this.seen.measured, kind: 'measured craft' });
    if (this.seen?.predicted) wanted.set(S.predicted, { at: this.seen.predicted, kind: 'predicted craft' });
    if (this.seen?.truth) wanted.set(S.truth, { at: this.seen.truth, kind: 'craft' });
    for (const [text, mark] of this.marks) {
      if (!wanted.has(text)) { mark.remove(); this.marks.delete(text); }
    }
    lens.updateMatrixWorld();
    const placed = []; // names of craft that are close together stand above each other
    for (const [text, { at, kind, drop }] of wanted) {
      let mark = this.marks.get(text);
      if (!mark) {
        mark = document.createElement('span');
        mark.textContent = text;
        if (kind) mark.className = kind;
        this.elements.labels.append(mark);
        this.marks.set(text, mark);
      }
      const p = new THREE.Vector3(at[0], at[1], at[2]).project(lens);
      const inside = Math.abs(p.x) < 0.98 && Math.abs(p.y) < 0.96 && p.z < 1;
      mark.style.display = inside ? '' : 'none';
      const left = Math.round(((p.x + 1) / 2) * rect.width);
      let top = Math.round(((1 - p.y) / 2) * rect.height) + (drop ? 14 : 0);
      if (kind) {
        const near = ([x, y]) => Math.abs(x - left) < 5 * this.tall && Math.abs(y - top) < this.tall;
        while (placed.some(near)) top -= 2;
        placed.push([left, top]);
      }
      mark.style.left = `${left}px`;
      mark.style.top = `${top}px`;
    }
  }

  // Where a point appears on the docking camera, in shares of its half height; null behind.
  onCamera(at) {
    const p = new THREE.Vector3(at[0], at[1], at[2]).project(this.dock);
    return p.z > 1 ? null : [p.x, p.y];
  }

  // How many pixels a part of the scene makes different from a scene without it: for tests.
  covers(part) {
    const body = { measured: this.measured, ghost: this.ghost, truth: this.truth,
      tube: this.tube.mesh, station: this.station, corridor: this.static.children[1] }[part];
    const was = body.visible;
    const shots = [was, false].map((visible) => {
      body.visible = visible;
      this.draw();
      const gl = this.renderer.getContext();
      const data = new Uint8Array(gl.drawingBufferWidth * gl.drawingBufferHeight * 4);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
      return data;
    });
    body.visible = was;
    let n = 0;
    for (let i = 0; i < shots[0].length; i += 4) {
      if (shots[0][i] !== shots[1][i] || shots[0][i + 1] !== shots[1][i + 1]) n += 1;
    }
    return n;
  }
}

function put(body, at) {
  body.visible = Boolean(at);
  if (at) body.position.set(at[0], at[1], at[2]);
}

export function scaleText(kind) {
  return kind === 'orbit' ? '' : fill(S.exaggerated, { n: EXAGGERATED });
}
