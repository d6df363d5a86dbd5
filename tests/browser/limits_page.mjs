// The page of `planish flatten` with a limit of strain, in a real browser, beside one without.
//   node limits_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { spawnSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

import { withReadyPage, readPage, skipUnlessThere, startBrowser, temporaryFolder } from './browser.mjs';
import { readObj } from './mesh.mjs';
import { decodePng } from './png.mjs';

const [program, modules] = process.argv.slice(2);
skipUnlessThere(modules);

const folder = temporaryFolder();
const input = join(folder, 'dome.obj');
spawnSync(program, ['sample', 'dome', '--vertices', '800', '-o', input]);

// What `flatten` makes of the dome; exit code 3 says that the limit is not kept.
function flatten(name, code, ...flags) {
  const output = join(folder, name);
  assert.equal(spawnSync(program, ['flatten', input, '-o', output, ...flags]).status, code, name);
  const path = join(output, 'report.html');
  readPage(path);
  return {
    url: pathToFileURL(path).href,
    report: JSON.parse(readFileSync(join(output, 'report.json'), 'utf8')),
    patch: readObj(join(output, 'processed.obj')),
    pattern: readObj(join(output, 'flat.obj')),
  };
}

const asked = 0.05;
const kept = flatten('kept', 0, '--max-strain', '5%', '--prefer', 'near');
const missed = flatten('missed', 3, '--max-strain', '5%', '--sweeps', '1', '--prefer', 'near');
const without = flatten('without', 0, '--prefer', 'near');

let browser;
before(async () => {
  browser = await startBrowser(modules);
});
after(() => browser?.close());

const withPage = ({ url }, options, run) => withReadyPage(browser, url, options, run);

const readout = (page, figure, state) =>
  page.locator(`.readout [data-figure="${figure}"][data-state="${state}"]`).innerText();
const percent = (text) => (text === 'none' ? 0 : Number(text.match(/^[+−]?[\d.]+/)[0].replace('−', '-')));

// The share of the picture that is in the colour of what is beyond, in any light.
async function shareBeyond(page, split) {
  await page.locator('.choice label', { hasText: 'Limit used up' }).click();
  await page.locator('.choice label', { hasText: 'Slider' }).click();
  await page.locator('input.split').evaluate((slider, share) => {
    slider.value = share;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }, split);
  await page.waitForTimeout(80);
  const { width, height, channels, pixels } = decodePng(await page.locator('.view').screenshot());
  let count = 0;
  for (let i = 0; i < pixels.length; i += channels) {
    const [red, green, blue] = pixels.subarray(i, i + 3);
    if (red > 100 && green < 0.5 * red && blue < 0.25 * red) ++count;
  }
  return count / (width * height);
}

test('how much of the limit is used up is one click away, with a scale that ends at the limit', async () => {
  await withPage(kept, {}, async (page) => {
    await page.locator('.choice label', { hasText: 'Limit used up' }).click();
    const labels = await page.locator('.scale .labels span').allInnerTexts();
    assert.deepEqual(labels, ['0', '50 % used up', '100 %, limit of 5 %', 'beyond']);
    assert.equal(await page.getByRole('button', { name: 'Finer scale' }).isVisible(), false);
    assert.deepEqual(await page.locator('.flat .legend span').allInnerTexts(), ['0', '50\u00a0%', '100\u00a0%', 'beyond']);
    assert.match(await page.locator('.flat .note').innerText(), /limit of strain \(5 %, for every edge\)/);
    await page.locator('.choice label', { hasText: 'Stretch' }).click();
    assert.equal(await page.getByRole('button', { name: 'Finer scale' }).isVisible(), true);
    assert.equal(await page.locator('.scale .labels span').count(), 3);
  });
});

