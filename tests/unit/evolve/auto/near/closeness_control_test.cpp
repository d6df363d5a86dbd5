#include "evolve/auto/near/closeness_control.h"

#include <algorithm>
#include <cmath>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

using namespace tuning::prefer_near;

struct PatchToCrumple {
  explicit PatchToCrumple(TriMesh m) : mesh(std::move(m)), state(Patch(mesh), pool) {}

  /// Lifts every other vertex; edges are some 20 mm long.
  void crumple(double millimetres) {
    for (Index v = 0; v < state.inner_count(); v += 2)
      state.move(v, state.origin(v) + state.scale() * Vec3{0.0, 0.0, millimetres});
  }

  TriMesh mesh;
  ThreadPool pool{1};
  PatchState state;
};

TEST(Roughness, IsThatOfTheFigures) {
  for (const char* shape : {"panel", "dome", "saddle", "cylinder"}) {
    PatchToCrumple laid(make_shape(shape, 300));
    const Roughness roughness(laid.state);
    EXPECT_NEAR(roughness.now(), measure(Patch(laid.mesh)).roughness, 1e-9);
    laid.crumple(1.0);
    const TriMesh moved{laid.state.positions_in_mesh_order(), laid.mesh.triangles};
    EXPECT_NEAR(roughness.now(), measure(Patch(moved)).roughness, 1e-9) << shape;
  }
}

TEST(ClosenessControl, GrowsToTheMostWhereThereIsRoom) {
  const PatchToCrumple laid(make_shape("panel", 300));
  ClosenessControl control(laid.state, 1.0, k_usual_closeness);
  double closeness = k_usual_closeness.first, strain = 0.1;
  // Before any strain is gone nothing may get rougher, so it stays.
  EXPECT_EQ(control.after_step(closeness, strain, true), closeness);
  for (int step = 0; step < 20; ++step, strain *= 0.7) {
    EXPECT_LE(control.after_step(closeness, strain, false), std::max(closeness, k_most_if_stiff));
    const double next = control.after_step(closeness, strain, true);
    EXPECT_GE(next, closeness);
    closeness = next;
  }
  EXPECT_EQ(closeness, k_usual_closeness.most);
}

TEST(ClosenessControl, FallsWhereThePatchIsTooRoughButNotToNothing) {
  PatchToCrumple laid(make_shape("panel", 300));
  ClosenessControl control(laid.state, 1.0, k_usual_closeness);
  EXPECT_FALSE(control.is_too_rough());
  laid.crumple(20.0);
  EXPECT_TRUE(control.is_too_rough());
  EXPECT_DOUBLE_EQ(control.after_step(1.0, 0.1, true), 0.25);
  EXPECT_DOUBLE_EQ(control.after_step(0.25, 0.0, false), 0.0625);
  const double least = control.after_step(1e-9, 0.0, true);
  EXPECT_GT(least, 0.0);
  EXPECT_LT(least, k_usual_closeness.first);
}

/// Crumples the patch until its roughness is nearly this.
void crumple_to(PatchToCrumple& laid, double roughness) {
  double low = 0.0, high = 20.0;
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    laid.crumple(middle);
    (Roughness(laid.state).now() < roughness ? low : high) = middle;
  }
  laid.crumple(low);
}

TEST(ClosenessControl, AllowsAllOfTheRoughnessOnlyWhenNoStrainIsLeft) {
  PatchToCrumple laid(make_shape("panel", 300));
  const double at_first = Roughness(laid.state).now();
  const double room = 1.0, most = at_first + room * (at_first + 2.5);
  ClosenessControl control(laid.state, room, k_usual_closeness);
  control.after_step(0.1, 0.1, true);
  crumple_to(laid, 0.95 * most);
  EXPECT_LT(control.after_step(0.1, 0.05, true), 0.1);
  EXPECT_EQ(control.after_step(0.1, 0.0, true), 0.1);
  EXPECT_FALSE(control.is_too_rough());
}

TEST(ClosenessControl, AllowsByThePowerOfTheStrainThatIsLeft) {
  // Where half of the strain is left, 1 - 2^-allowance_exponent of the room is there.
  for (const double allowance_exponent : {k_usual_closeness.allowance_exponent, 0.5}) {
    PatchToCrumple laid(make_shape("panel", 300));
    const double at_first = Roughness(laid.state).now(), room = 2.0;
    const double allowed = at_first + room * (at_first + k_usual_closeness.more) *
                                          (1.0 - std::pow(0.5, allowance_exponent));
    ClosenessPace schedule = k_usual_closeness;
    schedule.allowance_exponent = allowance_exponent;
    ClosenessControl control(laid.state, room, schedule);
    control.after_step(0.1, 0.1, true);
    crumple_to(laid, 0.99 * allowed);
    EXPECT_EQ(control.after_step(0.1, 0.05, true), 0.1);
    crumple_to(laid, 1.01 * allowed);
    EXPECT_LT(control.after_step(0.1, 0.05, true), 0.1);
  }
}

}  // namespace
}  // namespace planish
