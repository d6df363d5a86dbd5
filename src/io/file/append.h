#pragma once

#include <charconv>
#include <cstdint>
#include <string>

#include "io/file/byte_cursor.h"

namespace planish {

inline void append_integer(std::string& text, std::uint64_t value) {
  char digits[20];
  text.append(digits, std::to_chars(digits, digits + sizeof digits, value).ptr);
}

/// Appends the bytes of a number, the lowest first.
template <class T>
void append_little_endian(std::string& bytes, T value) {
  const auto piece = to_bytes(value, std::endian::little);
  bytes.append(piece.data(), piece.size());
}

}  // namespace planish
