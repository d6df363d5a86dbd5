// Borders that may move: where their vertices may go, and what the systems make of them.

#include <algorithm>
#include <cmath>
#include <limits>

#include <planish/evolve/evolve.h>
#include <planish/evolve/evolver.h>
#include <planish/measure/deviation.h>
#include <planish/mesh/shapes.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "energy/strain_potential.h"
#include "evolve/auto/shared/border_motion.h"
#include "evolve/auto/shared/fairness_energy.h"
#include "evolve/systems/kkt_system.h"
#include "evolve/systems/positions.h"
#include "support/moves.h"

namespace planish {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr BorderFreedom k_slide{BorderFreedom::Rule::slide};

BorderFreedom within(double distance) {
  return {BorderFreedom::Rule::within, distance};
}

/// A patch with a border that may move, distances in the units of the state.
struct Laid {
  Laid(TriMesh m, const BorderFreedom& freedom, const Constraints& constraints = {},
       double most_deviation = std::numeric_limits<double>::infinity())
      : mesh(std::move(m)),
        surface(mesh),
        state(surface, pool, constraints),
        border(freedom, most_deviation, state),
        jacobian(angle_jacobian_of(state, border.movable())) {
    jacobian.update(state.positions(), pool);
  }

  std::size_t count() const { return border.vertex_count(); }
  Index first_border() const { return static_cast<Index>(state.inner_count()); }

  TriMesh mesh;
  Patch surface;
  ThreadPool pool{1};
  PatchState state;
  BorderMotion border;
  AngleJacobian jacobian;
};

/// How far along a closed polygon the point nearest to p is, and how far p is from it.
struct OnPolygon {
  double along = 0.0, away = 0.0;
};
OnPolygon on_polygon(const std::vector<Vec3>& polygon, Vec3 p) {
  OnPolygon best{0.0, 1e300};
  double walked = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec3 a = polygon[i], d = polygon[(i + 1) % polygon.size()] - a;
    const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
    const double away = norm(p - (a + t * d));
    if (away < best.away) best = {walked + t * norm(d), away};
    walked += norm(d);
  }
  return best;
}

std::vector<Vec3> border_of(const TriMesh& mesh, const std::vector<Vec3>& positions) {
  const Patch patch(mesh);
  std::vector<Vec3> border;
  for (const Index v : patch.border_loops().front())
    border.push_back(positions[v]);
  return border;
}

TEST(BorderMotion, LeavesABorderThatIsFixedAlone) {
  for (const BorderFreedom& freedom : {BorderFreedom{}, within(0.0)}) {
    const Laid laid(make_shape("panel", 200), freedom);
    EXPECT_EQ(laid.count(), laid.state.inner_count());
    EXPECT_EQ(laid.border.direction_count(), 0);
    EXPECT_TRUE(laid.border.movable().empty());
    EXPECT_TRUE(laid.border.bends().empty());
  }
}

TEST(BorderMotion, SlidesAlongTheBorderInItsOrder) {
  for (const char* shape : {"dome", "panel", "cylinder"}) {
    const Laid laid(make_shape(shape, 600), k_slide);
    std::vector<Vec3> origins;
    for (Index v = laid.first_border(); v < laid.count(); ++v)
      origins.push_back(laid.state.origin(v));
    const double edge = norm(origins[1] - origins[0]);
    for (const double size : {0.2, 1.0, 5.0}) {
      Positions positions = sum_of(first_positions(laid.state, laid.count()), 1.0,
                                   some_moves(laid.count(), size * edge));
      laid.border.restrict(positions);
      double before = -1.0;
      int elsewhere = 0;
      for (std::size_t i = 0; i < origins.size(); ++i) {
        const Vec3 place = positions[laid.first_border() + i];
        const OnPolygon on = on_polygon(origins, place);
        EXPECT_LT(on.away, 1e-12) << shape;
        // The first of a round border may have slid to before the end of the loop.
        if (i > 1) {
          EXPECT_GT(on.along, before) << shape << " " << i;
        }
        if (i > 0) before = on.along;
        elsewhere += place != origins[i] ? 1 : 0;
      }
      EXPECT_GT(elsewhere, static_cast<int>(origins.size() / 3)) << shape;
    }
  }
}

