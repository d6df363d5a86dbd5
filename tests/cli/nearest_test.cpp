#include "shell/nearest.h"

#include <vector>

#include <gtest/gtest.h>

namespace planish::cli {
namespace {

TEST(EditDistance, CountsInsertionsRemovalsChangesAndSwaps) {
  EXPECT_EQ(edit_distance("sweeps", "sweeps"), 0U);
  EXPECT_EQ(edit_distance("sweps", "sweeps"), 1U);
  EXPECT_EQ(edit_distance("sweeeps", "sweeps"), 1U);
  EXPECT_EQ(edit_distance("sweebs", "sweeps"), 1U);
  EXPECT_EQ(edit_distance("sweesp", "sweeps"), 1U);
  EXPECT_EQ(edit_distance("SWEEPS", "sweeps"), 0U);
  EXPECT_EQ(edit_distance("", "abc"), 3U);
  EXPECT_EQ(edit_distance("abc", ""), 3U);
}

TEST(NearestHint, AsksAboutNearWordsOnly) {
  const std::vector<std::string> known = {"--sweeps", "--max-deviation", "--unit"};
  EXPECT_EQ(nearest_hint("--sweps", known), "; did you mean --sweeps?");
  EXPECT_EQ(nearest_hint("--max-dev", known), "; did you mean --max-deviation?");
  EXPECT_EQ(nearest_hint("--foo", known), "");
  EXPECT_EQ(nearest_hint("--Unit", known), "; did you mean --unit?");
  EXPECT_EQ(nearest_hint("--seam-allowance", std::vector<std::string>{"--seam-tolerance"}), "");
  EXPECT_EQ(nearest_hint("--thickness", std::vector<std::string>{"--fairness"}), "");
  EXPECT_EQ(nearest_hint("--scale", std::vector<std::string>{"--size"}), "");
  EXPECT_EQ(nearest_hint("k", std::vector<std::string>{"m", "mm"}), "");
  EXPECT_EQ(nearest_hint("--foo", {}), "");
}

}  // namespace
}  // namespace planish::cli
