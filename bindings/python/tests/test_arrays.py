"""Arrays in and out: whatever is wrong is one exception, and views outlive what they are of."""

import gc
import types
import unittest

import numpy as np

import planish


def grid(n=5):
    """A plane square of (n + 1)^2 vertices."""
    x, y = np.meshgrid(np.arange(n + 1.0), np.arange(n + 1.0))
    vertices = np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1)
    corner = (np.arange(n)[:, None] * (n + 1) + np.arange(n)).ravel()
    low = np.stack([corner, corner + 1, corner + n + 2], axis=1)
    high = np.stack([corner, corner + n + 2, corner + n + 1], axis=1)
    return vertices, np.concatenate([low, high])


class GoodArrays(unittest.TestCase):
    def setUp(self):
        self.vertices, self.faces = grid()

    def assert_same(self, vertices, faces):
        mesh = planish.Mesh(vertices, faces)
        np.testing.assert_array_equal(mesh.vertices, self.vertices)
        np.testing.assert_array_equal(mesh.faces, self.faces)

    def test_every_numeric_type(self):
        for kind in (np.float32, np.float64, np.int16, np.uint8, np.longdouble, ">f8"):
            self.assert_same(self.vertices.astype(kind), self.faces)
        for kind in (np.int16, np.int64, np.uint8, np.uint64, ">i4"):
            self.assert_same(self.vertices, self.faces.astype(kind))

    def test_every_order(self):
        self.assert_same(np.asfortranarray(self.vertices), np.asfortranarray(self.faces))
        padded = np.zeros((72, 6))
        padded[::2, ::2] = self.vertices
        self.assert_same(padded[::2, ::2], self.faces[::-1][::-1])
        self.assert_same(self.vertices.tolist(), self.faces.tolist())

    def test_read_only(self):
        self.vertices.flags.writeable = False
        self.faces.flags.writeable = False
        self.assert_same(self.vertices, self.faces)

    def test_input_is_not_changed(self):
        before = self.vertices.copy()
        planish.evolve(self.vertices + [[0, 0, 0]], self.faces)
        planish.evolve(self.vertices, self.faces)
        np.testing.assert_array_equal(self.vertices, before)

    def test_meshes_of_other_packages(self):
        pair = self.vertices, self.faces
        trimesh = types.SimpleNamespace(vertices=self.vertices, faces=self.faces)
        meshio = types.SimpleNamespace(points=self.vertices, cells=[], cells_dict={"triangle": self.faces})
        pyvista = types.SimpleNamespace(points=self.vertices, regular_faces=self.faces, cells_dict={})
        for mesh in (pair, trimesh, meshio, pyvista):
            np.testing.assert_array_equal(planish.unfold(mesh).faces, self.faces)

    def test_mesh_of_meshio_and_back(self):
        result = planish.unfold(self.vertices, self.faces)
        flat = result.to_meshio(flat=True)
        np.testing.assert_array_equal(flat.points[:, :2], result.uv)
        np.testing.assert_array_equal(planish.unfold(result.to_meshio()).uv, result.uv)


