#include <algorithm>
#include <cmath>
#include <limits>

#include <planish/measure/deviation.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "mesh/coarsen/coarsen.h"

namespace planish {
namespace {

TriMesh moved(TriMesh mesh, Vec3 by) {
  for (Vec3& p : mesh.positions)
    p = p + by;
  return mesh;
}

TEST(BoundaryChange, IsNoneWhereOnlyInnerVerticesMoved) {
  const TriMesh mesh = make_shape("dome", 300);
  const Patch patch(mesh);
  TriMesh after = mesh;
  for (const Index v : patch.inner_vertices())
    after.positions[v].z += 1.0;
  EXPECT_FALSE(measure_border_change(patch, after.positions).has_value());
}

TEST(BoundaryChange, TellsTheFurthestMoveAndBothLengthsAtAnySize) {
  const TriMesh dome = make_shape("dome", 300);
  const Patch patch(dome);
  double radius = 0.0, length = 0.0;
  for (const auto& loop : patch.border_loops()) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Vec3 p = dome.positions[loop[i]], q = dome.positions[loop[(i + 1) % loop.size()]];
      radius = std::max(radius, std::hypot(p.x, p.y));
      length += norm(q - p);
    }
  }
  for (const double size : {1.0, 1e-200, 1e200}) {
    TriMesh before = dome, after = dome;
    for (std::size_t v = 0; v < dome.positions.size(); ++v) {
      const Vec3 p = dome.positions[v];
      before.positions[v] = size * p;
      after.positions[v] = size * Vec3{1.25 * p.x, 1.25 * p.y, p.z};
    }
    const auto change = measure_border_change(Patch(before), after.positions);
    ASSERT_TRUE(change.has_value());
    EXPECT_NEAR(change->max, 0.25 * radius * size, 1e-9 * radius * size);
    EXPECT_NEAR(change->length_before, length * size, 1e-12 * length * size);
    EXPECT_NEAR(change->length_after, 1.25 * length * size, 1e-9 * length * size);
  }
}

TEST(SurfaceDeviation, IsNoneBetweenASurfaceAndItself) {
  const TriMesh mesh = make_shape("dome", 500);
  const Deviation deviation = measure_surface_deviation(Patch(mesh), mesh);
  EXPECT_EQ(deviation.max, 0.0);
  EXPECT_EQ(deviation.rms_over_diagonal, 0.0);
}

TEST(SurfaceDeviation, IsTheDistanceOfPlanesWhateverTheirTriangles) {
  TriMesh plane = make_shape("panel", 2000);
  for (Vec3& p : plane.positions)
    p.z = 0.0;
  const TriMesh coarse = coarsen(Patch(plane), 500, CoarseBorder::kept).mesh;
  ASSERT_LT(coarse.positions.size(), 900U);
  const Deviation deviation =
      measure_surface_deviation(Patch(plane), moved(coarse, {0.0, 0.0, 3.0}));
  EXPECT_NEAR(deviation.rms, 3.0, 1e-9);
  EXPECT_NEAR(deviation.max, 3.0, 1e-9);
}

/// No vertex of a thinned surface left the fine one, so the fine one's vertices decide; the oracle
/// takes many points of every coarse triangle.
TEST(SurfaceDeviation, IsWhatManyPointsOfTheTrianglesSay) {
  const TriMesh fine = make_shape("dome", 400);
  const TriMesh coarse = coarsen(Patch(fine), 120, CoarseBorder::kept).mesh;
  std::vector<Vec3> points;
  constexpr int cuts = 24;
  for (const Triangle& t : coarse.triangles) {
    for (int i = 0; i <= cuts; ++i) {
      for (int j = 0; i + j <= cuts; ++j) {
        const double a = static_cast<double>(i) / cuts, b = static_cast<double>(j) / cuts;
        points.push_back(a * coarse.positions[t[0]] + b * coarse.positions[t[1]] +
                         (1.0 - a - b) * coarse.positions[t[2]]);
      }
    }
  }
  const Patch patch(fine);
  double squares = 0.0, most = 0.0;
  for (const Index v : patch.inner_vertices()) {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3 p : points)
      least = std::min(least, norm(p - fine.positions[v]));
    squares += least * least;
    most = std::max(most, least);
  }
  const double rms = std::sqrt(squares / static_cast<double>(patch.inner_vertices().size()));
  const Deviation deviation = measure_surface_deviation(patch, coarse);
  EXPECT_GT(most, 0.1);  // millimetres
  EXPECT_NEAR(deviation.rms, rms, 0.05 * rms);
  EXPECT_NEAR(deviation.max, most, 0.05 * most);
}

}  // namespace
}  // namespace planish
