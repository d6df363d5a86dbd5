#pragma once

#include <array>
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
/// pixel. Time is linear in triangles and pixels.
Image render(const ShadedSurface& surface, int width, int height, Color background);

/// The bytes of a PNG file.
std::string write_png(const Image& image);

}  // namespace planish
