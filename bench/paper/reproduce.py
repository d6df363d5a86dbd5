#!/usr/bin/env python3
"""The evaluation of the 2010 paper in our own data: writes README.md, a page of
tables, pictures and figures.json.

    reproduce.py PLANISH OUT [FOLDER OF PATCHES]
    reproduce.py --update-docs PLANISH [FOLDER OF PATCHES]

Into docs/ it writes with --update-docs only. Without the folder of patches, or for a patch that is
not in it, built-in samples are taken. Called by bench/paper/reproduce, which builds the program first.
"""

import argparse
import json
import os
import pathlib
import re
import sys
import tempfile
import time

import convergence
import directions
import errata
import least_norm
import measures
import table_one
from markdown import table, wrapped
from patches import Patches
from program import Program

DOCS = pathlib.Path(__file__).resolve().parents[2] / "docs"
SECTIONS = [convergence, table_one, least_norm, directions, measures]


class Job:
    """What every section needs: the program, the patches, where to write, what the errata found."""

    def __init__(self, program, folder, out, found):
        self.program, self.out, self.errata = program, out, found
        self.patches = Patches(folder, program)


def errata_text(found):
    rows = []
    for e in errata.all_errata(found):
        if not e.shown:
            raise SystemExit(f"not shown: {e.where}: {e.check}")
        rows.append([e.where, e.printed, e.right, e.check])
    return f"""## The errata of the paper

From the text of the paper; the layout of symbols is judged from an extraction of it. Formulas are checked on
{errata.FANS} random fans of two rings, 3 to 9 neighbours, some of them on the border, against difference
quotients of the sixth order. A test does it all (`ctest -L paper`).

{table(["where", "as printed", "should be", "check"], rows)}"""


def processor():
    info = pathlib.Path("/proc/cpuinfo")
    names = re.findall(r"model name\s*: (.*)", info.read_text("utf-8")) if info.exists() else []
    return f"{names[0] if names else 'unknown processor'}, {os.cpu_count()} processors"


def marks(version):
    return f"""<!-- Made by bench/paper/reproduce: change that and run it, not this page. -->
<!-- figures of planish {version} -->"""


def page(version, summary, link):
    return f"""{marks(version)}
# The evaluation of the 2010 paper, in our own data

Lin, Zhang, Wang, Gao, *Flattenable mesh processing by controllable Laplacian evolution*, ASME DETC2010-28301, evaluates its
method in seven figures, 5 to 11, and a table. This page compares its claims with the corrected method
([controllable](../../methods/controllable.md)) on our own patches, as the paper's are not public. [All tables and
pictures]({link}), and why figures differ, are in the notebook. `bench/paper/reproduce` makes both pages.
Words are those of [notation](../../notation.md); Eq., Fig. and Table are the paper's.

{table(["", "the paper", "here"], summary)}"""


def notebook(version, sections, is_sample, link):
    data = (
        "no patches at hand: built-in samples stand for all of them" if is_sample
        else "patches of bodies, clothes and products, with source and licence beside each"
    )  # fmt: skip
    text = f"""{marks(version)}
# The paper's figures and tables, in our own data

The tables and pictures behind [the evaluation of the 2010 paper]({link}README.md). Each section ends with what is the
same, what differs, and why.

* Words are those of [notation](../notation.md); Eq., Fig. and Table are the paper's. Strain is that of the pattern's edges, rms;
  deviation is rms over the diagonal; angles and roughness are in degrees.
* Data: {data}.
* Seconds are of the evolution alone on one thread, medians of three up to 20,000 vertices, else of one run:
  planish {version}, {processor()}.
* All figures: [figures.json]({link}figures.json). What is printed in the paper: `bench/paper/printed.py`.

{chr(10).join(sections)}"""
    return re.sub(r"\]\(([\w-]+\.(?:png|svg))\)", rf"]({link}\1)", text).replace("](#the-errata", f"]({link}README.md#the-errata")


def arguments():
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--update-docs", action="store_true", help="write docs/notebook/paper and docs/notebook/paper.md")
    parser.add_argument("planish", type=pathlib.Path, help="the program")
    parser.add_argument("paths", type=pathlib.Path, nargs="*", help=argparse.SUPPRESS)
    given = parser.parse_args()
    if given.update_docs:
        given.paths.insert(0, DOCS / "notebook/paper")
    if not 1 <= len(given.paths) <= 2:
        parser.error("name the folder to write, or give --update-docs")
    out, folder = given.paths[0], given.paths[1] if len(given.paths) > 1 else None
    if not given.update_docs and out.resolve().is_relative_to(DOCS):
        parser.error(f"{out} is in docs/; to write docs/notebook/paper use --update-docs")
    return given.planish.resolve(), out, folder


def main():
    planish, out, folder = arguments()
    out.mkdir(parents=True, exist_ok=True)
    for kind in ("*.png", "*.svg"):  # of an earlier run, whose names may have been others
        for old in out.glob(kind):
            old.unlink()
    figures, texts, summary = {}, [], []
    with tempfile.TemporaryDirectory() as work:
        program = Program(planish, pathlib.Path(work))
        job = Job(program, folder, out, errata.measured())
        for section in SECTIONS:
            start = time.monotonic()
            text, figures[section.__name__], rows = section.make(job)
            texts.append(text)
            summary += rows
            print(f"{section.__name__}: {time.monotonic() - start:.0f} s", file=sys.stderr)
        version = program.ask("--version")["version"]
    figures["errata"] = job.errata
    tables = DOCS / "notebook/paper.md" if out == DOCS / "notebook/paper" else out / "tables.md"
    link = "paper/" if out == DOCS / "notebook/paper" else ""
    tables.write_text(wrapped(notebook(version, texts, folder is None, link)), encoding="utf-8")
    text = page(version, summary, os.path.relpath(tables, out)) + "\n" + errata_text(job.errata)
    (out / "README.md").write_text(wrapped(text), encoding="utf-8")
    (out / "figures.json").write_text(json.dumps(figures, indent=1) + "\n", encoding="utf-8")


if __name__ == "__main__":
    main()
