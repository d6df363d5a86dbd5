#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include <planish/core/error.h>
#include <planish/io/read_features.h>
#include <planish/io/read_mesh.h>
#include <planish/mesh/patch.h>

#include "core/math.h"
#include "core/number_text.h"
#include "io/drawn_lines.h"
#include "io/file/file_bytes.h"
#include "io/file/text_cursor.h"
#include "io/formats/formats.h"
#include "io/row_cursor.h"
#include "mesh/cut/edge_paths.h"
#include "mesh/search/nearest_vertex.h"
#include "platform/path.h"

namespace planish {
namespace {

/// Marks the vertices between the corners of a line.
void trace(const LineDrawing::Line& line, std::span<const Index> corners, EdgePaths& paths,
           const TextCursor& cursor, std::vector<unsigned char>& marked) {
  for (std::size_t i = line.begin + 1; i < line.end; ++i) {
    if (corners[i] == corners[i - 1]) continue;
    const auto path = paths.between(corners[i - 1], corners[i]);
    if (!path) {
      cursor.fail_at_line(line.line, ErrorCode::several_components,
                          "the line goes from vertex " + std::to_string(corners[i - 1]) +
                              " of the mesh to vertex " + std::to_string(corners[i]) +
                              ", which is on another part: make it two lines");
    }
    for (const Index v : *path)
      marked[v] = 1;
    if (paths.looks() > k_most_looks) {
      cursor.fail_at_line(line.line, ErrorCode::too_large,
                          "the lines up to this one are too long together: draw more points, so "
                          "that each is near the next");
    }
  }
}

/// Fixes the vertices that a drawing stands for.
FixedVertices snap(const LineDrawing& drawing, const Patch& patch, const TextCursor& cursor) {
  if (patch.triangles().empty()) throw Error(ErrorCode::no_triangles, "the mesh has no triangles");
  std::vector<Vec3> places;
  for (const Index corner : drawing.corners)
    places.push_back(drawing.places[corner]);
  const NearestVertex nearest(patch.mesh(), places);
  FixedVertices fixed;
  std::vector<Index> corners;
  std::vector<unsigned char> marked(patch.vertex_count(), 0);
  for (const Vec3 place : places) {
    const Index v = nearest.of(place);
    const Vec3 apart = patch.positions()[v] - place;
    fixed.farthest = std::max(fixed.farthest, math::hypot(apart.x, apart.y, apart.z));
    corners.push_back(v);
    marked[v] = 1;
  }
  EdgePaths paths(patch);
  for (const LineDrawing::Line& line : drawing.lines)
    trace(line, corners, paths, cursor, marked);
  for (std::size_t v = 0; v < marked.size(); ++v) {
    if (marked[v] != 0) fixed.vertices.push_back(static_cast<Index>(v));
  }
  return fixed;
}

/// Whether the colour of a vertex is another one than that of most of the mesh.
std::vector<unsigned char> painted(const ReadResult& file, const std::string& name) {
  constexpr float k_other = 0.125F;  // of a channel: a soft brush leaves less at its rim
  const auto& colors = file.colors;
  std::vector<std::array<float, 3>> sorted = colors;
  std::sort(sorted.begin(), sorted.end());
  std::size_t most = 0;
  std::array<float, 3> base = {};
  for (auto at = sorted.begin(); at != sorted.end();) {
    const auto end = std::upper_bound(at, sorted.end(), *at);
    const auto count = static_cast<std::size_t>(end - at);
    if (count > most) {
      most = count;
      base = *at;
    }
    at = end;
  }
  if (4 * most < colors.size() || most == 0) {
    throw Error(ErrorCode::malformed_file,
                "no colour covers a quarter of the vertices, so none can be taken for unpainted: "
                "fill the model with one colour, then paint on it",
                {.path = name});
  }
  std::vector<unsigned char> marked;
  for (const auto& color : colors) {
    const bool other = std::abs(color[0] - base[0]) > k_other ||
                       std::abs(color[1] - base[1]) > k_other ||
                       std::abs(color[2] - base[2]) > k_other;
    marked.push_back(other ? 1 : 0);
  }
  return marked;
}

/// The painted vertices of a mesh file.
FixedVertices painted_vertices(const ReadResult& file, const Patch& patch,
                               const std::string& name) {
  if (patch.triangles().empty()) throw Error(ErrorCode::no_triangles, "the mesh has no triangles");
  const std::vector<unsigned char> marked = painted(file, name);
  LineDrawing drawing;
  for (std::size_t v = 0; v < marked.size(); ++v) {
    if (marked[v] == 0) continue;
    drawing.corners.push_back(static_cast<Index>(drawing.places.size()));
    drawing.places.push_back(file.mesh.positions[v]);
  }
  return snap(drawing, patch, TextCursor({}, name));
}

/// Whether the vertices of an OBJ file have colours, and nothing is drawn.
bool is_painted(std::string_view obj, const std::string& name) {
  bool has_colors = false;
  TextCursor cursor(obj, name, {.comments = true, .continuation = true});
  for (; !cursor.at_end(); cursor.next_line()) {
    const std::string_view keyword = cursor.token();
    if (keyword == "l" || keyword == "p") return false;
    if (keyword != "v" || has_colors) continue;
    std::size_t words = 0;
    for (; !cursor.at_line_end(); ++words)
      cursor.token();
    if (words < 6) return false;
    has_colors = true;
  }
  return has_colors;
}

}  // namespace

FixedVertices read_fixed_vertices(const std::filesystem::path& path, const Patch& patch) {
  const FileBytes file(path);
  return parse_fixed_vertices(file.view(), patch, utf8_of(path));
}

FixedVertices parse_fixed_vertices(std::string_view bytes, const Patch& patch,
                                   const std::string& name) {
  const std::string extension = lower_extension(path_of(name));
  const bool is_ply = extension == ".ply";
  if (is_ply || (extension == ".obj" && is_painted(bytes, name))) {
    const ReadResult file =
        parse_mesh(bytes, is_ply ? MeshFormat::ply : MeshFormat::obj, name, {.colors = true});
    if (!file.colors.empty()) return painted_vertices(file, patch, name);
    throw Error(ErrorCode::malformed_file, "not all vertices have colours", {.path = name});
  }
  if (extension == ".obj") {
    TextCursor cursor(bytes, name, {.comments = true, .continuation = true});
    const LineDrawing drawing = parse_line_drawing(cursor);
    return snap(drawing, patch, cursor);
  }
  return {fixed_vertices_in(parse_rows(bytes, name), patch.vertex_count())};
}

std::vector<Index> fixed_vertices_in(const Rows& rows, std::size_t vertex_count) {
  std::vector<Index> vertices;
  for (const Row& row : rows.rows) {
    const std::vector<Index> some = RowCursor(rows, row).vertices(vertex_count);
    vertices.insert(vertices.end(), some.begin(), some.end());
  }
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return vertices;
}

std::vector<double> weights_in(const Rows& rows, std::size_t vertex_count) {
  std::vector<double> weights(vertex_count, 1.0);
  std::vector<std::size_t> row_of(vertex_count, 0);  // 0: not yet named
  for (const Row& row : rows.rows) {
    RowCursor cursor(rows, row);
    const Index v = cursor.vertex(cursor.next("the vertex"), vertex_count);
    const std::string vertex = "vertex " + std::to_string(v);
    if (row_of[v] != 0) {
      cursor.fail(ErrorCode::malformed_file,
                  vertex + " has a weight already, from line " + std::to_string(row_of[v]));
    }
    row_of[v] = row.number;
    const Field& field = cursor.next("the weight");
    const auto weight = field_number(field);
    if (!weight) {
      cursor.fail(ErrorCode::bad_number,
                  in_quotes(field_text(field)) + " is no weight such as 0.5");
    }
    if (!(*weight > 0.0)) {
      cursor.fail(ErrorCode::malformed_file, "the weight of " + vertex + " is " +
                                                 number_text(*weight) + " but must be above 0");
    }
    weights[v] = *weight;
    cursor.end();
  }
  return weights;
}

}  // namespace planish
