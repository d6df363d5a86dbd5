#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include <planish/core/error.h>
#include <planish/pattern/marks.h>

#include "pattern/polygon/free_strip.h"

namespace planish {

namespace {

constexpr double k_longest = 200.0, k_shortest = 1.0, k_head = 5.0;  // millimetres
constexpr double k_used = 0.8;                                       // of a free strip

/// Where the direction points to in a triangle of the pattern, times twice the patch's area.
Vec2 carried_over(const std::array<Vec3, 3>& from, const std::array<Vec2, 3>& to, Vec3 direction) {
  const Vec3 u = from[1] - from[0], v = from[2] - from[0];
  const Vec3 normal = cross(u, v);
  const double doubled = norm(normal);
  if (!(doubled > 0.0)) return {};
  // Along the surface the direction is a u + b v: by its areas with v and u.
  const double a = dot(cross(direction, v), normal) / doubled;
  const double b = dot(cross(u, direction), normal) / doubled;
  return a * (to[1] - to[0]) + b * (to[2] - to[0]);
}

std::vector<Polygon> arrow(Vec2 middle, Vec2 direction, double length, double half_width) {
  const double head = std::min(2.5 * half_width, 0.25 * length);
  const Vec2 aside = std::min(half_width, 0.4 * head) * Vec2{-direction.y, direction.x};
  const Vec2 start = middle - 0.5 * length * direction, end = middle + 0.5 * length * direction;
  const auto tip = [&](Vec2 at, Vec2 back) {
    return Polygon{at + head * back + aside, at, at + head * back - aside};
  };
  return {{start, end}, tip(start, direction), tip(end, -1.0 * direction)};
}

}  // namespace

Vec2 grain_direction(const TriMesh& mesh, std::span<const Vec2> positions, Vec3 direction,
                     std::string_view piece) {
  const double length = norm(direction);
  Vec2 sum;
  double area = 0.0;
  for (const auto& [a, b, c] : mesh.triangles) {
    const std::array<Vec3, 3> from = {mesh.positions[a], mesh.positions[b], mesh.positions[c]};
    sum = sum + carried_over(from, {positions[a], positions[b], positions[c]}, direction);
    area += norm(cross(from[1] - from[0], from[2] - from[0]));
  }
  if (!(norm(sum) > 0.01 * length * area)) {
    throw Error(ErrorCode::no_grain_direction,
                "piece \"" + std::string(piece) +
                    "\": the direction of the grain on the model has none in the pattern, as it "
                    "stands at right angles to the patch or its parts cancel out; give an angle");
  }
  return 1.0 / norm(sum) * sum;
}

std::vector<Polygon> grain_lines(const PieceOutline& outline, Vec2 direction,
                                 const std::optional<ClearBox>& keep_clear) {
  std::vector<Polygon> loops = outline.loops;
  if (keep_clear) {
    const auto [low, high] = *keep_clear;
    loops.push_back({low, {high.x, low.y}, high, {low.x, high.y}});
  }
  for (double half_width = 0.4 * k_head; half_width > 0.1; half_width *= 0.5) {
    const FreeStrip strip = longest_strip(loops, direction, half_width, k_longest / k_used);
    const double length = k_used * strip.length;
    if (length >= std::max(k_shortest, 4.0 * half_width)) {
      return arrow(strip.middle, direction, length, half_width);
    }
  }
  return {};
}

}  // namespace planish
