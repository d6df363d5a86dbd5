#include <algorithm>
#include <cmath>
#include <limits>

#include <planish/core/error.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/weld.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

constexpr double k_any_length = std::numeric_limits<double>::infinity();

/// Every triangle with vertices of its own, each moved by up to a distance in every direction.
TriMesh soup(const TriMesh& mesh, double jitter = 0.0) {
  meshes::Random random(11);
  TriMesh apart;
  for (const Triangle& t : mesh.triangles) {
    const auto first = static_cast<Index>(apart.positions.size());
    for (const Index v : t)
      apart.positions.push_back(mesh.positions[v] + meshes::random_point(random, jitter));
    apart.triangles.push_back({first, first + 1, first + 2});
  }
  return apart;
}

/// The mesh in three pieces with borders of their own, divided at two columns of a grid.
TriMesh islands(const TriMesh& mesh, std::size_t columns) {
  TriMesh apart;
  for (int island = 0; island < 3; ++island) {
    TriMesh piece = mesh;
    std::size_t quad = 0;
    std::erase_if(piece.triangles, [&](const Triangle&) {
      const std::size_t column = quad++ / 2 % columns;
      return static_cast<int>(3 * column / columns) != island;
    });
    apart = repairs::both(std::move(apart), piece);
  }
  return apart;
}

std::size_t pieces(const TriMesh& mesh) {
  return inspect(mesh).topology.components;
}

TEST(Weld, SoundMeshesStay) {
  for (const TriMesh& mesh : {meshes::rough_grid(6, 5, 1), meshes::tube(9, 3), meshes::torus(8, 9),
                              meshes::tetrahedron(), TriMesh{}}) {
    for (const double length : {0.0, default_weld_length(mesh), 1e300, k_any_length}) {
      const WeldedMesh welded = weld(mesh, length);
      EXPECT_EQ(welded.joined + welded.divided + welded.turned + welded.left, 0U);
      EXPECT_EQ(welded.mesh.triangles, mesh.triangles);
      EXPECT_EQ(welded.mesh.positions, mesh.positions);
    }
  }
}

TEST(Weld, TrianglesOfTheirOwnBecomeASheet) {
  const TriMesh sheet = meshes::rough_grid(6, 5, 2);
  for (const TriMesh& mesh : repairs::variants(soup(sheet))) {
    for (const double length : {0.0, k_any_length}) {
      const WeldedMesh welded = weld(mesh, length);
      EXPECT_TRUE(repairs::is_disk(welded.mesh));
      EXPECT_TRUE(repairs::has_sources(welded, mesh));
      EXPECT_EQ(welded.joined, 79U);  // inner edges
      EXPECT_EQ(repairs::area(welded.mesh), repairs::area(mesh));
    }
  }
}

TEST(Weld, PlacesWithinTheLengthAreJoined) {
  const TriMesh sheet = meshes::rough_grid(6, 5, 3);
  for (const TriMesh& mesh : repairs::variants(soup(sheet, 1e-4))) {
    const double unit = bounding_box_diagonal(mesh) / bounding_box_diagonal(sheet);
    EXPECT_EQ(weld(mesh, 0.0).joined, 0U);
    EXPECT_EQ(weld(mesh, 1e-6 * unit).joined, 0U);
    const WeldedMesh welded = weld(mesh, 4e-4 * unit);
    EXPECT_EQ(welded.joined, 79U);
    EXPECT_TRUE(repairs::is_disk(welded.mesh));
  }
}

TEST(Weld, TheDefaultJoinsAGapOfATenthOfAMicrometreInAModelOfAHundredMillimetres) {
  TriMesh one = meshes::flat_grid(20, 20);
  for (Vec3& p : one.positions)
    p = 5.0 * p;
  TriMesh other = one;
  for (Vec3& p : other.positions)
    p += {100.0 + 1e-4, 0.0, 0.0};
  const TriMesh mesh = repairs::both(one, other);
  EXPECT_TRUE(repairs::is_disk(weld(mesh, default_weld_length(mesh)).mesh));
}

TEST(Weld, IslandsOfATextureBecomeOnePiece) {
  const TriMesh sheet = repairs::shell(12, 8);
  for (const TriMesh& mesh : repairs::variants(islands(sheet, 12))) {
    ASSERT_EQ(pieces(mesh), 3U);
    const WeldedMesh welded = weld(mesh, default_weld_length(mesh));
    EXPECT_EQ(welded.joined, 16U);
    EXPECT_TRUE(repairs::is_disk(welded.mesh));
    const TouchingPieces touching = find_touching_pieces(mesh, default_weld_length(mesh));
    EXPECT_EQ(touching.pieces, 3U);
    EXPECT_EQ(touching.joined, 1U);
    EXPECT_NEAR(touching.length / bounding_box_diagonal(mesh),
                2 * 150.0 / bounding_box_diagonal(sheet), 1e-12);
  }
}

