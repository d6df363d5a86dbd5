#include <planish/core/ways_on.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(WaysOn, AreThereForEveryError) {
  int number = 0;
  for (; to_string(static_cast<ErrorCode>(number)) != "unknown"; ++number) {
    const auto code = static_cast<ErrorCode>(number);
    EXPECT_GT(way_on(code).size(), 9U) << to_string(code);
    EXPECT_LT(way_on(code).size(), 200U) << to_string(code);
    EXPECT_FALSE(way_on(code).ends_with('.')) << to_string(code);
    EXPECT_NE(way_on(code), way_on(static_cast<ErrorCode>(10'000))) << to_string(code);
  }
  EXPECT_GT(number, 30);
}

TEST(WaysOn, StandBehindWhatTheErrorSays) {
  const Error error(ErrorCode::no_inner_vertex, "loose", {.path = "a.obj"});
  EXPECT_EQ(with_way_on(error),
            "a.obj: loose. Join loose triangles with --weld; mesh a piece that is one with several "
            "rows of facets across");
}

}  // namespace
}  // namespace planish
