// The app, opened as a file without network: its patterns are those of the program.
//   node app_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { drawnText, flattenWords, readProject, seamsFile } from '../../web/app/project.js';
import { openPage, skip, skipUnlessThere, startBrowser, temporaryFolder } from './browser.mjs';

const [program, modules] = process.argv.slice(2);
skipUnlessThere(modules);
const html = fileURLToPath(new URL('../../build/web/planish.html', import.meta.url));
if (!existsSync(html)) skip('there is no build/web/planish.html: scripts/web makes it');

const folder = temporaryFolder();
const data = process.env.PLANISH_TEST_DATA ?? '';
let browser;
before(async () => {
  browser = await startBrowser(modules);
});
after(() => browser?.close());

// Runs with the page, without network; what it complains of or asks for fails the test.
async function withApp(options, run) {
  const url = pathToFileURL(html).href;
  const { page, context, complaints, requests } = await openPage(browser, url, { offline: true, ...options });
  try {
    await page.waitForSelector('#app[data-ready]', { timeout: 60000 });
    await run(page);
    assert.deepEqual(complaints, [], 'console');
    assert.deepEqual(requests, [], 'network');
  } finally {
    await context.close();
  }
}

// How many patterns were made so far.
const madeSoFar = (page) => page.$eval('#app', (root) => Number(root.dataset.made ?? 0));

// Does something, and waits for the pattern that comes of it.
async function makes(page, action) {
  const count = await madeSoFar(page);
  await action();
  await page.waitForFunction(
    (least) => {
      const fault = document.querySelector('.alert:not([hidden])')?.textContent;
      if (fault) throw new Error(fault);
      return Number(document.getElementById('app').dataset.made ?? 0) > least;
    },
    count,
    { timeout: 120000 },
  );
}

const choose = (page, path) => page.setInputFiles('input[type=file]', path);

// Drops files onto the page as the system would.
async function drop(page, path) {
  const bytes = readFileSync(path).toString('base64');
  const transfer = await page.evaluateHandle(
    ([text, name]) => {
      const made = new DataTransfer();
      made.items.add(new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], name));
      return made;
    },
    [bytes, basename(path)],
  );
  await page.dispatchEvent('#app', 'drop', { dataTransfer: transfer });
}

async function downloaded(page, selector) {
  const [file] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
  return readFileSync(await file.path());
}

async function savedProject(page) {
  return readProject((await downloaded(page, 'text=Save project')).toString());
}

// What the program writes for a project, by itself.
let runs = 0;
function patternOf(project, model) {
  const place = join(folder, String(++runs));
  mkdirSync(place);
  copyFileSync(model, join(place, project.model));
  writeFileSync(join(place, seamsFile), drawnText(project.lines.filter(({ kind }) => kind === 'drawn')));
  try {
    execFileSync(resolve(program), flattenWords(project, 'pattern'), { cwd: place, stdio: 'pipe' });
  } catch (error) {
    if (error.status !== 3) throw error; // written all the same
  }
  return (path) => readFileSync(join(place, 'pattern', path));
}

// The files of a zip that stores them as they are.
function unzipped(bytes) {
  const files = new Map();
  for (let at = 0; bytes.readUInt32LE(at) === 0x04034b50; ) {
    const [size, name, extra] = [bytes.readUInt32LE(at + 18), bytes.readUInt16LE(at + 26), bytes.readUInt16LE(at + 28)];
    const start = at + 30 + name + extra;
    files.set(bytes.subarray(at + 30, at + 30 + name).toString(), bytes.subarray(start, start + size));
    at = start + size;
  }
  return files;
}

async function expectPatternsOf(page, own) {
  for (const kind of ['svg', 'dxf', 'pdf']) {
    assert.ok((await downloaded(page, `[data-download=${kind}]`)).equals(own(`pattern.${kind}`)), kind);
  }
}

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
    const zip = unzipped(await downloaded(page, '[data-download=zip]'));
    const own = patternOf(named, model);
    const patterns = [...zip.keys()].filter((path) => path.endsWith('pattern.svg'));
    assert.equal(patterns.length, 2);
    for (const path of patterns) assert.ok(zip.get(path).equals(own(path)), path);
  }));

// Points of a line from border to border over the top.
function across(model) {
  const points = readFileSync(model, 'utf8')
    .split('\n')
    .filter((row) => row.startsWith('v '))
    .map((row) => row.split(/\s+/).slice(1, 4).map(Number));
  const best = (score) => points.reduce((most, point) => (score(point) > score(most) ? point : most));
  return [best(([, , z]) => z), best(([, y]) => y), best(([, , z]) => -z)];
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
    // It parts nothing, and the program says so.
    await page.waitForSelector('.alert:not([hidden])');
    assert.match(await page.textContent('.alert'), /nothing is left to cut/);
    const { lines } = await savedProject(page);
    assert.equal(lines[0].points.length, 2);
    await page.locator('.handle').first().focus();
    await page.keyboard.press('ArrowRight');
    assert.notDeepEqual((await savedProject(page)).lines, lines);
    await makes(page, async () => {
      await page.evaluate(() => (document.querySelector('.alert').hidden = true));
      await page.click('[aria-label="Delete line 1"]');
    });
  }));

test('on a phone all is within the width', () =>
  withApp({ viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true }, async (page) => {
    await makes(page, () => page.tap('[data-sample=saddle]'));
    assert.equal(await page.evaluate(() => document.documentElement.scrollWidth), 390);
  }));
