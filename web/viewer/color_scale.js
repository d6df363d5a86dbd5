// Values as colours.

/**
 * A colour: red, green and blue, 0 to 255 each.
 * @typedef {ArrayLike<number>} Color
 */

/**
 * Where there is no value, the mean of the neighbours' that have one: "0" there would read as flat.
 * @param {Float32Array} values one for each vertex; NaN where there is none
 * @param {ArrayLike<number>} triangles three vertices each
 * @returns {Float32Array} 0 where no neighbour has a value
 */
export function filled(values, triangles) {
  const sums = new Float32Array(values.length);
  const counts = new Uint16Array(values.length);
  for (let t = 0; t < triangles.length; t += 3) {
    for (let i = 0; i < 3; ++i) {
      const vertex = triangles[t + i];
      if (!Number.isNaN(values[vertex])) continue;
      for (let k = 1; k < 3; ++k) {
        const value = values[triangles[t + ((i + k) % 3)]];
        if (Number.isNaN(value)) continue;
        sums[vertex] += value;
        ++counts[vertex];
      }
    }
  }
  return values.map((value, vertex) =>
    Number.isNaN(value) ? sums[vertex] / Math.max(1, counts[vertex]) : value,
  );
}

/**
 * A colour map as a style sheet has it.
 * @param {Uint8Array} map colours from its low to its high end
 */
export function gradientOf(map) {
  const stops = [];
  for (let i = 0; i < map.length; i += 3) stops.push(colorOf(map.subarray(i, i + 3)));
  return `linear-gradient(to right, ${stops.join(', ')})`;
}

/**
 * A colour as a style sheet has it.
 * @param {Color} color
 */
export function colorOf(color) {
  return `rgb(${color[0]} ${color[1]} ${color[2]})`;
}

/**
 * 1, 2 and 5 times powers of ten, up and down.
 * @param {number} limit above 0; if it is none of these, the nearest of its power of ten is meant
 * @param {number} step how many of them up; below 0 down
 */
export function nextScale(limit, step) {
  const power = Math.floor(Math.log10(limit) + 1e-9);
  const nearest = [1, 2, 5, 10].reduce((best, mark) =>
    Math.abs(mark * 10 ** power - limit) < Math.abs(best * 10 ** power - limit) ? mark : best,
  );
  const index = Math.round(3 * power + [1, 2, 5, 10].indexOf(nearest)) + step;
  return Number(`${[1, 2, 5][((index % 3) + 3) % 3]}e${Math.floor(index / 3)}`);
}
