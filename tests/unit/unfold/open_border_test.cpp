#include "unfold/open_border.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include <planish/flatten/flatten.h>

#include <gtest/gtest.h>

#include "geometry/crosses_itself.h"
#include "support/meshes.h"

namespace planish {
namespace {

constexpr std::size_t k_cells = 20;
constexpr double k_side = 100.0;  // millimetres

/// A square with a slit: from the middle of the lower side up to the middle of the square, its
/// sides apart from each other.
struct SlitSquare {
  TriMesh mesh;
  std::vector<Index> left, right;  ///< sides of the slit, from below
};

SlitSquare slit_square() {
  SlitSquare square{meshes::flat_grid(k_cells, k_cells), {}, {}};
  const Index row = k_cells + 1, middle = k_cells / 2;
  for (Vec3& p : square.mesh.positions)
    p = (k_side / k_cells) * p;
  for (Index k = 0; k < middle; ++k) {
    const Index v = k * row + middle;
    square.left.push_back(v);
    square.right.push_back(static_cast<Index>(square.mesh.positions.size()));
    square.mesh.positions.push_back(square.mesh.positions[v]);
  }
  for (Triangle& t : square.mesh.triangles) {
    double x = 0.0;
    for (const Index v : t)
      x += square.mesh.positions[v].x / 3.0;
    if (x < 0.5 * k_side) continue;
    for (Index& v : t) {
      for (std::size_t k = 0; k < square.left.size(); ++k)
        if (v == square.left[k]) v = square.right[k];
    }
  }
  return square;
}

struct Layout {
  Disk disk;
  std::vector<Vec2> flat;  ///< by the disk's numbers
  double scale;            ///< from millimetres
};

/// The square with the sides of the slit pushed over each other by `depth` - 0.02, most in the
/// middle of the slit.
TriMesh pushed_square(double depth) {
  SlitSquare square = slit_square();
  for (std::size_t k = 0; k < square.left.size(); ++k) {
    const double share = static_cast<double>(k) / static_cast<double>(square.left.size());
    const double move = 0.5 * depth * 16.0 * std::pow(share * (1.0 - share), 2) - 0.01;
    square.mesh.positions[square.left[k]].x += move;
    square.mesh.positions[square.right[k]].x -= move;
  }
  return std::move(square.mesh);
}

Layout pushed(double depth) {
  const TriMesh mesh = pushed_square(depth);
  Layout layout{make_disk(Patch(mesh)), {}, 1.0};
  layout.scale = layout.disk.area_scale * layout.disk.box_scale;
  for (const Index v : layout.disk.vertex_of)
    layout.flat.push_back(layout.scale * Vec2{mesh.positions[v].x, mesh.positions[v].y});
  return layout;
}

std::optional<OpenBorder> opened(const Layout& layout, double most) {
  return open_border(layout.disk, layout.flat, layout.scale * most);
}

TEST(OpenBorder, MovesTheSidesOfAHairThinOverlapApart) {
  const Layout layout = pushed(0.08);
  ASSERT_TRUE(crosses_itself(border_of(layout.disk, layout.flat)));
  const auto open = opened(layout, 0.1);
  ASSERT_TRUE(open);
  EXPECT_FALSE(crosses_itself(border_of(layout.disk, open->flat)));
  EXPECT_EQ(open->crossings, 2U);
  double largest = 0.0;
  for (Index v = 0; v < layout.flat.size(); ++v) {
    const double move = norm(open->flat[v] - layout.flat[v]) / layout.scale;
    EXPECT_TRUE(layout.disk.is_border(v) || move == 0.0) << "inner vertex " << v;
    EXPECT_LE(move, 0.1);
    largest = std::max(largest, move);
  }
  // The sides lie over each other by 0.06 in the middle: each goes back by half of it.
  EXPECT_NEAR(largest, 0.03, 0.01);
  EXPECT_DOUBLE_EQ(open->largest_move / layout.scale, largest);
  EXPECT_EQ(norm(open->flat[open->vertex] - layout.flat[open->vertex]), open->largest_move);
}

TEST(OpenBorder, LeavesWhatLiesOverItselfByMore) {
  EXPECT_FALSE(opened(pushed(0.5), 0.1));
  EXPECT_TRUE(opened(pushed(0.5), 0.5));
  EXPECT_FALSE(opened(pushed(0.08), 0.0));
  EXPECT_FALSE(opened(pushed(0.08), std::nan("")));
}

TEST(OpenBorder, ChangesNothingWithoutCrossings) {
  const Layout layout = pushed(0.0);
  ASSERT_FALSE(crosses_itself(border_of(layout.disk, layout.flat)));
  const auto open = opened(layout, 0.1);
  ASSERT_TRUE(open);
  EXPECT_EQ(open->largest_move, 0.0);
  EXPECT_EQ(open->crossings, 0U);
}

TEST(OpenBorder, IsDoneByAJobForATenthOfAMillimetre) {
  const Patch patch(pushed_square(0.08));
  EXPECT_TRUE(unfold(patch).overlaps) << "only where it is asked for";

  const UnfoldReport report = unfold_patch(patch, Unit::mm);
  EXPECT_FALSE(report.pattern.overlaps);
  EXPECT_FALSE(report.overlap);
  ASSERT_TRUE(report.pattern.opened);
  EXPECT_EQ(report.pattern.opened->crossings, 2U);
  EXPECT_NEAR(report.pattern.opened->largest_move, 0.03, 0.01);
  EXPECT_FALSE(overlap_of(patch, report.pattern));

  TriMesh small = pushed_square(0.08);
  for (Vec3& p : small.positions)
    p = 0.1 * p;
  EXPECT_TRUE(unfold_patch(Patch(small), Unit::cm).pattern.opened);
  TriMesh thick = pushed_square(0.3);
  for (Vec3& p : thick.positions)
    p = 0.1 * p;
  EXPECT_FALSE(unfold_patch(Patch(thick), Unit::mm).pattern.opened)
      << "by 0.03 mm, but of a piece of 10 mm";

  const UnfoldReport in_metres = unfold_patch(patch, Unit::m);
  EXPECT_TRUE(in_metres.pattern.overlaps) << "by 60 mm";
  EXPECT_FALSE(in_metres.pattern.opened);
  ASSERT_TRUE(in_metres.overlap);
  EXPECT_EQ(in_metres.overlap->crossings, 2U);
  EXPECT_LT(norm(in_metres.overlap->high - in_metres.overlap->low), k_side);
}

}  // namespace
}  // namespace planish
