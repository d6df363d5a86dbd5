#include "draw/cutting_order.h"

#include <limits>
#include <string>
#include <variant>
#include <vector>

#include <planish/draw/format_drawing.h>

#include <gtest/gtest.h>

#include "oracle/drawn_lines.h"

namespace planish {
namespace {

std::vector<Vec2> square_at(double low, double side) {
  return {{low, low}, {low + side, low}, {low + side, low + side}, {low, low + side}};
}

/// A piece with a hole in a hole's island, outline first, and a mark on it.
Path cut_with_holes(std::size_t piece) {
  const double at = 200.0 * static_cast<double>(piece);
  Path path{{square_at(at, 100.0), square_at(at + 40.0, 10.0), square_at(at + 30.0, 40.0)},
            true,
            Stroke{}};
  path.piece = piece;
  return path;
}

Path mark_on(std::size_t piece) {
  const double at = 200.0 * static_cast<double>(piece) + 5.0;
  Path path{{{{at, at}, {at + 3.0, at}}}, false, Stroke{{0, 0, 255}}};
  path.piece = piece;
  return path;
}

Drawing two_pieces() {
  return {"two",
          400.0,
          400.0,
          {{"notch", {mark_on(0), mark_on(1)}}, {"cut", {cut_with_holes(1), cut_with_holes(0)}}}};
}

TEST(InnerFirst, PutsWhatEnclosesLessBeforeWhatEnclosesMore) {
  Path path = cut_with_holes(0);
  path.fitted.few = path.lines;
  for (const auto& line : path.lines)
    path.fitted.curves.push_back({line.front(), {}});
  const Path ordered = inner_first(path);
  ASSERT_EQ(ordered.lines.size(), 3U);
  EXPECT_EQ(ordered.lines[0], path.lines[1]);
  EXPECT_EQ(ordered.lines[1], path.lines[2]);
  EXPECT_EQ(ordered.lines[2], path.lines[0]);
  EXPECT_EQ(ordered.fitted.few, ordered.lines);
  for (std::size_t i = 0; i < 3; ++i)
    EXPECT_EQ(ordered.fitted.curves[i].start, ordered.lines[i].front());
  path.closed = false;
  EXPECT_EQ(inner_first(path).lines, path.lines) << "what encloses nothing stays";
}

TEST(InnerFirst, TakesLinesThatAreNowhereAsEnclosingNothing) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  Path path{{square_at(0.0, 9.0), {{nan, 0.0}, {1.0, 1.0}, {2.0, 0.0}}}, true, Stroke{}};
  EXPECT_EQ(inner_first(path).lines[1], path.lines[0]);
}

TEST(CuttingOrder, IsPieceByPieceInTheOrderOfTheLayers) {
  std::vector<std::string> order;
  for (const Layer& layer : in_cutting_order(two_pieces())) {
    for (const DrawingShape& shape : layer.shapes)
      order.push_back(layer.name + " " + std::to_string(std::get<Path>(shape).piece));
  }
  EXPECT_EQ(order, (std::vector<std::string>{"notch 0", "cut 0", "notch 1", "cut 1"}));
}

/// Marks, holes and outline of the first piece, then of the second, by the first place of each.
void expect_cutting_order(const oracle::Lines& lines) {
  ASSERT_EQ(lines.size(), 8U);
  const std::vector<double> wanted = {5.0, 40.0, 30.0, 0.0, 205.0, 240.0, 230.0, 200.0};
  for (std::size_t i = 0; i < wanted.size(); ++i)
    EXPECT_EQ(lines[i].front().x, wanted[i]) << i;
  for (const std::size_t i : {1U, 2U, 3U, 5U, 6U, 7U})
    EXPECT_EQ(lines[i].front(), lines[i].back()) << "closed";
}

TEST(CuttingOrder, IsThatOfHpglAndDxf) {
  expect_cutting_order(oracle::lines_of_plt(format_plt(two_pieces())));
  expect_cutting_order(oracle::lines_of_dxf(format_dxf(two_pieces())));
  const std::string dxf = format_dxf(two_pieces(), {.version = DxfVersion::r2000});
  std::vector<std::string> firsts;
  bool is_first = false;
  for (const auto& [code, value] : oracle::tags_of_dxf(dxf)) {
    if (code == 0) is_first = value == "LWPOLYLINE";
    if (code == 10 && is_first) firsts.emplace_back(value);
    if (code == 10) is_first = false;
  }
  EXPECT_EQ(firsts, (std::vector<std::string>{"5.0", "40.0", "30.0", "0.0", "205.0", "240.0",
                                              "230.0", "200.0"}));
}

TEST(CuttingOrder, OfSvgHasHolesBeforeTheirOutline) {
  const oracle::Lines lines = oracle::lines_of_svg(format_svg(two_pieces()));
  ASSERT_EQ(lines.size(), 8U);
  EXPECT_EQ(lines[2].front().x, 240.0);
  EXPECT_EQ(lines[4].front().x, 200.0);
}

}  // namespace
}  // namespace planish
