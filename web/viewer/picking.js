// Which vertex is meant by a place in a picture.

/**
 * The foremost triangle at a place in the picture.
 * @typedef {object} Hit
 * @property {number} triangle where its three vertices begin
 * @property {number[]} shares barycentric, of the place on it
 * @property {number} depth more is nearer
 */

/**
 * What is seen at a place, or null.
 * @param {Float32Array} places x, y, depth (more is nearer) of every vertex
 * @param {ArrayLike<number>} triangles three vertices each
 * @param {number} x in the unit of the places
 * @param {number} y
 * @returns {Hit | null}
 */
export function hitAt(places, triangles, x, y) {
  /** @type {Hit | null} */
  let hit = null;
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    const u = cross(places, b, c, x, y);
    const v = cross(places, c, a, x, y);
    const w = cross(places, a, b, x, y);
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) continue;
    const area = u + v + w;
    if (area === 0) continue;
    const depth = (u * places[a + 2] + v * places[b + 2] + w * places[c + 2]) / area;
    if (!hit || depth > hit.depth) hit = { triangle: t, shares: [u / area, v / area, w / area], depth };
  }
  return hit;
}

/**
 * The corner nearest to a place of the foremost triangle there, or -1.
 * @param {Float32Array} places x, y, depth (more is nearer) of every vertex
 * @param {ArrayLike<number>} triangles three vertices each
 * @param {number} x in the unit of the places
 * @param {number} y
 */
export function pick(places, triangles, x, y) {
  const hit = hitAt(places, triangles, x, y);
  if (!hit) return -1;
  const corners = [0, 1, 2].map((k) => 3 * triangles[hit.triangle + k]);
  return corners.reduce((p, q) => (apart(places, q, x, y) < apart(places, p, x, y) ? q : p)) / 3;
}

/**
 * Twice the area of the triangle of two vertices and a place, with its sign.
 * @param {Float32Array} places
 * @param {number} p where the places of a vertex begin
 * @param {number} q
 * @param {number} x
 * @param {number} y
 */
function cross(places, p, q, x, y) {
  return (places[p] - x) * (places[q + 1] - y) - (places[q] - x) * (places[p + 1] - y);
}

/**
 * The square of the distance.
 * @param {Float32Array} places
 * @param {number} p where the places of a vertex begin
 * @param {number} x
 * @param {number} y
 */
function apart(places, p, x, y) {
  return (places[p] - x) ** 2 + (places[p + 1] - y) ** 2;
}

/** Points in the plane by the cells of a grid, so that the nearest is found at once. */
export class PointGrid {
  /** @param {Float32Array} points x, y of each; they must not change any more */
  constructor(points) {
    this.points = points;
    const { left, right, top, bottom } = boxOf(points);
    const count = points.length / 2;
    this.left = left;
    this.top = top;
    /** Width and height of a cell. */
    this.size = Math.sqrt(((right - left) * (bottom - top)) / Math.max(1, count)) * 1.5 || 1;
    /** @type {Map<number, number[]>} */
    this.cells = new Map();
    for (let i = 0; i < count; ++i) {
      const key = this.key(this.column(points[2 * i]), this.row(points[2 * i + 1]));
      const cell = this.cells.get(key);
      if (cell) cell.push(i);
      else this.cells.set(key, [i]);
    }
  }

  /** @param {number} x */
  column(x) {
    return Math.floor((x - this.left) / this.size);
  }

  /** @param {number} y */
  row(y) {
    return Math.floor((y - this.top) / this.size);
  }

  /**
   * @param {number} column
   * @param {number} row
   */
  key(column, row) {
    return row * 65536 + column;
  }

  /**
   * The point nearest to a place and within a distance of it, or -1.
   * @param {number} x
   * @param {number} y
   * @param {number} distance
   */
  nearest(x, y, distance) {
    let best = -1;
    let least = distance;
    const [column, row] = [this.column(x), this.row(y)];
    const rings = Math.min(64, Math.ceil(distance / this.size));
    for (let ring = 0; ring <= rings && (ring - 1) * this.size <= least; ++ring) {
      for (let j = -ring; j <= ring; ++j) {
        const step = Math.abs(j) === ring || ring === 0 ? 1 : 2 * ring;
        for (let i = -ring; i <= ring; i += step) {
          for (const point of this.cells.get(this.key(column + i, row + j)) ?? []) {
            const far = Math.hypot(this.points[2 * point] - x, this.points[2 * point + 1] - y);
            if (far > least) continue;
            least = far;
            best = point;
          }
        }
      }
    }
    return best;
  }
}

/** @param {Float32Array} points */
function boxOf(points) {
  let [left, right, top, bottom] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < points.length; i += 2) {
    left = Math.min(left, points[i]);
    right = Math.max(right, points[i]);
    top = Math.min(top, points[i + 1]);
    bottom = Math.max(bottom, points[i + 1]);
  }
  return { left, right, top, bottom };
}
