#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>
#include <vector>

#include <planish/mesh/tri_mesh.h>

namespace planish {

/// Shortest paths over a tiny mesh between its vertices, found plainly: straight lines through all
/// strips of different triangles, and then shortest ways along such lines (Floyd and Warshall).
/// Takes exponential time.
/// @return distances, by both vertices
inline std::vector<std::vector<double>> plain_distances(const TriMesh& mesh) {
  const std::size_t n = mesh.positions.size();
  std::vector distances(n, std::vector(n, std::numeric_limits<double>::infinity()));
  const auto length = [&](Index a, Index b) { return norm(mesh.positions[a] - mesh.positions[b]); };
  // c in the plane with a at 0 and b on the x axis.
  const auto seen_along = [&](Index a, Index b, Index c) -> Vec2 {
    const Vec3 side = mesh.positions[b] - mesh.positions[a];
    const Vec3 other = mesh.positions[c] - mesh.positions[a];
    return {dot(side, other) / norm(side), norm(cross(side, other)) / norm(side)};
  };
  std::vector<unsigned char> is_used(mesh.triangles.size());
  // A straight line from 0 enters the next triangle between its corners a and b, placed in the
  // plane at p and q, inside the cone from low to high.
  const std::function<void(Index, Index, Index, Vec2, Vec2, Vec2, Vec2)> go_on =
      [&](Index source, Index a, Index b, Vec2 p, Vec2 q, Vec2 low, Vec2 high) {
        for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
          for (std::size_t k = 0; k < 3; ++k) {
            const Triangle& corners = mesh.triangles[t];
            if (is_used[t] != 0 || corners[k] != b || corners[(k + 1) % 3] != a) continue;
            const Index c = corners[(k + 2) % 3];
            const Vec2 placed = seen_along(a, b, c), axis = (1.0 / length(a, b)) * (q - p);
            const Vec2 r = p + placed.x * axis + placed.y * Vec2{axis.y, -axis.x};
            const bool after_low = cross(low, r) >= 0.0, before_high = cross(r, high) >= 0.0;
            if (after_low && before_high)
              distances[source][c] = std::min(distances[source][c], norm(r));
            is_used[t] = 1;
            if (after_low) go_on(source, a, c, p, r, low, before_high ? r : high);
            if (before_high) go_on(source, c, b, r, q, after_low ? r : low, high);
            is_used[t] = 0;
          }
        }
      };
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      const Triangle& corners = mesh.triangles[t];
      const Index s = corners[k], a = corners[(k + 1) % 3], b = corners[(k + 2) % 3];
      const Vec2 p = {length(s, a), 0.0}, q = seen_along(s, a, b);
      distances[s][s] = 0.0;
      distances[s][a] = distances[a][s] = length(s, a);
      distances[s][b] = distances[b][s] = length(s, b);
      is_used[t] = 1;
      go_on(s, a, b, p, q, p, q);
      is_used[t] = 0;
    }
  }
  for (std::size_t k = 0; k < n; ++k) {
    for (std::size_t i = 0; i < n; ++i) {
      for (std::size_t j = 0; j < n; ++j)
        distances[i][j] = std::min(distances[i][j], distances[i][k] + distances[k][j]);
    }
  }
  return distances;
}

}  // namespace planish
