#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <planish/core/vec.h>
#include <planish/draw/color.h>

namespace planish {

/// A picture of width x height pixels, rows from the top.
struct Image {
  int width = 0, height = 0;
  std::vector<Color> pixels;
  std::vector<std::uint8_t> alpha = {};  ///< 255: opaque, 0: clear; none: all opaque
  bool operator==(const Image&) const = default;
};

/// A surface to be drawn: vertices in pixels (x right, y down) with depth z (larger is nearer),
/// triangles over them, a colour and a brightness (0 to 1) per vertex.
struct ShadedSurface {
  std::span<const Vec3> vertices;
  std::span<const std::array<Index, 3>> triangles;
  std::span<const Color> colors;
  std::span<const double> brightness;
};

/// Draws the surface with hidden parts hidden, smoothly coloured, edges smoothed by 2 x 2 samples a
/// pixel. Parts outside the image and triangles with a vertex that is not finite are left out. Time
/// grows with the number of triangles plus the pixels that they cover.
/// @param background none: what the surface does not cover is clear
Image render(const ShadedSurface& surface, int width, int height,
             std::optional<Color> background = {});

/// The bytes of a PNG file: RGB, or RGBA where the image has alpha. The image has at least one
/// pixel.
std::string format_png(const Image& image);

}  // namespace planish
