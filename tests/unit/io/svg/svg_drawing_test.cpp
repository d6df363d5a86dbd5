#include "io/svg/svg_drawing.h"

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include <planish/core/error.h>

#include <gmock/gmock.h>

namespace planish {
namespace {

using testing::HasSubstr;

constexpr std::array<std::string_view, 2> k_layers = {"cut", "label"};

/// In a sheet of 200 x 100 mm with a unit of 1 mm.
std::string sheet(const std::string& content) {
  return "<?xml version=\"1.0\"?>\n<!-- a sheet -->\n"
         "<svg width=\"200mm\" height=\"100mm\" viewBox=\"0 0 200 100\">\n" +
         content + "\n</svg>\n";
}

SvgDrawing drawing(const std::string& bytes) {
  return parse_svg(bytes, "a.svg", k_layers);
}

std::vector<std::vector<Vec2>> lines(const std::string& content) {
  std::vector<std::vector<Vec2>> lines;
  for (const SvgLine& line : drawing(sheet(content)).lines)
    lines.push_back(line.points);
  return lines;
}

void expect_near(const std::vector<Vec2>& line, const std::vector<Vec2>& expected,
                 double tolerance = 1e-9) {
  ASSERT_EQ(line.size(), expected.size());
  for (std::size_t i = 0; i < line.size(); ++i)
    EXPECT_LT(norm(line[i] - expected[i]), tolerance) << i << ": " << line[i].x << ' ' << line[i].y;
}

/// One line of one shape, y upwards.
void expect_line(const std::string& content, const std::vector<Vec2>& expected) {
  SCOPED_TRACE(content);
  const auto found = lines(content);
  ASSERT_EQ(found.size(), 1U);
  expect_near(found[0], expected);
}

/// How far a line is from where all of a curve should be, at its points and between them.
double farthest(const std::vector<Vec2>& line, const std::function<double(Vec2)>& distance) {
  double most = 0.0;
  for (std::size_t i = 1; i < line.size(); ++i) {
    for (const double t : {0.0, 0.25, 0.5, 0.75, 1.0})
      most = std::max(most, distance((1.0 - t) * line[i - 1] + t * line[i]));
  }
  return most;
}

TEST(SvgDrawing, ReadsStraightShapes) {
  expect_line("<path d='M1 2 L3,4 5 6'/>", {{1, -2}, {3, -4}, {5, -6}});
  expect_line("<path d='m1 2 3 4-5-6z'/>", {{1, -2}, {4, -6}, {-1, 0}, {1, -2}});
  expect_line("<path d='M1,2h3v4H0V0'/>", {{1, -2}, {4, -2}, {4, -6}, {0, -6}, {0, 0}});
  expect_line("<path d='M.5.25.75-1e1'/>", {{0.5, -0.25}, {0.75, 10}});
  expect_line("<line x1='1' y1='2' x2='1cm' y2='4'/>", {{1, -2}, {960 / 25.4, -4}});
  expect_line("<polyline points='1,2 3,4 5 6'/>", {{1, -2}, {3, -4}, {5, -6}});
  expect_line("<polygon points='1,2 3,4 5 6'/>", {{1, -2}, {3, -4}, {5, -6}, {1, -2}});
  expect_line("<rect x='1' y='2' width='10%' height='4'/>",
              {{1, -2}, {21, -2}, {21, -6}, {1, -6}, {1, -2}});
  expect_line("<path d='M7 8'/>", {{7, -8}});
  EXPECT_TRUE(
      lines("<path d=''/><path/><polyline points=''/><rect width='3' height='0'/>").empty());
  const auto two = lines("<path d='M1 1l1 0zm5 5l2 0z l1 1'/>");
  ASSERT_EQ(two.size(), 3U);
  expect_near(two[1], {{6, -6}, {8, -6}, {6, -6}});
  expect_near(two[2], {{6, -6}, {7, -7}});
}

TEST(SvgDrawing, MakesChordsOfCurvesWithinAHundredthOfAMillimetre) {
  const auto circle = [](Vec2 middle, double r) {
    return [=](Vec2 p) { return std::abs(norm(p - middle) - r); };
  };
  for (const std::string content :
       {"<circle cx='50' cy='40' r='30'/>", "<ellipse cx='50' cy='40' rx='30' ry='30'/>",
        "<path d='M80 40A30 30 0 0 1 20 40 30 30 0 0 1 80 40'/>",
        "<path d='M80 40a30 30 0 11-60 0 30 30 0 1160 0'/>", "<path d='M80 40A30,30,0,1,0,50,70'/>",
        "<path d='M80 40A30,30,0,0,1,50,70'/>"}) {
    const auto found = lines(content);
    ASSERT_EQ(found.size(), 1U) << content;
    EXPECT_LT(farthest(found[0], circle({50, -40}, 30)), 0.01) << content;
    EXPECT_GT(farthest(found[0], circle({50, -40}, 30)), 0.001) << "more chords than it takes";
  }
  // The large arc goes the long way round.
  const auto large = lines("<path d='M80 40A30,30,0,1,0,50,70'/>")[0];
  const auto small = lines("<path d='M80 40A30,30,0,0,1,50,70'/>")[0];
  EXPECT_GT(large.size(), 2 * small.size());
  // Radii that are too small grow until they reach.
  const auto grown = lines("<path d='M0 0A1 1 0 0 1 20 0'/>")[0];
  EXPECT_LT(farthest(grown, circle({10, 0}, 10)), 0.01);
  // y = x^2 / 10 as a parabola of both kinds.
  for (const std::string content :
       {"<path d='M-10 -10Q0 10 10 -10'/>",
        "<path d='M-10 -10C-3.3333333333333333 3.3333333333333333 3.3333333333333333 "
        "3.3333333333333333 10 -10'/>"}) {
    const auto found = lines(content)[0];
    EXPECT_LT(farthest(found, [](Vec2 p) { return std::abs(p.y - p.x * p.x / 10.0); }), 0.02);
    EXPECT_GT(found.size(), 10U);
  }
}

TEST(SvgDrawing, MirrorsControlPointsOfSmoothCurves) {
  const auto same = [](const std::string& a, const std::string& b) {
    const auto left = lines("<path d='" + a + "'/>"), right = lines("<path d='" + b + "'/>");
    ASSERT_EQ(left.size(), 1U);
    expect_near(left[0], right[0]);
  };
  same("M0 0C0 10 10 10 10 0S20-10 20 0", "M0 0C0 10 10 10 10 0C10-10 20-10 20 0");
  same("M0 0Q5 10 10 0T20 0", "M0 0Q5 10 10 0Q15-10 20 0");
  same("m0 0q5 10 10 0t10 0", "M0 0Q5 10 10 0T20 0");
  // Behind another command the control point is where the line is.
  same("M0 0L10 0S20-10 20 0", "M0 0L10 0C10 0 20-10 20 0");
}

TEST(SvgDrawing, AppliesTransforms) {
  const std::string line = "<path d='M1 2L3 4'/>";
  const auto moved = [&](const std::string& transform) {
    return "<g transform='" + transform + "'>" + line + "</g>";
  };
  expect_line(moved("translate(10)"), {{11, -2}, {13, -4}});
  expect_line(moved("translate(10,20) scale(2)"), {{12, -24}, {16, -28}});
  expect_line(moved("scale(2, 3)"), {{2, -6}, {6, -12}});
  expect_line(moved("rotate(90)"), {{-2, -1}, {-4, -3}});
  expect_line(moved("rotate(180 1 2)"), {{1, -2}, {-1, 0}});
  expect_line(moved("matrix(1 2 3 4 5 6)"), {{12, -16}, {20, -28}});
  expect_line(moved("skewX(45)"), {{3, -2}, {7, -4}});
  expect_line(moved("skewY(45)"), {{1, -3}, {3, -7}});
  expect_line("<g transform='translate(5 0)'><g><path transform='scale(2)' d='M1 1L2 2'/></g></g>",
              {{7, -2}, {9, -4}});
}

TEST(SvgDrawing, IsAtTrueSizeInAllUnits) {
  const auto first_point = [](const std::string& head) {
    const auto found = drawing("<svg " + head + "><path d='M10 20'/></svg>").lines;
    return found.at(0).points.at(0);
  };
  const auto expect = [&](const std::string& head, Vec2 place) {
    EXPECT_LT(norm(first_point(head) - place), 1e-9) << head;
  };
  expect("width='100mm' height='50mm' viewBox='0 0 100 50'", {10, -20});
  expect("width='10cm' height='5cm' viewBox='0 0 100 50'", {10, -20});
  expect("width='1in' height='1in' viewBox='0 0 100 100'", {2.54, -5.08});
  expect("width='72pt' height='72pt' viewBox='0 0 100 100'", {2.54, -5.08});
  expect("width='96' height='96px' viewBox='0 0 100 100'", {2.54, -5.08});
  expect("width='100mm' height='50mm'", {10 * 25.4 / 96, -20 * 25.4 / 96});
  expect("", {10 * 25.4 / 96, -20 * 25.4 / 96});
  expect("viewBox='0 0 100 50'", {10 * 25.4 / 96, -20 * 25.4 / 96});
  expect("width='200mm' viewBox='0 0 100 50'", {20, -40});
  expect("width='100%' height='100mm' viewBox='5 10 100 50'", {10, -20});
  expect("width='100mm' height='100mm' viewBox='0 0 100 50'", {10, -20});
  expect("width='100mm' height='100mm' viewBox='0 0 100 50' preserveAspectRatio='none'", {10, -40});
}

TEST(SvgDrawing, TakesWhatIsVisible) {
  const auto count = [](const std::string& content) { return lines(content).size(); };
  const std::string line = "<path d='M0 0L1 1'/>";
  EXPECT_EQ(count("<g>" + line + "</g>"), 1U);
  EXPECT_EQ(count("<g display='none'>" + line + "</g>"), 0U);
  EXPECT_EQ(count("<g style='fill:red;display: none'>" + line + "</g>"), 0U);
  EXPECT_EQ(count("<g visibility='hidden'>" + line + "</g>"), 0U);
  EXPECT_EQ(count("<g visibility='hidden'><path visibility='visible' d='M0 0L1 1'/></g>"), 1U);
  EXPECT_EQ(count("<g style='display:none'><path style='display:inline' d='M0 0L1 1'/></g>"), 0U);
  EXPECT_EQ(count("<path fill='none' d='M0 0L1 1'/>"), 0U);
  EXPECT_EQ(count("<path style='fill:none;stroke:#000' d='M0 0L1 1'/>"), 1U);
  EXPECT_EQ(count("<g fill='none' stroke='red'>" + line + "</g>"), 1U);
  for (const std::string name :
       {"defs", "symbol", "clipPath", "mask", "marker", "pattern", "sodipodi:namedview", "text"})
    EXPECT_EQ(count("<" + name + ">" + line + "</" + name + ">"), 0U) << name;
  EXPECT_EQ(count("<svg:g>" + line + "</svg:g>"), 1U);
}

TEST(SvgDrawing, CountsWhatItLeavesOut) {
  const auto left_out = drawing(sheet("<text>a</text><g><image/><use/><use/></g><title>b</title>"
                                      "<text display='none'>c</text><defs><text>d</text></defs>"
                                      "<g id='label'><text>e</text></g>"))
                            .left_out;
  EXPECT_EQ(left_out, (std::map<std::string, std::size_t>{{"image", 1}, {"text", 1}, {"use", 2}}));
}

TEST(SvgDrawing, KnowsNamedLayersAlsoWhereTheyAreHidden) {
  const auto found =
      drawing(sheet("<g id='cut' style='display:none'><path d='M0 0L1 1'/></g>\n"
                    "<g id='mine'>\n<path id='cut' d='M0 0L1 1'/></g>"));
  ASSERT_EQ(found.lines.size(), 2U);
  EXPECT_EQ(found.lines[0].layer, "cut");
  EXPECT_EQ(found.lines[0].line, 4U);
  EXPECT_EQ(found.lines[1].layer, "");
  EXPECT_EQ(found.lines[1].line, 6U);
}

TEST(SvgDrawing, ReadsWhatOtherProgramsWrite) {
  // Entities of Illustrator, other quotes, sections of text, windows' ends of lines.
  const auto found = drawing(
      "\xef\xbb\xbf<?xml version='1.0'?>\r\n<!DOCTYPE svg PUBLIC \"-//W3C//DTD SVG 1.1//EN\" "
      "\"svg11.dtd\" [\r\n"
      "<!ENTITY ns_svg \"http://www.w3.org/2000/svg\">\r\n]>\r\n"
      "<svg xmlns=\"&ns_svg;\" width='10mm' height='10mm' viewBox='0 0 10 10'>"
      "<style><![CDATA[ .a > b { fill:none } ]]></style><g id='a &lt; b'>"
      "<path\n d = \"M1&#32;2&#xA;L3 4\" ></path  ></g></svg><!-- end -->\r\n");
  ASSERT_EQ(found.lines.size(), 1U);
  expect_near(found.lines[0].points, {{1, -2}, {3, -4}});
}

TEST(SvgDrawing, RefusesWithThePlace) {
  const auto expect = [](const std::string& bytes, ErrorCode code, std::size_t line,
                         const std::string& text) {
    try {
      drawing(bytes);
      ADD_FAILURE() << bytes;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), code) << bytes;
      EXPECT_EQ(error.place().path, "a.svg");
      EXPECT_EQ(error.place().line, line) << bytes;
      EXPECT_THAT(error.message(), HasSubstr(text));
    }
  };
  using enum ErrorCode;
  expect("", malformed_file, 1, "no element <svg>");
  expect("hello", malformed_file, 1, "no element <svg>");
  expect("<html></html>", malformed_file, 1, "outermost");
  expect("<svg></svg><svg></svg>", malformed_file, 1, "outermost");
  expect("<svg>\n<g>", truncated_file, 2, "inside element \"g\"");
  expect("<svg>\n<g", truncated_file, 2, "inside a tag");
  expect("<svg>\n<g id='a", truncated_file, 2, "value of an attribute");
  expect("<svg>\n<!-- ", truncated_file, 2, "inside a comment");
  expect("<svg>\n</g></svg>", malformed_file, 2, "\"svg\" is open");
  expect("<svg>\n<g id></g></svg>", malformed_file, 2, "has no value");
  expect("<svg>\n<g id=a></g></svg>", malformed_file, 2, "not in quotes");
  expect(sheet("<path d='L1 1'/>"), malformed_file, 4, "begin without M");
  expect(sheet("<path d='M1 1L2'/>"), malformed_file, 4, "number is missing or wrong");
  expect(sheet("<path d='M1 1L2 x'/>"), malformed_file, 4, "after L");
  expect(sheet("<path d='M1 1A1 1 0 2 0 3 3'/>"), malformed_file, 4, "after A");
  expect(sheet("<path d='M1 1z 5 5'/>"), malformed_file, 4, "command is missing");
  expect(sheet("<path d='M1 nan'/>"), malformed_file, 4, "number is missing or wrong");
  expect(sheet("<path d='M1 1e999'/>"), malformed_file, 4, "number is missing or wrong");
  expect(sheet("<path d='M1 1L1e300 0'/>"), too_large, 4, "too large");
  expect(sheet("<path d='M0 0C1e11 1e11 0 1e11 1 0'/>"), too_large, 4, "too large");
  expect(sheet("<polygon points='1 2 3'/>"), malformed_file, 4, "pairs");
  expect(sheet("<circle r='-1'/>"), malformed_file, 4, "below 0");
  expect(sheet("<circle r='1em'/>"), malformed_file, 4, "no length");
  expect(sheet("<g transform='turn(3)'/>"), malformed_file, 4, "no list of transforms");
  expect("<svg viewBox='0 0 1'></svg>", malformed_file, 1, "viewBox");
  expect("<svg viewBox='0 0 0 1'></svg>", malformed_file, 1, "viewBox");
  expect("<svg width='-1mm'></svg>", malformed_file, 1, "above 0");
  std::string deep = "<svg>";
  for (int i = 0; i < 1000; ++i)
    deep += "<g>";
  expect(deep, too_large, 1, "deep");
  expect(std::string("<\0s\0v\0g\0>\0", 10), malformed_file, 1, "UTF-16");
}

}  // namespace
}  // namespace planish
