#!/usr/bin/env python3
"""Checks that the tables of options in docs/methods have the options and defaults of the program.

tools/check_options.py PLANISH
"""

import json
import pathlib
import re
import subprocess
import sys

REPO = pathlib.Path(__file__).resolve().parent.parent
TABLE = re.compile(r"\| option \| default \|.*?\n\|[-|]+\n((?:\|.*\n)+)")


def options_of_methods(program):
    """Method -> option, as the library names it -> default."""
    described = json.loads(subprocess.check_output([program, "describe", "evolve", "--json"]))
    return {
        group["method"]: {
            flag["name"][2:].replace("-", "_"): flag["default"]
            for flag in group["flags"]
            if flag["name"] != "--material"  # another way to set max_strain
        }
        for group in described["verbs"][0]["groups"]
        if group["method"]
    }


def documented(text):
    """Option -> default as the page's table has it. A row may be of several options."""
    rows = {}
    for line in TABLE.search(text)[1].splitlines():
        names, default = line.strip("| ").split("|")[:2]
        names = re.findall(r"`(\w+)`", names)
        defaults = [part.strip(" `") for part in re.sub(r"(\d),(\d)", r"\1\2", default).split(",")]
        rows |= dict(zip(names, defaults * len(names) if len(defaults) == 1 else defaults))
    return rows


def is_same(written, default):
    if default is None or isinstance(default, str):
        return written == ("none" if default is None else default)
    try:
        return float(written) == default
    except ValueError:
        return False


def main():
    if len(sys.argv) != 2:
        sys.exit(__doc__)
    faults = []
    for method, options in options_of_methods(sys.argv[1]).items():
        page = REPO / f"docs/methods/{method}.md"
        rows = documented(page.read_text(encoding="utf-8"))
        for name in sorted(options.keys() | rows.keys()):
            if name not in rows:
                faults.append(f"{page.name}: the table lacks {name}")
            elif name not in options:
                faults.append(f"{page.name}: method {method} has no option {name}")
            elif not is_same(rows[name], options[name]):
                faults.append(f"{page.name}: the default of {name} is {options[name]}, not {rows[name]}")
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
