#pragma once

// Turns what a fuzzer feeds into numbers. Plain, so that corpora are replayed without libFuzzer
// too.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>
#include <string_view>

namespace planish::fuzz {

/// Takes numbers off the front of some bytes; behind their end all are zero.
class Bytes {
 public:
  Bytes(const std::uint8_t* data, std::size_t size)
      : bytes_(reinterpret_cast<const char*>(data), size) {}

  bool empty() const { return bytes_.empty(); }

  std::uint8_t byte() {
    if (bytes_.empty()) return 0;
    const auto first = static_cast<std::uint8_t>(bytes_.front());
    bytes_.remove_prefix(1);
    return first;
  }
  bool flag() { return byte() % 2 == 1; }

  /// From `from` to `to`, both included, at most 65536 of them.
  std::size_t whole(std::size_t from, std::size_t to) {
    std::size_t number = byte();
    if (to - from > 255) number = 256 * number + byte();
    return from + number % (to - from + 1);
  }

  /// In [-1, 1), in steps of 1/128.
  double fraction() { return static_cast<double>(byte()) / 128.0 - 1.0; }

  /// Any double at all.
  double any_double() {
    double value = 0.0;
    const std::string_view taken = text(sizeof value);
    std::memcpy(&value, taken.data(), taken.size());
    return value;
  }

  /// A number of any size in the range, both ends often.
  double within(double low, double high) {
    const std::size_t kind = whole(0, 7);
    if (kind == 0) return low;
    if (kind == 1) return high;
    if (kind == 2) return std::fmin(std::fmax(any_double(), low), high);
    const double share = static_cast<double>(byte()) / 255.0;
    return kind < 6 ? low + share * std::fmin(high - low, 1.0) : low + share * (high - low);
  }

  /// The next bytes, fewer where there are no more.
  std::string_view text(std::size_t length) {
    const std::string_view taken = bytes_.substr(0, length);
    bytes_.remove_prefix(taken.size());
    return taken;
  }
  std::string_view rest() { return text(bytes_.size()); }

 private:
  std::string_view bytes_;
};

}  // namespace planish::fuzz
