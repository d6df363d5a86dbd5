// Makes the page of the app: one file with the program, its worker, scripts and styles.
//   node build_app.mjs FOLDER-OF-NODE-MODULES FOLDER-OF-THE-WASM-MODULE OUTPUT.html
import { createHash } from 'node:crypto';
import { readFileSync, writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';
import { gzipSync } from 'node:zlib';

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

const glue = readFileSync(join(wasm, 'planish_module.js'), 'utf8');
const worker = Buffer.from(`${glue}\n${await bundled('worker.js')}`).toString('base64');
const program = gzipSync(readFileSync(join(wasm, 'planish_module.wasm')), { level: 9 }).toString('base64');
const script = await bundled('main.js');
const styles = ['report/page.css', 'viewer/viewer.css', 'app/app.css'];
const style = styles.map((path) => readFileSync(join(here, path), 'utf8')).join('\n');
if (script.includes('</script') || script.includes('<!--')) throw new Error('the bundle would end its script');

const policy = [
  "default-src 'none'",
  `script-src ${hashOf(script)} 'wasm-unsafe-eval'`,
  `style-src ${hashOf(style)}`,
  'worker-src blob:',
  'img-src data:',
  "base-uri 'none'",
  "form-action 'none'",
].join('; ');

/** @type {Record<string, string>} */
const parts = { policy, style, program, worker, script };
const template = readFileSync(join(here, 'app/page.html'), 'utf8');
writeFileSync(output, template.replace(/\{\{(\w+)\}\}/g, (_, name) => parts[name]));
