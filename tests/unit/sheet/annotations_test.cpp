#include <algorithm>
#include <cmath>
#include <string>

#include <planish/core/error.h>
#include <planish/draw/format_drawing.h>
#include <planish/sheet/pattern_sheet.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/fnv_hash.h"
#include "oracle/outline_distance.h"
#include "pattern/pattern_hash.h"
#include "pattern/polygon/loop_box.h"
#include "sheet/edge_texts.h"
#include "sheet/sheet_layout.h"
#include "support/sample_report.h"
#include "unit/sheet/layers.h"

namespace planish {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;

/// A square of 200 mm in 4 x 4 cells.
Drawing sheet_with(const PatternOptions& options, bool overlaps = false) {
  const TriMesh mesh = meshes::flat_grid(4, 4);
  UnfoldReport unfold = samples::plane_below(mesh, 200.0, 200.0);
  for (Vec2& p : unfold.pattern.positions)
    p = 50.0 * p;
  unfold.pattern.overlaps = overlaps;
  return pattern_sheet(Patch(mesh), unfold, "panel", options);
}

const Path& path(const Drawing& drawing, const std::string& name, std::size_t number = 0) {
  return std::get<Path>(layer_of(drawing, name).shapes.at(number));
}

std::vector<std::string> texts(const Drawing& drawing, const std::string& name) {
  std::vector<std::string> texts;
  for (const DrawingShape& shape : layer_of(drawing, name).shapes) {
    if (const auto* text = std::get_if<Text>(&shape)) texts.push_back(text->text);
  }
  return texts;
}

TEST(Annotations, IsNotThereUnlessAskedFor) {
  const Drawing sheet = sheet_with({});
  for (const char* name : {"seam", "notch", "grain", "drill", "internal", "annotation"})
    EXPECT_TRUE(layer_of(sheet, name).shapes.empty()) << name;
}

TEST(Annotations, MakesTheOutlineTheSeamWhereThereIsAnAllowance) {
  const Drawing sheet = sheet_with({.allowance = Allowance{.width = 12.0}});
  const Path &cut = path(sheet, "cut"), &seam = path(sheet, "seam");
  ASSERT_EQ(seam.lines.size(), 1U);
  EXPECT_EQ(seam.lines[0].size(), 16U) << "border vertices of 4 x 4 cells";
  EXPECT_TRUE(seam.closed);
  EXPECT_TRUE(seam.stroke->dashed);
  EXPECT_NEAR(signed_area(seam.lines[0]), 200.0 * 200.0, 1e-6);
  EXPECT_NEAR(signed_area(cut.lines.at(0)), 224.0 * 224.0, 0.01);
  EXPECT_NEAR(oracle::distances(cut.lines, seam.lines).least, 12.0, 1e-4);
  EXPECT_THAT(texts(sheet, "label"), Contains("200.0 × 200.0 mm + 12 mm allowance"));
}

/// A square of 200 mm whose vertex 2, in the middle of the lower side, lies this high.
PatternGeometry with_vertex_raised(double height) {
  const TriMesh mesh = meshes::flat_grid(4, 4);
  UnfoldReport unfold = samples::plane_below(mesh, 200.0, 200.0);
  for (Vec2& p : unfold.pattern.positions)
    p = 50.0 * p;
  unfold.pattern.positions[2] = {110.0, height};
  unfold.pattern.overlaps = true;
  return pattern_geometry(mesh, unfold, "panel", {.allowance = Allowance{.width = 12.0}});
}

TEST(Annotations, HasNoAllowanceWhereMuchOfAPatternOverlaps) {
  const PatternGeometry pattern = with_vertex_raised(400.0);
  EXPECT_EQ(pattern.cut, pattern.outline.loops);
  EXPECT_FALSE(pattern.options.allowance);
  // Of the triangle from (50, 0) and (150, 0) to (110, 400), half as high and wide, above 200.
  EXPECT_THAT(pattern.left_out,
              Contains("piece \"panel\" overlaps itself by 5000 mm2: it gets no seam allowance"));
}

TEST(Annotations, CutsAroundBothLayersWhereLittleOfAPatternOverlaps) {
  const PatternGeometry pattern = with_vertex_raised(230.0);
  EXPECT_TRUE(pattern.options.allowance);
  EXPECT_THAT(pattern.left_out, Contains(HasSubstr("overlaps itself by 195.7 mm2: its cut line")));
  ASSERT_EQ(pattern.cut.size(), 1U);
  const LoopBox box = loop_box(pattern.cut);
  EXPECT_NEAR(box.size().x, 224.0, 1e-4);
}

TEST(Annotations, RingsThePlaceWhereAPatternOverlapsItself) {
  const TriMesh mesh = meshes::flat_grid(4, 4);
  UnfoldReport unfold = samples::plane_below(mesh, 200.0, 200.0);
  for (Vec2& p : unfold.pattern.positions)
    p = 50.0 * p;
  unfold.pattern.positions[2] = {110.0, 230.0};  // from the lower side through the upper one
  unfold.pattern.overlaps = true;
  const auto overlap = overlap_of(Patch(mesh), unfold.pattern);
  ASSERT_TRUE(overlap);
  EXPECT_EQ(overlap->crossings, 2U);
  EXPECT_NEAR(overlap->low.y, 200.0, 1e-9);
  EXPECT_NEAR(overlap->high.y, 200.0, 1e-9);
  EXPECT_GT(overlap->low.x, 90.0);
  EXPECT_LT(overlap->high.x, 125.0);
  const Drawing sheet = pattern_sheet(Patch(mesh), unfold, "panel", {});
  const auto& ring = std::get<Path>(layer_of(sheet, "label").shapes.back());
  Vec2 middle;
  for (const Vec2 p : ring.lines.at(0))
    middle = middle + 1.0 / static_cast<double>(ring.lines[0].size()) * p;
  const Vec2 shift = path(sheet, "cut").lines[0][0] - unfold.pattern.positions[0];
  const Vec2 wanted = 0.5 * (overlap->low + overlap->high) + shift;
  EXPECT_NEAR(norm(middle - wanted), 0.0, 1e-9);
}

TEST(Annotations, HasOtherAllowancesAlongStretchesOfTheBorder) {
  // Vertices 0 to 4 are the lower side, 24 to 20 the upper one.
  const Drawing sheet =
      sheet_with({.allowance = Allowance{.width = 10.0}, .edge_allowances = {{0, 4, 0.0}}});
  EXPECT_NEAR(signed_area(path(sheet, "cut").lines.at(0)), 220.0 * 210.0, 0.01);
}

TEST(Annotations, HasInnerLinesOnTheirLayer) {
  const Drawing sheet = sheet_with({.inner_lines = {{6, 7, 12}}});
  const Path& line = path(sheet, "internal");
  EXPECT_FALSE(line.closed);
  ASSERT_EQ(line.lines.at(0).size(), 3U);
  EXPECT_NEAR(norm(line.lines[0][1] - line.lines[0][0]), 50.0, 1e-9);
}

TEST(Annotations, AreNamedByTheirColoursBelowThePattern) {
  EXPECT_THAT(texts(sheet_with({}), "label"), Contains("red: cut"));
  const Drawing sheet =
      sheet_with({.allowance = Allowance{.width = 10.0}, .inner_lines = {{6, 7, 12}}});
  EXPECT_THAT(texts(sheet, "label"), Contains("red: cut · grey: sew · cyan: inner line"));
  EXPECT_THAT(sheet.notes, Contains("red: cut · grey: sew · cyan: inner line"));
}

TEST(Annotations, DrawsAFoldAndLeavesTheAllowanceOutThere) {
  // Vertices 0 to 4 are the lower side; either order will do.
  for (const FoldLine fold : {FoldLine{0, 4}, FoldLine{4, 0}}) {
    const Drawing sheet = sheet_with(
        {.allowance = Allowance{.width = 10.0}, .fold = fold, .label = {.name = "half"}});
    EXPECT_NEAR(signed_area(path(sheet, "cut").lines.at(0)), 220.0 * 210.0, 0.01);
    const Path& line = path(sheet, "fold");
    EXPECT_NEAR(norm(line.lines[0][1] - line.lines[0][0]), 10.0 + 200.0 + 10.0, 1e-4);
    EXPECT_EQ(std::get<FoldMark>(line.mark).from, line.lines[0][0]);
    EXPECT_THAT(texts(sheet, "annotation"), ElementsAre("half", "on the fold"));
  }
}

TEST(Annotations, RefusesAFoldThatIsNotStraight) {
  for (const FoldLine fold : {FoldLine{0, 9}, FoldLine{0, 0}, FoldLine{0, 12}, FoldLine{0, 99}}) {
    try {
      sheet_with({.fold = fold, .label = {"front"}});
      FAIL() << fold.to;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::misplaced_allowance);
      EXPECT_THAT(error.message(), HasSubstr("piece \"front\": the fold from vertex 0 to "));
    }
  }
}

