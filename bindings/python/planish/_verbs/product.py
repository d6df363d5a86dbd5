"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, Literal, Mapping, Optional, Sequence

from .. import _core, _run

if TYPE_CHECKING:
    from .._types import Amount, MeshLike, Path, Progress, Rows


def flatten_product(
    patches: Path | Sequence[Path | MeshLike] | Mapping[str, MeshLike],
    *,
    name: Optional[str] = None,
    progress: Optional[Progress] = None,
    unit: Optional[Literal["mm", "cm", "dm", "m", "in"]] = None,
    scale: Optional[float] = None,
    remesh: Optional[bool] = None,
    smooth_first: Optional[Amount] = None,
    match_seams: Optional[bool] = None,
    no_match_seams: Optional[bool] = None,
    least_stretch: Optional[bool] = None,
    pick: Optional[int] = None,
    formats: Optional[str | Sequence[str]] = None,
    colors: Optional[Literal["diverging", "paper"]] = None,
    textured: Optional[bool] = None,
    no_report: Optional[bool] = None,
    paper: Optional[str] = None,
    page_overlap: Optional[Amount] = None,
    for_: Optional[Literal["laser", "knife", "plotter", "projector", "apparel"]] = None,
    map: Optional[bool] = None,
    only_layers: Optional[str | Sequence[str]] = None,
    text: Optional[Literal["letters", "strokes"]] = None,
    svg_groups: Optional[Literal["layers", "pieces"]] = None,
    dxf_profile: Optional[Literal["generic", "aama", "astm", "clo", "lectra", "optitex", "gerber"]] = None,
    dxf_version: Optional[Literal["r12", "r2000"]] = None,
    dxf_notches: Optional[Literal["points", "strokes"]] = None,
    dxf_layers: Optional[str] = None,
    piece: Optional[str | Sequence[str]] = None,
    seam_tolerance: Optional[Amount] = None,
    avoid: Optional[str] = None,
    symmetric: Optional[str] = None,
    mirror_surface: Optional[bool] = None,
    prefer_cuts: Optional[str] = None,
    effort: Optional[int] = None,
    divide: Optional[Literal["objects", "materials", "parts"]] = None,
    only: Optional[str | Sequence[str]] = None,
    without: Optional[str | Sequence[str]] = None,
    weld: Optional[Amount | bool] = None,
    fill_holes: Optional[Amount] = None,
    side: Optional[Literal["outer", "inner"]] = None,
    flip: Optional[bool] = None,
    strict: Optional[bool] = None,
    allowance: Optional[Amount] = None,
    corners: Optional[Literal["mitre", "square", "round"]] = None,
    hole_allowance: Optional[str] = None,
    kerf: Optional[Amount] = None,
    open_folds: Optional[bool] = None,
    seam_notches: Optional[Rows] = None,
    notch_depth: Optional[Amount] = None,
    grain: Optional[str | float | Sequence[float]] = None,
    size: Optional[str] = None,
    quantity: Optional[int] = None,
    mirrored: Optional[int] = None,
    fabric: Optional[str] = None,
    note: Optional[str] = None,
    date: Optional[str] = None,
    edge_lengths: Optional[bool] = None,
    sheet_unit: Optional[Literal["mm", "in"]] = None,
    curve_tolerance: Optional[Amount] = None,
    method: Optional[Literal["controllable", "classical", "least_norm", "flattenable_laplacian", "local_offset", "global_penalty", "local_perturbation", "fairing", "auto"]] = None,
    sweeps: Optional[int] = None,
    target_e_max: Optional[float] = None,
    max_strain: Optional[Amount] = None,
    material: Optional[Path] = None,
    max_rms_strain: Optional[Amount] = None,
    max_deviation: Optional[Amount] = None,
    min_angle: Optional[Amount] = None,
    max_bending: Optional[float] = None,
    prefer: Optional[Literal["smooth", "flat", "near"]] = None,
    closeness: Optional[float] = None,
    border: Optional[Amount | Literal["fixed", "linked"]] = None,
    lambda_min: Optional[float] = None,
    lambda_max: Optional[float] = None,
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
    rings: Optional[int] = None,
    inner_steps: Optional[int] = None,
    clearance: Optional[Amount] = None,
    pull: Optional[float] = None,
    flow: Optional[Literal["none", "taubin", "implicit", "anisotropic"]] = None,
    mu: Optional[float] = None,
    crease: Optional[Amount] = None,
    threads: Optional[int] = None,
) -> _core.ProductResult:
    """Flattens the patches of a product together: mesh files or one product file, which are divided into patches as the
        program does, or meshes, each one patch, by their names.

    Keywords, as flags of the program:
        unit: unit of the mesh's coordinates: mm, cm, dm, m or in (default: as the file says, else mm)
        scale: multiply all coordinates by this when the mesh is read; for a unit of 0.5 m: --unit m --scale 0.5
            (default 1)
        remesh: work on a mesh with fewer vertices, and write that mesh; all border vertices stay
        smooth_first: smooth the design first: takes out waves shorter than this, such as the noise of a scan (at most
            20 mean edge lengths; as 5mm)
        match_seams: keep the length of every border edge, or in a product of every edge along a seam, so that sewn
            sides stay equally long
        no_match_seams: allow the two sides of a product's seams to differ in length (default: equal to 0.1 mm)
        least_stretch: write the pattern of least rms strain; without this flag the rms strain may be up to 6 %
            higher, to make the largest strains as small as possible
        pick: how much strain to leave: 1 as designed, 2, 3, 4, 5 at most 2, 1, 0.5, 0.1 % rms, 6 flat
        formats: file formats of the pattern: any of svg, dxf, pdf and plt (default svg,dxf,pdf)
        colors: colours of the report's pictures: diverging or paper (default diverging)
        textured: also write the processed patch as textured.obj, with the pattern in millimetres as texture
            coordinates
        no_report: do not write the page of the report, and do not compute the table of ways to less stretch
        paper: also write the pattern as a .pdf of pages to join: a4, a3, a2, a1, a0, b4, b3, b2, b1, b0, letter,
            legal or tabloid, or any size as 36inx48in
        page_overlap: overlap of neighbouring pages of --paper (default 10mm)
        for_: what the files are for: laser, knife, plotter, projector or apparel; sets formats, layers and more,
            which your other flags can change
        map: draw the strain map and its legend in .svg, .pdf and on the pages of --paper
        only_layers: write only these layers, as cut,notch: any of strain, seam, notch, grain, fold, drill, internal,
            annotation, label, legend, hole or cut
        text: letters, or strokes for machines that have no letters (default letters)
        svg_groups: what the groups of the .svg are: layers, or pieces with their layers inside (default layers)
        dxf_profile: program that reads the .dxf: generic, aama, astm, clo, lectra, optitex or gerber (default
            generic)
        dxf_version: version of the .dxf: r12, which nearly every program reads, or r2000, with arcs and splines
            (default r12)
        dxf_notches: notches in a .dxf for apparel programs: points, or strokes for cutters that ignore points
            (default points)
        dxf_layers: other names in the .dxf for the layers strain, seam, notch, grain, fold, drill, internal,
            annotation, label, legend, hole or cut
        piece: a setting of one piece, which replaces the flag there, as front:allowance=12mm; keys: allowance,
            corners, hole-allowance, kerf, edge-allowances, fold, open-folds, notches, notch-depth, grain, marks,
            inner-lines, size, quantity, mirrored, fabric, note, darts, turn, material, name or out, allowance.N,
            hem.N or ends.N for edge N, and edge.N for its name; the value none leaves the flag out
        seam_tolerance: largest distance between borders that are one seam, as 0.5mm (default: a tenth of an edge's
            length)
        avoid: places that --cut open avoids if it can: one vertex a line, an .obj with lines or points on the mesh,
            or an .obj or .ply of the model with these places painted
        symmetric: make left equal right, in lines and patterns: auto finds the plane, "x=0" names it, no (default no)
        mirror_surface: with --symmetric: replace one half of the surface by the mirror image of the other; the half
            that has the lines stays
        prefer_cuts: what a division into panels must have before all else: few pieces (few), short seams (short), or
            no slits that end inside a piece (simple); default few
        effort: number of divisions to try (1 to 1000, default 6); a larger number never gives a worse result
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
        allowance: width of the seam allowance, as 10mm
        corners: corners of the allowance: mitre, square or round (default mitre)
        hole_allowance: give holes the allowance too, inwards: yes or no (default yes)
        kerf: width that the machine cuts away, as 0.2mm; cut lines move by half of it, outwards, and into holes
            (default 0)
        open_folds: draw the whole piece on both sides of its fold, not its half
        seam_notches: notches on both sides of seams, one a line: number of the seam, or * for all; place as 50% or
            120mm; slit, v or t; double; or an .obj drawn on the model
        notch_depth: depth of notches (default 5mm, or half the allowance if that is less)
        grain: grain: a direction on the model, or an angle in the pattern
        size: size that the piece is for
        quantity: number of pieces to cut
        mirrored: number of pieces of --quantity to cut as mirror images
        fabric: material to cut the piece from
        note: any other text, as "one mirrored" or "cut on fold"
        date: date to write on the sheet, printed as you give it (default none)
        edge_lengths: write the length of each edge, from corner to corner, beside it; flatten also writes edge-
            lengths.csv
        sheet_unit: unit of the lengths on sheets, of the .dxf and of edge-lengths.csv: mm or in (default mm)
        curve_tolerance: largest distance between the drawn curves and the border of the mesh (default 0.1mm; 0:
            straight lines from vertex to vertex)
        method: controllable, classical, least_norm, flattenable_laplacian, local_offset, global_penalty,
            local_perturbation, fairing or auto (default auto)
        sweeps: largest number of sweeps (default: the method's own)
        target_e_max: end as soon as e_max is at most this, in radians (at least 0, default 0)
        max_strain: largest strain that an edge of the pattern may have, as a fraction of its length; the form changes
            only as much as this needs (0.02 or 2% for every edge, 2%@p99 for 99 % of the area; 0 to 1, default 0)
        material: use the limit of a material instead of --max-strain: steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists their limits
        max_rms_strain: largest root mean square of the strain, as a fraction of length; a few places with more strain
            do not decide it (0.02 or 2%; 0 to 1, default 0)
        max_deviation: farthest that a vertex may end from its position in the design, in model units (1.5 or 1.5mm;
            at least 0, default no limit)
        min_angle: no triangle gets an angle below this, or below the smallest angle of the design if that is smaller,
            in degrees (5 or 5deg; 0 to 60, default 0); or with lambda_min below 0: no triangle gets an angle below
            this, or below its own angle before the step if that is smaller, in degrees (5 or 5deg; 0 to 60, default
            1)
        max_bending: with prefer smooth or flat: largest bending, as a multiple of the design's; a larger value keeps
            the surface nearer to the design; 0: as smooth as usual (0 to 1e+06, default 0)
        prefer: what matters most: a smooth surface, a flattenable surface, or a surface near to the design (smooth,
            flat or near, default smooth)
        closeness: how much roughness to accept for a surface nearer to the design; 0: no rougher than the design, 1:
            twice as rough and 2.5 degrees more (0 to 1e+06, default 1)
        border: what border vertices may do: stay, slide along the border of the design, or move by at most a distance
            in model units (fixed, slide or a length such as 1.5 or 1.5mm, default fixed); or whether border vertices
            at the same place, as on the two sides of a seam, stay or move together; all other border vertices stay
            (fixed or linked, default fixed)
        lambda_min: smallest step along the Laplacian vector; a value below 0 lets saddles improve (-10 to 0, default
            0)
        lambda_max: largest step along the Laplacian vector (0 to 10, default 1)
        solver: how the best step is computed; trust_region is the solver that the paper names (model or trust_region,
            default model)
        lambda_: fraction of the Laplacian vector that every vertex moves (0 to 1, default 0.5); or with flow taubin:
            fraction of the umbrella vector in the smoothing step (0 to 1, default 0.33)
        order: order in which a sweep moves the vertices (sequential or simultaneous, default sequential)
        update: how a step gives new positions, until direct steps begin (direct, uniform or cotangent, default
            cotangent)
        switch_e_max: direct steps begin when e_max is below this, in radians (at least 0, default 0.001)
        switch_after: direct steps also begin after this number of faired steps, once a faired step gains too little
            (at least 0, default 20)
        switch_fall: a faired step gains too little if e_max falls by less than this, in radians (at least 0, default
            0.01)
        damping: damping of faired steps, relative to the median of the matrix's diagonal; 0 means 3e-6 for cotangent,
            3e-4 for uniform (0 to 1000, default 0); or least softness of the constraints, relative to the matrix;
            1e-9 makes them hard, as printed in the paper; they get softer where e_max would rise (1e-12 to 1000,
            default 1e-09)
        border_weight: weight of the moves of vertices next to the border; 10 keeps the slant of the surface there
            (0.001 to 1000, default 1)
        max_step: largest move of a vertex in a direct step, as a multiple of its shortest edge (1e-06 to 10, default
            0.5)
        min_step: converged when the rms step is below this fraction of the mean edge length (0 to 1, default 1e-06);
            or converged when the rms step is below this fraction of the mean edge length (0 to 1, default 1e-05); or
            converged when the rms step is below this fraction of the mean edge length (0 to 1, default 1e-04)
        fairness: w1, the weight of short and even edges (0 to 1e+06, default 1)
        position: w2, the weight of staying at the first positions (1e-09 to 1e+06, default 0.1)
        tau: fraction of each step that is taken (0.001 to 1, default 0.25); or fraction of each step that is taken (0
            to 1, default 0.1)
        rebase_every: after this number of steps the present positions become those to stay near; 0: never (at least
            0, default 0)
        band: farthest that a vertex may end from its position in the design, in model units; 0 means the mean length
            of the edges at inner vertices (at least 0, default 0)
        enough: defects of at most this are left as they are, in radians (at least 0, default 0.01); or done when
            e_max is at most this, in radians (at least 0, default 0.001)
        max_updates: largest number of vertices tried, over all sweeps (at least 0, default 500000)
        step: which steps count: guarded: those that lower the energy; published: all, as printed, so that energy may
            rise (guarded or published, default guarded)
        max_visits: with published steps: largest number of visits of a vertex, which ends the printed loop (at least
            1, default 100)
        cg_steps: conjugate-gradient steps before the penalty grows (1 to 1000, default 5)
        tolerance: done when a sweep changes the sum of squared defects by at most this fraction of its first value (0
            to 1, default 1e-04)
        rings: number of rings around a vertex that move together (1 to 10, default 3)
        inner_steps: steps for each visit of a vertex (1 to 1000, default 5)
        clearance: distance to keep from the obstacle, in model units (1.5 or 1.5mm; at least 0, default 0)
        pull: how strongly vertices are pulled to their first positions; waves longer than 2 pi sqrt(area / pull)
            stay, shorter ones go; 0: no pull (at least 0, default 100)
        flow: what a sweep does: none: one solve for the surface that bends least; else one step of a flow (none,
            taubin, implicit or anisotropic, default none)
        mu: with flow taubin: fraction of the umbrella vector in the step back, below 0 (-1 to 0, default -0.34)
        crease: with flow anisotropic: a crease is where normals turn by more than this along a mean edge, in degrees
            (5 or 5deg; 0.1 to 180, default 20)
        threads: largest number of threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run_product(patches, name, given, progress)


def flatten_many(
    inputs: Path | Sequence[Path],
    *,
    out: Path,
    shard: Optional[str] = None,
    workers: Optional[int] = None,
    resume: bool = False,
    csv: Optional[Path] = None,
    keep_failures: Optional[Path] = None,
    progress: Optional[Progress] = None,
    unit: Optional[Literal["mm", "cm", "dm", "m", "in"]] = None,
    scale: Optional[float] = None,
    remesh: Optional[bool] = None,
    smooth_first: Optional[Amount] = None,
    match_seams: Optional[bool] = None,
    no_match_seams: Optional[bool] = None,
    least_stretch: Optional[bool] = None,
    pick: Optional[int] = None,
    formats: Optional[str | Sequence[str]] = None,
    colors: Optional[Literal["diverging", "paper"]] = None,
    textured: Optional[bool] = None,
    no_report: Optional[bool] = None,
    paper: Optional[str] = None,
    page_overlap: Optional[Amount] = None,
    for_: Optional[Literal["laser", "knife", "plotter", "projector", "apparel"]] = None,
    map: Optional[bool] = None,
    only_layers: Optional[str | Sequence[str]] = None,
    text: Optional[Literal["letters", "strokes"]] = None,
    svg_groups: Optional[Literal["layers", "pieces"]] = None,
    dxf_profile: Optional[Literal["generic", "aama", "astm", "clo", "lectra", "optitex", "gerber"]] = None,
    dxf_version: Optional[Literal["r12", "r2000"]] = None,
    dxf_notches: Optional[Literal["points", "strokes"]] = None,
    dxf_layers: Optional[str] = None,
    seam_tolerance: Optional[Amount] = None,
    cut: Optional[Rows] = None,
    cut_along: Optional[str] = None,
    smooth_lines: Optional[str] = None,
    avoid: Optional[str] = None,
    keep_small: Optional[bool] = None,
    symmetric: Optional[str] = None,
    mirror_surface: Optional[bool] = None,
    prefer_cuts: Optional[str] = None,
    effort: Optional[int] = None,
    divide: Optional[Literal["objects", "materials", "parts"]] = None,
    only: Optional[str | Sequence[str]] = None,
    without: Optional[str | Sequence[str]] = None,
    weld: Optional[Amount | bool] = None,
    fill_holes: Optional[Amount] = None,
    side: Optional[Literal["outer", "inner"]] = None,
    flip: Optional[bool] = None,
    strict: Optional[bool] = None,
    allowance: Optional[Amount] = None,
    corners: Optional[Literal["mitre", "square", "round"]] = None,
    hole_allowance: Optional[str] = None,
    kerf: Optional[Amount] = None,
    open_folds: Optional[bool] = None,
    seam_notches: Optional[Rows] = None,
    notch_depth: Optional[Amount] = None,
    grain: Optional[str | float | Sequence[float]] = None,
    size: Optional[str] = None,
    quantity: Optional[int] = None,
    mirrored: Optional[int] = None,
    fabric: Optional[str] = None,
    note: Optional[str] = None,
    date: Optional[str] = None,
    edge_lengths: Optional[bool] = None,
    sheet_unit: Optional[Literal["mm", "in"]] = None,
    curve_tolerance: Optional[Amount] = None,
    method: Optional[Literal["controllable", "classical", "least_norm", "flattenable_laplacian", "local_offset", "global_penalty", "local_perturbation", "fairing", "auto"]] = None,
    sweeps: Optional[int] = None,
    target_e_max: Optional[float] = None,
    max_strain: Optional[Amount] = None,
    material: Optional[Path] = None,
    max_rms_strain: Optional[Amount] = None,
    max_deviation: Optional[Amount] = None,
    min_angle: Optional[Amount] = None,
    max_bending: Optional[float] = None,
    prefer: Optional[Literal["smooth", "flat", "near"]] = None,
    closeness: Optional[float] = None,
    border: Optional[Amount | Literal["fixed", "linked"]] = None,
    lambda_min: Optional[float] = None,
    lambda_max: Optional[float] = None,
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
    rings: Optional[int] = None,
    inner_steps: Optional[int] = None,
    clearance: Optional[Amount] = None,
    pull: Optional[float] = None,
    flow: Optional[Literal["none", "taubin", "implicit", "anisotropic"]] = None,
    mu: Optional[float] = None,
    crease: Optional[Amount] = None,
) -> list[dict[str, Any]]:
    """Flattens many mesh files one by one, as `flatten --inputs` does, and writes each into a folder in out: the files
        of a sequence of paths, or those that one path of a list names, a line each. Gives a record of each patch, in
        the order of the files; one that fails has an error. Memory does not grow with the number of files.

    Keywords, as flags of the program:
        unit: unit of the mesh's coordinates: mm, cm, dm, m or in (default: as the file says, else mm)
        scale: multiply all coordinates by this when the mesh is read; for a unit of 0.5 m: --unit m --scale 0.5
            (default 1)
        remesh: work on a mesh with fewer vertices, and write that mesh; all border vertices stay
        smooth_first: smooth the design first: takes out waves shorter than this, such as the noise of a scan (at most
            20 mean edge lengths; as 5mm)
        match_seams: keep the length of every border edge, or in a product of every edge along a seam, so that sewn
            sides stay equally long
        no_match_seams: allow the two sides of a product's seams to differ in length (default: equal to 0.1 mm)
        least_stretch: write the pattern of least rms strain; without this flag the rms strain may be up to 6 %
            higher, to make the largest strains as small as possible
        pick: how much strain to leave: 1 as designed, 2, 3, 4, 5 at most 2, 1, 0.5, 0.1 % rms, 6 flat
        formats: file formats of the pattern: any of svg, dxf, pdf and plt (default svg,dxf,pdf)
        colors: colours of the report's pictures: diverging or paper (default diverging)
        textured: also write the processed patch as textured.obj, with the pattern in millimetres as texture
            coordinates
        no_report: do not write the page of the report, and do not compute the table of ways to less stretch
        paper: also write the pattern as a .pdf of pages to join: a4, a3, a2, a1, a0, b4, b3, b2, b1, b0, letter,
            legal or tabloid, or any size as 36inx48in
        page_overlap: overlap of neighbouring pages of --paper (default 10mm)
        for_: what the files are for: laser, knife, plotter, projector or apparel; sets formats, layers and more,
            which your other flags can change
        map: draw the strain map and its legend in .svg, .pdf and on the pages of --paper
        only_layers: write only these layers, as cut,notch: any of strain, seam, notch, grain, fold, drill, internal,
            annotation, label, legend, hole or cut
        text: letters, or strokes for machines that have no letters (default letters)
        svg_groups: what the groups of the .svg are: layers, or pieces with their layers inside (default layers)
        dxf_profile: program that reads the .dxf: generic, aama, astm, clo, lectra, optitex or gerber (default
            generic)
        dxf_version: version of the .dxf: r12, which nearly every program reads, or r2000, with arcs and splines
            (default r12)
        dxf_notches: notches in a .dxf for apparel programs: points, or strokes for cutters that ignore points
            (default points)
        dxf_layers: other names in the .dxf for the layers strain, seam, notch, grain, fold, drill, internal,
            annotation, label, legend, hole or cut
        seam_tolerance: largest distance between borders that are one seam, as 0.5mm (default: a tenth of an edge's
            length)
        cut: cut the surface along lines first: a drawing (.obj, or a pattern .svg), a list of vertices, "plane x=0",
            "line 0,0,1 0,2,1", rings, "creases 30deg", uv, groups, open or auto (panels); may be repeated
        cut_along: triangles: lines cut through them; edges: lines follow edges of the mesh (default triangles)
        smooth_lines: make drawn lines smooth; moves them by up to half an edge: yes or no (default yes)
        avoid: places that --cut open avoids if it can: one vertex a line, an .obj with lines or points on the mesh,
            or an .obj or .ply of the model with these places painted
        keep_small: keep small pieces that cuts make; without this flag, a piece with less than 1 % of the area, or
            with less than 5 % and narrower than two edges, is joined to a neighbour
        symmetric: make left equal right, in lines and patterns: auto finds the plane, "x=0" names it, no (default no)
        mirror_surface: with --symmetric: replace one half of the surface by the mirror image of the other; the half
            that has the lines stays
        prefer_cuts: what a division into panels must have before all else: few pieces (few), short seams (short), or
            no slits that end inside a piece (simple); default few
        effort: number of divisions to try (1 to 1000, default 6); a larger number never gives a worse result
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
        allowance: width of the seam allowance, as 10mm
        corners: corners of the allowance: mitre, square or round (default mitre)
        hole_allowance: give holes the allowance too, inwards: yes or no (default yes)
        kerf: width that the machine cuts away, as 0.2mm; cut lines move by half of it, outwards, and into holes
            (default 0)
        open_folds: draw the whole piece on both sides of its fold, not its half
        seam_notches: notches on both sides of seams, one a line: number of the seam, or * for all; place as 50% or
            120mm; slit, v or t; double; or an .obj drawn on the model
        notch_depth: depth of notches (default 5mm, or half the allowance if that is less)
        grain: grain: a direction on the model, or an angle in the pattern
        size: size that the piece is for
        quantity: number of pieces to cut
        mirrored: number of pieces of --quantity to cut as mirror images
        fabric: material to cut the piece from
        note: any other text, as "one mirrored" or "cut on fold"
        date: date to write on the sheet, printed as you give it (default none)
        edge_lengths: write the length of each edge, from corner to corner, beside it; flatten also writes edge-
            lengths.csv
        sheet_unit: unit of the lengths on sheets, of the .dxf and of edge-lengths.csv: mm or in (default mm)
        curve_tolerance: largest distance between the drawn curves and the border of the mesh (default 0.1mm; 0:
            straight lines from vertex to vertex)
        method: controllable, classical, least_norm, flattenable_laplacian, local_offset, global_penalty,
            local_perturbation, fairing or auto (default auto)
        sweeps: largest number of sweeps (default: the method's own)
        target_e_max: end as soon as e_max is at most this, in radians (at least 0, default 0)
        max_strain: largest strain that an edge of the pattern may have, as a fraction of its length; the form changes
            only as much as this needs (0.02 or 2% for every edge, 2%@p99 for 99 % of the area; 0 to 1, default 0)
        material: use the limit of a material instead of --max-strain: steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists their limits
        max_rms_strain: largest root mean square of the strain, as a fraction of length; a few places with more strain
            do not decide it (0.02 or 2%; 0 to 1, default 0)
        max_deviation: farthest that a vertex may end from its position in the design, in model units (1.5 or 1.5mm;
            at least 0, default no limit)
        min_angle: no triangle gets an angle below this, or below the smallest angle of the design if that is smaller,
            in degrees (5 or 5deg; 0 to 60, default 0); or with lambda_min below 0: no triangle gets an angle below
            this, or below its own angle before the step if that is smaller, in degrees (5 or 5deg; 0 to 60, default
            1)
        max_bending: with prefer smooth or flat: largest bending, as a multiple of the design's; a larger value keeps
            the surface nearer to the design; 0: as smooth as usual (0 to 1e+06, default 0)
        prefer: what matters most: a smooth surface, a flattenable surface, or a surface near to the design (smooth,
            flat or near, default smooth)
        closeness: how much roughness to accept for a surface nearer to the design; 0: no rougher than the design, 1:
            twice as rough and 2.5 degrees more (0 to 1e+06, default 1)
        border: what border vertices may do: stay, slide along the border of the design, or move by at most a distance
            in model units (fixed, slide or a length such as 1.5 or 1.5mm, default fixed); or whether border vertices
            at the same place, as on the two sides of a seam, stay or move together; all other border vertices stay
            (fixed or linked, default fixed)
        lambda_min: smallest step along the Laplacian vector; a value below 0 lets saddles improve (-10 to 0, default
            0)
        lambda_max: largest step along the Laplacian vector (0 to 10, default 1)
        solver: how the best step is computed; trust_region is the solver that the paper names (model or trust_region,
            default model)
        lambda_: fraction of the Laplacian vector that every vertex moves (0 to 1, default 0.5); or with flow taubin:
            fraction of the umbrella vector in the smoothing step (0 to 1, default 0.33)
        order: order in which a sweep moves the vertices (sequential or simultaneous, default sequential)
        update: how a step gives new positions, until direct steps begin (direct, uniform or cotangent, default
            cotangent)
        switch_e_max: direct steps begin when e_max is below this, in radians (at least 0, default 0.001)
        switch_after: direct steps also begin after this number of faired steps, once a faired step gains too little
            (at least 0, default 20)
        switch_fall: a faired step gains too little if e_max falls by less than this, in radians (at least 0, default
            0.01)
        damping: damping of faired steps, relative to the median of the matrix's diagonal; 0 means 3e-6 for cotangent,
            3e-4 for uniform (0 to 1000, default 0); or least softness of the constraints, relative to the matrix;
            1e-9 makes them hard, as printed in the paper; they get softer where e_max would rise (1e-12 to 1000,
            default 1e-09)
        border_weight: weight of the moves of vertices next to the border; 10 keeps the slant of the surface there
            (0.001 to 1000, default 1)
        max_step: largest move of a vertex in a direct step, as a multiple of its shortest edge (1e-06 to 10, default
            0.5)
        min_step: converged when the rms step is below this fraction of the mean edge length (0 to 1, default 1e-06);
            or converged when the rms step is below this fraction of the mean edge length (0 to 1, default 1e-05); or
            converged when the rms step is below this fraction of the mean edge length (0 to 1, default 1e-04)
        fairness: w1, the weight of short and even edges (0 to 1e+06, default 1)
        position: w2, the weight of staying at the first positions (1e-09 to 1e+06, default 0.1)
        tau: fraction of each step that is taken (0.001 to 1, default 0.25); or fraction of each step that is taken (0
            to 1, default 0.1)
        rebase_every: after this number of steps the present positions become those to stay near; 0: never (at least
            0, default 0)
        band: farthest that a vertex may end from its position in the design, in model units; 0 means the mean length
            of the edges at inner vertices (at least 0, default 0)
        enough: defects of at most this are left as they are, in radians (at least 0, default 0.01); or done when
            e_max is at most this, in radians (at least 0, default 0.001)
        max_updates: largest number of vertices tried, over all sweeps (at least 0, default 500000)
        step: which steps count: guarded: those that lower the energy; published: all, as printed, so that energy may
            rise (guarded or published, default guarded)
        max_visits: with published steps: largest number of visits of a vertex, which ends the printed loop (at least
            1, default 100)
        cg_steps: conjugate-gradient steps before the penalty grows (1 to 1000, default 5)
        tolerance: done when a sweep changes the sum of squared defects by at most this fraction of its first value (0
            to 1, default 1e-04)
        rings: number of rings around a vertex that move together (1 to 10, default 3)
        inner_steps: steps for each visit of a vertex (1 to 1000, default 5)
        clearance: distance to keep from the obstacle, in model units (1.5 or 1.5mm; at least 0, default 0)
        pull: how strongly vertices are pulled to their first positions; waves longer than 2 pi sqrt(area / pull)
            stay, shorter ones go; 0: no pull (at least 0, default 100)
        flow: what a sweep does: none: one solve for the surface that bends least; else one step of a flow (none,
            taubin, implicit or anisotropic, default none)
        mu: with flow taubin: fraction of the umbrella vector in the step back, below 0 (-1 to 0, default -0.34)
        crease: with flow anisotropic: a crease is where normals turn by more than this along a mean edge, in degrees
            (5 or 5deg; 0.1 to 180, default 20)
    """
    given = _run.keywords_of(locals())
    return _run.run_many(inputs, out, shard, workers, resume, csv, keep_failures, given, progress)
