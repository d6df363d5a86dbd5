// The packing of the page: what xz packs comes out again, and a module that was divided is joined to the same bytes.
import assert from 'node:assert/strict';
import { execFileSync } from 'node:child_process';
import test from 'node:test';

import { unpacked } from '../../web/app/packing/unpack.js';
import { divided, joined } from '../../web/app/packing/wasm_streams.js';

const pack = (input, options = '') =>
  new Uint8Array(execFileSync('xz', ['--format=lzma', `--lzma1=preset=9e${options}`], { input, maxBuffer: 1e8 }));

// Bytes that repeat and bytes that do not, always the same.
function sample(count) {
  const bytes = new Uint8Array(count);
  let state = 1;
  for (let i = 0; i < count; ++i) {
    state = (Math.imul(state, 1103515245) + 12345) >>> 0;
    bytes[i] = state % 7 < 4 && i > 300 ? bytes[i - 1 - (state >> 24)] : state >> 16;
  }
  return bytes;
}

test('what xz packs comes out again, with every setting', () => {
  for (const count of [0, 1, 2, 1000, 300000]) {
    for (const options of ['', ',pb=0,lc=4', ',lc=0,lp=2,pb=2', ',lc=1,lp=3,pb=4,dict=4096']) {
      const bytes = sample(count);
      assert.deepEqual(unpacked(pack(bytes, options)), bytes, `${count} ${options}`);
    }
  }
});

test('packed bytes that are cut off are refused', () => {
  const packed = pack(sample(5000));
  assert.throws(() => unpacked(packed.slice(0, packed.length / 2)), /cut off|damaged/);
});

// A module with an operation of every kind of number behind it. Functions need not be valid to be moved.
function moduleOf(body) {
  const code = [1, ...leb(body.length + 3), 1, 2, 0x7f, ...body];
  return Uint8Array.from([0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, 1, 1, 0, 10, ...leb(code.length), ...code, 11, 2, 0, 0]);
}

function leb(value) {
  return value < 128 ? [value] : [(value & 127) | 128, ...leb(value >> 7)];
}

const sixteen = Array.from({ length: 16 }, (_, i) => 200 + i);
const operations = [
  [0x02, 0x40], [0x06, 0x7f], [0x07, 3], [0x19], [0x0c, 1], [0x0e, 2, 0, 1, 2], [0x10, 0x80, 0x02], [0x11, 5, 0],
  [0x20, 7], [0x22, 0x81, 1], [0x23, 0], [0x28, 2, 0x90, 3], [0x3f, 0], [0x41, 0xff, 0x7e], [0x42, 0x80, 0x80, 1],
  [0x43, 1, 2, 3, 4], [0x44, 1, 2, 3, 4, 5, 6, 7, 8], [0x6a], [0xfc, 2], [0xfc, 8, 1, 0], [0xfc, 10, 0, 0],
  [0xfc, 11, 0], [0xfd, 0, 4, 16], [0xfd, 12, ...sixteen], [0xfd, 21, 3], [0xfd, 84, 0, 8, 1], [0xfd, 92, 2, 8],
  [0xfd, 0xae, 1], [0x0b],
];

test('a module is joined again from its streams, each operation with what belongs to it', () => {
  for (const some of [operations, ...operations.map((one) => [one, [0x0b]])]) {
    const module = moduleOf(some.flat());
    const parts = divided(module);
    assert.deepEqual(joined(parts), module, String(some));
  }
  const parts = divided(moduleOf(operations.flat()));
  assert.deepEqual([...parts[4]], [0x80, 0x02]); // calls alone
});

test('code that is cut off is refused', () => {
  assert.throws(() => divided(moduleOf([0x44, 1, 2])), /not understood/);
});