TEST(BorderMotion, GoesToTheNearestPlaceOfTheBorder) {
  const Laid laid(make_shape("dome", 600), k_slide);
  const Index v = laid.first_border() + 7;
  const Vec3 from = laid.state.origin(v), next = laid.state.origin(v + 1);
  Positions positions = first_positions(laid.state, laid.count());
  const Vec3 target = from + 0.3 * (next - from);
  positions[v] = target + 0.01 * cross(next - from, {0.0, 0.0, 1.0});
  laid.border.restrict(positions);
  EXPECT_LT(norm(positions[v] - target), 1e-12);
  const Vec3 along = laid.border.direction(v, 0);
  EXPECT_NEAR(norm(along), 1.0, 1e-14);
  EXPECT_GT(dot(along, next - from), 0.99 * norm(next - from));
}

TEST(BorderMotion, KeepsCornersAndFixedVerticesWhereBordersSlide) {
  const TriMesh mesh = make_shape("panel", 600);
  const Index held = Patch(mesh).border_loops().front()[5];
  const Laid laid(mesh, k_slide, {.fixed = {held}});
  int corners = 0;
  for (Index v = laid.first_border(); v < laid.count(); ++v) {
    const bool is_held = laid.state.vertex_of(v) == held;
    if (is_held) {
      EXPECT_FALSE(laid.jacobian.is_movable(v));
    }
    corners += !is_held && !laid.jacobian.is_movable(v) ? 1 : 0;
  }
  EXPECT_EQ(corners, 4);
  const Laid round(make_shape("dome", 600), k_slide);
  for (Index v = round.first_border(); v < round.count(); ++v)
    EXPECT_TRUE(round.jacobian.is_movable(v));
}

TEST(BorderMotion, KeepsTheDistance) {
  const Laid laid(make_shape("panel", 300), within(0.01));
  const Positions before = first_positions(laid.state, laid.count());
  Positions positions = sum_of(before, 1.0, some_moves(laid.count(), 0.012));
  const Positions asked = positions;
  laid.border.restrict(positions);
  int stopped = 0;
  for (Index v = 0; v < laid.count(); ++v) {
    const double wish = norm(asked[v] - before[v]), far = norm(positions[v] - before[v]);
    const bool stops = !laid.state.is_inner(v) && wish > 0.01;
    EXPECT_NEAR(far, stops ? 0.01 : wish, 1e-15);
    EXPECT_LT(norm(cross(positions[v] - before[v], asked[v] - before[v])), 1e-15);
    stopped += stops ? 1 : 0;
  }
  EXPECT_GT(stopped, 10);
}

TEST(BorderMotion, KeepsTheLimitOfDeviationToo) {
  constexpr double most = 0.004;
  for (const BorderFreedom& freedom : {k_slide, within(0.01)}) {
    const Laid laid(make_shape("dome", 300), freedom, {}, most);
    Positions positions =
        sum_of(first_positions(laid.state, laid.count()), 1.0, some_moves(laid.count(), 0.02));
    laid.border.restrict(positions);
    double furthest = 0.0;
    for (Index v = laid.first_border(); v < laid.count(); ++v)
      furthest = std::max(furthest, norm(positions[v] - laid.state.origin(v)));
    EXPECT_LE(furthest, most * (1.0 + 1e-12));
    EXPECT_GT(furthest, 0.5 * most);
  }
}

TEST(BorderMotion, KeepsAFifthOfTheWayBetweenVerticesThatSlide) {
  const Laid laid(make_shape("dome", 600), k_slide);
  const Index first = laid.first_border();
  const auto count = static_cast<Index>(laid.count() - first);
  Positions positions = first_positions(laid.state, laid.count());
  // All of them to one place: who can come near it does.
  for (Index v = first; v < laid.count(); ++v)
    positions[v] = laid.state.origin(first + count / 2);
  laid.border.restrict(positions);
  double nearest = 1.0;
  for (Index i = 0; i < count; ++i) {
    const Index v = first + i, next = first + (i + 1) % count;
    const double before = norm(laid.state.origin(next) - laid.state.origin(v));
    nearest = std::min(nearest, norm(positions[next] - positions[v]) / before);
  }
  EXPECT_GE(nearest, 0.199);  // chords are shorter than the way
  EXPECT_LT(nearest, 0.7);
}

