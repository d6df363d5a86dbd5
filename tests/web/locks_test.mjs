// Lock files name packages by version and hash; from where they are fetched is for who installs them.
import assert from 'node:assert/strict';
import { readFileSync } from 'node:fs';
import test from 'node:test';

for (const folder of ['web', 'tests/browser', 'tests/roundtrip']) {
  const read = (name) => JSON.parse(readFileSync(new URL(`../../${folder}/${name}`, import.meta.url), 'utf8'));

  test(`${folder}: no package has an address, and each a hash`, () => {
    for (const [name, { resolved, integrity }] of Object.entries(read('package-lock.json').packages)) {
      assert.equal(resolved, undefined, name);
      if (name !== '') assert.match(integrity, /^sha512-/, name);
    }
  });

  test(`${folder}: versions are exact`, () => {
    const { dependencies, devDependencies } = read('package.json');
    for (const [name, version] of Object.entries({ ...dependencies, ...devDependencies })) {
      assert.match(version, /^\d+\.\d+\.\d+$/, name);
    }
  });
}
