#!/usr/bin/env python3
"""What spreading the stretch gains over least stretch on the patches of a folder: the table of docs/notebook/unfold.md.

  spread_table.py PLANISH FOLDER

A line for each patch that is no flat one: strain on 99 % of the area and the largest of both patterns, in per cent,
and the spread pattern's figures over those of least stretch; then medians.
"""
import json, os, statistics, subprocess, sys, tempfile

FORMATS = (".obj", ".ply", ".stl", ".off")
LEAST = 1e-6  # strain that is none


def strain_of(program, path, flags):
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "unfold", path, "-o", os.path.join(folder, "flat.obj"), "--json", *flags]
        done = subprocess.run(command, capture_output=True, text=True)
        return json.loads(done.stdout)["strain"] if done.returncode == 0 else None


def main():
    if len(sys.argv) != 3:
        print(__doc__)
        return 2
    program, folder = sys.argv[1:]
    ratios = {"p99": [], "max": [], "rms": []}
    print("| patch | 99 % of the area | spread | largest | spread | p99 ratio | largest ratio | rms ratio |")
    print("|---|---|---|---|---|---|---|---|")
    for name in sorted(os.listdir(folder)):
        if not name.endswith(FORMATS):
            continue
        path = os.path.join(folder, name)
        least, spread = strain_of(program, path, ["--least-stretch"]), strain_of(program, path, [])
        if least is None or spread is None or least["p99"] < LEAST:
            continue
        row = {key: spread[key] / least[key] for key in ratios}
        for key, value in row.items():
            ratios[key].append(value)
        print(f"| {os.path.splitext(name)[0]} | {100 * least['p99']:.2f} | {100 * spread['p99']:.2f} "
              f"| {100 * least['max']:.1f} | {100 * spread['max']:.1f} "
              f"| {row['p99']:.3f} | {row['max']:.3f} | {row['rms']:.3f} |", flush=True)
    if ratios["rms"]:
        print(f"\n{len(ratios['rms'])} patches, medians: p99 {statistics.median(ratios['p99']):.3f}, largest "
              f"{statistics.median(ratios['max']):.3f}, rms {statistics.median(ratios['rms']):.3f}; most rms "
              f"{max(ratios['rms']):.4f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