TEST(BorderMotion, BendsNotWhereMovesGoEvenlyAlongTheBorder) {
  const Laid laid(make_shape("dome", 300), within(1.0));
  const auto bends = laid.border.bends();
  EXPECT_EQ(bends.size(), laid.count() - laid.state.inner_count());
  for (const auto& [vertices, weights] : bends) {
    const double back = norm(laid.state.origin(vertices[1]) - laid.state.origin(vertices[0]));
    const double ahead = norm(laid.state.origin(vertices[2]) - laid.state.origin(vertices[1]));
    EXPECT_NEAR(weights[0] + weights[1] + weights[2], 0.0, 1e-15);
    EXPECT_NEAR(-back * weights[0] + ahead * weights[2], 0.0, 1e-15);
    EXPECT_EQ(weights[1], 2.0);
  }
}

TEST(AngleJacobian, IsTheDerivativeWhereBordersMove) {
  Laid laid(make_shape("panel", 150), within(1.0));
  const Positions x = first_positions(laid.state, laid.count());
  const Positions u = some_moves(laid.count(), 1.0);
  const auto angle_sums_at = [&](double t) {
    set_positions(sum_of(x, t, u), laid.jacobian, laid.state);
    laid.state.measure(laid.pool);
    return VectorXd(-inner_defects(laid.state));
  };
  constexpr double h = 1e-6;
  const VectorXd difference = (angle_sums_at(h) - angle_sums_at(-h)) / (2.0 * h);
  const VectorXd product = laid.jacobian.times(u);
  EXPECT_LT((product - difference).norm(), 1e-6 * difference.norm());
  const VectorXd y = VectorXd::LinSpaced(product.size(), -1.0, 2.0);
  EXPECT_NEAR(planish::product(laid.jacobian.transposed_times(y, laid.pool), u), y.dot(product),
              1e-10 * y.norm() * product.norm());
}

TEST(FairnessEnergy, HasTheGradientAndTheHessianOfItsValueWhereBordersMove) {
  const Laid laid(make_shape("panel", 200), within(1.0));
  FairnessEnergy cost(laid.jacobian, laid.state, 0.05, laid.border.bends());
  const double h = cost.unit();
  const Positions x = sum_of(cost.origin(), 1.0, some_moves(laid.count(), 0.3 * h));
  const Positions u = some_moves(laid.count(), h);
  const double slope = 0.5 * (cost.value(sum_of(x, 1.0, u)) - cost.value(sum_of(x, -1.0, u)));
  EXPECT_NEAR(product(cost.gradient(x), u) / h, slope, 1e-10 * std::abs(slope));
  const Positions bend =
      sum_of(cost.gradient(sum_of(x, 0.5, u)), -1.0, cost.gradient(sum_of(x, -0.5, u)));
  const auto n = static_cast<Eigen::Index>(laid.count());
  VectorXd along(n), expected(n);
  for (Eigen::Index v = 0; v < n; ++v) {
    along[v] = u[static_cast<std::size_t>(v)].y / h;
    expected[v] = bend[static_cast<std::size_t>(v)].y;
  }
  EXPECT_LT((cost.hessian().selfadjointView<Eigen::Lower>() * along - expected).norm(),
            1e-10 * expected.norm());
}

