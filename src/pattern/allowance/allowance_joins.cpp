#include "pattern/allowance/allowance_joins.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/math.h"
#include "pattern/polygon/plane.h"

namespace planish {

namespace {

constexpr double k_sagitta = 0.005;  // millimetres that a chord may be inside its arc

Vec2 turned(Vec2 v, double angle) {
  const double c = math::cos(angle), s = math::sin(angle);
  return {c * v.x - s * v.y, s * v.x + c * v.y};
}

/// Left turns are > 0; half a turn counts as left, so that the tip of a slit is gone around.
double turn_of(const OutlineCorner& corner) {
  const double turn = turn_between(corner.before, corner.after);
  return turn <= -std::numbers::pi ? std::numbers::pi : turn;
}

// An arc, or between two widths a spiral.
void append_arc(const OutlineCorner& corner, double turn, Polygon& line) {
  const double widest = std::max(corner.width_before, corner.width_after);
  const double step = 2.0 * math::acos(1.0 - std::min(1.0, k_sagitta / widest));
  const int chords = std::max(1, static_cast<int>(std::ceil(turn / step)));
  const Vec2 from = outwards(corner.before);
  for (int i = 1; i < chords; ++i) {
    const double share = static_cast<double>(i) / chords;
    const double width = std::lerp(corner.width_before, corner.width_after, share);
    line.push_back(corner.point + width * turned(from, share * turn));
  }
}

// Cut off at the width, across the direction that halves the corner.
void append_square(const OutlineCorner& corner, double turn, Polygon& line) {
  const double beyond = corner.width_before * math::tan(turn / 4.0);
  const Vec2 start = corner.point + corner.width_before * outwards(corner.before);
  const Vec2 end = corner.point + corner.width_before * outwards(corner.after);
  line.push_back(start + beyond * corner.before);
  line.push_back(end - beyond * corner.after);
}

/// Where the two offset lines meet, beyond both edges and within the limit; false where they do
/// not.
bool append_mitre(const OutlineCorner& corner, double turn, Polygon& line) {
  const double sine = math::sin(turn), cosine = math::cos(turn);
  if (!(sine > 1e-9)) return false;
  const double beyond = (corner.width_after - corner.width_before * cosine) / sine;
  const double ahead = (corner.width_before - corner.width_after * cosine) / sine;
  const double widest = std::max(corner.width_before, corner.width_after);
  const double reach = math::hypot(corner.width_before, beyond);
  // At a right angle beside an edge of no width they are zero but for rounding.
  const double least = -1e-9 * widest;
  if (beyond < least || ahead < least || reach > corner.mitre_limit * widest) return false;
  line.push_back(corner.point + corner.width_before * outwards(corner.before) +
                 beyond * corner.before);
  return true;
}

void append_corner(const OutlineCorner& corner, double turn, Polygon& line) {
  if (corner.corners == Corners::mitre && append_mitre(corner, turn, line)) return;
  // With two widths there is no square.
  if (corner.corners == Corners::round || corner.width_before != corner.width_after) {
    append_arc(corner, turn, line);
  } else {
    append_square(corner, turn, line);
  }
}

}  // namespace

Vec2 WideLoop::direction(std::size_t edge) const {
  const Vec2 way = points[next(edge)] - points[edge];
  const double length = norm(way);
  return length > 0.0 ? 1.0 / length * way : Vec2{};
}

OutlineCorner WideLoop::corner(std::size_t point, Corners corners, double mitre_limit) const {
  const std::size_t before = last(point);
  return {points[point], direction(before), direction(point), widths[before],
          widths[point], corners,           mitre_limit};
}

void append_join(const OutlineCorner& corner, Polygon& line) {
  line.push_back(corner.point + corner.width_before * outwards(corner.before));
  const double turn = turn_of(corner);
  if (turn < 0.0) {
    line.push_back(corner.point);
  } else if (std::max(corner.width_before, corner.width_after) > 0.0) {
    append_corner(corner, turn, line);
  }
  line.push_back(corner.point + corner.width_after * outwards(corner.after));
}

}  // namespace planish
