#include "draw/scale_limit.h"

#include <cmath>
#include <string>

#include <fast_float/fast_float.h>

#include "core/math.h"

namespace planish {

double round_up_125(double value) {
  const int exponent = static_cast<int>(std::floor(math::log10(value)));
  const auto candidate = [&](int digit, int power) {
    // Reading "2e-3" gives the double that everybody means by 0.002; 2 * pow(10, -3) may not.
    const std::string text = std::to_string(digit) + "e" + std::to_string(power);
    double number = 0.0;
    fast_float::from_chars(text.data(), text.data() + text.size(), number);
    return number;
  };
  for (const int digit : {1, 2, 5}) {
    const double number = candidate(digit, exponent);
    if (value <= number * (1.0 + 1e-12)) return number;
  }
  return candidate(1, exponent + 1);
}

}  // namespace planish
