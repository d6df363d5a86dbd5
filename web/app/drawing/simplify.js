// Lines of many points as lines of few.
import { boxOf } from '../mesh.js';

/** @typedef {import('../project.js').Line} Line */
/** @typedef {import('../project.js').Point} Point */

/**
 * How far a point is from the straight part between two others.
 * @param {Point} point
 * @param {Point} from
 * @param {Point} to
 */
function away(point, from, to) {
  const way = to.map((x, k) => x - from[k]);
  const own = point.map((x, k) => x - from[k]);
  const square = way.reduce((sum, x) => sum + x * x, 0);
  const along = square > 0 ? own.reduce((sum, x, k) => sum + x * way[k], 0) / square : 0;
  const share = Math.min(1, Math.max(0, along));
  return Math.hypot(...own.map((x, k) => x - share * way[k]));
}

/**
 * The points that a line cannot do without (Douglas and Peucker 1973).
 * @param {Point[]} points
 * @param {number} tolerance how far the line may be from those left out
 * @returns {Point[]}
 */
export function simplified(points, tolerance) {
  if (points.length < 3) return points;
  const last = points.length - 1;
  let worst = 0;
  let most = -1;
  for (let i = 1; i < last; ++i) {
    const far = away(points[i], points[0], points[last]);
    if (far > most) [worst, most] = [i, far];
  }
  if (most <= tolerance) return [points[0], points[last]];
  const before = simplified(points.slice(0, worst + 1), tolerance);
  return [...before.slice(0, -1), ...simplified(points.slice(worst), tolerance)];
}

/**
 * A line whose points can be moved, near one that was drawn.
 * @param {Point[]} points of that
 * @param {Float32Array} positions of the model
 * @returns {Line}
 */
export function loosened(points, positions) {
  const { low, high } = boxOf(positions);
  const diagonal = Math.hypot(...high.map((x, k) => x - low[k]));
  return { kind: 'shortest', points: simplified(points, 0.01 * diagonal) };
}
