#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// The ordered one-rings of all vertices as compressed rows; see Connectivity::ring().
struct Rings {
  std::vector<std::size_t> start;  ///< vertex count + 1
  std::vector<Index> vertices;
  std::vector<unsigned char> border;  ///< 1 where the ring is open
};

/// Builds the rings in linear time; nothing where the triangles are not an oriented manifold (or
/// name a vertex twice, or one that does not exist).
std::optional<Rings> build_rings(const TriMesh& mesh);

}  // namespace planish
