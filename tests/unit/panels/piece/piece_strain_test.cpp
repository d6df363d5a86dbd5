#include "panels/piece/piece_strain.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "panels/piece/laid_flat.h"
#include "panels/seams/seam_chains.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

std::vector<Index> all_triangles(const PanelMesh& mesh) {
  std::vector<Index> all(mesh.triangles().size());
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

PanelPiece whole_piece(const PanelMesh& mesh, const OpenEdges& open) {
  return measured_piece(mesh, open, all_triangles(mesh));
}

OpenEdges all_closed(const PanelMesh& mesh) {
  return OpenEdges(mesh.edges().size(), 0);
}

std::size_t border_curves(const PanelMesh& mesh, const OpenEdges& open) {
  return PieceCorners(mesh, open, all_triangles(mesh)).border_loops().size();
}

double rms_of_pattern(const PanelMesh& mesh, const OpenEdges& open) {
  const PieceCorners corners(mesh, open, all_triangles(mesh));
  const auto flat = laid_flat(mesh, corners, {}, {.threads = 1});
  return flat ? flat->strain.rms : std::numeric_limits<double>::infinity();
}

/// A round piece of the surface z = height(square of the distance from the axis).
template <class Height>
PanelMesh round_cap(std::size_t rings, double radius, Height height) {
  TriMesh mesh;
  mesh.positions.push_back({0.0, 0.0, height(0.0)});
  const auto at = [&](std::size_t ring, std::size_t k) {
    return ring == 0 ? Index{0} : static_cast<Index>(1 + 3 * ring * (ring - 1) + k % (6 * ring));
  };
  for (std::size_t r = 1; r <= rings; ++r) {
    const double rho = radius * static_cast<double>(r) / static_cast<double>(rings);
    for (std::size_t k = 0; k < 6 * r; ++k) {
      const double angle =
          2.0 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(6 * r);
      mesh.positions.push_back({rho * std::cos(angle), rho * std::sin(angle), height(rho * rho)});
    }
    for (std::size_t k = 0; k < 6 * r; ++k) {
      const std::size_t sector = k / r, inner = k - sector;
      mesh.triangles.push_back({at(r, k), at(r, k + 1), at(r - 1, inner)});
      if (k % r != r - 1)
        mesh.triangles.push_back({at(r, k + 1), at(r - 1, inner + 1), at(r - 1, inner)});
    }
  }
  return PanelMesh(Patch(std::move(mesh)));
}

TEST(PieceStrain, OfASmallCapIsThatOfTheClampedPlate) {
  // Laplace^2 chi = K on a disk of radius R with chi and its slope 0 at the border is
  // K (R^2 - r^2)^2 / 64, so the strain is K R^2 / sqrt(512).
  const double radius = 0.2;
  const PanelMesh cap =
      round_cap(24, radius, [](double squared) { return std::sqrt(1.0 - squared); });
  EXPECT_NEAR(whole_piece(cap, all_closed(cap)).strain(), radius * radius / std::sqrt(512.0),
              0.03 * radius * radius / std::sqrt(512.0));
}

TEST(PieceStrain, OfAPieceWithSlitsIsThatOfItsPattern) {
  const PanelMesh cap =
      round_cap(16, 0.75, [](double squared) { return std::sqrt(1.0 - squared); });
  OpenEdges open = all_closed(cap);
  double last = whole_piece(cap, open).strain();
  // Slits from the border along three of the straight spokes.
  for (const std::size_t sector : {0U, 2U, 4U}) {
    for (std::size_t r = 16; r > 5; --r) {
      const auto at = [&](std::size_t ring) {
        return static_cast<Index>(1 + 3 * ring * (ring - 1) + sector * ring);
      };
      const Index e = find_edge(cap, at(r), at(r - 1));
      ASSERT_NE(e, PanelEdge::none);
      open[e] = 1;
    }
    const PanelPiece piece = whole_piece(cap, open);
    EXPECT_TRUE(piece.is_planar);
    EXPECT_LT(piece.strain(), last);
    last = piece.strain();
    const PieceCorners corners(cap, open, piece.triangles);
    const auto flat = laid_flat(cap, corners, {}, {.threads = 1});
    ASSERT_TRUE(flat);
    EXPECT_NEAR(piece.strain(), flat->strain.rms, 0.15 * flat->strain.rms);
  }
}

TEST(PieceStrain, IsNoneOnDevelopableSurfaces) {
  for (const char* name : {"cylinder", "cone"}) {
    const PanelMesh mesh(Patch(make_shape(name, 800)));
    EXPECT_LT(whole_piece(mesh, all_closed(mesh)).strain(), 1e-3) << name;
  }
  // A tip of a cone strains until a slit reaches it.
  const PanelMesh cone = round_cap(12, 1.0, [](double squared) { return -std::sqrt(squared); });
  OpenEdges open = all_closed(cone);
  EXPECT_GT(whole_piece(cone, open).strain(), 0.05);
  for (std::size_t r = 12; r > 0; --r) {
    const auto at = [](std::size_t ring) {
      return ring == 0 ? Index{0} : static_cast<Index>(1 + 3 * ring * (ring - 1));
    };
    open[find_edge(cone, at(r), at(r - 1))] = 1;
  }
  EXPECT_LT(whole_piece(cone, open).strain(), 0.02);
}

TEST(PieceStrain, OfAPieceWithAHoleIsThatOfItsPattern) {
  const auto height = [](double u, double v) { return 0.25 * std::hypot(u, v); };
  for (const bool is_saddle : {false, true}) {
    const meshes::Place place = [&](double x, double y) {
      const double u = x / 20.0 - 1.0, v = y / 20.0 - 1.0;
      return Vec3{u, v, is_saddle ? 0.2 * (u * u - v * v) : height(u, v)};
    };
    const PanelMesh mesh(Patch(meshes::perforated(40, 40, meshes::blocks(40, 40, 1, 1, 6), place)));
    OpenEdges open = all_closed(mesh);
    ASSERT_EQ(border_curves(mesh, open), 2U);
    const double strain = whole_piece(mesh, open).strain();
    EXPECT_GT(strain, 0.004);
    EXPECT_NEAR(strain, rms_of_pattern(mesh, open), 0.1 * strain);
  }
}

TEST(PieceStrain, IsInfiniteWhereASlitReachesNoBorder) {
  const PanelMesh sheet(Patch(meshes::flat_grid(6, 6)));
  OpenEdges open = all_closed(sheet);
  open[find_edge(sheet, 24, 25)] = open[find_edge(sheet, 25, 26)] = 1;
  EXPECT_TRUE(std::isinf(whole_piece(sheet, open).energy));
  EXPECT_TRUE(std::isinf(rms_of_pattern(sheet, open)));
  open[find_edge(sheet, 26, 27)] = 1;
  EXPECT_LT(whole_piece(sheet, open).energy, 1e-20);
}

TEST(PieceCorners, TellsDisksTubesAndHandles) {
  const PanelMesh sphere(Patch(solids::sphere(1.0, 12)));
  EXPECT_FALSE(whole_piece(sphere, all_closed(sphere)).is_planar);
  const PanelMesh tube(Patch(meshes::tube(12, 4)));
  EXPECT_TRUE(whole_piece(tube, all_closed(tube)).is_planar);
  EXPECT_EQ(border_curves(tube, all_closed(tube)), 2U);
  EXPECT_TRUE(std::isinf(whole_piece(tube, all_closed(tube)).energy));
  PanelMesh torus(Patch(meshes::torus(12, 12)));
  OpenEdges open = all_closed(torus);
  open[0] = 1;
  EXPECT_EQ(border_curves(torus, open), 1U);
  EXPECT_FALSE(whole_piece(torus, open).is_planar);
  const PanelMesh cube(Patch(meshes::finer(solids::cube(), 2)));
  OpenEdges slit = all_closed(cube);
  slit[0] = 1;
  EXPECT_EQ(border_curves(cube, slit), 1U);
  EXPECT_TRUE(whole_piece(cube, slit).is_planar);
  EXPECT_NEAR(whole_piece(cube, slit).area, 1.0, 1e-12);
}

}  // namespace
}  // namespace planish
