#pragma once

#include <planish/pattern/allowance.h>

namespace planish {

/// Where two edges of an outline meet.
struct OutlineCorner {
  Vec2 point;
  Vec2 before, after;  ///< directions of the edges, of length 1
  double width_before, width_after;
  Corners corners;  ///< how it is to be joined
  double mitre_limit;
};

/// Appends the way from the end of one edge's offset line to the start of the next one's. With the
/// corner's point it encloses an area counter-clockwise, or none: the premise of offset_outline().
void append_join(const OutlineCorner& corner, Polygon& line);

}  // namespace planish
