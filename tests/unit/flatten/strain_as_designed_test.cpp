#include <planish/core/error.h>
#include <planish/flatten/flatten.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

namespace planish {
namespace {

TEST(StrainAsDesigned, IsThatOfPatternsOfThePatchAsItCame) {
  const TriMesh panel = make_shape("panel", 300);
  const Patch patch(panel);
  const Pattern least = unfold(patch);
  const auto strain = strain_as_designed(patch, {}, 1);
  ASSERT_TRUE(strain && strain->smallest_limit);
  EXPECT_EQ(strain->least_stretch.max, edge_strain(patch, least.positions).max);
  EXPECT_EQ(*strain->smallest_limit, smallest_limit(patch, least));
  EXPECT_LT(*strain->smallest_limit, strain->least_stretch.max);
  EXPECT_TRUE(strain->limits.empty());
}

TEST(StrainAsDesigned, LimitsAreKeptFromTheSmallestOn) {
  const TriMesh panel = make_shape("panel", 300);
  const double smallest = *strain_as_designed(Patch(panel), {}, 1)->smallest_limit;
  for (const auto& [factor, kept] : {std::pair{1.02, true}, std::pair{0.9, false}}) {
    const auto strain = strain_as_designed(Patch(panel), {.max = factor * smallest}, 1);
    ASSERT_EQ(strain->limits.size(), 1U);
    EXPECT_EQ(strain->limits.front().kept(), kept) << factor;
  }
}

TEST(StrainAsDesigned, EndsWhenCancelled) {
  const TriMesh panel = make_shape("panel", 300);
  for (const int allowed : {0, 1, 5}) {
    int last = 0;
    const auto on_step = [&](int step, double) {
      EXPECT_EQ(step, last + 1);
      last = step;
      return step <= allowed;
    };
    EXPECT_FALSE(strain_as_designed(Patch(panel), {.max = 0.01}, 1, on_step).has_value())
        << allowed;
    EXPECT_EQ(last, allowed + 1);
  }
}

TEST(StrainAsDesigned, RefusesWhatIsNoDisk) {
  TriMesh two = make_shape("panel", 100);
  const auto count = static_cast<Index>(two.positions.size());
  const TriMesh one = two;
  for (const Vec3 p : one.positions)
    two.positions.push_back(p + Vec3{100.0, 0.0, 0.0});
  for (const Triangle& t : one.triangles)
    two.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
  EXPECT_THROW(strain_as_designed(Patch(two), {}, 1), Error);
}

}  // namespace
}  // namespace planish
