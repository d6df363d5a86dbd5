// What the app takes of a report's page.
import assert from 'node:assert/strict';
import test from 'node:test';

import { newProject, projectText } from '../../web/app/project.js';
import { opened, readReport } from '../../web/app/reports.js';

const text = (array) => Buffer.from(array.buffer).toString('base64');
const project = { ...newProject('hat.obj', 'ab12'), unit: 'dm', allowance: '10mm', names: { a: 'b' } };
const address = `data:application/json;base64,${Buffer.from(projectText(project)).toString('base64')}`;

// Two pieces of one triangle each, before and after.
const packed = {
  unit: 'cm',
  vertices: 6,
  of: 6,
  triangles: { bits: 16, data: text(new Uint16Array([0, 1, 2, 3, 4, 5])) },
  states: {
    names: ['design', 'result'],
    low: [0, 0, 0],
    step: [1, 0.5, 0.25],
    positions: [
      text(new Uint16Array([0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 4, 2, 0, 4, 0, 2, 4])),
      text(new Uint16Array(18)),
    ],
  },
  pieces: [{ name: 'crown\nf 1 1 1', vertices: 3 }, { name: 'brim', vertices: 3 }],
};

const page = (data) =>
  `<title>hat – Planish</title><p class="app"><a id="project" href="${address}" download="x">Project file</a>` +
  `<small>without --map</small></p></div><script type="application/json" id="report-data">${data}</script>`;

test('the model of a report is that of its design, a group for each piece', () => {
  const { name, bytes, options, asked, words } = opened(readReport(page(JSON.stringify(packed))));
  assert.equal(name, 'hat-report.obj');
  assert.deepEqual(new TextDecoder().decode(bytes).split('\n'), [
    'v 0 0 0', 'v 2 0 0', 'v 0 1 0', 'v 0 0 1', 'v 2 0 1', 'v 0 1 1',
    'g crown f 1 1 1', 'f 1 2 3', 'g brim', 'f 4 5 6', '',
  ]);
  assert.deepEqual(options, { unit: 'cm', material: '', strain: '', allowance: '10mm', paper: '', grain: '' });
  assert.deepEqual(asked, project);
  assert.match(words, /rounded to 1\/65,000 .* drop hat\.obj too\. .* without --map/);
  assert.match(opened({ ...readReport(page(JSON.stringify({ ...packed, of: 9 }))) }).words, /simplified/);
});

test('of one piece the model is what came in', () => {
  const single = { ...packed, pieces: undefined };
  const { bytes } = opened({ data: JSON.stringify(single), project: '', without: '', title: '<b> – Planish' });
  assert.ok(!new TextDecoder().decode(bytes).includes('g '));
});

test('what is no report is refused in words', () => {
  assert.throws(() => readReport('<p>Hello</p>'), /no model/);
  for (const damaged of ['{', '{}', 'null', '{"states": {"names": 3}}']) {
    assert.throws(() => opened(readReport(page(damaged))), /damaged/);
  }
  const hostile = { ...readReport(page('{}')), project: 'data:application/json;base64,e30=' };
  assert.throws(() => opened({ ...hostile, data: JSON.stringify(packed) }), /no project/);
});
