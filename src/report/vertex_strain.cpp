#include "report/vertex_strain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <planish/unfold/strain.h>

#include "unfold/strain_of_edge.h"

namespace planish {

std::vector<double> vertex_strains(const TriMesh& mesh, std::span<const Vec2> pattern) {
  const auto strains = signed_strains(principal_stretches(mesh, pattern));
  std::vector<double> sums(mesh.positions.size());
  std::vector<int> counts(mesh.positions.size());
  for (std::size_t t = 0; t < strains.size(); ++t) {
    for (const Index v : mesh.triangles[t]) {
      sums[v] += strains[t];
      ++counts[v];
    }
  }
  for (std::size_t v = 0; v < sums.size(); ++v)
    sums[v] /= std::max(1, counts[v]);
  return sums;
}

std::vector<double> largest_edge_strains(const TriMesh& mesh, const Connectivity& connectivity,
                                         std::span<const Vec2> pattern) {
  const double scale = unit_scale(mesh);
  std::vector<double> largest(mesh.positions.size());
  for (Index v = 0; v < largest.size(); ++v) {
    for (const Index w : connectivity.ring(v)) {
      const double strain = strain_of_edge(mesh, pattern, scale, v, w);
      if (std::abs(strain) > std::abs(largest[v])) largest[v] = strain;
    }
  }
  return largest;
}

}  // namespace planish
