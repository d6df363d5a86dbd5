#include <gmock/gmock.h>

#include "cli_run.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Frontier : public CliTest {};

TEST_F(Frontier, PrintsATableAndWritesNothing) {
  const CliResult result = planish({"frontier", "panel.obj", "--methods", "classical,fairing"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  for (const char* row :
       {"\n  1 as designed ", "\n  5 0.1 % rms ", "\n  6 flat ", " classical ", " fairing "})
    EXPECT_THAT(result.out, HasSubstr(row));
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 80U) << line;
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

TEST_F(Frontier, HasTheUsualStopsOrAsManyPointsAsAskedFor) {
  const auto json = planish({"frontier", "panel.obj", "--json"}).json();
  std::vector<int> picks;
  for (const auto& point : json["curve"])
    picks.push_back(point["pick"]);
  EXPECT_THAT(picks, ElementsAre(3, 4, 5, 6));
  EXPECT_EQ(json["design"]["pick"], 1);
  EXPECT_EQ(json["others"].size() + json["failures"].size(), 0U);
  const auto more =
      planish({"frontier", "panel.obj", "--points", "9", "--methods", "classical", "--json"})
          .json();
  EXPECT_EQ(more["curve"].size(), 9U);
  EXPECT_EQ(more["others"].size(), 1U);
}

TEST_F(Frontier, RunsAllOtherMethodsWhereThatIsAskedFor) {
  const auto json = planish({"frontier", "panel.obj", "--methods", "all", "--json"}).json();
  EXPECT_EQ(json["others"].size() + json["failures"].size(), 8U);
}

TEST_F(Frontier, HasAPointForAMaterial) {
  const Names args = {"frontier", "panel.obj", "--material", "leather", "--methods", "classical"};
  EXPECT_THAT(planish(args).out, HasSubstr("The limit of 1.00 % is kept at an rms deviation of "));
  Names with_json = args;
  with_json.push_back("--json");
  const auto json = planish(with_json).json();
  EXPECT_EQ(json["curve"].size(), 5U);
  EXPECT_EQ(json["limit"]["max_strain"], 0.01);
  const std::size_t first = json["limit"]["first_within"];
  EXPECT_EQ(json["limit"]["kind"], "p99");
  EXPECT_LE(json["curve"][first]["strain"]["p99"], 0.01);
}

TEST_F(Frontier, WritesAChartAPageOrAllFigures) {
  const Names args = {"frontier", "panel.obj", "--methods", "classical", "-o"};
  for (const auto& [output, begin] :
       {std::pair{"f.svg", "<svg "}, std::pair{"f.html", "<!DOCTYPE html>"},
        std::pair{"f.csv", "method,max_strain,"}}) {
    Names some = args;
    some.emplace_back(output);
    const CliResult result = planish(some);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    EXPECT_THAT(content_of(output), StartsWith(begin));
  }
  EXPECT_THAT(names(), ElementsAre("f.csv", "f.html", "f.svg", "panel.obj"));
}

TEST_F(Frontier, RefusesOtherFilesAndWhatIsNoDisk) {
  const CliResult file = planish({"frontier", "panel.obj", "-o", "f.pdf", "--json"});
  EXPECT_EQ(file.exit_code, k_exit_failed);
  EXPECT_EQ(file.json()["error"]["code"], "unsupported_format");
  write_mesh("closed.obj", TriMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  EXPECT_EQ(planish({"frontier", "closed.obj"}).exit_code, k_exit_failed);
  EXPECT_THAT(names(), ElementsAre("closed.obj", "panel.obj"));
}

TEST_F(Frontier, MistakesAreUsageErrors) {
  struct Case {
    Names flags;
    std::string message;
  };
  for (const Case& c : {Case{{"--points", "3"}, "--points is 3"},
                        Case{{"--methods", "auto"}, "method auto draws the curve"},
                        Case{{"--methods", "clasical"}, "did you mean classical?"},
                        Case{{"--material", "lether"}, "did you mean leather?"},
                        Case{{"--material", "leather", "--max-strain", "2%"}, "give one of them"},
                        Case{{"--max-strain", "0"}, "--max-strain is 0"}}) {
    Names args = {"frontier", "panel.obj"};
    args.insert(args.end(), c.flags.begin(), c.flags.end());
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_usage);
    EXPECT_THAT(result.err, HasSubstr(c.message));
  }
}

TEST_F(Frontier, AnInterruptEndsItWithNothingWritten) {
  const std::atomic<bool> interrupted = true;
  const RunContext context = {.interrupted = &interrupted};
  EXPECT_EQ(planish({"frontier", "panel.obj", "-o", "f.svg"}, context).exit_code,
            k_exit_interrupted);
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

}  // namespace
}  // namespace planish::cli
