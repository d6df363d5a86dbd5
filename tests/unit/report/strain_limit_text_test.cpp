#include <cmath>

#include <planish/mesh/shapes.h>
#include <planish/report/html_report.h>
#include <planish/report/strain_check.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "unit/report/sample_report.h"

namespace planish {
namespace {

using testing::HasSubstr;

TEST(StrainCheck, IsOnlyOfRunsThatHadALimit) {
  FlattenReport report = samples::flatten_report();
  EXPECT_FALSE(check_strain(report));
  report.evolve.method = Auto{};
  EXPECT_FALSE(check_strain(report));
  report.evolve.method = Auto{.max_strain = 0.02};
  EXPECT_TRUE(check_strain(report));
}

TEST(StrainCheck, IsMetUpToTheLimit) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{.max_strain = 0.02};
  report.unfold.strain.max = 0.02;
  EXPECT_TRUE(check_strain(report)->met());
  EXPECT_EQ(check_text(*check_strain(report)),
            "The strain limit of 2 % is met: the pattern's largest strain is 2 %.");
  report.unfold.strain.max = std::nextafter(0.02, 1.0);
  EXPECT_FALSE(check_strain(report)->met());
}

TEST(StrainCheck, TellsWhatIsLeftAndWhereInTheReportToo) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{.max_strain = 0.02};
  report.unfold.strain.max = 0.0312;
  report.unfold.strain.worst_edge = {3, 4};
  report.processed.positions[3] = {1.0, 2.0, 3.0};
  report.processed.positions[4] = {2.0, 2.0, -5.0};
  const std::string text = check_text(*check_strain(report));
  EXPECT_EQ(text,
            "The strain limit of 2 % is not met: the pattern's largest strain is 3.12 %, at the "
            "edge from vertex 3 to 4, near (1.5, 2, -1).");
  EXPECT_THAT(html_report(report), HasSubstr("largest strain is 3.12 %"));
}

TEST(StrainCheck, NeverSaysThatTheSameNumberIsTooMuch) {
  const StrainCheck check = {.max_strain = 0.02, .largest_strain = 0.0200001, .edge = {}, .at = {}};
  EXPECT_THAT(check_text(check), HasSubstr("limit of 2 % is not met"));
  EXPECT_THAT(check_text(check), HasSubstr("largest strain is 2.00001 %"));
}

TEST(RmsStrainCheck, IsToldByItselfOrAfterTheOther) {
  FlattenReport report = samples::flatten_report();
  EXPECT_FALSE(check_rms_strain(report));
  EXPECT_EQ(strain_limits_text(report), "");
  report.evolve.method = Auto{.max_rms_strain = 0.01};
  report.unfold.strain.rms = 0.01;
  report.unfold.strain.max = 0.05;
  EXPECT_TRUE(check_rms_strain(report)->met());
  EXPECT_FALSE(check_strain(report));
  const std::string met =
      "The limit of 1 % for the rms of the strain is met: the pattern's is 1 %.";
  EXPECT_EQ(strain_limits_text(report), met);
  EXPECT_NE(html_report(report).find("usual stretch at most 1.0\u00A0% (rms)"), std::string::npos);
  report.evolve.method = Auto{.max_strain = 0.05, .max_rms_strain = 0.01};
  EXPECT_EQ(strain_limits_text(report),
            "The strain limit of 5 % is met: the pattern's largest strain is 5 %. " + met);
  report.unfold.strain.rms = 0.010001;
  EXPECT_FALSE(check_rms_strain(report)->met());
  EXPECT_THAT(strain_limits_text(report), HasSubstr("is not met: the pattern's is 1.0001 %."));
}

TEST(StrainCheck, IsThatOfThePatternAsMeasured) {
  const auto report =
      flatten(make_shape("panel", 400), "panel", {.method = Auto{.max_strain = 0.02}});
  ASSERT_TRUE(report);
  const StrainCheck check = *check_strain(*report);
  const auto [v, w] = check.edge;
  const auto& pattern = report->unfold.pattern.positions;
  const auto& patch = report->processed.positions;
  const double strain = norm(pattern[v] - pattern[w]) / norm(patch[v] - patch[w]) - 1.0;
  EXPECT_NEAR(std::abs(strain), check.largest_strain, 1e-12);
  EXPECT_EQ(check.largest_strain, report->unfold.strain.max);
  EXPECT_EQ(check.at, 0.5 * (patch[v] + patch[w]));
}

}  // namespace
}  // namespace planish
