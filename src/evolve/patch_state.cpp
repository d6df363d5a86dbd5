#include "evolve/patch_state.h"

#include <utility>

#include "evolve/coloring.h"
#include "evolve/spatial_order.h"
#include "measure/angle_product.h"

namespace planish {

namespace {

/// Puts what is of one colour together and keeps the order within; returns where each begins.
std::vector<std::size_t> sort_by_color(std::vector<Index>& order,
                                       const std::vector<Index>& colors) {
  std::vector<std::size_t> start(1, 0);
  for (const Index v : order) {
    if (colors[v] + 2 > start.size()) start.resize(colors[v] + 2, 0);
    ++start[colors[v] + 1];
  }
  for (std::size_t c = 1; c < start.size(); ++c)
    start[c] += start[c - 1];
  std::vector<std::size_t> next = start;
  std::vector<Index> sorted(order.size());
  for (const Index v : order)
    sorted[next[colors[v]]++] = v;
  order = std::move(sorted);
  return start;
}

}  // namespace

PatchState::PatchState(const TriMesh& mesh, const Connectivity& connectivity)
    : scale_(unit_scale(mesh)), origins_(mesh.positions) {
  const auto inner = connectivity.inner_vertices();
  std::vector<Vec3> scaled;
  scaled.reserve(origins_.size());
  for (const Vec3 p : origins_)
    scaled.push_back(scale_ * p);
  vertex_of_ = spatial_order(scaled, inner);
  color_start_ = sort_by_color(vertex_of_, distance_two_colors(connectivity, vertex_of_));
  std::vector<Index> border;
  for (const auto& loop : connectivity.border_loops()) {
    border.insert(border.end(), loop.begin(), loop.end());
  }
  vertex_of_.insert(vertex_of_.end(), border.begin(), border.end());

  std::vector<Index> number_of(origins_.size(), 0);
  for (std::size_t v = 0; v < vertex_of_.size(); ++v) {
    number_of[vertex_of_[v]] = static_cast<Index>(v);
    const Vec3 p = scaled[vertex_of_[v]];
    x_.push_back(p.x), y_.push_back(p.y), z_.push_back(p.z);
  }
  ring_start_.push_back(0);
  for (std::size_t v = 0; v < inner.size(); ++v) {
    for (const Index j : connectivity.ring(vertex_of_[v]))
      rings_.push_back(number_of[j]);
    ring_start_.push_back(rings_.size());
  }
  moved_.assign(inner.size(), 0);
  defects_.assign(inner.size(), 0.0);
  refresh_defects(0, inner.size());
}

void PatchState::refresh_defects(std::size_t begin, std::size_t end) {
  for (std::size_t v = begin; v < end; ++v) {
    const auto neighbours = ring(v);
    defects_[v] = star_defect(position(v), neighbours.size(),
                              [&](std::size_t j) { return position(neighbours[j]); });
  }
}

std::vector<double> PatchState::defects_in_mesh_order() const {
  std::vector<double> defects(origins_.size(), 0.0);
  for (std::size_t v = 0; v < inner_count(); ++v)
    defects[vertex_of_[v]] = defects_[v];
  return defects;
}

std::vector<Vec3> PatchState::positions_in_mesh_order() const {
  std::vector<Vec3> positions = origins_;
  for (std::size_t v = 0; v < inner_count(); ++v) {
    if (moved_[v] != 0) positions[vertex_of_[v]] = (1.0 / scale_) * position(v);
  }
  return positions;
}

}  // namespace planish
