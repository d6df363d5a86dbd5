"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Optional, Sequence

from .. import _core, _meshes, _run

if TYPE_CHECKING:
    from .._types import Amount, Path


def read(
    path: Path,
    *,
    unit: Optional[Literal["mm", "cm", "dm", "m", "in"]] = None,
    divide: Optional[Literal["objects", "materials", "parts"]] = None,
    only: Optional[str | Sequence[str]] = None,
    without: Optional[str | Sequence[str]] = None,
    weld: Optional[Amount | bool] = None,
    fill_holes: Optional[Amount] = None,
    side: Optional[Literal["outer", "inner"]] = None,
    flip: Optional[bool] = None,
    strict: Optional[bool] = None,
) -> _core.Mesh:
    """Reads an OBJ, PLY, STL or OFF file. What is done to its mesh is in its notes; its groups are its pieces.

    Keywords, as flags of the program:
        unit: unit of the mesh's coordinates: mm, cm, dm, m or in (default: as the file says, else mm)
        divide: what makes a piece: objects (or groups, if the file has no objects), materials, or parts, which are
            not connected to each other (default objects)
        only: take only these objects, groups, materials or pieces: names, separated by commas
        without: leave out these objects, groups, materials or pieces: names, separated by commas
        weld: join borders that lie within LENGTH of each other (1.5 or 1.5mm; default: a length that fits the size of
            the mesh)
        fill_holes: close holes whose border is at most LENGTH long (1.5 or 1.5mm)
        side: of a wall with a thickness, take one side: outer or inner
        flip: turn the surface over: its inner side becomes the outer one
        strict: take the mesh as it is; repair and leave out only what other flags ask for
    """
    given = _run.keywords_of(locals())
    return _core.read(_meshes.text_of(path), given)
