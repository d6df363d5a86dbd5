#include <cmath>

#include <planish/flatten/product.h>
#include <planish/mesh/cut.h>
#include <planish/mesh/shapes.h>
#include <planish/panels/suggest_panels.h>

#include <gtest/gtest.h>

#include "mesh/split.h"
#include "support/products.h"
#include "support/seams.h"
#include "support/solids.h"

namespace planish {
namespace {

std::vector<ProductPatch> pieces_of(const std::vector<NamedPatch>& meshes) {
  std::vector<ProductPatch> patches;
  for (const NamedPatch& piece : meshes)
    patches.push_back({piece.name, piece.mesh});
  return patches;
}

ProductOptions with_common_lengths() {
  ProductOptions options;
  options.flatten.least_stretch = true;
  options.common_lengths = true;
  return options;
}

double edge_in(const PatchResult& patch, const std::vector<Index>& side, std::size_t k) {
  const std::vector<Vec2>& flat = patch.finished->unfold.pattern.positions;
  return norm(flat[side[k + 1]] - flat[side[k]]);
}

TEST(CommonLengths, AreTheMeanOfThoseInBothPatterns) {
  const std::vector<ProductPatch> patches = pieces_of(in_strips(make_shape("saddle", 300), 3));
  ProductOptions options = with_common_lengths();
  const ProductReport common = flatten_product(patches, options);
  options.common_lengths = false;
  const ProductReport own = flatten_product(patches, options);
  options.match_seams = false;
  const ProductReport apart = flatten_product(patches, options);
  ASSERT_EQ(common.seams.size(), 2U);
  for (const MeasuredSeam& seam : common.seams) {
    const auto& [one, other] = seam.seam.sides;
    for (std::size_t k = 0; k + 1 < one.vertices.size(); ++k) {
      const double length = edge_in(common.patches[one.patch], one.vertices, k);
      EXPECT_NEAR(length, edge_in(common.patches[other.patch], other.vertices, k), 1e-9 * length);
      const double mean = 0.5 * (edge_in(apart.patches[one.patch], one.vertices, k) +
                                 edge_in(apart.patches[other.patch], other.vertices, k));
      EXPECT_NEAR(length, mean, 1e-9 * length);
    }
  }
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const auto rms = [p](const ProductReport& report) {
      return report.patches[p].finished->unfold.strain.rms;
    };
    EXPECT_LT(rms(common), rms(own));
    EXPECT_LE(rms(apart), rms(common) * (1.0 + 1e-9));
  }
}

TEST(CommonLengths, AreTheirOwnBesideAPieceThatMissesItsLimit) {
  std::vector<ProductPatch> patches = pieces_of(in_strips(make_shape("saddle", 300), 3));
  patches[0].limits = StrainLimits{.rms = 1e-5};
  ProductOptions options = with_common_lengths();
  options.flatten.keep_design = true;
  const ProductReport report = flatten_product(patches, options);
  ASSERT_EQ(report.seams.size(), 2U);
  for (const MeasuredSeam& seam : report.seams) {
    const bool is_beside = seam.seam.sides[0].patch == 0;
    const double change = std::abs(*seam.in_pattern[0] - seam.on_model[0]);
    EXPECT_EQ(change < 1e-9 * seam.on_model[0], is_beside);
    EXPECT_LT(*seam.difference(), 1e-9 * seam.on_model[0]);
  }
}

TEST(CommonLengths, AreIdleWhereTheWholeBorderKeepsItsLengths) {
  const std::vector<ProductPatch> patches = pieces_of(in_strips(make_shape("saddle", 300), 3));
  ProductOptions options = with_common_lengths();
  options.flatten.match_seams = true;
  for (const MeasuredSeam& seam : flatten_product(patches, options).seams) {
    for (std::size_t s = 0; s < 2; ++s)
      EXPECT_NEAR(*seam.in_pattern[s], seam.on_model[s], 1e-9 * seam.on_model[s]);
  }
}

TEST(CommonLengths, OfASlitAreTheSameOnBothSides) {
  const Patch vase(meshes::opened_vase(24, 12));
  const SewnBorder border = find_own_seams(vase, {}, {});
  ASSERT_TRUE(border.has_seams);
  EXPECT_EQ(border.free_edges.size(), 2U * 24U);
  ASSERT_EQ(border.lengths.size(), 2U * 12U);
  UnfoldOptions options{.match_seams = true, .free_edges = border.free_edges};
  options.least_stretch = true;
  options.seam_lengths = border.lengths;
  const Pattern pattern = unfold(vase, options);
  for (Index row = 0; row < 12; ++row) {
    const auto length = [&](Index column) {
      const Index v = 25 * row + column;
      return norm(pattern.positions[v + 25] - pattern.positions[v]);
    };
    EXPECT_NEAR(length(0), length(24), 1e-10);
  }
  EXPECT_FALSE(find_own_seams(Patch(make_shape("dome", 100)), {}, {}).has_seams);
  EXPECT_FALSE(find_own_seams(vase, {.remesh = true}, {}).has_seams);
  EXPECT_FALSE(find_own_seams(vase, {.limits = {.rms = 1e-6}}, {}).has_seams);
}

/// The pieces of a division keep the limit as they are, with seams of one length.
TEST(CommonLengths, LeaveTheFormOfPanelsAsItIs) {
  TriMesh pear = solids::sphere(1.0, 16);
  for (Vec3& p : pear.positions)
    p = {(1.0 + 0.3 * p.y) * p.x, 1.5 * p.y, 0.8 * p.z + 0.3 * p.y * p.y};
  const StrainLimits limits{.rms = 0.03};
  const PanelSuggestion found =
      suggest_panels(Patch(pear), {.limits = limits, .moves = 2, .trial_vertices = 500});
  ASSERT_TRUE(found.met);
  std::vector<CutPath> paths;
  for (const std::vector<Index>& seam : found.seams)
    paths.push_back({seam, {}});
  const CutMesh cut = cut_open(Patch(found.mesh), paths);
  ProductOptions options = with_common_lengths();
  options.flatten.limits = limits;
  const ProductReport report = flatten_product(pieces_of(split(cut.mesh, "pear")), options);
  ASSERT_FALSE(report.seams.empty());
  for (const PatchResult& patch : report.patches) {
    ASSERT_TRUE(patch.finished);
    EXPECT_EQ(patch.finished->deviation.max, 0.0);
    EXPECT_LE(patch.finished->unfold.strain.rms, limits.rms);
  }
  for (const MeasuredSeam& seam : report.seams)
    EXPECT_LT(*seam.difference(), 1e-9 * seam.on_model[0]);
}

}  // namespace
}  // namespace planish
