#pragma once

#include <span>

#include <planish/core/vec.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Length in the pattern over length on the patch, minus 1.
/// @param pattern one position per vertex of the mesh
/// @param scale unit_scale(mesh), so that lengths of any size have squares
inline double strain_of_edge(const TriMesh& mesh, std::span<const Vec2> pattern, double scale,
                             Index v, Index w) {
  const double on_patch = norm(scale * mesh.positions[w] - scale * mesh.positions[v]);
  return norm(scale * pattern[w] - scale * pattern[v]) / on_patch - 1.0;
}

}  // namespace planish
