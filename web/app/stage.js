// The model in space, on which lines are drawn.
import { make } from '../viewer/dom.js';
import { DrawnLines } from '../viewer/drawn_lines.js';
import { PatchView } from '../viewer/patch_view.js';
import { borderOf } from '../viewer/patch_geometry.js';
import { boxOf } from './mesh.js';

/** @typedef {import('./project.js').Point} Point */
/** @typedef {import('./engine.js').Surface} Surface */
/** @typedef {import('../viewer/color_scale.js').Color} Color */

/**
 * A line as it is shown.
 * @typedef {object} ShownLine
 * @property {ArrayLike<number>} path x, y, z of its points on the surface
 * @property {Point[]} points that it is drawn through
 * @property {boolean} canMove
 */

/**
 * What a stage calls.
 * @typedef {object} StageListener
 * @property {(vertex: number) => void} hovered
 * @property {(place: Point | null, line: number) => void} clicked where on the surface, and which line there, or -1
 * @property {(index: number, place: Point, isDone: boolean) => void} moved a point of the chosen line goes there
 * @property {(index: number) => void} removed a point of the chosen line
 * @property {(index: number) => void} unnotched a notch is to go
 */

const reach = 12; // pixels within which a place snaps
const hidden = 0.004; // how much deeper than the surface a place is that cannot be seen

/** @type {Record<string, Color>} */
const inks = { line: [24, 24, 28], chosen: [192, 80, 0], image: [120, 120, 132], border: [60, 60, 66] };

/**
 * From where a model is seen at first: from the front, a little from above and the right, with its longest upright
 * axis up.
 * @param {Float32Array} positions
 */
function firstView(positions) {
  const { low, high } = boxOf(positions);
  const size = high.map((x, k) => x - low[k]);
  // Flat along z: seen from above.
  if (size[2] < 0.35 * Math.min(size[0], size[1])) {
    return { right: [1, 0, 0], up: [0, 0.88, 0.475], towards: [0, -0.475, 0.88] };
  }
  return { right: [0.866, 0, -0.5], up: [-0.17, 0.94, -0.295], towards: [0.47, 0.34, 0.814] };
}

export class Stage {
  /**
   * @param {{canvas: HTMLCanvasElement, context: WebGL2RenderingContext}} space
   * @param {Surface} surface
   * @param {Map<string, Uint8Array>} maps
   * @param {StageListener} listener
   */
  constructor(space, surface, maps, listener) {
    this.surface = surface;
    this.listener = listener;
    /** @type {import('../viewer/patch_scene.js').Patch} */
    this.plainPatch = {
      positions: [surface.positions],
      triangles: surface.triangles,
      view: firstView(surface.positions),
      shown: 0,
      maps,
    };
    this.view = new PatchView(
      space,
      this.plainPatch,
      {
        hovered: (vertex) => listener.hovered(vertex),
        clicked: (_, event) => this.click(event),
      },
      { what: 'Model' },
    );
    this.view.scene.drawn = new DrawnLines();
    this.view.painted = () => this.placeHandles();
    this.border = borderOf(surface.triangles);
    /** @type {ShownLine[]} */
    this.lines = [];
    /** The line whose points can be moved, or -1. */
    this.chosen = -1;
    this.handles = make('div', { className: 'handles' });
    this.notches = make('div', { className: 'handles' });
    /** @type {Point[]} */
    this.notchPlaces = [];
    this.crosshair = make('div', { className: 'crosshair', hidden: true });
    this.view.root.append(this.handles, this.notches, this.crosshair);
  }

  /** @param {boolean} isOn whether clicks add points */
  draws(isOn) {
    this.crosshair.hidden = !isOn;
    this.view.root.classList.toggle('drawing', isOn);
  }

  /**
   * @param {ShownLine[]} lines
   * @param {number} chosen
   * @param {ArrayLike<number>[]} images of lines on the other side of the plane of symmetry
   */
  showLines(lines, chosen, images) {
    this.lines = lines;
    this.chosen = chosen;
    const border = [];
    for (let i = 0; i < this.border.length; i += 2) {
      const ends = [this.border[i], this.border[i + 1]];
      border.push({
        points: ends.flatMap((v) => Array.from(this.surface.positions.subarray(3 * v, 3 * v + 3))),
        color: inks.border,
      });
    }
    const drawn = lines.map(({ path }, i) => ({ points: path, color: i === chosen ? inks.chosen : inks.line }));
    const mirrored = images.map((path) => ({ points: path, color: inks.image }));
    this.view.scene.drawn?.show([...border, ...mirrored, ...drawn]);
    this.makeHandles();
    this.view.redraw();
  }

