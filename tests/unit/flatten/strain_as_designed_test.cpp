#include <planish/core/error.h>
#include <planish/flatten/flatten.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/watched_job.h"

namespace planish {
namespace {

TEST(StrainAsDesigned, IsThatOfPatternsOfThePatchAsItCame) {
  const TriMesh panel = make_shape("panel", 300);
  const Patch patch(panel);
  const Pattern least = unfold(patch, {.least_stretch = true});
  const auto strain = strain_as_designed(patch, {}, {.threads = 1});
  ASSERT_TRUE(strain.smallest_limit);
  EXPECT_EQ(strain.least_stretch.max, edge_strain(patch, least.positions).max);
  EXPECT_EQ(*strain.smallest_limit, smallest_limit(patch, least));
  EXPECT_LT(*strain.smallest_limit, strain.least_stretch.max);
  EXPECT_TRUE(strain.limits.empty());
}

TEST(StrainAsDesigned, LimitsAreKeptFromTheSmallestOn) {
  const TriMesh panel = make_shape("panel", 300);
  const double smallest = *strain_as_designed(Patch(panel), {}, {.threads = 1}).smallest_limit;
  for (const auto& [factor, kept] : {std::pair{1.02, true}, std::pair{0.9, false}}) {
    const auto strain =
        strain_as_designed(Patch(panel), {.max = factor * smallest}, {.threads = 1});
    ASSERT_EQ(strain.limits.size(), 1U);
    EXPECT_EQ(strain.limits.front().met, kept) << factor;
  }
}

TEST(StrainAsDesigned, ReportsRisingProgressAndCanBeCancelled) {
  const Patch panel(make_shape("panel", 300));
  expect_cancellable(
      [&](const Context& context) { strain_as_designed(panel, {.max = 0.01}, context); });
}

TEST(StrainAsDesigned, RefusesWhatIsNoDisk) {
  TriMesh two = make_shape("panel", 100);
  const auto count = static_cast<Index>(two.positions.size());
  const TriMesh one = two;
  for (const Vec3 p : one.positions)
    two.positions.push_back(p + Vec3{100.0, 0.0, 0.0});
  for (const Triangle& t : one.triangles)
    two.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  EXPECT_THROW(strain_as_designed(Patch(two), {}, {.threads = 1}), Error);
}

}  // namespace
}  // namespace planish
