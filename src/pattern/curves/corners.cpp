#include "pattern/curves/corners.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "pattern/curves/piece_math.h"
#include "pattern/polygon/border_walk.h"

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

std::vector<Polygon> stretches_of(const Polygon& loop, std::vector<std::size_t> breaks) {
  if (breaks.empty()) breaks.push_back(0);
  std::vector<Polygon> stretches;
  stretches.reserve(breaks.size());
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    const std::size_t to = k + 1 < breaks.size() ? breaks[k + 1] : breaks.front() + loop.size();
    Polygon& stretch = stretches.emplace_back();
    for (std::size_t i = breaks[k]; i <= to; ++i)
      stretch.push_back(loop[i % loop.size()]);
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
