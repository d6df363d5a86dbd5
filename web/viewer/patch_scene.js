// A patch in several states, two of them drawn with one camera: one left of the split, one right.
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  LinearFilter,
  Matrix4,
  Mesh,
  OrthographicCamera,
  Scene,
  ShaderMaterial,
  Vector3,
  WebGLRenderer,
} from 'three';

import { rounding } from './figures.js';

/**
 * Three unit vectors at right angles, in the space of the model.
 * @typedef {object} Viewpoint
 * @property {number[]} right
 * @property {number[]} up
 * @property {number[]} towards from the patch to the eye
 */

/**
 * A mesh whose vertices have one position in each state.
 * @typedef {object} Patch
 * @property {Float32Array[]} positions x, y, z of all vertices, by state; model units
 * @property {Uint16Array | Uint32Array} triangles three vertices each
 * @property {Viewpoint} view from where it is seen at first
 * @property {number} shown the state right of the split at first; left of it is state 0
 * @property {Map<string, Uint8Array>} maps colour maps by name, red, green and blue from low to high
 */

/**
 * Which colours vertices have.
 * @typedef {object} Coloring
 * @property {(Float32Array | null)[]} values one for each vertex, by state
 * @property {string} map the name of the colour map
 * @property {number} limit |value| at which its colours end, above 0
 * @property {boolean} isSigned whether the middle of the map is 0, not its low end
 * @property {import('./color_scale.js').Color} [beyond] the colour beyond the limit; without,
 *   it is that of the map's end
 */

