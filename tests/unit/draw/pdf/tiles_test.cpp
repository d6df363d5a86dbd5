#include "draw/pdf/tiles.h"

#include <algorithm>
#include <string>

#include <planish/core/error.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

std::vector<bool> used(DrawingShape shape, Vec2 sheet, const TileGrid& grid) {
  return used_tiles({"t", sheet.x, sheet.y, {Layer{"cut", {std::move(shape)}}}}, grid);
}

TEST(TileGrid, CoversTheSheetWithOverlapsFromItsUpperLeftCorner) {
  for (const Vec2 sheet : {Vec2{10, 10}, Vec2{190, 277}, Vec2{191, 277}, Vec2{900, 1300}}) {
    for (const Paper& paper : papers()) {
      const TileGrid grid = tile_grid(sheet, {paper});
      EXPECT_GE(grid.size().x, sheet.x - 1e-3);
      EXPECT_GE(grid.size().y, sheet.y - 1e-3);
      const Vec2 first = grid.low_of(0, 0), last = grid.low_of(grid.rows - 1, grid.columns - 1);
      EXPECT_DOUBLE_EQ(first.x, 0.0);
      EXPECT_DOUBLE_EQ(first.y + grid.frame.y, sheet.y);
      EXPECT_TRUE(grid.columns == 1 || last.x + grid.overlap < sheet.x) << "no column too much";
      EXPECT_TRUE(grid.rows == 1 || last.y + grid.frame.y - grid.overlap > 0.0);
      if (grid.columns > 1) {
        EXPECT_DOUBLE_EQ(grid.low_of(0, 1).x + grid.overlap, grid.frame.x);
      }
      EXPECT_DOUBLE_EQ(grid.frame.x, grid.page.x - 2.0 * k_tile_margin);
    }
  }
}

TEST(TileGrid, LaysThePaperAsNeedsFewerPages) {
  const TileGrid upright = tile_grid({190.0, 277.0}, {paper_named("a4")});
  EXPECT_EQ(upright.columns * upright.rows, 1U);
  EXPECT_EQ(upright.page, (Vec2{210.0, 297.0}));
  const TileGrid across = tile_grid({277.0, 190.0}, {paper_named("a4")});
  EXPECT_EQ(across.columns * across.rows, 1U);
  EXPECT_EQ(across.page, (Vec2{297.0, 210.0}));
}

TEST(TileGrid, RefusesMorePagesThanAnyoneJoins) {
  try {
    tile_grid({90000.0, 90000.0}, {paper_named("a4")});
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.code(), ErrorCode::too_large);
    EXPECT_THAT(error.what(), HasSubstr("10,000 pages"));
  }
}

TEST(TileName, CountsRowsInLettersAndColumnsInNumbers) {
  EXPECT_EQ(tile_name(0, 0), "A1");
  EXPECT_EQ(tile_name(25, 9), "Z10");
  EXPECT_EQ(tile_name(26, 0), "AA1");
  EXPECT_EQ(tile_name(27, 0), "AB1");
  EXPECT_EQ(tile_name(702, 0), "AAA1");
}

TEST(UsedTiles, AreThoseThatALineMeets) {
  const Vec2 sheet = {540.0, 801.0};
  const TileGrid grid =
      tile_grid(sheet, {paper_named("a4")});  // frames of 190 x 277, steps 180 x 267
  ASSERT_EQ(grid.columns, 3U);
  ASSERT_EQ(grid.rows, 3U);
  // From the upper left corner straight down to the lower right one.
  EXPECT_THAT(used(Path{{{{5, 796}, {535, 5}}}, false, Stroke{}}, sheet, grid),
              ElementsAre(true, true, false, true, true, true, false, true, true));
  EXPECT_THAT(used(Path{{{{5, 796}, {170, 600}}}, false, Stroke{}}, sheet, grid),
              ElementsAre(true, false, false, false, false, false, false, false, false));
  EXPECT_THAT(used(Text{{400.0, 10.0}, 5.0, "Text"}, sheet, grid),
              ElementsAre(false, false, false, false, false, false, false, false, true));
  EXPECT_THAT(used(Path{{{{5, 796}, {535, 5}}}}, sheet, grid), testing::Each(false));
}

TEST(UsedTiles, HoldTheInsideOfWhatIsClosedButNotItsHoles) {
  const Vec2 sheet = {900.0, 1335.0};
  const TileGrid grid = tile_grid(sheet, {paper_named("a4")});
  ASSERT_EQ(grid.columns * grid.rows, 25U);
  const std::vector<Vec2> border = {{1, 1}, {899, 1}, {899, 1334}, {1, 1334}};
  const auto middle = [&](const std::vector<bool>& tiles) { return tiles[12]; };
  EXPECT_TRUE(middle(used(Path{{border}, true, Stroke{}}, sheet, grid)));
  EXPECT_FALSE(middle(used(Path{{border}, false, Stroke{}}, sheet, grid)));
  const std::vector<Vec2> hole = {{300, 450}, {600, 450}, {600, 880}, {300, 880}};
  EXPECT_FALSE(middle(used(Path{{border, hole}, true, Stroke{}}, sheet, grid)));
}

TEST(WriteTiledPdf, HasAMapAndAPageForEveryTileThatIsUsed) {
  const Drawing drawing = {
      "t", 540.0, 801.0, {Layer{"cut", {Path{{{{5, 796}, {535, 5}}}, false, Stroke{}}}}}};
  const std::string pdf = format_tiled_pdf(drawing, {paper_named("a4")});
  // Upright it has 3 x 3 tiles, of which 7 are used; across 2 x 5, of which 6 are.
  EXPECT_THAT(pdf, HasSubstr("/Count 7 "));
  EXPECT_THAT(pdf, HasSubstr("(A2) Tj")) << "the map names all";
  EXPECT_THAT(pdf, testing::Not(HasSubstr("(A2: row")));
  EXPECT_THAT(pdf, HasSubstr("(C2: row 3 of 5, column 2 of 2. t) Tj"));
  EXPECT_EQ(pdf, format_tiled_pdf(drawing, {paper_named("a4")}));
}

TEST(Papers, AreKnownByTheirNames) {
  for (const Paper& paper : papers()) {
    EXPECT_EQ(paper_named(paper.name), paper);
    EXPECT_LT(paper.width, paper.height) << "upright";
  }
  EXPECT_THROW(paper_named("a5"), Error);
}

TEST(UsedTiles, HoldTheInsideOfAPieceThatIsOpenAlongItsFold) {
  const Vec2 sheet = {900.0, 1335.0};
  const TileGrid grid = tile_grid(sheet, {paper_named("a4")});
  const Path cut{{{{1, 1}, {899, 1}, {899, 1334}, {1, 1334}}}, false, Stroke{}};
  Path fold{{{{1, 1334}, {1, 1}}}, false, Stroke{}};
  for (const bool opened : {false, true}) {
    fold.mark = FoldMark{fold.lines[0][0], fold.lines[0][1], opened};
    const std::vector<bool> used =
        used_tiles({"t", sheet.x, sheet.y, {Layer{"cut", {cut}}, Layer{"fold", {fold}}}}, grid);
    EXPECT_EQ(used[12], !opened);
  }
}

}  // namespace
}  // namespace planish
