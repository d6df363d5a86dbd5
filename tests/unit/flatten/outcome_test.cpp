#include <planish/flatten/product.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/sample_report.h"

namespace planish {
namespace {

using testing::ElementsAre;

TEST(Outcome, IsMetWhereNothingWasAskedFor) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{};
  report.evolve.result.stop = StopReason::smooth_limit;
  const Outcome outcome = report.outcome();
  EXPECT_TRUE(outcome.limits_met());
  EXPECT_FALSE(outcome.worst);
  EXPECT_EQ(outcome.reason, StopReason::smooth_limit);
  EXPECT_FALSE(outcome.target_met());
}

TEST(Outcome, NamesWhatIsMissedRatherThanWhatIsNear) {
  FlattenReport report = samples::flatten_report();  // strain 0.3187, deviation 0.5678
  report.evolve.method = Auto{.max_deviation = 0.56};
  report.unfold.limits = {{Criterion::strain, 0.31871, 0.3187}, {Criterion::rms_strain, 1.0}};
  const Outcome outcome = report.outcome();
  EXPECT_FALSE(outcome.limits_met());
  ASSERT_TRUE(outcome.worst);
  EXPECT_EQ(outcome.worst->what, Criterion::deviation);
  report.evolve.method = Auto{.max_deviation = 0.9};
  EXPECT_TRUE(report.outcome().limits_met());
  EXPECT_EQ(report.outcome().worst->what, Criterion::strain) << "nearest to its limit";
  EXPECT_EQ(report.evolve.outcome().worst->what, Criterion::deviation) << "it has no pattern";
}

TEST(Outcome, OfAnEvolutionGoesByTheEstimateOfItsStrain) {
  EvolveReport report = samples::flatten_report().evolve;
  report.method = Auto{.limits = {.max = 0.01}};
  for (const auto& [stop, met] :
       {std::pair{StopReason::strain_met, true}, std::pair{StopReason::converged, true},
        std::pair{StopReason::reached_target, true}, std::pair{StopReason::deviation_limit, false},
        std::pair{StopReason::sweep_limit, false}}) {
    report.result.stop = stop;
    EXPECT_EQ(report.outcome().limits_met(), met) << to_string(stop);
  }
}

TEST(Outcome, MissesATargetThatIsNotReached) {
  FlattenReport report = samples::flatten_report();  // e_max 0.0468
  report.evolve.method = ControllableLaplacian{};
  report.evolve.stopping.target_e_max = 0.04;
  report.evolve.result.stop = StopReason::sweep_limit;
  EXPECT_FALSE(report.outcome().limits_met());
  EXPECT_FALSE(report.evolve.outcome().limits_met());
  EXPECT_EQ(report.outcome().worst->what, Criterion::e_max);
  report.evolve.stopping.target_e_max = 0.05;
  EXPECT_TRUE(report.outcome().limits_met());
}

TEST(Outcome, IsUsableOnlyWhereNothingIsMissed) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{};
  report.unfold.limits = {{Criterion::p99_strain, 0.5, 0.3}};
  report.unfold.pattern.width = 100.0;
  EXPECT_THAT(report.outcome().missed, ElementsAre());
  EXPECT_TRUE(report.outcome().usable());
  report.evolve.fairness.height_ratio = 0.1;
  report.unfold.pattern.overlaps = true;
  EXPECT_THAT(report.outcome().missed, ElementsAre(Criterion::form, Criterion::overlap));
  EXPECT_TRUE(report.outcome().limits_met());
  EXPECT_FALSE(report.outcome().usable());
  report.unfold.limits = {{Criterion::p99_strain, 0.5, 0.51}};
  EXPECT_THAT(report.outcome().missed,
              ElementsAre(Criterion::p99_strain, Criterion::form, Criterion::overlap));
  EXPECT_FALSE(report.outcome().limits_met());
}

TEST(Outcome, IsTheSameOfAPieceOfAProduct) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{.max_deviation = 0.1};
  report.evolve.fairness.form_change->ripple = 20.0;
  report.evolve.after.self_intersections.pairs = 3;
  report.unfold.pattern.flipped_triangles = 2;
  report.rejected = EdgeStrain{};
  const PatchResult piece{.name = "front", .finished = finished_patch(report)};
  EXPECT_THAT(report.outcome().missed,
              ElementsAre(Criterion::deviation, Criterion::rejected, Criterion::crumpled,
                          Criterion::self_intersections, Criterion::flipped_triangles));
  EXPECT_EQ(piece.outcome().missed, report.outcome().missed);
  EXPECT_EQ(piece.outcome().reason, report.outcome().reason);
}

TEST(Outcome, OfAPatternGoesByLimitsOfStrainAndThePattern) {
  UnfoldReport report = samples::plane_below(samples::bumpy_patch(4, 4, 1.0), 40.0, 30.0);
  EXPECT_TRUE(report.outcome().usable());
  report.strain = {0.3, 0.2, 0.3};
  EXPECT_TRUE(report.outcome().usable()) << "no limit was asked for";
  report.limits = {{Criterion::strain, 0.1, 0.3}, {Criterion::rms_strain, 0.1, 0.2}};
  report.pattern.overlaps = true;
  EXPECT_THAT(report.outcome().missed,
              ElementsAre(Criterion::strain, Criterion::rms_strain, Criterion::overlap));
}

}  // namespace
}  // namespace planish
