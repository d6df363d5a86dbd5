"""Planted surfaces: a developable, an outline, bumps along the normal, and the meshes of both."""

import dataclasses
import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "paper"))

from developables import norms
from surface import Surface

SAMPLED = 401  # rulings by which area and width are known
ROW = 0.5 * np.sqrt(3.0)  # height of an equilateral triangle
GOLDEN = 0.5 * (np.sqrt(5.0) - 1.0)
JITTER = 0.2  # of the distance between vertices, along the rulings


@dataclasses.dataclass(frozen=True)
class Bump:
    """height (1 - d^2)^3 where d < 1, else 0: value, slope and curvature end at 0.

    a, b place and ra, rb half widths, across the rulings and along them, as shares of the outline;
    height as a share of the root of the area; turn in degrees; waves over the half width ra.
    """

    a: float
    b: float
    ra: float
    rb: float
    height: float
    turn: float = 0.0
    waves: float = 0.0

    def reach(self):
        """How far it goes from its place, in a and in b."""
        c, s = np.cos(np.radians(self.turn)), np.sin(np.radians(self.turn))
        return np.hypot(self.ra * c, self.rb * s), np.hypot(self.ra * s, self.rb * c)

    def is_inside(self):
        """Whether it ends before or at the border."""
        reach = self.reach()
        return all(reach[k] <= at <= 1.0 - reach[k] for k, at in enumerate((self.a, self.b)))

    def heights(self, a, b):
        c, s = np.cos(np.radians(self.turn)), np.sin(np.radians(self.turn))
        x = (c * (a - self.a) + s * (b - self.b)) / self.ra
        y = (c * (b - self.b) - s * (a - self.a)) / self.rb
        window = np.maximum(1.0 - x * x - y * y, 0.0) ** 3
        return self.height * window * np.cos(2.0 * np.pi * self.waves * x)


@dataclasses.dataclass(frozen=True)
class Planted:
    """@param rulings of developables.py
    @param outline a -> first and last place on a ruling, in mm; a in [0, 1] across the rulings"""

    name: str
    what: str
    rulings: object
    outline: object
    bumps: tuple

    def ends(self, count):
        """First and last points of so many rulings."""
        points, directions = self.rulings(count)
        low, high = self.outline(np.linspace(0.0, 1.0, count))
        return points + low[:, None] * directions, points + high[:, None] * directions

    def size(self):
        """Area, and mean width across the rulings."""
        low, high = self.ends(SAMPLED)
        area = 0.5 * np.sum(norms(np.cross(low[1:] - high[:-1], low[:-1] - high[1:])))
        return area, area / np.mean(norms(high - low))


def places(width, spacing, is_odd):
    """Of the vertices of a row, as shares of its width: odd ones lie half a step off."""
    count = max(2, round(width / spacing))
    if is_odd:
        return np.concatenate([[0.0], (np.arange(count) + 0.5) / count, [1.0]])
    return np.arange(count + 1) / count


def moved(shares, first):
    """Inner places jittered by fractions of the golden ratio: no random numbers, yet no pattern.
    @param first number of the row's first vertex"""
    fractions = np.modf((first + np.arange(len(shares))) * GOLDEN)[0] - 0.5
    result = shares.copy()
    gap = np.minimum(shares[1:-1] - shares[:-2], shares[2:] - shares[1:-1])
    result[1:-1] += 2.0 * JITTER * gap * fractions[1:-1]
    return result


def strip(low, high, positions):
    """Triangles between two rows of vertices: the shorter diagonal each time."""
    triangles, i, j = [], 0, 0
    while i + 1 < len(low) or j + 1 < len(high):
        across = [np.inf, np.inf]
        if i + 1 < len(low):
            across[0] = norms(positions[low[i + 1]] - positions[high[j]])
        if j + 1 < len(high):
            across[1] = norms(positions[low[i]] - positions[high[j + 1]])
        if across[0] <= across[1]:
            triangles.append((low[i], high[j], low[i + 1]))
            i += 1
        else:
            triangles.append((low[i], high[j], high[j + 1]))
            j += 1
    return triangles


def row_normals(low, high):
    """Of each ruling: the mean of those of the planes on its two sides."""
    planes = np.cross(high[1:] - low[:-1], high[:-1] - low[1:])
    planes /= norms(planes)[:, None]
    sums = np.concatenate([planes[:1], planes[1:] + planes[:-1], planes[-1:]])
    return sums / norms(sums)[:, None]


def meshes(planted, vertices):
    """Design and developable, of about so many vertices and of the same triangles."""
    area, width = planted.size()
    spacing = np.sqrt(area / (ROW * vertices))
    low, high = planted.ends(round(width / (ROW * spacing)) + 1)
    rows, a, b, count = [], [], [], 0
    for k, length in enumerate(norms(high - low)):
        shares = moved(places(length, spacing, k % 2 == 1), count)
        rows.append(np.arange(count, count + len(shares)))
        a.append(np.full(len(shares), k / (len(low) - 1)))
        b.append(shares)
        count += len(shares)
    of_row = np.repeat(np.arange(len(rows)), [len(row) for row in rows])
    a, b = np.concatenate(a), np.concatenate(b)
    flat = low[of_row] + b[:, None] * (high - low)[of_row]
    triangles = np.array([t for pair in zip(rows, rows[1:]) for t in strip(*pair, flat)])
    heights = np.sqrt(area) * sum(bump.heights(a, b) for bump in planted.bumps)
    bumpy = flat + heights[:, None] * row_normals(low, high)[of_row]
    return Surface(bumpy, triangles), Surface(flat, triangles)
