#include "support/seams.h"

#include <algorithm>

#include <planish/mesh/cut.h>
#include <planish/mesh/seams.h>

#include <gtest/gtest.h>

#include "mesh/split.h"
#include "support/meshes.h"

namespace planish {
namespace {

std::vector<TriMesh> strips(const TriMesh& mesh, std::size_t cells, std::size_t columns) {
  std::vector<Index> group;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    group.push_back(static_cast<Index>(t / 2 % columns / cells));
  const std::vector<std::string> names = {"a", "b", "c"};
  std::vector<TriMesh> meshes;
  for (NamedPatch& patch : split(mesh, group, names))
    meshes.push_back(std::move(patch.mesh));
  return meshes;
}

void expect_same_places(const Seam& seam, std::span<const TriMesh> patches, double tolerance) {
  ASSERT_EQ(seam.sides[0].vertices.size(), seam.sides[1].vertices.size());
  for (std::size_t k = 0; k < seam.sides[0].vertices.size(); ++k) {
    const Vec3 a = patches[seam.sides[0].patch].positions[seam.sides[0].vertices[k]];
    const Vec3 b = patches[seam.sides[1].patch].positions[seam.sides[1].vertices[k]];
    EXPECT_LE(norm(a - b), tolerance);
  }
}

TEST(Seams, AreTheWholeCurvesThatNeighboursShare) {
  const TriMesh mesh = meshes::rough_grid(9, 6, 5);
  const auto patches = strips(mesh, 3, 9);
  const auto seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 2U);
  for (std::size_t s = 0; s < 2; ++s) {
    EXPECT_EQ(seams[s].sides[0].patch, s);
    EXPECT_EQ(seams[s].sides[1].patch, s + 1);
    EXPECT_EQ(seams[s].sides[0].vertices.size(), 7U);
    expect_same_places(seams[s], patches, 0.0);
    double length = 0.0;
    const std::size_t column = 3 * (s + 1);
    for (std::size_t j = 0; j < 6; ++j) {
      length += norm(mesh.positions[(j + 1) * 10 + column] - mesh.positions[j * 10 + column]);
    }
    EXPECT_NEAR(length_of(seams[s].sides[0], patches[s].positions), length, 1e-12);
    EXPECT_NEAR(length_of(seams[s].sides[1], patches[s + 1].positions), length, 1e-12);
  }
}

TEST(Seams, NeedAToleranceWherePlacesDifferALittle) {
  auto patches = strips(meshes::rough_grid(9, 6, 5), 3, 9);
  for (Vec3& p : patches[1].positions)
    p += {3e-4, -2e-4, 1e-4};
  for (const Seam& seam : find_seams(patches))
    EXPECT_TRUE(seam.is_curve());
  const auto seams = find_seams(patches, 1e-3);
  ASSERT_EQ(seams.size(), 2U);
  for (const Seam& seam : seams) {
    EXPECT_FALSE(seam.is_curve());
    EXPECT_EQ(seam.sides[0].vertices.size(), 7U);
    expect_same_places(seam, patches, 1e-3);
  }
}

TEST(Seams, AreFoundWhereAPatchMeetsItself) {
  const std::vector<TriMesh> vase = {meshes::opened_vase(12, 8)};
  const auto seams = find_seams(vase);
  ASSERT_EQ(seams.size(), 1U);
  EXPECT_EQ(seams[0].sides[0].patch, seams[0].sides[1].patch);
  EXPECT_EQ(seams[0].sides[0].vertices.size(), 9U);
  expect_same_places(seams[0], vase, 0.0);
}

// Of a cut with a short branch in the middle: a curve along the cut would have both legs of the
// branch in one of its sides.
TEST(Seams, HaveTheLegsOfADartOnlyOnce) {
  constexpr Index columns = 20, rows = 24, width = columns + 1;
  const Patch grid(meshes::rough_grid(columns, rows, 5));
  CutPath cut, branch;
  for (Index j = 0; j <= rows; ++j)
    cut.vertices.push_back(j * width + 10);
  for (Index i = 10; i <= 12; ++i)
    branch.vertices.push_back(12 * width + i);
  const std::vector<TriMesh> patches = [&] {
    const TriMesh mesh = cut_open(grid, std::vector{cut, branch}).mesh;
    std::vector<TriMesh> meshes;
    for (NamedPatch& patch : split(mesh, "cut"))
      meshes.push_back(std::move(patch.mesh));
    return meshes;
  }();
  ASSERT_EQ(patches.size(), 2U);
  const auto seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 3U) << "above and below the branch, and the branch";
  for (const Seam& seam : seams) {
    EXPECT_FALSE(seam.is_curve());
    expect_same_places(seam, patches, 0.0);
  }
}

TEST(Seams, AreFoundForEveryTwoOfSeveralPages) {
  std::vector<TriMesh> pages;
  for (NamedPatch& page : split(meshes::book(3, 4, 6), "page"))
    pages.push_back(std::move(page.mesh));
  const auto seams = find_seams(pages);
  ASSERT_EQ(seams.size(), 3U);
  for (const Seam& seam : seams)
    EXPECT_EQ(seam.sides[0].vertices.size(), 7U);
}

TEST(Seams, MayBeClosed) {
  const TriMesh ring = meshes::tube(16, 2);
  TriMesh upper = ring;
  for (Vec3& p : upper.positions)
    p.z += 2.0;
  const std::vector<TriMesh> tubes = {ring, upper};
  const auto seams = find_seams(tubes);
  ASSERT_EQ(seams.size(), 1U);
  EXPECT_EQ(seams[0].sides[0].vertices.size(), 17U);
  EXPECT_EQ(seams[0].sides[0].vertices.front(), seams[0].sides[0].vertices.back());
  EXPECT_EQ(seams[0].sides[1].vertices.front(), seams[0].sides[1].vertices.back());
  expect_same_places(seams[0], tubes, 0.0);
}

TEST(Seams, AreFoundAlsoWhereOnePatchShowsItsOtherSide) {
  auto patches = strips(meshes::rough_grid(9, 6, 5), 3, 9);
  for (Triangle& t : patches[1].triangles)
    std::swap(t[1], t[2]);
  const auto seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 2U);
  for (const Seam& seam : seams) {
    EXPECT_EQ(seam.sides[0].vertices.size(), 7U);
    expect_same_places(seam, patches, 0.0);
  }
}

}  // namespace
}  // namespace planish
