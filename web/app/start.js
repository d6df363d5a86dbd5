// Starts the page: takes its scripts out of it and runs them.
import { unpacked } from './packing/unpack.js';

/** @param {string} id of a block of data in the page */
function partsOf(id) {
  const texts = (document.getElementById(id)?.textContent ?? '').split(' ');
  return texts.map((text) => Uint8Array.from(atob(text), (letter) => letter.charCodeAt(0)));
}

const scripts = new TextDecoder().decode(unpacked(partsOf('scripts')[0])).split('\0');
/** @type {import('./main.js').Parts} */
const parts = { worker: scripts[0], pageScript: scripts[1], program: () => partsOf('program') };
Object.assign(globalThis, { planishParts: parts });
const script = document.createElement('script');
script.textContent = scripts[2];
document.body.append(script);
