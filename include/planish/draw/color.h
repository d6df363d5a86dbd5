#pragma once

#include <cstdint>
#include <string_view>

namespace planish {

/// sRGB.
struct Color {
  std::uint8_t r = 0, g = 0, b = 0;  ///< red, green or blue, 0 to 255
  friend constexpr bool operator==(const Color&, const Color&) = default;
};

/// How a value becomes a colour.
enum class ColorMap {
  diverging,   ///< signed values: blue below 0, white at 0, red above; safe for colour-blind eyes
  paper,       ///< sizes as the 2010 paper shows them: blue at 0 over green and yellow to red
  sequential,  ///< sizes: from pale sand over green to dark blue; safe for colour-blind eyes
  pale,        ///< sizes: from sand over aqua to blue, on which dark lines and letters stand out;
               ///< safe for colour-blind eyes
};

/// The colour of a value.
/// @param t diverging: -1 to 1; all others: 0 to 1; values beyond are clamped, NaN is grey
Color color_at(ColorMap map, double t);

}  // namespace planish
