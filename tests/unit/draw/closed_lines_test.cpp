// What is closed in a drawing is so in every format, on whatever layer, and nothing else is.

#include <string>

#include <planish/draw/format_drawing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracle/drawn_lines.h"

namespace planish {
namespace {

using testing::HasSubstr;
using testing::Not;

Drawing with_line(bool closed, FittedLines fitted = {}) {
  Path path{{{{0, 0}, {30, 0}, {30, 20}, {0, 20}}}, closed, Stroke{}};
  path.fitted = std::move(fitted);
  return {"t", 50.0, 50.0, {Layer{"internal", {path}}}};
}

/// Two cubics around a lens, which is one run without a corner but at its start.
FittedLines round_curve() {
  return {
      {},
      {{{0, 0}, {CubicTo{{20, -20}, {40, -10}, {40, 10}}, CubicTo{{40, 30}, {-20, 20}, {0, 0}}}}}};
}

std::string entity_flags(const Drawing& drawing, DxfVersion version) {
  const std::string dxf = format_dxf(drawing, {.version = version});
  std::string flags, entity;
  for (const auto& [code, value] : oracle::tags_of_dxf(dxf)) {
    if (code == 0) entity = value;
    if (code == 70 && (entity == "POLYLINE" || entity == "LWPOLYLINE" || entity == "SPLINE"))
      flags += entity + " " + std::string(value) + "\n";
  }
  return flags;
}

TEST(ClosedLines, AreClosedInEveryFormat) {
  EXPECT_THAT(format_svg(with_line(true)), HasSubstr("z\""));
  EXPECT_THAT(format_pdf(with_line(true)), HasSubstr("\nh\nS\n"));
  EXPECT_EQ(entity_flags(with_line(true), DxfVersion::r12), "POLYLINE 1\n");
  EXPECT_EQ(entity_flags(with_line(true), DxfVersion::r2000), "LWPOLYLINE 1\n");
  const auto drawn = oracle::lines_of_plt(format_plt(with_line(true)));
  ASSERT_EQ(drawn.size(), 1U);
  EXPECT_EQ(drawn[0].size(), 5U);
  EXPECT_EQ(drawn[0].front(), drawn[0].back());
}

TEST(ClosedLines, AreNoneThatAreOpen) {
  EXPECT_THAT(format_svg(with_line(false)), Not(HasSubstr("z\"")));
  EXPECT_THAT(format_pdf(with_line(false)), Not(HasSubstr("\nh\n")));
  EXPECT_EQ(entity_flags(with_line(false), DxfVersion::r12), "POLYLINE 0\n");
  EXPECT_EQ(entity_flags(with_line(false), DxfVersion::r2000), "LWPOLYLINE 0\n");
  EXPECT_EQ(oracle::lines_of_plt(format_plt(with_line(false)))[0].size(), 4U);
}

TEST(ClosedLines, OfCurvesAreSoToo) {
  EXPECT_THAT(format_svg(with_line(true, round_curve())), HasSubstr("z\""));
  EXPECT_THAT(format_pdf(with_line(true, round_curve())), HasSubstr("c\nh\nS\n"));
  EXPECT_EQ(entity_flags(with_line(true, round_curve()), DxfVersion::r2000), "SPLINE 9\n");
  EXPECT_THAT(format_svg(with_line(false, round_curve())), Not(HasSubstr("z\"")));
  EXPECT_THAT(format_pdf(with_line(false, round_curve())), Not(HasSubstr("\nh\n")));
  EXPECT_EQ(entity_flags(with_line(false, round_curve()), DxfVersion::r2000), "SPLINE 8\n");
}

}  // namespace
}  // namespace planish
