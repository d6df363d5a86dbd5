#!/usr/bin/env python3
"""Measures what shards cost: small samples flattened in one run and in shards, each on one thread.

    tools/shards_table.py PLANISH [--patches 300] [--shards 20] [--repeats 3]

Prints the processor seconds of both (the least of all repeats, as other work on the machine only adds), their ratio,
and the memory of the largest process. Ends with 1 where the table of the shards is not that of the one run, or where a
shard that is killed and run again does more than one patch twice.
"""

import argparse
import json
import os
import pathlib
import shutil
import signal
import subprocess
import sys
import tempfile

SHAPES = ("panel", "saddle", "dome", "cylinder", "cone", "tangent")
SIZES = (100, 120, 140, 160, 180)


def make_inputs(planish, folder, count):
    """A list of meshes by formula, whose shapes and sizes repeat."""
    (folder / "in").mkdir()
    made = {}
    names = []
    for number in range(count):
        kind = SHAPES[number % len(SHAPES)], SIZES[number // len(SHAPES) % len(SIZES)]
        name = f"in/{kind[0]}-{number + 1:05}.obj"
        if kind in made:
            shutil.copy(made[kind], folder / name)
        else:
            words = [planish, "sample", kind[0], "--vertices", str(kind[1]), "-o", name]
            subprocess.run(words, cwd=folder, check=True, capture_output=True)
            made[kind] = folder / name
        names.append(name)
    (folder / "list.txt").write_text("".join(name + "\n" for name in names), encoding="utf-8")


def words_of(planish, out, *more):
    return [planish, "flatten", "--inputs", "list.txt", "-o", out, "--no-report", "--threads", "1", "--quiet", *more]


def measured(folder, words):
    """(processor seconds, memory in MB, exit code, what it printed) of a command."""
    with tempfile.TemporaryFile() as said:
        process = subprocess.Popen(words, cwd=folder, stdout=said, stderr=subprocess.DEVNULL)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = os.waitstatus_to_exitcode(status)
        said.seek(0)
        printed = said.read().decode()
    return usage.ru_utime + usage.ru_stime, usage.ru_maxrss / 1024, process.returncode, printed


def one_run(planish, folder):
    shutil.rmtree(folder / "one", ignore_errors=True)
    seconds, memory, *_ = measured(folder, words_of(planish, "one", "--csv", "one.csv"))
    return seconds, memory


def in_shards(planish, folder, count):
    shutil.rmtree(folder / "shards", ignore_errors=True)
    runs = [measured(folder, words_of(planish, "shards", "--shard", f"{k}/{count}")) for k in range(1, count + 1)]
    return sum(run[0] for run in runs), max(run[1] for run in runs)


def tables_equal(planish, folder):
    subprocess.run([planish, "collect", "shards"], cwd=folder, check=True, capture_output=True)
    return (folder / "shards/patches.csv").read_bytes() == (folder / "one.csv").read_bytes()


def done_twice(planish, folder, count):
    """Patches that a shard does again that was killed in its middle; None where it was done before it was killed."""
    shutil.rmtree(folder / "killed", ignore_errors=True)
    words = words_of(planish, "killed", "--shard", f"1/{count}")
    own = len(range(0, len((folder / "list.txt").read_text(encoding="utf-8").splitlines()), count))
    process = subprocess.Popen(words, cwd=folder, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    first = [process.stdout.readline() for _ in range(max(1, own // 2))]
    process.send_signal(signal.SIGKILL)
    printed = len(first) + len(process.stdout.readlines())
    process.stdout.close()
    process.wait()
    # What was begun is what was done and, of one thread, one more.
    begun = sum(path.is_dir() for path in (folder / "killed").iterdir())
    if process.returncode == 0 or printed == own:
        return None
    again = [json.loads(line) for line in measured(folder, [*words, "--resume"])[3].splitlines()]
    kept = sum(record["kept"] for record in again)
    if len(again) != own or kept < printed:
        return own
    return begun - kept


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("planish", type=os.path.abspath)
    parser.add_argument("--patches", type=int, default=300)
    parser.add_argument("--shards", type=int, default=20)
    parser.add_argument("--repeats", type=int, default=3)
    parser.add_argument("--folder", type=pathlib.Path, help="where to work (default: a temporary folder)")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory(dir=asked.folder) as name:
        folder = pathlib.Path(name)
        make_inputs(asked.planish, folder, asked.patches)
        pairs = []
        for _ in range(asked.repeats):
            pairs.append((one_run(asked.planish, folder), in_shards(asked.planish, folder, asked.shards)))
        one, shards = (min(pair[k][0] for pair in pairs) for k in (0, 1))
        memory = [max(pair[k][1] for pair in pairs) for k in (0, 1)]
        equal = tables_equal(asked.planish, folder)
        twice = done_twice(asked.planish, folder, asked.shards)
    print("| patches | shards | one run, processor s | shards, processor s | ratio | MB of one run | MB of a shard |")
    print("|---|---|---|---|---|---|---|")
    print(
        f"| {asked.patches} | {asked.shards} | {one:.2f} | {shards:.2f} | {shards / one:.3f} | {memory[0]:.0f} | {memory[1]:.0f} |"
    )
    print("\ntables equal:", "yes" if equal else "NO")
    print("a shard killed in its middle and run again does twice:", "it was done first" if twice is None else twice)
    return 0 if equal and (twice is None or twice <= 1) else 1


if __name__ == "__main__":
    sys.exit(main())
