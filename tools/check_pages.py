#!/usr/bin/env python3
"""Checks that figures on pages are those of the program.

    tools/check_pages.py PLANISH [FILE]    FILE: default tests/golden/page_figures

A line of FILE has five parts, with bars between them: a page, the beginning of a line of that page, a
figure as that line shows it, a command without `planish`, and where its JSON has the figure. The page must
show the figure, and what the program gives must round to it; a figure in percent is a hundred times that of
the program. Meshes of commands are `panel:5000` and the like, built-in samples with so many vertices, or
names of patches in the folder patches of the environment variable PLANISH_TEST_DATA: without it these
figures are only looked for on their pages.

Pages that name a version in a line `<!-- figures of planish X.Y.Z -->` must name the program's.
"""

import decimal
import json
import os
import pathlib
import re
import shlex
import subprocess
import sys
import tempfile

REPO = pathlib.Path(__file__).resolve().parent.parent
TABLE = REPO / "tests/golden/page_figures"
MARK = re.compile(r"^<!-- figures of planish (\S+) -->$", re.M)


class Figure:
    def __init__(self, line):
        self.page, self.start, self.shown, self.command, self.path = (part.strip() for part in line.split(" || "))

    def is_shown(self, page):
        # In a page of several tables the same line may begin twice: then one of them has the figure.
        lines = [line for line in page.splitlines() if line.lstrip().startswith(self.start)]
        whole = re.compile(r"(?<![\d.e+-])" + re.escape(self.shown) + r"(?![\d]|\.\d)")
        return any(whole.search(line) for line in lines)

    def is_that_of(self, value):
        """Whether the value rounds to what is shown."""
        text = self.shown.rstrip(" %")
        shown = decimal.Decimal(text.replace(",", ""))
        exact = decimal.Decimal(value) * (100 if "%" in self.shown else 1)
        half = decimal.Decimal(1).scaleb(shown.as_tuple().exponent) / 2
        return abs(exact - shown) <= half * decimal.Decimal("1.000001")


def read_table(path):
    lines = path.read_text(encoding="utf-8").splitlines()
    return [Figure(line) for line in lines if line and not line.startswith("#")]


def program_of(argument):
    words = shlex.split(argument)
    words[-1] = os.path.abspath(words[-1])
    return words


class Program:
    def __init__(self, words, folder):
        self.words, self.folder, self.said = words, folder, {}
        data = os.environ.get("PLANISH_TEST_DATA")
        self.patches = pathlib.Path(data) / "patches" if data else None

    def call(self, args):
        return subprocess.run([*self.words, *args], cwd=self.folder, capture_output=True, check=False)

    def mesh(self, word):
        """A path for the name of a mesh; None for a patch that is not there; other words as they are."""
        sample = re.fullmatch(r"(\w+):(\d+)", word)
        if sample:
            name = f"{sample[1]}-{sample[2]}.obj"
            self.call(["sample", sample[1], "--vertices", sample[2], "-o", name])
            return name
        if not re.fullmatch(r"patch/\w+", word):
            return word
        found = sorted(self.patches.glob(word.removeprefix("patch/") + ".*")) if self.patches else []
        return str(found[0]) if found else None

    def json(self, command):
        """What a command says; None where its patch is not there."""
        if command not in self.said:
            words = [self.mesh(word) for word in command.split()]
            if None in words:
                self.said[command] = None
            else:
                done = self.call([*words, "--json"])
                self.said[command] = json.loads(done.stdout) if done.stdout else {}
        return self.said[command]


def value_at(report, path):
    for part in path.split("."):
        report = report[int(part)] if isinstance(report, list) else report[part]
    return report


def figure_faults(figures, program):
    pages = {}
    for figure in figures:
        page = pages.setdefault(figure.page, (REPO / figure.page).read_text(encoding="utf-8"))
        if not figure.is_shown(page):
            yield f'{figure.page}: no line that begins with "{figure.start}" shows {figure.shown}'
            continue
        report = program.json(figure.command)
        if report is None:
            continue
        try:
            value = value_at(report, figure.path)
        except (KeyError, IndexError, TypeError):
            yield f"{figure.page}: planish {figure.command} has no {figure.path}"
            continue
        if not isinstance(value, (int, float)):
            yield f"{figure.page}: planish {figure.command} has no number at {figure.path}"
            continue
        if not figure.is_that_of(value):
            yield f"{figure.page}: shows {figure.shown}, where planish {figure.command} has {figure.path} {value}"


def version_faults(version):
    for path in sorted(REPO.glob("docs/**/*.md")):
        for told in MARK.findall(path.read_text(encoding="utf-8")):
            if told != version:
                yield f"{path.relative_to(REPO)}: its figures are those of planish {told}, this is {version}"


def main():
    figures = read_table(pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else TABLE)
    with tempfile.TemporaryDirectory() as folder:
        program = Program(program_of(sys.argv[1]), folder)
        version = json.loads(program.call(["--version", "--json"]).stdout)["version"]
        faults = [*version_faults(version), *figure_faults(figures, program)]
        looked_at = sum(program.said.get(figure.command) is not None for figure in figures)
    for fault in faults:
        print(fault)
    print(f"{len(figures)} figures of pages, {looked_at} computed again, {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
