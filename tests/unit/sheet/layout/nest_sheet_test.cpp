#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>
#include <variant>
#include <vector>

#include <planish/core/error.h>
#include <planish/draw/format_drawing.h>
#include <planish/sheet/nest_sheet.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracle/outline_gap.h"
#include "support/meshes.h"
#include "unit/sheet/layers.h"

namespace planish {
namespace {

using testing::HasSubstr;

/// A flat box of columns x rows cells of 10 mm, cut as often as told.
NestPatch flat_patch(const std::string& name, std::size_t columns, std::size_t rows,
                     PatternOptions annotations = {}) {
  NestPatch patch{name, meshes::flat_grid(columns, rows), {}, std::move(annotations)};
  for (const Vec3& p : patch.mesh.positions)
    patch.pattern.push_back({10.0 * p.x, 10.0 * p.y});
  return patch;
}

std::vector<Path> nest_paths(const Drawing& drawing, const std::string& name) {
  std::vector<Path> paths;
  for (const DrawingShape& shape : layer_of(drawing, name).shapes) {
    if (const auto* path = std::get_if<Path>(&shape)) paths.push_back(*path);
  }
  return paths;
}

std::vector<std::string> nest_texts(const Drawing& drawing, const std::string& name) {
  std::vector<std::string> texts;
  for (const DrawingShape& shape : layer_of(drawing, name).shapes) {
    if (const auto* text = std::get_if<Text>(&shape)) texts.push_back(text->text);
  }
  return texts;
}

NestJob jacket() {
  PatternOptions annotations{.allowance = Allowance{.width = 10.0},
                             .notches = {Notch::at_fraction(0.1)},
                             .grain = 90.0,
                             .marks = {{.vertex = 7}},
                             .label = {.quantity = 2}};
  NestJob job{{flat_patch("front", 20, 30, annotations), flat_patch("failed", 2, 2),
               flat_patch("sleeve", 15, 40, annotations)},
              Unit::mm,
              {.width = 700.0, .gap = 8.0}};
  job.patches[1].pattern.clear();
  return job;
}

TEST(DoubleCloth, LaysPairsOnceAndNamesWhatHasNoPartner) {
  const auto labelled = [](const std::string& name, int quantity, int mirrored) {
    PatternOptions own;
    own.label.quantity = quantity;
    own.label.mirrored = mirrored;
    return flat_patch(name, 2, 3, own);
  };
  std::vector<NestPatch> patches = {labelled("pair", 4, 2), labelled("collar", 1, 0),
                                    labelled("left", 3, 0), labelled("right", 2, 0)};
  patches[3].mirror_image_of = 2;
  patches.push_back(labelled("yoke", 1, 0));
  patches.back().annotations.fold = FoldLine{0, 2};
  const DoubleCloth cloth = on_double_cloth(patches);
  ASSERT_EQ(cloth.patches.size(), 4U) << "the right one is the left one's second layer";
  const auto copies = [&](std::size_t p) { return cloth.patches[p].annotations.label.quantity; };
  EXPECT_EQ(copies(0), 2);
  EXPECT_EQ(copies(1), 1);
  EXPECT_EQ(copies(2), 3);
  EXPECT_EQ(copies(3), 1) << "a half gives one whole piece";
  EXPECT_EQ(cloth.patches[0].annotations.label.mirrored, 0);
  ASSERT_EQ(cloth.single.size(), 2U);
  EXPECT_EQ(cloth.single[0].name, "collar");
  EXPECT_EQ(cloth.single[0].copies, 1);
  EXPECT_EQ(cloth.single[1].name, "left");
  EXPECT_EQ(cloth.single[1].copies, 1);
}

TEST(DoubleCloth, LaysTheFoldOfAHalfOnThatOfTheCloth) {
  PatternOptions own{.allowance = Allowance{.width = 8.0}, .fold = FoldLine{2, 11}};
  for (const double grain : {90.0, 270.0, 92.0}) {
    own.grain = grain;
    const NestJob job{on_double_cloth({flat_patch("half", 2, 3, own)}).patches,
                      Unit::mm,
                      {.width = 300.0, .folded = true}};
    const auto pieces = nest_pieces(job);
    ASSERT_EQ(pieces.size(), 1U);
    const Nesting nesting = nest(pieces, job.sheets);
    // Vertices 2 and 11 are the corners on the right.
    for (const Vec2 corner : {Vec2{20.0, 0.0}, Vec2{20.0, 30.0}})
      EXPECT_NEAR(nesting.placements[0](corner).y, 0.0, 1e-9);
    EXPECT_NEAR(nesting.placements[0]({0.0, 15.0}).y, 20.0, 1e-9);
  }
  own.grain = 0.0;
  const NestJob across{{flat_patch("half", 2, 3, own)}, Unit::mm, {.width = 300.0, .folded = true}};
  EXPECT_THROW(nest_pieces(across), Error);
}

TEST(NestSheet, DrawsEveryCopyWhereItWasLaid) {
  const NestJob job = jacket();
  const auto pieces = nest_pieces(job);
  const Nesting nesting = nest(pieces, job.sheets);
  ASSERT_EQ(nesting.placements.size(), 4U);
  const Drawing sheet = nest_sheet(job, nesting, 0, "jacket");
  const auto cuts = nest_paths(sheet, "cut"), seams = nest_paths(sheet, "seam");
  ASSERT_EQ(cuts.size(), 4U);
  ASSERT_EQ(seams.size(), 4U);
  double farthest = 0.0;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const auto box = oracle::outline_box(cuts[i].lines), seam = oracle::outline_box(seams[i].lines);
    EXPECT_NEAR(box.low.x, seam.low.x - 10.0, 1e-4);
    EXPECT_NEAR(box.high.y, seam.high.y + 10.0, 1e-4);
    EXPECT_GE(box.low.x, -1e-6);
    EXPECT_GE(box.low.y, -1e-6);
    EXPECT_LE(box.high.y, 700.0 + 1e-6);
    farthest = std::max(farthest, box.high.x);
    EXPECT_EQ(cuts[i].piece, i);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(oracle::gap_between(cuts[i].lines, cuts[j].lines, 9.0), 8.0 - 1e-6);
  }
  EXPECT_NEAR(nesting.used_length, farthest, 1e-6);
  EXPECT_EQ(nest_paths(sheet, "notch").size(), 4U);
  EXPECT_EQ(nest_paths(sheet, "drill").size(), 4U);
  EXPECT_THAT(nest_texts(sheet, "label"),
              testing::Contains("red: cut · grey: sew · pink: notch · green: grain · blue: mark"));
  EXPECT_THAT(nest_texts(sheet, "annotation"),
              testing::UnorderedElementsAre("front 1 of 2", "front 2 of 2", "sleeve 1 of 2",
                                            "sleeve 2 of 2"));
  ASSERT_EQ(sheet.pieces.size(), 4U);
  EXPECT_EQ(sheet.pieces[2].name, "sleeve 1 of 2");
}

/// The length along which edges of paths lie on each other, each pair once.
double doubled_length(const std::vector<Path>& paths) {
  std::vector<std::pair<Vec2, Vec2>> edges;
  for (const Path& path : paths) {
    for (const auto& line : path.lines) {
      for (std::size_t i = 0; i + (path.closed ? 0 : 1) < line.size(); ++i)
        edges.emplace_back(line[i], line[(i + 1) % line.size()]);
    }
  }
  double doubled = 0.0;
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const auto [a, b] = edges[i];
    const Vec2 along = 1.0 / norm(b - a) * (b - a);
    for (std::size_t j = 0; j < i; ++j) {
      const auto [c, d] = edges[j];
      if (std::abs(cross(along, c - a)) > 1e-3 || std::abs(cross(along, d - a)) > 1e-3) continue;
      const double first = dot(c - a, along), last = dot(d - a, along);
      doubled += std::max(
          0.0, std::min(norm(b - a), std::max(first, last)) - std::max(0.0, std::min(first, last)));
    }
  }
  return doubled;
}

