// A patch in several states, two of them drawn with one camera: side by side, left and right of a
// split, or one over the other.
import {
  BufferAttribute,
  BufferGeometry,
  DataTexture,
  DoubleSide,
  LineBasicMaterial,
  LineSegments,
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
 * @property {number} shown the state that is shown beside state 0 at first
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

/**
 * How two states are shown: each in a half of its own; the whole picture of both, cut by a split;
 * or one through the other.
 * @typedef {'beside' | 'split' | 'overlay'} Arrangement
 */

/**
 * A rectangle of the canvas, pixels of the page from the upper left.
 * @typedef {object} Rectangle
 * @property {number} left
 * @property {number} top
 * @property {number} width
 * @property {number} height
 */

/**
 * Where one of the two states is drawn.
 * @typedef {object} Pane
 * @property {number} side 0 before, 1 after
 * @property {number} state
 * @property {Rectangle} port what the camera fills
 * @property {Rectangle} clip what of that is seen
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
uniform bool isPlain;
uniform bool hasStripes;
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
  if (isPlain) {
    color = gl_FrontFacing ? vec3(0.86, 0.835, 0.79) : vec3(0.66, 0.68, 0.72);
    float key = clamp(dot(normal, vec3(-0.46, 0.56, 0.69)), 0.0, 1.0);
    light = 0.43 + 0.09 * normal.y + 0.54 * key;
  }
  if (hasStripes) {
    // What a wall of straight lamps looks like in a polished surface.
    float place = 7.0 * dot(2.0 * normal.z * normal, vec3(0.34, 0.94, 0.0));
    float soft = max(fwidth(place), 1e-4);
    float stripe = smoothstep(-soft, soft, abs(fract(place) - 0.5) - 0.25);
    color = mix(vec3(0.10, 0.11, 0.13), isPlain ? vec3(0.97) : color, stripe);
    light = 0.45 + 0.55 * light;
  }
  gl_FragColor = vec4(color * light, 1.0);
}`;

// The design over the result that is drawn solid.
const ghostVertexShader = `
varying vec3 facing;
void main() {
  facing = normalMatrix * normal;
  gl_Position = projectionMatrix * modelViewMatrix * vec4(position, 1.0);
}`;

const ghostFragmentShader = `
varying vec3 facing;
void main() {
  float edge = 1.0 - abs(normalize(facing).z);
  gl_FragColor = vec4(0.0, 0.40, 0.72, 0.26 + 0.44 * edge * edge);
}`;
const ghostLine = 0x00457c;

const margin = 1.12; // of the picture over the patch
const worthStacking = 1.3; // how much larger it must be one above the other than side by side

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
 * What a picture of all states must hold: the middle of what is seen of them, half of its sizes
 * along right and up, and how far anything is from there at most.
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
  const seen = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  for (const positions of states) {
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i).sub(middle);
      const [x, y] = [point.dot(right), point.dot(up)];
      seen.left = Math.min(seen.left, x);
      seen.right = Math.max(seen.right, x);
      seen.bottom = Math.min(seen.bottom, y);
      seen.top = Math.max(seen.top, y);
    }
  }
  middle.addScaledVector(right, 0.5 * (seen.left + seen.right));
  middle.addScaledVector(up, 0.5 * (seen.bottom + seen.top));
  return {
    middle,
    width: 0.5 * (seen.right - seen.left),
    height: 0.5 * (seen.top - seen.bottom),
    radius: low.distanceTo(high),
  };
}

/**
 * The edges that only one triangle has, two vertices each.
 * @param {ArrayLike<number>} triangles three vertices each
 */
function borderOf(triangles) {
  /** @type {Map<string, number[]>} */
  const edges = new Map();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let i = 0; i < 3; ++i) {
      const [a, b] = [triangles[t + i], triangles[t + ((i + 1) % 3)]];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      if (!edges.delete(key)) edges.set(key, [a, b]);
    }
  }
  return [...edges.values()].flat();
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
    /** @type {Arrangement} */
    this.arrangement = 'split';
    /** Whether what is side by side stands one above the other, where that is larger. */
    this.isStacked = false;
    /** The states before and after. */
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
      isPlain: { value: false },
      hasStripes: { value: false },
    };
    /** @type {Scene | null} the first state as a ghost, made when it is first needed */
    this.ghost = null;
    this.triangles = patch.triangles;
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
    this.uniforms.isPlain.value = false;
    if (beyond) this.uniforms.beyond.value.set(beyond[0], beyond[1], beyond[2]).divideScalar(255);
    this.scale(limit);
  }

  /** No colours: the form alone, as light shows it. */
  plain() {
    this.uniforms.isPlain.value = true;
  }

  /** @param {boolean} shown whether stripes are mirrored in the surface */
  zebra(shown) {
    this.uniforms.hasStripes.value = shown;
  }

  /** @param {number} limit |value| at which colours end, above 0 */
  scale(limit) {
    this.uniforms.limit.value = limit;
  }

  /**
   * How high a view of this width should be for two pictures, and whether these should stand one
   * above the other.
   * @param {number} width pixels
   * @param {number} least height
   * @param {number} most height
   */
  suited(width, least, most) {
    const { frame } = this;
    /** @type {(columns: number, rows: number) => {height: number, size: number}} */
    const fit = (columns, rows) => {
      const wanted = (rows * (width / columns) * frame.height) / (frame.width || 1);
      const height = Math.round(Math.min(most, Math.max(least, wanted)));
      return { height, size: Math.min(width / columns / frame.width, height / rows / frame.height) };
    };
    const beside = fit(2, 1);
    const stacked = fit(1, 2);
    return stacked.size > worthStacking * beside.size
      ? { isStacked: true, height: stacked.height }
      : { isStacked: false, height: beside.height };
  }

  /**
   * Where the states are drawn, the first one first.
   * @returns {Pane[]}
   */
  panes() {
    const { width, height } = this;
    const [before, after] = this.shown;
    const whole = { left: 0, top: 0, width, height };
    if (this.arrangement === 'overlay') return [{ side: 1, state: after, port: whole, clip: whole }];
    /** @type {(at: number, isStacked: boolean) => Rectangle[]} */
    const parts = (at, isStacked) =>
      isStacked
        ? [{ ...whole, height: at }, { ...whole, top: at, height: height - at }]
        : [{ ...whole, width: at }, { ...whole, left: at, width: width - at }];
    const isBeside = this.arrangement === 'beside';
    const isStacked = isBeside && this.isStacked;
    const at = Math.round(isStacked ? height / 2 : width * (isBeside ? 0.5 : this.split));
    const [first, second] = parts(at, isStacked);
    return [
      { side: 0, state: before, port: isBeside ? first : whole, clip: first },
      { side: 1, state: after, port: isBeside ? second : whole, clip: second },
    ];
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
    const { port } = this.panes()[0];
    const fit = Math.max((2 * width) / port.width, (2 * height) / port.height) || 1;
    return (margin * fit) / this.zoom;
  }

  /** @param {Rectangle} port */
  place(port) {
    const { camera, frame } = this;
    const half = 0.5 * this.pixel();
    camera.left = -half * port.width;
    camera.right = half * port.width;
    camera.top = half * port.height;
    camera.bottom = -half * port.height;
    const distance = 4 * frame.radius + frame.middle.distanceTo(this.target);
    camera.near = 0;
    camera.far = 2 * distance;
    camera.position.set(0, 0, distance).applyQuaternion(camera.quaternion).add(this.target);
    camera.updateProjectionMatrix();
    camera.updateMatrixWorld();
  }

  draw() {
    const { renderer, camera } = this;
    renderer.setScissorTest(false);
    renderer.clear();
    renderer.setScissorTest(true);
    for (const { state, port, clip } of this.panes()) {
      if (clip.width <= 0 || clip.height <= 0) continue;
      this.place(port);
      renderer.setViewport(port.left, this.height - port.top - port.height, port.width, port.height);
      renderer.setScissor(clip.left, this.height - clip.top - clip.height, clip.width, clip.height);
      renderer.render(this.scenes[state], camera);
    }
    if (this.arrangement === 'overlay') renderer.render(this.ghostScene(), camera);
  }

  // The first state, seen through, with its contour.
  ghostScene() {
    if (this.ghost) return this.ghost;
    const skin = new ShaderMaterial({
      vertexShader: ghostVertexShader,
      fragmentShader: ghostFragmentShader,
      side: DoubleSide,
      transparent: true,
      depthWrite: false,
      polygonOffset: true, // where both are the same the result is seen
      polygonOffsetFactor: 1,
      polygonOffsetUnits: 4,
    });
    const contour = new BufferGeometry();
    contour.setAttribute('position', this.geometries[0].getAttribute('position'));
    contour.setIndex(borderOf(this.triangles));
    const line = new LineBasicMaterial({ color: ghostLine, depthTest: false });
    const parts = [new Mesh(this.geometries[0], skin), new LineSegments(contour, line)];
    for (const part of parts) part.frustumCulled = false;
    this.ghost = new Scene().add(...parts);
    return this.ghost;
  }

  /**
   * The pane that a place of the canvas is in.
   * @param {number} x pixels from the left
   * @param {number} y pixels from the top
   */
  paneAt(x, y) {
    const panes = this.panes();
    return (
      panes.find(({ clip }) => x < clip.left + clip.width && y < clip.top + clip.height) ?? panes[panes.length - 1]
    );
  }

  /**
   * Where the vertices of a state are in its pane: pixels from the upper left of the canvas, depth
   * towards the eye.
   * @param {Pane} pane
   */
  projected({ state, port }) {
    this.place(port);
    const matrix = new Matrix4().multiplyMatrices(
      this.camera.projectionMatrix,
      this.camera.matrixWorldInverse,
    );
    const positions = this.positions(state);
    const places = new Float32Array(positions.length);
    const point = new Vector3();
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i).applyMatrix4(matrix);
      places[i] = port.left + 0.5 * (1 + point.x) * port.width;
      places[i + 1] = port.top + 0.5 * (1 - point.y) * port.height;
      places[i + 2] = -point.z;
    }
    return places;
  }

  /** Frees what the scene has on the graphics card; it cannot be drawn again. */
  dispose() {
    for (const geometry of this.geometries) geometry.dispose();
    this.ghost?.traverse((part) => {
      if (!(part instanceof Mesh || part instanceof LineSegments)) return;
      part.geometry.dispose();
      part.material.dispose();
    });
    for (const texture of this.textures.values()) texture.dispose();
    this.material.dispose();
    this.renderer.dispose();
    // Browsers give a page some 16 contexts and free those of dropped canvases late.
    this.renderer.forceContextLoss();
  }
}
