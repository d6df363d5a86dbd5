// The page of a product in a real browser.
//   node product_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { dirname, join } from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { openPage, readPage, skipUnlessThere, startBrowser, temporaryFolder, withReadyPage } from './browser.mjs';
import { readObj } from './mesh.mjs';
import { shareChanged } from './png.mjs';

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
// Flattens; the exit code is as it should be.
function flatten(files, flags, expected) {
  const { status, stderr } = spawnSync(program, ['flatten', ...files, '--product', ...flags], { encoding: 'utf8' });
  assert.equal(status, expected, stderr);
}
flatten([pieces], ['--pick', '1', '--sheet', '600mm', '-o', output], 1); // a piece cannot be read
const url = pathToFileURL(join(output, 'garment.html')).href;

// The data that the script of a page gets, with the places of its vertices by state.
function dataOf(path) {
  const data = JSON.parse(readPage(path).split('id="report-data">')[1].split('</script>')[0]);
  const bytes = (packed) => new Uint8Array(Buffer.from(packed, 'base64')).buffer;
  const { low, step } = data.states;
  const places = data.states.positions.map((packed) => {
    const steps = new Uint16Array(bytes(packed));
    return Array.from({ length: data.vertices }, (_, v) => [0, 1, 2].map((k) => low[k] + step[k] * steps[3 * v + k]));
  });
  const seams = data.seams.map((seam) => ({ ...seam, vertices: [...new Uint32Array(bytes(seam.vertices))] }));
  return { ...data, seams, places };
}
const data = dataOf(join(output, 'garment.html'));

// The same pieces with a form that changes.
const changed = join(folder, 'changed');
const both = ['left.obj', 'right.obj'].map((name) => join(pieces, name));
flatten(both, ['--method', 'controllable', '--sweeps', '5', '-o', changed], 3);

const apartOf = (place, other) => Math.hypot(...place.map((x, k) => x - other[k]));

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

const withView = (options, run) => withReadyPage(browser, url, options, run);

async function picture(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.locator('.view').screenshot();
}

async function moveApart(page, value) {
  await page.locator('.apart input').evaluate((slider, share) => {
    slider.value = share;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }, value);
}

test('the data have every piece in its place, and both sides of its seams', () => {
  const [places] = data.places;
  assert.deepEqual(data.states.names, ['result'], 'no form was changed');
  assert.deepEqual(data.pieces.map(({ name, number }) => [name, number]), [['left', 1], ['right', 2]]);
  let first = 0;
  const lines = new Map();
  for (const { name, number, vertices } of data.pieces) {
    const mesh = readObj(join(output, name, 'processed.obj')).positions;
    assert.equal(vertices, mesh.length);
    mesh.forEach((place, v) => assert.ok(apartOf(place, places[first + v]) < 0.01, `${name} ${v}`));
    for (const seam of data.seams.filter(({ piece }) => piece === number)) {
      assert.ok(seam.vertices.every((v) => v >= first && v < first + vertices), `of ${name}`);
      lines.set(number, seam.vertices.map((v) => places[v]));
      assert.equal(seam.number, 1);
    }
    first += vertices;
  }
  const [one, two] = [lines.get(1), lines.get(2)];
  assert.equal(one.length, 9, 'the whole border between the two');
  one.forEach((place) => assert.ok(two.some((other) => apartOf(place, other) < 0.01), 'sewn together'));
});

test('the sentence over the picture has the figures of the product', () =>
  withView({}, async (page) => {
    const garment = JSON.parse(readFileSync(join(output, 'garment.json'), 'utf8'));
    const sum = await page.locator('.whole .sum').innerText();
    assert.match(sum, /^3 pieces \(1 failed\), \d+\smm of seam; moves (0|up to [\d.]+)\smm; needs [\d.]+\s% of stretch\.$/);
    const length = garment.seams.reduce((all, seam) => all + seam.length_on_model, 0);
    assert.equal(Number(sum.match(/(\d+)\smm of seam/)[1]), Number(length.toPrecision(2)));
  }));

test('the slider moves the pieces apart, by keys too, and back', () =>
  withView({}, async (page) => {
    const together = await picture(page);
    await page.locator('.apart input').focus();
    for (let i = 0; i < 30; ++i) await page.keyboard.press('ArrowRight');
    assert.equal(await page.locator('.apart input').inputValue(), '30');
    const apart = await picture(page);
    assert.ok(shareChanged(together, apart) > 0.03, 'keys');
    await moveApart(page, 100);
    assert.ok(shareChanged(apart, await picture(page)) > 0.03, 'further');
    await page.keyboard.press('Home');
    assert.equal(shareChanged(together, await picture(page)), 0);
  }));

