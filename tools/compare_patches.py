#!/usr/bin/env python3
"""Runs every method on every patch of a folder and writes a table of figures.

RESULTS keeps the answer of `planish compare --json` for each patch and method; a run whose answer
is there is not made again. Into RESULTS go comparison.csv, a row for each run, and comparison.md,
tables of medians and counts; with --update-docs also those of
docs/notebook.

Patches above LARGE vertices get FEW_SWEEPS sweeps of every method but auto, as global methods on
them take long; all others what each method usually takes. local_perturbation gets FEW_SWEEPS rounds
everywhere, and is given up after PATIENCE seconds. A program from outside takes part with --with, as in
`planish compare` (docs/research.md).
"""

import argparse
import csv
import json
import pathlib
import subprocess

import comparison_tables

LARGE, FEW_SWEEPS, PATIENCE = 20_000, 10, 60
SLOW = "local_perturbation"
ENDS_BY_ITSELF = "auto"
COLUMNS = [
    "patch", "vertices", "method", "sweeps", "stop", "seconds", "e_max", "e_avg", "energy",
    "sum_abs_defect", "strain_rms", "strain_max", "rms_deviation_over_diagonal", "min_angle",
    "roughness", "verdict",
]  # fmt: skip


def ask(planish, *words, patience=None):
    run = subprocess.run(
        [planish, *words, "--json", "--quiet"], capture_output=True, text=True, timeout=patience
    )
    return json.loads(run.stdout)


def all_methods(planish):
    """The names of all methods, as the program describes itself."""
    groups = ask(planish, "describe", "evolve")["verbs"][0]["groups"]
    return [group["method"] for group in groups if group["method"]]


def compared(planish, patch, vertices, method, programs):
    """What `planish compare` says of a patch; where the method failed it says why."""
    if method in programs:
        given = f"{method}={programs[method]}"
        return compared_by(planish, patch, ["--methods", "none", "--with", given])
    few = method == SLOW or (vertices > LARGE and method != ENDS_BY_ITSELF)
    flags = ["--sweeps", str(FEW_SWEEPS)] if few else []
    try:
        patience = PATIENCE if method == SLOW else None
        return compared_by(planish, patch, ["--methods", method, *flags], patience)
    except subprocess.TimeoutExpired:
        return {"runs": [{"method": method, "error": {"message": f"given up after {PATIENCE} s"}}]}


def compared_by(planish, patch, flags, patience=None):
    answer = ask(planish, "compare", patch, "--threads", "1", *flags, patience=patience)
    if "runs" not in answer:
        raise SystemExit(f"{patch}: {answer['error']['message']}")
    return answer


def kept(place, make):
    """What lies in a file, made and put there where it does not."""
    if not place.exists():
        place.write_text(json.dumps(make()), encoding="utf-8")
    return json.loads(place.read_text(encoding="utf-8"))


def answer_of(planish, patch, methods, results, programs):
    """The answers for all methods as one; the input as the first that has it says."""
    measured = kept(results / f"{patch.name}-input.json", lambda: ask(planish, "measure", patch))
    if "error" in measured:
        raise SystemExit(f"{patch}: {measured['error']['message']}")
    answers = [
        kept(
            results / f"{patch.name}-{method}.json",
            lambda method=method: compared(
                planish, patch, measured["vertices"], method, programs
            ),
        )
        for method in methods
    ]
    unfolded = next((a["unfold_before"] for a in answers if "unfold_before" in a), None)
    runs = [run for answer in answers for run in answer["runs"]]
    return {"input": measured, "unfold_before": unfolded, "runs": runs}


def figures(measured, unfolded):
    """The columns that the input patch and every result have."""
    strain = unfolded["strain"] if unfolded else {"rms": None, "max": None}
    return {
        **{k: measured[k] for k in ("e_max", "e_avg", "energy", "sum_abs_defect")},
        **{k: measured[k] for k in ("min_angle", "roughness")},
        "strain_rms": strain["rms"],
        "strain_max": strain["max"],
    }


def rows(name, answer):
    """A row for the input patch and one for each method."""
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


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("planish", metavar="PLANISH", help="the program")
    add = parser.add_argument
    add("folder", metavar="FOLDER", type=pathlib.Path, help="of .obj and .ply files")
    add("results", metavar="RESULTS", type=pathlib.Path, help="folder to write into")
    add("--methods", metavar="LIST", help="names with commas (default: all methods)")
    add("--with", action="append", default=[], dest="programs", metavar="NAME=COMMAND")
    add("--update-docs", action="store_true", help="write docs/notebook/comparison.* too")
    given = parser.parse_args()
    if comparison_tables.DOCS in [given.results.resolve(), *given.results.resolve().parents]:
        parser.error("RESULTS is in docs/; to write there use --update-docs")
    known = all_methods(given.planish)
    given.methods = given.methods.split(",") if given.methods else known
    for method in given.methods:
        if method not in known:
            parser.error(f"unknown method {method}; known are {', '.join(known)}")
    given.programs = dict(program.split("=", 1) for program in given.programs)
    given.methods += given.programs
    return given


def write_table(path, lines):
    with open(path, "w", encoding="utf-8") as file:
        table = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        table.writeheader()
        table.writerows(lines)


def main():
    given = arguments()
    given.results.mkdir(parents=True, exist_ok=True)
    patches = [p for p in given.folder.iterdir() if p.suffix in (".obj", ".ply")]
    if not patches:
        raise SystemExit(f"{given.folder}: no .obj or .ply file in it")
    lines = []
    for patch in sorted(patches, key=lambda p: (p.stat().st_size, p.name)):
        answer = answer_of(given.planish, patch, given.methods, given.results, given.programs)
        lines += map(rounded, rows(patch.stem, answer))
    table = given.results / "comparison.csv"
    write_table(table, lines)
    text = comparison_tables.tables(table)
    (given.results / "comparison.md").write_text(text + "\n", encoding="utf-8")
    if given.update_docs:
        write_table(comparison_tables.DOCS / "comparison.csv", lines)
        comparison_tables.main()


if __name__ == "__main__":
    main()
