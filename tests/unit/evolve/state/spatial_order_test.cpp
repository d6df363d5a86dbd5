#include "evolve/state/spatial_order.h"

#include <algorithm>
#include <numeric>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// Positions on a square grid of 2^bits cells a side, row by row.
std::vector<Vec3> grid(int bits) {
  std::vector<Vec3> positions;
  for (int y = 0; y < 1 << bits; ++y) {
    for (int x = 0; x < 1 << bits; ++x)
      positions.push_back({static_cast<double>(x), static_cast<double>(y), 0.0});
  }
  return positions;
}

std::vector<Index> order_of(const std::vector<Vec3>& positions, std::vector<Index> chosen,
                            double shift = 0.0, unsigned threads = 2) {
  ThreadPool pool(threads);
  const Box box = bounding_box(positions, chosen, pool);
  return spatial_order(positions, chosen, 1.0, box, shift, pool);
}

std::vector<Index> all_of(const std::vector<Vec3>& positions) {
  std::vector<Index> chosen(positions.size());
  std::iota(chosen.begin(), chosen.end(), Index{0});
  return chosen;
}

TEST(SpatialOrder, GoesThroughAGridQuarterByQuarter) {
  const auto order = order_of(grid(1), {0, 1, 2, 3});
  EXPECT_EQ(order, (std::vector<Index>{0, 1, 2, 3}));
  const auto positions = grid(5);
  const auto large = order_of(positions, all_of(positions));
  ASSERT_EQ(large.size(), 1024U);
  // A quarter of the numbers for each quarter of the square.
  for (std::size_t i = 0; i < large.size(); ++i) {
    const Vec3 p = positions[large[i]];
    EXPECT_EQ((p.x >= 16.0 ? 1U : 0U) + (p.y >= 16.0 ? 2U : 0U), i / 256) << i;
  }
}

TEST(SpatialOrder, HoldsEachOfTheChosenOnce) {
  meshes::Random random(3);
  std::vector<Vec3> positions;
  for (int i = 0; i < 5000; ++i)
    positions.push_back({random.number(), random.number(), random.number()});
  std::vector<Index> chosen;
  for (Index i = 0; i < 5000; i += 3)
    chosen.push_back(i);
  for (const double shift : {0.0, 0.3}) {
    auto order = order_of(positions, chosen, shift);
    EXPECT_EQ(order, order_of(positions, chosen, shift, 1));
    EXPECT_EQ(order, order_of(positions, chosen, shift, 4));
    std::sort(order.begin(), order.end());
    EXPECT_EQ(order, chosen);
  }
}

TEST(SpatialOrder, KeepsTheOrderWithinACell) {
  const std::vector<Vec3> positions(100, Vec3{1.0, 2.0, 3.0});
  EXPECT_EQ(order_of(positions, all_of(positions)), all_of(positions));
}

}  // namespace
}  // namespace planish
