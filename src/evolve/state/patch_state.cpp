#include "evolve/state/patch_state.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "evolve/state/spatial_order.h"
#include "measure/simd/star_defects.h"

namespace planish {

PatchState::PatchState(const Patch& patch, ThreadPool& pool, const Constraints& constraints,
                       const MirrorOrbits& orbits)
    : patch_(patch), weights_(constraints.weights) {
  const auto inner = patch.inner_vertices();
  Box box = bounding_box(patch_.positions(), inner, pool);
  std::vector<Index> border;
  for (const auto& loop : patch.border_loops()) {
    border_starts_.push_back(static_cast<Index>(inner.size() + border.size()));
    border.insert(border.end(), loop.begin(), loop.end());
  }
  border_starts_.push_back(static_cast<Index>(inner.size() + border.size()));
  for (const Index v : border)
    box.add(patch_.positions()[v]);
  scale_ = unit_scale(box);
  box = {scale_ * box.low, scale_ * box.high};
  vertex_of_ = spatial_order(patch_.positions(), inner, scale_, box, 0.0, pool);
  vertex_of_.insert(vertex_of_.end(), border.begin(), border.end());
  plan_ = plan_for(patch.connectivity(), inner.size(), box, pool);
  place_vertices(pool);
  fix(constraints.fixed);
  obstacle_ = constraints.obstacle;
  for (Vec3& p : obstacle_.positions)
    p = scale_ * p;
  orbits_ = orbits.of_part(vertex_of_);
  changed_at_.assign(inner_count(), 0);
  measure(pool);
}

void PatchState::fix(std::span<const Index> vertices) {
  if (vertices.empty()) return;
  std::vector<unsigned char> in_mesh(patch_.vertex_count(), 0);
  for (const Index v : vertices)
    in_mesh[v] = 1;
  for (const Index v : vertex_of_)
    fixed_.push_back(in_mesh[v]);
}

void PatchState::place_vertices(ThreadPool& pool) {
  sites_ = Buffer<Site>(vertex_of_.size());
  pool.for_ranges(vertex_of_.size(), 4096, [this](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      const Vec3 p = scale_ * patch_.positions()[vertex_of_[v]];
      sites_[v] = {p.x, p.y, p.z, is_inner(static_cast<Index>(v)) ? 0.0 : std::nan("")};
    }
  });
}

VisitPlan PatchState::plan_for(const Connectivity& connectivity, std::size_t inner, const Box& box,
                               ThreadPool& pool) const {
  std::vector<Index> number_of(patch_.vertex_count(), 0);
  pool.for_ranges(vertex_of_.size(), 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      number_of[vertex_of_[v]] = static_cast<Index>(v);
  });
  std::vector<std::size_t> start(inner + 1, 0);
  pool.for_ranges(inner, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v)
      start[v + 1] = connectivity.ring(vertex_of_[v]).size();
  });
  std::partial_sum(start.begin(), start.end(), start.begin());
  Buffer<Index> rings(start.back());
  pool.for_ranges(inner, 4096, [&](std::size_t begin, std::size_t end) {
    for (std::size_t v = begin; v < end; ++v) {
      Index* number = rings.data() + start[v];
      for (const Index j : connectivity.ring(vertex_of_[v]))
        *number++ = number_of[j];
    }
  });
  const auto other_order = [&](std::vector<Index> vertices) {
    for (Index& v : vertices)
      v = vertex_of_[v];
    constexpr double shift = 0.3;  // far from any half, quarter, eighth
    vertices = spatial_order(patch_.positions(), vertices, scale_, box, shift, pool);
    for (Index& v : vertices)
      v = number_of[v];
    return vertices;
  };
  return plan_visits({start, {rings.data(), rings.size()}}, other_order, pool);
}

DefectSums PatchState::measure_visits(std::size_t begin, std::size_t end) {
  constexpr std::size_t batch = 64;
  const StarDefects star_defects = star_defects_for(best_isa());
  const std::uint32_t now = time_of(plan_.color_count);
  DefectSums sums;
  plan_.for_runs(begin, end, [&](const Run& run, std::size_t i, std::size_t last) {
    std::array<Star, batch> stars;
    std::array<double, batch> defects;
    for (; i < last; i += batch) {
      const std::size_t count = std::min(batch, last - i);
      for (std::size_t k = 0; k < count; ++k)
        stars[k] = plan_.star(run, i + k);
      star_defects(sites_.data(), stars.data(), count, run.valence, defects.data());
      for (std::size_t k = 0; k < count; ++k) {
        const Index v = stars[k].center;
        if (sites_[v].defect != defects[k]) changed_at_[v] = now;
        sites_[v].defect = defects[k];
        sums.add(std::abs(defects[k]));
      }
    }
  });
  return sums;
}

Flattenability PatchState::measure(ThreadPool& pool) {
  const auto& piece = plan_.piece_start;
  std::vector<DefectSums> parts(piece.size() - 1);
  pool.for_ranges(parts.size(), 1, [&](std::size_t first, std::size_t last) {
    for (std::size_t p = first; p < last; ++p)
      parts[p] = measure_visits(piece[p], piece[p + 1]);
  });
  sweep_began_ = time_of(plan_.color_count) + 1;
  DefectSums total;
  for (const DefectSums& part : parts)
    total.add(part);
  Flattenability figures;
  figures.e_max = total.most;
  figures.energy = total.energy.value();
  figures.sum_abs_defect = total.sum.value();
  if (inner_count() > 0)
    figures.e_avg = figures.sum_abs_defect / static_cast<double>(inner_count());
  return figures;
}

std::vector<Triangle> PatchState::triangles() const {
  std::vector<Index> number_of(patch_.vertex_count(), 0);
  for (std::size_t v = 0; v < vertex_count(); ++v)
    number_of[vertex_of_[v]] = static_cast<Index>(v);
  std::vector<Triangle> triangles(patch_.triangles().begin(), patch_.triangles().end());
  for (Triangle& t : triangles) {
    for (Index& v : t)
      v = number_of[v];
  }
  return triangles;
}

std::vector<Vec3> PatchState::positions_in_mesh_order() const {
  std::vector<Vec3> positions(patch_.positions().begin(), patch_.positions().end());
  for (std::size_t v = 0; v < vertex_count(); ++v) {
    if (position(v) != origin(v)) positions[vertex_of_[v]] = (1.0 / scale_) * position(v);
  }
  return positions;
}

}  // namespace planish
