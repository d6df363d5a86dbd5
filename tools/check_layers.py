#!/usr/bin/env python3
"""Checks what the compiler does not: that layers include downwards only, that public headers and
programs stay clear of private ones, that what one system alone has stays in its rooms, that paths
are made from text by path_of() alone, that no elementary function of the C library decides a
result, that no name has two underscores on end, and that every error code has its paragraph in
docs/errors.md.

    platform <- {core, io, report}
    core <- mesh <- {io, measure} <- {evolve, unfold <- pattern} <- report;  core <- draw <- report;
    core <- solve <- {evolve, unfold}
"""

import pathlib
import re
import sys

REPO = pathlib.Path(__file__).resolve().parent.parent

# Layer -> the layers that it may include, besides itself.
ALLOWED = {
    "platform": set(),
    "core": {"platform"},
    "solve": {"core"},
    "mesh": {"core"},
    "io": {"platform", "core", "mesh"},
    "measure": {"core", "mesh"},
    "draw": {"core"},
    "evolve": {"core", "solve", "mesh", "io", "measure"},
    "unfold": {"core", "solve", "mesh", "io", "measure"},
    "pattern": {"core", "mesh", "unfold"},
    "report": {"platform", "core", "mesh", "io", "measure", "draw", "evolve", "unfold", "pattern"},
}

# Headers that not every system has.
SYSTEM_HEADERS = re.compile(
    r"(sys|arpa|linux|netinet)/.*|c?signal(\.h)?"
    r"|(dirent|dlfcn|fcntl|malloc|poll|pthread|pwd|sched|spawn|termios|unistd)\.h"
    r"|(conio|direct|io|process|shellapi|shlobj|windows|winsock2)\.h",
    re.IGNORECASE,
)
SYSTEM_MACROS = re.compile(
    r"^\s*#\s*(?:if|ifdef|ifndef|elif)\b.*\b"
    r"(__linux__|__GLIBC__|__APPLE__|__unix__|_POSIX\w*|_WIN32|_WIN64|__MINGW\w*|_MSC_VER)\b",
    re.MULTILINE,
)
# Text of a path by std::filesystem, which on Windows is not UTF-8; implicit conversions go unseen.
PATH_TEXT = re.compile(r"\.(?:generic_)?string\(\)|\b(?:fs|filesystem)::path\([^)]")
# Where all of these may be: one folder and one file for each system.
ROOMS = re.compile(r"src/platform/\w+/.*|apps/planish/host_\w+\.cpp")
# Functions whose last digit is another in each C library; src/core/math.h has them with the same
# bits everywhere.
LIBM = re.compile(
    r"\bstd::(a?(?:sin|cos|tan)h?|atan2|exp[2m]?1?|log(?:10|2|1p|b)?|pow|cbrt|hypot|fma|[lt]gamma|erfc?)\("
)
# Names that are reserved; clang does not warn of them in parameters of functions that are only declared.
TWO_UNDERSCORES = re.compile(r"\b[A-Za-z]\w*__\w*")
# Windows has headers of these names, and its own include each other by them.
TAKEN_NAMES = {"direct.h", "io.h", "process.h"}

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


def check_rooms(faults):
    """One system's headers and macros stay in their rooms, so that another system adds a room."""
    for root in ("include", "src", "apps", "examples"):
        for path in sources(root):
            name = path.relative_to(REPO).as_posix()
            if path.name in TAKEN_NAMES:
                faults.append(f"{name}: hides a header of Windows")
            text = path.read_text(encoding="utf-8")
            for match in TWO_UNDERSCORES.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                faults.append(f"{name}:{line}: {match[0]} is a reserved name")
            if ROOMS.fullmatch(name):
                continue
            for line, mark, header in includes(path):
                if mark == "<" and SYSTEM_HEADERS.fullmatch(header):
                    faults.append(f"{name}:{line}: <{header}> belongs into src/platform/")
            for match in LIBM.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                faults.append(f"{name}:{line}: {match[0]}) gives other bits with each C library: use core/math.h")
            for match in SYSTEM_MACROS.finditer(text):
                line = text.count("\n", 0, match.start(1)) + 1
                faults.append(f"{name}:{line}: {match[1]} belongs into src/platform/")
            for match in PATH_TEXT.finditer(text):
                line = text.count("\n", 0, match.start()) + 1
                faults.append(f"{name}:{line}: use path_of() and utf8_of() of platform/path.h")


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
    check_rooms(faults)
    check_error_docs(faults)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
