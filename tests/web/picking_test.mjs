// Which vertex is meant by a place.
import assert from 'node:assert/strict';
import test from 'node:test';

import { PointGrid, pick } from '../../web/viewer/picking.js';

test('the foremost triangle is meant, and of it the nearest corner', () => {
  // Two triangles over each other, the second in front and turned the other way.
  const places = new Float32Array([0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 5, 0, 9, 5, 9, 0, 5]);
  const triangles = [0, 1, 2, 3, 4, 5];
  assert.equal(pick(places, triangles, 1, 1), 3);
  assert.equal(pick(places, triangles, 1, 6.5), 4);
  assert.equal(pick(places, triangles, 9.2, 0.5), 1, 'beside the one in front');
  assert.equal(pick(places, triangles, 20, 1), -1);
});

test('depth is that of the triangle at the place, not of its corners', () => {
  // The first slopes from depth 0 to 10 along x, the second lies at depth 5.
  const places = new Float32Array([0, 0, 0, 10, 0, 10, 0, 10, 0, 0, 0, 5, 10, 0, 5, 0, 10, 5]);
  const triangles = [0, 1, 2, 3, 4, 5];
  assert.equal(pick(places, triangles, 1, 1), 3);
  assert.equal(pick(places, triangles, 8, 1), 1);
});

test('a triangle seen on its edge is not meant', () => {
  assert.equal(pick(new Float32Array([0, 0, 0, 5, 0, 0, 10, 0, 0]), [0, 1, 2], 5, 0), -1);
});

// By looking at all of them.
function nearestOf(points, x, y, distance) {
  let [best, least] = [-1, distance];
  for (let i = 0; i < points.length / 2; ++i) {
    const apart = Math.hypot(points[2 * i] - x, points[2 * i + 1] - y);
    if (apart <= least) [best, least] = [i, apart];
  }
  return { best, least };
}

test('a grid finds the point that is nearest of all', () => {
  let state = 1;
  const random = () => (state = (state * 48271) % 2147483647) / 2147483647;
  const points = Float32Array.from({ length: 600 }, (_, i) => (i % 2 === 0 ? 100 : 7) * random());
  const grid = new PointGrid(points);
  for (let i = 0; i < 500; ++i) {
    const [x, y, distance] = [140 * random() - 20, 20 * random() - 6, 12 * random()];
    const { best, least } = nearestOf(points, x, y, distance);
    const found = grid.nearest(x, y, distance);
    if (best < 0) assert.equal(found, -1);
    else assert.equal(Math.hypot(points[2 * found] - x, points[2 * found + 1] - y), least);
  }
});

test('a grid of one point, and of points on a line', () => {
  assert.equal(new PointGrid(new Float32Array([3, 4])).nearest(3, 5, 2), 0);
  assert.equal(new PointGrid(new Float32Array([3, 4])).nearest(3, 7, 2), -1);
  assert.equal(new PointGrid(new Float32Array([0, 1, 5, 1, 9, 1])).nearest(6, 1, 3), 1);
});
