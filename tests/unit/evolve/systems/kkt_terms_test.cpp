// Terms of several vertices, with directions that are given or not.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include <planish/mesh/shapes.h>
#include <planish/mesh/symmetry.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "energy/hinge_bending.h"
#include "energy/shape_guard.h"
#include "energy/strain_potential.h"
#include "evolve/state/mirror_orbits_of.h"
#include "evolve/systems/kkt_system.h"
#include "support/meshes.h"

namespace planish {
namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double k_own = 0.7, k_c = 0.02, k_spring = 0.2;
constexpr KktSystem::Moves k_along_lines = {.inner = 1};

/// The same system as a dense matrix: unknowns are the coordinates of all vertices that are columns
/// of the Jacobian, then the multipliers.
struct Dense {
  MatrixXd matrix;
  Eigen::Index columns;

  Dense(const AngleJacobian& jacobian, const HingeBending& hinges, const ShapeGuard& guard,
        const SparseMatrix& square, const Positions& x)
      : columns(3 * static_cast<Eigen::Index>(jacobian.column_count())) {
    const auto rows = static_cast<Eigen::Index>(jacobian.row_count());
    matrix = MatrixXd::Zero(columns + rows, columns + rows);
    for (std::size_t h = 0; h < hinges.size(); ++h)
      add(hinges.stencil(h), 1.5, hinges.summand(h, x).gradient);
    for (std::size_t e = 0; e < guard.edge_count(); ++e) {
      add(guard.edge(e), 2.5, guard.edge_summand(e, x).gradient);
      for (const Vec3 axis : {Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}})
        add(guard.edge(e), k_spring, std::array{axis, -axis});
    }
    matrix.topLeftCorner(columns, columns).diagonal().array() += k_own;
    for (Index v = 0; v < jacobian.column_count(); ++v) {
      for (const AngleJacobian::Entry& entry : jacobian.column(v)) {
        const Vec3 g = jacobian.gradient(entry.entry);
        const Eigen::RowVector3d row(-g.x, -g.y, -g.z);
        const Eigen::Index r = columns + entry.row, c = 3 * static_cast<Eigen::Index>(v);
        matrix.block(r, c, 1, 3) = row;
        matrix.block(c, r, 3, 1) = row.transpose();
      }
    }
    matrix.bottomRightCorner(rows, rows) =
        -k_c * MatrixXd(MatrixXd(square).selfadjointView<Eigen::Lower>());
    for (Index v = 0; v < jacobian.column_count(); ++v) {
      if (!jacobian.is_movable(v)) hold(v);
    }
  }
  void hold(Index v) {
    for (Eigen::Index k = 3 * static_cast<Eigen::Index>(v), end = k + 3; k < end; ++k) {
      matrix.row(k).setZero();
      matrix.col(k).setZero();
      matrix(k, k) = 1.0;
    }
  }
  template <std::size_t n>
  void add(const std::array<Index, n>& corners, double scale, const std::array<Vec3, n>& gradient) {
    VectorXd all = VectorXd::Zero(matrix.rows());
    for (std::size_t k = 0; k < n; ++k) {
      const auto at = 3 * static_cast<Eigen::Index>(corners[k]);
      if (at < columns) all.segment<3>(at) << gradient[k].x, gradient[k].y, gradient[k].z;
    }
    matrix += scale * all * all.transpose();
  }
};

/// Of unit length, one for each inner vertex; symmetric where the orbits are.
Positions some_lines(const AngleJacobian& jacobian, const MirrorOrbits& orbits) {
  Positions lines;
  for (Index v = 0; v < jacobian.angle_count(); ++v) {
    const Vec3 n = {0.3, 0.1 * static_cast<double>(orbits.orbit_of(v) % 7) - 0.3, 1.0},
               carried = orbits.carried(v, n);
    lines.push_back((1.0 / norm(carried)) * carried);
  }
  return lines;
}

/// Turns of the same size at the vertices of an orbit.
VectorXd some_turns(const AngleJacobian& jacobian, const MirrorOrbits& orbits) {
  VectorXd turns(static_cast<Eigen::Index>(jacobian.row_count()));
  for (Eigen::Index row = 0; row < turns.size(); ++row)
    turns[row] =
        0.4 * orbits.orbit_of(static_cast<Index>(row)) / static_cast<double>(turns.size()) - 0.1;
  return turns;
}