TEST(KktSystem, SolvesAlongDirectionsAsTheDenseMatrixDoesWhereBordersMove) {
  for (const BorderFreedom& freedom : {k_slide, within(1.0)}) {
    Laid laid(make_shape("panel", 120), freedom);
    const FairnessEnergy cost(laid.jacobian, laid.state, 0.1, laid.border.bends());
    StrainPotential potential(laid.jacobian, all_positions(laid.state), laid.pool,
                              BoundaryCondition::dirichlet);
    const SparseMatrix &square = potential.square(), &hessian = cost.hessian();
    const int each = laid.border.direction_count();
    const auto for_entries = [&](const auto& visit) {
      for (int j = 0; j < hessian.outerSize(); ++j) {
        for (SparseMatrix::InnerIterator entry(hessian, j); entry; ++entry)
          visit(static_cast<Index>(entry.row()), static_cast<Index>(j), entry.value());
      }
    };
    const auto for_pairs = [&](const BlockMatrix::VisitPair& visit) {
      for_entries([&](Index v, Index w, double) { visit(v, w); });
    };
    KktSystem system(laid.jacobian, laid.state, for_pairs, square, {.inner = 1, .border = each},
                     Precision::full, laid.pool);
    std::vector<Vec3> directions, given;
    std::vector<Index> owner;
    for (Index v = 0; v < laid.count(); ++v) {
      const bool inner = laid.state.is_inner(v);
      for (int k = 0; k < (inner ? 1 : each); ++k) {
        directions.push_back(inner ? normal_at(v, laid.jacobian, laid.state)
                                   : laid.border.direction(v, k));
        owner.push_back(v);
        if (inner || each == 1) given.push_back(directions.back());
      }
    }
    const auto m = static_cast<Eigen::Index>(owner.size());
    const auto n = static_cast<Eigen::Index>(laid.state.inner_count());
    constexpr double unit = 0.3, stiffness = 2.5, c = 0.04;
    const Positions force = some_moves(laid.count(), 1.0);
    MatrixXd whole = MatrixXd::Zero(m + n, m + n);
    VectorXd right(m + n);
    const MatrixXd h = MatrixXd(hessian).selfadjointView<Eigen::Lower>();
    for (Eigen::Index a = 0; a < m; ++a) {
      const bool moves = laid.jacobian.is_movable(owner[a]);
      right[a] = moves ? dot(force[owner[a]], directions[a]) : 0.0;
      for (Eigen::Index b = 0; b < m; ++b)
        whole(a, b) =
            stiffness * h(owner[a], owner[b]) * (a == b ? 1.0 : dot(directions[a], directions[b]));
      for (const AngleJacobian::Entry& entry : laid.jacobian.column(owner[a])) {
        whole(m + entry.row, a) = whole(a, m + entry.row) =
            -unit * dot(laid.jacobian.gradient(entry.entry), directions[a]);
      }
    }
    whole.bottomRightCorner(n, n) = -c * MatrixXd(MatrixXd(square).selfadjointView<Eigen::Lower>());
    const VectorXd turn = VectorXd::LinSpaced(n, 0.1, -0.2);
    right.tail(n) = turn;
    system.clear(given, unit);
    for_entries([&](Index v, Index w, double value) {
      std::vector<BlockMatrix::Pair> pair;
      system.append_pairs(std::array{v, w}, pair);
      system.add_scalar(v, w, pair.front(), stiffness, value);
    });
    ASSERT_TRUE(system.factor(square, c, laid.pool));
    const VectorXd along = whole.fullPivLu().solve(right).head(m);
    Positions expected(laid.count());
    for (Eigen::Index a = 0; a < m; ++a)
      expected[owner[a]] += (unit * along[a]) * directions[a];
    const Positions step = system.solve(force, turn, laid.pool, 1e-12);
    EXPECT_LT(norm_of(sum_of(step, -1.0, expected)), 1e-9 * norm_of(expected));
  }
}

EvolveResult run_with(const TriMesh& mesh, const BorderFreedom& border, unsigned threads = 0,
                      const Constraints& constraints = {}) {
  const Auto method{.prefer = Prefer::near, .border = border};
  return evolve(Patch(mesh), method, usual_stopping(method), constraints, {.threads = threads});
}

Deviation deviation_of(const TriMesh& mesh, const EvolveResult& result) {
  return measure_deviation(Patch(mesh), result.positions);
}

/// The largest way that a vertex of the border went.
double border_moved(const TriMesh& mesh, const EvolveResult& result) {
  const Patch patch(mesh);
  double most = 0.0;
  for (const auto& loop : patch.border_loops()) {
    for (const Index v : loop)
      most = std::max(most, norm(result.positions[v] - mesh.positions[v]));
  }
  return most;
}

TEST(Auto, EndsNearerTheFurtherTheBorderMayGo) {
  const TriMesh mesh = make_shape("dome", 600);
  double nearest = deviation_of(mesh, run_with(mesh, {})).rms;
  for (const double distance : {2.0, 10.0, 40.0}) {
    const EvolveResult result = run_with(mesh, within(distance));
    EXPECT_EQ(result.stop, StopReason::converged) << distance;
    EXPECT_LE(border_moved(mesh, result), distance * (1.0 + 1e-12));
    EXPECT_GT(border_moved(mesh, result), 0.25 * distance);
    const double deviation = deviation_of(mesh, result).rms;
    EXPECT_LT(deviation, nearest) << distance;
    nearest = deviation;
  }
}

