#include "energy/move_barrier.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "core/neumaier_sum.h"

namespace planish {

namespace {

constexpr double k_infinity = std::numeric_limits<double>::infinity();
/// Weight of the barrier, and the fraction of a limit at which it is 1.
constexpr double k_barrier_weight = 0.3, k_barrier_share = 0.85;
/// A move counts as at its limit from this fraction of the limit on.
constexpr double k_reached = 0.95;

double eighth_power(double x) {
  const double square = x * x, fourth = square * square;
  return fourth * fourth;
}

}  // namespace

MoveBarrier::MoveBarrier(std::vector<double> reach, std::vector<double> counts)
    : reach_(std::move(reach)), weight_(std::move(counts)) {
  for (double& weight : weight_)
    weight = k_barrier_weight / weight;
}

double MoveBarrier::value(const std::vector<Vec3>& moves) const {
  NeumaierSum sum;
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (reach_[v] < k_infinity)
      sum.add(weight_[v] * eighth_power(norm(moves[v]) / (k_barrier_share * reach_[v])));
  }
  return sum.value();
}

MoveBarrier::Derivatives MoveBarrier::derivatives(Index v, Vec3 move, double stiff) const {
  const double length = norm(move), unit = 1.0 / (k_barrier_share * reach_[v]);
  if (!(reach_[v] < k_infinity) || !(length > 0.0)) return {};
  const double q = length * unit, sixth = q * q * q * q * q * q;
  const double across = 8.0 * weight_[v] * sixth * unit * unit;
  const double a = stiff * across, b = 6.0 * a;
  const Vec3 n = (1.0 / length) * move;
  return {across * move,
          {a + b * n.x * n.x, b * n.x * n.y, b * n.x * n.z, a + b * n.y * n.y, b * n.y * n.z,
           a + b * n.z * n.z}};
}

bool MoveBarrier::is_reached(const std::vector<Vec3>& moves) const {
  for (std::size_t v = 0; v < moves.size(); ++v) {
    if (norm(moves[v]) > k_reached * reach_[v]) return true;
  }
  return false;
}

}  // namespace planish
