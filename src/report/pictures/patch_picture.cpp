#include "report/pictures/patch_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <planish/measure/flattenability.h>
#include <planish/mesh/patch.h>

#include "draw/scale_limit.h"
#include "report/pictures/patch_view.h"

namespace planish {

namespace {

constexpr double k_scale_share = 0.98;  // of the vertices within the scale

// With the mean of the inner neighbours on the border: "0" there would read as "flat".
std::vector<double> shown_defects(std::span<const double> defects,
                                  const Connectivity& connectivity) {
  std::vector<double> shown(defects.begin(), defects.end());
  for (Index v = 0; v < shown.size(); ++v) {
    if (!connectivity.is_border(v)) continue;
    double sum = 0.0;
    int count = 0;
    for (const Index neighbour : connectivity.ring(v)) {
      if (!connectivity.is_inner(neighbour)) continue;
      sum += defects[neighbour];
      ++count;
    }
    if (count > 0) shown[v] = sum / count;
  }
  return shown;
}

std::vector<Color> colors_of(std::span<const double> defects, double limit, ColorMap map) {
  std::vector<Color> colors;
  colors.reserve(defects.size());
  for (const double defect : defects) {
    colors.push_back(color_at(map, (map == ColorMap::paper ? std::abs(defect) : defect) / limit));
  }
  return colors;
}

}  // namespace

double defect_limit(std::span<const double> defects, const Connectivity& connectivity) {
  std::vector<double> sizes;
  for (const Index v : connectivity.inner_vertices()) {
    if (std::isfinite(defects[v])) sizes.push_back(std::abs(defects[v]));
  }
  if (sizes.empty()) return k_flattenable_e_max;
  const auto rank = static_cast<std::size_t>(k_scale_share * static_cast<double>(sizes.size() - 1));
  std::nth_element(sizes.begin(), sizes.begin() + rank, sizes.end());
  // Less than what counts as flattenable is not to look like anything.
  return round_up_125(std::max(sizes[rank], k_flattenable_e_max));
}

PatchPictures patch_pictures(const Patch& before, std::span<const std::span<const Vec3>> after,
                             ColorMap colors, int width) {
  const Connectivity& connectivity = before.connectivity();
  const auto defects_before = angle_defects(before);
  const double limit = defect_limit(defects_before, connectivity);
  const PatchView view(before.mesh(), after, width);
  const auto picture = [&](std::span<const Vec3> positions, std::span<const double> defects) {
    return view.picture(positions, colors_of(shown_defects(defects, connectivity), limit, colors));
  };
  PatchPictures pictures{picture(before.positions(), defects_before), {}, limit};
  for (const std::span<const Vec3> positions : after) {
    if (std::equal(positions.begin(), positions.end(), before.positions().begin())) {
      pictures.after.push_back(pictures.before);
      continue;
    }
    const Patch moved = before.with_positions({positions.begin(), positions.end()});
    pictures.after.push_back(picture(positions, angle_defects(moved)));
  }
  return pictures;
}

}  // namespace planish
