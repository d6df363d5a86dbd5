#include "report/patch_picture.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include <planish/measure/angle_defect.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/connectivity.h>

#include "report/scale_limit.h"
#include "report/view.h"

namespace planish {

namespace {

constexpr int k_width = 880;                          // pixels: sharp at half of it
constexpr double k_flattest = 0.5, k_tallest = 1.15;  // height over width
constexpr double k_padding = 12.0;                    // pixels
constexpr double k_scale_share = 0.98;                // of the vertices within the scale
constexpr double k_least_brightness = 0.5;            // of what faces away from the light

// Where a patch appears in the picture.
struct Frame {
  View view;
  double scale = 1.0;  // pixels per model unit
  Vec2 middle = {};    // of what is seen, along right and up
  int width = k_width, height = k_width;
};

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

Frame frame_of(const TriMesh& before, const TriMesh& after) {
  Frame frame{view_of(before)};
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Vec2 low = {infinity, infinity}, high = {-infinity, -infinity};
  for (const TriMesh* mesh : {&before, &after}) {
    for (const Triangle& triangle : mesh->triangles) {
      for (const Index v : triangle) {
        const double x = dot(frame.view.right, mesh->positions[v]);
        const double y = dot(frame.view.up, mesh->positions[v]);
        low = {std::min(low.x, x), std::min(low.y, y)};
        high = {std::max(high.x, x), std::max(high.y, y)};
      }
    }
  }
  const Vec2 size = high - low;
  const double aspect = size.x > 0.0 ? size.y / size.x : 1.0;
  frame.height = static_cast<int>(k_width * std::clamp(aspect, k_flattest, k_tallest));
  frame.middle = low + 0.5 * size;
  frame.scale =
      std::min((frame.width - 2.0 * k_padding) / size.x, (frame.height - 2.0 * k_padding) / size.y);
  return frame;
}

std::vector<Vec3> projected(const TriMesh& mesh, const Frame& frame) {
  std::vector<Vec3> places;
  places.reserve(mesh.positions.size());
  for (const Vec3 p : mesh.positions) {
    const double x = dot(frame.view.right, p) - frame.middle.x;
    const double y = dot(frame.view.up, p) - frame.middle.y;
    places.push_back({0.5 * frame.width + frame.scale * x, 0.5 * frame.height - frame.scale * y,
                      frame.scale * dot(frame.view.towards, p)});
  }
  return places;
}

// Light from the upper left over the shoulder; both sides of the sheet are lit alike.
std::vector<double> brightness_of(const TriMesh& mesh, const View& view) {
  const double scale = unit_scale(mesh);
  std::vector<Vec3> normals(mesh.positions.size());
  for (const Triangle& triangle : mesh.triangles) {
    const Vec3 p = scale * mesh.positions[triangle[0]];
    const Vec3 normal =
        cross(scale * mesh.positions[triangle[1]] + -p, scale * mesh.positions[triangle[2]] + -p);
    for (const Index v : triangle)
      normals[v] += normal;
  }
  Vec3 light = view.towards + 0.75 * view.up + -0.75 * view.right;
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

Image picture(const TriMesh& mesh, std::span<const double> defects, double limit, ColorMap map,
              const Frame& frame) {
  std::vector<Color> colors;
  colors.reserve(defects.size());
  for (const double defect : defects) {
    colors.push_back(color_at(map, (map == ColorMap::paper ? std::abs(defect) : defect) / limit));
  }
  const auto vertices = projected(mesh, frame);
  const auto brightness = brightness_of(mesh, frame.view);
  return render({vertices, mesh.triangles, colors, brightness}, frame.width, frame.height);
}

}  // namespace

PatchPictures patch_pictures(const TriMesh& before, const TriMesh& after, ColorMap colors) {
  const Connectivity connectivity(before);
  const auto defects_before = angle_defects(before, connectivity);
  const auto defects_after = angle_defects(after, connectivity);
  const double limit = defect_limit(defects_before, connectivity);
  const Frame frame = frame_of(before, after);
  return {picture(before, shown_defects(defects_before, connectivity), limit, colors, frame),
          picture(after, shown_defects(defects_after, connectivity), limit, colors, frame), limit};
}

}  // namespace planish
