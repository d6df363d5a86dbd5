#include <cmath>

#include <planish/core/error.h>
#include <planish/sheet/nest_sheet.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

/// 60 x 40 mm in cells of 10 mm; with a hole of 20 x 10 mm.
NestPatch plate_of_kerf(bool has_hole, PatternOptions options) {
  NestPatch patch{"plate", meshes::flat_grid(6, 4), {}, std::move(options)};
  for (const Vec3& p : patch.mesh.positions)
    patch.pattern.push_back({10.0 * p.x, 10.0 * p.y});
  if (!has_hole) return patch;
  std::erase_if(patch.mesh.triangles, [&](const Triangle& t) {
    double x = 0.0, y = 0.0;
    for (const Index v : t) {
      x += patch.pattern[v].x / 3.0;
      y += patch.pattern[v].y / 3.0;
    }
    return x > 20.0 && x < 40.0 && y > 10.0 && y < 20.0;
  });
  return patch;
}

double area_of_cut(const PatternGeometry& pattern) {
  double area = 0.0;
  for (const Polygon& loop : pattern.cut)
    area += signed_area(loop);
  return area;
}

double cut_area(bool has_hole, PatternOptions options) {
  return area_of_cut(pattern_geometry(plate_of_kerf(has_hole, std::move(options)), Unit::mm));
}

// Sides of length P moved by k/2 add P k/2, each square corner that stands out k^2/4; those of a
// hole, which turn in, have k^2/4 too much of it: (20 - k)(10 - k).
TEST(Kerf, AddsHalfOfItTimesThePerimeterAndTheCorners) {
  for (const double kerf : {0.1, 0.2, 1.0, 3.0}) {
    const double outer = 0.5 * kerf * 200.0 + kerf * kerf;
    EXPECT_NEAR(cut_area(false, {.kerf = kerf}), 2400.0 + outer, 1e-3) << kerf;
    const double hole = 0.5 * kerf * 60.0 - kerf * kerf;
    EXPECT_NEAR(cut_area(true, {.kerf = kerf}), 2200.0 + outer + hole, 1e-3) << kerf;
  }
}

TEST(Kerf, JoinsTheAllowanceAndStaysWhereHolesHaveNone) {
  const Allowance wide{.width = 3.0}, outside{.width = 3.0, .holes = false};
  EXPECT_NEAR(cut_area(true, {.allowance = wide, .kerf = 0.4}),
              66.4 * 46.4 - (20.0 - 6.4) * (10.0 - 6.4), 1e-3);
  EXPECT_NEAR(cut_area(true, {.allowance = outside, .kerf = 0.4}),
              66.4 * 46.4 - (20.0 - 0.4) * (10.0 - 0.4), 1e-3);
  EXPECT_NEAR(cut_area(false, {.allowance = wide, .edge_allowances = {{0, 6, 0.0}}, .kerf = 0.4}),
              66.4 * 43.4, 1e-3)
      << "also along an edge without an allowance";
}

TEST(Kerf, IsNotAlongAFold) {
  const double area = cut_area(false, {.kerf = 0.4, .fold = FoldLine{0, 6}});
  EXPECT_NEAR(area, 60.4 * 40.2, 1e-3);
}

TEST(Kerf, ThatIsWiderThanAHoleOrThePieceIsRefused) {
  try {
    cut_area(true, {.kerf = 10.5});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::allowance_too_wide);
    EXPECT_THAT(error.what(),
                testing::HasSubstr("a kerf of 10.5 mm is wider than the hole at vertex"));
  }
  EXPECT_THROW(cut_area(false, {.kerf = 40.0}), Error);
}

}  // namespace
}  // namespace planish
