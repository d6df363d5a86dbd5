#include "evolve/auto/shared/defect_polish.h"

#include <cmath>
#include <numbers>

#include <planish/measure/flattenability.h>

#include <gtest/gtest.h>

#include "evolve/auto/shared/smallest_angle.h"
#include "unit/evolve/auto/shared/flattened_panel.h"

namespace planish {
namespace {

/// A panel that lies flat but for kinks at single vertices and one dent.
TriMesh kinked_panel() {
  TriMesh mesh = flattened_panel(1200);
  const Patch patch(mesh);
  const Vec3 middle = mesh.positions[patch.inner_vertices()[400]];
  const double size = norm(mesh.positions.front() - mesh.positions.back());
  for (const Index v : patch.inner_vertices()) {
    const double r = norm(mesh.positions[v] - middle) / size;
    mesh.positions[v].z +=
        size * (1e-3 * std::exp(-100.0 * r * r) + 1e-4 * std::sin(1.7 * static_cast<double>(v)));
  }
  return mesh;
}

struct Polished {
  explicit Polished(const TriMesh& mesh, const DescentLimits& limits = {},
                    const Constraints& constraints = {})
      : state(Patch(mesh), pool, constraints), polish(state, pool, limits) {}
  ThreadPool pool{1};
  PatchState state;
  DefectPolish polish;
};

TEST(DefectPolish, TakesOutKinksAndDents) {
  const TriMesh mesh = kinked_panel();
  Polished run(mesh);
  double energy = run.state.measure(run.pool).energy;
  EXPECT_GT(run.state.measure(run.pool).e_max, 1e-3);
  int cycles = 0;
  for (; cycles < 40 && run.state.measure(run.pool).e_max > 1e-6; ++cycles) {
    EXPECT_GT(run.polish.cycle().moved, 0U);
    const double now = run.state.measure(run.pool).energy;
    EXPECT_LT(now, energy);
    energy = now;
  }
  EXPECT_LT(cycles, 40);
  EXPECT_FALSE(run.polish.held_by().has_value());
}

TEST(DefectPolish, KeepsLimitsAndWhatIsFixed) {
  const TriMesh mesh = kinked_panel();
  const std::vector<Index> fixed = {Patch(mesh).inner_vertices()[300]};
  const double edge =
      norm(mesh.positions[mesh.triangles[0][0]] - mesh.positions[mesh.triangles[0][1]]);
  Polished loose(mesh, {}, {.fixed = fixed});
  DescentLimits limits;
  limits.deviation = 0.02 * edge * loose.state.scale();
  limits.angle = 0.9 * smallest_angle(loose.state, loose.state.triangles(), loose.pool);
  Polished run(mesh, limits, {.fixed = fixed});
  for (int i = 0; i < 5; ++i)
    run.polish.cycle();
  EXPECT_EQ(run.polish.held_by(), StopReason::deviation_limit);
  EXPECT_GE(smallest_angle(run.state, run.state.triangles(), run.pool), limits.angle);
  double furthest = 0.0;
  for (std::size_t v = 0; v < run.state.inner_count(); ++v)
    furthest = std::max(furthest, norm(run.state.position(v) - run.state.origin(v)));
  EXPECT_LE(furthest, limits.deviation);
  EXPECT_GT(furthest, 0.5 * limits.deviation);
  EXPECT_EQ(run.state.positions_in_mesh_order()[fixed[0]], mesh.positions[fixed[0]]);
}

}  // namespace
}  // namespace planish
