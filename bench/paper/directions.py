"""Fig. 11: where the Laplacian direction cannot help, by the paper's test and by the exact one."""

import math

import numpy as np

from maps import write_maps
from markdown import change, number, picture, table
from picture import marked, view_of, write_row
from surface import Surface, dot, gradients, laplacians, norm, write_obj

# The paper says "nearly orthogonal" at "always" and gives no bounds: within this of a right angle,
# at all of these states.
NEARLY = math.radians(10.0)
STATES = [0, 1, 2, 5, 10, 20, 50]


def staggered_saddle():
    """z = 0.4 x y over 21 rows of 21 vertices, every second one shifted by half an edge."""
    i, j = np.meshgrid(np.arange(21), np.arange(21))
    x = (i + 0.5 * (j % 2) - 10.25) / 10.0
    y = (j - 10.0) * math.sqrt(0.75) / 10.0
    positions = np.stack([x, y, 0.4 * x * y], axis=-1).reshape(-1, 3)
    triangles = []
    for row in range(20):
        for k in range(21 * row, 21 * row + 20):
            a, b, c, d = k, k + 1, k + 22, k + 21
            triangles += [[a, b, d], [b, c, d]] if row % 2 == 0 else [[a, b, c], [a, c, d]]
    return Surface(positions, np.array(triangles))


def orthogonal(surface):
    """The paper's test: L(v) nearly orthogonal to the gradient of the vertex's own angle sum."""
    own, _ = gradients(surface)
    along = laplacians(surface)
    cosine = np.abs(dot(own, along)) / np.maximum(norm(own) * norm(along), 1e-300)
    return cosine < math.sin(NEARLY)


def same_slopes(surface, vertices, slopes):
    """Largest difference between the program's slopes and those from arrays, as a share."""
    _, energy = gradients(surface)
    ours = dot(laplacians(surface), energy)[vertices]
    return float(np.max(np.abs(ours - slopes)) / max(np.max(np.abs(slopes)), 1e-300))


def state(job, path, sweeps):
    return job.program.evolve(path, "controllable", "--sweeps", sweeps).path if sweeps else path


def measured(job, path, file):
    program, states = job.program, {}
    for sweeps in STATES:
        at = state(job, path, sweeps)
        states[sweeps] = at, program.surface(at)
    marks = np.all([orthogonal(surface) for _, surface in states.values()], axis=0)
    last_path, last = states[STATES[-1]]
    _, _, _, first_lower = program.directions(path)
    inner, slopes, flat, lower = program.directions(last_path)
    stuck, orthogonally = ~flat & ~lower, marks[inner]
    drawn = np.zeros(len(last.positions), dtype=bool), np.zeros(len(last.positions), dtype=bool)
    drawn[0][inner], drawn[1][inner] = orthogonally, stuck
    start = states[0][1]
    write_row(job.out / file, [(last, marked(which)) for which in drawn], view_of(start))
    runs = {
        low: program.evolve(
            path, "controllable", "--sweeps", STATES[-1], "--lambda-min", low, *guard
        )
        for low, guard in ((0, []), (-1, ["--min-angle", "5deg"]))
    }
    return {
        "inner": len(inner),
        "can be lowered at first": int(first_lower.sum()),
        "can be lowered at last": int(lower.sum()),
        "stuck": int(stuck.sum()),
        "orthogonal": int(orthogonally.sum()),
        "both": int((stuck & orthogonally).sum()),
        "difference of slopes": same_slopes(last, inner, slopes),
        "energy": {
            str(low): [run.before["energy"], run.after["energy"]] for low, run in runs.items()
        },
        "smallest angle": {
            str(low): [math.degrees(m["min_angle"]) for m in (run.before, run.after)]
            for low, run in runs.items()
        },
    }


def cells(name, v):
    return [
        name, v["inner"], v["can be lowered at first"], v["can be lowered at last"], v["stuck"],
        v["orthogonal"], v["both"], change(*v["energy"]["0"]), change(*v["energy"]["-1"]),
        change(*v["smallest angle"]["-1"], 2),
    ]  # fmt: skip


