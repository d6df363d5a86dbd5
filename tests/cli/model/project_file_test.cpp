#include "model/project_file.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "commands/commands.h"
#include "model/sha256.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The panel with a line from border to border, as the app saves it.
class ProjectFileTest : public CliTest {
 protected:
  nlohmann::json project_ = {{"kind", "planish project"},
                             {"version", 1},
                             {"model", "panel.obj"},
                             {"hash", ""},
                             {"unit", "mm"},
                             {"lines", nlohmann::json::array()},
                             {"names", nlohmann::json::object()},
                             {"without", nlohmann::json::array()},
                             {"material", ""},
                             {"strain", ""},
                             {"allowance", "10mm"},
                             {"paper", ""}};
  std::vector<std::string> ends_;

  void SetUp() override {
    CliTest::SetUp();
    // Half way up at the left and at the right.
    const auto positions = make_shape("panel", 300).positions;
    const auto out = [](Vec3 p, double way) { return way * p.x - std::abs(p.y - 280.0); };
    const auto end = [&](double way) {
      return *std::max_element(positions.begin(), positions.end(),
                               [&](Vec3 a, Vec3 b) { return out(a, way) < out(b, way); });
    };
    nlohmann::json points = nlohmann::json::array();
    for (const Vec3 p : {end(-1.0), end(1.0)}) {
      points.push_back({p.x, p.y, p.z});
      ends_.push_back(points.back()[0].dump() + "," + points.back()[1].dump() + "," +
                      points.back()[2].dump());
    }
    project_["lines"] = {{{"kind", "shortest"}, {"points", points}}};
    project_["hash"] = sha256(bytes_of("panel.obj"));
  }

  std::string line() const { return "line " + ends_[0] + " " + ends_[1]; }
  void save() const { std::ofstream("panel.json") << project_.dump(); }
  std::string refusal() const {
    save();
    const CliResult run = planish({"flatten", "panel.json", "-o", "out"});
    EXPECT_NE(run.exit_code, 0);
    EXPECT_THAT(run.err, HasSubstr("panel.json"));
    EXPECT_FALSE(std::filesystem::exists("out"));
    return run.err;
  }
  /// But for reports, which have seconds in them.
  static void expect_same_patterns(const std::string& a, const std::string& b) {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(a)) {
      const std::string kind = entry.path().extension().string();
      if (!entry.is_regular_file() || kind == ".json" || kind == ".html") continue;
      ++count;
      const std::string path = entry.path().lexically_relative(a).string();
      EXPECT_EQ(bytes_of(a + "/" + path), bytes_of(b + "/" + path)) << path;
    }
    EXPECT_GT(count, 5U);
  }
};

