#include <algorithm>
#include <cmath>
#include <numbers>

#include <planish/measure/flattenability.h>

#include "core/careful_sum.h"
#include "geometry/dihedral_angle.h"
#include "geometry/smallest_angle.h"

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

double rms_dihedral_angle(const TriMesh& mesh, const Connectivity& connectivity, double scale) {
  const auto at = [&](Index v) { return scale * mesh.positions[v]; };
  CarefulSum sum;
  std::size_t count = 0;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const auto ring = connectivity.ring(v);
    const std::size_t n = ring.size();
    // The ends of an open ring are border edges.
    const std::size_t begin = connectivity.is_border(v) ? 1 : 0;
    const std::size_t end = connectivity.is_border(v) ? n - 1 : n;
    for (std::size_t j = begin; j < end && n > 0; ++j) {
      if (ring[j] < v) continue;  // every edge once
      const double angle =
          dihedral_angle(at(v), at(ring[j]), at(ring[(j + 1) % n]), at(ring[(j + n - 1) % n]));
      sum.add(angle * angle);
      ++count;
    }
  }
  if (count == 0) return 0.0;
  return std::sqrt(sum.value() / static_cast<double>(count)) * 180.0 / std::numbers::pi;
}

}  // namespace

Flattenability summarise_defects(std::span<const double> defects, std::size_t inner_vertices) {
  Flattenability figures;
  CarefulSum energy, sum;
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

Flattenability measure(const TriMesh& mesh, const Connectivity& connectivity) {
  Flattenability figures =
      summarise_defects(angle_defects(mesh, connectivity), connectivity.inner_vertices().size());
  const double scale = unit_scale(mesh);
  figures.min_angle = smallest_angle_of(mesh, scale);
  figures.roughness = rms_dihedral_angle(mesh, connectivity, scale);
  return figures;
}

bool is_flattenable(const Flattenability& figures, const Inspection& inspection) {
  return !blocking_problem(inspection, Purpose::unfold) && figures.e_max <= k_flattenable_e_max &&
         figures.sum_abs_defect <= k_flattenable_sum;
}

}  // namespace planish
