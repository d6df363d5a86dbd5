// The first screen of the page of `planish flatten`: what became of the form.
//   node form_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

import { openPage, withReadyPage, readPage, skipUnlessThere, startBrowser, temporaryFolder } from './browser.mjs';
import { readObj } from './mesh.mjs';
import { decodePng, shareChanged } from './png.mjs';

const [program, modules] = process.argv.slice(2);
skipUnlessThere(modules);

const folder = temporaryFolder();
const input = join(folder, 'panel.obj');
const output = join(folder, 'out');
execFileSync(program, ['sample', 'panel', '--vertices', '1500', '-o', input]);
execFileSync(program, ['flatten', input, '--pick', '5', '-o', output]);
const path = join(output, 'report.html');
readPage(path);
const url = pathToFileURL(path).href;
const report = JSON.parse(readFileSync(join(output, 'report.json'), 'utf8'));

let browser;
before(async () => {
  browser = await startBrowser(modules);
});
after(() => browser?.close());

const desktop = { viewport: { width: 1280, height: 800 } };
const phone = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 2, hasTouch: true, isMobile: true };
const withPage = (options, run) => withReadyPage(browser, url, options, run);
const choose = (page, text) => page.locator('.choice label', { hasText: text }).click();

async function picture(page) {
  await page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))));
  return page.locator('.view').screenshot();
}

// The share of the pixels of a picture, in a part of its width and height, for which something holds.
function share(png, holds, [left, right] = [0, 1], [top, bottom] = [0, 1]) {
  const { width, height, channels, pixels } = decodePng(png);
  let count = 0;
  let all = 0;
  for (let y = Math.floor(top * height); y < bottom * height; ++y) {
    for (let x = Math.floor(left * width); x < right * width; ++x, ++all) {
      const at = channels * (y * width + x);
      count += holds(...pixels.subarray(at, at + 3));
    }
  }
  return count / all;
}
const isColored = (red, green, blue) => Math.max(red, green, blue) - Math.min(red, green, blue) > 60;
const isBlue = (red, green, blue) => blue > red + 40;
const isDark = (red, green, blue) => Math.max(red, green, blue) < 60;

for (const [name, options] of Object.entries({ desktop, phone })) {
  for (const colorScheme of ['light', 'dark']) {
    test(`design and result are shown first, plain and whole, on a ${name} in ${colorScheme} mode`, async () => {
      await withPage({ ...options, colorScheme }, async (page) => {
        assert.equal(await page.locator('.choice.figure input:checked').inputValue(), 'form');
        assert.equal(await page.locator('.choice.arrangement input:checked').inputValue(), 'beside');
        assert.equal(await page.locator('.scale').isVisible(), false);
        const png = await picture(page);
        assert.ok(share(png, isColored) < 0.002, 'no colours');
        const isStacked = await page.locator('.view.stacked').count();
        for (const half of [[0, 0.5], [0.5, 1]]) {
          const part = isStacked ? [[0, 1], half] : [half, [0, 1]];
          const { width, height, channels, pixels } = decodePng(png);
          // The ground is what the middle of the lower edge has.
          const ground = [...pixels.subarray(channels * (width * (height - 6) + 8)).subarray(0, 3)];
          const isPatch = (...rgb) => rgb.some((value, i) => Math.abs(value - ground[i]) > 12);
          assert.ok(share(png, isPatch, ...part) > 0.3, 'it fills its window');
        }
        const [inner, whole] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
        assert.ok(whole <= inner, `${whole} in ${inner}`);
      });
    });
  }
}

test('both turn together, and a place is marked in both', async () => {
  await withPage(desktop, async (page) => {
    const box = await page.locator('.view').boundingBox();
    await page.locator('canvas').focus();
    for (let i = 0; i < 3; ++i) await page.keyboard.press('ArrowLeft');
    const turned = await picture(page);
    await page.keyboard.press('0');
    const home = await picture(page);
    const { width, height, channels, pixels } = decodePng(home);
    const other = decodePng(turned).pixels;
    for (const [from, to] of [[0, 0.5], [0.5, 1]]) {
      let changed = 0;
      for (let y = 0; y < height; ++y) {
        for (let x = Math.floor(from * width); x < to * width; ++x) {
          const at = channels * (y * width + x);
          changed += Math.abs(pixels[at] - other[at]) > 12;
        }
      }
      assert.ok(changed / (0.5 * width * height) > 0.02);
    }
    await page.mouse.move(box.x + 0.75 * box.width, box.y + 0.5 * box.height);
    const places = [];
    for (const spot of ['.spot', '.spot-before']) {
      assert.equal(await page.locator(spot).isVisible(), true, spot);
      const at = await page.locator(spot).boundingBox();
      places.push([at.x + at.width / 2 - box.x, at.y + at.height / 2 - box.y]);
    }
    assert.ok(Math.abs(places[0][0] - places[1][0] - box.width / 2) < 0.1 * box.width, 'the same place of each half');
  });
});

