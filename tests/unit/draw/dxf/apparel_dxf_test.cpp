#include <cmath>
#include <string>
#include <vector>

#include <planish/draw/format_drawing.h>
#include <planish/sheet/pattern_sheet.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/sample_report.h"
#include "unit/draw/dxf/read_dxf.h"

namespace planish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

constexpr DxfProfile k_apparel[] = {DxfProfile::aama,   DxfProfile::astm,    DxfProfile::clo,
                                    DxfProfile::lectra, DxfProfile::optitex, DxfProfile::gerber};

Path square(double side) {
  return {{{{0, 0}, {side, 0}, {side, side}, {0, side}}}, true, Stroke{}};
}

Drawing with_cut(Path path, std::vector<DrawingPiece> pieces = {}) {
  return {"sheet", 100.0, 100.0, {Layer{"cut", {std::move(path)}}}, std::move(pieces)};
}

Path marked(PieceMark mark) {
  Path path{{{{1, 1}, {2, 2}}}, false, Stroke{}};
  path.mark = mark;
  return path;
}

std::vector<DxfEntity> on_layer(const std::string& dxf, const std::string& kind,
                                const std::string& layer) {
  std::vector<DxfEntity> found;
  for (const DxfEntity& entity : all_of_kind(dxf, kind)) {
    if (value_of(entity, 8) == layer) found.push_back(entity);
  }
  return found;
}

/// A panel of 200 x 200 mm with everything.
Drawing panel() {
  const TriMesh mesh = meshes::flat_grid(4, 4);
  UnfoldReport unfold = samples::plane_below(mesh, 200.0, 200.0);
  for (Vec2& p : unfold.pattern.positions)
    p = 50.0 * p;
  return pattern_sheet(Patch(mesh), unfold, "panel",
                       {.allowance = Allowance{.width = 12.0},
                        .notches = {Notch::at_fraction(0.125, NotchKind::v),
                                    Notch::at_fraction(0.4, NotchKind::slit),
                                    Notch::at_fraction(0.65, NotchKind::t, true)},
                        .grain = Grain{30.0},
                        .marks = {{6}, {18, MarkKind::drill}},
                        .inner_lines = {{6, 7, 12}},
                        .label = {"Größe Ж布", "42", 2, "neoprene", "one mirrored"}});
}

TEST(ApparelDxf, HasABlockForEachPieceOnLayerZeroWithItsSizeInTheName) {
  Path second = square(5.0);
  second.piece = 1;
  Drawing drawing = with_cut(square(10.0), {{"front", "38"}, {"front", ""}});
  drawing.layers[0].shapes.emplace_back(second);
  for (const DxfProfile profile : k_apparel) {
    const std::string dxf = format_dxf(drawing, {.profile = profile});
    EXPECT_THAT(values(all_of_kind(dxf, "BLOCK"), 2), ElementsAre("front_38", "front_ONE"));
    EXPECT_THAT(values(all_of_kind(dxf, "BLOCK"), 8), ElementsAre("0", "0"));
    EXPECT_THAT(values(all_of_kind(dxf, "BLOCK"), 70), ElementsAre("64", "64"));
    EXPECT_THAT(values(all_of_kind(dxf, "INSERT"), 2), ElementsAre("front_38", "front_ONE"));
    EXPECT_THAT(values(all_of_kind(dxf, "INSERT"), 10), ElementsAre("0.0", "0.0"));
    EXPECT_GT(dxf.find("INSERT"), dxf.find("ENTITIES"));
    EXPECT_LT(dxf.rfind("POLYLINE"), dxf.find("ENTITIES")) << "all lines are in blocks";
  }
}

TEST(ApparelDxf, GivesEveryBlockANameOfItsOwn) {
  Drawing drawing = with_cut(square(1.0));
  drawing.title = std::string(40, 'x');
  drawing.layers[0].shapes.emplace_back(square(2.0));
  std::get<Path>(drawing.layers[0].shapes[1]).piece = 5;
  const std::string dxf = format_dxf(drawing, {.profile = DxfProfile::astm});
  EXPECT_THAT(values(all_of_kind(dxf, "BLOCK"), 2),
              ElementsAre(std::string(27, 'x') + "_ONE", std::string(25, 'x') + "_2_ONE"));
}