TEST(Annotations, SaysTheAllowanceWithoutTheDustOfItsUnit) {
  const Drawing sheet = sheet_with({.allowance = Allowance{.width = 1.9999999999999998}});
  EXPECT_THAT(texts(sheet, "label"), Contains(testing::EndsWith("+ 2 mm allowance")));
}

TEST(Annotations, StaysOnTheSheetWithAMargin) {
  const Drawing sheet = sheet_with({.allowance = Allowance{.width = 60.0}});
  for (const Vec2 p : path(sheet, "cut").lines.at(0)) {
    EXPECT_GE(std::min(p.x, p.y), 10.0 - 1e-4);
    EXPECT_LE(p.x, sheet.width - 10.0 + 1e-4);
    EXPECT_LE(p.y, sheet.height - 10.0 + 1e-4);
  }
}

TEST(Annotations, HasItsLayers) {
  const Drawing sheet = sheet_with(
      {.allowance = Allowance{},
       .notches = {Notch::at_fraction(0.125, NotchKind::v), Notch::at_vertex(2, NotchKind::slit)},
       .grain = Grain{Vec3{0, 1, 0}},
       .marks = {{6}, {18, MarkKind::drill}},
       .label = {"front", "42", 2, "neoprene", "one mirrored"}});
  EXPECT_EQ(layer_of(sheet, "notch").shapes.size(), 2U);
  EXPECT_EQ(layer_of(sheet, "drill").shapes.size(), 2U);
  EXPECT_THAT(texts(sheet, "annotation"),
              ElementsAre("front", "size 42", "cut 2 ×", "neoprene", "one mirrored"));
  const Path& grain = path(sheet, "grain");
  EXPECT_NEAR(grain.lines[0][0].x, grain.lines[0][1].x, 1e-9) << "upright";
}

