#include <cmath>
#include <cstdint>
#include <numbers>

#include <planish/measure/obstruction.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "oracle/plain.h"
#include "support/meshes.h"

namespace planish {
namespace {

using std::numbers::pi;

Obstruction found(const TriMesh& mesh) {
  const auto obstruction = find_obstruction(Patch(mesh));
  EXPECT_TRUE(obstruction.has_value());
  return obstruction.value_or(Obstruction{});
}

/// A disk of rings x around cells, place(r, turn) with r from 0 to 1.
template <class Place>
TriMesh round_patch(std::size_t rings, std::size_t around, Place place) {
  TriMesh mesh;
  mesh.positions.push_back(place(0.0, 0.0));
  for (std::size_t k = 1; k <= rings; ++k) {
    for (std::size_t i = 0; i < around; ++i) {
      mesh.positions.push_back(
          place(static_cast<double>(k) / static_cast<double>(rings),
                2.0 * pi * static_cast<double>(i) / static_cast<double>(around)));
    }
  }
  const auto at = [around](std::size_t k, std::size_t i) {
    return static_cast<Index>(k == 0 ? 0 : 1 + (k - 1) * around + i % around);
  };
  for (std::size_t k = 1; k <= rings; ++k) {
    for (std::size_t i = 0; i < around; ++i) {
      mesh.triangles.push_back({at(k - 1, i), at(k, i), at(k, i + 1)});
      if (k > 1) mesh.triangles.push_back({at(k - 1, i), at(k, i + 1), at(k - 1, i + 1)});
    }
  }
  return mesh;
}

TriMesh cap(double opening, std::size_t rings) {
  return round_patch(rings, 4 * rings, [&](double r, double turn) {
    const double polar = opening * r;
    return Vec3{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                std::cos(polar)};
  });
}

/// Far from any axis, at another size.
TriMesh moved(TriMesh mesh, double scale) {
  for (Vec3& p : mesh.positions) {
    const Vec3 turned = {0.36 * p.x + 0.48 * p.y - 0.8 * p.z, -0.8 * p.x + 0.6 * p.y,
                         0.48 * p.x + 0.64 * p.y + 0.6 * p.z};
    p = scale * (turned + Vec3{3.0, -5.0, 2.0});
  }
  return mesh;
}

TEST(Obstruction, OfASphericalCapIsAsInClosedForm) {
  // Area 2 pi (1 - cos a), border 2 pi sin a: the share that must go is sin^2(a / 2).
  for (const double opening : {0.15, 0.7, 1.2, 0.5 * pi, 2.2}) {
    const double area = 2.0 * pi * (1.0 - std::cos(opening));
    const double limit = pi * std::sin(opening) * std::sin(opening);
    const auto error = [&](std::size_t rings) {
      return std::abs(found(cap(opening, rings)).excess_share - (1.0 - limit / area));
    };
    const double coarse = error(20), fine = error(40);
    EXPECT_LT(fine, 1e-3) << opening;
    EXPECT_LT(fine, 0.3 * coarse) << opening;  // second order in the length of the edges

    const Obstruction obstruction = found(cap(opening, 40));
    EXPECT_TRUE(obstruction.blocked()) << opening;
    EXPECT_TRUE(obstruction.has_flat_border()) << opening;
    EXPECT_EQ(obstruction.is_notable(), opening > 0.2) << opening;
    EXPECT_NEAR(obstruction.area, area, 2e-3 * area) << opening;
    EXPECT_NEAR(obstruction.border_length, 2.0 * pi * std::sin(opening), 2e-3) << opening;
    EXPECT_NEAR(obstruction.area_excess, obstruction.area - obstruction.area_limit, 1e-12);
  }
}

TEST(Obstruction, IsTheIsoperimetricBoundWhereTheBorderIsNotFlat) {
  const TriMesh mesh = round_patch(20, 80, [](double r, double turn) {
    const double polar = r * (1.2 + 0.2 * std::cos(3.0 * turn));
    return Vec3{std::sin(polar) * std::cos(turn), std::sin(polar) * std::sin(turn),
                std::cos(polar)};
  });
  const Obstruction obstruction = found(mesh);
  double length = 0.0;
  for (std::size_t i = 0; i < 80; ++i) {
    const std::size_t first = mesh.positions.size() - 80;
    length += norm(mesh.positions[first + (i + 1) % 80] - mesh.positions[first + i]);
  }
  EXPECT_FALSE(obstruction.has_flat_border());
  EXPECT_NEAR(obstruction.border_length, length, 1e-12);
  EXPECT_NEAR(obstruction.area_limit, length * length / (4.0 * pi), 1e-12);
  EXPECT_TRUE(obstruction.is_notable());
}

TEST(Obstruction, NeverStandsInTheWayOfAFlatPiece) {
  // Of polygons the regular ones come closest to the bound: they lack pi^2 / (3 n^2) of it.
  for (const std::size_t corners : {3U, 4U, 7U, 60U, 1000U, 100000U}) {
    const double n = static_cast<double>(corners);
    for (const double scale : {1.0, 1e-9, 1e9}) {
      const Obstruction obstruction = found(moved(meshes::fan(corners), scale));
      EXPECT_FALSE(obstruction.blocked()) << corners;
      EXPECT_EQ(obstruction.excess_share, 0.0);
      EXPECT_EQ(obstruction.area_excess, 0.0);
      EXPECT_NEAR(obstruction.area / obstruction.area_limit, (pi / n) / std::tan(pi / n), 1e-11)
          << corners;
    }
  }
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    EXPECT_FALSE(found(moved(meshes::rough_grid(9, 7, seed, 0.25, 0.0), 3.7)).blocked()) << seed;
  }
  EXPECT_NEAR(found(meshes::flat_grid(6, 6)).area_limit, 36.0 * 4.0 / pi, 1e-12);
}

TEST(Obstruction, OfAFlatConvexBorderIsTheAreaThatItEncloses) {
  // Shorter borders than that of a square enclose as much: the bound of the circle does not see it.
  const TriMesh dome = meshes::height_field(
      12, 12, [](double x, double y) { return 0.01 * x * (12.0 - x) * y * (12.0 - y) / 12.0; });
  const Obstruction obstruction = found(moved(dome, 0.01));
  EXPECT_TRUE(obstruction.has_flat_border());
  EXPECT_NEAR(obstruction.area_limit, 0.0144, 1e-14);
  EXPECT_TRUE(obstruction.blocked());
  EXPECT_LT(obstruction.area, 0.0144 * 4.0 / pi);
}

TEST(Obstruction, IsNoneOnSaddlesAndOnFlattenablePatches) {
  for (const double height : {0.003, 0.03, 0.3}) {
    const auto saddle = meshes::height_field(
        16, 16, [&](double x, double y) { return height * (x - 8.0) * (y - 8.0); });
    EXPECT_FALSE(found(saddle).blocked()) << height;
    const auto turned = meshes::height_field(16, 16, [&](double x, double y) {
      return height * ((x - 8.0) * (x - 8.0) - (y - 8.0) * (y - 8.0));
    });
    EXPECT_FALSE(found(turned).blocked()) << height;
  }
  for (const char* name : {"saddle", "cylinder", "cone", "tangent"}) {
    EXPECT_FALSE(found(make_shape(name, 1000)).blocked()) << name;
  }
  // Its opening is 70 degrees.
  EXPECT_NEAR(found(make_shape("dome", 4000)).excess_share, 0.5 - 0.5 * std::cos(70.0 / 180 * pi),
              2e-3);
}

TEST(Obstruction, BalancesDefectsAndTheTurningOfTheBorder) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const TriMesh mesh = meshes::rough_grid(11, 8, seed, 0.3, 0.8);
    const plain::Patch patch(mesh);
    const Obstruction obstruction = found(mesh);
    double defects = 0.0;
    for (Index v = 0; v < mesh.positions.size(); ++v)
      defects += patch.inner[v] ? patch.defect(v) : 0.0;
    EXPECT_NEAR(obstruction.total_defect, defects, 1e-11);
    EXPECT_NEAR(obstruction.total_defect + obstruction.border_turning, k_flat_turning, 1e-9);
    // Angles are at least what they are in space (spherical triangles), which add up to at most
    // what is needed (Fenchel).
    EXPECT_GE(obstruction.turning_most, obstruction.border_turning - 1e-12);
    EXPECT_GE(obstruction.turning_most, k_flat_turning - 1e-12);
  }
  for (const Shape& shape : shapes()) {
    const Obstruction obstruction = found(make_shape(shape.name, 700));
    EXPECT_NEAR(obstruction.total_defect + obstruction.border_turning, k_flat_turning, 1e-9);
  }
}

