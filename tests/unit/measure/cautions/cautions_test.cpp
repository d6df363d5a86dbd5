#include <cmath>

#include <planish/measure/cautions.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/bent_sheets.h"
#include "support/meshes.h"

namespace planish {
namespace {

using testing::AllOf;
using testing::HasSubstr;

TEST(Cautions, AreNoneOfAFineSmoothMesh) {
  EXPECT_TRUE(find_cautions(Patch(meshes::bent_sphere(30))).empty());
  EXPECT_EQ(words_of(std::vector<Caution>{}), "");
  EXPECT_EQ(unjudged_by({}, true), nullptr);
}

TEST(Cautions, AreFoundTogether) {
  // One row, twisted, with facets that turn.
  TriMesh mesh = meshes::flat_grid(8, 1);
  for (Vec3& p : mesh.positions) {
    const double turn = 0.3 * p.x + 0.1 * p.y;
    p = {(1.0 + 0.2 * p.y) * std::sin(turn), p.y, std::cos(turn)};
  }
  const auto cautions = find_cautions(Patch(mesh));
  EXPECT_EQ(words_of(cautions), "no vertex inside, coarse facets");
  ASSERT_EQ(cautions.size(), 2u);
  EXPECT_EQ(code_of(cautions[0]), "hidden_curvature");
  EXPECT_EQ(code_of(cautions[1]), "coarse_facets");
  EXPECT_EQ(unjudged_by(cautions, true), &cautions[0]);
  EXPECT_EQ(unjudged_by(cautions, false), nullptr) << "that it does not lie flat is known";
}

TEST(Cautions, OfNoiseSayNothingOfFacets) {
  const TriMesh rough = meshes::rough_grid(20, 20, 3, 0.3);
  const auto cautions = find_cautions(Patch(rough));
  ASSERT_EQ(cautions.size(), 1u);
  EXPECT_EQ(code_of(cautions[0]), "scan_noise");
}

TEST(Cautions, OfCoordinatesLeaveNothingKnown) {
  const std::vector<Caution> cautions = {CoarseFacets{12.0, 0.002}, CoarseCoordinates{1.0, 2.0}};
  EXPECT_EQ(unjudged_by(cautions, true), &cautions[1]);
  EXPECT_EQ(unjudged_by(cautions, false), &cautions[1]);
}

TEST(Cautions, SayWhatToDo) {
  EXPECT_THAT(caution_text(HiddenCurvature{0.0}, Unit::mm),
              AllOf(HasSubstr("No vertex is inside"), HasSubstr("mesh the surface finer")));
  EXPECT_THAT(caution_text(HiddenCurvature{0.32}, Unit::mm),
              HasSubstr("Only 32\u00A0% of the area"));
  EXPECT_THAT(caution_text(CoarseFacets{22.5, 0.00642}, Unit::mm),
              HasSubstr("Facets turn by 22.5 degrees: up to 6.4\u00A0mm per metre short"));
  EXPECT_THAT(caution_text(CoarseCoordinates{0.03125, 0.08}, Unit::m),
              AllOf(HasSubstr("step by 31\u00A0mm where the mean edge has 80\u00A0mm, 39\u00A0%")));
  EXPECT_THAT(caution_text(ScanNoise{0.025, 2.08}, Unit::cm),
              AllOf(HasSubstr("0.25\u00A0mm"), HasSubstr("--smooth-first 21mm takes")));
  EXPECT_THAT(caution_text(ScanNoise{0.01, 0.8}, Unit::in), HasSubstr("--smooth-first 0.80in"));
}

}  // namespace
}  // namespace planish
