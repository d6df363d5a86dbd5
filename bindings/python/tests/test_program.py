"""Results are those of the program, byte for byte.

PLANISH_PROGRAM names the program; PLANISH_TEST_DATA a folder with the folder patches."""

import json
import os
import pathlib
import subprocess
import tempfile
import unittest

import numpy as np

import planish

PROGRAM = os.environ.get("PLANISH_PROGRAM")
PATCHES = pathlib.Path(os.environ.get("PLANISH_TEST_DATA", ""), "patches")


def some_patches():
    """The ten smallest."""
    found = [path for path in PATCHES.glob("*") if path.suffix in {".obj", ".ply"}] if PATCHES.name else []
    return sorted(found, key=lambda path: (path.stat().st_size, path.name))[:10]


def same_but_for_time(figures):
    """Without what changes from run to run and without paths."""
    if isinstance(figures, dict):
        left_out = {"seconds", "files", "threads"}
        return {key: same_but_for_time(value) for key, value in figures.items() if key not in left_out}
    return [same_but_for_time(item) for item in figures] if isinstance(figures, list) else figures


@unittest.skipUnless(PROGRAM, "PLANISH_PROGRAM is not set")
class Program(unittest.TestCase):
    def run_program(self, *words):
        done = subprocess.run([PROGRAM, *map(str, words)], capture_output=True, text=True)
        self.assertIn(done.returncode, (0, 3), done.stderr)
        return done.stdout

    def check_flatten(self, path, unit, **keywords):
        flags = [word for key, value in keywords.items() for word in (f"--{key.replace('_', '-')}", value)]
        with tempfile.TemporaryDirectory() as folder:
            by_program, by_python = pathlib.Path(folder, "program"), pathlib.Path(folder, "python")
            self.run_program("flatten", path, "-o", by_program, "--unit", unit, *flags)
            result = planish.flatten(path, unit=unit, **keywords)
            result.save(str(by_python))
            names = sorted(file.name for file in by_program.iterdir())
            self.assertEqual(sorted(file.name for file in by_python.iterdir()), names)
            for name in names:
                if name.startswith("report."):
                    continue  # it holds times
                self.assertEqual((by_python / name).read_bytes(), (by_program / name).read_bytes(), f"{path} {name}")
            self.assertEqual(result.svg(), (by_program / "pattern.svg").read_text())
            self.assertEqual(result.dxf().encode(), (by_program / "pattern.dxf").read_bytes())
            self.assertEqual(result.pdf(), (by_program / "pattern.pdf").read_bytes())
            if "as-designed.svg" in names:  # where the form may change
                self.assertEqual(result.svg(as_designed=True), (by_program / "as-designed.svg").read_text())
            report = json.loads((by_program / "report.json").read_text())
            self.assertEqual(same_but_for_time(result.figures), same_but_for_time(report))

    def test_describe(self):
        self.assertEqual(planish.describe(), json.loads(self.run_program("describe", "--json")))

    def test_samples(self):
        with tempfile.TemporaryDirectory() as folder:
            for name in ("panel", "saddle"):
                path = pathlib.Path(folder, f"{name}.ply")
                self.run_program("sample", name, "-o", path, "--vertices", "800")
                np.testing.assert_array_equal(planish.read(path).vertices, planish.sample(name, vertices=800).vertices)
                self.check_flatten(path, "mm", max_strain="1%", allowance="10mm", grain="30deg", piece_name="front")

    def test_other_verbs(self):
        with tempfile.TemporaryDirectory() as folder:
            path, out = pathlib.Path(folder, "panel.ply"), pathlib.Path(folder, "out.ply")
            planish.write(path, planish.sample("panel", vertices=1000))
            report = json.loads(self.run_program("evolve", path, "-o", out, "--json", "--lambda-min=-0.5"))
            result = planish.evolve(path, lambda_min=-0.5)
            np.testing.assert_array_equal(planish.read(out).vertices, result.vertices)
            self.assertEqual(same_but_for_time(result.figures), same_but_for_time(report))
            drawn = pathlib.Path(folder, "out.svg")
            report = json.loads(self.run_program("unfold", path, "-o", drawn, "--json", "--max-strain", "4%"))
            unfolded = planish.unfold(path, max_strain=0.04)
            self.assertEqual(unfolded.svg(), drawn.read_text())
            self.assertEqual(unfolded.figures, report)
            report = json.loads(self.run_program("measure", path, "--json", "--material", "leather"))
            self.assertEqual(planish.measure(path, material="leather").figures, report)
            listed = json.loads(self.run_program("materials", "--json"))["materials"]
            self.assertEqual(planish.materials(), listed)
            self.assertEqual(planish.materials("cotton"), [one for one in listed if one["name"] == "cotton"])
            with self.assertRaises(planish.RequestError):
                planish.materials("wood")
            report = json.loads(self.run_program("compare", path, "--json", "--methods", "fairing,controllable"))
            compared = planish.compare(path, methods=["fairing", "controllable"])
            self.assertEqual(same_but_for_time(compared.figures), same_but_for_time(report))
            report = json.loads(self.run_program("suggest-cuts", path, "--json"))
            self.assertEqual(same_but_for_time(planish.suggest_cuts(path).figures), same_but_for_time(report))

            report = json.loads(self.run_program("panels", path, "--json", "--effort", "1"))
            panels = planish.suggest_panels(path, effort=1)
            self.assertEqual(panels.figures, report)

    def test_real_patches(self):
        patches = some_patches()
        if len(patches) < 10:
            self.skipTest("there are no ten patches in PLANISH_TEST_DATA")
        for path in patches:
            with self.subTest(path.name):
                self.check_flatten(path, "m" if path.name.startswith("gc_") else "mm")


if __name__ == "__main__":
    unittest.main()
