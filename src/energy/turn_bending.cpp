#include "energy/turn_bending.h"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/math.h"

namespace planish {

namespace {

double turn_at(const std::array<Index, 3>& vertices, const std::vector<Vec2>& flat) {
  const Vec2 before = flat[vertices[1]] - flat[vertices[0]];
  const Vec2 after = flat[vertices[2]] - flat[vertices[1]];
  return math::atan2(cross(before, after), dot(before, after));
}

/// The turn less the free one, between half turns to either side.
double change_of(const TurnBending::Turn& turn, const std::vector<Vec2>& flat) {
  constexpr double whole = 2.0 * std::numbers::pi;
  const double change = turn_at(turn.vertices, flat) - turn.free;
  return change - whole * std::round(change / whole);
}

/// By how much the direction of a line turns as its end moves.
Vec2 turning_of(Vec2 line) {
  return (1.0 / dot(line, line)) * Vec2{0.0 - line.y, line.x};
}

}  // namespace

TurnBending::TurnBending(std::vector<Turn> turns, const std::vector<Vec2>& like)
    : turns_(std::move(turns)) {
  for (Turn& turn : turns_)
    turn.free = turn_at(turn.vertices, like);
}

double TurnBending::value(const std::vector<Vec2>& flat) const {
  double sum = 0.0;
  for (const Turn& turn : turns_) {
    const double change = change_of(turn, flat);
    sum += turn.weight * change * change;
  }
  return sum;
}

Summand<3, Vec2> TurnBending::summand(std::size_t turn, const std::vector<Vec2>& flat,
                                      double factor) const {
  const auto& v = turns_[turn].vertices;
  const Vec2 first = turning_of(flat[v[1]] - flat[v[0]]);
  const Vec2 last = turning_of(flat[v[2]] - flat[v[1]]);
  const double twice = 2.0 * factor * turns_[turn].weight;
  return {v, twice * change_of(turns_[turn], flat), twice, {first, Vec2{} - first - last, last}};
}

}  // namespace planish
