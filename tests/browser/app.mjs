// What tests of the app share: its page, opened as a file without network, and the program beside it.
//   node ..._page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { copyFileSync, existsSync, mkdirSync, readFileSync, writeFileSync } from 'node:fs';
import { basename, join, resolve } from 'node:path';
import { after, before } from 'node:test';
import { fileURLToPath, pathToFileURL } from 'node:url';

import { filesOf, flattenWords, modelFiles, projectText, readProject } from '../../web/app/project.js';
import { openPage, skip, skipUnlessThere, startBrowser, temporaryFolder } from './browser.mjs';

export const [program, modules] = process.argv.slice(2);
skipUnlessThere(modules);
export const html = fileURLToPath(new URL('../../build/web/planish.html', import.meta.url));
if (!existsSync(html)) skip('there is no build/web/planish.html: scripts/web makes it');

export const folder = temporaryFolder();
export const data = process.env.PLANISH_TEST_DATA ?? '';
export let browser;
before(async () => {
  browser = await startBrowser(modules);
});
after(() => browser?.close());

// Runs with the page, without network; what it complains of or asks for fails the test.
export async function withApp(options, run) {
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
export const madeSoFar = (page) => page.$eval('#app', (root) => Number(root.dataset.made ?? 0));

// Does something, and waits for the pattern that comes of it.
export async function makes(page, action) {
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

export const choose = (page, path) => page.setInputFiles('input[type=file]', path);

// Drops files onto the page as the system would.
export async function drop(page, ...paths) {
  const files = paths.map((path) => [readFileSync(path).toString('base64'), basename(path)]);
  const transfer = await page.evaluateHandle((given) => {
    const made = new DataTransfer();
    for (const [text, name] of given) {
      made.items.add(new File([Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0))], name));
    }
    return made;
  }, files);
  await page.dispatchEvent('#app', 'drop', { dataTransfer: transfer });
}

export async function downloaded(page, selector) {
  const [file] = await Promise.all([page.waitForEvent('download'), page.click(selector)]);
  return readFileSync(await file.path());
}

export async function savedProject(page) {
  return readProject((await downloaded(page, 'text=Save project')).toString());
}

// What the program writes for a project, by itself.
let runs = 0;
export function patternOf(project, models, words = flattenWords(project, 'pattern')) {
  const place = join(folder, String(++runs));
  mkdirSync(place);
  const paths = [models].flat();
  modelFiles(project).forEach(({ model }, i) => copyFileSync(paths[i], join(place, model)));
  writeFileSync(join(place, 'project.json'), projectText(project));
  if (words[1] !== 'project.json') {
    for (const [name, text] of filesOf(project)) writeFileSync(join(place, name), text);
  }
  try {
    execFileSync(resolve(program), words, { cwd: place, stdio: 'pipe' });
  } catch (error) {
    if (error.status !== 3) throw error; // written all the same
  }
  return (path) => readFileSync(join(place, 'pattern', path));
}

// What the program writes for a project's file.
export const patternOfFile = (project, models) => patternOf(project, models, ['flatten', 'project.json', '-o', 'pattern']);

// All patterns that the page gives, against what the program writes.
export async function expectZipOf(page, ...owns) {
  const zip = unzipped(await downloaded(page, '[data-download=zip]'));
  const paths = [...zip.keys()].filter((path) => /\.(svg|dxf|pdf|plt|obj|ply|off|stl)$/.test(path));
  assert.ok(paths.length > 4, String([...zip.keys()]));
  for (const own of owns) {
    for (const path of paths) assert.ok(zip.get(path).equals(own(path)), path);
  }
  return paths;
}

// Opens a project of a model that is open.
export async function openProject(page, project) {
  const file = join(folder, 'some.planish.json');
  writeFileSync(file, projectText(project));
  await makes(page, () => choose(page, file));
}

// The files of a zip that stores them as they are.
export function unzipped(bytes) {
  const files = new Map();
  for (let at = 0; bytes.readUInt32LE(at) === 0x04034b50; ) {
    const [size, name, extra] = [bytes.readUInt32LE(at + 18), bytes.readUInt16LE(at + 26), bytes.readUInt16LE(at + 28)];
    const start = at + 30 + name + extra;
    files.set(bytes.subarray(at + 30, at + 30 + name).toString(), bytes.subarray(start, start + size));
    at = start + size;
  }
  return files;
}

export async function expectPatternsOf(page, own) {
  for (const kind of ['svg', 'dxf', 'pdf', 'plt', 'obj']) {
    const name = kind === 'obj' ? 'textured.obj' : `pattern.${kind}`;
    assert.ok((await downloaded(page, `[data-download=${kind}]`)).equals(own(name)), kind);
  }
}
