// What auto does on real patches; see patches_test.cpp.

#include <algorithm>
#include <utility>
#include <vector>

#include <planish/evolve/evolve.h>
#include <planish/flatten/flatten.h>
#include <planish/io/read_mesh.h>
#include <planish/measure/deviation.h>
#include <planish/measure/flattenability.h>
#include <planish/unfold/strain.h>
#include <planish/unfold/unfold.h>

#include <gtest/gtest.h>

#include "support/test_patches.h"

namespace planish {
namespace {

struct Ended {
  StopReason stop;
  double deviation;  // rms, in model units
  double roughness;
  double strain;  // rms, of the pattern
};

Ended run(const TriMesh& mesh, Method method) {
  if (auto* options = std::get_if<Auto>(&method)) options->prefer = Prefer::near;
  const EvolveResult result = evolve(Patch(mesh), method, usual_stopping(method));
  const Patch patch(mesh);
  const TriMesh moved{result.positions, mesh.triangles};
  const Pattern pattern = unfold(Patch(moved));
  return {result.stop, measure_deviation(patch, result.positions).rms,
          measure(Patch(moved)).roughness, edge_strain(Patch(moved), pattern.positions).rms};
}

/// One mesh, or none where no folder is told.
std::vector<TriMesh> body_front() {
  std::vector<TriMesh> found;
  for (const PatchFacts& facts : patches()) {
    if (facts.path.stem() == "gc_front_4k") found.push_back(read_mesh(facts.path).mesh);
  }
  return found;
}

TEST(AutoOnPatches, StaysCloserWhereItMayGetRougher) {
  for (const TriMesh& mesh : body_front()) {
    const Ended smooth = run(mesh, Auto{.closeness = 0.0}), usual = run(mesh, Auto{}),
                rough = run(mesh, Auto{.closeness = 2.0});
    for (const Ended& ended : {smooth, usual, rough})
      EXPECT_EQ(ended.stop, StopReason::converged);
    EXPECT_LT(usual.deviation, 0.9 * smooth.deviation);
    EXPECT_LT(rough.deviation, usual.deviation);
    EXPECT_LT(smooth.roughness, usual.roughness);
    EXPECT_LT(usual.roughness, rough.roughness);
  }
}

TEST(AutoOnPatches, IsNearerTheMoreStrainThereMayBe) {
  for (const TriMesh& mesh : body_front()) {
    const Ended flat = run(mesh, Auto{});
    Ended last = flat, last_apart = flat;
    for (const double limit : {0.02, 0.05, 0.1, 0.2}) {
      const Ended ended = run(mesh, Auto{.limits = {.max = limit}});
      EXPECT_EQ(ended.stop, StopReason::strain_met) << limit;
      EXPECT_LT(ended.deviation, flat.deviation) << limit;
      EXPECT_GT(ended.strain, last.strain) << limit;
      last = ended;
      // Where a way ends has some chance in it: of two limits close to one another either may be
      // nearer.
      if (limit == 0.05) continue;
      EXPECT_LT(ended.deviation, last_apart.deviation) << limit;
      last_apart = ended;
    }
  }
}

TEST(AutoOnPatches, IsNearerThanLeastNormAtItsStrain) {
  for (const TriMesh& mesh : body_front()) {
    using Update = LeastNormUpdate;
    const std::pair<Update, double> limits[] = {
        {Update::direct, 0.14}, {Update::uniform, 0.02}, {Update::cotangent, 0.0}};
    for (const auto& [update, limit] : limits) {
      const Ended theirs = run(mesh, LeastNorm{.update = update});
      const Ended ours = run(mesh, Auto{.limits = {.max = limit}});
      EXPECT_LT(ours.strain, std::max(theirs.strain, 1e-4)) << limit;
      EXPECT_LT(ours.deviation, theirs.deviation) << limit;
    }
  }
}

/// The estimate of auto is a little too low there: it has to be run again.
TEST(FlattenOnPatches, KeepsTheAimByThePatternNotByTheEstimate) {
  for (const PatchFacts& facts : patches()) {
    if (facts.path.stem() != "mhf_calf_raw4k") continue;
    const TriMesh mesh = read_mesh(facts.path).mesh;
    const auto report = flatten(Patch(mesh), "calf", preset_options(5));
    EXPECT_EQ(report.evolve.result.stop, StopReason::strain_met);
    EXPECT_LE(report.unfold.strain.rms, k_unmeasurable_strain);
    EXPECT_TRUE(report.evolve.fairness.bends_little());
    const auto limited = flatten(Patch(mesh), "calf", {.limits = {.rms = 0.01}});
    EXPECT_TRUE(all_kept(limited.unfold.limits));
  }
}

/// Its pattern within the limit overlaps itself at the crotch: that is none to cut.
TEST(FlattenOnPatches, ChangesTheFormWhereThePatternWithinTheLimitsOverlaps) {
  for (const PatchFacts& facts : patches()) {
    if (facts.path.stem() != "jumpsuit_front_3k") continue;
    const Patch patch(read_mesh(facts.path).mesh);
    const StrainLimits cotton{.p99 = 0.05};
    const auto as_designed = flatten(patch, "front", {.keep_design = true, .limits = cotton});
    EXPECT_TRUE(all_kept(as_designed.unfold.limits));
    EXPECT_TRUE(as_designed.unfold.pattern.overlaps);
    const auto report = flatten(patch, "front", {.limits = cotton});
    EXPECT_TRUE(all_kept(report.unfold.limits));
    EXPECT_FALSE(report.unfold.pattern.overlaps);
    EXPECT_GT(report.evolve.deviation.max, 0.0);
    EXPECT_TRUE(report.evolve.fairness.bends_little());
  }
}

}  // namespace
}  // namespace planish
