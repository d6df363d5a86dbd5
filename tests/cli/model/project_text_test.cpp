#include "model/project_text.h"

#include <fstream>
#include <iterator>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "model/project_file.h"
#include "parse.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string text_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class ProjectTextTest : public CliTest {
 protected:
  static PageProject project(const std::vector<std::string>& words) {
    return project_of(parse(words).arguments);
  }
};

TEST_F(ProjectTextTest, AsksForTheSamePattern) {
  const std::vector<std::string> words = {"flatten",      "panel.obj",
                                          "--unit",       "cm",
                                          "--cut",        "line 0,0,0 100,280.5,-1e-3 300,0,0",
                                          "--allowance",  "10mm",
                                          "--paper",      "a4",
                                          "--max-strain", "4%",
                                          "--formats",    "svg,dxf,pdf,plt",
                                          "--textured"};
  const PageProject written = project(words);
  EXPECT_EQ(written.name, "panel.planish.json");
  EXPECT_THAT(written.left_out, IsEmpty());
  std::ofstream(written.name) << written.text;
  std::vector<std::string> flags = words;
  flags.insert(flags.end(), {"-o", "by_flags"});
  const CliResult by_flags = planish(flags);
  const CliResult by_file = planish({"flatten", written.name, "-o", "by_file"});
  EXPECT_EQ(by_file.exit_code, by_flags.exit_code) << by_file.err;
  std::size_t count = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator("by_flags")) {
    const std::string kind = entry.path().extension().string();
    if (!entry.is_regular_file() || kind == ".json" || kind == ".html") continue;
    ++count;
    const std::string path = entry.path().lexically_relative("by_flags").string();
    EXPECT_EQ(text_of("by_file/" + path), text_of("by_flags/" + path)) << path;
  }
  EXPECT_GT(count, 5U);
}

// A project is read as flags; written again it is the same.
TEST_F(ProjectTextTest, WritesWhatWasRead) {
  const std::string points = "[[0.0, 1.5, 2.0], [3.0, 4.0, 5.25], [0.0, 0.0, 1e-7]]";
  const nlohmann::json read = nlohmann::json::parse(
      R"({"kind": "planish project", "version": 1, "model": "panel.obj", "hash": "", "unit": "dm",
          "lines": [{"kind": "shortest", "points": )" +
      points + R"(}, {"kind": "drawn", "points": )" + points +
      R"(}], "names": {"panel-1": "front"}, "without": ["panel-2"], "material": "felt",
          "strain": "", "allowance": "1cm", "paper": "", "grain": "0,0,1", "symmetric": "x=0", "notches": )" +
      points + "}");
  std::ofstream("some.json") << read.dump();
  const std::vector<std::string> words = {"flatten", "some.json"};
  const Parsed parsed = parse(words);
  const PageProject written = project_of(with_project(*parsed.command, parsed.arguments));
  EXPECT_THAT(written.left_out, IsEmpty());
  nlohmann::json again = nlohmann::json::parse(written.text);
  EXPECT_EQ(again["hash"].get<std::string>().size(), 64U);
  again["hash"] = "";
  for (const auto& [key, value] : read.items())
    EXPECT_EQ(again[key], value) << key;
}

TEST_F(ProjectTextTest, ListsWhatItHasNoPlaceFor) {
  EXPECT_THAT(project({"flatten", "panel.obj", "--map", "--cut", "creases", "--json"}).left_out,
              ElementsAre("--cut", "--map"));
  EXPECT_THAT(
      project({"flatten", "panel.obj", "--grain", "30deg", "--material", "own.json"}).left_out,
      ElementsAre("--grain", "--material"));
  EXPECT_THAT(project({"flatten", "panel.obj", "--symmetric", "x=0"}).left_out,
              ElementsAre("--symmetric"));
}

TEST_F(ProjectTextTest, ListsThePartsOfAProduct) {
  std::filesystem::copy_file("panel.obj", "other.obj");
  const nlohmann::json written =
      nlohmann::json::parse(project({"flatten", "panel.obj", "other.obj", "--product"}).text);
  EXPECT_EQ(written["model"], "panel.obj");
  ASSERT_EQ(written["parts"].size(), 1U);
  EXPECT_EQ(written["parts"][0]["model"], "other.obj");
  EXPECT_EQ(written["parts"][0]["hash"], written["hash"]);
}

TEST_F(ProjectTextTest, IsEmptyWithoutAModelOfItsOwn) {
  EXPECT_EQ(project({"flatten", "."}).text, "");
  EXPECT_EQ(project({"flatten", "none.obj"}).text, "");
  EXPECT_EQ(project({"flatten", "panel.obj", "panel.obj"}).text, "");
}

TEST_F(ProjectTextTest, IsInTheReport) {
  ASSERT_NE(planish({"flatten", "panel.obj", "-o", "out", "--map"}).exit_code, 1);
  const std::string page = text_of("out/report.html");
  EXPECT_THAT(page, HasSubstr("download=\"panel.planish.json\""));
  EXPECT_THAT(page, HasSubstr("data-app=\"planish.html\""));
  EXPECT_THAT(page, HasSubstr("<small>without --map</small>"));
}

}  // namespace
}  // namespace planish::cli
