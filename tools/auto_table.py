#!/usr/bin/env python3
"""Runs `planish flatten --prefer near` on all patches of a folder and writes a table of
docs/notebook/auto.md.

    tools/auto_table.py PLANISH FOLDER RESULTS

RESULTS is a folder where the answer for each patch is kept; a patch whose answer lies there is not
run again. "Flat" are the patches with e_max <= 1e-4, strain of the pattern <= 0.1 % rms and <= 1 %
at most, and no angle below the lesser of 5 degrees and half of the smallest at first; "smooth" those
whose surface is smooth beside the design (docs/fairness.md).
"""

import json
import math
import pathlib
import subprocess
import sys
import tempfile

PAGE = pathlib.Path(__file__).resolve().parent.parent / "docs" / "notebook" / "auto.md"
BEGIN, END = "<!-- table: begin -->", "<!-- table: end -->"
PATIENCE = 1800


def flatten(planish, patch, *flags):
    """The answer of `planish flatten`, {"error": ...} where it failed."""
    with tempfile.TemporaryDirectory() as folder:
        run = subprocess.run(
            [planish, "flatten", patch, "-o", folder, "--json", "--quiet", *flags],
            capture_output=True, text=True, timeout=PATIENCE,
        )  # fmt: skip
    return json.loads(run.stdout) if run.stdout else {"error": run.stderr}


def figures(answer):
    before, after = answer["evolve"]["before"], answer["evolve"]["after"]
    strain = answer["unfold"]["strain"]
    return {
        "vertices": before["vertices"],
        "stop": answer["evolve"]["stop"],
        "steps": answer["evolve"]["sweeps"],
        "seconds": answer["evolve"]["seconds"],
        "e_max": after["e_max"],
        "rms": strain["rms"],
        "max": strain["max"],
        "deviation": answer["evolve"]["deviation"]["rms_over_diagonal"],
        "angles": [math.degrees(m["min_angle"]) for m in (before, after)],
        "roughness": [m["roughness"] for m in (before, after)],
        "smooth": answer["evolve"]["smooth"],
    }


def is_flat(row):
    return (
        row["e_max"] <= 1e-4
        and row["rms"] <= 1e-3
        and row["max"] <= 1e-2
        and row["angles"][1] >= min(5.0, 0.5 * row["angles"][0])
    )


def line(cells):
    return "| " + " | ".join(cells) + " |"


def table(rows):
    head = [
        "patch", "vertices", "ended", "e_max", "strain rms, %", "strain max, %", "rms deviation, %",
        "smallest angle", "roughness", "steps", "s", "flat", "smooth",
    ]  # fmt: skip
    out = [line(head), line(["---"] * len(head))]
    for name, row in rows.items():
        out.append(
            line(
                [
                    name, str(row["vertices"]), row["stop"], f"{row['e_max']:.1e}",
                    f"{100 * row['rms']:.3f}", f"{100 * row['max']:.2f}",
                    f"{100 * row['deviation']:.2f}",
                    " -> ".join(f"{angle:.1f}" for angle in row["angles"]),
                    " -> ".join(f"{degrees:.1f}" for degrees in row["roughness"]),
                    str(row["steps"]), f"{row['seconds']:.1f}", "yes" if is_flat(row) else "no",
                    "yes" if row["smooth"] else "no",
                ]  # fmt: skip
            )
        )
    flat = sum(is_flat(row) for row in rows.values())
    smooth = sum(is_flat(row) and row["smooth"] for row in rows.values())
    return "\n".join(out + ["", f"{flat} of {len(rows)} patches are flat, {smooth} of them smooth."])


def main():
    planish, folder, kept = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    kept.mkdir(parents=True, exist_ok=True)
    rows = {}
    for patch in sorted([*folder.glob("*.obj"), *folder.glob("*.ply")]):
        answer = kept / (patch.stem + ".json")
        if not answer.exists():
            answer.write_text(json.dumps(flatten(planish, str(patch), "--prefer", "near")), encoding="utf-8")
        rows[patch.stem] = figures(json.loads(answer.read_text(encoding="utf-8")))
        print(line([patch.stem, rows[patch.stem]["stop"]]), flush=True)
    before, rest = PAGE.read_text(encoding="utf-8").split(BEGIN)
    after = rest.split(END)[1]
    PAGE.write_text(f"{before}{BEGIN}\n{table(rows)}\n{END}{after}", encoding="utf-8")


if __name__ == "__main__":
    main()
