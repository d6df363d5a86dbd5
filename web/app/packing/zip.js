// Files as one zip, stored as they are.

const table = Uint32Array.from({ length: 256 }, (_, n) => {
  let c = n;
  for (let k = 0; k < 8; ++k) c = c & 1 ? 0xedb88320 ^ (c >>> 1) : c >>> 1;
  return c;
});

/** @param {Uint8Array} bytes */
function crcOf(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = table[(crc ^ byte) & 255] ^ (crc >>> 8);
  return ~crc >>> 0;
}

/**
 * A record of numbers, low byte first.
 * @param {[number, 2 | 4][]} fields value and bytes of each
 */
function record(fields) {
  const bytes = [];
  for (const [value, size] of fields) {
    for (let i = 0; i < size; ++i) bytes.push((value >>> (8 * i)) & 255);
  }
  return Uint8Array.from(bytes);
}

const utf8Names = 0x800; // flag
const firstDay = 0x21; // 1980-01-01, so that the same files give the same zip

/**
 * @param {[string, Uint8Array<ArrayBuffer>][]} files path, with slashes, and content
 * @returns {Blob}
 */
export function zipOf(files) {
  /** @type {Uint8Array<ArrayBuffer>[]} */
  const parts = [];
  const entries = [];
  let offset = 0;
  for (const [path, content] of files) {
    const name = new TextEncoder().encode(path);
    /** @type {[number, 2 | 4][]} */
    const shared = [
      [20, 2],
      [utf8Names, 2],
      [0, 2],
      [0, 2],
      [firstDay, 2],
      [crcOf(content), 4],
      [content.length, 4],
      [content.length, 4],
      [name.length, 2],
      [0, 2],
    ];
    const head = record([[0x04034b50, 4], ...shared]);
    entries.push(record([[0x02014b50, 4], [20, 2], ...shared, [0, 2], [0, 2], [0, 2], [0, 4], [offset, 4]]), name);
    parts.push(head, name, content);
    offset += head.length + name.length + content.length;
  }
  const size = entries.reduce((sum, entry) => sum + entry.length, 0);
  const end = record([
    [0x06054b50, 4],
    [0, 2],
    [0, 2],
    [files.length, 2],
    [files.length, 2],
    [size, 4],
    [offset, 4],
    [0, 2],
  ]);
  return new Blob([...parts, ...entries, end], { type: 'application/zip' });
}
