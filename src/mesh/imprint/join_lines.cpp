#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include <planish/mesh/carry.h>
#include <planish/mesh/surface_line.h>

#include "geometry/box.h"
#include "mesh/imprint/shared_triangle.h"
#include "mesh/mean_edge.h"

namespace planish {

namespace {

/// A place on a straight part of something.
struct Nearest {
  Vec3 place;
  double distance = std::numeric_limits<double>::infinity();
  std::optional<std::size_t> line = {};  ///< none: the border
  std::size_t end = 0;                   ///< of the line: the point that the segment ends in
  double share = 0.0;                    ///< of the way along the segment

  /// Takes the nearest place of a segment where it is nearer.
  void look(Vec3 p, Vec3 a, Vec3 b, std::optional<std::size_t> of, std::size_t segment_end) {
    const Vec3 along = b - a;
    const double length = dot(along, along);
    const double along_share =
        length > 0.0 ? std::clamp(dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    const Vec3 at = a + along_share * along;
    if (norm(p - at) < distance) *this = {at, norm(p - at), of, segment_end, along_share};
  }
};

class Joiner {
 public:
  Joiner(const Patch& patch, std::vector<SurfaceLine> lines, double tolerance)
      : patch_(patch), scale_(patch.unit_scale()), tolerance_(scale_ * tolerance) {
    result_.lines = std::move(lines);
    places_.resize(result_.lines.size());
    boxes_.resize(result_.lines.size());
    for (std::size_t l = 0; l < places_.size(); ++l)
      locate(l);
  }

  JoinedLines joined() {
    for (std::size_t l = 0; l < places_.size(); ++l) {
      if (places_[l].size() < 2 || places_[l].front() == places_[l].back()) continue;
      for (const bool is_last : {false, true})
        join(l, is_last);
    }
    return std::move(result_);
  }

 private:
  static constexpr double k_same_place = 1e-9;

  bool is_on_border(const SurfacePoint& point) const {
    const std::vector<Index> carriers = carriers_of(point);
    if (carriers.size() == 1) return patch_.is_border(carriers[0]);
    if (carriers.size() == 3 || !patch_.is_border(carriers[0])) return false;
    const auto ring = patch_.ring(carriers[0]);
    return ring.front() == carriers[1] || ring.back() == carriers[1];
  }

  void look_at_line(std::size_t l, std::size_t own, Vec3 end, bool is_last,
                    Nearest& nearest) const {
    if (l != own && are_apart(boxes_[l], {end, end}, tolerance_)) return;
    const std::vector<Vec3>& places = places_[l];
    double along = 0.0;  // of the own line, what is near the end is the end itself
    for (std::size_t i = 1; i < places.size(); ++i) {
      const std::size_t k = is_last ? places.size() - i : i;
      along += norm(places[k] - places[k - 1]);
      if (l != own || along > 4.0 * tolerance_) nearest.look(end, places[k - 1], places[k], l, k);
    }
  }

  void join(std::size_t l, bool is_last) {
    const SurfacePoint& point = is_last ? result_.lines[l].back() : result_.lines[l].front();
    if (is_on_border(point)) return;
    const Vec3 end = is_last ? places_[l].back() : places_[l].front();
    Nearest line, border;
    for (std::size_t other = 0; other < places_.size(); ++other)
      look_at_line(other, l, end, is_last, line);
    if (line.distance <= k_same_place) return;
    for (const auto& loop : patch_.border_loops()) {
      for (std::size_t k = 0; k < loop.size(); ++k) {
        border.look(end, scale_ * patch_.positions()[loop[k]],
                    scale_ * patch_.positions()[loop[(k + 1) % loop.size()]], std::nullopt, 0);
      }
    }
    const Nearest& nearest = line.distance <= border.distance ? line : border;
    if (!(nearest.distance <= tolerance_)) return;
    if (!lead_on(l, is_last, end, nearest)) return;
    result_.joined.push_back({l, is_last, nearest.distance / scale_, nearest.line});
  }

  /// Adds the way over the mesh to a place, if there is a short one.
  bool lead_on(std::size_t l, bool is_last, Vec3 end, const Nearest& nearest) {
    const DrawnLine drawn{{(1.0 / scale_) * end, (1.0 / scale_) * nearest.place}};
    TracedLines traced = trace_lines(patch_, {{drawn}, {}});
    if (traced.lines.size() != 1) return false;
    SurfaceLine way = std::move(traced.lines.front());
    if (scale_ * length_of(way, patch_.positions()) > 2.0 * nearest.distance + k_same_place)
      return false;
    // By rounding the traced way may begin beside a vertex on another triangle.
    const SurfacePoint& from = is_last ? result_.lines[l].back() : result_.lines[l].front();
    if (shared_triangle(patch_, from, way[1])) {
      way.front() = from;
    } else {
      way.insert(way.begin(), from);
    }
    if (nearest.line) {
      const SurfaceLine& line = result_.lines[*nearest.line];
      const auto point =
          point_between(patch_, line[nearest.end - 1], line[nearest.end], nearest.share);
      if (!point || !shared_triangle(patch_, way[way.size() - 2], *point)) return false;
      way.back() = *point;
      SurfaceLine& other = result_.lines[*nearest.line];
      other.insert(other.begin() + static_cast<std::ptrdiff_t>(nearest.end), *point);
      locate(*nearest.line);
    } else if (!is_on_border(way.back())) {
      return false;
    }
    SurfaceLine& line = result_.lines[l];
    if (is_last) {
      line.insert(line.end(), way.begin() + 1, way.end());
    } else {
      line.insert(line.begin(), way.rbegin(), way.rend() - 1);
    }
    locate(l);
    return true;
  }

  void locate(std::size_t l) {
    places_[l].clear();
    boxes_[l] = {};
    for (const SurfacePoint& point : result_.lines[l])
      places_[l].push_back(scale_ * position_of(point, patch_.positions()));
    for (const Vec3 p : places_[l])
      boxes_[l].add(p);
  }

  const Patch& patch_;
  double scale_, tolerance_;
  JoinedLines result_;
  std::vector<std::vector<Vec3>> places_;
  std::vector<Box> boxes_;
};

}  // namespace

JoinedLines join_lines(const Patch& patch, std::vector<SurfaceLine> lines, double tolerance) {
  return Joiner(patch, std::move(lines), tolerance).joined();
}

double join_tolerance(const TriMesh& mesh) {
  constexpr double of_diagonal = 0.005, of_edge = 1.5;
  return std::max(of_diagonal * bounding_box_diagonal(mesh), of_edge * mean_edge_length(mesh));
}

}  // namespace planish
