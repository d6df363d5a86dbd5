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
        unit: what one unit of the mesh is: mm, cm, dm, m or in (default: as its file says, else mm)
        scale: multiply all coordinates when the mesh is read: of a model whose unit is 0.5 m --unit m --scale 0.5
            (default 1)
        max_strain: how much an edge of the pattern may be longer or shorter than on the patch (0.02 or 2%); 2%@p99:
            on 99 % of the area
        material: instead of --max-strain: what this material takes, steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists the limits
        max_rms_strain: the same for the root mean square of the strain (0.02 or 2%)
        prefer_cuts: what a division into panels saves first: few (pieces), short (seams), simple (no slits that end
            inside a piece); default few
        effort: how many divisions are tried (1 to 1000, default 6); more are never worse
        symmetric: make left equal right: auto where the product is symmetric, "x=0" names the plane, no (default
            auto)
        seams: lines that must be seams, in the words of --cut: a drawing (.obj), "plane x=0", "creases 30deg", ...;
            others join them; may be repeated
        match_seams: keep the limit with both sides of each seam equally long, as the pieces of flatten --cut auto do
        threads: use at most N threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run(_core.suggest_panels, _meshes.as_mesh(mesh, faces, name), given, progress)
