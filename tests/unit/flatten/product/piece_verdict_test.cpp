#include "flatten/product/piece_verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::ElementsAre;

PatchResult finished() {
  PatchResult piece{"front", 10, 12, FinishedPatch{}};
  piece.finished->unfold.unit = Unit::cm;
  return piece;
}

std::vector<std::string> texts_of(const PatchResult& piece) {
  std::vector<std::string> texts;
  for (const PieceCheck& check : piece_checks(piece))
    texts.push_back(check.text);
  return texts;
}

TEST(PieceVerdict, IsMetWhereNothingWasAskedForAndNothingIsWrong) {
  EXPECT_TRUE(finished().outcome().usable());
  EXPECT_TRUE(piece_checks(finished()).empty());
}

TEST(PieceVerdict, IsMissedWhereAChangedSurfaceIsStretchedWithoutALimit) {
  PatchResult piece = finished();
  piece.finished->unfold.strain = {0.9, 0.61, 0.8};
  EXPECT_TRUE(piece.outcome().usable()) << "the design itself, as it was asked for";
  piece.finished->deviation.max = 0.5;
  EXPECT_THAT(texts_of(piece),
              ElementsAre("does not lie flat without stretch, and no limit was asked for"));
  EXPECT_FALSE(piece.outcome().usable());
  piece.finished->unfold.strain = {0.02, 0.0009, 0.01};
  EXPECT_TRUE(piece.outcome().usable()) << "too little to measure";
  piece.finished->unfold.strain = {0.9, 0.61, 0.8};
  piece.finished->limits = {{Criterion::strain, 1.0, 0.9, true}};
  EXPECT_TRUE(piece.outcome().usable());
}

TEST(PieceVerdict, IsMissedWhereTheFormIsNotAsItShouldBe) {
  PatchResult piece = finished();
  piece.finished->limits = {{Criterion::strain, 1.0, 0.9, true}};
  piece.finished->form_faults = {{Criterion::form, "is lost"}};
  EXPECT_FALSE(piece.outcome().usable());
  EXPECT_EQ(texts_of(piece).front(), "the form is lost");
  EXPECT_EQ(piece_checks(piece).front().what, Criterion::form);
}

TEST(PieceVerdict, NamesEveryLimitWithItsFigures) {
  PatchResult piece = finished();
  piece.finished->limits = {
      {Criterion::strain, 0.05, 0.0321, true},     {Criterion::p99_strain, 0.02, 0.01, true},
      {Criterion::rms_strain, 0.005, 0.004, true}, {Criterion::deviation, 0.2, 0.15, true},
      {Criterion::angle, 10.0, 12.5, true},        {Criterion::e_max, 0.001, 0.0005, true},
      {Criterion::bending, 2.0, 1.25, true}};
  EXPECT_TRUE(piece.outcome().usable());
  EXPECT_THAT(texts_of(piece),
              ElementsAre("strain limit of 5\u00A0% kept: 3.21\u00A0%",
                          "strain limit of 2\u00A0% on 99\u00A0% of the area kept: 1\u00A0%",
                          "strain limit of 0.5\u00A0% rms kept: 0.4\u00A0%",
                          "deviation limit of 2\u00A0mm kept: 1.5\u00A0mm",
                          "smallest-angle limit of 10° kept: 12.5°",
                          "e_max target of 0.001\u00A0rad kept: 0.0005\u00A0rad",
                          "bending limit of 2 kept: 1.25"));
}

TEST(PieceVerdict, HasWhatIsMissedFirst) {
  PatchResult piece = finished();
  piece.finished->limits = {{Criterion::strain, 0.05, 0.03, true},
                            {Criterion::deviation, 0.2, 0.31, false}};
  piece.finished->unfold.pattern.overlaps = true;
  piece.finished->unfold.pattern.flipped_triangles = 1;
  EXPECT_FALSE(piece.outcome().usable());
  EXPECT_THAT(piece.outcome().missed,
              ElementsAre(Criterion::deviation, Criterion::overlap, Criterion::flipped_triangles));
  EXPECT_THAT(texts_of(piece), ElementsAre("deviation limit of 2\u00A0mm missed: 3.1\u00A0mm",
                                           "the pattern overlaps itself",
                                           "1 triangle is flipped over in the pattern",
                                           "strain limit of 5\u00A0% kept: 3\u00A0%"));
}

