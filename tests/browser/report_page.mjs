// The page of `planish flatten` in a real browser.
//   node report_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync, statSync } from 'node:fs';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

import { openPage, withReadyPage, readPage, skipUnlessThere, startBrowser, temporaryFolder } from './browser.mjs';
import { angleDefect, distance, readObj } from './mesh.mjs';
import { shareChanged } from './png.mjs';

const [program, modules] = process.argv.slice(2);
skipUnlessThere(modules);

const folder = temporaryFolder();
const hostile = '<img src=x onerror=alert(1)>';
const input = join(folder, `${hostile}.obj`);
const output = join(folder, 'out');
execFileSync(program, ['sample', 'panel', '--vertices', '3000', '-o', input]);
const flags = ['--max-strain', '2%', '--allowance', '10mm', '--grain', '0,0,1', '--sheet', '1500mm'];
execFileSync(program, ['flatten', input, '-o', output, ...flags]);
const url = pathToFileURL(join(output, 'report.html')).href;
readPage(join(output, 'report.html'));
const report = JSON.parse(readFileSync(join(output, 'report.json'), 'utf8'));

let browser;
before(async () => {
  browser = await startBrowser(modules);
});
after(() => browser?.close());

const withPage = (options, run) => withReadyPage(browser, url, options, run);

const picture = (page) => page.locator('.view').screenshot();
const readout = (page, figure, state) =>
  page.locator(`.readout [data-figure="${figure}"]${state ? `[data-state="${state}"]` : ''}`).innerText();
const vertexShown = async (page) => Number((await readout(page, 'vertex')).replace(/\D/g, ''));
const number = (text) => {
  const [, sign, digits, power] = text.match(/^([+−]?)([\d.]+)(?:\s×\s10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+))?/);
  const exponent = (power ?? '⁰').replace('⁻', '-').replace(/[⁰¹²³⁴⁵⁶⁷⁸⁹]/g, (d) => '⁰¹²³⁴⁵⁶⁷⁸⁹'.indexOf(d));
  return (sign === '−' ? -1 : 1) * Number(digits) * 10 ** Number(exponent);
};

async function hoverAt(page, selector, right, down) {
  const box = await page.locator(selector).boundingBox();
  await page.mouse.move(box.x + right * box.width, box.y + down * box.height);
}

async function setSplit(page, value) {
  await page.locator('.choice label', { hasText: 'Slider' }).click();
  await page.locator('input.split').evaluate((slider, share) => {
    slider.value = share;
    slider.dispatchEvent(new Event('input', { bubbles: true }));
  }, value);
  await page.waitForTimeout(60);
}

test('opens at once, asks nobody for anything and complains of nothing', async () => {
  await withPage({}, async (page) => {
    assert.equal(await page.locator('.still').isVisible(), false);
    assert.equal(await page.locator('canvas').isVisible(), true);
  });
  assert.ok(statSync(join(output, 'report.html')).size < 10e6);
});

test('a hostile name is text', async () => {
  await withPage({}, async (page) => {
    assert.equal(await page.locator('h1').innerText(), hostile);
    assert.equal(await page.locator('img[src="x"]').count(), 0);
    await page.locator('summary', { hasText: 'How it was computed' }).click();
    assert.match(await page.locator('.run code').innerText(), /planish flatten ".*<img src=x onerror=alert\(1\)>\.obj"/);
  });
});

test('the slider shows more of before or after', async () => {
  await withPage({}, async (page) => {
    await setSplit(page, 100);
    const wholeBefore = await picture(page);
    await setSplit(page, 0);
    const wholeAfter = await picture(page);
    assert.ok(shareChanged(wholeBefore, wholeAfter) > 0.02);
    await page.locator('input.split').focus();
    const box = await page.locator('.view').boundingBox();
    await page.mouse.move(box.x + 2, box.y + box.height - 40);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.3 * box.width, box.y + box.height - 40, { steps: 5 });
    await page.mouse.up();
    assert.ok(Math.abs((await page.locator('input.split').inputValue()) - 30) <= 2);
  });
});

