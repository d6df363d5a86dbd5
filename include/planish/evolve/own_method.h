#pragma once

#include <string>
#include <vector>

#include <planish/evolve/method.h>
#include <planish/mesh/patch.h>

namespace planish {

/// What a method of one's own is given for a sweep. It is valid during the call. Vertices are
/// numbered as in the mesh.
struct SweepInput {
  const Patch& design;  ///< the input patch: triangles, rings, inner vertices, border
  const std::vector<Vec3>& positions;  ///< where the vertices are now, model units
  const std::vector<Index>& movable;   ///< the vertices that may move, increasing
  int sweep = 1;                       ///< the number of this sweep, from 1
};

/// The method whose only sweep puts all vertices there, those of the border too: what another
/// program made of a patch, to be measured and compared as the others are.
/// @param positions one per vertex of the mesh, model units
OwnMethod result_as_method(std::string name, std::vector<Vec3> positions);

}  // namespace planish
