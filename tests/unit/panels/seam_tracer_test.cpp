#include "panels/seam_tracer.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/solids.h"

namespace planish {
namespace {

TEST(SeamTracer, MakesAZigzagFairNearWhereItIs) {
  const Patch sheet(meshes::flat_grid(40, 40));
  DrawnLine drawn;
  for (int k = 0; k <= 30; ++k)
    drawn.points.push_back({5.0 + k, 20.0 + (k % 2 == 0 ? 0.4 : -0.4), 0.0});
  const SeamTracer tracer(sheet);
  const std::vector<DrawnLine> lines = {drawn};
  const SurfaceLine line = tracer.traced(lines).at(0);
  const SurfaceLine fair = tracer.fair(line, 8.0, 2);
  const auto length = [&](const SurfaceLine& l) { return length_of(l, sheet.positions()); };
  EXPECT_NEAR(length(line), 30.0 * std::hypot(1.0, 0.8), 1e-9);
  EXPECT_LT(length(fair), 1.01 * 30.0);
  for (const SurfacePoint& place : fair)
    EXPECT_NEAR(position_of(place, sheet.positions()).y, 20.0, 0.41);
  // Its ends stay.
  EXPECT_NEAR(position_of(fair.front(), sheet.positions()).x, 5.0, 1e-12);
  EXPECT_NEAR(position_of(fair.back(), sheet.positions()).x, 35.0, 1e-12);
}

TEST(SeamTracer, StaysAtSharpVertices) {
  const Patch cube(meshes::finer(solids::cube(), 4));
  // From the middle of one side over a corner to the middle of another one.
  const Vec3 corner = cube.positions()[0];
  DrawnLine drawn;
  drawn.points = {{0.25 * corner.x, 0.25 * corner.y, corner.z},
                  corner,
                  {corner.x, 0.25 * corner.y, 0.25 * corner.z}};
  const SeamTracer tracer(cube);
  const std::vector<DrawnLine> lines = {drawn};
  const SurfaceLine fair = tracer.fair(tracer.traced(lines).at(0), 1000.0, 2);
  double nearest = 1.0;
  for (const SurfacePoint& place : fair)
    nearest = std::min(nearest, norm(position_of(place, cube.positions()) - corner));
  EXPECT_LT(nearest, 1e-9);
}

TEST(SeamTracer, GivesALineOfEachDrawnOne) {
  // Chords of a sphere, some far below its surface.
  const Patch sphere(solids::sphere(1.0, 32));
  std::vector<DrawnLine> drawn;
  for (const double angle : {0.1, 0.3, 2.0}) {
    drawn.push_back({{{1.0, 0.0, 0.0}, {std::cos(angle), std::sin(angle), 0.0}}, {}});
  }
  const std::vector<SurfaceLine> lines = SeamTracer(sphere).traced(drawn);
  ASSERT_EQ(lines.size(), drawn.size());
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const Vec3 end = position_of(lines[k].back(), sphere.positions());
    EXPECT_LT(norm(end - drawn[k].points.back()), 0.05) << k;
  }
}

}  // namespace
}  // namespace planish
