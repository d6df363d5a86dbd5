"""What the paper's measures hide: energy against the strain of the pattern."""

import statistics

from chart import Axis, Panel, Series, write_svg
from markdown import number, percent, table

SWEEPS = [1, 3, 10, 30, 100, 300, 1000]
DENSITIES = [5_000, 15_000, 60_000]
METHODS = ["controllable", "least_norm", "auto"]
FLAT = 5e-4  # rms strain below which a ratio of strains says nothing
LEAST = 1e-8  # drawn here where smaller


def over_sweeps(job, patch):
    """Energy, total defect and strain as shares of what they were, by sweeps."""
    shares = {"energy": [], "sum_abs_defect": [], "strain": []}
    before = job.program.strain(patch.path)
    for sweeps in SWEEPS:
        run = job.program.evolve(patch.path, "controllable", "--sweeps", sweeps)
        for key in ("energy", "sum_abs_defect"):
            shares[key].append(run.after[key] / run.before[key])
        shares["strain"].append(job.program.strain(run.path) / before)
    return shares


def by_density(job):
    program = job.program
    paths = [program.sample("saddle", vertices) for vertices in DENSITIES]
    found = []
    for path in paths + job.patches.two_densities():
        measured = program.measure(path)
        keys = ("vertices", "e_max", "e_avg", "energy", "sum_abs_defect")
        found.append(
            {
                "patch": path.stem.rsplit("-", 1)[0],
                **{key: measured[key] for key in keys},
                "strain": program.strain(path),
            }
        )
    return found


def by_patch(job):
    """By method: for each patch what is left of energy and strain."""
    found = {method: {} for method in METHODS}
    for path in job.patches.small():
        before = job.program.strain(path)
        if before < FLAT:
            continue
        for method in METHODS:
            run = job.program.evolve(path, method)
            found[method][path.stem] = {
                "energy": run.after["energy"] / run.before["energy"],
                "strain": job.program.strain(run.path) / before,
            }
    return found


def draw(path, patch, shares, patches):
    curves = [Series(name, SWEEPS, values) for name, values in shares.items()]
    points = [
        Series(
            method,
            [max(v["energy"], LEAST) for v in by_name.values()],
            [max(v["strain"], LEAST) for v in by_name.values()],
            is_curve=False,
        )
        for method, by_name in patches.items()
    ]
    left = "left of it"
    write_svg(
        path,
        [
            Panel(
                f"{patch.name}, controllable",
                Axis("sweeps", is_log=True),
                Axis(left, is_log=True),
                curves,
            ),
            Panel(
                "One point for each patch and method",
                Axis("energy left", is_log=True),
                Axis("strain left", is_log=True),
                points,
            ),
        ],
    )


def patch_rows(patches):
    for method, by_name in patches.items():
        energies = [v["energy"] for v in by_name.values()]
        strains = [v["strain"] for v in by_name.values()]
        yield [
            f"`{method}`", len(by_name),
            percent(statistics.median(energies)), sum(e < 0.5 for e in energies),
            percent(statistics.median(strains)), sum(s < 0.5 for s in strains),
        ]  # fmt: skip


def density_rows(found):
    for v in found:
        numbers = (number(v[key]) for key in ("e_max", "e_avg", "energy", "sum_abs_defect"))
        yield [v["patch"], v["vertices"], *numbers, percent(v["strain"])]


def make(job):
    patch = job.patches.in_role("falls")
    shares, densities, patches = over_sweeps(job, patch), by_density(job), by_patch(job)
    draw(job.out / "measures.svg", patch, shares, patches)
    ten = SWEEPS.index(10)
    saddles = densities[: len(DENSITIES)]
    text = f"""## What the measures hide

`e_max`, `e_avg` and energy are of the defects at vertices. What a workshop feels is the strain of the pattern.

![Energy and strain over sweeps, and left of both by patch and method](measures.svg)

Left: what {SWEEPS[-1]} controllable sweeps leave on {patch.name}. Ten take {percent(1 - shares["energy"][ten], 2)} off the energy and
{percent(1 - shares["strain"][ten], 2)} off the strain; {SWEEPS[-1]} take {percent(1 - shares["energy"][-1], 2)} and {percent(1 - shares["strain"][-1], 2)}. Right: the same for
{len(patches["controllable"])} patches and three methods with their usual options (what is below {LEAST:g} is drawn there).

{table(["method", "patches", "energy left, median", "halved on", "strain left, median", "halved on"], patch_rows(patches))}
The figures depend on the mesh, too. The same input surface at several densities:

{table(["patch", "vertices", "`e_max`", "`e_avg`", "`energy`", "`sum_abs_defect`", "strain, rms"], density_rows(densities))}
From {saddles[0]["vertices"]} to {saddles[-1]["vertices"]} vertices the saddle's `e_max` falls by a factor of {number(saddles[0]["e_max"] / saddles[-1]["e_max"], 2)} and its energy by
{number(saddles[0]["energy"] / saddles[-1]["energy"], 2)} without anybody doing anything; `sum_abs_defect` and strain stay. **Why:** a defect is curvature times the
area of a vertex. So a bound on `e_max` says little of a dense mesh, and energy is ruled by what changes from vertex to
vertex: noise and dents, which are cheap to take out, and not the long waves that strain the pattern
([more](../notation.md#what-the-figures-tell-and-what-they-hide)). The paper's Table 1 shows its
method where it is strong. Hence every report of Planish has strain, deviation, smallest angle and roughness beside the energy.
"""
    return text, {"by sweeps": shares, "by density": densities, "by patch": patches}, []
