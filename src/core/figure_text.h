#pragma once

#include <cstddef>
#include <string>

#include <planish/core/unit.h>

namespace planish {

/// What people read, in every locale alike: a blank before the unit, a true minus, and for numbers
/// out of the usual range powers of ten in the form of UTF-8 superscripts, as in "1.2 × 10⁻⁷".
/// Numbers that are not finite read "not a number" or "infinite".

/// So many significant digits, with their zeros: 0.0638, 1.20, 27.0; whole numbers of more digits
/// are kept whole.
std::string significant_text(double value, int digits = 3);

/// So many digits after the point, with their zeros.
std::string decimals_text(double value, int decimals);

/// About how much: two significant digits, and no point from 10 on: 3.4, 27, 1200.
std::string about_text(double value);

/// A fraction as percent, two significant digits: "7.6 %", "0.05 %", "32 %"; what nobody can
/// measure reads "under 0.0001 %".
std::string percent_text(double fraction);

/// The same with a sign in front of what is not zero: "+7.6 %".
std::string signed_percent_text(double fraction);

/// A length of the model in millimetres, or of a model in inches in inches: "26 mm", "0.35 in".
std::string length_text(double length, Unit unit, int digits = 2);

/// "512 × 790 mm", as length_text() with three digits.
std::string size_text(double width, double height, Unit unit);

/// "10⁻⁴".
std::string power_of_ten_text(int power);

/// Three digits to a group: "195 000", the blank a narrow one.
std::string count_text(std::size_t count);

}  // namespace planish