  makeHandles() {
    const line = this.lines[this.chosen];
    const count = line?.canMove ? line.points.length : 0;
    const isClosed = count > 2 && String(line.points[0]) === String(line.points[count - 1]);
    const wanted = isClosed ? count - 1 : count;
    while (this.handles.childElementCount > wanted) this.handles.lastElementChild?.remove();
    while (this.handles.childElementCount < wanted) this.handles.append(this.handle(this.handles.childElementCount));
    this.placeHandles();
  }

  /** @param {number} index */
  handle(index) {
    const made = make('button', { type: 'button', className: 'handle' });
    made.setAttribute('aria-label', `Point ${index + 1} of the line. Arrow keys move it, Delete takes it away.`);
    let [right, down] = [0, 0];
    made.addEventListener('pointerdown', (event) => {
      event.stopPropagation();
      made.setPointerCapture(event.pointerId);
      const box = made.getBoundingClientRect();
      [right, down] = [event.clientX - box.left - box.width / 2, event.clientY - box.top - box.height / 2];
    });
    const drag = (/** @type {PointerEvent} */ event, /** @type {boolean} */ isDone) => {
      if (!made.hasPointerCapture(event.pointerId)) return;
      const place = this.placeNear(event.clientX - right, event.clientY - down, index);
      if (place) this.listener.moved(index, place, isDone);
      else if (isDone) this.listener.moved(index, this.lines[this.chosen].points[index], true);
    };
    made.addEventListener('pointermove', (event) => drag(event, false));
    made.addEventListener('pointerup', (event) => drag(event, true));
    made.addEventListener('keydown', (event) => this.handleKey(event, index, made));
    return made;
  }

