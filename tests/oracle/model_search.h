#pragma once

// The line search of the sweep for one vertex, with plain branches.

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <utility>

#include "evolve/vertex_step/interval.h"
#include "oracle/series.h"

namespace planish::plain {

/// A polynomial with its derivatives.
struct Polynomial {
  std::array<double, 6> c{};

  double at(double t) const { return derived(t, 0); }
  double slope(double t) const { return derived(t, 1); }
  double curvature(double t) const { return derived(t, 2); }

 private:
  double derived(double t, int times) const {
    double sum = 0.0;
    for (int k = times; k < 6; ++k) {
      double factor = 1.0;
      for (int i = 0; i < times; ++i)
        factor *= k - i;
      sum += factor * c[static_cast<std::size_t>(k)] * std::pow(t, k - times);
    }
    return sum;
  }
};

struct Found {
  double at = 0.0, value = 0.0;
  int evaluations = 0;
};

/// Goes down from 0 on the interval to a minimum of f, the sum of the squares of what the residuals
/// are the beginnings of. See LineSearch, which must take the same steps.
template <class F>
Found search_on_line(std::span<const Series> residuals, const F& f, Interval interval) {
  Polynomial model;
  double spread = 0.0;
  for (const Series& r : residuals) {
    for (std::size_t i = 0; i < 4; ++i) {
      for (std::size_t j = 0; j < 4 && i + j < 5; ++j)
        model.c[i + j] += r.c[i] * r.c[j];
    }
    spread += r.c[1] * r.c[1];
  }
  Found best{0.0, model.c[0]};
  const bool upward = model.c[1] < 0.0;
  double inner = 0.0, outer = upward ? interval.high : interval.low;
  bool outer_tried = false;
  if (model.c[1] == 0.0 || outer == 0.0) return best;

  Polynomial corrected = model;
  const auto bettered = [&](double place) {
    const double slope = corrected.slope(place), bend = corrected.curvature(place);
    const auto [low, high] = std::minmax(inner, outer);
    if (bend > 0.0) return std::clamp(place - slope / bend, low, high);
    if (place != best.at) return place;
    return slope < 0.0 ? high : low;
  };
  double from = -0.5 * model.c[1] / spread;
  if (!(from > std::min(inner, outer) && from < std::max(inner, outer))) from = outer;
  from = bettered(from);
  double last_place = 0.0, last_lack = 0.0;
  bool foretold = false;
  for (best.evaluations = 1; best.evaluations < 16; ++best.evaluations) {
    double place = bettered(from);
    if (place == inner || (place == outer && outer_tried)) place = 0.5 * (best.at + place);
    if (std::abs(place - best.at) < 1e-3 * std::min(1.0, interval.high - interval.low)) {
      if (foretold || best.at == 0.0) break;
      place = best.at - 0.1 * (best.at - inner);
    }
    const double value = f(place);
    foretold = std::abs(value - corrected.at(place)) <= 5e-3 * (model.c[0] - value);
    const bool better = value < best.value;
    const bool further = upward ? place > best.at : place < best.at;
    if (better && place == outer) outer_tried = true;
    const double tried = better ? best.at : place;
    if (better == further) {
      inner = tried;
    } else {
      outer = tried;
      outer_tried = true;
    }
    if (better) best.at = place, best.value = value;
    const double lack = (value - model.at(place)) / std::pow(place, 4);
    const double rise =
        last_place != 0.0 && place != last_place ? (lack - last_lack) / (place - last_place) : 0.0;
    corrected.c[4] = model.c[4] + lack - rise * place;
    corrected.c[5] = rise;
    last_place = place, last_lack = lack;
    from = best.at;
  }
  return best;
}

}  // namespace planish::plain