TEST(Weld, APieceThatIsInsideOutIsTurned) {
  const TriMesh large = meshes::flat_grid(6, 5);
  TriMesh small = meshes::flat_grid(2, 5);
  for (Vec3& p : small.positions)
    p.x += 6.0;
  for (const bool large_first : {true, false}) {
    const TriMesh mesh = large_first ? repairs::both(large, turned_over(small))
                                     : repairs::both(turned_over(small), large);
    const WeldedMesh welded = weld(mesh, 0.0);
    EXPECT_EQ(welded.turned, small.triangles.size());
    EXPECT_TRUE(repairs::is_disk(welded.mesh));
    for (const Triangle& t : welded.mesh.triangles) {
      const Vec3 normal = cross(welded.mesh.positions[t[1]] - welded.mesh.positions[t[0]],
                                welded.mesh.positions[t[2]] - welded.mesh.positions[t[0]]);
      EXPECT_GT(normal.z, 0.0);
    }
  }
}

/// Two rectangles of 12 by 10 whose common border has other vertices on each side.
TriMesh meshed_apart(std::size_t left, std::size_t right) {
  const auto rows = [](std::size_t n) {
    TriMesh mesh = meshes::flat_grid(4, n);
    for (Vec3& p : mesh.positions)
      p = {3.0 * p.x, 10.0 * p.y / static_cast<double>(n), 0.0};
    return mesh;
  };
  TriMesh other = rows(right);
  for (Vec3& p : other.positions)
    p.x += 12.0;
  return repairs::both(rows(left), other);
}

TEST(Weld, EdgesAreDividedAtVerticesOfTheOtherSide) {
  for (const auto& [left, right] : {std::pair{2, 6}, std::pair{4, 5}, std::pair{1, 7}}) {
    const TriMesh apart =
        meshed_apart(static_cast<std::size_t>(left), static_cast<std::size_t>(right));
    for (const TriMesh& mesh : repairs::variants(apart)) {
      const WeldedMesh welded = weld(mesh, default_weld_length(mesh));
      EXPECT_TRUE(repairs::is_disk(welded.mesh));
      EXPECT_TRUE(repairs::has_sources(welded, mesh));
      EXPECT_GT(welded.divided, 0U);
      EXPECT_EQ(welded.left, 0U);
      EXPECT_NEAR(repairs::area(welded.mesh), repairs::area(mesh), 1e-12 * repairs::area(mesh));
      EXPECT_EQ(welded.mesh.positions.size(), mesh.positions.size());
      for (std::size_t t = mesh.triangles.size(); t < welded.source.size(); ++t)
        EXPECT_LT(welded.source[t], mesh.triangles.size());
    }
  }
}

TEST(Weld, VerticesBesideAnEdgeAreJoinedWithinTheLength) {
  TriMesh apart = meshed_apart(4, 5);
  for (std::size_t v = 25; v < apart.positions.size(); ++v)
    apart.positions[v] += {6e-5, 0.0, 8e-5};
  for (const TriMesh& mesh : repairs::variants(apart)) {
    const double unit = bounding_box_diagonal(mesh) / bounding_box_diagonal(apart);
    EXPECT_EQ(pieces(weld(mesh, 0.9e-4 * unit).mesh), 2U);
    const WeldedMesh welded = weld(mesh, 1.1e-4 * unit);
    EXPECT_TRUE(repairs::is_disk(welded.mesh));
    EXPECT_NEAR(repairs::area(welded.mesh), repairs::area(mesh), 1e-5 * repairs::area(mesh));
  }
}

TEST(Weld, ATriangleIsDividedOnAllItsSides) {
  TriMesh mesh{{{0, 0, 0}, {6, 0, 0}, {0, 6, 0}}, {{0, 1, 2}}};
  // Beside each side two edges that meet in its middle or at a third.
  const TriMesh beside[] = {
      {{{0, 0, 0}, {2, 0, 0}, {6, 0, 0}, {3, -4, 0}}, {{0, 3, 1}, {1, 3, 2}}},
      {{{6, 0, 0}, {3, 3, 0}, {0, 6, 0}, {8, 8, 0}}, {{1, 0, 3}, {2, 1, 3}}},
      {{{0, 6, 0}, {0, 2, 0}, {0, 0, 0}, {-5, 3, 0}}, {{0, 3, 1}, {1, 3, 2}}}};
  for (const TriMesh& piece : beside)
    mesh = repairs::both(std::move(mesh), piece);
  const WeldedMesh welded = weld(mesh, 0.0);
  EXPECT_EQ(welded.divided, 3U);
  EXPECT_EQ(welded.joined, 6U);
  EXPECT_TRUE(repairs::is_disk(welded.mesh));
  EXPECT_NEAR(repairs::area(welded.mesh), repairs::area(mesh), 1e-12);
}

