"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Optional, Sequence

from .. import _core, _meshes, _run

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .._types import Amount, MeshLike, Path, Progress


def suggest_panels(
    mesh: MeshLike,
    faces: Optional[ArrayLike] = None,
    *,
    name: Optional[str] = None,
    progress: Optional[Progress] = None,
    unit: Optional[Literal["mm", "cm", "dm", "m", "in"]] = None,
    scale: Optional[float] = None,
    max_strain: Optional[Amount] = None,
    material: Optional[Path] = None,
    max_rms_strain: Optional[Amount] = None,
    prefer_cuts: Optional[str] = None,
    effort: Optional[int] = None,
    symmetric: Optional[str] = None,
    seams: Optional[str | Sequence[str]] = None,
    match_seams: Optional[bool] = None,
    threads: Optional[int] = None,
) -> _core.PanelsResult:
    """Divides a whole product, closed or open, into few panels with short seams.

    Keywords, as flags of the program:
        unit: unit of the mesh's coordinates: mm, cm, dm, m or in (default: as the file says, else mm)
        scale: multiply all coordinates by this when the mesh is read; for a unit of 0.5 m: --unit m --scale 0.5
            (default 1)
        max_strain: largest change of an edge's length from the patch to the pattern (0.02 or 2%); 2%@p99: on 99 % of
            the area
        material: use the limit of a material instead of --max-strain: steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists their limits
        max_rms_strain: largest root mean square of the strain (0.02 or 2%)
        prefer_cuts: what a division into panels must have before all else: few pieces (few), short seams (short), or
            no slits that end inside a piece (simple); default few
        effort: number of divisions to try (1 to 1000, default 6); a larger number never gives a worse result
        symmetric: make left equal right: auto does so if the product is symmetric, "x=0" names the plane, no (default
            auto)
        seams: lines that must be seams, written as for --cut: a drawing (.obj), "plane x=0", "creases 30deg", ...;
            other seams join them; may be repeated
        match_seams: keep the limit even with both sides of each seam equally long, as flatten --cut auto makes them
        threads: largest number of threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run(_core.suggest_panels, _meshes.as_mesh(mesh, faces, name), given, progress)