test('every figure colours the patch in its own way, and says what its scale means', async () => {
  await withPage({}, async (page) => {
    const pictures = [];
    const labels = new Set();
    const buttons = page.locator('.choice.figure label');
    const figures = await page.locator('.choice.figure input').evaluateAll((list) => list.map(({ value }) => value));
    const ofPaper = ['bent', 'defect', 'curvature'];
    assert.deepEqual(figures, ['form', 'offset', 'limit_used', 'strain', 'deviation', ...ofPaper, 'longest', 'shortest']);
    const count = figures.length;
    for (let i = 0; i < count; ++i) {
      await buttons.nth(i).click();
      await page.waitForTimeout(60);
      pictures.push(await picture(page));
      if (figures[i] === 'form') assert.equal(await page.locator('.scale').isVisible(), false);
      else labels.add(await page.locator('.scale .labels').innerText());
    }
    assert.equal(labels.size, count - 3, 'the three ways to show stretch have one scale, the form has none');
    for (let i = 0; i < count; ++i) {
      for (let j = 0; j < i; ++j) assert.ok(shareChanged(pictures[i], pictures[j]) > 0.05, `${i} ${j}`);
    }
    const last = await picture(page);
    await page.locator('.scale button').last().click();
    await page.waitForTimeout(60);
    assert.ok(shareChanged(last, await picture(page)) > 0.01, 'a finer scale');
  });
});

test('hovering tells the figures of a vertex and marks it on the pattern', async () => {
  const [patch, processed, flat] = [input, join(output, 'processed.obj'), join(output, 'flat.obj')].map(readObj);
  await withPage({}, async (page) => {
    const seen = [];
    for (const [right, down] of [[0.75, 0.5], [0.24, 0.45], [0.7, 0.56]]) {
      await hoverAt(page, '.view', right, down);
      const vertex = await vertexShown(page);
      assert.ok(vertex >= 0 && vertex < patch.positions.length);
      const figures = [
        ['defect', 'before', angleDefect(patch, vertex)],
        ['defect', 'after', angleDefect(processed, vertex)],
        ['deviation', 'after', distance(patch.positions[vertex], processed.positions[vertex])],
      ];
      for (const [figure, state, expected] of figures) {
        const shown = number(await readout(page, figure, state));
        // Float32, and digits as written.
        const bound = 0.051 * Math.abs(expected) + 1e-9;
        assert.ok(Math.abs(shown - expected) <= bound, `${figure} ${state}: ${shown}, not ${expected}`);
      }
      const mark = page.locator('.mark .ring');
      assert.equal(await page.locator('.mark').getAttribute('visibility'), 'visible');
      assert.equal(await page.locator('.spot').isVisible(), true);
      seen.push({ vertex, at: [await mark.getAttribute('cx'), await mark.getAttribute('cy')].map(Number) });
    }
    for (let i = 1; i < seen.length; ++i) {
      const expected = distance(flat.positions[seen[i].vertex], flat.positions[seen[0].vertex]);
      assert.ok(Math.abs(distance(seen[i].at, seen[0].at) - expected) < 0.02, 'true to scale');
    }
    // And back: on the mark, the same vertex is meant.
    const ring = await page.locator('.mark .ring').boundingBox();
    await page.mouse.move(ring.x + ring.width / 2, ring.y + ring.height / 2);
    assert.equal(await vertexShown(page), seen.at(-1).vertex);
    assert.equal(await page.locator('.spot').isVisible(), true);
  });
});

test('a click keeps a place, Escape lets it go, and the worst place is one click away', async () => {
  await withPage({}, async (page) => {
    await page.locator('.choice label', { hasText: 'Dome or saddle' }).click();
    await page.getByRole('button', { name: 'Worst place' }).click();
    const worst = number(await readout(page, 'defect', 'after'));
    assert.ok(Math.abs(Math.abs(worst) - report.evolve.after.e_max) <= 0.01 * report.evolve.after.e_max);
    await page.keyboard.press('Escape');
    assert.equal(await page.locator('.readout.empty').count(), 1);
    await hoverAt(page, '.view', 0.75, 0.5);
    await page.mouse.down();
    await page.mouse.up();
    const vertex = await vertexShown(page);
    await page.mouse.move(5, 5);
    assert.equal(await vertexShown(page), vertex);
  });
});

test('the worst place of the stretch is an end of the edge that is stretched most', async () => {
  await withPage({}, async (page) => {
    await page.locator('.choice label', { hasText: 'Stretch' }).click();
    await page.getByRole('button', { name: 'Worst place' }).click();
    const { max } = report.unfold.strain;
    const shown = 0.01 * number(await readout(page, 'edge_strain', 'after'));
    assert.ok(Math.abs(Math.abs(shown) - max) <= 0.051 * max, `${shown}, not ${max}`);
  });
});

