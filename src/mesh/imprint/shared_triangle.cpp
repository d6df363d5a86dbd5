#include "mesh/imprint/shared_triangle.h"

#include <algorithm>
#include <cstddef>
#include <utility>

#include "mesh/carry/place_on_triangle.h"

namespace planish {

std::vector<Index> carriers_of(const SurfacePoint& point) {
  std::vector<Index> carriers;
  for (std::size_t k = 0; k < 3; ++k) {
    if (point.shares[k] > 0.0) carriers.push_back(point.corners[k]);
  }
  return carriers;
}

std::optional<Triangle> triangle_with(const Patch& patch, std::span<const Index> vertices) {
  if (vertices.empty() || vertices.size() > 3) return std::nullopt;
  const auto ring = patch.ring(vertices[0]);
  if (ring.empty()) return std::nullopt;
  const std::size_t count = patch.is_border(vertices[0]) ? ring.size() - 1 : ring.size();
  for (std::size_t k = 0; k < count; ++k) {
    const Triangle t = {vertices[0], ring[k], ring[(k + 1) % ring.size()]};
    if (std::all_of(vertices.begin(), vertices.end(),
                    [&](Index v) { return std::find(t.begin(), t.end(), v) != t.end(); }))
      return t;
  }
  return std::nullopt;
}

std::optional<Triangle> shared_triangle(const Patch& patch, const SurfacePoint& a,
                                        const SurfacePoint& b) {
  std::vector<Index> all = carriers_of(a);
  for (const Index v : carriers_of(b)) {
    if (std::find(all.begin(), all.end(), v) == all.end()) all.push_back(v);
  }
  return triangle_with(patch, all);
}

std::optional<SurfacePoint> point_between(const Patch& patch, const SurfacePoint& a,
                                          const SurfacePoint& b, double share) {
  const auto triangle = shared_triangle(patch, a, b);
  if (!triangle) return std::nullopt;
  SurfacePoint point{*triangle, {0.0, 0.0, 0.0}};
  for (const auto& [end, part] : {std::pair{&a, 1.0 - share}, std::pair{&b, share}}) {
    for (std::size_t k = 0; k < 3; ++k) {
      const auto at = std::find(triangle->begin(), triangle->end(), end->corners[k]);
      if (end->shares[k] > 0.0)
        point.shares[static_cast<std::size_t>(at - triangle->begin())] += part * end->shares[k];
    }
  }
  point.shares = cleared(point.shares);
  return point;
}

}  // namespace planish
