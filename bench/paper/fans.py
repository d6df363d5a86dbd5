"""Random fans, a vertex and its two rings: all that a move of the vertex can change is in them, so
they are enough to check every formula of the paper. And the formulas, as they are printed."""

import functools

import numpy as np

from surface import Surface, angle, angle_sums, dot, is_inner, norm

NEXT, BEFORE = -1, 1  # shifts of np.roll that bring a ring vertex its neighbour


class Fan:
    """Vertex 0 is the one that moves, 1 to n its ring in order, the rest their other neighbours."""

    def __init__(self, surface, n):
        self.surface, self.n = surface, n
        self.centre, self.ring = surface.positions[0], surface.positions[1 : n + 1]
        self.ring_is_inner = is_inner(surface)[1 : n + 1]
        self.sums = angle_sums(surface)[: n + 1]

    def laplacian_of(self, v):
        t = self.surface.triangles
        around = np.unique(t[np.any(t == v, axis=1)])
        return laplacian(self.surface.positions[v], self.surface.positions[around[around != v]])

    @functools.cached_property
    def laplacian(self):
        return self.laplacian_of(0)

    @property
    def least_angle(self):
        """Of the triangles about the vertex."""
        to = self.ring - self.centre
        sides = [to, np.roll(to, NEXT, axis=0)]
        sides.append(sides[1] - sides[0])
        return float(
            min(
                angle(sides[0], sides[1]).min(),
                angle(-sides[0], sides[2]).min(),
                angle(sides[1], sides[2]).min(),
            )
        )

    def sums_at(self, steps):
        """Angle sums of the vertex and of its ring, a row for each step lambda along L(v)."""
        at = self.centre + np.multiply.outer(np.atleast_1d(steps), self.laplacian)
        apex = angle_sum(at, self.ring)
        change = base_angles(at, self.ring) - base_angles(self.centre, self.ring)
        return np.concatenate([apex[:, None], self.sums[1:] + change], axis=1)

    def defects_at(self, steps):
        """The same as defects; 0 for what is on the border."""
        measured = np.concatenate([[True], self.ring_is_inner])
        return np.where(measured, 2.0 * np.pi - self.sums_at(steps), 0.0)

    def energy_at(self, steps):
        """Eq. 4: the outer vertices are on the border and have no term in it."""
        return np.sum(self.defects_at(steps) ** 2, axis=1)


def laplacian(v, ring):
    """Eq. 9 with the paper's weights, which grow with the length of the edge."""
    weights = norm(ring - v)
    return weights @ ring / weights.sum() - v


def angle_sum(x, ring):
    """At places x, with a ring around."""
    to = ring - x[..., None, :]
    return np.sum(angle(to, np.roll(to, NEXT, axis=-2)), axis=-1)


def base_angles(x, ring):
    """Sum of the two angles at each ring vertex that change with x."""
    to = x[..., None, :] - ring
    return sum(angle(to, np.roll(ring, side, axis=0) - ring) for side in (BEFORE, NEXT))


def circle(n, radius, random):
    """Points about a circle in the plane z = 0, up to a fifth of their distance beside it."""
    at = 2.0 * np.pi * (np.arange(n) + 0.4 * (random.random(n) - 0.5)) / n
    reach = radius * (0.8 + 0.4 * random.random(n))
    return np.stack([reach * np.cos(at), reach * np.sin(at), np.zeros(n)], axis=1)


def two_ring_fan(random, border_share):
    """@param border_share of the ring's vertices that are on the border"""
    n = int(random.integers(3, 10))
    positions = np.vstack([[[0.0] * 3], circle(n, 1.0, random), circle(2 * n, 2.0, random)])
    positions += 0.2 * random.standard_normal(positions.shape)
    triangles = []
    for j in range(n):
        this, after = 1 + j, 1 + (j + 1) % n
        outer = [1 + n + (2 * j + k) % (2 * n) for k in range(3)]
        triangles += [[0, this, after], [this, outer[1], after], [after, outer[1], outer[2]]]
        if random.random() >= border_share:  # without this triangle it is on the border
            triangles.append([this, outer[0], outer[1]])
    return Fan(Surface(positions, np.array(triangles)), n)


def random_fans(count, border_share=0.25, seed=2010):
    """Without needles about the vertex, of which difference quotients would tell little."""
    random = np.random.default_rng(seed)
    found = []
    while len(found) < count:
        fan = two_ring_fan(random, border_share)
        found += [fan] if fan.least_angle > np.radians(15.0) else []
    return found


def slope(function, step=1e-3):
    """Of a function of lambda at 0: difference quotient of the sixth order."""
    first, second, third = (function(k * step) - function(-k * step) for k in (1, 2, 3))
    return (45.0 * first - 9.0 * second + third) / (60.0 * step)


def csc(x):
    return 1.0 / np.sin(x)


def cot(x):
    return 1.0 / np.tan(x)


def eq_16(x, ring, direction):
    """As printed: how the angle sum of the vertex changes with lambda."""
    p, q = x - ring, x - np.roll(ring, NEXT, axis=0)
    alpha = angle(p, q)
    along_p, along_q = p @ direction, q @ direction
    return np.sum(
        -csc(alpha) * (along_p + along_q) / (norm(p) * norm(q))
        + cot(alpha) * (along_p / dot(p, p) + along_q / dot(q, q))
    )


def eq_17(x, ring, directions):
    """As printed: how the angle sum of each ring vertex changes with lambda.

    @param directions what stands for L in the row of each: L(v_j) as printed, or L(v)"""
    p = x - ring
    along = dot(p, directions)
    total = np.zeros(len(ring))
    for side in (BEFORE, NEXT):
        q = x - np.roll(ring, side, axis=0)
        edge = norm(p - q)
        beta = angle(p, p - q)
        total += -csc(beta) * (along - dot(q, directions)) / (norm(p) * edge)
        total += cot(beta) * along / dot(p, p)
    return total


def eq_15(defects, own, of_ring, counts):
    """@param counts which of the ring are in the sum"""
    return -2.0 * defects[0] * own - 2.0 * np.sum((defects[1:] * of_ring)[counts])


def eq_12(x, ring, power):
    """Eq. 12 of [1], the gradient of the angle sum; @param power of the edge in the denominator"""
    to = ring - x
    weights = sum(
        cot(angle(x - ring, np.roll(ring, side, axis=0) - ring)) for side in (BEFORE, NEXT)
    )
    return np.sum((weights / norm(to) ** power)[:, None] * to, axis=0)