def make(job):
    grid = job.program.work / "saddle-in-staggered-rows.obj"
    write_obj(grid, staggered_saddle())
    patch = job.patches.in_role("directions")
    sample = job.program.sample("saddle", 4000)
    shown = {
        "saddle $0.4\\,xy$, staggered rows": (grid, "grid"),
        "saddle $u^2 - v^2$, jittered": (sample, "saddle"),
        patch.name: (patch.path, "patch"),
    }
    found, pictures = {}, []
    for name, (path, key) in shown.items():
        found[name] = measured(job, path, f"fig11-{key}-marks.png")
        red = write_maps(job, f"fig11-{key}.png", [path, state(job, path, STATES[-1])])
        pictures += [
            picture(f"fig11-{key}.png", f"{name} before and after {STATES[-1]} sweeps"),
            picture(f"fig11-{key}-marks.png", f"{name}: marks of the paper's and of the exact test"),
            f"{name}: before and after {STATES[-1]} sweeps. {red} Below it, in red: where the "
            "paper's test says that the direction cannot help (left), and where it cannot (right).\n",
        ]
    head = [
        "", "inner vertices", "can be lowered, at first", f"after {STATES[-1]} sweeps", "stuck",
        "marked by the paper's test", "stuck and marked", "`energy`, $\\lambda$ in [0, 1]",
        "in [-1, 1]", "smallest angle there",
    ]  # fmt: skip
    keys = ("stuck", "orthogonal", "both")
    stuck, marks, both = (sum(v[key] for v in found.values()) for key in keys)
    text = f"""## Fig. 11: where the Laplacian direction cannot help

The paper marks the vertices where $L(v)$ stays nearly orthogonal to $\\partial\\theta_v/\\partial v$ ("nearly" is here within
{math.degrees(NEARLY):.0f} degrees, "always" after {", ".join(map(str, STATES))} sweeps; it gives no bounds). That looks at one term of $b_v$. To first
order a step can lower $b_v$ exactly where

$$L(v)\\cdot\\nabla_v b_v = -2\\,d_v\\,\\theta_v' - 2\\sum_{{j\\ inner}} d_j\\,\\theta_j' < 0 .$$

A vertex is *stuck* where that does not hold and it is not flat.

{table(head, [cells(name, v) for name, v in found.items()])}
{chr(10).join(pictures)}
The slopes of `planish measure --map` and those computed for these pictures from the gradients of all angles, two programs,
differ by at most {max(v["difference of slopes"] for v in found.values()):.0e} of the largest.

**Same:** the paper's finding that the direction is what stops the method. **Differs:** the test. Of {stuck} stuck vertices
the paper's test marks {both}, and of the {marks} that it marks {marks - both} are not stuck. **Why:** the paper's
test leaves out the neighbours, and it leaves out the sign: a direction that is far from orthogonal helps nothing if it points
the wrong way. Two facts say which way that is:

* *Hull lemma.* The angle sum at $x$ is $\\pi$ times the mean number of times that a random plane through $x$ crosses the ring
  (Crofton). In the convex hull of the ring every plane crosses at least twice, so the sum is at least $2\\pi$. $v + L(v)$ is in
  the hull. So a saddle in the hull stays a saddle for all $\\lambda$ in [0, 1], while a dome or cup meets 0 on the way. The
  numbers are among the [errata](#the-errata-of-the-paper).
* *Conservation.* Over a star whose ring is inner the sum of the defects does not change, whatever the vertex does (largest
  change {job.errata["conserved"]["of the sum"]:.0e}, where single defects change by up to {number(job.errata["conserved"]["of one"], 2)}). So the
  slope is $-2\\theta_v'(d_v - \\bar d)$, $\\bar d$ a mean of the neighbours'. Where $\\theta_v' > 0$, which is the rule, a step forward
  helps only where $d_v$ is above that mean: maxima of the defect are worn down, minima stay.

What steps backward gain ($\\lambda$ in [-1, 1], no angle below 5 degrees or what it was), and what they cost, is in the
last columns of the table. *Can be lowered* is of the first order: it does not say by how much.
"""
    summary = [
        [
            "Fig. 11: where the direction cannot help",
            "$L$ nearly orthogonal to $\\partial\\theta_v/\\partial v$",
            f"finds {both} of {stuck} such vertices, and {marks - both} others",
        ]
    ]
    return text, found, summary
