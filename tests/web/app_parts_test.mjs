// Arithmetic of the app: meshes, places in the sheet, lines of fewer points, zip files.
import assert from 'node:assert/strict';
import test from 'node:test';
import { crc32 } from 'node:zlib';

import { colorLimit, flatDirection, joined, likelyUnit, rowsOf, sizeText, vertexStrain } from '../../web/app/mesh.js';
import { simplified } from '../../web/app/drawing/simplify.js';
import { zipOf } from '../../web/app/packing/zip.js';

test('the strain of a vertex is the mean around it', () => {
  const strain = vertexStrain(new Uint32Array([0, 1, 2, 2, 1, 3]), new Float32Array([0.5, -0.25]), 4);
  assert.deepEqual([...strain], [0.5, 0.125, 0.125, -0.25]);
});

test('colours end at 1, 2 or 5 near what nearly all keep', () => {
  assert.equal(colorLimit([new Float32Array(200).fill(0.03), new Float32Array([0.9])]), 0.05);
  assert.equal(colorLimit([new Float32Array([-0.2])]), 0.2);
  assert.equal(colorLimit([]), 0.001);
});

test('pieces become one mesh, numbered through', () => {
  const piece = (x) => ({
    name: 'a',
    figures: null,
    positions: new Float32Array([x, 0, 0, x + 1, 0, 0, x, 1, 0]),
    flat: new Float32Array([0, 0, 0, 1, 0, 0, 0, 1, 0]),
    triangles: new Uint32Array([0, 1, 2]),
    strain: new Float32Array([x]),
  });
  const { triangles, of, strain, ways } = joined([piece(0), piece(4)]);
  assert.deepEqual([...triangles], [0, 1, 2, 3, 4, 5]);
  assert.deepEqual([...of], [0, 0, 0, 1, 1, 1]);
  assert.deepEqual([...strain], [0, 0, 0, 4, 4, 4]);
  assert.deepEqual([...ways], [-2, 0, 0, 2, 0, 0], 'away from the middle');
});

test('a direction on the model is turned into the pattern as its triangles are', () => {
  // Lies in the plane y = 2, and in the pattern a quarter turn further on.
  const piece = {
    name: 'a',
    figures: null,
    positions: new Float32Array([0, 2, 0, 3, 2, 0, 0, 2, 1, 3, 2, 1]),
    flat: new Float32Array([0, 0, 0, 0, 3, 0, -1, 0, 0, -1, 3, 0]),
    triangles: new Uint32Array([0, 1, 2, 2, 1, 3]),
    strain: new Float32Array(2),
  };
  const [x, y] = flatDirection(piece, [0.8, 5, 0.6]);
  assert.ok(Math.abs(x / y + 0.6 / 0.8) < 1e-6, `${x} ${y}`);
  assert.ok(y > 0);
});

test('pieces in rows do not overlap and fill the sheet', () => {
  const sizes = Array.from({ length: 17 }, (_, i) => ({ width: 10 + ((7 * i) % 13), height: 5 + ((5 * i) % 11) }));
  const { places, width, height } = rowsOf(sizes, 2);
  sizes.forEach((one, i) => {
    assert.ok(places[i].x >= 0 && places[i].x + one.width <= width + 1e-9);
    assert.ok(places[i].y >= 0 && places[i].y + one.height <= height + 1e-9);
    for (let j = 0; j < i; ++j) {
      const apartX = places[i].x >= places[j].x + sizes[j].width + 2 || places[j].x >= places[i].x + one.width + 2;
      const apartY = places[i].y >= places[j].y + sizes[j].height + 2 || places[j].y >= places[i].y + one.height + 2;
      assert.ok(apartX || apartY, `${i} and ${j}`);
    }
  });
  assert.deepEqual(rowsOf([], 1), { places: [], width: 0, height: 0 });
});

test('sizes in words', () => {
  const hat = new Float32Array([0, 0, 0, 1.88, 1, 2.51]);
  assert.equal(sizeText(hat, 'dm').size, '19 × 10 × 25 cm');
  assert.equal(sizeText(hat, 'dm').words, 'a ruler');
  assert.equal(sizeText(hat, 'm').words, 'a car');
  assert.equal(likelyUnit(hat), 'dm');
});

test('a line of fewer points stays near the others', () => {
  const points = Array.from({ length: 50 }, (_, i) => [i, 10 * Math.sin(i / 8), 0]);
  const few = simplified(points, 0.5);
  assert.ok(few.length < 15 && few.length > 4, `${few.length} points`);
  assert.deepEqual([few[0], few[few.length - 1]], [points[0], points[49]]);
  for (const [x, y] of points) {
    const after = few.findIndex((point) => point[0] >= x);
    const [a, b] = [few[Math.max(0, after - 1)], few[Math.max(1, after)]];
    const along = a[1] + ((x - a[0]) / (b[0] - a[0])) * (b[1] - a[1]);
    assert.ok(Math.abs(along - y) < 1.2, `at ${x}`);
  }
});

test('a zip has its files, their sizes and checksums', async () => {
  const files = [
    ['pattern.svg', new TextEncoder().encode('<svg/>')],
    ['hat-1/ä.txt', new Uint8Array([0, 255, 7])],
    ['empty', new Uint8Array()],
  ];
  const bytes = Buffer.from(await zipOf(files).arrayBuffer());
  const end = bytes.length - 22;
  assert.equal(bytes.readUInt32LE(end), 0x06054b50);
  assert.equal(bytes.readUInt16LE(end + 10), 3);
  let entry = bytes.readUInt32LE(end + 16);
  for (const [path, content] of files) {
    assert.equal(bytes.readUInt32LE(entry), 0x02014b50);
    const size = bytes.readUInt16LE(entry + 28);
    assert.equal(bytes.subarray(entry + 46, entry + 46 + size).toString(), path);
    if (crc32) assert.equal(bytes.readUInt32LE(entry + 16), crc32(content));
    const local = bytes.readUInt32LE(entry + 42);
    assert.equal(bytes.readUInt32LE(local), 0x04034b50);
    const start = local + 30 + bytes.readUInt16LE(local + 26);
    assert.deepEqual([...bytes.subarray(start, start + content.length)], [...content]);
    entry += 46 + size;
  }
});
