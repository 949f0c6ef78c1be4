// What a display is made of, as three.js objects: bodies of simple solids, surfaces, lines, the sky.

import * as THREE from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { COLOUR, SOFTWARE } from './canvas.js';
import { DIRECTIONS } from './data.js';

const SCENE_COLOUR = { ...COLOUR, limit: '#6f8aa5' };
export const colourOf = (role) => SCENE_COLOUR[role];
const AXIS = { x: new THREE.Vector3(1, 0, 0), y: new THREE.Vector3(0, 1, 0), z: new THREE.Vector3(0, 0, 1) };

// How many pieces a round thing is made of: fewer where the processor draws.
const pieces = (n) => (SOFTWARE ? Math.ceil(n / 2) : n);

const vector = (direction) => new THREE.Vector3(...DIRECTIONS[direction]);

// The rotation that lays an axis along a direction.
const turned = (from, direction) => new THREE.Quaternion().setFromUnitVectors(AXIS[from], vector(direction));

// A shape in its place and colour. What is of one material is merged into one mesh: each mesh is a
// call to the graphics driver, and calls, not triangles, are what a picture costs.
function part(geometry, { colour, centre_m: centre, along }, axis) {
  geometry.deleteAttribute('uv');
  const shade = new THREE.Color(colour);
  const colours = new Float32Array(geometry.attributes.position.count * 3);
  for (let i = 0; i < colours.length; i += 3) shade.toArray(colours, i);
  geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
  if (along) geometry.applyQuaternion(turned(axis, along));
  return geometry.translate(...centre);
}

const SOLIDS = {
  box: (s) => part(new THREE.BoxGeometry(...s.size_m), s),
  cylinder: (s) => part(new THREE.CylinderGeometry(s.radius_m, s.other_radius_m ?? s.radius_m, s.length_m, pieces(32)), s, 'y'),
  torus: (s) => part(new THREE.TorusGeometry(s.radius_m, s.thickness_m, pieces(8), pieces(72)), s, 'z'),
};

const solids = (shape) => shape.map((s) => SOLIDS[s.kind](s));

// A body: `inner` turns with its attitude, the group around it stands in its place and is
// squeezed where a view exaggerates an axis.
export function figure(body) {
  const group = new THREE.Group();
  const ghostly = body.role === 'predicted' || body.role === 'truth';
  group.inner = ghostly ? ghost(body) : solid(body);
  group.add(group.inner);
  const { min, max } = new THREE.Box3().setFromObject(group.inner);
  group.reach = 'xyz'.split('').map((axis) => Math.max(-min[axis], max[axis])); // for its name above it
  return group;
}

function solid({ shape }) {
  const made = new THREE.Group();
  const lit = shape.filter((s) => s.lit);
  const marks = shape.filter((s) => !s.lit);
  if (lit.length) {
    made.lit = new THREE.MeshLambertMaterial({ vertexColors: true });
    made.add(new THREE.Mesh(mergeGeometries(solids(lit)), made.lit));
  }
  if (marks.length) made.add(new THREE.Mesh(mergeGeometries(solids(marks)), new THREE.MeshBasicMaterial({ vertexColors: true })));
  return made;
}

function ghost({ role, shape }) {
  const parts = solids(shape);
  const colour = colourOf(role);
  const body = new THREE.Mesh(mergeGeometries(parts), new THREE.MeshBasicMaterial({
    color: colour, transparent: true, opacity: 0.16, depthWrite: false }));
  body.add(new THREE.LineSegments(mergeGeometries(parts.map((one) => new THREE.EdgesGeometry(one, 40))),
    new THREE.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.75 })));
  return body;
}

// -- surfaces and lines: along x here, turned where they belong ---------------------------------

function circle(x, radius) {
  const n = pieces(64);
  return Array.from({ length: n + 1 }, (_, i) => {
    const a = (i / n) * 2 * Math.PI;
    return new THREE.Vector3(x, radius * Math.cos(a), radius * Math.sin(a));
  });
}

function meridians(xs, radii, count) {
  return Array.from({ length: count }, (_, k) => {
    const a = (k / count) * 2 * Math.PI;
    return xs.map((x, i) => new THREE.Vector3(x, radii[i] * Math.cos(a), radii[i] * Math.sin(a)));
  });
}

