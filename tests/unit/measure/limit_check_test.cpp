#include <planish/measure/limit_check.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace planish {
namespace {

using testing::ElementsAre;

TEST(Criterion, HasTheWordOfItsPlace) {
  EXPECT_EQ(to_string(Criterion::strain), "strain");
  EXPECT_EQ(to_string(Criterion::p99_compression), "p99_compression");
  EXPECT_EQ(to_string(Criterion::bending), "bending");
  EXPECT_EQ(to_string(Criterion::size), "size");
  EXPECT_EQ(to_string(Criterion::flipped_triangles), "flipped_triangles");
}

TEST(Criterion, NamesTheFigureThatItsLimitBounds) {
  const StrainLimits limits = {0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7};
  const EdgeStrain strain = {.max = 0.1,
                             .rms = 0.4,
                             .p99 = 0.2,
                             .max_stretch = 0.4,
                             .p99_stretch = 0.5,
                             .max_compression = 0.6,
                             .p99_compression = 0.8};
  std::vector<std::string_view> names;
  for (const Criterion what : k_strain_criteria) {
    EXPECT_TRUE(is_of_strain(what));
    names.push_back(figure_name(what));
    const bool is_more = what == Criterion::rms_strain || what == Criterion::p99_compression;
    EXPECT_EQ(figure_of(strain, what) > limits.of(what), is_more) << to_string(what);
  }
  EXPECT_THAT(names, ElementsAre("max", "p99", "rms", "max_stretch", "p99_stretch",
                                 "max_compression", "p99_compression"));
  EXPECT_FALSE(is_of_strain(Criterion::deviation));
}

TEST(CheckLimits, HasOneCheckForEachLimit) {
  const StrainLimits limits = {.p99 = 0.02, .max_stretch = 0.05};
  const auto checks = check_limits({.p99 = 0.02, .max_stretch = 0.06}, limits);
  ASSERT_EQ(checks.size(), 2U);
  EXPECT_EQ(checks[0].what, Criterion::p99_strain);
  EXPECT_TRUE(checks[0].met) << "at the limit";
  EXPECT_EQ(checks[1].what, Criterion::stretch);
  EXPECT_EQ(checks[1].limit, 0.05);
  EXPECT_EQ(checks[1].value, 0.06);
  EXPECT_FALSE(checks[1].met);
  EXPECT_FALSE(all_kept(checks));
  EXPECT_TRUE(all_kept(check_limits({.max = 1.0}, {})));
}

}  // namespace
}  // namespace planish
