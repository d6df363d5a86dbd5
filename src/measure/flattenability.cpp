#include <algorithm>
#include <cmath>
#include <numbers>

#include <planish/measure/flattenability.h>

#include "core/math.h"
#include "core/neumaier_sum.h"
#include "geometry/dihedral_angle.h"
#include "geometry/smallest_angle.h"
#include "mesh/border_loops.h"
#include "mesh/edges.h"

namespace planish {

namespace {

double smallest_angle_of(const TriMesh& mesh, double scale) {
  double smallest = mesh.triangles.empty() ? 0.0 : std::numbers::pi;
  for (const Triangle& t : mesh.triangles) {
    const auto corner = [&](int k) { return scale * mesh.positions[t[k]]; };
    smallest = std::min(smallest, smallest_angle(corner(0), corner(1), corner(2)));
  }
  return smallest;
}

double rms_dihedral_angle(const Patch& patch, double scale) {
  const auto at = [&](Index v) { return scale * patch.positions()[v]; };
  NeumaierSum sum;
  std::size_t count = 0;
  for_each_edge(patch.connectivity(), [&](const Edge& edge) {
    if (edge.is_border()) return;
    const double angle = dihedral_angle(at(edge.from), at(edge.to), at(edge.left), at(edge.right));
    sum.add(angle * angle);
    ++count;
  });
  if (count == 0) return 0.0;
  return std::sqrt(sum.value() / static_cast<double>(count)) * 180.0 / std::numbers::pi;
}

/// How far a hole is from closing in the plane: its border laid out edge by edge, each corner with
/// its angle on the surface.
struct HoleClosing {
  double turning = 0.0;  // radians that it lacks of a whole turn
  double gap = 0.0;      // between its ends, in lengths of the border
};

HoleClosing closing_of(const Patch& patch, double scale, std::span<const Index> loop) {
  const auto& positions = patch.positions();
  double heading = 0.0, length = 0.0;
  Vec2 at;
  for (std::size_t k = 0; k < loop.size(); ++k) {
    const Index from = loop[k], to = loop[(k + 1) % loop.size()];
    const double side = norm(scale * positions[to] - scale * positions[from]);
    at = at + side * Vec2{math::cos(heading), math::sin(heading)};
    length += side;
    heading += std::numbers::pi - border_angle(positions, patch.connectivity(), scale, to);
  }
  return {std::abs(heading + 2.0 * std::numbers::pi), norm(at) / length};
}

/// The most over all holes.
HoleClosing hole_closing(const Patch& patch, double scale) {
  HoleClosing most;
  const auto& loops = patch.border_loops();
  if (loops.size() < 2) return most;
  const std::size_t outline = border_kinds(patch.positions(), patch.connectivity(), scale).outline;
  for (std::size_t k = 0; k < loops.size(); ++k) {
    if (k == outline) continue;
    const HoleClosing closing = closing_of(patch, scale, loops[k]);
    most = {std::max(most.turning, closing.turning), std::max(most.gap, closing.gap)};
  }
  return most;
}

}  // namespace

Flattenability summarise_defects(std::span<const double> defects, std::size_t inner_vertices) {
  Flattenability figures;
  NeumaierSum energy, sum;
  for (const double defect : defects) {
    const double size = std::abs(defect);
    if (size > figures.e_max || std::isnan(size)) figures.e_max = size;  // a NaN stays
    sum.add(size);
    energy.add(size * size);
  }
  figures.energy = energy.value();
  figures.sum_abs_defect = sum.value();
  if (inner_vertices > 0) figures.e_avg = sum.value() / static_cast<double>(inner_vertices);
  return figures;
}

Flattenability measure(const Patch& patch) {
  Flattenability figures = summarise_defects(angle_defects(patch), patch.inner_vertices().size());
  const double scale = patch.unit_scale();
  figures.min_angle = smallest_angle_of(patch.mesh(), scale);
  figures.roughness = rms_dihedral_angle(patch, scale);
  const HoleClosing closing = hole_closing(patch, scale);
  figures.hole_turning = closing.turning;
  figures.hole_gap = closing.gap;
  return figures;
}

bool is_flattenable(const Flattenability& figures, const Inspection& inspection) {
  return !blocking_problem(inspection, Purpose::unfold) && figures.e_max <= k_flattenable_e_max &&
         figures.sum_abs_defect <= k_flattenable_sum && figures.hole_turning <= k_flattenable_sum &&
         figures.hole_gap <= k_flattenable_sum;
}

}  // namespace planish
