#!/usr/bin/env python3
"""Checks what the compiler does not: that layers include downwards only, that public headers and
programs stay clear of private ones, and that every error code has its paragraph in docs/errors.md.

    core <- mesh <- {io, measure} <- {evolve, unfold <- pattern} <- report;  core <- draw <- report;
    core <- solve <- {evolve, unfold}
"""

import pathlib
import re
import sys

REPO = pathlib.Path(__file__).resolve().parent.parent

# Layer -> the layers that it may include, besides itself.
ALLOWED = {
    "core": set(),
    "solve": {"core"},
    "mesh": {"core"},
    "io": {"core", "mesh"},
    "measure": {"core", "mesh"},
    "draw": {"core"},
    "evolve": {"core", "solve", "mesh", "io", "measure"},
    "unfold": {"core", "solve", "mesh", "io", "measure"},
    "pattern": {"core", "mesh", "unfold"},
    "report": {"core", "mesh", "io", "measure", "draw", "evolve", "unfold", "pattern"},
}

INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)


def sources(folder):
    paths = (REPO / folder).rglob("*")
    return sorted(p for p in paths if p.suffix in {".h", ".cpp"})


def includes(path):
    """Yields (line number, "<" or the quote, what is included)."""
    text = path.read_text(encoding="utf-8")
    for match in INCLUDE.finditer(text):
        yield text.count("\n", 0, match.start(2)) + 1, match[1], match[2]


def layer_of_include(path, mark, name):
    """The layer that an include of the library's own reaches into, or None for other headers."""
    if mark == "<":
        return name.split("/")[1] if name.startswith("planish/") else None
    if (path.parent / name).exists():
        return path.parent.relative_to(REPO / "src").parts[0]
    return name.split("/")[0]


def check_library(faults):
    for root in ("include/planish", "src"):
        for path in sources(root):
            layer = path.relative_to(REPO / root).parts[0]
            for line, mark, name in includes(path):
                where = f"{path.relative_to(REPO)}:{line}"
                if root != "src" and mark == '"':
                    faults.append(f"{where}: a public header includes a private one, {name}")
                    continue
                if root != "src" and "/" in name and not name.startswith("planish/"):
                    faults.append(f"{where}: a public header includes a foreign one, {name}")
                    continue
                target = layer_of_include(path, mark, name)
                if target is None or target == layer:
                    continue
                if layer not in ALLOWED:
                    faults.append(f"{where}: {layer} is no layer that {__file__} knows")
                elif target not in ALLOWED[layer]:
                    faults.append(f"{where}: {layer} must not include {target} ({name})")


def check_users(faults):
    """Programs see the public headers and their own."""
    for root in ("apps/planish", "examples", "tests/consumer"):
        for path in sources(root):
            for line, mark, name in includes(path):
                own = (REPO / root / name).exists() or (path.parent / name).exists()
                if mark == '"' and not own:
                    where = f"{path.relative_to(REPO)}:{line}"
                    faults.append(f"{where}: {root} must not include the private header {name}")


def error_codes():
    text = (REPO / "include/planish/core/error.h").read_text(encoding="utf-8")
    body = re.search(r"enum class ErrorCode \{(.*?)\};", text, re.DOTALL)[1]
    body = re.sub(r"//.*", "", body)
    yield from re.findall(r"\w+", body)
    # Failures that only the program knows.
    for path in sources("apps/planish"):
        yield from re.findall(r'json_failure\("(\w+)"', path.read_text(encoding="utf-8"))


def check_error_docs(faults):
    path = REPO / "docs/errors.md"
    if not path.exists():
        faults.append("docs/errors.md is missing")
        return
    headings = re.findall(r"^#+\s+`?(\w+)`?\s*$", path.read_text(encoding="utf-8"), re.MULTILINE)
    for code in error_codes():
        if code not in headings:
            faults.append(f"docs/errors.md: no heading for the error code {code}")


def main():
    faults = []
    check_library(faults)
    check_users(faults)
    check_error_docs(faults)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
