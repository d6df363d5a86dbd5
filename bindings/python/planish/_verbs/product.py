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
    folded_cloth: Optional[bool] = None,
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
        unit: what one unit of the mesh is: mm, cm, dm, m or in (default: as its file says, else mm)
        scale: multiply all coordinates when the mesh is read: of a model whose unit is 0.5 m --unit m --scale 0.5
            (default 1)
        remesh: work on fewer vertices, and write these; the border keeps all of its own
        smooth_first: first take waves shorter than this out of the design, as the noise of a scan (at most 20 mean
            edges; such as 5mm)
        match_seams: keep the length of every border edge, or in a product of those along seams, so that what is sewn
            together stays equally long
        no_match_seams: let the two sides of a product's seams become unequal (default: equal to 0.1 mm)
        least_stretch: the pattern of least stretch; without it, up to 6 % more rms strain make the largest strains as
            small as they get
        pick: how much strain to leave: 1 as designed, 2, 3, 4, 5 at most 2, 1, 0.5, 0.1 % rms, 6 flat
        formats: of the pattern: some of svg, dxf, pdf and plt (default svg,dxf,pdf)
        colors: of the report's pictures: diverging or paper (default diverging)
        textured: also write the processed patch as textured.obj, with the pattern in millimetres for texture
            coordinates
        no_report: leave out the page of the report, and the table of what less stretch costs
        paper: also write the pattern as a .pdf of pages to be joined: a4, a3, a2, a1, a0, b4, b3, b2, b1, b0, letter,
            legal or tabloid, or a size of your own as 36inx48in
        page_overlap: of neighbouring pages of --paper (default 10mm)
        for_: what the files are for: laser, knife, plotter, projector or apparel; stands for formats, layers and
            more, which flags of their own change
        map: draw the strain map and its legend, in .svg, .pdf and on the pages of --paper
        only_layers: write these layers only, like cut,notch: some of strain, seam, notch, grain, fold, drill,
            internal, annotation, label, legend, hole or cut
        text: letters, or strokes for machines without them (default letters)
        svg_groups: in the .svg a group for each of the layers, or of the pieces with their layers inside (default
            layers)
        dxf_profile: whom the .dxf is for: generic, aama, astm, clo, lectra, optitex or gerber (default generic)
        dxf_version: r12, which nearly everything reads, or r2000, with arcs and splines (default r12)
        dxf_notches: in profiles for apparel: points, or strokes for cutters that ignore points (default points)
        dxf_layers: other names in the .dxf for the layers strain, seam, notch, grain, fold, drill, internal,
            annotation, label, legend, hole or cut
        piece: a setting of one piece instead of the flag: front:allowance=12mm; keys: allowance, corners, hole-
            allowance, kerf, edge-allowances, fold, open-folds, notches, notch-depth, grain, marks, inner-lines, size,
            quantity, mirrored, fabric, note, darts, turn, material, name or out, allowance.N, hem.N or ends.N of edge
            N and its name edge.N; none: without that flag
        seam_tolerance: largest distance at which borders are one seam, like 0.5mm (default: a tenth of an edge's
            length)
        avoid: places that the cuts of --cut open go round where they can: vertices one a line, an .obj with lines or
            points over the mesh, or an .obj or .ply of the model with these places painted
        symmetric: make left equal right, lines and patterns: auto finds the plane, "x=0" names it, no (default no)
        mirror_surface: with --symmetric: replace one half of the surface by the mirror image of the half that has the
            lines
        prefer_cuts: what a division into panels saves first: few (pieces), short (seams), simple (no slits that end
            inside a piece); default few
        effort: how many divisions are tried (1 to 1000, default 6); more are never worse
        divide: what makes a piece: objects (or groups, where the file has none), materials, or parts: whatever hangs
            together (default objects)
        only: take these objects, groups, materials or pieces, by their names with commas between
        without: leave out these objects, groups, materials or pieces
        weld: join borders that lie within LENGTH of each other (1.5 or 1.5mm; default: a length that fits the size of
            the mesh)
        fill_holes: close holes whose border is at most LENGTH long (1.5 or 1.5mm)
        side: of a wall with a thickness take one side: outer or inner
        flip: turn the surface over: its inner side becomes the outer one
        strict: take the mesh as it is: repair and leave out only what other flags ask for
        allowance: material beyond the seam, as 10mm
        corners: of the allowance: mitre, square or round (default mitre)
        hole_allowance: whether holes get the allowance too, inwards: yes or no (default yes)
        kerf: that the machine cuts away, as 0.2mm: cut lines are moved by half of it, outwards, and into holes
            (default 0)
        open_folds: draw the whole of a piece with a fold, not its half
        seam_notches: on both sides of seams, a line each: number of the seam or *; 50% or 120mm; kind; double; or an
            .obj drawn on the model
        notch_depth: of notches (default 5mm, or half of less allowance)
        grain: direction of the grain on the model, or its angle in the pattern
        size: that the piece is for
        quantity: how many to cut
        mirrored: how many of --quantity to cut as mirror images
        fabric: what to cut it from
        note: anything else, as "one mirrored" or "cut on fold"
        date: written on the sheet as it is (default none)
        edge_lengths: write the lengths from corner to corner along the outline, and with flatten into edge-
            lengths.csv
        sheet_unit: of lengths written on sheets, of the .dxf and of edge-lengths.csv: mm or in (default mm)
        curve_tolerance: how near curves of outlines stay to the border's vertices (default 0.1mm; 0: lines from
            vertex to vertex)
        folded_cloth: the roll is folded along its length: pieces are cut as pairs, halves with their fold on that of
            the cloth
        method: controllable, classical, least_norm, flattenable_laplacian, local_offset, global_penalty,
            local_perturbation, fairing or auto (default auto)
        sweeps: largest number of sweeps (default: what each method usually takes)
        target_e_max: end as soon as e_max is at most this, in radians (at least 0, default 0)
        max_strain: change the form as little as it takes until no edge of a pattern has to stretch by more than this,
            as a share of length (0.02 or 2% for every edge, 2%@p99 for 99 % of the area; 0 to 1, default 0)
        material: instead of --max-strain: what this material takes, steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists the limits
        max_rms_strain: the same by the root mean square of the strain, which a few positions with more do not decide
            (0.02 or 2%; 0 to 1, default 0)
        max_deviation: no vertex ends further than this from where it began, in model units (1.5 or 1.5mm; at least 0,
            default no limit)
        min_angle: no triangle gets an angle below this, or below the smallest one at first if that is smaller, in
            degrees (5 or 5deg; 0 to 60, default 0); or with lambda_min below 0: no triangle gets an angle below this,
            or below its present one if that is smaller, in degrees (5 or 5deg; 0 to 60, default 1)
        max_bending: with prefer smooth or flat: largest bending, as a multiple of that of the design; a larger one
            lets the surface stay nearer; 0: as smooth as usual (0 to 1e+06, default 0)
        prefer: what counts most: that the surface stays smooth, becomes flattenable, or stays near (smooth, flat or
            near, default smooth)
        closeness: how much rougher the surface may get for staying close: 0: no rougher than at first, 1: twice as
            rough and 2.5 degrees more (0 to 1e+06, default 1)
        border: what vertices of the border may do: stay, slide along the border as it was, or go as far from where
            they were as this, in model units (fixed, slide or a length such as 1.5 or 1.5mm, default fixed); or
            whether border vertices that came at the same place, as on the two sides of a seam, stay or move together;
            all others stay (fixed or linked, default fixed)
        lambda_min: smallest step along the Laplacian vector; below 0 saddles can improve (-10 to 0, default 0)
        lambda_max: largest step along the Laplacian vector (0 to 10, default 1)
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
        threads: use at most N threads; never changes the result (default: all usable cores)
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
    folded_cloth: Optional[bool] = None,
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
        unit: what one unit of the mesh is: mm, cm, dm, m or in (default: as its file says, else mm)
        scale: multiply all coordinates when the mesh is read: of a model whose unit is 0.5 m --unit m --scale 0.5
            (default 1)
        remesh: work on fewer vertices, and write these; the border keeps all of its own
        smooth_first: first take waves shorter than this out of the design, as the noise of a scan (at most 20 mean
            edges; such as 5mm)
        match_seams: keep the length of every border edge, or in a product of those along seams, so that what is sewn
            together stays equally long
        no_match_seams: let the two sides of a product's seams become unequal (default: equal to 0.1 mm)
        least_stretch: the pattern of least stretch; without it, up to 6 % more rms strain make the largest strains as
            small as they get
        pick: how much strain to leave: 1 as designed, 2, 3, 4, 5 at most 2, 1, 0.5, 0.1 % rms, 6 flat
        formats: of the pattern: some of svg, dxf, pdf and plt (default svg,dxf,pdf)
        colors: of the report's pictures: diverging or paper (default diverging)
        textured: also write the processed patch as textured.obj, with the pattern in millimetres for texture
            coordinates
        no_report: leave out the page of the report, and the table of what less stretch costs
        paper: also write the pattern as a .pdf of pages to be joined: a4, a3, a2, a1, a0, b4, b3, b2, b1, b0, letter,
            legal or tabloid, or a size of your own as 36inx48in
        page_overlap: of neighbouring pages of --paper (default 10mm)
        for_: what the files are for: laser, knife, plotter, projector or apparel; stands for formats, layers and
            more, which flags of their own change
        map: draw the strain map and its legend, in .svg, .pdf and on the pages of --paper
        only_layers: write these layers only, like cut,notch: some of strain, seam, notch, grain, fold, drill,
            internal, annotation, label, legend, hole or cut
        text: letters, or strokes for machines without them (default letters)
        svg_groups: in the .svg a group for each of the layers, or of the pieces with their layers inside (default
            layers)
        dxf_profile: whom the .dxf is for: generic, aama, astm, clo, lectra, optitex or gerber (default generic)
        dxf_version: r12, which nearly everything reads, or r2000, with arcs and splines (default r12)
        dxf_notches: in profiles for apparel: points, or strokes for cutters that ignore points (default points)
        dxf_layers: other names in the .dxf for the layers strain, seam, notch, grain, fold, drill, internal,
            annotation, label, legend, hole or cut
        seam_tolerance: largest distance at which borders are one seam, like 0.5mm (default: a tenth of an edge's
            length)
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
        divide: what makes a piece: objects (or groups, where the file has none), materials, or parts: whatever hangs
            together (default objects)
        only: take these objects, groups, materials or pieces, by their names with commas between
        without: leave out these objects, groups, materials or pieces
        weld: join borders that lie within LENGTH of each other (1.5 or 1.5mm; default: a length that fits the size of
            the mesh)
        fill_holes: close holes whose border is at most LENGTH long (1.5 or 1.5mm)
        side: of a wall with a thickness take one side: outer or inner
        flip: turn the surface over: its inner side becomes the outer one
        strict: take the mesh as it is: repair and leave out only what other flags ask for
        allowance: material beyond the seam, as 10mm
        corners: of the allowance: mitre, square or round (default mitre)
        hole_allowance: whether holes get the allowance too, inwards: yes or no (default yes)
        kerf: that the machine cuts away, as 0.2mm: cut lines are moved by half of it, outwards, and into holes
            (default 0)
        open_folds: draw the whole of a piece with a fold, not its half
        seam_notches: on both sides of seams, a line each: number of the seam or *; 50% or 120mm; kind; double; or an
            .obj drawn on the model
        notch_depth: of notches (default 5mm, or half of less allowance)
        grain: direction of the grain on the model, or its angle in the pattern
        size: that the piece is for
        quantity: how many to cut
        mirrored: how many of --quantity to cut as mirror images
        fabric: what to cut it from
        note: anything else, as "one mirrored" or "cut on fold"
        date: written on the sheet as it is (default none)
        edge_lengths: write the lengths from corner to corner along the outline, and with flatten into edge-
            lengths.csv
        sheet_unit: of lengths written on sheets, of the .dxf and of edge-lengths.csv: mm or in (default mm)
        curve_tolerance: how near curves of outlines stay to the border's vertices (default 0.1mm; 0: lines from
            vertex to vertex)
        folded_cloth: the roll is folded along its length: pieces are cut as pairs, halves with their fold on that of
            the cloth
        method: controllable, classical, least_norm, flattenable_laplacian, local_offset, global_penalty,
            local_perturbation, fairing or auto (default auto)
        sweeps: largest number of sweeps (default: what each method usually takes)
        target_e_max: end as soon as e_max is at most this, in radians (at least 0, default 0)
        max_strain: change the form as little as it takes until no edge of a pattern has to stretch by more than this,
            as a share of length (0.02 or 2% for every edge, 2%@p99 for 99 % of the area; 0 to 1, default 0)
        material: instead of --max-strain: what this material takes, steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists the limits
        max_rms_strain: the same by the root mean square of the strain, which a few positions with more do not decide
            (0.02 or 2%; 0 to 1, default 0)
        max_deviation: no vertex ends further than this from where it began, in model units (1.5 or 1.5mm; at least 0,
            default no limit)
        min_angle: no triangle gets an angle below this, or below the smallest one at first if that is smaller, in
            degrees (5 or 5deg; 0 to 60, default 0); or with lambda_min below 0: no triangle gets an angle below this,
            or below its present one if that is smaller, in degrees (5 or 5deg; 0 to 60, default 1)
        max_bending: with prefer smooth or flat: largest bending, as a multiple of that of the design; a larger one
            lets the surface stay nearer; 0: as smooth as usual (0 to 1e+06, default 0)
        prefer: what counts most: that the surface stays smooth, becomes flattenable, or stays near (smooth, flat or
            near, default smooth)
        closeness: how much rougher the surface may get for staying close: 0: no rougher than at first, 1: twice as
            rough and 2.5 degrees more (0 to 1e+06, default 1)
        border: what vertices of the border may do: stay, slide along the border as it was, or go as far from where
            they were as this, in model units (fixed, slide or a length such as 1.5 or 1.5mm, default fixed); or
            whether border vertices that came at the same place, as on the two sides of a seam, stay or move together;
            all others stay (fixed or linked, default fixed)
        lambda_min: smallest step along the Laplacian vector; below 0 saddles can improve (-10 to 0, default 0)
        lambda_max: largest step along the Laplacian vector (0 to 10, default 1)
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
    """
    given = _run.keywords_of(locals())
    return _run.run_many(inputs, out, shard, workers, resume, csv, keep_failures, given, progress)
