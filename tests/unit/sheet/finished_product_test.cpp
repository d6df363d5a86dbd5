#include <planish/mesh/shapes.h>
#include <planish/sheet/nest_sheet.h>
#include <planish/sheet/product_sheet.h>

#include <gtest/gtest.h>

#include "support/meshes.h"
#include "support/products.h"
#include "support/twins.h"
#include "unit/sheet/layers.h"

namespace planish {
namespace {

ProductOptions quick() {
  return {.flatten = {.method = ControllableLaplacian{}, .stopping = Stopping{.max_sweeps = 1}}};
}

/// Two strips with a seam, the mirror image of the first one elsewhere, and what failed.
std::vector<ProductPatch> coat() {
  std::vector<ProductPatch> patches;
  for (NamedPatch& strip : in_strips(meshes::rough_grid(12, 6, 3, 0.2, 0.3), 2))
    patches.push_back({strip.name, std::move(strip.mesh)});
  patches.push_back({"mirrored", meshes::turned(meshes::mirrored(patches[0].mesh))});
  patches.push_back({"lost", {}, {}, Failure{"file_unreadable", "lost"}});
  return patches;
}

TEST(PatchesToCut, HaveNotchesOnTheirSeamsAndMirroredAnnotations) {
  const std::vector<ProductPatch> patches = coat();
  const ProductReport report = flatten_product(patches, quick());
  ASSERT_EQ(report.seams.size(), 1U);
  const PatternOptions own{.grain = 20.0};
  const std::vector<SeamNotch> notches = {{.place = 0.5}};
  const auto to_cut = patches_to_cut(patches, report, {4, own}, notches);
  ASSERT_EQ(to_cut.size(), 4U);
  for (const std::size_t p : {0U, 1U}) {
    EXPECT_EQ(to_cut[p].annotations.notches.size(), 1U);
    EXPECT_EQ(std::get<double>(*to_cut[p].annotations.grain), 20.0);
    EXPECT_EQ(to_cut[p].pattern, report.patches[p].finished->unfold.pattern.positions);
  }
  EXPECT_EQ(to_cut[2].annotations.notches.size(), 0U);
  EXPECT_NE(std::get<double>(*to_cut[2].annotations.grain), 20.0);
  EXPECT_TRUE(to_cut[3].pattern.empty());
  EXPECT_EQ(to_cut[3].name, "lost");
}

TEST(ProductSheet, OfAReportLeavesOutWhatIsNotFinished) {
  const std::vector<ProductPatch> patches = coat();
  const ProductReport report = flatten_product(patches, quick());
  const Drawing sheet = product_sheet(report, "coat");
  EXPECT_EQ(sheet.pieces.size(), 4U);
  EXPECT_EQ(layer_of(sheet, "cut").shapes.size(), 3U);
  EXPECT_EQ(layer_of(sheet, "seam").shapes.size(), 4U) << "both sides of the seam, and its number";
}

TEST(AnnotationsOfTwin, BeginWhereTheOtherOneBegins) {
  const std::vector<ProductPatch> patches = coat();
  const ProductReport report = flatten_product(patches, quick());
  ASSERT_TRUE(report.twins[2]);
  const auto own = annotations_of_twin({.grain = 20.0}, patches[0].mesh, *report.twins[2]);
  ASSERT_TRUE(own.like);
  EXPECT_TRUE(own.like->mirrored);
  EXPECT_NE(std::get<double>(*own.grain), 20.0);
}

}  // namespace
}  // namespace planish
