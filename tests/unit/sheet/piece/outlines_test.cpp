#include "sheet/piece/outlines.h"

#include <algorithm>
#include <set>
#include <utility>

#include <planish/mesh/patch.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

// Cells, two triangles each, of a grid of unit cells whose sum of column and row is even.
bool is_black(std::size_t triangle, std::size_t columns) {
  const std::size_t cell = triangle / 2;
  return (cell % columns + cell / columns) % 2 == 0;
}

double doubled_area(const TriMesh& mesh, const std::vector<Index>& loop) {
  double sum = 0.0;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec3 p = mesh.positions[loop[i]], q = mesh.positions[loop[(i + 1) % loop.size()]];
    sum += cross(Vec2{p.x, p.y}, Vec2{q.x, q.y});
  }
  return sum;
}

TEST(Outlines, OfTheWholeAreTheBorderLoops) {
  const TriMesh mesh = meshes::rough_grid(7, 5, 3);
  const auto loops = outlines(HalfEdges(mesh), [](std::size_t) { return true; });
  ASSERT_EQ(loops.size(), 1U);
  std::vector<Index> loop = loops.front();
  std::rotate(loop.begin(), std::min_element(loop.begin(), loop.end()), loop.end());
  EXPECT_EQ(loop, Patch(mesh).border_loops().front());
}

TEST(Outlines, OfNothingAreNone) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  EXPECT_TRUE(outlines(HalfEdges(mesh), [](std::size_t) { return false; }).empty());
}

TEST(Outlines, OfACheckerAreASquareForEachCell) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  const auto loops = outlines(HalfEdges(mesh), [](std::size_t t) { return is_black(t, 3); });
  ASSERT_EQ(loops.size(), 5U);
  for (const auto& loop : loops) {
    EXPECT_EQ(loop.size(), 4U);
    EXPECT_EQ(doubled_area(mesh, loop), 2.0) << "the part on its left";
  }
  const std::set<Index> middle(loops[2].begin(), loops[2].end());
  EXPECT_EQ(middle, (std::set<Index>{5, 6, 9, 10}));
}

TEST(Outlines, GoAroundHolesTheOtherWay) {
  const TriMesh mesh = meshes::flat_grid(3, 3);
  const auto loops =
      outlines(HalfEdges(mesh), [](std::size_t t) { return t / 2 != 4; });  // all but the middle
  ASSERT_EQ(loops.size(), 2U);
  EXPECT_EQ(doubled_area(mesh, loops[0]), 18.0);
  EXPECT_EQ(doubled_area(mesh, loops[1]), -2.0);
}

TEST(Outlines, AreExactAlsoWhereManyTrianglesShareAVertex) {
  TriMesh fan;
  constexpr Index spokes = 3000;
  fan.positions.resize(spokes + 1);
  for (Index i = 0; i < spokes; ++i)
    fan.triangles.push_back({0, i + 1, (i + 1) % spokes + 1});
  const auto loops = outlines(HalfEdges(fan), [](std::size_t) { return true; });
  ASSERT_EQ(loops.size(), 1U);
  EXPECT_EQ(loops.front().size(), spokes);
}

}  // namespace
}  // namespace planish
