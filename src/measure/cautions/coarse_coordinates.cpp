#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <vector>

#include <planish/measure/cautions.h>

#include "core/math.h"
#include "measure/area.h"
#include "measure/cautions/decimal_digits.h"
#include "measure/cautions/straight_rows.h"

namespace planish {

namespace {

constexpr double k_large_step = 0.01;  // of the mean edge
// Numbers of eight digits step by 1e-8 of themselves at least; of fewer than five they may be
// round.
constexpr double k_finest_step = 1e-8, k_coarsest_step = 1e-4;
constexpr double k_often_of_designs = 1e-5;  // steps above this, as whole millimetres at 12 m
constexpr int k_fewest_digits = 5, k_most_digits = 8, k_most_digits_of_float = 9;
constexpr double k_no_difference = 0x1p-32;  // of the largest number: rounding
constexpr std::size_t k_fewest_numbers = 5;

/// The coordinates of an axis.
struct Axis {
  double Vec3::*coordinate;
  std::vector<double> numbers = {};  // all that differ, in increasing order
  double largest = 0.0;              // of their sizes

  bool is_far(double mean_edge) const {
    return k_coarsest_step * largest > k_large_step * mean_edge;
  }
};

Axis axis_of(const Patch& patch, double Vec3::*coordinate) {
  Axis axis{coordinate};
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    if (!patch.ring(v).empty())
      axis.largest = std::max(axis.largest, std::abs(patch.positions()[v].*coordinate));
  }
  return axis;
}

std::vector<double> numbers_of(const Patch& patch, double Vec3::*coordinate) {
  std::vector<double> numbers;
  numbers.reserve(patch.vertex_count());
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    if (!patch.ring(v).empty()) numbers.push_back(patch.positions()[v].*coordinate);
  }
  std::sort(numbers.begin(), numbers.end());
  numbers.erase(std::unique(numbers.begin(), numbers.end()), numbers.end());
  return numbers;
}

/// With how many digits the coordinates of all axes may have been written.
struct Writing {
  int most_digits = 0;  // of a number
  bool fills = false;   // as fill_digits() of all
};

