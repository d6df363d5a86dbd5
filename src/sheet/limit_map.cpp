#include "sheet/limit_map.h"

#include <algorithm>
#include <cmath>

#include <planish/draw/color.h>

#include "core/number_text.h"
#include "sheet/strain_map.h"

namespace planish {

namespace {

constexpr int k_within = k_limit_bands - 1;  // bands up to the limit

}  // namespace

std::optional<StrainLimitCheck> limit_of_edges(std::span<const StrainLimitCheck> checks) {
  std::optional<StrainLimitCheck> smallest;
  for (const StrainLimitCheck& check : checks) {
    if (check.kind == StrainLimitKind::rms) continue;
    if (!smallest || check.asked < smallest->asked) smallest = check;
  }
  return smallest;
}

std::string limit_words(const StrainLimitCheck& limit) {
  std::string share = fixed_text(100.0 * limit.asked, 6) + " %";
  switch (limit.kind) {
    case StrainLimitKind::max:
      return share + ", for every edge";
    case StrainLimitKind::p99:
      return share + ", on 99 % of the area";
    case StrainLimitKind::rms:
      return share + ", rms";
  }
  return share;
}

int limit_band(double strain, double limit) {
  const double size = std::abs(strain);
  if (size > limit) return k_within;
  const double share = size / limit;
  if (std::isnan(share)) return 0;
  return std::min(static_cast<int>(k_within * share), k_within - 1);
}

Color limit_band_color(int band) {
  if (band >= k_within) return k_beyond_limit;
  return color_at(ColorMap::pale, (band + 0.5) / k_within);
}

std::array<Color, k_limit_bands> limit_band_colors() {
  std::array<Color, k_limit_bands> colors;
  for (int band = 0; band < k_limit_bands; ++band)
    colors[static_cast<std::size_t>(band)] = limit_band_color(band);
  return colors;
}

std::vector<DrawingShape> limit_map(const TriMesh& mesh, std::span<const HalfEdge> opposite,
                                    std::span<const Vec2> corners, std::span<const double> strains,
                                    double limit) {
  std::vector<int> bands;
  bands.reserve(strains.size());
  for (const double strain : strains)
    bands.push_back(limit_band(strain, limit));
  return map_of_bands(mesh, opposite, corners, bands, limit_band_color);
}

}  // namespace planish
