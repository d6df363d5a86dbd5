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
        text: letters, or strokes for machines that have no letters (default letters)
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
        text: letters, or strokes for machines that have no letters (default letters)
        dxf_profile: program that reads the .dxf: generic, aama, astm, clo, lectra, optitex or gerber (default
            generic)
        dxf_version: version of the .dxf: r12, which nearly every program reads, or r2000, with arcs and splines
            (default r12)
        dxf_notches: notches in a .dxf for apparel programs: points, or strokes for cutters that ignore points
            (default points)
        dxf_layers: other names in the .dxf for the layers strain, seam, notch, grain, fold, drill, internal,
            annotation, label, legend, hole or cut
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
        paper: divide the .pdf into pages to join: a4, a3, a2, a1, a0, b4, b3, b2, b1, b0, letter, legal or tabloid,
            or any size as 36inx48in
        map: draw the strain map and its legend in .svg, .pdf and on the pages of --paper
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
    """
    given = _run.keywords_of(locals())
    return _run.draw(result, "plt", path, as_designed, given).decode()
