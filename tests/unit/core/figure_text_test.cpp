#include "core/figure_text.h"

#include <limits>

#include <gtest/gtest.h>

#include "draw/base64.h"
#include "draw/scale_limit.h"

namespace planish {
namespace {

TEST(FigureText, KeepsSoManyDigits) {
  EXPECT_EQ(significant_text(0.063812), "0.0638");
  EXPECT_EQ(significant_text(1.2), "1.20");
  EXPECT_EQ(significant_text(0.09996), "0.100");
  EXPECT_EQ(significant_text(412.34), "412");
  EXPECT_EQ(significant_text(12345.6), "12346");
  EXPECT_EQ(significant_text(0.0), "0");
  EXPECT_EQ(significant_text(-0.25, 2), "−0.25");
}

TEST(FigureText, WritesVerySmallAndLargeAsPowersOfTen) {
  EXPECT_EQ(significant_text(1.234e-7, 2), "1.2\u00A0×\u00A010⁻⁷");
  EXPECT_EQ(significant_text(-5.6e13, 2), "−5.6\u00A0×\u00A010¹³");
  EXPECT_EQ(power_of_ten_text(-4), "10⁻⁴");
}

TEST(FigureText, SaysWhatIsNoNumber) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  EXPECT_EQ(significant_text(std::numeric_limits<double>::quiet_NaN()), "not a number");
  EXPECT_EQ(decimals_text(-infinity, 1), "minus infinite");
  EXPECT_EQ(percent_text(infinity), "infinite");
  EXPECT_EQ(about_text(infinity), "infinite");
}

TEST(FigureText, KeepsZerosAfterThePointWhereAsked) {
  EXPECT_EQ(decimals_text(538.0, 1), "538.0");
  EXPECT_EQ(decimals_text(-0.04, 1), "0.0");
  EXPECT_EQ(decimals_text(-1.26, 1), "−1.3");
}

TEST(FigureText, RoundsRoughFiguresToTwoDigits) {
  EXPECT_EQ(about_text(1170.0), "1200");
  EXPECT_EQ(about_text(273.2), "270");
  EXPECT_EQ(about_text(27.31), "27");
  EXPECT_EQ(about_text(3.44), "3.4");
  EXPECT_EQ(about_text(999.0), "1000");
}

TEST(FigureText, WritesPercentWithTwoDigits) {
  EXPECT_EQ(percent_text(0.0761), "7.6\u00A0%");
  EXPECT_EQ(percent_text(0.32), "32\u00A0%");
  EXPECT_EQ(percent_text(0.0005), "0.050\u00A0%");
  EXPECT_EQ(percent_text(1.234), "123\u00A0%");
  EXPECT_EQ(percent_text(0.0), "0\u00A0%");
  EXPECT_EQ(percent_text(9.9e-7), "under 0.0001\u00A0%");
  EXPECT_EQ(signed_percent_text(0.1), "+10\u00A0%");
  EXPECT_EQ(signed_percent_text(-0.27), "−27\u00A0%");
}

TEST(FigureText, GroupsCountsByThousands) {
  EXPECT_EQ(count_text(7), "7");
  EXPECT_EQ(count_text(999), "999");
  EXPECT_EQ(count_text(1000), "1\u202F000");
  EXPECT_EQ(count_text(1234567), "1\u202F234\u202F567");
}

TEST(FigureText, HasLengthsInMillimetresOrInches) {
  EXPECT_EQ(length_text(0.0264, Unit::m), "26\u00A0mm");
  EXPECT_EQ(length_text(0.35, Unit::cm), "3.5\u00A0mm");
  EXPECT_EQ(length_text(1234.0, Unit::mm), "1234\u00A0mm");
  EXPECT_EQ(length_text(0.352, Unit::in), "0.35\u00A0in");
  EXPECT_EQ(length_text(0.0, Unit::mm), "0\u00A0mm");
}

TEST(FigureText, HasSizesInMillimetresOrInches) {
  EXPECT_EQ(size_text(0.512, 0.79, Unit::m), "512 × 790\u00A0mm");
  EXPECT_EQ(size_text(12.0, 3.456, Unit::in), "12.0 × 3.46\u00A0in");
}

TEST(RoundUp125, GivesTheNextOfOneTwoFive) {
  EXPECT_EQ(round_up_125(0.0011), 0.002);
  EXPECT_EQ(round_up_125(0.002), 0.002);
  EXPECT_EQ(round_up_125(0.0020001), 0.005);
  EXPECT_EQ(round_up_125(51.0), 100.0);
  EXPECT_EQ(round_up_125(100.0), 100.0);
  EXPECT_EQ(round_up_125(0.1 + 0.2 - 0.1), 0.2) << "0.2 but for rounding";
  EXPECT_EQ(round_up_125(3e-200), 5e-200);
}

TEST(Base64, EncodesTheExamplesOfItsStandard) {
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xFF\xFE\xFD"), "//79");
}

}  // namespace
}  // namespace planish
