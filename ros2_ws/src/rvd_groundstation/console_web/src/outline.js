// Draws the scene without WebGL: the edges of what is solid and all lines, projected onto a 2-D
// canvas. It has those members of THREE.WebGLRenderer that the scene uses.

import * as THREE from 'three';
import { COLOUR } from './canvas.js';

const FAINT = 0.5; // skins paler than this have lines of their own
const SHARP_DEG = 25; // an edge is where faces meet at more than this
const DASH = [5, 4];

const edges = new WeakMap(); // geometry: its edges
const [matrix, a, b] = [new THREE.Matrix4(), new THREE.Vector4(), new THREE.Vector4()];

function edgesOf(geometry) {
  if (!edges.has(geometry)) edges.set(geometry, new THREE.EdgesGeometry(geometry, SHARP_DEG));
  return edges.get(geometry);
}

export class OutlineRenderer {
  constructor(canvas) {
    Object.assign(this, { canvas, pen: canvas.getContext('2d', { willReadFrequently: true }), ratio: 1, cut: false, colour: '#000' });
    this.at = { left: 0, top: 0, width: 0, height: 0 };
  }

  setPixelRatio(ratio) { this.ratio = ratio; }

  setSize(width, height) {
    this.size = { width, height };
    this.canvas.width = Math.max(1, Math.round(width * this.ratio));
    this.canvas.height = Math.max(1, Math.round(height * this.ratio));
  }

  setScissorTest(cut) { this.cut = cut; }

  setScissor() {} // as the viewport

  setViewport(left, bottom, width, height) {
    this.at = { left, top: this.size.height - bottom - height, width, height };
  }

  setClearColor(hex) { this.colour = `#${hex.toString(16).padStart(6, '0')}`; }

  clear() {
    const { left, top, width, height } = this.cut ? this.at : { left: 0, top: 0, ...this.size };
    this.pen.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.pen.fillStyle = this.colour;
    this.pen.fillRect(left, top, width, height);
  }

  clearDepth() {}

  dispose() {}

  render(scene, lens) {
    const { pen, at } = this;
    scene.updateMatrixWorld();
    lens.updateMatrixWorld();
    pen.save();
    pen.beginPath();
    pen.rect(at.left, at.top, at.width, at.height);
    pen.clip();
    const seen = new THREE.Matrix4().multiplyMatrices(lens.projectionMatrix, lens.matrixWorldInverse);
    scene.traverseVisible((object) => {
      if (!object.layers.test(lens.layers)) return;
      if (object.isLine) this.lines(object, object.geometry, object.isLineSegments ? 2 : 1, seen, `#${object.material.color.getHexString()}`);
      else if (object.isMesh && object.material.opacity > FAINT) this.lines(object, edgesOf(object.geometry), 2, seen, COLOUR.plain);
    });
    pen.restore();
  }

  // Lines between the points of a geometry: each with the next, or with `stride` 2 two by two.
  lines({ matrixWorld, material }, geometry, stride, seen, colour) {
    const { pen } = this;
    const { position } = geometry.attributes;
    const n = Math.min(position.count, geometry.drawRange.count);
    matrix.multiplyMatrices(seen, matrixWorld);
    pen.strokeStyle = colour;
    pen.globalAlpha = material.transparent ? material.opacity : 1;
    pen.lineWidth = 1;
    pen.setLineDash(material.isLineDashedMaterial ? DASH : []);
    pen.beginPath();
    for (let i = 0; i + 1 < n; i += stride) {
      a.fromBufferAttribute(position, i).setW(1).applyMatrix4(matrix);
      b.fromBufferAttribute(position, i + 1).setW(1).applyMatrix4(matrix);
      if (!clipped()) continue;
      pen.moveTo(...this.place(a));
      pen.lineTo(...this.place(b));
    }
    pen.stroke();
    pen.globalAlpha = 1;
  }

  place(p) {
    const { left, top, width, height } = this.at;
    return [left + ((p.x / p.w + 1) / 2) * width, top + ((1 - p.y / p.w) / 2) * height];
  }

  pixels() {
    return this.pen.getImageData(0, 0, this.canvas.width, this.canvas.height).data;
  }
}

// Cut the line from a to b off at the near plane; false when all of it is behind.
function clipped() {
  const [za, zb] = [a.z + a.w, b.z + b.w];
  if (za <= 0 && zb <= 0) return false;
  if (za <= 0) a.lerp(b, (1e-6 - za) / (zb - za));
  else if (zb <= 0) b.lerp(a, (1e-6 - zb) / (za - zb));
  return true;
}
