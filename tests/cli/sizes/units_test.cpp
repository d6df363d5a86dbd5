// The unit of length that a comment of a mesh file states.

#include <fstream>

#include <gmock/gmock.h>

#include "cli/cli_run.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

class StatedUnits : public CliTest {
 protected:
  /// The panel under another name, with a comment before it.
  static void write(const std::string& name, const std::string& comment) {
    std::ofstream(name) << comment << format_mesh(make_shape("panel", 300), mesh_format_of(name));
  }

  static nlohmann::json json_of(const std::vector<std::string>& args) {
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    return result.json();
  }
};

TEST_F(StatedUnits, AreTakenAsTheFlagWouldBe) {
  write("inches.obj", "# File units = inches\n");
  for (const std::vector<std::string>& verb : std::vector<std::vector<std::string>>{
           {"measure"},
           {"unfold", "-o", "pattern.svg", "--allowance", "10mm"},
           {"evolve", "-o", "evolved.obj", "--max-deviation", "2mm", "--sweeps", "2"},
           {"suggest-cuts", "--max-strain", "50%"}}) {
    std::vector<std::string> with_flag = verb, without = verb;
    with_flag.insert(with_flag.begin() + 1, "panel.obj");
    with_flag.insert(with_flag.end(), {"--unit", "in", "--json"});
    without.insert(without.begin() + 1, "inches.obj");
    without.emplace_back("--json");
    nlohmann::json asked = json_of(with_flag), stated = json_of(without);
    for (nlohmann::json* json : {&asked, &stated}) {
      json->erase("seconds");
      json->erase("history");
    }
    EXPECT_EQ(asked, stated) << verb.front();
  }
}

TEST_F(StatedUnits, AreSaidInANote) {
  write("inches.obj", "# File units = inches\n");
  const CliResult result = planish({"unfold", "inches.obj", "-o", "pattern.svg"});
  EXPECT_THAT(result.err, HasSubstr("inches.obj: the file says \"File units = inches\": taken as "
                                    "with --unit in"));
  EXPECT_THAT(result.out, HasSubstr(" in, "));
  EXPECT_THAT(planish({"convert", "inches.obj", "b.stl"}).err,
              HasSubstr("meshes that are written do not say it, so give --unit in with them"));
}

// The file that is written states none: it is no input of the second run.
TEST_F(StatedUnits, AreTheSameWhereAFileIsConvertedTwice) {
  write("inches.obj", "# File units = inches\n");
  ASSERT_EQ(planish({"convert", "inches.obj", "b.obj"}).exit_code, k_exit_done);
  const std::string once = content_of("b.obj");
  ASSERT_EQ(planish({"convert", "inches.obj", "b.obj"}).exit_code, k_exit_done);
  EXPECT_EQ(content_of("b.obj"), once);
}

TEST_F(StatedUnits, GiveWayToTheFlagAndSayThatTheyDisagree) {
  write("inches.obj", "# File units = inches\n");
  const CliResult result = planish({"measure", "inches.obj", "--unit", "cm"});
  EXPECT_THAT(
      result.err,
      HasSubstr("the file says \"File units = inches\", but --unit says cm, which is taken"));
  EXPECT_EQ(planish({"measure", "inches.obj", "--unit", "cm"}).out,
            planish({"measure", "inches.obj", "--unit", "cm", "--quiet"}).out);
  EXPECT_THAT(planish({"measure", "inches.obj", "--unit", "in"}).err, Not(HasSubstr("says")));
}

TEST_F(StatedUnits, OfSeveralFilesThatDisagreeAreScaledToMillimetres) {
  write("inches.obj", "# File units = inches\n");
  const CliResult result =
      planish({"unfold", "panel.obj", "inches.obj", "-o", "patterns", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("scaled from in to mm, the unit of this run"));
  const nlohmann::json files = result.json()["files"];
  EXPECT_NEAR(files[1]["width"].get<double>() / files[0]["width"].get<double>(), 25.4, 1e-6);
}

TEST_F(StatedUnits, OfAPieceComeBehindTheProductFileAndTheFlag) {
  write("inches.obj", "# File units = inches\n");
  const auto width = [](const std::string& piece, std::vector<std::string> more) {
    std::ofstream("suit.json") << R"({"pieces": [{"file": "panel.obj"}, {"file": "inches.obj")"
                               << piece << "}]}";
    std::vector<std::string> args = {"flatten", "suit.json", "-o", "out", "--json"};
    args.insert(args.end(), more.begin(), more.end());
    const nlohmann::json patches = json_of(args)["patches"];
    return patches[1]["unfold"]["width"].get<double>() /
           patches[0]["unfold"]["width"].get<double>();
  };
  EXPECT_NEAR(width("", {}), 25.4, 1e-6);
  EXPECT_NEAR(width(R"(, "unit": "cm")", {}), 10.0, 1e-6);
  EXPECT_NEAR(width("", {"--unit", "cm"}), 1.0, 1e-9);
}

}  // namespace
}  // namespace planish::cli
