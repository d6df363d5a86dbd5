#include "mesh/match/across_patch.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace planish {

namespace {

constexpr double k_farthest = 2.0;  // over the distance
constexpr double k_end = 0.02;      // share of the edge that is left free at its ends
constexpr int k_most_steps = 1000;

/// The third corner of the triangle on the left of the way from a to b.
std::optional<Index> apex_of(const Patch& patch, Index a, Index b) {
  const auto ring = patch.ring(a);
  const auto at = std::find(ring.begin(), ring.end(), b);
  if (at == ring.end()) return std::nullopt;
  if (at + 1 != ring.end()) return *(at + 1);
  return patch.is_border(a) ? std::nullopt : std::optional(ring.front());
}

/// A vertex, and its place in the plane that the triangles are laid out in.
struct Laid {
  Index vertex = 0;
  Vec2 at;
};

/// The corner of a triangle on the left of two that are laid.
Vec2 lay(const Patch& patch, const Laid& a, const Laid& b, Index apex) {
  const std::vector<Vec3>& positions = patch.positions();
  const Vec3 side = positions[apex] - positions[a.vertex];
  const Vec3 base = positions[b.vertex] - positions[a.vertex];
  const Vec2 base_laid = b.at - a.at;
  const double square = dot(base, base);
  const double along = dot(side, base) / square;
  const double height = norm(cross(side, base)) / square;
  return a.at + along * base_laid + height * Vec2{-base_laid.y, base_laid.x};
}

}  // namespace

bool is_just_across(const Patch& patch, const BorderEdge& edge, double share, Vec3 vertex,
                    double distance) {
  const std::vector<Vec3>& positions = patch.positions();
  const double length = norm(positions[edge.to] - positions[edge.from]);
  if (!(length > 0.0)) return false;
  const double x = length * std::clamp(share, k_end, 1.0 - k_end);
  Laid left{edge.from, {0.0, 0.0}}, right{edge.to, {length, 0.0}};
  for (int step = 0; step < k_most_steps; ++step) {
    const double width = right.at.x - left.at.x;
    if (!(width > 0.0)) return false;
    const double part = std::clamp((x - left.at.x) / width, 0.0, 1.0);
    const double height = left.at.y + part * (right.at.y - left.at.y);
    if (height > k_farthest * distance) return false;
    const auto apex = apex_of(patch, left.vertex, right.vertex);
    if (!apex) {
      const Vec3 a = positions[left.vertex], b = positions[right.vertex];
      return norm(a + part * (b - a) - vertex) <= k_farthest * (distance + k_end * length);
    }
    const Laid next{*apex, lay(patch, left, right, *apex)};
    (next.at.x > x ? right : left) = next;
  }
  return false;
}

}  // namespace planish
