// The two spacecraft, the corridor and the sky, as three.js objects.
// Axes are the target orbital frame: x along track, y radially outward, z completes the triad.

import * as THREE from 'three';

export const COLOURS = {
  measured: 0x7cc4ff, predicted: 0xffb652, wall: 0x6f8aa5, boundary: 0xb9c2a0, truth: 0xf2f5f8,
  auto: 0xd59bf6, ok: 0x56d6b0,
};

function lambert(color, extra) {
  return new THREE.MeshLambertMaterial({ color, ...extra });
}

function cylinder(material, top, bottom, length, x) {
  const mesh = new THREE.Mesh(new THREE.CylinderGeometry(top, bottom, length, 32), material);
  mesh.rotation.z = -Math.PI / 2; // its axis along x, `top` towards +x
  mesh.position.x = x;
  return mesh;
}

function box(material, x, y, z, sx, sy, sz) {
  const mesh = new THREE.Mesh(new THREE.BoxGeometry(sx, sy, sz), material);
  mesh.position.set(x, y, z);
  return mesh;
}

function panels(material, frame, x, reach, length, width) {
  const made = new THREE.Group();
  for (const side of [-1, 1]) {
    made.add(box(frame, x, 0, side * (reach + length / 2), width, 0.015, length));
    for (let i = 0; i < 4; i += 1) {
      const z = side * (reach + (length * (i + 0.5)) / 4);
      made.add(box(material, x, 0.012, z, width * 0.94, 0.012, (length / 4) * 0.9));
    }
    made.add(box(frame, x, 0, (side * reach) / 2 + side * 0.1, 0.04, 0.03, reach));
  }
  return made;
}

// The docking face is at the group's origin; the body lies behind it, towards -x.
export function chaser() {
  const group = new THREE.Group();
  const hull = lambert(0xd5dbe2);
  const dark = lambert(0x3a4652);
  const foil = lambert(0xb98f4c);
  group.add(cylinder(dark, 0.13, 0.16, 0.1, -0.05));
  group.add(cylinder(hull, 0.17, 0.3, 0.2, -0.2));
  group.add(cylinder(hull, 0.3, 0.3, 0.5, -0.55));
  group.add(cylinder(foil, 0.3, 0.26, 0.22, -0.91));
  group.add(cylinder(dark, 0.09, 0.16, 0.16, -1.09));
  group.add(panels(lambert(0x27508a), dark, -0.7, 0.34, 0.95, 0.34));
  return group;
}

export function ghost(colour) {
  const group = chaser();
  const skin = new THREE.MeshBasicMaterial({
    color: colour, transparent: true, opacity: 0.16, depthWrite: false });
  const edge = new THREE.LineBasicMaterial({ color: colour, transparent: true, opacity: 0.75 });
  const meshes = [];
  group.traverse((part) => { if (part.isMesh) meshes.push(part); });
  for (const mesh of meshes) {
    mesh.material = skin;
    mesh.add(new THREE.LineSegments(new THREE.EdgesGeometry(mesh.geometry, 40), edge));
  }
  return group;
}

// Its port is at the origin; the station lies towards +x.
export function target(dockingRadius) {
  const group = new THREE.Group();
  const hull = lambert(0xc3cad2);
  const dark = lambert(0x333e49);
  group.add(cylinder(dark, 0.24, 0.2, 0.14, 0.08));
  group.add(cylinder(hull, 0.5, 0.26, 0.3, 0.3));
  group.add(cylinder(hull, 0.5, 0.5, 1.5, 1.2));
  group.add(cylinder(lambert(0xaeb6be), 0.3, 0.5, 0.35, 2.1));
  group.add(panels(lambert(0x27508a), dark, 1.25, 0.55, 2.1, 0.8));
  // The cross that the camera aims at.
  const mark = new THREE.MeshBasicMaterial({ color: 0xf2f5f8 });
  group.add(box(mark, 0, 0, 0, 0.01, 0.3, 0.025), box(mark, 0, 0, 0, 0.01, 0.025, 0.3));
  const ring = new THREE.Mesh(new THREE.TorusGeometry(dockingRadius, 0.012, 10, 72),
    new THREE.MeshBasicMaterial({ color: COLOURS.ok }));
  ring.rotation.y = Math.PI / 2;
  group.add(ring);
  return group;
}

function circle(x, radius, material) {
  const points = [];
  for (let i = 0; i <= 64; i += 1) {
    const a = (i / 64) * 2 * Math.PI;
    points.push(new THREE.Vector3(x, radius * Math.cos(a), radius * Math.sin(a)));
  }
  return new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), material);
}

function meridians(xs, radii, count, material) {
  const group = new THREE.Group();
  for (let k = 0; k < count; k += 1) {
    const a = (k / count) * 2 * Math.PI;
    const points = xs.map((x, i) => new THREE.Vector3(x, radii[i] * Math.cos(a), radii[i] * Math.sin(a)));
    const line = new THREE.Line(new THREE.BufferGeometry().setFromPoints(points), material);
    line.computeLineDistances();
    group.add(line);
  }
  return group;
}

export function corridor({ x, wall, boundary }) {
  const group = new THREE.Group();
  const line = new THREE.LineBasicMaterial({ color: COLOURS.wall, transparent: true, opacity: 0.8 });
  const faint = new THREE.LineBasicMaterial({ color: COLOURS.wall, transparent: true, opacity: 0.38 });
  const skin = new THREE.MeshBasicMaterial({ color: COLOURS.wall, transparent: true, opacity: 0.05,
    side: THREE.DoubleSide, depthWrite: false });
  const profile = x.map((s, i) => new THREE.Vector2(wall[i], s));
  const cone = new THREE.Mesh(new THREE.LatheGeometry(profile, 48), skin);
  cone.rotation.z = -Math.PI / 2;
  group.add(cone);
  group.add(meridians([x[0], x[x.length - 1]], [wall[0], wall[wall.length - 1]], 4, line));
  group.add(meridians([x[0], x[x.length - 1]], [wall[0], wall[wall.length - 1]], 12, faint));
  for (let s = Math.ceil(x[0] / 5) * 5; s <= -5; s += 5) {
    group.add(circle(s, interpolate(x, wall, s), s % 10 === 0 ? line : faint));
  }
  const dashes = new THREE.LineDashedMaterial({ color: COLOURS.boundary, dashSize: 0.35,
    gapSize: 0.22, transparent: true, opacity: 0.85 });
  group.add(meridians(x, boundary, 4, dashes));
  for (const s of [-10, -20, -30]) group.add(circle(s, interpolate(x, boundary, s), dashes).computeLineDistances());
  const axis = meridians([x[0], 0], [0, 0], 1, faint);
  group.add(axis);
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
  for (let i = 0; i < 1400; i += 1) {
    const u = 2 * random() - 1;
    const a = 2 * Math.PI * random();
    const r = Math.sqrt(1 - u * u);
    places.push(900 * r * Math.cos(a), 900 * u, 900 * r * Math.sin(a));
  }
  const stars = new THREE.BufferGeometry();
  stars.setAttribute('position', new THREE.Float32BufferAttribute(places, 3));
  group.add(new THREE.Points(stars, new THREE.PointsMaterial({ color: 0x8fa3ba, size: 1.3,
    sizeAttenuation: false, transparent: true, opacity: 0.7 })));
  const geometry = new THREE.SphereGeometry(500 * (1738 / 1938), 96, 64);
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
      transparent: true, opacity: 0.22, side: THREE.DoubleSide, depthWrite: false }));
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
