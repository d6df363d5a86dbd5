#include "report/pictures/strain_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <planish/draw/color.h>

#include "unfold/strain/vertex_strain.h"

namespace planish {

namespace {

constexpr double k_strain_padding = 0.015;  // of the width

std::vector<Color> strain_colors(const TriMesh& mesh, const Pattern& pattern, double limit) {
  std::vector<Color> colors;
  colors.reserve(mesh.positions.size());
  for (const double strain : vertex_strains(mesh, pattern.positions))
    colors.push_back(color_at(ColorMap::diverging, strain / limit));
  return colors;
}

}  // namespace

std::vector<Image> strain_pictures(const TriMesh& mesh, std::span<const PatternOfPatch> patterns,
                                   double limit, int width) {
  Vec2 size;
  for (const PatternOfPatch& one : patterns) {
    size = {std::max(size.x, one.pattern.width), std::max(size.y, one.pattern.height)};
  }
  const double padding = k_strain_padding * width;
  const double scale = (width - 2.0 * padding) / size.x;
  const int height = static_cast<int>(std::ceil(scale * size.y + 2.0 * padding));
  std::vector<Image> pictures;
  for (const PatternOfPatch& one : patterns) {
    const TriMesh patch{{one.patch.begin(), one.patch.end()}, mesh.triangles};
    std::vector<Vec3> places;
    places.reserve(one.pattern.positions.size());
    for (const Vec2 p : one.pattern.positions) {
      const Vec2 from_middle = p - 0.5 * Vec2{one.pattern.width, one.pattern.height};
      places.push_back(
          {0.5 * width + scale * from_middle.x, 0.5 * height - scale * from_middle.y, 0.0});
    }
    const auto colors = strain_colors(patch, one.pattern, limit);
    const std::vector<double> brightness(places.size(), 1.0);
    pictures.push_back(render({places, mesh.triangles, colors, brightness}, width, height));
  }
  return pictures;
}

}  // namespace planish
