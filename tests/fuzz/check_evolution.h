#pragma once

// What holds of every method on every patch that may be evolved.

#include <cmath>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/patch.h>

#include "fuzz/bytes.h"
#include "fuzz/check.h"

namespace planish::fuzz {

/// Some vertices that are to stay.
inline Constraints fixed_vertices_from(Bytes& bytes, const TriMesh& mesh) {
  Constraints constraints;
  for (std::size_t count = bytes.whole(0, 7); count > 4; --count)
    constraints.fixed.push_back(static_cast<Index>(bytes.whole(0, mesh.positions.size() - 1)));
  return constraints;
}

/// @param border_stays false for methods that were told to move it
inline void check_evolution(const TriMesh& mesh, const EvolveResult& result,
                            const Constraints& constraints, bool border_stays) {
  check(result.positions.size() == mesh.positions.size(), "every vertex has a position");
  for (const Vec3& p : result.positions)
    check(is_finite(p), "positions are finite");
  for (const SweepRecord& record : result.history) {
    for (const double figure : {record.e_max, record.e_avg, record.energy})
      check(std::isfinite(figure) && figure >= 0.0, "figures of sweeps are finite");
  }
  const Patch patch(mesh);
  for (Index v = 0; border_stays && v < mesh.positions.size(); ++v) {
    if (!patch.is_inner(v)) check(result.positions[v] == mesh.positions[v], "the border stays");
  }
  for (const Index v : constraints.fixed)
    check(result.positions[v] == mesh.positions[v], "fixed vertices stay");
}

/// @param limit in model units
inline void check_deviation(const TriMesh& mesh, const EvolveResult& result, double limit) {
  const double size = bounding_box_diagonal(mesh);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    // What may be lost when coordinates are far greater than the limit.
    const double rounding = 1e-12 * (norm(mesh.positions[v]) + size);
    check(norm(result.positions[v] - mesh.positions[v]) <= limit * (1.0 + 1e-9) + rounding,
          "no vertex goes further than it may");
  }
}

}  // namespace planish::fuzz
