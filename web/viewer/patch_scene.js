// A patch in several states, two of them drawn with one camera: side by side, left and right of a
// split, or one over the other.
import {
  DataTexture,
  LinearFilter,
  Matrix4,
  OrthographicCamera,
  Vector3,
  WebGLRenderer,
} from 'three';

import { PatchBody } from './patch_body.js';
import { framing } from './patch_geometry.js';

/** @typedef {import('./drawn_lines.js').DrawnLines} DrawnLines */

/**
 * Three unit vectors at right angles, in the space of the model.
 * @typedef {object} Viewpoint
 * @property {number[]} right
 * @property {number[]} up
 * @property {number[]} towards from the patch to the eye
 */

/**
 * A line along the border of a piece.
 * @typedef {object} NumberedLine
 * @property {Uint32Array} vertices along it, two or more
 * @property {number} number that is written at its middle
 */

/**
 * The pieces that a patch consists of, each in one colour. They can be moved apart.
 * @typedef {object} Pieces
 * @property {Uint16Array} of the number of the piece of each vertex, from 0
 * @property {Float32Array} ways x, y, z by piece: where it goes when pieces are one unit apart; model units
 * @property {import('./color_scale.js').Color[]} colors by piece
 * @property {NumberedLine[]} lines
 */

/**
 * A mesh whose vertices have one position in each state.
 * @typedef {object} Patch
 * @property {Float32Array[]} positions x, y, z of all vertices, by state; model units
 * @property {Uint16Array | Uint32Array} triangles three vertices each
 * @property {Viewpoint} view from where it is seen at first
 * @property {number} shown the state that is shown beside state 0 at first; 0 where there is one state only
 * @property {Map<string, Uint8Array>} maps colour maps by name, red, green and blue from low to high
 * @property {Pieces} [pieces] of a patch that consists of several
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
 * How two states are shown, where there are two: each in a half of its own; the whole picture of both, cut by a split;
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
    this.right = new Vector3();
    this.up = new Vector3();
    this.home = new Matrix4();
    this.lookFrom(patch.view);
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
      apart: { value: 0 },
      chosen: { value: -1 },
    };
    this.body = new PatchBody(patch, this.uniforms);
    /** Lines that are drawn over the patch, if any. @type {DrawnLines | null} */
    this.drawn = null;
    this.frame = this.framed();
    this.target = this.frame.middle.clone();
    this.zoom = 1;
    this.reset();
  }

  /**
   * Shows another patch of as many states. What is in the middle of the picture stays there.
   * @param {Patch} patch its `view`, `shown` and `maps` are not looked at
   */
  replace(patch) {
    this.body = new PatchBody(patch, this.uniforms, this.body);
    this.frame = this.framed();
  }

  get geometries() {
    return this.body.geometries;
  }

  get lines() {
    return this.body.lines;
  }

  get pieces() {
    return this.body.pieces;
  }

  framed() {
    return framing(this.geometries.map((_, state) => this.places(state)), this.right, this.up);
  }

  /**
   * Where the vertices of a state are drawn: with their pieces apart.
   * @param {number} state
   */
  places(state) {
    const positions = this.positions(state);
    const apart = this.uniforms.apart.value;
    if (!this.pieces || apart === 0) return positions;
    const { of, ways } = this.pieces;
    return positions.map((place, i) => place + apart * ways[3 * of[Math.floor(i / 3)] + (i % 3)]);
  }

  /**
   * Moves pieces apart. All stay in the picture, as near as they were, and what was in its middle stays there.
   * @param {number} apart 0: in their places
   */
  moveApart(apart) {
    this.uniforms.apart.value = apart;
    const { middle } = this.frame;
    this.frame = this.framed();
    this.target.add(this.frame.middle).sub(middle);
  }

  /** @param {number} piece all others fade; -1: none does */
  choose(piece) {
    this.uniforms.chosen.value = piece;
  }

  /**
   * Says from where the patch is seen when it is reset.
   * @param {Viewpoint} view
   */
  lookFrom({ right, up, towards }) {
    this.right.fromArray(right);
    this.up.fromArray(up);
    this.home.makeBasis(this.right, this.up, new Vector3().fromArray(towards));
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
    this.lines?.place(state, positions);
    // Nothing may be cut off where the patch has grown.
    const { middle } = this.frame;
    const places = this.places(state);
    const point = new Vector3();
    for (let i = 0; i < places.length; i += 3) {
      this.frame.radius = Math.max(this.frame.radius, point.fromArray(places, i).distanceTo(middle));
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

  /** Whether there is one state only, and so one picture. */
  get isSingle() {
    return this.geometries.length === 1;
  }

  /**
   * How high a view of this width should be for its pictures, and whether these should stand one
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
    if (this.isSingle) return { isStacked: false, height: fit(1, 1).height };
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
    if (this.arrangement === 'overlay' || this.isSingle) return [{ side: 1, state: after, port: whole, clip: whole }];
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
      this.lines?.port.set(port.width, port.height);
      renderer.setViewport(port.left, this.height - port.top - port.height, port.width, port.height);
      renderer.setScissor(clip.left, this.height - clip.top - clip.height, clip.width, clip.height);
      renderer.render(this.body.scenes[state], camera);
      if (!this.drawn) continue;
      this.drawn.port.set(port.width, port.height);
      renderer.render(this.drawn.scene, camera);
    }
    if (this.arrangement === 'overlay' && !this.isSingle) renderer.render(this.body.ghostScene(), camera);
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
  projected(pane) {
    return this.project(this.places(pane.state), pane);
  }

  /**
   * Where points are in a pane, as `projected()` has it.
   * @param {Float32Array} positions x, y, z of each, model units
   * @param {Pane} pane
   */
  project(positions, { port }) {
    this.place(port);
    const matrix = new Matrix4().multiplyMatrices(
      this.camera.projectionMatrix,
      this.camera.matrixWorldInverse,
    );
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
    this.body.dispose();
    this.drawn?.dispose();
    for (const texture of this.textures.values()) texture.dispose();
    this.renderer.dispose();
    // Browsers give a page some 16 contexts and free those of dropped canvases late.
    this.renderer.forceContextLoss();
  }
}