TEST(Auto, SlidesTheBorderOnItself) {
  const TriMesh mesh = make_shape("dome", 800);
  const EvolveResult result = run_with(mesh, k_slide);
  EXPECT_EQ(result.stop, StopReason::converged);
  EXPECT_GT(border_moved(mesh, result), 0.0);
  const std::vector<Vec3> before = border_of(mesh, mesh.positions);
  for (const Vec3 p : border_of(mesh, result.positions))
    EXPECT_LT(on_polygon(before, p).away, 1e-9 * bounding_box_diagonal(mesh));
}

TEST(Auto, MovesBordersOnAllLevelsWithTheSameBitsOnAnyNumberOfThreads) {
  const TriMesh mesh = make_shape("panel", 6500);
  const Index held = Patch(mesh).border_loops().front()[40];
  const std::vector<Vec3> before = border_of(mesh, mesh.positions);
  for (const BorderFreedom& freedom : {k_slide, within(3.0)}) {
    const EvolveResult result = run_with(mesh, freedom, 1, {.fixed = {held}});
    EXPECT_EQ(result.stop, StopReason::converged);
    EXPECT_EQ(result.positions, run_with(mesh, freedom, 3, {.fixed = {held}}).positions);
    EXPECT_EQ(result.positions[held], mesh.positions[held]);
    EXPECT_GT(border_moved(mesh, result), 0.0);
    if (freedom == k_slide) {
      for (const Vec3 p : border_of(mesh, result.positions))
        EXPECT_LT(on_polygon(before, p).away, 1e-9 * bounding_box_diagonal(mesh));
    } else {
      EXPECT_LE(border_moved(mesh, result), 3.0 * (1.0 + 1e-12));
    }
  }
}

TEST(Auto, KeepsJaggedBordersOnTheirCurveOnAllLevels) {
  TriMesh mesh = make_shape("panel", 6500);
  const Patch patch(mesh);
  // Every third vertex of the border is a corner now, though hardly any is one on coarser levels.
  const auto& loop = patch.border_loops().front();
  for (std::size_t i = 0; i < loop.size(); i += 3)
    mesh.positions[loop[i]].z += 1.5;
  const std::vector<Vec3> before = border_of(mesh, mesh.positions);
  const EvolveResult result = run_with(mesh, k_slide);
  EXPECT_GT(border_moved(mesh, result), 0.0);
  for (const Vec3 p : border_of(mesh, result.positions))
    EXPECT_LT(on_polygon(before, p).away, 1e-9 * bounding_box_diagonal(mesh));
}

TEST(Auto, KeepsBordersWhereTheyMayBeWhenEndedOnACoarseLevel) {
  const TriMesh mesh = make_shape("panel", 6500);
  const std::vector<Vec3> before = border_of(mesh, mesh.positions);
  for (const auto& [freedom, prefer] :
       {std::pair{k_slide, Prefer::near}, std::pair{within(3.0), Prefer::near},
        std::pair{k_slide, Prefer::smooth}, std::pair{within(3.0), Prefer::smooth}}) {
    const Auto method{.max_deviation = 2.0, .prefer = prefer, .border = freedom};
    const EvolveResult result = evolve(Patch(mesh), method, {.max_sweeps = 4});
    EXPECT_EQ(result.stop, StopReason::sweep_limit);
    EXPECT_GT(border_moved(mesh, result), 0.0);
    EXPECT_LE(border_moved(mesh, result), 2.0 * (1.0 + 1e-12));
    for (const Vec3 p : border_of(mesh, result.positions)) {
      if (freedom == k_slide) {
        EXPECT_LT(on_polygon(before, p).away, 1e-9 * bounding_box_diagonal(mesh));
      }
    }
  }
}

TEST(Evolver, GoesOnAfterItSettledOnTheWayBack) {
  const TriMesh mesh = make_shape("panel", 6500);
  Evolver evolver(Patch(mesh), Auto{.limits = {.max = 0.004}, .prefer = Prefer::near});
  for (int i = 0; i < 12; ++i)
    evolver.step();
  evolver.prolong_to_finest();
  evolver.prolong_to_finest();
  evolver.step();
  for (const Vec3 p : evolver.positions())
    EXPECT_TRUE(std::isfinite(dot(p, p)));
}

}  // namespace
}  // namespace planish
