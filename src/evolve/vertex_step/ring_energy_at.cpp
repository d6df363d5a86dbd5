#include "evolve/vertex_step/ring_energy_at.h"

#include <numbers>

#include "core/math.h"
#include "geometry/angle_gradient.h"
#include "geometry/triangle_shape.h"

namespace planish {

RingEnergyAt::Corners RingEnergyAt::corners(Vec3 x, std::size_t j) const {
  const Vec3 p = ring_[j].place, q = ring_[next(j)].place;
  const Vec3 u = p - x, w = q - x, e = q - p;
  const double area = norm(cross(u, w));
  return {math::atan2(area, dot(u, w)), math::atan2(area, -dot(u, e)),
          math::atan2(area, dot(w, e))};
}

template <class Body>
void RingEnergyAt::for_defects(Vec3 x, const Body& body) const {
  const std::size_t n = ring_.size();
  const Corners last = corners(x, n - 1);
  double before = last.at_next, own = 2.0 * std::numbers::pi;
  for (std::size_t j = 0; j < n; ++j) {
    const Corners now = j + 1 < n ? corners(x, j) : last;
    body(ring_[j].inner ? ring_[j].rest - before - now.at_this : 0.0);
    before = now.at_next;
    own -= now.at_center;
  }
  body(own);
}

RingEnergyAt::RingEnergyAt(const PatchState& state, Index center, std::span<const Index> ring,
                           std::span<const double> defects) {
  ring_.reserve(ring.size());
  for (const Index j : ring) {
    const bool inner = state.is_inner(j);
    ring_.push_back({state.position(j), inner, inner ? defects[j] : 0.0});
  }
  const Vec3 x = state.position(center);
  for (std::size_t j = 0; j < ring_.size(); ++j) {
    const Corners now = corners(x, j);
    ring_[j].rest += now.at_this;
    ring_[next(j)].rest += now.at_next;
  }
}

double RingEnergyAt::value(Vec3 x) const {
  double energy = 0.0;
  for_defects(x, [&energy](double d) { energy += d * d; });
  return energy;
}

std::vector<double> RingEnergyAt::defects(Vec3 x) const {
  std::vector<double> defects;
  defects.reserve(ring_.size() + 1);
  for_defects(x, [&defects](double d) { defects.push_back(d); });
  return defects;
}

StarSample RingEnergyAt::along(Vec3 x, Vec3 direction) const {
  const std::size_t n = ring_.size();
  std::vector<double> rates(n + 1, 0.0);  // of the angle sums, in the order of defects()
  for (std::size_t j = 0; j < n; ++j) {
    const Vec3 p = ring_[j].place, q = ring_[next(j)].place;
    if (ring_[j].inner) rates[j] += dot(angle_gradient(p, q, x).at_r, direction);
    if (ring_[next(j)].inner) rates[next(j)] += dot(angle_gradient(q, x, p).at_q, direction);
    rates[n] += dot(angle_gradient(x, p, q).at_p, direction);
  }
  StarSample energy;
  auto rate = rates.cbegin();
  for_defects(x, [&](double d) {
    const double r = *rate++;
    energy.value += d * d;
    energy.slope -= 2.0 * d * r;
    energy.curvature += 2.0 * r * r;
  });
  return energy;
}

bool RingEnergyAt::has_needle(Vec3 x) const {
  for (std::size_t j = 0; j < ring_.size(); ++j) {
    // Also where the shape is no number.
    if (!(triangle_shape(x, ring_[j].place, ring_[next(j)].place) >= k_least_shape)) return true;
  }
  return false;
}

}  // namespace planish
