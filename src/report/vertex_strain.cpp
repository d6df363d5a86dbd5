#include "report/vertex_strain.h"

#include <algorithm>
#include <cstddef>

#include <planish/unfold/strain.h>

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

}  // namespace planish
