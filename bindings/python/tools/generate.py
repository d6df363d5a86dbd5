#!/usr/bin/env python3
"""Writes what follows from the program's one description of flags and from the module's classes:
planish/_verbs (the functions), planish/_core.pyi (types of the module) and the second half of
docs/python.md.

    bindings/python/tools/generate.py PACKAGES            writes them
    bindings/python/tools/generate.py PACKAGES --check    ends with 1 where they are not up to date

PACKAGES is the folder with the built package: build/package/python.
"""

import collections
import importlib.machinery
import importlib.util
import inspect
import json
import pathlib
import re
import sys
import textwrap
from keyword import iskeyword

HERE = pathlib.Path(__file__).resolve().parent.parent
REPO = HERE.parent.parent
MARK = "<!-- What follows is written by bindings/python/tools/generate.py. -->\n"
HEAD = '"""Written by tools/generate.py from `planish describe --json`. Change that."""\n'

# Flags that are no keywords, and why.
LEFT_OUT = {
    **dict.fromkeys(
        ["output", "output_format"],
        "results are returned; result.save(), write() and the drawing writers write files",
    ),
    "open": "a result shows its report in a notebook; result.report_html() is the page",
    "csv": "figures are in result.figures",
    "history": "figures are in result.figures",
    "fields": "result.fields",
    "require_target": "result.target_met and result.limits_met",
    "product": "flatten_product()",
    "rename": "pieces are called as their meshes are",
    **dict.fromkeys(["inputs", "shard", "keep_failures", "resume"], "flatten_many()"),
    "picture": "directions and cuts are not drawn from Python",
    "apply": "result.vertices and result.faces",
    "list": "an unknown name says which there are",
    **dict.fromkeys(["sheet", "nest_gap", "nest_margin", "nest_in_holes", "folded_cloth", "turn"], "laying pieces on material is the program's"),
    "json": "figures are in result.figures",
    "quiet": "result.notes",
    "help": "help()",
    "help_all": "help()",
    "version": "planish.__version__",
}
# What prepares the mesh of a file.
READING = dict.fromkeys("divide only without weld fill_holes side flip strict".split(), "of read()")
# The same of one function.
LEFT_OUT_OF = {
    "read": {"threads": "one is enough"},
    "measure": {"map": "result.fields", "unit": "figures are in model units", **READING},
    "flatten": {"seam_tolerance": "of a product", "no_match_seams": "of a product", **READING},
    **dict.fromkeys(["unfold", "suggest_cuts", "suggest_panels", "evolve"], READING),
    "compare": {"with_": "own", **READING},
    "flatten_product": {
        name: "of one patch"
        for name in "cut cut_along smooth_lines keep_small fix weights obstacle notches marks edge_allowances fold inner_lines piece_name".split()
    },
    "flatten_many": {
        "threads": "workers",
        "piece": "of one product",
        **dict.fromkeys(
            "fix weights obstacle notches marks edge_allowances fold inner_lines piece_name".split(), "of one patch"
        ),
    },
    "evolve_sweeps": {"remesh": "not with single sweeps", "smooth_first": "not with single sweeps", **READING},
}
# Which flags a writer of drawings takes.
DRAWING_GROUP = "What the pattern has besides its outline"
DRAWING_FLAGS = {
    "svg": {"text"},
    "dxf": {"text", "dxf_profile", "dxf_version", "dxf_notches", "dxf_layers"},
    "pdf": {"map", "paper"},
    "plt": set(),
}
MESH = "mesh: MeshLike, faces: Optional[ArrayLike] = None, *, name: Optional[str] = None"
PROGRESS = "progress: Optional[Progress] = None"
RUN = "return _run.run(_core.{verb}, _meshes.as_mesh(mesh, faces, name), given, progress)"

