// The app, opened as a file without network: its patterns are those of the program.
//   node app_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import test from 'node:test';

import { projectText } from '../../web/app/project.js';
import {
  choose,
  data,
  downloaded,
  drop,
  expectPatternsOf,
  expectZipOf,
  folder,
  makes,
  openProject,
  patternOf,
  patternOfFile,
  program,
  savedProject,
  unzipped,
  withApp,
} from './app.mjs';

test('a sample comes as the program makes it', () =>
  withApp({}, async (page) => {
    await makes(page, () => page.click('[data-sample=dome]'));
    const project = await savedProject(page);
    const model = join(folder, 'dome.obj');
    execFileSync(resolve(program), ['sample', 'dome', '--vertices', '1500', '-o', model]);
    await expectPatternsOf(page, patternOf(project, model));
    const zip = unzipped(await downloaded(page, '[data-download=zip]'));
    const own = patternOf(project, model);
    for (const name of ['pattern.svg', 'flat.obj', 'processed.obj']) assert.ok(zip.get(name).equals(own(name)), name);
  }));

test('the pattern of a dropped file is that of the program', { skip: !existsSync(data) && 'no real data' }, () =>
  withApp({}, async (page) => {
    const model = join(data, 'patches/gc_front_4k.obj');
    await makes(page, () => drop(page, model));
    await expectPatternsOf(page, patternOf(await savedProject(page), model));
  }));

test('a line is drawn, moved, undone, saved and opened', { skip: !existsSync(data) && 'no real data' }, () =>
  withApp({}, async (page) => {
    const model = join(data, 'products/hat.obj');
    await makes(page, () => choose(page, model));
    assert.equal((await savedProject(page)).unit, 'dm', 'the likely size');

    const box = await page.locator('.view canvas').boundingBox();
    const at = (x, y) => [box.x + x * box.width, box.y + y * box.height];
    await page.click('text=Draw a line');
    // From below, up to where a place snaps to the border.
    for (let y = 0.98; (await page.locator('.handle').count()) === 0; y -= 0.01) {
      assert.ok(y > 0.5, 'no border below the hat');
      await page.mouse.click(...at(0.5, y));
    }
    for (const [x, y] of [[0.5, 0.6], [0.5, 0.45]]) await page.mouse.click(...at(x, y));
    await makes(page, () => page.keyboard.press('Enter'));
    const drawn = await savedProject(page);
    assert.equal(drawn.lines.length, 1);
    assert.equal(drawn.lines[0].points.length, 3);

    const handle = await page.locator('.handle').nth(1).boundingBox();
    await page.mouse.move(handle.x + handle.width / 2, handle.y + handle.height / 2);
    await page.mouse.down();
    await page.mouse.move(handle.x + 40, handle.y + 6, { steps: 4 });
    await makes(page, () => page.mouse.up());
    const moved = await savedProject(page);
    assert.notDeepEqual(moved.lines[0].points[1], drawn.lines[0].points[1]);
    assert.deepEqual(moved.lines[0].points[0], drawn.lines[0].points[0]);
    await expectPatternsOf(page, patternOf(moved, model));

    await makes(page, () => page.keyboard.press('Control+z'));
    assert.deepEqual((await savedProject(page)).lines, drawn.lines);
    await makes(page, () => page.click('text=Undo'));
    assert.deepEqual((await savedProject(page)).lines, []);
    await makes(page, () => page.click('text=Redo'));
    const file = join(folder, 'hat.planish.json');
    writeFileSync(file, await downloaded(page, 'text=Save project'));
    await makes(page, () => page.click('[aria-label="Delete line 1"]'));
    await makes(page, () => choose(page, file));
    assert.deepEqual((await savedProject(page)).lines, drawn.lines);
  }));

