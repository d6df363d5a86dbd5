"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Optional, Sequence

from .. import _core, _meshes, _run

if TYPE_CHECKING:
    from numpy.typing import ArrayLike

    from .._types import Amount, MeshLike, Path, Progress, Rows


def unfold(
    mesh: MeshLike,
    faces: Optional[ArrayLike] = None,
    *,
    name: Optional[str] = None,
    progress: Optional[Progress] = None,
    unit: Optional[Literal["mm", "cm", "dm", "m", "in"]] = None,
    scale: Optional[float] = None,
    match_seams: Optional[bool] = None,
    least_stretch: Optional[bool] = None,
    cut: Optional[Rows] = None,
    cut_along: Optional[str] = None,
    smooth_lines: Optional[str] = None,
    avoid: Optional[str] = None,
    keep_small: Optional[bool] = None,
    symmetric: Optional[str] = None,
    mirror_surface: Optional[bool] = None,
    prefer_cuts: Optional[str] = None,
    effort: Optional[int] = None,
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
    max_strain: Optional[Amount] = None,
    material: Optional[Path] = None,
    max_rms_strain: Optional[Amount] = None,
    allowance: Optional[Amount] = None,
    corners: Optional[Literal["mitre", "square", "round"]] = None,
    hole_allowance: Optional[str] = None,
    kerf: Optional[Amount] = None,
    edge_allowances: Optional[Rows] = None,
    fold: Optional[str | Sequence[int]] = None,
    open_folds: Optional[bool] = None,
    notches: Optional[Rows] = None,
    seam_notches: Optional[Rows] = None,
    notch_depth: Optional[Amount] = None,
    grain: Optional[str | float | Sequence[float]] = None,
    marks: Optional[Rows] = None,
    inner_lines: Optional[Rows] = None,
    piece_name: Optional[str] = None,
    size: Optional[str] = None,
    quantity: Optional[int] = None,
    mirrored: Optional[int] = None,
    fabric: Optional[str] = None,
    note: Optional[str] = None,
    date: Optional[str] = None,
    edge_lengths: Optional[bool] = None,
    sheet_unit: Optional[Literal["mm", "in"]] = None,
    curve_tolerance: Optional[Amount] = None,
    threads: Optional[int] = None,
) -> _core.UnfoldResult:
    """Lays a patch flat as it is, with the least stretch or within limits of strain.

    Keywords, as flags of the program:
        unit: what one unit of the mesh is: mm, cm, dm, m or in (default: as its file says, else mm)
        scale: multiply all coordinates when the mesh is read: of a model whose unit is 0.5 m --unit m --scale 0.5
            (default 1)
        match_seams: keep the length of every border edge, or in a product of those along seams, so that what is sewn
            together stays equally long
        least_stretch: the pattern of least stretch; without it, up to 6 % more rms strain make the largest strains as
            small as they get
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
        paper: divide the .pdf into pages to be joined: a4, a3, a2, a1, a0, b4, b3, b2, b1, b0, letter, legal or
            tabloid, or a size of your own as 36inx48in
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
        max_strain: how much an edge of the pattern may be longer or shorter than on the patch (0.02 or 2%); 2%@p99:
            on 99 % of the area
        material: instead of --max-strain: what this material takes, steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists the limits
        max_rms_strain: the same for the root mean square of the strain (0.02 or 2%)
        allowance: material beyond the seam, as 10mm
        corners: of the allowance: mitre, square or round (default mitre)
        hole_allowance: whether holes get the allowance too, inwards: yes or no (default yes)
        kerf: that the machine cuts away, as 0.2mm: cut lines are moved by half of it, outwards, and into holes
            (default 0)
        edge_allowances: other ones for stretches of the border, a line each: from vertex, to vertex, width in mm
        fold: vertices at the ends of a straight stretch of the border: the piece is cut on the fold there, without an
            allowance
        open_folds: draw the whole of a piece with a fold, not its half
        notches: a line each: vertex, or share of the border as 0.25 or 25%; slit, v or t; double; or an .obj drawn on
            the model
        seam_notches: on both sides of seams, a line each: number of the seam or *; 50% or 120mm; kind; double; or an
            .obj drawn on the model
        notch_depth: of notches (default 5mm, or half of less allowance)
        grain: direction of the grain on the model, or its angle in the pattern
        marks: a line each: vertex; cross or drill; or an .obj drawn on the model
        inner_lines: as legs of darts, a line each by its vertices; or an .obj drawn on the model
        piece_name: written inside the piece, as are the next five
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
        threads: use at most N threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run(_core.unfold, _meshes.as_mesh(mesh, faces, name), given, progress)