# Function -> verb, parameters before the flags, result, body, summary.
FUNCTIONS = {
    "measure": (
        "measure",
        f"{MESH}, {PROGRESS}",
        "_core.MeasureResult",
        RUN.format(verb="measure"),
        "Measures how far a patch is from flat, and what strain its pattern needs as it is.",
    ),
    "flatten": (
        "flatten",
        f"{MESH}, {PROGRESS}",
        "_core.FlattenResult",
        RUN.format(verb="flatten"),
        "The whole job: lays a patch flat, changed as little as its limits need.",
    ),
    "flatten_product": (
        "flatten",
        "patches: Path | Sequence[Path | MeshLike] | Mapping[str, MeshLike], *, name: Optional[str] = None, " + PROGRESS,
        "_core.ProductResult",
        "return _run.run_product(patches, name, given, progress)",
        "Flattens the patches of a product together: mesh files or one product file, which are divided into patches "
        "as the program does, or meshes, each one patch, by their names.",
    ),
    "flatten_many": (
        "flatten",
        "inputs: Path | Sequence[Path], *, out: Path, shard: Optional[str] = None, workers: Optional[int] = None, "
        f"resume: bool = False, csv: Optional[Path] = None, keep_failures: Optional[Path] = None, {PROGRESS}",
        "list[dict[str, Any]]",
        "return _run.run_many(inputs, out, shard, workers, resume, csv, keep_failures, given, progress)",
        "Flattens many mesh files one by one, as `flatten --inputs` does, and writes each into a folder in out: the files "
        "of a sequence of paths, or those that one path of a list names, a line each. Gives a record of each patch, in "
        "the order of the files; one that fails has an error. Memory does not grow with the number of files.",
    ),
    "evolve": (
        "evolve",
        f"{MESH}, {PROGRESS}",
        "_core.EvolveResult",
        RUN.format(verb="evolve"),
        "Changes a patch by one method towards flattenable; it stays in space. The method may be a function of your own, "
        "which takes a SweepInput and returns the places of all vertices after a sweep.",
    ),
    "evolve_sweeps": (
        "evolve",
        MESH,
        "_core.Sweeps",
        "return _run.run(_core.sweeps, _meshes.as_mesh(mesh, faces, name), given)",
        "The same as an iterator: a Sweep after each sweep, until evolve() would end.",
    ),
    "unfold": (
        "unfold",
        f"{MESH}, {PROGRESS}",
        "_core.UnfoldResult",
        RUN.format(verb="unfold"),
        "Lays a patch flat as it is, with the least stretch or within limits of strain.",
    ),
    "compare": (
        "compare",
        f"{MESH}, own: Optional[Mapping[str, OwnMethod | MeshLike]] = None, {PROGRESS}",
        "_core.CompareResult",
        "return _run.run_compare(_meshes.as_mesh(mesh, faces, name), own, given, progress)",
        "Tries several methods on a patch, one after the other. In own, by name, are functions that make a sweep and "
        "results of others (meshes with the same triangles, or their vertices), which take part like methods.",
    ),
    "suggest_cuts": (
        "suggest-cuts",
        f"{MESH}, {PROGRESS}",
        "_core.CutResult",
        RUN.format(verb="suggest_cuts"),
        "Looks for short cuts that let a mesh lie flat.",
    ),
    "suggest_panels": (
        "panels",
        f"{MESH}, {PROGRESS}",
        "_core.PanelsResult",
        RUN.format(verb="suggest_panels"),
        "Divides a whole product, closed or open, into few panels with short seams.",
    ),
    "read": (
        "convert",
        "path: Path, *",
        "_core.Mesh",
        "return _core.read(_meshes.text_of(path), given)",
        "Reads an OBJ, PLY, STL or OFF file. What is done to its mesh is in its notes; its groups are its pieces.",
    ),
    "sample": (
        "sample",
        "name: str, *",
        "_core.Mesh",
        "return _core.sample(name, given)",
        "A built-in patch made by formula, in millimetres.",
    ),
}
DRAWN = "result: _core.FlattenResult | _core.UnfoldResult, path: Optional[Path] = None, *, as_designed: bool = False"
for form, kind in {"svg": "SVG", "dxf": "DXF", "pdf": "PDF", "plt": "HPGL"}.items():
    FUNCTIONS[form] = (
        "unfold",
        DRAWN,
        "bytes" if form == "pdf" else "str",
        f'return _run.draw(result, "{form}", path, as_designed, given)' + ("" if form == "pdf" else ".decode()"),
        f"The pattern of a result at true size as {kind}, which is also written where there is a path. Without "
        "keywords it is as the result was made; with any, all that are not given here have their defaults, an allowance "
        "too. With as_designed it is the pattern of the unchanged design.",
    )

# The modules of planish/_verbs that hold more than the function of their name.
MODULES = {
    "flatten_product": "product",
    "flatten_many": "product",
    "evolve_sweeps": "evolve",
    **dict.fromkeys(DRAWING_FLAGS, "drawing"),
}

FILE_ROWS = {"cut", "fix", "weights", "notches", "seam_notches", "marks", "inner_lines", "edge_allowances"}
# Types that docstrings of the module do not say.
PROPERTY_TYPES = {
    "fields": "dict[str, npt.NDArray[np.float64]]",
    "figures": "dict[str, Any]",
    "pattern": "dict[str, Any]",
    "cuts": "list[npt.NDArray[np.uint32]]",
    "problems": "list[dict[str, Any]]",
    "panel_of": "npt.NDArray[np.uint32]",
    "seams": "list[npt.NDArray[np.uint32]]",
    "runs": "list[ComparedMethod]",
    "patches": "list[Optional[FlattenResult]]",
}


