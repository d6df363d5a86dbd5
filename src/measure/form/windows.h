#pragma once

#include <span>
#include <vector>

#include <planish/mesh/patch.h>

namespace planish {

/// The vertices around one of them that are connected within a radius.
struct Window {
  std::span<const Index> vertices = {};  ///< the middle first
  std::span<const double> weights = {};  ///< 1 - (distance / radius)^2 of each, above 0
  double share = 0.0;  ///< the area of its inner half that no window before it has
};

/// Calls visit(window) for windows that cover the surface: around the first vertex whose place the
/// inner halves of those before it leave out, and so on. The same order every time. Every vertex
/// lies in a few windows, whatever the radius: O(n).
/// @param areas of the surface, one per vertex
template <class Visit>
void for_each_window(const Connectivity& connectivity, std::span<const Vec3> positions,
                     std::span<const double> areas, double radius, const Visit& visit) {
  constexpr double inner = 0.75;  // the weight at half the radius
  const std::size_t n = positions.size();
  std::vector<Index> seen_from(n, Edge::none), vertices;
  std::vector<char> is_covered(n, 0);
  std::vector<double> weights;
  const auto weight_of = [&](Index v, Vec3 middle) {
    const Vec3 off = (1.0 / radius) * (positions[v] - middle);
    return 1.0 - dot(off, off);
  };
  for (Index middle = 0; middle < n; ++middle) {
    if (is_covered[middle] != 0 || connectivity.ring(middle).empty()) continue;
    vertices.assign(1, middle);
    weights.assign(1, 1.0);
    seen_from[middle] = middle;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      for (const Index v : connectivity.ring(vertices[i])) {
        if (seen_from[v] == middle) continue;
        seen_from[v] = middle;
        const double weight = weight_of(v, positions[middle]);
        if (!(weight > 0.0)) continue;
        vertices.push_back(v);
        weights.push_back(weight);
      }
    }
    double share = 0.0;
    for (std::size_t i = 0; i < vertices.size(); ++i) {
      const Index v = vertices[i];
      if (weights[i] < inner || is_covered[v] != 0) continue;
      is_covered[v] = 1;
      share += areas[v];
    }
    visit(Window{vertices, weights, share});
  }
}

}  // namespace planish
