#include "sheet/strain_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <planish/draw/color.h>

namespace planish {

int strain_band(double strain, double limit) {
  if (std::isnan(strain)) return 0;
  // Band 0 reaches half a width to either side of no strain.
  const double place = std::clamp(strain / limit, -1.0, 1.0) * (k_bands_a_side + 0.5);
  return std::clamp(static_cast<int>(std::lround(place)), -k_bands_a_side, k_bands_a_side);
}

Color band_color(int band) {
  return color_at(ColorMap::diverging, static_cast<double>(band) / k_bands_a_side);
}

std::vector<DrawingShape> map_of_bands(const TriMesh& mesh, std::span<const HalfEdge> opposite,
                                       std::span<const Vec2> corners, std::span<const int> bands,
                                       const std::function<Color(int)>& color) {
  std::vector<DrawingShape> shapes;
  const auto add = [&](int band, const std::function<bool(std::size_t)>& in_part) {
    Path path{{}, true, {}, color(band)};
    for (const auto& loop : outlines(mesh, opposite, in_part)) {
      auto& line = path.lines.emplace_back();
      line.reserve(loop.size());
      for (const Index v : loop)
        line.push_back(corners[v]);
    }
    if (!path.lines.empty()) shapes.emplace_back(std::move(path));
  };
  add(0, [](std::size_t) { return true; });
  int lowest = 0, highest = 0;
  for (const int band : bands) {
    lowest = std::min(lowest, band);
    highest = std::max(highest, band);
  }
  for (int band = 1; band <= std::max(highest, -lowest); ++band) {
    if (band <= highest) add(band, [&](std::size_t t) { return bands[t] >= band; });
    if (-band >= lowest) add(-band, [&](std::size_t t) { return bands[t] <= -band; });
  }
  return shapes;
}

std::vector<DrawingShape> strain_map(const TriMesh& mesh, std::span<const HalfEdge> opposite,
                                     std::span<const Vec2> corners, std::span<const double> strains,
                                     double limit) {
  std::vector<int> bands;
  bands.reserve(strains.size());
  for (const double strain : strains)
    bands.push_back(strain_band(strain, limit));
  return map_of_bands(mesh, opposite, corners, bands, band_color);
}

}  // namespace planish
