// The flows of fairing.

#include <algorithm>
#include <cmath>

#include <planish/evolve/evolve.h>
#include <planish/evolve/evolver.h>
#include <planish/mesh/shapes.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "geometry/cotangents.h"
#include "support/meshes.h"

namespace planish {
namespace {

using Eigen::MatrixXd;

constexpr std::array k_flows = {FairingFlow::taubin, FairingFlow::implicit,
                                FairingFlow::anisotropic};

std::vector<Vec3> after_one_sweep(const TriMesh& mesh, const BilaplacianFairing& method) {
  Evolver evolver(Patch(mesh), method);
  evolver.step();
  return evolver.positions();
}

std::vector<Vec3> ring_positions(const TriMesh& mesh, std::span<const Index> ring) {
  std::vector<Vec3> positions;
  for (const Index v : ring)
    positions.push_back(mesh.positions[v]);
  return positions;
}

TEST(FairingFlow, KeepsAPlaneAPlane) {
  const TriMesh plane = meshes::rough_grid(12, 12, 5, 0.25, 0.0);
  for (const FairingFlow flow : k_flows) {
    const auto after = after_one_sweep(plane, {.flow = flow});
    for (std::size_t v = 0; v < after.size(); ++v) {
      EXPECT_NEAR(after[v].z, 0.0, 1e-12);
      // Cotangents take no vertex along the surface.
      if (flow != FairingFlow::taubin) {
        EXPECT_LT(norm(after[v] - plane.positions[v]), 1e-10);
      }
    }
  }
}

TEST(FairingFlow, KeepsTheBorder) {
  const TriMesh mesh = make_shape("saddle", 400);
  const Patch patch(mesh);
  for (const FairingFlow flow : k_flows) {
    const auto after = after_one_sweep(mesh, {.flow = flow});
    for (Index v = 0; v < after.size(); ++v)
      EXPECT_EQ(after[v] == mesh.positions[v], patch.is_border(v)) << v;
  }
}

/// (M + t K) v = M v0 with the border held, by a dense solve; K from cotangents.
MatrixXd dense_implicit_step(const TriMesh& mesh, double pull) {
  const Patch patch(mesh);
  const auto n = static_cast<Eigen::Index>(mesh.positions.size());
  MatrixXd system = MatrixXd::Identity(n, n), right(n, 3);
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    const Vec3 a = mesh.positions[t[0]];
    area += 0.5 * norm(cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a));
  }
  for (Eigen::Index v = 0; v < n; ++v)
    right.row(v) << mesh.positions[v].x, mesh.positions[v].y, mesh.positions[v].z;
  for (const Index v : patch.inner_vertices()) {
    const auto ring = patch.ring(v);
    const auto at = ring_positions(mesh, ring);
    const auto weights = cotangent_weights(mesh.positions[v], at);
    const double mass = pull / area * mixed_area(mesh.positions[v], at);
    system(v, v) = mass;
    right.row(v) *= mass;
    for (std::size_t j = 0; j < ring.size(); ++j) {
      system(v, v) += weights[j];
      system(v, ring[j]) -= weights[j];
    }
  }
  return system.partialPivLu().solve(right);
}

TEST(FairingFlow, ImplicitTakesTheStepThatADenseSolveTakes) {
  const TriMesh mesh = make_shape("panel", 300);
  const double size = norm(mesh.positions.front() - mesh.positions.back());
  for (const double pull : {0.0, 10.0, 1000.0}) {
    const auto ours = after_one_sweep(mesh, {.pull = pull, .flow = FairingFlow::implicit});
    const MatrixXd expected = dense_implicit_step(mesh, pull);
    for (std::size_t v = 0; v < ours.size(); ++v) {
      const auto row = expected.row(static_cast<Eigen::Index>(v));
      ASSERT_LT(norm(ours[v] - Vec3{row[0], row[1], row[2]}), 1e-9 * size) << pull;
    }
  }
}

TEST(FairingFlow, TaubinMultipliesAnEigenvectorByItsTransferFunction) {
  // Heights over a plane are filtered by themselves: with K = I - (means of the rings), an
  // eigenvector to k is multiplied by (1 - lambda k)(1 - mu k).
  const TriMesh plane = meshes::rough_grid(9, 8, 2, 0.2, 0.0);
  const Patch patch(plane);
  const auto inner = patch.inner_vertices();
  const auto n = static_cast<Eigen::Index>(inner.size());
  std::vector<Eigen::Index> number(plane.positions.size(), -1);
  for (Eigen::Index i = 0; i < n; ++i)
    number[inner[static_cast<std::size_t>(i)]] = i;
  MatrixXd k = MatrixXd::Identity(n, n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const auto ring = patch.ring(inner[static_cast<std::size_t>(i)]);
    for (const Index w : ring) {
      if (number[w] >= 0) k(i, number[w]) -= 1.0 / static_cast<double>(ring.size());
    }
  }
  const Eigen::EigenSolver<MatrixXd> eigen(k);
  const BilaplacianFairing method{.flow = FairingFlow::taubin, .lambda = 0.4, .mu = -0.5};
  for (const Eigen::Index e : {Eigen::Index{0}, n / 3, n - 1}) {
    const double value = eigen.eigenvalues()[e].real();
    TriMesh mesh = plane;
    for (Eigen::Index i = 0; i < n; ++i)
      mesh.positions[inner[static_cast<std::size_t>(i)]].z = eigen.eigenvectors()(i, e).real();
    const auto after = after_one_sweep(mesh, method);
    const double factor = (1.0 - method.lambda * value) * (1.0 - method.mu * value);
    for (const Index v : inner)
      ASSERT_NEAR(after[v].z, factor * mesh.positions[v].z, 1e-12) << value;
  }
}

