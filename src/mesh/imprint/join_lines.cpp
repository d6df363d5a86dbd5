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
  std::size_t loop = 0;                  ///< of the border
  std::size_t end = 0;                   ///< the point that the segment ends in
  double share = 0.0;                    ///< of the way along the segment

  /// Takes the nearest place of a segment where it is nearer.
  void look(Vec3 p, Vec3 a, Vec3 b, const Nearest& of) {
    const Vec3 along = b - a;
    const double length = dot(along, along);
    const double along_share =
        length > 0.0 ? std::clamp(dot(p - a, along) / length, 0.0, 1.0) : 0.0;
    const Vec3 at = a + along_share * along;
    if (norm(p - at) < distance) *this = {at, norm(p - at), of.line, of.loop, of.end, along_share};
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
    for (const auto& loop : patch.border_loops()) {
      std::vector<Vec3>& places = borders_.emplace_back();
      for (const Index v : loop)
        places.push_back(scale_ * patch.positions()[v]);
      places.push_back(places.front());
    }
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
    const bool is_bounded = std::isfinite(nearest.distance);
    if (l != own && is_bounded && are_apart(boxes_[l], {end, end}, nearest.distance)) return;
    const std::vector<Vec3>& places = places_[l];
    double along = 0.0;  // of the own line, what is near the end is the end itself
    for (std::size_t i = 1; i < places.size(); ++i) {
      const std::size_t k = is_last ? places.size() - i : i;
      along += norm(places[k] - places[k - 1]);
      if (l != own || along > 4.0 * tolerance_)
        nearest.look(end, places[k - 1], places[k], {{}, 0.0, l, 0, k});
    }
  }

  Nearest nearest_to(std::size_t l, bool is_last, Vec3 end) const {
    Nearest border;
    for (std::size_t loop = 0; loop < borders_.size(); ++loop) {
      for (std::size_t k = 1; k < borders_[loop].size(); ++k)
        border.look(end, borders_[loop][k - 1], borders_[loop][k],
                    {{}, 0.0, std::nullopt, loop, k});
    }
    Nearest line;  // goes before the border where they meet
    line.distance = std::nextafter(border.distance, 1e300);
    for (std::size_t other = 0; other < places_.size(); ++other) {
      if (other != l) look_at_line(other, l, end, is_last, line);
    }
    Nearest own;
    look_at_line(l, l, end, is_last, own);
    if (own.distance <= tolerance_ && own.distance < line.distance) return own;
    return line.line ? line : border;
  }

  /// Where a line ends nearly parallel to its neighbour, it joins that one farther ahead: the
  /// shortest connection would be a step across.
  Nearest ahead(std::size_t l, bool is_last, const Nearest& nearest) const {
    constexpr double run = 6.0, towards = 0.5, beside = 0.7;
    const std::vector<Vec3>& places = places_[l];
    const auto from_end = [&](std::size_t i) {
      return places[is_last ? places.size() - 1 - i : i];
    };
    const Vec3 end = from_end(0), way = nearest.place - end;
    std::size_t back = 1;
    while (back + 1 < places.size() && norm(from_end(back) - end) < 2.0 * nearest.distance)
      ++back;
    const Vec3 along = end - from_end(back);
    if (dot(along, way) > towards * norm(along) * norm(way)) return nearest;
    const std::vector<Vec3>& rail = nearest.line ? places_[*nearest.line] : borders_[nearest.loop];
    const Vec3 side = rail[nearest.end] - rail[nearest.end - 1];
    if (std::abs(dot(along, side)) < beside * norm(along) * norm(side)) return nearest;
    const bool is_forward = dot(along, side) > 0.0;
    Nearest there = nearest;
    double left = run * nearest.distance;
    for (std::size_t count = 0; count < rail.size(); ++count) {
      const double length = norm(rail[there.end] - rail[there.end - 1]);
      const double rest = length * (is_forward ? 1.0 - there.share : there.share);
      if (rest >= left) {
        there.share += (is_forward ? left : -left) / length;
        break;
      }
      left -= rest;
      there.share = is_forward ? 1.0 : 0.0;
      if (is_forward ? there.end + 1 == rail.size() : there.end == 1) break;
      there.end = is_forward ? there.end + 1 : there.end - 1;
      there.share = is_forward ? 0.0 : 1.0;
    }
    there.place = rail[there.end - 1] + there.share * (rail[there.end] - rail[there.end - 1]);
    there.distance = norm(there.place - end);
    return there;
  }

  void join(std::size_t l, bool is_last) {
    const SurfacePoint& point = is_last ? result_.lines[l].back() : result_.lines[l].front();
    if (is_on_border(point)) return;
    const Vec3 end = is_last ? places_[l].back() : places_[l].front();
    const Nearest nearest = nearest_to(l, is_last, end);
    if (nearest.distance <= k_same_place && nearest.line) return;
    const LineEnd free_end = {l, is_last, nearest.distance / scale_, nearest.line};
    const bool is_joined =
        nearest.distance <= tolerance_ &&
        (lead_on(l, is_last, end, ahead(l, is_last, nearest)) || lead_on(l, is_last, end, nearest));
    (is_joined ? result_.joined : result_.free).push_back(free_end);
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
    } else if (shared_triangle(patch_, from, way.front())) {
      way.insert(way.begin(), from);
    } else {
      return false;
    }
    if (nearest.line) {
      const SurfaceLine& line = result_.lines[*nearest.line];
      const auto point =
          point_between(patch_, line[nearest.end - 1], line[nearest.end], nearest.share);
      if (!point) return false;
      if (shared_triangle(patch_, way[way.size() - 2], *point)) {
        way.back() = *point;
      } else if (shared_triangle(patch_, way.back(), *point)) {
        way.push_back(*point);
      } else {
        return false;
      }
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
  std::vector<std::vector<Vec3>> places_, borders_;
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
