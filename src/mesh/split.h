#pragma once

#include <span>
#include <string>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// One patch of a mesh that holds several.
struct NamedPatch {
  std::string name;
  TriMesh mesh;                 ///< only the vertices that its triangles use, in their order
  std::vector<Index> vertices;  ///< of the patch -> number in the whole mesh
};

/// Divides a mesh into patches: one for every group, and where triangles of a group do not hang
/// together by edges, one for every piece that does. Patches come in the order of the groups,
/// pieces of a group in the order of their first triangles. A group of one piece gives its name,
/// one of several "NAME-1", "NAME-2", ... Positions keep their bits. Linear time but for sorting
/// edges.
/// @param of_triangle the group of each triangle, below the number of names
/// @throws Error index_out_of_range for a triangle that names a vertex the mesh has not
std::vector<NamedPatch> split(const TriMesh& mesh, std::span<const Index> of_triangle,
                              std::span<const std::string> names);

/// The same for a mesh without groups: one piece is called `name`, several "NAME-1", ...
std::vector<NamedPatch> split(const TriMesh& mesh, const std::string& name);

}  // namespace planish
