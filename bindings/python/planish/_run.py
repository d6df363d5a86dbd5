"""How functions call the library."""

from __future__ import annotations

import json
import os
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Sequence, TypeVar

from . import _core, errors
from ._meshes import as_mesh, text_of

if TYPE_CHECKING:
    from ._types import MeshLike, OwnMethod, Path, Progress

Result = TypeVar("Result")

# Keywords of files, which may also be given as rows.
ROW_KEYWORDS = {"cut", "fix", "weights", "notches", "seam_notches", "marks", "inner_lines", "edge_allowances"}
NOT_FLAGS = {"mesh", "faces", "name", "progress", "own", "patches", "result", "path", "as_designed"}
NOT_FLAGS |= {"inputs", "out", "shard", "workers", "resume", "csv", "keep_failures"}


def keywords_of(arguments: Mapping[str, Any]) -> dict[str, Any]:
    """Those of a function's arguments that are flags and were given."""
    return {key: value for key, value in arguments.items() if key not in NOT_FLAGS and value is not None}


def is_path(value: Any) -> bool:
    return isinstance(value, (str, os.PathLike))


def native(item: Any) -> Any:
    """What NumPy holds, as Python has it."""
    return item.tolist() if hasattr(item, "tolist") else item


def rows(keyword: str, value: Any, count: Optional[int]) -> list[Any]:
    """The lines of a file that says the same, each a text or its fields."""
    if isinstance(value, Mapping):
        return list(value.items())
    items = [native(item) for item in value]
    is_mask = keyword == "fix" and all(isinstance(item, bool) for item in items)
    if (is_mask or keyword == "weights") and items and len(items) != (count or len(items)):
        raise ValueError(f"{keyword} has {len(items)} items, but the mesh has {count} vertices")
    if is_mask:
        return [[vertex] for vertex, is_fixed in enumerate(items) if is_fixed]
    if keyword == "weights":
        return list(enumerate(items))
    are_single = bool(items) and not any(hasattr(item, "__len__") for item in items)
    if are_single and keyword in {"cut", "inner_lines"}:
        return [items]
    return [item if hasattr(item, "__len__") else [item] for item in items]


def typed(keywords: dict[str, Any], count: Optional[int] = None) -> dict[str, Any]:
    """The keywords, with rows of lists as rows and an obstacle as a mesh; count: vertices of the mesh."""
    given = dict(keywords)
    for keyword, value in keywords.items():
        if keyword in ROW_KEYWORDS and not is_path(value):
            given[keyword] = rows(keyword, value, count)
        elif keyword == "obstacle" and not is_path(value):
            given[keyword] = as_mesh(value)
    return given


def run(work: Callable[..., Result], mesh: _core.Mesh, keywords: dict[str, Any], *progress: Optional[Progress]) -> Result:
    """Runs the work of a verb on a mesh."""
    return work(mesh, typed(keywords, len(mesh.vertices)), *progress)


def run_compare(
    mesh: _core.Mesh,
    own: Optional[Mapping[str, OwnMethod | MeshLike]],
    keywords: dict[str, Any],
    progress: Optional[Progress],
) -> _core.CompareResult:
    """Compares methods of the library and, by their names, functions and results of others."""

    def of(value: Any) -> Any:
        if callable(value):
            return value
        return as_mesh(value, mesh.faces) if hasattr(value, "ndim") else as_mesh(value)

    others = None if own is None else {name: of(value) for name, value in own.items()}
    return _core.compare(mesh, others, typed(keywords, len(mesh.vertices)), progress)


def told_apart(names: list[str]) -> list[str]:
    """The names, with numbers where one stands for several meshes."""
    return [f"{name}-{place}" if names.count(name) > 1 else name for place, name in enumerate(names, start=1)]


def run_product(
    patches: Path | Sequence[Path | MeshLike] | Mapping[str, MeshLike],
    name: Optional[str],
    keywords: dict[str, Any],
    progress: Optional[Progress],
) -> _core.ProductResult:
    """Flattens files by the program's rules, or meshes, each one patch."""
    paths: list[Any]
    if isinstance(patches, (str, os.PathLike)):
        paths = [patches]
    else:
        paths = list(patches.values() if isinstance(patches, Mapping) else patches)
    if not isinstance(patches, Mapping) and paths and all(is_path(path) for path in paths):
        texts = [text_of(path) for path in paths]
        title = name or os.path.splitext(os.path.basename(texts[0]))[0]
        return _core.flatten_files(title, texts, typed(keywords), progress)
    meshes = [as_mesh(mesh) for mesh in paths]
    names: Iterable[Any] = patches if isinstance(patches, Mapping) else (mesh.name for mesh in meshes)
    pairs = list(zip(told_apart([str(own) for own in names]), meshes))
    if not pairs:
        raise errors.make("no_triangles", "the product has no patches")
    return _core.flatten_meshes(name or "product", pairs, typed(keywords), progress)


def run_many(
    inputs: Path | Sequence[Path],
    out: Path,
    shard: Optional[str],
    workers: Optional[int],
    resume: bool,
    csv: Optional[Path],
    keep_failures: Optional[Path],
    keywords: dict[str, Any],
    progress: Optional[Progress],
) -> list[dict[str, Any]]:
    """Flattens the files of a list, or those that are named, one by one."""
    given = {**typed(keywords), "output": text_of(out), "shard": shard, "threads": workers, "resume": resume}
    for keyword, path in {"csv": csv, "keep_failures": keep_failures}.items():
        given[keyword] = None if path is None else text_of(path)
    paths = []
    if isinstance(inputs, (str, os.PathLike)):
        given["inputs"] = text_of(inputs)
    else:
        paths = [text_of(path) for path in inputs]
        if not paths:
            return []
    records = [json.loads(line) for line in _core.flatten_many(paths, given, progress)]
    return sorted(records, key=lambda record: int(record["number"]))


def draw(result: Any, format_name: str, path: Optional[Path], as_designed: bool, keywords: dict[str, Any]) -> bytes:
    """The drawing of a pattern, also written where there is a path."""

    if isinstance(result, _core.FlattenResult):
        content = result._drawing(format_name, as_designed, typed(keywords))
    elif not isinstance(result, _core.UnfoldResult):
        kind = type(result).__name__
        raise TypeError(f"a result of flatten or unfold has a pattern to draw, not one of type {kind}")
    elif as_designed:
        raise ValueError("as_designed goes with a result of flatten only")
    else:
        content = result._drawing(format_name, typed(keywords))
    if path is not None:
        _core.write_bytes(text_of(path), content)
    return content
