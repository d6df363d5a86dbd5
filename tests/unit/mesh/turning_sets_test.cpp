#include "mesh/turning_sets.h"

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(TurningSets, KnowWhatMustBeTurned) {
  TurningSets sets(6);
  EXPECT_TRUE(sets.join(4, 5, 1));
  EXPECT_TRUE(sets.join(3, 4, 1));
  EXPECT_TRUE(sets.join(1, 3, 0));
  EXPECT_EQ(sets.first_of(5).number, 1U);
  EXPECT_EQ(sets.first_of(5).turned, 0);
  EXPECT_EQ(sets.first_of(4).turned, 1);
  EXPECT_EQ(sets.first_of(0).number, 0U);
}

TEST(TurningSets, TellAContradiction) {
  TurningSets sets(3);
  EXPECT_TRUE(sets.join(0, 1, 1));
  EXPECT_TRUE(sets.join(1, 2, 1));
  EXPECT_TRUE(sets.join(0, 2, 0));
  EXPECT_FALSE(sets.join(2, 0, 1));
}

}  // namespace
}  // namespace planish
