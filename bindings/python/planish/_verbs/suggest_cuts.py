"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Optional

from .. import _core, _meshes, _run

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .._types import Amount, MeshLike, Path, Progress


def suggest_cuts(
    mesh: MeshLike,
    faces: Optional[ArrayLike] = None,
    *,
    name: Optional[str] = None,
    progress: Optional[Progress] = None,
    unit: Optional[Literal["mm", "cm", "dm", "m", "in"]] = None,
    scale: Optional[float] = None,
    max_strain: Optional[Amount] = None,
    material: Optional[Path] = None,
    max_cuts: Optional[int] = None,
    threads: Optional[int] = None,
) -> _core.CutResult:
    """Looks for short cuts that let a mesh lie flat.

    Keywords, as flags of the program:
        unit: unit of the mesh's coordinates: mm, cm, dm, m or in (default: as the file says, else mm)
        scale: multiply all coordinates by this when the mesh is read; for a unit of 0.5 m: --unit m --scale 0.5
            (default 1)
        max_strain: limit of the largest strain of an edge (0.02 or 2%, default 2%); 2%@p99: on 99 % of the area
        material: use the limit of a material instead of --max-strain: steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists their limits
        max_cuts: largest number of darts (0 to 50, default 6)
        threads: largest number of threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run(_core.suggest_cuts, _meshes.as_mesh(mesh, faces, name), given, progress)
