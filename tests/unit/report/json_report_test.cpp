#include <limits>
#include <string>
#include <vector>

#include <planish/core/version.h>
#include <planish/core/ways_on.h>
#include <planish/report/json_report.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/sample_report.h"

namespace planish {
namespace {

using testing::ElementsAre;
using Json = nlohmann::ordered_json;

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items())
    keys.push_back(key);
  return keys;
}

TEST(JsonReport, OfAMeasuredPatchHasTheKeysOfTheContract) {
  MeasuredPatch patch = samples::measured(1.0);
  patch.flattenable = true;
  patch.inspection.problems = {{ErrorCode::zero_area, "triangle 7 has no area", 3, 7}};
  const Json json = Json::parse(json_report(patch));
  EXPECT_THAT(keys_of(json),
              ElementsAre("schema", "vertices", "triangles", "inner_vertices", "components",
                          "boundary_loops", "euler_characteristic", "e_max", "e_avg", "energy",
                          "sum_abs_defect", "hole_turning", "hole_gap", "min_angle", "roughness",
                          "flattenable", "extent", "area", "border_length", "bending",
                          "mean_curvature", "ruling_defect", "self_intersections", "obstruction",
                          "problems", "strain", "limits", "cautions"));
  EXPECT_EQ(json["strain"], Json(nullptr));
  EXPECT_EQ(json["limits"], Json::array());
  EXPECT_EQ(json["vertices"], 651);
  EXPECT_EQ(json["triangles"], 1200);
  EXPECT_EQ(json["inner_vertices"], 549);
  EXPECT_EQ(json["components"], 1);
  EXPECT_EQ(json["boundary_loops"], 1);
  EXPECT_EQ(json["euler_characteristic"], 1);
  EXPECT_EQ(json["e_max"], 0.0641);
  EXPECT_EQ(json["e_avg"], 0.00312);
  EXPECT_EQ(json["energy"], 0.137);
  EXPECT_EQ(json["sum_abs_defect"], 1.713);
  EXPECT_EQ(json["min_angle"], 0.3011);
  EXPECT_EQ(json["roughness"], 2.471);
  EXPECT_EQ(json["flattenable"], true);
  EXPECT_EQ(json["bending"], 41.7);
  EXPECT_EQ(json["mean_curvature"], 3.17);
  EXPECT_EQ(json["ruling_defect"], 0.203);
  EXPECT_EQ(json["self_intersections"], 0);
  ASSERT_EQ(json["problems"].size(), 1U);
  EXPECT_EQ(json["problems"][0], Json({{"code", "zero_area"},
                                       {"message", "triangle 7 has no area"},
                                       {"count", 3},
                                       {"first", 7}}));
}

TEST(JsonReport, OfAMeasuredPatchHasItsStrainAsDesigned) {
  StrainAsDesigned strain = {{0.4, 0.03, 0.1}, 0.07, {{Criterion::p99_strain, 0.05, 0.06}}};
  Json json = Json::parse(json_report(samples::measured(1.0), strain));
  EXPECT_EQ(json["strain"], Json({{"max", 0.4},
                                  {"rms", 0.03},
                                  {"p99", 0.1},
                                  {"stretch", {{"max", 0.0}, {"p99", 0.0}}},
                                  {"compression", {{"max", 0.0}, {"p99", 0.0}}},
                                  {"smallest_limit", 0.07}}));
  EXPECT_EQ(json["limits"][0]["kind"], "p99");
  EXPECT_EQ(json["limits"][0]["kept"], false);
  strain.smallest_limit.reset();
  json = Json::parse(json_report(samples::measured(1.0), strain));
  EXPECT_EQ(json["strain"]["smallest_limit"], Json(nullptr));
}

TEST(JsonReport, HasWhatTheBorderForbidsOrNull) {
  MeasuredPatch patch = samples::measured(1.0);
  EXPECT_EQ(Json::parse(json_report(patch))["obstruction"], Json(nullptr));
  patch.obstruction = Obstruction{100.0, 31.0, 76.5, 23.5, 0.235, 4.1, 2.2, 7.5, 60, 2};
  const Json json = Json::parse(json_report(patch))["obstruction"];
  EXPECT_EQ(json, Json({{"blocked", true},
                        {"area", 100.0},
                        {"border_length", 31.0},
                        {"area_limit", 76.5},
                        {"area_excess", 23.5},
                        {"excess_share", 0.235},
                        {"flat_border", false},
                        {"total_defect", 4.1},
                        {"border_turning", 2.2},
                        {"turning_needed", k_flat_turning},
                        {"turning_most", 7.5},
                        {"border_vertices", 60},
                        {"fixed_angles", 2}}));
}

