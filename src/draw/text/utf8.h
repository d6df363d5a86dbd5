#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace planish {

inline constexpr char32_t k_replacement_character = 0xFFFD;

struct CodePoint {
  char32_t value = 0;
  std::size_t bytes = 0;  ///< 0: no UTF-8
};

/// The code point that `text`, not empty, begins with.
CodePoint decode_utf8(std::string_view text);

/// All code points of a text; each byte that is no UTF-8 becomes U+FFFD.
std::u32string code_points(std::string_view text);

/// A code point as two-byte units, one or two of them.
std::u16string utf16_units(char32_t value);

}  // namespace planish
