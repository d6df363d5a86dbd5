#pragma once

#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <planish/mesh/cut.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Lines that a file says a mesh is to be cut along.
struct CutLines {
  std::vector<CutPath> paths;  ///< with the path and line of the file
  double farthest = 0.0;       ///< of the file's points from their vertices; model units
};

/// Reads where a mesh is to be cut open. An OBJ file (by its extension) draws it: every point of
/// its lines (l) stands for the nearest vertex that triangles use, the smallest number where
/// several are. Any other file has a cut a line: numbers of vertices, from 0, with blanks or commas
/// between them and comments from # to the end of the line.
/// @throws Error file_not_found, file_unreadable, malformed_file, truncated_file, bad_number,
///   non_finite_coordinate, index_out_of_range, too_large, misplaced_cut for a point that is
///   farther from its vertex than three mean edges; the place has path and line. Also, without a
///   place, no_triangles
CutLines read_cuts(const std::filesystem::path& path, const TriMesh& mesh);

/// The same from memory.
/// @param name stands for the path in errors, and its extension tells what `bytes` are
CutLines parse_cuts(std::string_view bytes, const TriMesh& mesh, const std::string& name);

/// Such a file for paths with every vertex, a cut a line.
std::string format_cuts(std::span<const std::vector<Index>> paths);

}  // namespace planish
