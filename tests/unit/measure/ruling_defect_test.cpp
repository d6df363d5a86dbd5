#include "measure/ruling_defect.h"

#include <numbers>

#include <planish/mesh/shapes.h>

#include <Eigen/Eigenvalues>
#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "support/bent_sheets.h"
#include "support/meshes.h"

namespace planish {
namespace {

double ruling_defect_of(const TriMesh& mesh) {
  return ruling_defect(Patch(mesh));
}

/// Vertex by vertex, with the eigenvalues of a library.
double plainly_measured(const TriMesh& mesh) {
  const plain::Patch patch(mesh);
  double least = 0.0, both = 0.0;
  for (Index v = 0; v < mesh.positions.size(); ++v) {
    if (!patch.inner[v]) continue;
    Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
    for (const Index t : patch.triangles_at[v]) {
      const Triangle& tri = mesh.triangles[t];
      const Vec3 a = mesh.positions[tri[0]];
      const Vec3 n = cross(mesh.positions[tri[1]] - a, mesh.positions[tri[2]] - a);
      const Eigen::Vector3d unit = Eigen::Vector3d(n.x, n.y, n.z).normalized();
      sum += patch.angle(t, v) * unit * unit.transpose();
    }
    const Eigen::Vector3d values =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d>(sum).eigenvalues();
    least += values[0];
    both += values[0] + values[1];
  }
  return least / both;
}

TEST(RulingDefect, AgreesWithAPlainSum) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const TriMesh mesh = meshes::rough_grid(9, 7, seed, 0.3, 0.1 * static_cast<double>(seed + 1));
    EXPECT_NEAR(ruling_defect_of(mesh), plainly_measured(mesh), 1e-12) << seed;
  }
}

TEST(RulingDefect, IsNothingWhereEdgesFollowRulings) {
  EXPECT_LT(ruling_defect_of(meshes::bent_cylinder(40, 0.5 * std::numbers::pi)), 1e-9);
  // Where they do not, triangles stand a little askew.
  EXPECT_LT(ruling_defect_of(meshes::bent_cylinder(40, 0.3)), 0.15);
  for (const char* name : {"cylinder", "cone", "tangent"})
    EXPECT_LT(ruling_defect_of(make_shape(name, 2000)), 1e-9) << name;
  EXPECT_EQ(ruling_defect_of(meshes::flat_grid(8, 5)), 0.0);
  EXPECT_EQ(ruling_defect_of({}), 0.0);
}

TEST(RulingDefect, IsLargeOnPanelsAtAnyDensity) {
  for (const std::size_t vertices : {1000U, 4000U, 16000U}) {
    EXPECT_GT(ruling_defect_of(make_shape("panel", vertices)), 0.2) << vertices;
    EXPECT_GT(ruling_defect_of(make_shape("dome", vertices)), 0.3) << vertices;
  }
  EXPECT_NEAR(ruling_defect_of(meshes::bent_sphere(40)), 0.5, 0.01);
}

TEST(RulingDefect, HardlyDependsOnTheDensityOfTheMesh) {
  const double fine = ruling_defect_of(meshes::crumpled_sheet(160));
  EXPECT_NEAR(ruling_defect_of(meshes::crumpled_sheet(40)) / fine, 1.0, 0.08);
  EXPECT_NEAR(ruling_defect_of(meshes::crumpled_sheet(80)) / fine, 1.0, 0.08);
}

TEST(RulingDefect, IsKnownAlsoWithNeedlesAndNoArea) {
  TriMesh mesh = meshes::rough_grid(6, 6, 1);
  mesh.positions[17] = mesh.positions[18];
  const double value = ruling_defect_of(mesh);
  EXPECT_GE(value, 0.0);
  EXPECT_LE(value, 0.5);
}

}  // namespace
}  // namespace planish
