#include "evolve/systems/positions.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "geometry/vertex_normal.h"
#include "mesh/border_loops.h"

namespace planish {

Positions sum_of(Positions a, double s, const Positions& b) {
  for (std::size_t v = 0; v < a.size(); ++v)
    a[v] += s * b[v];
  return a;
}

double norm_of(const Positions& a) {
  double sum = 0.0;
  for (const Vec3 p : a)
    sum += dot(p, p);
  return std::sqrt(sum);
}

Positions first_positions(const PatchState& state, std::size_t count) {
  Positions positions;
  positions.reserve(count);
  for (std::size_t v = 0; v < count; ++v)
    positions.push_back(state.position(v));
  return positions;
}

Positions all_positions(const PatchState& state) {
  return first_positions(state, state.vertex_count());
}

Positions first_origins(const PatchState& state, std::size_t count) {
  Positions origins;
  origins.reserve(count);
  for (std::size_t v = 0; v < count; ++v)
    origins.push_back(state.origin(v));
  return origins;
}

Positions inner_positions(const PatchState& state) {
  return first_positions(state, state.inner_count());
}

TriMesh mesh_at_first(const PatchState& state) {
  TriMesh mesh;
  mesh.positions.reserve(state.vertex_count());
  for (std::size_t v = 0; v < state.vertex_count(); ++v)
    mesh.positions.push_back((1.0 / state.scale()) * state.origin(v));
  mesh.triangles = state.triangles();
  return mesh;
}

AngleJacobian angle_jacobian_of(const PatchState& state,
                                std::span<const unsigned char> border_movable,
                                std::vector<HoleBorder> holes) {
  // Rows that share a vertex make a dense block of A A^T; a larger one than this is not worth it.
  constexpr std::size_t most_neighbours = 256;
  std::vector<std::span<const Index>> rings = rings_by_vertex(state.plan());
  std::vector<unsigned char> movable;
  for (Index v = 0; v < rings.size(); ++v)
    movable.push_back(!state.is_fixed(v) && rings[v].size() <= most_neighbours ? 1 : 0);
  movable.insert(movable.end(), border_movable.begin(), border_movable.end());
  return {std::move(rings), std::move(movable), std::move(holes)};
}

std::vector<HoleBorder> hole_borders_of(const PatchState& state) {
  const Patch& patch = state.patch();
  std::vector<HoleBorder> holes;
  const std::vector<std::size_t> loops = hole_loops(patch);
  if (state.inner_count() == 0 || loops.empty()) return holes;
  std::vector<Index> number_of(patch.vertex_count(), 0);
  for (Index v = 0; v < state.vertex_count(); ++v)
    number_of[state.vertex_of(v)] = v;
  for (const std::size_t k : loops) {
    HoleBorder& hole = holes.emplace_back();
    for (const Index b : patch.border_loops()[k]) {
      hole.loop.push_back(number_of[b]);
      std::vector<Index>& ring = hole.rings.emplace_back();
      for (const Index w : patch.ring(b))
        ring.push_back(number_of[w]);
      hole.around.insert(hole.around.end(), ring.begin(), ring.end());
    }
    std::sort(hole.around.begin(), hole.around.end());
    hole.around.erase(std::unique(hole.around.begin(), hole.around.end()), hole.around.end());
  }
  return holes;
}

bool holes_close(const Patch& patch, std::vector<Vec3> positions, double share) {
  if (hole_loops(patch).empty()) return true;
  const Flattenability figures = measure(patch.with_positions(std::move(positions)));
  return std::max(figures.hole_turning, figures.hole_gap) <= share * k_flattenable_sum;
}

Eigen::VectorXd inner_defects(const PatchState& state) {
  Eigen::VectorXd defects(static_cast<Eigen::Index>(state.inner_count()));
  for (std::size_t v = 0; v < state.inner_count(); ++v)
    defects[static_cast<Eigen::Index>(v)] = state.defect(v);
  return defects;
}

std::size_t set_positions(const Positions& positions, const AngleJacobian& jacobian,
                          PatchState& state) {
  const bool sound = std::all_of(positions.begin(), positions.end(),
                                 [](Vec3 p) { return std::isfinite(dot(p, p)); });
  std::size_t moved = 0;
  for (Index v = 0; sound && v < positions.size(); ++v) {
    if (!jacobian.is_movable(v) || positions[v] == state.position(v)) continue;
    state.move(v, positions[v]);
    ++moved;
  }
  return moved;
}

Positions within_distance(Positions positions, const Positions& origin, std::size_t inner_count,
                          double distance) {
  if (std::isinf(distance)) return positions;
  for (std::size_t v = 0; v < inner_count; ++v) {
    const Vec3 away = positions[v] - origin[v];
    const double far = norm(away);
    if (far > distance) positions[v] = origin[v] + (distance / far) * away;
  }
  return positions;
}

Positions symmetric_about(const Positions& origin, const MirrorOrbits& orbits,
                          Positions positions) {
  if (!orbits.is_symmetric()) return positions;
  return sum_of(origin, 1.0, orbits.symmetric(sum_of(std::move(positions), -1.0, origin)));
}

Vec3 normal_at(Index v, const AngleJacobian& jacobian, const PatchState& state) {
  const auto ring = jacobian.ring(v);
  return vertex_normal(state.position(v), ring.size(),
                       [&](std::size_t j) { return state.position(ring[j]); });
}

EdgeLengths edges_at(Index v, const AngleJacobian& jacobian, const PatchState& state) {
  EdgeLengths lengths{0.0, std::numeric_limits<double>::infinity()};
  const auto ring = jacobian.ring(v);
  for (const Index w : ring) {
    const double length = norm(state.position(w) - state.position(v));
    lengths.mean += length / static_cast<double>(ring.size());
    lengths.shortest = std::min(lengths.shortest, length);
  }
  return lengths;
}

double mean_edge(const AngleJacobian& jacobian, const PatchState& state) {
  double sum = 0.0;
  for (Index v = 0; v < state.inner_count(); ++v)
    sum += edges_at(v, jacobian, state).mean;
  return sum / static_cast<double>(state.inner_count());
}

}  // namespace planish
