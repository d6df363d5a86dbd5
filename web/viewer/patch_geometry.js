// What is computed of a patch before it is drawn.
import { BufferAttribute, BufferGeometry, Vector3 } from 'three';

/** @typedef {import('./patch_scene.js').Pieces} Pieces */

/**
 * What a picture of all states must hold: the middle of what is seen of them, half of its sizes
 * along right and up, and how far anything is from there at most.
 * @param {Float32Array[]} states
 * @param {Vector3} right
 * @param {Vector3} up
 */
export function framing(states, right, up) {
  const low = new Vector3(Infinity, Infinity, Infinity);
  const high = low.clone().negate();
  const point = new Vector3();
  for (const positions of states) {
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i);
      low.min(point);
      high.max(point);
    }
  }
  const middle = low.clone().add(high).multiplyScalar(0.5);
  const seen = { left: Infinity, right: -Infinity, bottom: Infinity, top: -Infinity };
  for (const positions of states) {
    for (let i = 0; i < positions.length; i += 3) {
      point.fromArray(positions, i).sub(middle);
      const [x, y] = [point.dot(right), point.dot(up)];
      seen.left = Math.min(seen.left, x);
      seen.right = Math.max(seen.right, x);
      seen.bottom = Math.min(seen.bottom, y);
      seen.top = Math.max(seen.top, y);
    }
  }
  middle.addScaledVector(right, 0.5 * (seen.left + seen.right));
  middle.addScaledVector(up, 0.5 * (seen.bottom + seen.top));
  return {
    middle,
    width: 0.5 * (seen.right - seen.left),
    height: 0.5 * (seen.top - seen.bottom),
    radius: low.distanceTo(high),
  };
}

/**
 * The edges that only one triangle has, two vertices each.
 * @param {ArrayLike<number>} triangles three vertices each
 */
export function borderOf(triangles) {
  /** @type {Map<string, number[]>} */
  const edges = new Map();
  for (let t = 0; t < triangles.length; t += 3) {
    for (let i = 0; i < 3; ++i) {
      const [a, b] = [triangles[t + i], triangles[t + ((i + 1) % 3)]];
      const key = a < b ? `${a} ${b}` : `${b} ${a}`;
      if (!edges.delete(key)) edges.set(key, [a, b]);
    }
  }
  return [...edges.values()].flat();
}

/**
 * What the vertices have of their pieces.
 * @param {Pieces} pieces
 * @returns {[string, BufferAttribute][]} with their names
 */
export function attributesOf({ of, ways, colors }) {
  const way = new Float32Array(3 * of.length);
  const tint = new Uint8Array(3 * of.length);
  of.forEach((piece, vertex) => {
    way.set(ways.subarray(3 * piece, 3 * piece + 3), 3 * vertex);
    tint.set(Array.from(colors[piece]), 3 * vertex);
  });
  return [
    ['way', new BufferAttribute(way, 3)],
    ['tint', new BufferAttribute(tint, 3, true)],
    ['piece', new BufferAttribute(Float32Array.from(of), 1)],
  ];
}

/**
 * The mesh of one state, which keeps its own copy of the positions.
 * @param {Float32Array} positions
 * @param {BufferAttribute} index
 * @param {[string, BufferAttribute][]} shared what is the same in all states, by name
 */
export function geometryOf(positions, index, shared) {
  const geometry = new BufferGeometry();
  geometry.setIndex(index);
  for (const [name, attribute] of shared) geometry.setAttribute(name, attribute);
  geometry.setAttribute('position', new BufferAttribute(positions.slice(), 3));
  geometry.setAttribute('value', new BufferAttribute(new Float32Array(positions.length / 3), 1));
  geometry.computeVertexNormals();
  return geometry;
}
