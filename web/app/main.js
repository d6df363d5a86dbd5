// Starts the page: takes the program out of it, and gives it to two workers.
import { App } from './app.js';
import { Engine } from './engine.js';

/** @param {string} id of a block of data in the page */
function dataOf(id) {
  return document.getElementById(id)?.textContent ?? '';
}

async function compiled() {
  const letters = atob(dataOf('program'));
  const packed = Uint8Array.from(letters, (letter) => letter.charCodeAt(0));
  const stream = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return WebAssembly.compile(await new Response(stream).arrayBuffer());
}

const root = document.getElementById('app');
if (root) {
  const script = new TextDecoder().decode(Uint8Array.from(atob(dataOf('worker')), (letter) => letter.charCodeAt(0)));
  const module = compiled();
  module.catch(() => {
    root.textContent = 'This browser cannot run the program. It takes Chrome 97, Firefox 113, Safari 16.4 or newer.';
  });
  new App(root, new Engine(script, module), new Engine(script, module));
}
