"""Exact tests of what is written: every coordinate counts as the decimal number in the file.

Decimals are brought to whole numbers. A determinant is computed in doubles first, and in whole numbers where the
bound of its rounding error says that the sign may be wrong (Shewchuk 1997).
"""

from fractions import Fraction

import numpy as np

ERROR = 4.0 * np.finfo(float).eps  # of a determinant of differences, over the sum of its terms


def signs(p, q, r, exact):
    """Signs of the turn p, q, r of many triples of points.
    @param p, q, r numbers of points, @param exact the points as Fractions with their doubles"""
    places, doubles = exact
    u, v = doubles[q] - doubles[p], doubles[r] - doubles[p]
    left, right = u[:, 0] * v[:, 1], u[:, 1] * v[:, 0]
    scale = np.abs(left) + np.abs(right)
    size = np.abs(doubles).max(initial=0.0)
    # Differences of rounded decimals are off by up to an ulp of the coordinates.
    bound = ERROR * (scale + size * (np.abs(u).sum(axis=1) + np.abs(v).sum(axis=1)))
    result = np.sign(left - right).astype(int)
    for k in np.flatnonzero(~(np.abs(left - right) > bound)):
        a, b, c = places[p[k]], places[q[k]], places[r[k]]
        turn = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
        result[k] = (turn > 0) - (turn < 0)
    return result


def exact_points(texts):
    """@param texts pairs of decimals as written"""
    return [(Fraction(x), Fraction(y)) for x, y in texts], np.array([(float(x), float(y)) for x, y in texts])


def not_upright(points, triangles):
    """How many triangles are flipped or flat."""
    return int(np.count_nonzero(signs(triangles[:, 0], triangles[:, 1], triangles[:, 2], points) <= 0))


def border_of(triangles):
    sides = np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])
    known = set(map(tuple, sides.tolist()))
    return np.array([side for side in map(tuple, sides.tolist()) if side[::-1] not in known], int).reshape(-1, 2)


def crossings(points, sides):
    """How many pairs of sides cross inside both. @param sides pairs of numbers of points"""
    _, doubles = points
    starts, ends = doubles[sides[:, 0]], doubles[sides[:, 1]]
    low, high = np.minimum(starts, ends), np.maximum(starts, ends)
    size = float(np.ptp(doubles, axis=0).max())
    cell = max(float(np.median((high - low).max(axis=1))), size / 500.0, 1e-300)
    grid = {}
    for k, (first, last) in enumerate(zip(np.floor(low / cell).astype(int), np.floor(high / cell).astype(int))):
        for x in range(first[0], last[0] + 1):
            for y in range(first[1], last[1] + 1):
                grid.setdefault((x, y), []).append(k)
    pairs = set()
    for members in grid.values():
        if len(members) < 2:
            continue
        m = np.array(members)
        i, j = (m[part] for part in np.triu_indices(len(m), 1))
        near = np.all((low[i] <= high[j]) & (low[j] <= high[i]), axis=1)
        pairs.update(zip(i[near].tolist(), j[near].tolist()))
    if not pairs:
        return 0
    i, j = np.array(sorted(pairs)).T
    apart = (sides[i][:, :, None] != sides[j][:, None, :]).all(axis=(1, 2))
    i, j = i[apart], j[apart]
    (a, b), (c, d) = sides[i].T, sides[j].T
    one = signs(a, b, c, points) * signs(a, b, d, points)
    two = signs(c, d, a, points) * signs(c, d, b, points)
    return int(np.count_nonzero((one < 0) & (two < 0)))


def sides_of_loops(loops):
    """The points of closed polylines in a row, and their sides; points in the same place follow each other once."""
    texts, sides = [], []
    for loop in loops:
        kept = [p for k, p in enumerate(loop) if p != loop[k - 1]] or loop[:1]
        first = len(texts)
        texts += kept
        sides += [(first + k, first + (k + 1) % len(kept)) for k in range(len(kept))]
    return exact_points(texts), np.array(sides, int).reshape(-1, 2)
