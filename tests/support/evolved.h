#pragma once

#include <algorithm>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/measure/flattenability.h>
#include <planish/mesh/patch.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

namespace planish {

/// Of a mesh whose vertices are at these positions.
inline Flattenability figures_of(const TriMesh& mesh, const std::vector<Vec3>& positions) {
  return measure(Patch({positions, mesh.triangles}));
}

/// Runs of `auto`, and what tests ask of them.
namespace auto_runs {

inline constexpr double k_no_strain = 1e-3;

inline Auto smooth() {
  return {.prefer = Prefer::smooth};
}

inline EvolveResult run(const TriMesh& mesh, const Auto& method, unsigned threads = 1) {
  return evolve(Patch(mesh), method, usual_stopping(method), {}, {.threads = threads});
}

inline double rms_strain(const TriMesh& mesh, const std::vector<Vec3>& positions) {
  const TriMesh after{positions, mesh.triangles};
  const Patch patch(after);
  return edge_strain(patch, unfold(patch, {.least_stretch = true}).positions).rms;
}

inline double farthest(const TriMesh& mesh, const std::vector<Vec3>& positions, bool of_border) {
  const Patch patch(mesh);
  double most = 0.0;
  for (Index v = 0; v < positions.size(); ++v) {
    if (patch.is_border(v) == of_border)
      most = std::max(most, norm(positions[v] - mesh.positions[v]));
  }
  return most;
}

}  // namespace auto_runs
}  // namespace planish