double length_of(const std::vector<Path>& paths) {
  double length = 0.0;
  for (const Path& path : paths) {
    for (const auto& line : path.lines) {
      for (std::size_t i = 0; i + (path.closed ? 0 : 1) < line.size(); ++i)
        length += norm(line[(i + 1) % line.size()] - line[i]);
    }
  }
  return length;
}

TEST(NestSheet, CutsCommonLinesOnce) {
  // Two rows of boxes that fill the sheet, of two sizes, so that edges lie on parts of others.
  const NestJob job{{flat_patch("long", 20, 10, {.label = {.quantity = 2}}),
                     flat_patch("short", 10, 10, {.label = {.quantity = 4}})},
                    Unit::mm,
                    {.width = 200.0, .length = 400.0, .gap = 0.0}};
  const Nesting nesting = nest(nest_pieces(job), job.sheets);
  ASSERT_EQ(nesting.sheets, 1U);
  const Drawing sheet = nest_sheet(job, nesting, 0, "boxes");
  EXPECT_GT(doubled_length(nest_paths(sheet, "cut")), 399.0);
  const Drawing once = without_common_lines(sheet);
  const auto cut = nest_paths(once, "cut");
  EXPECT_NEAR(doubled_length(cut), 0.0, 1e-2);
  EXPECT_NEAR(length_of(cut),
              length_of(nest_paths(sheet, "cut")) - doubled_length(nest_paths(sheet, "cut")), 1e-2)
      << "nothing else is left out";
  auto all = cut;
  for (Path& path : nest_paths(once, "label"))
    all.push_back(std::move(path));
  EXPECT_NEAR(doubled_length(all), 0.0, 1e-2) << "nor on the border of the sheet";
}

