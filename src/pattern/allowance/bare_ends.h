#pragma once

#include <optional>
#include <span>
#include <vector>

#include "pattern/allowance/allowance_joins.h"

namespace planish {

/// A line that ends allowances: they are to its left.
struct EndLine {
  Vec2 at, along;
};

/// Where allowances end beside edges without one, as folds: at the lines of those edges.
struct BareEnds {
  /// By vertex, for corners where an allowance ends so: of the opened piece.
  std::vector<std::optional<OutlineCorner>> corners;
  std::vector<std::vector<EndLine>> of_join, of_edge;  ///< that cut the allowance there

  /// Whether the join at a vertex is not that of two edges alone.
  bool is_at(std::size_t vertex) const {
    const std::size_t last = (vertex + corners.size() - 1) % corners.size();
    return corners[vertex] || !of_join[vertex].empty() || !of_edge[vertex].empty() ||
           !of_edge[last].empty();
  }
};

/// Finds where the allowances of a loop end at the line of a neighbouring edge without one. There
/// is no such end if the allowance does not leave that line within four widths along its edges (the
/// side simply continues without an allowance), or if that edge is not on a fold and the border
/// turns by less than 25 degrees there.
BareEnds bare_ends(const WideLoop& wide, Corners corners, double mitre_limit);

/// What is left of a polygon to the left of lines. Two polygons with an edge in common still have
/// what is left of it in common, to the last bit.
Polygon left_of(Polygon polygon, std::span<const EndLine> lines);

}  // namespace planish