// Lines through rows of points, each with its own distance along it for dashes.
function strokes(rows, material) {
  const [points, along] = [[], []];
  for (const row of rows) {
    let distance = 0;
    for (let i = 1; i < row.length; i += 1) {
      points.push(row[i - 1], row[i]);
      along.push(distance, distance += row[i].distanceTo(row[i - 1]));
    }
  }
  const geometry = new THREE.BufferGeometry().setFromPoints(points);
  geometry.setAttribute('lineDistance', new THREE.Float32BufferAttribute(along, 1));
  return new THREE.LineSegments(geometry, material);
}

const skinOf = (role, opacity) => new THREE.MeshBasicMaterial({ color: colourOf(role), transparent: true, opacity,
  side: THREE.DoubleSide, forceSinglePass: true, depthWrite: false });
const lineOf = (role, opacity) => new THREE.LineBasicMaterial({ color: colourOf(role), transparent: true, opacity });

function revolved(s) {
  const { stations_m: xs, radii_m: radii } = s;
  const group = new THREE.Group();
  if (s.skin) {
    const skin = new THREE.Mesh(new THREE.LatheGeometry(xs.map((x, i) => new THREE.Vector2(radii[i], x)), pieces(48)), skinOf(s.role, 0.05));
    skin.rotation.z = -Math.PI / 2;
    group.add(skin);
  }
  const bright = [...meridians(xs, radii, s.meridians), ...s.rings.map(([x, r]) => circle(x, r))];
  const faint = [...meridians(xs, radii, s.faint_meridians), ...s.faint_rings.map(([x, r]) => circle(x, r))];
  if (s.axis) faint.push([xs[0], xs[xs.length - 1]].map((x) => new THREE.Vector3(x, 0, 0)));
  const dashes = () => new THREE.LineDashedMaterial({ color: colourOf(s.role), dashSize: 0.35, gapSize: 0.22, transparent: true, opacity: 0.85 });
  if (bright.length) group.add(strokes(bright, s.dashed ? dashes() : lineOf(s.role, 0.8)));
  if (faint.length) group.add(strokes(faint, lineOf(s.role, 0.38)));
  group.quaternion.copy(turned('x', s.along));
  group.position.set(...s.origin_m);
  return group;
}

function sphere({ role, radius_m: radius }) {
  const group = new THREE.Group();
  const swap = ([x, y, z]) => [new THREE.Vector3(x, y, z), new THREE.Vector3(y, x, z), new THREE.Vector3(z, y, x)];
  const round = circle(0, radius).map((p) => swap(p.toArray()));
  group.add(new THREE.Mesh(new THREE.SphereGeometry(radius, pieces(32), pieces(20)), skinOf(role, 0.1)),
    strokes([0, 1, 2].map((k) => round.map((p) => p[k])), lineOf(role, 0.7)));
  return group;
}

export const surface = (s) => (s.kind === 'sphere' ? sphere(s) : revolved(s));

// -- the sky ------------------------------------------------------------------------------------

function stars() {
  const places = [];
  let seed = 7;
  const random = () => { seed = (seed * 16807) % 2147483647; return seed / 2147483647; };
  for (let i = 0; i < pieces(1400); i += 1) {
    const u = 2 * random() - 1;
    const a = 2 * Math.PI * random();
    const r = Math.sqrt(1 - u * u);
    places.push(900 * r * Math.cos(a), 900 * u, 900 * r * Math.sin(a));
  }
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
  return new THREE.Points(geometry, new THREE.PointsMaterial({ color: 0x8fa3ba, size: 1.3, sizeAttenuation: false, transparent: true, opacity: 0.7 }));
}

