#!/usr/bin/env python3
"""Runs flatten and unfold with every two settings that may stand together, and looks at each run:

    tests/pairwise/pairs.py PLANISH                  all runs
    tests/pairwise/pairs.py PLANISH --check FILE     also compares the hashes of all results with FILE
    tests/pairwise/pairs.py PLANISH --write FILE     writes them there
    ... --only TEXT      only runs that have TEXT in their command or name
    ... --list           prints the names of runs with their commands, and ends

The exit code, `limits_met`, `usable` and `missed` must go with each other and with all figures; limits
are computed again from the meshes that were written; one thread and two must give the same bytes. A
flag that has no values in settings.py is a fault, as is a pair that the program refuses without a rule
there, or takes in spite of one.
"""
import argparse
import concurrent.futures
import hashlib
import importlib.machinery
import itertools
import importlib.util
import json
import math
import os
import pathlib
import shlex
import subprocess
import sys
import tempfile

from covering import cover
from settings import LEFT_OUT, LEFT_OUT_OF, NEEDS, REFUSED, VALUES

REPO = pathlib.Path(__file__).resolve().parent.parent.parent
SAMPLES = {"panel": 150, "dome": 120}
SMALLER = 0.125  # of samples: in inches they still take few pages of paper
VERBS = ("flatten", "unfold")
USUAL_METHOD = "auto"

# The words of `missed` that are limits and targets.
LIMIT_WORDS = {
    "max": "strain",
    "p99": "p99_strain",
    "rms": "rms_strain",
    "max_stretch": "stretch",
    "p99_stretch": "p99_stretch",
    "max_compression": "compression",
    "p99_compression": "p99_compression",
}
ASKED_FOR = {*LIMIT_WORDS.values(), "deviation", "angle", "e_max", "bending", "rejected", "failure"}
# The kinds of limits of the first material and of the last.
MATERIAL_LIMITS = {"steel": ["p99"], "leather-lasted": ["max_stretch", "p99_stretch", "p99_compression"]}


def load_fingerprint():
    loader = importlib.machinery.SourceFileLoader("fingerprint", str(REPO / "tools/fingerprint"))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("fingerprint", loader))
    loader.exec_module(module)
    return module


# --- settings ---


def values_of(flag):
    """Those to be tried; None where nobody said."""
    if flag["name"] in VALUES:
        return VALUES[flag["name"]]
    if flag["type"] == "switch":
        return [""]
    choices = [choice for choice in flag["choices"] if choice != flag["default"]]
    return choices[:1] + choices[-1:] if len(choices) > 1 else choices or None


def settings_of(verb):
    """All settings of a verb, in its order, and of each flag the methods that it goes with (None: all)."""
    settings, methods, faults = [], {}, []
    for group in verb["groups"]:
        for flag in group["flags"]:
            name = flag["name"]
            known = methods.setdefault(name, set())
            known.add(group["method"])
            if len(known) > 1 or name in LEFT_OUT or (verb["name"], name) in LEFT_OUT_OF:
                continue
            values = values_of(flag)
            if values is None:
                faults.append(f"flag {name} of {verb['name']} has no values in tests/pairwise/settings.py")
            settings += [(name, value) for value in values or []]
    # All choices of a method are tried, as its flags hang on it.
    if "--method" in methods:
        settings = [setting for setting in settings if setting[0] != "--method"]
        choices = next(flag["choices"] for group in verb["groups"] for flag in group["flags"]
                       if flag["name"] == "--method")
        settings += [("--method", choice) for choice in choices if choice != USUAL_METHOD]
    return settings, methods, faults