TEST(Annotations, PutsTheLabelInsideThePieceAndClearOfTheGrain) {
  const Drawing sheet = sheet_with({.grain = Grain{90.0}, .label = {"front", "42", 2}});
  const Path& cut = path(sheet, "cut");
  const Path& grain = path(sheet, "grain");
  for (const DrawingShape& shape : layer_of(sheet, "annotation").shapes) {
    const auto& text = std::get<Text>(shape);
    EXPECT_TRUE(oracle::is_inside(text.at, cut.lines));
    EXPECT_EQ(text.height, 6.0);
    EXPECT_GT(std::abs(text.at.x - grain.lines[0][0].x), 8.0) << "half of its longest line";
  }
}

TEST(Annotations, PutsTheLabelClearOfMarksAndInnerLines) {
  const PatternOptions plain = {.label = {"front", "42", 2}};
  const Drawing unmarked = sheet_with(plain);
  const auto& before = std::get<Text>(layer_of(unmarked, "annotation").shapes.at(1));
  PatternOptions marked = plain;
  marked.marks = {{12}, {11, MarkKind::drill}, {13}};
  marked.inner_lines = {{7, 17}};
  const Drawing sheet = sheet_with(marked);
  const Path& mark = path(sheet, "drill");
  EXPECT_LT(std::abs(before.at.y - mark.lines[0][0].y), 20.0) << "it would lie over the mark";
  double least = 1e9;
  for (const DrawingShape& shape : layer_of(sheet, "annotation").shapes) {
    const auto& text = std::get<Text>(shape);
    EXPECT_EQ(text.height, 6.0);
    least = std::min(least, std::abs(text.at.y + 3.0 - mark.lines[0][0].y));
  }
  EXPECT_GT(least, 6.0) << "a half of the mark and of a letter";
}

