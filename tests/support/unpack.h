#pragma once

// Reads what pages hold, as their script does.

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace planish::pages {

/// RFC 4648, read plainly.
inline std::vector<unsigned char> bytes_of(const std::string& base64) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::vector<unsigned char> bytes;
  unsigned bits = 0, count = 0;
  for (const char c : base64) {
    if (c == '=') break;
    bits = (bits << 6 | static_cast<unsigned>(digits.find(c))) & 0xFFFFU;
    count += 6;
    if (count < 8) continue;
    count -= 8;
    bytes.push_back(static_cast<unsigned char>(bits >> count & 0xFFU));
  }
  return bytes;
}

inline std::vector<unsigned> small_numbers_of(const std::string& base64) {
  const auto bytes = bytes_of(base64);
  std::vector<unsigned> numbers;
  for (std::size_t i = 0; i + 1 < bytes.size(); i += 2)
    numbers.push_back(bytes[i] + 256U * bytes[i + 1]);
  return numbers;
}

inline std::vector<std::uint32_t> numbers_of(const std::string& base64) {
  const auto halves = small_numbers_of(base64);
  std::vector<std::uint32_t> numbers;
  for (std::size_t i = 0; i + 1 < halves.size(); i += 2)
    numbers.push_back(halves[i] + 65536U * halves[i + 1]);
  return numbers;
}

inline std::vector<float> floats_of(const std::string& base64) {
  std::vector<float> floats;
  for (const std::uint32_t bits : numbers_of(base64))
    floats.push_back(std::bit_cast<float>(bits));
  return floats;
}

}  // namespace planish::pages
