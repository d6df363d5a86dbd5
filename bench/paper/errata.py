"""The errata of the paper, each with the check that shows it."""

import dataclasses

import numpy as np

import fans
import printed
from fans import angle_sum, base_angles, circle, eq_12, eq_15, eq_16, eq_17, laplacian, slope

FANS, RINGS = 500, 2000
RIGHT, WRONG = 1e-8, 0.01  # errors of what is right, and of what is wrong


@dataclasses.dataclass(frozen=True)
class Erratum:
    where: str
    printed: str
    right: str
    check: str
    shown: bool


def of_formulas():
    """Largest errors of the formulas against difference quotients, on random two-ring fans."""
    worst = {}

    def note(name, error):
        worst[name] = max(worst.get(name, 0.0), float(np.max(np.abs(error))))

    for fan in fans.random_fans(FANS):
        x, ring, n = fan.centre, fan.ring, fan.n
        sums = slope(lambda step: fan.sums_at(step)[0])
        energy = slope(lambda step: fan.energy_at(step)[0])
        own = eq_16(x, ring, fan.laplacian)
        corrected = eq_17(x, ring, np.tile(fan.laplacian, (n, 1)))
        as_printed = eq_17(x, ring, np.array([fan.laplacian_of(1 + j) for j in range(n)]))
        note("16", own - sums[0])
        note("17 corrected", corrected - sums[1:])
        note("17 printed", as_printed - sums[1:])
        defects, inner = 2.0 * np.pi - fan.sums, fan.ring_is_inner
        note("15 corrected", eq_15(defects, own, corrected, inner) - energy)
        note("15 with all neighbours", eq_15(defects, own, corrected, inner | True) - energy)
        note("15 with 17 printed", eq_15(defects, own, as_printed, inner) - energy)
        gradient = np.array(
            [slope(lambda step: angle_sum(x + step * axis, ring)) for axis in np.eye(3)]
        )
        note("12 printed", eq_12(x, ring, 1) - gradient)
        note("12 corrected", eq_12(x, ring, 2) - gradient)
    return worst


