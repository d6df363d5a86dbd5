// A drawing of the pattern in which a vertex can be pointed at and marked.
import { makeSvg } from './dom.js';
import { PointGrid } from './picking.js';

/** @typedef {import('./patch_view.js').VertexListener} VertexListener */

const markSize = 7; // pixels
const reach = 24; // pixels: what is further away from any vertex is not meant

export class PatternView {
  /**
   * @param {SVGSVGElement} svg the drawing; a mark is added to it
   * @param {Float32Array} positions x, y of all vertices in the coordinates of the drawing
   * @param {VertexListener} listener
   */
  constructor(svg, positions, listener) {
    this.svg = svg;
    this.grid = new PointGrid(positions);
    this.marked = -1;
    this.circles = [makeSvg('circle', { class: 'halo' }), makeSvg('circle', { class: 'ring' })];
    this.root = makeSvg('g', { class: 'mark', visibility: 'hidden' }, ...this.circles);
    svg.append(this.root);
    this.listening = new AbortController();
    const { signal } = this.listening;
    svg.addEventListener('pointermove', (event) => listener.hovered(this.vertexAt(event)), { signal });
    svg.addEventListener('pointerleave', () => listener.hovered(-1), { signal });
    svg.addEventListener('click', (event) => listener.clicked(this.vertexAt(event), event), { signal });
  }

  /**
   * Says where the vertices are in the drawing now. What is drawn is not the view's: it stays.
   * @param {Float32Array} positions x, y of all vertices in the coordinates of the drawing
   * @throws {RangeError} if it is of another number of vertices
   */
  update(positions) {
    const { length } = this.grid.points;
    if (positions.length !== length) {
      throw new RangeError(`positions of ${positions.length / 2} vertices, not of ${length / 2}`);
    }
    this.grid = new PointGrid(positions);
    this.mark(this.marked);
  }

  /**
   * The vertex that is meant by a place in the drawing, or -1.
   * @param {MouseEvent} event
   */
  vertexAt(event) {
    const matrix = this.svg.getScreenCTM();
    if (!matrix) return -1;
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return this.grid.nearest(x, y, Math.max(reach / matrix.a, this.grid.size));
  }

  /** @param {number} vertex -1 for none */
  mark(vertex) {
    this.marked = vertex;
    const matrix = vertex < 0 ? null : this.svg.getScreenCTM();
    this.root.setAttribute('visibility', matrix ? 'visible' : 'hidden');
    if (!matrix) return;
    for (const circle of this.circles) {
      circle.setAttribute('cx', String(this.grid.points[2 * vertex]));
      circle.setAttribute('cy', String(this.grid.points[2 * vertex + 1]));
      circle.setAttribute('r', String(markSize / matrix.a));
    }
  }

  /** Leaves the drawing as it was. */
  dispose() {
    this.listening.abort();
    this.root.remove();
  }
}
