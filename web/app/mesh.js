// Arithmetic on meshes, which needs no browser.

/** @typedef {import('./engine.js').LaidPiece} LaidPiece */

/**
 * The mean strain around each vertex.
 * @param {Uint32Array} triangles
 * @param {Float32Array} strain of each triangle
 * @param {number} count of vertices
 */
export function vertexStrain(triangles, strain, count) {
  const sums = new Float32Array(count);
  const around = new Uint16Array(count);
  triangles.forEach((vertex, i) => {
    sums[vertex] += strain[Math.floor(i / 3)];
    ++around[vertex];
  });
  return sums.map((sum, vertex) => sum / Math.max(1, around[vertex]));
}

/**
 * Least and most of each coordinate.
 * @param {Float32Array} positions x, y, z of each
 */
export function boxOf(positions) {
  const low = [Infinity, Infinity, Infinity];
  const high = [-Infinity, -Infinity, -Infinity];
  positions.forEach((x, i) => {
    low[i % 3] = Math.min(low[i % 3], x);
    high[i % 3] = Math.max(high[i % 3], x);
  });
  return { low, high };
}

/**
 * The strain beyond which colours end: 1, 2 or 5 times a power of ten, near what 95 % of the triangles keep.
 * @param {Float32Array[]} strains of the triangles of each piece
 */
export function colorLimit(strains) {
  const sizes = strains.flatMap((some) => Array.from(some, Math.abs)).sort((a, b) => a - b);
  const most = Math.max(0.001, sizes[Math.floor(0.95 * (sizes.length - 1))] ?? 0);
  const power = 10 ** Math.floor(Math.log10(most) + 1e-9);
  return [1, 2, 5, 10].map((mark) => mark * power).find((mark) => mark >= most * 0.999) ?? 10 * power;
}

/**
 * All pieces as one mesh.
 * @param {LaidPiece[]} pieces
 */
export function joined(pieces) {
  const vertices = pieces.map(({ positions }) => positions.length / 3);
  const count = vertices.reduce((sum, some) => sum + some, 0);
  const positions = new Float32Array(3 * count);
  const flat = new Float32Array(3 * count);
  const strain = new Float32Array(count);
  const of = new Uint16Array(count);
  const starts = [];
  const corners = [];
  let start = 0;
  for (const [k, piece] of pieces.entries()) {
    positions.set(piece.positions, 3 * start);
    flat.set(piece.flat, 3 * start);
    strain.set(vertexStrain(piece.triangles, piece.strain, vertices[k]), start);
    of.fill(k, start, start + vertices[k]);
    for (const vertex of piece.triangles) corners.push(start + vertex);
    starts.push(start);
    start += vertices[k];
  }
  return { positions, flat, strain, of, starts, triangles: Uint32Array.from(corners), ways: waysApart(positions, of) };
}

/**
 * Where pieces go when they are moved apart: away from the middle of all.
 * @param {Float32Array} positions
 * @param {Uint16Array} of the piece of each vertex
 */
function waysApart(positions, of) {
  const pieces = of.reduce((most, piece) => Math.max(most, piece + 1), 0);
  const sums = Array.from({ length: pieces }, () => [0, 0, 0, 0]);
  of.forEach((piece, vertex) => {
    for (let k = 0; k < 3; ++k) sums[piece][k] += positions[3 * vertex + k];
    ++sums[piece][3];
  });
  const middles = sums.map(([x, y, z, count]) => [x, y, z].map((sum) => sum / Math.max(1, count)));
  const middle = [0, 1, 2].map((k) => middles.reduce((sum, one) => sum + one[k], 0) / Math.max(1, pieces));
  return Float32Array.from(middles.flatMap((one) => one.map((x, k) => x - middle[k])));
}

/**
 * Places for pieces side by side in rows, the highest first.
 * @param {{width: number, height: number}[]} sizes
 * @param {number} gap between them
 */
export function rowsOf(sizes, gap) {
  const area = sizes.reduce((sum, { width, height }) => sum + (width + gap) * (height + gap), 0);
  const widest = sizes.reduce((most, { width }) => Math.max(most, width), 0);
  const room = Math.max(widest, 1.25 * Math.sqrt(area));
  const order = sizes.map((_, i) => i).sort((a, b) => sizes[b].height - sizes[a].height || a - b);
  const places = sizes.map(() => ({ x: 0, y: 0 }));
  let [x, y, row, width] = [0, 0, 0, 0];
  for (const i of order) {
    if (x > 0 && x + sizes[i].width > room) {
      y += row + gap;
      x = 0;
      row = 0;
    }
    places[i] = { x, y };
    x += sizes[i].width + gap;
    row = Math.max(row, sizes[i].height);
    width = Math.max(width, x - gap);
  }
  return { places, width, height: y + row };
}

