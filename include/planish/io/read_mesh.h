#pragma once

#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <planish/core/unit.h>
#include <planish/io/mesh_format.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// The parts that a file divides its triangles into: the objects, groups or materials of an OBJ
/// file, the values of a number of the faces of a PLY file.
struct FaceGroups {
  std::string kind;                ///< what they are in the file, as in "usemtl"; empty for none
  std::vector<std::string> names;  ///< in the order of the first triangle of each, all different
  std::vector<Index> of_triangle;  ///< one number of a name per triangle; empty for none
};

/// The unit of length that a comment of a file says it is in, as SketchUp's "# File units =
/// inches".
struct StatedUnit {
  Unit unit;             ///< of the coordinates
  std::string words;     ///< of the comment, printable
  std::size_t line = 0;  ///< from 1; 0 in the header of a binary STL file
};

/// A mesh as the file has it, and what the reader did that a user may want to know.
struct ReadResult {
  TriMesh mesh;                    ///< vertices in the order of the file; finite, indices in range
  MeshFormat format;               ///< of the file
  std::vector<std::string> notes;  ///< "welded 2280 corners to 401 vertices", ...
  FaceGroups groups = {};          ///< objects, else groups; none where the file has fewer than two
  FaceGroups materials = {};       ///< of an OBJ file; none where it has fewer than two
  /// None where no comment before the first vertex says it, or two disagree.
  std::optional<StatedUnit> unit = {};
  /// Red, green and blue of each vertex of an OBJ or PLY file, 0 to 1, where options ask for them;
  /// empty where a vertex has none.
  std::vector<std::array<float, 3>> colors = {};
};

/// How much of what is harmless is mended.
struct ReadOptions {
  bool strict = false;  ///< refuses what is otherwise mended with a note, as a corner named twice
  bool colors = false;  ///< keeps the colours of vertices
};

/// Reads an OBJ, PLY, STL or OFF file. Polygons are divided into triangles inside themselves, quads
/// by the Delaunay diagonal (docs/formats.md); STL corners at exactly equal places become one
/// vertex, in the order of their first use; a corner that a polygon names twice in a row is
/// dropped; nothing else is welded, dropped or reordered. Time and memory are about linear in the
/// size of the file, whatever counts it claims.
/// @throws Error file_not_found, file_unreadable, unsupported_format, malformed_file,
///   truncated_file, bad_number, non_finite_coordinate, index_out_of_range, no_triangles,
///   too_large; the place has path and line (text) or byte (binary)
ReadResult read_mesh(const std::filesystem::path& path, const ReadOptions& options = {});

/// The unit that read_mesh() would tell, without reading the mesh.
/// @throws Error file_not_found, file_unreadable, unsupported_format
std::optional<StatedUnit> read_stated_unit(const std::filesystem::path& path);

/// The same as read_mesh() from memory. Nothing outside `bytes` is looked at.
/// @param name stands for the path in errors
ReadResult parse_mesh(std::string_view bytes, MeshFormat format, const std::string& name = {},
                      const ReadOptions& options = {});

}  // namespace planish
