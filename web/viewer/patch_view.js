// A patch that can be turned, in two states: side by side, with a split between them that can be
// moved, or one over the other. Its styles are in viewer.css, which takes colours from variables of the page: --ground,
// --card, --ink and --blue.
import { make } from './dom.js';
import { PatchScene } from './patch_scene.js';
import { hitAt, pick } from './picking.js';
import { Turning } from './turning.js';

/** @typedef {import('./patch_scene.js').Arrangement} Arrangement */
/** @typedef {import('./patch_scene.js').Coloring} Coloring */
/** @typedef {import('./color_scale.js').Color} Color */
/** @typedef {import('./patch_scene.js').Patch} Patch */
/** @typedef {import('./patch_scene.js').Viewpoint} Viewpoint */

/**
 * What a view calls.
 * @typedef {object} VertexListener
 * @property {(vertex: number) => void} hovered the vertex under the pointer, or -1
 * @property {(vertex: number, event: MouseEvent) => void} clicked the vertex that was clicked, or -1
 */

/**
 * A canvas to draw in space on; null where the browser cannot.
 * @returns {{canvas: HTMLCanvasElement, context: WebGL2RenderingContext} | null}
 */
export function spaceCanvas() {
  const canvas = make('canvas');
  const context = canvas.getContext('webgl2', { antialias: true, alpha: true });
  return context && { canvas, context };
}

export class PatchView {
  /**
   * The view is drawn as soon as its root has a place in the page.
   * @param {{canvas: HTMLCanvasElement, context: WebGL2RenderingContext}} space of `spaceCanvas()`
   * @param {Patch} patch
   * @param {VertexListener} listener
   * @param {{what?: string, tags?: string[]}} [words] what is seen, and what it is called before and after
   */
  constructor({ canvas, context }, patch, listener, { what = 'Patch', tags = ['before', 'after'] } = {}) {
    this.canvas = canvas;
    this.triangles = patch.triangles;
    this.marked = -1;
    /** Pixels that the height of the view stays between; without, it is that of its style sheet. */
    this.heights = /** @type {{least: number, most: number} | null} */ (null);
    /**
     * Where the vertices of a side are in the picture, kept until it changes.
     * @type {Map<number, Float32Array>}
     */
    this.kept = new Map();
    this.waiting = 0;
    /** Called whenever the picture was drawn anew. */
    this.painted = () => {};
    canvas.tabIndex = 0;
    canvas.setAttribute('role', 'application');
    canvas.setAttribute('aria-label', `${what} in space. Arrow keys turn it, plus and minus zoom, 0 resets.`);
    this.slider = make('input', { type: 'range', className: 'split', min: 0, max: 100, step: 1, value: 50 });
    this.slider.setAttribute('aria-label', 'How much is shown as before');
    this.spot = make('div', { className: 'spot', hidden: true });
    this.spotBefore = make('div', { className: 'spot-before', hidden: true });
    this.tags = ['before', 'after'].map((side, i) =>
      make('span', { className: `tag ${side}`, textContent: tags[i] }),
    );
    const line = make('div', { className: 'split-line' });
    /** To be put into the page. */
    this.root = make(
      'div',
      { className: 'view' },
      canvas,
      line,
      ...this.tags,
      this.spotBefore,
      this.spot,
      this.slider,
    );
    this.scene = new PatchScene(canvas, context, patch);
    this.root.dataset.arrangement = this.scene.isSingle ? 'single' : 'split';
    this.turning = new Turning(
      canvas,
      this.scene,
      () => this.moved(),
      (event) => listener.clicked(this.vertexAt(event), event),
    );
    this.listening = new AbortController();
    this.listen(listener);
    this.sizes = new ResizeObserver(() => this.fit());
    this.sizes.observe(this.root);
  }

  /** @param {VertexListener} listener */
  listen({ hovered }) {
    const { signal } = this.listening;
    const { canvas, slider } = this;
    canvas.addEventListener(
      'pointermove',
      (event) => {
        if (!this.turning.isDragging) hovered(this.vertexAt(event));
      },
      { signal },
    );
    canvas.addEventListener('pointerleave', () => hovered(-1), { signal });
    slider.addEventListener('input', () => this.redraw(), { signal });
  }

  /** The states before and after. */
  get shown() {
    return this.scene.shown;
  }

  /**
   * Shows another state as the one after.
   * @param {number} state
   * @param {string} name plain text
   */
  show(state, name) {
    this.scene.shown = [0, state];
    this.tags[1].textContent = name;
    this.moved();
  }

  /** @param {Arrangement} arrangement of two states */
  arrange(arrangement) {
    this.scene.arrangement = arrangement;
    this.root.dataset.arrangement = arrangement;
    this.moved();
  }

  /** @param {number} apart how far pieces are from their places, as parts of their ways; 0: in their places */
  moveApart(apart) {
    this.scene.moveApart(apart);
    this.moved();
  }

  /** @param {number} piece all others fade; -1: none does */
  choose(piece) {
    this.scene.choose(piece);
    this.redraw();
  }

  /**
   * @param {Color[]} colors of the lines along pieces
   * @param {Color} ground of their numbers
   */
  paintLines(colors, ground) {
    this.scene.lines?.paint(colors, ground);
    this.redraw();
  }

  /**
   * Shows the whole from somewhere else, also when it is reset.
   * @param {Viewpoint} view
   */
  lookFrom(view) {
    this.scene.lookFrom(view);
    this.reset();
    this.fit();
  }

  /** No colours of figures: the form alone, as light shows it; pieces in their own. */
  plain() {
    this.scene.plain();
    this.redraw();
  }

