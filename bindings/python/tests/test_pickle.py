"""Meshes and results go to other processes and come back."""

import concurrent.futures
import multiprocessing
import pathlib
import pickle
import tempfile
import unittest

import numpy as np

import planish


def copied(value):
    return pickle.loads(pickle.dumps(value))


def flattened(mesh):
    return planish.flatten(mesh, max_strain="2%", allowance="10mm", threads=1)


class Pickle(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.panel = planish.sample("panel", vertices=300)

    def test_meshes(self):
        mesh = copied(self.panel)
        np.testing.assert_array_equal(mesh.vertices, self.panel.vertices)
        np.testing.assert_array_equal(mesh.faces, self.panel.faces)
        self.assertEqual(mesh.name, self.panel.name)

    def test_results_keep_their_figures_and_arrays(self):
        panel = self.panel
        for result in (
            flattened(panel),
            planish.flatten(panel, method="controllable", match_seams=True),
            planish.flatten(planish.sample("panel", vertices=6000), remesh=True, sweeps=2),
            planish.unfold(panel, max_strain="3%"),
            planish.evolve(panel, sweeps=3),
            planish.measure(panel, material="leather"),
            planish.compare(panel, methods="controllable,classical"),
            planish.suggest_cuts(panel, max_strain="3%"),
            planish.suggest_panels(panel, effort=1),
        ):
            with self.subTest(type(result).__name__):
                other = copied(result)
                self.assertEqual(other.figures, result.figures)
                for name in ("vertices", "faces", "uv", "source", "panel_of"):
                    if getattr(result, name, None) is not None:
                        np.testing.assert_array_equal(getattr(other, name), getattr(result, name))
                for name, values in getattr(result, "fields", {}).items():
                    np.testing.assert_array_equal(other.fields[name], values)

    def test_parts_of_results(self):
        compared = planish.compare(self.panel, methods="controllable,classical", sweeps=2)
        for run in compared.runs:
            other = copied(run)
            self.assertEqual((other.method, other.failure), (run.method, run.failure))
            np.testing.assert_array_equal(other.vertices, run.vertices)
        for sweep in planish.evolve_sweeps(self.panel, sweeps=2):
            other = copied(sweep)
            for name in ("sweep", "e_max", "e_avg", "energy", "moved", "seconds"):
                self.assertEqual(getattr(other, name), getattr(sweep, name))

    def test_every_public_result_is_tried(self):
        classes = {name for name in planish.__all__ if isinstance(getattr(planish, name), type)}
        results = {name for name in classes if name.endswith(("Result", "Method")) or name in {"Mesh", "Sweep"}}
        compared = planish.compare(self.panel, methods="controllable", sweeps=1)
        made = [
            self.panel,
            planish.flatten(self.panel, no_report=True),
            planish.flatten_product({"a": self.panel}),
            planish.unfold(self.panel),
            planish.evolve(self.panel, sweeps=1),
            planish.measure(self.panel),
            compared,
            compared.runs[0],
            next(iter(planish.evolve_sweeps(self.panel, sweeps=1))),
            planish.suggest_cuts(self.panel, max_strain="90%"),
            planish.suggest_panels(self.panel, effort=1),
        ]
        tried = {type(copied(value)).__name__ for value in made}
        self.assertEqual(tried, results)

    def test_copies_write_the_same_files(self):
        result = flattened(self.panel)
        other = copied(result)
        for kind in ("svg", "dxf", "pdf", "plt"):
            self.assertEqual(getattr(other, kind)(), getattr(result, kind)())
        self.assertEqual(other.svg(allowance="4mm"), result.svg(allowance="4mm"))
        self.assertEqual(other.svg(as_designed=True), result.svg(as_designed=True))
        self.assertEqual(other.report_html(), result.report_html())
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as two:
            paths, others = result.save(one), other.save(two)
            self.assertEqual(paths.keys(), others.keys())
            for role in paths:
                if role != "report_json":  # it has the paths
                    self.assertEqual(pathlib.Path(paths[role]).read_bytes(), pathlib.Path(others[role]).read_bytes())
        unfolded = planish.unfold(self.panel)
        self.assertEqual(copied(unfolded).svg(), unfolded.svg())

    def test_products(self):
        product = planish.flatten_product({"front": self.panel, "back": planish.sample("dome", vertices=200)}, sweeps=1)
        other = copied(product)
        self.assertEqual(other.figures, product.figures)
        self.assertEqual(other.missed, product.missed)
        self.assertEqual(other.layout_svg(), product.layout_svg())
        self.assertEqual(other.patches[1].svg(), product.patches[1].svg())

    def test_other_processes_give_results_back(self):
        meshes = [self.panel, planish.sample("saddle", vertices=300)]
        context = multiprocessing.get_context("spawn")
        with concurrent.futures.ProcessPoolExecutor(2, mp_context=context) as pool:
            for mesh, result in zip(meshes, pool.map(flattened, meshes)):
                self.assertEqual(result.svg(), flattened(mesh).svg())

    def test_what_is_damaged_is_refused(self):
        rebuild, arguments, state = self.panel.__reduce_ex__(2)[:3]
        version, content = state
        for wrong in (("0.0.0", content), (version, content[:-1]), (version, content + b"x"), (version, b""), ()):
            with self.assertRaises((ValueError, RuntimeError)):
                rebuild(*arguments).__setstate__(wrong)


if __name__ == "__main__":
    unittest.main()