TEST(ApparelDxf, HasAnEmptyHeaderAndNoTablesButForClo) {
  for (const DxfProfile profile : k_apparel) {
    const std::string dxf = format_dxf(with_cut(square(10.0)), {.profile = profile});
    EXPECT_THAT(dxf, Not(HasSubstr("TABLE")));
    EXPECT_EQ(dxf.starts_with("0\nSECTION\n2\nHEADER\n0\nENDSEC\n"), profile != DxfProfile::clo);
  }
  const std::string clo = format_dxf(with_cut(square(10.0)), {.profile = DxfProfile::clo});
  EXPECT_THAT(clo, HasSubstr("9\n$ACADVER\n1\nAC1006\n9\n$INSBASE\n10\n0.0\n20\n0.0\n30\n0.0\n"
                             "9\n$EXTMIN\n10\n0.0\n20\n0.0\n9\n$EXTMAX\n10\n10.0\n20\n10.0\n"
                             "0\nENDSEC\n"));
}

TEST(ApparelDxf, IsAsciiAndHasNoLinesWherePointsBelong) {
  for (const DxfProfile profile : k_apparel) {
    for (const bool stroked : {false, true}) {
      const std::string dxf = format_dxf(panel(), {.profile = profile, .stroked_text = stroked});
      for (const char c : dxf)
        ASSERT_TRUE(c == '\n' || (c >= ' ' && c < 0x7F));
      EXPECT_THAT(dxf, Not(HasSubstr("\\U+")));
      for (const char* layer : {"4", "5", "6", "7", "13", "15", "80"})
        EXPECT_THAT(on_layer(dxf, "POLYLINE", layer), IsEmpty()) << layer;
    }
  }
}

TEST(ApparelDxf, WritesNotchesAsPointsOnTheBoundary) {
  const Drawing drawing = panel();
  const std::string dxf = format_dxf(drawing, {.profile = DxfProfile::aama});
  const auto notches = on_layer(dxf, "POINT", "4");
  ASSERT_EQ(notches.size(), 4U);
  EXPECT_THAT(values(notches, 30), ElementsAre("5.0", "5.0", "5.0", "5.0"));
  EXPECT_THAT(values(notches, 39), ElementsAre("4.0", "0.0", "4.0", "4.0"));
  const std::vector<double> angles = {90.0, 180.0, 270.0, 270.0};
  for (std::size_t i = 0; i < notches.size(); ++i)
    EXPECT_NEAR(real_of(notches[i], 50), angles[i], 0.001);
  // Half along the lower side, 12 mm below it; the sheet has a margin of 10 mm.
  EXPECT_NEAR(real_of(notches[0], 10), 10.0 + 12.0 + 100.0, 0.001);
  EXPECT_NEAR(real_of(notches[2], 10) - real_of(notches[3], 10), 6.0, 0.001) << "a double one";
  std::vector<std::pair<std::string, std::string>> boundary;
  for (const DxfEntity& vertex : on_layer(dxf, "VERTEX", "1"))
    boundary.emplace_back(value_of(vertex, 10), value_of(vertex, 20));
  for (const DxfEntity& notch : notches)
    EXPECT_THAT(boundary, testing::Contains(std::pair(value_of(notch, 10), value_of(notch, 20))));
}

TEST(ApparelDxf, PutsTNotchesOfAstmOnLayer80) {
  const std::string dxf = format_dxf(panel(), {.profile = DxfProfile::astm});
  EXPECT_EQ(on_layer(dxf, "POINT", "4").size(), 2U);
  EXPECT_EQ(on_layer(dxf, "POINT", "80").size(), 2U);
}

TEST(ApparelDxf, WritesStrokesOnRequest) {
  const std::string dxf = format_dxf(panel(), {.profile = DxfProfile::aama, .notch_strokes = true});
  EXPECT_THAT(on_layer(dxf, "POINT", "4"), IsEmpty());
  EXPECT_EQ(on_layer(dxf, "POLYLINE", "4").size(), 1U + 1U + 2U * 2U);
  EXPECT_EQ(on_layer(dxf, "POLYLINE", "13").size(), 2U + 1U) << "a cross and a ring";
  EXPECT_EQ(on_layer(dxf, "LINE", "7").size(), 1U) << "the grain stays a line";
}

