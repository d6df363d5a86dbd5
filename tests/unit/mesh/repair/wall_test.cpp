#include <array>
#include <cmath>

#include <planish/mesh/inspect.h>
#include <planish/mesh/patch.h>
#include <planish/mesh/wall.h>

#include <gtest/gtest.h>

#include "measure/normals.h"
#include "support/meshes.h"
#include "support/solids.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

TriMesh thick_shell() {
  return repairs::closed(repairs::shell(18, 12, 100.0), repairs::shell(18, 12, 98.0));
}

/// What may not be lost: sides by the numbers of triangles.
void expect_sides(const TriMesh& mesh, std::size_t of_side, double thickness) {
  const auto wall = find_wall(mesh);
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->thickness, thickness, 0.01 * thickness);
  const RepairedMesh outer = take_side(mesh, *wall, WallPart::outer);
  const RepairedMesh inner = take_side(mesh, *wall, WallPart::inner);
  EXPECT_EQ(outer.mesh.triangles.size(), of_side);
  EXPECT_EQ(inner.mesh.triangles.size(), of_side);
  EXPECT_TRUE(repairs::has_sources(outer, mesh));
}

TEST(FindWall, AClosedShell) {
  const TriMesh mesh = thick_shell();
  ASSERT_EQ(inspect(mesh).problems.front().code, ErrorCode::closed_surface);
  for (const TriMesh& variant : repairs::variants(mesh)) {
    const double unit = bounding_box_diagonal(variant) / bounding_box_diagonal(mesh);
    expect_sides(variant, 432, 2.0 * unit);
    const RepairedMesh outer = take_side(variant, *find_wall(variant), WallPart::outer);
    EXPECT_TRUE(repairs::is_disk(outer.mesh));
    EXPECT_NEAR(repairs::area(outer.mesh) / unit / unit,
                repairs::area(repairs::shell(18, 12, 100.0)), 1e-6);
  }
}

TEST(FindWall, TwoSheetsOrientedAnyWay) {
  const TriMesh outer = repairs::shell(18, 12, 100.0), inner = repairs::shell(18, 12, 98.0);
  const std::array<TriMesh, 4> meshes = {
      repairs::both(outer, turned_over(inner)), repairs::both(turned_over(outer), inner),
      repairs::both(outer, inner), repairs::both(turned_over(inner), turned_over(outer))};
  for (const TriMesh& mesh : meshes) {
    expect_sides(mesh, 432, 2.0);
    const auto wall = find_wall(mesh);
    ASSERT_TRUE(wall);
    const TriMesh taken = take_side(mesh, *wall, WallPart::outer).mesh;
    EXPECT_NEAR(repairs::area(taken), repairs::area(outer), 1e-6);
    // Away from the axis.
    const Triangle t = taken.triangles[5];
    const Vec3 normal = cross(taken.positions[t[1]] - taken.positions[t[0]],
                              taken.positions[t[2]] - taken.positions[t[0]]);
    const Vec3 p = taken.positions[t[0]];
    EXPECT_GT(normal.x * p.x + normal.z * p.z, 0.0);
  }
}

TEST(FindWall, OfAFlatOneTheFirstSideIsTheOuter) {
  const TriMesh above = meshes::flat_grid(30, 30);
  TriMesh below = above;
  for (Vec3& p : below.positions)
    p.z -= 0.5;
  const TriMesh mesh = repairs::closed(above, below);
  const auto wall = find_wall(mesh);
  ASSERT_TRUE(wall);
  EXPECT_TRUE(wall->is_level);
  EXPECT_EQ(wall->part.front(), WallPart::outer);
  EXPECT_EQ(wall->part[1800], WallPart::inner);
  EXPECT_EQ(wall->part[3600], WallPart::rim);
  EXPECT_EQ(take_side(mesh, *wall, WallPart::outer).mesh.triangles, above.triangles);
}

TEST(FindWall, ASleeveHasTwoRims) {
  const auto sleeve = [](double radius) {
    TriMesh mesh = meshes::tube(48, 20);
    for (Vec3& p : mesh.positions)
      p = {radius * p.x, radius * p.y, 10.0 * p.z};
    return mesh;
  };
  const TriMesh mesh = repairs::closed(sleeve(60.0), sleeve(57.0));
  expect_sides(mesh, 1920, 3.0);
  const auto wall = find_wall(mesh);
  ASSERT_TRUE(wall);
  const TriMesh outer = take_side(mesh, *wall, WallPart::outer).mesh;
  EXPECT_EQ(inspect(outer).topology.border_loops, 2U);
  EXPECT_NEAR(repairs::area(outer), repairs::area(sleeve(60.0)), 1e-6);
}