TEST(NestSheet, LeavesLinesWithoutOthersOnThemClosed) {
  NestJob job = jacket();
  job.sheets.margin = 1.0;
  const Drawing sheet = nest_sheet(job, nest(nest_pieces(job), job.sheets), 0, "jacket");
  const Drawing once = without_common_lines(sheet);
  for (const char* layer : {"cut", "label"}) {
    ASSERT_EQ(nest_paths(once, layer).size(), nest_paths(sheet, layer).size());
    for (const Path& path : nest_paths(once, layer))
      EXPECT_TRUE(path.closed);
  }
}

TEST(NestSheet, LaysTheGrainAlongTheSheet) {
  for (const Turns turns : {Turns::none, Turns::half}) {
    NestJob job = jacket();
    job.sheets.turns = turns;
    const Nesting nesting = nest(nest_pieces(job), job.sheets);
    const Drawing sheet = nest_sheet(job, nesting, 0, "jacket");
    std::size_t lines = 0;
    for (const Path& path : nest_paths(sheet, "grain")) {
      if (path.lines[0].size() != 2) continue;  // an arrow's head
      EXPECT_NEAR(path.lines[0][0].y, path.lines[0][1].y, 1e-9);
      ++lines;
    }
    EXPECT_EQ(lines, 4U);
    // 300 mm and 20 mm of allowances go along the grain, which was across.
    const auto box = oracle::outline_box(nest_paths(sheet, "cut").at(0).lines);
    EXPECT_NEAR(box.high.x - box.low.x, 320.0, 1e-3);
  }
}

TEST(NestSheet, TakesTheGrainFromTheModelToo) {
  NestJob job{{flat_patch("panel", 20, 5, {.grain = Vec3{0.0, 1.0, 0.0}})}, Unit::cm, {}};
  const auto pieces = nest_pieces(job);
  EXPECT_NEAR(pieces[0].angle, -90.0, 1e-9);
  const Nesting nesting = nest(pieces, {.width = 2500.0});
  EXPECT_NEAR(nesting.used_length, 500.0, 1e-6) << "10 cm to a cell, the short side along";
}

TEST(NestSheet, DrawsSheetsOneByOne) {
  NestJob job{{flat_patch("plate", 30, 20, {.label = {.quantity = 3}})},
              Unit::mm,
              {.width = 220.0, .length = 400.0}};
  const Nesting nesting = nest(nest_pieces(job), job.sheets);
  ASSERT_EQ(nesting.sheets, 3U);
  for (std::size_t s = 0; s < 3; ++s) {
    const Drawing sheet = nest_sheet(job, nesting, s, "hull");
    EXPECT_EQ(nest_paths(sheet, "cut").size(), 1U);
    EXPECT_THAT(nest_texts(sheet, "label"),
                testing::Contains("sheet " + std::to_string(s + 1) + " of 3"));
    const auto border = oracle::outline_box(nest_paths(sheet, "label").at(0).lines);
    EXPECT_EQ(border.high, (Vec2{400.0, 220.0}));
    EXPECT_GE(sheet.height, 270.0);
  }
}

TEST(NestSheet, GivesApparelProgramsABlockForEachCopy) {
  const NestJob job = jacket();
  const Drawing sheet = nest_sheet(job, nest(nest_pieces(job), job.sheets), 0, "jacket");
  const std::string dxf = format_dxf(sheet, {.profile = DxfProfile::aama});
  EXPECT_THAT(dxf, HasSubstr("Piece Name: front 1 of 2"));
  EXPECT_THAT(dxf, HasSubstr("Piece Name: sleeve 2 of 2"));
}

