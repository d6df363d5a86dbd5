#include <planish/core/error.h>
#include <planish/pattern/allowance.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::ElementsAre;

/// 100 x 50 mm.
PieceOutline panel_of_four() {
  return {"panel", {{{0, 0}, {100, 0}, {100, 50}, {0, 50}}}, {{3, 7, 9, 20}}};
}

double area_with(const std::vector<EdgeAllowance>& edges) {
  const PieceOutline outline = panel_of_four();
  const Allowance allowance = with_edge_allowances({.width = 10.0}, outline, edges);
  return signed_area(offset_outline(outline, allowance).at(0));
}

TEST(EdgeAllowances, AreThoseOfTheirStretchAndTheUsualOneElsewhere) {
  EXPECT_NEAR(area_with({}), 120.0 * 70.0, 1e-3);
  EXPECT_NEAR(area_with({{3, 7, 0.0}}), 120.0 * 60.0, 1e-3) << "no allowance below";
  EXPECT_NEAR(area_with({{7, 9, 20.0}}), 130.0 * 70.0, 1e-3) << "more at the right";
  EXPECT_NEAR(area_with({{20, 7, 0.0}}), 110.0 * 60.0, 1e-3) << "past the first point";
  EXPECT_NEAR(area_with({{9, 9, 5.0}}), 110.0 * 60.0, 1e-3) << "all around";
  EXPECT_NEAR(area_with({{3, 3, 0.0}, {7, 9, 10.0}}), 110.0 * 50.0, 1e-3) << "the last one counts";
}

TEST(EdgeAllowances, HaveAWidthForEveryEdge) {
  const Allowance allowance = with_edge_allowances({.width = 10.0}, panel_of_four(),
                                                   std::vector<EdgeAllowance>{{7, 20, 2.5}});
  ASSERT_EQ(allowance.edge_widths.size(), 1U);
  EXPECT_THAT(allowance.edge_widths[0], ElementsAre(10.0, 2.5, 2.5, 10.0));
}

TEST(EdgeAllowances, OffTheBorderAreRefused) {
  try {
    with_edge_allowances({}, panel_of_four(), std::vector<EdgeAllowance>{{3, 8, 1.0}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::misplaced_allowance);
    EXPECT_THAT(error.what(), testing::HasSubstr("piece \"panel\""));
    EXPECT_THAT(error.what(), testing::HasSubstr("from vertex 3 to 8"));
  }
}

}  // namespace
}  // namespace planish
