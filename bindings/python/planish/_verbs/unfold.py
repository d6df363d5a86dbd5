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
        unit: unit of the mesh's coordinates: mm, cm, dm, m or in (default: as the file says, else mm)
        scale: multiply all coordinates by this when the mesh is read; for a unit of 0.5 m: --unit m --scale 0.5
            (default 1)
        match_seams: keep the length of every border edge, or in a product of every edge along a seam, so that sewn
            sides stay equally long
        least_stretch: write the pattern of least rms strain; without this flag the rms strain may be up to 6 %
            higher, to make the largest strains as small as possible
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
        paper: divide the .pdf into pages to join: a4, a3, a2, a1, a0, b4, b3, b2, b1, b0, letter, legal or tabloid,
            or any size as 36inx48in
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
        max_strain: largest change of an edge's length from the patch to the pattern (0.02 or 2%); 2%@p99: on 99 % of
            the area
        material: use the limit of a material instead of --max-strain: steel, aluminium, leather, cotton, neoprene,
            stretch-woven or leather-lasted or a .json file of your own; planish materials lists their limits
        max_rms_strain: largest root mean square of the strain (0.02 or 2%)
        allowance: width of the seam allowance, as 10mm
        corners: corners of the allowance: mitre, square or round (default mitre)
        hole_allowance: give holes the allowance too, inwards: yes or no (default yes)
        kerf: width that the machine cuts away, as 0.2mm; cut lines move by half of it, outwards, and into holes
            (default 0)
        edge_allowances: allowances of single stretches of the border, one a line: first vertex, last vertex, width in
            mm
        fold: the two vertices at the ends of a straight stretch of the border; the piece is cut on the fold there,
            without an allowance
        open_folds: draw the whole piece on both sides of its fold, not its half
        notches: notches, one a line: vertex, or place along the border as 0.25 or 25%; slit, v or t; double; or an
            .obj drawn on the model
        seam_notches: notches on both sides of seams, one a line: number of the seam, or * for all; place as 50% or
            120mm; slit, v or t; double; or an .obj drawn on the model
        notch_depth: depth of notches (default 5mm, or half the allowance if that is less)
        grain: grain: a direction on the model, or an angle in the pattern
        marks: marks, one a line: vertex; cross or drill; or an .obj drawn on the model
        inner_lines: lines inside the piece, such as legs of darts: the vertices of each on one line; or an .obj drawn
            on the model
        piece_name: name of the piece, written inside it, as are the values of the next five flags
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
        threads: largest number of threads; never changes the result (default: all usable cores)
    """
    given = _run.keywords_of(locals())
    return _run.run(_core.unfold, _meshes.as_mesh(mesh, faces, name), given, progress)
