#include "mesh/search/first_hit.h"

#include <array>
#include <cmath>
#include <limits>
#include <span>

namespace planish {

namespace {

// Shares of a corner down to this count as on the triangle.
constexpr double k_rounding = 1e-9;

/// Distance at which the ray meets the triangle's plane inside of it. (Moeller and Trumbore, Fast
/// minimum storage ray/triangle intersection, 1997)
std::optional<double> distance_to(const BoxTree::Corners& corners, Vec3 from, Vec3 direction) {
  const Vec3 u = corners[1] - corners[0], v = corners[2] - corners[0], w = from - corners[0];
  const Vec3 across = cross(direction, v);
  const double volume = dot(u, across);
  if (volume == 0.0) return std::nullopt;
  const double b = dot(w, across) / volume;
  const Vec3 turned = cross(w, u);
  const double c = dot(direction, turned) / volume;
  if (!(b >= -k_rounding && c >= -k_rounding && b + c <= 1.0 + k_rounding)) return std::nullopt;
  return dot(v, turned) / volume;
}

/// Whether the ray can meet something in the box nearer than `farthest`.
bool meets(const Box& box, Vec3 from, Vec3 direction, double farthest) {
  double enter = 0.0, leave = farthest;
  const auto clip = [&](double low, double high, double at, double along) {
    // A box has room for rounding, so that one without height is not missed.
    const double room = k_rounding * (high - low) + 1e-12;
    if (along == 0.0) return at >= low - room && at <= high + room;
    const double one = (low - room - at) / along, other = (high + room - at) / along;
    enter = std::max(enter, std::min(one, other));
    leave = std::min(leave, std::max(one, other));
    return enter <= leave;
  };
  return clip(box.low.x, box.high.x, from.x, direction.x) &&
         clip(box.low.y, box.high.y, from.y, direction.y) &&
         clip(box.low.z, box.high.z, from.z, direction.z);
}

}  // namespace

std::optional<Hit> first_hit(const BoxTree& tree, Vec3 from, Vec3 direction, double nearest) {
  std::optional<Hit> best;
  double farthest = std::numeric_limits<double>::infinity();
  const std::span<const BoxTree::Node> nodes = tree.nodes();
  // The depth of a tree that halves is below 64.
  std::array<std::size_t, 64> waiting{};
  std::size_t count = 1;
  while (count > 0) {
    const std::size_t number = waiting[--count];
    const BoxTree::Node& node = nodes[number];
    if (!meets(node.box, from, direction, farthest)) continue;
    if (!node.is_leaf()) {
      waiting[count++] = node.second;
      waiting[count++] = number + 1;
      continue;
    }
    for (std::size_t place = node.begin; place < node.end; ++place) {
      const auto distance = distance_to(tree.corners(place), from, direction);
      if (!distance || !(*distance > nearest) || *distance > farthest) continue;
      const Index triangle = tree.triangle(place);
      if (best && *distance == best->distance && triangle > best->triangle) continue;
      best = Hit{*distance, triangle};
      farthest = *distance;
    }
  }
  return best;
}

}  // namespace planish
