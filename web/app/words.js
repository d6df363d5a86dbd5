// Names and words of the program, for the page.
import { lineWord } from './project.js';

export const stages = /** @type {Record<string, string>} */ ({
  reading: 'Reading the model',
  measuring: 'Measuring',
  evolving: 'Changing the form',
  unfolding: 'Laying flat',
  dividing: 'Dividing',
});

/** @param {Uint8Array<ArrayBuffer>} bytes */
export async function hashOf(bytes) {
  if (!crypto.subtle) return '';
  const hash = new Uint8Array(await crypto.subtle.digest('SHA-256', bytes));
  return Array.from(hash, (byte) => byte.toString(16).padStart(2, '0')).join('');
}

/** A name that the program's command line and every system take as a file's. @param {string} name */
export function fileName(name) {
  const safe = name.replace(/[^\p{L}\p{N}._ -]/gu, '_').replace(/^[-.]+/, '_');
  return safe || 'model.obj';
}

/** Files in a few words. @param {string[]} names */
export function titleOf(names) {
  return names.length > 2 ? `${names[0]} and ${names.length - 1} others` : names.join(' and ');
}

/** What the program said last. @param {string} err */
export function errorOf(err) {
  const at = err.lastIndexOf('error: ');
  const text = at < 0 ? err : err.slice(at + 7);
  return text.replace('planish --help and planish VERB --help tell more', '').trim();
}

/**
 * What lines still lack to cut, for those who draw them.
 * @param {import('./project.js').Project} project
 * @param {string} said by the program; empty where all is well
 */
export function lineHint({ lines }, said) {
  if (!/nothing is left to cut|nothing is cut there/.test(said)) return '';
  const idle = lines.flatMap((line, i) => (said.includes(lineWord(line)) ? [i + 1] : []));
  const which = idle.length === 1 ? `Line ${idle[0]} cuts` : 'These lines cut';
  return `${which} nothing yet. Lead both ends to the border or to another line, or one end for a dart.`;
}
