#include "flatten/reference_sweeps.h"

#include <gtest/gtest.h>

#include "support/sample_report.h"

namespace planish {
namespace {

TEST(ReferenceSweeps, AreThoseOfTheMethodOf2010OnThePatchAsItCame) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{};
  const auto sweeps = reference_sweeps(report);
  const auto wanted = evolve(report.input, ControllableLaplacian{}, {.max_sweeps = 10}).history;
  ASSERT_EQ(sweeps.size(), wanted.size());
  for (std::size_t i = 0; i < sweeps.size(); ++i) {
    EXPECT_EQ(sweeps[i].e_max, wanted[i].e_max);
    EXPECT_EQ(sweeps[i].energy, wanted[i].energy);
  }
}

TEST(ReferenceSweeps, AreNotManyMoreThanThoseOfTheRun) {
  FlattenReport report = samples::flatten_report();
  report.evolve.method = Auto{};
  report.evolve.result.history.resize(17);
  EXPECT_LE(reference_sweeps(report).size(), 17U);
  report.evolve.result.history.resize(400);
  EXPECT_LE(reference_sweeps(report).size(), 50U);
  report.evolve.method = ControllableLaplacian{};
  EXPECT_TRUE(reference_sweeps(report).empty()) << "the run itself is one";
}

}  // namespace
}  // namespace planish
