// Runs a tool of build/npm/web in the folder of the project, or is skipped where there is none.
//   node run_tool.mjs NODE_MODULES TOOL ARGUMENT...
import { spawnSync } from 'node:child_process';
import { existsSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { fileURLToPath } from 'node:url';

const skipped = 77; // exit code for ctest
const [modules, tool, ...more] = process.argv.slice(2);
const script = resolve(join(modules, tool));
if (!existsSync(script)) {
  console.log(`skipped: there is no ${tool} under build/npm/web`);
  process.exit(skipped);
}
const project = fileURLToPath(new URL('../..', import.meta.url));
const { status } = spawnSync(process.execPath, [script, ...more], { cwd: project, stdio: 'inherit' });
process.exit(status ?? 1);
