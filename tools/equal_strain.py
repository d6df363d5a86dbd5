#!/usr/bin/env python3
"""Sets auto beside least_norm at equal strain, and writes a table of
docs/notebook/auto.md.

    tools/equal_strain.py PLANISH FOLDER RESULTS [NAME...]

Each update of least_norm is run with its usual steps; where it ends there are a strain (rms, of the
unfolded pattern), a deviation (rms) and a roughness. auto is run with --prefer near, without a limit and with that strain as limit of its
rms, then where it is not nearer for some limits between those around that strain. What counts is the least deviation of its runs with no
more strain: nothing is read off between runs. All strain
below 0.01 % counts as equal, and where auto without a limit ends below 0.1 %, all below that. Where the update is nearer and rougher than
auto may get unless told, auto is run again with as much room for roughness (--closeness) as the
update took, and twice that, as it seldom takes all; what ends rougher than the update does not
count. RESULTS keeps the answers: what lies
there is not run again. Patches whose names end in more than 60k are left out: a run with a limit of
strain takes minutes there. NAMEs: these patches alone, and no table.
"""

import concurrent.futures
import json
import math
import pathlib
import re
import sys

from auto_table import PAGE, flatten, line

BEGIN, END = "<!-- equal: begin -->", "<!-- equal: end -->"
UPDATES = ("direct", "uniform", "cotangent")
LEAST_LIMIT = 1e-4
FLAT, NEARLY_FLAT = 1e-4, 1e-3
ROUNDING = 1.0 + 1e-6


class Run:
    """Where a run ended."""

    def __init__(self, answer):
        evolve = answer["evolve"]
        self.strain = answer["unfold"]["strain"]["rms"]
        self.deviation = evolve["deviation"]["rms_over_diagonal"]
        self.rough_before = evolve["before"]["roughness"]
        self.roughness = evolve["after"]["roughness"]


class Runs:
    def __init__(self, planish, results):
        self.planish, self.results = planish, results

    def __call__(self, patch, tag, *flags):
        """None where it ended in an error."""
        kept = self.results / f"{patch.stem}.{tag}.json"
        if not kept.exists():
            answer = flatten(self.planish, str(patch), "--threads", "1", *flags)
            kept.write_text(json.dumps(answer), encoding="utf-8")
        answer = json.loads(kept.read_text(encoding="utf-8"))
        return None if "error" in answer else Run(answer)

    def auto(self, patch, limit, closeness=1.0):
        """@param limit of strain, rms; 0: none"""
        flags = ("--prefer", "near", *(("--max-rms-strain", repr(limit)) if limit else ()))
        tag = f"auto{limit:.6g}"
        if closeness != 1.0:
            flags += ("--closeness", f"{closeness:.4g}")
            tag += f".{closeness:.4g}"
        return self(patch, tag, *flags)


def deviation_within(strain, runs):
    """The least of auto's runs with no more strain; infinite where there is none."""
    return min((run.deviation for run in runs if run.strain <= strain * ROUNDING), default=math.inf)


def refined(runs, patch, found, strain, deviation, times, closeness=1.0):
    """Adds runs with limits between the two around a strain, until one is as near with no more; where
    all have less, with a larger limit.
    @param found limit -> run"""
    for _ in range(times):
        if deviation_within(strain, found.values()) <= deviation * ROUNDING:
            return
        low = max((limit for limit, run in found.items() if limit and run.strain <= strain), default=0)
        high = min((limit for limit, run in found.items() if run.strain > strain and limit > low), default=0)
        if high == 0 and low > 0:
            high = low * (strain / max(found[low].strain, 0.5 * strain)) ** 2
        if high == 0 or high < max(1.02 * low, LEAST_LIMIT):
            return
        middle = float(f"{math.sqrt(low * high) if low else high / 3.0:.4g}")
        run = runs.auto(patch, middle, closeness)
        if not run:
            return
        found[middle] = run