/// From the coordinates of all vertices to the unknowns where inner vertices move along lines.
MatrixXd onto_lines(const AngleJacobian& jacobian, const Positions& lines, Eigen::Index size) {
  const auto inner = static_cast<Eigen::Index>(lines.size());
  MatrixXd onto = MatrixXd::Zero(size - 2 * inner, size);
  for (Eigen::Index v = 0; v < inner; ++v) {
    const Vec3 n = lines[static_cast<std::size_t>(v)];
    onto.block(v, 3 * v, 1, 3) << n.x, n.y, n.z;
  }
  const Eigen::Index rest = size - 3 * inner;
  onto.bottomRightCorner(rest, rest).setIdentity();
  EXPECT_EQ(static_cast<std::size_t>(rest),
            3 * jacobian.column_count() - 3 * lines.size() + jacobian.row_count());
  return onto;
}

/// @param border_movable by vertex of the border
void expect_solved_as_dense(const Constraints& constraints,
                            std::span<const unsigned char> border_movable,
                            KktSystem::Moves moves = {},
                            const TriMesh& mesh = make_shape("panel", 100)) {
  const Patch patch(mesh);
  ThreadPool pool(1);
  const Symmetry symmetry =
      constraints.symmetric_in ? symmetry_in(patch, *constraints.symmetric_in) : Symmetry{};
  const PatchState state(patch, pool, constraints, mirror_orbits_of(patch, symmetry, constraints));
  AngleJacobian jacobian = angle_jacobian_of(state, border_movable, hole_borders_of(state));
  jacobian.update(state.positions(), pool);
  const Positions x = first_positions(state, state.vertex_count());
  const HingeBending hinges(Patch(mesh_at_first(state)), x, 1.0);
  const ShapeGuard guard(state.triangles(), x, 0.05);
  const MirrorOrbits& orbits = state.orbits();
  ASSERT_EQ(orbits.is_symmetric(), constraints.symmetric_in.has_value());
  StrainPotential whole(jacobian, x, pool, BoundaryCondition::free);
  StrainPotential potential(jacobian, x, pool, BoundaryCondition::free, Precision::full, orbits);
  const auto for_pairs = [&](const BlockMatrix::VisitPair& visit) {
    for (std::size_t h = 0; h < hinges.size(); ++h) {
      const auto& corners = hinges.stencil(h);
      for (const auto& [i, j] : {std::pair{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}})
        visit(corners[static_cast<std::size_t>(i)], corners[static_cast<std::size_t>(j)]);
    }
  };
  KktSystem system(jacobian, state, for_pairs, potential.square(), moves, Precision::full, pool,
                   orbits);
  const Positions lines = moves.inner == 1 ? some_lines(jacobian, orbits) : Positions{};
  system.clear(lines);
  for (std::size_t h = 0; h < hinges.size(); ++h)
    system.add_term(hinges.stencil(h), 1.5, hinges.summand(h, x).gradient);
  std::vector<BlockMatrix::Pair> pairs;
  for (std::size_t e = 0; e < guard.edge_count(); ++e)
    system.append_pairs(guard.edge(e), pairs);
  for (std::size_t e = 0; e < guard.edge_count(); ++e) {
    const auto [v, w] = guard.edge(e);
    system.add_term(guard.edge(e), pairs.data() + e, 2.5, guard.edge_summand(e, x).gradient);
    system.add_scalar(v, v, BlockMatrix::k_none, k_spring, 1.0);
    system.add_scalar(w, w, BlockMatrix::k_none, k_spring, 1.0);
    system.add_scalar(v, w, pairs[e], k_spring, -1.0);
  }
  for (Index v = 0; v < jacobian.column_count(); ++v)
    system.add_vertex(v, {k_own, 0, 0, k_own, 0, k_own});
  ASSERT_TRUE(system.factor(potential.square(), k_c, pool));

  const Dense dense(jacobian, hinges, guard, whole.square(), x);
  Positions force(jacobian.column_count());
  VectorXd right = VectorXd::Zero(dense.matrix.rows());
  for (Index v = 0; v < force.size(); ++v) {
    if (!jacobian.is_movable(v)) continue;
    const auto k = static_cast<double>(orbits.orbit_of(v));
    force[v] = orbits.carried(v, {0.1 * k - 1.0, 2.0 - 0.03 * k, 0.5});
    right.segment<3>(3 * static_cast<Eigen::Index>(v)) << force[v].x, force[v].y, force[v].z;
  }
  const VectorXd turn = some_turns(jacobian, orbits);
  right.tail(turn.size()) = turn;
  const Positions step = system.solve(force, turn, pool, 1e-12);
  const MatrixXd onto = lines.empty() ? MatrixXd::Identity(right.size(), right.size())
                                      : onto_lines(jacobian, lines, right.size());
  const MatrixXd matrix = onto * dense.matrix * onto.transpose();
  const VectorXd expected = onto.transpose() * matrix.fullPivLu().solve(onto * right);
  for (Index v = 0; v < step.size(); ++v) {
    const auto at = 3 * static_cast<Eigen::Index>(v);
    EXPECT_NEAR(step[v].x, expected[at], 1e-10) << v;
    EXPECT_NEAR(step[v].y, expected[at + 1], 1e-10) << v;
    EXPECT_NEAR(step[v].z, expected[at + 2], 1e-10) << v;
  }
}

