// The modules of web/ that need no browser.
import assert from 'node:assert/strict';
import test from 'node:test';

import { filled, nextScale } from '../../web/viewer/colors.js';
import { unpack } from '../../web/report/data.js';
import { labelsOf, namedFigures, textOf, worstOf, written } from '../../web/viewer/figures.js';
import { pick } from '../../web/viewer/picking.js';

test('numbers are written as the program writes them', () => {
  const cases = [
    [0, '0'],
    [0.063812, '0.0638'],
    [1.2, '1.20'],
    [-27, '−27.0'],
    [123456, '123456'],
    [0.09996, '0.100'],
    [1.2345e-7, '1.23 × 10⁻⁷'],
    [-4.5e12, '−4.50 × 10¹²'],
  ];
  for (const [value, text] of cases) assert.equal(written(value), text);
  assert.equal(written(0.0456, 1), '0.05');
});

test('scales go up and down by 1, 2, 5', () => {
  const up = [0.001];
  while (up.length < 7) up.push(nextScale(up.at(-1), 1));
  assert.deepEqual(up, [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1]);
  assert.equal(nextScale(1, -1), 0.5);
  assert.equal(nextScale(0.2, -1), 0.1);
  assert.equal(nextScale(5e-9, 1), 1e-8);
});

test('what is not measured takes the color of its neighbours and says so', () => {
  const values = new Float32Array([NaN, 2, 4, NaN]);
  assert.deepEqual([...filled(values, [0, 1, 2])], [3, 2, 4, 0]);
  const figure = { text: (value) => `${value}!` };
  assert.equal(textOf(figure, values, 0, 'mm'), 'edge');
  assert.equal(textOf(figure, values, 1, 'mm'), '2!');
  assert.equal(textOf(figure, null, 1, 'mm'), '–');
  assert.equal(worstOf(new Float32Array([NaN, -3, 2])), 1);
});

test('the foremost triangle is meant, and of it the nearest corner', () => {
  // Two triangles over each other, the second in front and turned the other way.
  const places = new Float32Array([0, 0, 0, 10, 0, 0, 0, 10, 0, 0, 0, 5, 0, 9, 5, 9, 0, 5]);
  const triangles = [0, 1, 2, 3, 4, 5];
  assert.equal(pick(places, triangles, 1, 1), 3);
  assert.equal(pick(places, triangles, 1, 6.5), 4);
  assert.equal(pick(places, triangles, 9.2, 0.5), 1, 'beside the one in front');
  assert.equal(pick(places, triangles, 20, 1), -1);
});

test('the limit used up is the strain of the edges over the limit', () => {
  const text = (array) => Buffer.from(array.buffer).toString('base64');
  const json = {
    vertices: 3,
    numbers: '',
    triangles: { bits: 16, data: '' },
    states: { names: [], positions: [] },
    figures: [
      { id: 'defect', map: 'diverging', limit: 1, values: [null] },
      { id: 'edge_strain', map: 'diverging', limit: 1, values: [null, text(new Float32Array([-0.05, 0.01, 0.08]))] },
    ],
    maps: {},
  };
  assert.equal(unpack(json).figures.has('limit_used'), false);
  const data = unpack({ ...json, limit: { asked: 0.05, beyond: [240, 82, 10] } });
  const [figure] = namedFigures(data);
  assert.equal(figure.id, 'limit_used', 'comes first');
  assert.equal(figure.values[0], null);
  const texts = [0, 1, 2].map((vertex) => textOf(figure, figure.values[1], vertex, 'mm'));
  assert.deepEqual(texts, ['100 %', '20 %', '160 %, beyond the limit']);
  assert.deepEqual(labelsOf(figure, figure.limit, 'mm'), ['0', '50 % used up', '100 %, limit of 5 %']);
});

test('only what has a limit has a colour beyond it', () => {
  const values = [new Float32Array([0, 0.5, -4])];
  const figures = new Map([['curvature', { id: 'curvature', map: 'pale', limit: 1, values }]]);
  const [figure] = namedFigures({ figures });
  assert.equal(figure.beyond, undefined);
  assert.deepEqual(labelsOf(figure, 1, 'mm'), ['0 flat', '', 'ball of 1.0 mm radius or less']);
});

test('packed data come out as they went in', () => {
  const text = (array) => Buffer.from(array.buffer).toString('base64');
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
  assert.deepEqual([...data.drawn], [2, 12, 6, 14]);
});
