#include <set>
#include <string>

#include <planish/flatten/compare.h>
#include <planish/mesh/shapes.h>
#include <planish/report/json_report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/sample_comparison.h"
#include "support/watched_job.h"

namespace planish {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

TEST(Compare, RunsEveryMethodOfTheVariantWithItsUsualStopping) {
  const auto runs = runs_of_all_methods();
  ASSERT_EQ(runs.size(), k_named_methods);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    EXPECT_EQ(runs[i].method.index(), i);
    EXPECT_EQ(runs[i].stopping.max_sweeps, usual_stopping(runs[i].method).max_sweeps);
  }
}

TEST(Compare, GivesEachMethodWhatItGivesAlone) {
  const TriMesh mesh = make_shape("panel", 300);
  const std::vector<CompareRun> runs = {{ControllableLaplacian{}, {.max_sweeps = 5}},
                                        {ClassicalLaplacian{}, {.max_sweeps = 3}}};
  const auto report = compare(Patch(mesh), "panel", runs, {.unit = Unit::cm});
  ASSERT_EQ(report.runs.size(), 2U);
  ASSERT_TRUE(report.design_least_stretch);
  const auto before = unfold_patch(Patch(mesh), Unit::cm, {.least_stretch = true});
  EXPECT_EQ(report.design_least_stretch->strain.rms, before.strain.rms);
  EXPECT_EQ(report.before.figures.energy, measure_patch(Patch(mesh)).figures.energy);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const ComparedMethod& method = report.runs[i];
    const EvolveReport alone = evolve_patch(Patch(mesh), runs[i].method, runs[i].stopping);
    ASSERT_TRUE(method.evolve && method.unfold);
    EXPECT_FALSE(method.failure);
    EXPECT_EQ(method.evolve->result.positions, alone.result.positions);
    EXPECT_EQ(method.evolve->after.figures.energy, alone.after.figures.energy);
    const auto unfolded = unfold_patch(Patch({alone.result.positions, mesh.triangles}), Unit::cm,
                                       {.least_stretch = true});
    EXPECT_EQ(method.unfold->strain.rms, unfolded.strain.rms);
    EXPECT_EQ(method.unfold->unit, Unit::cm);
  }
}

TEST(Compare, GoesOnWhereAMethodFails) {
  const auto report = compare(
      Patch(make_shape("dome", 200)), "dome",
      {{ClassicalLaplacian{.lambda = 7.0}, {}}, {ControllableLaplacian{}, {.max_sweeps = 2}}});
  ASSERT_TRUE(report.runs[0].failure);
  EXPECT_EQ(report.runs[0].failure->code, "option_out_of_range");
  EXPECT_FALSE(report.runs[0].evolve);
  EXPECT_THAT(verdict_text(report, report.runs[0]), StartsWith("failed: lambda is 7"));
  EXPECT_FALSE(report.runs[1].failure);
  EXPECT_TRUE(report.runs[1].evolve);
}

TEST(Compare, DoesWithoutPatternsWhereThePatchIsNoDisk) {
  const auto report = compare(Patch(meshes::tube(12, 8)), "tube", {{ControllableLaplacian{}, {}}});
  EXPECT_FALSE(report.design_least_stretch);
  EXPECT_THAT(report.why_no_patterns, HasSubstr("border"));
  EXPECT_TRUE(report.runs[0].evolve);
  EXPECT_FALSE(report.runs[0].unfold);
  EXPECT_FALSE(report.runs[0].failure);
  EXPECT_THROW(compare(Patch(meshes::tetrahedron()), "", {{ControllableLaplacian{}, {}}}), Error)
      << "nothing would hold a closed surface";
}

TEST(Compare, ReportsRisingProgressAndCanBeCancelledAnywhere) {
  const Patch patch(make_shape("dome", 200));
  const std::vector<CompareRun> runs = {{ControllableLaplacian{}, {.max_sweeps = 3}},
                                        {ClassicalLaplacian{}, {.max_sweeps = 3}}};
  WatchedJob job;
  compare(patch, "", runs, {}, job.context());
  EXPECT_THAT(job.subjects(), ElementsAre("", "classical", "controllable"));
  expect_cancellable([&](const Context& context) { compare(patch, "", runs, {}, context); });
}

