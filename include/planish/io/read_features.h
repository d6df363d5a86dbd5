#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include <planish/mesh/carry.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/surface_line.h>
#include <planish/mesh/tri_mesh.h>

namespace planish {

/// A word, or a number that needs no reading.
using Field = std::variant<std::string, std::int64_t, double>;

/// The word, or the number in the shortest digits that read back to it.
std::string field_text(const Field& field);

/// The finite number that a field is, or that its word says before an ending; nothing of others.
std::optional<double> field_number(const Field& field, std::string_view ending = {});

/// What a word has between its commas; a number is one part.
std::vector<Field> field_parts(const Field& field);

/// A row of a list: the fields of one item.
struct Row {
  std::vector<Field> fields;  ///< numbers and words, in order
  std::size_t number = 0;     ///< the line of the file, or which row it is; from 1
};

/// A list of items: the lines of a file divided into fields, or rows that a caller made.
struct Rows {
  std::string name;       ///< the path in errors
  std::vector<Row> rows;  ///< in order
};

/// The words of each line that has any; comments from # to the end of the line.
/// @throws Error file_not_found, file_unreadable; malformed_file for UTF-16 and UTF-32
Rows read_rows(const std::filesystem::path& path);

/// The same from memory.
/// @param name used as the path in errors
Rows parse_rows(std::string_view bytes, const std::string& name);

/// The vertices of a mesh that a file says are to stay where they are.
struct FixedVertices {
  std::vector<Index> vertices;  ///< in increasing order, each once
  double farthest = 0.0;        ///< of the file's points from their vertices; model units
};

/// Reads which vertices of a mesh are fixed. An OBJ file (by its extension) draws them: every point
/// of its lines (l) and points (p) stands for the nearest vertex that triangles use, the smallest
/// number where several are, and the vertices of a line are joined by shortest paths along the
/// edges. In an OBJ file without lines and points, or a PLY file, they are painted: vertices whose
/// colour is another than that of most vertices stand for the nearest ones. Any other file lists
/// numbers of vertices, from 0, with blanks or commas between them and comments from # to the end
/// of the line.
/// @throws Error file_not_found, file_unreadable, malformed_file, truncated_file, bad_number,
///   non_finite_coordinate, index_out_of_range, too_large, several_components for a line that no
///   edges join; the place has path and line. Also, without a place, no_triangles
FixedVertices read_fixed_vertices(const std::filesystem::path& path, const Patch& patch);

/// The same from memory.
/// @param name used as the path in errors; its extension says which format `bytes` have
FixedVertices parse_fixed_vertices(std::string_view bytes, const Patch& patch,
                                   const std::string& name);

/// The vertices that rows list, with commas or without, in increasing order, each once.
/// @throws Error bad_number, index_out_of_range; the place is that of the row
std::vector<Index> fixed_vertices_in(const Rows& rows, std::size_t vertex_count);

/// Weights of vertices: of each row the number of a vertex, from 0, and its weight, a number above
/// 0. The others have weight 1.
/// @return one for each vertex
/// @throws Error malformed_file (also for a vertex that comes twice and a weight that is not above
///   0), bad_number, index_out_of_range; the place is that of the row
std::vector<double> weights_in(const Rows& rows, std::size_t vertex_count);

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
/// @param name used as the path in errors; its extension says which format `bytes` have
CutLines parse_cuts(std::string_view bytes, const TriMesh& mesh, const std::string& name);

/// The cuts that rows list: each the numbers of its vertices, from 0, with commas or without.
/// @throws Error bad_number, index_out_of_range; malformed_file where there are none; no_triangles
CutLines cuts_in(const Rows& rows, const TriMesh& mesh);

/// Lines on a patch that a file draws or lists.
struct CutLinesOnPatch {
  std::vector<SurfaceLine> lines;      ///< in the order of the file
  std::vector<SourceLocation> places;  ///< of each line, where the file has it
  double farthest = 0.0;               ///< of drawn points from the patch; model units
  double outside_length = 0.0;         ///< of drawn lines that lie off the patch; model units
};

/// Reads the lines that a patch is to be cut along, through triangles. An OBJ file draws them
/// (trace_lines()); lines that it has edge by edge are chained. Any other file lists vertices, as
/// read_cuts() reads it: those that no edge joins are joined by a shortest way.
/// @param smooth whether drawn lines are made fair: smoothed_line() by half a mean edge
/// @throws Error as read_cuts(), misplaced_cut also for a drawing none of which lies on the patch
CutLinesOnPatch read_cut_lines(const std::filesystem::path& path, const Patch& patch,
                               bool smooth = true);

/// The same of lines that were drawn.
/// @throws Error misplaced_cut for a point that is farther from the patch than three mean edges,
/// and
///   where no line lies on it; as trace_lines()
CutLinesOnPatch cut_lines_in(const DrawnLines& drawing, const Patch& patch, bool smooth = true);

/// Which edges of a model file are lines.
enum class ModelLines {
  texture,    ///< those at which the texture of an OBJ file is elsewhere on one side than the other
  groups,     ///< between its objects, else its groups, else its materials
  materials,  ///< between its materials
};

/// Edges of a model file, in its coordinates, each a line of two points.
/// @throws Error as read_mesh(); misplaced_cut where there are none
DrawnLines read_model_lines(const std::filesystem::path& path, ModelLines lines);

/// Those that rows list, as cuts_in() takes them.
CutLinesOnPatch cut_lines_in(const Rows& rows, const Patch& patch);

/// The same from memory.
/// @param name used as the path in errors; its extension says which format `bytes` have
CutLinesOnPatch parse_cut_lines(std::string_view bytes, const Patch& patch, const std::string& name,
                                bool smooth = true);

/// Such a file for paths with every vertex, a cut a line.
std::string format_cuts(std::span<const std::vector<Index>> paths);

}  // namespace planish
