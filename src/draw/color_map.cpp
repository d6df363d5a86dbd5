#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include <planish/draw/color.h>

namespace planish {

namespace {

constexpr Color k_grey = {150, 150, 150};

// Evenly spaced on straight lines in CIELAB from L* = 97 to L* = 36, so that equal steps of the
// value are equal steps for the eye and both sides weigh the same. Blue runs to chroma 53 while its
// hue turns from 254 to 286 degrees (a constant hue would look purple), red to chroma 62 from 44 to
// 32 degrees. The points are close enough that plain sRGB will do between them.
constexpr std::array<Color, 17> k_diverging = {{
    {0x16, 0x52, 0xa7},
    {0x37, 0x66, 0xb3},
    {0x51, 0x7b, 0xbd},
    {0x6a, 0x8f, 0xc7},
    {0x84, 0xa4, 0xd1},
    {0x9e, 0xb9, 0xda},
    {0xba, 0xcd, 0xe3},
    {0xd8, 0xe2, 0xed},
    {0xf6, 0xf6, 0xf6},
    {0xf0, 0xdd, 0xd7},
    {0xe9, 0xc3, 0xb9},
    {0xe0, 0xaa, 0x9c},
    {0xd6, 0x90, 0x81},
    {0xcb, 0x77, 0x67},
    {0xbf, 0x5d, 0x4f},
    {0xb2, 0x41, 0x38},
    {0xa4, 0x1f, 0x23},
}};

constexpr std::array<Color, 5> k_paper = {
    {{0, 0, 255}, {0, 255, 255}, {0, 255, 0}, {255, 255, 0}, {255, 0, 0}}};

// From L* = 96 down to L* = 23 in equal steps; the hue turns from sand over green to blue.
constexpr std::array<Color, 9> k_sequential = {{
    {0xfa, 0xf3, 0xe0},
    {0xd4, 0xde, 0xb7},
    {0x9e, 0xcc, 0x9d},
    {0x5a, 0xb8, 0x96},
    {0x04, 0xa0, 0x99},
    {0x05, 0x84, 0x93},
    {0x00, 0x6a, 0x87},
    {0x02, 0x50, 0x79},
    {0x29, 0x36, 0x59},
}};

// From L* = 96 down to L* = 59.
constexpr std::array<Color, 5> k_pale = {{
    {0xfb, 0xf4, 0xe2},
    {0xdf, 0xe9, 0xd0},
    {0xb0, 0xd8, 0xcf},
    {0x7d, 0xbc, 0xcb},
    {0x4f, 0x97, 0xbd},
}};

std::uint8_t mix(std::uint8_t a, std::uint8_t b, double share) {
  return static_cast<std::uint8_t>(std::lround(a + share * (b - a)));
}

// The colour at `share` of the way, 0 to 1, along evenly spaced points.
Color along(std::span<const Color> points, double share) {
  const double place = share * static_cast<double>(points.size() - 1);
  const auto from = std::min(static_cast<std::size_t>(place), points.size() - 2);
  const double rest = place - static_cast<double>(from);
  const Color a = points[from], b = points[from + 1];
  return {mix(a.r, b.r, rest), mix(a.g, b.g, rest), mix(a.b, b.b, rest)};
}

}  // namespace

Color color_at(ColorMap map, double t) {
  if (std::isnan(t)) return k_grey;
  if (map == ColorMap::sequential) return along(k_sequential, std::clamp(t, 0.0, 1.0));
  if (map == ColorMap::pale) return along(k_pale, std::clamp(t, 0.0, 1.0));
  if (map == ColorMap::paper) return along(k_paper, std::clamp(t, 0.0, 1.0));
  return along(k_diverging, 0.5 + 0.5 * std::clamp(t, -1.0, 1.0));
}

}  // namespace planish
