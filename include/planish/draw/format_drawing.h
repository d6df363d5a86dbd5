#pragma once

#include <array>
#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/unit.h>
#include <planish/draw/drawing.h>

namespace planish {

/// How a drawing is written as SVG.
struct SvgOptions {
  /// A group for each piece, with its layers inside, for programs that move pieces. What belongs to
  /// no one piece keeps layers of its own before them.
  bool by_piece = false;
};

/// The drawing as a stand-alone SVG at true size: width and height in mm, one user unit = 1 mm,
/// each layer a group that Inkscape shows as a layer, holes before the outline around them;
/// coordinates to 0.001 mm. The same drawing
/// gives the same bytes. Text is escaped; bytes that are no UTF-8 become U+FFFD. Sizes and places
/// are to be finite; points and texts that are nowhere are left out.
std::string format_svg(const Drawing& drawing, const SvgOptions& options = {});

/// The drawing as a PDF of one page at true size, with the sheet's size for a page and a word to
/// viewers not to scale it when printing. Each layer is one that viewers can show and hide;
/// coordinates to 0.001 mm. Text is set in Helvetica, which viewers have, as long as it keeps to
/// the characters of Windows-1252 (a minus sign is set as an en dash); Greek and Cyrillic letters
/// are spelled in Latin ones, characters of other scripts by their numbers, and what is beyond
/// Windows-1252 then is drawn as strokes and cannot be searched for. Nothing is compressed and no
/// date written: the same drawing gives the same bytes. A sheet longer than 5.08 m, which many
/// viewers would show too small, is divided into pages as format_tiled_pdf() does; one that would
/// take more than 10,000 of these is one page with a larger unit (PDF 1.6).
std::string format_pdf(const Drawing& drawing);

/// A size of paper, upright; pages may lie across as well.
struct Paper {
  std::string name;     ///< as "a4", also in names of files
  double width = 0.0;   ///< millimetres
  double height = 0.0;  ///< millimetres

  bool operator==(const Paper&) const = default;
};

/// The sizes that have names: a0 to a4 and b0 to b4 of ISO 216, letter, legal and tabloid.
const std::vector<Paper>& papers();

/// @throws Error unknown_name
Paper paper_named(std::string_view name);

/// How a drawing is divided into pages to be joined.
struct PageOptions {
  Paper paper = {};       ///< a named size or the maker's own
  double overlap = 10.0;  ///< of neighbours, millimetres
  /// A drawing that fits on one page with its label is that page alone, without a map.
  bool one_page = false;

