// Lines along the borders of pieces, each with its number at its middle.
import {
  BufferAttribute,
  CanvasTexture,
  CustomBlending,
  DoubleSide,
  InstancedBufferAttribute,
  InstancedBufferGeometry,
  LinearFilter,
  Mesh,
  OneFactor,
  OneMinusSrcAlphaFactor,
  ShaderMaterial,
  Vector2,
} from 'three';

import { colorOf } from './color_scale.js';
import { make } from './dom.js';
import { lineFragmentShader, lineVertexShader, numberFragmentShader, numberVertexShader } from './shaders.js';

/** @typedef {import('./color_scale.js').Color} Color */
/** @typedef {import('./patch_scene.js').Pieces} Pieces */

const cellSize = 64; // pixels of a number in the picture of all

/**
 * A square of two triangles.
 * @param {number} left its other sides are at 1, -1 and 1
 */
export function squareOf(left) {
  const geometry = new InstancedBufferGeometry();
  const corners = Float32Array.of(left, -1, 0, 1, -1, 0, 1, 1, 0, left, 1, 0);
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  geometry.setIndex([0, 1, 2, 0, 2, 3]);
  return geometry;
}

/**
 * @param {number[]} values
 * @param {number} size how many of them one has
 */
function floats(values, size) {
  return new InstancedBufferAttribute(Float32Array.from(values), size);
}

/**
 * @param {InstancedBufferGeometry} geometry drawn as often as there are instances
 * @param {[string, InstancedBufferAttribute][]} attributes of these by name
 * @param {number} count of them
 * @param {ShaderMaterial} material
 * @param {number} order those of higher ones are drawn over the others
 */
function drawable(geometry, attributes, count, material, order) {
  for (const [name, attribute] of attributes) geometry.setAttribute(name, attribute);
  geometry.instanceCount = count;
  const mesh = new Mesh(geometry, material);
  mesh.frustumCulled = false;
  mesh.renderOrder = order;
  return mesh;
}

/**
 * The place half way along.
 * @param {Float32Array} positions
 * @param {ArrayLike<number>} vertices of the line
 * @returns {number[]}
 */
export function middleOf(positions, vertices) {
  const place = (/** @type {number} */ i) => positions.subarray(3 * vertices[i], 3 * vertices[i] + 3);
  const lengths = [];
  for (let i = 1; i < vertices.length; ++i) {
    const [a, b] = [place(i - 1), place(i)];
    lengths.push(Math.hypot(b[0] - a[0], b[1] - a[1], b[2] - a[2]));
  }
  let left = 0.5 * lengths.reduce((sum, length) => sum + length, 0);
  for (let i = 0; i < lengths.length; ++i) {
    if (lengths[i] > 0 && left <= lengths[i]) {
      const [a, b, share] = [place(i), place(i + 1), left / lengths[i]];
      return [0, 1, 2].map((k) => a[k] + share * (b[k] - a[k]));
    }
    left -= lengths[i];
  }
  return [...place(vertices.length - 1)];
}

