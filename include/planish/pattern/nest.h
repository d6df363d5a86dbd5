#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include <planish/core/context.h>
#include <planish/pattern/piece_outline.h>

namespace planish {

/// How a piece may lie on a sheet, beside the way that its grain asks for.
enum class Turns {
  none,     ///< that way only
  half,     ///< or turned by 180 degrees: along the grain too
  quarter,  ///< or turned by 90, 180 or 270 degrees
  free,     ///< or turned by any multiple of 15 degrees
};
/// "none", "half", "quarter" or "free".
std::string_view to_string(Turns turns);

/// A piece to be cut from a sheet.
struct NestPiece {
  PieceOutline outline;  ///< what is cut, with its allowance
  int quantity = 1;      ///< how many; 0 leaves the piece out
  /// Degrees, counter-clockwise, that bring the grain along the length of the sheet.
  double angle = 0.0;
  std::optional<Turns> turns = {};  ///< none: those of NestOptions
  /// Of half a piece on folded cloth: degrees, counter-clockwise, that bring its fold along the
  /// sheet, with the piece above it. It lies so, on the sheet's edge at y = 0.
  std::optional<double> fold = {};
};

/// The sheets, in millimetres: a sheet's length is along x, its width along y.
struct NestOptions {
  double width = 1500.0;              ///< of each sheet
  std::optional<double> length = {};  ///< of each sheet; without, one roll of any length
  double gap = 5.0;                   ///< that is left between any two pieces
  double margin = 0.0;                ///< that is left free along every edge of a sheet
  /// The cloth is folded along y = 0, where no margin is left; the width is that of the folded
  /// cloth.
  bool folded = false;
  bool in_holes = false;      ///< pieces may lie in the holes of others, which are cut first
  Turns turns = Turns::half;  ///< of every piece that has none of its own
  /// Places along the length are multiples of it: finer is tighter and slower. 0: chosen by the
  /// sizes of the pieces.
  double step = 0.0;
  /// Orders of laying the pieces, of which the best is kept. 0: as many as make 10,000 turned
  /// copies, but 4 to 200.
  int tries = 0;
};

/// Where a copy of a piece lies: turned about the origin of its outline, then shifted.
struct NestPlacement {
  std::size_t piece = 0;  ///< its number in what nest() was given, from 0
  int copy = 0;           ///< from 0
  std::size_t sheet = 0;  ///< from 0
  double angle = 0.0;     ///< degrees, counter-clockwise, at least 0 and less than 360
  Vec2 shift = {};        ///< millimetres; (0, 0) is a corner of the sheet

  Vec2 operator()(Vec2 p) const;  ///< a place of the piece on the sheet
};

/// Pieces laid on sheets.
struct Nesting {
  std::vector<NestPlacement> placements;  ///< every copy: by piece, then by copy
  std::size_t sheets = 0;                 ///< that are begun; of a roll 1
  double used_length = 0.0;               ///< of the last of them, with both margins, millimetres
  double piece_area = 0.0;                ///< of all copies, square millimetres
  double sheet_area = 0.0;                ///< of the sheets, of the last as long as it is used

  /// Share of the area that ends up in pieces.
  double used_share() const { return sheet_area > 0.0 ? piece_area / sheet_area : 0.0; }
};

/// Whether nest() takes so many pieces, each copy counted.
/// @throws Error too_large for more than 10,000
void check_copies(double copies);

/// Lays pieces on sheets so that none is nearer to another one than the gap, nor to an edge of its
/// sheet than the margin, both to 0.000001 mm; every copy is laid. Each goes as far towards the
/// beginning of the sheet as it can in the turns that it may take, in several orders, of which the
/// one is kept that needs the least. The result depends on nothing but what is given.
/// docs/nesting.md says why none overlap, and how long it takes.
/// @throws Error option_out_of_range, piece_too_large for one that fits on no sheet in any of its
///   turns, no_triangles for one without an area, non_finite_coordinate, too_large for more than
///   10,000 copies, or a piece of 10 km or 10,000 km away from its origin; Cancelled
Nesting nest(std::span<const NestPiece> pieces, const NestOptions& options = {},
             const Context& context = {});

}  // namespace planish
