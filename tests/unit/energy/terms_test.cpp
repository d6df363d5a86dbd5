#include <limits>
#include <vector>

#include <planish/measure/fairness.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "energy/hinge_bending.h"
#include "energy/line_bending.h"
#include "energy/move_barrier.h"
#include "energy/proximity.h"
#include "energy/shape_guard.h"

namespace planish {
namespace {

struct Surface {
  explicit Surface(TriMesh of) : mesh(std::move(of)), x(mesh.positions) {}

  TriMesh mesh;
  Patch patch{mesh};
  std::vector<Vec3> x;  // positions now
  ThreadPool pool{1};
};

/// The difference quotient of a function by the position of a vertex.
template <class Function>
Vec3 slope_of(const Function& function, Index v, std::vector<Vec3>& x) {
  constexpr double h = 1e-6;
  const Vec3 at = x[v];
  const auto along = [&](Vec3 step) {
    x[v] = at + step;
    const double after = function();
    x[v] = at - step;
    const double before = function();
    x[v] = at;
    return (after - before) / (2.0 * h);
  };
  return {along({h, 0, 0}), along({0, h, 0}), along({0, 0, h})};
}

void expect_near(Vec3 a, Vec3 b, double most) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
  EXPECT_NEAR(a.z, b.z, most);
}

/// Adds f' times the gradient of each part.
template <std::size_t n>
void add(const Summand<n>& part, std::vector<Vec3>& gradient) {
  for (std::size_t k = 0; k < n; ++k)
    gradient[part.vertices[k]] += part.first * part.gradient[k];
}

TEST(HingeBending, IsTheBendingOfTheMesh) {
  constexpr double b0 = 0.25;
  for (const char* name : {"panel", "saddle", "cylinder"}) {
    Surface surface(make_shape(name, 300));
    HingeBending hinges(surface.patch, surface.x, b0);
    hinges.set_weights(surface.x, surface.pool);
    EXPECT_NEAR(hinges.value(surface.x, surface.pool), measure_bending(surface.patch).bending / b0,
                1e-8)
        << name;
  }
}

TEST(HingeBending, CountsFromAFractionOfTheFirstAngles) {
  Surface surface(make_shape("panel", 100));
  HingeBending hinges(surface.patch, surface.x, 1.0);
  hinges.set_weights(surface.x, surface.pool);
  EXPECT_EQ(hinges.value(surface.x, surface.pool, 1.0), 0.0);
  EXPECT_NEAR(hinges.value(surface.x, surface.pool, 0.75),
              0.0625 * hinges.value(surface.x, surface.pool), 1e-12);
}

TEST(HingeBending, HasTheGradientOfDifferenceQuotients) {
  constexpr double kept = 0.6;
  Surface surface(make_shape("panel", 100));
  HingeBending hinges(surface.patch, surface.x, 0.3);
  hinges.set_weights(surface.x, surface.pool);
  surface.x[7] += Vec3{0.01, -0.02, 0.03};
  std::vector<Vec3> gradient(surface.x.size());
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    const Summand<4> part = hinges.summand(h, surface.x, kept);
    EXPECT_EQ(part.vertices, hinges.stencil(h));
    EXPECT_GT(part.second, 0.0);
    add(part, gradient);
  }
  const auto value = [&] { return hinges.value(surface.x, surface.pool, kept); };
  for (Index v = 0; v < surface.x.size(); ++v)
    expect_near(gradient[v], slope_of(value, v, surface.x), 1e-5 * (1.0 + norm(gradient[v])));
}

TEST(HingeBending, IsZeroWhereATriangleHasNoArea) {
  Surface surface({{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}});
  HingeBending hinges(surface.patch, surface.x, 1.0);
  ASSERT_EQ(hinges.size(), 1U);
  hinges.set_weights(surface.x, surface.pool);
  EXPECT_EQ(hinges.value(surface.x, surface.pool), 0.0);
  EXPECT_EQ(hinges.summand(0, surface.x).gradient[0], (Vec3{}));
}

/// Pushes a vertex nearly onto another, so that corners are sharp.
void squeeze(Surface& surface) {
  const Connectivity& connectivity = surface.patch.connectivity();
  for (Index v = 0; v < surface.x.size(); ++v) {
    if (surface.patch.is_border(v)) continue;
    surface.x[v] += 0.93 * (surface.x[connectivity.ring(v)[0]] - surface.x[v]);
    return;
  }
}

TEST(ShapeGuard, IsNothingForTheDesign) {
  Surface surface(make_shape("panel", 100));
  const ShapeGuard guard(surface.mesh.triangles, surface.x, 0.05);
  EXPECT_LT(guard.value(surface.x, surface.pool), 1e-25);
  for (std::size_t c = 0; c < guard.corner_count(); ++c)
    EXPECT_EQ(guard.corner_summand(c, surface.x).second, 0.0);
}

TEST(ShapeGuard, CountsStrainByArea) {
  Surface surface(make_shape("panel", 100));
  const ShapeGuard guard(surface.mesh.triangles, surface.x, 0.05);
  // All edges are 3 % longer.
  for (Vec3& p : surface.x)
    p = 1.03 * p;
  const double s = 0.03 / 0.15;
  EXPECT_NEAR(guard.value(surface.x, surface.pool), s * s * s * s + 0.02 * s * s, 1e-12);
}

