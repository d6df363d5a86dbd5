#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>
#include <stdexcept>
#include <thread>

#include <planish/flatten/product.h>
#include <planish/mesh/shapes.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "support/jacket.h"
#include "support/meshes.h"
#include "support/products.h"
#include "support/twins.h"
#include "support/watched_job.h"

namespace planish {
namespace {

using testing::ElementsAre;
using testing::UnorderedElementsAre;

/// Three strips with two seams.
std::vector<ProductPatch> strips() {
  std::vector<ProductPatch> patches;
  for (NamedPatch& strip : in_strips(make_shape("saddle", 300), 3))
    patches.push_back({strip.name, std::move(strip.mesh)});
  return patches;
}

/// A pair, something else, and a tube, which cannot be laid flat.
std::vector<ProductPatch> coat() {
  const TriMesh sleeve = meshes::rough_grid(8, 6, 3, 0.2, 0.3);
  return {{"left", sleeve},
          {"tube", meshes::tube(8, 3)},
          {"right", meshes::mirrored(sleeve)},
          {"back", make_shape("dome", 150)}};
}

ProductOptions quick() {
  ProductOptions options;
  options.flatten.method = ControllableLaplacian{};
  options.flatten.stopping = Stopping{.max_sweeps = 2};
  return options;
}

/// With matching that is no matter of what can be.
ProductOptions matched_always(ProductOptions options) {
  options.flatten.match_seams = true;
  return options;
}

void expect_same(const ProductReport& report, const ProductReport& other) {
  ASSERT_EQ(report.patches.size(), other.patches.size());
  for (std::size_t p = 0; p < report.patches.size(); ++p) {
    const PatchResult &one = report.patches[p], &two = other.patches[p];
    EXPECT_EQ(one.name, two.name);
    EXPECT_EQ(one.failure.has_value(), two.failure.has_value()) << one.name;
    ASSERT_EQ(one.finished.has_value(), two.finished.has_value()) << one.name;
    if (!one.finished) continue;
    EXPECT_EQ(one.finished->processed.positions, two.finished->processed.positions) << one.name;
    EXPECT_EQ(one.finished->unfold.pattern.positions, two.finished->unfold.pattern.positions);
    EXPECT_EQ(one.finished->twin_of.has_value(), two.finished->twin_of.has_value());
  }
  ASSERT_EQ(report.seams.size(), other.seams.size());
  for (std::size_t s = 0; s < report.seams.size(); ++s)
    EXPECT_EQ(report.seams[s].in_pattern, other.seams[s].in_pattern);
}

TEST(FlattenProduct, SearchesForSeamsOnlyInAGroup) {
  std::vector<ProductPatch> patches = strips();
  EXPECT_EQ(flatten_product(patches, quick()).seams.size(), 2U);
  patches[2].group = 1;
  const ProductReport report = flatten_product(patches, quick());
  ASSERT_EQ(report.seams.size(), 1U);
  EXPECT_EQ(report.seams[0].seam.sides[0].patch, 0U);
  EXPECT_EQ(report.seams[0].seam.sides[1].patch, 1U);
}

TEST(FlattenProduct, TakesLimitsAndWordsOfAPatch) {
  std::vector<ProductPatch> patches = coat();
  patches[2].limits = StrainLimits{.p99 = 0.25};
  patches[2].words = {"neoprene", 3};
  const ProductReport report = flatten_product(patches, quick());
  EXPECT_FALSE(report.twins[2]) << "it may stretch more than the other one";
  EXPECT_TRUE(report.patches[0].finished->unfold.limits.empty());
  ASSERT_EQ(report.patches[2].finished->unfold.limits.size(), 1U);
  EXPECT_EQ(report.patches[2].finished->unfold.limits[0].limit, 0.25);
  EXPECT_EQ(report.patches[2].words.material, "neoprene");
  EXPECT_EQ(report.patches[2].words.quantity, 3);
  patches[0].limits = patches[2].limits;
  EXPECT_TRUE(flatten_product(patches, quick()).twins[2]);
}

TEST(FlattenProduct, GoesOnWhereAPatchFails) {
  std::vector<ProductPatch> patches = coat();
  patches.push_back({"lost", {}, {}, Failure{"file_unreadable", "lost.obj: no such file"}});
  std::vector<std::string> told;
  const ProductReport report =
      flatten_product(patches, quick(), {.on_done = [&](std::size_t p, PatchResult& result) {
                        EXPECT_EQ(result.name, patches[p].name);
                        told.push_back(result.name);
                      }});
  EXPECT_EQ(report.finished(), 3U);
  EXPECT_THAT(told, UnorderedElementsAre("left", "tube", "right", "back", "lost"));
  ASSERT_TRUE(report.patches[1].failure);
  EXPECT_EQ(report.patches[1].failure->code, "several_border_loops");
  EXPECT_EQ(report.patches[4].failure->message, "lost.obj: no such file");
  EXPECT_EQ(report.patches[3].vertices, patches[3].mesh.positions.size());
  EXPECT_EQ(report.patches[3].finished->stop, StopReason::sweep_limit);
}

TEST(FlattenProduct, TakesWhatFlattenMakesOfEachPatch) {
  const std::vector<ProductPatch> patches = coat();
  const ProductReport report = flatten_product(patches, quick());
  for (const std::size_t p : {0U, 3U}) {
    const auto alone = flatten(Patch(patches[p].mesh), patches[p].name, quick().flatten);
    EXPECT_EQ(report.patches[p].finished->processed.positions, alone.processed.positions());
    EXPECT_EQ(report.patches[p].finished->unfold.pattern.positions, alone.unfold.pattern.positions);
  }
}

TEST(FlattenProduct, MakesTwinsFromTheirOthers) {
  const std::vector<ProductPatch> patches = coat();
  std::mutex mutex;
  std::map<std::size_t, std::optional<PatchTwin>> reports;
  const ProductReport report = flatten_product(
      patches, quick(),
      {.on_report = [&](std::size_t p, const FlattenReport& full, const PatchTwin* twin) {
        const std::lock_guard lock(mutex);
        EXPECT_EQ(full.name, patches[p].name);
        EXPECT_EQ(full.twin_of.has_value(), twin != nullptr);
        reports[p] = twin ? std::optional(*twin) : std::nullopt;
      }});
  ASSERT_EQ(reports.size(), 3U);
  ASSERT_TRUE(reports[2]);
  EXPECT_EQ(reports[2]->patch, 0U);
  EXPECT_TRUE(reports[2]->mirrored);
  ASSERT_TRUE(report.twins[2]);
  EXPECT_EQ(report.twins[2]->vertex, reports[2]->vertex);
  EXPECT_FALSE(report.twins[0] || report.twins[1] || report.twins[3]);
  EXPECT_EQ(report.patches[2].finished->twin_of->name, "left");
  const auto& left = report.patches[0].finished->unfold.pattern.positions;
  const auto& right = report.patches[2].finished->unfold.pattern.positions;
  for (std::size_t v = 0; v < left.size(); ++v) {
    EXPECT_EQ(right[reports[2]->vertex[v]].x, -left[v].x);
    EXPECT_EQ(right[reports[2]->vertex[v]].y, left[v].y);
  }
}

TEST(FlattenProduct, DoesNotDependOnTheNumberOfThreads) {
  for (const auto& patches : {coat(), strips()}) {
    const ProductReport one = flatten_product(patches, quick(), {}, {.threads = 1});
    expect_same(one, flatten_product(patches, quick(), {}, {.threads = 4}));
    expect_same(one, flatten_product(patches, quick()));
  }
}

TEST(FlattenProduct, WorksOnTheCallingThreadWhereThereIsToBeOne) {
  const auto here = std::this_thread::get_id();
  flatten_product(
      coat(), quick(),
      {.on_report = [&](std::size_t, const FlattenReport&,
                        const PatchTwin*) { EXPECT_EQ(std::this_thread::get_id(), here); }},
      {.threads = 1});
}

TEST(FlattenProduct, ReportsProgressByPatchAndCanBeCancelled) {
  for (const unsigned threads : {1U, 3U}) {
    WatchedJob job;
    flatten_product(strips(), quick(), {}, job.context(threads));
    EXPECT_EQ(job.reports(), 3);
    EXPECT_EQ(job.share(), 1.0);
    EXPECT_THAT(job.subjects(), ElementsAre(strips()[0].name, strips()[1].name, strips()[2].name));
    for (const int most : {0, 1, 2}) {
      WatchedJob cut(most);
      EXPECT_THROW(flatten_product(strips(), quick(), {}, cut.context(threads)), Cancelled);
      EXPECT_EQ(cut.reports(), most);
    }
  }
}

TEST(FlattenProduct, EndsWithWhatItsCallbackForResultsThrows) {
  for (const unsigned threads : {1U, 3U}) {
    const auto cancel = [](std::size_t, PatchResult&) { throw Cancelled(); };
    EXPECT_THROW(flatten_product(strips(), quick(), {.on_done = cancel}, {.threads = threads}),
                 Cancelled);
  }
}

/// Runs again with the finished patches of a report, but for some; returns what was flattened.
std::vector<std::string> flattened_anew(const std::vector<ProductPatch>& patches,
                                        const ProductReport& before, std::size_t missing) {
  std::mutex mutex;
  std::vector<std::string> anew;
  const ProductReport report =
      flatten_product(patches, quick(),
                      {.earlier =
                           [&](std::size_t p, const PatchTwin* twin, const SewnBorder&) {
                             EXPECT_EQ(twin != nullptr, before.twins[p].has_value());
                             return p == missing ? std::nullopt : before.patches[p].finished;
                           },
                       .on_report =
                           [&](std::size_t, const FlattenReport& full, const PatchTwin*) {
                             const std::lock_guard lock(mutex);
                             anew.push_back(full.name);
                           }});
  expect_same(report, before);
  for (const PatchResult& patch : report.patches)
    EXPECT_EQ(patch.resumed,
              patch.finished && std::find(anew.begin(), anew.end(), patch.name) == anew.end());
  return anew;
}

TEST(FlattenProduct, KeepsWhatAnEarlierRunMade) {
  const std::vector<ProductPatch> patches = coat();
  const ProductReport before = flatten_product(patches, quick());
  EXPECT_THAT(flattened_anew(patches, before, patches.size()), ElementsAre());
  EXPECT_THAT(flattened_anew(patches, before, 3), ElementsAre("back"));
  EXPECT_THAT(flattened_anew(patches, before, 2), UnorderedElementsAre("left", "right"))
      << "the twin is made from the full report";
}

TEST(FlattenProduct, TakesWhatACallbackThrowsForTheFailureOfThatPatch) {
  const ProductReport report =
      flatten_product(strips(), quick(),
                      {.on_report =
                           [](std::size_t p, const FlattenReport&, const PatchTwin*) {
                             if (p == 1) throw Error(ErrorCode::allowance_too_wide, "too wide");
                             if (p == 2) throw std::runtime_error("lost");
                           },
                       .on_done =
                           [](std::size_t p, PatchResult& result) {
                             if (p == 0) result.finished.reset();
                             if (p == 0) result.failure = Failure{"file_unwritable", "full"};
                           }});
  EXPECT_EQ(report.finished(), 0U);
  EXPECT_EQ(report.patches[0].failure->code, "file_unwritable");
  EXPECT_EQ(report.patches[1].failure->code, "allowance_too_wide");
  EXPECT_EQ(report.patches[2].failure->code, "internal_error");
}

TEST(FlattenProduct, MeasuresSeamsOnTheModelAndInBothPatterns) {
  const std::vector<ProductPatch> patches = strips();
  ProductOptions options = quick();
  options.flatten.unit = Unit::cm;
  options.match_seams = false;
  const ProductReport plain = flatten_product(patches, options);
  ASSERT_EQ(plain.seams.size(), 2U);
  const SeamSide& side = plain.seams[0].seam.sides[0];
  EXPECT_NEAR(plain.seams[0].on_model[0],
              10.0 * length_of(side, std::span<const Vec3>(patches[0].mesh.positions)), 1e-9);
  EXPECT_GT(*plain.seams[0].difference(), 1e-6);
  EXPECT_FALSE(plain.patches[0].finished->unfold.unmatched_strain);
  options.match_seams = true;
  expect_same(flatten_product(patches, options), flatten_product(patches, matched_always(options)));
  const ProductReport matched = flatten_product(patches, options);
  for (const MeasuredSeam& seam : matched.seams)
    EXPECT_LT(*seam.difference(), 1e-8 * seam.on_model[0]);
  EXPECT_TRUE(matched.patches[0].finished->unfold.unmatched_strain);
}

TEST(FlattenProduct, MatchesSeamsWithinLimitsWhereItCan) {
  const std::vector<ProductPatch> patches = strips();
  ProductOptions options = quick();
  options.flatten.stopping = Stopping{.max_sweeps = 0};
  const ProductReport free = flatten_product(patches, options);
  double most = 0.0;
  for (const PatchResult& patch : free.patches)
    most = std::max(most, patch.finished->unfold.strain.max);
  options.flatten.limits.max = 0.8 * most;
  const ProductReport report = flatten_product(patches, options);
  for (const PatchResult& patch : report.patches) {
    EXPECT_TRUE(all_kept(patch.finished->unfold.limits)) << patch.name;
    EXPECT_TRUE(patch.finished->unfold.unmatched_strain) << patch.name;
  }
  for (const MeasuredSeam& seam : report.seams)
    EXPECT_LT(*seam.difference(), 1e-8 * seam.on_model[0]);
}

/// Two ribbons, 1e8 times as long as wide: numbers cannot tell whether their ends keep lengths.
TEST(FlattenProduct, GoesOnWithoutMatchingWhereABorderCannotKeepItsLengths) {
  std::vector<ProductPatch> patches;
  for (const double y : {0.0, 2.0}) {
    TriMesh ribbon = meshes::flat_grid(12, 2);
    for (Vec3& p : ribbon.positions)
      p = {1e8 * p.x, p.y + y, 0.1 * p.x * (p.y + y)};
    patches.push_back({"ribbon", std::move(ribbon)});
  }
  ProductOptions options = quick();
  options.flatten.stopping = Stopping{.max_sweeps = 0};
  const ProductReport report = flatten_product(patches, options);
  ASSERT_FALSE(report.seams.empty());
  for (const PatchResult& patch : report.patches) {
    ASSERT_TRUE(patch.finished) << patch.failure->message;
    EXPECT_TRUE(patch.finished->unfold.pattern.is_unmatchable);
    EXPECT_FALSE(patch.finished->unfold.unmatched_strain);
  }
  for (const PatchResult& patch : flatten_product(patches, matched_always(options)).patches) {
    ASSERT_TRUE(patch.failure) << "where seams must match";
    EXPECT_EQ(patch.failure->code, "unfold_failed");
  }
}

TEST(FlattenProduct, LeavesThePatternOfAPatchWithoutSeams) {
  const std::vector<ProductPatch> patches = {{"dome", make_shape("dome", 150)}};
  ProductOptions options = quick();
  const ProductReport report = flatten_product(patches, options);
  options.match_seams = false;
  expect_same(report, flatten_product(patches, options));
  EXPECT_FALSE(report.patches[0].finished->unfold.unmatched_strain);
}

/// The border edges of a strip at its ends and outer sides stretch as little as they can.
TEST(FlattenProduct, LeavesWhatIsSewnToNothingFree) {
  const std::vector<ProductPatch> patches = strips();
  ProductOptions options = quick();
  options.flatten.stopping = Stopping{.max_sweeps = 0};
  options.flatten.match_seams = true;
  const ProductReport report = flatten_product(patches, options);
  for (std::size_t p = 0; p < patches.size(); ++p) {
    const UnfoldReport& unfold = report.patches[p].finished->unfold;
    EXPECT_LT(unfold.border_strain, 1e-9) << "of edges along seams";
    const Patch patch(patches[p].mesh);
    EXPECT_GT(largest_border_strain(patch, unfold.pattern.positions), 1e-5);
    const double all = unfold_patch(patch, Unit::mm, {.match_seams = true}).strain.rms;
    EXPECT_LT(unfold.strain.rms, all);
  }
}

TEST(FlattenProduct, LeavesHemsFreeWhereTheDesignIsSmoothedFirst) {
  const std::vector<ProductPatch> patches = strips();
  ProductOptions options = quick();
  options.flatten.stopping = Stopping{.max_sweeps = 0};
  options.flatten.match_seams = true;
  const Vec3 size = measure_size(Patch(patches[0].mesh)).extent;
  options.flatten.smooth_first = 0.2 * std::max({size.x, size.y, size.z});
  for (const PatchResult& piece : flatten_product(patches, options).patches) {
    ASSERT_TRUE(piece.finished) << piece.failure->message;
    const UnfoldReport& unfold = piece.finished->unfold;
    EXPECT_LT(unfold.border_strain, 1e-9) << "of edges along seams";
    EXPECT_GT(largest_border_strain(Patch(piece.finished->processed), unfold.pattern.positions),
              1e-5);
  }
}

TEST(FlattenProduct, MatchesTheWholeBorderOfAPatchWithoutSeams) {
  ProductOptions options = quick();
  options.flatten.match_seams = true;
  const std::vector<ProductPatch> patches = {{"dome", make_shape("dome", 150)}};
  const ProductReport report = flatten_product(patches, options);
  const FinishedPatch& dome = *report.patches[0].finished;
  EXPECT_LT(largest_border_strain(Patch(dome.processed), dome.unfold.pattern.positions), 1e-9);
}

/// Two sleeves, mirror images, one of them sewn to a strip.
TEST(FlattenProduct, FreesOfTwinsWhatIsSewnToNothingInBoth) {
  const TriMesh left = meshes::height_field(6, 4, [](double x, double y) { return 0.05 * x * y; });
  TriMesh strip = meshes::flat_grid(6, 2);
  for (std::size_t v = 0; v < strip.positions.size(); ++v)
    strip.positions[v].y -= 2.0;
  TriMesh right = meshes::mirrored(left);
  for (Vec3& p : right.positions)
    p.z += 50.0;
  ProductOptions options = quick();
  options.flatten.stopping = Stopping{.max_sweeps = 0};
  options.flatten.match_seams = true;
  const ProductReport report = flatten_product(
      std::vector<ProductPatch>{{"left", left}, {"right", right}, {"strip", strip}}, options);
  ASSERT_EQ(report.seams.size(), 1U);
  ASSERT_TRUE(report.patches[1].finished->twin_of);
  const auto& mirrored = report.patches[1].finished->unfold;
  EXPECT_LT(mirrored.border_strain, 1e-9);
  EXPECT_EQ(mirrored.pattern.width, report.patches[0].finished->unfold.pattern.width);
}

TEST(FlattenProduct, ReportsTheEasingOfSeamsThatWereMeshedApart) {
  std::vector<ProductPatch> patches;
  for (NamedPatch& panel : meshes::Jacket::panels())
    patches.push_back({panel.name, std::move(panel.mesh)});
  ProductOptions options = quick();
  options.flatten.stopping = Stopping{.max_sweeps = 0};
  options.flatten.match_seams = true;
  const ProductReport report = flatten_product(patches, options);
  ASSERT_EQ(report.seams.size(), meshes::Jacket::seams().size());
  std::size_t eased = 0;
  for (const MeasuredSeam& seam : report.seams) {
    // Every side is as long as on the model.
    EXPECT_NEAR(*seam.difference(), seam.difference_on_model(), 1e-6);
    EXPECT_EQ(seam.longer(), seam.longer_on_model());
    EXPECT_EQ(seam.longer().has_value(), *seam.difference() >= 0.01);
    if (!seam.longer()) continue;
    ++eased;
    EXPECT_GT(*seam.in_pattern[*seam.longer()], *seam.in_pattern[1 - *seam.longer()]);
  }
  EXPECT_EQ(eased, 4U) << "the armholes, whose edges cut their bends";
  EXPECT_TRUE(report.near_borders.empty());
}

TEST(FlattenProduct, KnowsNoLengthInThePatternOfAPatchThatFailed) {
  std::vector<ProductPatch> patches = strips();
  patches[1].failure = Failure{"unfold_failed", "as a test has it"};
  const ProductReport report = flatten_product(patches, quick());
  ASSERT_EQ(report.seams.size(), 2U);
  for (const MeasuredSeam& seam : report.seams) {
    EXPECT_GT(seam.on_model[0], 0.0);
    EXPECT_FALSE(seam.difference());
    EXPECT_NE(seam.in_pattern[0].has_value(), seam.in_pattern[1].has_value());
  }
}

TEST(FlattenProduct, RefusesWhatNamesTheVerticesOfOneMesh) {
  ProductOptions options = quick();
  options.flatten.constraints.fixed = {0};
  EXPECT_THROW(flatten_product(strips(), options), Error);
  options = quick();
  options.flatten.keep = {0};
  EXPECT_THROW(flatten_product(strips(), options), Error);
  options = quick();
  options.flatten.free_edges = {{0, 1}};
  EXPECT_THROW(flatten_product(strips(), options), Error);
  options = quick();
  for (const double wrong : {-1.0, std::nan(""), std::numeric_limits<double>::infinity()}) {
    options.seam_tolerance = wrong;
    EXPECT_THROW(flatten_product(strips(), options), Error) << wrong;
  }
  for (const double wrong : {-0.02, std::nan(""), 2.0}) {
    options = quick();
    options.flatten.limits.max = wrong;
    EXPECT_THROW(flatten_product(strips(), options), Error) << wrong;
    std::vector<ProductPatch> patches = strips();
    patches[1].limits = StrainLimits{.p99 = wrong};
    EXPECT_THROW(flatten_product(patches, quick()), Error) << wrong;
  }
}

TEST(FlattenProduct, KeepsTheDesignOfPiecesThatMoved) {
  const std::vector<ProductPatch> patches = strips();
  const ProductReport report = flatten_product(patches, quick());
  for (std::size_t p = 0; p < patches.size(); ++p) {
    EXPECT_EQ(report.patches[p].design, patches[p].mesh.positions);
    EXPECT_NE(report.patches[p].finished->processed.positions, report.patches[p].design);
  }
  ProductOptions still = quick();
  still.flatten.stopping = Stopping{.max_sweeps = 0};
  for (const PatchResult& piece : flatten_product(patches, still).patches)
    EXPECT_TRUE(piece.design.empty()) << "none moved";
}

TEST(FlattenProduct, KeepsTheDesignOfTheVerticesThatRemeshingLeaves) {
  std::vector<ProductPatch> patches;
  patches.push_back({"dense", make_shape("dome", 9000)});
  ProductOptions options = quick();
  options.flatten.remesh = true;
  const ProductReport report = flatten_product(patches, options);
  const PatchResult& piece = report.patches.front();
  const std::vector<Index>& source = piece.finished->source;
  ASSERT_EQ(source.size(), piece.finished->processed.positions.size());
  ASSERT_LT(source.size(), patches[0].mesh.positions.size());
  ASSERT_EQ(piece.design.size(), source.size());
  double moved = 0.0;
  for (std::size_t v = 0; v < source.size(); ++v) {
    EXPECT_EQ(piece.design[v], patches[0].mesh.positions[source[v]]);
    moved = std::max(moved, norm(piece.design[v] - piece.finished->processed.positions[v]));
  }
  EXPECT_GT(moved, 0.0);
  // An earlier run may have kept what is of no use.
  FinishedPatch earlier = *piece.finished;
  earlier.source.back() = 1'000'000;
  const ProductReport resumed = flatten_product(
      patches, options, {.earlier = [&](auto&&...) { return std::optional(earlier); }});
  EXPECT_TRUE(resumed.patches.front().resumed);
  EXPECT_TRUE(resumed.patches.front().design.empty());
}

TEST(FlattenProduct, IsOfNothingWhereThereIsNothing) {
  const ProductReport report = flatten_product({}, quick());
  EXPECT_TRUE(report.patches.empty());
}

TEST(FinishedPatch, LeavesOutPatternsThatAreOnlyComparedWith) {
  FlattenOptions options = quick().flatten;
  options.match_seams = true;
  const auto report = flatten(Patch(make_shape("dome", 150)), "dome", options);
  const FinishedPatch patch = finished_patch(report);
  EXPECT_FALSE(report.unfold.pattern.unmatched_least_stretch.empty());
  EXPECT_TRUE(patch.unfold.pattern.unmatched_least_stretch.empty());
  EXPECT_EQ(patch.unfold.unmatched_strain->max, report.unfold.unmatched_strain->max);
  EXPECT_EQ(patch.stop, report.evolve.result.stop);
}

}  // namespace
}  // namespace planish
