#include "unfold/stretch/border_bend.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "core/math.h"

namespace planish {

namespace {

double turn_at(const Triangle& vertices, const std::vector<Vec2>& flat) {
  const Vec2 before = flat[vertices[1]] - flat[vertices[0]];
  const Vec2 after = flat[vertices[2]] - flat[vertices[1]];
  return math::atan2(cross(before, after), dot(before, after));
}

/// The turn less the free one, between half turns to either side.
double change_of(const BorderBend::Turn& turn, const std::vector<Vec2>& flat) {
  constexpr double whole = 2.0 * std::numbers::pi;
  const double change = turn_at(turn.vertices, flat) - turn.free;
  return change - whole * std::round(change / whole);
}

/// By how much the direction of a line turns as its end moves.
Vec2 turning_of(Vec2 line) {
  return (1.0 / dot(line, line)) * Vec2{0.0 - line.y, line.x};
}

}  // namespace

BorderBend::BorderBend(const Disk& disk, const BorderLengths& lengths,
                       const std::vector<Vec2>& like) {
  constexpr double k_shortest = 0.05;  // of the mean
  const std::size_t n = disk.border.size();
  double total = 0.0;
  for (const double length : lengths.of_edges)
    total += length;
  const double shortest = k_shortest * total / static_cast<double>(n);
  for (std::size_t k = 0; k < n; ++k) {
    const std::size_t before =
        (k + n - 1) % n;  // the edge that ends here, and the vertex it is from
    const double least = std::min(lengths.of_edges[before], lengths.of_edges[k]);
    if (!(least > shortest) || (lengths.may_change(before) && lengths.may_change(k))) continue;
    Turn turn{{disk.border[before], disk.border[k], disk.border[(k + 1) % n]}};
    turn.free = turn_at(turn.vertices, like);
    turn.weight = k_stiffness / (0.5 * (lengths.of_edges[before] + lengths.of_edges[k]));
    turns_.push_back(turn);
  }
}

double BorderBend::energy(const std::vector<Vec2>& flat) const {
  double energy = 0.0;
  for (const Turn& turn : turns_)
    energy += energy_of(turn, flat);
  return energy;
}

double BorderBend::energy_of(const Turn& turn, const std::vector<Vec2>& flat) {
  const double change = change_of(turn, flat);
  return turn.weight * change * change;
}

BorderBend::Derivatives BorderBend::derivatives(const Turn& turn, const std::vector<Vec2>& flat,
                                                double times) {
  const Triangle& v = turn.vertices;
  const Vec2 first = turning_of(flat[v[1]] - flat[v[0]]);
  const Vec2 last = turning_of(flat[v[2]] - flat[v[1]]);
  const std::array<double, 6> of_angle = {
      first.x, first.y, 0.0 - first.x - last.x, 0.0 - first.y - last.y, last.x, last.y};
  const double twice = 2.0 * times * turn.weight, change = change_of(turn, flat);
  Derivatives result;
  for (std::size_t i = 0; i < 6; ++i) {
    result.gradient[i] = twice * change * of_angle[i];
    for (std::size_t j = 0; j < 6; ++j)
      result.hessian[i][j] = twice * of_angle[i] * of_angle[j];
  }
  return result;
}

}  // namespace planish
