// Figures of vertices in words.
import assert from 'node:assert/strict';
import test from 'node:test';

import { labelsOf, namedFigures, textOf, worstOf, written } from '../../web/viewer/figures.js';

// One state of a figure, with its words.
function named(id, values, more = {}) {
  const [figure] = namedFigures([{ id, map: 'pale', limit: 1, values: [new Float32Array(values)], ...more }]);
  return figure;
}

const textsOf = (figure) => [...figure.values[0]].map((_, vertex) => textOf(figure, figure.values[0], vertex, 'mm'));

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

test('values say what they mean on a patch', () => {
  assert.deepEqual(textsOf(named('defect', [0, 0.5, -0.25, NaN])), [
    '0 rad, flat',
    '+0.500 rad, dome',
    '−0.250 rad, saddle',
    'edge',
  ]);
  assert.deepEqual(textsOf(named('curvature', [0, 0.25])), ['flat', 'ball of radius 2.0 mm']);
  assert.deepEqual(textsOf(named('bent', [0, 0.25])), ['flat', 'as a cylinder of radius 4.0 mm']);
  assert.deepEqual(textsOf(named('strain', [0, 0.0125, -0.5])), ['none', '+1.3 %, longer', '−50 %, shorter']);
  assert.deepEqual(textsOf(named('deviation', [1.25])), ['1.3 mm']);
  assert.deepEqual(textsOf(named('offset', [0, 2.5, -0.75])), ['0 mm', '+2.5 mm, outwards', '−0.75 mm, inwards']);
  assert.deepEqual(labelsOf(named('offset', [2.5]), 2.6, 'mm'), ['inwards −2.6 mm', '0 where it was', 'outwards +2.6 mm']);
});

test('what is not measured says so', () => {
  const figure = { text: (value) => `${value}!` };
  const values = new Float32Array([NaN, 2]);
  assert.equal(textOf(figure, values, 0, 'mm'), 'edge');
  assert.equal(textOf(figure, values, 1, 'mm'), '2!');
  assert.equal(textOf(figure, null, 1, 'mm'), '–');
});

test('figures without values in any state are left out', () => {
  const values = [null, new Float32Array(1)];
  const figures = namedFigures([
    { id: 'strain', map: 'pale', limit: 1, values: [null, null] },
    { id: 'defect', map: 'pale', limit: 1, values },
  ]);
  assert.deepEqual(figures.map(({ id, name }) => [id, name]), [['defect', 'Dome or saddle']]);
});

test('the worst place has the largest size', () => {
  assert.equal(worstOf(new Float32Array([NaN, -3, 2])), 1);
  assert.equal(worstOf(new Float32Array([NaN, NaN])), 0);
});

test('the ends of a scale say where more lies beyond', () => {
  assert.deepEqual(labelsOf(named('strain', [0.01]), 0.02, 'mm'), [
    'shorter −2 %',
    '0 keeps its length',
    'longer +2 %',
  ]);
  assert.deepEqual(labelsOf(named('strain', [-0.03]), 0.02, 'mm'), [
    'shorter −2 % or more',
    '0 keeps its length',
    'longer +2 % or more',
  ]);
  assert.deepEqual(labelsOf(named('deviation', [3]), 2, 'cm'), ['0 stayed', '', '2 cm or more']);
});

test('only what has a limit has a colour beyond it', () => {
  const figure = named('curvature', [0, 0.5, -4]);
  assert.equal(figure.beyond, undefined);
  assert.deepEqual(labelsOf(figure, 1, 'mm'), ['0 flat', '', 'ball of 1.0 mm radius or less']);
});

test('what is used up of a limit', () => {
  const figure = named('limit_used', [1, 0.2, 1.6], { asked: 0.05, beyond: [240, 82, 10] });
  assert.deepEqual(textsOf(figure), ['100 %', '20 %', '160 %, beyond the limit']);
  assert.deepEqual(labelsOf(figure, figure.limit, 'mm'), ['0', '50 % used up', '100 %, limit of 5 %']);
  const apart = named('limit_used', [1, 0.2, 1.6], { beyond: [240, 82, 10] });
  assert.deepEqual(labelsOf(apart, apart.limit, 'mm'), ['0', '50 % used up', '100 %, the limit']);
});

test('what became of the form stands first, terms of the paper last', () => {
  const ids = ['curvature', 'defect', 'longest', 'strain', 'offset', 'limit_used'];
  const figures = ids.map((id) => ({ id, map: 'pale', limit: 1, values: [new Float32Array([1])] }));
  assert.deepEqual(
    namedFigures(figures).map(({ id }) => id),
    ['offset', 'limit_used', 'strain', 'defect', 'curvature', 'longest'],
  );
});
