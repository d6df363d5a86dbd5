#pragma once

#include <span>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// The vertex of the smallest number at the exact place of each vertex.
std::vector<Index> first_at_place(const std::vector<Vec3>& positions);

/// Whether two vertices are at exactly equal places.
bool has_equal_places(const TriMesh& mesh);

/// Triangles of the back sides of pieces all of whose triangles are there in both orientations, at
/// exactly equal places. The side with the piece's first triangle is not its back.
/// @param gone triangles that do not count
std::vector<Index> backs_of_doubled_sheets(const TriMesh& mesh,
                                           std::span<const unsigned char> gone);

}  // namespace planish
