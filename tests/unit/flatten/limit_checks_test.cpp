#include "flatten/limit_checks.h"

#include <array>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/sample_report.h"

namespace planish {
namespace {

TEST(LimitChecks, AreNoneWhereNoneWasGiven) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{};
  EXPECT_TRUE(limit_checks(report).empty());
  report.evolve.method = ControllableLaplacian{};
  EXPECT_TRUE(limit_checks(report).empty()) << "its own least angle was not asked for";
}

TEST(LimitChecks, CompareWithWhatCameOut) {
  FlattenReport report = samples::flatten_report();  // strain 0.3187, deviation 0.5678
  report.evolve.method = Auto{.max_deviation = 0.5};
  report.unfold.limits = {{Criterion::strain, 0.32, 0.3187}};
  report.evolve.stopping.target_e_max = 0.047;  // e_max 0.0641 * 0.73 = 0.0468
  const auto checks = limit_checks(report);
  ASSERT_EQ(checks.size(), 3U);
  EXPECT_EQ(checks[0].what, Criterion::strain);
  EXPECT_TRUE(checks[0].met);
  EXPECT_EQ(checks[1].what, Criterion::deviation);
  EXPECT_FALSE(checks[1].met);
  EXPECT_EQ(checks[1].value, 0.5678);
  EXPECT_EQ(checks[2].what, Criterion::e_max);
  EXPECT_TRUE(checks[2].met);
  EXPECT_EQ(limit_text(checks[0], Unit::mm), "at most 32\u00A0%");
  EXPECT_EQ(limit_text(checks[1], Unit::cm), "at most 5.00\u00A0mm");
}

TEST(LimitChecks, HaveStretchAndCompressionApart) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{};
  report.unfold.limits = {{Criterion::stretch, 0.12, 0.1},
                          {Criterion::p99_stretch, 0.08, 0.1},
                          {Criterion::compression, 0.02, 0.01},
                          {Criterion::p99_compression, 0.01, 0.02}};
  const auto checks = limit_checks(report);
  ASSERT_EQ(checks.size(), 4U);
  const std::array codes = {"stretch", "p99_stretch", "compression", "p99_compression"};
  const std::array texts = {
      "at most 12\u00A0% of stretch", "at most 8.0\u00A0% of stretch on 99 % of the area",
      "at most 2.0\u00A0% of compression", "at most 1.0\u00A0% of compression on 99 % of the area"};
  for (std::size_t k = 0; k < checks.size(); ++k) {
    EXPECT_EQ(to_string(checks[k].what), codes[k]);
    EXPECT_EQ(limit_text(checks[k], Unit::mm), texts[k]);
    EXPECT_EQ(checks[k].met, k % 2 == 0);
  }
  EXPECT_THAT(report.outcome().missed,
              testing::IsSupersetOf({Criterion::p99_stretch, Criterion::p99_compression}));
}

TEST(LimitChecks, AllowAnglesThatWereSmallerBefore) {
  FlattenReport report = samples::flatten_report();  // 17.3 degrees before, 12.6 after
  report.evolve.method = Auto{.min_angle = 10.0};
  EXPECT_TRUE(limit_checks(report).front().met);
  report.evolve.method = Auto{.min_angle = 15.0};
  EXPECT_FALSE(limit_checks(report).front().met);
  report.evolve.before.figures.min_angle = report.evolve.after.figures.min_angle;
  EXPECT_TRUE(limit_checks(report).front().met);
}

TEST(LimitChecks, CompareBendingWithItsBound) {
  FlattenReport report = samples::flatten_report();
  report.evolve.fairness.bending_ratio = 1.6;
  report.evolve.method = Auto{.max_bending = 1.5};
  const LimitCheck check = limit_checks(report).front();
  EXPECT_EQ(check.what, Criterion::bending);
  EXPECT_EQ(check.value, 1.6);
  EXPECT_FALSE(check.met);
  EXPECT_EQ(limit_text(check, Unit::mm), "at most 1.50 times the design's");
  report.evolve.method = Auto{.max_bending = 1.7, .prefer = Prefer::flat};
  EXPECT_TRUE(limit_checks(report).front().met);
  report.evolve.method = Auto{.max_bending = 1.5, .prefer = Prefer::near};
  EXPECT_TRUE(limit_checks(report).empty()) << "it has no bound of bending";
}

}  // namespace
}  // namespace planish
