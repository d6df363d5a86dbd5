#!/usr/bin/env python3
"""Tells how far the patterns of mirrored twins are apart under a bound of strain.

    tools/twins.py PLANISH FOLDER [NAME...]

A twin is the patch mirrored, turned, with other numbers of vertices and triangles, and rounded to
32-bit floats. Both are laid flat by `unfold --max-strain B`, where B is 0.55 of the largest strain
of plain `unfold`. The twin's pattern is mirrored back and laid over the other one by the best
motion of the plane. What is told is the largest distance of corresponding vertices, in mm per metre
of the patch's diagonal (docs/testing.md). Ends with 1 where one is above 0.1. FOLDER holds OBJ
files; NAMEs: these alone, else the ten of the table.
"""

import json
import math
import pathlib
import random
import struct
import subprocess
import sys
import tempfile

NAMES = ("gc_front_4k", "mhf_front_5k", "gc_back_5k", "dress_front_5k", "mhm_thigh_5k", "gc_sleeve_5k",
         "car_wing_5k", "shoe_vamp_4k", "boat_hull_5k", "jumpsuit_front_3k")
SHARE = 0.55  # of the largest strain without a bound
AIM = 0.1  # mm per metre


def read_obj(path):
    """Positions and triangles (from 0) of the v and f lines."""
    positions, triangles = [], []
    for line in path.read_text(encoding="utf-8").splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            positions.append(tuple(float(word) for word in words[1:4]))
        elif words[:1] == ["f"]:
            triangles.append(tuple(int(word.split("/")[0]) - 1 for word in words[1:4]))
    return positions, triangles


def write_obj(path, positions, triangles):
    with open(path, "w", encoding="utf-8") as file:
        for p in positions:
            file.write("v " + " ".join(repr(c) for c in p) + "\n")
        for t in triangles:
            file.write("f " + " ".join(str(v + 1) for v in t) + "\n")


def as_float(value):
    return struct.unpack("f", struct.pack("f", value))[0]


def turned(p):
    """By 0.7 about z, then 1.1 about x."""
    x, y, z = p
    x, y = math.cos(0.7) * x - math.sin(0.7) * y, math.sin(0.7) * x + math.cos(0.7) * y
    return x, math.cos(1.1) * y - math.sin(1.1) * z, math.sin(1.1) * y + math.cos(1.1) * z


def twin_of(positions, triangles):
    """The twin, and for each of its vertices that of the patch."""
    dice = random.Random(20100)
    order = list(range(len(positions)))
    dice.shuffle(order)
    number = {v: k for k, v in enumerate(order)}
    moved = [tuple(as_float(c) for c in turned((-positions[v][0], *positions[v][1:]))) for v in order]
    renumbered = [(number[a], number[c], number[b]) for a, b, c in triangles]
    dice.shuffle(renumbered)
    starts = [dice.randrange(3) for _ in renumbered]
    return moved, [t[k:] + t[:k] for t, k in zip(renumbered, starts)], order


def unfold(planish, mesh, flat, *flags):
    """The pattern of a mesh as complex numbers, and what --json says."""
    command = [planish, "unfold", str(mesh), "-o", str(flat), "--json", "--quiet", "--unit", "m", *flags]
    run = subprocess.run(command, capture_output=True, text=True, check=False)
    if run.returncode not in (0, 3):  # 3: the limit is not kept, the pattern is there
        raise RuntimeError(f"{mesh}: {run.stderr.strip()}")
    return [complex(x, y) for x, y, _ in read_obj(flat)[0]], json.loads(run.stdout)


def farthest(one, other):
    """Largest distance after the best turn and shift of the other."""
    one_mean, other_mean = sum(one) / len(one), sum(other) / len(other)
    one, other = [p - one_mean for p in one], [p - other_mean for p in other]
    turn = sum(p * q.conjugate() for p, q in zip(one, other))
    turn /= abs(turn)
    return max(abs(p - turn * q) for p, q in zip(one, other))


def diagonal(positions):
    return math.dist([min(c) for c in zip(*positions)], [max(c) for c in zip(*positions)])


def compare(planish, path, folder):
    """Bound, figures of both runs, distance in mm per metre of the diagonal."""
    positions, triangles = read_obj(path)
    moved, renumbered, order = twin_of(positions, triangles)
    twin = folder / "twin.obj"
    write_obj(twin, moved, renumbered)
    flat = folder / "flat.obj"
    bound = SHARE * unfold(planish, path, flat)[1]["strain"]["max"]
    limit = ("--max-strain", repr(bound))
    pattern, told = unfold(planish, path, flat, *limit)
    mirrored, told_twin = unfold(planish, twin, flat, *limit)
    back = [0j] * len(pattern)
    for k, v in enumerate(order):
        back[v] = -mirrored[k].conjugate()
    return bound, told, told_twin, 1000.0 * farthest(pattern, back) / diagonal(positions)


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    planish, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    missed = 0
    print("| patch | bound | largest strain, of the twin | steps | mm per metre |\n|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as scratch:
        for name in sys.argv[3:] or NAMES:
            bound, told, twin, distance = compare(planish, folder / f"{name}.obj", pathlib.Path(scratch))
            missed += distance > AIM
            steps = " and ".join(f"{run['iterations']}{'' if run['converged'] else '*'}" for run in (told, twin))
            print(f"| {name} | {bound:.5f} | {told['strain']['max']:.5f}, {twin['strain']['max']:.5f} | {steps} "
                  f"| {distance:.4f} |", flush=True)
    sys.exit(1 if missed else 0)


if __name__ == "__main__":
    main()