test('what is beyond the limit has a colour of its own, and only that', async () => {
  await withPage(kept, {}, async (page) => {
    assert.ok(kept.report.unfold_before.strain.max > asked);
    assert.ok((await shareBeyond(page, 100)) > 0.01, 'before');
    assert.equal(await shareBeyond(page, 0), 0, 'after');
  });
  await withPage(missed, {}, async (page) => {
    assert.ok((await shareBeyond(page, 0)) > 0.01);
  });
});

test('the worst place has the strain of the worst edge over the limit', async () => {
  for (const result of [kept, missed]) {
    await withPage(result, {}, async (page) => {
      await page.locator('.choice label', { hasText: 'Limit used up' }).click();
      await page.getByRole('button', { name: 'Worst place' }).click();
      const text = await readout(page, 'limit_used', 'after');
      const used = (100 * result.report.unfold.strain.max) / asked;
      assert.ok(Math.abs(percent(text) - used) <= Math.max(0.051 * used, 0.51), `${text}, not ${used}`);
      assert.equal(/beyond the limit/.test(text), result === missed);
    });
  }
});

// The singular values of the map of a triangle to the pattern, minus 1: the roots of the
// characteristic polynomial of both metrics.
function principal(triangle, patch, pattern) {
  const metric = (positions) => {
    const [a, b, c] = triangle.map((vertex) => positions[vertex]);
    const [u, v] = [b, c].map((p) => p.map((x, i) => x - a[i]));
    const dot = (p, q) => p.reduce((sum, x, i) => sum + x * q[i], 0);
    return [dot(u, u), dot(u, v), dot(v, v)];
  };
  const [a, b, c] = metric(patch.positions);
  const [e, f, g] = metric(pattern.positions);
  const area = a * c - b * b;
  const half = (a * g - 2 * b * f + c * e) / (2 * area);
  const root = Math.sqrt(Math.max(0, half * half - (e * g - f * f) / area));
  return [Math.sqrt(half + root) - 1, Math.sqrt(half - root) - 1];
}

test('a place tells how much longer and shorter the pattern is there, each way', async () => {
  await withPage(kept, {}, async (page) => {
    const { patch, pattern } = kept;
    const box = await page.locator('.view').boundingBox();
    for (const [right, down] of [[0.75, 0.5], [0.7, 0.55], [0.8, 0.45]]) {
      await page.mouse.move(box.x + right * box.width, box.y + down * box.height);
      const vertex = Number((await page.locator('.readout [data-figure="vertex"]').innerText()).replace(/\D/g, ''));
      const around = patch.triangles.filter((triangle) => triangle.includes(vertex));
      for (const [i, figure] of ['longest', 'shortest'].entries()) {
        const mean = around.reduce((sum, triangle) => sum + principal(triangle, patch, pattern)[i], 0) / around.length;
        const text = await readout(page, figure, 'after');
        assert.ok(Math.abs(percent(text) - 100 * mean) <= 0.051 * Math.abs(100 * mean) + 1e-4, `${figure} ${text}, not ${mean}`);
        assert.match(text, mean > 0 ? /longer/ : /shorter/);
      }
    }
  });
});

test('it fits a phone', async () => {
  await withPage(kept, { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true }, async (page) => {
    const [inner, whole] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
    assert.ok(whole <= inner, `${whole} in ${inner}`);
  });
});

test('without a limit all is as it was', async () => {
  await withPage(without, {}, async (page) => {
    const figures = await page.locator('.choice.figure input').evaluateAll((list) => list.map(({ value }) => value));
    assert.deepEqual(figures, ['form', 'offset', 'strain', 'deviation', 'bent', 'defect', 'curvature']);
    assert.equal(await page.locator('.readout tbody tr').count(), 7);
    assert.equal(await page.locator('.bounded').count(), 0);
    // One scale for the patch and its pattern.
    await page.locator('.choice label', { hasText: 'Stretch' }).click();
    const end = (text) => Number(text.match(/([\d.]+)\s%/)[1]);
    const scale = end(await page.locator('.scale .labels span').last().innerText());
    assert.equal(scale, end(await page.locator('.flat .legend span').last().innerText()));
  });
});