class Rules:
    """What a verb lets stand together.

    methods   of each flag, the methods that it goes with; None among them: with all
    settings  that are tried, which says what values flags have
    """

    def __init__(self, methods, settings):
        self.methods = methods
        self.usual = {}
        for flag, value in settings:
            self.usual.setdefault(flag, value)
        self.refused = [tuple(parse(word) for word in rule.split(" + ")) for rule in REFUSED]
        self.refused = [rule for rule in self.refused if all(name in self.usual for name, _ in rule)]

    def completed(self, row):
        """With what its flags need; None where something else stands there."""
        row, again = dict(row), True
        while again:
            again = False
            for flag, value in list(row.items()):
                for needed in NEEDS.get(flag, []) + NEEDS.get(f"{flag}={value}", []):
                    name, values = parse(needed)
                    if name not in self.usual:
                        continue
                    choice = values.split("|") if values else None
                    if name in row:
                        if choice and row[name] not in choice:
                            return None
                        continue
                    row[name] = choice[0] if choice else self.usual[name]
                    again = True
                methods = self.methods.get(flag, {None})
                if not methods & {None, USUAL_METHOD} and "--method" not in row:
                    row["--method"] = min(methods)
        return row

    def may_stand(self, row):
        method = row.get("--method", USUAL_METHOD)
        for flag in row:
            methods = self.methods.get(flag, {None})
            if None not in methods and method not in methods:
                return False
        return not any(all(matches(row, part) for part in rule) for rule in self.refused)


def parse(word):
    """A flag, and its value or None for any."""
    name, is_given, value = word.partition("=")
    return name, value if is_given else None


def matches(row, part):
    name, value = part
    return name in row and value in (None, row[name])


def rows_of(verb):
    settings, methods, faults = settings_of(verb)
    rules = Rules(methods, settings)
    rows, forbidden = cover(settings, rules.completed, rules.may_stand)
    faults += [f"{verb['name']}: {pair} are in no run" for pair in left_out(settings, rows, forbidden)]
    return rows, forbidden, faults


def left_out(settings, rows, forbidden):
    """Pairs that are neither in a row nor apart by rule."""
    met = {pair for row in rows for pair in itertools.combinations(sorted(row.items()), 2)}
    apart = {tuple(sorted(pair)) for pair in forbidden}
    pairs = {tuple(sorted(pair)) for pair in itertools.combinations(settings, 2) if pair[0][0] != pair[1][0]}
    return sorted(pairs - met - apart)


def words_of(row):
    return [f"{flag}={value}" if value else flag for flag, value in row.items()]


# --- inputs ---


def read_obj(path):
    points, triangles = [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            points.append(tuple(map(float, words[1:4])))
        elif words[:1] == ["f"]:
            triangles.append(tuple(int(word.split("/")[0]) - 1 for word in words[1:4]))
    return points, triangles


def directed_edges(triangles):
    return {(t[k], t[(k + 1) % 3]) for t in triangles for k in range(3)}


def way_inside(triangles, length):
    """Vertices from the first one on the border that has a way inwards, each a neighbour of the one before."""
    edges = directed_edges(triangles)
    border = {v for v, w in edges if (w, v) not in edges} | {w for v, w in edges if (w, v) not in edges}
    ring = {}
    for v, w in sorted(edges):
        ring.setdefault(v, []).append(w)
        ring.setdefault(w, []).append(v)
    for start in sorted(border):
        way = [start]
        while len(way) < length:
            inner = [w for w in ring[way[-1]] if w not in border and w not in way]
            if not inner:
                break
            # The neighbour that is furthest from the border, by its own neighbours.
            way.append(max(inner, key=lambda w: (sum(x not in border for x in ring[w]), -w)))
        if len(way) == length:
            return way
    raise ValueError("no way inside")


def border_edge(triangles, vertex):
    """Of the border, from that vertex."""
    edges = directed_edges(triangles)
    return next((v, w) for v, w in sorted(edges) if v == vertex and (w, v) not in edges)


BALL = """v 5000 0 0
v 5010 0 0
v 5000 10 0
v 5000 0 10
f 1 3 2
f 1 2 4
f 1 4 3
f 2 3 4
"""


def prepare(program, folder):
    """A folder for each sample, with all that its runs read."""
    for name, vertices in SAMPLES.items():
        own = folder / name
        own.mkdir()
        subprocess.run([*program, "sample", name, "--vertices", str(vertices), "-o", "large.obj"], cwd=own, check=True,
                       capture_output=True)
        points, triangles = read_obj(own / "large.obj")
        lines = [f"v {' '.join(repr(SMALLER * x) for x in point)}" for point in points]
        lines += [f"f {a + 1} {b + 1} {c + 1}" for a, b, c in triangles]
        (own / "in.obj").write_text("\n".join(lines) + "\n")
        way = way_inside(triangles, 4)
        first, second = border_edge(triangles, way[0])
        files = {"cut.txt": " ".join(map(str, way)), "lines.txt": " ".join(map(str, way[1:])), "fixed.txt": way[-1],
                 "weights.txt": f"{way[-1]} 5", "allowances.txt": f"{first} {second} 3", "notches.txt": "0.25 v\n0.6 t",
                 "marks.txt": f"{way[-1]} drill", "ball.obj": BALL}
        for file, text in files.items():
            (own / file).write_text(f"{text}\n")


# --- what is computed again ---


def edges_with_areas(points, triangles):
    """Edge -> a third of the area of its triangles."""
    edges = {}
    for a, b, c in triangles:
        u = [points[b][k] - points[a][k] for k in range(3)]
        v = [points[c][k] - points[a][k] for k in range(3)]
        cross = (u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0])
        area = 0.5 * math.sqrt(sum(x * x for x in cross))
        for v0, v1 in ((a, b), (b, c), (c, a)):
            edge = (min(v0, v1), max(v0, v1))
            edges[edge] = edges.get(edge, 0.0) + area / 3.0
    return edges


