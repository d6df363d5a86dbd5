"""A method of your own, compared with two of the library."""

import numpy as np
import numpy.typing as npt

import planish


def umbrella(patch: planish.SweepInput) -> npt.ArrayLike:
    """One sweep: every vertex that may move goes halfway to the mean of its neighbours."""
    sides = np.vstack([patch.faces[:, [0, 1]], patch.faces[:, [1, 2]], patch.faces[:, [2, 0]]])
    edges = np.unique(np.vstack([sides, sides[:, ::-1]]), axis=0)
    sums = np.zeros(patch.vertices.shape)
    np.add.at(sums, edges[:, 0], patch.vertices[edges[:, 1]])
    counts = np.bincount(edges[:, 0], minlength=len(sums))
    moved: npt.ArrayLike = 0.5 * (patch.vertices + sums / np.maximum(counts, 1)[:, None])
    return moved


panel = planish.sample("panel", vertices=1000)  # or planish.read("panel.obj")

comparison = planish.compare(panel, methods="classical,auto", own={"umbrella": umbrella})

for run in comparison.runs:
    print(f"{run.method}: {run.verdict}")
