#pragma once

#include <cstdint>

namespace planish {

/// sRGB.
struct Color {
  std::uint8_t r = 0, g = 0, b = 0;
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

}  // namespace planish
