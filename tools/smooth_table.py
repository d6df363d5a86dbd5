#!/usr/bin/env python3
"""What `flatten` reaches on the patches of a folder: the tables of docs/methods/smooth.md.

  smooth_table.py PLANISH FOLDER [flags of flatten]

A line for each OBJ patch of at most 30,000 vertices, then medians over those whose borders allow flatness. Without
flags it is `--pick 5`: some flag has to ask for another form. Values of flags that end with D, as in --border 0.02D, are multiples of the diagonal of each patch's bounding box.
"""
import json, math, os, re, statistics, subprocess, sys, tempfile

MOST_VERTICES = 30_000
# Their borders forbid flatness, or they are flat already: not in the medians.
LEFT_OUT = ("cowhead", "face", "fish_side", "gc_hood", "goathead", "hat_crown", "hat_fedora", "spothead", "hemisphere",
            "lego_flat", "maze")


def diagonal_of(path):
    with open(path, encoding="utf-8") as file:
        places = [[float(x) for x in line.split()[1:4]] for line in file if line.startswith("v ")]
    return math.dist([min(axis) for axis in zip(*places)], [max(axis) for axis in zip(*places)])


def run(program, path, flags):
    if any(is_of_diagonal(flag) for flag in flags):
        diagonal = diagonal_of(path)
        flags = [str(float(flag[:-1]) * diagonal) if is_of_diagonal(flag) else flag for flag in flags]
    with tempfile.TemporaryDirectory() as folder:
        command = [program, "flatten", path, "-o", folder, "--json", *(flags or ["--pick", "5"])]
        done = subprocess.run(command, capture_output=True, text=True)
        if done.returncode not in (0, 3):
            return None
        return json.loads(done.stdout)


def is_of_diagonal(flag):
    return re.fullmatch(r"[0-9.]+D", flag) is not None


def vertices_of(path):
    with open(path, "rb") as file:
        return sum(1 for line in file if line.startswith(b"v "))


def main():
    if len(sys.argv) < 3:
        print(__doc__)
        return 2
    program, folder, flags = sys.argv[1], sys.argv[2], sys.argv[3:]
    rows = []
    print("| patch | smooth | bending | added | deviation, % | strain, % rms | stop |\n|---|---|---|---|---|---|---|")
    for name in sorted(os.listdir(folder)):
        path = os.path.join(folder, name)
        stem = os.path.splitext(name)[0]
        if not name.endswith(".obj") or vertices_of(path) > MOST_VERTICES:
            continue
        report = run(program, path, flags)
        if report is None:
            continue
        evolve, strain = report["evolve"], report["unfold"]["strain"]
        row = {"smooth": evolve["smooth"], "bending": evolve["bending_ratio"], "added": evolve["bending_added"],
               "deviation": 100 * evolve["deviation"]["rms_over_diagonal"], "strain": 100 * strain["rms"]}
        if not stem.startswith(LEFT_OUT):
            rows.append(row)
        figures = " | ".join("-" if row[key] is None else f"{row[key]:.3g}"
                             for key in ("bending", "added", "deviation", "strain"))
        print(f"| {stem} | {'yes' if row['smooth'] else 'no'} | {figures} | {evolve['stop']} |", flush=True)
    medians = ", ".join(f"{key} {statistics.median(row[key] for row in rows):.3g}"
                        for key in ("bending", "added", "deviation", "strain"))
    print(f"\n{len(rows)} whose border allows flatness: smooth {sum(row['smooth'] for row in rows)}; medians: {medians}; "
          f"at most 0.1 % rms: {sum(row['strain'] <= 0.1 for row in rows)}; "
          f"bending at most 1.3: {sum(row['bending'] <= 1.3 for row in rows)}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
