#include <planish/core/error.h>
#include <planish/core/range.h>

#include "core/number_text.h"

namespace planish {

namespace {

std::string describe_range(Range range) {
  const bool from = range.min > -std::numeric_limits<double>::infinity();
  const bool to = range.max < std::numeric_limits<double>::infinity();
  if (range.min == std::numeric_limits<double>::min() && !to) return "above 0";
  if (from && to) return "from " + number_text(range.min) + " to " + number_text(range.max);
  if (from) return "at least " + number_text(range.min);
  if (to) return "at most " + number_text(range.max);
  return "a number";
}

}  // namespace

void check_range(std::string_view option, double value, Range range) {
  if (value >= range.min && value <= range.max) return;  // false for NaN
  throw Error(ErrorCode::option_out_of_range, std::string(option) + " is " + number_text(value) +
                                                  " but must be " + describe_range(range));
}

}  // namespace planish
