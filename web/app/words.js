// Names and words of the program, for the page.

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

/** What the program said last. @param {string} err */
export function errorOf(err) {
  const at = err.lastIndexOf('error: ');
  const text = at < 0 ? err : err.slice(at + 7);
  return text.replace('planish --help and planish VERB --help tell more', '').trim();
}
