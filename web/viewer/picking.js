// Which vertex is meant by a place in a picture.

// The corner nearest to (x, y) of the foremost triangle there, or -1.
// places: x, y, depth (more is nearer) of every vertex
export function pick(places, triangles, x, y) {
  let best = -1;
  let nearest = -Infinity;
  for (let t = 0; t < triangles.length; t += 3) {
    const a = 3 * triangles[t];
    const b = 3 * triangles[t + 1];
    const c = 3 * triangles[t + 2];
    const u = cross(places, b, c, x, y);
    const v = cross(places, c, a, x, y);
    const w = cross(places, a, b, x, y);
    if (!((u >= 0 && v >= 0 && w >= 0) || (u <= 0 && v <= 0 && w <= 0))) continue;
    const area = u + v + w;
    if (area === 0) continue;
    const depth = (u * places[a + 2] + v * places[b + 2] + w * places[c + 2]) / area;
    if (depth <= nearest) continue;
    nearest = depth;
    best = [a, b, c].reduce((p, q) => (distance(places, q, x, y) < distance(places, p, x, y) ? q : p)) / 3;
  }
  return best;
}

function cross(places, p, q, x, y) {
  return (places[p] - x) * (places[q + 1] - y) - (places[q] - x) * (places[p + 1] - y);
}

function distance(places, p, x, y) {
  return (places[p] - x) ** 2 + (places[p + 1] - y) ** 2;
}
