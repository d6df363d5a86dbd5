#include <algorithm>
#include <tuple>

#include <planish/evolve/evolve.h>
#include <planish/evolve/remesh.h>
#include <planish/mesh/connectivity.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/shapes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

/// The border's positions in order, from the least one on.
std::vector<Vec3> border_of(const TriMesh& mesh) {
  const Connectivity connectivity(mesh);
  std::vector<Vec3> positions;
  for (const Index v : connectivity.border_loops().front())
    positions.push_back(mesh.positions[v]);
  const auto least = std::min_element(positions.begin(), positions.end(), [](Vec3 a, Vec3 b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  std::rotate(positions.begin(), least, positions.end());
  return positions;
}

TEST(Remesh, TakesVerticesFromTheInsideOnly) {
  const TriMesh mesh = make_shape("panel", 20000);
  const RemeshedPatch patch = remesh(mesh);
  EXPECT_LE(patch.mesh.positions.size(), 6000U);
  EXPECT_GE(patch.mesh.positions.size(), 4000U);
  EXPECT_EQ(border_of(patch.mesh), border_of(mesh));
  EXPECT_FALSE(blocking_problem(inspect(patch.mesh), Purpose::unfold).has_value());
}

TEST(Remesh, KeepsWhatIsFixedAndTheWeightsOfWhatIsLeft) {
  const TriMesh mesh = make_shape("panel", 9000);
  const Connectivity connectivity(mesh);
  Constraints constraints;
  for (std::size_t i = 0; i < connectivity.inner_vertices().size(); i += 1000)
    constraints.fixed.push_back(connectivity.inner_vertices()[i]);
  for (const Vec3 p : mesh.positions)
    constraints.weights.push_back(1.0 + p.x * p.x);
  const RemeshedPatch patch = remesh(mesh, constraints);
  ASSERT_LT(patch.mesh.positions.size(), mesh.positions.size());
  ASSERT_EQ(patch.constraints.fixed.size(), constraints.fixed.size());
  for (std::size_t i = 0; i < constraints.fixed.size(); ++i) {
    EXPECT_EQ(patch.mesh.positions[patch.constraints.fixed[i]],
              mesh.positions[constraints.fixed[i]]);
  }
  ASSERT_EQ(patch.constraints.weights.size(), patch.mesh.positions.size());
  for (Index v = 0; v < patch.mesh.positions.size(); ++v) {
    const double x = patch.mesh.positions[v].x;
    EXPECT_EQ(patch.constraints.weights[v], 1.0 + x * x);
  }
}

TEST(Remesh, KeepsTheVerticesThatAreNamedAndTellsWhereAllComeFrom) {
  const TriMesh mesh = make_shape("panel", 9000);
  const Connectivity connectivity(mesh);
  std::vector<Index> keep;
  for (std::size_t i = 0; i < connectivity.inner_vertices().size(); i += 500)
    keep.push_back(connectivity.inner_vertices()[i]);
  const RemeshedPatch patch = remesh(mesh, {}, keep);
  ASSERT_LT(patch.mesh.positions.size(), mesh.positions.size());
  ASSERT_EQ(patch.source.size(), patch.mesh.positions.size());
  for (Index v = 0; v < patch.source.size(); ++v)
    EXPECT_EQ(patch.mesh.positions[v], mesh.positions[patch.source[v]]);
  EXPECT_THAT(patch.source, testing::IsSupersetOf(keep));
  EXPECT_TRUE(patch.constraints.fixed.empty());
  const std::vector<Index> beyond = {9'999'999};
  EXPECT_THROW(remesh(mesh, {}, beyond), Error);
}

TEST(Remesh, LeavesCoarsePatchesAsTheyAre) {
  const TriMesh coarse = make_shape("panel", 900);
  EXPECT_EQ(remesh(coarse).mesh.triangles, coarse.triangles);
  EXPECT_EQ(remesh(coarse).source.size(), coarse.positions.size());
  EXPECT_EQ(remesh(coarse, {.fixed = {7}}).constraints.fixed, std::vector<Index>{7});
}

}  // namespace
}  // namespace planish
