#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/evolve/constraints.h>
#include <planish/mesh/patch.h>

namespace planish {

/// A patch to be worked on in the place of a denser one.
struct RemeshedPatch {
  Patch patch;                ///< with fewer vertices
  Constraints constraints;    ///< of the vertices that are left
  std::vector<Index> source;  ///< vertex of `patch` -> vertex of the denser one, increasing
};

/// Takes vertices out of the inside of a patch, for work that does not need its density: a coarse
/// surface that is flattenable stays so however it is divided. Every vertex and edge of the border
/// stays, so that seams still fit, and so do fixed vertices and those to be kept; triangles grow
/// from the border's edges inward (see coarsen()). What is left are some 5,000 vertices, or three
/// times as many as on the border where that is more. A patch that has no more, or is not of one
/// part with a border, comes back as it is.
/// @pre check_constraints() accepts the constraints
/// @throws Error what stands in the way of Purpose::measure; index_out_of_range for a vertex to be
///   kept that there is not
RemeshedPatch remesh(const Patch& patch, const Constraints& constraints = {},
                     std::span<const Index> keep = {});

}  // namespace planish