TEST(JsonReport, OfAPatchWithoutProblemsHasAnEmptyList) {
  EXPECT_EQ(Json::parse(json_report(samples::measured(1.0)))["problems"], Json::array());
}

TEST(JsonReport, HasWhatTheMeshCannotShow) {
  const std::vector<Caution> cautions = {HiddenCurvature{0.25}, CoarseCoordinates{0.03, 0.08},
                                         ScanNoise{0.2, 12.0}};
  FlattenReport report = samples::flatten_report();
  report.unfold.unit = Unit::m;
  EXPECT_EQ(Json::parse(json_report(report, {}))["cautions"], Json::array());
  report.cautions = cautions;
  const Json expected = {{{"code", "hidden_curvature"},
                          {"message", caution_text(cautions[0], Unit::m)},
                          {"inner_share", 0.25}},
                         {{"code", "coarse_coordinates"},
                          {"message", caution_text(cautions[1], Unit::m)},
                          {"step", 0.03},
                          {"mean_edge", 0.08}},
                         {{"code", "scan_noise"},
                          {"message", caution_text(cautions[2], Unit::m)},
                          {"amplitude", 0.2},
                          {"wave", 12.0}}};
  EXPECT_EQ(Json::parse(json_report(report, {}))["cautions"], expected);
  EXPECT_EQ(Json::parse(json_report(report.unfold, cautions))["cautions"], expected);
  EXPECT_EQ(Json::parse(json_report(samples::measured(1.0), {}, cautions, Unit::m))["cautions"],
            expected);
}

TEST(JsonReport, TellsOfABorderOnlyWhereItMoved) {
  EvolveReport report = samples::flatten_report().evolve;
  EXPECT_FALSE(Json::parse(json_report(report)).contains("border"));
  report.border = BoundaryChange{1.5, 100.0, 101.0};
  report.method = Auto{.border = {BorderFreedom::Rule::within, 1.5}};
  const Json json = Json::parse(json_report(report));
  EXPECT_EQ(json["border"],
            Json({{"max", 1.5}, {"length_before", 100.0}, {"length_after", 101.0}}));
  EXPECT_EQ(json["options"]["border"], 1.5);
  report.method = Auto{.border = {BorderFreedom::Rule::slide}};
  EXPECT_EQ(Json::parse(json_report(report))["options"]["border"], "slide");
}

TEST(JsonReport, TellsOfSmoothingOnlyWhereItWasDone) {
  EvolveReport report = samples::flatten_report().evolve;
  EXPECT_FALSE(Json::parse(json_report(report)).contains("smoothed_first"));
  report.smoothed_first = SmoothingSummary{5.0, {0.25, 1.5, 0.0125}};
  EXPECT_EQ(Json::parse(json_report(report))["smoothed_first"],
            Json({{"length", 5.0},
                  {"moved", {{"rms", 0.25}, {"max", 1.5}, {"rms_over_diagonal", 0.0125}}}}));
}

TEST(JsonReport, OfAnEvolutionHasTheKeysOfTheContract) {
  const Json json = Json::parse(json_report(samples::flatten_report().evolve));
  EXPECT_THAT(
      keys_of(json),
      ElementsAre("schema", "method", "options", "sweeps", "stop", "threads", "seconds", "before",
                  "after", "deviation", "remeshed_from", "history", "bending_ratio",
                  "bending_added", "bending_lost", "normal_turn", "border_turn", "sharpest_fold",
                  "form_change", "smooth", "form_kept", "cautions"));
  EXPECT_EQ(json["method"], "controllable");
  EXPECT_EQ(json["sweeps"], 10);
  EXPECT_EQ(json["stop"], "sweep_limit");
  EXPECT_EQ(json["threads"], 2);
  EXPECT_EQ(json["seconds"], 0.25);
  EXPECT_EQ(json["before"]["e_max"], 0.0641);
  EXPECT_EQ(json["after"]["e_max"], 0.0641 * 0.73);
  EXPECT_EQ(json["deviation"],
            Json({{"rms", 0.1234}, {"max", 0.5678}, {"rms_over_diagonal", 0.00345}}));
  ASSERT_EQ(json["history"].size(), 10U);
  EXPECT_THAT(keys_of(json["history"][9]),
              ElementsAre("sweep", "e_max", "e_avg", "energy", "moved", "seconds"));
  EXPECT_EQ(json["history"][9]["sweep"], 10);
  EXPECT_EQ(json["history"][9]["moved"], 549);
}

