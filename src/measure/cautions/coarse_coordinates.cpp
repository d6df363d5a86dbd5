#include <algorithm>
#include <cmath>
#include <vector>

#include <planish/measure/cautions.h>

#include "measure/area.h"
#include "mesh/edges.h"

namespace planish {

namespace {

constexpr double k_large_step = 0.01;  // of the mean edge
// Numbers of 32 bits step by 2^-24 of themselves at least; of fewer than six digits may be round.
constexpr double k_finest_step = 1.0 / (1 << 25), k_coarsest_step = 1e-5;
constexpr double k_no_difference = 1.0 / (1 << 28);  // of the largest number: rounding
constexpr std::size_t k_fewest_numbers = 8;

/// The coordinates of an axis.
struct Axis {
  std::vector<double> numbers;  // in increasing order
  double largest = 0.0;         // of their sizes
};

template <class Coordinate>
Axis axis_of(const Patch& patch, const Coordinate& coordinate) {
  Axis axis;
  for (const Triangle& t : patch.triangles()) {
    for (const Index v : t)
      axis.largest = std::max(axis.largest, std::abs(coordinate(patch.positions()[v])));
  }
  return axis;
}

/// The largest number that divides all differences between numbers of the axis; 0 where that is
/// finer than any step that is sought.
double common_step(const Axis& axis) {
  const double nothing = k_no_difference * axis.largest, finest = k_finest_step * axis.largest;
  double step = 0.0;
  for (std::size_t i = 1; i < axis.numbers.size(); ++i) {
    double other = axis.numbers[i] - axis.numbers[i - 1];
    while (step > 0.0 && other > nothing) {
      const double left = std::abs(std::remainder(std::max(step, other), std::min(step, other)));
      step = std::min(step, other);
      other = left;
    }
    if (step == 0.0 && other > nothing) step = other;
    if (step > 0.0 && step < finest) return 0.0;
  }
  return step;
}

/// Whether the step is that of writing, and not of a grid on which the surface was designed: there
/// all edges along the axis have one length, and no more than a half of all edges have none.
template <class Coordinate>
bool is_of_writing(const Patch& patch, double step, const Coordinate& coordinate) {
  double first = 0.0;
  bool several = false;
  std::size_t edges = 0, without = 0;
  for_each_edge(patch.connectivity(), [&](const Edge& edge) {
    const double steps = std::round(std::abs(coordinate(patch.positions()[edge.to]) -
                                             coordinate(patch.positions()[edge.from])) /
                                    step);
    ++edges;
    if (steps == 0.0) {
      ++without;
      return;
    }
    if (first == 0.0) first = steps;
    several = several || steps != first;
  });
  return several || 2 * without > edges;
}

/// The step of 32-bit numbers of the size of the largest, where all numbers of the axis are such,
/// several, and some use their last bit: else they may be those of a design. 0 where not.
double step_of_floats(const Axis& axis) {
  const auto largest = static_cast<float>(axis.largest);
  if (!std::isfinite(largest) || axis.numbers.size() < 2) return 0.0;
  const double step =
      static_cast<double>(largest) - static_cast<double>(std::nextafter(largest, 0.0F));
  bool uses_last_bit = false;
  for (const double number : axis.numbers) {
    if (static_cast<double>(static_cast<float>(number)) != number) return 0.0;
    uses_last_bit = uses_last_bit || std::remainder(number, 2.0 * step) != 0.0;
  }
  return uses_last_bit ? step : 0.0;
}

/// By how much the numbers of an axis step; 0 where they have more digits than need be known.
template <class Coordinate>
double step_of(const Patch& patch, double mean_edge, const Coordinate& coordinate) {
  Axis axis = axis_of(patch, coordinate);
  if (!(k_coarsest_step * axis.largest > k_large_step * mean_edge)) return 0.0;
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    if (!patch.ring(v).empty()) axis.numbers.push_back(coordinate(patch.positions()[v]));
  }
  std::sort(axis.numbers.begin(), axis.numbers.end());
  axis.numbers.erase(std::unique(axis.numbers.begin(), axis.numbers.end()), axis.numbers.end());
  if (const double step = step_of_floats(axis); step > k_large_step * mean_edge) return step;
  if (axis.numbers.size() < k_fewest_numbers) return 0.0;
  const double step = common_step(axis);
  if (!(step > 0.0) || step > k_coarsest_step * axis.largest) return 0.0;
  return is_of_writing(patch, step, coordinate) ? step : 0.0;
}

}  // namespace

std::optional<CoarseCoordinates> find_coarse_coordinates(const Patch& patch) {
  const double mean_edge = mean_side_of(patch.mesh(), patch.unit_scale()) / patch.unit_scale();
  if (!(mean_edge > 0.0)) return std::nullopt;
  const double step = std::max({step_of(patch, mean_edge, [](Vec3 p) { return p.x; }),
                                step_of(patch, mean_edge, [](Vec3 p) { return p.y; }),
                                step_of(patch, mean_edge, [](Vec3 p) { return p.z; })});
  if (!(step > k_large_step * mean_edge)) return std::nullopt;
  return CoarseCoordinates{step, mean_edge};
}

}  // namespace planish
