#include "mesh/border_loops.h"

#include <numbers>
#include <vector>

#include <planish/mesh/patch.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

constexpr double pi = std::numbers::pi;

double turning_of(const Patch& patch, std::size_t loop) {
  return border_turning(patch.positions(), patch.connectivity(), patch.unit_scale(),
                        patch.border_loops()[loop]);
}

BorderKinds kinds_of(const Patch& patch) {
  return border_kinds(patch.positions(), patch.connectivity(), patch.unit_scale());
}

TriMesh without_middle_cells() {
  TriMesh plate = meshes::flat_grid(5, 5);
  plate.triangles.erase(plate.triangles.begin() + 24, plate.triangles.begin() + 26);
  return plate;
}

TEST(BorderLoops, AreEndsOfATube) {
  const Patch tube(meshes::tube(12, 3));
  EXPECT_NEAR(turning_of(tube, 0), 0.0, 1e-9);
  EXPECT_NEAR(turning_of(tube, 1), 0.0, 1e-9);
  EXPECT_EQ(kinds_of(tube).tube_ends.size(), 1U) << "the other one is the outline";
}

TEST(BorderLoops, AreAnOutlineAndHoles) {
  const Patch plate(without_middle_cells());
  ASSERT_EQ(plate.border_loops().size(), 2U);
  EXPECT_NEAR(turning_of(plate, 0), 2.0 * pi, 1e-9);
  EXPECT_NEAR(turning_of(plate, 1), -2.0 * pi, 1e-9);
  EXPECT_EQ(kinds_of(plate).outline, 0U);
  EXPECT_TRUE(kinds_of(plate).tube_ends.empty());
}

// Of a ball with one opening, that is the outline, though it turns as a hole does.
TEST(BorderLoops, AreAnOutlineWhereThereIsOneOnly) {
  TriMesh ball = solids::sphere(1.0, 8);
  std::erase_if(ball.triangles,
                [](const Triangle& t) { return t[0] == 0 || t[1] == 0 || t[2] == 0; });
  const Patch patch(ball);
  EXPECT_LT(turning_of(patch, 0), 0.0);
  EXPECT_EQ(kinds_of(patch).outline, 0U);
  EXPECT_TRUE(kinds_of(patch).tube_ends.empty());
}

TEST(BorderLoops, AreSlitsWhereTheyEncloseNothing) {
  const Patch plate(without_middle_cells());
  EXPECT_FALSE(is_slit(plate.positions(), 1.0, plate.border_loops()[1]));
  const std::vector<Vec3> line = {{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 0, 1e-9}};
  EXPECT_TRUE(is_slit(line, 1.0, std::vector<Index>{0, 1, 2, 3}));
}

}  // namespace
}  // namespace planish
