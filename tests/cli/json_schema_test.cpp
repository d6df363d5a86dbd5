// Every JSON object that the program hands out begins with the number of its format.

#include <map>

#include <gmock/gmock.h>

#include "cli_run.h"
#include "commands/commands.h"
#include "output/app_page.h"
#include "support/meshes.h"
#include "support/products.h"
#include "text/json_text.h"

namespace planish::cli {
namespace {

using nlohmann::ordered_json;

void expect_schema(const std::string& text, const std::string& from) {
  const ordered_json json = ordered_json::parse(text, nullptr, false);
  ASSERT_TRUE(json.is_object() && !json.empty()) << from << ": " << text;
  EXPECT_EQ(json.begin().key(), "schema") << from;
  EXPECT_EQ(json.front(), 2) << from;
}

class JsonSchema : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_product("coat.obj", {{"front", make_shape("dome", 100), {}},
                               {"back", make_shape("saddle", 100), {}}});
    write_mesh("tube.obj", meshes::tube(12, 5));
    std::ofstream("cut.txt") << "0 60\n";
    const TriMesh panel = make_shape("panel", 300);
    write_mesh("panel-line.obj", panel);
    std::ofstream("line.obj") << content_of("panel-line.obj") << "l 1 2\n";
  }
};

const Names k_svg_only = {"--formats", "svg"};

Names quick_flatten(const std::string& input, const std::string& folder, const Names& more = {}) {
  Names args = {"flatten", input, "-o", folder};
  args.insert(args.end(), k_svg_only.begin(), k_svg_only.end());
  args.insert(args.end(), more.begin(), more.end());
  return args;
}

TEST_F(JsonSchema, IsFirstInWhatEveryVerbPrints) {
  const std::map<std::string, Names> runs = {
      {"flatten", quick_flatten("panel.obj", "out")},
      {"measure", {"measure", "panel.obj"}},
      {"evolve", {"evolve", "panel.obj", "-o", "evolved.obj", "--sweeps", "1"}},
      {"unfold", {"unfold", "panel.obj", "-o", "flat.obj"}},
      {"compare", {"compare", "panel.obj", "-o", "compared", "--methods", "fairing"}},
      {"frontier", {"frontier", "panel.obj", "--methods", "fairing"}},
      {"suggest-cuts", {"suggest-cuts", "panel.obj", "--max-strain", "50%"}},
      {"panels", {"panels", "panel.obj", "--effort", "1"}},
      {"carry", {"carry", "line.obj", "--from", "panel.obj", "--to", "panel.obj", "-o", "on.obj"}},
      {"collect", {"collect", "results.jsonl"}},
      {"convert", {"convert", "panel.obj", "panel.ply"}},
      {"sample", {"sample", "dome", "-o", "dome.ply"}},
      {"app", {"app", "-o", "app.html"}},
      {"materials", {"materials"}},
      {"describe", {"describe"}},
      {"completion", {"completion", "fish"}},
      {"man", {"man", "flatten"}},
      {"doctor", {"doctor"}}};
  std::ofstream("list.txt") << "panel.obj\n";
  std::ofstream("results.jsonl") << planish({"flatten", "--inputs", "list.txt", "-o", "many"}).out;
  for (const Command& command : commands()) {
    ASSERT_TRUE(runs.contains(command.name)) << command.name;
    if (command.name == "app" && app_page().empty()) continue;
    Names args = runs.at(command.name);
    args.push_back("--json");
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    expect_schema(result.out, command.name);
  }
  expect_schema(content_of("out/report.json"), "report.json");
  expect_schema(content_of("compared/compare.json"), "compare.json");
}

TEST_F(JsonSchema, IsFirstInWhatIsAddedToByFlags) {
  const std::vector<Names> runs = {quick_flatten("tube.obj", "cut", {"--cut", "cut.txt"}),
                                   quick_flatten("panel.obj", "laid", {"--sheet", "5000mm"}),
                                   quick_flatten("coat.obj", "coat", {"--sheet", "5000mm"}),
                                   {"measure", "panel.obj", "--map", "map.csv"},
                                   {"sample", "--list"},
                                   {"--version"}};
  for (Names args : runs) {
    args.push_back("--json");
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    expect_schema(result.out, testing::PrintToString(args));
  }
  for (const char* file : {"cut/report.json", "laid/report.json", "coat/garment.json",
                           "coat/front/report.json", "coat/back/report.json"})
    expect_schema(content_of(file), file);
}

TEST_F(JsonSchema, IsFirstInFailures) {
  for (const Names& args : {Names{"measure", "missing.obj", "--json"},
                            Names{"measure", "panel.obj", "--no-such-flag", "--json"},
                            Names{"sample", "no_such_shape", "-o", "out.ply", "--json"}}) {
    const CliResult result = planish(args);
    EXPECT_NE(result.exit_code, k_exit_done);
    expect_schema(result.out, testing::PrintToString(args));
  }
  expect_schema(k_out_of_memory_json, "out of memory");
}

}  // namespace
}  // namespace planish::cli
