"""The errata of the paper show what bench/paper says that they show, and what its figures are
computed and drawn with is right. Ends with 77 where numpy is not installed."""

import pathlib
import sys
import tempfile
import unittest
import xml.etree.ElementTree
import zlib

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed")
    sys.exit(77)

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[2] / "bench" / "paper"))

import chart
import directions
import errata
import fans
import picture
import surface
from surface import Surface


class Errata(unittest.TestCase):
    def test_each_is_shown_by_its_check(self):
        for erratum in errata.all_errata(errata.measured()):
            with self.subTest(erratum.where):
                self.assertTrue(erratum.shown, erratum.check)


class Surfaces(unittest.TestCase):
    def test_gradients_are_those_of_difference_quotients(self):
        grid = directions.staggered_saddle()
        own, energy = surface.gradients(grid)
        at, step = 7 * 21 + 9, 1e-5

        def moved(along):
            positions = grid.positions.copy()
            positions[at] += along
            return Surface(positions, grid.triangles)

        for k, axis in enumerate(np.eye(3)):
            ends = [surface.defects(moved(side * step * axis)) for side in (1, -1)]
            slopes = [-(ends[0][at] - ends[1][at]), np.sum(ends[0] ** 2) - np.sum(ends[1] ** 2)]
            self.assertAlmostEqual(own[at, k], slopes[0] / (2 * step), delta=1e-8)
            self.assertAlmostEqual(energy[at, k], slopes[1] / (2 * step), delta=1e-8)

    def test_laplacians_are_those_of_fans(self):
        grid = directions.staggered_saddle()
        at = 21 * 5 + 5
        around = np.unique(grid.triangles[np.any(grid.triangles == at, axis=1)])
        ring = grid.positions[around[around != at]]
        wanted = fans.laplacian(grid.positions[at], ring)
        self.assertLess(surface.norm(surface.laplacians(grid)[at] - wanted), 1e-15)

    def test_no_vertex_of_the_staggered_saddle_can_be_lowered(self):
        grid = directions.staggered_saddle()
        _, energy = surface.gradients(grid)
        inner = surface.is_inner(grid)
        slopes = surface.dot(surface.laplacians(grid), energy)[inner]
        self.assertEqual(inner.sum(), 361)
        self.assertTrue(np.all(surface.defects(grid)[inner] < 0.0))
        self.assertGreater(slopes.min(), -1e-16)

    def test_curvature_of_a_sphere_is_one_over_its_radius_squared(self):
        i, j = np.meshgrid(np.arange(41) - 20.0, np.arange(41) - 20.0)
        x, y = 0.01 * (i + 0.5 * (j % 2)), 0.01 * j
        radius = 2.0
        z = np.sqrt(radius**2 - x**2 - y**2)
        k = np.arange(41 * 41).reshape(41, 41)
        even = k[:-1, :-1][::2].ravel(), k[:-1, :-1][1::2].ravel()
        triangles = np.concatenate(
            [np.stack([a, a + 1, a + 41 + shift], axis=1) for shift, a in enumerate(even)]
            + [
                np.stack([even[0] + 1, even[0] + 42, even[0] + 41], axis=1),
                np.stack([even[1], even[1] + 42, even[1] + 41], axis=1),
            ]
        )
        ball = Surface(np.stack([x, y, z], axis=-1).reshape(-1, 3), triangles)
        inner = surface.curvature(ball)[surface.is_inner(ball)]
        self.assertLess(np.max(np.abs(inner * radius**2 - 1.0)), 0.02)


class Pictures(unittest.TestCase):
    def test_triangles_that_share_edges_cover_every_pixel_once(self):
        square = np.array([[0.0, 0, 0], [40, 0, 0], [40, 30, 0], [0, 30, 0], [17.3, 11.9, 0]])
        pieces = np.array([[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]])
        pixel, triangle, weights = picture.fragments(square, pieces, 40, 30)
        self.assertEqual(sorted(pixel), list(range(40 * 30)))
        places = np.einsum("ij,ijk->ik", weights, square[pieces[triangle]])
        wanted = np.stack([pixel % 40 + 0.5, pixel // 40 + 0.5], axis=1)
        self.assertLess(np.max(np.abs(places[:, :2] - wanted)), 1e-9)

    def test_png_holds_the_pixels(self):
        pixels = np.zeros((3, 5, 3))
        pixels[1, 2] = [255.0, 0.0, 255.0]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "p.png"
            picture.write_png(path, pixels)
            data = path.read_bytes()
        at = data.index(b"IDAT")
        rows = zlib.decompress(data[at + 4 : at + 4 + int.from_bytes(data[at - 4 : at], "big")])
        differences = np.frombuffer(rows, np.uint8).reshape(3, 16)[:, 1:].reshape(3, 5, 3)
        read = np.cumsum(differences, axis=0, dtype=np.uint8)
        self.assertTrue(np.array_equal(read, pixels.astype(np.uint8)))

    def test_chart_is_well_formed(self):
        curve = chart.Series("a < b", [1, 10, 100], [1.0, 0.5, 1e-3])
        panel = chart.Panel("t", chart.Axis("x", is_log=True), chart.Axis("y"), [curve])
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "c.svg"
            chart.write_svg(path, [panel, panel])
            root = xml.etree.ElementTree.parse(path).getroot()
        self.assertEqual(sum(e.tag.endswith("polyline") for e in root), 2)


if __name__ == "__main__":
    unittest.main()
