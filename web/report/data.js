// The block of data that the program wrote into the page, unpacked.

function bytesOf(text) {
  const letters = atob(text);
  const bytes = new Uint8Array(letters.length);
  for (let i = 0; i < letters.length; ++i) bytes[i] = letters.charCodeAt(i);
  return bytes.buffer;
}

// Points on a grid of 65536 places along each axis.
function pointsOf(text, low, step) {
  const places = new Uint16Array(bytesOf(text));
  const axes = low.length;
  const points = new Float32Array(places.length);
  for (let i = 0; i < places.length; ++i) points[i] = low[i % axes] + step[i % axes] * places[i];
  return points;
}

function figureOf({ id, map, limit, values }) {
  return { id, map, limit, values: values.map((text) => text && new Float32Array(bytesOf(text))) };
}

// How much of its limit the edge there uses up whose length differs most: 1 is the limit.
function limitUsed({ asked, beyond }, edgeStrain) {
  const values = edgeStrain.values.map((strains) => strains && strains.map((strain) => Math.abs(strain) / asked));
  return { id: 'limit_used', map: 'pale', limit: 1, values, asked, beyond };
}

// With a limit, what it is about comes first.
function figuresOf(json) {
  const figures = json.figures.map(figureOf);
  if (json.limit) figures.unshift(limitUsed(json.limit, figures.find(({ id }) => id === 'edge_strain')));
  return new Map(figures.map((figure) => [figure.id, figure]));
}

export function unpack(json) {
  const { states, triangles, pattern } = json;
  const Indices = triangles.bits === 16 ? Uint16Array : Uint32Array;
  return {
    unit: json.unit,
    count: json.vertices,
    whole: json.of,
    view: json.view,
    names: states.names,
    shown: states.shown,
    numbers: new Uint32Array(bytesOf(json.numbers)),
    triangles: new Indices(bytesOf(triangles.data)),
    positions: states.positions.map((text) => pointsOf(text, states.low, states.step)),
    figures: figuresOf(json),
    maps: new Map(
      Object.entries(json.maps).map(([name, text]) => [name, new Uint8Array(bytesOf(text))]),
    ),
    drawn: pattern && pointsOf(pattern.positions, pattern.low, pattern.step),
  };
}
