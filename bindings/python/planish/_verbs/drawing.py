"""Written by tools/generate.py from `planish describe --json`. Change that."""

from __future__ import annotations

from typing import TYPE_CHECKING, Literal, Optional, Sequence

from .. import _core, _run

if TYPE_CHECKING:
    from .._types import Amount, Path, Rows


def svg(
    result: _core.FlattenResult | _core.UnfoldResult,
    path: Optional[Path] = None,
    *,
    as_designed: bool = False,
    text: Optional[Literal["letters", "strokes"]] = None,
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
) -> str:
    """The pattern of a result at true size as SVG, which is also written where there is a path. Without keywords it is
        as the result was made; with any, all that are not given here have their defaults, an allowance too. With
        as_designed it is the pattern of the unchanged design.

    Keywords, as flags of the program:
        text: letters, or strokes for machines without them (default letters)
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
    """
    given = _run.keywords_of(locals())
    return _run.draw(result, "svg", path, as_designed, given).decode()


def dxf(
    result: _core.FlattenResult | _core.UnfoldResult,
    path: Optional[Path] = None,
    *,
    as_designed: bool = False,
    text: Optional[Literal["letters", "strokes"]] = None,
    dxf_profile: Optional[Literal["generic", "aama", "astm", "clo", "lectra", "optitex", "gerber"]] = None,
    dxf_version: Optional[Literal["r12", "r2000"]] = None,
    dxf_notches: Optional[Literal["points", "strokes"]] = None,
    dxf_layers: Optional[str] = None,
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
) -> str:
    """The pattern of a result at true size as DXF, which is also written where there is a path. Without keywords it is
        as the result was made; with any, all that are not given here have their defaults, an allowance too. With
        as_designed it is the pattern of the unchanged design.

    Keywords, as flags of the program:
        text: letters, or strokes for machines without them (default letters)
        dxf_profile: whom the .dxf is for: generic, aama, astm, clo, lectra, optitex or gerber (default generic)
        dxf_version: r12, which nearly everything reads, or r2000, with arcs and splines (default r12)
        dxf_notches: in profiles for apparel: points, or strokes for cutters that ignore points (default points)
        dxf_layers: other names in the .dxf for the layers strain, seam, notch, grain, fold, drill, internal,
            annotation, label, legend, hole or cut
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
    """
    given = _run.keywords_of(locals())
    return _run.draw(result, "dxf", path, as_designed, given).decode()


def pdf(
    result: _core.FlattenResult | _core.UnfoldResult,
    path: Optional[Path] = None,
    *,
    as_designed: bool = False,
    paper: Optional[str] = None,
    map: Optional[bool] = None,
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
) -> bytes:
    """The pattern of a result at true size as PDF, which is also written where there is a path. Without keywords it is
        as the result was made; with any, all that are not given here have their defaults, an allowance too. With
        as_designed it is the pattern of the unchanged design.

    Keywords, as flags of the program:
        paper: divide the .pdf into pages to be joined: a4, a3, a2, a1, a0, b4, b3, b2, b1, b0, letter, legal or
            tabloid, or a size of your own as 36inx48in
        map: draw the strain map and its legend, in .svg, .pdf and on the pages of --paper
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
    """
    given = _run.keywords_of(locals())
    return _run.draw(result, "pdf", path, as_designed, given)


def plt(
    result: _core.FlattenResult | _core.UnfoldResult,
    path: Optional[Path] = None,
    *,
    as_designed: bool = False,
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
) -> str:
    """The pattern of a result at true size as HPGL, which is also written where there is a path. Without keywords it is
        as the result was made; with any, all that are not given here have their defaults, an allowance too. With
        as_designed it is the pattern of the unchanged design.

    Keywords, as flags of the program:
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
    """
    given = _run.keywords_of(locals())
    return _run.draw(result, "plt", path, as_designed, given).decode()
