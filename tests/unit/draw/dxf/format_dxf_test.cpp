#include <limits>
#include <string>
#include <vector>

#include <planish/core/error.h>
#include <planish/draw/format_drawing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "draw/dxf/dxf_tags.h"
#include "unit/draw/dxf/read_dxf.h"

namespace planish {
namespace {

using testing::Each;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

constexpr Color k_red = {255, 0, 0}, k_blue = {10, 0, 240};

Path triangle(Color color) {
  return {{{{0, 0}, {10, 0}, {10, 5.01249}, {0, 0}}}, true, Stroke{color}};
}

Drawing sheet() {
  Path open = triangle(k_blue);
  open.closed = false;
  open.stroke->dashed = true;
  return {"sheet",
          100.0,
          50.0,
          {Layer{"cut", {triangle(k_red), open}}, Layer{"my notes", {triangle(k_blue)}, false},
           Layer{"label", {Text{{1.0, 2.0}, 3.0, "Ab", k_blue, true}}}}};
}

TEST(WriteDxf, BeginsWithVersionUnitsAndExtents) {
  const std::string dxf = format_dxf(sheet());
  EXPECT_THAT(dxf, HasSubstr("$ACADVER\n1\nAC1009\n"));
  EXPECT_THAT(dxf, HasSubstr("$INSUNITS\n70\n4\n"));
  EXPECT_THAT(dxf, HasSubstr("$EXTMIN\n10\n0.0\n20\n0.0\n"));
  EXPECT_THAT(dxf, HasSubstr("$EXTMAX\n10\n10.0\n20\n5.012\n"));
  EXPECT_THAT(dxf, HasSubstr("$LIMMAX\n10\n100.0\n20\n50.0\n"));
  EXPECT_TRUE(dxf.ends_with("0\nENDSEC\n0\nEOF\n"));
}

TEST(WriteDxf, DrawsOutlinesWithFewPointsWhereTheseWereFitted) {
  Path path = triangle(k_red);
  path.fitted.few = {{{0, 0}, {10, 0}, {10, 5}}};
  const std::string dxf = format_dxf({"t", 20.0, 20.0, {Layer{"cut", {path}}}});
  EXPECT_THAT(values(all_of_kind(dxf, "VERTEX"), 20), ElementsAre("0.0", "0.0", "5.0"));
}

TEST(WriteDxf, WritesOldPolylinesThatAreClosedWhereTheLinesAre) {
  const std::string dxf = format_dxf(sheet());
  const auto lines = all_of_kind(dxf, "POLYLINE");
  EXPECT_THAT(values(lines, 70), ElementsAre("1", "0", "1"));
  EXPECT_THAT(values(lines, 66), Each("1")) << "vertices follow";
  EXPECT_THAT(values(lines, 8), ElementsAre("cut", "cut", "my_notes"));
  EXPECT_THAT(values(lines, 6), ElementsAre("", "DASHED", ""));
  EXPECT_THAT(values(lines, 62), ElementsAre("", "5", "")) << "unlike the layer's only";
  EXPECT_EQ(all_of_kind(dxf, "VERTEX").size(), 3U + 4U + 3U) << "closed: the first once only";
  EXPECT_EQ(all_of_kind(dxf, "SEQEND").size(), 3U);
  EXPECT_THAT(dxf, Not(HasSubstr("LWPOLYLINE")));
}

TEST(WriteDxf, ListsTheLayersThatAreUsedHiddenOnesNegative) {
  Drawing drawing = sheet();
  Path area = triangle(k_red);
  area.stroke.reset();
  area.fill = k_red;
  drawing.layers.push_back({"strain", {area}});
  const auto layers = all_of_kind(format_dxf(drawing), "LAYER");
  EXPECT_THAT(values(layers, 2), ElementsAre("0", "cut", "my_notes", "label"));
  EXPECT_THAT(values(layers, 62), ElementsAre("7", "1", "-5", "5"));
}

TEST(WriteDxf, SetsTextOrDrawsIt) {
  const auto texts = all_of_kind(format_dxf(sheet()), "TEXT");
  ASSERT_EQ(texts.size(), 1U);
  EXPECT_EQ(value_of(texts[0], 1), "Ab");
  EXPECT_EQ(value_of(texts[0], 40), "3.0");
  EXPECT_EQ(value_of(texts[0], 72), "1");
  EXPECT_EQ(value_of(texts[0], 11), "1.0");
  const std::string drawn = format_dxf(sheet(), {.stroked_text = true});
  EXPECT_TRUE(all_of_kind(drawn, "TEXT").empty());
  EXPECT_EQ(all_of_kind(drawn, "POLYLINE").size(), 3U + 2U + 2U) << "A and b have two lines each";
}

TEST(DxfText, IsAsciiWithoutMeaningsOfItsOwn) {
  EXPECT_EQ(dxf_text("0.1 % ± é 😀"), "0.1 % \\U+00B1 \\U+00E9 \\U+D83D\\U+DE00");
  EXPECT_EQ(dxf_text("%%d \\U+0041 ^J\n"), "\\U+0025\\U+0025d \\U+005CU+0041 \\U+005EJ ");
}

TEST(DxfName, KeepsWhatR12Allows) {
  EXPECT_EQ(dxf_name("cut_1-A$"), "cut_1-A$");
  EXPECT_EQ(dxf_name("ä b,"), "__b_");
  EXPECT_EQ(dxf_name(""), "_");
  EXPECT_EQ(dxf_name(std::string(40, 'x')).size(), 31U);
}

TEST(WriteDxf, RenamesLayersAndJoinsThoseOfOneName) {
  const std::string dxf =
      format_dxf(sheet(), {.layer_names = {{"cut", "LASER"}, {"my notes", "LASER"}}});
  EXPECT_THAT(values(all_of_kind(dxf, "LAYER"), 2), ElementsAre("0", "LASER", "label"));
  EXPECT_THAT(values(all_of_kind(dxf, "LAYER"), 62), ElementsAre("7", "1", "5")) << "one shows";
}

TEST(WriteDxf, RefusesToRenameALayerThatIsNotThere) {
  try {
    format_dxf(sheet(), {.layer_names = {{"cutt", "LASER"}}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::unknown_name);
    EXPECT_THAT(error.what(), HasSubstr("'cutt'; there are cut, my notes, label"));
  }
}

TEST(DxfProfiles, AreKnownByTheirNames) {
  for (const DxfProfile profile : k_dxf_profiles)
    EXPECT_EQ(dxf_profile_named(to_string(profile)), profile);
  EXPECT_THROW(dxf_profile_named("autocad"), Error);
}

TEST(WriteDxf, LeavesOutPointsThatAreNowhereAndLinesOfOne) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const Drawing drawing = {
      "t",
      1.0,
      1.0,
      {Layer{"cut",
             {Path{{{{1, 1}, {nan, 2}}, {}}, true, Stroke{}}, Text{{nan, 0.0}, 3.0, "lost"}}}}};
  const std::string dxf = format_dxf(drawing);
  EXPECT_TRUE(all_of_kind(dxf, "POLYLINE").empty());
  EXPECT_THAT(dxf, Not(HasSubstr("nan")));
  EXPECT_THAT(dxf, Not(HasSubstr("lost")));
}

TEST(WriteDxf, GivesTheSameBytesForTheSameDrawing) {
  EXPECT_EQ(format_dxf(sheet()), format_dxf(sheet()));
}

}  // namespace
}  // namespace planish