export class NumberedLines {
  /**
   * @param {Pieces} pieces
   * @param {Float32Array[]} states positions of the vertices, by state
   * @param {{apart: {value: number}, chosen: {value: number}}} uniforms shared with the surface
   */
  constructor(pieces, states, uniforms) {
    const { of, ways, lines } = pieces;
    this.lines = lines;
    /** The ends of all straight parts. */
    this.pairs = lines.flatMap(({ vertices }) => Array.from(vertices.subarray(1), (to, i) => [vertices[i], to]));
    /** Pixels of the picture that lines are drawn into. */
    this.port = new Vector2(1, 1);
    /** Which line each straight part is of. */
    this.owners = lines.flatMap(({ vertices }, line) => new Array(Math.max(0, vertices.length - 1)).fill(line));
    this.columns = Math.max(1, Math.ceil(Math.sqrt(lines.length)));
    this.tints = new InstancedBufferAttribute(new Uint8Array(3 * this.owners.length), 3, true);
    this.sheet = make('canvas', { width: cellSize * this.columns, height: cellSize * this.columns });
    this.texture = new CanvasTexture(this.sheet);
    this.texture.premultiplyAlpha = true;
    this.texture.flipY = false;
    this.texture.minFilter = LinearFilter;
    this.texture.generateMipmaps = false;
    const own = { ...uniforms, port: { value: this.port } };
    const defines = { PIECES: '' };
    const blending = {
      transparent: true,
      blending: CustomBlending,
      blendSrc: OneFactor,
      blendDst: OneMinusSrcAlphaFactor,
    };
    this.stroke = new ShaderMaterial({
      vertexShader: lineVertexShader,
      fragmentShader: lineFragmentShader,
      uniforms: own,
      defines,
      ...blending,
      depthWrite: false,
      side: DoubleSide,
    });
    this.disc = new ShaderMaterial({
      vertexShader: numberVertexShader,
      fragmentShader: numberFragmentShader,
      uniforms: { ...own, numbers: { value: this.texture }, cells: { value: this.columns } },
      defines,
      ...blending,
      depthWrite: false,
    });
    /** @type {(vertices: number[]) => [string, InstancedBufferAttribute][]} */
    const shared = (vertices) => [
      ['way', floats(vertices.flatMap((v) => Array.from(ways.subarray(3 * of[v], 3 * of[v] + 3))), 3)],
      ['piece', floats(vertices.map((v) => of[v]), 1)],
    ];
    const ofParts = shared(this.pairs.map(([from]) => from));
    ofParts.push(['tint', this.tints]);
    const ofLines = shared(lines.map(({ vertices }) => vertices[0]));
    ofLines.push(['cell', floats(lines.flatMap((_, i) => [i % this.columns, Math.floor(i / this.columns)]), 2)]);
    /** Of each state the lines and their numbers. */
    this.parts = states.map(() => [
      drawable(squareOf(0), ofParts, this.pairs.length, this.stroke, 1),
      drawable(squareOf(-1), ofLines, lines.length, this.disc, 2),
    ]);
    states.forEach((positions, state) => this.place(state, positions));
  }

  /**
   * Puts the lines of a state where its vertices are.
   * @param {number} state
   * @param {Float32Array} positions x, y, z of all vertices
   */
  place(state, positions) {
    const at = (/** @type {number} */ v) => Array.from(positions.subarray(3 * v, 3 * v + 3));
    const [strokes, discs] = this.parts[state].map(({ geometry }) => geometry);
    strokes.setAttribute('start', floats(this.pairs.flatMap(([from]) => at(from)), 3));
    strokes.setAttribute('end', floats(this.pairs.flatMap(([, to]) => at(to)), 3));
    discs.setAttribute('start', floats(this.lines.flatMap(({ vertices }) => middleOf(positions, vertices)), 3));
  }

  /**
   * @param {Color[]} colors of the lines
   * @param {Color} ground of the numbers
   */
  paint(colors, ground) {
    this.owners.forEach((line, part) => this.tints.array.set(Array.from(colors[line]), 3 * part));
    this.tints.needsUpdate = true;
    const pen = this.sheet.getContext('2d');
    if (!pen) return;
    pen.clearRect(0, 0, this.sheet.width, this.sheet.height);
    pen.textAlign = 'center';
    pen.textBaseline = 'middle';
    pen.lineWidth = 4;
    this.lines.forEach(({ number }, i) => {
      const x = (0.5 + (i % this.columns)) * cellSize;
      const y = (0.5 + Math.floor(i / this.columns)) * cellSize;
      pen.fillStyle = colorOf(ground);
      pen.strokeStyle = colorOf(colors[i]);
      pen.beginPath();
      pen.arc(x, y, 0.5 * cellSize - 4, 0, 2 * Math.PI);
      pen.fill();
      pen.stroke();
      pen.fillStyle = colorOf(colors[i]);
      pen.font = `700 ${number < 100 ? 34 : 26}px system-ui, sans-serif`;
      pen.fillText(String(number), x, y + 2);
    });
    this.texture.needsUpdate = true;
  }

  dispose() {
    for (const part of this.parts.flat()) part.geometry.dispose();
    this.stroke.dispose();
    this.disc.dispose();
    this.texture.dispose();
  }
}