TEST(Weld, ASlitIsClosed) {
  const TriMesh sheet = repairs::shell(12, 8);
  TriMesh mesh = sheet;
  // Above the middle row, vertices 54 to 62 are others.
  for (Index v = 54; v <= 62; ++v)
    mesh.positions.push_back(sheet.positions[v]);
  for (std::size_t t = 96; t < mesh.triangles.size(); ++t) {
    for (Index& v : mesh.triangles[t])
      v = v >= 54 && v <= 62 ? v + 117 - 54 : v;
  }
  ASSERT_EQ(inspect(mesh).topology.border_loops, 2U);
  const WeldedMesh welded = weld(mesh, 0.0);
  EXPECT_EQ(welded.joined, 10U);
  EXPECT_EQ(welded.mesh.triangles, sheet.triangles);
}

TEST(Weld, ThreeBordersOnOneCurveAreLeft) {
  const auto [one, other, third] = repairs::three_on_one_line();
  const TriMesh mesh = repairs::both(repairs::both(one, other), third);
  const WeldedMesh welded = weld(mesh, 0.0);
  EXPECT_EQ(welded.joined, 0U);
  EXPECT_EQ(welded.left, 15U);
}

TEST(Weld, SheetsThatLieOnEachOtherAreLeft) {
  const TriMesh sheet = meshes::rough_grid(5, 4, 4);
  TriMesh other = sheet;
  for (Vec3& p : other.positions)
    p.z += 1e-3;
  const WeldedMesh welded = weld(repairs::both(sheet, other), 1e-2);
  EXPECT_EQ(pieces(welded.mesh), 2U);
  EXPECT_GT(welded.left, 0U);
}

TEST(Weld, PiecesThatTouchAtAPointStayApart) {
  TriMesh other = meshes::flat_grid(3, 3);
  for (Vec3& p : other.positions)
    p += {3.0, 3.0, 0.0};
  const TriMesh mesh = repairs::both(meshes::flat_grid(3, 3), other);
  EXPECT_EQ(pieces(weld(mesh, 0.1).mesh), 2U);
  EXPECT_EQ(find_touching_pieces(mesh, 0.1).pieces, 0U);
}

/// Lengths above the edges collapse nothing.
TEST(Weld, ALongLengthLeavesEveryTriangle) {
  const TriMesh mesh = islands(meshes::rough_grid(9, 7, 5), 9);
  for (const double length : {0.3, 1.0, 10.0, 1e6, k_any_length}) {
    const WeldedMesh welded = weld(mesh, length);
    EXPECT_TRUE(repairs::is_disk(welded.mesh)) << length;
    EXPECT_EQ(welded.mesh.triangles.size(), mesh.triangles.size());
  }
}

/// Two triangles on one edge whose other corners are at one end of it.
TEST(Weld, TrianglesWithoutAreaDoNotBecomeOne) {
  const TriMesh mesh{{{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {1, 0, 0}}, {{0, 1, 3}, {0, 3, 2}}};
  for (const double length : {0.0, 0.1}) {
    const WeldedMesh welded = weld(mesh, length);
    EXPECT_EQ(welded.mesh.triangles, mesh.triangles);
    EXPECT_EQ(welded.left, 2U);
  }
}

TEST(Weld, LengthsThatAreNoneAreRefused) {
  for (const double length : {-1.0, -k_any_length, std::nan("")}) {
    for (const bool touching : {true, false}) {
      try {
        const TriMesh mesh = meshes::flat_grid(2, 2);
        if (touching) {
          find_touching_pieces(mesh, length);
        } else {
          weld(mesh, length);
        }
        ADD_FAILURE() << length;
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ErrorCode::option_out_of_range);
      }
    }
  }
}

TEST(NearestBorderGap, IsBetweenPieces) {
  const TriMesh grid = meshes::flat_grid(5, 4);
  const auto beside = [&](double gap) {
    TriMesh other = grid;
    for (Vec3& p : other.positions)
      p = {p.x + 5.0 + gap, p.y + 0.37, p.z};
    return repairs::both(grid, other);
  };
  for (const double gap : {0.0, 0.01, 0.3, 7.0}) {
    for (const TriMesh& mesh : repairs::variants(beside(gap))) {
      const double unit = bounding_box_diagonal(mesh) / bounding_box_diagonal(beside(gap));
      const auto found = nearest_border_gap(mesh);
      ASSERT_TRUE(found);
      EXPECT_NEAR(*found, gap * unit, 1e-9 * unit);
    }
  }
  EXPECT_FALSE(nearest_border_gap(grid)) << "one piece has no other";
  EXPECT_FALSE(nearest_border_gap(meshes::tetrahedron())) << "and no border";
  EXPECT_FALSE(nearest_border_gap({}));
}

}  // namespace
}  // namespace planish
