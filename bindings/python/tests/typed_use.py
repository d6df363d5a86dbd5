"""What mypy --strict must take, and what it must refuse: the lines with an ignore, which it calls unused if not."""

import numpy as np
import numpy.typing as npt

import planish


def progress(stage: str, share: float, subject: str) -> bool:
    return share < 1.0 or stage != subject


def uses(vertices: npt.NDArray[np.float32], faces: npt.NDArray[np.int64]) -> None:
    result = planish.flatten(vertices, faces, max_strain="2%", method="auto", prefer="near", progress=progress)
    uv: npt.NDArray[np.float64] = result.uv
    text: str = result.svg(allowance=10.0, grain=(0, 0, 1), notches=[(3, "v")])
    page: bytes = planish.pdf(result, paper="a4")
    for sweep in planish.evolve_sweeps((vertices, faces), lambda_max=0.9):
        energy: float = sweep.energy
        print(energy, sweep.vertices[0])
    best = planish.compare(result, methods=["controllable", "fairing"]).best
    name: str = best.method if best is not None else "none"
    print(uv, text, page, name, planish.measure("panel.obj").figures["strain"])
    product = planish.flatten_product({"front": result, "back": (vertices, faces)})
    print([patch.width for patch in product.patches if patch is not None])

    pieces: list[planish.Mesh] = planish.suggest_panels(vertices, faces, effort=2).pieces
    print(planish.flatten_product(pieces).missed)

    planish.flatten(vertices, faces, method="autoo")  # type: ignore[arg-type]
    planish.flatten(vertices, faces, lambda_maxx=0.9)  # type: ignore[call-arg]
    planish.flatten(vertices, faces, remesh="yes")  # type: ignore[arg-type]
    result.uv = uv  # type: ignore[misc]
