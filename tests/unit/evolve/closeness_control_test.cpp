#include "evolve/closeness_control.h"

#include <cmath>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

struct Laid {
  explicit Laid(TriMesh m) : mesh(std::move(m)), state(mesh, Connectivity(mesh), pool) {}

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
    Laid laid(make_shape(shape, 300));
    const Roughness roughness(laid.state);
    EXPECT_NEAR(roughness.now(), measure(laid.mesh, Connectivity(laid.mesh)).roughness, 1e-9);
    laid.crumple(1.0);
    const TriMesh moved{laid.state.positions_in_mesh_order(), laid.mesh.triangles};
    EXPECT_NEAR(roughness.now(), measure(moved, Connectivity(moved)).roughness, 1e-9) << shape;
  }
}

TEST(ClosenessControl, GrowsToTheMostWhereThereIsRoom) {
  const Laid laid(make_shape("panel", 300));
  ClosenessControl control(laid.state, 1.0, k_smooth_first);
  double closeness = k_smooth_first.first, strain = 0.1;
  // Before any strain is gone nothing may get rougher, so it stays.
  EXPECT_EQ(control.after_step(closeness, strain), closeness);
  for (int step = 0; step < 20; ++step, strain *= 0.7) {
    const double next = control.after_step(closeness, strain);
    EXPECT_GE(next, closeness);
    closeness = next;
  }
  EXPECT_EQ(closeness, k_smooth_first.most);
}

TEST(ClosenessControl, FallsWhereThePatchIsTooRoughButNotToNothing) {
  Laid laid(make_shape("panel", 300));
  ClosenessControl control(laid.state, 1.0, k_near_first);
  laid.crumple(20.0);
  EXPECT_DOUBLE_EQ(control.after_step(1.0, 0.1), 0.25);
  EXPECT_DOUBLE_EQ(control.after_step(0.25, 0.0), 0.0625);
  const double least = control.after_step(1e-9, 0.0);
  EXPECT_GT(least, 0.0);
  EXPECT_LT(least, k_smooth_first.first);
}

TEST(ClosenessControl, AllowsAllOfTheRoughnessOnlyWhenNoStrainIsLeft) {
  Laid laid(make_shape("panel", 300));
  const double at_first = Roughness(laid.state).now();
  const double room = 1.0, most = at_first + room * (at_first + 2.0);
  double low = 0.0, high = 20.0;  // crumples of nearly the most that is allowed
  for (int i = 0; i < 40; ++i) {
    const double middle = 0.5 * (low + high);
    laid.crumple(middle);
    (Roughness(laid.state).now() < 0.95 * most ? low : high) = middle;
  }
  laid.crumple(0.0);
  ClosenessControl control(laid.state, room, k_smooth_first);
  control.after_step(0.1, 0.1);
  laid.crumple(low);
  EXPECT_LT(control.after_step(0.1, 0.05), 0.1);
  EXPECT_EQ(control.after_step(0.1, 0.0), 0.1);
}

}  // namespace
}  // namespace planish