TEST(CompareVerdict, GoesByTheStrainAndNamesThePrice) {
  CompareReport report = samples::comparison();
  const auto verdict = [&](std::size_t run) { return verdict_text(report, report.runs[run]); };
  EXPECT_EQ(verdict(0), "better pattern: strain 7.6 % -> 2.6 %");
  EXPECT_EQ(verdict(1), "worse pattern: strain 7.6 % -> 8.6 %; needles (0.12 deg)");
  EXPECT_EQ(verdict(2), "failed: no <weights> here");
  EXPECT_EQ(best_run(report), 0U);
  report.runs[0].unfold->strain.rms = 0.0761;
  EXPECT_EQ(verdict(0), "no better pattern: energy -27 %, strain as before");
  EXPECT_EQ(best_run(report), std::nullopt);
  report.runs[1].unfold->strain.rms = 0.01;
  EXPECT_EQ(best_run(report), std::nullopt) << "at the price of needles";
  report.runs[0].evolve->fairness.bending_ratio = 4.2;
  report.runs[0].evolve->fairness.form_change->ripple = 4.0;
  report.runs[0].unfold->pattern.overlaps = true;
  report.runs[0].unfold->pattern.flipped_triangles = 1;
  EXPECT_THAT(verdict(0), HasSubstr("; crumpled (bent 4.2 times as much, 1.2 % of it sharply), "
                                    "pattern overlaps, flipped triangles"));
  report.runs[0].evolve->deviation.max = 0.0;
  EXPECT_THAT(verdict(0), StartsWith("moved nothing"));
  report.runs[1].evolve->after.flattenable = true;
  EXPECT_THAT(verdict(1), StartsWith("flattenable: strain 7.6 % -> 1 %"));
}

TEST(CompareVerdict, GoesByTheCurvatureLeftWithoutPatterns) {
  CompareReport report = samples::comparison();
  report.design_least_stretch.reset();
  for (ComparedMethod& method : report.runs)
    method.unfold.reset();
  EXPECT_EQ(verdict_text(report, report.runs[0]), "better patch: curvature left 1.7 -> 1.3 rad");
  EXPECT_EQ(best_run(report), 0U);
}

TEST(CompareJson, HasTheReportsOfItsPartsAndNullForWhatThereIsNot) {
  const CompareReport report = samples::comparison();
  using Json = nlohmann::ordered_json;
  const Json json = Json::parse(json_report(report));
  EXPECT_EQ(json["name"], "front panel");
  Json input = samples::part_of(json_report(report.before));
  for (const char* of_measure : {"strain", "limits"})
    input.erase(of_measure);
  EXPECT_EQ(json["input"], input);
  EXPECT_EQ(json["unfold_before"], samples::part_of(json_report(*report.design_least_stretch)));
  EXPECT_EQ(json["best"], "controllable");
  ASSERT_EQ(json["runs"].size(), 3U);
  Json first = json["runs"][0];
  EXPECT_EQ(first["unfold"], samples::part_of(json_report(*report.runs[0].unfold)));
  EXPECT_TRUE(first["error"].is_null());
  EXPECT_EQ(first["verdict"], verdict_text(report, report.runs[0]));
  for (const char* key : {"unfold", "error", "verdict"})
    first.erase(key);
  EXPECT_EQ(first, samples::part_of(json_report(*report.runs[0].evolve)));
  const Json failed = json["runs"][2];
  EXPECT_EQ(failed["method"], "classical");
  EXPECT_EQ(failed["options"]["lambda"], 0.5);
  EXPECT_TRUE(failed["unfold"].is_null());
  EXPECT_EQ(failed["error"],
            Json({{"code", "unsupported_constraint"}, {"message", "no <weights> here"}}));
}

TEST(CompareCsv, HasALineForEverySweepOfEveryMethod) {
  CompareReport report = samples::comparison();
  report.runs[0].evolve->result.history = {{1, 0.5, 0.25, 2.0, 7, 0.125}};
  report.runs[1].evolve->result.history = {{1, 0.1, 1e-7, 1.5, 0, 0.25}};
  report.runs[1].evolve->result.history[0].level = {123, 0.75, 0.5, 0.0625};
  EXPECT_EQ(history_csv(report),
            "method,sweep,seconds,e_max,e_avg,energy,moved,level_vertices,merit_before,merit,"
            "level_strain\n"
            "controllable,1,0.125,0.5,0.25,2,7,,,,\n"
            "classical,1,0.25,0.1,1e-07,1.5,0,123,0.75,0.5,0.0625\n");
}

}  // namespace
}  // namespace planish
