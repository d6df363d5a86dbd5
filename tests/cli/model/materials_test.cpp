// Materials: the verb, files of one's own, and what they do as --material.

#include <fstream>

#include <planish/core/error.h>
#include <planish/measure/material.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "model/material_file.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

class Materials : public CliTest {
 protected:
  static void write(const std::string& content, const std::string& name = "my.json") {
    std::ofstream(name) << content;
  }

  /// Stretch and compression by their usual figures, and a largest one of stretch.
  static void write_suede(const std::string& stretch, const std::string& compression,
                          const std::string& largest) {
    const auto figure = [](const std::string& strain) {
      return R"({"strain": )" + strain + R"(, "source": "own test"})";
    };
    write(R"({"name": "suede", "use": "bags", "stretch": {"usual": )" + figure(stretch) +
          R"(, "largest": )" + figure(largest) + R"(}, "compression": {"usual": )" +
          figure(compression) + "}}");
  }

  static std::vector<std::string> kinds_of(const nlohmann::json& limits) {
    std::vector<std::string> kinds;
    for (const auto& limit : limits)
      kinds.push_back(limit["kind"]);
    return kinds;
  }
};

TEST_F(Materials, AreListedWithWhatTheyTake) {
  const CliResult result = planish({"materials"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  for (const Material& material : materials())
    EXPECT_THAT(result.out, HasSubstr("\n" + material.name + " ")) << material.name;
  EXPECT_THAT(result.out, HasSubstr("\nneoprene        10 %          10 %          "));
  EXPECT_THAT(result.out, HasSubstr("\nleather-lasted  12 % (12 %)   1 %           "));
  EXPECT_EQ(planish({"materials", "--json"}).json()["materials"].size(), materials().size());
}

TEST_F(Materials, HaveTheSourceOfEachFigure) {
  const CliResult one = planish({"materials", "LEATHER-lasted"});
  ASSERT_EQ(one.exit_code, k_exit_done) << one.err;
  EXPECT_THAT(one.out, HasSubstr("stretch      12 % on 99 % of the area. Source: ISO 3379"));
  EXPECT_THAT(one.out, HasSubstr("\n             12 % at most. Source: the same\n"));
  EXPECT_THAT(one.out, HasSubstr("compression  1 % on 99 % of the area. Source: as leather"));
  const CliResult unknown = planish({"materials", "lether"});
  EXPECT_EQ(unknown.exit_code, k_exit_usage);
  EXPECT_THAT(unknown.err, HasSubstr("did you mean leather?"));
}

TEST_F(Materials, AreFilesInJson) {
  const nlohmann::json listed = planish({"materials", "--json"}).json();
  for (const nlohmann::json& known : listed.at("materials")) {
    nlohmann::json material = known;
    material["name"] = "mine";
    write(material.dump());
    nlohmann::json read = planish({"materials", "my.json", "--json"}).json()["materials"][0];
    EXPECT_EQ(read["name"], "mine");
    read["name"] = known["name"];
    EXPECT_EQ(read, known);
  }
}

TEST_F(Materials, OfOnesOwnSayWhatTheFileSays) {
  write_suede("0.08", "\"1.5 %\"", "0.15");
  const Material suede = read_material_file("my.json");
  EXPECT_EQ(suede.name, "suede");
  EXPECT_EQ(suede.use, "bags");
  EXPECT_EQ(suede.stretch.usual.strain, 0.08);
  EXPECT_EQ(suede.stretch.largest->strain, 0.15);
  EXPECT_EQ(suede.compression.usual.strain, 0.015);
  EXPECT_FALSE(suede.compression.largest);
  EXPECT_THAT(planish({"materials", "my.json"}).out, HasSubstr("suede: bags"));
}

TEST_F(Materials, ThatAreWrongAreRefusedWithPlaceAndKey) {
  struct Case {
    const char *content, *message;
  };
  const std::string figure = R"({"strain": 0.1, "source": "x"})";
  const std::string usual = R"({"usual": )" + figure + "}";
  const auto with = [&](const std::string& stretch) {
    return R"({"name": "a", "stretch": )" + stretch + R"(, "compression": )" + usual + "}";
  };
  const auto with_figure = [&](const std::string& text) {
    return with(R"({"usual": )" + text + "}");
  };
  const auto with_strain = [&](const std::string& strain) {
    return with_figure(R"({"source": "x", "strain": )" + strain + "}");
  };
  const auto refusal = [&](const std::string& content) {
    write(content);
    const CliResult result = planish({"materials", "my.json"});
    EXPECT_EQ(result.exit_code, k_exit_failed) << content;
    EXPECT_THAT(result.err, HasSubstr("my.json:")) << content;
    std::string text = result.err;
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
  };
  EXPECT_THAT(refusal("{\n  \"name\": \"a\",\n  oops\n}"), HasSubstr("my.json:3: is no JSON"));
  EXPECT_THAT(refusal(""), HasSubstr("my.json:1: is no JSON, from column 1 on"));
  EXPECT_THAT(refusal(std::string(100, '[') + std::string(100, ']')), HasSubstr("nested too deep"));
  EXPECT_THAT(refusal("[]"), HasSubstr("must be an object"));
  EXPECT_THAT(refusal("{}"), HasSubstr("needs \"name\""));
  EXPECT_THAT(refusal(R"({"name": "a", "strech": {}})"),
              HasSubstr("unknown key \"strech\"; did you mean stretch?; known are name, use, "
                        "stretch or compression"));
  EXPECT_THAT(refusal(R"({"name": 3})"), HasSubstr("name: must be a text in quotes"));
  EXPECT_THAT(refusal(R"({"name": "a\nb"})"), HasSubstr("name: must be one line"));
  EXPECT_THAT(refusal(R"({"name": ")" + std::string(61, 'a') + "\"}"),
              HasSubstr("name: must have at most 60 bytes"));
  EXPECT_THAT(refusal(R"({"name": "cotton"})"), HasSubstr("give yours another name"));
  EXPECT_THAT(refusal(R"({"name": "a"})"), HasSubstr("needs \"stretch\""));
  EXPECT_THAT(refusal(R"({"name": "a", "stretch": )" + usual + "}"),
              HasSubstr("needs \"compression\""));
  EXPECT_THAT(refusal(with("0.1")), HasSubstr("stretch: must be an object"));
  EXPECT_THAT(refusal(with("{}")), HasSubstr("stretch: needs \"usual\""));
  EXPECT_THAT(refusal(with_figure("{}")), HasSubstr("stretch.usual: needs \"strain\""));
  EXPECT_THAT(refusal(with_figure(R"({"strain": 0.1})")),
              HasSubstr("stretch.usual: needs \"source\""));
  EXPECT_THAT(refusal(with_strain("true")), HasSubstr("stretch.usual.strain: must be a share"));
  for (const char* strain : {"0", "-0.1", "12", "1.01", "\"\"", "\"12\"", "\"x %\"", "\"0 %\"",
                             "\"101 %\"", "\"1 2%\"", "\"nan%\""}) {
    EXPECT_THAT(
        refusal(with_strain(strain)),
        HasSubstr("stretch.usual.strain: is " + std::string(strain) + " but must be a share"))
        << strain;
  }
  EXPECT_THAT(
      refusal(with(R"({"usual": )" + figure + R"(, "largest": {"strain": 0.05, "source": "x"}})")),
      HasSubstr("stretch.largest.strain: must be at least that of \"usual\""));
  const CliResult missing = planish({"materials", "none.json"});
  EXPECT_EQ(missing.exit_code, k_exit_failed);
  EXPECT_THAT(missing.err, HasSubstr("none.json: "));
}

TEST_F(Materials, OfAFileAreLimitsOfStretchAndCompression) {
  write_suede("0.3", "0.2", "0.4");
  const Names args = {"flatten", "panel.obj", "--material", "my.json"};
  const CliResult result = planish(args);
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Within what suede takes"));
  EXPECT_THAT(content_of("panel-pattern/report.html"),
              HasSubstr("The limit of 20 % for the compression on 99 % of the area is kept"));
  Names with_json = args;
  with_json.push_back("--json");
  const auto json = planish(with_json).json();
  EXPECT_THAT(kinds_of(json["limits"]),
              ElementsAre("max_stretch", "p99_stretch", "p99_compression"));
  EXPECT_EQ(json["limits"][1]["asked"], 0.3);
  EXPECT_EQ(json["limits"][2]["asked"], 0.2);
  EXPECT_EQ(json["limits"][1]["reached"], json["unfold"]["strain"]["stretch"]["p99"]);
  EXPECT_EQ(json["limits"][2]["reached"], json["unfold"]["strain"]["compression"]["p99"]);
}

TEST_F(Materials, ThatGiveOneWayMakeThePatternSmaller) {
  const auto area_within = [](const std::string& stretch, const std::string& compression) {
    write_suede(stretch, compression, "0.9");
    const CliResult result =
        planish({"unfold", "panel.obj", "-o", "out.svg", "--material", "my.json", "--json"});
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    return result.json()["area_ratio"].get<double>();
  };
  EXPECT_LT(area_within("0.2", "0.005"), area_within("0.005", "0.2"));
}

TEST_F(Materials, ThatMissALimitSayWhichWay) {
  write_suede("\"0.001 %\"", "\"0.001 %\"", "\"0.002 %\"");
  const CliResult result =
      planish({"unfold", "panel.obj", "-o", "out.svg", "--material", "my.json"});
  EXPECT_EQ(result.exit_code, k_exit_target_missed);
  EXPECT_THAT(result.err, HasSubstr("for the stretch of every edge is not kept"));
}

TEST_F(Materials, AreTakenByAllVerbsThatHaveTheFlag) {
  write_suede("0.3", "0.2", "0.4");
  EXPECT_EQ(
      planish({"measure", "panel.obj", "--material", "my.json", "--json"}).json()["limits"].size(),
      3U);
  const auto cuts =
      planish({"suggest-cuts", "panel.obj", "--material", "my.json", "--json"}).json();
  EXPECT_THAT(kinds_of(cuts["limits"]),
              ElementsAre("max_stretch", "p99_stretch", "p99_compression"));
  EXPECT_TRUE(cuts["max_strain"].is_null()) << "there is none for both";
  EXPECT_EQ(cuts["met"], true);
  const auto evolve = planish({"evolve", "panel.obj", "-o", "out.obj", "--method", "auto",
                               "--material", "my.json", "--sweeps", "0", "--json"})
                          .json();
  EXPECT_EQ(evolve["options"]["max_strain"], 0.25) << "as much as both ask for";
  const CliResult frontier = planish({"frontier", "panel.obj", "--material", "my.json"});
  EXPECT_EQ(frontier.exit_code, k_exit_usage);
  EXPECT_THAT(frontier.err, HasSubstr("give --max-strain"));
}

TEST_F(Materials, ThatChangeAreNoReasonToKeepOldResults) {
  write_suede("0.3", "0.2", "0.4");
  std::ofstream("suit.json")
      << R"({"pieces": [{"file": "panel.obj", "material": "my.json"}, {"file": "panel.obj"}]})";
  const auto flatten = [](const Names& more = {}) {
    Names args = {"flatten", "suit.json", "-o", "out", "--formats", "svg", "--pick", "1"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  };
  flatten();
  const auto asked = [] {
    const auto json = nlohmann::json::parse(content_of("out/garment.json"));
    return json["patches"][0]["unfold"]["limits"][1]["asked"].get<double>();
  };
  EXPECT_EQ(asked(), 0.3);
  write_suede("0.35", "0.2", "0.4");
  flatten({"--resume"});
  EXPECT_EQ(asked(), 0.35);
}

}  // namespace
}  // namespace planish::cli
