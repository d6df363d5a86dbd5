#include "evolve/systems/places.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/vertex_normal.h"

namespace planish {

Places sum_of(Places a, double s, const Places& b) {
  for (std::size_t v = 0; v < a.size(); ++v)
    a[v] += s * b[v];
  return a;
}

double norm_of(const Places& a) {
  double sum = 0.0;
  for (const Vec3 p : a)
    sum += dot(p, p);
  return std::sqrt(sum);
}

Places first_places(const PatchState& state, std::size_t count) {
  Places places;
  for (std::size_t v = 0; v < count; ++v)
    places.push_back(state.position(v));
  return places;
}

Places inner_places(const PatchState& state) {
  return first_places(state, state.inner_count());
}

TriMesh mesh_at_first(const PatchState& state) {
  TriMesh mesh;
  for (std::size_t v = 0; v < state.vertex_count(); ++v)
    mesh.positions.push_back((1.0 / state.scale()) * state.origin(v));
  mesh.triangles = state.triangles();
  return mesh;
}

Eigen::VectorXd inner_defects(const PatchState& state) {
  Eigen::VectorXd defects(static_cast<Eigen::Index>(state.inner_count()));
  for (std::size_t v = 0; v < state.inner_count(); ++v)
    defects[static_cast<Eigen::Index>(v)] = state.defect(v);
  return defects;
}

std::size_t move_to(const Places& places, const AngleJacobian& jacobian, PatchState& state) {
  const bool sound =
      std::all_of(places.begin(), places.end(), [](Vec3 p) { return std::isfinite(dot(p, p)); });
  std::size_t moved = 0;
  for (Index v = 0; sound && v < places.size(); ++v) {
    if (!jacobian.is_movable(v) || places[v] == state.position(v)) continue;
    state.move(v, places[v]);
    ++moved;
  }
  return moved;
}

Places within_distance(Places places, const Places& origin, std::size_t inner_count,
                       double distance) {
  if (std::isinf(distance)) return places;
  for (std::size_t v = 0; v < inner_count; ++v) {
    const Vec3 away = places[v] - origin[v];
    const double far = norm(away);
    if (far > distance) places[v] = origin[v] + (distance / far) * away;
  }
  return places;
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
