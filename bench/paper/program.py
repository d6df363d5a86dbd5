"""The program as a tool: what it makes of patches, each asked for once."""

import csv
import json
import statistics
import subprocess

import numpy as np

import surface

LARGE = 20_000  # vertices; above, a run is timed once, else three times


class Run:
    """An evolution: what `planish evolve --json` says, where the result lies, median seconds."""

    def __init__(self, answer, path, seconds):
        self.answer, self.path, self.seconds = answer, path, seconds
        self.before, self.after = answer["before"], answer["after"]


class Program:
    """@param work a folder for meshes that nobody keeps"""

    def __init__(self, planish, work):
        self.planish, self.work = str(planish), work
        self.known = {}

    def ask(self, *arguments):
        command = [self.planish, *map(str, arguments), "--quiet", "--json"]
        done = subprocess.run(command, capture_output=True, text=True, check=False)
        answer = json.loads(done.stdout or "{}")
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(command)}\n{answer.get('error', done.stderr)}")
        return answer

    def once(self, key, make):
        if key not in self.known:
            self.known[key] = make()
        return self.known[key]

    def new_path(self, suffix=".ply"):
        return self.work / f"{len(self.known)}{suffix}"

    def sample(self, name, vertices):
        path = self.work / f"{name}-{vertices}.ply"
        self.ask("sample", name, "--vertices", vertices, "-o", path)
        return path

    def measure(self, path):
        return self.once(("measure", path), lambda: self.ask("measure", path))

    def unfold(self, path):
        """Of the pattern, which is not kept."""
        out = self.new_path()
        return self.once(("unfold", path), lambda: self.ask("unfold", path, "-o", out))

    def strain(self, path):
        """Rms strain of the pattern's edges, as a fraction."""
        return self.unfold(path)["strain"]["rms"]

    def evolve(self, path, method, *flags, timed=False):
        """One thread, so that seconds compare with those of 2010."""
        return self.once(
            ("evolve", path, method, *flags, timed),
            lambda: self.evolved(path, ["--method", method, *flags], timed),
        )

    def evolved(self, path, flags, timed):
        out = self.new_path()
        arguments = ["evolve", path, "-o", out, "--threads", 1, *flags]
        answer = self.ask(*arguments)
        again = 2 if timed and answer["before"]["vertices"] <= LARGE else 0
        seconds = [answer["seconds"]] + [self.ask(*arguments)["seconds"] for _ in range(again)]
        return Run(answer, out, statistics.median(seconds))

    def surface(self, path):
        """The mesh of a file of any format."""
        if path.suffix == ".ply" and path.parent == self.work:
            return surface.read_ply(path)
        out = self.new_path()
        return surface.read_ply(
            self.once(("convert", path), lambda: self.ask("convert", path, out) and out)
        )

    def directions(self, path):
        """What `planish measure --map` says of the inner vertices: their numbers, L . grad b_v of
        each, and whether it is flat or can be lowered."""
        out = self.new_path(".csv")
        self.ask("measure", path, "--map", out)
        with open(out, newline="", encoding="ascii") as file:
            rows = [row for row in csv.DictReader(file) if row["laplacian_slope"]]
        return (
            np.array([int(row["vertex"]) for row in rows]),
            np.array([float(row["laplacian_slope"]) for row in rows]),
            np.array([row["class"] == "flat" for row in rows]),
            np.array([row["can_lower"] == "1" for row in rows]),
        )