test('zebra stripes come and go', async () => {
  await withPage(desktop, async (page) => {
    const plain = await picture(page);
    await page.getByLabel('Zebra stripes').check();
    const striped = await picture(page);
    for (const half of [[0, 0.5], [0.5, 1]])
      assert.ok(share(striped, isDark, half) > share(plain, isDark, half) + 0.08, 'dark stripes on both');
    await page.getByLabel('Zebra stripes').uncheck();
    assert.ok(shareChanged(plain, await picture(page)) < 0.001);
  });
});

test('the overlay has the result solid and the design blue, with its contour', async () => {
  await withPage(desktop, async (page) => {
    const beside = await picture(page);
    await choose(page, 'Overlay');
    const overlay = await picture(page);
    assert.ok(share(overlay, isBlue, [0.2, 0.8]) > 0.02, 'the design is seen');
    assert.ok(share(overlay, isColored) < 0.9);
    assert.equal(await page.locator('input.split').isVisible(), false);
    assert.match(await page.locator('.tag.before').innerText(), /before/);
    const box = await page.locator('.view').boundingBox();
    await page.mouse.move(box.x + 0.5 * box.width, box.y + 0.5 * box.height);
    assert.equal(await page.locator('.spot').isVisible(), true);
    await page.mouse.move(5, 5);
    await choose(page, 'Side by side');
    assert.ok(shareChanged(beside, await picture(page)) < 0.001);
  });
});

test('offsets have a sign, a scale that fits and a legend in the unit of the model', async () => {
  const [design, result] = [input, join(output, 'processed.obj')].map(readObj);
  const moves = design.positions.map((p, v) => Math.hypot(...p.map((x, i) => result.positions[v][i] - x)));
  await withPage(desktop, async (page) => {
    await choose(page, 'Offset');
    assert.ok(share(await picture(page), isColored) > 0.02);
    const labels = await page.locator('.scale .labels span').allInnerTexts();
    assert.match(labels[0], /^inwards −[\d.]+ mm$/);
    assert.match(labels[2], /^outwards \+[\d.]+ mm$/);
    const end = Number(labels[2].match(/[\d.]+/)[0]);
    assert.ok(end <= 1.06 * Math.max(...moves), `${end}: no offset is more than the longest move`);
    await page.getByRole('button', { name: 'Worst place' }).click();
    const text = await page.locator('.readout [data-figure="offset"][data-state="after"]').innerText();
    assert.match(text, /^[+−][\d.]+ mm, (out|in)wards$/);
    const worst = Number(text.match(/[\d.]+/)[0]);
    assert.ok(worst <= 1.06 * end && worst >= 0.9 * end, `${worst} of ${end}`);
  });
});

test('the first screen needs no term of the paper; these are one click away', async () => {
  await withPage(desktop, async (page) => {
    const top = await page.locator('header').innerText();
    assert.doesNotMatch(top, /sweep|energy|e_max|face down|defect|vertex/i);
    const chart = page.getByRole('heading', { name: 'How it went, sweep by sweep' });
    assert.equal(await chart.isVisible(), false);
    await page.locator('summary', { hasText: 'How it was computed' }).click();
    assert.equal(await chart.isVisible(), true);
    assert.match(await page.locator('.computed').innerText(), /energy/);
    const view = await page.locator('.view').boundingBox();
    assert.ok(view.y < 500, `the forms begin on the first screen: ${view.y}`);
    assert.equal(await page.locator('.checks .missed').count() > 0, !report.evolve.smooth || !report.evolve.form_kept);
  });
});

test('without scripts there are still pictures', async () => {
  const { page, context, complaints } = await openPage(browser, url, { javaScriptEnabled: false });
  assert.equal(await page.locator('.still img').count(), 2);
  assert.equal(await page.locator('.still img').first().isVisible(), true);
  assert.deepEqual(complaints, []);
  await context.close();
});
