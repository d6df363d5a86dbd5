#include "report/charts/defect_histogram.h"

#include <array>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/page.h"

namespace planish {
namespace {

using pages::count;
using testing::HasSubstr;

TEST(DefectHistogram, HasABarForEveryHalfDecadeThatIsThere) {
  // Before: in [1e-2, 10^-1.5) twice and in [10^-1.5, 1e-1) once; after: zero counts to the lowest.
  const std::string svg = defect_histogram(std::array{0.012, -0.02, 0.05}, std::array{1e-7, 0.0});
  EXPECT_EQ(count(svg, "<rect class=\"bar-before\""), 3U) << "two, and the key";
  EXPECT_EQ(count(svg, "<rect class=\"bar-after\""), 3U);
  EXPECT_EQ(count(svg, "class=\"bound\""), 1U);
  EXPECT_THAT(svg, HasSubstr(">10⁻⁴</text>"));
  EXPECT_THAT(svg, testing::Not(HasSubstr("nan")));
}

TEST(DefectHistogram, HeightsAreShares) {
  const std::string svg =
      defect_histogram(std::vector<double>(4, 0.2), std::array{0.2, 0.2, 2e-6, 2e-6});
  // The tallest bar is as tall as the chart, one of half the places half of it.
  EXPECT_THAT(svg, HasSubstr("height=\"246\""));
  EXPECT_EQ(count(svg, "height=\"123\""), 2U);
}

TEST(DefectHistogram, IsNothingWithoutPlaces) {
  EXPECT_EQ(defect_histogram({}, {}), "");
}

}  // namespace
}  // namespace planish
