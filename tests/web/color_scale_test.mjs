// Values as colours.
import assert from 'node:assert/strict';
import test from 'node:test';

import { colorOf, filled, gradientOf, nextScale } from '../../web/viewer/color_scale.js';

test('what is not measured takes the colour of its neighbours', () => {
  const values = new Float32Array([NaN, 2, 4, NaN]);
  assert.deepEqual([...filled(values, [0, 1, 2])], [3, 2, 4, 0]);
  assert.deepEqual([...values], [NaN, 2, 4, NaN], 'the values stay');
});

test('scales go up and down by 1, 2, 5', () => {
  const up = [0.001];
  while (up.length < 7) up.push(nextScale(up.at(-1), 1));
  assert.deepEqual(up, [0.001, 0.002, 0.005, 0.01, 0.02, 0.05, 0.1]);
  assert.equal(nextScale(1, -1), 0.5);
  assert.equal(nextScale(0.2, -1), 0.1);
  assert.equal(nextScale(5e-9, 1), 1e-8);
  assert.equal(nextScale(0.0021, 1), 0.005, 'from the nearest');
});

test('colours and maps as a style sheet has them', () => {
  assert.equal(colorOf([240, 82, 10]), 'rgb(240 82 10)');
  const map = new Uint8Array([1, 2, 3, 4, 5, 6]);
  assert.equal(gradientOf(map), 'linear-gradient(to right, rgb(1 2 3), rgb(4 5 6))');
});