constexpr std::size_t k_roof_cells = 20;

/// Two planes at a right angle along the middle column of a grid.
TriMesh roof() {
  TriMesh mesh = meshes::flat_grid(k_roof_cells, k_roof_cells);
  for (Vec3& p : mesh.positions)
    p.z = -std::abs(p.x - 0.5 * k_roof_cells);
  return mesh;
}

TEST(FairingFlow, AnisotropicKeepsACreaseWhereImplicitRoundsIt) {
  const TriMesh clean = roof();
  const Patch patch(clean);
  TriMesh mesh = clean;
  meshes::Random random(4);
  for (const Index v : patch.inner_vertices())
    mesh.positions[v].z += 0.1 * random.number();
  struct Errors {
    double at_crease = 0.0, elsewhere = 0.0;
  };
  const auto errors = [&](const std::vector<Vec3>& positions) {
    Errors sums;
    for (const Index v : patch.inner_vertices()) {
      const double to_crease = std::abs(clean.positions[v].x - 0.5 * k_roof_cells);
      const double error = std::abs(positions[v].z + std::abs(positions[v].x - 0.5 * k_roof_cells));
      if (to_crease < 0.5) sums.at_crease += error;
      if (to_crease > 2.5) sums.elsewhere += error;
    }
    return sums;
  };
  const auto after = [&](FairingFlow flow) {
    return errors(after_one_sweep(mesh, {.pull = 400.0, .flow = flow}));
  };
  const Errors before = errors(mesh.positions), round = after(FairingFlow::implicit);
  const Errors sharp = after(FairingFlow::anisotropic);
  EXPECT_LT(sharp.at_crease, 0.5 * round.at_crease);
  EXPECT_LT(sharp.elsewhere, 0.7 * before.elsewhere);
}

TEST(FairingFlow, AnisotropicIsImplicitWhereNothingIsACrease) {
  const TriMesh mesh = make_shape("dome", 300);
  const double size = norm(mesh.positions.front() - mesh.positions.back());
  const auto implicit = after_one_sweep(mesh, {.flow = FairingFlow::implicit});
  const auto at = [&](double crease) {
    const auto after = after_one_sweep(mesh, {.flow = FairingFlow::anisotropic, .crease = crease});
    double most = 0.0;
    for (std::size_t v = 0; v < after.size(); ++v)
      most = std::max(most, norm(after[v] - implicit[v]));
    return most / size;
  };
  EXPECT_LT(at(180.0), 1e-2 * at(1.0));
}

TEST(FairingFlow, HonoursFixedVerticesAndWeights) {
  const TriMesh mesh = make_shape("panel", 300);
  const Patch patch(mesh);
  const auto inner = patch.inner_vertices();
  const Index heavy = inner[inner.size() / 2], fixed = inner[inner.size() / 3];
  for (const FairingFlow flow : k_flows) {
    Constraints constraints{.fixed = {fixed}};
    constraints.weights.assign(mesh.positions.size(), 1.0);
    const auto moved = [&](Index v) {
      const auto result = evolve(patch, BilaplacianFairing{.flow = flow}, {.max_sweeps = 1},
                                 constraints, {.threads = 1});
      return norm(result.positions[v] - mesh.positions[v]);
    };
    const double unweighted = moved(heavy);
    constraints.weights[heavy] = 1e5;
    if (flow != FairingFlow::taubin) {
      EXPECT_LT(moved(heavy), 1e-3 * unweighted);
    }
    EXPECT_EQ(moved(fixed), 0.0);
  }
}

TEST(FairingFlow, GivesTheSameBitsOnAnyNumberOfThreads) {
  const TriMesh mesh = make_shape("panel", 3000);
  for (const FairingFlow flow : k_flows) {
    const auto on = [&](unsigned threads) {
      return evolve(Patch(mesh), BilaplacianFairing{.flow = flow}, {.max_sweeps = 2}, {},
                    {.threads = threads})
          .positions;
    };
    EXPECT_EQ(on(1), on(4));
  }
}

}  // namespace
}  // namespace planish
