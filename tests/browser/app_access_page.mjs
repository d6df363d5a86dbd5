// Whether all can use the app: axe looks at each of its states, on a desk and on a phone, by day and in the dark.
//   node app_access_page.mjs PROGRAM NODE_MODULES
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import { existsSync, readFileSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import test from 'node:test';

import { projectText } from '../../web/app/project.js';
import { choose, drop, folder, makes, modules, program, savedProject, withApp } from './app.mjs';
import { skip } from './browser.mjs';

const axe = join(modules, 'axe-core/axe.min.js');
if (!existsSync(axe)) skip('there is no axe-core under build/npm/browser');
const source = readFileSync(axe, 'utf8');
const model = join(folder, 'dome.obj');
execFileSync(resolve(program), ['sample', 'dome', '--vertices', '400', '-o', model]);

async function expectNoFault(page, state) {
  await page.evaluate(source);
  const { violations } = await page.evaluate(() => globalThis.axe.run());
  const faults = violations.map(({ id, impact, nodes }) => `${id} (${impact}): ${nodes.map(({ html }) => html).join(' ')}`);
  assert.deepEqual(faults, [], state);
}

const desk = { viewport: { width: 1440, height: 900 } };
const phone = { viewport: { width: 390, height: 844 }, hasTouch: true, isMobile: true };
for (const [place, viewport] of Object.entries({ desk, phone })) {
  for (const colorScheme of ['light', 'dark']) {
    test(`no state has a fault: ${place}, ${colorScheme}`, () =>
      withApp({ ...viewport, colorScheme }, async (page) => {
        await expectNoFault(page, 'empty');
        await makes(page, () => drop(page, model));
        await expectNoFault(page, 'a model');
        await page.click('text=Draw a line');
        await expectNoFault(page, 'drawing');
        await page.keyboard.press('Escape');
        const lines = [{ kind: 'shortest', points: [[-1e3, 0, 0], [0, 0, 1e3], [1e3, 0, 0]] }];
        const project = join(folder, 'cut.planish.json');
        writeFileSync(project, projectText({ ...(await savedProject(page)), lines, grain: '1,0,0' }));
        await makes(page, () => choose(page, project));
        await page.click('.lines .name');
        await expectNoFault(page, 'pieces');
        writeFileSync(join(folder, 'bad.obj'), '');
        await choose(page, join(folder, 'bad.obj'));
        await page.waitForSelector('.alert:not([hidden])');
        await expectNoFault(page, 'a fault');
      }));
  }
}
