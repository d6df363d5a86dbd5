#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include <planish/io/mesh_format.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// The parts that a file divides its triangles into: the groups, objects or materials of an OBJ
/// file, the values of a number of the faces of a PLY file.
struct FaceGroups {
  std::string kind;                ///< what they are in the file, as in "usemtl"; empty for none
  std::vector<std::string> names;  ///< in the order of the first triangle of each, all different
  std::vector<Index> of_triangle;  ///< one number of a name per triangle; empty for none
};

/// A mesh as the file has it, and what the reader did that a user may want to know.
struct ReadResult {
  TriMesh mesh;                    ///< vertices in the order of the file; finite, indices in range
  MeshFormat format;               ///< of the file
  std::vector<std::string> notes;  ///< "welded 2280 corners to 401 vertices", ...
  FaceGroups groups = {};          ///< none where the file has fewer than two
};

/// Reads an OBJ, PLY, STL or OFF file. Polygons are split into fans; STL corners at exactly equal
/// places become one vertex, in the order of their first use; nothing else is welded, dropped or
/// reordered. Time and memory are linear in the size of the file, whatever counts it claims.
/// @throws Error file_not_found, file_unreadable, unsupported_format, malformed_file,
///   truncated_file, bad_number, non_finite_coordinate, index_out_of_range, no_triangles,
///   too_large; the place has path and line (text) or byte (binary)
ReadResult read_mesh(const std::filesystem::path& path);

/// The same from memory. Nothing outside `bytes` is looked at.
/// @param name stands for the path in errors
ReadResult parse_mesh(std::string_view bytes, MeshFormat format, const std::string& name = {});

}  // namespace planish