def strain_of(surface, flat, scale=1.0):
    """As docs/unfold.md defines it: of the lengths of edges, weighed by area."""
    points, triangles = surface
    edges = edges_with_areas(points, triangles)
    strains = []
    for (v, w), area in edges.items():
        strain = math.dist(flat[0][v], flat[0][w]) / (scale * math.dist(points[v], points[w])) - 1.0
        strains.append((strain, area))
    whole = math.fsum(area for _, area in strains)
    figures = {"rms": math.sqrt(math.fsum(area * strain * strain for strain, area in strains) / whole)}
    ways = {"": abs, "_stretch": lambda strain: max(0.0, -strain), "_compression": lambda strain: max(0.0, strain)}
    for name, part in ways.items():
        parts = sorted((part(strain), area) for strain, area in strains)
        reached = 0.0
        for strain, area in parts:
            reached += area
            if reached >= 0.99 * whole:
                break
        figures |= {f"max{name}": parts[-1][0], f"p99{name}": strain}
    return figures


def near(a, b):
    return abs(a - b) <= 1e-7 + 1e-6 * abs(b)


def strain_faults(report, again):
    """Between figures that were computed again and those of JSON; p99 may jump to the next edge."""
    told = report["unfold"]["strain"] if "unfold" in report else report["strain"]
    for kind in ("max", "rms"):
        if not near(told[kind], again[kind]):
            yield f"strain {kind} is {told[kind]} in JSON and {again[kind]} in the files"
    limits = report["limits"]
    for limit in limits:
        reached = again[limit["kind"]]
        if not near(limit["reached"], reached) and not limit["kind"].startswith("p99"):
            yield f"the limit {limit['kind']} has reached {limit['reached']} in JSON and {reached} in the files"
        if limit["kept"] != (reached <= limit["asked"]) and not near(reached, limit["asked"]):
            yield f"the limit {limit['kind']} of {limit['asked']}: kept is {limit['kept']}, the files have {reached}"


def asked_limits(row):
    """The limits of strain that a command asks for: kind -> share, None for that of a material."""
    limits = {}
    if "--max-strain" in row:
        text, _, of_area = row["--max-strain"].partition("@")
        limits["p99" if of_area else "max"] = float(text.rstrip("%")) / 100.0
    if "--max-rms-strain" in row:
        limits["rms"] = float(row["--max-rms-strain"].rstrip("%")) / 100.0
    if "--material" in row:
        limits |= dict.fromkeys(MATERIAL_LIMITS[row["--material"]])
    return limits


