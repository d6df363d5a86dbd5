// Patches that are to stay their own mirror images.

#include <cstddef>

#include <planish/evolve/evolve.h>
#include <planish/measure/deviation.h>
#include <planish/measure/fairness.h>
#include <planish/mesh/shapes.h>
#include <planish/mesh/symmetry.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

const Plane k_upright{{1.0, 0.0, 0.0}, 0.0};

/// Its own mirror image to the bit.
SymmetricMesh symmetric_shape(const char* shape, std::size_t vertices) {
  return symmetric_mesh(Patch(make_shape(shape, vertices)), k_upright, MirrorSide::above);
}

void expect_symmetric_to_the_bit(const SymmetricMesh& mesh, const std::vector<Vec3>& positions) {
  for (Index v = 0; v < positions.size(); ++v)
    ASSERT_EQ(positions[mesh.image[v]], mirrored(k_upright, positions[v])) << v;
}

struct Figures {
  double strain, bending, deviation;
};

Figures figures_of_run(const Patch& patch, const EvolveResult& result) {
  double strain = 0.0;
  for (const SweepRecord& record : result.history)
    strain = record.level ? record.level->strain : strain;
  return {strain, measure_bending(patch.with_positions(result.positions)).bending,
          measure_deviation(patch, result.positions).rms};
}

TEST(SymmetricIn, StepsAsTheWholeDoesUntilThatGoesAstray) {
  const Patch patch(symmetric_shape("panel", 900).mesh);
  const Auto method{.limits = {.rms = 0.002}};
  const Stopping stopping{.max_sweeps = 6};
  const EvolveResult half = evolve(patch, method, stopping, {.symmetric_in = k_upright}),
                     whole = evolve(patch, method, stopping);
  ASSERT_EQ(half.history.size(), whole.history.size());
  for (std::size_t k = 0; k < whole.history.size(); ++k) {
    const LevelRecord &of_half = *half.history[k].level, &of_whole = *whole.history[k].level;
    EXPECT_NEAR(of_half.merit, of_whole.merit, 1e-6 * of_whole.merit) << k;
    EXPECT_NEAR(of_half.strain, of_whole.strain, 1e-6 * of_whole.strain) << k;
  }
}

TEST(SymmetricIn, EndsAsTheWholeDoesOnOneLevelAndOnSeveral) {
  for (const std::size_t vertices : {900U, 3600U}) {
    SCOPED_TRACE(vertices);
    const SymmetricMesh mesh = symmetric_shape("panel", vertices);
    const Patch patch(mesh.mesh);
    const Auto method{.limits = {.rms = 0.002}};
    const Stopping stopping = usual_stopping(method);
    const Constraints constraints{.symmetric_in = k_upright};
    const EvolveResult half = evolve(patch, method, stopping, constraints, {.threads = 1});
    expect_symmetric_to_the_bit(mesh, half.positions);
    EXPECT_EQ(half.stop, StopReason::strain_met);
    const Figures of_half = figures_of_run(patch, half),
                  of_whole = figures_of_run(patch, evolve(patch, method, stopping));
    EXPECT_NEAR(of_half.strain, of_whole.strain, 0.05 * of_whole.strain);
    EXPECT_NEAR(of_half.bending, of_whole.bending, 0.1 * of_whole.bending);
    EXPECT_NEAR(of_half.deviation, of_whole.deviation, 0.1 * of_whole.deviation);
    EXPECT_EQ(half.positions,
              evolve(patch, method, stopping, constraints, {.threads = 3}).positions);
  }
}

TEST(SymmetricIn, KeepsFlatResultsAndMovingBordersSymmetric) {
  const SymmetricMesh mesh = symmetric_shape("panel", 700);
  const Patch patch(mesh.mesh);
  for (const Auto& method :
       {Auto{.prefer = Prefer::flat}, Auto{.border = {BorderFreedom::Rule::within, 10.0}},
        Auto{.prefer = Prefer::near, .border = {BorderFreedom::Rule::slide}}}) {
    const EvolveResult result =
        evolve(patch, method, usual_stopping(method), {.symmetric_in = k_upright}, {.threads = 1});
    expect_symmetric_to_the_bit(mesh, result.positions);
    EXPECT_NE(result.positions, patch.positions());
  }
}

TEST(SymmetricIn, HoldsWhatIsFixedOnOneSide) {
  const SymmetricMesh mesh = symmetric_shape("panel", 700);
  const Patch patch(mesh.mesh);
  const Index fixed = patch.inner_vertices()[30];
  ASSERT_NE(mesh.image[fixed], fixed);
  const Auto method;
  const EvolveResult result =
      evolve(patch, method, usual_stopping(method), {.fixed = {fixed}, .symmetric_in = k_upright});
  EXPECT_EQ(result.positions[fixed], patch.positions()[fixed]);
}

}  // namespace
}  // namespace planish
