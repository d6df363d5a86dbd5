// The page of `planish compare` in a real browser.
//   node compare_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { readFileSync } from 'node:fs';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { pathToFileURL } from 'node:url';

import { openPage, readPage, skipUnlessThere, startBrowser, temporaryFolder } from './browser.mjs';
import { shareChanged } from './png.mjs';

const [program, modules] = process.argv.slice(2);
skipUnlessThere(modules);

const folder = temporaryFolder();
const input = join(folder, 'dome.obj');
const output = join(folder, 'out');
execFileSync(program, ['sample', 'dome', '--vertices', '800', '-o', input]);
execFileSync(program, ['compare', input, '-o', output, '--methods', 'controllable,classical,auto']);
const report = JSON.parse(readFileSync(join(output, 'compare.json'), 'utf8'));
readPage(join(output, 'compare.html'));
const url = pathToFileURL(join(output, 'compare.html')).href;

let browser;
before(async () => {
  browser = await startBrowser(modules);
});
after(() => browser?.close());

test('every result can be seen beside the input patch, the best first', async () => {
  const { page, context, complaints, requests } = await openPage(browser, url);
  await page.waitForSelector('.view[data-ready]');
  const select = page.locator('#stage select');
  assert.deepEqual(await select.locator('option').allInnerTexts(), ['controllable', 'classical', 'auto']);
  assert.equal(await select.locator('option:checked').innerText(), report.best);
  const pictures = [];
  for (const method of ['controllable', 'auto']) {
    await select.selectOption({ label: method });
    await page.waitForTimeout(80);
    assert.equal(await page.locator('.tag.after').innerText(), method);
    pictures.push(await page.locator('.view').screenshot());
  }
  assert.ok(shareChanged(...pictures) > 0.01);
  assert.deepEqual(complaints, []);
  assert.deepEqual(requests, []);
  await context.close();
});

test('it fits a phone', async () => {
  const { page, context } = await openPage(browser, url, { viewport: { width: 390, height: 844 }, isMobile: true, hasTouch: true });
  await page.waitForSelector('.view[data-ready]');
  const [inner, whole] = await page.evaluate(() => [innerWidth, document.documentElement.scrollWidth]);
  assert.ok(whole <= inner, `${whole} in ${inner}`);
  await context.close();
});
