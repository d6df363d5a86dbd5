#include "evolve/patch_state.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "core/careful_sum.h"
#include "evolve/coloring.h"
#include "evolve/spatial_order.h"
#include "measure/star_batches.h"

namespace planish {

namespace {

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
  const std::size_t inner = vertex_of_.size();
  for (const auto& loop : connectivity.border_loops())
    vertex_of_.insert(vertex_of_.end(), loop.begin(), loop.end());
  number_rings(connectivity, inner, pool);
  plan_visits(distance_two_colors({ring_start_, rings_}, pool));
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
}

void PatchState::plan_visits(const std::vector<Index>& colors) {
  visits_.resize(inner_count());
  std::iota(visits_.begin(), visits_.end(), Index{0});
  sort_by(visits_, [this](Index v) { return ring(v).size(); });
  color_start_ = sort_by(visits_, [&](Index v) { return colors[v]; });
  for (std::size_t color = 0; color < color_count(); ++color) {
    for (std::size_t i = color_start_[color]; i < color_start_[color + 1]; ++i) {
      const bool last = i + 1 == color_start_[color + 1];
      if (last || ring(visits_[i]).size() != ring(visits_[i + 1]).size()) run_end_.push_back(i + 1);
    }
  }
}

std::size_t PatchState::end_of_run(std::size_t i) const {
  return *std::upper_bound(run_end_.begin(), run_end_.end(), i);
}

void PatchState::refresh_defects(ThreadPool& pool) {
  begin_phase();
  // Written apart first: the kernel loads whole sites, also while others are being computed.
  std::vector<double> defects(inner_count());
  pool.for_ranges(inner_count(), 1024, [&](std::size_t begin, std::size_t end) {
    StarBatches batches(sites_.data(), [&](Index v, double defect) { defects[v] = defect; });
    for (std::size_t v = begin; v < end; ++v)
      batches.add(static_cast<Index>(v), ring(v));
    batches.finish();
  });
  pool.for_ranges(inner_count(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      if (sites_[v].defect != defects[v]) changed_at_[v] = now_;
      sites_[v].defect = defects[v];
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
