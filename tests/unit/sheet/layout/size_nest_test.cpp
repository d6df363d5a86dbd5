#include <cmath>

#include <planish/core/error.h>
#include <planish/sheet/nest_sheet.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "oracle/outline_gap.h"
#include "support/meshes.h"
#include "unit/sheet/layers.h"

namespace planish {
namespace {

/// A box of 40 x 60 mm times a scale, turned and moved away.
NestPatch size_patch(const std::string& size, double scale, double radians, Vec2 shift) {
  NestPatch patch{"box-" + size, meshes::flat_grid(4, 6), {}, {}};
  patch.annotations.label.size = size;
  patch.annotations.allowance = Allowance{.width = 5.0};
  for (const Vec3& p : patch.mesh.positions) {
    const Vec2 q = 10.0 * scale * Vec2{p.x, p.y};
    patch.pattern.push_back(shift + Vec2{q.x * std::cos(radians) - q.y * std::sin(radians),
                                         q.x * std::sin(radians) + q.y * std::cos(radians)});
  }
  return patch;
}

const Path& first_path(const Drawing& drawing, const std::string& layer) {
  for (const DrawingShape& shape : layer_of(drawing, layer).shapes) {
    if (const auto* path = std::get_if<Path>(&shape)) return *path;
  }
  throw std::logic_error("no path");
}

TEST(SizeNest, LaysSizesOntoTheMiddleOne) {
  const std::vector<NestPatch> sizes = {size_patch("S", 0.9, 0.4, {500.0, 3.0}),
                                        size_patch("M", 1.0, 0.0, {}),
                                        size_patch("L", 1.2, -2.0, {-70.0, 90.0})};
  const Drawing nest = size_nest(sizes, Unit::mm, "box");
  ASSERT_EQ(nest.layers.size(), 4U);
  EXPECT_EQ(nest.layers.back().name, "label");
  std::vector<Vec2> middles;
  for (const auto& [name, scale] : {std::pair{"S", 0.9}, {"M", 1.0}, {"L", 1.2}}) {
    const Path& seam = first_path(nest, name);
    const oracle::OutlineBox box = oracle::outline_box({seam.lines.front()});
    EXPECT_NEAR(box.high.x - box.low.x, 40.0 * scale, 1e-9) << name << " is turned back";
    EXPECT_NEAR(box.high.y - box.low.y, 60.0 * scale, 1e-9);
    middles.push_back(0.5 * (box.low + box.high));
  }
  EXPECT_NEAR(norm(middles[0] - middles[1]), 0.0, 1e-9);
  EXPECT_NEAR(norm(middles[2] - middles[1]), 0.0, 1e-9);
  EXPECT_FALSE(first_path(nest, "S").stroke->color == first_path(nest, "L").stroke->color);
}

TEST(SizeNest, RefusesOtherTriangles) {
  std::vector<NestPatch> sizes = {size_patch("S", 1.0, 0.0, {}), size_patch("M", 1.0, 0.0, {})};
  std::swap(sizes[1].mesh.triangles[0], sizes[1].mesh.triangles[1]);
  EXPECT_THROW(size_nest(sizes, Unit::mm, "box"), Error);
  EXPECT_TRUE(size_nest({}, Unit::mm, "box").layers.empty());
}

}  // namespace
}  // namespace planish
