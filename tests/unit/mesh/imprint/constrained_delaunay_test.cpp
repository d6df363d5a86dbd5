#include "mesh/imprint/constrained_delaunay.h"

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

namespace planish {
namespace {

Vec2 grid(double x, double y) {
  return {std::nearbyint(x * k_cells), std::nearbyint(y * k_cells)};
}

TEST(ConstrainedDelaunay, FindsTheNearestCornerBeyondASegment) {
  ConstrainedDelaunay inside({1.0, std::sqrt(2.0), 1.0});
  const Index from = inside.add(grid(0.1, 0.3)), to = inside.add(grid(0.7, 0.2));
  inside.connect(from, to);
  inside.add(grid(0.4, 0.25 + 2e-5));
  const Vec2 place = {0.4, 0.25 - 2e-5};
  double nearest = 1.0;
  for (Index node = 0; node < inside.nodes().size(); ++node)
    nearest = std::min(nearest, norm(inside.place(node) - place));
  EXPECT_NEAR(nearest, 4e-5, 1e-12);
  EXPECT_DOUBLE_EQ(inside.distance_to_corner(place), nearest);
}

}  // namespace
}  // namespace planish
