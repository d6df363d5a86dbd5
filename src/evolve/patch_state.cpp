#include "evolve/patch_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "core/careful_sum.h"
#include "evolve/coloring.h"
#include "evolve/spatial_order.h"
#include "measure/lanes/star_defects.h"

namespace planish {

namespace {

/// Vertices whose stars are computed by one call.
constexpr std::size_t k_batch = 256;

/// Puts what has one key together, keys ascending, and keeps the order within; returns where each
/// begins, and the end.
template <class KeyOf>
std::vector<std::size_t> sort_by(std::vector<Index>& order, const KeyOf& key_of) {
  std::vector<std::size_t> start(1, 0);
  for (const Index v : order) {
    const std::size_t key = key_of(v);
    if (key + 2 > start.size()) start.resize(key + 2, 0);
    ++start[key + 1];
  }
  for (std::size_t c = 1; c < start.size(); ++c)
    start[c] += start[c - 1];
  std::vector<std::size_t> next = start;
  std::vector<Index> sorted(order.size());
  for (const Index v : order)
    sorted[next[key_of(v)]++] = v;
  order = std::move(sorted);
  return start;
}

}  // namespace

PatchState::PatchState(const TriMesh& mesh, const Connectivity& connectivity, ThreadPool& pool)
    : scale_(unit_scale(mesh)), origins_(mesh.positions) {
  vertex_of_ = spatial_order(origins_, scale_, connectivity.inner_vertices(), pool);
  const auto colors = distance_two_colors(connectivity, vertex_of_, pool);
  sort_by(vertex_of_, [&](Index v) { return connectivity.ring(v).size(); });
  color_start_ = sort_by(vertex_of_, [&](Index v) { return colors[v]; });
  const std::size_t inner = vertex_of_.size();
  for (const auto& loop : connectivity.border_loops())
    vertex_of_.insert(vertex_of_.end(), loop.begin(), loop.end());
  number_rings(connectivity, inner, pool);
  place_vertices(pool);
  moved_.assign(inner_count(), 0);
  changed_at_.assign(inner_count(), 0);
  refresh_defects(pool);
}

void PatchState::place_vertices(ThreadPool& pool) {
  sites_.resize(vertex_of_.size());
  pool.for_ranges(vertex_of_.size(), 4096, [this](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Vec3 p = scale_ * origins_[vertex_of_[v]];
      sites_[v] = {p.x, p.y, p.z, 0.0};
    }
  });
}

void PatchState::number_rings(const Connectivity& connectivity, std::size_t inner,
                              ThreadPool& pool) {
  std::vector<Index> number_of(origins_.size(), 0);
  for (std::size_t v = 0; v < vertex_of_.size(); ++v)
    number_of[vertex_of_[v]] = static_cast<Index>(v);
  ring_start_.reserve(inner + 1);
  ring_start_.push_back(0);
  for (std::size_t v = 0; v < inner; ++v) {
    ring_start_.push_back(ring_start_[v] + connectivity.ring(vertex_of_[v]).size());
  }
  rings_.resize(ring_start_.back());
  pool.for_ranges(inner, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Index* number = rings_.data() + ring_start_[v];
      for (const Index j : connectivity.ring(vertex_of_[v]))
        *number++ = number_of[j];
    }
  });
  for (std::size_t color = 0; color < color_count(); ++color) {
    for (std::size_t v = color_start_[color]; v < color_start_[color + 1]; ++v) {
      const bool last = v + 1 == color_start_[color + 1];
      if (last || ring(v).size() != ring(v + 1).size()) run_end_.push_back(v + 1);
    }
  }
}

std::size_t PatchState::end_of_run(std::size_t v) const {
  return *std::upper_bound(run_end_.begin(), run_end_.end(), v);
}

void PatchState::refresh_defects(ThreadPool& pool) {
  begin_phase();
  const StarDefects star_defects = star_defects_for(best_isa());
  pool.for_ranges(inner_count(), k_batch, [&](std::size_t begin, std::size_t end) {
    std::array<Star, k_batch> stars;
    std::array<double, k_batch> defects;
    while (begin < end) {
      const std::size_t valence = ring(begin).size();
      const std::size_t count = std::min({end, end_of_run(begin), begin + k_batch}) - begin;
      for (std::size_t i = 0; i < count; ++i)
        stars[i] = {ring(begin + i).data(), static_cast<Index>(begin + i)};
      star_defects(sites_.data(), stars.data(), count, valence, defects.data());
      for (std::size_t i = 0; i < count; ++i) {
        double& defect = sites_[begin + i].defect;
        if (defect != defects[i]) changed_at_[begin + i] = now_;
        defect = defects[i];
      }
      begin += count;
    }
  });
}

Flattenability PatchState::summary(ThreadPool& pool) const {
  // In parts that do not depend on the number of threads.
  constexpr std::size_t part = 4096;
  struct Sums {
    double e_max = 0.0;
    CarefulSum energy, sum;
  };
  std::vector<Sums> parts((inner_count() + part - 1) / part);
  pool.for_ranges(parts.size(), 1, [&](std::size_t begin, std::size_t end) {
    for (std::size_t p = begin; p < end; ++p) {
      for (std::size_t v = p * part; v < std::min(inner_count(), (p + 1) * part); ++v) {
        const double size = std::abs(sites_[v].defect);
        if (size > parts[p].e_max || std::isnan(size)) parts[p].e_max = size;
        parts[p].energy.add(size * size);
        parts[p].sum.add(size);
      }
    }
  });
  Sums total;
  for (const Sums& sums : parts) {
    if (sums.e_max > total.e_max || std::isnan(sums.e_max)) total.e_max = sums.e_max;
    total.energy.add(sums.energy);
    total.sum.add(sums.sum);
  }
  Flattenability figures;
  figures.e_max = total.e_max;
  figures.energy = total.energy.value();
  figures.sum_abs_defect = total.sum.value();
  if (inner_count() > 0) figures.e_avg = total.sum.value() / static_cast<double>(inner_count());
  return figures;
}

std::vector<Vec3> PatchState::positions_in_mesh_order() const {
  std::vector<Vec3> positions = origins_;
  for (std::size_t v = 0; v < inner_count(); ++v) {
    if (moved_[v] != 0) positions[vertex_of_[v]] = (1.0 / scale_) * position(v);
  }
  return positions;
}

}  // namespace planish
