#pragma once

#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Whether two vertices are at exactly equal places, or two parts reach as far as each other in
/// all directions, to the default length of weld(): without that no sheet of a manifold is doubled.
bool may_be_doubled(const TriMesh& mesh);

/// Triangles that are there already as others of the same or of other pieces, in increasing order.
struct DoubledSheets {
  std::vector<Index> backs;     ///< in the other orientation
  std::vector<Index> repeated;  ///< in the same one
};

/// Finds pieces all of whose triangles are there in other pieces, or in themselves in the other
/// orientation: with the same corners, or as the two triangles on the other diagonal of the same
/// quadrilateral. Corners are the same at exactly equal places, and between parts of equal extent
/// within the default length of weld(). The side with the first triangle is not the double.
/// @param gone triangles that do not count
DoubledSheets find_doubled_sheets(const TriMesh& mesh, std::span<const unsigned char> gone);

}  // namespace planish
