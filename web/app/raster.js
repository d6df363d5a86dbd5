// Triangles of a mesh as pixels: thousands of them take a canvas's pen seconds.

/**
 * Fills triangles with one colour each. Pixels are taken whose middle is inside.
 * @param {{data: Uint8ClampedArray, width: number, height: number}} image
 * @param {Float32Array} points x, y of the vertices, pixels
 * @param {ArrayLike<number>} triangles three vertices each
 * @param {(triangle: number) => ArrayLike<number>} colorOf red, green and blue
 */
export function fillTriangles(image, points, triangles, colorOf) {
  const { width, height } = image;
  const pixels = new Uint32Array(image.data.buffer);
  for (let t = 0; t < triangles.length; t += 3) {
    const [a, b, c] = [2 * triangles[t], 2 * triangles[t + 1], 2 * triangles[t + 2]];
    const [red, green, blue] = /** @type {number[]} */ (colorOf(t / 3));
    const color = (255 << 24) | (blue << 16) | (green << 8) | red;
    const top = Math.max(0, Math.ceil(Math.min(points[a + 1], points[b + 1], points[c + 1]) - 0.5));
    const bottom = Math.min(height - 1, Math.floor(Math.max(points[a + 1], points[b + 1], points[c + 1]) - 0.5));
    for (let row = top; row <= bottom; ++row) {
      let [from, to] = [Infinity, -Infinity];
      for (const [p, q] of [
        [a, b],
        [b, c],
        [c, a],
      ]) {
        const y = row + 0.5;
        if (points[p + 1] < y === points[q + 1] < y) continue;
        const share = (y - points[p + 1]) / (points[q + 1] - points[p + 1]);
        const x = points[p] + share * (points[q] - points[p]);
        from = Math.min(from, x);
        to = Math.max(to, x);
      }
      if (from > to) continue;
      const left = Math.max(0, Math.ceil(from - 0.5));
      const right = Math.min(width, Math.ceil(to - 0.5));
      pixels.fill(color, row * width + left, row * width + Math.max(left, right));
    }
  }
}
