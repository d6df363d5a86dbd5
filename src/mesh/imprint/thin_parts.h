#pragma once

#include <optional>
#include <vector>

#include "mesh/imprint/constrained_delaunay.h"

namespace planish {

/// A node that makes a small angle larger: on a fixed side, or between sides.
struct WidenedBy {
  std::optional<std::array<Index, 2>> side = {};  ///< its ends
  double share = 0.0;                             ///< of the way along the side
  Vec2 place = {};                                ///< of what is on no side
  double reach = 0.0;                             ///< no node is to be nearer to it than this
};

/// Nodes for the parts of a triangle with an angle below `least` that more nodes can make larger:
/// one for each such part. Sides of the triangle and segments are fixed. Between two of them an
/// angle is what it is. Where the triangle has a smaller angle itself, that one counts.
/// @param least degrees
/// @param finest parts with a shorter side than this stay
std::vector<WidenedBy> widening_nodes(const ConstrainedDelaunay& inside, double least,
                                      double finest);

}  // namespace planish