TEST(Annotations, WritesTheLengthsOfEdgesInsideThePiece) {
  const Drawing sheet = sheet_with({.allowance = Allowance{.width = 12.0}, .edge_lengths = true});
  EXPECT_THAT(texts(sheet, "annotation"), ElementsAre("200.0", "200.0", "200.0", "200.0"));
  for (const DrawingShape& shape : layer_of(sheet, "annotation").shapes)
    EXPECT_TRUE(oracle::is_inside(std::get<Text>(shape).at, path(sheet, "seam").lines));
}

struct TextBox {
  Vec2 low, high;
};

/// Of a text around its middle, with letters as wide as the layout takes them.
TextBox box_of(const Text& text) {
  EXPECT_TRUE(text.centred);
  const double half =
      0.5 * sheet::k_letter_width * text.height * static_cast<double>(text.text.size());
  return {text.at - Vec2{half, 0.0}, text.at + Vec2{half, text.height}};
}

bool overlap(const TextBox& a, const TextBox& b) {
  return a.low.x < b.high.x && b.low.x < a.high.x && a.low.y < b.high.y && b.low.y < a.high.y;
}

TEST(Annotations, WritesTheNumbersOfSeamsInsideBesideTheirVertices) {
  // Vertex 2 is in the middle of the lower side, 10 in that of the left one, 12 inside.
  const Drawing sheet = sheet_with({.seam_numbers = {{3, 2}, {7, 10}, {9, 12}}});
  EXPECT_THAT(texts(sheet, "annotation"), ElementsAre("seam 3", "seam 7"));
  const Vec2 corner = path(sheet, "cut").lines[0][0];
  const auto& shapes = layer_of(sheet, "annotation").shapes;
  const TextBox lower = box_of(std::get<Text>(shapes[0])), left = box_of(std::get<Text>(shapes[1]));
  EXPECT_NEAR(lower.low.y - corner.y, 3.5, 1e-9);
  EXPECT_NEAR(0.5 * (lower.low.x + lower.high.x) - corner.x, 100.0, 1e-9);
  EXPECT_NEAR(left.low.x - corner.x, 3.5, 1e-9);
  EXPECT_NEAR(0.5 * (left.low.y + left.high.y) - corner.y, 100.0, 1e-9);
}

TEST(Annotations, NamesThePartnerOfASeamAndMarksItsEnds) {
  const Drawing sheet = sheet_with({.seam_numbers = {{3, 2, "back"}, {3, 1, "back", 'a'}}});
  EXPECT_THAT(texts(sheet, "annotation"), ElementsAre("seam 3: back", "3a"));
  const auto& shapes = layer_of(sheet, "annotation").shapes;
  const Text &middle = std::get<Text>(shapes[0]), &end = std::get<Text>(shapes[1]);
  EXPECT_LT(end.height, middle.height);
  EXPECT_LT(end.at.x, middle.at.x) << "the border runs on from a";
  for (const Text& text : {middle, end}) {
    const TextBox box = box_of(text);
    for (const Vec2 at : {box.low, box.high})
      EXPECT_TRUE(oracle::is_inside(at, path(sheet, "cut").lines)) << text.text;
  }
}

TEST(Annotations, ScaleLettersWithLargeAndSmallPieces) {
  const auto square = [](double side) {
    return Polygon{{0.0, 0.0}, {side, 0.0}, {side, side}, {0.0, side}};
  };
  EXPECT_EQ(letter_scale(square(100.0)), 1.0);
  EXPECT_EQ(letter_scale(square(1500.0)), 1.0);
  EXPECT_EQ(letter_scale(square(9000.0)), 6.0);
  EXPECT_EQ(letter_scale(square(50.0)), 0.5);
  EXPECT_EQ(letter_scale(square(28.0)), 0.4) << "1.6 mm for a seam's number can still be read";
  EXPECT_EQ(letter_scale(square(1e6)), 8.0);
}

