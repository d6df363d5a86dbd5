#pragma once

#include <cstddef>
#include <vector>

#include <planish/mesh/inspect.h>

namespace planish {

/// What keeps triangles from being an oriented manifold.
struct ManifoldDefects {
  std::vector<Problem> problems;  ///< worst first
  std::size_t edges = 0, used_vertices = 0;
};

/// Finds repeated indices, duplicate triangles, edges and vertices that are not manifold, and
/// clashing orientation. O(m log m).
/// @pre all indices are in range
ManifoldDefects find_manifold_defects(const TriMesh& mesh);

}  // namespace planish