// A celestial body at its true size in the sky; only the cap that faces us is made.
function ball({ direction, half_angle_rad: half, colour }) {
  const towards = new THREE.Vector3(...direction).normalize();
  const limb = Math.PI / 2 - half; // from its middle: what lies beyond is hidden
  const geometry = new THREE.SphereGeometry(500 * Math.sin(half), pieces(96), pieces(16), 0, 2 * Math.PI, 0, 1.05 * limb);
  geometry.applyQuaternion(new THREE.Quaternion().setFromUnitVectors(AXIS.y, towards.clone().negate()));
  const position = geometry.attributes.position;
  const tint = new THREE.Color().setStyle(colour, THREE.LinearSRGBColorSpace);
  const colours = [];
  const n = new THREE.Vector3();
  for (let i = 0; i < position.count; i += 1) {
    n.fromBufferAttribute(position, i).normalize();
    const grain = Math.sin(23 * n.x + 5 * Math.sin(17 * n.z)) * Math.sin(19 * n.z + 4 * Math.sin(13 * n.x));
    const light = Math.max(0.15, n.x * -0.35 + n.y * 0.75 + n.z * 0.35);
    const v = light * (0.124 + 0.024 * grain);
    colours.push(v * tint.r, v * tint.g, v * tint.b);
  }
  geometry.setAttribute('color', new THREE.Float32BufferAttribute(colours, 3));
  const made = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ vertexColors: true }));
  made.position.copy(towards).multiplyScalar(500);
  return made;
}

export function sky(display) {
  const group = new THREE.Group();
  if (display.stars) group.add(stars());
  for (const one of display.sky) group.add(ball(one));
  return group;
}

// -- lines that change --------------------------------------------------------------------------

// A tube of varying radius along points; its topology is fixed, only places change.
export class Tube {
  constructor(role, stations = 24, sides = 10) {
    this.stations = stations;
    this.sides = sides;
    this.places = new Float32Array(stations * sides * 3);
    const index = [];
    for (let i = 0; i < stations - 1; i += 1) {
      for (let k = 0; k < sides; k += 1) {
        const a = i * sides + k;
        const b = i * sides + ((k + 1) % sides);
        index.push(a, b, a + sides, b, b + sides, a + sides);
      }
    }
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(this.places, 3));
    geometry.setIndex(index);
    this.mesh = new THREE.Mesh(geometry, skinOf(role, 0.22));
    this.mesh.frustumCulled = false;
    this.mesh.visible = false;
  }

  // `n` rows of x, y, z, radius from `at` on; its circles stand across the x axis.
  set({ rows, at, n }) {
    this.mesh.visible = n > 1;
    if (!this.mesh.visible) return;
    for (let i = 0; i < this.stations; i += 1) {
      const share = (i / (this.stations - 1)) * (n - 1);
      const j = Math.min(Math.floor(share), n - 2);
      const f = share - j;
      const value = (c) => rows[j][at + c] + (rows[j + 1][at + c] - rows[j][at + c]) * f;
      const radius = value(3);
      for (let k = 0; k < this.sides; k += 1) {
        const a = (k / this.sides) * 2 * Math.PI;
        const o = (i * this.sides + k) * 3;
        this.places[o] = value(0);
        this.places[o + 1] = value(1) + radius * Math.cos(a);
        this.places[o + 2] = value(2) + radius * Math.sin(a);
      }
    }
    this.mesh.geometry.attributes.position.needsUpdate = true;
  }
}

// A line whose points change; at most `most` of them.
export class Path {
  constructor(role, most, dashed) {
    this.most = most;
    this.places = new Float32Array(most * 3);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(this.places, 3));
    const material = dashed
      ? new THREE.LineDashedMaterial({ color: colourOf(role), dashSize: 0.25, gapSize: 0.2 })
      : new THREE.LineBasicMaterial({ color: colourOf(role) });
    this.dashed = dashed;
    this.line = new THREE.Line(geometry, material);
    this.line.frustumCulled = false;
    this.line.visible = false;
  }

  // `count` rows of x, y, z from `at` on.
  set({ rows, at, n: count }) {
    const last = count > 0 ? rows[count - 1] : null;
    if (rows === this.rows && count === this.count && last === this.last) return; // it has not grown
    Object.assign(this, { rows, count, last });
    const stride = Math.max(1, Math.ceil(count / this.most));
    let n = 0;
    for (let i = 0; i < count && n < this.most; i += stride, n += 1) {
      const row = rows[i];
      this.places[n * 3] = row[at];
      this.places[n * 3 + 1] = row[at + 1];
      this.places[n * 3 + 2] = row[at + 2];
    }
    this.line.geometry.setDrawRange(0, n);
    this.line.geometry.attributes.position.needsUpdate = true;
    if (this.dashed) this.line.computeLineDistances();
    this.line.visible = n > 1;
  }
}
