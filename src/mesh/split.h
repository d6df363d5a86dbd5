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

/// Divides a mesh into patches, one for every name: its triangles in their order, also none.
/// Positions keep their bits. Linear time but for sorting vertices.
/// @param of_triangle the number of a name for each triangle
/// @throws Error index_out_of_range for a triangle that names a vertex the mesh has not
std::vector<NamedPatch> split(const TriMesh& mesh, std::span<const Index> of_triangle,
                              std::span<const std::string> names);

/// The connected parts of a mesh as patches: one is called `name`, several "NAME-1", ...
std::vector<NamedPatch> split(const TriMesh& mesh, const std::string& name);

/// "NAME" of one part, "NAME-1", "NAME-2", ... of several.
std::vector<std::string> numbered_names(const std::string& name, std::size_t count);

/// The names with a number behind those that are there already, whatever their capitals: "Front",
/// "front-2".
std::vector<std::string> distinct_names(std::span<const std::string> names);

}  // namespace planish
