#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <planish/mesh/patch.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// What a page shows of a mesh: some of its vertices, where they are, and triangles over them.
struct DisplayMesh {
  std::vector<Index> source;        ///< vertex here -> vertex of the mesh, increasing
  std::vector<Triangle> triangles;  ///< over the vertices here
};

/// All that triangles use; of meshes with more vertices than `most` and a border about `most`, as
/// coarsen() leaves them, among them all to be kept.
DisplayMesh display_mesh(const Patch& patch, std::size_t most, std::span<const Index> keep);

}  // namespace planish
