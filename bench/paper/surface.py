"""Triangle meshes as arrays: reading what the program writes, angles, defects, and their gradients.

Positions are n x 3, triangles m x 3, numbered from 0. Angles are in radians.
"""

import dataclasses

import numpy as np

PLY_TYPES = {"double": "<f8", "float": "<f4", "int": "<i4", "uint": "<u4", "uchar": "u1"}


@dataclasses.dataclass(frozen=True)
class Surface:
    positions: np.ndarray
    triangles: np.ndarray


def read_ply(path):
    """A binary PLY file of triangles, as `planish convert` writes it."""
    with open(path, "rb") as file:
        counts, columns = {}, []
        while (line := file.readline().decode("ascii").split())[0] != "end_header":
            if line[0] == "element":
                counts[line[1]] = int(line[2])
            elif line[0] == "property" and line[1] == "list":
                corners = [("size", PLY_TYPES[line[2]]), ("corners", PLY_TYPES[line[3]], 3)]
            elif line[0] == "property":
                columns.append((line[2], PLY_TYPES[line[1]]))
        vertices = np.fromfile(file, dtype=columns, count=counts["vertex"])
        faces = np.fromfile(file, dtype=corners, count=counts["face"])
    if len(faces) < counts["face"] or not np.all(faces["size"] == 3):
        raise ValueError(f"{path}: not a whole file of triangles")
    positions = np.stack([vertices[axis] for axis in "xyz"], axis=1).astype(float)
    return Surface(positions, faces["corners"].astype(np.int64))


def write_obj(path, surface):
    with open(path, "w", encoding="ascii") as file:
        file.writelines("v %.17g %.17g %.17g\n" % tuple(p) for p in surface.positions)
        file.writelines("f %d %d %d\n" % tuple(t + 1) for t in surface.triangles)


def norm(vectors):
    return np.sqrt(np.sum(vectors * vectors, axis=-1))


def dot(a, b):
    return np.sum(a * b, axis=-1)


def angle(a, b):
    """Angle between vectors; no cancellation near 0 and pi, unlike the arc cosine of Eq. 14."""
    return np.arctan2(norm(np.cross(a, b)), dot(a, b))


def corners(surface):
    """Yields for each corner of the triangles: numbers of its vertex p and of q and r after it."""
    for k in range(3):
        yield tuple(surface.triangles[:, (k + step) % 3] for step in range(3))


def is_inner(surface):
    """Which vertices are used and not on the border."""
    t, n = surface.triangles, len(surface.positions)
    ends = np.sort(np.concatenate([t[:, [0, 1]], t[:, [1, 2]], t[:, [2, 0]]]), axis=1)
    edges, count = np.unique(ends[:, 0] * n + ends[:, 1], return_counts=True)
    alone = edges[count == 1]
    inner = np.zeros(n, dtype=bool)
    inner[t] = True
    inner[alone // n] = inner[alone % n] = False
    return inner


def angle_sums(surface):
    x = surface.positions
    return sum(
        np.bincount(p, angle(x[q] - x[p], x[r] - x[p]), len(x)) for p, q, r in corners(surface)
    )


def defects(surface):
    """Eq. 3 at inner vertices, 0 at all others."""
    return np.where(is_inner(surface), 2.0 * np.pi - angle_sums(surface), 0.0)


def curvature(surface):
    """Discrete Gaussian curvature of Eq. 1: the defect over a third of the triangles around."""
    x, t = surface.positions, surface.triangles
    doubled = norm(np.cross(x[t[:, 1]] - x[t[:, 0]], x[t[:, 2]] - x[t[:, 0]]))
    around = sum(np.bincount(t[:, k], 0.5 * doubled, len(x)) for k in range(3))
    return defects(surface) / np.where(around > 0.0, around / 3.0, 1.0)


def angle_gradients(p, q, r):
    """How the angle at p between q and r changes as p, q, r move."""
    a, b = q - p, r - p
    normal = np.cross(a, b)
    normal = normal / norm(normal)[..., None]
    at_q = np.cross(a, normal) / dot(a, a)[..., None]
    at_r = -np.cross(b, normal) / dot(b, b)[..., None]
    return -(at_q + at_r), at_q, at_r


def scattered(n, where, vectors):
    """Sums of vectors by the vertex that they belong to."""
    return np.stack([np.bincount(where, vectors[:, k], n) for k in range(3)], axis=1)


def gradients(surface):
    """For each vertex v, as v moves: the gradient of its own angle sum, and that of the energy of
    Eq. 4, which at inner vertices is the gradient of the ring energy b_v."""
    x, d, n = surface.positions, defects(surface), len(surface.positions)
    own, energy = np.zeros((n, 3)), np.zeros((n, 3))
    for p, q, r in corners(surface):
        for k, (vertex, gradient) in enumerate(zip((p, q, r), angle_gradients(x[p], x[q], x[r]))):
            if k == 0:
                own += scattered(n, vertex, gradient)
            energy -= scattered(n, vertex, 2.0 * d[p][:, None] * gradient)
    return own, energy


def laplacians(surface):
    """L(v) of Eq. 9 with the paper's weights, which grow with the length of the edge."""
    x, n = surface.positions, len(surface.positions)
    weighted, weights = np.zeros((n, 3)), np.zeros(n)
    # Every edge of an inner vertex lies in two triangles and so counts twice, up and down alike.
    for p, q, r in corners(surface):
        for other in (q, r):
            edge = x[other] - x[p]
            length = norm(edge)
            weights += np.bincount(p, length, n)
            weighted += scattered(n, p, length[:, None] * edge)
    return weighted / np.where(weights > 0.0, weights, 1.0)[:, None]


def diagonal(surface):
    """Of the box around, along the axes."""
    return float(norm(np.ptp(surface.positions, axis=0)))