Writing writing_of(std::span<const Axis> axes) {
  Writing writing;
  std::vector<DecimalDigits> all;
  for (const Axis& axis : axes) {
    for (const double number : axis.numbers) {
      all.push_back(decimal_digits(number));
      writing.most_digits = std::max(writing.most_digits, all.back().count);
      if (writing.most_digits > k_most_digits_of_float) return writing;
    }
  }
  writing.fills = writing.most_digits >= k_fewest_digits && writing.most_digits <= k_most_digits &&
                  fill_digits(all, writing.most_digits);
  return writing;
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

/// Of rows of three vertices, how evenly they go on along an axis: by how many steps the way to the
/// third differs from the way to the second.
struct StepsOfRows {
  std::size_t even = 0, nearly = 0, uneven = 0;

  std::size_t count() const { return even + nearly + uneven; }
  /// The grid of a design goes on evenly, or is changed by more than rounding does.
  bool show_rounding() const { return 10 * nearly > count(); }
  /// What rounding does to rows that go on evenly: it leaves no other changes.
  bool show_rounding_only() const { return show_rounding() && 10 * uneven < count(); }
  bool are_even() const { return even > 0 && even == count(); }
  bool show_no_grid() const { return 2 * even < count(); }
};

/// Of rows of three vertices, along the border too, that lead along an axis.
StepsOfRows steps_of_rows(const Patch& patch, const Axis& axis, double step) {
  constexpr double k_nearly = 2.0;
  StepsOfRows steps;
  const auto add = [&](Index before, Index v, Index after) {
    const auto place = [&](Index of) { return patch.positions()[of].*axis.coordinate; };
    const double first = std::round((place(v) - place(before)) / step),
                 second = std::round((place(after) - place(v)) / step);
    const double change = std::abs(second - first);
    // Steps of one are what a grid has, and what rounding leaves of everything.
    if (change == 0.0 && std::abs(first) < 2.0) return;
    ++(change == 0.0 ? steps.even : change <= k_nearly ? steps.nearly : steps.uneven);
  };
  for (Index v = 0; v < patch.vertex_count(); ++v) {
    for (const Index before : patch.ring(v)) {
      const Index after = straight_on(patch, before, v);
      if (after != Edge::none && before < after) add(before, v, after);
    }
  }
  return steps;
}

/// Of a number of the axis; those above nine are not counted.
int most_digits_of(const Axis& axis) {
  int most = 0;
  for (const double number : axis.numbers) {
    most = std::max(most, decimal_digits(number).count);
    if (most > k_most_digits_of_float) return most;
  }
  return most;
}

/// The step of 32-bit numbers of the size of the largest, where all numbers of the axis are such,
/// several, and some use their last bit: else they may be those of a design. 0 where not.
double step_of_floats(const Patch& patch, const Axis& axis) {
  if (!(axis.largest <= static_cast<double>(std::numeric_limits<float>::max()))) return 0.0;
  const auto largest = static_cast<float>(axis.largest);
  const double step =
      static_cast<double>(largest) - static_cast<double>(std::nextafter(largest, 0.0F));
  // Eight or nine digits are the fewest that tell a 32-bit number from its neighbours.
  const int digits = most_digits_of(axis);
  const bool as_text = digits >= k_most_digits && digits <= k_most_digits_of_float;
  bool uses_last_bit = false;
  for (const double number : axis.numbers) {
    const auto nearest = static_cast<double>(static_cast<float>(number));
    if (nearest != number && !(as_text && is_text_of_float(number, digits))) return 0.0;
    uses_last_bit = uses_last_bit || std::remainder(nearest, 2.0 * step) != 0.0;
  }
  // Halves and quarters may be the grid of a design.
  const auto is_grid = [&] {
    return digits <= k_most_digits && steps_of_rows(patch, axis, step).are_even();
  };
  return uses_last_bit && !is_grid() ? step : 0.0;
}

/// The last of the decimal digits that numbers as large as the largest have; 0 where these are so
/// few that a design may have them.
double decimal_step(const Axis& axis) {
  const int power = decimal_digits(axis.largest).power;
  int most = 0;
  for (const double number : axis.numbers) {
    const DecimalDigits digits = decimal_digits(number);
    if (digits.power == power) most = std::max(most, digits.count);
  }
  return most >= k_fewest_digits && most <= k_most_digits ? math::power_of_ten(power - most + 1)
                                                          : 0.0;
}

/// By how much the numbers of an axis step; 0 where they have more digits than need be known.
double step_of(const Patch& patch, const Axis& axis, const Writing& writing, double mean_edge) {
  if (!axis.is_far(mean_edge) || axis.numbers.size() < 2) return 0.0;
  if (const double step = step_of_floats(patch, axis); step > k_large_step * mean_edge) return step;
  if (writing.fills)
    return math::power_of_ten(decimal_digits(axis.largest).power - writing.most_digits + 1);
  if (writing.most_digits <= k_most_digits) {
    const double step = decimal_step(axis);
    if (step > 0.0) {
      const StepsOfRows steps = steps_of_rows(patch, axis, step);
      const bool is_of_design = step > k_often_of_designs * axis.largest;
      if (is_of_design ? steps.show_rounding_only() : steps.show_rounding()) return step;
    }
  }
  const double step = common_step(axis);
  if (!(step > 0.0) || step > k_often_of_designs * axis.largest) return 0.0;
  const StepsOfRows steps = steps_of_rows(patch, axis, step);
  const bool are_many = axis.numbers.size() >= k_fewest_numbers;
  return steps.show_rounding() || (are_many && steps.show_no_grid()) ? step : 0.0;
}

}  // namespace

std::optional<CoarseCoordinates> find_coarse_coordinates(const Patch& patch) {
  const double mean_edge = mean_side_of(patch.mesh(), patch.unit_scale()) / patch.unit_scale();
  if (!(mean_edge > 0.0)) return std::nullopt;
  std::array axes = {axis_of(patch, &Vec3::x), axis_of(patch, &Vec3::y), axis_of(patch, &Vec3::z)};
  const auto is_far = [&](const Axis& axis) { return axis.is_far(mean_edge); };
  if (std::none_of(axes.begin(), axes.end(), is_far)) return std::nullopt;
  for (Axis& axis : axes)
    axis.numbers = numbers_of(patch, axis.coordinate);
  const Writing writing = writing_of(axes);
  double step = 0.0;
  for (const Axis& axis : axes)
    step = std::max(step, step_of(patch, axis, writing, mean_edge));
  if (!(step > k_large_step * mean_edge)) return std::nullopt;
  return CoarseCoordinates{step, mean_edge};
}

}  // namespace planish
