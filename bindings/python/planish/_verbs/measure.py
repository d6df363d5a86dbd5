"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Optional

from .. import _core, _meshes, _run

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .._types import Amount, MeshLike, Path, Progress


def measure(
    mesh: MeshLike,
    faces: Optional[ArrayLike] = None,
    *,
    name: Optional[str] = None,
    progress: Optional[Progress] = None,
    scale: Optional[float] = None,
    max_strain: Optional[Amount] = None,
    material: Optional[Path] = None,
    max_rms_strain: Optional[Amount] = None,
    threads: Optional[int] = None,
) -> _core.MeasureResult:
    """Measures how far a patch is from flat, and what strain its pattern needs as it is.

    Keywords, as flags of the program:
        scale: multiply all coordinates by this when the mesh is read; for a unit of 0.5 m: --unit m --scale 0.5
            (default 1)
        max_strain: largest change of an edge's length from the patch to the pattern (0.02 or 2%); 2%@p99: on 99 % of
            the area
        material: use the limit of a material instead of --max-strain: steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists their limits
        max_rms_strain: largest root mean square of the strain (0.02 or 2%)
        threads: largest number of threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run(_core.measure, _meshes.as_mesh(mesh, faces, name), given, progress)