TEST(ApparelDxf, WritesDrillHolesAsPointsAndGrainAndFoldAsLines) {
  Drawing drawing = with_cut(square(10.0));
  drawing.layers.push_back({"drill", {marked(DrillMark{{3, 4}})}});
  drawing.layers.push_back({"grain", {marked(GrainMark{{1, 2}, {1, 8}})}});
  drawing.layers.push_back({"fold", {marked(FoldMark{{0, 0}, {10, 0}})}});
  const std::string dxf = format_dxf(drawing, {.profile = DxfProfile::astm});
  const auto drills = on_layer(dxf, "POINT", "13");
  ASSERT_EQ(drills.size(), 1U);
  EXPECT_EQ(value_of(drills[0], 10), "3.0");
  EXPECT_EQ(value_of(drills[0], 20), "4.0");
  for (const char* layer : {"7", "5"}) {
    const auto grain = on_layer(dxf, "LINE", layer);
    ASSERT_EQ(grain.size(), 1U) << layer;
    EXPECT_EQ(value_of(grain[0], 20), "2.0");
    EXPECT_EQ(value_of(grain[0], 21), "8.0");
  }
  EXPECT_EQ(value_of(on_layer(dxf, "LINE", "6").at(0), 11), "10.0");
}

TEST(ApparelDxf, MarksEveryVertexAsATurnOrACurvePoint) {
  Path disk{{{}}, true, Stroke{}};
  for (int k = 0; k < 36; ++k) {
    const double angle = k * 3.14159265358979 / 18.0;
    disk.lines[0].push_back({50.0 * std::cos(angle), 50.0 * std::sin(angle)});
  }
  disk.lines[0].push_back({60.0, 0.0});  // a corner, and it makes two of its neighbours
  const std::string dxf = format_dxf(with_cut(disk), {.profile = DxfProfile::aama});
  const auto vertices = on_layer(dxf, "VERTEX", "1");
  const auto turns = on_layer(dxf, "POINT", "2"), curves = on_layer(dxf, "POINT", "3");
  EXPECT_EQ(vertices.size(), 37U);
  EXPECT_EQ(turns.size() + curves.size(), vertices.size());
  EXPECT_THAT(values(turns, 10), testing::Contains("60.0"));
  EXPECT_LE(turns.size(), 3U);
}

TEST(ApparelDxf, PutsHolesOnLayer11) {
  Path holed = square(10.0);
  holed.lines.insert(holed.lines.begin(), {{8, 1}, {9, 1}, {9, 2}});
  const std::string dxf = format_dxf(with_cut(holed), {.profile = DxfProfile::aama});
  EXPECT_THAT(values(all_of_kind(dxf, "POLYLINE"), 8), ElementsAre("11", "1"));
  const std::string astm = format_dxf(with_cut(holed), {.profile = DxfProfile::astm});
  EXPECT_THAT(values(all_of_kind(astm, "POLYLINE"), 8), ElementsAre("11", "1", "86", "84"));
}

TEST(ApparelDxf, HasTheDenseLinesBesideTheFewPointsInAstmOnly) {
  Path path = square(10.0);
  path.fitted.few = {{{0, 0}, {10, 0}, {10, 10}}};
  Drawing drawing = with_cut(path);
  drawing.layers.push_back({"seam", {path}});
  drawing.layers.push_back({"internal", {Path{{{{1, 1}, {2, 2}, {3, 1}}}, false, Stroke{}}}});
  const std::string astm = format_dxf(drawing, {.profile = DxfProfile::astm});
  EXPECT_THAT(values(all_of_kind(astm, "POLYLINE"), 8),
              ElementsAre("1", "84", "14", "87", "8", "85"));
  EXPECT_EQ(on_layer(astm, "VERTEX", "1").size(), 3U);
  EXPECT_EQ(on_layer(astm, "VERTEX", "84").size(), 4U);
  EXPECT_EQ(on_layer(astm, "POINT", "2").size(), 3U + 3U + 3U) << "ends and corners";
  const std::string aama = format_dxf(drawing, {.profile = DxfProfile::aama});
  EXPECT_THAT(values(all_of_kind(aama, "POLYLINE"), 8), ElementsAre("1", "14", "8"));
}

std::vector<std::string> texts_of(const Drawing& drawing, DxfProfile profile) {
  return values(all_of_kind(format_dxf(drawing, {.profile = profile}), "TEXT"), 1);
}

