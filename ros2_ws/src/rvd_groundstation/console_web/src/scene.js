// The scene: one WebGL canvas behind the page, drawn into the rectangles of two elements: the
// view that was chosen and, where the mission has one, the camera. Without WebGL its lines alone.

import * as THREE from 'three';
import { Path, Tube, colourOf, figure, sky, surface } from './shapes.js';
import { SOFTWARE } from './canvas.js';
import { OutlineRenderer } from './outline.js';
import { DIRECTIONS, along, part, place, trailOf } from './data.js';
import { fieldOf } from './field.js';
import { S, fill } from './strings.js';

const CARRIED = 1; // layer of what moves, which a camera on board does not see
const MAX_PIXELS = 2.2e6;
const [SLOW_MS, FAST_MS, LEAST_QUALITY] = [60, 38, 0.35]; // between two pictures
const MOST_QUALITY = SOFTWARE ? 0.5 : 1; // pixels that the processor draws it lacks for the loop
const TRAIL_POINTS = 1000;
const AHEAD_POINTS = 24; // of the way ahead
const LINE_POINTS = 64;
const [LIT, GREY] = [0x0d2233, 0x30353a]; // glow of what was measured: fresh, too old

const vector = (direction) => new THREE.Vector3(...DIRECTIONS[direction]);

export class Scene {
  constructor(canvas, view, camera, labels) {
    this.elements = { view, camera, labels };
    this.canvas = canvas;
    const looks = { antialias: !SOFTWARE, alpha: false, powerPreference: 'high-performance', preserveDrawingBuffer: true }; // see `draw`
    const context = canvas.getContext('webgl2', looks);
    this.webgl = context !== null;
    if (this.webgl) {
      this.renderer = new THREE.WebGLRenderer({ canvas, context, ...looks });
      this.renderer.autoClear = false;
      canvas.addEventListener('webglcontextlost', () => this.outline());
    } else {
      this.renderer = new OutlineRenderer(canvas);
    }
    this.scene = new THREE.Scene();
    this.scene.add(new THREE.HemisphereLight(0xdfe9ff, 0x2a2a2a, 0.9));
    const sun = new THREE.DirectionalLight(0xffffff, 2.3);
    sun.position.set(-6, 9, 5);
    this.scene.add(sun);
    this.far = new THREE.Scene();
    this.perspective = new THREE.PerspectiveCamera(32, 1, 0.1, 2000);
    this.ortho = new THREE.OrthographicCamera(-1, 1, 1, -1, -100, 200);
    this.onboard = new THREE.PerspectiveCamera(20, 1, 0.02, 2000);
    for (const lens of [this.perspective, this.ortho]) lens.layers.enable(CARRIED);
    Object.assign(this, { display: null, world: null, items: new Map(), bodies: [], eyes: [], chosen: 0 });
    Object.assign(this, { enabled: true, drawn: 0, quality: MOST_QUALITY, adaptive: true, pace: 33, since: 0 });
    this.marks = new Map();
    this.follow(view);
    this.resize();
    const observer = new ResizeObserver(() => this.resize());
    for (const element of [view, camera]) observer.observe(element);
    addEventListener('resize', () => this.resize());
  }

