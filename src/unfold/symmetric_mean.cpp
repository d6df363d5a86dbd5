#include "unfold/symmetric_mean.h"

#include <cstddef>

#include "core/neumaier_sum.h"

namespace planish {

namespace {

Vec2 product(Vec2 a, Vec2 b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}

}  // namespace

// Places are complex numbers z, partners w, from the mean of all. Of the mirrorings w -> u conj(w)
// with |u| = 1 the one that brings the partners nearest to the places has u along the sum of z w.
std::vector<Vec2> symmetric_mean(std::vector<Vec2> places, std::span<const Vec2> partners,
                                 std::span<const double> shares) {
  NeumaierSum x, y;
  for (std::size_t i = 0; i < places.size(); ++i) {
    x.add(places[i].x + partners[i].x);
    y.add(places[i].y + partners[i].y);
  }
  const double each = places.empty() ? 0.0 : 0.5 / static_cast<double>(places.size());
  const Vec2 middle = each * Vec2{x.value(), y.value()};
  NeumaierSum real, imaginary;
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec2 both = product(places[i] - middle, partners[i] - middle);
    real.add(both.x);
    imaginary.add(both.y);
  }
  Vec2 turn = {real.value(), imaginary.value()};
  turn = norm(turn) > 0.0 ? 1.0 / norm(turn) * turn : Vec2{1.0, 0.0};
  for (std::size_t i = 0; i < places.size(); ++i) {
    const Vec2 w = partners[i] - middle;
    const Vec2 mirrored = middle + product(turn, {w.x, 0.0 - w.y});
    places[i] = places[i] + shares[i] * (mirrored - places[i]);
  }
  return places;
}

}  // namespace planish
