#include "evolve/auto/near/strain_descent.h"

#include <algorithm>
#include <cmath>

#include <planish/mesh/shapes.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "evolve/auto/near/deviation_reduction.h"
#include "evolve/auto/shared/smallest_angle.h"
#include "evolve/systems/positions.h"
#include "support/meshes.h"
#include "support/moves.h"

namespace planish {
namespace {

using namespace tuning::prefer_near;

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Laid {
  explicit Laid(const TriMesh& m, const Constraints& constraints = {})
      : mesh(m),
        surface(mesh),
        state(surface, pool, constraints),
        jacobian(angle_jacobian_of(state)) {
    jacobian.update(state.positions(), pool);
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(state.inner_count()); }

  TriMesh mesh;
  Patch surface;
  ThreadPool pool{1};
  PatchState state;
  AngleJacobian jacobian;
};

/// Of the vertices that may move.
Positions moves_where_free(const Laid& laid, double size) {
  Positions moves = some_moves(laid.state.inner_count(), size);
  for (Index v = 0; v < moves.size(); ++v) {
    if (!laid.jacobian.is_movable(v)) moves[v] = {};
  }
  return moves;
}

Constraints one_held(const TriMesh& mesh) {
  return {.fixed = {Patch(mesh).inner_vertices()[20]}};
}

TEST(FairnessEnergy, HasTheGradientAndTheHessianOfItsValue) {
  const TriMesh mesh = make_shape("panel", 200);
  Laid laid(mesh, one_held(mesh));
  FairnessEnergy cost(laid.jacobian, laid.state, 0.05);
  cost.scale_proximity(std::vector<Index>{3, 7}, 5.0);
  const double h = cost.unit();
  const Positions x = sum_of(inner_positions(laid.state), 1.0, moves_where_free(laid, 0.3 * h));
  const Positions u = moves_where_free(laid, 1.0 * h);
  // Quadratic: central differences are exact but for rounding. The gradient is per unit length.
  const double slope = 0.5 * (cost.value(sum_of(x, 1.0, u)) - cost.value(sum_of(x, -1.0, u)));
  EXPECT_NEAR(product(cost.gradient(x), u) / h, slope, 1e-10 * std::abs(slope));
  const Positions bend =
      sum_of(cost.gradient(sum_of(x, 0.5, u)), -1.0, cost.gradient(sum_of(x, -0.5, u)));
  for (const auto part : {&Vec3::x, &Vec3::y, &Vec3::z}) {
    VectorXd along(laid.count()), expected(laid.count());
    for (Eigen::Index v = 0; v < laid.count(); ++v) {
      along[v] = u[static_cast<std::size_t>(v)].*part / h;
      expected[v] = bend[static_cast<std::size_t>(v)].*part;
    }
    EXPECT_LT((cost.hessian().selfadjointView<Eigen::Lower>() * along - expected).norm(),
              1e-10 * expected.norm());
  }
}

TEST(FairnessEnergy, SpreadsMovesAsADenseSolverDoes) {
  const TriMesh mesh = make_shape("panel", 200);
  Laid laid(mesh, one_held(mesh));
  const FairnessEnergy cost(laid.jacobian, laid.state, 0.0);
  std::vector<unsigned char> given(laid.state.inner_count(), 0);
  for (std::size_t v = 0; v < given.size(); v += 5)
    given[v] = laid.jacobian.is_movable(static_cast<Index>(v)) ? 1 : 0;
  const Positions moves = moves_where_free(laid, 1.0);
  const Positions spread = cost.spread(given, moves, laid.pool);
  MatrixXd dense(cost.hessian());
  VectorXd right = VectorXd::Zero(laid.count()), found(laid.count());
  for (Eigen::Index v = 0; v < laid.count(); ++v) {
    const auto i = static_cast<std::size_t>(v);
    const bool held = !laid.jacobian.is_movable(static_cast<Index>(v));
    dense(v, v) += given[i] != 0 || held ? 1.0 : 0.0;
    right[v] = given[i] != 0 ? moves[i].y : 0.0;
    found[v] = spread[i].y;
    if (held) {
      EXPECT_EQ(spread[i], Vec3{});
    }
  }
  const VectorXd expected = dense.ldlt().solve(right);
  EXPECT_LT((found - expected).norm(), 1e-5 * expected.norm());
}

TEST(TangentialRelaxation, MendsWhatHasBecomePoorAndNothingElse) {
  const TriMesh mesh = meshes::height_field(20, 20, [](double, double) { return 0.0; });
  Laid laid(mesh);
  TangentialRelaxation relaxation(laid.jacobian, laid.state);
  EXPECT_EQ(relaxation.relax(), 0U);
  const Index v = 100, w = laid.jacobian.ring(v)[0];
  const Vec3 from = laid.state.position(v), to = laid.state.position(w);
  laid.state.move(v, from + 0.98 * (to - from));
  const double needle = smallest_angle(laid.state, laid.state.triangles(), laid.pool);
  for (int pass = 0; pass < 5; ++pass)
    relaxation.relax();
  EXPECT_LT(needle, 0.05);
  EXPECT_GT(smallest_angle(laid.state, laid.state.triangles(), laid.pool), 0.2);
  for (Index i = 0; i < laid.state.inner_count(); ++i) {
    EXPECT_EQ(laid.state.position(i).z, laid.state.origin(i).z);
    const auto ring = laid.jacobian.ring(v);
    const bool near = i == v || std::find(ring.begin(), ring.end(), i) != ring.end();
    if (!near) {
      EXPECT_EQ(laid.state.position(i), laid.state.origin(i)) << i;
    }
  }
}

TEST(StrainDescent, LowersItsMeritInEveryStepUntilThePatchIsNearlyFlattenable) {
  for (const char* shape : {"panel", "saddle"}) {
    const TriMesh mesh = make_shape(shape, 900);
    Laid laid(mesh);
    StrainDescent descent(laid.state, laid.pool, {}, {});
    descent.start(k_cold_start);
    const double before = descent.rms_strain();
    for (int i = 0; i < 60 && descent.rms_strain() > 1e-4; ++i) {
      const StrainDescent::Step step = descent.step();
      if (step.moved > 0) {
        EXPECT_LT(step.merit, step.merit_before) << shape << i;
      }
    }
    EXPECT_LT(descent.rms_strain(), 1e-4) << shape;
    EXPECT_GT(before, 1e-2) << shape;
  }
}

TEST(StrainDescent, OnlyLowersAClosenessThatACoarserLevelFound) {
  for (const double found : {0.0, 0.1, 4.0}) {  // none: with the usual one, which may grow
    Laid laid(make_shape("panel", 900));
    StrainDescent descent(laid.state, laid.pool, {.closeness = found}, {});
    descent.start(k_cold_start);
    double most = descent.closeness();
    for (int i = 0; i < 40; ++i) {
      descent.step();
      most = std::max(most, descent.closeness());
    }
    if (found > 0.0)
      EXPECT_EQ(most, found);
    else
      EXPECT_GT(most, k_usual_closeness.first);
  }
}

TEST(DeviationReduction, EndsNearerWithinTheLimitOfStrain) {
  for (const char* shape : {"panel", "saddle"}) {
    Laid laid(make_shape(shape, 900));
    constexpr double limit = 0.04;
    StrainDescent descent(laid.state, laid.pool, {.strain = {.max = limit}}, {});
    descent.start(k_cold_start);
    for (int i = 0; i < 60 && !descent.strain_is_met(); ++i)
      descent.step();
    ASSERT_TRUE(descent.strain_is_met()) << shape;
    const double deviation = descent.deviation(), strain = descent.max_strain();
    DeviationReduction deviation_reduction(descent);
    int steps = 0;
    for (; !deviation_reduction.over(); ++steps) {
      const StrainDescent::Step step = deviation_reduction.step();
      if (step.moved > 0) {
        EXPECT_LT(step.merit, step.merit_before) << shape;
      }
    }
    deviation_reduction.finish();
    EXPECT_GE(steps, 5) << shape;
    EXPECT_LT(descent.deviation(), 0.99 * deviation) << shape;
    EXPECT_LE(descent.max_strain(), limit) << shape;
    EXPECT_GT(descent.max_strain(), strain) << shape;
  }
}

TEST(StrainDescent, KeepsItsLimitsAndWhatIsHeld) {
  const TriMesh mesh = make_shape("dome", 900);
  const Constraints constraints = one_held(mesh);
  Laid laid(mesh, constraints);
  const double angle = 0.9 * smallest_angle(laid.state, laid.state.triangles(), laid.pool);
  const double far = 10.0 * laid.state.scale();  // millimetres
  StrainDescent descent(laid.state, laid.pool, {}, {far, angle});
  descent.start(k_cold_start);
  for (int i = 0; i < 15; ++i) {
    descent.step();
    EXPECT_GE(smallest_angle(laid.state, laid.state.triangles(), laid.pool), angle);
    for (Index v = 0; v < laid.state.inner_count(); ++v) {
      const double away = norm(laid.state.position(v) - laid.state.origin(v));
      EXPECT_LE(away, far * (1.0 + 1e-12));
      if (laid.state.is_fixed(v)) {
        EXPECT_EQ(away, 0.0);
      }
    }
  }
  EXPECT_TRUE(descent.at_deviation_limit());
}

}  // namespace
}  // namespace planish