TEST(Annotations, KeepsNumbersOfSeamsAndLengthsApart) {
  const Drawing sheet = sheet_with({.seam_numbers = {{3, 2}, {7, 10}}, .edge_lengths = true});
  std::vector<TextBox> boxes;
  for (const DrawingShape& shape : layer_of(sheet, "annotation").shapes) {
    boxes.push_back(box_of(std::get<Text>(shape)));
    for (const Vec2 at : {boxes.back().low, boxes.back().high})
      EXPECT_TRUE(oracle::is_inside(at, path(sheet, "cut").lines));
    for (std::size_t k = 0; k + 1 < boxes.size(); ++k)
      EXPECT_FALSE(overlap(boxes[k], boxes.back())) << k;
  }
  EXPECT_EQ(boxes.size(), 6U);
}

TEST(Annotations, KeepsTheGrainLineOffADrillHoleOfASmallPart) {
  const TriMesh mesh = meshes::flat_grid(4, 2);  // 28 by 14 mm
  UnfoldReport unfold = samples::plane_below(mesh, 28.0, 14.0);
  for (Vec2& p : unfold.pattern.positions)
    p = 7.0 * p;
  const Index middle = 7;
  const Drawing sheet = pattern_sheet(Patch(mesh), unfold, "tab",
                                      {.grain = Grain{0.0},
                                       .marks = {{.vertex = middle, .kind = MarkKind::drill}},
                                       .label = {.name = "tab"}});
  const Vec2 hole = std::get<DrillMark>(path(sheet, "drill").mark).at;
  const Path& cut = path(sheet, "cut");
  EXPECT_NEAR(norm(hole - (cut.lines[0][0] + Vec2{14.0, 7.0})), 0.0, 1e-9);
  const Path& grain = path(sheet, "grain");
  for (const auto& line : grain.lines) {
    for (const Vec2 p : line)
      EXPECT_TRUE(oracle::is_inside(p, cut.lines));
    const double nearest_x = std::clamp(hole.x, std::min(line.front().x, line.back().x),
                                        std::max(line.front().x, line.back().x));
    EXPECT_GT(std::max(std::abs(nearest_x - hole.x), std::abs(line.front().y - hole.y)), 1.5);
  }
  const TextBox words = box_of(std::get<Text>(layer_of(sheet, "annotation").shapes.at(0)));
  EXPECT_FALSE(overlap(words, {hole - Vec2{1.5, 1.5}, hole + Vec2{1.5, 1.5}}));
  for (const Vec2 corner : {words.low, words.high})
    EXPECT_TRUE(oracle::is_inside(corner, cut.lines));
}

TEST(Annotations, KeepsWordsBelowThePatternOffTheSquaresAndApart) {
  for (const bool is_bad : {false, true}) {
    const TriMesh mesh = meshes::flat_grid(4, 4);
    UnfoldReport unfold = samples::plane_below(mesh, 200.0, 200.0);
    for (Vec2& p : unfold.pattern.positions)
      p = 50.0 * p;
    unfold.unit = Unit::in;
    if (is_bad) unfold.limits = {{Criterion::p99_strain, 0.01, 0.02}};
    const Drawing sheet = pattern_sheet(Patch(mesh), unfold, "panel",
                                        {.allowance = Allowance{.width = 8.0},
                                         .fold = FoldLine{0, 4},
                                         .notches = {Notch::at_fraction(0.4)},
                                         .grain = 90.0,
                                         .marks = {{.vertex = 7}},
                                         .inner_lines = {{6, 7, 12}},
                                         .date = "2031-02-03",
                                         .model_scale = 0.0254});
    const Path& inches = path(sheet, "label", 2);
    const double right = inches.lines[0][0].x;
    double above = 1e300;
    std::size_t rows = 0;
    for (const DrawingShape& shape : layer_of(sheet, "label").shapes) {
      const auto* text = std::get_if<Text>(&shape);
      if (text == nullptr || text->at.x != sheet::k_column) continue;
      const auto letters = std::count_if(text->text.begin(), text->text.end(), [](char byte) {
        return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
      });
      EXPECT_LT(text->at.x + sheet::k_letter_width * text->height * static_cast<double>(letters),
                right)
          << text->text;
      EXPECT_LT(text->at.y + 1.2 * text->height, above) << text->text;
      EXPECT_GT(text->at.y, sheet::k_margin + 14.0) << "above the legend";
      above = text->at.y;
      ++rows;
    }
    EXPECT_EQ(rows, is_bad ? 9U : 8U)
        << "name, size, two of the unit, origin, strain, limit, two of lines";
  }
}

