#include <algorithm>

#include <planish/mesh/seams.h>

namespace planish {

namespace {

template <class Point>
std::vector<Point> points_along(const SeamSide& side, std::span<const Point> points) {
  std::vector<Point> line;
  line.reserve(side.vertices.size());
  for (const Index v : side.vertices)
    line.push_back(points[v]);
  // The ends of a side within one edge are both of that edge.
  const auto at = [](Point a, Point b, double share) { return a + share * (b - a); };
  const std::size_t n = line.size();
  const Point first = at(line[0], line[1], side.first_share);
  const Point last = at(line[n - 2], line[n - 1], side.last_share);
  if (side.first_share != 0.0) line.front() = first;
  if (side.last_share != 1.0) line.back() = last;
  return line;
}

template <class Point>
double polyline_length(const std::vector<Point>& line) {
  double length = 0.0;
  for (std::size_t k = 1; k < line.size(); ++k)
    length += norm(line[k] - line[k - 1]);
  return length;
}

}  // namespace

double matched_share(const Seam& seam, double share) {
  const auto& matches = seam.matches;
  if (matches.empty()) return share;
  const auto next =
      std::find_if(matches.begin() + 1, matches.end() - 1,
                   [&](const std::array<double, 2>& match) { return match[0] >= share; });
  const std::array<double, 2>&before = *(next - 1), &after = *next;
  const double step = after[0] - before[0];
  const double part = step > 0.0 ? std::clamp((share - before[0]) / step, 0.0, 1.0) : 0.0;
  return before[1] + part * (after[1] - before[1]);
}

double length_of(const SeamSide& side, std::span<const Vec3> positions) {
  return polyline_length(line_of(side, positions));
}

double length_of(const SeamSide& side, std::span<const Vec2> pattern) {
  return polyline_length(line_of(side, pattern));
}

std::vector<Vec3> line_of(const SeamSide& side, std::span<const Vec3> positions) {
  return points_along(side, positions);
}

std::vector<Vec2> line_of(const SeamSide& side, std::span<const Vec2> pattern) {
  return points_along(side, pattern);
}

}  // namespace planish
