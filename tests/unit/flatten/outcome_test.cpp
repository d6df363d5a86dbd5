#include <gtest/gtest.h>

#include "support/sample_report.h"

namespace planish {
namespace {

TEST(Outcome, IsMetWhereNothingWasAskedFor) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{};
  report.evolve.result.stop = StopReason::smooth_limit;
  const Outcome outcome = report.outcome();
  EXPECT_TRUE(outcome.met);
  EXPECT_FALSE(outcome.worst);
  EXPECT_EQ(outcome.reason, StopReason::smooth_limit);
  EXPECT_FALSE(outcome.target_met());
}

TEST(Outcome, NamesWhatIsMissedRatherThanWhatIsNear) {
  FlattenReport report = samples::flatten_report();  // strain 0.3187, deviation 0.5678
  report.evolve.method = Auto{.max_deviation = 0.56};
  report.unfold.limits = {{StrainLimitKind::max, 0.31871, 0.3187}, {StrainLimitKind::rms, 1.0}};
  const Outcome outcome = report.outcome();
  EXPECT_FALSE(outcome.met);
  ASSERT_TRUE(outcome.worst);
  EXPECT_EQ(outcome.worst->what, LimitOf::deviation);
  report.evolve.method = Auto{.max_deviation = 0.9};
  EXPECT_TRUE(report.outcome().met);
  EXPECT_EQ(report.outcome().worst->what, LimitOf::strain) << "nearest to its limit";
  EXPECT_EQ(report.evolve.outcome().worst->what, LimitOf::deviation) << "it has no pattern";
}

TEST(Outcome, OfAnEvolutionGoesByTheEstimateOfItsStrain) {
  EvolveReport report = samples::flatten_report().evolve;
  report.method = Auto{.max_strain = 0.01};
  for (const auto& [stop, met] :
       {std::pair{StopReason::strain_met, true}, std::pair{StopReason::converged, true},
        std::pair{StopReason::reached_target, true}, std::pair{StopReason::deviation_limit, false},
        std::pair{StopReason::sweep_limit, false}}) {
    report.result.stop = stop;
    EXPECT_EQ(report.outcome().met, met) << to_string(stop);
  }
}

TEST(Outcome, MissesATargetThatIsNotReached) {
  FlattenReport report = samples::flatten_report();  // e_max 0.0468
  report.evolve.method = ControllableLaplacian{};
  report.evolve.stopping.target_e_max = 0.04;
  report.evolve.result.stop = StopReason::sweep_limit;
  EXPECT_FALSE(report.outcome().met);
  EXPECT_FALSE(report.evolve.outcome().met);
  EXPECT_EQ(report.outcome().worst->what, LimitOf::defect);
  report.evolve.stopping.target_e_max = 0.05;
  EXPECT_TRUE(report.outcome().met);
}

}  // namespace
}  // namespace planish