TEST(Annotations, ShowsAHashOfThePatternAndADateOnlyIfGiven) {
  const TriMesh mesh = meshes::flat_grid(4, 4);
  std::vector<Vec2> corners;
  for (const Vec3 p : mesh.positions)
    corners.push_back(50.0 * Vec2{p.x, p.y});
  const std::string hash = hash_text(pattern_hash(corners));
  const auto dateless = texts(sheet_with({}), "label");
  EXPECT_THAT(dateless, Contains(testing::EndsWith(" · scale 1:1 · pattern " + hash)));
  const auto dated = texts(sheet_with({.allowance = Allowance{}, .date = "2031-02-03"}), "label");
  EXPECT_THAT(dated, Contains(testing::EndsWith(" · scale 1:1 · 2031-02-03 · pattern " + hash)))
      << "of the piece, whatever is around it";
}

TEST(Annotations, HasATestSquareOfTwoInches) {
  const Drawing sheet = sheet_with({});
  const Path& square = path(sheet, "label", 2);
  EXPECT_NEAR(square.lines[0][2].x - square.lines[0][0].x, 50.8, 1e-9);
  EXPECT_NEAR(square.lines[0][2].y - square.lines[0][0].y, 50.8, 1e-9);
}

TEST(Annotations, ReachesApparelProgramsByItsNumbers) {
  const Drawing sheet = sheet_with({.allowance = Allowance{},
                                    .notches = {Notch::at_fraction(0.125)},
                                    .grain = Grain{30.0},
                                    .marks = {{12}},
                                    .label = {"front", "42", 2}});
  const std::string dxf = format_dxf(sheet, {.profile = DxfProfile::aama});
  for (const char* text : {"Piece Name: front", "Size: 42", "Quantity: 2", "Sample Size: 42",
                           "POLYLINE\n8\n14\n", "POINT\n8\n4\n", "LINE\n8\n7\n", "POINT\n8\n13\n"})
    EXPECT_THAT(dxf, HasSubstr(text));
}

TEST(Annotations, NamesThePieceInErrors) {
  try {
    sheet_with({.notches = {Notch::at_vertex(12)}, .label = {"front"}});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::misplaced_notch);
    EXPECT_THAT(error.message(), HasSubstr("piece \"front\": the notch at vertex 12"));
  }
  EXPECT_THROW(sheet_with({.marks = {{25}}}), Error);
  EXPECT_THROW(sheet_with({.grain = Grain{Vec3{0, 0, 1}}}), Error);
}

TEST(Annotations, ClosesInnerLinesThatEndWhereTheyBegin) {
  const Drawing sheet = sheet_with({.marks = {{.vertex = 6, .kind = MarkKind::drill}},
                                    .inner_lines = {{6, 7, 12, 11, 6}, {6, 7, 12}, {6, 7, 6}}});
  EXPECT_TRUE(path(sheet, "internal", 0).closed);
  EXPECT_EQ(path(sheet, "internal", 0).lines.at(0).size(), 4U) << "the first point once";
  EXPECT_FALSE(path(sheet, "internal", 1).closed);
  EXPECT_FALSE(path(sheet, "internal", 2).closed) << "there and back encloses nothing";
  EXPECT_EQ(path(sheet, "internal", 2).lines.at(0).size(), 3U);
  EXPECT_TRUE(path(sheet, "drill").closed);
}

