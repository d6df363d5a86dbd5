#include "evolve/vertex_step/move_check.h"

#include <cmath>
#include <stdexcept>

#include <planish/evolve/evolve.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "evolve/methods/controllable_laplacian.h"
#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

class MoveCheckTest : public testing::Test {
 protected:
  const TriMesh mesh_ = meshes::rough_grid(6, 6, 3);
  const Patch patch_{mesh_};
  ThreadPool pool_{1};
  PatchState state_{patch_, pool_};
  const MoveCheck check_{state_};
};

TEST_F(MoveCheckTest, KnowsTheRingEnergyOfEveryInnerVertex) {
  const plain::Patch patch(mesh_);
  for (std::size_t i = 0; i < state_.inner_count(); ++i) {
    const Index v = state_.vertex_of(i);
    const MoveCheck::Energy energy = check_.energy(i);
    EXPECT_NEAR(energy.value, patch.ring_energy(v, mesh_.positions[v]), 1e-12);
    EXPECT_LT(energy.rounding, 1e-10);
  }
}

TEST_F(MoveCheckTest, LetsAMovePassThatLowersTheEnergy) {
  ControllableMover mover({}, state_);
  std::size_t moves = 0;
  for (std::size_t visit = 0; visit < state_.inner_count(); ++visit) {
    const std::size_t v = state_.plan().visits[visit];
    const MoveCheck::Energy before = check_.energy(v);
    moves += mover.move(visit, visit + 1);
    EXPECT_NO_THROW(check_.require_fall(v, before));
  }
  EXPECT_GT(moves, 0U);
}

TEST_F(MoveCheckTest, StopsAMoveThatRaisesIt) {
  for (std::size_t v = 0; v < state_.inner_count(); ++v) {
    const MoveCheck::Energy before = check_.energy(v);
    const Vec3 at = state_.position(v);
    state_.move(v, at + Vec3{0.0, 0.0, 0.5});
    if (check_.energy(v).value < before.value) {
      state_.move(v, at - Vec3{0.0, 0.0, 0.5});
    }
    ASSERT_GT(check_.energy(v).value, before.value);
    try {
      check_.require_fall(v, before);
      ADD_FAILURE() << "passed a move of vertex " << v;
    } catch (const std::logic_error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("raised its ring energy"));
    }
    state_.move(v, at);
  }
}

TEST_F(MoveCheckTest, StopsAMoveThatRaisesItByMoreThanRoundingAlone) {
  MoveCheck::Energy before = check_.energy(0);
  before.value *= 1.0 - 1e-9;
  EXPECT_THROW(check_.require_fall(0, before), std::logic_error);
}

TEST(MoveCheckOfShortEdges, ClaimsNothingWhereAreasHaveNoDigits) {
  TriMesh mesh = meshes::rough_grid(6, 6, 3);
  mesh.positions[0] = {-1e78, -1e78, 0.0};
  const Patch patch(mesh);
  ThreadPool pool(1);
  const PatchState state(patch, pool);
  const MoveCheck check(state);
  for (std::size_t v = 0; v < state.inner_count(); ++v)
    EXPECT_TRUE(std::isinf(check.energy(v).rounding)) << v;
}

}  // namespace
}  // namespace planish
