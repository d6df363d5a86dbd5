#include "flatten/verdict.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/sample_report.h"

namespace planish {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

// A text without the blanks that keep number and unit together.
std::string with_plain_blanks(std::string text) {
  for (std::size_t at; (at = text.find("\u00A0")) != std::string::npos;)
    text.replace(at, 2, " ");
  return text;
}

std::string verdict(const FlattenReport& report) {
  return with_plain_blanks(verdict_text(report));
}

std::string computed(const FlattenReport& report) {
  return with_plain_blanks(computed_text(report));
}

FlattenReport report() {
  return samples::flatten_report();
}

FlattenReport with_strain(double before, double after) {
  FlattenReport some = report();
  some.design_least_stretch.strain.rms = some.design_pattern.strain.rms = before;
  some.unfold.strain.rms = after;
  return some;
}

FlattenReport with_energy(double before, double after) {
  FlattenReport some = report();
  some.evolve.before.figures.energy = before;
  some.evolve.after.figures.energy = after;
  return some;
}

FlattenReport flattenable_with_strain(double max) {
  FlattenReport some = report();
  some.evolve.after.flattenable = true;
  some.unfold.strain = {max, max / 4.0, max / 2.0};
  return some;
}

const std::string k_changed = ", with the form changed by up to 0.57 mm";

FlattenReport design_with(double p99, double rms) {
  FlattenReport some = report();
  some.evolve.method.reset();
  some.evolve.result.history.clear();
  some.evolve.fairness = {.unchanged = true};
  some.evolve.deviation = {};
  EdgeStrain& strain = some.unfold.strain;
  strain = {.max = 1.5 * p99, .rms = rms, .p99 = p99, .worst_edge = {0, 1}};
  strain.max_stretch = strain.max_compression = strain.max;
  strain.p99_stretch = strain.p99_compression = p99;
  some.design_pattern = some.design_least_stretch = some.unfold;
  return some;
}

TEST(Verdict, SaysOfADesignThatIsKeptWhatSheetTakesIt) {
  const std::string text = verdict(design_with(0.08, 0.033));
  EXPECT_THAT(text, StartsWith("Needs a sheet that takes 8.0 %: neoprene (10 %) does, "));
  EXPECT_THAT(text, HasSubstr(" does not. The usual stretch is 3.3 %, the largest 12 %, near ("));
  EXPECT_THAT(text, EndsWith(" The form was not changed."));
  EXPECT_THAT(verdict(design_with(0.0019, 0.0015)), HasSubstr("%: steel (0.20 %) does. "));
  EXPECT_THAT(verdict(design_with(0.9, 0.3)),
              StartsWith("Needs a sheet that takes 90 %: no material that is known here does. "));
  FlattenReport overlapping = design_with(0.08, 0.033);
  overlapping.unfold.pattern.overlaps = true;
  EXPECT_THAT(verdict(overlapping), StartsWith("Do not cut this pattern: it overlaps itself."));
}

TEST(Verdict, CallsALargestStretchThatIsACompressionSo) {
  FlattenReport some = design_with(0.08, 0.033);
  some.unfold.strain.max_stretch = 0.06;
  EXPECT_THAT(verdict(some), HasSubstr("the largest 12 % (compression), near ("));
}

/// Of a form that was changed within a tolerance of 5 mm.
FlattenReport within_tolerance(double moved, double fold, double bent) {
  FlattenReport some = report();
  some.evolve.method = Auto{.max_deviation = 5.0};
  some.evolve.result.stop = StopReason::smooth_limit;
  some.evolve.deviation.max = moved;
  some.evolve.fairness.bending_added = bent;
  some.evolve.fairness.sharpest_fold = Fold{.degrees = fold};
  return some;
}

TEST(Verdict, SaysWhatEndsASearchWithinATolerance) {
  EXPECT_THAT(verdict(within_tolerance(4.2, 4.95, 0.01)),
              AllOf(StartsWith("Needs a sheet that takes "),
                    HasSubstr(" Less would fold some place by more than 5 degrees beyond the "
                              "design, which --max-deviation does not allow: ")));
  EXPECT_THAT(verdict(within_tolerance(2.0, 3.0, 0.049)), HasSubstr(" Less would bend the form "));
  EXPECT_THAT(verdict(within_tolerance(4.99, 3.0, 0.01)),
              HasSubstr(" Less would move some place further than --max-deviation allows."));
  EXPECT_THAT(verdict(within_tolerance(2.0, 3.0, 0.01)),
              HasSubstr(" No form with less stretch was found within --max-deviation."));
}

TEST(Verdict, SaysOfWhichPatternTheFiguresOfTheDesignAre) {
  FlattenReport some = with_strain(0.12, 0.0085);
  some.unfold.limits = {{Criterion::p99_strain, 0.1, 0.018}};
  some.unfold.unlimited_strain = some.unfold.strain;
  EXPECT_THAT(verdict(some),
              HasSubstr("; for the design as it is, with least stretch, 12 % and 32 %. "));
}

TEST(Verdict, SaysWhyTheDesignWasKept) {
  FlattenReport some = report();
  some.rejected = EdgeStrain{.max = 0.5, .rms = 0.084, .p99 = 0.2};
  EXPECT_THAT(verdict(some),
              HasSubstr("Changing the form would have stretched the pattern more, to "
                        "8.4 % as a rule, so this is the design as it is."));
}

TEST(Verdict, SaysHowTheStrainIsAndWhatTheSweepsDid) {
  EXPECT_EQ(verdict(report()),
            "Does not lie flat without stretch. The usual stretch is 7.6 %, the largest 32 %. No "
            "material that is known here takes that. No place moved further than 0.57 mm. The form "
            "stayed smooth.");
  EXPECT_EQ(computed(report()),
            "10 controllable sweeps lowered the energy by 27 % and left the strain where it was.");
}

TEST(Verdict, ComparesTheStretchWithThatOfTheDesign) {
  EXPECT_THAT(verdict(with_strain(0.12, 0.0085)),
              HasSubstr("The usual stretch is 0.85 %, the largest 32 %; for the design as it is "
                        "12 % and 32 %. "));
}

TEST(Verdict, NamesTheStiffestMaterialThatTakesTheDesign) {
  FlattenReport some = with_strain(0.02, 0.0009);
  some.unfold.strain.p99 = some.unfold.strain.max = 0.004;
  some.design_pattern.strain.p99 = 0.04;
  const std::string words =
      "Cotton takes the design as it is: --material cotton leaves the form unchanged.";
  EXPECT_THAT(verdict(some), HasSubstr(words));
  some.design_pattern.strain.p99 = some.design_pattern.strain.p99_compression = 0.2;
  EXPECT_THAT(verdict(some), Not(HasSubstr("takes the design")));
  some.design_pattern.strain.p99 = 0.04;
  some.evolve.fairness.unchanged = true;
  EXPECT_THAT(verdict(some), Not(HasSubstr("takes the design")));
  some.evolve.fairness.unchanged = false;
  some.material = "leather";
  some.unfold.limits = {{Criterion::p99_strain, 0.01, 0.004}};
  EXPECT_THAT(verdict(some), Not(HasSubstr("takes the design"))) << "the material is chosen";
}

TEST(Verdict, SaysInItsFirstSentenceWhatBecameOfTheForm) {
  FlattenReport some = report();
  Fairness& fairness = some.evolve.fairness;
  fairness.height_ratio = 0.254;
  EXPECT_THAT(verdict(some),
              StartsWith("Does not lie flat without stretch, and the form is lost. "));
  some.material = "leather";
  some.unfold.limits = {{Criterion::p99_strain, 0.01, 0.00999}};
  EXPECT_THAT(verdict(some), StartsWith("Within the 1.0 % that leather takes on 99 % of the area" +
                                        k_changed + ", but the form is lost. "));
  EXPECT_THAT(verdict(some), EndsWith("The form stayed smooth. The form is not kept: height "
                                      "25 % of the design's."));
  fairness.form_change->ripple = 3.26;
  EXPECT_THAT(verdict(some),
              StartsWith("Within the 1.0 % that leather takes on 99 % of the area" + k_changed +
                         ", but the form is "
                         "crumpled and lost. "));
  fairness.height_ratio = k_kept_height;
  EXPECT_THAT(verdict(some), StartsWith("Within the 1.0 % that leather takes on 99 % of the area" +
                                        k_changed + ", but the form is crumpled. "));
}

TEST(Verdict, SaysInItsFirstSentenceThatTheFormIsFoldedOrGoesThroughItself) {
  FlattenReport some = report();
  some.evolve.fairness.sharpest_fold = Fold{.degrees = 173.2};
  some.evolve.fairness.form_change = FormChange{.fold = k_seen_new_fold};
  EXPECT_THAT(verdict(some), StartsWith("Does not lie flat without stretch. "));
  some.evolve.fairness.form_change = FormChange{.fold = 2.8};
  EXPECT_THAT(verdict(some), StartsWith("Does not lie flat without stretch, and the form has a new "
                                        "fold. "));
  some.evolve.after.self_intersections.pairs = 5;
  EXPECT_THAT(verdict(some), StartsWith("Does not lie flat without stretch, and the form has a new "
                                        "fold and goes through itself. "));
  some.evolve.before.self_intersections.pairs = 5;
  EXPECT_THAT(verdict(some), Not(HasSubstr("goes through itself"))) << "the design does, too";
}

TEST(FormLoss, SaysWhatIsLost) {
  EXPECT_EQ(form_loss_text({}), "");
  EXPECT_EQ(form_loss_text({.bending_lost = 0.9, .height_ratio = k_kept_height}), "");
  EXPECT_EQ(form_loss_text({.height_ratio = 0.254}), "height 25\u00A0% of the design's");
  EXPECT_EQ(form_loss_text({.form_change = FormChange{.relief_lost = 0.31}}),
            "hills and hollows lost 31\u00A0% of their height");
  EXPECT_EQ(form_loss_text({.height_ratio = 0.5, .form_change = FormChange{.relief_lost = 1.2}}),
            "height 50\u00A0% of the design's, hills and hollows lost 100\u00A0% of their height");
  EXPECT_EQ(form_loss_text({.form_change = FormChange{.dent = 0.05, .edge_lost = 0.5}}),
            "edges are rounded off, a dent or bulge is new");
  EXPECT_EQ(form_loss_text({.form_change = FormChange{.uneven_turn = 3.0}}),
            "small features changed");
  EXPECT_EQ(form_loss_text({.largest_move = k_kept_move}), "");
  EXPECT_EQ(form_loss_text({.largest_move = 0.222}), "a part moved by 22\u00A0% of the whole size");
}

TEST(Verdict, SaysWhetherTheFormIsSmooth) {
  FlattenReport some = report();
  const auto with = [&](const Fairness& fairness) {
    some.evolve.fairness = fairness;
    return verdict(some);
  };
  Fairness fairness = some.evolve.fairness;
  fairness.form_change = FormChange{.relief_lost = 0.6};
  EXPECT_THAT(with(fairness), EndsWith("The form stayed smooth. The form is not kept: hills and "
                                       "hollows lost 60 % of their height."));
  fairness.form_change = FormChange{.ripple = 0.7};
  EXPECT_THAT(with(fairness), EndsWith("The form stayed smooth."));
  fairness.form_change = FormChange{.ripple = 0.7, .fold = 2.8};
  EXPECT_THAT(with(fairness), EndsWith("The form is folded: in one place it is bent 3.0 times as "
                                       "sharply as it was."));
  fairness.form_change = FormChange{.ripple = 1.4, .fold = 2.4};
  EXPECT_THAT(with(fairness), AllOf(HasSubstr("and the form is rippled. "),
                                    EndsWith("The form is rippled: in places it is bent 1.7 times "
                                             "as sharply as it was.")));
  fairness.form_change = FormChange{.ripple = 5.0, .fold = 6.0};
  EXPECT_THAT(with(fairness), EndsWith("The form is crumpled: in places it is bent 5.1 times as "
                                       "sharply as it was."));
  fairness.form_change = {};  // other triangles
  fairness.bending_ratio = 4.24;
  EXPECT_THAT(with(fairness),
              EndsWith("The form is crumpled: it is bent 4.2 times as much as it was."));
  EXPECT_THAT(with({}), EndsWith("The form was a plane, and is bent now."));
  EXPECT_THAT(with({.unchanged = true}), EndsWith("The form was not changed."));
}

TEST(Verdict, KeepsToWhatTheMeshCanShow) {
  FlattenReport some = flattenable_with_strain(0.0);
  some.cautions = {CoarseFacets{22.5, 0.00642}};
  EXPECT_THAT(verdict(some),
              StartsWith("Lies flat without stretch. The pattern keeps every length of the mesh. "
                         "Facets turn by 22.5 degrees: up to 6.4 mm per metre short where the "
                         "surface is meant to be round. "));
  some.cautions = {HiddenCurvature{0.0}, CoarseFacets{22.5, 0.00642}};
  EXPECT_THAT(verdict(some), StartsWith("Cannot be judged: no vertex inside. The pattern keeps "
                                        "every length of the mesh. No vertex is inside the mesh"));
  EXPECT_THAT(verdict(some), HasSubstr("Facets turn by 22.5 degrees"));
  some.evolve.after.flattenable = false;
  some.unfold.strain = {0.003, 0.0005, 0.001};
  EXPECT_THAT(verdict(some), StartsWith("Cannot be judged: no vertex inside. The usual stretch is "
                                        "0.050 %"));
  some.cautions = {HiddenCurvature{0.3}};
  some.unfold.strain = {0.3, 0.05, 0.1};
  EXPECT_THAT(verdict(some), StartsWith("Does not lie flat without stretch. "))
      << "that much is known";
  some.cautions = {CoarseCoordinates{0.03, 0.08}};
  EXPECT_THAT(verdict(some), StartsWith("Cannot be judged: coarse coordinates. The usual stretch"));
  some.cautions = {HiddenCurvature{0.3}, CoarseCoordinates{0.03, 0.08}};
  EXPECT_THAT(verdict(some), StartsWith("Cannot be judged: coarse coordinates. "))
      << "what hides curvature is no reason for a stretch";
  some.cautions = {HiddenCurvature{0.3}};
  EXPECT_THAT(verdict(some), HasSubstr("Only 30 % of the area is around inner vertices"));
}

TEST(Verdict, TellsFlatFromNearlyAndNotYet) {
  EXPECT_THAT(verdict(flattenable_with_strain(0.0)),
              StartsWith("Lies flat without stretch. The pattern keeps every length. "));
  EXPECT_THAT(verdict(flattenable_with_strain(1e-9)),
              StartsWith("Lies flat without stretch. The pattern keeps every length. "));
  EXPECT_THAT(
      verdict(flattenable_with_strain(0.0005)),
      StartsWith("Lies flat without stretch. The pattern keeps every length to within 0.050 %. "));
  EXPECT_THAT(verdict(flattenable_with_strain(0.02)),
              StartsWith("Does not lie flat without stretch. The usual stretch is 0.50 %"))
      << "flattenable by its angles alone";
  FlattenReport near = report();
  near.unfold.strain = {0.003, 0.0005, 0.001};
  EXPECT_THAT(verdict(near), StartsWith("Flat but for a stretch too small to measure. The usual "
                                        "stretch is 0.050 %, the largest 0.30 %"));
}

TEST(Verdict, MeasuresStrainByTheLimitThatWasGiven) {
  FlattenReport some = report();
  some.unfold.strain = {0.018, 0.006, 0.01};
  const auto with = [&](std::vector<LimitCheck> limits) {
    some.unfold.limits = std::move(limits);
    return verdict(some);
  };
  const LimitCheck kept{Criterion::strain, 0.02, 0.018}, missed{Criterion::strain, 0.02, 0.03};
  const LimitCheck rms{Criterion::rms_strain, 0.01, 0.006};
  EXPECT_THAT(with({kept}), StartsWith("Within the limit of 2.0 %" + k_changed +
                                       ". The usual stretch is 0.60 %, "
                                       "the largest 1.8 %; for the design as it is "));
  EXPECT_THAT(with({{Criterion::p99_strain, 0.02, 0.018}}),
              StartsWith("Within the limit of 2.0 % on 99 % of the area" + k_changed + ". "));
  EXPECT_THAT(with({{Criterion::p99_strain, 0.1, 0.018}}),
              StartsWith("Within the limit of 10 % on 99 % of the area" + k_changed + ". "))
      << "no material was named";
  some.material = "neoprene";
  EXPECT_THAT(with({{Criterion::p99_strain, 0.1, 0.018}}),
              StartsWith("Within the 10 % that neoprene takes" + k_changed + ". "));
  EXPECT_THAT(with({{Criterion::p99_stretch, 0.1, 0.018}}),
              StartsWith("Within the 10 % of stretch that neoprene takes" + k_changed + ". "));
  EXPECT_THAT(
      with({{Criterion::p99_stretch, 0.1, 0.018}, {Criterion::p99_compression, 0.02, 0.01}}),
      StartsWith("Within what neoprene takes" + k_changed + ". "));
  some.unfold.strain.max_compression = 0.018;
  EXPECT_THAT(
      with({{Criterion::p99_stretch, 0.1, 0.018}, {Criterion::p99_compression, 0.009, 0.01}}),
      StartsWith("Not within the 0.90 % of compression that neoprene takes on 99 % of the "
                 "area. "));
  EXPECT_THAT(with({{Criterion::stretch, 0.01, 0.018}}),
              StartsWith("Not within the 1.0 % of stretch that neoprene takes at any edge. "));
  some.material.clear();
  EXPECT_THAT(with({{Criterion::compression, 0.02, 0.018}}),
              StartsWith("Within the limit of 2.0 % of compression" + k_changed + ". "));
  EXPECT_THAT(with({missed}), StartsWith("Not within the limit of 2.0 %. "));
  EXPECT_THAT(with({missed, rms}), StartsWith("Not within the limit of 2.0 %. "));
  EXPECT_THAT(with({kept, {Criterion::rms_strain, 0.005, 0.006}}),
              StartsWith("Not within the limit of 0.50 % (rms). "));
  EXPECT_THAT(with({rms}), StartsWith("Within the limit of 1.0 % (rms)" + k_changed + ". "));
  some.evolve.after.flattenable = true;
  EXPECT_THAT(verdict(some), StartsWith("Within the limit")) << "flattenable by its angles alone";
  EXPECT_THAT(with({rms}), Not(HasSubstr("take"))) << "materials are not asked for";
}

TEST(Verdict, WarnsFirstOfAPatternThatIsNotToBeCut) {
  FlattenReport some = flattenable_with_strain(0.0);
  some.unfold.pattern.flipped_triangles = 1;
  EXPECT_THAT(verdict(some), StartsWith("Do not cut this pattern: parts of it are flipped over. "));
  some.unfold.pattern.overlaps = true;
  EXPECT_THAT(verdict(some), StartsWith("Do not cut this pattern: it overlaps itself. "));
  EXPECT_THAT(verdict(some), HasSubstr(" Divide the patch (--cut). "));
}

TEST(Computed, SaysWhatBecameOfTheEnergy) {
  EXPECT_THAT(computed(with_energy(1.0, 0.73)), HasSubstr("lowered the energy by 27 % and"));
  EXPECT_THAT(computed(with_energy(1.0, 0.998)), HasSubstr("left the energy where it was and"));
  EXPECT_THAT(computed(with_energy(1.0, 0.00085)),
              HasSubstr("brought the energy down to 1/1200 of what it was and"));
  EXPECT_THAT(computed(with_energy(1.0, 0.0)), HasSubstr("brought the energy to 0 and"));
  EXPECT_THAT(computed(with_energy(1.0, 1.5)), HasSubstr("raised the energy by 50 % and"));
  EXPECT_THAT(computed(with_energy(1.0, 12.0)),
              HasSubstr("raised the energy to 12 times what it was and"));
  EXPECT_THAT(computed(with_energy(0.0, 1.0)), HasSubstr("raised the energy from 0 and"));
  EXPECT_THAT(computed(with_energy(0.0, 0.0)), HasSubstr("left the energy where it was and"));
}

TEST(Computed, SaysWhatBecameOfTheStrain) {
  EXPECT_THAT(computed(with_strain(0.076, 0.0005)),
              HasSubstr("by 27 % and lowered the strain from 7.6 % to 0.050 % rms."));
  EXPECT_THAT(computed(with_strain(0.05, 0.076)),
              HasSubstr("by 27 % but raised the strain from 5.0 % to 7.6 % rms."));
  EXPECT_THAT(computed(with_strain(0.076, 0.0755)), HasSubstr("left the strain where it was."));
  EXPECT_THAT(computed(with_strain(1e-9, 2e-9)), HasSubstr("left the strain where it was."))
      << "rounding is no change";
}

TEST(Computed, SaysWhenNothingWasDone) {
  FlattenReport some = flattenable_with_strain(0.0);
  some.evolve.result.history.clear();
  some.evolve.fairness.unchanged = true;
  some.evolve.before.flattenable = true;
  EXPECT_THAT(computed(some), EndsWith("It came so, and no vertex was moved."));
  some.evolve.before.flattenable = false;
  EXPECT_THAT(computed(some), EndsWith("No sweep was made, and no vertex was moved."));
  some.evolve.result.history = {{1, 0.1, 0.1, 0.1, 0, 0.0}};
  EXPECT_THAT(computed(some), EndsWith("1 controllable sweep found no vertex to move."));
}

TEST(Verdict, NamesTheMethodAndTheUnit) {
  FlattenReport some = report();
  some.evolve.method = ClassicalLaplacian{};
  some.unfold.unit = Unit::cm;
  EXPECT_THAT(computed(some), HasSubstr("10 classical sweeps"));
  EXPECT_THAT(verdict(some), HasSubstr("No place moved further than 5.7 mm."));
}

TEST(Verdict, OwnsUpToAnUnfoldingThatDidNotEnd) {
  FlattenReport some = report();
  EXPECT_THAT(verdict(some), Not(HasSubstr("Unfolding stopped")));
  some.unfold.pattern.converged = false;
  EXPECT_THAT(verdict(some), HasSubstr("Unfolding stopped before it was done"));
}

TEST(Verdict, AsksAboutTheUnitWhereTheSizeIsUnlikely) {
  FlattenReport some = report();
  some.unfold.pattern.width = 0.609;
  some.unfold.pattern.height = 0.514;
  EXPECT_THAT(verdict(some),
              EndsWith("The pattern is 0.61 mm long: is the model in m? Then give --unit m."));
  some.unfold.unit = Unit::m;
  EXPECT_THAT(verdict(some), Not(HasSubstr("really")));
  some.unfold.pattern.width = 609.0;
  EXPECT_THAT(verdict(some), EndsWith("is the model in mm? Then give --unit mm."));
  some.unfold.pattern.width = 6e6;
  EXPECT_THAT(verdict(some), EndsWith("is the model's unit really m?"));
}

TEST(BorderText, IsOneSentenceWhereMuchAreaMustGo) {
  FlattenReport some = report();
  EXPECT_EQ(border_text(some), "");
  Obstruction obstruction;
  obstruction.excess_share = 0.009;
  obstruction.turning_most = 9.0;
  some.evolve.before.obstruction = obstruction;
  EXPECT_EQ(border_text(some), "");
  some.evolve.before.obstruction->excess_share = 0.329;
  EXPECT_EQ(
      border_text(some),
      "The edge is too short for so much surface: at least 33\u00A0% of the area of the design "
      "must go for a piece with this edge to lie flat, so put in a dart or a cut to keep the "
      "form.");
  const EdgeStrain stretched = some.unfold.strain;
  some.unfold.strain = {};
  EXPECT_EQ(border_text(some), "") << "the area has gone, and the form is kept";
  const Fairness sound = some.evolve.fairness;
  some.evolve.fairness.form_change = FormChange{.ripple = 4.0};
  EXPECT_NE(border_text(some), "") << "it has gone into folds";
  some.evolve.fairness = sound;
  some.unfold.strain = stretched;
  some.evolve.before.obstruction->turning_most = k_flat_turning;
  EXPECT_THAT(border_text(some),
              StartsWith("The edge lies in a plane and only a plane piece fits it: at least 33"));
}

}  // namespace
}  // namespace planish
