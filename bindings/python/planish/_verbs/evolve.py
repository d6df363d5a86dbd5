"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Optional

from .. import _core, _meshes, _run

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .._types import Amount, MeshLike, OwnMethod, Path, Progress, Rows


def evolve(
    mesh: MeshLike,
    faces: Optional[ArrayLike] = None,
    *,
    name: Optional[str] = None,
    progress: Optional[Progress] = None,
    unit: Optional[Literal["mm", "cm", "dm", "m", "in"]] = None,
    scale: Optional[float] = None,
    remesh: Optional[bool] = None,
    smooth_first: Optional[Amount] = None,
    cut: Optional[Rows] = None,
    cut_along: Optional[str] = None,
    smooth_lines: Optional[str] = None,
    avoid: Optional[str] = None,
    keep_small: Optional[bool] = None,
    symmetric: Optional[str] = None,
    mirror_surface: Optional[bool] = None,
    prefer_cuts: Optional[str] = None,
    effort: Optional[int] = None,
    method: Optional[Literal["controllable", "classical", "least_norm", "flattenable_laplacian", "local_offset", "global_penalty", "local_perturbation", "fairing", "auto"] | OwnMethod] = None,
    sweeps: Optional[int] = None,
    target_e_max: Optional[float] = None,
    lambda_min: Optional[float] = None,
    lambda_max: Optional[float] = None,
    min_angle: Optional[Amount] = None,
    max_deviation: Optional[Amount] = None,
    solver: Optional[Literal["model", "trust_region"]] = None,
    lambda_: Optional[float] = None,
    order: Optional[Literal["sequential", "simultaneous"]] = None,
    update: Optional[Literal["direct", "uniform", "cotangent"]] = None,
    switch_e_max: Optional[float] = None,
    switch_after: Optional[int] = None,
    switch_fall: Optional[float] = None,
    damping: Optional[float] = None,
    border_weight: Optional[float] = None,
    max_step: Optional[float] = None,
    min_step: Optional[float] = None,
    fairness: Optional[float] = None,
    position: Optional[float] = None,
    tau: Optional[float] = None,
    rebase_every: Optional[int] = None,
    band: Optional[float] = None,
    enough: Optional[float] = None,
    max_updates: Optional[int] = None,
    step: Optional[Literal["guarded", "published"]] = None,
    max_visits: Optional[int] = None,
    cg_steps: Optional[int] = None,
    tolerance: Optional[float] = None,
    border: Optional[Amount | Literal["fixed", "linked"]] = None,
    rings: Optional[int] = None,
    inner_steps: Optional[int] = None,
    clearance: Optional[Amount] = None,
    pull: Optional[float] = None,
    flow: Optional[Literal["none", "taubin", "implicit", "anisotropic"]] = None,
    mu: Optional[float] = None,
    crease: Optional[Amount] = None,
    max_strain: Optional[Amount] = None,
    material: Optional[Path] = None,
    max_rms_strain: Optional[Amount] = None,
    max_bending: Optional[float] = None,
    prefer: Optional[Literal["smooth", "flat", "near"]] = None,
    closeness: Optional[float] = None,
    fix: Optional[Rows] = None,
    weights: Optional[Rows] = None,
    obstacle: Optional[MeshLike] = None,
    threads: Optional[int] = None,
) -> _core.EvolveResult:
    """Changes a patch by one method towards flattenable; it stays in space. The method may be a function of your own,
        which takes a SweepInput and returns the places of all vertices after a sweep.

    Keywords, as flags of the program:
        unit: what one unit of the mesh is: mm, cm, dm, m or in (default: as its file says, else mm)
        scale: multiply all coordinates when the mesh is read: of a model whose unit is 0.5 m --unit m --scale 0.5
            (default 1)
        remesh: work on fewer vertices, and write these; the border keeps all of its own
        smooth_first: first take waves shorter than this out of the design, as the noise of a scan (at most 20 mean
            edges; such as 5mm)
        cut: cut the surface along lines first: a drawing (.obj, a pattern .svg), a list of vertices, "plane x=0",
            "line 0,0,1 0,2,1", rings, "creases 30deg", uv, groups, open or auto (panels); may be repeated
        cut_along: triangles: a line cuts through them; edges: it follows edges of the mesh (default triangles)
        smooth_lines: take the teeth out of drawn lines, by up to half an edge: yes or no (default yes)
        avoid: places that the cuts of --cut open go round where they can: vertices one a line, an .obj with lines or
            points over the mesh, or an .obj or .ply of the model with these places painted
        keep_small: keep pieces that cuts make with less than 1 % of the area, or 5 % where they are narrower than two
            edges; else each is joined to a neighbour
        symmetric: make left equal right, lines and patterns: auto finds the plane, "x=0" names it, no (default no)
        mirror_surface: with --symmetric: replace one half of the surface by the mirror image of the half that has the
            lines
        prefer_cuts: what a division into panels saves first: few (pieces), short (seams), simple (no slits that end
            inside a piece); default few
        effort: how many divisions are tried (1 to 1000, default 6); more are never worse
        method: controllable, classical, least_norm, flattenable_laplacian, local_offset, global_penalty,
            local_perturbation, fairing or auto (default controllable)
        sweeps: largest number of sweeps (default: what each method usually takes)
        target_e_max: end as soon as e_max is at most this, in radians (at least 0, default 0)
        lambda_min: smallest step along the Laplacian vector; below 0 saddles can improve (-10 to 0, default 0)
        lambda_max: largest step along the Laplacian vector (0 to 10, default 1)
        min_angle: with lambda_min below 0: no triangle gets an angle below this, or below its present one if that is
            smaller, in degrees (5 or 5deg; 0 to 60, default 1); or no triangle gets an angle below this, or below the
            smallest one at first if that is smaller, in degrees (5 or 5deg; 0 to 60, default 0)
        max_deviation: no vertex ends further than this from where it began, in model units (1.5 or 1.5mm; at least 0,
            default no limit)
        solver: how the best step is computed; trust_region is the paper's (model or trust_region, default model)
        lambda_: share of the Laplacian vector that every vertex moves (0 to 1, default 0.5); or of taubin: share of
            the umbrella vector in the smoothing step (0 to 1, default 0.33)
        order: order of the moves in a sweep (sequential or simultaneous, default sequential)
        update: how a step becomes positions until direct steps take over (direct, uniform or cotangent, default
            cotangent)
        switch_e_max: direct steps take over when e_max is below this, in radians (at least 0, default 0.001)
        switch_after: and after this number of faired steps, when one gains too little (at least 0, default 20)
        switch_fall: too little: e_max falls by less than this, in radians (at least 0, default 0.01)
        damping: of faired steps, in units of the matrix's median diagonal; 0: 3e-6 for cotangent, 3e-4 for uniform (0
            to 1000, default 0); or how soft the constraints are at least, in units of the matrix; as small as 1e-9
            they are hard, as printed, and softer where e_max would rise (1e-12 to 1000, default 1e-09)
        border_weight: weight of moves of vertices next to the border; 10 keeps the patch's slant there (0.001 to
            1000, default 1)
        max_step: a direct step moves no vertex by more of its shortest edge (1e-06 to 10, default 0.5)
        min_step: converged when the rms step is below this share of the mean edge length (0 to 1, default 1e-06); or
            converged when the rms step is below this share of the mean edge length (0 to 1, default 1e-05); or
            converged when the rms step is below this share of the mean edge length (0 to 1, default 1e-04)
        fairness: w1: how much edges are to be short and even (0 to 1e+06, default 1)
        position: w2: how much vertices are to stay where they began (1e-09 to 1e+06, default 0.1)
        tau: share of each step that is taken (0.001 to 1, default 0.25); or share of the solved step that is gone (0
            to 1, default 0.1)
        rebase_every: number of steps after which the positions reached become those to stay at; 0: never (at least 0,
            default 0)
        band: no vertex ends further than this from where it began, in model units; 0 for the mean length of the edges
            at inner vertices (at least 0, default 0)
        enough: a defect of at most this is left alone, in radians (at least 0, default 0.01); or e_max at which the
            method is done, in radians (at least 0, default 0.001)
        max_updates: largest number of vertices tried, in all sweeps together (at least 0, default 500000)
        step: which steps count; published: all, as printed, so that energy may rise (guarded or published, default
            guarded)
        max_visits: with published steps: a vertex that was tried this often is left alone, which ends the printed
            loop (at least 1, default 100)
        cg_steps: conjugate-gradient steps between two settings of the penalty (1 to 1000, default 5)
        tolerance: done when a sweep changes the summed squared defects by at most this share of what they were at
            first (0 to 1, default 1e-04)
        border: whether border vertices that came at the same place, as on the two sides of a seam, stay or move
            together; all others stay (fixed or linked, default fixed); or what vertices of the border may do: stay,
            slide along the border as it was, or go as far from where they were as this, in model units (fixed, slide
            or a length such as 1.5 or 1.5mm, default fixed)
        rings: number of rings around a vertex that move at once (1 to 10, default 3)
        inner_steps: steps each time that a vertex is taken (1 to 1000, default 5)
        clearance: distance to keep from the obstacle, in model units (1.5 or 1.5mm; at least 0, default 0)
        pull: how strongly vertices are drawn to where they began; waves longer than 2 pi sizes over the root of this
            stay, a size being the root of the area; 0: not at all (at least 0, default 100)
        flow: what a sweep is: none: one solve to where the surface bends least; else a step of a flow (none, taubin,
            implicit or anisotropic, default none)
        mu: of taubin: the same in the step back, negative (-1 to 0, default -0.34)
        crease: of anisotropic: where normals turn by more than this along a mean edge, in degrees, it is a crease (5
            or 5deg; 0.1 to 180, default 20)
        max_strain: change the form as little as it takes until no edge of a pattern has to stretch by more than this,
            as a share of length (0.02 or 2% for every edge, 2%@p99 for 99 % of the area; 0 to 1, default 0)
        material: instead of --max-strain: what this material takes, steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists the limits
        max_rms_strain: the same by the root mean square of the strain, which a few positions with more do not decide
            (0.02 or 2%; 0 to 1, default 0)
        max_bending: with prefer smooth or flat: largest bending, as a multiple of that of the design; a larger one
            lets the surface stay nearer; 0: as smooth as usual (0 to 1e+06, default 0)
        prefer: what counts most: that the surface stays smooth, becomes flattenable, or stays near (smooth, flat or
            near, default smooth)
        closeness: how much rougher the surface may get for staying close: 0: no rougher than at first, 1: twice as
            rough and 2.5 degrees more (0 to 1e+06, default 1)
        fix: vertices that stay where they are: a list of numbers from 0, or an .obj whose lines and points are
            snapped to the mesh
        weights: weights of moves: on each line a vertex, from 0, and its weight
        obstacle: a closed mesh that must not be entered
        threads: use at most N threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run(_core.evolve, _meshes.as_mesh(mesh, faces, name), given, progress)


def evolve_sweeps(
    mesh: MeshLike,
    faces: Optional[ArrayLike] = None,
    *,
    name: Optional[str] = None,
    unit: Optional[Literal["mm", "cm", "dm", "m", "in"]] = None,
    scale: Optional[float] = None,
    cut: Optional[Rows] = None,
    cut_along: Optional[str] = None,
    smooth_lines: Optional[str] = None,
    avoid: Optional[str] = None,
    keep_small: Optional[bool] = None,
    symmetric: Optional[str] = None,
    mirror_surface: Optional[bool] = None,
    prefer_cuts: Optional[str] = None,
    effort: Optional[int] = None,
    method: Optional[Literal["controllable", "classical", "least_norm", "flattenable_laplacian", "local_offset", "global_penalty", "local_perturbation", "fairing", "auto"] | OwnMethod] = None,
    sweeps: Optional[int] = None,
    target_e_max: Optional[float] = None,
    lambda_min: Optional[float] = None,
    lambda_max: Optional[float] = None,
    min_angle: Optional[Amount] = None,
    max_deviation: Optional[Amount] = None,
    solver: Optional[Literal["model", "trust_region"]] = None,
    lambda_: Optional[float] = None,
    order: Optional[Literal["sequential", "simultaneous"]] = None,
    update: Optional[Literal["direct", "uniform", "cotangent"]] = None,
    switch_e_max: Optional[float] = None,
    switch_after: Optional[int] = None,
    switch_fall: Optional[float] = None,
    damping: Optional[float] = None,
    border_weight: Optional[float] = None,
    max_step: Optional[float] = None,
    min_step: Optional[float] = None,
    fairness: Optional[float] = None,
    position: Optional[float] = None,
    tau: Optional[float] = None,
    rebase_every: Optional[int] = None,
    band: Optional[float] = None,
    enough: Optional[float] = None,
    max_updates: Optional[int] = None,
    step: Optional[Literal["guarded", "published"]] = None,
    max_visits: Optional[int] = None,
    cg_steps: Optional[int] = None,
    tolerance: Optional[float] = None,
    border: Optional[Amount | Literal["fixed", "linked"]] = None,
    rings: Optional[int] = None,
    inner_steps: Optional[int] = None,
    clearance: Optional[Amount] = None,
    pull: Optional[float] = None,
    flow: Optional[Literal["none", "taubin", "implicit", "anisotropic"]] = None,
    mu: Optional[float] = None,
    crease: Optional[Amount] = None,
    max_strain: Optional[Amount] = None,
    material: Optional[Path] = None,
    max_rms_strain: Optional[Amount] = None,
    max_bending: Optional[float] = None,
    prefer: Optional[Literal["smooth", "flat", "near"]] = None,
    closeness: Optional[float] = None,
    fix: Optional[Rows] = None,
    weights: Optional[Rows] = None,
    obstacle: Optional[MeshLike] = None,
    threads: Optional[int] = None,
) -> _core.Sweeps:
    """The same as an iterator: a Sweep after each sweep, until evolve() would end.

    Keywords, as flags of the program:
        unit: what one unit of the mesh is: mm, cm, dm, m or in (default: as its file says, else mm)
        scale: multiply all coordinates when the mesh is read: of a model whose unit is 0.5 m --unit m --scale 0.5
            (default 1)
        cut: cut the surface along lines first: a drawing (.obj, a pattern .svg), a list of vertices, "plane x=0",
            "line 0,0,1 0,2,1", rings, "creases 30deg", uv, groups, open or auto (panels); may be repeated
        cut_along: triangles: a line cuts through them; edges: it follows edges of the mesh (default triangles)
        smooth_lines: take the teeth out of drawn lines, by up to half an edge: yes or no (default yes)
        avoid: places that the cuts of --cut open go round where they can: vertices one a line, an .obj with lines or
            points over the mesh, or an .obj or .ply of the model with these places painted
        keep_small: keep pieces that cuts make with less than 1 % of the area, or 5 % where they are narrower than two
            edges; else each is joined to a neighbour
        symmetric: make left equal right, lines and patterns: auto finds the plane, "x=0" names it, no (default no)
        mirror_surface: with --symmetric: replace one half of the surface by the mirror image of the half that has the
            lines
        prefer_cuts: what a division into panels saves first: few (pieces), short (seams), simple (no slits that end
            inside a piece); default few
        effort: how many divisions are tried (1 to 1000, default 6); more are never worse
        method: controllable, classical, least_norm, flattenable_laplacian, local_offset, global_penalty,
            local_perturbation, fairing or auto (default controllable)
        sweeps: largest number of sweeps (default: what each method usually takes)
        target_e_max: end as soon as e_max is at most this, in radians (at least 0, default 0)
        lambda_min: smallest step along the Laplacian vector; below 0 saddles can improve (-10 to 0, default 0)
        lambda_max: largest step along the Laplacian vector (0 to 10, default 1)
        min_angle: with lambda_min below 0: no triangle gets an angle below this, or below its present one if that is
            smaller, in degrees (5 or 5deg; 0 to 60, default 1); or no triangle gets an angle below this, or below the
            smallest one at first if that is smaller, in degrees (5 or 5deg; 0 to 60, default 0)
        max_deviation: no vertex ends further than this from where it began, in model units (1.5 or 1.5mm; at least 0,
            default no limit)
        solver: how the best step is computed; trust_region is the paper's (model or trust_region, default model)
        lambda_: share of the Laplacian vector that every vertex moves (0 to 1, default 0.5); or of taubin: share of
            the umbrella vector in the smoothing step (0 to 1, default 0.33)
        order: order of the moves in a sweep (sequential or simultaneous, default sequential)
        update: how a step becomes positions until direct steps take over (direct, uniform or cotangent, default
            cotangent)
        switch_e_max: direct steps take over when e_max is below this, in radians (at least 0, default 0.001)
        switch_after: and after this number of faired steps, when one gains too little (at least 0, default 20)
        switch_fall: too little: e_max falls by less than this, in radians (at least 0, default 0.01)
        damping: of faired steps, in units of the matrix's median diagonal; 0: 3e-6 for cotangent, 3e-4 for uniform (0
            to 1000, default 0); or how soft the constraints are at least, in units of the matrix; as small as 1e-9
            they are hard, as printed, and softer where e_max would rise (1e-12 to 1000, default 1e-09)
        border_weight: weight of moves of vertices next to the border; 10 keeps the patch's slant there (0.001 to
            1000, default 1)
        max_step: a direct step moves no vertex by more of its shortest edge (1e-06 to 10, default 0.5)
        min_step: converged when the rms step is below this share of the mean edge length (0 to 1, default 1e-06); or
            converged when the rms step is below this share of the mean edge length (0 to 1, default 1e-05); or
            converged when the rms step is below this share of the mean edge length (0 to 1, default 1e-04)
        fairness: w1: how much edges are to be short and even (0 to 1e+06, default 1)
        position: w2: how much vertices are to stay where they began (1e-09 to 1e+06, default 0.1)
        tau: share of each step that is taken (0.001 to 1, default 0.25); or share of the solved step that is gone (0
            to 1, default 0.1)
        rebase_every: number of steps after which the positions reached become those to stay at; 0: never (at least 0,
            default 0)
        band: no vertex ends further than this from where it began, in model units; 0 for the mean length of the edges
            at inner vertices (at least 0, default 0)
        enough: a defect of at most this is left alone, in radians (at least 0, default 0.01); or e_max at which the
            method is done, in radians (at least 0, default 0.001)
        max_updates: largest number of vertices tried, in all sweeps together (at least 0, default 500000)
        step: which steps count; published: all, as printed, so that energy may rise (guarded or published, default
            guarded)
        max_visits: with published steps: a vertex that was tried this often is left alone, which ends the printed
            loop (at least 1, default 100)
        cg_steps: conjugate-gradient steps between two settings of the penalty (1 to 1000, default 5)
        tolerance: done when a sweep changes the summed squared defects by at most this share of what they were at
            first (0 to 1, default 1e-04)
        border: whether border vertices that came at the same place, as on the two sides of a seam, stay or move
            together; all others stay (fixed or linked, default fixed); or what vertices of the border may do: stay,
            slide along the border as it was, or go as far from where they were as this, in model units (fixed, slide
            or a length such as 1.5 or 1.5mm, default fixed)
        rings: number of rings around a vertex that move at once (1 to 10, default 3)
        inner_steps: steps each time that a vertex is taken (1 to 1000, default 5)
        clearance: distance to keep from the obstacle, in model units (1.5 or 1.5mm; at least 0, default 0)
        pull: how strongly vertices are drawn to where they began; waves longer than 2 pi sizes over the root of this
            stay, a size being the root of the area; 0: not at all (at least 0, default 100)
        flow: what a sweep is: none: one solve to where the surface bends least; else a step of a flow (none, taubin,
            implicit or anisotropic, default none)
        mu: of taubin: the same in the step back, negative (-1 to 0, default -0.34)
        crease: of anisotropic: where normals turn by more than this along a mean edge, in degrees, it is a crease (5
            or 5deg; 0.1 to 180, default 20)
        max_strain: change the form as little as it takes until no edge of a pattern has to stretch by more than this,
            as a share of length (0.02 or 2% for every edge, 2%@p99 for 99 % of the area; 0 to 1, default 0)
        material: instead of --max-strain: what this material takes, steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists the limits
        max_rms_strain: the same by the root mean square of the strain, which a few positions with more do not decide
            (0.02 or 2%; 0 to 1, default 0)
        max_bending: with prefer smooth or flat: largest bending, as a multiple of that of the design; a larger one
            lets the surface stay nearer; 0: as smooth as usual (0 to 1e+06, default 0)
        prefer: what counts most: that the surface stays smooth, becomes flattenable, or stays near (smooth, flat or
            near, default smooth)
        closeness: how much rougher the surface may get for staying close: 0: no rougher than at first, 1: twice as
            rough and 2.5 degrees more (0 to 1e+06, default 1)
        fix: vertices that stay where they are: a list of numbers from 0, or an .obj whose lines and points are
            snapped to the mesh
        weights: weights of moves: on each line a vertex, from 0, and its weight
        obstacle: a closed mesh that must not be entered
        threads: use at most N threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run(_core.sweeps, _meshes.as_mesh(mesh, faces, name), given)
