// The data of a page, unpacked.
import assert from 'node:assert/strict';
import test from 'node:test';

import { unpack } from '../../web/report/data.js';

const text = (array) => Buffer.from(array.buffer).toString('base64');

// As little as a page may hold.
const least = {
  vertices: 3,
  numbers: '',
  triangles: { bits: 16, data: '' },
  states: { names: [], positions: [] },
  figures: [
    { id: 'defect', map: 'diverging', limit: 1, values: [null] },
    { id: 'edge_strain', map: 'diverging', limit: 1, values: [null, text(new Float32Array([-0.5, 0.25, 1]))] },
  ],
  maps: {},
  pattern: null,
};

test('packed data come out as they went in', () => {
  const data = unpack({
    unit: 'cm',
    vertices: 2,
    of: 9,
    view: {},
    numbers: text(new Uint32Array([4, 70000])),
    triangles: { bits: 16, data: text(new Uint16Array([0, 1, 1])) },
    states: {
      names: ['a'],
      shown: 0,
      low: [-1, 0, 5],
      step: [0.5, 1, 0],
      positions: [text(new Uint16Array([0, 1, 2, 65535, 3, 4]))],
    },
    figures: [{ id: 'defect', map: 'paper', limit: 2, values: [text(new Float32Array([0.25, -3])), null] }],
    maps: { paper: text(new Uint8Array([1, 2, 3])) },
    pattern: { low: [0, 10], step: [2, 1], positions: text(new Uint16Array([1, 2, 3, 4])) },
  });
  assert.deepEqual([...data.positions[0]], [-1, 1, 5, 32766.5, 3, 5]);
  assert.deepEqual([...data.numbers], [4, 70000]);
  assert.deepEqual([...data.triangles], [0, 1, 1]);
  assert.deepEqual([...data.figures.get('defect').values[0]], [0.25, -3]);
  assert.equal(data.figures.get('defect').values[1], null);
  assert.deepEqual([...data.maps.get('paper')], [1, 2, 3]);
  assert.deepEqual([...data.drawn], [2, 12, 6, 14]);
});

test('indices have 32 bits where 16 are too few', () => {
  const data = unpack({ ...least, triangles: { bits: 32, data: text(new Uint32Array([0, 1, 70000])) } });
  assert.deepEqual([...data.triangles], [0, 1, 70000]);
  assert.equal(data.drawn, null);
});

test('the limit used up is the strain of the edges over the limit', () => {
  assert.equal(unpack(least).figures.has('limit_used'), false);
  const data = unpack({ ...least, limit: { asked: 0.5, beyond: [240, 82, 10] } });
  const [figure] = data.figures.values();
  assert.equal(figure.id, 'limit_used', 'comes first');
  assert.equal(figure.values[0], null);
  assert.deepEqual([...figure.values[1]], [1, 0.5, 2]);
  assert.deepEqual(figure.beyond, [240, 82, 10]);
});

test('a limit of stretch and one of compression are used up apart', () => {
  const used = (limit) => [...unpack({ ...least, limit }).figures.get('limit_used').values[1]];
  assert.deepEqual(used({ stretch: 0.5, compression: 0.25, beyond: [1, 2, 3] }), [1, 1, 4]);
  assert.deepEqual(used({ stretch: null, compression: 0.5, beyond: [1, 2, 3] }), [0, 0.5, 2]);
});

test('lengths are in millimetres whatever the unit of the model', () => {
  const of = (id, value) => ({ id, map: 'pale', limit: 2, values: [null, text(new Float32Array([value]))] });
  const figures = [of('offset', -0.5), of('deviation', 0.5), of('bent', 4), of('curvature', 8), of('strain', 0.25)];
  const data = unpack({ ...least, unit: 'm', figures });
  assert.equal(data.unit, 'mm');
  const shown = [...data.figures.values()].map(({ id, limit, values }) => [id, limit, values[1][0]]);
  const small = [Math.fround(4 * 1e-3), Math.fround(8 * 1e-6)];
  assert.deepEqual(shown, [
    ['offset', 2000, -500],
    ['deviation', 2000, 500],
    ['bent', 2 * 1e-3, small[0]],
    ['curvature', 2 * 1000 ** -2, small[1]],
    ['strain', 2, 0.25],
  ]);
});
