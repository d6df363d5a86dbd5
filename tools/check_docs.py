#!/usr/bin/env python3
"""Checks that the docs say what is there: the examples in README.md and docs/research.md are those of examples/,
every link to a file of the project leads to one and to a heading that it has, every code of an
error has its paragraph, and docs/building.md has the packages that the scripts install."""

import pathlib
import re
import sys

REPO = pathlib.Path(__file__).resolve().parent.parent
PAGES = [*REPO.glob("*.md"), *REPO.glob("docs/**/*.md")]


# Codes of the program alone, which the library does not know.
PROGRAM_CODES = {"usage", "interrupted", "out_of_memory", "internal_error"}


def error_faults():
    header = (REPO / "include/planish/core/error.h").read_text(encoding="utf-8")
    codes = set(re.findall(r"^  (\w+),$", header.split("enum class ErrorCode {")[1].split("};")[0], re.M))
    page = (REPO / "docs/errors.md").read_text(encoding="utf-8")
    told = set(re.findall(r"^### (\w+)$", page, re.M))
    missing = sorted((codes | PROGRAM_CODES) - told)
    unknown = sorted(told - codes - PROGRAM_CODES)
    return [f"docs/errors.md: no paragraph on {code}" for code in missing] + [
        f"docs/errors.md: {code} is no code" for code in unknown
    ]


def anchors(text):
    """The names under which links reach the headings of a page."""
    found = set()
    for heading in re.findall(r"^#+ (.*)$", re.sub(r"```.*?```", "", text, flags=re.DOTALL), re.M):
        words = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading.strip().lower())
        name = re.sub(r"[^\w\- ]", "", words).replace(" ", "-")
        copies = [f"{name}-{k}" for k in range(1, len(found) + 1)]
        found.add(next(n for n in [name, *copies] if n not in found))
    return found


def link_faults(page):
    for link, anchor in re.findall(r"\]\(([^)#]*)(?:#([^)]*))?\)", page.read_text(encoding="utf-8")):
        if ":" in link:
            continue
        target = page.parent / link if link else page
        if not target.exists():
            yield f"{page.relative_to(REPO)}: no file at {link}"
        elif anchor and target.suffix == ".md":
            if anchor not in anchors(target.read_text(encoding="utf-8")):
                yield f"{page.relative_to(REPO)}: no heading at {link}#{anchor}"


def example_faults(name, languages):
    """Whether a page shows examples in these languages, each as it is in examples/ but for its first line."""
    page = (REPO / name).read_text(encoding="utf-8")
    shown = re.findall(r"`(examples/[\w/]+\.(\w+))`\):\n\n```\w+\n(.*?)```", page, re.DOTALL)
    for language in sorted(languages - {ending for _, ending, _ in shown}):
        yield f"{name}: there is no example in .{language}"
    for path, _, text in shown:
        # The file's first line says what it is for.
        if (REPO / path).read_text(encoding="utf-8").split("\n", 1)[1].strip() != text.strip():
            yield f"{name}: the example is not that of {path}"


def installed_packages(script):
    """Those of the tables of scripts/common.sh."""
    tables = re.findall(r'^\w+_packages="\n(.*?)^"', script, re.M | re.DOTALL)
    return {line.split()[0] for table in tables for line in table.splitlines()}


def wanted_versions():
    """Package -> the version that CMake asks for at least."""
    packages = {"Eigen3": "libeigen3-dev", "nlohmann_json": "nlohmann-json3-dev", "pybind11": "pybind11-dev",
                "Python3": "python3-dev"}
    wanted = {}
    for path in (REPO / name for name in ("CMakeLists.txt", "apps/planish/CMakeLists.txt",
                                          "bindings/python/CMakeLists.txt")):
        text = path.read_text(encoding="utf-8")
        for name, version in re.findall(r"find_package\((\w+) ([\d.]+)", text):
            wanted[packages[name]] = version
        for version in re.findall(r"cmake_minimum_required\(VERSION ([\d.]+)", text):
            wanted["cmake"] = version
    return wanted


def package_faults(script, page, wanted):
    """What docs/building.md says of packages beside what scripts and CMake ask for."""
    rows = re.findall(r"^\| `([\w.+-]+)` \| (.*) \|$", page, re.M)
    told = {name: [cell.strip() for cell in cells.split("|")] for name, cells in rows}
    packages = installed_packages(script)
    for name in sorted(packages - told.keys()):
        yield f"docs/building.md: no row on {name}, which scripts/common.sh installs"
    for name in sorted(told.keys() - packages):
        yield f"docs/building.md: {name} is not in scripts/common.sh"
    for name, cells in told.items():
        if len(cells) != 4 or not all(cells):
            yield f"docs/building.md: {name} needs a version, what it is for, a licence and whether it is needed"
        least = re.search(r"at least ([\d.]+)", cells[0])
        if name in wanted and (least is None or least[1] != wanted[name]):
            yield f"docs/building.md: {name}: CMake asks for at least {wanted[name]}"
    if len(rows) != len(told):
        yield "docs/building.md: a package has two rows"


def main():
    faults = error_faults()
    faults.extend(package_faults((REPO / "scripts/common.sh").read_text(encoding="utf-8"),
                                 (REPO / "docs/building.md").read_text(encoding="utf-8"), wanted_versions()))
    for name in ("README.md", "docs/research.md"):
        faults.extend(example_faults(name, {"cpp", "py"}))
    for page in PAGES:
        faults.extend(link_faults(page))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