TEST(ApparelDxf, HasTheTextsThatProgramsLookForInTheirOrder) {
  Drawing drawing = with_cut(square(10.0), {{"Größe Ж", "42", 2, 1, "wool", "one mirrored"}});
  drawing.date = "2031-02-03";
  const std::string version =
      value_of(all_of_kind(format_dxf(drawing, {.profile = DxfProfile::aama}), "TEXT").at(11), 1);
  EXPECT_THAT(texts_of(drawing, DxfProfile::aama),
              ElementsAre("Piece Name: Groesse Zh", "Material: wool", "Size: 42",
                          "Annotation: one mirrored", "Annotation: 2 as drawn, 1 mirrored",
                          "Quantity: 3", "Style Name: sheet", "Creation Date: 2031-02-03",
                          "Creation Time: ", "Author: PLANISH", "PRODUCT: PLANISH",
                          testing::StartsWith("VERSION: "), "Sample Size: 42", "Units: METRIC",
                          "TOLERANCE: .15"));
  EXPECT_THAT(
      texts_of(drawing, DxfProfile::gerber),
      ElementsAre("Piece Name: Groesse Zh", "Fabric: wool", "Size: 42", "Annotation: one mirrored",
                  "Quantity: 2,1", "Style Name: sheet", "Creation Date: 2031-02-03",
                  "Creation Time: ", testing::StartsWith("Author: PLANISH ; PLANISH ; "),
                  "Sample Size: 42", "Units: METRIC", "Curve Tolerance: .15",
                  "ASTM/D13Proposal 1 Version: D 6673-04"));
  EXPECT_THAT(texts_of(drawing, DxfProfile::clo),
              testing::IsSupersetOf({"PIECE NAME: Groesse Zh", "MATERIAL: wool", "SIZE: 42",
                                     "QUANTITY: 3", "STYLE NAME: sheet", "UNITS: METRIC"}));
}

TEST(ApparelDxf, LeavesOtherLayersOutButThoseThatAreRenamed) {
  Drawing drawing = with_cut(square(10.0));
  drawing.layers.push_back({"label", {square(3.0), Text{{1.0, 2.0}, 3.0, "a note"}}});
  EXPECT_THAT(format_dxf(drawing, {.profile = DxfProfile::aama}), Not(HasSubstr("a note")));
  const std::string dxf =
      format_dxf(drawing, {.profile = DxfProfile::aama, .layer_names = {{"label", "15"}}});
  EXPECT_THAT(dxf, HasSubstr("a note"));
  EXPECT_EQ(on_layer(dxf, "POLYLINE", "15").size(), 1U);
}

/// Half a panel, with its fold along the left side.
Drawing half_panel(bool has_hole) {
  TriMesh mesh = meshes::flat_grid(4, 4);
  if (has_hole) mesh.triangles.erase(mesh.triangles.begin() + 10);
  UnfoldReport unfold = samples::plane_below(mesh, 200.0, 200.0);
  for (Vec2& p : unfold.pattern.positions)
    p = 50.0 * p;
  return pattern_sheet(Patch(mesh), unfold, "half",
                       {.allowance = Allowance{.width = 12.0}, .fold = FoldLine{20, 0}});
}

TEST(ApparelDxf, ClosesTheBoundaryAlongAFold) {
  for (const bool has_hole : {false, true}) {
    for (const DxfProfile profile : k_apparel) {
      const std::string dxf = format_dxf(half_panel(has_hole), {.profile = profile});
      const auto boundary = on_layer(dxf, "POLYLINE", "1");
      ASSERT_EQ(boundary.size(), 1U);
      EXPECT_EQ(value_of(boundary[0], 70), "1") << "closed";
      EXPECT_EQ(on_layer(dxf, "POLYLINE", "11").size(), has_hole ? 1U : 0U);
      EXPECT_EQ(on_layer(dxf, "LINE", "6").size(), 1U);
    }
  }
}

TEST(ApparelDxf, HasNoFoldToMirrorAPieceThatIsWhole) {
  Drawing drawing = with_cut(square(10.0));
  drawing.layers.push_back({"fold", {marked(FoldMark{{5, 0}, {5, 10}, true})}});
  const std::string dxf = format_dxf(drawing, {.profile = DxfProfile::aama});
  EXPECT_THAT(on_layer(dxf, "LINE", "6"), IsEmpty());
  EXPECT_EQ(on_layer(dxf, "LINE", "8").size(), 1U);
}

}  // namespace
}  // namespace planish
