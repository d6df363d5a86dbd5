// The code of a WebAssembly module with what is alike side by side: operations, locals, offsets and so on each in a
// stream of its own, which packs an eighth smaller (WebAssembly Core Specification 2.0, section 5.4).

const streams = /** @type {const} */ (['rest', 'sizes', 'operation', 'local', 'call', 'offset', 'number', 'wide', 'table']);
/** @typedef {typeof streams[number]} Stream */

const magic = 8; // bytes of a module before its sections
const codeSection = 10;

/** Bytes that grow. */
class Bytes {
  constructor() {
    this.bytes = new Uint8Array(1 << 16);
    this.count = 0;
  }

  /** @param {number} byte */
  push(byte) {
    if (this.count === this.bytes.length) {
      const larger = new Uint8Array(2 * this.count);
      larger.set(this.bytes);
      this.bytes = larger;
    }
    this.bytes[this.count++] = byte;
  }

  taken() {
    return this.bytes.subarray(0, this.count);
  }
}

/**
 * Moves the bytes of code from one place to another: it reads the same from a module and from streams, and whoever
 * takes and gives decides which.
 */
class Mover {
  /**
   * @param {(stream: Stream) => number} take
   * @param {(stream: Stream, byte: number) => void} give
   */
  constructor(take, give) {
    this.take = take;
    this.give = give;
    this.moved = 0;
  }

  /** @param {Stream} stream */
  byte(stream) {
    const byte = this.take(stream);
    this.give(stream, byte);
    ++this.moved;
    return byte;
  }

  /**
   * @param {Stream} stream
   * @param {number} count
   */
  bytes(stream, count) {
    for (let i = 0; i < count; ++i) this.byte(stream);
  }

  /** A number in LEB128. @param {Stream} stream */
  number(stream) {
    let [value, scale] = [0, 1];
    for (;;) {
      const byte = this.byte(stream);
      value += (byte & 127) * scale;
      scale *= 128;
      if (byte < 128) return value;
    }
  }

  /** All functions of a code section. */
  section() {
    for (let left = this.number('sizes'); left > 0; --left) {
      const end = this.number('sizes') + this.moved;
      for (let groups = this.number('sizes'); groups > 0; --groups) {
        this.number('sizes');
        this.byte('sizes');
      }
      while (this.moved < end) this.instruction();
    }
  }

  instruction() {
    const code = this.byte('operation');
    if (code >= 0x28 && code <= 0x3e) this.place();
    else if (code >= 0x20 && code <= 0x22) this.number('local');
    else if (code === 0x41) this.number('number');
    else if (code === 0x42) this.number('wide');
    else if (code === 0x43) this.bytes('wide', 4);
    else if (code === 0x44) this.bytes('wide', 8);
    else if (code === 0x10) this.number('call');
    else if (code === 0x11) this.bytesOfCallByTable();
    else if (code === 0x0e) this.branches();
    else if (code === 0xfc) this.bulk();
    else if (code === 0xfd) this.vector();
    else if (hasNumber.has(code)) this.number('operation');
  }

  /** Of memory: how it is aligned, and the offset. */
  place() {
    this.number('operation');
    this.number('offset');
  }

  bytesOfCallByTable() {
    this.number('table');
    this.number('table');
  }

  branches() {
    for (let left = this.number('table') + 1; left > 0; --left) this.number('table');
  }

  bulk() {
    const code = this.number('operation');
    if (code === 8 || code === 10 || code === 12 || code === 14) this.bytes('operation', 2);
    else if (code > 7) this.byte('operation');
  }

  vector() {
    const code = this.number('operation');
    if (code <= 11 || code === 92 || code === 93) this.place();
    else if (code === 12 || code === 13) this.bytes('wide', 16);
    else if (code >= 84 && code <= 91) {
      this.place();
      this.byte('operation');
    } else if (code >= 21 && code <= 34) this.byte('operation');
  }
}

/** Blocks, branches, exceptions, globals: with one number behind them. */
const hasNumber = new Set([2, 3, 4, 6, 7, 8, 9, 0x0c, 0x0d, 0x18, 0x23, 0x24, 0x3f, 0x40]);

/**
 * Where the code section of a module begins and ends, behind its own header.
 * @param {Uint8Array} module
 */
function codeOf(module) {
  let at = magic;
  const number = () => {
    let [value, scale] = [0, 1];
    for (;;) {
      const byte = module[at++];
      value += (byte & 127) * scale;
      scale *= 128;
      if (byte < 128) return value;
    }
  };
  while (at < module.length) {
    const kind = module[at++];
    const size = number();
    if (kind === codeSection) return { begin: at, end: at + size };
    at += size;
  }
  throw new Error('the module has no code');
}

/**
 * @param {Uint8Array} module
 * @returns {Uint8Array[]} the streams
 */
export function divided(module) {
  const { begin, end } = codeOf(module);
  const made = Object.fromEntries(streams.map((name) => [name, new Bytes()]));
  let at = begin;
  const mover = new Mover(
    () => module[at++],
    (stream, byte) => made[stream].push(byte),
  );
  mover.section();
  if (at !== end) throw new Error('the code of the module is not understood');
  for (const byte of module.subarray(0, begin)) made.rest.push(byte);
  for (const byte of module.subarray(end)) made.rest.push(byte);
  return streams.map((name) => made[name].taken());
}

/**
 * The module that was divided.
 * @param {Uint8Array[]} parts
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function joined(parts) {
  const all = new Uint8Array(parts.reduce((sum, { length }) => sum + length, 0));
  const [rest] = parts;
  const { begin } = codeOf(rest);
  all.set(rest.subarray(0, begin));
  let count = begin;
  const places = new Map(streams.map((name, i) => [name, { part: parts[i], at: 0 }]));
  const mover = new Mover(
    (stream) => {
      const place = /** @type {{part: Uint8Array, at: number}} */ (places.get(stream));
      return place.part[place.at++];
    },
    (_, byte) => {
      all[count++] = byte;
    },
  );
  mover.section();
  all.set(rest.subarray(begin), count);
  return all;
}
