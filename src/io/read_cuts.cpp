#include <algorithm>
#include <utility>

#include <planish/core/error.h>
#include <planish/io/read_features.h>

#include "io/drawn_lines.h"
#include "io/file/file_bytes.h"
#include "io/file/text_cursor.h"
#include "io/formats/formats.h"
#include "mesh/mean_edge.h"
#include "mesh/search/nearest_vertex.h"
#include "platform/path.h"

namespace planish {
namespace {

CutLines snap_cuts(const LineDrawing& drawing, const TriMesh& mesh, const TextCursor& cursor,
                   const std::string& name) {
  if (drawing.lines.empty()) {
    cursor.fail_at_line(1, ErrorCode::malformed_file,
                        "the file has no line (l), and points (p) cut nothing");
  }
  const NearestVertex nearest(mesh, drawing.places);
  const double most = k_most_edges_off * mean_edge_length(mesh);
  CutLines cuts;
  for (const LineDrawing::Line& line : drawing.lines) {
    CutPath& path = cuts.paths.emplace_back(CutPath{{}, {.path = name, .line = line.line}});
    for (std::size_t i = line.begin; i < line.end; ++i) {
      const Vec3 place = drawing.places[drawing.corners[i]];
      const Index v = nearest.of(place);
      const double apart = distance_of(place, mesh.positions[v]);
      if (!(apart <= most)) {
        cursor.fail_at_line(
            line.line, ErrorCode::misplaced_cut,
            "cut " + std::to_string(cuts.paths.size()) + " leaves the mesh at " +
                point_text(place) + ": the nearest vertex, " + std::to_string(v) + " at " +
                point_text(mesh.positions[v]) +
                ", is farther away than three edges; is the drawing in other units?");
      }
      cuts.farthest = std::max(cuts.farthest, apart);
      path.vertices.push_back(v);
    }
  }
  return cuts;
}

CutLines listed_cuts(std::string_view bytes, const std::string& name, std::size_t vertex_count) {
  TextCursor cursor(bytes, name, {.comments = true});
  CutLines cuts;
  while (cursor.skip_to_token()) {
    CutPath& path = cuts.paths.emplace_back(CutPath{{}, {.path = name, .line = cursor.line()}});
    while (!cursor.at_line_end()) {
      std::string_view words = cursor.token();
      while (!words.empty()) {
        const std::size_t comma = std::min(words.find(','), words.size());
        if (comma > 0) {
          path.vertices.push_back(vertex_named(words.substr(0, comma), vertex_count, cursor));
        }
        words.remove_prefix(std::min(comma + 1, words.size()));
      }
    }
  }
  if (cuts.paths.empty()) {
    cursor.fail_at_line(1, ErrorCode::malformed_file, "the file names no cut");
  }
  return cuts;
}

}  // namespace

CutLines read_cuts(const std::filesystem::path& path, const TriMesh& mesh) {
  const FileBytes file(path);
  return parse_cuts(file.view(), mesh, utf8_of(path));
}

CutLines parse_cuts(std::string_view bytes, const TriMesh& mesh, const std::string& name) {
  if (mesh.triangles.empty()) throw Error(ErrorCode::no_triangles, "the mesh has no triangles");
  if (lower_extension(path_of(name)) != ".obj")
    return listed_cuts(bytes, name, mesh.positions.size());
  TextCursor cursor(bytes, name, {.comments = true, .continuation = true});
  const LineDrawing drawing = parse_line_drawing(cursor);
  return snap_cuts(drawing, mesh, cursor, name);
}

std::string format_cuts(std::span<const std::vector<Index>> paths) {
  std::string text;
  for (const auto& path : paths) {
    for (std::size_t i = 0; i < path.size(); ++i)
      text += (i == 0 ? "" : " ") + std::to_string(path[i]);
    text += "\n";
  }
  return text;
}

}  // namespace planish