def as_rough(runs, patch, update, strain, usual):
    """The deviation of auto, given room for as much roughness as an update took.
    @param usual limit -> run, without that room"""
    closeness = (update.roughness - update.rough_before) / (update.rough_before + 2.5)
    if closeness <= 1.0:
        return math.inf
    limits = sorted(limit for limit in usual if limit)
    around = [limit for limit in limits if usual[limit].strain <= strain][-1:]
    around += [limit for limit in limits if usual[limit].strain > strain][:1]
    best = math.inf
    for room in (closeness, 2.0 * closeness):
        found = {limit: runs.auto(patch, limit, room) for limit in (0.0, *around)}
        found = {limit: run for limit, run in found.items() if run}
        refined(runs, patch, found, strain, update.deviation, 3, room)
        smooth = [run for run in found.values() if run.roughness <= update.roughness]
        best = min(best, deviation_within(strain, smooth))
    return best


def compare(runs, patch):
    """For each update its strain, its deviation, that of auto, and that of auto given as much room for
    roughness (none where that was not needed); None for a failed run."""
    auto = {0.0: runs.auto(patch, 0.0)}
    auto = {limit: run for limit, run in auto.items() if run}
    least = max(FLAT, auto[0.0].strain) if 0.0 in auto else math.inf
    updates = [runs(patch, update, "--method", "least_norm", "--update", update) for update in UPDATES]
    strains = [max(run.strain, least if least <= NEARLY_FLAT else FLAT) if run else None for run in updates]
    for strain in filter(None, strains):
        limit = float(f"{strain:.4g}")
        run = runs.auto(patch, limit) if FLAT <= limit <= 1.0 else None
        if run:
            auto[limit] = run
    for ended, strain in zip(updates, strains):
        if ended:
            refined(runs, patch, auto, strain, ended.deviation, 6)
    rows = []
    for ended, strain in zip(updates, strains):
        if not ended:
            rows.append(None)
            continue
        ours = deviation_within(strain, auto.values())
        rough = None
        if ours > ended.deviation * ROUNDING:
            rough = as_rough(runs, patch, ended, strain, auto)
        rows.append((strain, ended.deviation, ours, rough))
    return rows


def is_nearer(row):
    return row is None or row[2] <= row[1] * ROUNDING


def is_nearer_as_rough(row):
    return is_nearer(row) or row[3] <= row[1] * ROUNDING


def furthest(rows):
    """Of the update that ended with the least strain."""
    return min((row for row in rows if row), default=None)


def text_of(share):
    return f"{100.0 * share:.2f}" if math.isfinite(share) else "-"


def cells(rows):
    for row in rows:
        if row is None:
            yield "failed"
            continue
        strain, theirs, ours, rough = row
        more = "" if rough is None else f" ({text_of(rough)})"
        yield f"{100.0 * strain:.3f}: {text_of(theirs)}, {text_of(ours)}{more}"


def is_small(patch):
    thousands = re.search(r"(\d+)k$", patch.stem)
    return thousands is None or int(thousands[1]) <= 60


def main():
    planish, folder, results = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    names = sys.argv[4:]
    results.mkdir(parents=True, exist_ok=True)
    runs = Runs(planish, results)
    patches = sorted([*folder.glob("*.obj"), *folder.glob("*.ply")])
    patches = [patch for patch in patches if (patch.stem in names if names else is_small(patch))]
    out = [line(["patch", *UPDATES, "nearer than all", "as rough"]), line(["---"] * 6)]
    nearer = rough = far = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for patch, rows in zip(patches, pool.map(lambda p: compare(runs, p), patches)):
            won, won_rough = all(map(is_nearer, rows)), all(map(is_nearer_as_rough, rows))
            nearer, rough, far = nearer + won, rough + won_rough, far + is_nearer(furthest(rows))
            out.append(line([patch.stem, *cells(rows), *("yes" if w else "no" for w in (won, won_rough))]))
            print(out[-1], flush=True)
    out += [
        "",
        f"Of {len(patches)} patches auto is nearer than all three on {nearer}, on {rough} where it may get as "
        f"rough as they did, and on {far} nearer than the update that ended with the least strain.",
    ]
    print(out[-1])
    if names:
        return
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    after = rest.split(END)[1]
    text = "\n".join(out)
    PAGE.write_text(f"{before}{BEGIN}\n{text}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
