#!/usr/bin/env python3
"""Checks what the compiler does not: that layers and the rooms of each (tools/rooms.py) include
downwards only, that folders stay small, that public headers and programs stay clear of private
ones, that what one system alone has stays in its rooms, that paths are made from text by path_of()
alone, that no elementary function of the C library decides a result, that no name has two
underscores on end, that no two headers have a type of one name, and that every error code has its paragraph in
docs/errors.md.
"""

import collections
import pathlib
import re
import sys

import rooms
from rooms import REPO, includes, layer_of, sources

# Layer -> the layers that it may include, besides itself.
ALLOWED = {
    "platform": set(),
    "core": {"platform"},
    "geometry": {"core"},
    "solve": {"core"},
    "mesh": {"core", "geometry"},
    "optimize": {"core", "solve"},
    "energy": {"core", "geometry", "solve", "optimize", "mesh", "measure"},
    "io": {"platform", "core", "mesh"},
    "measure": {"core", "geometry", "mesh"},
    "draw": {"core", "pattern"},
    "evolve": {"core", "geometry", "solve", "optimize", "energy", "mesh", "measure"},
    "unfold": {"core", "geometry", "solve", "optimize", "energy", "mesh", "measure"},
    "panels": {"core", "geometry", "solve", "energy", "mesh", "measure", "unfold"},
    "pattern": {"platform", "core", "geometry", "mesh", "io"},
    "flatten": {"core", "mesh", "measure", "evolve", "unfold"},
    "sheet": {"core", "geometry", "mesh", "draw", "unfold", "pattern", "flatten"},
    "report": {"core", "mesh", "io", "measure", "draw", "evolve", "unfold", "pattern", "flatten", "sheet"},
}

# Layer -> its floors, lowest first. A room includes those of lower floors; the layer's face, its
# public headers, is below them all.
FLOORS = {
    "platform": [["platform"], ["platform/posix", "platform/windows"]],
    "core": [["core"], ["core/simd"]],
    "geometry": [["geometry"]],
    "solve": [["solve/simd"], ["solve"]],
    "optimize": [["optimize"]],
    "energy": [["energy"]],
    "mesh": [
        ["mesh"],
        ["mesh/search", "mesh/coarsen", "mesh/cut", "mesh/polygon"],
        ["mesh/match", "mesh/carry", "mesh/repair"],
        ["mesh/imprint"],
        ["mesh/redundant", "mesh/geodesic", "mesh/symmetry"],
    ],
    "io": [["io/file"], ["io/unit"], ["io/formats", "io/svg", "io/model"], ["io"]],
    "measure": [["measure/simd"], ["measure"], ["measure/cautions", "measure/form"]],
    "draw": [["draw"], ["draw/text"], ["draw/svg", "draw/dxf", "draw/pdf", "draw/plt"]],
    "evolve": [
        ["evolve/simd"],
        ["evolve/state"],
        ["evolve/vertex_step", "evolve/systems"],
        ["evolve/methods", "evolve/auto/shared"],
        ["evolve/auto/smooth"],
        ["evolve/auto/near"],
        ["evolve"],
    ],
    "unfold": [
        ["unfold/strain", "unfold/disk"],
        ["unfold/start", "unfold/stretch"],
        ["unfold"],
        ["unfold/cuts"],
    ],
    "panels": [["panels/piece"], ["panels/cells"], ["panels/seams"], ["panels"]],
    "pattern": [["pattern/polygon"], ["pattern/curves"], ["pattern/allowance"], ["pattern", "pattern/nest"]],
    "flatten": [["flatten/choices", "flatten/steps"], ["flatten"], ["flatten/product"]],
    "sheet": [["sheet/piece"], ["sheet"], ["sheet/layout", "sheet/carry"]],
    "report": [["report"], ["report/charts"], ["report/pictures"], ["report/page"], ["report/product"]],
}

# Private headers that the program may include: only the program needs them.
FOR_THE_PROGRAM = {
    "core/fnv_hash.h",
    "core/simd/isa.h",
    "core/likely_units.h",
    "core/struct_fields.h",
    "draw/pdf/pdf_text.h",
    "draw/text/ascii_text.h",
    "draw/text/stroke_text.h",
    "evolve/direction.h",
    "flatten/evolve_progress.h",
    "flatten/product/piece_verdict.h",
    "flatten/product/workers.h",
    "flatten/reference_sweeps.h",
    "flatten/strain_limit_text.h",
    "flatten/twin_report.h",
    "flatten/verdict.h",
    "io/read_drawing.h",
    "io/svg/svg_drawing.h",
    "mesh/disjoint_sets.h",
    "mesh/match/twins.h",
    "mesh/mean_edge.h",
    "mesh/split.h",
    "mesh/symmetry/plane_text.h",
    "platform/memory.h",
    "platform/processors.h",
    "platform/path.h",
    "report/page/page_assets.h",
    "report/product/html_table.h",
    "platform/windows/wide.h",
    "report/json_parts.h",
    "report/several_files.h",
    "report/pictures/direction_map.h",
    "sheet/carry/drawing_on_sheet.h",
    "sheet/cut_sheet.h",
}
MOST_PUBLIC_HEADERS = 70

