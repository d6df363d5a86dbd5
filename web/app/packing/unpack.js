// What xz packs as .lzma: a third smaller than what browsers can unpack by themselves (LZMA; I. Pavlov, LZMA
// specification, 2015).

const full = 0x800; // a probability of one half, of 2^11
const shift = 5; // how fast probabilities follow what was read
const header = 13; // bytes

/** Reads bits, each by its probability (G. N. N. Martin, Range encoding, 1979). */
class BitReader {
  /**
   * @param {Uint8Array} bytes
   * @param {number} at where the coded bits begin
   */
  constructor(bytes, at) {
    this.bytes = bytes;
    this.at = at + 5;
    this.range = 0xffffffff;
    this.code = 0;
    for (let i = 1; i < 5; ++i) this.code = ((this.code << 8) | bytes[at + i]) >>> 0;
  }

  /**
   * @param {Uint16Array} chances that a bit is 0
   * @param {number} place
   */
  bit(chances, place) {
    const chance = chances[place];
    const bound = (this.range >>> 11) * chance;
    let bit = 0;
    if (this.code < bound) {
      this.range = bound;
      chances[place] = chance + ((full - chance) >> shift);
    } else {
      this.range -= bound;
      this.code -= bound;
      chances[place] = chance - (chance >> shift);
      bit = 1;
    }
    if (this.range < 0x1000000) this.refill();
    return bit;
  }

  refill() {
    this.range = (this.range << 8) >>> 0;
    this.code = ((this.code << 8) | this.bytes[this.at++]) >>> 0;
  }

  /** @param {number} count of bits that are as often 0 as 1 */
  plain(count) {
    let value = 0;
    for (let i = 0; i < count; ++i) {
      this.range >>>= 1;
      const bit = this.code >= this.range ? 1 : 0;
      if (bit === 1) this.code -= this.range;
      value = value * 2 + bit;
      if (this.range < 0x1000000) this.refill();
    }
    return value;
  }

  /**
   * A number, its highest bit first.
   * @param {Uint16Array} chances
   * @param {number} start
   * @param {number} count of bits
   */
  tree(chances, start, count) {
    let node = 1;
    for (let i = 0; i < count; ++i) node = (node << 1) | this.bit(chances, start + node);
    return node - (1 << count);
  }

  /**
   * A number, its lowest bit first.
   * @param {Uint16Array} chances
   * @param {number} start
   * @param {number} count
   */
  reversed(chances, start, count) {
    let [node, value] = [1, 0];
    for (let i = 0; i < count; ++i) {
      const bit = this.bit(chances, start + node);
      node = (node << 1) | bit;
      value |= bit << i;
    }
    return value;
  }
}

/** @param {number} count */
const evenChances = (count) => new Uint16Array(count).fill(full / 2);

/** How long a copy is. */
class LengthReader {
  constructor() {
    this.choice = evenChances(2);
    this.low = evenChances(16 << 3);
    this.middle = evenChances(16 << 3);
    this.high = evenChances(256);
  }

  /**
   * @param {BitReader} reader
   * @param {number} place in the output, modulo its period
   */
  length(reader, place) {
    if (reader.bit(this.choice, 0) === 0) return 2 + reader.tree(this.low, place << 3, 3);
    if (reader.bit(this.choice, 1) === 0) return 10 + reader.tree(this.middle, place << 3, 3);
    return 18 + reader.tree(this.high, 0, 8);
  }
}

class Unpacker {
  /** @param {Uint8Array} packed */
  constructor(packed) {
    const properties = packed[0];
    this.literalContext = properties % 9;
    const [places, literalPlaces] = [Math.floor(properties / 45), Math.floor(properties / 9) % 5];
    this.places = (1 << places) - 1;
    this.literalPlaces = (1 << literalPlaces) - 1;
    this.reader = new BitReader(packed, header);
    this.literals = evenChances(0x300 << (this.literalContext + literalPlaces));
    this.isCopy = evenChances(12 << 4);
    this.isRepeated = evenChances(12);
    this.isLater = [evenChances(12), evenChances(12), evenChances(12)];
    this.isLong = evenChances(12 << 4);
    this.slots = evenChances(4 << 6);
    this.special = evenChances(115);
    this.align = evenChances(16);
    this.lengths = new LengthReader();
    this.repeatedLengths = new LengthReader();
    this.state = 0;
    /** Distances of the last copies, less one. */
    this.distances = [0, 0, 0, 0];
    this.out = new Uint8Array(4 * packed.length);
    this.count = 0;
  }