test('everything can be done by keys', async () => {
  await withPage({}, async (page) => {
    const active = () => page.evaluate(() => document.activeElement.className || document.activeElement.tagName);
    const reach = async (name) => {
      for (let i = 0; i < 30 && (await active()) !== name; ++i) await page.keyboard.press('Tab');
      assert.equal(await active(), name);
    };
    await page.locator('body').press('Tab');
    assert.equal(await page.evaluate(() => document.activeElement.tagName !== 'BODY'), true);
    await reach('CANVAS');
    const home = await picture(page);
    for (let i = 0; i < 4; ++i) await page.keyboard.press('ArrowLeft');
    await page.waitForTimeout(60);
    const turned = await picture(page);
    assert.ok(shareChanged(home, turned) > 0.02, 'turned');
    await page.keyboard.press('0');
    await page.waitForTimeout(60);
    assert.ok(shareChanged(home, await picture(page)) < 0.001, 'reset');
    await page.locator('.choice.arrangement input').first().focus();
    for (let i = 0; i < 2; ++i) await page.keyboard.press('ArrowRight');
    assert.equal(await page.locator('.view').getAttribute('data-arrangement'), 'split');
    await reach('split');
    await page.keyboard.press('ArrowRight');
    await page.keyboard.press('ArrowRight');
    assert.equal(await page.locator('input.split').inputValue(), '52');
    await page.locator('.choice.figure input').first().focus();
    await page.keyboard.press('ArrowRight');
    assert.equal(await page.locator('.choice.figure input:checked').inputValue(), 'offset');
  });
});

test('dragging turns the patch, layers of the pattern can be hidden', async () => {
  await withPage({}, async (page) => {
    const home = await picture(page);
    const box = await page.locator('.view').boundingBox();
    await hoverAt(page, '.view', 0.25, 0.5);
    await page.mouse.down();
    await page.mouse.move(box.x + 0.25 * box.width + 90, box.y + 0.5 * box.height + 40, { steps: 4 });
    await page.mouse.up();
    await page.waitForTimeout(60);
    assert.ok(shareChanged(home, await picture(page)) > 0.02);
    for (const layer of ['cut', 'seam', 'grain', 'strain', 'directions']) {
      const shown = () => page.locator(`svg.pattern #${layer}`).evaluate((g) => getComputedStyle(g).display);
      assert.notEqual(await shown(), 'none', layer);
      await page.locator(`.lines li[data-layer="${layer}"] input`).uncheck();
      assert.equal(await shown(), 'none', layer);
    }
  });
});

// Rows of the table with what report.json has for them: before, after.
function expectedRows() {
  const { evolve, unfold, as_designed: first } = report;
  const degrees = 180 / Math.PI;
  const both = (pick) => [pick(evolve.before), pick(evolve.after)];
  return {
    'Largest angle defect': both((m) => m.e_max),
    'Mean angle defect': both((m) => m.e_avg),
    Energy: both((m) => m.energy),
    'Curvature left': both((m) => m.sum_abs_defect),
    'Smallest angle': both((m) => m.min_angle * degrees),
    Bending: both((m) => m.bending),
    "Bending over the design's": [evolve.bending_ratio],
    'Bending added': [evolve.bending_added],
    'Bending lost': [evolve.bending_lost],
    'Sharply bent': [evolve.after.sharp_share],
    'Mean curvature': both((m) => m.mean_curvature),
    'Ruling defect': both((m) => m.ruling_defect),
    'Turn of the surface': [evolve.normal_turn],
    'Turn along the border': [evolve.border_turn],
    Crossings: both((m) => m.self_intersections),
    'Strain, rms': [first.strain.rms, unfold.strain.rms],
    'Strain, 99 % of the area': [first.strain.p99, unfold.strain.p99],
    'Strain, worst edge': [first.strain.max, unfold.strain.max],
    'Pattern size': [first.width, first.height, unfold.width, unfold.height],
    'Area ratio': [first.area_ratio, unfold.area_ratio],
    'Flipped triangles': [first.flipped_triangles, unfold.flipped_triangles],
    Overlap: [Number(first.overlaps), Number(unfold.overlaps)],
    'Deviation, rms': [evolve.deviation.rms],
    'Deviation, rms over size': [evolve.deviation.rms_over_diagonal],
    'Deviation, largest': [evolve.deviation.max],
    'Deviation, largest over size': null,
  };
}