def outcome_faults(verb, row, report, exit_code):
    missed, unfold = report["missed"], report.get("unfold", report)
    beyond = [limit["kind"] for limit in report["limits"] if not limit["kept"]]
    evolve = report.get("evolve", {})
    off_target = "--require-target" in row and evolve["stop"] != "reached_target"
    expected = 3 if beyond or "rejected_strain" in report or off_target else 0
    if exit_code != expected:
        yield f"exit code {exit_code}, where JSON asks for {expected}"
    asked = asked_limits(row)
    kinds = [limit["kind"] for limit in report["limits"]]
    if verb == "unfold" or "--pick" not in row:
        if sorted(asked) != sorted(kinds):
            yield f"limits {sorted(asked)} were asked for, and JSON has {sorted(kinds)}"
    for limit in report["limits"]:
        share = asked.get(limit["kind"])
        if share is not None and not math.isclose(limit["asked"], share):
            yield f"limit {limit['kind']}: asked for {share}, and JSON has {limit['asked']}"
    if report["limits_met"] != (not ASKED_FOR & set(missed)):
        yield f"limits_met is {report['limits_met']} beside {missed}"
    if report["usable"] != (not missed):
        yield f"usable is {report['usable']} beside {missed}"
    if {LIMIT_WORDS[kind] for kind in beyond} != set(LIMIT_WORDS.values()) & set(missed):
        yield f"limits {beyond} are not kept, and missed is {missed}"
    facts = {"overlap": unfold["overlaps"], "flipped_triangles": unfold["flipped_triangles"] > 0,
             "rejected": "rejected_strain" in report}
    if evolve:
        facts["crumpled"] = not evolve["smooth"]
        facts["form"] = not evolve["form_kept"]
        target = float(row.get("--target-e-max", "inf"))
        facts["e_max"] = evolve["after"]["e_max"] > target * (1 + 1e-9)
        facts["deviation"] = ("--max-deviation" in row
                              and evolve["deviation"]["max"] > length(row["--max-deviation"], row) * (1 + 1e-6))
    for word, is_so in facts.items():
        if is_so != (word in missed):
            yield f"{word}: figures say {is_so}, missed is {missed}"


def length(text, row):
    """In model units."""
    per_unit = {"mm": 1.0, "cm": 10.0, "dm": 100.0, "m": 1000.0, "in": 25.4}
    return float(text.removesuffix("mm")) / per_unit[row.get("--unit", "mm")]


# --- runs ---


class Job:
    """A command, on one sample."""

    def __init__(self, verb, row, sample):
        self.verb, self.row, self.sample = verb, row, sample
        given = dict(row)
        if verb == "flatten":
            given["--output"] = "out"
        given.setdefault("--output", "flat.obj")
        self.output = given["--output"]
        self.args = [verb, "in.obj", *words_of(given), "--json"]
        self.name = f"{sample}/{verb} {' '.join(words_of(row))}"
        # Short, for lines of hashes; --list says what it stands for.
        self.short = f"{sample}/{verb} {hashlib.sha256(self.name.encode()).hexdigest()[:8]}"

    def call(self, program, folder, threads):
        done = subprocess.run([*program, *self.args, f"--threads={threads}"], cwd=folder, capture_output=True,
                              check=False)
        return done.returncode, done.stdout, done.stderr

    def faults(self, folder, done):
        exit_code, said, complaint = done
        if exit_code not in (0, 3):
            rule = "; where that is a rule, name it in tests/pairwise/settings.py" if exit_code == 2 else ""
            error = next(line for line in complaint.decode().splitlines() if line.startswith("error:"))
            yield f"exit code {exit_code}: {error}{rule}"
            return
        report = json.loads(said)
        yield from outcome_faults(self.verb, self.row, report, exit_code)
        if self.verb == "flatten":
            surface, flat = read_obj(folder / "out/processed.obj"), read_obj(folder / "out/flat.obj")
            yield from strain_faults(report, strain_of(surface, flat))
        elif self.output == "flat.obj" and "--cut" not in self.row:
            surface, flat = read_obj(folder / "in.obj"), read_obj(folder / "flat.obj")
            yield from strain_faults(report, strain_of(surface, flat, float(self.row.get("--scale", "1"))))

    def run(self, program, inputs, fingerprint):
        """Faults, and lines of hashes."""
        results = []
        faults = []
        for threads in (1, 2):
            with tempfile.TemporaryDirectory() as name:
                folder = pathlib.Path(name)
                for path in (inputs / self.sample).iterdir():
                    os.symlink(path, folder / path.name)
                done = self.call(program, folder, threads)
                if threads == 1:
                    faults += self.faults(folder, done)
                results.append(lines_of(self, folder, done, fingerprint))
        if results[0] != results[1]:
            places = [line.split("  ", 1)[1] for line in set(results[0]) ^ set(results[1])]
            faults.append(f"one thread and two give different bytes: {sorted(set(places))}")
        return faults, results[0]


