#include <algorithm>
#include <cstddef>
#include <utility>

#include <planish/core/error.h>
#include <planish/pattern/read_annotations.h>

#include "io/drawn_lines.h"
#include "io/file/file_bytes.h"
#include "io/file/text_cursor.h"
#include "io/read_drawing.h"
#include "mesh/mean_edge.h"
#include "mesh/search/closest_point.h"
#include "platform/path.h"

namespace planish {

namespace {

/// A point of a drawing that is drawn there as often as lines go through it.
struct DrawnPoint {
  Vec3 at;
  SourceLocation place;
};

/// Of lines and points, each once, in the order of the file.
std::vector<DrawnPoint> points_in(std::string_view bytes, const std::string& name) {
  TextCursor cursor(bytes, name, {.comments = true, .continuation = true});
  const LineDrawing drawing = parse_line_drawing(cursor);
  std::vector<unsigned char> seen(drawing.places.size(), 0);
  std::vector<DrawnPoint> points;
  for (std::size_t i = 0; i < drawing.corners.size(); ++i) {
    const Index corner = drawing.corners[i];
    if (seen[corner] == 0) {
      points.push_back({drawing.places[corner], {.path = name, .line = drawing.line_of_corner[i]}});
    }
    seen[corner] = 1;
  }
  return points;
}

/// Refuses a point that is too far from its place.
class Reach {
 public:
  Reach(const Patch& patch, ErrorCode code, std::string what)
      : most_(k_most_edges_off * mean_edge_length(patch.mesh())),
        code_(code),
        what_(std::move(what)) {}

  double check(Vec3 drawn, Vec3 found, const SourceLocation& place) const {
    const double apart = distance_of(drawn, found);
    if (apart <= most_) return apart;
    throw Error(code_,
                "what is drawn at " + point_text(drawn) + " is farther than three edges from " +
                    what_ + ": the nearest place is " + point_text(found) +
                    "; is the drawing in other units?",
                place);
  }

 private:
  double most_;
  ErrorCode code_;
  std::string what_;
};

void check_triangles(const Patch& patch) {
  if (patch.triangles().empty()) throw Error(ErrorCode::no_triangles, "the mesh has no triangles");
}

/// The nearest place of the border to a point.
struct BorderPlace {
  Notch notch;
  Vec3 point;
};

/// Finds places on the border, whose edges are triangles without area to the tree.
class BorderPlaces {
 public:
  /// @pre the patch has a border
  explicit BorderPlaces(const Patch& patch)
      : patch_(patch), edges_(edges_of(patch)), tree_(edges_) {}

  /// Of several equally near edges the first along the border.
  BorderPlace nearest(Vec3 p) const {
    const ClosestPoint closest = tree_.query(patch_.unit_scale() * p);
    const Triangle& edge = edges_.triangles[closest.triangle];
    const double share = 1.0 - closest.barycentric[0];
    return {Notch::on_edge(edge[0], edge[1], share),
            (1.0 - share) * patch_.positions()[edge[0]] + share * patch_.positions()[edge[1]]};
  }

 private:
  static TriMesh edges_of(const Patch& patch) {
    TriMesh edges;
    edges.positions.reserve(patch.vertex_count());
    for (const Vec3 p : patch.positions())
      edges.positions.push_back(patch.unit_scale() * p);
    for (const std::vector<Index>& loop : patch.border_loops()) {
      for (std::size_t i = 0; i < loop.size(); ++i) {
        const Index to = loop[(i + 1) % loop.size()];
        edges.triangles.push_back({loop[i], to, to});
      }
    }
    return edges;
  }

  const Patch& patch_;
  TriMesh edges_;  // in coordinates of about 1
  ClosestPointTree tree_;
};

Mark mark_at(const ClosestPoint& closest, const Patch& patch) {
  const Triangle& corners = patch.triangles()[closest.triangle];
  const auto& shares = closest.barycentric;
  const auto nearest = std::max_element(shares.begin(), shares.end()) - shares.begin();
  return {corners[static_cast<std::size_t>(nearest)], MarkKind::cross,
          SurfacePoint{corners, shares}};
}

/// Of what the file at a path draws.
template <class Parse>
DrawnAnnotations parsed(const std::filesystem::path& path, const Patch& patch, Parse parse) {
  const FileBytes file(path);
  return parse(file.view(), patch, utf8_of(path));
}

}  // namespace

DrawnAnnotations parse_drawn_notches(std::string_view bytes, const Patch& patch,
                                     const std::string& name) {
  check_triangles(patch);
  const Reach reach(patch, ErrorCode::misplaced_notch, "the border");
  if (patch.border_loops().empty()) {
    throw Error(ErrorCode::misplaced_notch, "the mesh has no border that a notch could be on",
                {.path = name});
  }
  const BorderPlaces border(patch);
  DrawnAnnotations drawn;
  for (const DrawnPoint& point : points_in(bytes, name)) {
    const BorderPlace nearest = border.nearest(point.at);
    drawn.farthest = std::max(drawn.farthest, reach.check(point.at, nearest.point, point.place));
    drawn.notches.push_back(nearest.notch);
  }
  return drawn;
}

DrawnAnnotations parse_drawn_marks(std::string_view bytes, const Patch& patch,
                                   const std::string& name) {
  check_triangles(patch);
  const Reach reach(patch, ErrorCode::misplaced_mark, "the mesh");
  const ClosestPointTree tree(patch.mesh());
  DrawnAnnotations drawn;
  for (const DrawnPoint& point : points_in(bytes, name)) {
    const ClosestPoint closest = tree.query(point.at);
    drawn.farthest = std::max(drawn.farthest, reach.check(point.at, closest.point, point.place));
    drawn.marks.push_back(mark_at(closest, patch));
  }
  return drawn;
}

DrawnAnnotations parse_drawn_lines(std::string_view bytes, const Patch& patch,
                                   const std::string& name) {
  check_triangles(patch);
  const DrawnLines lines = parse_obj_lines(bytes, name);
  if (lines.lines.empty()) {
    throw Error(ErrorCode::malformed_file,
                "the file has no line (l), and points (p) are no inner lines",
                {.path = name, .line = 1});
  }
  const Reach reach(patch, ErrorCode::misplaced_mark, "the mesh");
  const ClosestPointTree tree(patch.mesh());
  DrawnAnnotations drawn;
  for (const DrawnLine& line : lines.lines) {
    for (const Vec3 p : line.points)
      drawn.farthest = std::max(drawn.farthest, reach.check(p, tree.query(p).point, line.place));
  }
  TracedLines traced = trace_lines(patch, {lines.lines, {}});
  drawn.lines = std::move(traced.lines);
  drawn.outside_length = traced.outside_length;
  return drawn;
}

DrawnAnnotations read_drawn_notches(const std::filesystem::path& path, const Patch& patch) {
  return parsed(path, patch, parse_drawn_notches);
}

DrawnAnnotations read_drawn_marks(const std::filesystem::path& path, const Patch& patch) {
  return parsed(path, patch, parse_drawn_marks);
}

DrawnAnnotations read_drawn_lines(const std::filesystem::path& path, const Patch& patch) {
  return parsed(path, patch, parse_drawn_lines);
}

}  // namespace planish