TEST(Obstruction, CountsTheAnglesThatNoInnerVertexCanChange) {
  // Two corners of a grid are ears, the two others have a diagonal.
  const Obstruction grid = found(meshes::rough_grid(5, 4, 1));
  EXPECT_EQ(grid.border_vertices, 18U);
  EXPECT_EQ(grid.fixed_angles, 2U);
  const Obstruction strip = found(meshes::rough_grid(7, 1, 1));
  EXPECT_EQ(strip.border_vertices, 16U);
  EXPECT_EQ(strip.fixed_angles, 16U);
  EXPECT_EQ(found(meshes::fan(5)).fixed_angles, 0U);
}

TEST(Obstruction, KeepsItsShareAtAnySizeAndPlace) {
  const TriMesh mesh = cap(1.1, 12);
  const Obstruction here = found(mesh);
  for (const double scale : {1e-200, 1e-3, 17.0, 1e100}) {
    const Obstruction there = found(moved(mesh, scale));
    EXPECT_NEAR(there.excess_share, here.excess_share, 1e-12) << scale;
    EXPECT_NEAR(there.border_turning, here.border_turning, 1e-11) << scale;
    EXPECT_NEAR(there.turning_most, here.turning_most, 1e-11) << scale;
    EXPECT_NEAR(there.border_length / scale, here.border_length, 1e-11) << scale;
  }
  EXPECT_NEAR(found(moved(mesh, 17.0)).area_excess, 289.0 * here.area_excess, 1e-10);
}

TEST(Obstruction, IsAskedOfDisksOnly) {
  const auto grid = meshes::rough_grid(5, 4, 1);
  for (const TriMesh& mesh :
       {meshes::tube(7, 4), meshes::torus(9, 11), meshes::tetrahedron(),
        meshes::side_by_side(grid, grid), meshes::side_by_side(grid, meshes::tetrahedron()),
        meshes::side_by_side(grid, meshes::torus(9, 11))}) {
    EXPECT_FALSE(find_obstruction(Patch(mesh)).has_value());
  }
  TriMesh with_stray = grid;
  with_stray.positions.push_back({100.0, 100.0, 100.0});
  EXPECT_NEAR(found(with_stray).area, found(grid).area, 1e-12);
}

}  // namespace
}  // namespace planish
