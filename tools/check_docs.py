#!/usr/bin/env python3
"""Checks that the docs say what is there: the example in README.md is the one that is built, and
every link to a file of the project leads to one."""

import pathlib
import re
import sys

REPO = pathlib.Path(__file__).resolve().parent.parent
PAGES = [*REPO.glob("*.md"), *REPO.glob("docs/**/*.md")]


def main():
    faults = []
    readme = (REPO / "README.md").read_text(encoding="utf-8")
    shown = re.search(r"`(examples/\w+\.cpp)`\):\n\n```cpp\n(.*?)```", readme, re.DOTALL)
    # The file's first line tells what it is for.
    example = (REPO / shown[1]).read_text(encoding="utf-8").split("\n", 1)[1] if shown else None
    if example is None or example.strip() != shown[2].strip():
        faults.append("README.md: the example in C++ is not that of examples/")
    for page in PAGES:
        text = page.read_text(encoding="utf-8")
        for link in re.findall(r"\]\(([^)#]+)(?:#[^)]*)?\)", text):
            if ":" not in link and not (page.parent / link).exists():
                faults.append(f"{page.relative_to(REPO)}: no file at {link}")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
