#!/usr/bin/env python3
"""Sets auto beside least_norm at equal strain, and writes the table of docs/methods/auto.md.

    tools/equal_strain.py PLANISH FOLDER RESULTS [NAME...]

Each update of least_norm is run with its usual steps; where it ends there are a strain (rms, of the
unfolded pattern) and a deviation (rms). auto is run for a row of limits of strain, then twice more
between the two limits around that strain. Its deviation at that strain is the least of a run with no
more strain, or between two neighbouring runs on a line over the logarithm of strain. Strain below
1e-3 that auto reaches without a limit counts as equal. RESULTS keeps the answers: what lies there is
not run again. NAMEs: these patches alone, and no table.
"""

import concurrent.futures
import json
import math
import pathlib
import sys

from auto_table import PAGE, flatten, line

BEGIN, END = "<!-- equal: begin -->", "<!-- equal: end -->"
UPDATES = ("direct", "uniform", "cotangent")
LIMITS = (1.0, 0.7, 0.5, 0.3, 0.2, 0.14, 0.1, 0.07, 0.05, 0.035, 0.025, 0.018, 0.012, 0.008, 0.005)
FLAT = 1e-3
ROUNDING = 1.0 + 1e-6


class Runs:
    def __init__(self, planish, results):
        self.planish, self.results = planish, results

    def __call__(self, patch, tag, *flags):
        """Limit, strain, deviation of a run; None where it ended in an error."""
        kept = self.results / f"{patch.stem}.{tag}.json"
        if not kept.exists():
            answer = flatten(self.planish, str(patch), "--threads", "1", *flags)
            kept.write_text(json.dumps(answer), encoding="utf-8")
        answer = json.loads(kept.read_text(encoding="utf-8"))
        if "error" in answer:
            return None
        strain = answer["unfold"]["strain"]["rms"]
        return strain, answer["evolve"]["deviation"]["rms_over_diagonal"]

    def auto(self, patch, limit):
        flags = ("--max-strain", repr(limit)) if limit else ()
        return self(patch, f"auto{limit:.6g}", *flags)


def deviation_at(strain, runs):
    """Of auto at a strain, from its runs; infinite where none has so little."""
    runs = sorted(runs)
    within = [d for s, d in runs if s <= strain]
    best = min(within, default=math.inf)
    above = [run for run in runs if run[0] > strain]
    if within and above and runs[len(within) - 1][0] > 0.0:
        (s, d), (s_above, d_above) = runs[len(within) - 1], above[0]
        share = math.log(strain / s) / math.log(s_above / s)
        best = min(best, d + share * (d_above - d))
    return best


def compare(runs, patch):
    """For each update its strain, its deviation and that of auto; None for a failed run."""
    auto = {limit: runs.auto(patch, limit) for limit in (*LIMITS, 0.0)}
    auto = {limit: found for limit, found in auto.items() if found}
    least = auto.get(0.0, (math.inf, 0.0))[0]
    rows = []
    for update in UPDATES:
        ended = runs(patch, update, "--method", "least_norm", "--update", update)
        if not ended:
            rows.append(None)
            continue
        strain = max(ended[0], least if least <= FLAT else 0.0)
        for _ in range(2):
            low = max((limit for limit, run in auto.items() if limit and run[0] <= strain), default=0)
            high = min((limit for limit, run in auto.items() if run[0] > strain and limit > low), default=0)
            if low == 0 or high == 0 or high < 1.05 * low:
                break
            middle = float(f"{math.sqrt(low * high):.4g}")
            found = runs.auto(patch, middle)
            if found:
                auto[middle] = found
        rows.append((strain, ended[1], deviation_at(strain, auto.values())))
    return rows


def is_nearer(row):
    return row is None or row[2] <= row[1] * ROUNDING


def cells(rows):
    for row in rows:
        if row is None:
            yield "failed"
            continue
        strain, theirs, ours = (100.0 * value for value in row)
        yield f"{strain:.3f}: {theirs:.2f}, " + (f"{ours:.2f}" if math.isfinite(ours) else "-")


def main():
    planish, folder, results = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    names = sys.argv[4:]
    results.mkdir(parents=True, exist_ok=True)
    runs = Runs(planish, results)
    patches = sorted([*folder.glob("*.obj"), *folder.glob("*.ply")])
    patches = [patch for patch in patches if not names or patch.stem in names]
    out = [line(["patch", *UPDATES, "nearer than all"]), line(["---"] * 5)]
    nearer = 0
    with concurrent.futures.ThreadPoolExecutor(2) as pool:
        for patch, rows in zip(patches, pool.map(lambda p: compare(runs, p), patches)):
            won = all(is_nearer(row) for row in rows)
            nearer += won
            out.append(line([patch.stem, *cells(rows), "yes" if won else "no"]))
            print(out[-1], flush=True)
    out += ["", f"Nearer than all three on {nearer} of {len(patches)}."]
    print(out[-1])
    if names:
        return
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    after = rest.split(END)[1]
    text = "\n".join(out)
    PAGE.write_text(f"{before}{BEGIN}\n{text}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
