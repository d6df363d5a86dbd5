#include "report/page/candidate_tiles.h"

#include <string>

#include <planish/mesh/shapes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/page.h"

namespace planish {
namespace {

using pages::count;
using testing::HasSubstr;
using testing::Not;

const Patch& panel() {
  static const Patch patch(make_shape("panel", 300));
  return patch;
}

TEST(CandidateTiles, AreTheDesignAndTheResult) {
  const FlattenReport report = flatten(panel(), "panel", preset_options(5, {.unit = Unit::cm}));
  const std::string html = candidate_tiles(report);
  pages::expect_closed_tags(html);
  EXPECT_EQ(count(html, "<li"), 2U);
  EXPECT_EQ(count(html, "class=\"chosen\""), 1U);
  EXPECT_LT(html.find("The design as it is<small>as-designed.*"),
            html.find("Changed<small>the result, pattern.*"));
  EXPECT_THAT(html, HasSubstr("Nothing moved."));
  EXPECT_THAT(html, HasSubstr("\u00A0mm at most"));
  EXPECT_EQ(count(html, "outline of the pattern\""), 2U);
}

TEST(CandidateTiles, AreOneWhereTheMaterialTakesTheDesign) {
  const std::string html = candidate_tiles(flatten(panel(), "panel", {.limits = {.max = 0.5}}));
  EXPECT_EQ(count(html, "<li"), 1U);
  EXPECT_THAT(html, HasSubstr("The design as it is<small>the result, pattern.*"));
}

TEST(CandidateTiles, SayWhereALimitIsMissed) {
  const double strain = unfold_patch(panel(), Unit::mm).strain.rms;
  const std::string html =
      candidate_tiles(flatten(panel(), "panel", {.limits = {.rms = 0.5 * strain}}));
  EXPECT_EQ(count(html, "It does not keep the limit"), 1U) << "the design";
  EXPECT_THAT(html.substr(html.find("chosen")), Not(HasSubstr("It does not keep the limit")));
}

}  // namespace
}  // namespace planish
