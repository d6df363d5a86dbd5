#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace planish {

/// FNV-1a of 64 bits (Fowler, Noll, Vo): a checksum, not a cryptographic hash.
class FnvHash {
 public:
  void add(std::string_view bytes) {
    for (const char byte : bytes)
      value_ = (value_ ^ static_cast<unsigned char>(byte)) * 0x100000001b3U;
  }
  std::uint64_t value() const { return value_; }

 private:
  std::uint64_t value_ = 0xcbf29ce484222325U;
};

/// 16 hexadecimal digits.
inline std::string hash_text(std::uint64_t hash) {
  std::string text(16, '0');
  for (auto digit = text.rbegin(); digit != text.rend(); ++digit) {
    *digit = "0123456789abcdef"[hash & 0xfU];
    hash >>= 4U;
  }
  return text;
}

}  // namespace planish