const vertexShader = `
attribute float value;
varying float shown;
varying vec3 facing;
void main() {
  shown = value;
  facing = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

// Light comes from over the shoulder and both sides of the patch are lit alike.
const fragmentShader = `
uniform sampler2D colors;
uniform float limit;
uniform bool bothWays;
uniform bool isBounded;
uniform vec3 beyond;
varying float shown;
varying vec3 facing;
void main() {
  float share = clamp(shown / limit, -1.0, 1.0);
  float place = bothWays ? 0.5 + 0.5 * share : abs(share);
  vec3 color = texture2D(colors, vec2(place * 0.992 + 0.004, 0.5)).rgb;
  if (isBounded && abs(shown) > limit * (1.0 + ${rounding})) color = beyond;
  vec3 normal = normalize(facing);
  normal *= sign(normal.z + 1e-6);
  float light = 0.5 + 0.5 * clamp(dot(normal, vec3(0.28, 0.38, 0.88)), 0.0, 1.0);
  gl_FragColor = vec4(color * light, 1.0);
}`;

const margin = 1.12; // of the picture over the patch

/** @param {Uint8Array} map */
function textureOf(map) {
  const pixels = new Uint8Array((map.length / 3) * 4).fill(255);
  for (let i = 0; i < map.length / 3; ++i) pixels.set(map.subarray(3 * i, 3 * i + 3), 4 * i);
  const texture = new DataTexture(pixels, map.length / 3, 1);
  texture.minFilter = LinearFilter;
  texture.magFilter = LinearFilter;
  texture.needsUpdate = true;
  return texture;
}

/**
 * What a picture of all states must hold: the middle of their box, half of its sizes along right
 * and up, and of its diagonal.
 * @param {Float32Array[]} states
 * @param {Vector3} right
 * @param {Vector3} up
 */
function framing(states, right, up) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const point = new Vector3();
  for (const positions of states) {
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i);
      low.min(point);
      high.max(point);
    }
  }
  const middle = low.clone().add(high).multiplyScalar(0.5);
  let width = 0;
  let height = 0;
  for (const positions of states) {
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i).sub(middle);
      width = Math.max(width, Math.abs(point.dot(right)));
      height = Math.max(height, Math.abs(point.dot(up)));
    }
  }
  return { middle, width, height, radius: 0.5 * low.distanceTo(high) };
}

/**
 * The mesh of one state, which keeps its own copy of the positions.
 * @param {Float32Array} positions
 * @param {BufferAttribute} index
 */
function geometryOf(positions, index) {
  const geometry = new BufferGeometry();
  geometry.setIndex(index);
  geometry.setAttribute('position', new BufferAttribute(positions.slice(), 3));
  geometry.setAttribute('value', new BufferAttribute(new Float32Array(positions.length / 3), 1));
  geometry.computeVertexNormals();
  return geometry;
}

export class PatchScene {
  /**
   * @param {HTMLCanvasElement} canvas
   * @param {WebGL2RenderingContext} context of the canvas
   * @param {Patch} patch
   */
  constructor(canvas, context, patch) {
    this.renderer = new WebGLRenderer({ canvas, context, alpha: true });
    this.renderer.setClearColor(0x000000, 0);
    this.renderer.autoClear = false;
    this.camera = new OrthographicCamera();
    this.right = new Vector3().fromArray(patch.view.right);
    this.up = new Vector3().fromArray(patch.view.up);
    this.home = new Matrix4().makeBasis(this.right, this.up, new Vector3().fromArray(patch.view.towards));
    this.textures = new Map([...patch.maps].map(([name, map]) => [name, textureOf(map)]));
    /** The share of the width left of the split, 0 to 1. */
    this.split = 0.5;
    /** The states left and right of the split. */
    this.shown = [0, patch.shown];
    this.width = 0;
    this.height = 0;
    this.uniforms = {
      /** @type {{value: DataTexture | null}} */
      colors: { value: null },
      limit: { value: 1 },
      bothWays: { value: true },
      isBounded: { value: false },
      beyond: { value: new Vector3() },
    };
    this.material = new ShaderMaterial({ vertexShader, fragmentShader, side: DoubleSide, uniforms: this.uniforms });
    const index = new BufferAttribute(patch.triangles, 1);
    this.geometries = patch.positions.map((positions) => geometryOf(positions, index));
    this.scenes = this.geometries.map((geometry) => {
      const mesh = new Mesh(geometry, this.material);
      mesh.frustumCulled = false;
      return new Scene().add(mesh);
    });
    this.frame = this.framed();
    this.target = this.frame.middle.clone();
    this.zoom = 1;
    this.reset();
  }

  framed() {
    return framing(this.geometries.map((_, state) => this.positions(state)), this.right, this.up);
  }

  /**
   * x, y, z of all vertices in a state, model units.
   * @param {number} state
   */
  positions(state) {
    return /** @type {Float32Array} */ (this.geometries[state].getAttribute('position').array);
  }

  /**
   * Moves the vertices of a state; the camera stays until it is reset.
   * @param {Float32Array} positions x, y, z of all vertices, model units; copied
   * @param {number} state by default the one right of the split
   * @throws {RangeError} if it is of another number of vertices
   */
  update(positions, state = this.shown[1]) {
    const geometry = this.geometries[state];
    const attribute = geometry.getAttribute('position');
    if (positions.length !== attribute.array.length) {
      throw new RangeError(`positions of ${positions.length / 3} vertices, not of ${attribute.count}`);
    }
    attribute.array.set(positions);
    attribute.needsUpdate = true;
    geometry.computeVertexNormals();
    // Nothing may be cut off where the patch has grown.
    const { middle } = this.frame;
    const point = new Vector3();
    for (let i = 0; i < positions.length; i += 3) {
      this.frame.radius = Math.max(this.frame.radius, point.fromArray(positions, i).distanceTo(middle));
    }
  }

  /** Shows all states from where the patch was seen at first. */
  reset() {
    this.frame = this.framed();
    this.camera.quaternion.setFromRotationMatrix(this.home);
    this.target = this.frame.middle.clone();
    this.zoom = 1;
  }

  /** @param {Coloring} coloring */
  color({ values, map, limit, isSigned, beyond }) {
    this.geometries.forEach((geometry, state) => {
      const attribute = geometry.getAttribute('value');
      const some = values[state];
      if (some) attribute.array.set(some);
      else attribute.array.fill(NaN);
      attribute.needsUpdate = true;
    });
    this.uniforms.colors.value = this.textures.get(map) ?? null;
    this.uniforms.bothWays.value = isSigned;
    this.uniforms.isBounded.value = beyond !== undefined;
    if (beyond) this.uniforms.beyond.value.set(beyond[0], beyond[1], beyond[2]).divideScalar(255);
    this.scale(limit);
  }

  /** @param {number} limit |value| at which colours end, above 0 */
  scale(limit) {
    this.uniforms.limit.value = limit;
  }

  /**
   * @param {number} width of the canvas, in pixels of the page
   * @param {number} height
   * @param {number} ratio pixels of the screen to one of the page
   */
  resize(width, height, ratio) {
    this.width = width;
    this.height = height;
    this.renderer.setPixelRatio(ratio);
    this.renderer.setSize(width, height, false);
  }

  /** Model units per pixel. */
  pixel() {
    const { width, height } = this.frame;
    const fit = Math.max((2 * width) / this.width, (2 * height) / this.height) || 1;
    return (margin * fit) / this.zoom;
  }

  place() {
    const { camera, frame } = this;
    const half = 0.5 * this.pixel();
    camera.left = -half * this.width;
    camera.right = half * this.width;
    camera.top = half * this.height;
    camera.bottom = -half * this.height;
    const distance = 4 * frame.radius + frame.middle.distanceTo(this.target);
    camera.near = 0;
    camera.far = 2 * distance;
    camera.position.set(0, 0, distance).applyQuaternion(camera.quaternion).add(this.target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  draw() {
    this.place();
    const { renderer, width, height } = this;
    const at = Math.round(this.split * width);
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    for (const [state, left, size] of [
      [this.shown[0], 0, at],
      [this.shown[1], at, width - at],
    ]) {
      if (size <= 0) continue;
      renderer.setScissor(left, 0, size, height);
      renderer.render(this.scenes[state], this.camera);
    }
  }

  /**
   * Where the vertices of a state are in the picture that was drawn last: pixels from the upper
   * left, depth towards the eye.
   * @param {number} state
   */
  projected(state) {
    const matrix = new Matrix4().multiplyMatrices(
      this.camera.projectionMatrix,
      this.camera.matrixWorldInverse,
    );
    const positions = this.positions(state);
    const places = new Float32Array(positions.length);
    const point = new Vector3();
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i).applyMatrix4(matrix);
      places[i] = 0.5 * (1 + point.x) * this.width;
      places[i + 1] = 0.5 * (1 - point.y) * this.height;
      places[i + 2] = -point.z;
    }
    return places;
  }

  /** Frees what the scene has on the graphics card; it cannot be drawn again. */
  dispose() {
    for (const geometry of this.geometries) geometry.dispose();
    for (const texture of this.textures.values()) texture.dispose();
    this.material.dispose();
    this.renderer.dispose();
    // Browsers give a page some 16 contexts and free those of dropped canvases late.
    this.renderer.forceContextLoss();
  }
}
