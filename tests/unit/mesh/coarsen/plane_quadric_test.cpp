#include "mesh/coarsen/plane_quadric.h"

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

TEST(PlaneQuadric, IsTheMeanSquareOfDistances) {
  meshes::Random random(3);
  const auto point = [&] { return Vec3{random.number(), random.number(), random.number()}; };
  const auto unit = [&] {
    const Vec3 v = point();
    return (1.0 / norm(v)) * v;
  };
  const Vec3 at = point();
  PlaneQuadric quadric, other;
  EXPECT_EQ(quadric.mean(at), 0.0);
  double sum = 0.0, weights = 0.0;
  for (int i = 0; i < 5; ++i) {
    const Vec3 p = point(), n = unit(), q = point(), e = unit();
    const double weight = 1.5 + random.number();
    quadric.add_plane(p, n, weight);
    other.add_line(q, e, 0.5 * weight, 4.0);
    const double height = dot(at - p, n), aside = norm(cross(at - q, e));
    sum += weight * height * height + 2.0 * weight * aside * aside;
    weights += 1.5 * weight;
  }
  quadric += other;
  EXPECT_NEAR(quadric.mean(at), sum / weights, 1e-13);
}

}  // namespace
}  // namespace planish
