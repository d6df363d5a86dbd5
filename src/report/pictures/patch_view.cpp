#include "report/pictures/patch_view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

namespace planish {

namespace {

constexpr double k_flattest = 0.4, k_tallest = 1.15;  // height over width
constexpr double k_padding = 12.0 / 880.0;            // of the width
constexpr double k_least_brightness = 0.5;            // of what faces away from the light
constexpr std::size_t k_most_split_triangles = 200'000;

}  // namespace

PatchView::PatchView(const TriMesh& mesh, std::span<const std::span<const Vec3>> others, int width)
    : PatchView(mesh, others, width, view_of(mesh)) {}

PatchView::PatchView(const TriMesh& mesh, std::span<const std::span<const Vec3>> others, int width,
                     const View& view)
    : mesh_(mesh), view_(view), width_(width), height_(width) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec2 low = {infinity, infinity}, high = {-infinity, -infinity};
  const auto include = [&](std::span<const Vec3> positions) {
    for (const Triangle& triangle : mesh.triangles) {
      for (const Index v : triangle) {
        const double x = dot(view_.right, positions[v]), y = dot(view_.up, positions[v]);
        low = {std::min(low.x, x), std::min(low.y, y)};
        high = {std::max(high.x, x), std::max(high.y, y)};
      }
    }
  };
  include(mesh.positions);
  std::for_each(others.begin(), others.end(), include);
  const Vec2 size = high - low;
  const double aspect = size.x > 0.0 ? size.y / size.x : 1.0;
  height_ = static_cast<int>(width * std::clamp(aspect, k_flattest, k_tallest));
  middle_ = low + 0.5 * size;
  const double padding = 2.0 * k_padding * width;
  scale_ = std::min((width_ - padding) / size.x, (height_ - padding) / size.y);
}

std::vector<Vec3> PatchView::projected(std::span<const Vec3> positions) const {
  std::vector<Vec3> places;
  places.reserve(positions.size());
  for (const Vec3 p : positions) {
    const double x = dot(view_.right, p) - middle_.x;
    const double y = dot(view_.up, p) - middle_.y;
    places.push_back(
        {0.5 * width_ + scale_ * x, 0.5 * height_ - scale_ * y, scale_ * dot(view_.towards, p)});
  }
  return places;
}

// Light from the upper left over the shoulder; both sides of the sheet are lit alike.
std::vector<double> PatchView::brightness_of(std::span<const Vec3> positions) const {
  const double scale = unit_scale(mesh_);
  std::vector<Vec3> normals(positions.size());
  for (const Triangle& triangle : mesh_.triangles) {
    const Vec3 p = scale * positions[triangle[0]];
    const Vec3 normal =
        cross(scale * positions[triangle[1]] + -p, scale * positions[triangle[2]] + -p);
    for (const Index v : triangle)
      normals[v] += normal;
  }
  Vec3 light = view_.towards + 0.75 * view_.up + -0.75 * view_.right;
  light = 1.0 / norm(light) * light;
  std::vector<double> brightness;
  brightness.reserve(normals.size());
  for (const Vec3 normal : normals) {
    const double length = norm(normal);
    const double facing = length > 0.0 ? std::abs(dot(normal, light)) / length : 0.0;
    brightness.push_back(k_least_brightness + (1.0 - k_least_brightness) * facing);
  }
  return brightness;
}

Image PatchView::picture(std::span<const Vec3> positions, std::span<const Color> colors) const {
  const auto vertices = projected(positions);
  const auto brightness = brightness_of(positions);
  return render({vertices, mesh_.triangles, colors, brightness}, width_, height_);
}

Image PatchView::shaded(std::span<const Vec3> positions) const {
  constexpr Color grey = {196, 200, 204};
  return picture(positions, std::vector<Color>(positions.size(), grey));
}

Image PatchView::picture_of_kinds(std::span<const Color> colors) const {
  if (mesh_.triangles.size() > k_most_split_triangles) return picture(mesh_.positions, colors);
  const auto corners = projected(mesh_.positions);
  const auto light = brightness_of(mesh_.positions);
  std::vector<Vec3> vertices;
  std::vector<Triangle> triangles;
  std::vector<Color> cell_colors;
  std::vector<double> brightness;
  for (const Triangle& t : mesh_.triangles) {
    const double mean_light = (light[t[0]] + light[t[1]] + light[t[2]]) / 3.0;
    const Vec3 centre = 1.0 / 3.0 * (corners[t[0]] + corners[t[1]] + corners[t[2]]);
    for (int i = 0; i < 3; ++i) {
      const Index v = t[i], next = t[(i + 1) % 3], last = t[(i + 2) % 3];
      const auto from = static_cast<Index>(vertices.size());
      vertices.insert(vertices.end(), {corners[v], 0.5 * (corners[v] + corners[next]), centre,
                                       0.5 * (corners[last] + corners[v])});
      brightness.insert(brightness.end(), {light[v], 0.5 * (light[v] + light[next]), mean_light,
                                           0.5 * (light[last] + light[v])});
      cell_colors.insert(cell_colors.end(), 4, colors[v]);
      triangles.push_back({from, from + 1, from + 2});
      triangles.push_back({from, from + 2, from + 3});
    }
  }
  return render({vertices, triangles, cell_colors, brightness}, width_, height_);
}

}  // namespace planish
