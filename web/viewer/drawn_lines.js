// Lines over a surface that are no edges of it.
import { DoubleSide, InstancedBufferAttribute, Mesh, Scene, ShaderMaterial, Vector2 } from 'three';

import { squareOf } from './numbered_lines.js';
import { lineFragmentShader, lineVertexShader } from './shaders.js';

/**
 * @typedef {object} DrawnLine
 * @property {ArrayLike<number>} points x, y, z of each, model units
 * @property {import('./color_scale.js').Color} color
 */

export class DrawnLines {
  constructor() {
    this.scene = new Scene();
    /** Pixels of the picture that lines are drawn into. */
    this.port = new Vector2(1, 1);
    this.stroke = new ShaderMaterial({
      vertexShader: lineVertexShader,
      fragmentShader: lineFragmentShader,
      uniforms: { port: { value: this.port }, chosen: { value: -1 }, apart: { value: 0 } },
      defines: { PIECES: '' },
      side: DoubleSide,
      depthWrite: false,
    });
    /** @type {Mesh | null} */
    this.mesh = null;
  }

  /** @param {DrawnLine[]} lines those that there were are gone */
  show(lines) {
    this.clear();
    /** @type {{start: number[], end: number[], tint: number[]}} */
    const all = { start: [], end: [], tint: [] };
    for (const { points, color } of lines) {
      for (let i = 3; i < points.length; i += 3) {
        for (let k = 0; k < 3; ++k) {
          all.start.push(points[i - 3 + k]);
          all.end.push(points[i + k]);
          all.tint.push(color[k]);
        }
      }
    }
    const count = all.start.length / 3;
    if (count === 0) return;
    const geometry = squareOf(0);
    geometry.setAttribute('start', new InstancedBufferAttribute(Float32Array.from(all.start), 3));
    geometry.setAttribute('end', new InstancedBufferAttribute(Float32Array.from(all.end), 3));
    geometry.setAttribute('tint', new InstancedBufferAttribute(Uint8Array.from(all.tint), 3, true));
    geometry.setAttribute('way', new InstancedBufferAttribute(new Float32Array(3 * count), 3));
    geometry.setAttribute('piece', new InstancedBufferAttribute(new Float32Array(count), 1));
    geometry.instanceCount = count;
    this.mesh = new Mesh(geometry, this.stroke);
    this.mesh.frustumCulled = false;
    this.scene.add(this.mesh);
  }

  clear() {
    this.mesh?.removeFromParent();
    this.mesh?.geometry.dispose();
    this.mesh = null;
  }

  /** Frees its GPU memory. */
  dispose() {
    this.clear();
    this.stroke.dispose();
  }
}