/// An L, which no turn makes its own mirror image, with a notch near one end of its long side.
NestPatch l_shape(PatternOptions annotations) {
  NestPatch patch = flat_patch("hook", 3, 5, std::move(annotations));
  auto& triangles = patch.mesh.triangles;
  triangles.erase(std::remove_if(triangles.begin(), triangles.end(),
                                 [&](const Triangle& t) {
                                   const Vec3 sum = patch.mesh.positions[t[0]] +
                                                    patch.mesh.positions[t[1]] +
                                                    patch.mesh.positions[t[2]];
                                   return sum.x > 3.0 && sum.y > 3.0;
                                 }),
                  triangles.end());
  return patch;
}

TEST(NestSheet, CutsMirrorImagesAsOftenAsTheLabelSays) {
  const NestPatch hook =
      l_shape({.notches = {Notch::at_fraction(0.04)}, .label = {.quantity = 3, .mirrored = 1}});
  const auto patches = with_mirror_images({hook});
  ASSERT_EQ(patches.size(), 2U);
  EXPECT_EQ(patches[0].annotations.label.quantity, 2);
  EXPECT_EQ(patches[1].annotations.label.quantity, 1);
  EXPECT_EQ(patches[1].name, "hook, mirrored");
  NestJob job{patches, Unit::mm, {.width = 300.0, .turns = Turns::none}};
  const Drawing sheet = nest_sheet(job, nest(nest_pieces(job), job.sheets), 0, "hooks");
  const auto cuts = nest_paths(sheet, "cut"), notches = nest_paths(sheet, "notch");
  ASSERT_EQ(cuts.size(), 3U);
  ASSERT_EQ(notches.size(), 3U);
  // Of a piece and its mirror image the notch is as far from one side as from the other.
  const auto from_left = [&](std::size_t k) {
    return std::get<NotchMark>(notches[k].mark).at.x - oracle::outline_box(cuts[k].lines).low.x;
  };
  const auto from_right = [&](std::size_t k) {
    return oracle::outline_box(cuts[k].lines).high.x - std::get<NotchMark>(notches[k].mark).at.x;
  };
  EXPECT_NEAR(from_left(0), from_left(1), 1e-9) << "two copies";
  EXPECT_NEAR(from_left(0), from_right(2), 1e-9) << "the mirror image";
  EXPECT_GT(std::abs(from_left(0) - from_left(2)), 1.0);
  EXPECT_EQ(sheet.pieces[2].name, "hook, mirrored");
}

TEST(NestSheet, LeavesPatchesWithoutMirrorImagesAsTheyAre) {
  const auto patches = with_mirror_images(jacket().patches);
  EXPECT_EQ(patches.size(), 3U);
  EXPECT_EQ(patches[2].annotations.label.quantity, 2);
  const auto all = with_mirror_images({l_shape({.label = {.quantity = 1, .mirrored = 5}})});
  ASSERT_EQ(all.size(), 1U) << "only the mirror image";
  EXPECT_EQ(all[0].annotations.label.quantity, 1);
}

TEST(PiecesSheet, HasEveryPieceOnceAndCountsItsTwins) {
  NestJob job = jacket();
  job.patches.push_back(flat_patch("sleeve, right", 15, 40, job.patches[2].annotations));
  const std::vector<std::optional<PatchTwin>> twins = {{}, {}, {}, PatchTwin{2, true, {}}};
  const Drawing sheet = pieces_sheet(job, twins, "jacket");
  ASSERT_EQ(sheet.pieces.size(), 2U);
  EXPECT_EQ(sheet.pieces[0].name, "front");
  EXPECT_EQ(sheet.pieces[1].name, "sleeve");
  EXPECT_EQ(sheet.pieces[1].quantity, 2);
  EXPECT_EQ(sheet.pieces[1].mirrored, 2);
  const auto cuts = nest_paths(sheet, "cut");
  ASSERT_EQ(cuts.size(), 2U);
  EXPECT_LT(oracle::outline_box(cuts[0].lines).high.x, oracle::outline_box(cuts[1].lines).low.x);
  EXPECT_NEAR(oracle::outline_box(cuts[1].lines).low.y, 0.0, 1e-9);
  const std::string dxf = format_dxf(sheet, {.profile = DxfProfile::astm});
  EXPECT_THAT(dxf, HasSubstr("Quantity: 2,2"));
}

}  // namespace
}  // namespace planish
