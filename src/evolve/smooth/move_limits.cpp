#include "evolve/smooth/move_limits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "core/careful_sum.h"
#include "evolve/descent/tuning.h"

namespace planish {

using namespace tuning::prefer_smooth;

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();

double eighth_power(double x) {
  const double square = x * x, fourth = square * square;
  return fourth * fourth;
}

}  // namespace

MoveLimits::MoveLimits(const DescentLimits& limits, const BorderMotion& border,
                       std::size_t inner_count, double unit)
    : bends_(border.bends()) {
  const std::size_t count = border.vertex_count(), of_border = count - inner_count;
  const bool within = limits.border.rule == BorderFreedom::Rule::within;
  const double border_reach =
      within ? std::min(limits.deviation, limits.border.distance) : limits.deviation;
  reach_.assign(count, limits.deviation);
  weight_.assign(count,
                 k_barrier_weight / static_cast<double>(std::max<std::size_t>(inner_count, 1)));
  for (std::size_t v = inner_count; v < count; ++v) {
    reach_[v] = border_reach;
    weight_[v] = k_barrier_weight / static_cast<double>(of_border);
  }
  if (bends_.empty()) return;
  const double length = k_border_bend * unit;
  bend_weight_ = 1.0 / (static_cast<double>(bends_.size()) * length * length);
}

Vec3 MoveLimits::bend_of(const BorderMotion::Bend& bend, const Positions& moves) const {
  Vec3 sum;
  for (std::size_t k = 0; k < 3; ++k) {
    if (bend.vertices[k] < moves.size()) sum += bend.weights[k] * moves[bend.vertices[k]];
  }
  return sum;
}

double MoveLimits::value(const Positions& moves) const {
  CarefulSum sum;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (reach_[v] < k_infinity)
      sum.add(weight_[v] * eighth_power(norm(moves[v]) / (k_barrier_share * reach_[v])));
  }
  for (const BorderMotion::Bend& bend : bends_) {
    const Vec3 f = bend_of(bend, moves);
    sum.add(bend_weight_ * dot(f, f));
  }
  return sum.value();
}

void MoveLimits::add_to(KktSystem& system, Positions& force, const Positions& moves,
                        double stiff) const {
  for (Index v = 0; v < moves.size(); ++v) {
    const double length = norm(moves[v]), unit = 1.0 / (k_barrier_share * reach_[v]);
    if (!(reach_[v] < k_infinity) || !(length > 0.0)) continue;
    const double q = length * unit, sixth = q * q * q * q * q * q;
    const double across = 8.0 * weight_[v] * sixth * unit * unit;
    const Vec3 n = (1.0 / length) * moves[v];
    force[v] += -across * moves[v];
    const double a = stiff * across, b = 6.0 * a;
    system.add_vertex(v, {a + b * n.x * n.x, b * n.x * n.y, b * n.x * n.z, a + b * n.y * n.y,
                          b * n.y * n.z, a + b * n.z * n.z});
  }
  for (std::size_t k = 0; k < bends_.size(); ++k) {
    const Vec3 f = bend_of(bends_[k], moves);
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}}) {
      std::array<Vec3, 3> gradient;
      for (std::size_t j = 0; j < 3; ++j)
        gradient[j] = bends_[k].weights[j] * axis;
      system.add_term(std::to_array(bends_[k].vertices), stiff * 2.0 * bend_weight_, gradient);
    }
    for (std::size_t j = 0; j < 3; ++j) {
      const Index v = bends_[k].vertices[j];
      if (v < force.size()) force[v] += -2.0 * bend_weight_ * bends_[k].weights[j] * f;
    }
  }
}

bool MoveLimits::is_reached(const Positions& moves) const {
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (norm(moves[v]) > k_reached * reach_[v]) return true;
  }
  return false;
}

}  // namespace planish
