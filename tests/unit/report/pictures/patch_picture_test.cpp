#include "report/pictures/patch_picture.h"

#include <cmath>
#include <cstddef>

#include <planish/draw/color.h>

#include <gtest/gtest.h>

#include "report/pictures/view.h"
#include "support/sample_report.h"

namespace planish {
namespace {

TEST(View, IsThreeDirectionsAtRightAnglesSeenFromOutside) {
  const View view = view_of(samples::bumpy_patch(20, 60, 2.0));
  EXPECT_NEAR(norm(view.right), 1.0, 1e-12);
  EXPECT_NEAR(norm(view.up), 1.0, 1e-12);
  EXPECT_NEAR(norm(view.towards), 1.0, 1e-12);
  EXPECT_NEAR(dot(view.right, view.up), 0.0, 1e-12);
  EXPECT_NEAR(dot(cross(view.right, view.up), view.towards), 1.0, 1e-12) << "no mirror image";
  EXPECT_GT(view.towards.z, 0.8) << "the outer side of a grid over the plane is up";
}

TEST(View, HasTheLongestExtentLevel) {
  EXPECT_NEAR(view_of(meshes::flat_grid(10, 40)).right.y, 1.0, 1e-5);
  EXPECT_NEAR(view_of(meshes::flat_grid(40, 10)).right.x, 1.0, 1e-5);
}

TEST(View, LiftsTheEyeMoreOverAHighPatch) {
  const View flat = view_of(meshes::flat_grid(20, 60));
  const View high = view_of(samples::bumpy_patch(20, 60, 20.0));
  EXPECT_GT(flat.up.z, 0.3) << "the outer side is up";
  EXPECT_GT(high.up.z, flat.up.z + 0.1);
  EXPECT_NEAR(high.right.z, 0.0, 0.1);
}

TEST(View, IsDefinedWhereTheNormalsCancelOut) {
  TriMesh tube;  // a whole cylinder along z
  constexpr Index around = 24, rings = 12;
  for (Index j = 0; j < rings; ++j) {
    for (Index i = 0; i < around; ++i) {
      const double angle = 2.0 * 3.141592653589793 * i / around;
      tube.positions.push_back({std::cos(angle), std::sin(angle), 1.0 * j});
      const Index right = j * around + (i + 1) % around, here = j * around + i;
      if (j + 1 == rings) continue;
      tube.triangles.push_back({here, right, right + around});
      tube.triangles.push_back({here, right + around, here + around});
    }
  }
  const View view = view_of(tube);
  EXPECT_NEAR(norm(view.towards), 1.0, 1e-12);
  EXPECT_GT(view.right.z, 0.9);
}

TEST(View, DoesNotHangOnTheSizeOfTheModel) {
  TriMesh mesh = samples::bumpy_patch(20, 30, 2.0);
  const View view = view_of(mesh);
  for (Vec3& p : mesh.positions)
    p = 0x1p-600 * p;
  EXPECT_EQ(view_of(mesh).towards, view.towards);
  EXPECT_EQ(view_of(mesh).up, view.up);
}

std::size_t covered(const Image& image) {
  std::size_t count = 0;
  for (const std::uint8_t alpha : image.alpha)
    count += alpha == 255 ? 1 : 0;
  return count;
}

// Of a patch and one thing that became of it.
PatchPictures pictures_of(const TriMesh& before, const TriMesh& after, ColorMap colors) {
  const std::vector<std::span<const Vec3>> positions = {after.positions};
  return patch_pictures(Patch(before), positions, colors, 880);
}

TEST(PatchPictures, ShowBothPatchesAlikeAndFillThePicture) {
  const TriMesh before = samples::bumpy_patch(30, 40, 2.0);
  const TriMesh after = samples::bumpy_patch(30, 40, 0.0);
  const PatchPictures pictures = pictures_of(before, after, ColorMap::diverging);
  EXPECT_EQ(pictures.before.width, pictures.after.front().width);
  EXPECT_EQ(pictures.before.height, pictures.after.front().height);
  const double share = static_cast<double>(covered(pictures.before)) /
                       static_cast<double>(pictures.before.pixels.size());
  EXPECT_GT(share, 0.5);
  EXPECT_NEAR(static_cast<double>(covered(pictures.after.front())),
              static_cast<double>(covered(pictures.before)),
              0.1 * static_cast<double>(pictures.before.pixels.size()));
}

TEST(PatchPictures, HaveNoColourWhereThePatchIsFlat) {
  const TriMesh flat = meshes::flat_grid(12, 12);
  const PatchPictures pictures = pictures_of(flat, flat, ColorMap::diverging);
  EXPECT_EQ(pictures.limit, 1e-4) << "less is not to look like anything";
  for (std::size_t i = 0; i < pictures.after.front().pixels.size(); ++i) {
    const Color color = pictures.after.front().pixels[i];
    ASSERT_EQ(color.r, color.g);
    ASSERT_EQ(color.g, color.b);
  }
}

TEST(PatchPictures, ShowDomesRedAndSaddlesBlueUpToTheBorder) {
  const auto dominance = [](const TriMesh& mesh) {
    int red = 0, blue = 0;
    const PatchPictures pictures = pictures_of(mesh, mesh, ColorMap::diverging);
    for (const Color color : pictures.before.pixels) {
      if (color.r > color.b + 4) ++red;
      if (color.b > color.r + 4) ++blue;
    }
    return std::pair{red, blue};
  };
  const auto dome = meshes::height_field(30, 30, [](double x, double y) {
    return -0.01 * ((x - 15) * (x - 15) + (y - 15) * (y - 15));
  });
  const auto saddle = meshes::height_field(30, 30, [](double x, double y) {
    return 0.01 * ((x - 15) * (x - 15) - (y - 15) * (y - 15));
  });
  const auto [dome_red, dome_blue] = dominance(dome);
  EXPECT_GT(dome_red, 100'000);
  EXPECT_EQ(dome_blue, 0);
  const auto [saddle_red, saddle_blue] = dominance(saddle);
  EXPECT_GT(saddle_blue, 100'000);
  EXPECT_EQ(saddle_red, 0);
}

TEST(PatchPictures, SetTheScaleByThePatchAsItCame) {
  const TriMesh steep = samples::bumpy_patch(30, 20, 2.0);
  const TriMesh flat = samples::bumpy_patch(30, 20, 0.1);
  EXPECT_EQ(pictures_of(steep, flat, ColorMap::paper).limit,
            pictures_of(steep, steep, ColorMap::paper).limit);
  EXPECT_LT(pictures_of(flat, steep, ColorMap::paper).limit,
            pictures_of(steep, flat, ColorMap::paper).limit);
}

}  // namespace
}  // namespace planish
