// The pattern, piece beside piece, in the colours of its stretch.
import { make } from '../viewer/dom.js';
import { borderOf } from '../viewer/patch_geometry.js';
import { PointGrid } from '../viewer/picking.js';
import { boxOf, flatDirection, rowsOf } from './mesh.js';
import { fillTriangles } from './raster.js';

/** @typedef {import('./engine.js').LaidPiece} LaidPiece */
/** @typedef {import('../viewer/color_scale.js').Color} Color */

const reach = 24; // pixels: what is further away from any vertex is not meant

/**
 * How pieces are coloured: by stretch, or each in a colour of its own.
 * @typedef {object} SheetColors
 * @property {'stretch' | 'pieces'} by
 * @property {Uint8Array} map
 * @property {number} limit |strain| at which colours end
 * @property {Color[]} pieces
 */

/**
 * A piece with its place in the sheet.
 * @typedef {object} PlacedPiece
 * @property {LaidPiece} piece
 * @property {number} x what is added to its coordinates, model units
 * @property {number} y
 * @property {number[]} border pairs of vertices
 */

export class Sheet {
  /**
   * @param {(vertex: number) => void} hovered the vertex of all pieces, one after the other, or -1
   */
  constructor(hovered) {
    this.canvas = make('canvas', { className: 'sheet', role: 'img', ariaLabel: 'Pattern' });
    /** @type {PlacedPiece[]} */
    this.placed = [];
    this.size = { width: 1, height: 1 };
    /** @type {SheetColors | null} */
    this.colors = null;
    this.marked = -1;
    /** Places of notches on the model. @type {[number, number, number][]} */
    this.notches = [];
    /** Direction of the grain on the model. @type {number[] | null} */
    this.grain = null;
    /** The surfaces of the pieces, until they change. @type {ImageData | null} */
    this.picture = null;
    /** @type {PointGrid | null} */
    this.grid = null;
    this.waiting = 0;
    this.canvas.addEventListener('pointermove', (event) => hovered(this.vertexAt(event)));
    this.canvas.addEventListener('pointerleave', () => hovered(-1));
    new ResizeObserver(() => this.redraw()).observe(this.canvas);
  }

  /** @param {LaidPiece[]} pieces */
  show(pieces) {
    const boxes = pieces.map(({ flat }) => boxOf(flat));
    const sizes = boxes.map(({ low, high }) => ({ width: high[0] - low[0], height: high[1] - low[1] }));
    const largest = sizes.reduce((most, { width, height }) => Math.max(most, width, height), 0);
    const { places, width, height } = rowsOf(sizes, 0.06 * largest);
    this.size = { width: width || 1, height: height || 1 };
    this.placed = pieces.map((piece, k) => ({
      piece,
      x: places[k].x - boxes[k].low[0],
      y: places[k].y - boxes[k].low[1],
      border: borderOf(piece.triangles),
    }));
    const points = this.placed.flatMap(({ piece: { flat }, x, y }) =>
      Array.from({ length: (2 * flat.length) / 3 }, (_, i) => flat[3 * (i >> 1) + (i % 2)] + [x, y][i % 2]),
    );
    this.grid = points.length > 0 ? new PointGrid(Float32Array.from(points)) : null;
    this.marked = -1;
    this.picture = null;
    const names = pieces.map(({ name }) => name).join(', ');
    this.canvas.setAttribute('aria-label', pieces.length > 0 ? `Pattern of ${names}` : 'Pattern');
    this.redraw();
  }

  /** @param {[number, number, number][]} places on the model */
  showNotches(places) {
    this.notches = places;
    this.redraw();
  }

  /** @param {number[] | null} way of the grain on the model */
  showGrain(way) {
    this.grain = way;
    this.redraw();
  }

  /** @param {SheetColors} colors */
  color(colors) {
    this.colors = colors;
    this.picture = null;
    this.redraw();
  }

  /** @param {number} vertex -1 for none */
  mark(vertex) {
    if (vertex === this.marked) return;
    this.marked = vertex;
    this.redraw();
  }

  redraw() {
    this.waiting ||= requestAnimationFrame(() => {
      this.waiting = 0;
      this.paint();
    });
  }

  /** Pixels of the page to a unit of the model, and where the sheet begins. */
  frame() {
    const { clientWidth, clientHeight } = this.canvas;
    const margin = 18;
    const scale = Math.min(
      (clientWidth - 2 * margin) / this.size.width,
      (clientHeight - 2 * margin) / this.size.height,
    );
    return {
      scale,
      left: 0.5 * (clientWidth - scale * this.size.width),
      top: 0.5 * (clientHeight - scale * this.size.height),
    };
  }

  /** @param {MouseEvent} event */
  vertexAt(event) {
    const { scale, left, top } = this.frame();
    if (!this.grid || !(scale > 0)) return -1;
    const y = this.size.height - (event.offsetY - top) / scale;
    return this.grid.nearest((event.offsetX - left) / scale, y, reach / scale);
  }

  paint() {
    const { clientWidth, clientHeight } = this.canvas;
    const pen = this.canvas.getContext('2d');
    if (!pen || clientWidth === 0) return;
    const ratio = Math.min(2, window.devicePixelRatio);
    const [width, height] = [Math.round(clientWidth * ratio), Math.round(clientHeight * ratio)];
    if (this.canvas.width !== width || this.canvas.height !== height) {
      Object.assign(this.canvas, { width, height });
      this.picture = null;
    }
    const { scale, left, top } = this.frame();
    if (!(scale > 0)) return;
    this.picture ??= this.filled(pen, ratio);
    pen.putImageData(this.picture, 0, 0);
    pen.setTransform(ratio, 0, 0, ratio, 0, 0);
    for (const placed of this.placed) this.outline(pen, placed, scale, left, top);
    this.spot(pen, scale, left, top);
  }