test('the numbers on the page are those of report.json', async () => {
  const expected = expectedRows();
  await withPage({}, async (page) => {
    const rows = await page.locator('tr:has(data)').evaluateAll((list) =>
      list.map((row) => [
        row.querySelector('th').firstChild.textContent,
        [...row.querySelectorAll('data')].map((data) => Number(data.value)),
      ]),
    );
    assert.deepEqual(rows.map(([name]) => name).sort(), Object.keys(expected).sort());
    for (const [name, numbers] of rows) {
      if (expected[name] === null) continue;
      numbers.forEach((value, i) => {
        const want = expected[name][i];
        assert.ok(Math.abs(value - want) <= 1e-15 * Math.abs(want), `${name}: ${value}, not ${want}`);
      });
      assert.equal(numbers.length, expected[name].length, name);
    }
    const percent = (share) => (100 * share).toPrecision(2);
    assert.match(await page.locator('.tiles').innerText(), new RegExp(percent(report.unfold.strain.max).replace('.', '\\.')));
    assert.match(await page.locator('.tiles').innerText(), /✓ at most 2\.0\s%|✗ at most 2\.0\s%/);
    assert.match(await page.locator('.tiles').innerText(), /✓ fits a roll of width 1500/);
  });
});

// Of the text over the ground, as WCAG has it.
const contrasts = (page) =>
  page.evaluate(() => {
    const rgb = (text) => text.match(/[\d.]+/g).map(Number);
    const light = ([r, g, b]) => {
      const [x, y, z] = [r, g, b].map((c) => (c / 255 <= 0.04045 ? c / 255 / 12.92 : ((c / 255 + 0.055) / 1.055) ** 2.4));
      return 0.2126 * x + 0.7152 * y + 0.0722 * z;
    };
    const ground = (element) => {
      const color = rgb(getComputedStyle(element).backgroundColor);
      return color.length === 4 && color[3] === 0 && element.parentElement ? ground(element.parentElement) : color;
    };
    return [...document.querySelectorAll('h1, h2, h3, p, small, td, th, dt, dd, summary, .choice span, .toggle, .met, .missed, .neutral, .labels span')]
      .filter((element) => element.offsetParent)
      .map((element) => {
        const [a, b] = [light(rgb(getComputedStyle(element).color)), light(ground(element))];
        return { text: element.innerText.slice(0, 40), ratio: (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05) };
      });
  });

for (const colorScheme of ['light', 'dark']) {
  test(`text stands out in ${colorScheme} mode`, async () => {
    await withPage({ colorScheme }, async (page) => {
      const body = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      const ground = Number(body.match(/\d+/)[0]);
      assert.ok(colorScheme === 'dark' ? ground < 60 : ground > 200, body);
      for (const summary of await page.locator('main > details > summary').all()) await summary.click();
      for (const { text, ratio } of await contrasts(page)) assert.ok(ratio >= 4.5, `${text}: ${ratio}`);
    });
  });
}

test('a phone shows it without scrolling sideways, all in reach of a thumb', async () => {
  const phone = { viewport: { width: 390, height: 844 }, deviceScaleFactor: 3, hasTouch: true, isMobile: true };
  await withPage(phone, async (page) => {
    const [inner, whole] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
    assert.ok(whole <= inner, `${whole} in ${inner}`);
    await page.locator('.choice label', { hasText: 'Offset' }).click();
    for (const button of await page.locator('#stage button').all()) {
      assert.ok((await button.boundingBox()).height >= 36);
    }
    const box = await page.locator('.view').boundingBox();
    await page.touchscreen.tap(box.x + 0.5 * box.width, box.y + 0.75 * box.height);
    assert.ok((await vertexShown(page)) >= 0);
  });
});

test('paper gets still pictures', async () => {
  await withPage({}, async (page) => {
    await page.emulateMedia({ media: 'print' });
    assert.equal(await page.locator('#stage').isVisible(), false);
    assert.equal(await page.locator('.still img').first().isVisible(), true);
    assert.equal(await page.locator('.still img').nth(1).isVisible(), true);
    const pdf = await page.pdf({ format: 'A4', printBackground: false });
    const pages = pdf.toString('latin1').match(/\/Type\s*\/Page\b/g).length;
    assert.ok(pages >= 1 && pages <= 5, `${pages} pages`);
  });
});

test('without scripts it is whole too', async () => {
  const { page, context, complaints } = await openPage(browser, url, { javaScriptEnabled: false });
  assert.equal(await page.locator('.still img').first().isVisible(), true);
  assert.equal(await page.locator('svg.pattern').isVisible(), true);
  assert.deepEqual(complaints, []);
  await context.close();
});