  // Go on without WebGL: the driver took it away, and may again.
  outline() {
    const canvas = this.canvas.cloneNode(false); // a canvas keeps its first kind of context
    this.canvas.replaceWith(canvas);
    this.renderer.dispose();
    Object.assign(this, { canvas, webgl: false, renderer: new OutlineRenderer(canvas) });
    this.resize();
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

  // -- what is in it ------------------------------------------------------------------------------

  setDisplay(display) {
    for (const old of [this.world, ...this.far.children]) discard(old);
    this.far.clear();
    this.far.add(sky(display));
    this.world = new THREE.Group();
    this.scene.add(this.world);
    this.items.clear();
    this.bodies = display.bodies.map((body) => this.add(body, figure(body), !Array.isArray(body.place)));
    this.moving = this.bodies.filter(({ moves }) => moves);
    for (const one of display.surfaces) {
      const item = this.add(one, surface(one), one.kind === 'sphere' && !Array.isArray(one.place));
      if (item.moves) this.moving.push(item);
      else if (one.kind === 'sphere') item.object.position.set(...one.place);
    }
    this.lines = display.lines.map((line) => this.addLine(line));
    this.eyes = display.views.map((view) => ({ azimuth: view.azimuth_rad, height: view.height_rad, zoom: 1,
      focus: view.kind === 'perspective' ? new THREE.Vector3(...lookedAt(view, null)) : null }));
    if (this.display === null || this.chosen >= display.views.length) this.chosen = 0;
    this.display = display;
    this.cameraTan = undefined;
    this.frame = null;
    this.shot = [];
  }

  add(item, object, moves) {
    const made = { item, object, moves };
    if (moves) {
      object.visible = false;
      object.traverse((inner) => inner.layers.set(CARRIED));
    } else if (item.kind === 'body') object.position.set(...item.place);
    this.items.set(item.name, object);
    this.world.add(object);
    return made;
  }

  addLine(line) {
    const stands = Array.isArray(line.points);
    const most = stands ? line.points.length : line.kind === 'line' ? LINE_POINTS : line.since ? AHEAD_POINTS + 3 : TRAIL_POINTS;
    const path = new Path(line.role, most, line.dashed);
    if (stands) path.set({ rows: line.points, at: 0, n: most });
    else path.line.layers.set(CARRIED);
    this.items.set(line.name, path.line);
    this.world.add(path.line);
    const tube = line.spread ? new Tube(line.role) : null;
    if (tube) {
      tube.mesh.layers.set(CARRIED);
      this.world.add(tube.mesh);
    }
    return { line, path, tube, stands };
  }

  // Put everything where a frame says; trails as they were at `now`.
  place(frame, history, now, stale) {
    this.frame = frame;
    for (const { item, object } of this.moving) {
      const at = place(frame, item.place, item.axes);
      object.visible = Boolean(at);
      if (at) object.position.set(...at);
      const turn = at && item.attitude ? part(frame, item.attitude) : undefined;
      if (turn) object.inner.quaternion.set(...turn);
      if (item.role === 'measured' && object.inner?.lit) object.inner.lit.emissive.setHex(stale ? GREY : LIT);
    }
    for (const { line, path, tube, stands } of this.lines) {
      if (stands) continue;
      if (line.kind === 'line') {
        const rows = part(frame, line.points) || [];
        path.set({ rows, at: 0, n: rows.length });
      } else {
        const trail = trailOf(line, history?.trails.get(line.name) || [], frame, now, AHEAD_POINTS);
        path.set(trail);
        tube?.set(trail);
      }
    }
  }

  // The first body of a list whose place the frame tells.
  known(names) {
    for (const name of names) {
      const { item } = this.bodies.find((body) => body.item.name === name);
      const at = place(this.frame, item.place, item.axes);
      if (at) return { item, at, turn: item.attitude ? part(this.frame, item.attitude) : undefined };
    }
    return null;
  }

  // -- where it is drawn --------------------------------------------------------------------------

  // The canvas covers what is drawn into and no more: where the processor puts the page together,
  // each picture costs by the area. Places are asked for here alone, as asking costs a layout.
  resize() {
    const rects = [this.elements.view, this.elements.camera].map((e) => e.getBoundingClientRect());
    const shown = rects.filter((r) => r.width > 0);
    const left = Math.min(...shown.map((r) => r.left));
    const top = Math.min(...shown.map((r) => r.top));
    const width = Math.max(...shown.map((r) => r.right)) - left;
    const height = Math.max(...shown.map((r) => r.bottom)) - top;
    const inside = (r) => ({ left: r.left - left, bottom: top + height - r.bottom, width: r.width, height: r.height });
    this.places = { view: inside(rects[0]), camera: inside(rects[1]) };
    const { canvas } = this;
    Object.assign(canvas.style, { left: `${left + scrollX}px`, top: `${top + scrollY}px`, width: `${width}px`, height: `${height}px` });
    const ratio = Math.min(devicePixelRatio || 1, Math.sqrt(MAX_PIXELS / Math.max(width * height, 1)));
    this.renderer.setPixelRatio(ratio * this.quality);
    this.renderer.setSize(width, height, false);
    this.renderer.setScissorTest(false); // what shows between the panels
    this.renderer.setClearColor(0x080c12, 1);
    this.renderer.clear();
    this.renderer.setScissorTest(true);
    this.shot = []; // where the camera on board was in its last picture
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
    const eye = this.eyes[this.chosen];
    if (!eye?.focus) return;
    eye.azimuth += azimuth;
    eye.height = Math.max(-1.4, Math.min(1.4, eye.height + height));
  }

  zoom(by) {
    const eye = this.eyes[this.chosen];
    if (eye) eye.zoom = Math.max(0.15, Math.min(4, eye.zoom * by));
  }

  // -- a picture ----------------------------------------------------------------------------------

  draw() {
    if (!this.enabled || !this.display) return;
    this.drawn += 1;
    const { view, camera } = this.places;
    const chosen = this.display.views[this.chosen];
    const flat = chosen.kind === 'flat';
    if (flat) for (const { object } of this.bodies) object.scale.setComponent('xyz'.indexOf(chosen.up[1]), 1 / chosen.stretch);
    const lens = flat ? this.flat(chosen, view) : this.orbit(chosen, view);
    this.lens = lens;
    this.into(view, lens, !flat);
    this.label(lens, view, flat ? chosen : null);
    if (flat) for (const { object } of this.bodies) object.scale.set(1, 1, 1);
    if (!this.display.camera || camera.height <= 20) return;
    // The camera sees what does not move, so its picture changes with its place alone.
    const carrier = this.known(this.display.camera.carried_by);
    if (!carrier) { // before any telemetry it shows nothing
      if (this.shot !== null) this.blank(camera);
      this.shot = null;
      return;
    }
    const { at, turn } = eyeOf(this.display.camera, carrier);
    const now = [...at, ...turn];
    this.shot ??= [];
    if (now.some((c, i) => c !== this.shot[i])) {
      this.shot = now;
      this.aim(this.display.camera, at, turn, camera);
      this.into(camera, this.onboard, true);
    }
  }

  orbit(view, rect) {
    const lens = this.perspective;
    const aspect = rect.width / Math.max(rect.height, 1);
    const eye = this.eyes[this.chosen];
    const { focus } = eye;
    focus.lerp(new THREE.Vector3(...lookedAt(view, this.known(view.follow)?.at)), 0.08); // both stay in view
    const out = focus.distanceTo(new THREE.Vector3(...view.centre_m));
    const far = eye.zoom * (view.distance_m + view.growth * out) * Math.max(1, 1.45 / aspect);
    const c = Math.cos(eye.height);
    lens.position.set(focus.x + far * c * Math.cos(eye.azimuth), focus.y + far * Math.sin(eye.height),
      focus.z + far * c * Math.sin(eye.azimuth));
    lens.lookAt(focus);
    lens.aspect = aspect;
    lens.updateProjectionMatrix();
    return lens;
  }

  flat(view, rect) {
    const lens = this.ortho;
    const half = (view.span_m / 2) * this.eyes[this.chosen].zoom;
    const up = half / (rect.width / Math.max(rect.height, 1)) / view.stretch;
    Object.assign(lens, { left: -half, right: half, top: up, bottom: -up });
    const middle = new THREE.Vector3(...view.centre_m);
    lens.up.copy(vector(view.up));
    lens.position.copy(vector(view.right)).cross(lens.up).multiplyScalar(50).add(middle);
    lens.lookAt(middle);
    lens.updateProjectionMatrix();
    return lens;
  }

  aim(camera, eye, turn, rect) {
    const lens = this.onboard;
    const turned = new THREE.Quaternion(...turn);
    lens.up.copy(vector(camera.up).applyQuaternion(turned));
    lens.position.set(...eye);
    lens.lookAt(lens.position.clone().add(vector(camera.look).applyQuaternion(turned)));
    const range = Math.max(along(camera.look, camera.aim_m) - along(camera.look, eye), 0.4);
    this.cameraTan = fieldOf(camera, range, this.cameraTan);
    lens.fov = (2 * Math.atan(this.cameraTan) * 180) / Math.PI;
    lens.aspect = rect.width / Math.max(rect.height, 1);
    lens.updateProjectionMatrix();
    lens.updateMatrixWorld();
  }

  // Draw nothing into a rectangle.
  blank(rect) {
    this.renderer.setViewport(rect.left, rect.bottom, rect.width, rect.height);
    this.renderer.setScissor(rect.left, rect.bottom, rect.width, rect.height);
    this.renderer.setClearColor(0x05080c, 1);
    this.renderer.clear(true, true);
  }

  into(rect, lens, withSky) {
    this.blank(rect);
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

  label(lens, rect, flat) {
    const up = flat ? flat.up : '+y';
    const stretch = flat ? flat.stretch : 1;
    const wanted = new Map();
    for (const { text, at_m: at } of this.display.labels) wanted.set(text, { text, at, drop: 1 });
    for (const { item, object } of this.bodies) {
      const at = item.label ? place(this.frame, item.place, item.axes) : undefined;
      if (!at) continue;
      const top = at.map((c, i) => c + (DIRECTIONS[up][i] * object.reach[i]) / stretch);
      wanted.set(`body ${item.name}`, { text: item.label, at: top, role: item.role });
    }
    for (const [key, mark] of this.marks) {
      if (!wanted.has(key)) { mark.remove(); this.marks.delete(key); }
    }
    lens.updateMatrixWorld();
    const placed = []; // names of bodies that are close together stand above each other
    for (const [key, { text, at, role, drop }] of wanted) {
      let mark = this.marks.get(key);
      if (!mark) {
        mark = document.createElement('span');
        mark.textContent = text;
        if (role) {
          mark.className = 'body';
          mark.style.color = colourOf(role);
        }
        this.elements.labels.append(mark);
        this.marks.set(key, mark);
      }
      const p = new THREE.Vector3(at[0], at[1], at[2]).project(lens);
      const inside = Math.abs(p.x) < 0.98 && Math.abs(p.y) < 0.96 && p.z < 1;
      mark.style.display = inside ? '' : 'none';
      const left = Math.round(((p.x + 1) / 2) * rect.width);
      let top = Math.round(((1 - p.y) / 2) * rect.height) + (drop ? 14 : 0);
      if (role) {
        const near = ([x, y]) => Math.abs(x - left) < 5 * this.tall && Math.abs(y - top) < this.tall;
        while (placed.some(near)) top -= 2;
        placed.push([left, top]);
      }
      mark.style.left = `${left}px`;
      mark.style.top = `${top}px`;
    }
  }

  // Where a point appears in the view, in pixels from its upper left corner; null behind, or before a picture.
  onView(at) {
    if (!this.lens) return null;
    const p = new THREE.Vector3(...at).project(this.lens);
    return p.z > 1 ? null : [((p.x + 1) / 2) * this.places.view.width, ((1 - p.y) / 2) * this.places.view.height];
  }

  // Where a point appears on the camera, in shares of its half width and height; null behind.
  onCamera(at) {
    const p = new THREE.Vector3(...at).project(this.onboard);
    return p.z > 1 ? null : [p.x, p.y];
  }

  // How many pixels an item of the display makes different from a scene without it: for tests.
  covers(name) {
    const object = this.items.get(name);
    const was = object.visible;
    const shots = [was, false].map((visible) => {
      object.visible = visible;
      this.draw();
      if (!this.webgl) return this.renderer.pixels();
      const gl = this.renderer.getContext();
      const data = new Uint8Array(gl.drawingBufferWidth * gl.drawingBufferHeight * 4);
      gl.readPixels(0, 0, gl.drawingBufferWidth, gl.drawingBufferHeight, gl.RGBA, gl.UNSIGNED_BYTE, data);
      return data;
    });
    object.visible = was;
    let n = 0;
    for (let i = 0; i < shots[0].length; i += 4) {
      if (shots[0][i] !== shots[1][i] || shots[0][i + 1] !== shots[1][i + 1]) n += 1;
    }
    return n;
  }
}

// Where a camera is and how it is turned, on the body that carries it.
function eyeOf(camera, carrier) {
  const turn = (camera.turns && carrier.turn) || [0, 0, 0, 1];
  const arm = new THREE.Vector3(...camera.at_m).applyQuaternion(new THREE.Quaternion(...turn));
  return { at: [carrier.at[0] + arm.x, carrier.at[1] + arm.y, carrier.at[2] + arm.z], turn };
}

// Take something out of the scene, and out of the memory of the graphics processor.
function discard(old) {
  old?.traverse((object) => {
    object.geometry?.dispose();
    object.material?.dispose();
  });
  old?.removeFromParent();
}

// Where a perspective view looks: its centre, or a share of the way from there to a body.
function lookedAt(view, at) {
  if (!view.follow.length) return view.centre_m;
  const way = at ? along(view.along, at) - along(view.along, view.centre_m) : view.start_m;
  const slid = view.share * Math.sign(view.start_m) * Math.max(view.least_m, way * Math.sign(view.start_m));
  return view.centre_m.map((c, i) => c + slid * DIRECTIONS[view.along][i]);
}

export function scaleText(view) {
  return view.kind === 'flat' && view.stretch !== 1 ? fill(S.exaggerated, { axis: view.up[1], n: view.stretch }) : '';
}
