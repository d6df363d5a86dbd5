"""How functions call the library."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Callable, Iterable, Mapping, Optional, Sequence, TypeVar

from . import _core, errors
from ._meshes import as_mesh, text_of

if TYPE_CHECKING:
    from ._types import MeshLike, Path, Progress

Result = TypeVar("Result")

# Keywords of files, which may also be given as rows.
ROW_KEYWORDS = {"cut", "fix", "weights", "notches", "seam_notches", "marks", "inner_lines", "edge_allowances"}
NOT_FLAGS = {"mesh", "faces", "name", "progress", "patches", "result", "path", "as_designed"}


def keywords_of(arguments: Mapping[str, Any]) -> dict[str, Any]:
    """Those of a function's arguments that are flags and were given."""
    return {key: value for key, value in arguments.items() if key not in NOT_FLAGS and value is not None}


def word(item: Any) -> str:
    """An item of a line, a number with all its digits."""
    if isinstance(item, str):
        return item
    return str(item.__index__()) if hasattr(item, "__index__") else repr(float(item))


def is_numpy_bool(item: Any) -> bool:
    return getattr(getattr(item, "dtype", None), "kind", "") == "b"


def line(row: Any) -> str:
    return row if isinstance(row, str) else " ".join(word(item) for item in row)


def lines(keyword: str, rows: Any) -> list[str]:
    """The lines of a file that says the same."""
    if isinstance(rows, Mapping):
        return [line(row) for row in rows.items()]
    items = list(rows)
    if keyword == "fix" and items and all(isinstance(item, bool) or is_numpy_bool(item) for item in items):
        return [line([vertex]) for vertex, is_fixed in enumerate(items) if is_fixed]
    if keyword == "weights":
        return [line(row) for row in enumerate(items)]
    are_single = bool(items) and not any(isinstance(item, str) or hasattr(item, "__len__") for item in items)
    if are_single and keyword in {"cut", "inner_lines"}:
        return [line(items)]
    return [line([item] if not hasattr(item, "__len__") else item) for item in items]


def is_path(value: Any) -> bool:
    return isinstance(value, (str, os.PathLike))


def write_rows(folder: str, keyword: str, value: Any) -> str:
    """Writes what a keyword says into a file, as the program reads it."""
    if keyword == "obstacle":
        path = os.path.join(folder, "obstacle.ply")
        _core.write(path, as_mesh(value))
        return path
    path = os.path.join(folder, keyword)
    with open(path, "w", encoding="utf-8") as file:
        file.writelines(row + "\n" for row in lines(keyword, value))
    return path


def with_files(keywords: dict[str, Any], work: Callable[[dict[str, Any]], Result]) -> Result:
    """Does the work with a file for each keyword that was given as rows."""
    rows = {k: v for k, v in keywords.items() if k in ROW_KEYWORDS | {"obstacle"} and not is_path(v)}
    if not rows:
        return work(keywords)
    from tempfile import TemporaryDirectory

    with TemporaryDirectory(prefix="planish-") as folder:
        files = {keyword: write_rows(folder, keyword, value) for keyword, value in rows.items()}
        try:
            result = work({**keywords, **files})
        except errors.Error as error:
            inside = folder + os.sep
            words = str(error).replace(inside, "")
            path = error.place.path and error.place.path.replace(inside, "")
            place = error.place
            raise errors.make(error.code, words, path, place.line, place.byte, place.first, place.count) from None
        if hasattr(result, "notes"):
            result.notes = [note.replace(folder + os.sep, "") for note in result.notes]
        return result


def check_counts(keywords: Mapping[str, Any], count: int) -> None:
    """Refuses sequences that should have an item for each vertex and have not."""
    for keyword in ("fix", "weights"):
        value = keywords.get(keyword)
        if value is None or is_path(value) or isinstance(value, Mapping):
            continue
        items = list(value)
        is_mask = all(isinstance(item, bool) or is_numpy_bool(item) for item in items)
        if (keyword == "weights" or is_mask) and items and len(items) != count:
            raise ValueError(f"{keyword} has {len(items)} items, but the mesh has {count} vertices")


def run(
    work: Callable[[_core.Mesh, dict[str, Any], Any], Result],
    mesh: _core.Mesh,
    keywords: dict[str, Any],
    progress: Optional[Progress] = None,
) -> Result:
    """Runs the work of a verb on a mesh."""
    check_counts(keywords, len(mesh.vertices))
    return with_files(keywords, lambda given: work(mesh, given, progress))


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
        return with_files(keywords, lambda given: _core.flatten_files(title, texts, given, progress))
    meshes = [as_mesh(mesh) for mesh in paths]
    names: Iterable[Any] = patches if isinstance(patches, Mapping) else (mesh.name for mesh in meshes)
    pairs = list(zip(told_apart([str(own) for own in names]), meshes))
    if not pairs:
        raise errors.make("no_triangles", "the product has no patches")
    return with_files(keywords, lambda given: _core.flatten_meshes(name or "product", pairs, given, progress))


def draw(result: Any, format_name: str, path: Optional[Path], as_designed: bool, keywords: dict[str, Any]) -> bytes:
    """The drawing of a pattern, also written where there is a path."""

    def work(given: dict[str, Any]) -> bytes:
        if isinstance(result, _core.FlattenResult):
            return result._drawing(format_name, as_designed, given)
        if isinstance(result, _core.UnfoldResult):
            if as_designed:
                raise ValueError("as_designed goes with a result of flatten only")
            return result._drawing(format_name, given)
        raise TypeError(f"a result of flatten or unfold has a pattern to draw, not one of type {type(result).__name__}")

    content = with_files(keywords, work)
    if path is not None:
        _core.write_bytes(text_of(path), content)
    return content
