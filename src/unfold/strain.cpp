#include <algorithm>
#include <cmath>

#include <planish/unfold/strain.h>

#include "core/careful_sum.h"
#include "core/math.h"
#include "unfold/strain_of_edge.h"

namespace planish {

EdgeStrain edge_strain(const TriMesh& mesh, const Connectivity& connectivity,
                       std::span<const Vec2> pattern) {
  const double scale = unit_scale(mesh);
  EdgeStrain result;
  std::vector<double> sizes;
  CarefulSum squares;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    for (const Index w : connectivity.ring(v)) {
      if (w < v) continue;  // every edge once
      const double strain = strain_of_edge(mesh, pattern, scale, v, w);
      sizes.push_back(std::abs(strain));
      if (sizes.size() == 1 || sizes.back() > result.max) {
        result.max = sizes.back();
        result.worst_edge = {v, w};
      }
      squares.add(strain * strain);
    }
  }
  if (sizes.empty()) return result;
  const auto n = static_cast<double>(sizes.size());
  result.rms = std::sqrt(squares.value() / n);
  const auto rank = sizes.begin() + static_cast<std::ptrdiff_t>(std::ceil(0.99 * n)) - 1;
  std::nth_element(sizes.begin(), rank, sizes.end());
  result.p99 = *rank;
  return result;
}

double largest_border_strain(const TriMesh& mesh, const Connectivity& connectivity,
                             std::span<const Vec2> pattern) {
  const double scale = unit_scale(mesh);
  double largest = 0.0;
  for (const std::vector<Index>& loop : connectivity.border_loops()) {
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index v = loop[k], w = loop[(k + 1) % loop.size()];
      largest = std::max(largest, std::abs(strain_of_edge(mesh, pattern, scale, v, w)));
    }
  }
  return largest;
}

std::vector<PrincipalStretch> principal_stretches(const TriMesh& mesh,
                                                  std::span<const Vec2> pattern) {
  const double scale = unit_scale(mesh);
  std::vector<PrincipalStretch> stretches;
  stretches.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    const Vec3 x = scale * mesh.positions[t[0]];
    const Vec3 a = scale * mesh.positions[t[1]] - x, b = scale * mesh.positions[t[2]] - x;
    const double length = norm(a), height = norm(cross(a, b)) / length;
    PrincipalStretch& stretch = stretches.emplace_back();
    if (!(height > 0.0) || !std::isfinite(height)) continue;
    const double along = dot(a, b) / length;
    // The map as a matrix in the frame of a and the normal to it in the triangle.
    const Vec2 p = (scale / length) * (pattern[t[1]] - pattern[t[0]]);
    const Vec2 q = (1.0 / height) * (scale * (pattern[t[2]] - pattern[t[0]]) - along * p);
    const double turn = 0.5 * math::hypot(p.x + q.y, p.y - q.x);
    const double flip = 0.5 * math::hypot(p.x - q.y, p.y + q.x);
    stretch = {turn + flip, turn - flip};
  }
  return stretches;
}

std::vector<double> signed_strains(std::span<const PrincipalStretch> stretches) {
  std::vector<double> strains;
  strains.reserve(stretches.size());
  for (const PrincipalStretch& s : stretches) {
    const double longer = s.max - 1.0, shorter = s.min - 1.0;
    strains.push_back(std::abs(longer) >= std::abs(shorter) ? longer : shorter);
  }
  return strains;
}

}  // namespace planish