TEST(JsonReport, TellsHowSmoothTheResultIs) {
  EvolveReport report = samples::flatten_report().evolve;
  const auto json = [&] { return Json::parse(json_report(report)); };
  EXPECT_EQ(json()["bending_ratio"], 1.13);
  EXPECT_EQ(json()["bending_added"], 0.31);
  EXPECT_EQ(json()["bending_lost"], 0.17);
  EXPECT_EQ(json()["normal_turn"], 3.4);
  EXPECT_EQ(json()["border_turn"], 5.6);
  EXPECT_EQ(json()["after"]["sharp_share"], 0.0125);
  EXPECT_FALSE(json()["before"].contains("sharp_share"));
  EXPECT_EQ(json()["sharpest_fold"],
            Json({{"degrees", 9.5}, {"edge", {40, 41}}, {"at", {9.5, 1.0, 0.25}}}));
  EXPECT_EQ(json()["smooth"], true);
  EXPECT_EQ(json()["form_kept"], true);
  EXPECT_EQ(json()["form_change"], Json({{"ripple", 0.4},
                                         {"fold", 0.7},
                                         {"fold_at", {9.5, 1.0, 0.25}},
                                         {"dent", 0.01},
                                         {"dent_at", {4.5, 3.0, 0.5}},
                                         {"uneven_turn", 1.5},
                                         {"relief_lost", 0.125},
                                         {"edge_lost", 0.0625}}));
  report.fairness.form_change->relief_lost = 0.29;
  EXPECT_EQ(json()["form_kept"], false);
  report.fairness = {};
  report.after.self_intersections.complete = false;
  for (const char* key : {"bending_ratio", "bending_added", "bending_lost", "normal_turn",
                          "border_turn", "sharpest_fold", "form_change"})
    EXPECT_TRUE(json()[key].is_null()) << key;
  EXPECT_TRUE(json()["after"]["self_intersections"].is_null());
  EXPECT_EQ(json()["smooth"], false);
}

TEST(JsonReport, StatesTheOptionsOfTheMethodAsDescribed) {
  EvolveReport report = samples::flatten_report().evolve;
  report.method = ClassicalLaplacian{.lambda = 0.25, .order = SweepOrder::simultaneous};
  EXPECT_EQ(Json::parse(json_report(report))["options"],
            Json({{"lambda", 0.25}, {"order", "simultaneous"}, {"max_deviation", nullptr}}))
      << "infinite is null";
  report.method = ControllableLaplacian{.max_deviation = 1.5};
  EXPECT_EQ(Json::parse(json_report(report))["options"]["max_deviation"], 1.5);
}