  bool operator==(const PageOptions&) const = default;
};

/// The drawing at true size on pages of a printer's paper, to be joined. The first page shows where
/// each goes, the drawing's notes, and test squares; so the layer "label" is left out, unless the
/// layer "legend" is there. Pages are upright or across, whatever needs fewer; 10 mm at
/// each edge stay free, neighbours overlap, and crosses in the overlap show how to align
/// them. Rows have letters from the top, columns numbers. Pages with nothing on them are crossed
/// out on the first page and left out. Of several pieces the map has their names. Otherwise as
/// format_pdf().
/// @throws Error too_large where it would take more than 10,000 pages, option_out_of_range for
///   paper that is smaller than its margins and the overlap
std::string format_tiled_pdf(const Drawing& drawing, const PageOptions& options);

/// How many pages format_tiled_pdf() takes.
/// @throws Error as format_tiled_pdf()
std::size_t count_pages(const Drawing& drawing, const PageOptions& options);

/// The room of pages that are joined, across (x) and along (y), in millimetres.
struct PageRoom {
  Vec2 frame;  ///< what one page shows
  Vec2 step;   ///< what each further page adds
};

/// Of upright pages, or of those that lie across.
/// @throws Error option_out_of_range as format_tiled_pdf()
PageRoom page_room(const PageOptions& options, bool across);

/// For callers who make a drawing with long work: its area alone may say that it takes too many
/// pages.
/// @param area of what is drawn, square millimetres
/// @throws Error too_large where format_tiled_pdf() would, whatever the shape
void check_page_area(double area, const PageOptions& options);

/// The drawing as HPGL for plotters and cutters, 40 units per millimetre, so coordinates to
/// 0.025 mm, from (0, 0) at the lower left corner of all lines. Pieces come one after the other,
/// each in the order of the layers, holes before the outline around them. Each layer that is
/// visible and has lines takes a pen: pen 1 "cut", the next ones the others in their order; from
/// the eighth on they share pen 8. Closed lines end where they began; text is drawn as strokes, in
/// letters as format_pdf() spells them. HPGL has no areas: what is filled and has no outline
/// is left out. Widths, colours and dashes are the pen's, not the file's. Plotters with 16-bit
/// coordinates reach 819 mm. The same drawing gives the same bytes.
std::string format_plt(const Drawing& drawing);

/// For whom a DXF file is. None of the programs was at hand to try a file with: docs/formats.md.
enum class DxfProfile {
  generic,  ///< lasers, plotters, CAD: all layers under their own names, nothing in blocks
  aama,     ///< apparel CAD, ANSI/AAMA-292: a block per piece, numbered layers
  astm,     ///< apparel CAD, ASTM D6673: the same with its system texts
  clo,      ///< as aama, marked as DXF R10
  lectra,   ///< as aama
  optitex,  ///< as astm
  gerber,   ///< as astm
};

/// All profiles.
inline constexpr std::array k_dxf_profiles = {
    DxfProfile::generic, DxfProfile::aama,    DxfProfile::astm,  DxfProfile::clo,
    DxfProfile::lectra,  DxfProfile::optitex, DxfProfile::gerber};

/// "generic", "aama", ...
std::string_view to_string(DxfProfile profile);

/// @throws Error unknown_name
DxfProfile dxf_profile_named(std::string_view name);

/// The dialect of a DXF file.
enum class DxfVersion {
  r12,    ///< AC1009, what the widest range of programs and machines reads: lines as polylines
  r2000,  ///< AC1015: curves as arcs and splines
};

/// All versions.
inline constexpr std::array k_dxf_versions = {DxfVersion::r12, DxfVersion::r2000};

/// "r12" or "r2000".
std::string_view to_string(DxfVersion version);

/// How a drawing is written as DXF.
struct DxfOptions {
  DxfProfile profile = DxfProfile::generic;  ///< the program that is to read it
  /// Other names for layers: name in the drawing -> name in the file. Layers with one name become
  /// one layer.
  std::map<std::string, std::string, std::less<>> layer_names = {};
  bool stroked_text = false;  ///< letters as lines instead of TEXT; in no profile for apparel
  DxfVersion version = DxfVersion::r12;  ///< of the generic profile
  /// Profiles for apparel: notches, match marks and drill holes as lines, for cutters that ignore
  /// points.
  bool notch_strokes = false;
  Unit unit = Unit::mm;  ///< of coordinates and of $INSUNITS
};

/// The drawing as DXF, in millimetres unless options have another unit, coordinates to 0.001 mm.
/// Pieces come one after the other, each in the order of the layers, holes before the outline
/// around them. Lines become POLYLINEs, closed where they are closed, with few points where these
/// were fitted; in R2000 outlines become LWPOLYLINEs, whose arcs are arcs, and SPLINEs. Areas that
/// are filled and have no outline (the strain map) are left out, and so are layers without anything
/// else; widths of lines are not kept. Colours become the nearest of fifteen of AutoCAD's, hidden
/// layers stay hidden. Text becomes TEXT as high as asked; each UTF-16 unit beyond ASCII becomes
/// \U+ and four hexadecimal digits, as in AutoCAD. Names of layers and blocks are cut to 31 of A-Z
/// a-z 0-9 $ - _, as R12 wants them; every other character becomes _. The same drawing gives the
/// same bytes.
///
/// The other profiles write every piece as a block, in ASCII. They have numbers for these layers,
/// by their names in the drawing: cut, notch, grain, fold, internal, drill and seam; others are
/// left out unless layer_names names them. A path's mark becomes a POINT or a LINE, and every
/// vertex of an outline or inner line has a POINT that says whether it is a corner:
/// docs/formats.md.
/// @throws Error unknown_name where layer_names names a layer that the drawing does not have
std::string format_dxf(const Drawing& drawing, const DxfOptions& options = {});

}  // namespace planish
