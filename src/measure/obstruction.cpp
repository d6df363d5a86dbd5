#include <algorithm>
#include <span>
#include <vector>

#include <planish/measure/flattenability.h>
#include <planish/measure/obstruction.h>

#include "core/neumaier_sum.h"
#include "geometry/angle_between.h"
#include "geometry/curve_size.h"
#include "measure/area.h"
#include "mesh/border_loops.h"

namespace planish {

namespace {

// Border that turns less than this beyond 2 pi is taken for plane and convex. A surface rises over
// such a border by about the root of it: 0.3 % of its size.
constexpr double k_flat_border_room = 1e-5;

// Shares of the area below these are rounding: of the sums; and of a border that is nearly plane,
// where what it encloses is known only as well as that.
constexpr double k_share_rounding = 1e-9;
constexpr double k_flat_rounding = 1e-3;

/// How many vertices can be reached from the first along edges.
std::size_t reached_from(Index first, const Connectivity& connectivity) {
  std::vector<char> seen(connectivity.vertex_count(), 0);
  std::vector<Index> waiting = {first};
  seen[first] = 1;
  std::size_t count = 0;
  while (!waiting.empty()) {
    const Index v = waiting.back();
    waiting.pop_back();
    ++count;
    for (const Index w : connectivity.ring(v)) {
      if (seen[w] != 0) continue;
      seen[w] = 1;
      waiting.push_back(w);
    }
  }
  return count;
}

bool is_disk(const Patch& patch) {
  if (patch.border_loops().size() != 1) return false;
  const auto& border = patch.border_loops().front();
  const std::size_t used = patch.inner_vertices().size() + border.size();
  // Three sides a triangle, two triangles an edge but at the border: V - E + F = 1.
  const std::size_t edges = (3 * patch.triangles().size() + border.size()) / 2;
  return used + patch.triangles().size() == edges + 1 &&
         reached_from(border.front(), patch.connectivity()) == used;
}

double length_of(std::span<const Vec3> loop) {
  NeumaierSum length;
  for (std::size_t i = 0; i < loop.size(); ++i)
    length.add(norm(loop[(i + 1) % loop.size()] - loop[i]));
  return length.value();
}

/// Total curvature of the loop as a curve in space.
double curvature_of(std::span<const Vec3> loop) {
  const std::size_t n = loop.size();
  NeumaierSum sum;
  for (std::size_t i = 0; i < n; ++i)
    sum.add(angle_between(loop[i] - loop[(i + n - 1) % n], loop[(i + 1) % n] - loop[i]));
  return sum.value();
}

bool is_fixed_angle(const Connectivity& connectivity, Index b) {
  const auto ring = connectivity.ring(b);
  return std::all_of(ring.begin(), ring.end(), [&](Index v) { return connectivity.is_border(v); });
}

/// What a flattenable surface with this border has at most.
double area_limit(double area, std::span<const Vec3> border, bool is_flat_border) {
  const double length = length_of(border);
  const double round = length * length / (4.0 * std::numbers::pi);
  const double enclosed = enclosed_area(border);
  const bool is_known = is_flat_border && enclosed < (1.0 - k_flat_rounding) * area;
  return is_known ? std::min(round, enclosed) : round;
}

}  // namespace

bool Obstruction::has_flat_border() const {
  return turning_most - k_flat_turning <= k_flat_border_room;
}

bool Obstruction::is_notable() const {
  return excess_share > k_notable_excess;
}

std::optional<Obstruction> find_obstruction(const Patch& patch) {
  if (!is_disk(patch)) return std::nullopt;
  const auto& loop = patch.border_loops().front();
  const double scale = patch.unit_scale();
  std::vector<Vec3> border;
  border.reserve(loop.size());
  for (const Index b : loop)
    border.push_back(scale * patch.positions()[b]);

  Obstruction obstruction;
  obstruction.border_vertices = loop.size();
  obstruction.turning_most = curvature_of(border);
  NeumaierSum defects, turning;
  for (const double defect : angle_defects(patch))
    defects.add(defect);
  for (const Index b : loop) {
    turning.add(std::numbers::pi - border_angle(patch.positions(), patch.connectivity(), scale, b));
    if (is_fixed_angle(patch.connectivity(), b)) ++obstruction.fixed_angles;
  }
  obstruction.total_defect = defects.value();
  obstruction.border_turning = turning.value();

  const double area = area_of(patch.mesh(), scale);
  const double limit = area_limit(area, border, obstruction.has_flat_border());
  const double share = area > 0.0 ? 1.0 - limit / area : 0.0;
  obstruction.excess_share = share > k_share_rounding ? share : 0.0;
  obstruction.area = area / scale / scale;
  obstruction.area_limit = limit / scale / scale;
  obstruction.area_excess = obstruction.excess_share * obstruction.area;
  obstruction.border_length = length_of(border) / scale;
  return obstruction;
}

}  // namespace planish
