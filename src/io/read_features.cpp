#include <algorithm>
#include <span>
#include <utility>

#include <planish/core/error.h>
#include <planish/io/read_features.h>
#include <planish/mesh/patch.h>

#include "core/math.h"
#include "core/number_text.h"
#include "io/drawn_lines.h"
#include "io/file/file_bytes.h"
#include "io/file/text_cursor.h"
#include "io/formats/formats.h"
#include "mesh/cut/edge_paths.h"
#include "mesh/search/nearest_vertex.h"
#include "platform/path.h"

namespace planish {
namespace {

/// The numbers of a list.
std::vector<Index> parse_list(std::string_view bytes, std::string_view name,
                              std::size_t vertex_count) {
  TextCursor cursor(bytes, name, {.comments = true});
  std::vector<Index> vertices;
  while (cursor.skip_to_token()) {
    std::string_view words = cursor.token();
    while (!words.empty()) {
      const std::size_t comma = std::min(words.find(','), words.size());
      if (comma > 0) {
        vertices.push_back(vertex_named(words.substr(0, comma), vertex_count, cursor));
      }
      words.remove_prefix(std::min(comma + 1, words.size()));
    }
  }
  return vertices;
}

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

}  // namespace

FixedVertices read_fixed_vertices(const std::filesystem::path& path, const Patch& patch) {
  const FileBytes file(path);
  return parse_fixed_vertices(file.view(), patch, utf8_of(path));
}

FixedVertices parse_fixed_vertices(std::string_view bytes, const Patch& patch,
                                   const std::string& name) {
  if (lower_extension(path_of(name)) == ".obj") {
    TextCursor cursor(bytes, name, {.comments = true, .continuation = true});
    const LineDrawing drawing = parse_line_drawing(cursor);
    return snap(drawing, patch, cursor);
  }
  std::vector<Index> vertices = parse_list(bytes, name, patch.vertex_count());
  std::sort(vertices.begin(), vertices.end());
  vertices.erase(std::unique(vertices.begin(), vertices.end()), vertices.end());
  return {std::move(vertices)};
}

std::vector<double> read_weights(const std::filesystem::path& path, const TriMesh& mesh) {
  const FileBytes file(path);
  return parse_weights(file.view(), mesh, utf8_of(path));
}

std::vector<double> parse_weights(std::string_view bytes, const TriMesh& mesh,
                                  const std::string& name) {
  const std::size_t count = mesh.positions.size();
  std::vector<double> weights(count, 1.0);
  std::vector<std::size_t> line_of(count, 0);  // 0: not yet named
  TextCursor cursor(bytes, name, {.comments = true});
  while (cursor.skip_to_token()) {
    const Index v = vertex_named(cursor.token(), count, cursor);
    if (line_of[v] != 0) {
      cursor.fail(ErrorCode::malformed_file, "vertex " + std::to_string(v) +
                                                 " has a weight already, from line " +
                                                 std::to_string(line_of[v]));
    }
    line_of[v] = cursor.line();
    weights[v] = cursor.number(ErrorCode::bad_number);
    if (!(weights[v] > 0.0)) {
      cursor.fail(ErrorCode::malformed_file, "the weight of vertex " + std::to_string(v) + " is " +
                                                 number_text(weights[v]) + " but must be above 0");
    }
    if (!cursor.at_line_end()) {
      cursor.fail(
          ErrorCode::malformed_file,
          "a line has one vertex and its weight; more follows: " + in_quotes(cursor.token()));
    }
  }
  return weights;
}

}  // namespace planish
