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
  EXPECT_EQ(strain_limit_text({.what = Criterion::strain, .limit = 0.02, .value = 0.02}),
            "The limit of 2 % for the strain of every edge is kept: the pattern has 2 %.");
  EXPECT_EQ(strain_limit_text({.what = Criterion::p99_strain, .limit = 0.05, .value = 0.0312}),
            "The limit of 5 % for the strain on 99 % of the area is kept: the pattern has 3.12 %.");
  EXPECT_EQ(strain_limit_text({.what = Criterion::rms_strain, .limit = 0.01, .value = 0.005}),
            "The limit of 1 % for the rms of the strain is kept: the pattern has 0.5 %.");
  EXPECT_EQ(strain_limit_text({.what = Criterion::stretch, .limit = 0.12, .value = 0.1}),
            "The limit of 12 % for the stretch of every edge is kept: the pattern has 10 %.");
  EXPECT_EQ(strain_limit_text({.what = Criterion::p99_stretch, .limit = 0.12, .value = 0.1}),
            "The limit of 12 % for the stretch on 99 % of the area is kept: the pattern has 10 %.");
  EXPECT_EQ(strain_limit_text({.what = Criterion::compression, .limit = 0.01, .value = 0.01}),
            "The limit of 1 % for the compression of every edge is kept: the pattern has 1 %.");
  EXPECT_THAT(strain_limit_text({.what = Criterion::p99_compression, .limit = 0.01, .value = 0.02}),
              HasSubstr("The limit of 1 % for the compression on 99 % of the area is not kept"));
}

TEST(StrainLimitText, SaysHowMuchIsLeftAndWhere) {
  const LimitCheck check{.what = Criterion::strain,
                         .limit = 0.02,
                         .value = 0.0312,
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
  const LimitCheck check{.limit = 0.02, .value = 0.0200001};
  EXPECT_THAT(strain_limit_text(check),
              HasSubstr("limit of 2 % for the strain of every edge is not"));
  EXPECT_THAT(strain_limit_text(check), HasSubstr("the pattern has 2.00001 %"));
}

TEST(StrainLimitText, OfSeveralIsOneAfterTheOther) {
  EXPECT_EQ(strain_limits_text({}), "");
  const std::vector<LimitCheck> checks = {
      {.what = Criterion::strain, .limit = 0.05, .value = 0.04},
      {.what = Criterion::rms_strain, .limit = 0.01, .value = 0.02}};
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
