#include "pattern/allowance/filled_slit.h"

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
  EXPECT_DOUBLE_EQ(filled(slit_plate(5.0), 10.0), 80.0 + 5.0 + 80.0);
}

TEST(FilledSlit, IsTheWholeOfAShortCutWithoutAGap) {
  const PieceOutline plate = {
      "plate", {{{0, 0}, {100, 0}, {100, 20}, {100, 0}, {200, 0}, {200, 100}, {0, 100}}}};
  EXPECT_DOUBLE_EQ(filled(plate, 15.0), 40.0);
  EXPECT_DOUBLE_EQ(filled(plate, 20.0), 40.0);
}

TEST(FilledSlit, IsTheCutThatOpensAFrameWhateverItsWidth) {
  // 300 by 200 and 30 wide, cut open at the lower left corner of its inner border.
  const PieceOutline frame = {"frame",
                              {{{0, 0},
                                {300, 0},
                                {300, 200},
                                {0, 200},
                                {0, 30},
                                {30, 30},
                                {30, 170},
                                {270, 170},
                                {270, 30},
                                {30, 30},
                                {0, 30}}}};
  for (const double width : {5.0, 10.0, 15.0})
    EXPECT_DOUBLE_EQ(filled(frame, width), 60.0) << width;
}

TEST(FilledSlit, OfADartIsAsFarAsItsSidesAreNearerThanBothAllowances) {
  // 100 deep and 20 wide at the mouth.
  const PieceOutline dart = {
      "dart", {{{0, 0}, {90, 0}, {100, 100}, {110, 0}, {200, 0}, {200, 150}, {0, 150}}}};
  // Allowances of 3 meet 30.15 above the tip, and cut lines begin there.
  EXPECT_NEAR(filled(dart, 3.0), 2.0 * 30.0, 2.0);
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
