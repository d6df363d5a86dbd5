#!/usr/bin/env python3
"""Runs all methods on all patches of a folder and writes docs/comparison.csv and the tables of
docs/comparison.md.

    tools/compare_patches.py PLANISH FOLDER RESULTS

RESULTS is a folder where the answer of `planish compare --json` for each patch is kept; a patch
whose answer lies there is not run again. Patches above LARGE vertices get FEW_SWEEPS sweeps of
every method, as global methods on them take long; all others what each method usually takes.
local_perturbation gets FEW_SWEEPS rounds everywhere, and is given up after PATIENCE seconds.
"""

import csv
import json
import pathlib
import subprocess
import sys

import comparison_tables

LARGE, FEW_SWEEPS, PATIENCE = 20_000, 10, 60
SLOW = "local_perturbation"
METHODS = [
    "controllable", "classical", "least_norm", "flattenable_laplacian", "local_offset",
    "global_penalty", "fairing",
]  # fmt: skip
COLUMNS = [
    "patch", "vertices", "method", "sweeps", "stop", "seconds", "e_max", "e_avg", "energy",
    "sum_abs_defect", "strain_rms", "strain_max", "rms_deviation_over_diagonal", "min_angle",
    "roughness", "verdict",
]  # fmt: skip


def ask(planish, patch, *flags, patience=None):
    """What `planish compare` says of a patch; where every method failed it says why in each row."""
    command = [planish, "compare", patch, "--json", "--quiet", "--threads", "1", *flags]
    run = subprocess.run(command, capture_output=True, text=True, timeout=patience)
    answer = json.loads(run.stdout)
    if "runs" not in answer:
        raise SystemExit(f"{patch}: {answer['error']['message']}")
    return answer


def kept(place, make):
    """What lies in a file, made and put there where it does not."""
    if not place.exists():
        place.write_text(json.dumps(make()), encoding="utf-8")
    return json.loads(place.read_text(encoding="utf-8"))


def answer_of_slow(planish, patch):
    few = ["--sweeps", str(FEW_SWEEPS)]
    try:
        return ask(planish, patch, "--methods", SLOW, *few, patience=PATIENCE)["runs"]
    except subprocess.TimeoutExpired:
        return [{"method": SLOW, "error": {"message": f"given up after {PATIENCE} s"}}]


def answer_of_others(planish, patch):
    vertices = json.loads(
        subprocess.run(
            [planish, "measure", patch, "--json"], capture_output=True, text=True, check=True
        ).stdout
    )["vertices"]
    few = ["--sweeps", str(FEW_SWEEPS)] if vertices > LARGE else []
    return ask(planish, patch, "--methods", ",".join(METHODS), *few)


def figures(measured, unfolded):
    """The columns that the patch as it came and every result have."""
    strain = unfolded["strain"] if unfolded else {"rms": None, "max": None}
    return {
        **{k: measured[k] for k in ("e_max", "e_avg", "energy", "sum_abs_defect")},
        **{k: measured[k] for k in ("min_angle", "roughness")},
        "strain_rms": strain["rms"],
        "strain_max": strain["max"],
    }


def rows(name, answer):
    """A row for the patch as it came and one for each method."""
    shared = {"patch": name, "vertices": answer["input"]["vertices"]}
    yield {**shared, "method": "input", **figures(answer["input"], answer["unfold_before"])}
    for run in answer["runs"]:
        row = {**shared, "method": run["method"]}
        if "after" not in run:
            yield {**row, "verdict": run["error"]["message"]}
            continue
        row.update({k: run[k] for k in ("sweeps", "stop", "seconds", "verdict")})
        row["rms_deviation_over_diagonal"] = run["deviation"]["rms_over_diagonal"]
        yield {**row, **figures(run["after"], run["unfold"])}


def rounded(row):
    """Four digits are enough to compare by."""
    return {k: f"{v:.4g}" if isinstance(v, float) else v for k, v in row.items()}


def main():
    planish, folder, results = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    results.mkdir(parents=True, exist_ok=True)
    patches = [p for p in folder.iterdir() if p.suffix in (".obj", ".ply")]
    lines = []
    for patch in sorted(patches, key=lambda p: (p.stat().st_size, p.name)):
        slow = kept(results / f"{patch.name}-slow.json", lambda: answer_of_slow(planish, patch))
        answer = kept(results / f"{patch.name}.json", lambda: answer_of_others(planish, patch))
        answer["runs"] += slow
        lines += map(rounded, rows(patch.stem, answer))
    with open(comparison_tables.DOCS / "comparison.csv", "w", encoding="utf-8") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(lines)
    comparison_tables.main()


if __name__ == "__main__":
    main()
