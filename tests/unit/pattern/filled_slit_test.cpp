#include "pattern/filled_slit.h"

#include <numbers>

#include <planish/pattern/allowance.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

/// 200 by 100 with a slit of a width, 80 deep, from the middle of the lower side.
PieceOutline slit_plate(double slit_width) {
  const double left = 100.0 - slit_width / 2.0, right = 100.0 + slit_width / 2.0;
  return {"plate",
          {{{0, 0},
            {left, 0},
            {left, 40},
            {left, 80},
            {right, 80},
            {right, 40},
            {right, 0},
            {200, 0},
            {200, 100},
            {0, 100}}}};
}

std::vector<OutlineStretch> filled_of(const PieceOutline& outline, double width) {
  return filled_slits(outline.loops, offset_outline(outline, {.width = width}), width);
}

double filled(const PieceOutline& outline, double width) {
  double length = 0.0;
  for (const OutlineStretch& stretch : filled_of(outline, width))
    length += stretch.length;
  return length;
}

TEST(FilledSlit, HasTheLengthOfTheEdgesWithoutACutLine) {
  // Both sides from 40 on, 50 from the cut line, and the end, 30 from it.
  EXPECT_DOUBLE_EQ(filled(slit_plate(5.0), 10.0), 40.0 + 5.0 + 40.0);
}

TEST(FilledSlit, IsOneStretchWithTheTipInItsMiddle) {
  const auto stretches = filled_of(slit_plate(5.0), 10.0);
  ASSERT_EQ(stretches.size(), 1U);
  EXPECT_EQ(stretches[0].middle, 4U);
}

TEST(FilledSlit, IsNoneWhereTheSlitStaysOpen) {
  EXPECT_EQ(filled(slit_plate(25.0), 10.0), 0.0);
  EXPECT_EQ(filled(slit_plate(5.0), 2.0), 0.0);
}

TEST(FilledSlit, IsNoneBesideABayOf60Degrees) {
  const double half = 50.0 / std::numbers::sqrt3;
  const PieceOutline bay = {
      "bay",
      {{{0, 0}, {100 - half, 0}, {100, 50}, {100 + half, 0}, {200, 0}, {200, 100}, {0, 100}}}};
  EXPECT_EQ(filled(bay, 10.0), 0.0);
}

}  // namespace
}  // namespace planish
