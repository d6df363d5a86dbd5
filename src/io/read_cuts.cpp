#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <planish/core/error.h>
#include <planish/io/read_features.h>
#include <planish/mesh/carry.h>
#include <planish/mesh/geodesic.h>

#include "io/drawn_lines.h"
#include "io/file/file_bytes.h"
#include "io/file/text_cursor.h"
#include "io/formats/formats.h"
#include "io/read_drawing.h"
#include "io/row_cursor.h"
#include "mesh/mean_edge.h"
#include "mesh/search/closest_point.h"
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

void check_triangles(const TriMesh& mesh) {
  if (mesh.triangles.empty()) throw Error(ErrorCode::no_triangles, "the mesh has no triangles");
}

/// Triangles that all shortest ways together may look at: some seconds.
constexpr std::size_t k_most_looked_at = 10'000'000;

/// From vertex to vertex, along an edge or the shortest way over the surface.
/// @param looked_at is counted up
SurfaceLine line_through(const Patch& patch, const CutPath& path, std::size_t number,
                         std::size_t& looked_at) {
  const auto refuse = [&](const std::string& message, Index v) {
    SourceLocation place = path.place;
    place.first = v;
    throw Error(ErrorCode::misplaced_cut, "cut " + std::to_string(number + 1) + message, place);
  };
  for (const Index v : path.vertices) {
    if (patch.ring(v).empty())
      refuse(" names vertex " + std::to_string(v) + ", which no triangle uses", v);
  }
  SurfaceLine line = line_along_edges(patch, {path.vertices.data(), 1});
  for (std::size_t i = 1; i < path.vertices.size(); ++i) {
    const std::array ends = {path.vertices[i - 1], path.vertices[i]};
    if (ends[0] == ends[1]) continue;
    const auto ring = patch.ring(ends[0]);
    SurfaceLine part = line_along_edges(patch, ends);
    if (std::find(ring.begin(), ring.end(), ends[1]) == ring.end()) {
      looked_at += patch.triangles().size();
      if (looked_at > k_most_looked_at) {
        throw Error(ErrorCode::too_large,
                    "cut " + std::to_string(number + 1) +
                        " is one too many: name every vertex along the lines, or draw them",
                    path.place);
      }
      part = geodesic(patch, part[0], part[1]).points;
    }
    line.insert(line.end(), part.begin() + 1, part.end());
  }
  if (line.size() < 2) {
    refuse(" has one vertex only, " + std::to_string(path.vertices[0]) + ": it needs two at least",
           path.vertices[0]);
  }
  return line;
}

}  // namespace

CutLinesOnPatch cut_lines_in(const DrawnLines& drawing, const Patch& patch, bool smooth) {
  const ClosestPointTree nearest(patch.mesh());
  constexpr double k_smoothing = 0.5;  // of a mean edge
  const double edge = mean_edge_length(patch.mesh());
  CutLinesOnPatch cuts;
  for (const DrawnLine& line : chained_lines(drawing.lines)) {
    for (const Vec3 p : line.points) {
      const double apart = distance_of(p, nearest.query(p).point);
      cuts.farthest = std::max(cuts.farthest, apart);
      if (apart <= k_most_edges_off * edge) continue;
      throw Error(ErrorCode::misplaced_cut,
                  "the line leaves the mesh at " + point_text(p) +
                      ": that is farther away than three edges; is the drawing in other units?",
                  line.place);
    }
    TracedLines traced =
        trace_lines(patch, {{smooth ? smoothed_line(line, k_smoothing * edge) : line}, {}});
    cuts.outside_length += traced.outside_length;
    for (SurfaceLine& part : traced.lines) {
      cuts.lines.push_back(std::move(part));
      cuts.places.push_back(line.place);
    }
  }
  if (cuts.lines.empty()) {
    const SourceLocation place = drawing.lines.empty() ? SourceLocation{} : drawing.lines[0].place;
    throw Error(ErrorCode::misplaced_cut, "no line of the drawing lies on the mesh",
                {.path = place.path});
  }
  return cuts;
}

CutLines read_cuts(const std::filesystem::path& path, const TriMesh& mesh) {
  const FileBytes file(path);
  return parse_cuts(file.view(), mesh, utf8_of(path));
}

CutLines parse_cuts(std::string_view bytes, const TriMesh& mesh, const std::string& name) {
  check_triangles(mesh);
  if (lower_extension(path_of(name)) != ".obj") return cuts_in(parse_rows(bytes, name), mesh);
  TextCursor cursor(bytes, name, {.comments = true, .continuation = true});
  const LineDrawing drawing = parse_line_drawing(cursor);
  return snap_cuts(drawing, mesh, cursor, name);
}

CutLines cuts_in(const Rows& rows, const TriMesh& mesh) {
  check_triangles(mesh);
  if (rows.rows.empty())
    throw Error(ErrorCode::malformed_file, "the file names no cut", {.path = rows.name, .line = 1});
  CutLines cuts;
  for (const Row& row : rows.rows) {
    RowCursor cursor(rows, row);
    cuts.paths.push_back({cursor.vertices(mesh.positions.size()), cursor.place()});
  }
  return cuts;
}

CutLinesOnPatch cut_lines_in(const Rows& rows, const Patch& patch) {
  const CutLines listed = cuts_in(rows, patch.mesh());
  CutLinesOnPatch cuts;
  std::size_t looked_at = 0;
  for (std::size_t k = 0; k < listed.paths.size(); ++k) {
    cuts.lines.push_back(line_through(patch, listed.paths[k], k, looked_at));
    cuts.places.push_back(listed.paths[k].place);
  }
  return cuts;
}

CutLinesOnPatch read_cut_lines(const std::filesystem::path& path, const Patch& patch, bool smooth) {
  const FileBytes file(path);
  return parse_cut_lines(file.view(), patch, utf8_of(path), smooth);
}

CutLinesOnPatch parse_cut_lines(std::string_view bytes, const Patch& patch, const std::string& name,
                                bool smooth) {
  if (patch.triangles().empty()) throw Error(ErrorCode::no_triangles, "the mesh has no triangles");
  if (lower_extension(path_of(name)) != ".obj") return cut_lines_in(parse_rows(bytes, name), patch);
  const DrawnLines drawing = parse_obj_lines(bytes, name);
  if (drawing.lines.empty()) {
    throw Error(ErrorCode::malformed_file, "the file has no line (l), and points (p) cut nothing",
                {.path = name, .line = 1});
  }
  return cut_lines_in(drawing, patch, smooth);
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
