#include "pattern/curves/corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include "pattern/polygon/border_walk.h"
#include "pattern/polygon/plane.h"

namespace planish {

namespace {

constexpr double k_least_turn = 20.0 * std::numbers::pi / 180.0;
constexpr double k_least_distance = 3.0, k_edges = 2.5;
constexpr double k_share_at_point = 0.6;

/// 0 where one of the directions is none.
double turn(Vec2 before, Vec2 after) {
  if (!(norm(before) > 0.0) || !(norm(after) > 0.0)) return 0.0;
  return turn_between(before, after);
}

/// The numbers of the points from each break to the next one; without breaks all around.
std::vector<std::vector<std::size_t>> points_between(std::size_t count,
                                                     std::vector<std::size_t> breaks) {
  if (breaks.empty()) breaks.push_back(0);
  std::vector<std::vector<std::size_t>> runs;
  runs.reserve(breaks.size());
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const std::size_t to = k + 1 < breaks.size() ? breaks[k + 1] : breaks.front() + count;
    std::vector<std::size_t>& run = runs.emplace_back();
    for (std::size_t i = breaks[k]; i <= to; ++i)
      run.push_back(i % count);
  }
  return runs;
}

}  // namespace

std::vector<std::size_t> corners_of(const Polygon& loop) {
  const std::size_t n = loop.size();
  if (n < 3) return {};
  const BorderWalk walk(loop);
  const double distance =
      std::min(std::max(k_least_distance, k_edges * walk.length() / static_cast<double>(n)),
               0.125 * walk.length());
  std::vector<std::size_t> corners;
  for (std::size_t i = 0; i < n; ++i) {
    const Vec2 at = loop[i];
    const double own = turn(at - loop[(i + n - 1) % n], loop[(i + 1) % n] - at);
    if (std::abs(own) < k_least_turn) continue;
    const double way = walk.way_to(i);
    const double seen = turn(at - walk.at(way - distance), walk.at(way + distance) - at);
    if (std::abs(seen) < k_least_turn || own * seen < 0.0) continue;
    // Each point of a circle turns 0.4 of that.
    if (std::abs(own) >= k_share_at_point * std::abs(seen)) corners.push_back(i);
  }
  return corners;
}

namespace {

/// The points from corner to corner of a loop, the first run behind its lowest vertex.
std::vector<std::vector<std::size_t>> runs_from_lowest(const PieceOutline& outline, std::size_t k) {
  const std::size_t n = outline.loops[k].size();
  std::vector<std::vector<std::size_t>> runs = points_between(n, corners_of(outline.loops[k]));
  if (outline.vertices.empty() || outline.vertices[k].empty()) return runs;
  const std::vector<Index>& vertices = outline.vertices[k];
  const auto lowest = static_cast<std::size_t>(std::min_element(vertices.begin(), vertices.end()) -
                                               vertices.begin());
  const auto way = [&](const std::vector<std::size_t>& run) {
    return (run.front() + n - lowest) % n;
  };
  std::stable_sort(runs.begin(), runs.end(),
                   [&](const auto& a, const auto& b) { return way(a) < way(b); });
  return runs;
}

}  // namespace

std::vector<OutlineEdge> edges_between_corners(const PieceOutline& outline) {
  std::vector<OutlineEdge> edges;
  for (std::size_t k = 0; k < outline.loops.size(); ++k) {
    const Polygon& loop = outline.loops[k];
    for (std::vector<std::size_t>& points : runs_from_lowest(outline, k)) {
      OutlineEdge& edge = edges.emplace_back(OutlineEdge{k, std::move(points)});
      for (std::size_t i = 1; i < edge.points.size(); ++i)
        edge.length += norm(loop[edge.points[i]] - loop[edge.points[i - 1]]);
    }
  }
  return edges;
}

std::vector<Polygon> stretches_of(const Polygon& loop, std::vector<std::size_t> breaks) {
  std::vector<Polygon> stretches;
  for (const std::vector<std::size_t>& points : points_between(loop.size(), std::move(breaks))) {
    Polygon& stretch = stretches.emplace_back();
    stretch.reserve(points.size());
    for (const std::size_t i : points)
      stretch.push_back(loop[i]);
  }
  return stretches;
}

Polygon without_repeats(const Polygon& loop) {
  Polygon points;
  points.reserve(loop.size());
  for (const Vec2 p : loop) {
    if (points.empty() || !(p == points.back())) points.push_back(p);
  }
  while (points.size() > 1 && points.front() == points.back())
    points.pop_back();
  return points;
}

double length_of_line(std::span<const Vec2> points) {
  double length = 0.0;
  for (std::size_t i = 1; i < points.size(); ++i)
    length += norm(points[i] - points[i - 1]);
  return length;
}

}  // namespace planish
