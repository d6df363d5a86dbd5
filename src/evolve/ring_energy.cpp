#include "evolve/ring_energy.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "evolve/laplacian.h"
#include "measure/angle_product.h"

namespace planish {

namespace {

constexpr double k_two_pi = 2.0 * std::numbers::pi;

/// The sum of the angles of two corners, 0 to 2 pi.
double angle_sum(Corner a, Corner b) {
  const double re = a.re * b.re - a.im * b.im;
  const double im = a.re * b.im + a.im * b.re;
  const double arg = std::atan2(im, re);
  // Two corners of exactly pi come out as 0.
  const bool full_turn = arg == 0.0 && (a.re < 0.0 || b.re < 0.0);
  return arg < 0.0 || full_turn ? arg + k_two_pi : arg;
}

/// Of the triangle between u, next and the edge that joins their ends: from the edge and the
/// shorter of the two, as then no angle of a needle loses digits.
double doubled_area(Vec3 u, Vec3 next, Vec3 edge) {
  return norm(cross(dot(u, u) < dot(next, next) ? u : next, edge));
}

/// A corner on the line with its derivative: angle' = (C S' - S C') / (C^2 + S^2).
struct MovingCorner {
  Corner corner;
  double rate = 0.0;
};

MovingCorner moving_corner(double c, double c_slope, double s, double s_slope) {
  const double size = c * c + s * s;
  return {{c, s}, size > 0.0 ? (c * s_slope - s * c_slope) / size : 0.0};
}

}  // namespace

void RingEnergy::look_at(const PatchState& state, std::size_t v) {
  vertex_ = v;
  start_ = state.position(v);
  const auto ring = state.ring(v);
  spokes_.resize(ring.size());
  for (std::size_t j = 0; j < ring.size(); ++j) {
    Spoke& spoke = spokes_[j];
    spoke.vertex = ring[j];
    spoke.place = state.position(ring[j]);
    spoke.inner = state.is_inner(ring[j]);
    spoke.rest = 0.0;
  }
  for (std::size_t j = 0; j < ring.size(); ++j) {
    spokes_[j].edge = spokes_[j + 1 < ring.size() ? j + 1 : 0].place - spokes_[j].place;
  }
  // With nothing known of the rest, minus the two angles at x comes out; then the rest is known.
  evaluate_at(start_);
  for (Spoke& spoke : spokes_) {
    if (spoke.inner) spoke.rest = state.defect(spoke.vertex) - spoke.defect;
  }
  energy_ = evaluate_at(start_);
}

Vec3 RingEnergy::laplacian() const {
  return edge_weighted_laplacian(start_, spokes_.size(),
                                 [this](std::size_t j) { return spokes_[j].place; });
}

void RingEnergy::set_line(Vec3 direction) {
  const double direction_squared = dot(direction, direction);
  for (std::size_t j = 0; j < spokes_.size(); ++j) {
    Spoke& spoke = spokes_[j];
    const Vec3 u = spoke.place - start_;
    const Vec3 next = spokes_[j + 1 < spokes_.size() ? j + 1 : 0].place - start_;
    const Vec3 normal = cross(u, next), turn = cross(spoke.edge, direction);
    const double along_edge = dot(direction, spoke.edge);
    spoke.apex = {dot(u, next), -dot(direction, u + next), direction_squared};
    spoke.base = {-dot(u, spoke.edge), along_edge, 0.0};
    spoke.next_base = {dot(next, spoke.edge), -along_edge, 0.0};
    spoke.area_squared = {dot(normal, normal), 2.0 * dot(normal, turn), dot(turn, turn)};
  }
}

LinePoint RingEnergy::along(double lambda) const {
  // Of the triangle before v_j, the corner at v_j.
  const auto next_base = [&](const Spoke& spoke) {
    const double s = std::sqrt(std::max(spoke.area_squared.at(lambda), 0.0));
    const double s_slope = s > 0.0 ? spoke.area_squared.slope(lambda) / (2.0 * s) : 0.0;
    return moving_corner(spoke.next_base.at(lambda), spoke.next_base.slope(lambda), s, s_slope);
  };
  LinePoint b{lambda, 0.0, 0.0, 0.0};
  const auto add_defect = [&b](double defect, double angle_rate) {
    b.value += defect * defect;
    b.slope -= 2.0 * defect * angle_rate;
    b.curvature += 2.0 * angle_rate * angle_rate;
  };
  AngleProduct own;
  double own_rate = 0.0;
  MovingCorner before = next_base(spokes_.back());
  for (const Spoke& spoke : spokes_) {
    const double s = std::sqrt(std::max(spoke.area_squared.at(lambda), 0.0));
    const double s_slope = s > 0.0 ? spoke.area_squared.slope(lambda) / (2.0 * s) : 0.0;
    const auto corner = [&](const Quadratic& c) {
      return moving_corner(c.at(lambda), c.slope(lambda), s, s_slope);
    };
    const MovingCorner apex = corner(spoke.apex);
    own.add(apex.corner);
    own_rate += apex.rate;
    if (spoke.inner) {
      const MovingCorner base = corner(spoke.base);
      add_defect(spoke.rest - angle_sum(before.corner, base.corner), before.rate + base.rate);
    }
    before = corner(spoke.next_base);
  }
  add_defect(own.defect(), own_rate);
  return b;
}

double RingEnergy::evaluate_at(Vec3 x) {
  // Errors in a defect: a few units in the last place of 2 pi for a neighbour, whose defect went
  // through several updates in a sweep; one per corner for the vertex itself.
  constexpr double neighbour_error = 1e-14;
  const double own_error = 1e-15 * static_cast<double>(spokes_.size() + 4);
  double energy = 0.0, error = 0.0;
  Vec3 u = spokes_.back().place - x;
  Vec3 next = spokes_.front().place - x;
  Corner before{dot(next, spokes_.back().edge), doubled_area(u, next, spokes_.back().edge)};
  AngleProduct own;
  for (std::size_t j = 0; j < spokes_.size(); ++j) {
    Spoke& spoke = spokes_[j];
    u = next;
    next = spokes_[j + 1 < spokes_.size() ? j + 1 : 0].place - x;
    const double s = doubled_area(u, next, spoke.edge);
    own.add({dot(u, next), s});
    if (spoke.inner) {
      spoke.defect = spoke.rest - angle_sum(before, {-dot(u, spoke.edge), s});
      energy += spoke.defect * spoke.defect;
      error += neighbour_error * (2.0 * std::abs(spoke.defect) + neighbour_error);
    }
    before = {dot(next, spoke.edge), s};
  }
  own_defect_ = own.defect();
  rounding_error_ = error + own_error * (2.0 * std::abs(own_defect_) + own_error);
  return energy + own_defect_ * own_defect_;
}

bool RingEnergy::keeps_lengths(Vec3 x) const {
  return std::none_of(spokes_.begin(), spokes_.end(), [x](const Spoke& spoke) {
    const Vec3 u = spoke.place - x;
    return dot(u, u) == 0.0;
  });
}

bool RingEnergy::keeps_angles(Vec3 x, double limit) const {
  // The smallest angle of a triangle has the largest cotangent, C / S.
  const auto smallest_angle = [&](const Spoke& spoke, Vec3 at) {
    const Vec3 u = spoke.place - at, next = u + spoke.edge;
    const double largest_dot = std::max({dot(u, next), -dot(u, spoke.edge), dot(next, spoke.edge)});
    return std::atan2(norm(cross(u, next)), largest_dot);
  };
  return std::all_of(spokes_.begin(), spokes_.end(), [&](const Spoke& spoke) {
    return smallest_angle(spoke, x) >= std::min(limit, smallest_angle(spoke, start_));
  });
}

void RingEnergy::move_to(Vec3 x, PatchState& state) const {
  state.move(vertex_, x);
  state.set_defect(vertex_, own_defect_);
  for (const Spoke& spoke : spokes_) {
    if (spoke.inner) state.set_defect(spoke.vertex, spoke.defect);
  }
}

}  // namespace planish
