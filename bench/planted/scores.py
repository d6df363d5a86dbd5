"""What a result is worth beside the planted developable. All figures but the way of the vertices are
the program's, and every result is measured from its file: ours like those of other programs."""

import dataclasses
import json
import subprocess

import numpy as np

import surface

DEVIATION_ALLOWED = 1.05  # times that of the planted developable
BENDING_ALLOWED = 0.1  # above that of the planted developable, in shares of B0
FLAT = 1e-4  # e_max, radians
BORDER_HELD = 1e-6  # of the diagonal
MOST_SECONDS = 1800


class Failed(Exception):
    pass


def ask(planish, *arguments):
    command = [str(planish), *map(str, arguments), "--threads", "1", "--quiet", "--json"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=MOST_SECONDS)
        answer = json.loads(done.stdout or "{}")
    except (subprocess.TimeoutExpired, json.JSONDecodeError) as error:
        raise Failed(type(error).__name__) from error
    if done.returncode not in (0, 3) or "error" in answer:
        of_runs = [run["error"] for run in answer.get("runs", []) if run["error"]]
        failure = next(iter(of_runs), answer.get("error", {}))
        raise Failed(failure.get("code", f"exit code {done.returncode}"))
    return answer


def read_obj(path):
    """Places of the vertices in the order of the file."""
    with open(path, encoding="utf-8") as file:
        return np.array([line.split()[1:4] for line in file if line.startswith("v ")], dtype=float)


@dataclasses.dataclass(frozen=True)
class Figures:
    """Of one mesh beside its design; deviation is a share of the design's diagonal."""

    e_max: float
    flattenable: bool
    deviation: float
    bending: float  # B / B0
    border_moved: float


class Beside:
    """Scores what lies beside one design.
    @param design path of its mesh, @param planted path of the developable, @param mesh the design"""

    def __init__(self, planish, design, planted, mesh):
        self.planish, self.path, self.mesh = planish, design, mesh
        self.inner, self.diagonal = surface.is_inner(mesh), surface.diagonal(mesh)
        self.b0 = self.design_bending(design.with_suffix(".b0.obj"))
        self.planted = self.figures(planted)

    def design_bending(self, unused):
        """B0, which the JSON tells only by the ratio: any run will do, here the cheapest."""
        answer = ask(self.planish, "evolve", self.path, "-o", unused, "--method", "controllable", "--sweeps", 1)
        unused.unlink()
        return answer["after"]["bending"] / answer["bending_ratio"]

    def figures(self, path):
        positions = read_obj(path)
        if positions.shape != self.mesh.positions.shape or not np.all(np.isfinite(positions)):
            raise Failed("not the vertices of the design")
        moves = surface.norm(positions - self.mesh.positions) / self.diagonal
        answer = ask(self.planish, "measure", path)
        return Figures(
            answer["e_max"], answer["flattenable"], float(np.sqrt(np.mean(moves[self.inner] ** 2))),
            answer["bending"] / self.b0, float(np.max(moves[~self.inner])),
        )  # fmt: skip

    def score(self, path, answer=None):
        """@param answer of the program where it made the result"""
        return Score(self.figures(path), self.planted, answer or {})


@dataclasses.dataclass(frozen=True)
class Score:
    found: Figures
    planted: Figures
    answer: dict

    @property
    def deviation_ratio(self):
        return self.found.deviation / self.planted.deviation

    @property
    def bending_more(self):
        return self.found.bending - self.planted.bending

    @property
    def is_flat(self):
        return self.found.flattenable or self.found.e_max <= FLAT

    @property
    def passes(self):
        return (self.is_flat and self.deviation_ratio <= DEVIATION_ALLOWED and self.bending_more <= BENDING_ALLOWED
                and self.found.border_moved <= BORDER_HELD)