TEST_F(ProjectFileTest, GivesTheFilesOfTheSameFlags) {
  project_["names"] = {{"panel-1", "left"}};
  save();
  const CliResult run = planish({"flatten", "panel.json", "-o", "a"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(std::filesystem::exists("a/left"));
  const CliResult other = planish({"flatten", "panel.obj", "--unit", "mm", "--cut", line(),
                                   "--rename", "panel-1=left", "--allowance", "10mm", "-o", "b"});
  ASSERT_EQ(other.exit_code, 0) << other.err;
  expect_same_patterns("b", "a");
  EXPECT_TRUE(std::filesystem::exists("a/left/pattern.plt"));
  EXPECT_TRUE(std::filesystem::exists("a/left/textured.obj"));
}

TEST_F(ProjectFileTest, TakesDrawnLinesAsFromAFile) {
  project_["lines"][0]["kind"] = "drawn";
  save();
  ASSERT_EQ(planish({"flatten", "panel.json", "-o", "a"}).exit_code, 0);
  std::ofstream file("seams.obj");
  for (const std::string& end : ends_) {
    std::string place = end;
    std::replace(place.begin(), place.end(), ',', ' ');
    file << "v " << place << "\n";
  }
  file << "l 1 2\n";
  file.close();
  ASSERT_EQ(planish({"flatten", "panel.obj", "--unit", "mm", "--cut", "seams.obj", "--allowance",
                     "10mm", "-o", "b"})
                .exit_code,
            0);
  expect_same_patterns("b", "a");
}

TEST_F(ProjectFileTest, PutsNotchesOnBothSidesOfTheSeam) {
  const nlohmann::json ends = project_["lines"][0]["points"];
  save();
  ASSERT_EQ(planish({"flatten", "panel.json", "-o", "plain"}).exit_code, 0);
  project_["notches"] = nlohmann::json::array({ends[0]});
  save();
  const CliResult run = planish({"flatten", "panel.json", "-o", "notched"});
  ASSERT_EQ(run.exit_code, 0) << run.err;
  for (const char* piece : {"panel-1", "panel-2"}) {
    const std::string path = std::string("/") + piece + "/pattern.svg";
    EXPECT_GT(bytes_of("notched" + path).size(), bytes_of("plain" + path).size());
  }
  project_["notches"] = nlohmann::json::array({nlohmann::json::array({1e6, 0.0, 0.0})});
  save();
  const CliResult far = planish({"flatten", "panel.json", "-o", "far"});
  EXPECT_THAT(far.err, HasSubstr("notch 1 is on no seam"));
}

TEST_F(ProjectFileTest, MirrorsTheHalfWithTheLinesWhereThePlaneIsNamed) {
  const auto asked = [&](const char* plane) {
    project_["symmetric"] = plane;
    save();
    Arguments typed;
    typed.operands = {"panel.json"};
    for (const Command& command : commands()) {
      if (command.name == "flatten") return with_project(command, typed);
    }
    return typed;
  };
  EXPECT_FALSE(asked("auto").has("--mirror-surface"));
  EXPECT_EQ(asked("auto").text("--symmetric"), "auto");
  EXPECT_TRUE(asked("x=0.5").has("--mirror-surface"));
  EXPECT_EQ(asked("x=0.5").text("--symmetric"), "x=0.5");
}

TEST_F(ProjectFileTest, LetsFlagsThatWereTypedCountMore) {
  save();
  ASSERT_EQ(planish({"flatten", "panel.json", "--allowance", "20mm", "-o", "a"}).exit_code, 0);
  ASSERT_EQ(planish({"flatten", "panel.json", "-o", "b"}).exit_code, 0);
  EXPECT_NE(bytes_of("a/panel-1/pattern.svg"), bytes_of("b/panel-1/pattern.svg"));
}

TEST_F(ProjectFileTest, RefusesAnotherVersion) {
  project_["version"] = 2;
  project_["more"] = true;
  EXPECT_THAT(refusal(), HasSubstr("version: is 2; this program reads version 1"));
}

TEST_F(ProjectFileTest, RefusesAnotherModel) {
  write_mesh("panel.obj", make_shape("panel", 400));
  EXPECT_THAT(refusal(), HasSubstr("of another panel.obj"));
  std::filesystem::remove("panel.obj");
  EXPECT_THAT(refusal(), HasSubstr("has to lie beside it"));
}

TEST_F(ProjectFileTest, RefusesWhatIsNone) {
  const nlohmann::json good = project_;
  const auto with = [&](const char* key, nlohmann::json value) {
    project_ = good;
    project_[key] = std::move(value);
    return refusal();
  };
  EXPECT_THAT(with("model", "../panel.obj"), HasSubstr("a file beside the project"));
  EXPECT_THAT(with("model", "/etc/passwd"), HasSubstr("a file beside the project"));
  EXPECT_THAT(with("model", 5), HasSubstr("a text in quotes"));
  EXPECT_THAT(with("lines", {{{"kind", "wavy"}, {"points", {{0, 0, 0}, {1, 1, 1}}}}}),
              HasSubstr("lines[0].kind"));
  EXPECT_THAT(with("lines", {{{"kind", "shortest"}, {"points", {{0, 0, 0}}}}}),
              HasSubstr("2 points or more"));
  EXPECT_THAT(with("lines", {{{"kind", "shortest"}, {"points", {{0, 0, "x"}, {1, 1, 1}}}}}),
              HasSubstr("three numbers"));
  EXPECT_THAT(with("names", {{"panel-1", "a\nb"}}), HasSubstr("control characters"));
  EXPECT_THAT(with("colour", "red"), HasSubstr("unknown key"));
  EXPECT_THAT(with("unit", "parsec"), HasSubstr("parsec"));
}

TEST(Sha256, HasThePublishedDigests) {
  EXPECT_EQ(sha256(""), "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(sha256("abc"), "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(sha256(std::string(1000000, 'a')),
            "cdc76e5c9914fb9281a1c7e284d73e67f1809a48a497200e046d39ccc7112cd0");
}

}  // namespace
}  // namespace planish::cli