  /**
   * @param {KeyboardEvent} event
   * @param {number} index
   * @param {HTMLElement} handle
   */
  handleKey(event, index, handle) {
    if (event.key === 'Delete' || event.key === 'Backspace') {
      event.preventDefault();
      this.listener.removed(index);
      return;
    }
    /** @type {Record<string, [number, number]>} */
    const ways = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] };
    const way = ways[event.key];
    if (!way) return;
    event.preventDefault();
    event.stopPropagation();
    const step = event.shiftKey ? 1 : 6;
    const box = handle.getBoundingClientRect();
    const x = box.left + box.width / 2 + step * way[0];
    const y = box.top + box.height / 2 + step * way[1];
    const place = this.placeNear(x, y, index, event.shiftKey ? 0 : reach / 3);
    if (place) this.listener.moved(index, place, true);
  }

  /** @param {Point[]} places */
  showNotches(places) {
    this.notchPlaces = places;
    while (this.notches.childElementCount > places.length) this.notches.lastElementChild?.remove();
    while (this.notches.childElementCount < places.length) this.notches.append(this.notch(this.notches.childElementCount));
    this.placeHandles();
  }

  /** @param {number} index */
  notch(index) {
    const textContent = `Notch ${index + 1}: a click takes it away`;
    const made = make('button', { type: 'button', className: 'notch', title: textContent, ariaLabel: textContent });
    made.addEventListener('click', () => this.listener.unnotched(index));
    return made;
  }

  placeHandles() {
    this.placeAll(this.handles, this.lines[this.chosen]?.points ?? []);
    this.placeAll(this.notches, this.notchPlaces);
  }

  /**
   * @param {HTMLElement} parent
   * @param {Point[]} points of its children
   */
  placeAll(parent, points) {
    const places = this.project(points.flat());
    [...parent.children].forEach((child, i) => {
      const handle = /** @type {HTMLElement} */ (child);
      const [x, y, depth] = places.subarray(3 * i, 3 * i + 3);
      const seen = this.view.placeAt(x, y);
      handle.hidden = seen !== null && depth < seen.depth - hidden;
      handle.style.transform = `translate(${x}px, ${y}px)`;
    });
  }

  /**
   * Where points are in the canvas, and how deep.
   * @param {ArrayLike<number>} points x, y, z of each
   */
  project(points) {
    return this.view.scene.project(Float32Array.from(points), this.view.scene.panes()[0]);
  }

  /** @param {MouseEvent} event */
  click(event) {
    this.listener.clicked(this.placeNear(event.clientX, event.clientY, -1), this.lineNear(event));
  }

  /** The place of the surface in the middle of the view, under the crosshair. */
  middle() {
    const box = this.view.canvas.getBoundingClientRect();
    return this.placeNear(box.left + box.width / 2, box.top + box.height / 2, -1);
  }

  /**
   * The line nearest to a place of the page, if it can be seen there, or -1.
   * @param {MouseEvent} event
   */
  lineNear({ clientX, clientY }) {
    const box = this.view.canvas.getBoundingClientRect();
    const [x, y] = [clientX - box.left, clientY - box.top];
    const floor = (this.view.placeAt(x, y)?.depth ?? -Infinity) - 4 * hidden;
    let [best, least] = [-1, reach];
    this.lines.forEach(({ path }, line) => {
      const near = nearestOn(this.project(path), chain(path.length / 3), x, y, floor);
      if (near && near.distance < least) [best, least] = [line, near.distance];
    });
    return best;
  }

  /**
   * The place of the surface that is meant by one of the page: what is there, or the end of a line, a line or the
   * border near it.
   * @param {number} clientX
   * @param {number} clientY
   * @param {number} index of the point of the chosen line that is to go there; -1 for none
   * @param {number} within pixels
   * @returns {Point | null}
   */
  placeNear(clientX, clientY, index, within = reach) {
    const box = this.view.canvas.getBoundingClientRect();
    const [x, y] = [clientX - box.left, clientY - box.top];
    const seen = this.view.placeAt(x, y);
    const floor = (seen?.depth ?? -Infinity) - 2 * hidden;
    const ends = this.lines.flatMap(({ points }, line) =>
      [0, points.length - 1].filter((i) => line !== this.chosen || i !== index).map((i) => points[i]),
    );
    const others = this.lines.filter((_, line) => line !== this.chosen || index < 0).map(({ path }) => path);
    const found =
      this.snapped(ends.flat(), alone(ends.length), x, y, floor, within) ??
      this.snapped(this.surface.positions, this.border, x, y, floor, within) ??
      others
        .map((path) => this.snapped(path, chain(path.length / 3), x, y, floor, within))
        .find((place) => place !== null) ??
      seen?.point;
    return found ? /** @type {Point} */ (found.map((value) => Number(value.toPrecision(8)))) : null;
  }

  /**
   * @param {ArrayLike<number>} positions
   * @param {ArrayLike<number>} pairs
   * @param {number} x
   * @param {number} y
   * @param {number} floor
   * @param {number} within
   * @returns {number[] | null}
   */
  snapped(positions, pairs, x, y, floor, within) {
    if (pairs.length === 0 || within <= 0) return null;
    const near = nearestOn(this.project(positions), pairs, x, y, floor);
    if (!near || near.distance > within) return null;
    const [a, b] = [3 * pairs[near.pair], 3 * pairs[near.pair + 1]];
    return [0, 1, 2].map((k) => positions[a + k] + near.share * (positions[b + k] - positions[a + k]));
  }

  dispose() {
    this.view.dispose();
  }
}

/**
 * Pairs of the points that follow each other.
 * @param {number} count
 */
function chain(count) {
  const pairs = [];
  for (let i = 1; i < count; ++i) pairs.push(i - 1, i);
  return pairs;
}

/**
 * Pairs of each point with itself.
 * @param {number} count
 */
function alone(count) {
  return Array.from({ length: 2 * count }, (_, i) => i >> 1);
}

/**
 * The place nearest to another in a picture, on straight parts that are seen.
 * @param {Float32Array} places x, y, depth of points
 * @param {ArrayLike<number>} pairs two points of each part
 * @param {number} x
 * @param {number} y
 * @param {number} floor depth below which nothing is seen
 */
function nearestOn(places, pairs, x, y, floor) {
  /** @type {{pair: number, share: number, distance: number} | null} */
  let best = null;
  for (let i = 0; i < pairs.length; i += 2) {
    const [a, b] = [3 * pairs[i], 3 * pairs[i + 1]];
    const [right, down] = [places[b] - places[a], places[b + 1] - places[a + 1]];
    const square = right * right + down * down;
    const along = square > 0 ? ((x - places[a]) * right + (y - places[a + 1]) * down) / square : 0;
    const share = Math.min(1, Math.max(0, along));
    if (places[a + 2] + share * (places[b + 2] - places[a + 2]) < floor) continue;
    const distance = Math.hypot(places[a] + share * right - x, places[a + 1] + share * down - y);
    if (!best || distance < best.distance) best = { pair: i, share, distance };
  }
  return best;
}