def lines_of(job, folder, done, fingerprint):
    exit_code, said, complaint = done
    everything = fingerprint.normalised("stdout", said) + b"\n" + complaint + b"\n%d" % exit_code
    lines = [f"{fingerprint.digest(everything)}  {job.short}: said"]
    for path in sorted(folder.rglob("*")):
        short = path.relative_to(folder).as_posix()
        # Pages have times; what they show is in the other files.
        if path.is_dir() or path.is_symlink() or path.name in ("job.json", "report.html"):
            continue
        content = fingerprint.normalised(path.name, path.read_bytes())
        lines.append(f"{fingerprint.digest(content)}  {job.short}: {short}")
    return lines


def rule_faults(program, inputs, verb):
    """Rules that the program does not have."""
    folder = inputs / next(iter(SAMPLES))
    settings, methods, _ = settings_of(verb)
    rules = Rules(methods, settings)
    for rule in rules.refused:
        row = rules.completed({name: value or rules.usual[name] for name, value in rule})
        with tempfile.TemporaryDirectory() as name:
            for path in folder.iterdir():
                os.symlink(path, pathlib.Path(name) / path.name)
            exit_code, _, _ = Job(verb["name"], row or {}, "").call(program, name, 1)
        if exit_code != 2:
            yield f"{verb['name']} {' '.join(words_of(row))} is taken, though settings.py says that it is refused"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--check", metavar="FILE")
    parser.add_argument("--write", metavar="FILE")
    parser.add_argument("--only", default="")
    parser.add_argument("--list", action="store_true")
    args = parser.parse_args()
    program = shlex.split(args.program)
    program[-1] = os.path.abspath(program[-1])

    described = json.loads(subprocess.run([*program, "describe", "--json"], check=True, capture_output=True).stdout)
    verbs = [verb for verb in described["verbs"] if verb["name"] in VERBS]
    faults, jobs, forbidden = [], [], 0
    for verb in verbs:
        rows, apart, missing = rows_of(verb)
        faults += missing
        forbidden += len(apart)
        jobs += [Job(verb["name"], row, sample) for row in rows for sample in SAMPLES]
    jobs = [job for job in jobs if args.only in job.name or args.only in job.short]
    if args.list:
        print("\n".join(f"{job.short}  {job.name}" for job in jobs))
        return 0

    fingerprint = load_fingerprint()
    lines = []
    with tempfile.TemporaryDirectory() as name:
        inputs = pathlib.Path(name)
        prepare(program, inputs)
        for verb in verbs:
            faults += rule_faults(program, inputs, verb)
        with concurrent.futures.ThreadPoolExecutor(os.cpu_count()) as pool:
            for job, (own, hashes) in zip(jobs, pool.map(lambda job: job.run(program, inputs, fingerprint), jobs)):
                faults += [f"{job.name} ({job.short})\n    {fault}" for fault in own]
                lines += hashes
    for fault in faults:
        print(fault)
    print(f"{len(jobs)} runs, {forbidden} pairs apart by rule, {len(faults)} faults")
    if args.write:
        pathlib.Path(args.write).write_text("\n".join(lines) + "\n", encoding="utf-8")
    different = fingerprint.compare(lines, args.check, bool(args.only)) if args.check else 0
    return 1 if faults or different else 0


if __name__ == "__main__":
    sys.exit(main())
