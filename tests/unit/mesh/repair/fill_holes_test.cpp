#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

#include <planish/core/error.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/repair.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

constexpr double k_any = std::numeric_limits<double>::infinity();

/// The mesh without the triangles that have all corners within a distance of a place.
TriMesh with_hole(TriMesh mesh, Vec3 middle, double radius) {
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    return std::all_of(t.begin(), t.end(),
                       [&](Index v) { return norm(mesh.positions[v] - middle) < radius; });
  });
  return mesh;
}

/// A quarter cylinder with holes of two sizes.
TriMesh shell_with_holes() {
  const TriMesh shell = repairs::shell(20, 20);
  const TriMesh small = with_hole(shell, shell.positions[5 * 21 + 5], 12.0);
  return with_hole(small, shell.positions[13 * 21 + 13], 24.0);
}

TEST(FillHoles, TheLengthDecidesWhich) {
  const TriMesh mesh = shell_with_holes();
  ASSERT_EQ(inspect(mesh).topology.border_loops, 3U);
  EXPECT_EQ(fill_holes(mesh, 1.0).filled, 0U);
  EXPECT_EQ(fill_holes(mesh, 1.0).left, 0U);
  EXPECT_EQ(fill_holes(mesh, 70.0).filled, 1U);
  EXPECT_EQ(fill_holes(mesh, k_any).filled, 2U);
}

TEST(FillHoles, ClosesAllButTheOuterBorder) {
  const TriMesh mesh = shell_with_holes();
  const double whole = repairs::area(repairs::shell(20, 20));
  const std::vector<TriMesh> variants = repairs::variants(mesh);
  const std::vector<double> scales = {1.0, 1.0, 1.0, 1e-3, 1e3};
  for (std::size_t i = 0; i < variants.size(); ++i) {
    const FilledMesh filled = fill_holes(variants[i], k_any);
    EXPECT_EQ(filled.filled, 2U);
    EXPECT_EQ(filled.left, 0U);
    EXPECT_TRUE(repairs::is_disk(filled.mesh));
    EXPECT_TRUE(repairs::has_sources(filled, variants[i]));
    EXPECT_NEAR(repairs::area(filled.mesh) / (scales[i] * scales[i]), whole, 0.002 * whole);
    const auto news = std::count(filled.source.begin(), filled.source.end(), RepairedMesh::none);
    EXPECT_EQ(static_cast<std::size_t>(news), filled.mesh.triangles.size() - mesh.triangles.size());
  }
}

/// A vent with 12 teeth has a longer border than the disc around it.
TEST(FillHoles, TheRimIsNoHoleThoughAJaggedOneIsLonger) {
  constexpr Index spokes = 96, rings = 6;
  TriMesh disc;
  for (Index r = 0; r < rings; ++r) {
    for (Index k = 0; k < spokes; ++k) {
      const double angle = 6.283185307179586 * k / spokes;
      const double inner = k % 8 < 4 ? 20.0 : 70.0;
      const double radius = inner + (100.0 - inner) * r / (rings - 1);
      disc.positions.push_back({radius * std::cos(angle), radius * std::sin(angle), 0.0});
    }
  }
  for (Index r = 0; r + 1 < rings; ++r) {
    for (Index k = 0; k < spokes; ++k) {
      const Index a = r * spokes + k, b = r * spokes + (k + 1) % spokes;
      disc.triangles.push_back({a, a + spokes, b});
      disc.triangles.push_back({b, a + spokes, b + spokes});
    }
  }
  const Inspection found = inspect(disc);
  ASSERT_EQ(found.topology.border_loops, 2U);
  for (const Problem& problem : found.problems)
    EXPECT_EQ(problem.message.find("--fill-holes"), std::string::npos) << problem.message;
  EXPECT_EQ(fill_holes(disc, 700.0).filled, 0U) << "the rim is 628 long";
  const FilledMesh all = fill_holes(disc, k_any);
  ASSERT_EQ(all.filled, 1U);
  const TriMesh& mesh = all.mesh;
  double area = 0.0;
  for (const Triangle& t : mesh.triangles) {
    area += 0.5 * norm(cross(mesh.positions[t[1]] - mesh.positions[t[0]],
                             mesh.positions[t[2]] - mesh.positions[t[0]]));
  }
  const double whole = 0.5 * spokes * 100.0 * 100.0 * std::sin(6.283185307179586 / spokes);
  EXPECT_NEAR(area, whole, 1e-9 * whole);
}

