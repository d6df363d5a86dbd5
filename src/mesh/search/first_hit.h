#pragma once

#include <optional>

#include <planish/core/vec.h>

#include "mesh/search/box_tree.h"

namespace planish {

/// Where a ray meets a triangle first.
struct Hit {
  double distance = 0.0;  ///< in lengths of the direction
  Index triangle = 0;
};

/// The first triangle of the tree on the ray from `from`, of several at one distance that of the
/// smallest number. A ray through a vertex or an edge meets its triangles, in spite of rounding.
/// @param tree of a mesh at the scale of unit_scale() and near the origin
/// @param nearest below it nothing counts, so that a ray can begin on a triangle
std::optional<Hit> first_hit(const BoxTree& tree, Vec3 from, Vec3 direction, double nearest);

}  // namespace planish