TEST(PieceVerdict, IsMissedWhereThePatternIsTooSmallToBeOne) {
  PatchResult piece = finished();  // in cm
  Pattern& pattern = piece.finished->unfold.pattern;
  pattern.width = 0.3;
  pattern.height = 0.499;
  EXPECT_THAT(texts_of(piece), ElementsAre("The pattern is 5.0\u00A0mm long: is the model in m? "
                                           "Then give --unit m."));
  EXPECT_EQ(piece_checks(piece).front().what, Criterion::size);
  pattern.height = 0.5;
  EXPECT_TRUE(piece.outcome().usable());
  pattern.height = 900.0;
  EXPECT_TRUE(piece.outcome().usable()) << "large pieces are cut too: of hulls and sails";
}

TEST(PieceVerdict, TellsALimitFromAValueThatIsHardlyBeyond) {
  PatchResult piece = finished();
  piece.finished->limits = {{Criterion::strain, 0.05, 0.050001, false}};
  EXPECT_THAT(texts_of(piece), ElementsAre("strain limit of 5\u00A0% missed: 5.0001\u00A0%"));
}

TEST(PieceVerdict, SaysWhenTheDesignWasKept) {
  PatchResult piece = finished();
  piece.finished->rejected = EdgeStrain{.rms = 0.08};
  EXPECT_FALSE(piece.outcome().usable());
  EXPECT_EQ(piece_checks(piece).front().what, Criterion::rejected);
  EXPECT_THAT(texts_of(piece).front(), testing::HasSubstr("to 8\u00A0% rms: the design was kept"));
}

TEST(ProductVerdict, SaysWhatSheetItNeedsAndThatNoLimitWasGiven) {
  ProductReport report;
  report.patches = {finished()};
  FinishedPatch& piece = *report.patches.front().finished;
  piece.unfold.strain = {.max = 0.12, .rms = 0.03, .p99 = 0.08};
  piece.limits = {{Criterion::deviation, 1.0, 0.5, true}};
  EXPECT_THAT(product_verdict(report),
              testing::AllOf(testing::StartsWith("Needs a sheet that takes 8.0\u00A0%: "),
                             testing::EndsWith("front stretches most. No limit of stretch was "
                                               "given. No form was changed.")));
  piece.limits.push_back({Criterion::p99_strain, 0.1, 0.08, true});
  EXPECT_EQ(product_verdict(report), "No form was changed.");
}

TEST(PieceVerdict, SaysWhichSideOfASeamIsLonger) {
  ProductReport report;
  report.patches = {{"front"}, {"back"}};
  MeasuredSeam seam{{{{SeamSide{0, {0, 1}}, SeamSide{1, {0, 1}}}}}, {50.0, 50.0}, {49.0, 52.02}};
  EXPECT_EQ(easing_text(report, seam), "back is 3.02\u00A0mm longer in the pattern");
  seam.on_model = {50.4, 50.0};
  EXPECT_EQ(
      easing_text(report, seam),
      "back is 3.02\u00A0mm longer in the pattern; front is 0.40\u00A0mm longer on the model");
  seam.in_pattern = {50.4, 50.0};
  EXPECT_EQ(easing_text(report, seam),
            "front is 0.40\u00A0mm longer in the pattern and on the model");
  seam.in_pattern = {50.0, 50.009};
  EXPECT_EQ(easing_text(report, seam), "front is 0.40\u00A0mm longer on the model");
  seam.on_model = {50.0, 50.009};
  EXPECT_EQ(easing_text(report, seam), "") << "less than a hundredth counts as equal";
  seam.seam.sides[1].patch = 0;
  seam.in_pattern[1] = 51.0;
  EXPECT_EQ(easing_text(report, seam), "the second side is 1.00\u00A0mm longer in the pattern");
}

TEST(PieceVerdict, OfAFailureIsItsReason) {
  ProductReport report;
  report.patches = {finished(), {"tube", 1, 1, {}, Failure{"handles", "has a handle"}}, finished()};
  EXPECT_THAT(texts_of(report.patches[1]), ElementsAre("failed: has a handle"));
  EXPECT_THAT(report.patches[1].outcome().missed, ElementsAre(Criterion::failure));
  EXPECT_FALSE(report.patches[1].outcome().limits_met());
  EXPECT_THAT(missed_first(report), ElementsAre(1U, 0U, 2U));
}

}  // namespace
}  // namespace planish
