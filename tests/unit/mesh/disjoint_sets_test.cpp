#include "mesh/disjoint_sets.h"

#include <numeric>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

TEST(DisjointSets, AreKnownByTheirSmallestNumber) {
  DisjointSets<std::size_t> sets(6);
  sets.join(4, 5);
  sets.join(5, 2);
  sets.join(2, 4);
  EXPECT_EQ(sets.first_of(5), 2U);
  EXPECT_EQ(sets.first_of(4), 2U);
  EXPECT_EQ(sets.first_of(0), 0U);
  sets.join(0, 5);
  EXPECT_EQ(sets.first_of(4), 0U);
  EXPECT_EQ(sets.first_of(3), 3U);
}

TEST(DisjointSets, AgreeWithLabelsThatAreRewritten) {
  meshes::Random random(7);
  constexpr std::size_t count = 60;
  DisjointSets<Index> sets(count);
  std::vector<Index> label(count);
  std::iota(label.begin(), label.end(), Index{0});
  for (int step = 0; step < 80; ++step) {
    const auto any = [&] { return static_cast<Index>(0.5 * count * (random.number() + 1.0)); };
    const Index a = any(), b = any();
    sets.join(a, b);
    const auto [low, high] = std::minmax({label[a], label[b]});
    std::replace(label.begin(), label.end(), Index{high}, Index{low});
    for (Index v = 0; v < count; ++v)
      ASSERT_EQ(sets.first_of(v), label[v]);
  }
}

}  // namespace
}  // namespace planish