TEST(JsonReport, OfAnUnfoldingHasTheKeysOfTheContract) {
  UnfoldReport report = samples::flatten_report().unfold;
  report.unit = Unit::cm;
  report.pattern.overlaps = true;
  report.pattern.flipped_triangles = 2;
  report.border_strain = 0.25;
  report.turned = true;
  const Json json = Json::parse(json_report(report));
  EXPECT_EQ(json, Json({{"schema", 2},
                        {"strain",
                         {{"max", 0.3187},
                          {"rms", 0.0761},
                          {"p99", 0.2143},
                          {"stretch", {{"max", 0.3187}, {"p99", 0.2143}}},
                          {"compression", {{"max", 0.25}, {"p99", 0.1875}}}}},
                        {"area_ratio", 1.0021},
                        {"flipped_triangles", 2},
                        {"overlaps", true},
                        {"overlap", nullptr},
                        {"opened", nullptr},
                        {"holes", nullptr},
                        {"width", 30.0},
                        {"height", 20.0},
                        {"unit", "cm"},
                        {"side", "outer"},
                        {"turned", true},
                        {"iterations", 7},
                        {"converged", true},
                        {"border_strain", 0.25},
                        {"match_seams", false},
                        {"unmatched_strain", nullptr},
                        {"unlimited_strain", nullptr},
                        {"limits", Json::array()},
                        {"limits_met", true},
                        {"usable", false},
                        {"missed", {"overlap", "flipped_triangles"}},
                        {"cautions", Json::array()}}));
  report.unmatched_strain = EdgeStrain{.max = 0.5, .rms = 0.125, .p99 = 0.375};
  const Json matched = Json::parse(json_report(report));
  EXPECT_EQ(matched["match_seams"], true);
  report.overlap = Overlap{{1.0, 2.0}, {3.0, 4.0}, 5};
  report.pattern.opened = OpenedCrossings{2, 0.0625, 7};
  const Json crossing = Json::parse(json_report(report));
  EXPECT_EQ(crossing["overlap"],
            Json({{"low", {1.0, 2.0}}, {"high", {3.0, 4.0}}, {"crossings", 5}}));
  EXPECT_EQ(crossing["opened"], Json({{"crossings", 2}, {"largest_move", 0.0625}, {"vertex", 7}}));
  EXPECT_EQ(matched["unmatched_strain"], Json({{"max", 0.5},
                                               {"rms", 0.125},
                                               {"p99", 0.375},
                                               {"stretch", {{"max", 0.0}, {"p99", 0.0}}},
                                               {"compression", {{"max", 0.0}, {"p99", 0.0}}}}));
}

TEST(JsonReport, OfAPatternSaysWhatItMisses) {
  UnfoldReport report = samples::flatten_report().unfold;
  report.limits = {{Criterion::rms_strain, 0.02, 0.05}};
  report.pattern.overlaps = true;
  const Json json = Json::parse(json_report(report));
  EXPECT_EQ(json["limits_met"], false);
  EXPECT_EQ(json["usable"], false);
  EXPECT_EQ(json["missed"], Json::array({"rms_strain", "overlap"}));
}

TEST(JsonReport, OfTheMainJobHasItsPartsAndFiles) {
  const FlattenReport report = samples::flatten_report();
  const Json json = Json::parse(json_report(report, {{"pattern", "out/pattern.svg"}}));
  EXPECT_THAT(keys_of(json),
              ElementsAre("schema", "name", "version", "evolve", "unfold", "unfold_before",
                          "as_designed", "limits", "candidates", "ways", "cautions", "files",
                          "limits_met", "usable", "missed"));
  EXPECT_EQ(json["name"], "front panel");
  EXPECT_EQ(json["version"], k_version);
  EXPECT_EQ(json["evolve"], samples::part_of(json_report(report.evolve)));
  EXPECT_EQ(json["unfold"], samples::part_of(json_report(report.unfold)));
  EXPECT_EQ(json["unfold_before"], samples::part_of(json_report(report.design_least_stretch)));
  EXPECT_EQ(json["limits"], Json::array()) << "none was asked for";
  EXPECT_EQ(json["files"], Json({{"pattern", "out/pattern.svg"}}));
  EXPECT_EQ(Json::parse(json_report(report, {}))["files"], Json::object());
}

TEST(JsonReport, TellsOfEveryLimitWhetherThePatternKeepsItAndWhereItDoesSoLeast) {
  FlattenReport report = samples::flatten_report();
  report.unfold.limits = {
      {Criterion::p99_strain, 0.02, 0.05, false, 0.125, {3, 4}, {1.5, 2.0, 4.0}},
      {Criterion::rms_strain, 0.02, 0.0125, true, 0.125, {3, 4}, {1.5, 2.0, 4.0}}};
  report.unfold.unlimited_strain = EdgeStrain{.max = 0.5, .rms = 0.01, .p99 = 0.375};
  const Json where = {{"edge", {3, 4}}, {"at", {1.5, 2.0, 4.0}}};
  const Json expected = {{{"kind", "p99"},
                          {"asked", 0.02},
                          {"kept", false},
                          {"reached", 0.05},
                          {"share_beyond", 0.125},
                          {"where", where}},
                         {{"kind", "rms"},
                          {"asked", 0.02},
                          {"kept", true},
                          {"reached", 0.0125},
                          {"share_beyond", 0.125},
                          {"where", where}}};
  const Json json = Json::parse(json_report(report, {}));
  EXPECT_EQ(json["limits"], expected);
  EXPECT_EQ(json["unfold"]["limits"], expected);
  EXPECT_EQ(json["unfold"]["unlimited_strain"],
            Json({{"max", 0.5},
                  {"rms", 0.01},
                  {"p99", 0.375},
                  {"stretch", {{"max", 0.0}, {"p99", 0.0}}},
                  {"compression", {{"max", 0.0}, {"p99", 0.0}}}}));
}

