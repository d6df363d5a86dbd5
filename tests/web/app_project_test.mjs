// Projects of the app: their files, and the words that they are for the program.
import assert from 'node:assert/strict';
import test from 'node:test';

import {
  History,
  cutsOf,
  dartsWords,
  drawnText,
  filesOf,
  flattenWords,
  lineWord,
  linesOf,
  modelFiles,
  newProject,
  panelsWords,
  projectText,
  readProject,
  shellText,
  sketchWords,
} from '../../web/app/project.js';
import { lineHint } from '../../web/app/words.js';

const all = ['--formats', 'svg,dxf,pdf,plt', '--textured'];

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
  symmetric: 'x=-0.5',
  notches: [[0, 0, 1], [0.25, 1, 0]],
  grain: '0,0.6,-0.8',
};

test('a project is a command line of the program', () => {
  assert.deepEqual(flattenWords(hat, 'out'), [
    'flatten', 'hat.obj', '--unit', 'dm', '--cut', 'line 0,0,1 0.5,2,-1e-7', '--cut', 'seams.obj',
    '--symmetric', 'x=-0.5', '--mirror-surface', '--rename', 'hat-1=crown', '--without', 'hat-3',
    '--allowance', '10mm', '--seam-notches', 'notches.obj', '--grain', '0,0.6,-0.8', ...all, '-o', 'out',
  ]);
  assert.deepEqual(flattenWords(newProject('a.ply', ''), 'out'), ['flatten', 'a.ply', ...all, '-o', 'out']);
});

test('a quick look is cut as the pattern is', () => {
  assert.deepEqual(sketchWords(hat), [
    'flatten', 'hat.obj', '--cut', 'line 0,0,1 0.5,2,-1e-7', '--cut', 'seams.obj', '--symmetric', 'x=-0.5', '--mirror-surface',
  ]);
  assert.ok(!sketchWords({ ...hat, symmetric: 'auto' }).includes('--mirror-surface'));
});

test('several files are the parts of one product', () => {
  const product = { ...newProject('a.obj', '1'), parts: [{ model: 'b.obj', hash: '2' }], unit: 'm' };
  assert.deepEqual(flattenWords(product, 'out'), ['flatten', 'a.obj', 'b.obj', '--product', '--unit', 'm', ...all, '-o', 'out']);
  assert.deepEqual(modelFiles(product), [{ model: 'a.obj', hash: '1' }, { model: 'b.obj', hash: '2' }]);
  assert.deepEqual(readProject(projectText(product)), product);
});

test('darts are proposed for the file that is named', () => {
  assert.deepEqual(dartsWords(hat, 'piece.obj', '5%'), [
    'suggest-cuts', 'piece.obj', '--unit', 'dm', '--max-strain', '5%', '-o', 'darts.txt',
  ]);
});

test('the files that words name are there', () => {
  const files = new Map(filesOf(hat));
  assert.deepEqual([...files.keys()], ['seams.obj', 'notches.obj']);
  assert.equal(files.get('notches.obj'), 'v 0 0 1\nv 0.25 1 0\np 1 2\n');
  assert.deepEqual(filesOf({ ...hat, lines: [], notches: [] }), []);
});

test('proposed darts are read', () => {
  assert.deepEqual(cutsOf('# darts\n3 4, 5\n\n7 8 # tip\n'), [[3, 4, 5], [7, 8]]);
});

test('a hint names the lines that cut nothing', () => {
  const [line] = hat.lines;
  assert.equal(lineHint(hat, ''), '');
  assert.equal(lineHint(hat, 'note: something else'), '');
  assert.match(lineHint(hat, `error: --cut ${lineWord(line)}: nothing is left to cut`), /^Line 1 cuts nothing yet/);
  assert.match(lineHint(hat, 'error: nothing is left to cut'), /^These lines cut nothing yet/);
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
    [JSON.stringify({ ...packed(), symmetric: '; rm' }), /plane/],
    [JSON.stringify({ ...packed(), grain: '0,0; rm' }), /grain/],
    [JSON.stringify({ ...packed(), parts: 'all' }), /lists/],
    [JSON.stringify({ ...packed(), notches: [[0, 0]] }), /notch/],
    [JSON.stringify({ ...packed(), names: { 'hat-1': 'a\nb' } }), /name/],
    [JSON.stringify({ ...packed(), lines: {} }), /lists/],
    [JSON.stringify({ ...packed(), lines: [null] }), /line/],
    [JSON.stringify({ ...packed(), lines: [{ kind: 'shortest', points: [[0, 0, 0]] }] }), /line/],
    [JSON.stringify({ ...packed(), lines: [{ kind: 'shortest', points: [[0, 0, 0], [1, '; rm', 0]] }] }), /line/],
    [JSON.stringify({ ...packed(), lines: [{ kind: 'plane', points: [[0, 0, 0], [1, 0, 0]] }] }), /line/],
  ]) {
    assert.throws(() => readProject(text), words, text);
  }
});

test('a project file without the later keys is read', () => {
  const { symmetric, notches, parts, grain, ...packed } = JSON.parse(projectText(hat));
  assert.ok(symmetric && notches && parts && grain);
  assert.deepEqual(readProject(JSON.stringify(packed)), { ...hat, symmetric: '', notches: [], grain: '' });
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