test('pointing at a piece shows its name and its row, and a click keeps it', () =>
  withView({}, async (page) => {
    const rows = page.locator('.parts button');
    assert.deepEqual((await rows.allInnerTexts()).map((text) => text.split('\n')[0]), ['✓ left', '✓ right']);
    assert.equal(await page.locator('.parts li').count(), 3, 'the one that failed is in the list');
    await moveApart(page, 60);
    await picture(page);
    const box = await page.locator('.view').boundingBox();
    const named = new Map();
    for (let share = 0.04; share < 1; share += 0.04) {
      const at = [box.x + share * box.width, box.y + 0.5 * box.height];
      await page.mouse.move(...at);
      if (await page.locator('.view .named').isHidden()) continue;
      const name = await page.locator('.view .named b').innerText();
      named.set(name, at);
      assert.equal((await page.locator('.parts .named').innerText()).split('\n')[0], `✓ ${name}`);
      assert.match(await page.locator('.view .named').innerText(), /seam 1/);
    }
    assert.deepEqual([...named.keys()].sort(), ['left', 'right']);
    await page.mouse.click(...named.get('right'));
    await page.mouse.move(box.x + 3, box.y + 3);
    assert.deepEqual(await rows.evaluateAll((all) => all.map((row) => row.ariaPressed)), ['false', 'true']);
    assert.match(await page.locator('.pieces .marked h3').innerText(), /right/);
    assert.equal(await page.locator('.seams tr.marked').count(), 1);
    await page.keyboard.press('Escape');
    assert.deepEqual(await rows.evaluateAll((all) => all.map((row) => row.ariaPressed)), ['false', 'false']);
    assert.equal(await page.locator('.marked').count(), 0);
  }));

test('a row shows where its piece is', () =>
  withView({}, async (page) => {
    const all = await picture(page);
    const row = page.locator('.parts button', { hasText: 'left' });
    await row.focus();
    await page.keyboard.press('Enter');
    assert.equal(await page.locator('.view .named b').innerText(), 'left');
    const left = await picture(page);
    assert.ok(shareChanged(all, left) > 0.03, 'the other one fades');
    await page.keyboard.press('Enter');
    assert.equal(shareChanged(all, await picture(page)), 0);
  }));

test('either axis can point up', () =>
  withView({}, async (page) => {
    const first = await picture(page);
    await page.locator('.choice.up label', { hasText: 'z up' }).click();
    assert.ok(shareChanged(first, await picture(page)) > 0.03);
  }));

test('design and result are side by side where a piece moved', () =>
  withReadyPage(browser, pathToFileURL(join(changed, 'garment.html')).href, {}, async (page) => {
    const { states, places, pieces: parts } = dataOf(join(changed, 'garment.html'));
    assert.deepEqual(states.names, ['design', 'result']);
    const files = [(name) => join(pieces, `${name}.obj`), (name) => join(changed, name, 'processed.obj')];
    files.forEach((path, state) => {
      const all = parts.flatMap(({ name }) => readObj(path(name)).positions);
      all.forEach((place, v) => assert.ok(apartOf(place, places[state][v]) < 0.01, `${states.names[state]} ${v}`));
    });
    assert.match(await page.locator('.whole .sum').innerText(), /; moves up to [\d.]+\smm;/);
    assert.deepEqual(await page.locator('.view .tag').allInnerTexts(), ['design', 'result']);
    const beside = await picture(page);
    await page.locator('.choice.arrangement label', { hasText: 'Overlay' }).click();
    assert.ok(shareChanged(beside, await picture(page)) > 0.05);
  }));

test('without script there are a still picture, the sentence and links to the pieces', async () => {
  const { page, context } = await openPage(browser, url, { javaScriptEnabled: false });
  try {
    assert.equal(await page.locator('.whole canvas').count(), 0);
    const still = page.locator('.whole .still img');
    assert.equal(await still.isVisible(), true);
    assert.match(await page.locator('.whole .sum').innerText(), /^3 pieces/);
    const links = await page.locator('.parts a').evaluateAll((all) => all.map((a) => a.getAttribute('href')));
    assert.deepEqual(links, ['#piece-1', '#piece-2', '#piece-3']);
    for (const link of links) assert.equal(await page.locator(link).count(), 1);
  } finally {
    await context.close();
  }
});

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
  withView({ viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }, async (page) => {
    await page.locator('.parts button').first().tap();
    assert.equal(await page.locator('.view .named b').innerText(), 'left');
    const slider = await page.locator('.apart input').boundingBox();
    assert.ok(slider.width > 150 && slider.height >= 30, JSON.stringify(slider));
    const [inner, whole] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
    assert.ok(whole <= inner, `${whole} in ${inner}`);
  }));