TEST(JsonReport, OfASweepOnALevelHasTheLevel) {
  EvolveReport report = samples::flatten_report().evolve;
  report.result.history.front().level = {123, 0.5, 0.25, 0.0625};
  const Json history = Json::parse(json_report(report))["history"];
  EXPECT_EQ(
      history[0]["level"],
      Json({{"inner_vertices", 123}, {"merit_before", 0.5}, {"merit", 0.25}, {"strain", 0.0625}}));
  EXPECT_FALSE(history[1].contains("level"));
}

TEST(JsonReport, OfAnErrorHasOnlyTheKeysThatAreKnown) {
  const auto advised = [](const std::string& message, ErrorCode code) {
    return message + ". " + std::string(way_on(code));
  };
  const Json bare = Json::parse(json_report(Error(ErrorCode::unfold_failed, "no way")));
  EXPECT_EQ(bare, Json({{"schema", 2},
                        {"error",
                         {{"code", "unfold_failed"},
                          {"message", advised("no way", ErrorCode::unfold_failed)}}}}));
  SourceLocation place;
  place.path = "a.obj";
  place.line = 12;
  place.byte = 34;
  place.first = 5;
  place.count = 6;
  const Json full = Json::parse(json_report(Error(ErrorCode::bad_number, "'x'", place)));
  EXPECT_EQ(full["error"], Json({{"code", "bad_number"},
                                 {"message", advised("'x'", ErrorCode::bad_number)},
                                 {"path", "a.obj"},
                                 {"line", 12},
                                 {"byte", 34},
                                 {"first", 5},
                                 {"count", 6}}));
}

TEST(JsonReport, KeepsEveryBitOfANumberAndWritesNullForWhatIsNone) {
  MeasuredPatch patch = samples::measured(1.0);
  patch.figures.e_max = 0.1 + 0.2;
  patch.figures.e_avg = 5e-324;
  patch.figures.energy = std::numeric_limits<double>::infinity();
  patch.figures.roughness = std::numeric_limits<double>::quiet_NaN();
  const Json json = Json::parse(json_report(patch));
  EXPECT_EQ(json["e_max"].get<double>(), 0.1 + 0.2);
  EXPECT_EQ(json["e_avg"].get<double>(), 5e-324);
  EXPECT_TRUE(json["energy"].is_null());
  EXPECT_TRUE(json["roughness"].is_null());
}

TEST(JsonReport, ReplacesWhatIsNoUtf8) {
  FlattenReport report = samples::flatten_report();
  report.name = "a\xFFz\"\n";
  const Json json = Json::parse(json_report(report, {{"p\xFE", "q\xC3"}}));
  EXPECT_EQ(json["name"], "a\uFFFDz\"\n");
  EXPECT_EQ(json["files"], Json({{"p\uFFFD", "q\uFFFD"}}));
}

const std::string k_history_head =
    "sweep,e_max,e_avg,energy,moved,seconds,level_vertices,merit_before,merit,level_strain\n";

TEST(HistoryCsv, HasAHeaderAndALineASweep) {
  EXPECT_EQ(history_csv(std::vector<SweepRecord>{{1, 0.5, 0.25, 2.0, 7, 0.125},
                                                 {2, 0.1, 1e-7, 1.5, 0, 0.25}}),
            k_history_head +
                "1,0.5,0.25,2,7,0.125,,,,\n"
                "2,0.1,1e-07,1.5,0,0.25,,,,\n");
  EXPECT_EQ(history_csv(std::vector<SweepRecord>{}), k_history_head);
}

TEST(HistoryCsv, TellsOfTheLevelOfASweep) {
  SweepRecord record = {1, 0.5, 0.25, 2.0, 7, 0.125};
  record.level = {123, 0.75, 0.5, 0.0625};
  EXPECT_EQ(history_csv(std::vector<SweepRecord>{record}),
            k_history_head + "1,0.5,0.25,2,7,0.125,123,0.75,0.5,0.0625\n");
}

}  // namespace
}  // namespace planish
