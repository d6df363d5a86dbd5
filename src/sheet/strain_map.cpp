#include "sheet/strain_map.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <planish/draw/color.h>

#include "sheet/piece/outlines.h"

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

std::vector<DrawingShape> strain_map(const TriMesh& mesh, std::span<const Vec2> corners,
                                     std::span<const double> strains,
                                     const std::function<int(double)>& band_of,
                                     const std::function<Color(int)>& color) {
  const HalfEdges edges(mesh);
  std::vector<int> bands(strains.size());
  std::transform(strains.begin(), strains.end(), bands.begin(), band_of);
  std::vector<DrawingShape> shapes;
  const auto add = [&](int band, const std::function<bool(std::size_t)>& in_part) {
    Path path{{}, true, {}, color(band)};
    for (const auto& loop : outlines(edges, in_part)) {
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

}  // namespace planish