def keyword_of(flag):
    name = flag["name"].lstrip("-").replace("-", "_")
    return name + "_" if iskeyword(name) else name


def flags_of(description, function):
    """Keyword -> its flags, one or several methods may have it: (flag, method)."""
    verb, *_ = FUNCTIONS[function]
    groups = next(v for v in description["verbs"] if v["name"] == verb)["groups"]
    found = {}
    for group in [*groups, {"title": "", "method": None, "flags": description["every_verb"]}]:
        for flag in group["flags"]:
            keyword = keyword_of(flag)
            if keyword in LEFT_OUT or keyword in LEFT_OUT_OF.get(function, {}):
                continue
            if function in DRAWING_FLAGS and group["title"] != DRAWING_GROUP:
                if keyword not in DRAWING_FLAGS[function]:
                    continue
            if function in {"sample", *DRAWING_FLAGS} and keyword == "threads":
                continue
            found.setdefault(keyword, []).append((flag, group["method"]))
    return found


def type_of(function, keyword, flags):
    kinds = {"OwnMethod"} if keyword == "method" and function in {"evolve", "evolve_sweeps"} else set()
    for flag, _ in flags:
        kind = flag["type"]
        if flag["value_optional"]:
            kinds.add("bool")
        if keyword == "obstacle":
            kinds.add("MeshLike")
        elif keyword in FILE_ROWS:
            kinds.add("Rows")
        elif kind == "name" and flag["choices"] and not flag["extensions"]:
            kinds.add("Literal[" + ", ".join(f'"{choice}"' for choice in flag["choices"]) + "]")
        elif kind == "names" or flag["repeats"]:
            kinds.add("str | Sequence[str]")
        elif kind == "name" and flag["extensions"]:
            kinds.add("Path")
        elif keyword in {"grain", "fold"}:
            kinds.add("str | float | Sequence[float]" if keyword == "grain" else "str | Sequence[int]")
        else:
            kinds.add(
                {"switch": "bool", "integer": "int", "number": "float", "radians": "float"}.get(
                    kind, "Amount" if kind in {"share", "length", "angle"} else "str"
                )
            )
    return "Optional[" + " | ".join(sorted(kinds)) + "]"


def wrapped(text, indent, width=118):
    return "\n".join(textwrap.wrap(text, width, initial_indent=indent, subsequent_indent=indent + "    "))


def documentation(flags):
    lines = []
    for keyword, given in flags.items():
        words = dict.fromkeys(flag["help"] for flag, _ in given)
        lines.append(wrapped(f"{keyword}: {'; or '.join(words)}", "        "))
    return "\n".join(lines)


def function_text(description, function):
    verb, parameters, result, body, summary = FUNCTIONS[function]
    flags = flags_of(description, function)
    given = [f"    {part.strip()}," for part in re.split(r", (?=\*|\w+:)", parameters)]
    given += [f"    {keyword}: {type_of(function, keyword, found)} = None," for keyword, found in flags.items()]
    # The wrapped lines of a docstring must not end in a quote.
    doc = wrapped(summary, "    ").strip() + "\n\n    Keywords, as flags of the program:\n" + documentation(flags)
    doc = doc.replace("\\", "\\\\").replace('"""', "'''")
    return (
        f"def {function}(\n" + "\n".join(given) + f"\n) -> {result}:\n"
        f'    """{doc}\n    """\n    given = _run.keywords_of(locals())\n    {body}\n'
    )


def verb_modules(description):
    """Name of a module of planish/_verbs -> its source."""
    functions = {}
    for function in FUNCTIONS:
        functions.setdefault(MODULES.get(function, function), []).append(function_text(description, function))
    return {name: module_source("\n\n".join(texts)) for name, texts in functions.items()}


def import_of(source, names, text):
    """The import of those names that the text has."""
    used = [name for name in names if re.search(rf"\b{name}\b", text)]
    return f"from {source} import {', '.join(used)}\n" if used else ""


