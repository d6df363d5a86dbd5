// Starts the browser of the system, and says what pages did in it.
import assert from 'node:assert/strict';
import { existsSync, mkdtempSync, readFileSync, rmSync } from 'node:fs';
import { createRequire } from 'node:module';
import { tmpdir } from 'node:os';
import { join, resolve } from 'node:path';

const skipped = 77; // exit code for ctest
const chromium = '/usr/bin/chromium';

export function skip(reason) {
  console.log(`skipped: ${reason}`);
  process.exit(skipped);
}

export function skipUnlessThere(modules) {
  for (const [path, what] of [
    [chromium, 'chromium'],
    [join(modules, 'playwright-core'), 'playwright-core under build/npm/browser'],
  ]) {
    if (!existsSync(path)) skip(`there is no ${what}`);
  }
}

// A page's text, with the script that is tested.
export function readPage(path) {
  const html = readFileSync(path, 'utf8');
  if (!html.includes('id="report-data"')) skip('the program was built without the script of its pages');
  return html;
}

export async function startBrowser(modules) {
  const playwright = createRequire(resolve(modules, 'none.js'))('playwright-core');
  return playwright.chromium.launch({
    executablePath: chromium,
    args: [
      '--no-sandbox',
      '--disable-quic',
      '--no-first-run',
      '--disable-background-networking',
      '--disable-component-update',
      '--disable-sync',
      '--use-gl=angle',
      '--use-angle=swiftshader',
      '--enable-unsafe-swiftshader',
    ],
  });
}

// A page with what it complained of and what it asked the network for.
export async function openPage(browser, url, options = {}) {
  const context = await browser.newContext({ viewport: { width: 1440, height: 1000 }, ...options });
  const page = await context.newPage();
  const complaints = [];
  const requests = [];
  page.on('console', (message) => {
    if (['error', 'warning'].includes(message.type())) complaints.push(message.text());
  });
  page.on('pageerror', (error) => complaints.push(String(error)));
  page.on('dialog', (dialog) => {
    complaints.push(`dialog: ${dialog.message()}`);
    dialog.dismiss();
  });
  page.on('request', (request) => {
    if (request.url() !== url && !/^(data|blob):/.test(request.url())) requests.push(request.url());
  });
  await page.goto(url);
  return { page, context, complaints, requests };
}

// Runs with a page whose view is ready and in the window; complaints and requests fail the test.
export async function withReadyPage(browser, url, options, run) {
  const { page, context, complaints, requests } = await openPage(browser, url, options);
  try {
    await page.waitForSelector('.view[data-ready]');
    await page.$eval('.view[data-ready]', (view) => view.scrollIntoView({ block: 'center' }));
    await run(page);
    assert.deepEqual(complaints, [], 'console');
    assert.deepEqual(requests, [], 'network');
  } finally {
    await context.close();
  }
}

export function temporaryFolder() {
  const folder = mkdtempSync(join(tmpdir(), 'planish-browser-'));
  process.on('exit', () => rmSync(folder, { recursive: true, force: true }));
  return folder;
}
