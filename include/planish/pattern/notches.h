#pragma once

#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include <planish/pattern/piece_outline.h>

namespace planish {

enum class NotchKind { slit, v, t };
std::string_view to_string(NotchKind kind);

/// A place on an edge of the border, which may run either way.
struct PlaceOnEdge {
  Index from = 0, to = 0;
  double share = 0.0;  ///< of the edge's length, 0 to 1, from `from`
};

/// A mark in the edge that tells which places of two pieces are sewn together.
struct Notch {
  /// A vertex on the border, or a share of the outer border's length in the pattern, 0 to 1, from
  /// its vertex of the smallest number on, counter-clockwise, or a place on an edge.
  std::variant<Index, double, PlaceOnEdge> place;
  NotchKind kind = NotchKind::slit;
  bool is_double = false;
};

/// Millimetres.
struct NotchSizes {
  double depth = 5.0;
  double width = 4.0;    ///< of a V at the edge, of a T's bar
  double spacing = 6.0;  ///< of a double notch's two, along the seam
};

/// Checks that places are on the border, which needs no pattern.
/// @param border loops of vertices
/// @throws Error misplaced_notch naming the piece and the place
void check_notches(std::span<const std::vector<Index>> border, std::span<const Notch> notches,
                   std::string_view piece);

/// Notches as open lines: each begins at the line that is cut and runs at right angles to the seam
/// towards it. A T has a second line, its bar.
/// @param cut what offset_outline() made of the outline, or the outline's own loops
/// @param outline with vertices where notches name any
/// @throws Error option_out_of_range for sizes that are not above 0; misplaced_notch for places off
///   the border and for notches that reach through the seam, or where there is no allowance to
///   where the piece is not
std::vector<Polygon> notch_lines(const PieceOutline& outline, std::span<const Polygon> cut,
                                 std::span<const Notch> notches, const NotchSizes& sizes = {});

}  // namespace planish
