#include <numeric>

#include <planish/mesh/carry.h>
#include <planish/mesh/imprint.h>
#include <planish/mesh/inspect.h>
#include <planish/mesh/repair.h>
#include <planish/mesh/surface_line.h>

#include <gtest/gtest.h>

#include "lines/line_checks.h"
#include "support/meshes.h"
#include "unit/mesh/repair/repairs.h"

namespace planish {
namespace {

/// A square of two triangles, whose diagonal has more vertices on one of its sides: triangles
/// with little area lie between. The corners of the square come first.
/// @param depth that these vertices are below the diagonal
TriMesh square_with_caps(std::size_t count, double depth = 0.0) {
  TriMesh mesh{{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}}, {{0, 2, 3}}};
  std::vector<Index> on = {0};
  for (std::size_t i = 1; i <= count; ++i) {
    on.push_back(static_cast<Index>(mesh.positions.size()));
    const double place = 4.0 * static_cast<double>(i) / static_cast<double>(count + 1);
    mesh.positions.push_back({place, place, -depth});
  }
  on.push_back(2);
  for (std::size_t i = 1; i < on.size(); ++i) {
    mesh.triangles.push_back({on[i], on[i - 1], 1});
    if (i + 1 < on.size()) mesh.triangles.push_back({0, on[i], on[i + 1]});
  }
  return mesh;
}

double area_of(const TriMesh& mesh) {
  return std::accumulate(
      mesh.triangles.begin(), mesh.triangles.end(), 0.0,
      [&](double sum, const Triangle& t) { return sum + norm(lines::area_vector(mesh, t)); });
}

TEST(FlipCaps, EachBecomesAPartOfTheNeighbourAtItsLongSide) {
  for (const std::size_t count : {1U, 2U, 7U}) {
    const TriMesh mesh = square_with_caps(count);
    const FlippedMesh flat = flip_caps(mesh, 0.0);
    EXPECT_EQ(flat.flipped, count);
    EXPECT_EQ(flat.mesh.positions, mesh.positions);
    const Inspection found = inspect(flat.mesh);
    EXPECT_TRUE(found.problems.empty()) << found.problems.front().message;
    EXPECT_EQ(found.topology.euler_characteristic, 1);
    EXPECT_DOUBLE_EQ(area_of(flat.mesh), 16.0);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
      const bool was_flat = norm(lines::area_vector(mesh, mesh.triangles[t])) == 0.0;
      EXPECT_EQ(flat.source[t], was_flat ? 0 : t);
    }
  }
}

TEST(FlipCaps, OnlyThoseAsLowAsAskedFor) {
  const TriMesh mesh = square_with_caps(1, 1e-3);
  EXPECT_EQ(flip_caps(mesh, 0.9e-3).flipped, 0U);
  EXPECT_EQ(flip_caps(mesh, 1.1e-3).flipped, 1U);
  EXPECT_THROW(flip_caps(mesh, -1.0), Error);
}

TEST(FlipCaps, ALongSideAtTheBorderStays) {
  const TriMesh mesh{{{0, 0, 0}, {2, 0, 0}, {1, 0, 0}, {1, 1, 0}},
                     {{0, 1, 2}, {0, 2, 3}, {2, 1, 3}}};
  const FlippedMesh flat = flip_caps(mesh, 0.0);
  EXPECT_EQ(flat.flipped, 0U);
  EXPECT_EQ(flat.mesh.triangles, mesh.triangles);
}

TEST(FlipCaps, NothingHappensToASoundMeshOfAnySize) {
  for (const double scale : {1e-200, 1.0, 1e200}) {
    const TriMesh mesh = scaled(meshes::rough_grid(6, 5, 1), scale);
    EXPECT_EQ(flip_caps(mesh, 0.0).mesh.triangles, mesh.triangles);
  }
}

// The middle of the diagonal is on two edges while the cap is there.
TEST(FlipCaps, ALineAcrossThemIsImprinted) {
  const TriMesh mesh = square_with_caps(2);
  const Patch patch(flip_caps(mesh, 0.0).mesh);
  const DrawnLine drawn{{{3.5, 0, 0}, {0.5, 4, 0}}};
  const std::vector<SurfaceLine> line = trace_lines(patch, {{drawn}, {}}).lines;
  lines::Figures figures;
  EXPECT_EQ(lines::wrong_imprint(patch, line, imprint(patch, line), figures), "");
}

}  // namespace
}  // namespace planish
