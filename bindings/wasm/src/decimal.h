#pragma once

#include <charconv>
#include <string>

namespace planish {

// What to_chars() of a standard library writes for floating-point numbers, made of printf() and a
// reader that rounds correctly. Numbers may be infinite or not a number.

/// The shortest decimal that reads back as the number, of several the nearest. Fixed or scientific,
/// whichever is shorter, fixed where both are as long.
std::string shortest_decimal(double value);
std::string shortest_decimal(float value);

/// The shortest one in this format: general is fixed for powers of ten from -4 to 5, as of "%g".
/// Not hex.
std::string shortest_decimal(double value, std::chars_format format);
std::string shortest_decimal(float value, std::chars_format format);

/// As printf() in the C locale; not hex.
/// @param precision >= 0
std::string rounded_decimal(double value, std::chars_format format, int precision);

}  // namespace planish
