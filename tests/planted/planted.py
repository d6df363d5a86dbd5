"""The planted surfaces of bench/planted are what their page says. Ends with 77 where numpy is not
installed."""

import pathlib
import subprocess
import sys
import tempfile
import unittest

try:
    import numpy as np
except ImportError:
    print("skipped: numpy is not installed")
    sys.exit(77)

BENCH = pathlib.Path(__file__).resolve().parents[2] / "bench" / "planted"
sys.path.insert(0, str(BENCH))

from designs import DENSITIES, designs
from planted import meshes
import surface


class Planted(unittest.TestCase):
    def test_there_are_thirty(self):
        self.assertEqual(len({planted.name for planted in designs()}), 30)

    def test_each_developable_is_flattenable_and_has_the_border_of_its_design(self):
        for planted in designs():
            with self.subTest(planted.name):
                design, flat = meshes(planted, DENSITIES["coarse"])
                inner = surface.is_inner(design)
                moves = surface.norm(design.positions - flat.positions) / surface.diagonal(design)
                self.assertTrue(all(bump.is_inside() for bump in planted.bumps))
                self.assertLess(np.max(np.abs(surface.defects(flat))), 1e-12)
                self.assertGreater(np.max(np.abs(surface.defects(design))), 1e-3)
                self.assertLess(np.max(moves[~inner]), 1e-15)
                self.assertGreater(np.sqrt(np.mean(moves[inner] ** 2)), 1e-3)

    def test_the_files_are_the_same_each_time(self):
        with tempfile.TemporaryDirectory() as folder:
            folders = [pathlib.Path(folder) / name for name in "ab"]
            for one in folders:
                subprocess.run([sys.executable, BENCH / "make", one, "--density", "coarse"], check=True)
            first, second = ({path.name: path.read_bytes() for path in one.iterdir()} for one in folders)
        self.assertEqual(len(first), 60)
        self.assertEqual(first, second)


if __name__ == "__main__":
    unittest.main()