def of_chords(random):
    """By valence: what the angle sum has above a full turn on chords between two ring vertices that
    face each other, mean and largest size."""
    excess = {}
    for n in range(4, 9):
        found = []
        for _ in range(RINGS // 5):
            ring = circle(n, 1.0, random) + [0.0, 0.0, 0.3] * random.standard_normal((n, 3))
            share = random.random()
            point = share * ring[0] + (1.0 - share) * ring[n // 2]
            found.append(angle_sum(point, ring) - 2.0 * np.pi)
        excess[n] = {"mean": float(np.mean(found)), "largest": float(np.max(np.abs(found)))}
    return excess


def own_slope(x, ring):
    """How the angle sum of x changes along its Laplacian vector."""
    return float(eq_16(x, ring, laplacian(x, ring)))


def of_saddles(random):
    """Saddles inside the hull of their ring; shares and counts."""
    steps = np.linspace(0.0, 1.0, 41)
    rises, reached, reached_below, least = 0, 0, 0, np.inf
    for _ in range(RINGS):
        n = int(random.integers(4, 10))
        ring = circle(n, 1.0, random) + [0.0, 0.0, 0.3] * random.standard_normal((n, 3))
        x = random.dirichlet(np.full(n, 2.0)) @ ring
        along = np.multiply.outer(steps, laplacian(x, ring))
        sums = angle_sum(x + along, ring)
        rises += own_slope(x, ring) > 0.0
        reached += np.any(sums <= 2.0 * np.pi)
        reached_below += np.any(angle_sum(x - 4.0 * along, ring) <= 2.0 * np.pi)
        least = min(least, float(np.min(sums) - 2.0 * np.pi))
    return {
        "rises": rises / RINGS,
        "zero reached": int(reached),
        "zero reached in [-4, 0]": reached_below / RINGS,
        "least excess": least,
    }


def of_domes(random):
    """Vertices with a defect above 0, above rings that are nearly plane."""
    falls, reached, count = 0, 0, 0
    while count < RINGS:
        n = int(random.integers(4, 10))
        ring = circle(n, 1.0, random) + [0.0, 0.0, 0.1] * random.standard_normal((n, 3))
        x = ring.mean(axis=0) + [0.0, 0.0, 0.2 + 0.4 * random.random()]
        if angle_sum(x, ring) >= 2.0 * np.pi:
            continue
        count += 1
        falls += own_slope(x, ring) > 0.0
        reached += angle_sum(x + laplacian(x, ring), ring) >= 2.0 * np.pi - 1e-12
    return {"falls": falls / RINGS, "zero reached": reached / RINGS}


def of_guard():
    """How often no step inside (0, 1) lowers the energy, and how often the best one that does
    leaves a larger defect than there was."""
    steps = np.linspace(0.0, 1.0, 201)
    stuck, raised = 0, 0
    all_fans = fans.random_fans(FANS // 2, border_share=0.0)
    for fan in all_fans:
        energies, defects = fan.energy_at(steps), np.abs(fan.defects_at(steps))
        best = int(np.argmin(energies))
        stuck += best == 0
        raised += bool(np.max(defects[best]) > np.max(defects[0]))
    return {"no step lowers": stuck, "e_max rises": raised, "fans": len(all_fans)}


def conserved(random):
    """Largest change of the defects' sum over a star whose ring is inner, and of a single one."""
    of_sum, of_one = 0.0, 0.0
    for fan in fans.random_fans(100, border_share=0.0, seed=4):
        defects = fan.defects_at([0.0, random.random()])
        of_sum = max(of_sum, abs(float(np.diff(defects.sum(axis=1))[0])))
        of_one = max(of_one, float(np.max(np.abs(np.diff(defects, axis=0)))))
    return {"of the sum": of_sum, "of one": of_one}


def measured():
    """All figures that the errata rest on."""
    random = np.random.default_rng(28301)
    return {
        "formulas": of_formulas(),
        "chords": of_chords(random),
        "saddles": of_saddles(random),
        "domes": of_domes(random),
        "guard": of_guard(),
        "conserved": conserved(random),
    }


def errors(worst, wrong, right):
    return f"largest error as printed {worst[wrong]:.2g}, corrected {worst[right]:.1e}"


def errata_of_formulas(found):
    worst = found["formulas"]

    def shown(wrong, right):
        return worst[wrong] > WRONG and worst[right] < RIGHT

    yield Erratum(
        "Eq. 17",
        "$L(v_j)$ in six places",
        "$L(v)$: it is $v$ that moves, along its own Laplacian vector",
        errors(worst, "17 printed", "17 corrected")
        + f"; in Eq. 15, with it as printed, {worst['15 with 17 printed']:.2g}",
        shown("17 printed", "17 corrected"),
    )
    yield Erratum(
        "Eq. 11, 13, 15",
        "the sum runs over all neighbours of $v$",
        "over the *inner* ones: Eq. 4 has no term for the border, which has no $d$",
        "Eq. 15 against the slope of Eq. 4: "
        + errors(worst, "15 with all neighbours", "15 corrected"),
        shown("15 with all neighbours", "15 corrected"),
    )
    yield Erratum(
        "section 5, on Fig. 11",
        "“Eq. (12) in [2]” is the gradient of the angle sum",
        "it is Eq. 12 of [1], and there the edge in the denominator lacks its square",
        errors(worst, "12 printed", "12 corrected"),
        shown("12 printed", "12 corrected"),
    )
    yield Erratum(
        "Eq. 16",
        "no erratum",
        "",
        f"right as printed: largest error {worst['16']:.1e}",
        worst["16"] < RIGHT,
    )


def errata_of_claims(found):
    chords, saddles, guard = found["chords"], found["saddles"], found["guard"]
    means = [chords[n]["mean"] for n in range(5, 9)]
    yield Erratum(
        "Fig. 3 and the text on it",
        "on the lines $AB$ and $CD$ the angle sum is $2\\pi$",
        "with four neighbours only; with more it is larger",
        f"largest difference with 4 neighbours {chords[4]['largest']:.0e}; mean excess with 5 to 8 "
        f"neighbours {min(means):.2f} to {max(means):.2f} rad",
        chords[4]["largest"] < RIGHT and min(means) > WRONG,
    )
    yield Erratum(
        "section 3, below Eq. 10",
        "along the Laplacian vector the defect of a saddle gets smaller",
        "inside the hull of its ring it mostly gets larger at first, and is 0 nowhere on the way",
        f"{RINGS} saddles inside the hull of their ring: larger at first on "
        f"{100 * saddles['rises']:.0f} %, 0 reached for $\\lambda$ in [0, 1] on "
        f"{saddles['zero reached']}, in [-4, 0] on "
        f"{100 * saddles['zero reached in [-4, 0]']:.0f} %; the least excess over $2\\pi$ is {saddles['least excess']:.0e}. Domes, as claimed: "
        f"smaller at first on {100 * found['domes']['falls']:.0f} %, 0 reached on "
        f"{100 * found['domes']['zero reached']:.0f} %",
        saddles["rises"] > 0.5 and saddles["zero reached"] == 0,
    )
    yield Erratum(
        "sections 1, 3, 5",
        "the energy is “guaranteed to decrease”",
        "only if a step counts where $b_v$ falls: 0 is no point of the open interval of Eq. 13. "
        "And it is the energy that falls; `e_max` may rise",
        f"of {guard['fans']} fans no step in (0, 1) lowers $b_v$ on {guard['no step lowers']}, so "
        "that any solver inside ends higher; the best step raises the largest defect on "
        f"{guard['e_max rises']}",
        guard["no step lowers"] > 0 and guard["e_max rises"] > 0,
    )


def errata_of_words():
    ratios = [row.ratio for row in printed.TABLE_1]
    claimed = ", ".join(f"{ratios[k]:.1f}" for k in printed.MORE_THAN_OF)
    others = ", ".join(f"{r:.1f}" for k, r in enumerate(ratios) if k not in printed.MORE_THAN_OF)
    sweeps = [row.sweeps for row in printed.TABLE_1]
    as_many = sum(k >= printed.FEWER_SWEEPS_THAN for k in sweeps)
    yield Erratum(
        "section 4, on Table 1",
        f"“more than {printed.MORE_THAN:.0f} times (Figs. 7(d) and 9(b))”",
        "Fig. 9(b) only",
        f"`e_max` before over after, from Table 1: {claimed}; the others {others}",
        min(ratios[k] for k in printed.MORE_THAN_OF) < printed.MORE_THAN,
    )
    yield Erratum(
        "section 4, on Table 1",
        f"“less than {printed.FEWER_SWEEPS_THAN}” steps",
        f"at most {max(sweeps)}",
        f"{as_many} of {len(sweeps)} rows took {max(sweeps)}",
        as_many > 0,
    )
    reading = [
        ("Eq. 5", "the minimum is over $v\\in V_{int}$", "over the places of all $v\\in V_{int}$"),
        (
            "below Eq. 13",
            "“the global optimization problem Eq. (11)”",
            "Eq. 5; Eq. 11 belongs to one vertex",
        ),
        ("below Eq. 17", "$b_\\lambda(v)$", "$b_v(\\lambda)$"),
    ]
    for where, wrong, right in reading:
        yield Erratum(where, wrong, right, "by reading", True)


def all_errata(found):
    return [*errata_of_formulas(found), *errata_of_claims(found), *errata_of_words()]
