// The block of data of a page of a product, unpacked. docs/report.md has its format.
import { bytesOf, cornersOf, positionsOf } from './data.js';

/** @typedef {import('../viewer/patch_scene.js').Patch} Patch */
/** @typedef {import('../viewer/patch_scene.js').Viewpoint} Viewpoint */
/** @typedef {import('./data.js').PackedStates} PackedStates */
/** @typedef {import('./data.js').PackedTriangles} PackedTriangles */

/**
 * @typedef {object} PackedPiece
 * @property {string} name
 * @property {number} number on the page, from 1
 * @property {[number, number, number]} color
 * @property {number} vertices how many, behind those of the pieces before
 * @property {[number, number, number]} middle
 */

/**
 * One side of a seam.
 * @typedef {object} PackedSeam
 * @property {number} number
 * @property {number} piece its number on the page
 * @property {string} vertices
 */

/**
 * @typedef {object} PackedProduct
 * @property {number} vertices
 * @property {number} of
 * @property {Record<string, Viewpoint>} views by the axis that points up
 * @property {[number, number, number]} middle
 * @property {PackedTriangles} triangles
 * @property {PackedStates} states
 * @property {PackedPiece[]} pieces
 * @property {PackedSeam[]} seams
 */

/**
 * What a page shows of a product.
 * @typedef {object} ProductData
 * @property {number} count vertices drawn
 * @property {number} whole vertices of the pieces
 * @property {string[]} names of the states; the last is the result
 * @property {{name: string, number: number, seams: number[]}[]} pieces
 * @property {Map<string, Viewpoint>} views by the axis that points up
 * @property {Patch} patch
 */

/**
 * Where each piece goes when they move apart: on from the product's middle through its own.
 * @param {PackedPiece[]} pieces
 * @param {number[]} middle
 */
export function waysOf(pieces, middle) {
  return Float32Array.from(pieces.flatMap((piece) => piece.middle.map((place, i) => place - middle[i])));
}

/**
 * @param {PackedProduct} packed
 * @returns {ProductData}
 */
export function unpackProduct({ vertices, of, views, middle, triangles, states, pieces, seams }) {
  const seen = new Map(Object.entries(views));
  return {
    count: vertices,
    whole: of,
    names: states.names,
    pieces: pieces.map(({ name, number }) => ({
      name,
      number,
      seams: [...new Set(seams.filter(({ piece }) => piece === number).map((seam) => seam.number))],
    })),
    views: seen,
    patch: {
      positions: positionsOf(states),
      triangles: cornersOf(triangles),
      view: views.y,
      shown: states.shown,
      maps: new Map(),
      pieces: {
        of: Uint16Array.from(pieces.flatMap((piece, i) => new Array(piece.vertices).fill(i))),
        ways: waysOf(pieces, middle),
        colors: pieces.map(({ color }) => color),
        lines: seams.map((seam) => ({ number: seam.number, vertices: new Uint32Array(bytesOf(seam.vertices)) })),
      },
    },
  };
}
