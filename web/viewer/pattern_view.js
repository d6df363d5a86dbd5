// The drawing of the pattern: which vertex is under the pointer, a mark on a vertex, layers.

const markSize = 7; // pixels
const reach = 24; // pixels: what is further away from any vertex is not meant

// Vertices by the cells of a grid, so that the nearest is found at once.
class Grid {
  constructor(points) {
    this.points = points;
    const count = points.length / 2;
    const xs = points.filter((_, i) => i % 2 === 0);
    const ys = points.filter((_, i) => i % 2 === 1);
    const extent = (list) => list.reduce(([l, h], x) => [Math.min(l, x), Math.max(h, x)], [Infinity, -Infinity]);
    const [left, right] = extent(xs);
    const [top, bottom] = extent(ys);
    Object.assign(this, { left, top });
    this.size = Math.sqrt(((right - left) * (bottom - top)) / Math.max(1, count)) * 1.5 || 1;
    this.cells = new Map();
    for (let i = 0; i < count; ++i) {
      const key = this.key(points[2 * i], points[2 * i + 1]);
      const cell = this.cells.get(key);
      if (cell) cell.push(i);
      else this.cells.set(key, [i]);
    }
  }

  column(x) {
    return Math.floor((x - this.left) / this.size);
  }

  row(y) {
    return Math.floor((y - this.top) / this.size);
  }

  key(x, y) {
    return this.row(y) * 65536 + this.column(x);
  }

  // Within the distance, or -1.
  nearest(x, y, distance) {
    let best = -1;
    let least = distance;
    const [column, row] = [this.column(x), this.row(y)];
    const rings = Math.min(64, Math.ceil(distance / this.size));
    for (let ring = 0; ring <= rings && (ring - 1) * this.size <= least; ++ring) {
      for (let j = -ring; j <= ring; ++j) {
        const step = Math.abs(j) === ring || ring === 0 ? 1 : 2 * ring;
        for (let i = -ring; i <= ring; i += step) {
          for (const vertex of this.cells.get((row + j) * 65536 + column + i) ?? []) {
            const apart = Math.hypot(this.points[2 * vertex] - x, this.points[2 * vertex + 1] - y);
            if (apart > least) continue;
            least = apart;
            best = vertex;
          }
        }
      }
    }
    return best;
  }
}

function element(name, attributes) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
}

export class PatternView {
  // hovered(vertex or -1), clicked(vertex)
  constructor(svg, drawn, hovered, clicked) {
    this.svg = svg;
    this.drawn = drawn;
    this.grid = new Grid(drawn);
    this.mark = element('g', { class: 'mark', visibility: 'hidden' });
    this.mark.append(element('circle', { class: 'halo' }), element('circle', { class: 'ring' }));
    svg.append(this.mark);
    svg.addEventListener('pointermove', (event) => hovered(this.vertexAt(event)));
    svg.addEventListener('pointerleave', () => hovered(-1));
    svg.addEventListener('click', (event) => clicked(this.vertexAt(event)));
  }

  vertexAt(event) {
    const matrix = this.svg.getScreenCTM();
    const { x, y } = new DOMPoint(event.clientX, event.clientY).matrixTransform(matrix.inverse());
    return this.grid.nearest(x, y, Math.max(reach / matrix.a, this.grid.size));
  }

  show(vertex) {
    this.mark.setAttribute('visibility', vertex < 0 ? 'hidden' : 'visible');
    if (vertex < 0) return;
    const size = markSize / this.svg.getScreenCTM().a;
    for (const circle of this.mark.children) {
      circle.setAttribute('cx', this.drawn[2 * vertex]);
      circle.setAttribute('cy', this.drawn[2 * vertex + 1]);
      circle.setAttribute('r', size);
    }
  }
}

// A box to tick in front of each line of the key of the drawing.
export function addLayerSwitches(svg, keys) {
  for (const item of keys.querySelectorAll('li[data-layer]')) {
    const layer = svg.querySelector(`#${item.dataset.layer}`);
    const box = document.createElement('input');
    box.type = 'checkbox';
    box.checked = true;
    box.addEventListener('change', () => layer.style.setProperty('display', box.checked ? '' : 'none'));
    const label = document.createElement('label');
    label.append(box, ...item.childNodes);
    item.append(label);
  }
}
