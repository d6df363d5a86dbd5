// The data of the page of a product, unpacked.
import assert from 'node:assert/strict';
import test from 'node:test';

import { unpackProduct } from '../../web/report/product_data.js';

const text = (array) => Buffer.from(array.buffer).toString('base64');

const packed = {
  vertices: 5,
  of: 50,
  views: { y: { right: [1, 0, 0] }, z: { right: [0, 1, 0] } },
  middle: [1, 2, 3],
  triangles: { bits: 16, data: text(new Uint16Array([0, 1, 2, 2, 3, 4])) },
  states: {
    names: ['design', 'result'],
    shown: 1,
    low: [0, 0, 10],
    step: [1, 0.5, 0],
    positions: [text(new Uint16Array(15)), text(Uint16Array.from({ length: 15 }, (_, i) => i))],
  },
  pieces: [
    { name: 'front', number: 1, color: [1, 2, 3], vertices: 3, middle: [1, 2, 5] },
    { name: 'back', number: 4, color: [4, 5, 6], vertices: 2, middle: [0, 4, 3] },
  ],
  seams: [
    { number: 2, piece: 1, vertices: text(new Uint32Array([0, 2])) },
    { number: 2, piece: 4, vertices: text(new Uint32Array([4, 3])) },
    { number: 7, piece: 4, vertices: text(new Uint32Array([3, 4])) },
    { number: 7, piece: 4, vertices: text(new Uint32Array([4, 3])) },
  ],
};

test('pieces have their vertices, and go away from the middle of the product', () => {
  const { patch, pieces, names, count, whole } = unpackProduct(packed);
  assert.deepEqual([...patch.pieces.of], [0, 0, 0, 1, 1]);
  assert.deepEqual([...patch.pieces.ways], [0, 0, 2, -1, 2, 0]);
  assert.deepEqual(patch.pieces.colors, [[1, 2, 3], [4, 5, 6]]);
  assert.deepEqual(pieces.map(({ name, number }) => [name, number]), [['front', 1], ['back', 4]]);
  assert.deepEqual([...patch.positions[1].subarray(3, 6)], [3, 2, 10]);
  assert.deepEqual([...patch.triangles], [0, 1, 2, 2, 3, 4]);
  assert.deepEqual([names, count, whole, patch.shown], [['design', 'result'], 5, 50, 1]);
});

test('seams have the vertices and the number of each side, and pieces their seams', () => {
  const { patch, pieces } = unpackProduct(packed);
  assert.deepEqual(
    patch.pieces.lines.map(({ number, vertices }) => [number, ...vertices]),
    [[2, 0, 2], [2, 4, 3], [7, 3, 4], [7, 4, 3]],
  );
  assert.deepEqual(pieces.map(({ seams }) => seams), [[2], [2, 7]]);
});

test('either axis can point up', () => {
  const { patch, views } = unpackProduct(packed);
  assert.deepEqual([...views.keys()], ['y', 'z']);
  assert.equal(patch.view, views.get('y'));
});
