#include <cmath>
#include <limits>

#include <planish/draw/color.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

double linear(std::uint8_t part) {
  const double share = part / 255.0;
  return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
}

// CIE L*, 0 to 100.
double lightness(Color color) {
  const double y = 0.2126 * linear(color.r) + 0.7152 * linear(color.g) + 0.0722 * linear(color.b);
  return y > 0.008856 ? 116.0 * std::cbrt(y) - 16.0 : 903.3 * y;
}

TEST(DivergingMap, GetsDarkerWithEveryStepAwayFromTheMiddle) {
  for (int i = 1; i <= 50; ++i) {
    for (const double side : {-1.0, 1.0}) {
      const double inner = lightness(color_at(ColorMap::diverging, side * (i - 1) / 50.0));
      const double outer = lightness(color_at(ColorMap::diverging, side * i / 50.0));
      EXPECT_LT(outer, inner) << side * i / 50.0;
      EXPECT_NEAR(inner - outer, 61.0 / 50.0, 0.5) << "steps are even, at " << side * i / 50.0;
    }
  }
}

TEST(DivergingMap, IsAsLightOnOneSideAsOnTheOther) {
  for (int i = 0; i <= 100; ++i) {
    const double below = lightness(color_at(ColorMap::diverging, -i / 100.0));
    const double above = lightness(color_at(ColorMap::diverging, i / 100.0));
    EXPECT_NEAR(below, above, 0.02 * above) << i;
  }
}

TEST(DivergingMap, IsBlueBelowWhiteInTheMiddleAndRedAbove) {
  const Color low = color_at(ColorMap::diverging, -1.0);
  const Color middle = color_at(ColorMap::diverging, 0.0);
  const Color high = color_at(ColorMap::diverging, 1.0);
  EXPECT_GT(low.b, low.r + 100);
  EXPECT_GT(high.r, high.b + 100);
  EXPECT_EQ(middle.r, middle.g);
  EXPECT_EQ(middle.g, middle.b);
  EXPECT_GT(middle.r, 240);
}

TEST(SequentialMap, GetsDarkerInEvenSteps) {
  for (int i = 1; i <= 50; ++i) {
    const double less = lightness(color_at(ColorMap::sequential, (i - 1) / 50.0));
    const double more = lightness(color_at(ColorMap::sequential, i / 50.0));
    EXPECT_NEAR(less - more, 73.0 / 50.0, 0.5) << i;
  }
}

TEST(PaleMap, GetsDarkerButLeavesRoomForDarkLines) {
  for (int i = 1; i <= 20; ++i) {
    const double less = lightness(color_at(ColorMap::pale, (i - 1) / 20.0));
    const double more = lightness(color_at(ColorMap::pale, i / 20.0));
    EXPECT_LT(more, less - 0.5) << i;
  }
  EXPECT_GT(lightness(color_at(ColorMap::pale, 1.0)), 58.0);
}

TEST(PaperMap, GoesFromBlueOverCyanGreenAndYellowToRed) {
  EXPECT_EQ(color_at(ColorMap::paper, 0.0), (Color{0, 0, 255}));
  EXPECT_EQ(color_at(ColorMap::paper, 0.25), (Color{0, 255, 255}));
  EXPECT_EQ(color_at(ColorMap::paper, 0.5), (Color{0, 255, 0}));
  EXPECT_EQ(color_at(ColorMap::paper, 0.75), (Color{255, 255, 0}));
  EXPECT_EQ(color_at(ColorMap::paper, 1.0), (Color{255, 0, 0}));
  EXPECT_EQ(color_at(ColorMap::paper, 0.125), (Color{0, 128, 255}));
}

TEST(ColorMaps, ClampWhatLiesBeyondAndShowWhatIsNoNumberGrey) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const ColorMap map : {ColorMap::diverging, ColorMap::paper}) {
    EXPECT_EQ(color_at(map, infinity), color_at(map, 1.0));
    EXPECT_EQ(color_at(map, 7.0), color_at(map, 1.0));
    const Color grey = color_at(map, std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(grey.r, grey.g);
    EXPECT_EQ(grey.g, grey.b);
    EXPECT_LT(grey.r, 200) << "not to be taken for the white of 0";
  }
  EXPECT_EQ(color_at(ColorMap::diverging, -infinity), color_at(ColorMap::diverging, -1.0));
  EXPECT_EQ(color_at(ColorMap::paper, -1.0), color_at(ColorMap::paper, 0.0));
}

}  // namespace
}  // namespace planish
