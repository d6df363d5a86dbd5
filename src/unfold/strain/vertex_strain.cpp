#include "unfold/strain/vertex_strain.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

#include "unfold/strain/strain_of_edge.h"

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

namespace {

/// The one of larger size, where stretch counts as much as the weight says.
double larger(double a, double b, double weight_of_stretch) {
  const auto size = [&](double strain) {
    return strain < 0.0 ? -strain * weight_of_stretch : strain;
  };
  return size(b) > size(a) ? b : a;
}

}  // namespace

std::vector<double> largest_edge_strains(const Patch& patch, std::span<const Vec2> pattern,
                                         double weight_of_stretch) {
  const double scale = patch.unit_scale();
  std::vector<double> largest(patch.vertex_count());
  for (Index v = 0; v < largest.size(); ++v) {
    for (const Index w : patch.ring(v)) {
      const double strain = strain_of_edge(patch.mesh(), pattern, scale, v, w);
      largest[v] = larger(largest[v], strain, weight_of_stretch);
    }
  }
  return largest;
}

std::vector<double> largest_edge_strains_of_triangles(const TriMesh& mesh,
                                                      std::span<const Vec2> pattern,
                                                      double weight_of_stretch) {
  const double scale = unit_scale(mesh);
  std::vector<double> largest;
  largest.reserve(mesh.triangles.size());
  for (const Triangle& t : mesh.triangles) {
    double& most = largest.emplace_back(0.0);
    for (const auto& [v, w] :
         {std::pair(t[0], t[1]), std::pair(t[1], t[2]), std::pair(t[2], t[0])}) {
      const double strain = strain_of_edge(mesh, pattern, scale, v, w);
      most = larger(most, strain, weight_of_stretch);
    }
  }
  return largest;
}

std::vector<PrincipalStretch> vertex_stretches(const TriMesh& mesh, std::span<const Vec2> pattern) {
  const auto stretches = principal_stretches(mesh, pattern);
  std::vector<PrincipalStretch> means(mesh.positions.size(), {0.0, 0.0});
  std::vector<int> counts(mesh.positions.size());
  for (std::size_t t = 0; t < stretches.size(); ++t) {
    for (const Index v : mesh.triangles[t]) {
      means[v] = {means[v].max + stretches[t].max, means[v].min + stretches[t].min};
      ++counts[v];
    }
  }
  for (std::size_t v = 0; v < means.size(); ++v) {
    const double count = counts[v];
    means[v] = counts[v] == 0 ? PrincipalStretch{}
                              : PrincipalStretch{means[v].max / count, means[v].min / count};
  }
  return means;
}

}  // namespace planish
