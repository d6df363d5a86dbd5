"""What the corpus holds: kinds, sizes, faults and their shares. Number and seed fix every mesh."""

import pathlib
import sys

import numpy as np

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parents[1] / "planted"))

import meshes
import planted
from designs import designs
from formulas import FAMILIES
from surface import norm

SEED = 1
SIZES = (300, 1500, 6000)  # vertices, about
FAULTS = (("sound", 0.7), ("coarse", 0.1), ("noisy", 0.1), ("needles", 0.1))
FEWEST = 60  # vertices of coarse meshes
PUBLIC_SHARE = 0.3  # of regions of whole meshes, where there are any
PLANTED_SHARE = 0.1
MESHES = (".obj", ".ply", ".stl", ".off")


def public_meshes(folders):
    """Mesh files below some folders, in an order that depends on their names alone."""
    found = [path for folder in folders for path in pathlib.Path(folder).rglob("*") if path.suffix.lower() in MESHES]
    return sorted(found, key=lambda path: (path.name, str(path)))


def chosen(pairs, value):
    for name, share in pairs:
        value -= share
        if value < 0.0:
            return name
    return pairs[0][0]


def planted_mesh(vertices, rng):
    all_designs = designs()
    design, _ = planted.meshes(all_designs[int(rng.integers(len(all_designs)))], vertices)
    return design.positions, design.triangles


class Corpus:
    """@param read path -> positions, triangles of a whole mesh; raises ValueError where it is none"""

    def __init__(self, folders, read):
        self.public, self.read, self.known = public_meshes(folders), read, {}

    def whole_mesh(self, path):
        if path not in self.known:
            if len(self.known) > 20:
                self.known.clear()
            self.known[path] = self.read(path)
        return self.known[path]

    def item(self, number):
        """Kind, size, fault and mesh of one number; the mesh is None where a public file holds no surface."""
        rng = np.random.default_rng([SEED, number])
        size = SIZES[number % len(SIZES)]
        fault = chosen(FAULTS, rng.random())
        vertices = max(FEWEST, size // 6) if fault == "coarse" else size
        draw = rng.random()
        if self.public and draw < PUBLIC_SHARE:
            path = self.public[int(rng.integers(len(self.public)))]
            kind, mesh = "region", self.region(path, vertices, rng)
        elif draw < PUBLIC_SHARE + PLANTED_SHARE:
            kind, mesh = "planted", planted_mesh(vertices, rng)
        else:
            kind = sorted(FAMILIES)[int(rng.integers(len(FAMILIES)))]
            mesh = meshes.by_formula(kind, vertices, rng)
        if mesh is not None and fault == "noisy":
            mesh = meshes.noisy(*mesh, rng), mesh[1]
        if mesh is not None and fault == "needles":
            mesh = meshes.with_needles(*mesh, rng)
        return kind, size, fault, mesh

    def region(self, path, vertices, rng):
        try:
            positions, triangles = self.whole_mesh(path)
        except ValueError:
            return None
        if len(triangles) < 4:
            return None
        positions, triangles = meshes.region(positions, triangles, 2 * vertices, rng)
        diagonal = float(norm(np.ptp(positions, axis=0)))
        return rng.uniform(100.0, 1000.0) / max(diagonal, 1e-300) * positions, triangles
