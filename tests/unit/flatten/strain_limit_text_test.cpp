#include "flatten/strain_limit_text.h"

#include <cmath>

#include <planish/report/html_report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/sample_report.h"

namespace planish {
namespace {

using testing::HasSubstr;

TEST(StrainLimitText, SaysOfWhatTheLimitIsAndThatItIsKept) {
  EXPECT_EQ(strain_limit_text({.kind = StrainLimitKind::max, .asked = 0.02, .reached = 0.02}),
            "The limit of 2 % for the strain of every edge is kept: the pattern has 2 %.");
  EXPECT_EQ(strain_limit_text({.kind = StrainLimitKind::p99, .asked = 0.05, .reached = 0.0312}),
            "The limit of 5 % for the strain on 99 % of the area is kept: the pattern has 3.12 %.");
  EXPECT_EQ(strain_limit_text({.kind = StrainLimitKind::rms, .asked = 0.01, .reached = 0.005}),
            "The limit of 1 % for the rms of the strain is kept: the pattern has 0.5 %.");
  EXPECT_EQ(
      strain_limit_text({.kind = StrainLimitKind::max_stretch, .asked = 0.12, .reached = 0.1}),
      "The limit of 12 % for the stretch of every edge is kept: the pattern has 10 %.");
  EXPECT_EQ(
      strain_limit_text({.kind = StrainLimitKind::p99_stretch, .asked = 0.12, .reached = 0.1}),
      "The limit of 12 % for the stretch on 99 % of the area is kept: the pattern has 10 %.");
  EXPECT_EQ(
      strain_limit_text({.kind = StrainLimitKind::max_compression, .asked = 0.01, .reached = 0.01}),
      "The limit of 1 % for the compression of every edge is kept: the pattern has 1 %.");
  EXPECT_THAT(
      strain_limit_text({.kind = StrainLimitKind::p99_compression, .asked = 0.01, .reached = 0.02}),
      HasSubstr("The limit of 1 % for the compression on 99 % of the area is not kept"));
}

TEST(StrainLimitText, SaysHowMuchIsLeftAndWhere) {
  const StrainLimitCheck check{.kind = StrainLimitKind::max,
                               .asked = 0.02,
                               .reached = 0.0312,
                               .share_beyond = 0.0123,
                               .edge = {3, 4},
                               .at = {1.5, 2.0, -1.0}};
  EXPECT_EQ(strain_limit_text(check),
            "The limit of 2 % for the strain of every edge is not kept: the pattern has 3.12 %, "
            "most at the edge from vertex 3 to 4, near (1.5, 2, -1); 1.2 % of the area is beyond "
            "the limit.");
  FlattenReport report = samples::flatten_report();
  report.unfold.limits = {check};
  EXPECT_THAT(html_report(report), HasSubstr("the pattern has 3.12 %"));
}

TEST(StrainLimitText, NeverSaysThatTheSameNumberIsTooMuch) {
  const StrainLimitCheck check{.asked = 0.02, .reached = 0.0200001};
  EXPECT_THAT(strain_limit_text(check),
              HasSubstr("limit of 2 % for the strain of every edge is not"));
  EXPECT_THAT(strain_limit_text(check), HasSubstr("the pattern has 2.00001 %"));
}

TEST(StrainLimitText, OfSeveralIsOneAfterTheOther) {
  EXPECT_EQ(strain_limits_text({}), "");
  const std::vector<StrainLimitCheck> checks = {
      {.kind = StrainLimitKind::max, .asked = 0.05, .reached = 0.04},
      {.kind = StrainLimitKind::rms, .asked = 0.01, .reached = 0.02}};
  EXPECT_EQ(strain_limits_text(checks),
            strain_limit_text(checks[0]) + " " + strain_limit_text(checks[1]));
  FlattenReport report = samples::flatten_report();
  report.unfold.limits = checks;
  const std::string page = html_report(report);
  EXPECT_THAT(page, HasSubstr("✗ not within the limit of 1.0\u00A0% (rms)"));
  EXPECT_THAT(page, HasSubstr(strain_limits_text(checks)));
}

}  // namespace
}  // namespace planish
