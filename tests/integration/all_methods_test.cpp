// What every method promises.

#include <algorithm>
#include <cmath>

#include <planish/evolve/evolve.h>
#include <planish/mesh/shapes.h>

#include <gtest/gtest.h>

#include "support/meshes.h"

namespace planish {
namespace {

class AllMethods : public testing::TestWithParam<Method> {};

template <std::size_t... I>
std::vector<Method> all_methods(std::index_sequence<I...>) {
  return {Method(std::variant_alternative_t<I, Method>{})...};
}

INSTANTIATE_TEST_SUITE_P(
    Methods, AllMethods,
    testing::ValuesIn(all_methods(std::make_index_sequence<k_named_methods>())),
    [](const auto& test) { return std::string(name_of(test.param)); });

bool all_finite(const std::vector<Vec3>& positions) {
  return std::all_of(positions.begin(), positions.end(),
                     [](Vec3 p) { return std::isfinite(p.x + p.y + p.z); });
}

TEST_P(AllMethods, GiveTheSameBitsOnEveryRunAndAnyNumberOfThreads) {
  const TriMesh mesh = make_shape("panel", 1500);
  const auto first = evolve(Patch(mesh), GetParam(), {.max_sweeps = 4}, {}, {.threads = 1});
  EXPECT_NE(first.positions, mesh.positions);
  for (const unsigned threads : {1U, 2U, 4U}) {
    const auto again = evolve(Patch(mesh), GetParam(), {.max_sweeps = 4}, {}, {.threads = threads});
    EXPECT_EQ(again.positions, first.positions) << threads;
    EXPECT_EQ(again.stop, first.stop);
    ASSERT_EQ(again.history.size(), first.history.size());
    EXPECT_EQ(again.history.back().energy, first.history.back().energy);
  }
}

TEST_P(AllMethods, CanBeCancelled) {
  const Patch patch(make_shape("panel", 1500));
  int reports = 0;
  const Context context{.on_progress = [&](const Progress&) { ++reports; },
                        .is_cancelled = [&] { return reports > 0; }};
  EXPECT_THROW(evolve(patch, GetParam(), {.max_sweeps = 50}, {}, context), Cancelled);
  EXPECT_EQ(reports, 1);
}

TEST_P(AllMethods, EndWithAReasonAndARecordOfEverySweep) {
  constexpr int most = 8;
  const auto result = evolve(Patch(make_shape("dome", 100)), GetParam(), {.max_sweeps = most});
  ASSERT_FALSE(result.history.empty());
  for (std::size_t i = 0; i < result.history.size(); ++i) {
    EXPECT_EQ(result.history[i].sweep, static_cast<int>(i) + 1);
    EXPECT_TRUE(std::isfinite(result.history[i].energy));
  }
  EXPECT_EQ(result.stop == StopReason::sweep_limit,
            result.history.size() == std::size_t{most} &&
                result.history.back().status == SweepStatus::running);
}

TEST_P(AllMethods, NeverReturnWhatIsNoNumber) {
  // Needles, spikes, folded stars, a lattice with corners of exactly 90 and 180 degrees.
  std::vector<TriMesh> nasty;
  nasty.push_back(meshes::height_field(
      12, 12, [](double x, double y) { return 5.0 * std::sin(37.0 * x + 91.0 * y * y); }));
  TriMesh needles = make_shape("saddle", 150);
  for (Vec3& p : needles.positions)
    p.x *= 1e-6;
  nasty.push_back(needles);
  TriMesh spike = make_shape("panel", 150);
  spike.positions[Patch(spike).inner_vertices()[40]].z += 1e6;
  nasty.push_back(spike);
  TriMesh folded = make_shape("panel", 150);
  std::swap(folded.positions[Patch(folded).inner_vertices()[40]],
            folded.positions[Patch(folded).inner_vertices()[60]]);
  nasty.push_back(folded);
  for (std::size_t i = 0; i < nasty.size(); ++i) {
    const auto result = evolve(Patch(nasty[i]), GetParam(), {.max_sweeps = 5});
    EXPECT_TRUE(all_finite(result.positions)) << i;
    for (const SweepRecord& record : result.history)
      EXPECT_TRUE(std::isfinite(record.energy)) << i;
  }
}

TEST_P(AllMethods, LeaveAFlatPatchAlone) {
  const TriMesh flat = meshes::flat_grid(8, 8);
  const auto result = evolve(Patch(flat), GetParam(), {.max_sweeps = 5});
  EXPECT_EQ(result.positions, flat.positions);
  EXPECT_EQ(result.stop, StopReason::reached_target);
}

TEST_P(AllMethods, WorkOnOneInnerVertex) {
  TriMesh pyramid = meshes::fan(5);
  pyramid.positions[Patch(pyramid).inner_vertices()[0]].z += 0.2;
  const auto result = evolve(Patch(pyramid), GetParam(), {.max_sweeps = 20});
  EXPECT_TRUE(all_finite(result.positions));
  EXPECT_FALSE(result.history.empty());
}

}  // namespace
}  // namespace planish
