#pragma once

#include <cstddef>
#include <vector>

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

/// A loop without edges of no length, and what each edge has.
struct WideLoop {
  Polygon points;
  std::vector<double> widths;
  std::vector<bool> folds;  ///< whether an edge is on a fold

  std::size_t next(std::size_t i) const { return (i + 1) % points.size(); }
  std::size_t last(std::size_t i) const { return (i + points.size() - 1) % points.size(); }
  /// Of the edge from a point on, of length 1; 0 for an edge too short to have one.
  Vec2 direction(std::size_t edge) const;
  OutlineCorner corner(std::size_t point, Corners corners, double mitre_limit) const;
};

/// Appends the way from the end of one edge's offset line to the start of the next one's. With the
/// corner's point it encloses an area counter-clockwise, or none: the premise of offset_outline().
void append_join(const OutlineCorner& corner, Polygon& line);

}  // namespace planish
