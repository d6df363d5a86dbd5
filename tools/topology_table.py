#!/usr/bin/env python3
"""Lays every mesh file of some folders flat and prints, for each folder, how many got a pattern.

    tools/topology_table.py PLANISH FOLDER... [--seconds 180] [--most 300000] [--list FILE]

Each file (.obj, .ply, .stl, .off) is given to `planish flatten`, and where that is refused or
overlaps itself, to `planish flatten --cut open`. The flat meshes that were written are read again
by this script alone: it counts triangles that are not upright and sides of outlines that cross
another side of the same piece, and computes the strain of edges. A file is sound where it holds
triangles and Planish, which mends what it can, finds an oriented manifold in it.
"""

import argparse
import json
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

MESHES = {".obj", ".ply", ".stl", ".off"}
EMPTY = {"no_triangles", "malformed_file", "truncated_file", "bad_number", "file_unreadable",
         "unsupported_format", "index_out_of_range", "non_finite_coordinate", "file_not_found"}
NOT_MANIFOLD = {"non_manifold_edge", "non_manifold_vertex", "non_orientable", "repeated_index",
                "inconsistent_orientation", "duplicate_triangle", "zero_length_edge"}
TOPOLOGY = {"closed_surface", "several_components", "several_border_loops", "handles",
            "misplaced_cut"}
KINDS = ("pattern", "overlap", "flip", "geometry", "topology", "time", "crash", "large",
         "not manifold", "empty")


def read_off(path):
    numbers = iter(path.read_text().split()[1:])
    count, faces, _ = (int(next(numbers)) for _ in range(3))
    points = [[float(next(numbers)) for _ in range(3)] for _ in range(count)]
    triangles = [[int(next(numbers)) for _ in range(4)][1:] for _ in range(faces)]
    return points, triangles


def read_obj(path):
    points, triangles = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append([float(word) for word in words[1:4]])
        elif words[:1] == ["f"]:
            triangles.append([int(word.split("/")[0]) - 1 for word in words[1:4]])
    return points, triangles


def read_ply(path):
    data = path.read_bytes()
    end = data.index(b"end_header\n") + len(b"end_header\n")
    head = data[:end].decode().splitlines()
    vertices, faces = (int(line.split()[2]) for line in head if line.startswith("element"))
    if "format ascii 1.0" in head:
        lines = data[end:].decode().splitlines()
        points = [[float(word) for word in line.split()[:3]] for line in lines[:vertices]]
        return points, [[int(word) for word in line.split()[1:4]]
                        for line in lines[vertices:vertices + faces]]
    kind = "<f8" if any(line.split()[:2] == ["property", "double"] for line in head) else "<f4"
    points = np.frombuffer(data, kind, 3 * vertices, end).reshape(-1, 3)
    row = np.dtype([("count", "u1"), ("corners", "<i4", 3)])
    table = np.frombuffer(data, row, faces, end + points.nbytes)
    return points, table["corners"]


def read_mesh(path):
    path = Path(path)
    points, triangles = {".off": read_off, ".obj": read_obj, ".ply": read_ply}[path.suffix](path)
    return np.array(points, float).reshape(-1, 3), np.array(triangles, int).reshape(-1, 3)


def sides_of(triangles):
    return np.concatenate([triangles[:, [0, 1]], triangles[:, [1, 2]], triangles[:, [2, 0]]])


def outline_of(triangles):
    """The sides that one triangle has."""
    sides = sides_of(triangles)
    known = {(int(a), int(b)) for a, b in sides}
    return np.array([(a, b) for a, b in known if (b, a) not in known], int).reshape(-1, 2)


def upside_down(flat, triangles):
    a, b, c = (flat[triangles[:, k]] for k in range(3))
    twice = (b - a)[:, 0] * (c - a)[:, 1] - (b - a)[:, 1] * (c - a)[:, 0]
    return int(np.count_nonzero(~(twice > 0.0)))


def crossings(flat, outline):
    """Pairs of sides that share no end and cross; what only touches does not count."""
    if len(outline) == 0:
        return 0
    size = float(np.ptp(flat, axis=0).max())
    starts, ends = flat[outline[:, 0]], flat[outline[:, 1]]
    low, high = np.minimum(starts, ends), np.maximum(starts, ends)
    cell = max(float((high - low).max()), size / 400.0, 1e-300)
    grid = {}
    for k, (first, last) in enumerate(zip(np.floor(low / cell).astype(int),
                                          np.floor(high / cell).astype(int))):
        for x in range(first[0], last[0] + 1):
            for y in range(first[1], last[1] + 1):
                grid.setdefault((x, y), []).append(k)
    found = set()
    least = 1e-10 * size * size
    for members in grid.values():
        m = np.array(members)
        if len(m) < 2:
            continue
        i, j = (m[part] for part in np.triu_indices(len(m), 1))
        boxes = np.all((low[i] <= high[j]) & (low[j] <= high[i]), axis=1)
        apart = (outline[i][:, :, None] != outline[j][:, None, :]).all(axis=(1, 2))
        i, j = i[boxes & apart], j[boxes & apart]

        def turn(p, q, r):
            return (q - p)[:, 0] * (r - p)[:, 1] - (q - p)[:, 1] * (r - p)[:, 0]

        one = turn(starts[i], ends[i], starts[j]), turn(starts[i], ends[i], ends[j])
        two = turn(starts[j], ends[j], starts[i]), turn(starts[j], ends[j], ends[i])
        cross = np.ones(len(i), bool)
        for a, b in (one, two):
            cross &= ((a > least) & (b < -least)) | ((a < -least) & (b > least))
        found.update(zip(i[cross], j[cross]))
    return len(found)


