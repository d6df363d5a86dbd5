#pragma once

#include <planish/mesh/repair.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// The mesh as it is, with itself as the source.
/// @throws Error index_out_of_range, non_finite_coordinate
RepairedMesh unchanged(const TriMesh& mesh);

/// What unchanged() refuses.
void require_entries(const TriMesh& mesh);

}  // namespace planish