  /**
   * The surfaces of all pieces.
   * @param {CanvasRenderingContext2D} pen
   * @param {number} ratio pixels of the screen to one of the page
   */
  filled(pen, ratio) {
    const image = pen.createImageData(this.canvas.width, this.canvas.height);
    const { scale, left, top } = this.frame();
    const { colors } = this;
    if (!colors) return image;
    const { by, map, limit, pieces } = colors;
    this.placed.forEach(({ piece: { flat, triangles, strain }, x, y }, k) => {
      const points = new Float32Array((2 * flat.length) / 3);
      for (let v = 0; 3 * v < flat.length; ++v) {
        points[2 * v] = ratio * (left + scale * (flat[3 * v] + x));
        points[2 * v + 1] = ratio * (top + scale * (this.size.height - flat[3 * v + 1] - y));
      }
      const steps = map.length / 3 - 1;
      fillTriangles(image, points, triangles, (t) => {
        if (by === 'pieces') return pieces[k];
        const share = Math.min(1, Math.max(-1, strain[t] / limit));
        const place = 3 * Math.round((0.5 + 0.5 * share) * steps);
        return map.subarray(place, place + 3);
      });
    });
    return image;
  }

  /**
   * @param {CanvasRenderingContext2D} pen
   * @param {PlacedPiece} placed
   * @param {number} scale
   * @param {number} leftmost
   * @param {number} top
   */
  outline(pen, { piece, border, x, y }, scale, leftmost, top) {
    const { flat } = piece;
    /** @type {(v: number) => [number, number]} */
    const at = (v) => [
      leftmost + scale * (flat[3 * v] + x),
      top + scale * (this.size.height - flat[3 * v + 1] - y),
    ];
    pen.strokeStyle = '#1e1f21';
    pen.lineWidth = 1.4;
    pen.lineCap = 'round';
    pen.beginPath();
    let [right, down] = [0, 0];
    for (let i = 0; i < border.length; i += 2) {
      const from = at(border[i]);
      pen.moveTo(...from);
      pen.lineTo(...at(border[i + 1]));
      right += (2 * from[0]) / border.length;
      down += (2 * from[1]) / border.length;
    }
    pen.stroke();
    pen.fillStyle = '#c05000';
    for (const vertex of borderNear(this.notches, piece, border)) {
      pen.beginPath();
      pen.arc(...at(vertex), 4, 0, 2 * Math.PI);
      pen.fill();
    }
    const box = boxOf(flat);
    const size = scale * Math.min(box.high[0] - box.low[0], box.high[1] - box.low[1]);
    if (this.grain) arrow(pen, right, down, flatDirection(piece, this.grain), 0.3 * size);
    pen.font = '600 14px system-ui, sans-serif';
    pen.textAlign = 'center';
    pen.lineWidth = 4;
    pen.lineJoin = 'round';
    pen.strokeStyle = '#ffffff';
    pen.strokeText(piece.name, right, down);
    pen.fillStyle = '#1e1f21';
    pen.fillText(piece.name, right, down);
  }

  /**
   * @param {CanvasRenderingContext2D} pen
   * @param {number} scale
   * @param {number} left
   * @param {number} top
   */
  spot(pen, scale, left, top) {
    if (this.marked < 0 || !this.grid) return;
    const [x, y] = this.grid.points.subarray(2 * this.marked, 2 * this.marked + 2);
    for (const [color, width] of /** @type {const} */ ([
      ['#111', 5],
      ['#fff', 2],
    ])) {
      pen.strokeStyle = color;
      pen.lineWidth = width;
      pen.beginPath();
      pen.arc(left + scale * x, top + scale * (this.size.height - y), 7, 0, 2 * Math.PI);
      pen.stroke();
    }
  }
}

/**
 * The grain, with a head at either end.
 * @param {CanvasRenderingContext2D} pen
 * @param {number} x its middle
 * @param {number} y
 * @param {number[]} way upwards
 * @param {number} half its length
 */
function arrow(pen, x, y, [right, up], half) {
  const length = Math.hypot(right, up);
  if (!(length > 0)) return;
  const [a, b] = [(half * right) / length, (-half * up) / length];
  pen.strokeStyle = '#0a6b3d';
  pen.lineWidth = 2;
  pen.beginPath();
  pen.moveTo(x - a, y - b);
  pen.lineTo(x + a, y + b);
  for (const end of [-1, 1]) {
    for (const side of [-1, 1]) {
      pen.moveTo(x + end * a, y + end * b);
      pen.lineTo(x + end * (0.85 * a - 0.1 * side * b), y + end * (0.85 * b + 0.1 * side * a));
    }
  }
  pen.stroke();
}

/**
 * The vertices of a border that lie nearest to places of the model, where they lie near.
 * @param {[number, number, number][]} places
 * @param {LaidPiece} piece
 * @param {number[]} border
 */
function borderNear(places, { positions }, border) {
  const { low, high } = places.length > 0 ? boxOf(positions) : { low: [0], high: [0] };
  const reachOf = 0.02 * Math.hypot(...high.map((x, k) => x - low[k]));
  return places.flatMap((place) => {
    let [best, least] = [-1, reachOf];
    for (const v of border) {
      const far = Math.hypot(...place.map((x, k) => x - positions[3 * v + k]));
      if (far < least) [best, least] = [v, far];
    }
    return best < 0 ? [] : [best];
  });
}