test('a model that is divided has its pieces named and left out', { skip: !existsSync(data) && 'no real data' }, () =>
  withApp({}, async (page) => {
    const model = join(data, 'products/hat.obj');
    await makes(page, () => choose(page, model));
    const project = { ...(await savedProject(page)), lines: [{ kind: 'shortest', points: across(model) }] };
    const file = join(folder, 'cut.planish.json');
    writeFileSync(file, JSON.stringify({ kind: 'planish project', version: 1, ...project }));
    await makes(page, () => choose(page, file));
    assert.equal(await page.locator('.pieces li').count(), 2);
    const name = page.locator('.pieces input[type=text]').first();
    await makes(page, async () => {
      await name.fill('crown <b>');
      await name.press('Enter');
    });
    const named = await savedProject(page);
    const paths = await expectZipOf(page, patternOf(named, model), patternOfFile(named, model));
    assert.equal(paths.filter((path) => path.endsWith('pattern.svg')).length, 2);
  }));

test('lines are mirrored, notches set on both sides, and all of it undone', { skip: !existsSync(data) && 'no real data' }, () =>
  withApp({}, async (page) => {
    const model = join(data, 'products/hat.obj');
    await makes(page, () => choose(page, model));
    await openProject(page, { ...(await savedProject(page)), lines: [{ kind: 'shortest', points: across(model) }] });
    await makes(page, () => page.click('text=Mirror lines'));
    // The hat is nearly symmetric: one half of it is taken for both.
    assert.match((await savedProject(page)).symmetric, /^x=-0\.0066/);

    await page.click('.lines .name');
    const box = await page.locator('.handle:not([hidden])').first().boundingBox();
    await page.click('text=Set notches');
    await makes(page, () => page.mouse.click(box.x + box.width / 2, box.y + box.height / 2));
    const notched = await savedProject(page);
    assert.equal(notched.notches.length, 1);
    assert.equal(await page.locator('.notch').count(), 1);
    await expectZipOf(page, patternOf(notched, model), patternOfFile(notched, model));

    await makes(page, () => page.click('text=Undo'));
    assert.equal(await page.locator('.notch').count(), 0);
    await makes(page, () => page.click('text=Undo'));
    assert.equal((await savedProject(page)).symmetric, '');
    await makes(page, () => page.click('text=Undo'));
    assert.deepEqual((await savedProject(page)).lines, []);
  }));

test('proposed darts are lines that can be moved', () =>
  withApp({}, async (page) => {
    await makes(page, () => page.click('[data-sample=dome]'));
    await makes(page, () => page.click('text=Propose darts'));
    const { lines } = await savedProject(page);
    assert.ok(lines.length > 0);
    assert.ok(lines.every(({ kind, points }) => kind === 'shortest' && points.length < 12));
  }));

// Delays of quick looks while a point of a line is dragged about.
async function delaysOf(page, moves) {
  await page.click('.lines .name');
  const box = await page.locator('.handle:not([hidden])').nth(1).boundingBox();
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  await page.mouse.move(x, y);
  await page.mouse.down();
  const delays = [];
  for (let i = 1; i <= moves; ++i) {
    const count = Number(await page.$eval('#app', (root) => root.dataset.sketched ?? 0));
    await page.mouse.move(x + 30 * Math.sin(i), y + 20 * Math.cos(i));
    await page.waitForFunction((least) => Number(document.getElementById('app').dataset.seen ?? 0) > least, count);
    delays.push(Number(await page.$eval('#app', (root) => root.dataset.delay)));
  }
  await page.mouse.up();
  return delays.sort((a, b) => a - b);
}

for (const vertices of [5000, 50000]) {
  test(`a line that is moved is cut and laid flat at once, of ${vertices} vertices`, () =>
    withApp({}, async (page) => {
      const model = join(folder, `dome${vertices}.obj`);
      execFileSync(resolve(program), ['sample', 'dome', '--vertices', String(vertices), '-o', model]);
      const start = performance.now();
      await choose(page, model);
      await page.waitForFunction(() => document.getElementById('app').dataset.seen);
      const first = performance.now() - start;
      const points = across(model, ([x]) => x, ([, , z]) => z);
      const lines = [{ kind: 'shortest', points }];
      const file = join(folder, 'line.planish.json');
      writeFileSync(file, projectText({ ...(await savedProject(page)), lines }));
      const count = await page.$eval('#app', (root) => Number(root.dataset.sketched));
      await choose(page, file);
      await page.waitForFunction((least) => Number(document.getElementById('app').dataset.seen) > least, count);
      const delays = await delaysOf(page, 15);
      const middle = delays[Math.floor(delays.length / 2)];
      console.log(`# ${vertices} vertices: first look ${first.toFixed(0)} ms, moved point ${middle.toFixed(0)} ms (median)`);
      await page.click('text=Cancel').catch(() => {});
    }));
}

