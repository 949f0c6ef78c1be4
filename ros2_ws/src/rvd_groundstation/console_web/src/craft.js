// The two spacecraft, the corridor and the sky, as three.js objects.
// Axes are the target orbital frame: x along track, y radially outward, z completes the triad.

import * as THREE from 'three';
import { mergeGeometries } from 'three/addons/utils/BufferGeometryUtils.js';
import { SOFTWARE } from './canvas.js';

export const COLOURS = {
  measured: 0x7cc4ff, predicted: 0xffb652, wall: 0x6f8aa5, boundary: 0xb9c2a0, truth: 0xf2f5f8,
  auto: 0xd59bf6, ok: 0x56d6b0,
};

// How many pieces a round thing is made of: fewer where the processor draws.
const pieces = (n) => (SOFTWARE ? Math.ceil(n / 2) : n);

// A shape in its place and colour. What is of one material is merged into one mesh: each mesh is a
// call to the graphics driver, and calls, not triangles, are what a picture costs.
function part(geometry, colour, place) {
  geometry.deleteAttribute('uv');
  const shade = new THREE.Color(colour);
  const colours = new Float32Array(geometry.attributes.position.count * 3);
  for (let i = 0; i < colours.length; i += 3) shade.toArray(colours, i);
  geometry.setAttribute('color', new THREE.BufferAttribute(colours, 3));
  return geometry.applyMatrix4(place);
}

function cylinder(colour, top, bottom, length, x) { // its axis along x, `top` towards +x
  const place = new THREE.Matrix4().makeRotationZ(-Math.PI / 2).setPosition(x, 0, 0);
  return part(new THREE.CylinderGeometry(top, bottom, length, pieces(32)), colour, place);
}

function box(colour, x, y, z, sx, sy, sz) {
  return part(new THREE.BoxGeometry(sx, sy, sz), colour, new THREE.Matrix4().setPosition(x, y, z));
}

function panels(colour, frame, x, reach, length, width) {
  const made = [];
  for (const side of [-1, 1]) {
    made.push(box(frame, x, 0, side * (reach + length / 2), width, 0.015, length));
    for (let i = 0; i < 4; i += 1) {
      const z = side * (reach + (length * (i + 0.5)) / 4);
      made.push(box(colour, x, 0.012, z, width * 0.94, 0.012, (length / 4) * 0.9));
    }
    made.push(box(frame, x, 0, (side * reach) / 2 + side * 0.1, 0.04, 0.03, reach));
  }
  return made;
}

// The docking face is at the origin; the body lies behind it, towards -x.
function chaserParts() {
  const [hull, dark, foil] = [0xd5dbe2, 0x3a4652, 0xb98f4c];
  return [
    cylinder(dark, 0.13, 0.16, 0.1, -0.05), cylinder(hull, 0.17, 0.3, 0.2, -0.2),
    cylinder(hull, 0.3, 0.3, 0.5, -0.55), cylinder(foil, 0.3, 0.26, 0.22, -0.91),
    cylinder(dark, 0.09, 0.16, 0.16, -1.09), ...panels(0x27508a, dark, -0.7, 0.34, 0.95, 0.34)];
}

export function chaser() {
  return new THREE.Mesh(mergeGeometries(chaserParts()),
    new THREE.MeshLambertMaterial({ vertexColors: true }));
}

export function ghost(colour) {
  const parts = chaserParts();
  const body = new THREE.Mesh(mergeGeometries(parts), new THREE.MeshBasicMaterial({
    color: colour, transparent: true, opacity: 0.16, depthWrite: false }));
  body.add(new THREE.LineSegments(mergeGeometries(parts.map((one) => new THREE.EdgesGeometry(one, 40))),
    new THREE.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.75 })));
  return body;
}

// Its port is at the origin; the station lies towards +x.
export function target(dockingRadius) {
  const [hull, dark, white] = [0xc3cad2, 0x333e49, 0xf2f5f8];
  const station = new THREE.Mesh(mergeGeometries([
    cylinder(dark, 0.24, 0.2, 0.14, 0.08), cylinder(hull, 0.5, 0.26, 0.3, 0.3),
    cylinder(hull, 0.5, 0.5, 1.5, 1.2), cylinder(0xaeb6be, 0.3, 0.5, 0.35, 2.1),
    ...panels(0x27508a, dark, 1.25, 0.55, 2.1, 0.8)]),
  new THREE.MeshLambertMaterial({ vertexColors: true }));
  // The cross that the camera aims at, and the docking circle.
  station.add(new THREE.Mesh(mergeGeometries([
    box(white, 0, 0, 0, 0.01, 0.3, 0.025), box(white, 0, 0, 0, 0.01, 0.025, 0.3),
    part(new THREE.TorusGeometry(dockingRadius, 0.012, pieces(8), pieces(72)), COLOURS.ok,
      new THREE.Matrix4().makeRotationY(Math.PI / 2))]),
  new THREE.MeshBasicMaterial({ vertexColors: true })));
  return station;
}

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

