#pragma once

#include <cstdint>
#include <string>

namespace planish {

/// Appends the last `digits` hexadecimal digits of a value, in capitals.
inline void append_hex(std::string& text, std::uint64_t value, int digits) {
  for (int shift = 4 * (digits - 1); shift >= 0; shift -= 4)
    text += "0123456789ABCDEF"[(value >> shift) & 15U];
}

}  // namespace planish
