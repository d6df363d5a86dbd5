#include <planish/flatten/flatten.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

const Patch& panel() {
  static const Patch patch(make_shape("panel", 300));
  return patch;
}

TEST(Candidates, OfARunAreTheDesignAndTheResult) {
  const FlattenReport report = flatten(panel(), "panel", preset_options(5));
  const std::vector<Candidate> candidates = report.candidates();
  ASSERT_EQ(candidates.size(), 2U);
  EXPECT_EQ(candidates[0].preset, 1);
  EXPECT_TRUE(candidates[0].is_design());
  EXPECT_EQ(candidates[0].strain.rms,
            unfold_patch(panel(), Unit::mm, {.least_stretch = true}).strain.rms);
  EXPECT_EQ(candidates[0].deviation.max, 0.0);
  EXPECT_TRUE(candidates[0].fairness.unchanged);
  EXPECT_EQ(candidates[1].preset, 5);
  EXPECT_EQ(candidates[1].strain.max, report.unfold.strain.max);
  EXPECT_EQ(candidates[1].deviation.max, report.evolve.deviation.max);
  EXPECT_EQ(candidates[1].fairness.bending_added, report.evolve.fairness.bending_added);
  EXPECT_TRUE(candidates[1].limits_kept);
}

TEST(Candidates, AreOnlyTheDesignWhereTheMaterialTakesIt) {
  const FlattenReport report = flatten(panel(), "panel", {.limits = {.max = 0.5}});
  ASSERT_EQ(report.candidates().size(), 1U);
  EXPECT_TRUE(report.candidates()[0].is_design());
  EXPECT_EQ(report.design_pattern.pattern.positions, report.unfold.pattern.positions);
}

TEST(Candidates, KnowWhetherTheDesignKeepsTheLimits) {
  const double strain = unfold_patch(panel(), Unit::mm).strain.rms;
  const FlattenReport report = flatten(panel(), "panel", {.limits = {.rms = 0.5 * strain}});
  ASSERT_EQ(report.candidates().size(), 2U);
  EXPECT_FALSE(report.candidates()[0].limits_kept);
  EXPECT_TRUE(report.candidates()[1].limits_kept);
  EXPECT_FALSE(report.candidates()[1].preset) << "of no stop in the fixed order";
}

TEST(Pick, GivesTheSurfaceOfItsNumberWithLessStrainAndFurtherAwayEachTime) {
  double strain = 1.0, away = -1.0;
  for (int number = 1; number <= k_candidates; ++number) {
    const FlattenReport report = flatten(panel(), "panel", preset_options(number));
    const Candidate result = report.candidates().back();
    if (result.preset == number) {
      EXPECT_EQ(candidate_name(result), preset_name(number));
    }
    // Stops above the strain of the design give the design.
    const bool is_between = number > 1 && number < k_candidates;
    const double limit =
        is_between ? k_candidate_strains[static_cast<std::size_t>(number) - 2] : 1.0;
    const bool is_design = number == 1 || report.design_least_stretch.strain.rms <= limit;
    EXPECT_EQ(result.preset, is_between && is_design ? 1 : number);
    EXPECT_LE(result.strain.rms, 1.05 * limit) << number;
    EXPECT_LE(result.strain.rms, strain) << number;
    EXPECT_GE(result.deviation.rms, away) << number;
    strain = result.strain.rms;
    away = result.deviation.rms;
  }
}

TEST(Pick, OfTheDesignChangesNothingAndEvolvesNothing) {
  const FlattenReport report = flatten(panel(), "panel", preset_options(1));
  EXPECT_EQ(report.processed.positions(), panel().positions());
  EXPECT_TRUE(report.evolve.result.history.empty());
  EXPECT_EQ(report.evolve.result.stop, StopReason::design_kept);
  EXPECT_TRUE(report.outcome().limits_met());
}

TEST(Pick, KeepsOtherOptions) {
  const FlattenOptions options = preset_options(
      6, {.method = Auto{.limits = {.max = 0.1}, .max_deviation = 7.0}, .unit = Unit::cm});
  const auto& method = std::get<Auto>(*options.method);
  EXPECT_EQ(method.prefer, Prefer::flat);
  EXPECT_EQ(method.max_deviation, 7.0);
  EXPECT_EQ(method.limits.max, 0.0) << "the number says how much strain may stay";
  EXPECT_EQ(options.unit, Unit::cm);
}

TEST(Pick, RefusesNumbersOutOfOrder) {
  EXPECT_THROW(preset_options(0), Error);
  EXPECT_THROW(preset_options(k_candidates + 1), Error);
  EXPECT_THROW(preset_name(0), Error);
}

TEST(CandidateName, HasTheLimitInFewDigits) {
  Candidate candidate;
  candidate.stop = StopReason::strain_met;
  const auto name_with = [&](const Auto& method) {
    candidate.method = method;
    return candidate_name(candidate);
  };
  EXPECT_EQ(name_with({.limits = {.rms = 0.005}}), "0.5 % rms");
  EXPECT_EQ(name_with({.limits = {.rms = 0.0123456}}), "1.23 % rms");
  EXPECT_EQ(name_with({.limits = {.max = 0.01}}), "limit 1 %");
  EXPECT_EQ(name_with({}), "0.1 % rms");
  candidate.limits_kept = false;
  EXPECT_EQ(name_with({.limits = {.rms = 0.005}}), "0.5 % rms, missed");
  EXPECT_EQ(name_with({.prefer = Prefer::flat}), "as flat as it gets");
  EXPECT_EQ(name_with({.prefer = Prefer::near}), "as flat as it gets");
  candidate.flattenable = true;
  EXPECT_EQ(name_with({.prefer = Prefer::flat}), "flat");
  candidate.method = ClassicalLaplacian{};
  EXPECT_EQ(candidate_name(candidate), "classical");
  candidate.stop = StopReason::design_kept;
  EXPECT_EQ(candidate_name(candidate), "as designed");
}

// Classical steps pull a flattenable surface towards a minimal one, which is not flattenable.
TEST(Flatten, HandsOutTheDesignWhereEvolvingMadeThePatternWorse) {
  const Patch nearly_flat = flatten(panel(), "panel", preset_options(6)).processed;
  const FlattenReport report =
      flatten(nearly_flat, "panel",
              {.method = ClassicalLaplacian{}, .stopping = Stopping{.max_sweeps = 50}});
  ASSERT_TRUE(report.rejected);
  EXPECT_GT(report.rejected->rms, report.design_least_stretch.strain.rms);
  EXPECT_EQ(report.processed.positions(), nearly_flat.positions());
  EXPECT_EQ(report.unfold.strain.rms, report.design_least_stretch.strain.rms);
  EXPECT_EQ(report.evolve.result.stop, StopReason::design_kept);
  EXPECT_FALSE(report.evolve.result.history.empty()) << "what was tried";
  EXPECT_FALSE(report.outcome().limits_met());
  ASSERT_EQ(report.candidates().size(), 1U);
}

}  // namespace
}  // namespace planish
