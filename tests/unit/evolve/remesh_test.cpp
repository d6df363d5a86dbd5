#include <algorithm>
#include <tuple>

#include <planish/evolve/evolve.h>
#include <planish/evolve/remesh.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/shapes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

/// The border's positions in order, from the least one on.
std::vector<Vec3> border_of(const TriMesh& mesh) {
  const Patch surface(mesh);
  std::vector<Vec3> positions;
  for (const Index v : surface.border_loops().front())
    positions.push_back(mesh.positions[v]);
  const auto least = std::min_element(positions.begin(), positions.end(), [](Vec3 a, Vec3 b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
  });
  std::rotate(positions.begin(), least, positions.end());
  return positions;
}

TEST(Remesh, TakesVerticesFromTheInsideOnly) {
  const TriMesh mesh = make_shape("panel", 20000);
  const RemeshedPatch left = remesh(Patch(mesh));
  EXPECT_LE(left.patch.positions().size(), 6000U);
  EXPECT_GE(left.patch.positions().size(), 4000U);
  EXPECT_EQ(border_of(left.patch.mesh()), border_of(mesh));
  EXPECT_FALSE(blocking_problem(left.patch.inspection(), Purpose::unfold).has_value());
}

TEST(Remesh, LeavesAboutAsManyVerticesAsItSays) {
  for (const std::size_t vertices : {1000U, 9000U, 20000U}) {
    const Patch surface(make_shape("panel", vertices));
    const auto said = static_cast<double>(vertices_of_remeshed(surface));
    EXPECT_NEAR(static_cast<double>(remesh(surface).patch.vertex_count()), said, 0.2 * said)
        << vertices;
  }
}

TEST(Remesh, KeepsWhatIsFixedAndTheWeightsOfWhatIsLeft) {
  const TriMesh mesh = make_shape("panel", 9000);
  const Patch surface(mesh);
  Constraints constraints;
  for (std::size_t i = 0; i < surface.inner_vertices().size(); i += 1000)
    constraints.fixed.push_back(surface.inner_vertices()[i]);
  for (const Vec3 p : mesh.positions)
    constraints.weights.push_back(1.0 + p.x * p.x);
  const RemeshedPatch left = remesh(surface, constraints);
  ASSERT_LT(left.patch.positions().size(), mesh.positions.size());
  ASSERT_EQ(left.constraints.fixed.size(), constraints.fixed.size());
  for (std::size_t i = 0; i < constraints.fixed.size(); ++i) {
    EXPECT_EQ(left.patch.positions()[left.constraints.fixed[i]],
              mesh.positions[constraints.fixed[i]]);
  }
  ASSERT_EQ(left.constraints.weights.size(), left.patch.positions().size());
  for (Index v = 0; v < left.patch.positions().size(); ++v) {
    const double x = left.patch.positions()[v].x;
    EXPECT_EQ(left.constraints.weights[v], 1.0 + x * x);
  }
}

TEST(Remesh, KeepsTheVerticesThatAreNamedAndTellsWhereAllComeFrom) {
  const TriMesh mesh = make_shape("panel", 9000);
  const Patch surface(mesh);
  std::vector<Index> keep;
  for (std::size_t i = 0; i < surface.inner_vertices().size(); i += 500)
    keep.push_back(surface.inner_vertices()[i]);
  const RemeshedPatch left = remesh(surface, {}, keep);
  ASSERT_LT(left.patch.positions().size(), mesh.positions.size());
  ASSERT_EQ(left.source.size(), left.patch.positions().size());
  for (Index v = 0; v < left.source.size(); ++v)
    EXPECT_EQ(left.patch.positions()[v], mesh.positions[left.source[v]]);
  EXPECT_THAT(left.source, testing::IsSupersetOf(keep));
  EXPECT_TRUE(left.constraints.fixed.empty());
  const std::vector<Index> beyond = {9'999'999};
  EXPECT_THROW(remesh(surface, {}, beyond), Error);
}

TEST(Remesh, LeavesCoarsePatchesAsTheyAre) {
  const TriMesh coarse = make_shape("panel", 900);
  EXPECT_EQ(remesh(Patch(coarse)).patch.triangles(), coarse.triangles);
  EXPECT_EQ(remesh(Patch(coarse)).source.size(), coarse.positions.size());
  EXPECT_EQ(remesh(Patch(coarse), {.fixed = {7}}).constraints.fixed, std::vector<Index>{7});
}

}  // namespace
}  // namespace planish
