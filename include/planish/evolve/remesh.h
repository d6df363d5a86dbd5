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

/// How many vertices remesh() leaves, about: 5,000, or three times those of the border where that
/// is more; all where the patch has no more.
std::size_t vertices_of_remeshed(const Patch& patch);

/// Takes vertices out of the inside of a patch, for work that does not need its density: a coarse
/// surface that is flattenable stays so however it is divided. Every vertex and edge of the border
/// stays, so that seams still fit, and so do fixed vertices and those to be kept; triangles grow
/// from the border's edges inward (see coarsen()). vertices_of_remeshed() are left. A patch that
/// has no more, or is not of one part with a border, comes back as it is.
/// @pre check_constraints() accepts the constraints
/// @throws Error what stands in the way of Purpose::measure; index_out_of_range for a vertex to be
///   kept that there is not
RemeshedPatch remesh(const Patch& patch, const Constraints& constraints = {},
                     std::span<const Index> keep = {});

}  // namespace planish
