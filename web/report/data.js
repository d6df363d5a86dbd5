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
    figures: new Map(json.figures.map((figure) => [figure.id, figureOf(figure)])),
    maps: new Map(
      Object.entries(json.maps).map(([name, text]) => [name, new Uint8Array(bytesOf(text))]),
    ),
    drawn: pattern && pointsOf(pattern.positions, pattern.low, pattern.step),
  };
}