// Points of a line from border to border over the top.
function across(model, along = ([, , z]) => z, up = ([, y]) => y) {
  const points = readFileSync(model, 'utf8')
    .split('\n')
    .filter((row) => row.startsWith('v '))
    .map((row) => row.split(/\s+/).slice(1, 4).map(Number));
  const best = (score) => points.reduce((most, point) => (score(point) > score(most) ? point : most));
  return [best(along), best(up), best((point) => -along(point))];
}

test('files that are no models are refused in words, and the page goes on', () =>
  withApp({}, async (page) => {
    for (const [name, text] of [
      ['empty.obj', ''],
      ['broken.obj', 'v 0 0 0\nv 1 0\nf 1 2 3\n'],
      ['noise.stl', 'x'.repeat(5000)],
      ['other.json', '{}'],
      ['unknown.xyz', '1 2 3'],
    ]) {
      const path = join(folder, name);
      writeFileSync(path, text);
      await page.evaluate(() => (document.querySelector('.alert').hidden = true));
      await choose(page, path);
      await page.waitForSelector('.alert:not([hidden])');
      assert.ok((await page.textContent('.alert')).length > 10, name);
    }
    await makes(page, async () => {
      await page.evaluate(() => (document.querySelector('.alert').hidden = true));
      await page.click('[data-sample=cone]');
    });
  }));

test('a job can be cancelled, and the next change makes the pattern', () =>
  withApp({}, async (page) => {
    await page.click('[data-sample=dome]');
    await page.click('text=Cancel');
    await page.waitForFunction(() => document.querySelector('.busy').hidden);
    await makes(page, async () => {
      await page.fill('.field:has-text("Allowance") input', '10');
      await page.keyboard.press('Tab');
    });
    assert.equal((await savedProject(page)).allowance, '10mm');
  }));

test('a line is drawn by keys alone', () =>
  withApp({}, async (page) => {
    await makes(page, () => page.click('[data-sample=dome]'));
    await page.focus('text=Draw a line');
    await page.keyboard.press('Enter');
    await page.keyboard.press('Space');
    for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowUp');
    await page.keyboard.press('Space');
    await page.keyboard.press('Enter');
    // It parts nothing, which is no error: the pattern is that without it.
    await page.waitForFunction(() => /Line 1 cuts nothing yet/.test(document.querySelector('.hint').textContent));
    assert.equal(await page.locator('.alert:not([hidden])').count(), 0);
    const { lines } = await savedProject(page);
    assert.equal(lines[0].points.length, 2);
    await page.locator('.handle').first().focus();
    await page.keyboard.press('ArrowRight');
    assert.notDeepEqual((await savedProject(page)).lines, lines);
    await makes(page, () => page.click('[aria-label="Delete line 1"]'));
    assert.equal(await page.textContent('.hint'), '');
  }));

test('work is kept in the browser, unless that is switched off', () =>
  withApp({}, async (page) => {
    await makes(page, () => page.click('[data-sample=cone]'));
    await makes(page, async () => {
      await page.fill('.field:has-text("Allowance") input', '7');
      await page.keyboard.press('Tab');
    });
    await page.waitForTimeout(1000);
    await page.reload();
    await page.waitForSelector('#app[data-ready]', { timeout: 60000 });
    await makes(page, () => page.click('[data-work]'));
    assert.equal((await savedProject(page)).allowance, '7mm');

    await page.click('text=Keep my work');
    await page.waitForTimeout(300);
    await page.reload();
    await page.waitForSelector('#app[data-ready]', { timeout: 60000 });
    assert.equal(await page.locator('[data-work]').count(), 0);
    assert.equal(await page.isChecked('.keeping input'), false);
  }));

test('on a phone all is within the width', () =>
  withApp({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, async (page) => {
    await makes(page, () => page.tap('[data-sample=saddle]'));
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  }));
