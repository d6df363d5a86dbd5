#include <algorithm>
#include <cmath>
#include <string>
#include <variant>

#include <planish/sheet/product_sheet.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/twins.h"
#include "unit/sheet/layers.h"

namespace planish {
namespace {

ProductPiece piece(const std::string& name, std::size_t columns, std::size_t rows, double shift) {
  ProductPiece piece{name, meshes::flat_grid(columns, rows), {}};
  for (const Vec3& p : piece.mesh.positions)
    piece.pattern.push_back({10.0 * p.x, 10.0 * p.y});
  for (Vec3& p : piece.mesh.positions)
    p.x += shift;
  return piece;
}

std::vector<Path> paths_of(const Layer& layer) {
  std::vector<Path> paths;
  for (const DrawingShape& shape : layer.shapes) {
    if (const auto* path = std::get_if<Path>(&shape)) paths.push_back(*path);
  }
  return paths;
}

TEST(ProductSheet, ShowsPiecesAtTrueSizeApartFromEachOther) {
  const std::vector<ProductPiece> pieces = {piece("a", 4, 3, 0.0),
                                            piece("b", 2, 3, 4.0),
                                            {"failed", meshes::flat_grid(2, 2), {}},
                                            piece("c", 3, 6, 50.0)};
  const Drawing sheet = product_sheet(pieces, {}, Unit::mm, "coat");
  const auto cuts = paths_of(layer_of(sheet, "cut"));
  ASSERT_EQ(cuts.size(), 3U);
  struct Box {
    double left, right, low, high;
  };
  std::vector<Box> boxes;
  for (const Path& path : cuts) {
    const auto& line = path.lines.at(0);
    const auto [left, right] =
        std::minmax_element(line.begin(), line.end(), [](Vec2 p, Vec2 q) { return p.x < q.x; });
    const auto [low, high] =
        std::minmax_element(line.begin(), line.end(), [](Vec2 p, Vec2 q) { return p.y < q.y; });
    boxes.push_back({left->x, right->x, low->y, high->y});
    EXPECT_GE(boxes.back().left, 9.9);
    EXPECT_GE(boxes.back().low, 9.9);
    EXPECT_LE(boxes.back().right, sheet.width - 9.9);
    EXPECT_LE(boxes.back().high, sheet.height - 9.9);
  }
  EXPECT_NEAR(boxes[0].right - boxes[0].left, 40.0, 1e-9);
  EXPECT_NEAR(boxes[2].high - boxes[2].low, 60.0, 1e-9);
  for (std::size_t i = 0; i < 3; ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      EXPECT_TRUE(boxes[i].right < boxes[j].left || boxes[j].right < boxes[i].left ||
                  boxes[i].high < boxes[j].low || boxes[j].high < boxes[i].low);
    }
  }
}

TEST(ProductSheet, NumbersBothSidesOfASeam) {
  const std::vector<ProductPiece> pieces = {piece("a", 4, 3, 0.0), piece("b", 2, 3, 4.0)};
  const std::vector<TriMesh> patches = {pieces[0].mesh, pieces[1].mesh};
  const auto seams = find_seams(patches);
  ASSERT_EQ(seams.size(), 1U);
  const Drawing sheet = product_sheet(pieces, seams, Unit::cm, "coat");
  const auto lines = paths_of(layer_of(sheet, "seam"));
  ASSERT_EQ(lines.size(), 2U);
  for (const Path& path : lines)
    EXPECT_NEAR(norm(path.lines.at(0).back() - path.lines.at(0).front()), 300.0, 1e-9);
  const auto& shapes = layer_of(sheet, "seam").shapes;
  EXPECT_EQ(std::count_if(shapes.begin(), shapes.end(),
                          [](const DrawingShape& shape) {
                            const auto* text = std::get_if<Text>(&shape);
                            return text != nullptr && text->text == "1";
                          }),
            2);
}

TEST(ProductSheet, ShowsSidesThatEndWithinAnEdge) {
  const std::vector<ProductPiece> pieces = {piece("a", 4, 3, 0.0), piece("b", 2, 3, 4.0)};
  const Seam seam = {{{SeamSide{0, {4, 9, 14, 19}, 0.5, 0.75}, SeamSide{1, {0, 3}, 0.25, 0.5}}},
                     {{0.0, 0.0}, {1.0, 1.0}}};
  const Drawing sheet = product_sheet(pieces, {{seam}}, Unit::mm, "coat");
  const auto lines = paths_of(layer_of(sheet, "seam"));
  ASSERT_EQ(lines.size(), 2U);
  ASSERT_EQ(lines[0].lines.at(0).size(), 4U);
  EXPECT_NEAR(norm(lines[0].lines[0].back() - lines[0].lines[0].front()), 22.5, 1e-12);
  ASSERT_EQ(lines[1].lines.at(0).size(), 2U);
  EXPECT_NEAR(norm(lines[1].lines[0].back() - lines[1].lines[0].front()), 2.5, 1e-12);
}

TEST(ProductSheet, ShowsMirroredPiecesMirroredToTheLastDigitWritten) {
  meshes::Random random(3);
  ProductPiece left = piece("left", 4, 3, 0.0);
  for (Vec2& p : left.pattern)
    p = p + Vec2{3.0 * random.number(), 3.0 * random.number()};
  left.pattern[7].x = 12.3455;  // half way between two thousandths
  ProductPiece right{"right", meshes::mirrored(left.mesh), left.pattern};
  PatchTwin twin{0, true, {}};
  for (Index v = 0; v < left.pattern.size(); ++v) {
    right.pattern[v].x = 0.0 - right.pattern[v].x;
    twin.vertex.push_back(v);
  }
  right.twin = twin;
  ProductPiece copy = left;
  copy.name = "copy";
  copy.twin = PatchTwin{0, false, twin.vertex};
  const Drawing sheet = product_sheet(std::vector{left, right, copy}, {}, Unit::mm, "coat");
  const auto cuts = paths_of(layer_of(sheet, "cut"));
  ASSERT_EQ(cuts.size(), 3U);
  const auto &first = cuts[0].lines.at(0), &mirror = cuts[1].lines.at(0),
             &same = cuts[2].lines.at(0);
  const auto steps = [](double x) { return std::llround(1000.0 * x); };
  const auto sum = steps(first[0].x) + steps(mirror[0].x),
             apart = steps(same[0].x) - steps(first[0].x);
  EXPECT_EQ(sum % 1000, 0);
  for (std::size_t k = 0; k < first.size(); ++k) {
    const std::size_t j = (first.size() - k) % first.size();  // it runs the other way
    EXPECT_EQ(steps(first[k].x) + steps(mirror[j].x), sum) << k;
    EXPECT_EQ(steps(same[k].x) - steps(first[k].x), apart) << k;
  }
  std::vector<std::string> names;
  for (const DrawingShape& shape : layer_of(sheet, "label").shapes)
    names.push_back(std::get<Text>(shape).text);
  EXPECT_EQ(names, (std::vector<std::string>{"left", "right (mirror image of left)",
                                             "copy (equal to left)"}));
}

}  // namespace
}  // namespace planish