export function corridor({ x, wall, boundary }) {
  const line = new THREE.LineBasicMaterial({ color: COLOURS.wall, transparent: true, opacity: 0.8 });
  const faint = new THREE.LineBasicMaterial({ color: COLOURS.wall, transparent: true, opacity: 0.38 });
  const dashes = new THREE.LineDashedMaterial({ color: COLOURS.boundary, dashSize: 0.35,
    gapSize: 0.22, transparent: true, opacity: 0.85 });
  const skin = new THREE.MeshBasicMaterial({ color: COLOURS.wall, transparent: true, opacity: 0.05,
    side: THREE.DoubleSide, forceSinglePass: true, depthWrite: false });
  const [ends, radii] = [[x[0], x[x.length - 1]], [wall[0], wall[wall.length - 1]]]; // straight
  const profile = ends.map((s, i) => new THREE.Vector2(radii[i], s));
  const cone = new THREE.Mesh(new THREE.LatheGeometry(profile, pieces(48)), skin);
  cone.rotation.z = -Math.PI / 2;
  const bright = meridians(ends, radii, 4);
  const dim = [...meridians(ends, radii, 12), [new THREE.Vector3(x[0], 0, 0), new THREE.Vector3(0, 0, 0)]];
  for (let s = Math.ceil(x[0] / 5) * 5; s <= -5; s += 5) {
    (s % 10 === 0 ? bright : dim).push(circle(s, interpolate(x, wall, s)));
  }
  const bounds = meridians(x, boundary, 4);
  for (const s of [-10, -20, -30]) bounds.push(circle(s, interpolate(x, boundary, s)));
  const group = new THREE.Group();
  group.add(cone, strokes(bright, line), strokes(dim, faint), strokes(bounds, dashes));
  return group;
}

export function interpolate(xs, ys, x) {
  const share = (x - xs[0]) / (xs[xs.length - 1] - xs[0]);
  const place = Math.max(0, Math.min(xs.length - 1, share * (xs.length - 1)));
  const i = Math.min(Math.floor(place), xs.length - 2);
  return ys[i] + (ys[i + 1] - ys[i]) * (place - i);
}

// Stars, and the Moon at its true angular size below (-y): 1738 of 1938 km.
export function sky() {
  const group = new THREE.Group();
  const places = [];
  let seed = 7;
  const random = () => { seed = (seed * 16807) % 2147483647; return seed / 2147483647; };
  for (let i = 0; i < pieces(1400); i += 1) {
    const u = 2 * random() - 1;
    const a = 2 * Math.PI * random();
    const r = Math.sqrt(1 - u * u);
    places.push(900 * r * Math.cos(a), 900 * u, 900 * r * Math.sin(a));
  }
  const stars = new THREE.BufferGeometry();
  stars.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
  group.add(new THREE.Points(stars, new THREE.PointsMaterial({ color: 0x8fa3ba, size: 1.3,
    sizeAttenuation: false, transparent: true, opacity: 0.7 })));
  const limb = Math.acos(1738 / 1938); // from the middle of the Moon: what lies beyond is hidden
  const geometry = new THREE.SphereGeometry(500 * (1738 / 1938), pieces(96), pieces(16), 0, 2 * Math.PI, 0, 1.05 * limb);
  const position = geometry.attributes.position;
  const colours = [];
  const n = new THREE.Vector3();
  for (let i = 0; i < position.count; i += 1) {
    n.fromBufferAttribute(position, i).normalize();
    const grain = Math.sin(23 * n.x + 5 * Math.sin(17 * n.z)) * Math.sin(19 * n.z + 4 * Math.sin(13 * n.x));
    const light = Math.max(0.15, n.x * -0.35 + n.y * 0.75 + n.z * 0.35);
    const v = light * (0.115 + 0.022 * grain);
    colours.push(v * 0.95, v, v * 1.08);
  }
  geometry.setAttribute('color', new THREE.Float32BufferAttribute(colours, 3));
  const moon = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ vertexColors: true }));
  moon.position.y = -500;
  group.add(moon);
  return group;
}

// A tube of varying radius along points; its topology is fixed, only places change.
export class Tube {
  constructor(colour, stations = 24, sides = 10) {
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
    this.mesh = new THREE.Mesh(geometry, new THREE.MeshBasicMaterial({ color: colour,
      transparent: true, opacity: 0.22, side: THREE.DoubleSide, forceSinglePass: true,
      depthWrite: false }));
    this.mesh.frustumCulled = false;
  }

  // `points` rows [x, y, z, radius], in order along x mostly
  set(points) {
    this.mesh.visible = points.length > 1;
    if (!this.mesh.visible) return;
    for (let i = 0; i < this.stations; i += 1) {
      const place = (i / (this.stations - 1)) * (points.length - 1);
      const j = Math.min(Math.floor(place), points.length - 2);
      const f = place - j;
      const at = (c) => points[j][c] + (points[j + 1][c] - points[j][c]) * f;
      const radius = at(3);
      for (let k = 0; k < this.sides; k += 1) {
        const a = (k / this.sides) * 2 * Math.PI;
        const o = (i * this.sides + k) * 3;
        this.places[o] = at(0);
        this.places[o + 1] = at(1) + radius * Math.cos(a);
        this.places[o + 2] = at(2) + radius * Math.sin(a);
      }
    }
    this.mesh.geometry.attributes.position.needsUpdate = true;
  }
}

// A line whose points change; at most `most` of them.
export class Path {
  constructor(colour, most, dashed) {
    this.most = most;
    this.places = new Float32Array(most * 3);
    const geometry = new THREE.BufferGeometry();
    geometry.setAttribute('position', new THREE.BufferAttribute(this.places, 3));
    const material = dashed
      ? new THREE.LineDashedMaterial({ color: colour, dashSize: 0.25, gapSize: 0.2 })
      : new THREE.LineBasicMaterial({ color: colour });
    this.dashed = dashed;
    this.line = new THREE.Line(geometry, material);
    this.line.frustumCulled = false;
  }

  set(points) {
    const stride = Math.max(1, Math.ceil(points.length / this.most));
    let n = 0;
    for (let i = 0; i < points.length && n < this.most; i += stride, n += 1) {
      this.places.set(points[i].slice(0, 3), n * 3);
    }
    this.line.geometry.setDrawRange(0, n);
    this.line.geometry.attributes.position.needsUpdate = true;
    if (this.dashed) this.line.computeLineDistances();
    this.line.visible = n > 1;
  }
}
