// The block of data that the program wrote into the page, unpacked. docs/report.md has its format.

/** @typedef {import('../viewer/figures.js').Figure} Figure */
/** @typedef {import('../viewer/patch_scene.js').Viewpoint} Viewpoint */

/**
 * Texts are base64 of little-endian arrays.
 * @typedef {object} PackedFigure
 * @property {string} id
 * @property {string} map
 * @property {number} limit
 * @property {(string | null)[]} values
 */

/**
 * One limit, or those of stretch and of compression; null where one of these has none.
 * @typedef {object} PackedLimit
 * @property {number} [asked]
 * @property {number | null} [stretch]
 * @property {number | null} [compression]
 * @property {[number, number, number]} beyond
 */

/** @typedef {{bits: number, data: string}} PackedTriangles */
/** @typedef {{names: string[], shown: number, low: number[], step: number[], positions: string[]}} PackedStates */

/**
 * @typedef {object} PackedData
 * @property {string} unit
 * @property {number} vertices
 * @property {number} of
 * @property {Viewpoint} view
 * @property {string} numbers
 * @property {PackedTriangles} triangles
 * @property {PackedStates} states
 * @property {PackedFigure[]} figures
 * @property {PackedLimit} [limit]
 * @property {Record<string, string>} maps
 * @property {{positions: string, low: number[], step: number[]} | null} pattern
 */

/**
 * What a page shows of a patch.
 * @typedef {object} ReportData
 * @property {string} unit of lengths in figures
 * @property {number} count vertices drawn
 * @property {number} whole vertices of the patch
 * @property {Viewpoint} view from where it is seen at first
 * @property {string[]} names of the states; the first is the input patch
 * @property {number} shown the state beside the first at the start
 * @property {Uint32Array} numbers of the vertices in the file that was read
 * @property {Uint16Array | Uint32Array} triangles three vertices each
 * @property {Float32Array[]} positions x, y, z of the vertices, by state; model units
 * @property {Map<string, Figure>} figures by id, in the order in which they are shown
 * @property {Map<string, Uint8Array>} maps colour maps by name
 * @property {Float32Array | null} drawn x, y of the vertices in the drawing of the pattern
 */

/** @param {string} text */
export function bytesOf(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes.buffer;
}

/**
 * Points on a grid of 65536 places along each axis.
 * @param {string} text
 * @param {number[]} low
 * @param {number[]} step
 */
function pointsOf(text, low, step) {
  const places = new Uint16Array(bytesOf(text));
  const axes = low.length;
  const points = new Float32Array(places.length);
  for (let i = 0; i < places.length; ++i) points[i] = low[i % axes] + step[i % axes] * places[i];
  return points;
}

/**
 * @param {PackedFigure} figure
 * @returns {Figure}
 */
function figureOf({ id, map, limit, values }) {
  return { id, map, limit, values: values.map((text) => (text === null ? null : new Float32Array(bytesOf(text)))) };
}

/** Millimetres in the unit of a model. */
const millimetres = new Map([
  ['mm', 1],
  ['cm', 10],
  ['m', 1000],
  ['in', 25.4],
]);

/** Which power of a length figures are of; the others have no unit. */
const powers = new Map([
  ['offset', 1],
  ['deviation', 1],
  ['bent', -1],
  ['curvature', -2],
]);

/**
 * A figure of lengths in millimetres.
 * @param {Figure} figure
 * @param {string} unit of the model
 * @returns {Figure}
 */
function inMillimetres(figure, unit) {
  const factor = (millimetres.get(unit) ?? 1) ** (powers.get(figure.id) ?? 0);
  if (factor === 1) return figure;
  const values = figure.values.map((some) => some && some.map((value) => factor * value));
  return { ...figure, limit: factor * figure.limit, values };
}

/**
 * How much of its limit the edge there uses up whose length differs most: 1 is the limit.
 * @param {PackedLimit} limit
 * @param {Figure} edgeStrain
 * @returns {Figure}
 */
function limitUsed({ asked, stretch = asked, compression = asked, beyond }, edgeStrain) {
  const share = (/** @type {number} */ strain) =>
    Math.abs(strain) / ((strain < 0 ? stretch : compression) ?? Number.POSITIVE_INFINITY);
  const values = edgeStrain.values.map((strains) => strains && strains.map(share));
  return { id: 'limit_used', map: 'pale', limit: 1, values, asked, beyond };
}

/**
 * With a limit, what it is about comes first.
 * @param {PackedData} packed
 */
function figuresOf(packed) {
  const figures = packed.figures.map(figureOf).map((figure) => inMillimetres(figure, packed.unit));
  const edgeStrain = figures.find(({ id }) => id === 'edge_strain');
  if (packed.limit && edgeStrain) figures.unshift(limitUsed(packed.limit, edgeStrain));
  return new Map(figures.map((figure) => [figure.id, figure]));
}

/**
 * Positions of all vertices, by state.
 * @param {PackedStates} states
 */
export function positionsOf({ positions, low, step }) {
  return positions.map((text) => pointsOf(text, low, step));
}

/** @param {PackedTriangles} triangles */
export function cornersOf({ bits, data }) {
  return new (bits === 16 ? Uint16Array : Uint32Array)(bytesOf(data));
}

/**
 * @param {PackedData} packed
 * @returns {ReportData}
 */
export function unpack(packed) {
  const { states, triangles, pattern } = packed;
  return {
    unit: 'mm',
    count: packed.vertices,
    whole: packed.of,
    view: packed.view,
    names: states.names,
    shown: states.shown,
    numbers: new Uint32Array(bytesOf(packed.numbers)),
    triangles: cornersOf(triangles),
    positions: positionsOf(states),
    figures: figuresOf(packed),
    maps: new Map(Object.entries(packed.maps).map(([name, text]) => [name, new Uint8Array(bytesOf(text))])),
    drawn: pattern ? pointsOf(pattern.positions, pattern.low, pattern.step) : null,
  };
}
