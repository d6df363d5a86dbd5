// What the app opens beside a model: the parts of a product, projects and reports.
//   node app_files_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import test from 'node:test';
import { pathToFileURL } from 'node:url';

import { projectText, readProject } from '../../web/app/project.js';
import {
  browser,
  downloaded,
  drop,
  expectZipOf,
  folder,
  html,
  makes,
  patternOf,
  patternOfFile,
  program,
  savedProject,
  withApp,
} from './app.mjs';
import { openPage } from './browser.mjs';

const place = (...names) => join(folder, ...names);
const planish = (...words) => execFileSync(resolve(program), words, { cwd: folder, stdio: 'pipe' });
planish('sample', 'dome', '--vertices', '400', '-o', 'dome.obj');
planish('sample', 'saddle', '--vertices', '400', '-o', 'saddle.obj');
planish('flatten', 'dome.obj', '--unit', 'cm', '--allowance', '10mm', '--cut', 'line 0,0,50 50,0,0', '--map', '-o', 'out');
const products = ['dome.obj', 'saddle.obj'].map((name) => place(name));

test('files that are dropped together are the parts of one product', () =>
  withApp({}, async (page) => {
    await makes(page, () => drop(page, ...products));
    const project = await savedProject(page);
    assert.deepEqual([project.model, ...project.parts.map(({ model }) => model)], ['dome.obj', 'saddle.obj']);
    const paths = await expectZipOf(page, patternOf(project, products), patternOfFile(project, products));
    assert.equal(paths.filter((path) => path.endsWith('pattern.svg')).length, 2);
    assert.equal(await page.locator('.pieces li').count(), 2);
    assert.equal(await page.locator('text=Draw a line').isVisible(), false);

    // The project is of these files, whichever come first.
    await makes(page, async () => {
      await page.locator('.pieces input[type=checkbox]').first().click();
    });
    const left = await savedProject(page);
    assert.deepEqual(left.without, ['dome']);
    writeFileSync(place('two.planish.json'), projectText(left));
    await makes(page, () => drop(page, products[0]));
    await drop(page, place('two.planish.json'));
    await page.waitForSelector('text=This project is of dome.obj and saddle.obj');
    await makes(page, () => drop(page, products[1], products[0]));
    assert.deepEqual(await savedProject(page), left);
  }));

for (const ending of ['ply', 'off', 'stl']) {
  test(`a model of .${ending} is shown with its pattern, which is that of the program`, () =>
    withApp({}, async (page) => {
      const model = place(`some.${ending}`);
      planish('convert', 'dome.obj', model);
      await makes(page, () => drop(page, model));
      await page.waitForSelector('[aria-label="Pattern of some"]');
      await expectZipOf(page, patternOf(await savedProject(page), model));
    }));
}

