// The program as it runs in the browser, from the command line: files of the current folder, and those that words
// name, are put into the module's memory, and what the program wrote there is put into the folder.
//   node planish.mjs MODULE.js VERB ...
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';

const [script, ...words] = process.argv.slice(2);
const wasmBinary = readFileSync(script.replace(/js$/, 'wasm'));
const module = await createRequire(import.meta.url)(resolve(script))({ wasmBinary });
const { FS } = module;
FS.writeFile('/page_script', readFileSync(join(dirname(script), '../../generated/page_script.txt')));
const here = process.cwd();

/** Of files that were put in: their content. @type {Map<string, Uint8Array>} */
const put = new Map();

/** @param {string} path */
function putIn(path) {
  if (put.has(path)) return;
  const bytes = readFileSync(path);
  FS.mkdirTree(dirname(path));
  FS.writeFile(path, bytes);
  put.set(path, bytes);
}

/** @param {string} path */
function takeOut(path) {
  for (const name of FS.readdir(path)) {
    if (name === '.' || name === '..') continue;
    const inside = join(path, name);
    if (FS.isDir(FS.stat(inside).mode)) {
      takeOut(inside);
      continue;
    }
    const bytes = FS.readFile(inside);
    const before = put.get(inside);
    if (before && Buffer.compare(before, bytes) === 0) continue;
    mkdirSync(path, { recursive: true });
    writeFileSync(inside, bytes);
  }
}

FS.mkdirTree(here);
for (const entry of readdirSync(here, { recursive: true, encoding: 'utf8' })) {
  const path = join(here, entry);
  if (statSync(path).isFile()) putIn(path);
}
for (const word of words) {
  const path = resolve(here, word);
  if (existsSync(path) && statSync(path).isFile()) putIn(path);
}
FS.chdir(here);
const { code, out, err } = module.run(words, () => {});
takeOut(here);
process.stdout.write(out);
process.stderr.write(err);
process.exitCode = code;
