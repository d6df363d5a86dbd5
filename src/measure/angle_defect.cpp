#include <algorithm>
#include <array>
#include <vector>

#include <planish/measure/angle_defect.h>

#include "measure/lanes/star_defects.h"

namespace planish {

namespace {

/// Collects the stars of one valence until there are enough to compute them together.
class StarBatch {
 public:
  void add(Star star, std::size_t valence, const Site* sites, std::vector<double>& defects) {
    stars_[count_++] = star;
    if (count_ == stars_.size()) flush(valence, sites, defects);
  }

  void flush(std::size_t valence, const Site* sites, std::vector<double>& defects) {
    std::array<double, k_stars> results;
    star_defects_for(best_isa())(sites, stars_.data(), count_, valence, results.data());
    for (std::size_t i = 0; i < count_; ++i)
      defects[stars_[i].center] = results[i];
    count_ = 0;
  }

 private:
  static constexpr std::size_t k_stars = 64;
  std::array<Star, k_stars> stars_;
  std::size_t count_ = 0;
};

}  // namespace

std::vector<double> angle_defects(const TriMesh& mesh, const Connectivity& connectivity) {
  constexpr std::size_t batched_valences = 16;  // the others are rare: one by one
  std::vector<double> defects(mesh.positions.size(), 0.0);
  if (connectivity.inner_vertices().empty()) return defects;
  const double scale = unit_scale(mesh);
  std::vector<Site> sites;
  sites.reserve(mesh.positions.size());
  for (const Vec3 p : mesh.positions)
    sites.push_back({scale * p.x, scale * p.y, scale * p.z, 0.0});
  std::vector<StarBatch> batches(batched_valences + 1);
  for (const Index v : connectivity.inner_vertices()) {
    const auto ring = connectivity.ring(v);
    StarBatch& batch = batches[std::min(ring.size(), batched_valences)];
    batch.add({ring.data(), v}, ring.size(), sites.data(), defects);
    if (ring.size() >= batched_valences) batch.flush(ring.size(), sites.data(), defects);
  }
  for (std::size_t valence = 0; valence < batched_valences; ++valence)
    batches[valence].flush(valence, sites.data(), defects);
  return defects;
}

}  // namespace planish
