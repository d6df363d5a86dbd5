#pragma once

#include <limits>
#include <string>
#include <string_view>

namespace planish {

/// Closed range of the values that a number may take.
struct Range {
  double min = -std::numeric_limits<double>::infinity();  ///< smallest value
  double max = std::numeric_limits<double>::infinity();   ///< largest value
};

/// Throws Error(option_out_of_range) naming the option, unless value is a number within range.
void check_range(std::string_view option, double value, Range range);

}  // namespace planish
