#include <numbers>

#include <planish/measure/fairness.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "evolve/smooth/hinge_terms.h"
#include "evolve/smooth/shape_guard.h"
#include "evolve/systems/positions.h"

namespace planish {
namespace {

struct Prepared {
  explicit Prepared(TriMesh of) : mesh(std::move(of)) {}

  TriMesh mesh;
  Patch surface{mesh};
  ThreadPool pool{1};
  PatchState state{surface, pool};
};

/// The difference quotient of a function by the place of a vertex.
template <class Function>
Vec3 slope_of(const Function& function, Index v, PatchState& state) {
  constexpr double h = 1e-6;
  const Vec3 at = state.position(v);
  const auto along = [&](Vec3 step) {
    state.move(v, at + step);
    const double after = function();
    state.move(v, at - step);
    const double before = function();
    state.move(v, at);
    return (after - before) / (2.0 * h);
  };
  return {along({h, 0, 0}), along({0, h, 0}), along({0, 0, h})};
}

void expect_near(Vec3 a, Vec3 b, double most) {
  EXPECT_NEAR(a.x, b.x, most);
  EXPECT_NEAR(a.y, b.y, most);
  EXPECT_NEAR(a.z, b.z, most);
}

TEST(HingeTerms, HaveTheBendingOfTheMesh) {
  for (const char* name : {"panel", "saddle", "cylinder"}) {
    Prepared patch(make_shape(name, 300));
    HingeTerms hinges(Patch(mesh_at_first(patch.state)), patch.state);
    hinges.take_weights(patch.pool);
    EXPECT_NEAR(hinges.bending(patch.pool), measure_bending(patch.surface).bending, 1e-9) << name;
  }
}

TEST(HingeTerms, SlopesAreDifferenceQuotients) {
  Prepared patch(make_shape("panel", 100));
  const HingeTerms hinges(Patch(mesh_at_first(patch.state)), patch.state);
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    const HingeTerms::Slope slope = hinges.slope(h);
    EXPECT_NE(slope.angle, 0.0);
    for (std::size_t k = 0; k < 4; ++k) {
      const auto angle = [&] { return hinges.slope(h).angle; };
      expect_near(slope.gradient[k], slope_of(angle, hinges.corners(h)[k], patch.state), 1e-6);
    }
  }
}

TEST(HingeTerms, CountBendingFromAShareOfTheFirstAngles) {
  Prepared patch(make_shape("panel", 100));
  HingeTerms hinges(Patch(mesh_at_first(patch.state)), patch.state);
  hinges.take_weights(patch.pool);
  EXPECT_EQ(hinges.bending(patch.pool, 1.0), 0.0);
  EXPECT_NEAR(hinges.bending(patch.pool, 0.75), 0.0625 * hinges.bending(patch.pool), 1e-12);

  constexpr Index moved = 7;
  constexpr double kept = 0.6;
  patch.state.move(moved, patch.state.position(moved) + Vec3{0.01, -0.02, 0.03});
  Vec3 slope;
  for (std::size_t h = 0; h < hinges.size(); ++h) {
    const auto now = hinges.slope(h);
    const double turned = now.angle - kept * hinges.first_angle(h);
    for (std::size_t k = 0; k < 4; ++k) {
      if (hinges.corners(h)[k] == moved) slope += 2.0 * hinges.weight(h) * turned * now.gradient[k];
    }
  }
  const auto bending = [&] { return hinges.bending(patch.pool, kept); };
  expect_near(slope, slope_of(bending, moved, patch.state), 1e-5 * norm(slope));
}

TEST(HingeTerms, AreZeroWhereATriangleHasNoArea) {
  Prepared patch({{{0, 0, 0}, {1, 0, 0}, {0.5, 1, 0}, {0.5, 0, 0}}, {{0, 1, 2}, {1, 0, 3}}});
  HingeTerms hinges(Patch(mesh_at_first(patch.state)), patch.state);
  ASSERT_EQ(hinges.size(), 1U);
  hinges.take_weights(patch.pool);
  EXPECT_EQ(hinges.bending(patch.pool), 0.0);
  EXPECT_EQ(hinges.slope(0).gradient[0], (Vec3{}));
}

/// Pushes a vertex nearly onto another, so that corners are sharp.
void squeeze(PatchState& state) {
  const Vec3 at = state.position(5), to = state.position(6);
  state.move(5, at + 0.93 * (to - at));
}

TEST(ShapeGuard, IsNothingForTheDesign) {
  Prepared patch(make_shape("panel", 100));
  const ShapeGuard guard(patch.state, 0.05);
  EXPECT_LT(guard.value(patch.pool), 1e-25);
  for (std::size_t c = 0; c < guard.corner_count(); ++c)
    EXPECT_EQ(guard.corner_slope(c).second, 0.0);
}

TEST(ShapeGuard, CountsStrainByArea) {
  Prepared patch(make_shape("panel", 100));
  const ShapeGuard guard(patch.state, 0.05);
  // All edges are 3 % longer.
  for (std::size_t v = 0; v < patch.state.vertex_count(); ++v)
    patch.state.move(v, 1.03 * patch.state.position(v));
  const double s = 0.03 / 0.15;
  EXPECT_NEAR(guard.value(patch.pool), s * s * s * s + 0.02 * s * s, 1e-12);
}

TEST(ShapeGuard, SlopesAreDifferenceQuotients) {
  Prepared patch(make_shape("panel", 100));
  const ShapeGuard guard(patch.state, 0.05);
  squeeze(patch.state);
  const auto value = [&] { return guard.value(patch.pool); };
  std::size_t sharp = 0;
  std::vector<Vec3> slopes(patch.state.vertex_count());
  for (std::size_t e = 0; e < guard.edge_count(); ++e) {
    const auto slope = guard.edge_slope(e);
    for (std::size_t k = 0; k < 2; ++k)
      slopes[guard.edge(e)[k]] += slope.first * slope.gradient[k];
  }
  for (std::size_t c = 0; c < guard.corner_count(); ++c) {
    const auto slope = guard.corner_slope(c);
    sharp += slope.second > 0.0 ? 1 : 0;
    for (std::size_t k = 0; k < 3; ++k)
      slopes[guard.corner(c)[k]] += slope.first * slope.gradient[k];
  }
  EXPECT_GT(sharp, 0U);
  for (Index v = 0; v < patch.state.vertex_count(); ++v)
    expect_near(slopes[v], slope_of(value, v, patch.state), 1e-6 * (1.0 + norm(slopes[v])));
}

}  // namespace
}  // namespace planish