TEST(FillHoles, OfAPlaneStaysInItAndDoesNotFold) {
  TriMesh mesh = meshes::flat_grid(12, 12);
  // A hole in the shape of an L.
  std::erase_if(mesh.triangles, [&](const Triangle& t) {
    const Vec3 sum = mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]];
    const double x = sum.x / 3.0, y = sum.y / 3.0;
    return x > 2 && y > 2 && x < 9 && y < 9 && (x < 5 || y < 5);
  });
  const FilledMesh filled = fill_holes(mesh, k_any);
  EXPECT_EQ(filled.filled, 1U);
  EXPECT_NEAR(repairs::area(filled.mesh), 144.0, 1e-9);
  for (const Triangle& t : filled.mesh.triangles) {
    const Vec3 normal = cross(filled.mesh.positions[t[1]] - filled.mesh.positions[t[0]],
                              filled.mesh.positions[t[2]] - filled.mesh.positions[t[0]]);
    EXPECT_GT(normal.z, 0.0);
  }
}

TEST(FillHoles, ATubeKeepsOneEnd) {
  const FilledMesh filled = fill_holes(meshes::tube(12, 4), k_any);
  EXPECT_EQ(filled.filled, 1U);
  EXPECT_TRUE(repairs::is_disk(filled.mesh));
}

TEST(FillHoles, EachPieceKeepsItsOuterBorder) {
  TriMesh other = shell_with_holes();
  for (Vec3& p : other.positions)
    p += {500.0, 0.0, 0.0};
  const FilledMesh filled = fill_holes(repairs::both(shell_with_holes(), other), k_any);
  EXPECT_EQ(filled.filled, 4U);
  EXPECT_EQ(inspect(filled.mesh).topology.border_loops, 2U);
}

/// A grid of 6 x 6 cells, cut along its fourth row of vertices from one column to another; `apart`
/// is how far the upper side of the middle column is moved.
TriMesh with_slit(Index from, Index to, double apart = 0.0) {
  TriMesh mesh = meshes::flat_grid(6, 6);
  const TriMesh whole = mesh;
  for (Index column = from; column <= to; ++column) {
    const Index v = 21 + column;
    const Vec3 lift = {0.0, column == 3 ? apart : 0.0, 0.0};
    mesh.positions.push_back(mesh.positions[v] + lift);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const Triangle& corners = whole.triangles[t];
      if (std::none_of(corners.begin(), corners.end(), [](Index w) { return w > 27; })) continue;
      std::replace(mesh.triangles[t].begin(), mesh.triangles[t].end(), v,
                   static_cast<Index>(mesh.positions.size() - 1));
    }
  }
  return mesh;
}

TEST(FillHoles, TheSidesOfASlitBecomeOne) {
  for (const Index to : {2U, 3U, 4U}) {
    const TriMesh mesh = with_slit(2, to);
    ASSERT_EQ(inspect(mesh).topology.border_loops, 2U);
    for (const TriMesh& variant : repairs::variants(mesh)) {
      const FilledMesh filled = fill_holes(variant, k_any);
      EXPECT_EQ(filled.filled, 1U);
      EXPECT_EQ(filled.left, 0U);
      EXPECT_EQ(filled.mesh.triangles.size(), mesh.triangles.size());
      EXPECT_TRUE(repairs::is_disk(filled.mesh));
      EXPECT_TRUE(repairs::has_sources(filled, variant));
    }
    const double length = 2.0 * (to - 2.0 + 2.0);
    EXPECT_EQ(fill_holes(mesh, 0.99 * length).filled, 0U);
    EXPECT_EQ(fill_holes(mesh, 1.01 * length).filled, 1U);
  }
}

TEST(FillHoles, AHoleThatEndsInASlitIsClosedWithIt) {
  const TriMesh mesh = with_slit(2, 4, 0.2);
  const FilledMesh filled = fill_holes(mesh, k_any);
  EXPECT_EQ(filled.filled, 2U);
  EXPECT_EQ(filled.mesh.triangles.size(), mesh.triangles.size() + 2U);
  EXPECT_TRUE(repairs::is_disk(filled.mesh));
}

TEST(FillHoles, ASlitFromTheOuterBorderIsACutAndStays) {
  const TriMesh mesh = with_slit(0, 3);
  const FilledMesh filled = fill_holes(mesh, k_any);
  EXPECT_EQ(filled.filled, 0U);
  EXPECT_EQ(filled.left, 0U);
  EXPECT_EQ(filled.mesh.triangles, mesh.triangles);
}

TEST(FillHoles, MeshesThatAreNoManifoldStay) {
  TriMesh mesh = shell_with_holes();
  mesh.triangles.push_back(mesh.triangles[0]);
  EXPECT_EQ(fill_holes(mesh, k_any).filled, 0U);
  EXPECT_EQ(fill_holes({}, k_any).filled, 0U);
}

TEST(FillHoles, ALengthMustBeAboveZero) {
  for (const double length : {0.0, -1.0, std::nan("")}) {
    try {
      fill_holes(meshes::flat_grid(2, 2), length);
      ADD_FAILURE() << length;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::option_out_of_range);
    }
  }
}

}  // namespace
}  // namespace planish
