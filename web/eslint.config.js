// Rules for the scripts of web/ and of their tests. The packages are where scripts/test installs them.
import { createRequire } from 'node:module';

const require = createRequire(new URL('../build/npm/web/none.js', import.meta.url));
const eslint = require('@eslint/js');
const globals = require('globals');

const inNode = ['web/*.js', 'web/*.mjs', 'tests/**/*.mjs', 'bindings/wasm/tools/*.mjs'];
const inBrowser = ['web/app/**/*.js', 'web/report/*.js', 'web/viewer/*.js', 'tests/browser/*.mjs'];

export default [
  eslint.configs.recommended,
  {
    linterOptions: { reportUnusedDisableDirectives: 'error' },
    rules: {
      eqeqeq: 'error',
      'no-implicit-globals': 'error',
      'no-shadow': 'error',
      'no-var': 'error',
      'object-shorthand': 'error',
      'prefer-const': ['error', { destructuring: 'all' }],
      'prefer-template': 'error',
    },
  },
  { files: inNode, languageOptions: { globals: globals.node } },
  { files: inBrowser, languageOptions: { globals: globals.browser } },
  {
    files: ['web/viewer/*.js'],
    rules: {
      'no-restricted-imports': [
        'error',
        { patterns: [{ group: ['**/report/**', '**/app/**'], message: 'The viewer knows no page.' }] },
      ],
    },
  },
];
