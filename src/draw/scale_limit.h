#pragma once

namespace planish {

/// The smallest of 1, 2, 5 times a power of ten that is at least `value`, which is positive and
/// finite; a value that exceeds one of these by rounding only counts as that one.
double round_up_125(double value);

}  // namespace planish
