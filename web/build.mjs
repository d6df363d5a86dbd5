// Bundles the script of the report pages and writes it as a C++ source, or as a text behind a line with its hash.
//   node build.mjs FOLDER-OF-NODE-MODULES OUTPUT.cpp|OUTPUT.txt
import { createHash } from 'node:crypto';
import { writeFileSync } from 'node:fs';
import { createRequire } from 'node:module';
import { dirname, join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const [modules, output] = process.argv.slice(2).map((path) => resolve(path));
const here = dirname(fileURLToPath(import.meta.url));
const esbuild = createRequire(join(modules, 'none.js'))('esbuild');

const { outputFiles } = await esbuild.build({
  entryPoints: [join(here, 'report/main.js')],
  nodePaths: [modules],
  bundle: true,
  write: false,
  minify: true,
  format: 'iife',
  target: 'es2020',
  charset: 'ascii',
  legalComments: 'inline',
  logLevel: 'warning',
});
const script = outputFiles[0].text.replace(/\n$/, '');

// What would end the script, the C++ string or the agreement of its hash.
for (const part of ['</script', '<!--', ')planish"', '\r']) {
  if (script.includes(part)) throw new Error(`the bundle holds ${JSON.stringify(part)}`);
}

const longest = 60000; // letters of a string that every compiler takes
const parts = [];
for (let at = 0; at < script.length; at += longest) parts.push(script.slice(at, at + longest));
const hash = `sha256-${createHash('sha256').update(script).digest('base64')}`;
const source = `#include "report/page/page_assets.h"

namespace planish {

namespace {

using namespace std::string_view_literals;  // with their lengths: compilers will not count so far

constexpr std::string_view k_parts[] = {
${parts.map((part) => `R"planish(${part})planish"sv`).join(',\n')}};

}  // namespace

PageScript page_script() {
  return {"${hash}", k_parts};
}

}  // namespace planish
`;
writeFileSync(output, output.endsWith('.txt') ? `${hash}\n${script}` : source);
