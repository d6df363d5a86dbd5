// The page of a product in a real browser.
//   node product_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { mkdirSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { openPage, skipUnlessThere, startBrowser, temporaryFolder } from './browser.mjs';

const [program, modules] = process.argv.slice(2);
skipUnlessThere(modules);

// Part of a bowl: a grid of squares of 40 mm, from column `first` to column `last`.
function bowl(first, last, rows) {
  const lines = [];
  for (let i = first; i <= last; ++i) {
    for (let j = 0; j <= rows; ++j) {
      const x = 40 * i;
      const y = 40 * j;
      lines.push(`v ${x} ${y} ${0.001 * (x * x + y * y)}`);
    }
  }
  for (let i = 0; i < last - first; ++i) {
    for (let j = 0; j < rows; ++j) {
      const a = i * (rows + 1) + j + 1;
      const b = a + rows + 1;
      lines.push(`f ${a} ${b} ${b + 1}`, `f ${a} ${b + 1} ${a + 1}`);
    }
  }
  return lines.join('\n');
}

const folder = temporaryFolder();
const pieces = join(folder, 'coat');
const output = join(folder, 'out');
mkdirSync(pieces);
writeFileSync(join(pieces, 'left.obj'), bowl(0, 4, 8));
writeFileSync(join(pieces, 'right.obj'), bowl(4, 8, 8));
writeFileSync(join(pieces, 'torn.obj'), 'v 0 0 zero\n');
try {
  execFileSync(program, ['flatten', pieces, '--product', '--pick', '1', '--sheet', '600mm', '-o', output], { stdio: 'pipe' });
  assert.fail('a piece cannot be read');
} catch (error) {
  assert.equal(error.status, 1, String(error.stderr));
}
const url = pathToFileURL(join(output, 'garment.html')).href;

let browser;
before(async () => {
  browser = await startBrowser(modules);
});
after(() => browser?.close());

async function withPage(options, run) {
  const { page, context, complaints, requests } = await openPage(browser, url, options);
  try {
    await run(page);
    assert.deepEqual(complaints, [], 'console');
    assert.deepEqual(requests, [], 'network');
  } finally {
    await context.close();
  }
}

test('what is missed comes first, and is in the headline', () =>
  withPage({}, async (page) => {
    assert.match(await page.locator('.verdict').innerText(), /^1 of 3 pieces needs a look/);
    const names = await page.locator('.pieces h3').allInnerTexts();
    assert.match(names[0], /torn/);
    assert.equal(await page.locator('.pieces .lacking').count(), 1);
  }));

test('every finished piece has its surface and its outline', () =>
  withPage({}, async (page) => {
    const tiles = page.locator('.pieces > li:not(.lacking)');
    assert.equal(await tiles.count(), 2);
    const widths = await tiles.locator('img').evaluateAll((images) => images.map((image) => image.naturalWidth));
    assert.ok(widths.every((width) => width > 100), String(widths));
    for (const outline of await tiles.locator('svg.outline').all()) {
      const box = await outline.boundingBox();
      assert.ok(box.width > 60 && box.height > 60, JSON.stringify(box));
    }
  }));

test('a seam has one colour and one number on both sides and in the table', () =>
  withPage({}, async (page) => {
    const sides = await page
      .locator('.outline g:has(text)')
      .evaluateAll((groups) => groups.map((group) => [group.textContent, getComputedStyle(group.querySelector('text')).fill]));
    assert.equal(sides.length, 2, 'one seam, two sides');
    assert.deepEqual(sides[0], sides[1]);
    const swatch = page.locator('.seams .swatch polyline');
    assert.equal(await swatch.evaluate((line) => getComputedStyle(line).stroke), sides[0][1]);
    assert.match(await page.locator('.seams .sewn').nth(1).innerText(), /left – right/);
  }));

test('the sheet shows where the pieces lie', () =>
  withPage({}, async (page) => {
    const sheet = page.locator('svg.sheet');
    const frame = await sheet.boundingBox();
    const cuts = await sheet.locator('g[id$="cut"] path').all();
    assert.equal(cuts.length, 2);
    for (const cut of cuts) {
      const box = await cut.boundingBox();
      assert.ok(box.width > 20 && box.height > 20, JSON.stringify(box));
      assert.ok(box.x >= frame.x && box.x + box.width <= frame.x + frame.width);
    }
  }));

test('each piece links to its own report', () =>
  withPage({}, async (page) => {
    const links = await page.locator('.pieces a').evaluateAll((all) => all.map((a) => a.href));
    assert.equal(links.length, 2);
    for (const link of links) assert.equal(dirname(dirname(fileURLToPath(link))), output);
  }));

test('it is dark where the reader asks for that', () =>
  withPage({ colorScheme: 'dark' }, async (page) => {
    const [red] = await page.evaluate(() => getComputedStyle(document.body).backgroundColor.match(/\d+/g).map(Number));
    assert.ok(red < 60, String(red));
  }));

test('it fits a phone', () =>
  withPage({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }, async (page) => {
    const [inner, whole] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
    assert.ok(whole <= inner, `${whole} in ${inner}`);
  }));
