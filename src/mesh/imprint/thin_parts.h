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

/// Nodes that refine the parts of a triangle with an angle below `least`, one for each part. Sides
/// of the triangle and segments are fixed, so no node can make the angle between two of them
/// larger. In a triangle that has a smaller angle itself, that angle is the bound.
/// @param least degrees
/// @param finest parts with a shorter side are not refined
std::vector<WidenedBy> widening_nodes(const ConstrainedDelaunay& inside, double least,
                                      double finest);

}  // namespace planish
