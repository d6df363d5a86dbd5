#!/usr/bin/env python3
"""Prints how much of each folder's code the tests ran and what they did not, and fails below floors.

    check_coverage.py FOLDER PROGRAM...

FOLDER holds the .profraw files that instrumented test programs left; the programs are those. Needs
llvm-profdata and llvm-cov of clang 14. Branches are those of the source, so that exits by exceptions
that nothing throws do not count. On a processor without AVX-512 the code for it does not count.
"""

import collections
import json
import os
import pathlib
import re
import subprocess
import sys

REPO = pathlib.Path(__file__).resolve().parent.parent

# Name, what of src/ and include/planish/ belongs to it, floors in per cent of lines and branches.
FLOORS = [
    ("src and include", r"", 95.0, 85.0),
    ("readers", r"io/((formats/)?read_|formats/(obj|ply|stl|off|face_list)|file/(text_cursor|byte_cursor|cursor_error))", 100.0, 0.0),
    # Not what chooses between them.
    ("kernels", r"(core|measure|evolve|solve)/simd/(?!isa)", 100.0, 0.0),
]


# What available_isas() in src/core/simd/isa.cpp asks of a processor for x86-64-v4.
FLAGS_OF_V4 = {"avx512f", "avx512dq", "avx512vl"}


def processor_runs_v4():
    for line in pathlib.Path("/proc/cpuinfo").read_text().splitlines():
        if line.startswith("flags"):
            return FLAGS_OF_V4 <= set(line.split())
    return False


def lines_for_v4(name):
    """The lines of a source that only AVX-512 runs: all of a *_v4.cpp, or the branches of the
    preprocessor that ask for it."""
    path = REPO / "src" / name
    if not path.is_file():
        return set()
    inside, found = name.endswith("_v4.cpp"), set()
    for number, line in enumerate(path.read_text().splitlines(), start=1):
        if not name.endswith("_v4.cpp") and re.match(r"#(if|elif|else|endif)", line):
            inside = "__AVX512" in line
        if inside:
            found.add(number)
    return found


def exported(profiles, programs):
    merged = profiles / "merged.profdata"
    raw = sorted(str(path) for path in profiles.glob("*.profraw"))
    if not raw:
        sys.exit(f"no .profraw file in {profiles}")
    subprocess.run(["llvm-profdata-14", "merge", "-sparse", "-o", merged, *raw], check=True)
    command = ["llvm-cov-14", "export", "-skip-expansions", f"-instr-profile={merged}"]
    for number, program in enumerate(programs):
        command += [program] if number == 0 else ["-object", program]
    return json.loads(subprocess.run(command, check=True, stdout=subprocess.PIPE).stdout)


def share(covered, count):
    return 100.0 * covered / count if count else 100.0


def counts_by_line(segments):
    """How often each line was run, of the lines that have code, as llvm-cov shows it.

    A segment is (line, column, count, has a count, begins a region, is a gap), in order. Whatever
    instance of a template or of a header ran a line, ran it; llvm-cov's own summaries count every
    instance anew.
    """
    by_line = collections.defaultdict(list)
    for segment in segments:
        by_line[segment[0]].append(segment)
    counts = {}
    wrapped = None  # what goes on from lines above
    for line in range(min(by_line), max(by_line) + 1) if by_line else ():
        here = by_line.get(line, [])
        begun = [s[2] for s in here if s[3] and s[4] and not s[5]]
        is_skipped = bool(here) and here[0][4] and not here[0][3]
        goes_on = wrapped is not None and wrapped[3]
        if not is_skipped and (goes_on or begun):
            counts[line] = max(begun + ([wrapped[2]] if goes_on else []))
        if here:
            wrapped = here[-1]
    return counts


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    files = {}
    for entry in exported(pathlib.Path(sys.argv[1]), sys.argv[2:])["data"][0]["files"]:
        # A compiler cache may leave paths that go up and down.
        path = os.path.relpath(entry["filename"], REPO)
        name = re.sub(r"^(src|include/planish)/", "", path)
        if name != path:
            files[name] = entry
    folders = collections.defaultdict(lambda: [0, 0, 0, 0])

    lines_of = {name: counts_by_line(entry["segments"]) for name, entry in files.items()}
    if not processor_runs_v4():
        print("this processor has no AVX-512: the code for it does not count")
        for name, counts in lines_of.items():
            for line in lines_for_v4(name):
                counts.pop(line, None)

    def add(row, name):
        counts = lines_of[name].values()
        branches = files[name]["summary"]["branches"]
        more = (sum(c > 0 for c in counts), len(counts), branches["covered"], branches["count"])
        row[:] = [a + b for a, b in zip(row, more)]

    for name in files:
        add(folders[name.rsplit("/", 1)[0]], name)
    print(f"{'':24}{'lines %':>10}{'branches %':>12}")
    for folder, row in sorted(folders.items()):
        print(f"{folder:24}{share(*row[:2]):10.2f}{share(*row[2:]):12.2f}")
    failed = False
    for group, pattern, line_floor, branch_floor in FLOORS:
        row = [0, 0, 0, 0]
        inside = sorted(n for n in files if re.match(pattern, n))
        if not inside:
            sys.exit(f"nothing belongs to {group}")
        for name in inside:
            add(row, name)
        lines, branches = share(*row[:2]), share(*row[2:])
        low = lines < line_floor or branches < branch_floor
        failed = failed or low
        print(f"{group:24}{lines:10.2f}{branches:12.2f}   floors {line_floor:g} and {branch_floor:g}"
              + (": BELOW" if low else ""))
    print("lines that nothing ran:")
    for name, counts in sorted(lines_of.items()):
        missed = [str(line) for line, count in sorted(counts.items()) if count == 0]
        if missed:
            print(f"  {name}: {' '.join(missed)}")
    sys.exit(1 if failed else 0)


if __name__ == "__main__":
    main()
