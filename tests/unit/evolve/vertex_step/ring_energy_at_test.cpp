#include "evolve/vertex_step/ring_energy_at.h"

#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

/// The stars of a rough patch beside the plain ones.
class Stars {
 public:
  explicit Stars(std::uint64_t seed)
      : mesh_(meshes::rough_grid(7, 6, seed)),
        plain_(mesh_),
        patch_(mesh_),
        pool_(1),
        state_(patch_, pool_) {
    for (Index v = 0; v < state_.inner_count(); ++v)
      defects_.push_back(state_.defect(v));
  }

  const PatchState& state() const { return state_; }
  const plain::Patch& plain() const { return plain_; }
  RingEnergyAt energy(Index v) const {
    return {state_, v, rings_by_vertex(state_.plan())[v], defects_};
  }

 private:
  TriMesh mesh_;
  plain::Patch plain_;
  Patch patch_;
  ThreadPool pool_;
  PatchState state_;
  std::vector<double> defects_;
};

TEST(RingEnergyAt, IsTheRingEnergyWhereverTheCentreIs) {
  const Stars stars(1);
  const double scale = stars.state().scale();
  meshes::Random random(7);
  for (Index v = 0; v < stars.state().inner_count(); ++v) {
    const RingEnergyAt energy = stars.energy(v);
    for (int place = 0; place < 5; ++place) {
      Vec3 x = stars.plain().mesh.positions[stars.state().vertex_of(v)];
      if (place > 0) x += 0.4 * Vec3{random.number(), random.number(), random.number()};
      EXPECT_NEAR(energy.value(scale * x), stars.plain().ring_energy(stars.state().vertex_of(v), x),
                  1e-13);
    }
  }
}

TEST(RingEnergyAt, KnowsTheDefectsOfTheStar) {
  const Stars stars(2);
  const PatchState& state = stars.state();
  const Vec3 shift{0.1, -0.2, 0.15};
  for (Index v = 0; v < state.inner_count(); ++v) {
    plain::Patch moved = stars.plain();
    moved.mesh.positions[state.vertex_of(v)] += shift;
    const auto defects = stars.energy(v).defects(state.position(v) + state.scale() * shift);
    const auto ring = rings_by_vertex(state.plan())[v];
    ASSERT_EQ(defects.size(), ring.size() + 1);
    EXPECT_NEAR(defects.back(), moved.defect(state.vertex_of(v)), 1e-13);
    for (std::size_t j = 0; j < ring.size(); ++j) {
      const Index w = state.vertex_of(ring[j]);
      EXPECT_NEAR(defects[j], moved.inner[w] ? moved.defect(w) : 0.0, 1e-13);
    }
  }
}

TEST(RingEnergyAt, HasTheDerivativesOfThePowerSeries) {
  const Stars stars(3);
  const PatchState& state = stars.state();
  meshes::Random random(5);
  for (Index v = 0; v < state.inner_count(); ++v) {
    const Vec3 direction{random.number(), random.number(), random.number()};
    double slope = 0.0, curvature = 0.0;
    // A length of 1 in here is 1 / scale in the mesh.
    for (const plain::Series& d :
         stars.plain().defects_along(state.vertex_of(v), (1.0 / state.scale()) * direction)) {
      slope += 2.0 * d.c[0] * d.c[1];
      curvature += 2.0 * d.c[1] * d.c[1];
    }
    const StarSample energy = stars.energy(v).along(state.position(v), direction);
    EXPECT_NEAR(energy.slope, slope, 1e-11 * (1.0 + std::abs(slope)));
    EXPECT_NEAR(energy.curvature, curvature, 1e-11 * (1.0 + curvature));
    EXPECT_NEAR(energy.value, stars.energy(v).value(state.position(v)), 1e-15);
  }
}

TEST(RingEnergyAt, HasTheSlopeOfDifferenceQuotients) {
  const Stars stars(4);
  const PatchState& state = stars.state();
  const Vec3 direction{0.3, -0.5, 0.8};
  constexpr double h = 1e-6;
  for (Index v = 0; v < state.inner_count(); ++v) {
    const RingEnergyAt energy = stars.energy(v);
    const Vec3 x = state.position(v) + Vec3{0.01, 0.02, -0.01};
    const double slope =
        (energy.value(x + h * direction) - energy.value(x - h * direction)) / (2.0 * h);
    EXPECT_NEAR(energy.along(x, direction).slope, slope, 1e-6 * (1.0 + std::abs(slope)));
  }
}

TEST(RingEnergyAt, TellsWhereATriangleHasNoAngles) {
  const TriMesh mesh = meshes::fan(5, 0.4);
  const Patch patch(mesh);
  ThreadPool pool(1);
  const PatchState state(patch, pool);
  const auto ring = rings_by_vertex(state.plan())[0];
  const RingEnergyAt energy(state, 0, ring, std::vector<double>{state.defect(0)});
  EXPECT_FALSE(energy.has_needle(state.position(0)));
  EXPECT_TRUE(energy.has_needle(state.position(ring[2])));
  EXPECT_TRUE(energy.has_needle(2.0 * state.position(ring[1]) - state.position(ring[2])));
  EXPECT_TRUE(energy.has_needle({std::nan(""), 0.0, 0.0}));
}

}  // namespace
}  // namespace planish