TEST(ShapeGuard, HasTheGradientOfDifferenceQuotients) {
  Surface surface(make_shape("panel", 100));
  const ShapeGuard guard(surface.mesh.triangles, surface.x, 0.05);
  squeeze(surface);
  std::size_t sharp = 0;
  std::vector<Vec3> gradient(surface.x.size());
  for (std::size_t e = 0; e < guard.edge_count(); ++e) {
    EXPECT_GT(guard.edge_summand(e, surface.x).second, 0.0);
    add(guard.edge_summand(e, surface.x), gradient);
  }
  for (std::size_t c = 0; c < guard.corner_count(); ++c) {
    const Summand<3> part = guard.corner_summand(c, surface.x);
    EXPECT_GE(part.second, 0.0);
    sharp += part.second > 0.0 ? 1 : 0;
    add(part, gradient);
  }
  EXPECT_GT(sharp, 0U);
  const auto value = [&] { return guard.value(surface.x, surface.pool); };
  for (Index v = 0; v < surface.x.size(); ++v)
    expect_near(gradient[v], slope_of(value, v, surface.x), 1e-6 * (1.0 + norm(gradient[v])));
}

TEST(MoveBarrier, HasTheDerivativesOfDifferenceQuotients) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const MoveBarrier barrier({0.5, 1.0, infinite}, {2.0, 2.0, 1.0});
  std::vector<Vec3> moves = {{0.3, -0.2, 0.1}, {0.1, 0.8, 0.2}, {5.0, 0.0, 0.0}};
  EXPECT_NEAR(MoveBarrier({1.0}, {3.0}).value({{0.0, 0.85, 0.0}}), 0.1, 1e-15);
  const auto value = [&] { return barrier.value(moves); };
  for (Index v = 0; v < 3; ++v) {
    const auto [gradient, hessian] = barrier.derivatives(v, moves[v]);
    expect_near(gradient, slope_of(value, v, moves), 1e-8);
    const auto along_x = [&] { return barrier.derivatives(v, moves[v]).gradient.x; };
    const auto along_z = [&] { return barrier.derivatives(v, moves[v]).gradient.z; };
    expect_near({hessian.xx, hessian.xy, hessian.xz}, slope_of(along_x, v, moves), 1e-8);
    expect_near({hessian.xz, hessian.yz, hessian.zz}, slope_of(along_z, v, moves), 1e-8);
    const double minor = hessian.xx * hessian.yy - hessian.xy * hessian.xy;
    EXPECT_GE(hessian.xx, 0.0);
    EXPECT_GE(minor, 0.0);
    EXPECT_GE(minor * hessian.zz + 2.0 * hessian.xy * hessian.xz * hessian.yz -
                  hessian.xx * hessian.yz * hessian.yz - hessian.yy * hessian.xz * hessian.xz,
              0.0);
  }
  EXPECT_FALSE(barrier.is_reached(moves));
  moves[1].y = 0.95;
  EXPECT_TRUE(barrier.is_reached(moves));
}

TEST(LineBending, IsTheMeanSquareOfSecondDifferences) {
  const LineBending line({{{0, 1, 2}, {1.0, -2.0, 1.0}}, {{1, 2, 9}, {1.0, -2.0, 1.0}}}, 0.5);
  const std::vector<Vec3> moves = {{0, 0, 0}, {0, 1, 0}, {0, 2, 3}};
  // 0 0 3, and 0 -3 -6 with nothing at the last one; over 2 x 0.25.
  EXPECT_NEAR(line.value(moves), (9.0 + 9.0 + 36.0) / 0.5, 1e-12);
  EXPECT_EQ(LineBending({}, 0.5).value(moves), 0.0);
}

TEST(LineBending, HasTheGradientOfDifferenceQuotients) {
  const LineBending line({{{0, 1, 2}, {0.8, -2.0, 1.2}}, {{1, 2, 9}, {1.0, -2.0, 1.0}}}, 0.5);
  std::vector<Vec3> moves = {{0.3, -0.2, 0.1}, {0.1, 0.8, 0.2}, {0.0, 0.4, -0.5}};
  std::vector<Vec3> gradient(moves.size());
  for (const SecondDifference& difference : line.differences()) {
    const auto part = line.gradient(difference, moves);
    Vec3 by_axes;  // of the Hessian
    for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
      by_axes += line.stiffness() * dot(difference.of(moves), axis) * difference.gradient(axis)[0];
    expect_near(part[0], by_axes, 1e-12);
    for (std::size_t k = 0; k < 3; ++k) {
      if (difference.vertices[k] < moves.size()) gradient[difference.vertices[k]] += part[k];
    }
  }
  const auto value = [&] { return line.value(moves); };
  for (Index v = 0; v < moves.size(); ++v)
    expect_near(gradient[v], slope_of(value, v, moves), 1e-8);
}

TEST(Proximity, HasTheDerivativesOfDifferenceQuotients) {
  const Proximity proximity({1.0, 3.0});
  std::vector<Vec3> moves = {{0.3, -0.2, 0.1}, {0.1, 0.8, 0.2}};
  EXPECT_NEAR(Proximity({1.0, 1.0}).value({{0.5, 0, 0}, {0, 0, 0.5}}, 0.5), 1.0, 1e-15);
  const auto value = [&] { return proximity.value(moves, 0.4); };
  for (Index v = 0; v < moves.size(); ++v) {
    EXPECT_GT(proximity.stiffness(v, 0.4), 0.0);
    expect_near(proximity.stiffness(v, 0.4) * moves[v], slope_of(value, v, moves), 1e-8);
  }
}

}  // namespace
}  // namespace planish
