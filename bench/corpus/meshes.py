"""Disks and holed patches of a corpus: from formulas, and cut out of whole meshes; and what may be wrong with them."""

import heapq
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "paper"))

from formulas import FAMILIES
from surface import norm


def sheet(vertices, aspect, rng):
    """Jittered points in [0, 1]^2, about this number of them, and a triangulation."""
    columns = max(4, round(np.sqrt(vertices * aspect)))
    rows = max(4, round(vertices / columns))
    places, triangles = [], []
    for j in range(rows + 1):
        u = np.arange(columns + 1) / columns + (0.5 / columns if 0 < j < rows and j % 2 else 0.0)
        inner = (u > 0.0) & (u < 1.0) & (0 < j < rows)
        jitter = rng.uniform(-0.2, 0.2, (2, columns + 1)) * inner
        u[-1] = 1.0
        places.append(np.stack([np.clip(u + jitter[0] / columns, 0.0, 1.0), j / rows + jitter[1] / rows], axis=1))
        places[-1][0, 0] = 0.0
    for j in range(rows):
        for i in range(columns):
            a, b = j * (columns + 1) + i, (j + 1) * (columns + 1) + i
            corners = [(a, a + 1, b + 1), (a, b + 1, b)] if j % 2 else [(a, a + 1, b), (a + 1, b + 1, b)]
            triangles += corners
    return np.concatenate(places), np.array(triangles)


def largest_part(triangles):
    """The triangles that hang together by edges, of the largest such part."""
    by_edge = {}
    for t, (a, b, c) in enumerate(triangles):
        for edge in ((a, b), (b, c), (c, a)):
            by_edge.setdefault((min(edge), max(edge)), []).append(t)
    parent = list(range(len(triangles)))

    def root(t):
        while parent[t] != t:
            parent[t] = parent[parent[t]]
            t = parent[t]
        return t

    for sharing in by_edge.values():
        for t in sharing[1:]:
            parent[root(t)] = root(sharing[0])
    roots = np.array([root(t) for t in range(len(triangles))])
    values, counts = np.unique(roots, return_counts=True)
    return triangles[roots == values[np.argmax(counts)]]


def without_touching_corners(triangles):
    """A surface whose border passes no vertex twice: triangles go until it is so."""
    while True:
        sides = {(int(t[k]), int(t[(k + 1) % 3])) for t in triangles for k in range(3)}
        starts = [a for a, b in sides if (b, a) not in sides]
        vertices, counts = np.unique(starts, return_counts=True)
        twice = set(vertices[counts > 1].tolist())
        if not twice:
            return triangles
        kept = largest_part(np.array([t for t in triangles if not twice.intersection(t.tolist())]).reshape(-1, 3))
        if len(kept) == 0:
            return kept
        triangles = kept


def compact(positions, triangles):
    used = np.unique(triangles)
    number = np.full(len(positions), -1)
    number[used] = np.arange(len(used))
    return positions[used], number[triangles]


def with_holes(places, triangles, count, rng):
    """Without the triangles over a few ellipses that keep clear of the border."""
    centres = places[triangles].mean(axis=1)
    away = np.zeros(len(triangles), bool)
    for _ in range(count):
        middle, half = rng.uniform(0.25, 0.75, 2), rng.uniform(0.04, 0.14, 2)
        away |= np.sum(((centres - middle) / half) ** 2, axis=1) < 1.0
    kept = triangles[~away]
    return without_touching_corners(largest_part(kept)) if len(kept) else triangles


def by_formula(family, vertices, rng):
    surface = FAMILIES[family](rng)
    corners = surface(np.array([0.0, 1.0, 0.0]), np.array([0.0, 0.0, 1.0]))
    along, across = norm(corners[1] - corners[0]), norm(corners[2] - corners[0])
    aspect = np.clip(along / max(across, 1e-9), 0.2, 5.0)
    places, triangles = sheet(vertices, aspect, rng)
    if rng.random() < 0.2:
        triangles = with_holes(places, triangles, rng.integers(1, 4), rng)
    return compact(surface(places[:, 0], places[:, 1]), triangles)


def region(positions, triangles, most, rng):
    """A patch that grows over a mesh from a random triangle, nearest first, and stays a disk."""
    neighbours = {}
    for t, (a, b, c) in enumerate(triangles.tolist()):
        for edge in ((a, b), (b, c), (c, a)):
            neighbours.setdefault((min(edge), max(edge)), []).append(t)
    centres = positions[triangles].mean(axis=1)
    first = int(rng.integers(len(triangles)))
    distance = norm(centres - centres[first])
    taken, vertices, edges = set(), set(), set()
    front, seen = [(0.0, first)], {first}
    def edges_of(t):
        a, b, c = triangles[t].tolist()
        return [(min(e), max(e)) for e in ((a, b), (b, c), (c, a))]

    while front and len(taken) < most:
        _, t = heapq.heappop(front)
        old_vertices = len(vertices.intersection(triangles[t].tolist()))
        old_edges = len(edges.intersection(edges_of(t)))
        # What a triangle adds must be a disk's: it shares one edge, or two with their vertices.
        if taken and (old_edges, old_vertices) not in ((1, 2), (2, 3)):
            seen.discard(t)
            continue
        taken.add(t)
        vertices.update(triangles[t].tolist())
        edges.update(edges_of(t))
        for edge in edges_of(t):
            for other in neighbours[edge]:
                if len(neighbours[edge]) == 2 and other not in seen:
                    seen.add(other)
                    heapq.heappush(front, (float(distance[other]), other))
    return compact(positions, triangles[sorted(taken)])


def mean_edge(positions, triangles):
    return float(np.mean([norm(positions[triangles[:, k]] - positions[triangles[:, (k + 1) % 3]]).mean()
                          for k in range(3)]))


def vertex_normals(positions, triangles):
    a, b, c = (positions[triangles[:, k]] for k in range(3))
    normals = np.zeros_like(positions)
    across = np.cross(b - a, c - a)
    for k in range(3):
        np.add.at(normals, triangles[:, k], across)
    lengths = norm(normals)
    return normals / np.where(lengths > 0.0, lengths, 1.0)[:, None]


def noisy(positions, triangles, rng):
    """Noise along the normals, of 2 to 10 % of an edge."""
    height = rng.uniform(0.02, 0.1) * mean_edge(positions, triangles)
    return positions + height * rng.standard_normal(len(positions))[:, None] * vertex_normals(positions, triangles)


def with_needles(positions, triangles, rng):
    """Some inner edges are divided very near to one end, so that needles arise, down to 1/10,000 of an edge."""
    sides = {}
    for t, corners in enumerate(triangles.tolist()):
        for k in range(3):
            sides[(corners[k], corners[(k + 1) % 3])] = t
    inner = [side for side in sides if (side[1], side[0]) in sides and side[0] < side[1]]
    chosen = rng.permutation(len(inner))[:max(1, len(inner) // 40)]
    points, lists, busy = positions.tolist(), {t: c for t, c in enumerate(triangles.tolist())}, set()
    for number in chosen:
        a, b = inner[number]
        pair = (sides[(a, b)], sides[(b, a)])
        if busy.intersection(pair):
            continue
        busy.update(pair)
        share = 10.0 ** rng.uniform(-4.0, -1.0)
        points.append(((1.0 - share) * positions[a] + share * positions[b]).tolist())
        new = len(points) - 1
        for t, (p, q) in zip(pair, ((a, b), (b, a))):
            (r,) = set(lists[t]) - {p, q}
            lists[t] = [p, new, r]
            lists[len(lists)] = [new, q, r]
    return np.array(points), np.array([lists[t] for t in range(len(lists))])
