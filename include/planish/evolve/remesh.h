#pragma once

#include <cstddef>

#include <planish/evolve/constraints.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A patch to be worked on in the place of a denser one.
struct RemeshedPatch {
  TriMesh mesh;
  Constraints constraints;  ///< of the vertices that are left
};

/// Takes vertices out of the inside of a patch, for work that does not need its density: a coarse
/// surface that is flattenable stays so however it is divided. Every vertex and edge of the border
/// stays, so that seams still fit, and so do fixed vertices; triangles grow from the border's edges
/// inward (see coarsen()). What is left are some 5,000 vertices, or three times as many as on the
/// border where that is more. A patch that has no more, or is not of one part with a border, comes
/// back as it is.
/// @pre check_constraints() accepts the constraints
/// @throws Error what stands in the way of Purpose::measure
RemeshedPatch remesh(const TriMesh& mesh, const Constraints& constraints = {});

}  // namespace planish