  /** @param {boolean} shown whether stripes are mirrored in the surface */
  zebra(shown) {
    this.scene.zebra(shown);
    this.redraw();
  }

  /**
   * Moves the vertices of a state; the camera stays until it is reset.
   * @param {Float32Array} positions x, y, z of all vertices, model units; copied
   * @param {number} [state] by default the one right of the split
   * @throws {RangeError} if it is of another number of vertices
   */
  update(positions, state) {
    this.scene.update(positions, state);
    this.moved();
  }

  /**
   * Shows another patch of as many states; what is in the middle of the picture stays there. Colours are to be given
   * anew.
   * @param {Patch} patch its `view`, `shown` and `maps` are not looked at
   */
  replace(patch) {
    this.triangles = patch.triangles;
    this.marked = -1;
    this.scene.replace(patch);
    this.moved();
  }

  /** @param {Coloring} coloring */
  color(coloring) {
    this.scene.color(coloring);
    this.redraw();
  }

  /** @param {number} limit |value| at which colours end, above 0 */
  scale(limit) {
    this.scene.scale(limit);
    this.redraw();
  }

  /** Shows the whole patch from where it was seen at first. */
  reset() {
    this.turning.reset();
  }

  /**
   * Marks a vertex on both pictures; with a split on the side on which it is seen, and where that is
   * both, right of it.
   * @param {number} vertex -1 for none
   */
  mark(vertex) {
    this.marked = vertex;
    this.placeSpot();
  }

  /**
   * The vertex that is meant by a place in the view, or -1.
   * @param {MouseEvent} event
   */
  vertexAt(event) {
    const box = this.canvas.getBoundingClientRect();
    const x = event.clientX - box.left;
    const y = event.clientY - box.top;
    return pick(this.places(this.scene.paneAt(x, y).side), this.triangles, x, y);
  }

  /**
   * What is seen at a place of the canvas.
   * @param {number} x pixels from the left
   * @param {number} y pixels from the top
   * @returns {{point: number[], depth: number} | null} on the surface, model units; more depth is nearer
   */
  placeAt(x, y) {
    const { side, state } = this.scene.paneAt(x, y);
    const hit = hitAt(this.places(side), this.triangles, x, y);
    if (!hit) return null;
    const positions = this.scene.positions(state);
    const corners = [0, 1, 2].map((k) => 3 * this.triangles[hit.triangle + k]);
    const point = [0, 1, 2].map((axis) =>
      corners.reduce((sum, corner, k) => sum + hit.shares[k] * positions[corner + axis], 0),
    );
    return { point, depth: hit.depth };
  }

  /**
   * Where the vertices of one side are.
   * @param {number} side 0 before, 1 after
   */
  places(side) {
    const panes = this.scene.panes();
    const pane = panes.find((one) => one.side === side) ?? panes[0];
    const places = this.kept.get(side) ?? this.scene.projected(pane);
    this.kept.set(side, places);
    return places;
  }

  placeSpot() {
    const [before, after] = [0, 1].map((side) => this.spotIn(side));
    const isBeside = this.scene.arrangement === 'beside';
    for (const [spot, at] of /** @type {const} */ ([
      [this.spot, isBeside ? after : (after ?? before)],
      [this.spotBefore, isBeside ? before : null],
    ])) {
      spot.hidden = !at;
      if (at) spot.style.transform = `translate(${at[0]}px, ${at[1]}px)`;
    }
  }

  /**
   * Where the marked vertex is on a side; null where it is not seen.
   * @param {number} side 0 before, 1 after
   */
  spotIn(side) {
    const pane = this.scene.panes().find((one) => one.side === side);
    if (!pane || this.marked < 0) return null;
    const { clip } = pane;
    const places = this.places(side);
    const [x, y] = [places[3 * this.marked], places[3 * this.marked + 1]];
    const isSeen = x >= clip.left && x < clip.left + clip.width && y >= clip.top && y < clip.top + clip.height;
    return isSeen ? [x, y] : null;
  }

  /** Draws in the size that the view has in the page; nothing where it has none yet. */
  fit() {
    if (this.heights && this.root.clientWidth > 0) {
      const { least, most } = this.heights;
      const { isStacked, height } = this.scene.suited(this.root.clientWidth, least, most);
      this.scene.isStacked = isStacked;
      this.root.classList.toggle('stacked', isStacked);
      this.root.style.height = `${height}px`;
    }
    const { clientWidth, clientHeight } = this.root;
    if (clientWidth === 0 || clientHeight === 0) return;
    this.scene.resize(clientWidth, clientHeight, Math.min(2, window.devicePixelRatio));
    this.kept.clear();
    this.paint();
  }

  /** Camera or vertices did. */
  moved() {
    this.kept.clear();
    this.redraw();
  }

  redraw() {
    this.waiting ||= requestAnimationFrame(() => {
      this.waiting = 0;
      this.paint();
    });
  }

  paint() {
    if (!this.scene.width) return;
    const { root, slider } = this;
    const share = Number(slider.value) / 100;
    this.scene.split = share;
    root.style.setProperty('--split', `${slider.value}%`);
    root.classList.toggle('only-after', share < 0.14);
    root.classList.toggle('only-before', share > 0.86);
    slider.setAttribute('aria-valuetext', `${slider.value} % before`);
    this.scene.draw();
    this.placeSpot();
    this.painted();
    root.dataset.ready ??= String(Math.round(performance.now()));
  }

  /** Takes the view from the page and frees all that it holds; it cannot be used again. */
  dispose() {
    cancelAnimationFrame(this.waiting);
    this.sizes.disconnect();
    this.listening.abort();
    this.turning.dispose();
    this.scene.dispose();
    this.kept.clear();
    this.root.remove();
  }
}
