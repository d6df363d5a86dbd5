#include <planish/report/json_report.h>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "support/sample_report.h"

namespace planish {
namespace {

using Json = nlohmann::ordered_json;

ProductReport product() {
  ProductReport report;
  report.patches = {{"front", 10, 12, finished_patch(samples::flatten_report())},
                    {"back", 20, 22, {}, Failure{"zero_area", "none"}},
                    {"rest", 30, 32}};
  report.seams = {
      {{{SeamSide{0, {3, 4, 5}}, SeamSide{1, {7, 8, 9}}}}, {50.0, 50.0}, {49.0, std::nullopt}},
      {{{SeamSide{0, {3, 4}}, SeamSide{0, {8, 9}}}}, {40.0, 40.25}, {41.0, 39.0}}};
  report.seams[1].seam.matches = {{0.0, 0.0}, {1.0, 1.0}};
  report.seams[1].seam.sides[0].first_share = 0.25;
  report.near_borders = {{{0, 1}, 12.5}};
  return report;
}

TEST(JsonReport, OfAProductHasWhatReportsOfPatchesHave) {
  const FlattenReport front = samples::flatten_report();
  const WrittenFiles files = {{"flat", "out/front/flat.obj"}};
  const Json json =
      Json::parse(json_report(product(), "coat", {{"front", "back", "rest"}, {files, {}, {}}}));
  const Json of_front = Json::parse(json_report(front, files));
  EXPECT_EQ(json["name"], "coat");
  EXPECT_EQ(json["patches"][0]["unfold"], of_front["unfold"]);
  EXPECT_EQ(json["patches"][0]["stop"], of_front["evolve"]["stop"]);
  EXPECT_EQ(json["patches"][0]["deviation"], of_front["evolve"]["deviation"]);
  EXPECT_EQ(json["patches"][0]["files"], of_front["files"]);
  EXPECT_EQ(json["patches"][0]["error"], Json(nullptr));
  EXPECT_EQ(json["patches"][0]["vertices"], 10);
  EXPECT_FALSE(json["patches"][0]["met"]) << "it is stretched without a limit";
  for (const char* key : {"limits_met", "usable", "missed"})
    EXPECT_EQ(json["patches"][0][key], of_front[key]) << key;
  EXPECT_EQ(json["patches"][0]["missed"], Json::array({"stretched"}));
  EXPECT_TRUE(json["patches"][0]["limits_met"]);
  EXPECT_FALSE(json["patches"][0]["usable"]);
  EXPECT_EQ(json["near_borders"],
            Json::parse(R"([{"patches": ["front", "back"], "length": 12.5}])"));
  EXPECT_EQ(json["patches"][0]["rejected_strain"], Json(nullptr));
  EXPECT_EQ(json["patches"][1]["error"]["code"], "zero_area");
  EXPECT_FALSE(json["patches"][1]["met"]);
  EXPECT_EQ(json["patches"][1]["missed"], Json::array({"failure"}));
  EXPECT_EQ(json["patches"][1]["checks"],
            Json::parse(R"([{"what": "failure", "met": false, "text": "failed: none"}])"));
  for (const char* key : {"unfold", "stop", "deviation", "files"})
    EXPECT_EQ(json["patches"][1][key], Json(nullptr)) << key;
  EXPECT_EQ(json["patches"][2]["error"], Json(nullptr));
  EXPECT_EQ(json["seams"][0]["sides"][1]["patch"], "back");
  EXPECT_EQ(json["seams"][0]["difference"], Json(nullptr));
  EXPECT_EQ(json["seams"][1]["number"], 2);
  EXPECT_EQ(json["seams"][1]["difference_share"], 0.05);
  EXPECT_EQ(json["seams"][0]["longer"], Json(nullptr));
  EXPECT_EQ(json["seams"][1]["longer"], 1);
  EXPECT_EQ(json["seams"][1]["longer_on_model"], 2);
  EXPECT_EQ(json["seams"][1]["difference_on_model"], 0.25);
  EXPECT_EQ(json["seams"][1]["length_on_model"], 40.0);
  EXPECT_EQ(json["seams"][1]["sides"][1]["length_on_model"], 40.25);
  EXPECT_EQ(json["seams"][0]["matched"], "vertices");
  EXPECT_EQ(json["seams"][1]["matched"], "curve");
  EXPECT_EQ(json["seams"][1]["sides"][0]["first_share"], 0.25);
  EXPECT_EQ(json["seams"][1]["sides"][0]["last_share"], 1.0);
  EXPECT_EQ(json["nesting"], Json(nullptr));
}

TEST(JsonReport, OfAProductHasTheWordsOfAProductFile) {
  ProductReport report = product();
  report.patches[0].words = {"neoprene", 2};
  report.seams[1].name = "side";
  const Json json = Json::parse(json_report(report, "coat", {{"", "", ""}, {{}, {}, {}}}));
  EXPECT_EQ(json["patches"][0]["material"], "neoprene");
  EXPECT_EQ(json["patches"][0]["quantity"], 2);
  EXPECT_EQ(json["patches"][1]["material"], Json(nullptr));
  EXPECT_EQ(json["patches"][1]["quantity"], Json(nullptr));
  EXPECT_EQ(json["seams"][0]["name"], Json(nullptr));
  EXPECT_EQ(json["seams"][1]["name"], "side");
}

TEST(JsonReport, OfAProductSaysWhereTheDesignWasKept) {
  ProductReport report = product();
  report.patches[0].finished->rejected = EdgeStrain{.max = 0.5, .rms = 0.25};
  const Json patch =
      Json::parse(json_report(report, "coat", {{"", "", ""}, {{}, {}, {}}}))["patches"][0];
  EXPECT_FALSE(patch["met"]);
  EXPECT_EQ(patch["rejected_strain"]["rms"], 0.25);
  EXPECT_EQ(patch["checks"][0]["what"], "rejected");
}

TEST(JsonReport, OfALayoutSaysWhereThePiecesLieOrWhyNot) {
  const NestJob job{{{"front", {}, {{0, 0}}}, {"lost", {}, {}}}, Unit::mm, {.width = 700.0}};
  LayoutReport layout;
  layout.left_out = {"lost"};
  add_layout("felt", job, {{{0, 1, 0, 90.0, {3.0, 4.0}}}, 1, 500.0, 10.0, 40.0}, layout);
  const NestJob other{{{"lining", {}, {{0, 0}}}}, Unit::mm, {.width = 900.0}};
  add_layout("silk", other, {{{0, 0, 1, 0.0, {}}}, 2, 300.0, 20.0, 60.0}, layout);
  const auto nesting = [&] {
    return Json::parse(
        json_report(product(), "coat", {{"", "", ""}, {{}, {}, {}}}, layout))["nesting"];
  };
  EXPECT_EQ(nesting()["sheet_width"], 700.0);
  EXPECT_EQ(nesting()["left_out"], Json::array({"lost"}));
  EXPECT_EQ(nesting()["placements"][0]["patch"], "front");
  EXPECT_EQ(nesting()["placements"][0]["copy"], 2);
  EXPECT_EQ(nesting()["placements"][1]["patch"], "lining");
  EXPECT_EQ(nesting()["placements"][1]["sheet"], 3) << "behind the one of felt";
  EXPECT_EQ(nesting()["sheets"], 3);
  EXPECT_EQ(nesting()["used_share"], 0.3);
  EXPECT_EQ(nesting()["waste"], 0.7);
  EXPECT_EQ(nesting()["materials"][1]["material"], "silk");
  EXPECT_EQ(nesting()["materials"][1]["sheet_width"], 900.0);
  EXPECT_EQ(nesting()["materials"][1]["first_sheet"], 2);
  EXPECT_EQ(nesting()["materials"][0]["used_share"], 0.25);
  layout.failure = Failure{"piece_too_large", "large"};
  EXPECT_EQ(nesting()["error"]["message"], "large");
  EXPECT_FALSE(nesting().contains("placements"));
}

TEST(JsonReport, OfAProductSaysWhatWasCut) {
  const auto cut = [](const std::optional<MoreFigures>& figures) {
    return Json::parse(
        json_report(product(), "coat", {{"", "", ""}, {{}, {}, {}}}, {}, figures))["cut"];
  };
  EXPECT_EQ(cut({}), Json(nullptr));
  EXPECT_EQ(cut(MoreFigures{"cut", {{"edges", std::size_t{3}}, {"length", 2.0}}}),
            Json::parse(R"({"edges": 3, "length": 2.0})"));
}

TEST(JsonReport, HasFiguresOfAProgramsOwnAtItsEnd) {
  const std::vector<MoreFigures> more = {{"cut", {{"edges", std::size_t{3}}, {"length", 2.0}}}};
  const Json json = Json::parse(json_report(samples::flatten_report().unfold, {}, more));
  EXPECT_EQ(json.back(), Json::parse(R"({"edges": 3, "length": 2.0})"));
  EXPECT_EQ(json.items().begin().key(), "schema");
}

}  // namespace
}  // namespace planish