TEST(KktSystem, SolvesTermsAsTheDenseMatrixDoes) {
  expect_solved_as_dense({}, {});
}

TEST(KktSystem, HoldsWhatIsFixed) {
  const TriMesh mesh = make_shape("panel", 100);
  const Patch patch(mesh);
  std::vector<Index> inner;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (!patch.is_border(v)) inner.push_back(v);
  }
  expect_solved_as_dense({.fixed = {inner[3], inner[20]}}, {});
  expect_solved_as_dense({.fixed = {inner[3], inner[20]}}, {}, k_along_lines);
}

TEST(KktSystem, MovesTheBorderWhereItMay) {
  const TriMesh mesh = make_shape("panel", 100);
  const Patch patch(mesh);
  std::vector<unsigned char> movable;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (patch.is_border(v)) movable.push_back(movable.size() % 3 != 0 ? 1 : 0);
  }
  expect_solved_as_dense({}, movable);
  expect_solved_as_dense({}, movable, k_along_lines);
}

TEST(KktSystem, MovesInnerVerticesAlongLinesWhereAskedTo) {
  expect_solved_as_dense({}, {}, k_along_lines);
}

TEST(KktSystem, FindsTheSymmetricMovesOfTheWholeFromHalf) {
  for (const Vec3 normal : {Vec3{1.0, 0.0, 0.0}, Vec3{0.9, 0.2, -0.1}}) {
    const TriMesh hill = meshes::height_field(
        6, 6, [](double x, double y) { return 0.1 * x * (6.0 - x) + 0.02 * y * y; });
    const Plane plane{normal, dot(normal, Vec3{3.0, 3.0, 0.5})};
    const SymmetricMesh made = symmetric_mesh(Patch(hill), plane, MirrorSide::above);
    const Patch patch(made.mesh);
    std::vector<unsigned char> movable;
    for (const auto& loop : patch.border_loops()) {
      for (const Index v : loop)
        movable.push_back(std::min(v, made.image[v]) % 3 != 0 ? 1 : 0);
    }
    const Index inner = patch.inner_vertices()[4];
    ASSERT_NE(inner, made.image[inner]);
    for (const KktSystem::Moves moves : {KktSystem::Moves{}, k_along_lines}) {
      expect_solved_as_dense({.symmetric_in = plane}, {}, moves, made.mesh);
      expect_solved_as_dense({.fixed = {inner, made.image[inner]}, .symmetric_in = plane}, movable,
                             moves, made.mesh);
    }
  }
}

TEST(KktSystem, HasThreeRowsForEachHole) {
  const TriMesh mesh =
      meshes::perforated(14, 8, meshes::blocks(14, 8, 2, 1, 2), [](double x, double y) {
        return Vec3{x, y, std::sin(0.4 * x) * std::cos(0.5 * y)};
      });
  const Patch patch(mesh);
  ASSERT_EQ(patch.border_loops().size(), 3U);
  std::vector<unsigned char> movable;
  for (const auto& loop : patch.border_loops())
    movable.insert(movable.end(), loop.size(), 1);
  for (const KktSystem::Moves moves : {KktSystem::Moves{}, k_along_lines}) {
    expect_solved_as_dense({}, {}, moves, mesh);
    expect_solved_as_dense({}, movable, moves, mesh);
  }
}

}  // namespace
}  // namespace planish