std::string size_words(const PatternOptions& options) {
  const std::vector<std::string> words = texts(sheet_with(options), "label");
  const auto found = std::find_if(words.begin(), words.end(), [](const std::string& text) {
    return text.find("allowance") != std::string::npos;
  });
  return found == words.end() ? "" : found->substr(found->find('+') + 2);
}

TEST(Annotations, SayEachWidthOfTheAllowance) {
  // The corners of the square are vertices 0, 4, 24 and 20, counter-clockwise.
  PatternOptions options{.allowance = Allowance{.width = 10.0}};
  EXPECT_EQ(size_words(options), "10 mm allowance");
  options.edge_allowances = {{4, 24, 30.0}};
  EXPECT_EQ(size_words(options), "allowance 10 mm, 30 mm at edge 2");
  options.edge_allowances = {{4, 24, 30.0}, {20, 0, 30.0}};
  EXPECT_EQ(size_words(options), "allowance 10 mm, 30 mm at edge 2 and edge 4");
  options.edge_allowances = {{4, 24, 30.0}, {20, 0, 0.0}};
  EXPECT_EQ(size_words(options), "allowance 10 mm, 30 mm at edge 2, none at edge 4");
  options.edge_allowances = {{4, 14, 30.0}};
  EXPECT_EQ(size_words(options), "allowance 10 mm, 30 mm at a part of edge 2");
  options.edge_allowances = {{4, 24, 10.0}};
  EXPECT_EQ(size_words(options), "10 mm allowance");
  options.edge_allowances = {{0, 0, 7.5}};
  EXPECT_EQ(size_words(options), "7.5 mm allowance");
  options.edge_allowances = {{4, 24, 30.0}};
  options.fold = FoldLine{20, 0};
  EXPECT_EQ(size_words(options), "allowance 10 mm, 30 mm at edge 2");
}

/// The length of all segments of one layer that lie on segments of another one.
double doubled_length(const Drawing& sheet, const std::string& one, const std::string& other) {
  struct Segment {
    Vec2 a, b;
  };
  const auto segments_of = [&](const std::string& name) {
    std::vector<Segment> segments;
    for (const DrawingShape& shape : layer_of(sheet, name).shapes) {
      const Path& some = std::get<Path>(shape);
      for (const auto& line : some.lines) {
        for (std::size_t i = 0; i + (some.closed ? 0 : 1) < line.size(); ++i)
          segments.push_back({line[i], line[(i + 1) % line.size()]});
      }
    }
    return segments;
  };
  double length = 0.0;
  for (const Segment& s : segments_of(one)) {
    const double own = norm(s.b - s.a);
    for (const Segment& t : segments_of(other)) {
      const Vec2 along = 1.0 / own * (s.b - s.a);
      if (std::abs(cross(along, t.a - s.a)) > 1e-3 || std::abs(cross(along, t.b - s.a)) > 1e-3)
        continue;
      const double from = dot(along, t.a - s.a), to = dot(along, t.b - s.a);
      length +=
          std::max(0.0, std::min(own, std::max(from, to)) - std::max(0.0, std::min(from, to)));
    }
  }
  return length;
}

double length_on(const Drawing& sheet, const std::string& name) {
  double length = 0.0;
  for (const DrawingShape& shape : layer_of(sheet, name).shapes) {
    const Path& some = std::get<Path>(shape);
    if (std::holds_alternative<SignMark>(some.mark)) continue;
    for (const auto& line : some.lines) {
      for (std::size_t i = 0; i + (some.closed ? 0 : 1) < line.size(); ++i)
        length += norm(line[(i + 1) % line.size()] - line[i]);
    }
  }
  return length;
}

