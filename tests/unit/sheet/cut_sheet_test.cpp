#include "sheet/cut_sheet.h"

#include <algorithm>
#include <variant>

#include <planish/mesh/shapes.h>
#include <planish/sheet/pattern_sheet.h>

#include <gtest/gtest.h>

#include "unit/sheet/layers.h"

namespace planish {
namespace {

TEST(CutSheet, DrawsEveryDartOnThePatternWithoutThem) {
  const TriMesh dome = make_shape("dome", 500);
  const auto suggestion = suggest_cuts(Patch(dome), {.limits = {.max = 0.001}, .max_darts = 2});
  ASSERT_EQ(suggestion.cuts.size(), 2U);
  const Drawing sheet = cut_sheet(suggestion, Unit::cm, "dome");
  EXPECT_EQ(sheet.layers.size(), k_sheet_layers.size() + 1);
  const Layer& darts = layer_of(sheet, "suggested");
  ASSERT_EQ(darts.shapes.size(), 4U);  // a line and a number each
  const auto& outline = std::get<Path>(layer_of(sheet, "cut").shapes.front());
  for (std::size_t k = 0; k < 2; ++k) {
    const auto& dart = std::get<Path>(darts.shapes[2 * k]);
    ASSERT_EQ(dart.lines.size(), 1U);
    EXPECT_EQ(dart.lines[0].size(), suggestion.cuts[k].path.size());
    EXPECT_NE(dart.stroke->color.r, outline.stroke->color.r);
    EXPECT_EQ(std::get<Text>(darts.shapes[2 * k + 1]).text, std::to_string(k + 1));
  }
  // The first begins on the outline.
  const auto& line = std::get<Path>(darts.shapes[0]).lines[0];
  const auto is_on_outline = [&](Vec2 p) {
    return std::any_of(outline.lines[0].begin(), outline.lines[0].end(),
                       [&](Vec2 q) { return norm(p - q) < 1e-9; });
  };
  EXPECT_TRUE(is_on_outline(line.front()) || is_on_outline(line.back()));
  EXPECT_FALSE(is_on_outline(line.front()) && is_on_outline(line.back()));
}

}  // namespace
}  // namespace planish
