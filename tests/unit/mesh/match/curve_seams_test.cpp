// Seams between borders that were meshed apart.

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

#include <planish/mesh/seams.h>

#include <gtest/gtest.h>

#include "support/jacket.h"
#include "support/meshes.h"

namespace planish {
namespace {

using Patches = std::vector<TriMesh>;

double length_on(const SeamSide& side, const Patches& patches) {
  return length_of(side, std::span<const Vec3>(patches[side.patch].positions));
}

/// The place at a share of a side's length.
Vec3 place_at(const SeamSide& side, const Patches& patches, double share) {
  const auto line = line_of(side, std::span<const Vec3>(patches[side.patch].positions));
  double left = share * length_on(side, patches);
  for (std::size_t k = 1; k < line.size(); ++k) {
    const double length = norm(line[k] - line[k - 1]);
    if (left <= length && length > 0.0)
      return line[k - 1] + (left / length) * (line[k] - line[k - 1]);
    left -= length;
  }
  return line.back();
}

/// Looks at all that is promised of a seam as curve.
void expect_sound(const Seam& seam, const Patches& patches, double tolerance) {
  ASSERT_TRUE(seam.is_curve());
  EXPECT_EQ(seam.matches.front(), (std::array<double, 2>{0.0, 0.0}));
  EXPECT_EQ(seam.matches.back(), (std::array<double, 2>{1.0, 1.0}));
  for (std::size_t k = 1; k < seam.matches.size(); ++k) {
    EXPECT_GE(seam.matches[k][0], seam.matches[k - 1][0]);
    EXPECT_GE(seam.matches[k][1], seam.matches[k - 1][1]);
  }
  for (double share = 0.0; share <= 1.0; share += 0.01) {
    const Vec3 a = place_at(seam.sides[0], patches, share);
    const Vec3 b = place_at(seam.sides[1], patches, matched_share(seam, share));
    EXPECT_LE(norm(a - b), tolerance) << share;
  }
  for (const SeamSide& side : seam.sides) {
    EXPECT_GE(side.first_share, 0.0);
    EXPECT_LT(side.first_share, 1.0);
    EXPECT_GT(side.last_share, 0.0);
    EXPECT_LE(side.last_share, 1.0);
    EXPECT_GE(side.vertices.size(), 2U);
  }
}

/// A flat grid over a rectangle.
TriMesh sheet(double x0, double x1, double y0, double y1, std::size_t columns, std::size_t rows) {
  TriMesh mesh = meshes::flat_grid(columns, rows);
  for (Vec3& p : mesh.positions) {
    p = {x0 + (x1 - x0) * p.x / static_cast<double>(columns),
         y0 + (y1 - y0) * p.y / static_cast<double>(rows), 0.0};
  }
  return mesh;
}

TEST(CurveSeams, OfAJacketMeshedPanelByPanelAreAllFoundAndNoOthers) {
  Patches patches;
  for (const NamedPatch& panel : meshes::Jacket::panels())
    patches.push_back(panel.mesh);
  const std::vector<Seam> seams = find_seams(patches);
  std::vector<std::pair<std::size_t, std::size_t>> found;
  for (const Seam& seam : seams) {
    found.emplace_back(seam.sides[0].patch, seam.sides[1].patch);
    expect_sound(seam, patches, 1.5);
    EXPECT_NEAR(length_on(seam.sides[0], patches), length_on(seam.sides[1], patches),
                2e-3 * length_on(seam.sides[0], patches));
    for (const SeamSide& side : seam.sides) {
      EXPECT_EQ(side.first_share, 0.0) << "all ends are corners";
      EXPECT_EQ(side.last_share, 1.0);
    }
  }
  EXPECT_EQ(found, meshes::Jacket::seams());
  EXPECT_TRUE(find_near_borders(patches, seams).empty());
}

TEST(CurveSeams, AreTheSameWhereverTheModelIsAndWhateverItsUnit) {
  Patches patches;
  for (const NamedPatch& panel : meshes::Jacket::panels())
    patches.push_back(panel.mesh);
  const std::vector<Seam> seams = find_seams(patches);
  Patches moved = patches;
  for (TriMesh& mesh : moved) {
    for (Vec3& p : mesh.positions)
      p = 0.001 * Vec3{0.6 * p.x - 0.8 * p.z + 50.0, p.y - 20.0, 0.8 * p.x + 0.6 * p.z + 7.0};
  }
  const std::vector<Seam> others = find_seams(moved);
  ASSERT_EQ(others.size(), seams.size());
  for (std::size_t s = 0; s < seams.size(); ++s) {
    for (std::size_t side = 0; side < 2; ++side) {
      EXPECT_EQ(others[s].sides[side].vertices, seams[s].sides[side].vertices);
      EXPECT_NEAR(1000.0 * length_on(others[s].sides[side], moved),
                  length_on(seams[s].sides[side], patches), 1e-6);
    }
  }
}

TEST(CurveSeams, MayEndInTheMiddleOfAnEdge) {
  const Patches patches = {sheet(0, 10, 0, 20, 10, 20), sheet(10, 14, 3.3, 12.7, 5, 23)};
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  expect_sound(seams[0], patches, 1e-12);
  const SeamSide& side = seams[0].sides[0];
  EXPECT_EQ(side.vertices.size(), 11U) << "from 3 to 13";
  EXPECT_NEAR(side.first_share, 0.3, 1e-12);
  EXPECT_NEAR(side.last_share, 0.7, 1e-12);
  EXPECT_NEAR(length_on(side, patches), 9.4, 1e-12);
  EXPECT_EQ(seams[0].sides[1].vertices.size(), 24U);
  EXPECT_NEAR(length_on(seams[0].sides[1], patches), 9.4, 1e-12);
}

TEST(CurveSeams, MayLieWithinOneEdge) {
  const Patches patches = {sheet(0, 10, 0, 20, 1, 1), sheet(10, 14, 5, 15, 5, 23)};
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  expect_sound(seams[0], patches, 1e-12);
  EXPECT_EQ(seams[0].sides[0].vertices.size(), 2U);
  EXPECT_NEAR(seams[0].sides[0].first_share, 0.25, 1e-12);
  EXPECT_NEAR(seams[0].sides[0].last_share, 0.75, 1e-12);
  EXPECT_NEAR(length_on(seams[0].sides[0], patches), 10.0, 1e-12);
}

TEST(CurveSeams, MeetInATJunction) {
  const Patches patches = {sheet(0, 10, 0, 20, 10, 20), sheet(10, 18, 0, 8.37, 9, 11),
                           sheet(10, 18, 8.37, 20, 13, 17)};
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 3U);
  const std::vector<double> lengths = {8.37, 11.63, 8.0};
  for (std::size_t s = 0; s < 3; ++s) {
    expect_sound(seams[s], patches, 1e-12);
    for (const SeamSide& side : seams[s].sides)
      EXPECT_NEAR(length_on(side, patches), lengths[s], 1e-12);
  }
}

/// A cone whose two straight sides meet, as the sides of a dart do, with other vertices each.
TriMesh dart(std::size_t around, std::size_t along) {
  TriMesh mesh;
  mesh.positions.push_back({0.0, 0.0, 0.0});
  const double turn = 2.0 * std::numbers::pi;
  for (std::size_t j = 1; j <= along; ++j) {
    for (std::size_t i = 0; i <= around; ++i) {
      const double u = static_cast<double>(i) / static_cast<double>(around);
      const double r = static_cast<double>(j) - (j < along ? 0.4 * u : 0.0);
      const double angle = i == around ? 0.0 : turn * u;
      mesh.positions.push_back({r * std::cos(angle), r * std::sin(angle), 0.5 * r});
    }
  }
  const auto at = [&](std::size_t i, std::size_t j) {
    return static_cast<Index>(1 + (j - 1) * (around + 1) + i);
  };
  for (std::size_t i = 0; i < around; ++i) {
    mesh.triangles.push_back({0, at(i, 1), at(i + 1, 1)});
    for (std::size_t j = 1; j < along; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return mesh;
}

TEST(CurveSeams, OfADartRunToItsTip) {
  const Patches patches = {dart(40, 16)};
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  expect_sound(seams[0], patches, 1e-12);
  for (const SeamSide& side : seams[0].sides) {
    EXPECT_EQ(side.vertices.size(), 17U);
    EXPECT_NEAR(length_on(side, patches), 16.0 * std::sqrt(1.25), 1e-12);
    EXPECT_TRUE(side.vertices.front() == 0 || side.vertices.back() == 0) << "the tip";
  }
}

/// A tube from z0 to z1 whose border vertices lie on circles, `turned` by some of an edge.
TriMesh tube(std::size_t around, double z0, double z1, double turned) {
  const std::size_t rows = 4;
  TriMesh mesh = meshes::tube(around, rows);
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const double angle = 2.0 * std::numbers::pi * (static_cast<double>(v % around) + turned) /
                         static_cast<double>(around);
    mesh.positions[v] = {10.0 * std::cos(angle), 10.0 * std::sin(angle),
                         z0 + (z1 - z0) * static_cast<double>(v / around) / rows};
  }
  return mesh;
}

TEST(CurveSeams, MayBeClosed) {
  const Patches patches = {tube(24, 0.0, 10.0, 0.0), tube(31, 10.0, 25.0, 0.37)};
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  expect_sound(seams[0], patches, 0.1);
  const std::vector<double> edges = {24.0, 31.0};
  for (std::size_t s = 0; s < 2; ++s) {
    const SeamSide& side = seams[0].sides[s];
    EXPECT_NEAR(length_on(side, patches), edges[s] * 20.0 * std::sin(std::numbers::pi / edges[s]),
                1e-9);
    EXPECT_LT(norm(place_at(side, patches, 0.0) - place_at(side, patches, 1.0)), 1e-9);
  }
}

TEST(CurveSeams, AreNoneAtTwoTolerancesAndOneAtHalf) {
  const auto apart = [](double gap) {
    return Patches{sheet(0, 10, 0, 20, 10, 40), sheet(10 + gap, 14, 0, 20, 5, 27)};
  };
  EXPECT_EQ(find_seams(apart(0.05), 0.1).size(), 1U);
  EXPECT_TRUE(find_seams(apart(0.2), 0.1).empty());
  EXPECT_EQ(find_seams(apart(0.025)).size(), 1U) << "a tenth of the shorter edges is 0.05";
  EXPECT_TRUE(find_seams(apart(0.15)).empty());
  EXPECT_EQ(find_seams(apart(0.15), 0.2).size(), 1U);
}

TEST(CurveSeams, AreNoneWhereBordersCross) {
  for (const double angle : {0.1, 0.3, 0.8, 1.5}) {
    Patches patches = {sheet(0, 10, -10, 10, 10, 40), sheet(10, 20, -11, 11, 10, 53)};
    for (Vec3& p : patches[1].positions) {
      const double x = p.x - 10.0;
      p = {10.0 + x * std::cos(angle) - p.y * std::sin(angle),
           x * std::sin(angle) + p.y * std::cos(angle), 0.0};
    }
    EXPECT_TRUE(find_seams(patches).empty()) << angle;
    EXPECT_TRUE(find_seams(patches, 0.05).empty()) << angle;
  }
}

TEST(CurveSeams, AreNoneAcrossAThinStripOfOnePatch) {
  // Whose sides have other vertices; of one row, and of several.
  for (const std::size_t rows : {1U, 5U}) {
    TriMesh strip = meshes::flat_grid(60, rows);
    for (Vec3& p : strip.positions)
      p = {p.x + 0.4 * p.y / static_cast<double>(rows), 0.05 * p.y / static_cast<double>(rows),
           0.0};
    EXPECT_TRUE(find_seams({{strip}}).empty()) << rows;
    EXPECT_TRUE(find_seams({{strip}}, 0.2).empty()) << rows;
    TriMesh ring = meshes::tube(60, rows);
    for (std::size_t v = 0; v < ring.positions.size(); ++v) {
      const double row = static_cast<double>(v / 60) / static_cast<double>(rows);
      const double angle =
          2.0 * std::numbers::pi * (static_cast<double>(v % 60) + 0.4 * row) / 60.0;
      ring.positions[v] = {9.5 * std::cos(angle), 9.5 * std::sin(angle), 0.05 * row};
    }
    EXPECT_TRUE(find_seams({{ring}}).empty()) << rows;
  }
}

TEST(CurveSeams, AreNoneWhereTwoBordersTouchAtACorner) {
  // A ring cut open whose ends only touch at their inner corners.
  TriMesh ring = meshes::flat_grid(60, 12);
  for (Vec3& p : ring.positions) {
    const double u = p.x / 60.0, r = 10.0 + p.y;
    const double open = 0.15 * p.y / 12.0;  // of the end's angle
    const double angle = u * (2.0 * std::numbers::pi - open);
    p = {r * std::cos(angle), r * std::sin(angle), 0.0};
  }
  EXPECT_TRUE(find_seams({{ring}}).empty());
  const Patches corners = {sheet(0, 10, 0, 10, 10, 10), sheet(10, 20, 10, 20, 13, 13)};
  EXPECT_TRUE(find_seams(corners).empty());
}

TEST(CurveSeams, AreNoFragments) {
  // Along three edges, and along many of a far larger border, but only 0.1 % of it.
  EXPECT_TRUE(
      find_seams(Patches{sheet(0, 10, 0, 20, 10, 20), sheet(10, 14, 4.5, 7.5, 4, 3)}).empty());
  EXPECT_TRUE(
      find_seams(Patches{sheet(0, 1000, 0, 1000, 4, 4), sheet(1000, 2000, 999.9, 2000, 4, 10007)})
          .empty());
}

TEST(CurveSeams, GoOnOverAJag) {
  Patches patches = {sheet(0, 10, 0, 20, 10, 40), sheet(10, 14, 0, 20, 5, 53)};
  for (std::size_t row : {20U, 21U})
    patches[0].positions[row * 11 + 10].x -= 0.8;
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  EXPECT_NEAR(length_on(seams[0].sides[1], patches), 20.0, 1e-12);
  EXPECT_GT(length_on(seams[0].sides[0], patches), 20.5);
  expect_sound(seams[0], patches, 0.9);
}

TEST(CurveSeams, DoNotNeedATightTolerance) {
  Patches patches;
  for (const NamedPatch& panel : meshes::Jacket::panels())
    patches.push_back(panel.mesh);
  const std::vector<Seam> seams = find_seams(patches);
  for (const double tolerance : {1.0, 3.0, 8.0}) {
    const std::vector<Seam> others = find_seams(patches, tolerance);
    ASSERT_EQ(others.size(), seams.size()) << tolerance;
    for (std::size_t s = 0; s < seams.size(); ++s) {
      EXPECT_NEAR(length_on(others[s].sides[0], patches), length_on(seams[s].sides[0], patches),
                  1e-9)
          << tolerance << " " << s;
    }
  }
}

TEST(CurveSeams, AreNoneBetweenTwoLayersThatAreSewnThemselves) {
  // Two pairs with equal vertices, one above the other.
  Patches patches = {sheet(0, 10, 0, 20, 10, 20), sheet(10, 14, 0, 20, 5, 20),
                     sheet(2, 10, -1, 21, 8, 29), sheet(10, 17, -1, 21, 5, 29)};
  for (const std::size_t upper : {2U, 3U}) {
    for (Vec3& p : patches[upper].positions)
      p.z = 0.05;
  }
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 2U);
  for (const Seam& seam : seams)
    EXPECT_FALSE(seam.is_curve());
  patches.pop_back();
  EXPECT_EQ(find_seams(patches).size(), 3U) << "the third one has no seam of its own";
}

TEST(CurveSeams, LeaveOutVerticesThatHappenToBeEqual) {
  // Along the first half the vertices differ, and in the second only a pair of edges lies together.
  Patches patches = {sheet(0, 10, 0, 20, 10, 200), sheet(10, 14, 0, 20, 5, 400)};
  for (std::size_t row = 1; row < 401; ++row) {
    Vec3& p = patches[1].positions[row * 6];
    if (row < 200) p.y += 0.01;
    if (row > 200 && row != 300 && row != 301 && row != 302) p.x += 0.5;
  }
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  expect_sound(seams[0], patches, 1e-12);
  EXPECT_NEAR(length_on(seams[0].sides[0], patches), 10.0, 1e-12);
}

TEST(CurveSeams, TakeTheRestWhereOnlyAPartHasEqualVertices) {
  Patches patches = {sheet(0, 10, 0, 20, 10, 20), sheet(10, 14, 0, 20, 5, 20)};
  for (std::size_t row = 8; row < 20; ++row)
    patches[1].positions[row * 6].y += 0.3;
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  expect_sound(seams[0], patches, 1e-12);
  EXPECT_NEAR(length_on(seams[0].sides[0], patches), 20.0, 1e-12);
}

TEST(CurveSeams, AreFoundAlsoWhereOnePatchShowsItsOtherSide) {
  Patches patches = {sheet(0, 10, 0, 20, 10, 20), sheet(10, 14, 0, 20, 5, 27)};
  for (Triangle& t : patches[1].triangles)
    std::swap(t[1], t[2]);
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  expect_sound(seams[0], patches, 1e-12);
}

TEST(CurveSeams, OfManyVerticesAreFoundWithoutLookingAtAllPairs) {
  const Patches patches = {sheet(0, 1, 0, 1000, 1, 30000), sheet(1, 2, 0, 1000, 1, 20011)};
  const std::vector<Seam> seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  EXPECT_NEAR(length_on(seams[0].sides[1], patches), 1000.0, 1e-9);
}

}  // namespace
}  // namespace planish