class BadArrays(unittest.TestCase):
    def setUp(self):
        self.vertices, self.faces = grid()

    def refuse(self, kind, words, vertices, faces):
        with self.assertRaisesRegex(kind, words) as caught:
            planish.flatten(vertices, faces)
        self.assertNotIn("\n", str(caught.exception))
        return caught.exception

    def test_index_out_of_range(self):
        for index in (36, 2**32, 2**32 + 1, 2**40, -1, -(2**63)):
            faces = self.faces.astype(np.int64)
            faces[7, 1] = index
            error = self.refuse(planish.FormatError, f"triangle 7 names vertex {index},", self.vertices, faces)
            self.assertEqual((error.code, error.place.first), ("index_out_of_range", 7))
        faces = self.faces.astype(np.uint64)
        faces[0, 0] = 2**64 - 1
        self.refuse(planish.FormatError, "names vertex 18446744073709551615,", self.vertices, faces)

    def test_not_finite(self):
        for value in (np.nan, np.inf, -np.inf):
            vertices = self.vertices.copy()
            vertices[3, 2] = value
            error = self.refuse(planish.MeshError, "vertex 3", vertices, self.faces)
            self.assertEqual(error.code, "non_finite_coordinate")

    def test_types(self):
        self.refuse(TypeError, "vertices must be numbers", self.vertices.astype(complex), self.faces)
        self.refuse(TypeError, "vertices must be numbers", self.vertices.astype(str), self.faces)
        self.refuse(TypeError, "vertices must be numbers", self.vertices.astype(object), self.faces)
        self.refuse(TypeError, "vertices must be numbers", None, self.faces)
        self.refuse(TypeError, "faces must be whole numbers", self.vertices, self.faces.astype(float))
        self.refuse(TypeError, "faces must be whole numbers", self.vertices, self.faces.astype(bool))
        self.refuse(TypeError, "faces must be whole numbers", self.faces, self.vertices)

    def test_shapes(self):
        self.refuse(ValueError, r"vertices must have the shape \(n, 3\), not \(36, 2\)", self.vertices[:, :2], self.faces)
        self.refuse(ValueError, "vertices must have the shape", self.vertices.ravel(), self.faces)
        self.refuse(ValueError, "vertices must have the shape", self.vertices[None], self.faces)
        self.refuse(ValueError, "divide each quad", self.vertices, np.zeros((4, 4), dtype=int))
        self.refuse(ValueError, "faces must have the shape", self.vertices, self.faces.ravel())

    def test_empty(self):
        self.refuse(planish.FormatError, "no triangles", self.vertices, np.zeros((0, 3), dtype=int))
        self.refuse(planish.FormatError, "no triangles", np.zeros((0, 3)), [])
        self.refuse(planish.FormatError, "3 vertices|0 vertices", np.zeros((0, 3)), [[0, 1, 2]])

    def test_not_a_mesh(self):
        for thing in (None, 5, {"a": 1}, object(), self.vertices):
            with self.assertRaisesRegex(TypeError, "a mesh is two arrays"):
                planish.measure(thing)
        quads = types.SimpleNamespace(points=self.vertices, cells_dict={"quad": np.zeros((1, 4), dtype=int)})
        with self.assertRaisesRegex(ValueError, "cells of type quad"):
            planish.measure(quads)

    def test_broken_meshes(self):
        with self.assertRaises(planish.MeshError) as caught:
            planish.flatten(self.vertices, np.concatenate([self.faces, self.faces[:1]]))
        self.assertEqual(caught.exception.code, "duplicate_triangle")
        codes = [problem["code"] for problem in planish.Mesh(self.vertices, self.faces[:, ::-1][:4]).problems]
        self.assertIn("unreferenced_vertex", codes)


class Views(unittest.TestCase):
    def test_no_copy_and_read_only(self):
        result = planish.unfold(*grid())
        for name in ("vertices", "faces", "uv"):
            view = getattr(result, name)
            self.assertIs(view.base, result)
            with self.assertRaises(ValueError):
                view[0] = 0
            self.assertEqual(view.ctypes.data, getattr(result, name).ctypes.data)

    def test_views_outlive_results(self):
        results = {
            "flatten": planish.flatten(*grid()),
            "unfold": planish.unfold(*grid()),
            "measure": planish.measure(*grid()),
            "compare": planish.compare(*grid(), methods="controllable").runs[0],
            "sweep": next(planish.evolve_sweeps(planish.sample("panel", vertices=200))),
        }
        views = {name: (result.vertices, result.vertices.copy()) for name, result in results.items()}
        fields = results["flatten"].fields["offset"]
        kept = fields.copy()
        del results
        for _ in range(20):
            gc.collect()
            np.full(100_000, 7.0)
        for view, copy in views.values():
            np.testing.assert_array_equal(view, copy)
        np.testing.assert_array_equal(fields, kept)

    def test_compared_methods_outlive_their_comparison(self):
        runs = planish.compare(*grid(), methods="controllable").runs
        gc.collect()
        self.assertEqual(runs[0].vertices.shape, (36, 3))


if __name__ == "__main__":
    unittest.main()
