// Fairing with the border and its slant held.

#include <algorithm>
#include <cmath>

#include <planish/evolve/evolve.h>
#include <planish/evolve/evolver.h>
#include <planish/mesh/shapes.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "evolve/systems/fairing_system.h"
#include "geometry/cotangents.h"
#include "support/meshes.h"

namespace planish {
namespace {

using Eigen::MatrixXd;

std::vector<Vec3> places_of(const TriMesh& mesh, std::span<const Index> vertices) {
  std::vector<Vec3> positions;
  for (const Index v : vertices)
    positions.push_back(mesh.positions[v]);
  return positions;
}

bool is_next_to_border(const Connectivity& connectivity, Index v) {
  const auto ring = connectivity.ring(v);
  return std::any_of(ring.begin(), ring.end(), [&](Index w) { return connectivity.is_border(w); });
}

/// The positions after one sweep, by dense least squares over all vertices of the mesh.
MatrixXd dense_sweep(const TriMesh& mesh, double pull) {
  const Patch patch(mesh);
  const auto inner = patch.inner_vertices();
  const auto n = static_cast<Eigen::Index>(mesh.positions.size());
  const auto rows = static_cast<Eigen::Index>(inner.size());
  MatrixXd laplacian = MatrixXd::Zero(rows, n), positions(n, 3);
  double total = 0.0;
  for (Eigen::Index v = 0; v < n; ++v)
    positions.row(v) << mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z;
  for (const Index v : inner)
    total += mixed_area(mesh.positions[v], places_of(mesh, patch.ring(v)));
  for (Eigen::Index i = 0; i < rows; ++i) {
    const Index v = inner[i];
    const auto ring = patch.ring(v);
    const auto at = places_of(mesh, ring);
    const auto weights = cotangent_weights(mesh.positions[v], at);
    const double scale =
        std::sqrt(total / static_cast<double>(rows) / mixed_area(mesh.positions[v], at));
    for (std::size_t j = 0; j < ring.size(); ++j) {
      laplacian(i, v) += scale * weights[j];
      laplacian(i, ring[j]) -= scale * weights[j];
    }
  }
  std::vector<Index> movable;
  for (const Index v : inner) {
    if (!is_next_to_border(patch.connectivity(), v)) movable.push_back(v);
  }
  const auto count = static_cast<Eigen::Index>(movable.size());
  MatrixXd matrix = MatrixXd::Zero(rows + count, count);
  MatrixXd right = MatrixXd::Zero(rows + count, 3);
  right.topRows(rows) = -laplacian * positions;
  for (Eigen::Index i = 0; i < count; ++i) {
    matrix.col(i).head(rows) = laplacian.col(movable[i]);
    matrix(rows + i, i) = pull / static_cast<double>(rows);
  }
  const MatrixXd moves = matrix.colPivHouseholderQr().solve(right);
  for (Eigen::Index i = 0; i < count; ++i)
    positions.row(movable[i]) += moves.row(i);
  return positions;
}

TEST(BilaplacianFairing, TakesTheStepThatADenseSolveTakes) {
  const TriMesh mesh = make_shape("panel", 300);
  const double size = norm(mesh.positions.front() - mesh.positions.back());
  for (const double pull : {0.0, 10.0, 300.0}) {
    Evolver evolver(Patch(mesh), BilaplacianFairing{.pull = pull});
    evolver.step();
    const auto ours = evolver.positions();
    const MatrixXd expected = dense_sweep(mesh, pull);
    for (std::size_t v = 0; v < ours.size(); ++v) {
      const auto row = expected.row(static_cast<Eigen::Index>(v));
      ASSERT_LT(norm(ours[v] - Vec3{row[0], row[1], row[2]}), 1e-9 * size) << pull;
    }
  }
}

/// The cylinder sample with a few dents of several edges across.
TriMesh cylinder_with_five_dents(std::size_t vertices) {
  TriMesh mesh = make_shape("cylinder", vertices);
  const Patch patch(mesh);
  const auto inner = patch.inner_vertices();
  Vec3 middle;
  for (const Vec3 p : mesh.positions)
    middle += (1.0 / static_cast<double>(mesh.positions.size())) * p;
  std::vector<Vec3> dents;
  for (const std::size_t share : {3U, 5U, 8U, 11U, 14U})
    dents.push_back(mesh.positions[inner[inner.size() * share / 17]]);
  for (const Index v : inner) {
    if (is_next_to_border(patch.connectivity(), v)) continue;
    const Vec3 p = mesh.positions[v];
    for (const Vec3 dent : dents) {
      const double r = norm(p - dent) / 12.0;
      const Vec3 inwards = middle - dent;
      mesh.positions[v] += (8.0 * std::exp(-r * r) / norm(inwards)) * inwards;
    }
  }
  return mesh;
}

TEST(BilaplacianFairing, TakesDentsOutOfACylinder) {
  const TriMesh mesh = cylinder_with_five_dents(3000);
  const auto faired = evolve(Patch(mesh), BilaplacianFairing{}, {.max_sweeps = 1}).history.back();
  const auto controllable =
      evolve(Patch(mesh), ControllableLaplacian{}, {.max_sweeps = 10}).history.back();
  EXPECT_LT(faired.energy, controllable.energy / 20.0);
  EXPECT_LT(faired.e_max, controllable.e_max / 10.0);
}

TEST(BilaplacianFairing, LeavesAPlaneAndACylinderAlone) {
  TriMesh plane = meshes::rough_grid(20, 20, 5, 0.25, 0.0);
  Evolver evolver(Patch(plane), BilaplacianFairing{.pull = 0.0});
  evolver.step();
  const auto after = evolver.positions();
  for (std::size_t v = 0; v < after.size(); ++v)
    EXPECT_LT(norm(after[v] - plane.positions[v]), 1e-10);
  const TriMesh cylinder = make_shape("cylinder", 2000);
  const auto result = evolve(Patch(cylinder), BilaplacianFairing{}, {.max_sweeps = 10});
  EXPECT_EQ(result.positions, cylinder.positions);
  EXPECT_EQ(result.stop, StopReason::reached_target);
}

TEST(BilaplacianFairing, KeepsTheBorderAndTheRingNextToIt) {
  const TriMesh mesh = make_shape("saddle", 800);
  const Patch patch(mesh);
  const auto result = evolve(patch, BilaplacianFairing{}, {.max_sweeps = 3});
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const bool held = patch.is_border(v) || is_next_to_border(patch.connectivity(), v);
    EXPECT_EQ(result.positions[v] == mesh.positions[v], held) << v;
  }
}

TEST(BilaplacianFairing, GoesTheFurtherTheLessItPulls) {
  const TriMesh mesh = make_shape("dome", 1500);
  double last = 0.0;
  for (const double pull : {1e9, 1000.0, 100.0, 10.0, 0.0}) {
    const auto result = evolve(Patch(mesh), BilaplacianFairing{.pull = pull}, {.max_sweeps = 1});
    double furthest = 0.0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
      furthest = std::max(furthest, norm(result.positions[v] - mesh.positions[v]));
    EXPECT_GT(furthest, last);
    last = furthest;
  }
}

TEST(BilaplacianFairing, SaysWhereItConverges) {
  const auto result = evolve(Patch(make_shape("dome", 1500)), BilaplacianFairing{.pull = 1000.0},
                             {.max_sweeps = 40});
  EXPECT_EQ(result.stop, StopReason::converged);
}

TEST(BilaplacianFairing, HonoursFixedVerticesAndWeights) {
  const TriMesh mesh = make_shape("panel", 800);
  const Patch patch(mesh);
  std::vector<Index> free;
  for (const Index v : patch.inner_vertices()) {
    if (!is_next_to_border(patch.connectivity(), v)) free.push_back(v);
  }
  const Index heavy = free[free.size() / 2], fixed = free[free.size() / 3];
  Constraints constraints{.fixed = {fixed}};
  constraints.weights.assign(mesh.positions.size(), 1.0);
  const auto moved = [&](Index v) {
    const auto result =
        evolve(patch, BilaplacianFairing{}, {.max_sweeps = 2}, constraints, {.threads = 1});
    return norm(result.positions[v] - mesh.positions[v]);
  };
  const double unweighted = moved(heavy);
  constraints.weights[heavy] = 1e5;
  EXPECT_LT(moved(heavy), 1e-3 * unweighted);
  EXPECT_EQ(moved(fixed), 0.0);
}

}  // namespace
}  // namespace planish