const things = /** @type {[number, string][]} */ ([
  [12, 'a pea'],
  [35, 'a coin'],
  [100, 'an egg'],
  [220, 'a hand'],
  [400, 'a ruler'],
  [800, 'an arm'],
  [1300, 'a table'],
  [2500, 'a person'],
  [6000, 'a car'],
  [15000, 'a bus'],
  [Infinity, 'a house'],
]);

export const millimetres = new Map([
  ['mm', 1],
  ['cm', 10],
  ['dm', 100],
  ['m', 1000],
  ['in', 25.4],
]);

/**
 * How large a model is in a unit.
 * @param {Float32Array} positions
 * @param {string} unit
 */
export function sizeText(positions, unit) {
  const { low, high } = boxOf(positions);
  const sides = high.map((x, k) => (x - low[k]) * (millimetres.get(unit) ?? 1));
  const largest = Math.max(...sides);
  const [scale, name] = largest >= 2000 ? [1000, 'm'] : largest >= 100 ? [10, 'cm'] : [1, 'mm'];
  const text = sides.map((side) => Number((side / scale).toPrecision(2))).join(' × ');
  return { size: `${text} ${name}`, words: things.find(([most]) => largest < most)?.[1] ?? '', largest };
}

/**
 * The unit in which a model is nearest to the size of a garment, a bag or a hat.
 * @param {Float32Array} positions
 */
export function likelyUnit(positions) {
  const far = (/** @type {string} */ unit) => Math.abs(Math.log(sizeText(positions, unit).largest / 500));
  return ['mm', 'cm', 'dm', 'm'].reduce((best, unit) => (far(unit) < far(best) ? unit : best));
}

/**
 * An .obj of a mesh.
 * @param {Float32Array} positions
 * @param {ArrayLike<number>} triangles
 * @param {Map<number, string>} [groups] names of groups, by the triangle that they begin with
 */
export function objText(positions, triangles, groups = new Map()) {
  const rows = [];
  for (let v = 0; 3 * v < positions.length; ++v) rows.push(`v ${pointAt(positions, v).join(' ')}`);
  for (let t = 0; 3 * t < triangles.length; ++t) {
    const group = groups.get(t);
    if (group !== undefined) rows.push(`g ${group}`);
    rows.push(`f ${[0, 1, 2].map((k) => triangles[3 * t + k] + 1).join(' ')}`);
  }
  return `${rows.join('\n')}\n`;
}

/**
 * Which way a direction on the model runs in the pattern of a piece: the mean over its triangles.
 * @param {LaidPiece} piece
 * @param {number[]} way
 */
export function flatDirection({ positions, flat, triangles }, way) {
  const edge = (/** @type {Float32Array} */ of, /** @type {number} */ a, /** @type {number} */ b) =>
    [0, 1, 2].map((k) => of[3 * b + k] - of[3 * a + k]);
  const dot = (/** @type {number[]} */ a, /** @type {number[]} */ b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  const sum = [0, 0];
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = triangles.subarray(t, t + 3);
    const [u, v] = [edge(positions, a, b), edge(positions, a, c)];
    const [uu, uv, vv, uw, vw] = [dot(u, u), dot(u, v), dot(v, v), dot(u, way), dot(v, way)];
    const square = uu * vv - uv * uv;
    if (!(square > 0)) continue;
    // The direction is s u + r v, seen along the triangle's normal; its weight is the area.
    const [s, r] = [(uw * vv - vw * uv) / square, (vw * uu - uw * uv) / square];
    const [p, q] = [edge(flat, a, b), edge(flat, a, c)];
    for (const k of [0, 1]) sum[k] += Math.sqrt(square) * (s * p[k] + r * q[k]);
  }
  return sum;
}

/**
 * @param {Float32Array} positions
 * @param {number} vertex
 * @returns {import('./project.js').Point}
 */
export function pointAt(positions, vertex) {
  const [x, y, z] = [0, 1, 2].map((k) => Number(positions[3 * vertex + k].toPrecision(8)));
  return [x, y, z];
}
