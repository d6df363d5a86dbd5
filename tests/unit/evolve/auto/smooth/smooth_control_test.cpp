#include "evolve/auto/smooth/smooth_control.h"

#include <optional>

#include <gtest/gtest.h>

namespace planish {
namespace {

using namespace tuning::prefer_smooth;

constexpr DescentStrain k_at_first{0.02, 0.1};
constexpr StrainLimits k_limit{.rms = 1e-3};
/// Within the limit, with room for bending.
constexpr DescentStrain k_within{9e-4, 4e-3};
constexpr double k_smooth_bending = 0.7;
/// Where the border stays it has no effect.
constexpr double k_deviation = 0.01;

SmoothDescent::Step step_that_takes(double share, int parts = 1) {
  return {.moved = 1, .merit_before = 1.0, .merit = 1.0 - share, .parts = parts};
}

SmoothControl on_finer_level(double least_delta_factor = k_least_delta_factor) {
  SmoothControl control({.limit = k_limit}, k_at_first);
  control.start_finer(least_delta_factor);
  return control;
}

void take(SmoothControl& control, int steps, const SmoothDescent::Step& step) {
  for (int k = 0; k < steps; ++k)
    control.after(step, k_within, k_smooth_bending, k_deviation);
}

TEST(SmoothControl, KeepsTheWeightsOfTheCoarserLevelAtFirst) {
  SmoothControl control = on_finer_level();
  const SmoothWeights before = control.weights();
  take(control, k_steps_lifted - 1, step_that_takes(0.1));
  EXPECT_EQ(control.weights().delta, before.delta);
  EXPECT_EQ(control.weights().sigma, before.sigma);
}

TEST(SmoothControl, LowersDeltaByNoMoreThanItsFactor) {
  for (const double factor : {k_least_delta_factor, k_least_delta_factor_large}) {
    SmoothControl control = on_finer_level(factor);
    const double before = control.weights().delta;
    take(control, k_steps_lifted, step_that_takes(0.1));
    EXPECT_DOUBLE_EQ(control.weights().delta, factor * before);
  }
}

TEST(SmoothControl, CountsAStepAlongLinesAsThree) {
  SmoothControl free = on_finer_level(), along_lines = on_finer_level();
  take(free, k_steps_lifted, step_that_takes(0.1));
  take(along_lines, k_steps_lifted, step_that_takes(0.1, 3));
  take(free, 1, step_that_takes(0.5 * k_settled_fall));
  EXPECT_FALSE(free.is_over());
  take(along_lines, 1, step_that_takes(0.5 * k_settled_fall_along_lines, 3));
  EXPECT_TRUE(along_lines.is_over());
  take(free, 1, step_that_takes(0.5 * k_settled_fall));
  EXPECT_TRUE(free.is_over());
}

TEST(SmoothControl, KeepsTheFormWhereMuchStrainMayStay) {
  EXPECT_EQ(SmoothControl({.limit = {.rms = 2.0 * k_loose}}, k_at_first).weights().form,
            k_loose_form);
  EXPECT_EQ(SmoothControl({.limit = {.rms = 0.5 * k_tight}}, k_at_first).weights().form, 0.0);
}

TEST(SmoothControl, BeginsLessCloseTheMoreStrainHasToGo) {
  const auto first_delta = [](double strain_over_limit) {
    constexpr double limit = 2.0 * k_loose, led_to = tuning::k_rms_limit_share * limit;
    return SmoothControl({.limit = {.rms = limit}}, {strain_over_limit * led_to, 1.0})
        .weights()
        .delta;
  };
  EXPECT_DOUBLE_EQ(first_delta(1.0), k_first_delta * k_loose_delta);
  EXPECT_DOUBLE_EQ(first_delta(1.5), 2.25 * k_first_delta * k_loose_delta);
  EXPECT_DOUBLE_EQ(first_delta(50.0), k_most_first_delta * k_loose_delta);
}

TEST(SmoothControl, BeginsAtATightLimitWithTheSameDeltaForEveryStrain) {
  const auto first_delta = [](double strain, bool flat) {
    return SmoothControl({.limit = {.rms = 0.5 * k_tight}, .flat = flat}, {strain, 1.0})
        .weights()
        .delta;
  };
  for (const double strain : {0.01, 0.1}) {
    EXPECT_DOUBLE_EQ(first_delta(strain, false), k_first_delta * k_tight_delta);
    EXPECT_DOUBLE_EQ(first_delta(strain, true), k_first_delta_flat * k_tight_delta);
  }
}

TEST(SmoothControl, GivesUpClosenessThenTheFormThenStrain) {
  DescentStrain too_much{0.1, 0.3};
  constexpr double too_bent = 2.0;
  SmoothControl control({.limit = {.rms = 2.0 * k_loose}}, k_at_first);
  const auto lead = [&] {
    too_much.rms *= 0.97;  // not stuck
    control.after(step_that_takes(0.1), too_much, too_bent, k_deviation);
  };
  while (control.weights().delta < k_most_delta) {
    EXPECT_EQ(control.weights().form, k_loose_form);
    lead();
  }
  lead();
  EXPECT_DOUBLE_EQ(control.weights().form, k_form_fall * k_loose_form);
  while (control.weights().form > 0.0)
    lead();
  lead();
  EXPECT_TRUE(control.leaves_strain());
}

TEST(SmoothControl, GivesUpTheFormBeforeStrainIsLeft) {
  constexpr DescentStrain stuck{0.02, 0.1};
  SmoothControl control({.limit = {.rms = 2.0 * k_loose}}, k_at_first);
  double form = k_loose_form;
  int falls = 0;
  for (int k = 0; k < 40; ++k) {
    EXPECT_TRUE(!control.leaves_strain() || form == 0.0);
    control.after(step_that_takes(0.1), stuck, k_smooth_bending, k_deviation);
    falls += control.weights().form < form ? 1 : 0;
    form = control.weights().form;
  }
  EXPECT_GT(falls, 3);
  EXPECT_EQ(form, 0.0);
  EXPECT_TRUE(control.leaves_strain());
}

TEST(SmoothControl, EndsAfterTheMostStepsWhereAllStrainIsToGo) {
  for (const int parts : {1, 3}) {
    SmoothControl control({.limit = k_limit}, k_at_first);
    control.start_strict();
    int steps = 0;
    for (; !control.is_over() && steps < 2 * k_most_strict_steps; ++steps)
      take(control, 1, step_that_takes(0.1, parts));
    EXPECT_EQ(steps, (k_most_strict_steps + parts - 1) / parts);
    EXPECT_EQ(control.weights().sigma, k_last_strict_sigma);
  }
}

TEST(SmoothControl, MakesAStepWithTheLastSigma) {
  for (const int parts : {1, 3}) {
    SmoothControl control({.limit = k_limit}, k_at_first);
    control.start_strict();
    while (control.weights().sigma != k_last_strict_sigma)
      take(control, 1, step_that_takes(0.0, parts));
    EXPECT_FALSE(control.is_over());
    take(control, 1, step_that_takes(0.0, parts));
    EXPECT_TRUE(control.is_over());
  }
}

TEST(SmoothControl, BeginsTheCloserTheFurtherTheBorderMayMove) {
  const auto first_delta = [](std::optional<double> border_reach) {
    return SmoothControl({.limit = {.rms = 0.5 * k_tight}, .border_reach = border_reach},
                         k_at_first)
        .weights()
        .delta;
  };
  EXPECT_EQ(first_delta({}), k_first_delta * k_tight_delta);
  EXPECT_EQ(first_delta(0.0), first_delta({}));
  EXPECT_DOUBLE_EQ(first_delta(0.5 * k_far_border),
                   0.5 * (first_delta(0.0) + first_delta(k_far_border)));
  EXPECT_EQ(first_delta(k_far_border), k_first_delta * k_tight_delta_far_border);
  EXPECT_EQ(first_delta(10.0 * k_far_border), first_delta(k_far_border));
  const SmoothControl flat(
      {.limit = {.rms = 0.5 * k_tight}, .flat = true, .border_reach = k_far_border}, k_at_first);
  EXPECT_EQ(flat.weights().delta, k_first_delta_flat * k_tight_delta_far_border);
}

/// Delta after so many steps of a patch whose border may move, or not.
double delta_led(std::optional<double> border_reach, double deviation, double bending,
                 double max_bending = 0.0) {
  SmoothControl control(
      {.limit = {.rms = 0.5 * k_tight}, .max_bending = max_bending, .border_reach = border_reach},
      k_at_first);
  control.start_finer();
  for (int k = 0; k < 40; ++k)
    control.after(step_that_takes(0.1), {0.4 * k_tight, 1e-3}, bending, deviation);
  return control.weights().delta;
}

TEST(SmoothControl, LetsDeltaFollowTheDeviationWhereTheBorderMayMove) {
  for (const double deviation : {0.005, 0.01, 0.02})
    EXPECT_DOUBLE_EQ(delta_led(k_far_border, deviation, k_smooth_bending),
                     k_delta_of_deviation * deviation);
  EXPECT_EQ(delta_led(k_far_border, 1e-5, k_smooth_bending), k_tight_delta_far_border);
  EXPECT_EQ(delta_led(k_far_border, 0.01, 2.0 * k_tight_ceiling), k_most_delta)
      << "bent too much, so closeness gives way";
  EXPECT_EQ(delta_led({}, 0.02, k_smooth_bending), k_tight_delta) << "the border stays";
  EXPECT_EQ(delta_led(k_far_border, 0.02, k_smooth_bending, 3.0), k_bounded_delta)
      << "a bound of bending leads";
}

constexpr double k_bound = 3.0;

TEST(SmoothControl, BeginsTheCloserTheMoreBendingIsAllowed) {
  const auto first_delta = [](double max_bending) {
    return SmoothControl({.limit = {.rms = 0.5 * k_tight}, .max_bending = max_bending}, k_at_first)
        .weights()
        .delta;
  };
  const double usual = k_first_delta * k_tight_delta;
  EXPECT_DOUBLE_EQ(first_delta(k_nearly * k_tight_ceiling), usual);
  EXPECT_DOUBLE_EQ(first_delta(2.0 * k_nearly * k_tight_ceiling), 0.5 * usual);
  EXPECT_EQ(first_delta(1e6), k_least_first_delta);
  EXPECT_EQ(first_delta(1e-6), k_most_delta);
}

TEST(SmoothControl, GetsCloserUntilTheBoundOfBendingIsReached) {
  SmoothControl control({.limit = k_limit, .max_bending = k_bound}, k_at_first);
  control.start_finer();
  double delta = control.weights().delta;
  take(control, k_steps_lifted, step_that_takes(0.0));
  EXPECT_LT(control.weights().delta, delta);
  EXPECT_FALSE(control.is_over()) << "settled, but bent less than it may be";
  control.after(step_that_takes(0.0), k_within, k_bound / k_nearly, k_deviation);
  EXPECT_TRUE(control.is_over());
  control.after(step_that_takes(0.0), k_within, 1.1 * k_bound, k_deviation);
  EXPECT_FALSE(control.is_over()) << "bent too much";
  delta = control.weights().delta;
  control.after(step_that_takes(0.0), k_within, 1.1 * k_bound, k_deviation);
  EXPECT_GT(control.weights().delta, delta);
}

TEST(SmoothControl, EndsAtTheLeastDeltaWhereThePatchBendsLessThanTheBound) {
  SmoothControl control({.limit = k_limit, .max_bending = k_bound}, k_at_first);
  control.start_finer();
  int steps = 0;
  for (; !control.is_over() && steps < 100; ++steps)
    take(control, 1, step_that_takes(0.0));
  EXPECT_EQ(control.weights().delta, k_bounded_delta);
  EXPECT_LT(steps, 100);
}

TEST(SmoothControl, GivesUpClosenessWhereItKeepsStrainAboveTheLimit) {
  constexpr DescentStrain strained{5e-3, 2e-2};
  SmoothControl control({.limit = k_limit, .max_bending = k_bound}, k_at_first);
  control.start_finer();
  double least = 1.0;
  for (int k = 0; k < 30; ++k) {
    control.after(step_that_takes(0.1), strained, k_smooth_bending, k_deviation);
    least = std::min(least, control.weights().delta);
  }
  EXPECT_EQ(control.weights().sigma, k_least_sigma * strained.rms);
  EXPECT_GT(control.weights().delta, 2.0 * least);
}

TEST(SmoothControl, GivesUpClosenessWhereItKeepsStrainThatIsToGo) {
  SmoothControl control({.limit = k_limit, .flat = true, .max_bending = k_bound}, k_at_first);
  control.start_strict();
  const double delta = control.weights().delta, sigma = control.weights().sigma;
  control.after(step_that_takes(0.1), {0.9 * k_much_left * sigma, 1.0}, k_smooth_bending,
                k_deviation);
  EXPECT_EQ(control.weights().delta, delta);
  control.after(step_that_takes(0.1), {1.1 * k_much_left * sigma, 1.0}, k_smooth_bending,
                k_deviation);
  EXPECT_DOUBLE_EQ(control.weights().delta, k_most_delta_factor * delta);
}

TEST(SmoothControl, LeadsBendingToTheBoundWhereAllStrainIsToGo) {
  constexpr DescentStrain hardly_any{1e-5, 1e-4};
  SmoothControl control({.limit = k_limit, .flat = true, .max_bending = k_bound}, k_at_first);
  control.start_strict();
  const double delta = control.weights().delta;
  control.after(step_that_takes(0.1), hardly_any, k_smooth_bending, k_deviation);
  EXPECT_DOUBLE_EQ(control.weights().delta, k_least_delta_factor * delta);
  while (control.weights().sigma != k_last_strict_sigma)
    control.after(step_that_takes(0.1), hardly_any, k_smooth_bending, k_deviation);
  for (int k = 0; k < k_settled_steps; ++k) {
    EXPECT_FALSE(control.is_over());
    control.after(step_that_takes(0.0), hardly_any, k_bound / k_room_for_polish, k_deviation);
  }
  EXPECT_TRUE(control.is_over());
}

}  // namespace
}  // namespace planish