/// The faces of a tray hang together at its edges; the strips of its bottom that have the sides of
/// the tray above them belong to it too.
TEST(FindWall, ATrayHasItsSharpEdges) {
  const auto tray = [](double size, double bottom) {
    TriMesh mesh = meshes::flat_grid(40, 40);
    for (Vec3& p : mesh.positions) {
      const double x = p.x - 20.0, y = p.y - 20.0, out = std::max(std::abs(x), std::abs(y));
      // Beyond 14 cells the sheet goes up.
      const double share = out > 14.0 ? 14.0 / out : 1.0;
      p = {x * share * size / 14.0, y * share * size / 14.0,
           bottom + std::max(0.0, out - 14.0) * (60.0 - bottom) / 6.0};
    }
    // Diagonals along the edges between the sides.
    for (std::size_t q = 0; q < 1600; ++q) {
      if ((q % 40 < 20) == (q / 40 < 20)) continue;
      Triangle &one = mesh.triangles[2 * q], &other = mesh.triangles[2 * q + 1];
      const Index a = one[0], b = one[1], c = one[2], d = other[2];
      one = {a, b, d};
      other = {b, c, d};
    }
    return turned_over(mesh);
  };
  const TriMesh mesh = repairs::closed(tray(100.0, 0.0), tray(96.0, 4.0));
  const auto wall = find_wall(mesh);
  ASSERT_TRUE(wall);
  EXPECT_NEAR(wall->thickness, 4.0, 0.1);
  const TriMesh outer = take_side(mesh, *wall, WallPart::outer).mesh;
  EXPECT_TRUE(repairs::is_disk(outer));
  EXPECT_NEAR(repairs::area(outer), repairs::area(tray(100.0, 0.0)), 1e-6);
}

/// The part of a grid that is a cell or more off its border.
double off_border(Vec3 p, double columns, double rows) {
  return std::min({p.x, columns - p.x, p.y, rows - p.y});
}

/// A dome of 40 x 30 cells, of that height in the middle.
TriMesh dome(double height) {
  return meshes::height_field(40, 30, [&](double x, double y) {
    return height * x * (40.0 - x) * y * (30.0 - y) / 90'000.0;
  });
}

/// The dome shifted along its normals, at the border by less and inwards: a bevel that looks up.
TriMesh shifted(const TriMesh& mesh, double thickness, double bevel) {
  const std::vector<Vec3> normals = vertex_normals(mesh.triangles, mesh.positions, 1.0);
  TriMesh result = mesh;
  for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
    const Vec3 p = mesh.positions[v];
    const bool is_border = off_border(p, 40.0, 30.0) < 0.5;
    const double share = is_border ? 1.0 - bevel : 1.0;
    result.positions[v] = p + share * thickness / norm(normals[v]) * normals[v];
  }
  return result;
}

TEST(FindWall, TheOuterSideBulgesWhateverItsBevels) {
  // Shallow, so that what a bevel adds to or takes from the area is far more than the bend does.
  const TriMesh inner = dome(1.0);
  for (const double bevel : {0.0, 0.4, 0.8}) {
    for (const bool is_below : {false, true}) {
      // A bevel on the side above, or on that below.
      const TriMesh up = is_below ? inner : shifted(inner, 0.7, bevel);
      const TriMesh down = is_below ? shifted(inner, -0.7, bevel) : inner;
      for (const TriMesh& mesh : {repairs::closed(up, down), turned_over(repairs::closed(up, down)),
                                  repairs::sheets(down, up)}) {
        const auto wall = find_wall(mesh);
        ASSERT_TRUE(wall) << bevel << is_below;
        EXPECT_FALSE(wall->is_level);
        const TriMesh outer = take_side(mesh, *wall, WallPart::outer).mesh;
        ASSERT_FALSE(outer.triangles.empty());
        double height = 0.0;
        for (const Triangle& t : outer.triangles) {
          for (const Index v : t)
            height = std::max(height, outer.positions[v].z);
        }
        EXPECT_NEAR(height, is_below ? 1.0 : 1.7, 0.05) << bevel << is_below;
      }
    }
  }
}

TEST(FindWall, SaysWhereNoSideBulges) {
  const auto wave = [](double z) {
    return meshes::height_field(40, 30, [&](double x, double) {
      return z + (x - 20.0) * (x - 20.0) * (x - 20.0) / 4000.0;
    });
  };
  const TriMesh mesh = repairs::closed(wave(0.5), wave(0.0));
  const auto wall = find_wall(mesh);
  ASSERT_TRUE(wall);
  EXPECT_TRUE(wall->is_level);
  EXPECT_EQ(wall->part.front(), WallPart::outer);
  EXPECT_FALSE(find_wall(thick_shell())->is_level);
}

TEST(FindWall, SolidBodiesAreNone) {
  TriMesh rod = solids::cube();
  for (Vec3& p : rod.positions)
    p.x *= 200.0;
  TriMesh block = solids::cube();
  for (Vec3& p : block.positions)
    p.z *= 0.3;
  for (const TriMesh& mesh : {solids::cube(), block, rod, solids::sphere(1.0, 16),
                              solids::star_prism(), meshes::torus(40, 60), meshes::tetrahedron()}) {
    EXPECT_FALSE(find_wall(mesh));
  }
}

TEST(FindWall, SheetsAreNone) {
  TriMesh far = meshes::flat_grid(20, 20);
  for (Vec3& p : far.positions)
    p.z -= 5.0;
  TriMesh slanted = meshes::flat_grid(20, 20);
  for (Vec3& p : slanted.positions)
    p.z -= 0.2 + 0.05 * p.x;
  for (const TriMesh& mesh : {meshes::rough_grid(20, 20, 1), repairs::shell(18, 12),
                              meshes::tube(24, 10), repairs::sheets(meshes::flat_grid(20, 20), far),
                              repairs::sheets(meshes::flat_grid(20, 20), slanted), TriMesh{}}) {
    EXPECT_FALSE(find_wall(mesh));
  }
}

}  // namespace
}  // namespace planish
