// Makes the page of the app: one file with the program, its worker, scripts and styles.
//   node build_app.mjs FOLDER-OF-NODE-MODULES FOLDER-OF-THE-WASM-MODULE OUTPUT.html
import { execFileSync } from 'node:child_process';
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

import { divided } from './app/packing/wasm_streams.js';

const [modules, wasm, output] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(modules, 'none.js'))('esbuild');

/** @param {string} entry */
async function bundled(entry) {
  const { outputFiles } = await esbuild.build({
    entryPoints: [join(here, 'app', entry)],
    nodePaths: [modules],
    bundle: true,
    write: false,
    minify: true,
    format: 'iife',
    target: 'es2022',
    charset: 'ascii',
    legalComments: 'inline',
    logLevel: 'warning',
  });
  return outputFiles[0].text;
}

/** @param {string} text */
function hashOf(text) {
  return `'sha256-${createHash('sha256').update(text).digest('base64')}'`;
}

/**
 * Packed for unpack.js, as a text.
 * @param {string | Uint8Array} input
 * @param {string} options of xz
 */
function packed(input, options = '') {
  const words = ['--format=lzma', `--lzma1=preset=9e${options}`];
  return execFileSync('xz', words, { input, maxBuffer: 1e9 }).toString('base64');
}

const glue = readFileSync(join(wasm, 'planish_module.js'), 'utf8');
const { code } = await esbuild.transform(glue, { minify: true, charset: 'ascii', target: 'es2022' });
const pageScript = readFileSync(join(wasm, '../../generated/page_script.txt'), 'utf8');
const script = await bundled('main.js');
const start = await bundled('start.js');
// Scripts together, as the app and the pages of reports share most of theirs.
const scripts = packed([`${code}\n${await bundled('worker.js')}`, pageScript, script].join('\0'));
const program = divided(readFileSync(join(wasm, 'planish_module.wasm')))
  .map((part) => packed(part, ',pb=0,lc=4'))
  .join(' ');
const styles = ['report/base.css', 'viewer/viewer.css', 'app/app.css'];
const rules = styles.map((path) => readFileSync(join(here, path), 'utf8')).join('\n');
const { code: style } = await esbuild.transform(rules, { loader: 'css', minify: true, charset: 'ascii', target: 'es2022' });
if (start.includes('</script') || start.includes('<!--')) throw new Error('the bundle would end its script');

const policy = [
  "default-src 'none'",
  `script-src ${hashOf(start)} ${hashOf(script)} 'wasm-unsafe-eval'`,
  `style-src ${hashOf(style)}`,
  'worker-src blob:',
  'img-src data:',
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** @type {Record<string, string>} */
const parts = { policy, style, program, scripts, start };
const template = readFileSync(join(here, 'app/page.html'), 'utf8');
writeFileSync(output, template.replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]));
