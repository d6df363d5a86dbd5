#pragma once

#include <span>

namespace planish {

/// How a number is written with the fewest digits that read back to it: d.ddd times a power of ten.
struct DecimalDigits {
  int count = 0;  ///< without zeros at either end; 0 of the number 0
  int power = 0;  ///< of ten
};

DecimalDigits decimal_digits(double number);

/// Whether this is what is read of the text of a 32-bit number: of the fewest digits that read back
/// to it, or of so many.
bool is_text_of_float(double number, int digits);

/// Whether texts of `digits` significant digits show in numbers: at two powers of ten or more, at
/// least a half of three or more numbers have as many. Those of a design, and those of a fixed
/// number of decimals, have as many at one power of ten only.
bool fill_digits(std::span<const DecimalDigits> numbers, int digits);

}  // namespace planish