# No folder of code, tests or tools holds more.
MOST_FILES = 25

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
ROOMS = re.compile(r"src/platform/\w+/.*|apps/planish/shell/host_\w+\.cpp")
# Functions whose last digit is another in each C library; src/core/math.h has them with the same
# bits everywhere.
LIBM = re.compile(
    r"\bstd::(a?(?:sin|cos|tan)h?|atan2|exp[2m]?1?|log(?:10|2|1p|b)?|pow|cbrt|hypot|fma|[lt]gamma|erfc?)\("
)
# Names that are reserved; clang does not warn of them in parameters of functions that are only declared.
TWO_UNDERSCORES = re.compile(r"\b[A-Za-z]\w*__\w*")
# Windows has headers of these names, and its own include each other by them.
TAKEN_NAMES = {"direct.h", "io.h", "process.h"}


def floor_of(room):
    """Its floor in its layer, or None where FLOORS has none."""
    if room.startswith(rooms.FACE):
        return -1
    for floor, names in enumerate(FLOORS.get(layer_of(room), [])):
        if room in names:
            return floor
    return None


def fault_between(room, target):
    """What is wrong with a room's including another, or None."""
    own, other = layer_of(room), layer_of(target)
    if own not in ALLOWED or floor_of(room) is None:
        return f"{room} is no room that {__file__} knows"
    if own != other:
        return None if other in ALLOWED[own] else f"{own} must not include {other}"
    if floor_of(target) is None or floor_of(target) >= floor_of(room):
        return f"{room} must not include {target}"
    return None


def check_library(faults):
    for root in ("include/planish", "src"):
        for path in sources(root):
            if path == rooms.WHOLE:
                continue
            room = rooms.room_of(path)
            for line, mark, name in includes(path):
                where = f"{path.relative_to(REPO)}:{line}"
                if root != "src" and mark == '"':
                    faults.append(f"{where}: a public header includes a private one, {name}")
                    continue
                if root != "src" and "/" in name and not name.startswith("planish/"):
                    faults.append(f"{where}: a public header includes a foreign one, {name}")
                    continue
                target = rooms.room_of_include(path, mark, name)
                fault = None if target in {None, room} else fault_between(room, target)
                if fault:
                    faults.append(f"{where}: {fault} ({name})")


def check_folders(faults):
    """Folders stay small, and no rooms include each other in a circle."""
    counts = collections.Counter()
    for root in ("include", "src", "apps", "tests", "tools", "web", "bench", "examples", "json"):
        for path in (REPO / root).rglob("*"):
            if path.is_file() and "__pycache__" not in path.parts and "corpus" not in path.parts:
                counts[path.parent.relative_to(REPO).as_posix()] += 1
    for folder, count in sorted(counts.items()):
        if count > MOST_FILES:
            faults.append(f"{folder}: {count} files, more than {MOST_FILES}")
    try:
        rooms.floors(rooms.graph()[0])
    except ValueError as circle:
        faults.append(f"rooms include each other: {circle}")


def check_face(faults):
    """Few public headers, and one that includes them all."""
    headers = {p.relative_to(REPO / "include").as_posix() for p in sources("include")}
    if len(headers) > MOST_PUBLIC_HEADERS:
        faults.append(f"include/planish: {len(headers)} headers, more than {MOST_PUBLIC_HEADERS}")
    whole = {name for _, _, name in includes(rooms.WHOLE)}
    for header in sorted(headers - whole - {"planish/planish.h"}):
        faults.append(f"include/planish/planish.h: does not include <{header}>")


def check_users(faults):
    """Programs see the public headers and their own."""
    for root in ("apps/planish", "examples", "tests/consumer"):
        for path in sources(root):
            for line, mark, name in includes(path):
                own = (REPO / root / name).exists() or (path.parent / name).exists()
                allowed = root == "apps/planish" and name in FOR_THE_PROGRAM
                if mark == '"' and not own and not allowed:
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


TYPE = re.compile(r"^(?:template <.*>\s*)?(?:struct|class|enum class|enum) (\w+)[^;]*\{", re.M)


def check_types(faults):
    """Headers of the library have one namespace: two types of one name there break the rule of one definition,
    which no compiler tells. A header within a namespace of its own below it does not count."""
    places = collections.defaultdict(list)
    for root in ("include", "src"):
        for path in sorted((REPO / root).rglob("*.h")):
            text = path.read_text()
            if not re.search(r"^namespace planish \{", text, re.M):
                continue
            for name in TYPE.findall(text):
                places[name].append(str(path.relative_to(REPO)))
    for name, where in places.items():
        if len(where) > 1:
            faults.append(f"{' and '.join(where)}: each has a type {name}; give one of them another name")


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
    check_face(faults)
    check_folders(faults)
    check_users(faults)
    check_rooms(faults)
    check_error_docs(faults)
    check_types(faults)
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
