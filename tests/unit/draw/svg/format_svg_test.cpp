#include <cmath>
#include <cstdlib>
#include <limits>
#include <string>
#include <vector>

#include <planish/draw/format_drawing.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/sheets.h"

namespace planish {
namespace {

using testing::HasSubstr;
using testing::Not;

// The subpaths of the first path, read as SVG defines M, l and z; y turned up again.
std::vector<std::vector<Vec2>> read_path(const std::string& svg, double height) {
  std::size_t at = svg.find("<path d=\"") + 9;
  const std::size_t end = svg.find('"', at);
  std::vector<std::vector<Vec2>> lines;
  Vec2 pen;
  bool relative = false;
  while (at < end) {
    const char c = svg[at];
    if (c == 'M' || c == 'l') {
      relative = c == 'l';
      if (c == 'M') lines.emplace_back();
      ++at;
    } else if (c == 'z' || c == ' ' || c == ',') {
      ++at;
    } else {
      char* next = nullptr;
      const double x = std::strtod(svg.c_str() + at, &next);
      const double y = std::strtod(next + 1, &next);
      pen = relative ? pen + Vec2{x, y} : Vec2{x, y};
      lines.back().push_back({pen.x, height - pen.y});
      at = static_cast<std::size_t>(next - svg.c_str());
    }
  }
  return lines;
}

TEST(WriteSvg, HasTheSheetsSizeInMillimetresAndOneUnitAMillimetre) {
  const std::string svg = format_svg({"t", 412.25, 538.0, {}});
  EXPECT_THAT(svg, HasSubstr("width=\"412.25mm\" height=\"538mm\" viewBox=\"0 0 412.25 538\""));
  EXPECT_TRUE(svg.starts_with("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<svg "));
  EXPECT_TRUE(svg.ends_with("</svg>\n"));
}

TEST(WriteSvg, MakesEachLayerAGroupThatInkscapeShowsAsALayer) {
  const std::string svg =
      format_svg({"t", 1.0, 1.0, {Layer{"strain", {}}, Layer{"notes", {}, false}}});
  EXPECT_THAT(
      svg, HasSubstr("<g id=\"strain\" inkscape:groupmode=\"layer\" inkscape:label=\"strain\">"));
  EXPECT_THAT(svg, HasSubstr("inkscape:label=\"notes\" style=\"display:none\">"));
  EXPECT_LT(svg.find("strain"), svg.find("notes")) << "drawn in order";
}

TEST(WriteSvg, KeepsEveryPointToAThousandthOfAMillimetreWithoutDrift) {
  Path path;
  path.lines.resize(2);
  for (int i = 0; i < 2000; ++i) {
    const double angle = 0.01 * i;
    path.lines[0].push_back({100.0 + 0.03 * i * std::cos(angle), 150.0 + 90.0 * std::sin(angle)});
    path.lines[1].push_back({i / 10.0, i / 7.0});
  }
  const auto read = read_path(format_svg(sheet_with(path)), 297.0);
  ASSERT_EQ(read.size(), 2U);
  for (std::size_t line = 0; line < 2; ++line) {
    ASSERT_EQ(read[line].size(), path.lines[line].size());
    for (std::size_t i = 0; i < read[line].size(); ++i) {
      EXPECT_NEAR(read[line][i].x, path.lines[line][i].x, 0.000501);
      EXPECT_NEAR(read[line][i].y, path.lines[line][i].y, 0.000501);
    }
  }
}

TEST(WriteSvg, CountsYDownwards) {
  const std::string svg = format_svg(sheet_with(Path{{{{10.0, 20.0}, {10.0, 30.5}}}}));
  EXPECT_THAT(svg, HasSubstr("d=\"M10,277l0,-10.5\""));
}

TEST(WriteSvg, ClosesFillsStrokesAndDashesAsAsked) {
  const std::vector<std::vector<Vec2>> lines = {{{1, 1}, {2, 1}, {2, 2}}, {{3, 3}, {4, 3}, {4, 4}}};
  const std::string filled = format_svg(sheet_with(Path{lines, true, {}, Color{1, 171, 255}}));
  EXPECT_THAT(filled, HasSubstr("z\" fill=\"#01abff\" fill-rule=\"evenodd\"/>"));
  const std::string dashed =
      format_svg(sheet_with(Path{lines, false, Stroke{{255, 0, 0}, 0.25, true}}));
  EXPECT_THAT(dashed, HasSubstr("fill=\"none\" stroke=\"#ff0000\" stroke-width=\"0.25\""));
  EXPECT_THAT(dashed, HasSubstr("stroke-dasharray=\"3 1.5\""));
  EXPECT_THAT(dashed, Not(HasSubstr("z\"")));
}

TEST(WriteSvg, SetsTextByTheHeightOfItsCapitals) {
  const std::string svg = format_svg(sheet_with(Text{{5.0, 7.0}, 3.6, "Ab", {}, true}));
  EXPECT_THAT(svg, HasSubstr("<text x=\"5\" y=\"290\" font-family=\"sans-serif\" font-size=\"5\" "
                             "fill=\"#000000\" text-anchor=\"middle\">Ab</text>"));
}

TEST(WriteSvg, EscapesTitleLayerNamesAndText) {
  const std::string evil = "<script>\"&\x01\xFF";
  const std::string svg =
      format_svg({evil, 1.0, 1.0, {Layer{evil, {Text{{0.0, 0.0}, 1.0, evil}}}}});
  EXPECT_THAT(svg, Not(HasSubstr("<script")));
  const std::string escaped = "&lt;script&gt;&quot;&amp;\uFFFD\uFFFD";
  EXPECT_THAT(svg, HasSubstr("<title>" + escaped + "</title>"));
  EXPECT_THAT(svg, HasSubstr("id=\"" + escaped + "\""));
  EXPECT_THAT(svg, HasSubstr(">" + escaped + "</text>"));
}

TEST(WriteSvg, LeavesOutPointsThatAreNowhere) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  Drawing drawing = sheet_with(Path{{{{1, 297}, {nan, 2}, {3, infinity}, {4, 297}}}});
  drawing.layers[0].shapes.emplace_back(Text{{nan, 0.0}, 3.0, "lost"});
  const std::string svg = format_svg(drawing);
  EXPECT_THAT(svg, HasSubstr("d=\"M1,0l3,0\""));
  EXPECT_THAT(svg, Not(HasSubstr("nan")));
  EXPECT_THAT(svg, Not(HasSubstr("inf")));
  EXPECT_THAT(svg, Not(HasSubstr("lost")));
}

TEST(WriteSvg, GivesTheSameBytesForTheSameDrawing) {
  const Drawing drawing = sheet_with(Path{{{{1.23456, 2}, {3, 4}}}, true, Stroke{}});
  EXPECT_EQ(format_svg(drawing), format_svg(Drawing(drawing)));
}

}  // namespace
}  // namespace planish