  /** @param {number} more bytes to come */
  reserve(more) {
    if (this.count + more <= this.out.length) return;
    const larger = new Uint8Array(2 * this.out.length + more);
    larger.set(this.out);
    this.out = larger;
  }

  literal() {
    const { reader, literals, out, count } = this;
    const before = count > 0 ? out[count - 1] : 0;
    const context = ((count & this.literalPlaces) << this.literalContext) + (before >> (8 - this.literalContext));
    const start = 0x300 * context;
    let symbol = 1;
    if (this.state >= 7) {
      // Behind a copy: by the byte that would have followed in it.
      let match = out[count - this.distances[0] - 1];
      while (symbol < 0x100) {
        const expected = (match >> 7) & 1;
        match <<= 1;
        const bit = reader.bit(literals, start + ((1 + expected) << 8) + symbol);
        symbol = (symbol << 1) | bit;
        if (bit !== expected) break;
      }
    }
    while (symbol < 0x100) symbol = (symbol << 1) | reader.bit(literals, start + symbol);
    this.reserve(1);
    this.out[this.count++] = symbol & 0xff;
    this.state = this.state < 4 ? 0 : this.state < 10 ? this.state - 3 : this.state - 6;
  }

  /** @param {number} length */
  distance(length) {
    const { reader } = this;
    const slot = reader.tree(this.slots, Math.min(length - 2, 3) << 6, 6);
    if (slot < 4) return slot;
    const bits = (slot >> 1) - 1;
    const base = (2 | (slot & 1)) * 2 ** bits;
    if (slot < 14) return base + reader.reversed(this.special, base - slot, bits);
    return base + reader.plain(bits - 4) * 16 + reader.reversed(this.align, 0, 4);
  }

  /**
   * A copy with the distance of one of the last four.
   * @param {number} place
   * @returns {number} its length
   */
  repeated(place) {
    const { reader, state, distances } = this;
    let which = 0;
    if (reader.bit(this.isLater[0], state) === 0) {
      if (reader.bit(this.isLong, (state << 4) + place) === 0) {
        this.state = state < 7 ? 9 : 11;
        return 1;
      }
    } else {
      which = 1;
      while (which < 3 && reader.bit(this.isLater[which], state) === 1) ++which;
      distances.unshift(...distances.splice(which, 1));
    }
    this.state = state < 7 ? 8 : 11;
    return this.repeatedLengths.length(reader, place);
  }

  /** @param {number} length */
  copy(length) {
    const from = this.count - this.distances[0] - 1;
    if (from < 0) throw new Error('packed data are damaged');
    this.reserve(length);
    for (let i = 0; i < length; ++i) this.out[this.count++] = this.out[from + i];
  }

  unpack() {
    const { reader } = this;
    for (;;) {
      const place = this.count & this.places;
      if (reader.at > reader.bytes.length) throw new Error('packed data are cut off');
      if (reader.bit(this.isCopy, (this.state << 4) + place) === 0) {
        this.literal();
      } else if (reader.bit(this.isRepeated, this.state) === 1) {
        this.copy(this.repeated(place));
      } else {
        const length = this.lengths.length(reader, place);
        this.state = this.state < 7 ? 7 : 10;
        const distance = this.distance(length);
        if (distance === 0xffffffff) return this.out.slice(0, this.count);
        this.distances.unshift(distance);
        this.distances.pop();
        this.copy(length);
      }
    }
  }
}

/**
 * @param {Uint8Array} packed by `xz --format=lzma`, with a mark at the end
 * @returns {Uint8Array<ArrayBuffer>}
 */
export function unpacked(packed) {
  return new Unpacker(packed).unpack();
}
