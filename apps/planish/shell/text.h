#pragma once

#include <ostream>
#include <string>
#include <string_view>
#include <vector>

namespace planish::cli {

inline constexpr std::size_t k_text_width = 80;

/// Breaks a text into lines of at most k_text_width; all but the first are indented.
/// @param indent also the width that stands before the first line
std::string wrapped(std::string_view text, std::size_t indent);

/// A number with this number of significant digits, as in "0.06350" and "1.776e-15"; whole numbers
/// below a million with all of theirs.
std::string digits(double value, int significant = 4);
/// A number with this number of digits behind the point.
std::string fixed(double value, int decimals);
/// A share in per cent, as in "7.60 %".
std::string percent(double share);
/// A number in at most seven characters.
std::string short_number(double value);
/// A number that is never tiny, or need not be exact then, in at most five characters.
std::string shorter_number(double value);

/// Text padded to a width.
std::string left(std::string text, std::size_t width);
std::string right(const std::string& text, std::size_t width);

/// As much of the beginning as has at most this number of bytes and ends on a whole UTF-8 letter.
std::string beginning(const std::string& text, std::size_t bytes);

/// Written to a stream without what a terminal would obey: control characters but line ends and
/// tabs become question marks. Names in files are anybody's.
struct Shown {
  std::string_view text;
  friend std::ostream& operator<<(std::ostream& out, Shown shown);
};

/// "1 sweep", "2 sweeps"
std::string counted(std::size_t count, const std::string& noun);

}  // namespace planish::cli
