#pragma once

#include <vector>

#include <planish/measure/flattenability.h>

namespace planish {

/// Of a mesh whose vertices are at these positions.
inline Flattenability figures_of(const TriMesh& mesh, const std::vector<Vec3>& positions) {
  const TriMesh after{positions, mesh.triangles};
  return measure(Patch(after));
}

}  // namespace planish