def strain_of(patch, flat, triangles):
    """Sum of squares over edges, weighted by the area around, and that area."""
    a, b, c = (patch[triangles[:, k]] for k in range(3))
    area = 0.5 * np.linalg.norm(np.cross(b - a, c - a), axis=1)
    sides = sides_of(triangles)
    length = np.linalg.norm(patch[sides[:, 1]] - patch[sides[:, 0]], axis=1)
    now = np.linalg.norm(flat[sides[:, 1]] - flat[sides[:, 0]], axis=1)
    good = length > 0.0
    strain = now[good] / length[good] - 1.0
    weight = np.concatenate([area, area, area])[good] / 3.0
    return float(np.sum(weight * strain * strain)), float(np.sum(weight))


def run(planish, path, folder, more, seconds):
    """The JSON of a run, and how it ended."""
    command = [planish, "flatten", str(path), "-o", str(folder), "--formats", "svg", "--json"]
    try:
        done = subprocess.run(command + more, capture_output=True, text=True, timeout=seconds,
                              check=False)
    except subprocess.TimeoutExpired:
        return {}, "time"
    try:
        return json.loads(done.stdout), done.returncode
    except ValueError:
        return {}, "crash"


def failures_of(result):
    """The errors of a run, by its pieces."""
    if "error" in result:
        return [result["error"]]
    return [patch["error"] for patch in result.get("patches", []) if patch.get("error")]


def judged(result, end):
    """What became of a file: the kind, figures, and words."""
    if end in ("time", "crash"):
        return end, {}, ""
    failures = failures_of(result)
    codes = [failure["code"] for failure in failures]
    for kind, known in (("empty", EMPTY), ("not manifold", NOT_MANIFOLD), ("topology", TOPOLOGY)):
        if any(code in known for code in codes):
            return kind, {}, codes[0]
    if failures:
        return "geometry", {}, failures[0]["message"]
    pieces = result.get("patches", [result])
    squares = area = 0.0
    flips = crossed = 0
    for piece in pieces:
        flat, triangles = read_mesh(piece["files"]["flat"])
        patch, _ = read_mesh(piece["files"]["processed"])
        here = strain_of(patch, flat, triangles)
        squares, area = squares + here[0], area + here[1]
        flips += upside_down(flat, triangles)
        crossed += crossings(flat[:, :2], outline_of(triangles))
    figures = {"pieces": len(pieces), "rms": (squares / area) ** 0.5 if area > 0.0 else 0.0}
    if flips:
        return "flip", figures, f"{flips} triangles"
    if crossed:
        return "overlap", figures, f"{crossed} crossings"
    return "pattern", figures, ""


def laid_flat(planish, path, folder, seconds):
    """The better one of the ways without and with a cut."""
    best = judged(*run(planish, path, folder / "as-is", [], seconds))
    if best[0] in ("empty", "not manifold", "pattern"):
        return best
    cut = judged(*run(planish, path, folder / "cut", ["--cut", "open"], seconds))
    if best[0] == "topology":
        return cut
    return min(best, cut, key=lambda outcome: KINDS.index(outcome[0]))


def triangles_in(path):
    """About how many a file has: by its size, so that large ones can be left out."""
    return path.stat().st_size // (50 if path.suffix.lower() in (".stl", ".ply") else 35)


def table_of(planish, folder, arguments):
    rows = []
    for path in sorted(Path(folder).iterdir()):
        if path.suffix.lower() not in MESHES:
            continue
        begin = time.time()
        if triangles_in(path) > arguments.most:
            outcome = "large", {}, ""
        else:
            with tempfile.TemporaryDirectory() as place:
                outcome = laid_flat(planish, path, Path(place), arguments.seconds)
        rows.append(outcome)
        kind, figures, words = outcome
        line = f"{path.name:40} {kind:12} {time.time() - begin:6.1f} s"
        if figures:
            line += f"  {figures['pieces']:3} pieces  rms {100.0 * figures['rms']:6.2f} %"
        print(f"{line}  {words}", file=arguments.list, flush=True)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n", maxsplit=1)[0])
    parser.add_argument("planish")
    parser.add_argument("folders", nargs="+")
    parser.add_argument("--seconds", type=float, default=180.0, help="for each run")
    parser.add_argument("--most", type=int, default=300_000, help="triangles of a file, about")
    parser.add_argument("--list", type=argparse.FileType("w"), default=sys.stderr,
                        help="where a line for each file goes")
    arguments = parser.parse_args()
    print("| set | files | sound | patterns | share | rms strain, median | overlaps | flips "
          "| geometry | topology | too slow |")
    print("|---|---|---|---|---|---|---|---|---|---|---|")
    for folder in arguments.folders:
        rows = table_of(arguments.planish, folder, arguments)
        count = {kind: sum(row[0] == kind for row in rows) for kind in KINDS}
        sound = len(rows) - count["empty"] - count["not manifold"] - count["large"]
        strains = [row[1]["rms"] for row in rows if row[0] == "pattern"]
        median = f"{100.0 * float(np.median(strains)):.1f} %" if strains else "-"
        share = f"{100.0 * count['pattern'] / sound:.0f} %" if sound else "-"
        print(f"| {Path(folder).name} | {len(rows)} | {sound} | {count['pattern']} | {share} "
              f"| {median} | {count['overlap']} | {count['flip']} | {count['geometry']} "
              f"| {count['topology']} | {count['time'] + count['crash']} |", flush=True)


if __name__ == "__main__":
    main()
