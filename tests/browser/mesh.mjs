// Reads OBJ files, and measures their vertices by the plainest formula there is.
import { readFileSync } from 'node:fs';

export function readObj(path) {
  const positions = [];
  const triangles = [];
  for (const line of readFileSync(path, 'utf8').split('\n')) {
    const words = line.trim().split(/\s+/);
    if (words[0] === 'v') positions.push(words.slice(1, 4).map(Number));
    if (words[0] === 'f') triangles.push(words.slice(1, 4).map((word) => parseInt(word, 10) - 1));
  }
  return { positions, triangles };
}

function angleAt(a, b, c) {
  const [u, v] = [b, c].map((p) => p.map((x, i) => x - a[i]));
  const dot = (p, q) => p.reduce((sum, x, i) => sum + x * q[i], 0);
  return Math.acos(dot(u, v) / Math.sqrt(dot(u, u) * dot(v, v)));
}

// A full turn less the angles around the vertex.
export function angleDefect({ positions, triangles }, vertex) {
  let sum = 2 * Math.PI;
  for (const triangle of triangles) {
    const corner = triangle.indexOf(vertex);
    if (corner < 0) continue;
    const [a, b, c] = [0, 1, 2].map((i) => positions[triangle[(corner + i) % 3]]);
    sum -= angleAt(a, b, c);
  }
  return sum;
}

export function distance(p, q) {
  return Math.hypot(...p.map((x, i) => x - q[i]));
}
