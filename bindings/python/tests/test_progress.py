"""Progress, cancelling and threads."""

import os
import signal
import subprocess
import sys
import threading
import unittest

import numpy as np

import planish


class Progress(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = planish.sample("saddle", vertices=3000)
        cls.long = dict(method="classical", lambda_=1e-6, sweeps=1_000_000)

    def test_numpys_false_cancels_too(self):
        with self.assertRaises(planish.Cancelled):
            planish.evolve(self.mesh, progress=lambda *_: np.bool_(False), **self.long)

    def test_shares_rise(self):
        steps = []
        planish.flatten(self.mesh, progress=lambda stage, share, subject: steps.append((stage, share, subject)))
        self.assertTrue(steps)
        shares = [share for _, share, _ in steps]
        self.assertEqual(shares, sorted(shares))
        self.assertTrue(all(0 <= share <= 1 for share in shares))
        self.assertTrue(all(isinstance(stage, str) for stage, _, _ in steps))

    def test_false_cancels(self):
        with self.assertRaises(planish.Cancelled) as caught:
            planish.evolve(self.mesh, progress=lambda *_: False, **self.long)
        self.assertEqual(caught.exception.code, "interrupted")

    def test_false_cancels_short_work_too(self):
        with self.assertRaises(planish.Cancelled):
            planish.flatten(planish.sample("panel", vertices=100), progress=lambda *_: False)

    def test_other_answers_do_not(self):
        for answer in (None, 0, True, "", []):
            planish.evolve(self.mesh, sweeps=2, progress=lambda *_, answer=answer: answer)

    def test_what_it_raises_is_passed_on(self):
        class Own(Exception):
            pass

        def fail(*_):
            raise Own("words")

        with self.assertRaisesRegex(Own, "words"):
            planish.evolve(self.mesh, progress=fail, **self.long)
        with self.assertRaises(SystemExit):
            planish.evolve(self.mesh, progress=lambda *_: exit(3), **self.long)
        with self.assertRaises(TypeError):
            planish.evolve(self.mesh, progress=lambda: None, **self.long)

    def test_it_must_be_a_function(self):
        with self.assertRaisesRegex(TypeError, "progress must be a function"):
            planish.evolve(self.mesh, progress=5)

    def test_it_may_call_the_library(self):
        seen = []

        def look(*_):
            seen.append(planish.unfold(planish.sample("panel", vertices=100)).width)

        planish.evolve(self.mesh, sweeps=5, progress=look)
        self.assertTrue(seen)

    def test_control_c(self):
        # A shell that starts this in the background has it ignored.
        before = signal.signal(signal.SIGINT, signal.default_int_handler)
        self.addCleanup(signal.signal, signal.SIGINT, before)
        timer = threading.Timer(0.2, os.kill, (os.getpid(), signal.SIGINT))
        timer.start()
        with self.assertRaises(KeyboardInterrupt):
            planish.evolve(self.mesh, **self.long)
        timer.join()

    def test_threads_cancel_each_other(self):
        endings = {}
        goes_on = {"a": True, "b": True}

        def work(own, other):
            def progress(*_):
                goes_on[other] = False
                return goes_on[own]

            try:
                planish.evolve(self.mesh, progress=progress, **self.long)
                endings[own] = "finished"
            except planish.Cancelled:
                endings[own] = "cancelled"

        threads = [threading.Thread(target=work, args=pair) for pair in ("ab", "ba")]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(endings, {"a": "cancelled", "b": "cancelled"})

    def test_other_threads_run_meanwhile(self):
        ticks = []

        def cancel_late(*_):
            return len(ticks) < 1000

        stop = threading.Event()
        ticker = threading.Thread(target=lambda: [ticks.append(1) for _ in iter(stop.is_set, True)])
        ticker.start()
        with self.assertRaises(planish.Cancelled):
            planish.evolve(self.mesh, progress=cancel_late, **self.long)
        stop.set()
        ticker.join()
        self.assertGreaterEqual(len(ticks), 1000)

    def test_python_ends_while_a_thread_works(self):
        code = (
            "import threading, time, planish\n"
            "mesh = planish.sample('saddle', vertices=3000)\n"
            "def work(): planish.evolve(mesh, method='classical', lambda_=1e-6, sweeps=10**6)\n"
            "threading.Thread(target=work, daemon=True).start()\n"
            "time.sleep(0.2)\n"
        )
        done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True)
        self.assertEqual(done.returncode, 0, done.stderr)

    def test_any_number_of_threads_gives_the_same(self):
        results = [planish.flatten(self.mesh, threads=threads).uv for threads in (1, 2, 0)]
        np.testing.assert_array_equal(results[0], results[1])
        np.testing.assert_array_equal(results[0], results[2])


class Sweeps(unittest.TestCase):
    def test_the_last_sweep_is_the_result(self):
        mesh = planish.sample("saddle", vertices=800)
        for keywords in ({"sweeps": 4}, {"method": "auto", "sweeps": 6}, {"method": "fairing"}):
            sweeps = list(planish.evolve_sweeps(mesh, **keywords))
            result = planish.evolve(mesh, **keywords)
            np.testing.assert_array_equal(sweeps[-1].vertices, result.vertices)
            self.assertEqual([s.sweep for s in sweeps], [s["sweep"] for s in result.figures["history"]])
            self.assertEqual(sweeps[-1].e_max, result.figures["history"][-1]["e_max"])

    def test_flat_patches_have_none(self):
        flat = planish.unfold(planish.sample("panel", vertices=200)).to_meshio(flat=True)
        self.assertEqual(list(planish.evolve_sweeps(flat)), [])

    def test_two_threads_at_one_iterator(self):
        sweeps = planish.evolve_sweeps(planish.sample("saddle", vertices=5000), sweeps=200)
        outcomes = []

        def take():
            try:
                for _ in range(20):
                    next(sweeps)
                outcomes.append("done")
            except RuntimeError as error:
                outcomes.append(str(error))

        threads = [threading.Thread(target=take) for _ in range(3)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertLessEqual(set(outcomes), {"done", "another thread is at work on these sweeps"})

    def test_flags_that_do_not_go_with_it(self):
        with self.assertRaises(TypeError):
            planish.evolve_sweeps(planish.sample("panel"), remesh=True)


if __name__ == "__main__":
    unittest.main()
