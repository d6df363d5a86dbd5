// Projects of the app: their files, and the words that they are for the program.
import assert from 'node:assert/strict';
import test from 'node:test';

import {
  History,
  drawnText,
  flattenWords,
  linesOf,
  newProject,
  panelsWords,
  projectText,
  readProject,
  shellText,
} from '../../web/app/project.js';

const hat = {
  ...newProject('hat.obj', 'ab12'),
  unit: 'dm',
  lines: [
    { kind: 'shortest', points: [[0, 0, 1], [0.5, 2, -1e-7]] },
    { kind: 'drawn', points: [[0, 0, 0], [1, 0, 0], [1, 1, 0]] },
  ],
  names: { 'hat-1': 'crown', 'hat-2': 'hat-2' },
  without: ['hat-3'],
  allowance: '10mm',
};

test('a project is a command line of the program', () => {
  assert.deepEqual(flattenWords(hat, 'out'), [
    'flatten', 'hat.obj', '--unit', 'dm', '--cut', 'line 0,0,1 0.5,2,-1e-7', '--cut', 'seams.obj',
    '--rename', 'hat-1=crown', '--without', 'hat-3', '--allowance', '10mm', '-o', 'out',
  ]);
  assert.deepEqual(flattenWords(newProject('a.ply', ''), 'out'), ['flatten', 'a.ply', '-o', 'out']);
});

test('panels keep the limit of the project, else the one that is given', () => {
  assert.deepEqual(panelsWords(hat, '2%'), [
    'panels', 'hat.obj', '--unit', 'dm', '--max-rms-strain', '2%', '-o', 'seams.obj',
  ]);
  assert.ok(!panelsWords({ ...hat, material: 'cotton' }, '2%').includes('--max-rms-strain'));
});

test('words for a shell are quoted where they have to be', () => {
  assert.equal(shellText(['flatten', "it's.obj", '--cut', 'line 0,0,1 1,1,1']),
    "planish flatten 'it'\\''s.obj' --cut 'line 0,0,1 1,1,1'");
});

test('a project comes back from its file', () => {
  assert.deepEqual(readProject(projectText(hat)), hat);
});

test('files that are no project are refused with words', () => {
  const packed = () => JSON.parse(projectText(hat));
  for (const [text, words] of [
    ['', /not JSON/],
    ['null', /no project/],
    ['[]', /no project/],
    ['{"kind": "other"}', /no project/],
    [JSON.stringify({ ...packed(), version: 2 }), /version 2/],
    [JSON.stringify({ ...packed(), version: '<b>'.repeat(100) }), /version <b>/],
    [JSON.stringify({ ...packed(), unit: 'ell' }), /unit/],
    [JSON.stringify({ ...packed(), model: 7 }), /model/],
    [JSON.stringify({ ...packed(), lines: {} }), /lists/],
    [JSON.stringify({ ...packed(), lines: [null] }), /line/],
    [JSON.stringify({ ...packed(), lines: [{ kind: 'shortest', points: [[0, 0, 0]] }] }), /line/],
    [JSON.stringify({ ...packed(), lines: [{ kind: 'shortest', points: [[0, 0, 0], [1, '; rm', 0]] }] }), /line/],
    [JSON.stringify({ ...packed(), lines: [{ kind: 'plane', points: [[0, 0, 0], [1, 0, 0]] }] }), /line/],
  ]) {
    assert.throws(() => readProject(text), words, text);
  }
});

test('what a project file has beside is dropped', () => {
  const read = readProject(JSON.stringify({ ...JSON.parse(projectText(hat)), extra: 1, __proto__: { a: 1 } }));
  assert.deepEqual(Object.keys(read).sort(), Object.keys(hat).sort());
});

test('proposed lines go through an .obj and back', () => {
  const lines = hat.lines.filter(({ kind }) => kind === 'drawn');
  assert.deepEqual(linesOf(drawnText([...lines, ...lines])), [...lines, ...lines]);
});

test('changes are undone and done again, and a new one drops what was undone', () => {
  const history = new History(newProject('a', ''));
  for (const unit of ['mm', 'cm', 'm']) history.push({ ...history.now, unit });
  assert.ok(history.undo() && history.undo());
  assert.equal(history.now.unit, 'mm');
  assert.ok(history.redo());
  assert.equal(history.now.unit, 'cm');
  history.push({ ...history.now, unit: 'in' });
  assert.equal(history.redo(), false);
  assert.ok(history.undo());
  assert.equal(history.now.unit, 'cm');
});
