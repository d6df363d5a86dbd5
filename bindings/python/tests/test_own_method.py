"""Methods of one's own: functions and results."""

import os
import pickle
import runpy
import signal
import threading
import unittest
from pathlib import Path

import numpy as np

import planish

EXAMPLES = Path(__file__).resolve().parents[3] / "examples/python"


def lengths(vectors):
    return np.linalg.norm(vectors, axis=1)


def laplacian(patch, share=0.4):
    """What `classical` does with simultaneous moves (Eq. 9)."""
    after = patch.vertices.copy()
    for v in patch.movable:
        spokes = patch.vertices[patch.ring(v)] - patch.vertices[v]
        weights = lengths(spokes)
        after[v] += share * (weights @ spokes) / weights.sum()
    return after


class OwnMethod(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = planish.sample("panel", vertices=400)

    def test_it_does_what_a_method_of_the_library_does(self):
        theirs = planish.evolve(self.mesh, method="classical", lambda_=0.4, order="simultaneous", sweeps=4)
        own = planish.evolve(self.mesh, method=laplacian, sweeps=4)
        np.testing.assert_allclose(own.vertices, theirs.vertices, rtol=0, atol=1e-11)
        self.assertEqual(own.figures["method"], "laplacian")
        self.assertEqual(own.stop, "sweep_limit")
        for mine, other in zip(own.figures["history"], theirs.figures["history"]):
            self.assertAlmostEqual(mine["energy"], other["energy"], delta=1e-9)

    def test_it_is_given_the_patch_as_it_is(self):
        seen = []

        def look(patch):
            seen.append(patch)
            after = patch.vertices.copy()
            after[:, 2] += 0.1
            return after

        result = planish.evolve(self.mesh, method=look, sweeps=2, fix=[200])
        first, second = seen  # which outlive the run
        np.testing.assert_array_equal(first.vertices, self.mesh.vertices)
        np.testing.assert_array_equal(second.design, self.mesh.vertices)
        np.testing.assert_array_equal(second.faces, self.mesh.faces)
        self.assertEqual([first.sweep, second.sweep], [1, 2])
        self.assertNotIn(200, first.movable)
        moved = np.flatnonzero(lengths(result.vertices - self.mesh.vertices) > 0)
        np.testing.assert_array_equal(moved, first.movable)
        self.assertFalse(first.vertices.flags.writeable)
        with self.assertRaises(IndexError):
            first.ring(len(self.mesh.vertices))

    def test_any_array_of_the_right_shape_will_do(self):
        for answer in (lambda p: p.vertices.tolist(), lambda p: p.vertices.astype(np.float32)):
            planish.evolve(self.mesh, method=answer, sweeps=1)

    def test_single_sweeps(self):
        sweeps = list(planish.evolve_sweeps(self.mesh, method=laplacian, sweeps=3))
        whole = planish.evolve(self.mesh, method=laplacian, sweeps=3)
        self.assertEqual([sweep.sweep for sweep in sweeps], [1, 2, 3])
        np.testing.assert_array_equal(sweeps[-1].vertices, whole.vertices)

    def test_what_it_raises_comes_through(self):
        class Own(Exception):
            pass

        def fail(_):
            raise Own("words")

        for call in (
            lambda: planish.evolve(self.mesh, method=fail),
            lambda: list(planish.evolve_sweeps(self.mesh, method=fail)),
            lambda: planish.compare(self.mesh, methods="classical", own={"mine": fail}),
        ):
            with self.assertRaisesRegex(Own, "words"):
                call()
        with self.assertRaises(TypeError):
            planish.evolve(self.mesh, method=lambda: None)

    def test_what_is_no_surface_is_refused(self):
        with self.assertRaisesRegex(planish.RequestError, "3 positions") as caught:
            planish.evolve(self.mesh, method=lambda p: p.vertices[:3])
        self.assertEqual(caught.exception.code, "method_failed")
        with self.assertRaisesRegex(planish.RequestError, "no number"):
            planish.evolve(self.mesh, method=lambda p: p.vertices * np.nan)
        with self.assertRaisesRegex(ValueError, "shape"):
            planish.evolve(self.mesh, method=lambda p: p.vertices[:, :2])
        with self.assertRaises(TypeError):
            planish.evolve(self.mesh, method=lambda p: "no array")

    def test_flags_of_other_methods_are_refused(self):
        with self.assertRaisesRegex(planish.RequestError, "method laplacian has no flag --lambda-max"):
            planish.evolve(self.mesh, method=laplacian, lambda_max=0.5)
        with self.assertRaises(TypeError):
            planish.flatten(self.mesh, method=laplacian)

    def test_it_can_be_cancelled(self):
        calls = []

        def count(patch):
            calls.append(patch.sweep)
            return patch.vertices + [0, 0, 1e-3]

        with self.assertRaises(planish.Cancelled):
            planish.evolve(self.mesh, method=count, sweeps=1_000_000, progress=lambda *_: len(calls) < 3)
        self.assertGreaterEqual(len(calls), 3)

    def test_control_c(self):
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            planish.evolve(self.mesh, method=lambda p: p.vertices + [0, 0, 1e-6], sweeps=100_000_000)
        timer.join()

    def test_it_may_call_the_library(self):
        given = dict(method="classical", order="simultaneous")

        def smooth(patch):
            return planish.evolve(patch.vertices, patch.faces, sweeps=1, **given).vertices

        own = planish.evolve(self.mesh, method=smooth, sweeps=2)
        theirs = planish.evolve(self.mesh, sweeps=2, **given)
        np.testing.assert_array_equal(own.vertices, theirs.vertices)

    def test_results_can_be_pickled(self):
        result = planish.evolve(self.mesh, method=laplacian, sweeps=1)
        again = pickle.loads(pickle.dumps(result))
        self.assertEqual(again.figures, result.figures)
        comparison = planish.compare(self.mesh, methods="none", own={"mine": laplacian})
        self.assertEqual(pickle.loads(pickle.dumps(comparison)).runs[0].method, "mine")

    def test_functions_and_results_are_compared(self):
        evolved = planish.evolve(self.mesh, method="classical")
        comparison = planish.compare(
            self.mesh,
            methods="classical",
            sweeps=10,
            own={"mine": laplacian, "mesh": evolved, "array": evolved.vertices.copy()},
        )
        theirs, mine, mesh, array = comparison.runs
        self.assertEqual([mine.method, mesh.method, array.method], ["mine", "mesh", "array"])
        self.assertEqual(len(mine.vertices), len(self.mesh.vertices))
        for judged in (mesh, array):
            self.assertEqual(judged.strain_rms, theirs.strain_rms)
            self.assertEqual(judged.verdict, theirs.verdict)
        only = planish.compare(self.mesh, methods="none", own={"mine": laplacian})
        self.assertEqual(len(only.runs), 1)

    def test_names_and_results_that_do_not_fit_are_refused(self):
        for name in ("auto", "../mine", ""):
            with self.assertRaises(planish.RequestError):
                planish.compare(self.mesh, own={name: laplacian})
        with self.assertRaisesRegex(planish.RequestError, "vertices, the input has"):
            planish.compare(self.mesh, methods="none", own={"mine": planish.sample("dome", vertices=100)})
        with self.assertRaises(planish.RequestError):
            planish.compare(self.mesh, methods="none", own={"mine": self.mesh}, fix=[3])
        with self.assertRaises(planish.RequestError):
            planish.compare(self.mesh, methods="none")

    def test_the_example(self):
        comparison = runpy.run_path(str(EXAMPLES / "own_method.py"))["comparison"]
        umbrella = comparison.runs[-1]
        self.assertEqual(umbrella.method, "umbrella")
        self.assertIsNone(umbrella.failure)
        self.assertLess(umbrella.e_max, comparison.figures["input"]["e_max"])


if __name__ == "__main__":
    unittest.main()
