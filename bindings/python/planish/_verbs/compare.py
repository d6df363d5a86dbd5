"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Mapping, Optional, Sequence

from .. import _core, _meshes, _run

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .._types import MeshLike, OwnMethod, Progress, Rows


def compare(
    mesh: MeshLike,
    faces: Optional[ArrayLike] = None,
    *,
    name: Optional[str] = None,
    own: Optional[Mapping[str, OwnMethod | MeshLike]] = None,
    progress: Optional[Progress] = None,
    unit: Optional[Literal["mm", "cm", "dm", "m", "in"]] = None,
    scale: Optional[float] = None,
    methods: Optional[str | Sequence[str]] = None,
    sweeps: Optional[int] = None,
    target_e_max: Optional[float] = None,
    fix: Optional[Rows] = None,
    weights: Optional[Rows] = None,
    obstacle: Optional[MeshLike] = None,
    threads: Optional[int] = None,
) -> _core.CompareResult:
    """Tries several methods on a patch, one after the other. In own, by name, are functions that make a sweep and
        results of others (meshes with the same triangles, or their vertices), which take part like methods.

    Keywords, as flags of the program:
        unit: unit of the mesh's coordinates: mm, cm, dm, m or in (default: as the file says, else mm)
        scale: multiply all coordinates by this when the mesh is read; for a unit of 0.5 m: --unit m --scale 0.5
            (default 1)
        methods: methods to run, separated by commas: controllable, classical, least_norm, flattenable_laplacian,
            local_offset, global_penalty, local_perturbation, fairing or auto; with --with also none (default: all)
        sweeps: largest number of sweeps (default: the method's own)
        target_e_max: end as soon as e_max is at most this, in radians (at least 0, default 0)
        fix: vertices that stay where they are: a list of numbers from 0, or an .obj whose lines and points are moved
            to the nearest vertices
        weights: weights of vertices against moving, one a line: number of the vertex, from 0, and its weight
        obstacle: a closed mesh that the surface must not enter
        threads: largest number of threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run_compare(_meshes.as_mesh(mesh, faces, name), own, given, progress)
