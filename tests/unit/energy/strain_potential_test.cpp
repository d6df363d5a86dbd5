#include "energy/strain_potential.h"

#include <cmath>
#include <numbers>

#include <planish/mesh/shapes.h>
#include <planish/mesh/symmetry.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "evolve/systems/dense.h"
#include "evolve/systems/positions.h"
#include "support/moves.h"
#include "unit/energy/strain_gradient.h"

namespace planish {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

struct Laid {
  explicit Laid(const TriMesh& mesh)
      : surface(mesh), state(surface, pool), jacobian(angle_jacobian_of(state)) {
    jacobian.update(state.positions(), pool);
  }
  Eigen::Index count() const { return static_cast<Eigen::Index>(state.inner_count()); }
  StrainPotential potential(BoundaryCondition border) {
    return {jacobian, all_positions(state), pool, border, potential_precision(state.inner_count())};
  }
  /// As the patch is now.
  VectorXd defects() {
    state.measure(pool);
    return inner_defects(state);
  }

  Patch surface;
  ThreadPool pool{1};
  PatchState state;
  AngleJacobian jacobian;
};

TEST(StrainPotential, IsThatOfTheWholeWhereHalfIsSolvedFor) {
  const Plane plane{{0.9, 0.2, -0.1}, 3.0};
  const SymmetricMesh made =
      symmetric_mesh(Patch(make_shape("panel", 300)), plane, MirrorSide::above);
  Laid laid(made.mesh);
  const PatchState state(laid.surface, laid.pool, {},
                         mirror_orbits(made.mesh, symmetry_in(laid.surface, plane)));
  const MirrorOrbits& orbits = state.orbits();
  ASSERT_TRUE(orbits.is_symmetric());
  const VectorXd d = laid.defects();
  for (const BoundaryCondition border : {BoundaryCondition::free, BoundaryCondition::dirichlet}) {
    StrainPotential whole(laid.jacobian, all_positions(state), laid.pool, border),
        half(laid.jacobian, all_positions(state), laid.pool, border, Precision::full, orbits);
    EXPECT_LT(2 * half.square().cols(), laid.count() + 40);
    const VectorXd expected = whole.of(d, laid.pool);
    EXPECT_LT((half.of(d, laid.pool) - expected).norm(), 1e-9 * expected.norm());
    half.update(all_positions(state), laid.pool);
    EXPECT_LT((half.of(d, laid.pool) - expected).norm(), 1e-9 * expected.norm());
  }
}

TEST(StrainPotential, HasTheGradientOfDifferenceQuotients) {
  Laid laid(make_shape("panel", 200));
  StrainPotential potential = laid.potential(BoundaryCondition::free);
  expect_gradient_of_strain(laid, potential);
}

TEST(StrainPotential, IsTheConformalStretchOfACap) {
  // The stereographic picture of a cap of 70 degrees, its border at true length, stretches by
  // (1 + cos t) / (1 + cos 70) at the angle t from the pole.
  const TriMesh mesh = make_shape("dome", 4000);
  Laid laid(mesh);
  laid.state.measure(laid.pool);
  StrainPotential potential = laid.potential(BoundaryCondition::dirichlet);
  ASSERT_TRUE(potential.solvable());
  const VectorXd d = inner_defects(laid.state), phi = potential.of(d, laid.pool);
  EXPECT_LT((potential.stiffness() * phi - d).norm(), 1e-12 * d.norm());
  const double pole = std::log(2.0 / (1.0 + std::cos(70.0 * std::numbers::pi / 180.0)));
  EXPECT_NEAR(phi.maxCoeff(), pole, 0.01 * pole);
  EXPECT_GT(phi.minCoeff(), 0.0);
}

TEST(StrainPotential, IsTheSmallestOneWhereTheBorderIsFree) {
  const TriMesh mesh = make_shape("panel", 200);
  Laid laid(mesh);
  laid.state.measure(laid.pool);
  const VectorXd d = inner_defects(laid.state);
  StrainPotential held = laid.potential(BoundaryCondition::dirichlet);
  StrainPotential free = laid.potential(BoundaryCondition::free);
  const VectorXd phi = free.of(d, laid.pool);
  ASSERT_EQ(phi.size(), static_cast<Eigen::Index>(laid.state.vertex_count()));
  // Of all that have these defects, by a dense decomposition.
  const MatrixXd k = MatrixXd(free.stiffness()).transpose();
  const VectorXd least = k.completeOrthogonalDecomposition().solve(d);
  EXPECT_LT((phi - least).norm(), 1e-9 * least.norm());
  VectorXd with_zeros = VectorXd::Zero(phi.size());
  with_zeros.head(laid.count()) = held.of(d, laid.pool);
  EXPECT_LT((k * with_zeros - d).norm(), 1e-10 * d.norm());
  EXPECT_LT(phi.norm(), 0.95 * with_zeros.norm());
  const double by_square = d.dot(MatrixXd(free.square()).ldlt().solve(d));
  EXPECT_NEAR(by_square, phi.squaredNorm(), 1e-9 * by_square);
}

TEST(StrainPotential, ComesFromFreeToHeldAsTheBorderGetsStiff) {
  const TriMesh mesh = make_shape("panel", 200);
  Laid laid(mesh);
  laid.state.measure(laid.pool);
  const VectorXd d = inner_defects(laid.state);
  StrainPotential held = laid.potential(BoundaryCondition::dirichlet);
  StrainPotential free = laid.potential(BoundaryCondition::free);
  const double most = held.of(d, laid.pool).norm();
  double last = free.of(d, laid.pool).norm();
  for (const double ease : {0.3, 0.01, 1e-4}) {
    free.set_boundary_compliance(ease);
    free.update(all_positions(laid.state), laid.pool);
    const double now = free.of(d, laid.pool).norm();
    EXPECT_GT(now, last) << ease;
    EXPECT_LT(now, most) << ease;
    last = now;
  }
  EXPECT_NEAR(last, most, 0.01 * most);
  free.set_boundary_compliance(1.0);
  free.update(all_positions(laid.state), laid.pool);
  StrainPotential anew = laid.potential(BoundaryCondition::free);
  EXPECT_LT((free.of(d, laid.pool) - anew.of(d, laid.pool)).norm(), 1e-12 * most);
}

TEST(StrainPotential, TellsTheStrainOfThePatternWhereTheBorderIsFree) {
  for (const char* shape : {"panel", "saddle"}) {
    const TriMesh mesh = make_shape(shape, 3000);
    Laid laid(mesh);
    laid.state.measure(laid.pool);
    StrainPotential potential = laid.potential(BoundaryCondition::free);
    const VectorXd phi = potential.of(inner_defects(laid.state), laid.pool);
    const double told = edge_strain_of(phi.norm() / std::sqrt(static_cast<double>(phi.size())));
    const Pattern pattern = unfold(laid.surface, {.least_stretch = true});
    const double strain = edge_strain(laid.surface, pattern.positions).rms;
    EXPECT_NEAR(told, strain, 0.05 * strain) << shape;
  }
}

TEST(StrainPotential, TakesTheSurfaceAsItIsWhenUpdated) {
  for (const BoundaryCondition border : {BoundaryCondition::dirichlet, BoundaryCondition::free}) {
    const TriMesh mesh = make_shape("panel", 200);
    Laid laid(mesh);
    StrainPotential potential = laid.potential(border);
    const MatrixXd before(potential.square());
    const Positions moves = some_moves(laid.state.inner_count(), 0.2 * laid.state.scale());
    set_positions(sum_of(inner_positions(laid.state), 1.0, moves), laid.jacobian, laid.state);
    laid.state.measure(laid.pool);
    potential.update(all_positions(laid.state), laid.pool);
    ASSERT_TRUE(potential.solvable());
    StrainPotential anew = laid.potential(border);
    EXPECT_GT((MatrixXd(potential.square()) - before).norm(), 1e-6 * before.norm());
    EXPECT_LT(MatrixXd(potential.square() - anew.square()).norm(), 1e-12 * before.norm());
    const VectorXd d = inner_defects(laid.state), expected = anew.of(d, laid.pool);
    EXPECT_LT((potential.of(d, laid.pool) - expected).norm(), 1e-12 * expected.norm());
  }
}

TEST(StrainPotential, IsTheSameWithAFactorThatWasFreedAndMadeAgain) {
  for (const std::size_t vertices : {200, 12'000}) {  // in double and in float
    const TriMesh mesh = make_shape("saddle", vertices);
    Laid laid(mesh);
    laid.state.measure(laid.pool);
    StrainPotential potential = laid.potential(BoundaryCondition::free);
    const VectorXd d = inner_defects(laid.state), before = potential.of(d, laid.pool);
    potential.release();
    potential.factor(laid.pool);
    ASSERT_TRUE(potential.solvable());
    EXPECT_EQ(potential.of(d, laid.pool), before) << vertices;
  }
}

}  // namespace
}  // namespace planish
