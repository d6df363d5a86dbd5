#pragma once

#include <cstddef>
#include <vector>

#include <planish/pattern/piece_outline.h>

namespace planish {

/// A line across which material is folded: a point of it, and its direction, of length 1.
struct CreaseLine {
  Vec2 at, along;

  /// How far a place is to the left.
  double height(Vec2 p) const { return cross(along, p - at); }
  Vec2 mirrored(Vec2 p) const;
};

/// The mirror image of a polygon, which runs the other way round, so that its area keeps its sign.
Polygon mirrored(Polygon polygon, const CreaseLine& crease);

/// A strip over a crease as far as a polygon lies along it, so that rounding leaves no gap between
/// the polygon and its mirror image; empty where it does not.
Polygon strip_over(const CreaseLine& crease, const Polygon& flap);

/// Puts the points of a loop between two others onto the straight line between these.
void straighten(std::size_t from, std::size_t to, Polygon& loop);

/// winding_union() without specks that rounding leaves.
std::vector<Polygon> united_flaps(const std::vector<Polygon>& lines);

}  // namespace planish
