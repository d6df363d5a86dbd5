#include "unfold/strain/free_edges.h"

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(FreeEdgesSet, HasEdgesInEitherOrder) {
  const std::vector<std::array<Index, 2>> edges = {{7, 3}, {1, 2}};
  const FreeEdges free(edges);
  EXPECT_TRUE(free.has(3, 7));
  EXPECT_TRUE(free.has(7, 3));
  EXPECT_TRUE(free.has(2, 1));
  EXPECT_FALSE(free.has(1, 3));
  EXPECT_FALSE(free.has(7, 7));
}

TEST(RenumberedEdges, HaveTheNumbersOfTheVerticesThatAreLeft) {
  const std::vector<std::array<Index, 2>> edges = {{2, 9}, {9, 4}};
  const std::vector<Index> source = {0, 2, 4, 7, 9};
  const std::vector<std::array<Index, 2>> expected = {{1, 4}, {4, 2}};
  EXPECT_EQ(renumbered_edges(edges, source), expected);
}

}  // namespace
}  // namespace planish
