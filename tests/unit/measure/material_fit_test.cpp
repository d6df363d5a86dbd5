#include <algorithm>

#include <planish/measure/material.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

Material some_material() {
  return {.name = "suede",
          .stretch = {{0.08, "a"}, MaterialFigure{0.15, "b"}},
          .compression = {{0.02, "c"}}};
}

const MaterialVerdict& verdict_on(const std::vector<MaterialVerdict>& verdicts,
                                  std::string_view name) {
  return *std::find_if(verdicts.begin(), verdicts.end(), [name](const MaterialVerdict& verdict) {
    return verdict.material->name == name;
  });
}

TEST(LimitsOf, AMaterialThatGivesAlikeAreForBothWays) {
  EXPECT_EQ(limits_of(material_named("cotton")), (StrainLimits{.p99 = 0.05}));
  Material alike = some_material();
  alike.compression = alike.stretch;
  EXPECT_EQ(limits_of(alike), (StrainLimits{.max = 0.15, .p99 = 0.08}));
}

TEST(LimitsOf, AMaterialThatDoesNotAreApart) {
  EXPECT_EQ(limits_of(some_material()),
            (StrainLimits{.max_stretch = 0.15, .p99_stretch = 0.08, .p99_compression = 0.02}));
}

TEST(MaterialsFor, SaysWhichTakeAPatternAndWhichDoNot) {
  const EdgeStrain strain = {.max = 0.12,
                             .rms = 0.03,
                             .p99 = 0.082,
                             .max_stretch = 0.12,
                             .p99_stretch = 0.082,
                             .max_compression = 0.03,
                             .p99_compression = 0.02};
  const auto verdicts = materials_for(strain);
  ASSERT_EQ(verdicts.size(), materials().size());
  const MaterialVerdict& neoprene = verdict_on(verdicts, "neoprene");
  EXPECT_TRUE(neoprene.takes) << "its limit is for 99 % of the area";
  EXPECT_EQ(neoprene.tightest.limit, 0.10);
  EXPECT_EQ(neoprene.tightest.value, 0.082);
  const MaterialVerdict& cotton = verdict_on(verdicts, "cotton");
  EXPECT_FALSE(cotton.takes);
  EXPECT_EQ(cotton.tightest.what, Criterion::p99_strain);
  EXPECT_EQ(cotton.tightest.limit, 0.05);
  EXPECT_TRUE(verdict_on(verdicts, "stretch-woven").takes) << "8.2 of 10.7 and 2 of 5 %";
  const MaterialVerdict& lasted = verdict_on(verdicts, "leather-lasted");
  EXPECT_FALSE(lasted.takes);
  EXPECT_EQ(lasted.tightest.what, Criterion::p99_compression) << "twice of it, of stretch as much";
  EXPECT_EQ(lasted.tightest.value, 0.02);
  EXPECT_EQ(lasted.tightest.limit, 0.01);
}

TEST(MaterialsFor, TakesThemAllWhereThereIsNoStrain) {
  for (const MaterialVerdict& verdict : materials_for({}))
    EXPECT_TRUE(verdict.takes && verdict.tightest.limit > 0.0) << verdict.material->name;
}

}  // namespace
}  // namespace planish