def module_source(functions):
    """With the imports of what the functions name."""
    types = [
        import_of("numpy.typing", ["ArrayLike"], functions),
        import_of(".._types", ["Amount", "MeshLike", "OwnMethod", "Path", "Progress", "Rows"], functions),
    ]
    of_types = "\n".join(f"    {line}" for line in types if line)
    body = (f"\nif TYPE_CHECKING:\n{of_types}" if of_types else "") + f"\n\n{functions}"
    return (
        HEAD
        + "\nfrom __future__ import annotations\n\n"
        + import_of("typing", ["TYPE_CHECKING", "Any", "Literal", "Mapping", "Optional", "Sequence"], body)
        + "\n"
        + import_of("..", ["_core", "_meshes", "_run"], body)
        + body
    )


def python_type(text):
    """The type that a docstring of pybind11 says, as Python writes it."""
    text = text.replace("planish._core.", "").replace("numpy.ndarray[numpy.", "npt.NDArray[np.")
    for old, new in {"Dict": "dict", "List": "list", "Tuple": "tuple"}.items():
        text = re.sub(rf"\b{old}\b", new, text)
    text = re.sub(r"\bdict$", "dict[str, Any]", text)
    return re.sub(r"\bobject\b", "Any", text)


def signature(doc):
    """(parameters, result) of the first line of a docstring of pybind11."""
    match = re.match(r"\w+\((.*)\) -> (.*)$", doc.splitlines()[0]) if doc else None
    if match is None:
        return "self", "Any"
    given = re.sub(r"\b(self|arg0): [\w.]+", "self", match[1], count=1)
    given = re.sub(r": dict\b", ": dict[str, Any]", given)
    return python_type(given), python_type(match[2])


def members(cls):
    """(name, kind, object) of a class, in the order of their definition."""
    for name, member in vars(cls).items():
        if name.startswith("__") and name not in {"__init__", "__iter__", "__next__"}:
            continue
        if name.startswith("_pybind"):
            continue
        yield name, "property" if isinstance(member, property) else "function", member


def words_of(member):
    """A docstring without the signature that pybind11 puts before it."""
    return "\n".join(line for line in (member.__doc__ or "").splitlines() if "->" not in line).strip()


def property_type(name, member):
    if name in PROPERTY_TYPES:
        return PROPERTY_TYPES[name]
    doc = member.fget.__doc__ or ""
    return python_type(doc.splitlines()[0].rpartition("-> ")[2]) if "->" in doc else "Any"


def class_stub(cls):
    lines = [f"class {cls.__name__}:"]
    for name, kind, member in members(cls):
        if kind == "property":
            lines += ["    @property", f"    def {name}(self) -> {property_type(name, member)}: ..."]
        elif inspect.isfunction(member) and name == member.__name__:
            lines.append(f"    {name} = {member.__module__.rpartition('.')[2]}.{name}")
        elif inspect.isfunction(member):
            lines.append(f"    def {name}(self) -> str: ...")
        elif name == "_drawing":
            flatten = "as_designed: bool, " if cls.__name__ == "FlattenResult" else ""
            lines.append(f"    def _drawing(self, format: str, {flatten}keywords: dict[str, Any]) -> bytes: ...")
        elif name == "save":
            lines.append("    def save(self, folder: Path) -> dict[str, str]: ...")
        elif name == "__init__":
            if "vertices" in (member.__doc__ or ""):
                lines.append("    def __init__(self, vertices: Any, faces: Any, name: str = ...) -> None: ...")
        else:
            given, result = signature(member.__doc__)
            result = {"__iter__": "Sweeps", "__next__": "Sweep"}.get(name, result)
            given = "self" if name.startswith("__") else given
            lines.append(f"    def {name}({given}) -> {result}: ...")
    return "\n".join(lines) + "\n"


def classes(core):
    return [cls for cls in vars(core).values() if inspect.isclass(cls)]


def core_stub(core):
    text = HEAD + textwrap.dedent(
        """
        from typing import Any, Optional

        import numpy as np
        import numpy.typing as npt

        from . import _meshes
        from ._types import Path
        from ._verbs import drawing

        __version__: str
        """
    )
    for cls in classes(core):
        text += "\n" + class_stub(cls)
    text += "\n"
    for name, member in vars(core).items():
        if inspect.isbuiltin(member):
            given, result = signature(member.__doc__)
            text += f"def {name}({given}) -> {result}: ...\n"
    return text


def paragraph(text):
    return "\n".join(textwrap.wrap(text, 118, break_long_words=False, break_on_hyphens=False)) + "\n"


def shared_keywords(description):
    """Keywords that several functions take, which the page lists once."""
    pattern = list(flags_of(description, "plt"))
    unfold = flags_of(description, "unfold")
    method = [name for name in flags_of(description, "evolve_sweeps") if name not in unfold]
    return {"keywords of patterns": pattern, "keywords of methods": method}


