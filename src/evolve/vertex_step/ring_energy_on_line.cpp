// The arctangent is the library's own, so that no two systems give different bits.
#define PLANISH_ISA ring_energy_on_line_lanes
#define PLANISH_LANES 2
#include "evolve/vertex_step/ring_energy_on_line.h"

#include <algorithm>
#include <cmath>

#include "core/simd/arctangent.h"
#include "geometry/laplacian.h"

namespace planish {

namespace {

/// -pi to pi; NaN of 0.
double argument(double re, double im) {
  using namespace ring_energy_on_line_lanes;
  return ring_energy_on_line_lanes::argument({broadcast(re), broadcast(im)})[0];
}

}  // namespace

RingEnergyOnLine::RingEnergyOnLine(const Site* sites, const Star& star, std::size_t valence,
                                   double max_cotangent)
    : own_(sites[star.center].defect), spokes_(valence) {
  const auto position_of = [&](std::uint32_t v) {
    return Vec3{sites[v].x, sites[v].y, sites[v].z};
  };
  start_ = position_of(star.center);
  laplacian_ = edge_weighted_laplacian(start_, valence,
                                       [&](std::size_t j) { return position_of(star.ring[j]); });
  for (std::size_t j = 0; j < valence; ++j) {
    Spoke& spoke = spokes_[j];
    spoke.place = position_of(star.ring[j]);
    spoke.edge = position_of(star.ring[next(j)]) - spoke.place;
    spoke.normal_rate = -cross(laplacian_, spoke.edge);
    const double defect = sites[star.ring[j]].defect;
    spoke.inner = defect == defect;  // the border's is NaN
    spoke.defect = spoke.inner ? defect : 0.0;
  }
  for (std::size_t j = 0; j < valence; ++j) {
    Spoke& spoke = spokes_[j];
    spoke.start = base_at(j, start_);
    spoke.max_cotangent = std::max(max_cotangent, largest_cotangent(spoke.start));
  }
}

RingEnergyOnLine::Base RingEnergyOnLine::base_at(std::size_t j, Vec3 x) const {
  const Spoke& spoke = spokes_[j];
  const Vec3 u = spoke.place - x, u_next = spokes_[next(j)].place - x;
  Base base;
  base.square = dot(u, u), base.next_square = dot(u_next, u_next);
  // From the edge and the shorter spoke, as then no angle of a needle loses digits.
  base.normal = cross(base.next_square < base.square ? u_next : u, spoke.edge);
  const double doubled_area = norm(base.normal);
  base.here = {-dot(u, spoke.edge), doubled_area};
  base.next = {dot(u_next, spoke.edge), doubled_area};
  base.apex = dot(u, u_next);
  return base;
}

double RingEnergyOnLine::largest_cotangent(const Base& base) {
  return std::max({base.apex, base.here.re, base.next.re}) / base.here.im;
}

/// A corner (C, S) at the base has S = |N| with N linear in lambda, and C linear too. So
///   S' = N . N' / S,  S'' = (|N'|^2 - S'^2) / S,  C'' = 0,
///   angle' = (C S' - S C') / D,  angle'' = (C S'' - 2 (S S' + C C') angle') / D
/// with D = C^2 + S^2. Where the triangle has no area, S has a kink: its slopes are taken as 0.
RingEnergyOnLine::Turn RingEnergyOnLine::turn_of(const Corner& then, const Corner& now,
                                                 double cosine_rate, double size, const Base& base,
                                                 Vec3 normal_rate) {
  const double s = now.im, c = now.re;
  const double s_rate = s > 0.0 ? dot(base.normal, normal_rate) / s : 0.0;
  const double s_bend = s > 0.0 ? (dot(normal_rate, normal_rate) - s_rate * s_rate) / s : 0.0;
  Turn turn;
  turn.angle = argument(c * then.re + s * then.im, s * then.re - c * then.im);
  turn.rate = (c * s_rate - s * cosine_rate) / size;
  turn.acceleration = (c * s_bend - 2.0 * (s * s_rate + c * cosine_rate) * turn.rate) / size;
  return turn;
}

RingEnergyOnLine::Ring RingEnergyOnLine::at(Vec3 x) const {
  const std::size_t n = spokes_.size();
  Ring ring;
  std::vector<Turn> turns(n);
  for (std::size_t j = 0; j < n; ++j) {
    const Spoke& spoke = spokes_[j];
    const Base base = base_at(j, x);
    const double along = dot(laplacian_, spoke.edge), edge_square = dot(spoke.edge, spoke.edge);
    turns[j] += turn_of(spoke.start.here, base.here, along, base.square * edge_square, base,
                        spoke.normal_rate);
    turns[next(j)] += turn_of(spoke.start.next, base.next, -along, base.next_square * edge_square,
                              base, spoke.normal_rate);
    ring.sound &= !(largest_cotangent(base) > spoke.max_cotangent);
  }
  const auto add = [&ring](double defect, double rate, double acceleration) {
    ring.b.value += defect * defect;
    ring.b.slope += 2.0 * defect * rate;
    ring.b.curvature += 2.0 * (rate * rate + defect * acceleration);
  };
  // The angles of a triangle sum to pi: what the neighbours gain the vertex loses.
  Turn total;
  for (std::size_t j = 0; j < n; ++j) {
    total += turns[j];
    ring.defects.push_back(spokes_[j].inner ? spokes_[j].defect - turns[j].angle : 0.0);
    if (spokes_[j].inner) add(ring.defects[j], -turns[j].rate, -turns[j].acceleration);
  }
  ring.own = own_ + total.angle;
  add(ring.own, total.rate, total.acceleration);
  ring.sound &= ring.b.value == ring.b.value;
  return ring;
}

double RingEnergyOnLine::rounding_error(double value) const {
  // As in simd/ring_energy.h.
  constexpr double e = 1e-14;
  const auto count = static_cast<double>(spokes_.size() + 1);
  return 2.0 * e * std::sqrt(count * value) + count * (e * e);
}

void RingEnergyOnLine::write(Vec3 x, const Ring& ring, const Star& star, Site* sites,
                             Changes changes) const {
  sites[star.center] = {x.x, x.y, x.z, ring.own};
  changes.changed_at[star.center] = changes.now;
  for (std::size_t j = 0; j < spokes_.size(); ++j) {
    if (!spokes_[j].inner) continue;
    sites[star.ring[j]].defect = ring.defects[j];
    changes.changed_at[star.ring[j]] = changes.now;
  }
}

}  // namespace planish
