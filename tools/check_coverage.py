#!/usr/bin/env python3
"""Prints how much of each folder's code the tests ran, and fails where that is below its floor.

    check_coverage.py FOLDER PROGRAM...

FOLDER holds the .profraw files that instrumented test programs left; the programs are those. Needs
llvm-profdata and llvm-cov of clang 14. Branches are those of the source, so that ways out by
exceptions that nothing throws do not count.
"""

import collections
import json
import pathlib
import re
import subprocess
import sys

REPO = pathlib.Path(__file__).resolve().parent.parent

# Name, what of src/ and include/planish/ belongs to it, floors in per cent of lines and branches.
FLOORS = [
    ("src and include", r"", 95.0, 85.0),
    ("readers", r"io/(obj|ply|stl|off|read_|text_cursor|byte_cursor|cursor_error|face_list)", 100.0, 0.0),
    ("kernels", r"(core|measure|evolve|solve)/lanes/", 100.0, 0.0),
]


def exported(profiles, programs):
    merged = profiles / "merged.profdata"
    raw = sorted(str(path) for path in profiles.glob("*.profraw"))
    if not raw:
        sys.exit(f"no .profraw file in {profiles}")
    subprocess.run(["llvm-profdata-14", "merge", "-sparse", "-o", merged, *raw], check=True)
    command = ["llvm-cov-14", "export", "-skip-expansions", f"-instr-profile={merged}"]
    for number, program in enumerate(programs):
        command += [program] if number == 0 else ["-object", program]
    command += [str(REPO / "src"), str(REPO / "include")]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)


def share(covered, count):
    return 100.0 * covered / count if count else 100.0


def missed_lines(segments):
    """Numbers of the lines where a region begins that nothing ran."""
    return sorted({s[0] for s in segments if s[3] and s[2] == 0 and s[4]})


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    files = {}
    for entry in exported(pathlib.Path(sys.argv[1]), sys.argv[2:])["data"][0]["files"]:
        path = pathlib.Path(entry["filename"]).relative_to(REPO)
        name = re.sub(r"^(src|include/planish)/", "", str(path))
        files[name] = entry
    folders = collections.defaultdict(lambda: [0, 0, 0, 0])

    def add(row, summary):
        for at, kind in ((0, "lines"), (2, "branches")):
            row[at] += summary[kind]["covered"]
            row[at + 1] += summary[kind]["count"]

    for name, entry in files.items():
        add(folders[name.rsplit("/", 1)[0]], entry["summary"])
    print(f"{'':24}{'lines %':>10}{'branches %':>12}")
    for folder, row in sorted(folders.items()):
        print(f"{folder:24}{share(*row[:2]):10.2f}{share(*row[2:]):12.2f}")
    failed = False
    for group, pattern, line_floor, branch_floor in FLOORS:
        row = [0, 0, 0, 0]
        inside = {n: e for n, e in files.items() if re.match(pattern, n)}
        if not inside:
            sys.exit(f"nothing belongs to {group}")
        for entry in inside.values():
            add(row, entry["summary"])
        lines, branches = share(*row[:2]), share(*row[2:])
        low = lines < line_floor or branches < branch_floor
        failed = failed or low
        print(f"{group:24}{lines:10.2f}{branches:12.2f}   floors {line_floor:g} and {branch_floor:g}"
              + (": BELOW" if low else ""))
        if low or "-v" in sys.argv:
            for name, entry in sorted(inside.items()):
                missed = missed_lines(entry["segments"])
                if missed:
                    print(f"  {name}: {' '.join(map(str, missed[:20]))}{' ...' if len(missed) > 20 else ''}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