TEST(Annotations, HaveABracketInsideAHalfThatPointsAtItsFold) {
  const Drawing sheet = sheet_with({.fold = FoldLine{20, 0}});
  const auto& shapes = layer_of(sheet, "fold").shapes;
  ASSERT_EQ(shapes.size(), 2U);
  const Path& fold = std::get<Path>(shapes[0]);
  const Path& bracket = std::get<Path>(shapes[1]);
  ASSERT_EQ(bracket.lines.size(), 3U) << "a line and two arrow heads";
  const Vec2 end = fold.lines[0].front(), way = fold.lines[0].back() - end;
  const auto away = [&](Vec2 p) { return std::abs(cross(way, p - end)) / norm(way); };
  EXPECT_NEAR(away(bracket.lines[0].front()), 0.0, 1e-9);
  EXPECT_NEAR(away(bracket.lines[0].back()), 0.0, 1e-9);
  for (const Vec2 p : {bracket.lines[0][1], bracket.lines[0][2]}) {
    EXPECT_NEAR(away(p), 10.0, 1e-9);
    EXPECT_TRUE(oracle::is_inside(p, {path(sheet, "cut").lines[0]}));
  }
  EXPECT_NEAR(away(bracket.lines[1][1]), 0.0, 1e-9) << "the tip of an arrow";
}

TEST(Annotations, ShowTheWholeOfAHalfWhereThatIsAskedFor) {
  const TriMesh mesh = meshes::flat_grid(4, 4);
  UnfoldReport unfold = samples::plane_below(mesh, 200.0, 200.0);
  for (Vec2& p : unfold.pattern.positions)
    p = 50.0 * p;
  PatternOptions options{.allowance = Allowance{.width = 10.0}, .fold = FoldLine{20, 0}};
  const auto sheet_of = [&] {
    return sheet_to_cut(mesh, unfold, pattern_geometry(mesh, unfold, "panel", options));
  };
  EXPECT_FALSE(path(sheet_of(), "cut").closed) << "open along the fold";
  options.open_fold = true;
  const Drawing sheet = sheet_of();
  EXPECT_TRUE(path(sheet, "cut").closed);
  EXPECT_NEAR(signed_area(path(sheet, "cut").lines.at(0)), 420.0 * 220.0, 0.01);
  EXPECT_EQ(layer_of(sheet, "fold").shapes.size(), 1U) << "no bracket on a whole";
}

TEST(Annotations, DrawNoLineTwice) {
  for (const bool has_fold : {false, true}) {
    for (const double width : {0.0, 10.0}) {
      for (const LineFit& fit : {LineFit{.tolerance = 0.0}, LineFit{}}) {
        PatternOptions options{.curves = fit};
        if (width > 0.0) {
          options.allowance = Allowance{.width = width};
          options.edge_allowances = {{4, 24, 0.0}};
        }
        if (has_fold) options.fold = FoldLine{20, 0};
        const Drawing sheet = sheet_with(options);
        EXPECT_NEAR(doubled_length(sheet, "cut", "seam"), 0.0, 1e-6);
        EXPECT_NEAR(doubled_length(sheet, "cut", "fold"), 0.0, 1e-6);
        EXPECT_NEAR(doubled_length(sheet, "seam", "fold"), 0.0, 1e-6);
        // Each of the sides is drawn all the same.
        EXPECT_NEAR(length_on(sheet, "fold"), has_fold ? 200.0 + 2.0 * width : 0.0, 1e-4);
        if (width > 0.0) {
          EXPECT_NEAR(length_on(sheet, "seam"), has_fold ? 400.0 : 600.0, 1e-6);
        } else {
          EXPECT_NEAR(length_on(sheet, "cut"), has_fold ? 600.0 : 800.0, 1e-6);
        }
      }
    }
  }
}

TEST(Annotations, DrawACurveOpenAlongTheFold) {
  const Drawing sheet = sheet_with(
      {.allowance = Allowance{.width = 10.0}, .fold = FoldLine{20, 0}, .curves = LineFit{}});
  const Path& cut = path(sheet, "cut");
  EXPECT_FALSE(cut.closed);
  ASSERT_EQ(cut.fitted.curves.size(), 1U);
  const Curve& curve = cut.fitted.curves[0];
  EXPECT_EQ(curve.start, cut.lines.at(0).front());
  EXPECT_EQ(end_of(curve.pieces.back()), cut.lines.at(0).back());
  EXPECT_NEAR(length_of(curve), length_on(sheet, "cut"), 1e-6);
  EXPECT_EQ(cut.fitted.few.at(0).front(), cut.lines.at(0).front());
}

}  // namespace
}  // namespace planish
