"""Meshes from and to other packages and files."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, Optional

from . import _core, errors

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from ._types import MeshLike, Path


def text_of(path: Path) -> str:
    """A path as the module takes it; labels and reports hold the name, so it has to be text."""
    text = os.fsdecode(path)
    try:
        text.encode()
    except UnicodeEncodeError:
        raise errors.make("file_unreadable", f"the name {text!r} is not UTF-8 text: rename the file") from None
    return text


def write(path: Path, mesh: MeshLike, faces: Optional[ArrayLike] = None) -> None:
    """Writes a mesh as .obj, .ply, .stl or .off, whole or not at all."""
    _core.write(text_of(path), as_mesh(mesh, faces))


def triangles_of_cells(cells: Any) -> Any:
    """The triangles of a mesh of meshio, which must have no other faces."""
    others = sorted(set(cells) - {"triangle", "line", "vertex"})
    if others:
        raise ValueError(f"the mesh has cells of type {', '.join(others)}: divide them into triangles")
    if "triangle" not in cells:
        raise ValueError("the mesh has no triangles")
    return cells["triangle"]


def faces_of(mesh: Any) -> Any:
    """(vertices, faces) of a mesh of another package, or None."""
    if hasattr(mesh, "vertices") and hasattr(mesh, "faces"):
        return mesh.vertices, mesh.faces
    if hasattr(mesh, "points") and hasattr(mesh, "cells_dict") and not hasattr(mesh, "regular_faces"):
        return mesh.points, triangles_of_cells(mesh.cells_dict)
    if hasattr(mesh, "points") and hasattr(mesh, "regular_faces"):
        return mesh.points, mesh.regular_faces
    return None


def as_mesh(mesh: MeshLike, faces: Optional[ArrayLike] = None, name: Optional[str] = None) -> _core.Mesh:
    """The mesh that was given: arrays, a pair of them, a path, or a mesh of this or another package."""
    if faces is None and isinstance(mesh, (str, os.PathLike)):
        mesh = _core.read(text_of(mesh), {})
    if faces is None and isinstance(mesh, _core.Mesh):
        return mesh if name is None else mesh.renamed(name)
    if faces is not None:
        pair: Any = mesh, faces
    elif isinstance(mesh, tuple) and len(mesh) == 2:
        pair = mesh
    else:
        pair = faces_of(mesh)
    if pair is None:
        raise TypeError(
            "a mesh is two arrays (vertices, faces), a path, or has .vertices and .faces or .points and .cells_dict; "
            f"this is of type {type(mesh).__name__}"
        )
    return _core.Mesh(pair[0], pair[1], name or "mesh")


def shown_points(mesh: Any, flat: bool) -> Any:
    """Places of the patch, or of its pattern in the plane z = 0."""
    if not flat:
        return mesh.vertices
    if getattr(mesh, "uv", None) is None:
        raise ValueError("there is no pattern: flatten or unfold the mesh first")
    import numpy

    return numpy.pad(mesh.uv, ((0, 0), (0, 1)))


def to_trimesh(self: Any, flat: bool = False) -> Any:
    """A trimesh.Trimesh with the same vertices and triangles; with flat=True of the pattern."""
    import trimesh

    return trimesh.Trimesh(vertices=shown_points(self, flat), faces=self.faces, process=False)


def to_pyvista(self: Any, flat: bool = False) -> Any:
    """A pyvista.PolyData with the same vertices and triangles; with flat=True of the pattern."""
    import numpy
    import pyvista

    faces = numpy.insert(numpy.asarray(self.faces, dtype=numpy.int64), 0, 3, axis=1)
    return pyvista.PolyData(numpy.array(shown_points(self, flat)), faces.ravel())


def to_meshio(self: Any, flat: bool = False) -> Any:
    """A meshio.Mesh with the same vertices and triangles; with flat=True of the pattern."""
    import meshio
    import numpy

    faces = numpy.asarray(self.faces, dtype=numpy.int64)
    return meshio.Mesh(numpy.array(shown_points(self, flat)), [("triangle", faces)])
