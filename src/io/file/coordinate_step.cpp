#include "io/file/coordinate_step.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>

#include "core/math.h"

namespace planish {

namespace {

/// Numbers with more significant digits hold all that a double does.
constexpr int k_most_digits = 12;
/// Whole numbers are a design's own, but for those that fill the six digits of C's %g.
constexpr int k_digits_of_general_format = 6;
/// Rounded numbers end on any digit, those of a design on few.
constexpr int k_least_last_digits = 4;

double largest_coordinate(std::span<const Vec3> places) {
  double largest = 0.0;
  for (const Vec3 p : places)
    largest = std::max({largest, std::abs(p.x), std::abs(p.y), std::abs(p.z)});
  return largest;
}

bool is_float(double x) {
  return std::abs(x) <= static_cast<double>(std::numeric_limits<float>::max()) &&
         static_cast<double>(static_cast<float>(x)) == x;
}

/// A number as its digits are written.
struct Digits {
  int power = 0;     ///< of ten, of the first digit that is not 0
  int decimals = 0;  ///< below 0 where an exponent leaves fewer than the units
  int last = 0;
  bool zero = true;
};

Digits digits_of(std::string_view word) {
  const std::size_t end = std::min(word.find_first_of("eE"), word.size());
  const std::size_t point = std::min(word.find('.'), end);
  const std::size_t first = word.find_first_of("123456789");
  Digits digits;
  if (first == std::string_view::npos || first > end) return digits;
  int exponent = 0;
  if (end < word.size()) {
    const std::size_t sign = word.substr(end + 1).starts_with('+') ? 1 : 0;
    std::from_chars(word.data() + end + 1 + sign, word.data() + word.size(), exponent);
    exponent = std::clamp(exponent, -400, 400);
  }
  const auto places = [](std::size_t from, std::size_t to) {
    return static_cast<int>(to) - static_cast<int>(from);
  };
  digits.zero = false;
  digits.power = (first < point ? places(first, point) - 1 : -places(point, first)) + exponent;
  digits.decimals = (point < end ? places(point, end) - 1 : 0) - exponent;
  const char last = word[end - 1];
  digits.last = last >= '0' && last <= '9' ? last - '0' : 0;
  return digits;
}

}  // namespace

double step_of_floats(std::span<const Vec3> places) {
  const auto largest = static_cast<float>(largest_coordinate(places));
  if (!(largest > 0.0F) || !std::isfinite(largest)) return 0.0;
  const auto next = std::bit_cast<float>(std::bit_cast<std::uint32_t>(largest) + 1);
  return static_cast<double>(next) - static_cast<double>(largest);
}

double step_of_widened_floats(std::span<const Vec3> places) {
  for (const Vec3 p : places)
    if (!is_float(p.x) || !is_float(p.y) || !is_float(p.z)) return 0.0;
  const double step = step_of_floats(places);
  const double fine = 16.0 * step;
  const double large = 0.5 * largest_coordinate(places);
  const auto uses_last_digits = [&](double x) {
    return std::abs(x) >= large && std::trunc(x / fine) * fine != x;
  };
  const bool fills = std::any_of(places.begin(), places.end(), [&](Vec3 p) {
    return uses_last_digits(p.x) || uses_last_digits(p.y) || uses_last_digits(p.z);
  });
  return fills && step > 0.0 ? step : 0.0;
}

void DecimalSteps::add(TextCursor ahead) {
  for (std::size_t axis = 0; axis < axes_.size(); ++axis) {
    ahead.skip_to_token();
    add(axis, ahead.token());
  }
}

void DecimalSteps::add(std::size_t axis, std::string_view word) {
  const Digits digits = digits_of(word);
  Axis& known = axes_[axis];
  if (digits.zero || digits.power < known.power) return;
  if (digits.power > known.power || digits.decimals > known.decimals) {
    known = {digits.power, digits.decimals, 0};
  }
  if (digits.decimals == known.decimals) known.last_digits |= 1U << digits.last;
}

double DecimalSteps::step() const {
  double largest = 0.0;
  for (const Axis& axis : axes_) {
    const int digits = axis.power + axis.decimals + 1;
    const bool designed = axis.decimals <= 0 && digits < k_digits_of_general_format;
    if (digits > k_most_digits || designed) continue;
    if (std::popcount(axis.last_digits) < k_least_last_digits) continue;
    largest = std::max(largest, math::power_of_ten(-axis.decimals));
  }
  return largest;
}

}  // namespace planish
