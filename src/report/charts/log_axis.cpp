#include "report/charts/log_axis.h"

#include <algorithm>
#include <cmath>

#include "core/figure_text.h"
#include "core/math.h"
#include "core/number_text.h"
#include "draw/scale_limit.h"

namespace planish {

namespace {

constexpr double k_slack = 1e-9;  // a value that misses a tick by rounding lies on it

std::string tick_text(double value) {
  if (value >= 1e-3 && value < 1e6) return fixed_text(value, 6);
  return power_of_ten_text(static_cast<int>(std::lround(math::log10(value))));
}

std::vector<double> decades(double low, double high) {
  const int from = static_cast<int>(std::floor(math::log10(low) + k_slack));
  const int to = static_cast<int>(std::ceil(math::log10(high) - k_slack));
  const int step = std::max(1, (to - from + 5) / 6);
  std::vector<double> values;
  for (int power = to; power > from - step; power -= step) {
    values.insert(values.begin(), math::power_of_ten(power));
  }
  return values;
}

std::vector<double> ones_twos_fives(double low, double high) {
  const int from = static_cast<int>(std::floor(math::log10(low) + k_slack));
  std::vector<double> candidates;
  for (int power = from; power <= from + 3; ++power) {
    for (const double digit : {1.0, 2.0, 5.0})
      candidates.push_back(digit * math::power_of_ten(power));
  }
  const auto first = std::find_if(candidates.rbegin(), candidates.rend(),
                                  [&](double value) { return value <= low * (1.0 + k_slack); })
                         .base() -
                     1;
  const auto last = std::find_if(first + 1, candidates.end() - 1,
                                 [&](double value) { return value >= high * (1.0 - k_slack); });
  return {first, last + 1};
}

std::vector<double> evenly_spaced(double low, double high) {
  const double step = round_up_125(std::max(high - low, 0.01 * high) / 4.0);
  const double from = std::floor(low / step + k_slack);
  const double to = std::max(std::ceil(high / step - k_slack), from + 1.0);
  std::vector<double> values;
  // From 0 there is no way on a logarithmic axis.
  for (double i = std::max(from, 1.0); i <= to; ++i)
    values.push_back(i * step);
  return values;
}

}  // namespace

double LogAxis::place_of(double value) const {
  return math::log(value / low) / math::log(high / low);
}

LogAxis log_axis(double low, double high) {
  const double ratio = high / low;
  const std::vector<double> values = ratio > 100.0 ? decades(low, high)
                                     : ratio > 2.0 ? ones_twos_fives(low, high)
                                                   : evenly_spaced(low, high);
  LogAxis axis{values.front(), values.back(), {}};
  for (const double value : values)
    axis.ticks.push_back({value, tick_text(value)});
  return axis;
}

}  // namespace planish