def quoted(names):
    return ", ".join(f"`{name}`" for name in names)


def keywords_told(description, function):
    names = list(flags_of(description, function))
    told = []
    for title, shared in shared_keywords(description).items():
        missing = [name for name in shared if name not in names]
        if len(missing) < len(shared) / 2:
            names = [name for name in names if name not in shared]
            but = f" but {quoted(missing)}" if missing else ""
            told.append(f"the [{title}](#{title.replace(' ', '-')}){but}")
    return "; ".join([quoted(names), *told] if names else told)


def members_told(cls):
    """(name, words) of what the page says of a class."""
    for name, kind, member in members(cls):
        if name in DRAWING_FLAGS:
            yield f"{name}()", f"[{name}](#{name}) of this result."
        elif not name.startswith("_") and words_of(member):
            shown = name if kind == "property" else f"{name}()"
            yield shown, " ".join(words_of(member).split())


def bullets(told):
    return "\n".join(textwrap.fill(f"* `{n}`: {words}", 118, subsequent_indent="  ") for n, words in told) + "\n"


def reference(description, core, planish):
    text = "\n## Functions\n"
    for function, (_, parameters, result, _, summary) in FUNCTIONS.items():
        short = re.sub(r": (?:[^,=\[]|\[[^]]*\])+(?= =|,|$)", "", parameters).replace(" = ", "=")
        signature = f"`planish.{function}({short}, ...)` -> `{result.replace('_core.', '')}`"
        text += f"\n### {function}\n\n{paragraph(signature)}\n"
        kind = summary.partition(" as ")[2].partition(",")[0]
        told = f"As [svg](#svg), in {kind}." if function in {"dxf", "pdf", "plt"} else summary
        text += paragraph(told) + "\n" + paragraph(f"Keywords: {keywords_told(description, function)}.")
    for function in ("write", "describe", "materials"):
        member = getattr(planish, function)
        given = re.sub(r": '[^']*'", "", str(inspect.signature(member)).partition(" ->")[0]).replace(" = ", "=")
        text += f"\n### {function}\n\n`planish.{function}{given}`\n\n" + paragraph(inspect.getdoc(member))
    for title, names in shared_keywords(description).items():
        text += f"\n### {title.capitalize()}\n\n" + paragraph(quoted(names) + ".")
    text += "\n### Flags without a keyword\n\n"
    reasons = {}
    for keyword, why in LEFT_OUT.items():
        reasons.setdefault(why, []).append(f"--{keyword.replace('_', '-')}")
    text += bullets(("`, `".join(flags), f"{why}.") for why, flags in reasons.items())
    text += "\n## Results\n\n### Several results\n\n"
    kinds = collections.Counter(told for cls in classes(core) for told in members_told(cls))
    common = [told for told, count in kinds.items() if count > 1]
    text += paragraph("Members of more than one class. Each class names the ones that it has.") + "\n" + bullets(common)
    for cls in classes(core):
        text += f"\n### {cls.__name__}\n\n" + paragraph(inspect.getdoc(cls))
        own = [told for told in members_told(cls) if told not in common]
        if own:
            text += "\n" + bullets(own)
        shared = [name for name, words in members_told(cls) if (name, words) in common]
        if shared:
            text += "\n" + paragraph(f"Also {quoted(shared)}.")
    return text


def load_core(packages):
    path = next(pathlib.Path(packages, "planish").glob("_core*.so"))
    loader = importlib.machinery.ExtensionFileLoader("planish._core", str(path))
    module = importlib.util.module_from_spec(importlib.util.spec_from_loader("planish._core", loader))
    loader.exec_module(module)
    return module


def main():
    packages, checks = sys.argv[1], "--check" in sys.argv
    stale = []

    def put(path, text):
        if path.exists() and path.read_text(encoding="utf-8") == text:
            return
        stale.append(path)
        if not checks:
            path.write_text(text, encoding="utf-8")

    core = load_core(packages)
    description = json.loads(core.description())
    for name, source in verb_modules(description).items():
        put(HERE / f"planish/_verbs/{name}.py", source)
    sys.path.insert(0, packages)
    import planish

    put(HERE / "planish/_core.pyi", core_stub(planish._core))
    page = REPO / "docs/python.md"
    head = page.read_text(encoding="utf-8").partition(MARK)[0]
    put(page, head + MARK + reference(description, planish._core, planish))
    for path in stale:
        print(f"{path.relative_to(REPO)}: " + ("not up to date: run bindings/python/tools/generate.py" if checks else "written"))
    return 1 if checks and stale else 0


if __name__ == "__main__":
    sys.exit(main())
