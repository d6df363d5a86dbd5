// Gives the program to its workers, and makes the page.
import { App } from './app.js';
import { Engine, compiled } from './engine.js';

/**
 * What the page holds (start.js).
 * @typedef {object} Parts
 * @property {string} worker the script of workers
 * @property {string} pageScript of the program's reports, behind a line with its hash
 * @property {() => Uint8Array<ArrayBuffer>[]} program as it is packed, in streams
 */

const root = document.getElementById('app');
if (root) {
  /** @type {Parts} */
  // @ts-expect-error: start.js left it
  const { worker, pageScript, program } = globalThis.planishParts;
  const url = URL.createObjectURL(new Blob([worker], { type: 'text/javascript' }));
  const module = compiled(url, program());
  module.catch(() => {
    root.textContent = 'This browser cannot run the program. It takes Chrome 97, Firefox 113, Safari 16.4 or newer.';
  });
  new App(root, new Engine(url, module, pageScript), new Engine(url, module), new Engine(url, module));
}