test('the grain runs from one click to the next, in the pattern as well', () =>
  withApp({}, async (page) => {
    await makes(page, () => drop(page, products[0]));
    const box = await page.locator('.view canvas').boundingBox();
    await page.click('text=Set the grain');
    await page.mouse.click(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    await makes(page, () => page.mouse.click(box.x + 0.6 * box.width, box.y + 0.5 * box.height));
    const project = await savedProject(page);
    const way = project.grain.split(',').map(Number);
    assert.ok(Math.abs(Math.hypot(...way) - 1) < 1e-5, project.grain);
    await expectZipOf(page, patternOf(project, products[0]), patternOfFile(project, products[0]));
    await makes(page, () => page.click('text=Remove the grain'));
    assert.equal((await savedProject(page)).grain, '');
  }));

test('one piece of a divided model gets darts', () =>
  withApp({}, async (page) => {
    await makes(page, () => drop(page, products[0]));
    const lines = [{ kind: 'shortest', points: [[-1e3, 0, 0], [0, 0, 1e3], [1e3, 0, 0]] }];
    const project = { ...(await savedProject(page)), lines };
    writeFileSync(place('cut.planish.json'), projectText(project));
    await makes(page, () => drop(page, place('cut.planish.json')));
    assert.equal(await page.locator('.pieces li').count(), 2);
    await page.selectOption('[aria-label="How much stretch panels may have"]', '1%');
    await makes(page, () => page.locator('[aria-label^="Propose darts of"]').first().click());
    const darted = await savedProject(page);
    assert.ok(darted.lines.length > 1);
    assert.equal(await page.locator('.pieces li').count(), 2);
    await expectZipOf(page, patternOf(darted, products[0]));
  }));

// The exact model follows the one of the report.
async function expectWholeProject(page) {
  await page.waitForSelector('text=drop dome.obj too');
  assert.match(await page.textContent('footer .note'), /without --map/);
  assert.equal((await savedProject(page)).allowance, '10mm');
  await makes(page, () => drop(page, products[0]));
  const project = await savedProject(page);
  const asked = { unit: 'cm', allowance: '10mm', lines: [{ kind: 'shortest', points: [[0, 0, 50], [50, 0, 0]] }] };
  for (const [key, value] of Object.entries(asked)) assert.deepEqual(project[key], value);
  await expectZipOf(page, patternOf(project, products[0]));
}

test('a report that is dropped brings its model and options along', () =>
  withApp({}, async (page) => {
    await makes(page, () => drop(page, place('out/report.html')));
    await expectWholeProject(page);
  }));

test('a report opens the app and hands its model over', async () => {
  copyFileSync(html, place('out/planish.html'));
  const { page, context, complaints } = await openPage(browser, pathToFileURL(place('out/report.html')).href, {
    offline: true,
  });
  try {
    const [app] = await Promise.all([context.waitForEvent('page'), page.click('text=Open in the app')]);
    app.on('console', (message) => complaints.push(message.text()));
    await app.waitForSelector('#app[data-made]', { timeout: 60000 });
    await expectWholeProject(app);
    assert.equal(await page.textContent('.app [role=status]'), 'The app has taken the model.');
    const project = readProject((await downloaded(page, '#project')).toString());
    assert.equal(project.model, 'dome.obj');
    assert.deepEqual(complaints, []);
  } finally {
    await context.close();
  }
});

test('a report says where it looks for the app, and gives its model to no page of the net', async () => {
  mkdirSync(place('alone'));
  copyFileSync(place('out/report.html'), place('alone/report.html'));
  const { page, context } = await openPage(browser, pathToFileURL(place('alone/report.html')).href, {});
  await context.route('https://**', (route) => route.fulfill({ contentType: 'text/html', body: thief }));
  const thief =
    '<script>const c = new MessageChannel(); c.port1.onmessage = () => (document.title = "stolen");' +
    'opener.postMessage("planish app is open", "*", [c.port2]);</script>';
  try {
    // The window that the report opened goes on to another origin.
    const [app] = await Promise.all([context.waitForEvent('page'), page.click('text=Open in the app')]);
    await app.goto('https://example.org/').catch(() => {});
    await app.waitForTimeout(500);
    assert.notEqual(await app.title(), 'stolen');
    assert.match(await page.textContent('.app [role=status]'), /The app should lie at planish\.html/);
  } finally {
    await context.close();
  }
});

test('the report of a product opens with its pieces', () => {
  planish('flatten', ...products, '--product', '--material', 'neoprene', '-o', 'both');
  assert.match(readFileSync(place('both/dome/report.html'), 'utf8'), /data-app="\.\.\/planish\.html"/);
  return withApp({}, async (page) => {
    await makes(page, () => drop(page, place('both/garment.html')));
    assert.equal(await page.locator('.pieces li').count(), 2);
    assert.deepEqual(await page.locator('.pieces input[type=text]').evaluateAll((all) => all.map(({ value }) => value)), ['dome', 'saddle']);
    assert.equal((await savedProject(page)).material, 'neoprene');
  });
});
