#include <algorithm>
#include <cmath>
#include <vector>

#include <planish/core/error.h>
#include <planish/sheet/nest_sheet.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sheet/piece/outline_paths.h"
#include "sheet/piece/placed_pattern.h"
#include "support/meshes.h"
#include "unit/sheet/layers.h"

namespace planish {
namespace {

/// A half of 40 x 60 mm in cells of 10 mm, with its fold along the left or the right side, turned.
struct Half {
  NestPatch patch;
  Vec2 along;  ///< of the fold, length 1
};

constexpr double k_half_width = 40.0, k_half_height = 60.0;

Index vertex_at(std::size_t column, std::size_t row) {
  return static_cast<Index>(row * 5 + column);
}

Half half_piece(PatternOptions annotations, bool fold_on_right, double degrees) {
  const std::size_t side = fold_on_right ? 4 : 0;
  annotations.fold = FoldLine{vertex_at(side, 6), vertex_at(side, 0)};
  const double angle = degrees * std::acos(-1.0) / 180.0;
  const Vec2 x = {std::cos(angle), std::sin(angle)}, y = {-x.y, x.x};
  Half half{{"half", meshes::flat_grid(4, 6), {}, std::move(annotations)}, y};
  for (const Vec3& p : half.patch.mesh.positions)
    half.patch.pattern.push_back(Vec2{3.0, 5.0} + 10.0 * p.x * x + 10.0 * p.y * y);
  return half;
}

/// One sheet with the half laid on it.
Drawing laid(const Half& half) {
  const NestJob job{with_folds_opened({half.patch}, Unit::mm), Unit::mm, {.width = 300.0}};
  return nest_sheet(job, nest(nest_pieces(job), job.sheets), 0, "sheet");
}

std::vector<Path> paths_on(const Drawing& drawing, const std::string& name) {
  std::vector<Path> paths;
  for (const DrawingShape& shape : layer_of(drawing, name).shapes) {
    if (const auto* path = std::get_if<Path>(&shape)) paths.push_back(*path);
  }
  return paths;
}

TEST(OpenedFold, IsDrawnWholeWithTheFoldAsALineInside) {
  for (const bool on_right : {false, true}) {
    for (const double degrees : {0.0, 37.0, 200.0}) {
      const Drawing sheet =
          laid(half_piece({.allowance = Allowance{.width = 8.0}}, on_right, degrees));
      const std::vector<Path> cut = paths_on(sheet, "cut"), seam = paths_on(sheet, "seam");
      ASSERT_EQ(cut.size(), 1U);
      EXPECT_TRUE(cut[0].closed);
      EXPECT_NEAR(signed_area(seam[0].lines.at(0)), 2.0 * k_half_width * k_half_height, 1e-6);
      EXPECT_NEAR(signed_area(cut[0].lines.at(0)),
                  (2.0 * k_half_width + 16.0) * (k_half_height + 16.0), 0.01);
      const std::vector<Path> fold = paths_on(sheet, "fold");
      ASSERT_EQ(fold.size(), 1U);
      const Vec2 from = fold[0].lines[0][0], to = fold[0].lines[0][1];
      EXPECT_NEAR(norm(to - from), k_half_height, 1e-9);
      EXPECT_TRUE(std::get<FoldMark>(fold[0].mark).opened);
      // The fold halves the piece.
      const Vec2 across = {from.y - to.y, to.x - from.x};
      double least = 0.0, most = 0.0;
      for (const Vec2 p : seam[0].lines[0]) {
        least = std::min(least, dot(p - from, across) / norm(across));
        most = std::max(most, dot(p - from, across) / norm(across));
      }
      EXPECT_NEAR(most, k_half_width, 1e-9);
      EXPECT_NEAR(least, -k_half_width, 1e-9);
    }
  }
}

TEST(OpenedFold, OfTheHalfAloneIsDrawnFromCutLineToCutLineAndNotCut) {
  for (const double tolerance : {0.0, 0.1}) {
    for (const bool on_right : {false, true}) {
      const Half half =
          half_piece({.allowance = Allowance{.width = 8.0}, .curves = {.tolerance = tolerance}},
                     on_right, 20.0);
      const PatternGeometry alone = placed_pattern(half.patch.mesh, half.patch.pattern, Unit::mm,
                                                   "half", half.patch.annotations);
      const Polygon fold = fold_line(alone);
      ASSERT_EQ(fold.size(), 2U);
      EXPECT_NEAR(norm(fold[1] - fold[0]), k_half_height + 16.0, 1e-3);
      EXPECT_LT(dot(fold[1] - fold[0], half.along), 0.0) << "from its own first end";
      const std::vector<Path> cut = cut_paths(alone, {}, {}).outer;
      ASSERT_EQ(cut.size(), 1U);
      EXPECT_FALSE(cut[0].closed);
      std::vector<Polygon> lines = cut[0].lines;
      if (tolerance > 0.0) {
        ASSERT_EQ(cut[0].fitted.curves.size(), 1U);
        const Curve& curve = cut[0].fitted.curves[0];
        lines.push_back({curve.start});
        for (const CurvePiece& piece : curve.pieces)
          lines.back().push_back(end_of(piece));
        lines.push_back(cut[0].fitted.few.at(0));
      }
      for (const Polygon& line : lines) {
        const bool runs_back = norm(line.front() - fold[0]) > 1.0;
        EXPECT_NEAR(norm(line.front() - fold[runs_back ? 1 : 0]), 0.0, 1e-3);
        EXPECT_NEAR(norm(line.back() - fold[runs_back ? 0 : 1]), 0.0, 1e-3);
        for (std::size_t i = 1; i + 1 < line.size(); ++i)
          EXPECT_GT(std::abs(cross(half.along, line[i] - fold[0])), 1.0) << i;
      }
    }
  }
}

TEST(OpenedFold, HasWhatIsOnTheHalfOnBothSides) {
  const PatternOptions options{
      .allowance = Allowance{.width = 8.0},
      .edge_allowances = {{vertex_at(4, 0), vertex_at(4, 6), 20.0}},
      .notches = {Notch::at_vertex(vertex_at(2, 0)), Notch::at_vertex(vertex_at(0, 0)),
                  Notch::at_fraction(0.3), Notch::on_edge(vertex_at(4, 2), vertex_at(4, 3), 0.5)},
      .marks = {{.vertex = vertex_at(2, 3)}, {.vertex = vertex_at(0, 3)}},
      .inner_lines = {{vertex_at(1, 1), vertex_at(3, 1)}, {vertex_at(0, 2), vertex_at(0, 4)}}};
  const Drawing sheet = laid(half_piece(options, false, 0.0));
  EXPECT_EQ(paths_on(sheet, "notch").size(), 7U) << "that on the fold once";
  EXPECT_EQ(paths_on(sheet, "drill").size(), 3U);
  EXPECT_EQ(paths_on(sheet, "internal").size(), 3U);
  EXPECT_NEAR(signed_area(paths_on(sheet, "cut")[0].lines.at(0)),
              (2.0 * k_half_width + 40.0) * (k_half_height + 16.0), 0.01);
  // Every notch has its mirror image in the fold.
  const std::vector<Vec2> fold = paths_on(sheet, "fold").at(0).lines.at(0);
  const Vec2 along = 1.0 / norm(fold[1] - fold[0]) * (fold[1] - fold[0]);
  const std::vector<Path> notches = paths_on(sheet, "notch");
  for (const Path& notch : notches) {
    const Vec2 p = notch.lines[0][0] - fold[0];
    const Vec2 image = fold[0] + 2.0 * dot(p, along) * along - p;
    EXPECT_TRUE(std::any_of(notches.begin(), notches.end(), [&](const Path& other) {
      return norm(other.lines[0][0] - image) < 1e-6;
    }));
  }
}

TEST(OpenedFold, HasBothOfADoubleNotchAtTheEndOfTheFoldAndTheHalfOneOfThem) {
  for (const bool on_right : {false, true}) {
    for (const std::size_t row : {0U, 6U}) {
      const Index end = vertex_at(on_right ? 4 : 0, row);
      const Half half = half_piece({.allowance = Allowance{.width = 8.0},
                                    .notches = {Notch::at_vertex(end, NotchKind::slit, true)},
                                    .notch_sizes = {.depth = 4.0}},
                                   on_right, 20.0);
      const PatternGeometry alone = placed_pattern(half.patch.mesh, half.patch.pattern, Unit::mm,
                                                   "half", half.patch.annotations);
      ASSERT_EQ(alone.notches.size(), 1U);
      EXPECT_NEAR(std::abs(cross(half.along, alone.notches[0].at - alone.positions[end])), 3.0,
                  1e-4);
      const std::vector<Path> notches = paths_on(laid(half), "notch");
      ASSERT_EQ(notches.size(), 2U);
      EXPECT_NEAR(
          norm(std::get<NotchMark>(notches[0].mark).at - std::get<NotchMark>(notches[1].mark).at),
          6.0, 1e-4);
    }
  }
}

TEST(OpenedFold, KeepsTheGrainOfTheHalf) {
  const Half half = half_piece({.grain = Vec3{1.0, 0.0, 0.0}}, false, 30.0);
  const auto opened = with_folds_opened({half.patch}, Unit::mm);
  EXPECT_NEAR(std::get<double>(*opened[0].annotations.grain), 30.0, 1e-9);
}

TEST(OpenedFold, RefusesANotchOnTheFold) {
  for (const Notch& notch :
       {Notch::at_vertex(vertex_at(0, 3)), Notch::on_edge(vertex_at(0, 3), vertex_at(0, 4), 0.5)}) {
    try {
      with_folds_opened({half_piece({.notches = {notch}}, false, 0.0).patch}, Unit::mm);
      ADD_FAILURE() << "no error";
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ErrorCode::misplaced_notch);
      EXPECT_THAT(error.message(), testing::HasSubstr("is on the fold"));
    }
  }
}

TEST(OpenedFold, LeavesOtherPatchesAsTheyAre) {
  Half half = half_piece({}, false, 0.0);
  half.patch.annotations.fold.reset();
  const auto same = with_folds_opened({half.patch}, Unit::mm);
  EXPECT_EQ(same[0].mesh.triangles, half.patch.mesh.triangles);
  EXPECT_EQ(same[0].pattern, half.patch.pattern);
}

}  // namespace
}  // namespace planish
