#include "measure/smoothed.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include <planish/core/error.h>
#include <planish/measure/fairness.h>

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/meshes.h"

namespace planish {
namespace {

std::vector<Vec3> smoothed(const TriMesh& mesh, std::optional<double> wave = {}) {
  return smoothed_positions(Patch(mesh), wave);
}

double mean_edge(const TriMesh& mesh) {
  const Patch patch(mesh);
  double edges = 0.0, length = 0.0;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    for (const Index w : patch.ring(v)) {
      if (w < v) continue;
      edges += 1.0;
      length += norm(mesh.positions[w] - mesh.positions[v]);
    }
  }
  return length / edges;
}

/// The same by a dense matrix: all rows of L from the triangles, those of the border left out.
std::vector<Vec3> plainly_smoothed(const TriMesh& mesh, std::optional<double> wave) {
  const Patch patch(mesh);
  const auto n = static_cast<Eigen::Index>(mesh.positions.size());
  Eigen::MatrixXd laplacian = Eigen::MatrixXd::Zero(n, n), x0(n, 3);
  Eigen::VectorXd mass = Eigen::VectorXd::Zero(n);
  for (const Triangle& t : mesh.triangles) {
    for (int k = 0; k < 3; ++k) {
      const Index a = t[k], b = t[(k + 1) % 3], c = t[(k + 2) % 3];
      const Vec3 p = mesh.positions[a], u = mesh.positions[b] - p, v = mesh.positions[c] - p;
      const double doubled = norm(cross(u, v)), weight = 0.5 * dot(u, v) / doubled;
      mass[a] += doubled / 6.0;
      laplacian(b, b) += weight;
      laplacian(c, c) += weight;
      laplacian(b, c) -= weight;
      laplacian(c, b) -= weight;
    }
  }
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 p = mesh.positions[v];
    x0.row(v) << p.x, p.y, p.z;
  }
  const double halved = wave.value_or(2.0 * mean_edge(mesh));
  const double t = std::pow(halved / (2.0 * std::numbers::pi), 4.0);
  for (Index v = 0; v < n; ++v) {
    if (!patch.is_inner(v)) laplacian.row(v).setZero();
  }
  Eigen::MatrixXd system = t * laplacian.transpose() * mass.cwiseInverse().asDiagonal() * laplacian;
  system.diagonal() += mass;
  Eigen::MatrixXd right = mass.asDiagonal() * x0;
  for (Index v = 0; v < n; ++v) {
    if (patch.is_inner(v)) continue;
    system.row(v).setZero();
    system(v, v) = 1.0;
    right.row(v) = x0.row(v);
  }
  const Eigen::MatrixXd x = system.partialPivLu().solve(right);
  std::vector<Vec3> result;
  for (Index v = 0; v < n; ++v)
    result.push_back({x(v, 0), x(v, 1), x(v, 2)});
  return result;
}

TEST(Smoothed, SolvesTheSystem) {
  for (const TriMesh& mesh : {meshes::rough_grid(12, 9, 5), meshes::rough_grid(9, 9, 6, 0.45, 0.6),
                              meshes::tube(9, 6), meshes::bent_sphere(10)}) {
    const double edge = mean_edge(mesh);
    for (const std::optional<double> wave : {std::optional<double>(), {0.5 * edge}, {7.0 * edge}}) {
      const std::vector<Vec3> found = smoothed(mesh, wave), expected = plainly_smoothed(mesh, wave);
      double farthest = 0.0;
      for (Index v = 0; v < found.size(); ++v)
        farthest = std::max(farthest, norm(expected[v] - mesh.positions[v]));
      EXPECT_GT(farthest, 0.0);
      for (Index v = 0; v < found.size(); ++v)
        ASSERT_LT(norm(found[v] - expected[v]), 1e-4 * farthest) << v;
    }
  }
}

TEST(Smoothed, HalvesTheWaveThatIsNamed) {
  constexpr double wave = 10.0, height = 0.05;
  TriMesh mesh = meshes::flat_grid(60, 60);
  for (Vec3& p : mesh.positions)
    p.z = height * std::cos(2.0 * std::numbers::pi * (p.x - 30.0) / wave);
  const std::size_t centre = 30 * 61 + 30;
  ASSERT_NEAR(mesh.positions[centre].z, height, 1e-12);
  EXPECT_NEAR(smoothed(mesh, wave)[centre].z / height, 0.5, 0.02);
  EXPECT_NEAR(smoothed(mesh, 0.5 * wave)[centre].z / height, 16.0 / 17.0, 0.01);
  EXPECT_EQ(smoothed(mesh, 0.0), mesh.positions);
}

TEST(Smoothed, RefusesWavesBeyondTwentyEdges) {
  const TriMesh mesh = meshes::flat_grid(9, 6);
  const double edge = mean_edge(mesh);
  EXPECT_NO_THROW(smoothed(mesh, 19.9 * edge));
  for (const double wave : {20.1 * edge, -1.0, std::nan("")}) {
    try {
      smoothed(mesh, wave);
      ADD_FAILURE() << wave;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::option_out_of_range);
    }
  }
}

TEST(Smoothed, LeavesTheBorderAndPlanes) {
  const TriMesh mesh = meshes::rough_grid(8, 8, 3);
  const Patch patch(mesh);
  const std::vector<Vec3> positions = smoothed_positions(patch);
  for (Index v = 0; v < positions.size(); ++v) {
    if (!patch.is_border(v)) continue;
    EXPECT_EQ(positions[v], mesh.positions[v]);
  }
  const TriMesh flat = meshes::flat_grid(9, 6);
  EXPECT_EQ(design_bending(Patch(flat)), 0.0);
  for (const Vec3 p : smoothed(flat))
    EXPECT_EQ(p.z, 0.0);
}

TEST(Smoothed, KeepsTheBendingOfAFormAndLosesThatOfNoise) {
  TriMesh mesh = meshes::bent_cylinder(60);
  const Patch patch(mesh);
  const double form = measure_bending(patch).bending;
  EXPECT_NEAR(design_bending(patch) / form, 1.0, 0.01);
  meshes::Random random(1);
  for (const Index v : patch.inner_vertices())
    mesh.positions[v] += 0.001 * Vec3{random.number(), random.number(), random.number()};
  const Patch rough(mesh);
  const double noisy = measure_bending(rough).bending;
  EXPECT_GT(noisy, 3.0 * form);
  EXPECT_LT(design_bending(rough), 0.7 * noisy);
}

TEST(Smoothed, GivesPlacesAlsoWhereTrianglesHaveNoArea) {
  TriMesh mesh = meshes::rough_grid(6, 6, 2);
  mesh.positions[17] = mesh.positions[18];
  mesh.positions[24] = 0.5 * (mesh.positions[23] + mesh.positions[25]);
  for (const Vec3 p : smoothed(mesh))
    EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
  EXPECT_EQ(smoothed({}).size(), 0U);
}

}  // namespace
}  // namespace planish
