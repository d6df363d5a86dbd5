// Verbs that take many files: evolve, unfold and compare. Of measure: measure_test.cpp.

#include <algorithm>
#include <atomic>
#include <map>

#include <planish/io/read_mesh.h>

#include <gmock/gmock.h>

#include "cli/batch/csv_table.h"
#include "cli/cli_run.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class SeveralFiles : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    std::filesystem::create_directory("more");
    write_mesh("more/dome.ply", make_shape("dome", 150));
    write_mesh("more/panel.stl", make_shape("saddle", 150));
    std::ofstream("bad.obj") << "v 0 0\n";
  }

  /// The run's table by the names of its columns.
  static std::vector<std::map<std::string, std::string>> table(const std::string& path) {
    const std::vector<Names> rows = table_in(content_of(path));
    std::vector<std::map<std::string, std::string>> lines;
    for (std::size_t r = 1; r < rows.size(); ++r) {
      EXPECT_EQ(rows[r].size(), rows[0].size()) << r;
      auto& line = lines.emplace_back();
      for (std::size_t c = 0; c < rows[r].size(); ++c)
        line[rows[0].at(c)] = rows[r][c];
    }
    return lines;
  }
};

double number(const std::string& text) {
  return std::stod(text);
}

TEST_F(SeveralFiles, EvolveWritesALineAndAMeshForEach) {
  const CliResult result =
      planish({"evolve", "panel.obj", "more", "-o", "out", "--csv", "f.csv", "--sweeps", "3"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  // An STL goes as OBJ, and two of a name stay apart.
  EXPECT_THAT(names(),
              ElementsAre("bad.obj", "f.csv", "more", "more/dome.ply", "more/panel.stl", "out",
                          "out/dome.ply", "out/panel-2.obj", "out/panel.obj", "panel.obj"));
  const auto lines = table("f.csv");
  ASSERT_EQ(lines.size(), 3U);
  EXPECT_EQ(lines[2].at("output"), "out/panel-2.obj");
  const auto alone =
      planish({"evolve", "panel.obj", "-o", "a.obj", "--sweeps", "3", "--json"}).json();
  EXPECT_EQ(content_of("a.obj"), content_of("out/panel.obj"));
  const auto& line = lines[0];
  EXPECT_EQ(line.at("method"), "controllable");
  EXPECT_EQ(line.at("sweeps"), "3");
  EXPECT_EQ(line.at("stop"), alone["stop"].get<std::string>());
  for (const char* figure : {"e_max", "e_avg", "energy", "sum_abs_defect", "min_angle"}) {
    EXPECT_EQ(number(line.at(std::string(figure) + "_before")), alone["before"][figure]);
    EXPECT_EQ(number(line.at(std::string(figure) + "_after")), alone["after"][figure]);
  }
  for (const char* figure : {"bending_ratio", "bending_added", "bending_lost"})
    EXPECT_EQ(number(line.at(figure)), alone[figure]);
  EXPECT_EQ(number(line.at("deviation_max")), alone["deviation"]["max"]);
  EXPECT_EQ(line.at("smooth"), alone["smooth"].get<bool>() ? "1" : "0");
  EXPECT_EQ(line.at("form_kept"), alone["form_kept"].get<bool>() ? "1" : "0");
}

TEST_F(SeveralFiles, EvolveGoesOnBehindABadFile) {
  const CliResult result =
      planish({"evolve", "bad.obj", "panel.obj", "--csv", "f.csv", "--sweeps", "2", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("1 of 2 files failed"));
  const auto lines = table("f.csv");
  EXPECT_EQ(lines[0].at("error"), "malformed_file");
  EXPECT_EQ(lines[0].at("e_max_after"), "");
  EXPECT_EQ(lines[1].at("error"), "");
  EXPECT_EQ(lines[1].at("output"), "");
  const auto json = result.json();
  EXPECT_EQ(json["csv"], "f.csv");
  EXPECT_EQ(json["files"][0]["error"]["code"], "malformed_file");
  EXPECT_EQ(json["files"][1]["history"].size(), 2U);
  EXPECT_TRUE(json["files"][1]["output"].is_null());
  EXPECT_EQ(names().size(), 6U);  // no mesh was asked for
}

TEST_F(SeveralFiles, EvolveSaysHowManyMissTheTarget) {
  write_mesh("flat.obj", meshes::flat_grid(4, 4));
  const CliResult result = planish({"evolve", "flat.obj", "panel.obj", "--csv", "f.csv", "--sweeps",
                                    "1", "--target-e-max", "1e-6", "--require-target"});
  EXPECT_EQ(result.exit_code, k_exit_target_missed);
  EXPECT_THAT(result.err, HasSubstr("the target is missed by 1 of 2 files"));
}

TEST_F(SeveralFiles, UnfoldWritesPatternsInTheFormatAskedFor) {
  const CliResult result = planish({"unfold", "more", "-o", "out", "--csv", "f.csv",
                                    "--output-format", "dxf", "--max-strain", "90%"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(names(), ElementsAre("bad.obj", "f.csv", "more", "more/dome.ply", "more/panel.stl",
                                   "out", "out/dome.dxf", "out/panel.dxf", "panel.obj"));
  const auto line = table("f.csv").front();
  const auto alone =
      planish({"unfold", "more/dome.ply", "-o", "a.dxf", "--max-strain", "90%", "--json"}).json();
  EXPECT_EQ(content_of("a.dxf"), content_of("out/dome.dxf"));
  for (const char* figure : {"max", "rms", "p99"})
    EXPECT_EQ(number(line.at(std::string("strain_") + figure)), alone["strain"][figure]);
  for (const char* figure : {"width", "height", "area_ratio"})
    EXPECT_EQ(number(line.at(figure)), alone[figure]);
  EXPECT_EQ(line.at("overlaps"), "0");
  EXPECT_EQ(line.at("flipped_triangles"), "0");
  EXPECT_EQ(line.at("limits_kept"), "1");
}

TEST_F(SeveralFiles, UnfoldWritesSvgUnlessAskedAndCountsMissedLimits) {
  const CliResult result = planish({"unfold", "more", "-o", "out", "--max-strain", "0.001%"});
  EXPECT_EQ(result.exit_code, k_exit_target_missed);
  EXPECT_THAT(result.err, HasSubstr("a limit of strain is missed by 2 of 2 files"));
  EXPECT_THAT(content_of("out/dome.svg"), HasSubstr("<svg"));
}

TEST_F(SeveralFiles, CompareWritesALineForEachFileAndMethod) {
  const CliResult result =
      planish({"compare", "bad.obj", "more", "--methods", "controllable,local_offset", "--sweeps",
               "2", "--csv", "f.csv", "-o", "out"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  const auto lines = table("f.csv");
  ASSERT_EQ(lines.size(), 5U);
  EXPECT_EQ(lines[0].at("method"), "");
  EXPECT_EQ(lines[0].at("error"), "malformed_file");
  EXPECT_EQ(lines[1].at("method"), "controllable");
  EXPECT_EQ(lines[2].at("method"), "local_offset");
  EXPECT_EQ(lines[2].at("path"), "more/dome.ply");
  const auto alone = nlohmann::json::parse(content_of("out/dome/compare.json"));
  EXPECT_EQ(number(lines[2].at("strain_rms")), alone["runs"][1]["unfold"]["strain"]["rms"]);
  EXPECT_EQ(number(lines[2].at("strain_rms_before")), alone["unfold_before"]["strain"]["rms"]);
  EXPECT_EQ(lines[2].at("output"), "out/dome");
  EXPECT_TRUE(std::filesystem::exists("out/panel/panel-local_offset.obj"));
}

TEST_F(SeveralFiles, CompareGivesTheMethodThatFailedItsError) {
  write_mesh("tube.obj", meshes::tube(12, 5));
  const CliResult result = planish({"compare", "tube.obj", "--methods", "controllable", "--csv",
                                    "f.csv", "--sweeps", "1", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["files"][0]["runs"].size(), 1U);
  EXPECT_EQ(table("f.csv").front().at("strain_rms"), "");
}

TEST_F(SeveralFiles, FitOnATerminal) {
  for (const Names& args : {Names{"evolve", "more", "panel.obj", "-o", "a", "--sweeps", "1"},
                            Names{"unfold", "more", "panel.obj", "-o", "b"},
                            Names{"compare", "more", "panel.obj", "--sweeps", "1"}}) {
    std::istringstream lines(planish(args).out);
    for (std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST_F(SeveralFiles, RefuseWhatGoesWithOneFile) {
  const auto message_of = [](const Names& args) {
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_usage) << result.err;
    return result.err;
  };
  EXPECT_THAT(message_of({"evolve", "more", "-o", "o", "--history", "h.csv"}),
              HasSubstr("--history goes with one file only"));
  EXPECT_THAT(message_of({"unfold", "more", "-o", "o", "--notches", "n.txt"}),
              HasSubstr("--notches goes with one file only"));
  EXPECT_THAT(message_of({"compare", "more", "--fix", "f.txt"}),
              HasSubstr("--fix goes with one file only"));
  EXPECT_THAT(message_of({"evolve", "panel.obj", "-o", "o.obj", "--output-format", "ply"}),
              HasSubstr("--output-format goes with several files"));
  EXPECT_THAT(message_of({"evolve", "more", "-o", "o", "--output-format", "svg"}),
              HasSubstr("svg"));
  EXPECT_THAT(message_of({"evolve", "more"}), HasSubstr("missing flag -o"));
  EXPECT_THAT(message_of({"evolve", "more", "-o", "one.obj"}), HasSubstr("looks like a file"));
  EXPECT_THAT(message_of({"evolve", "more", "-o", "./more/"}), HasSubstr("would replace an input"));
}

TEST_F(SeveralFiles, StopWhereTheUserAsks) {
  const std::atomic<bool> interrupted = true;
  const CliResult result = planish({"evolve", "panel.obj", "more", "-o", "out", "--csv", "f.csv"},
                                   {.interrupted = &interrupted});
  EXPECT_EQ(result.exit_code, k_exit_interrupted);
  EXPECT_THAT(result.err, HasSubstr("nothing was written"));
  EXPECT_FALSE(std::filesystem::exists("f.csv"));
}

TEST_F(SeveralFiles, MayBeginWithAHyphen) {
  std::filesystem::rename("more/dome.ply", "-dome.ply");
  const auto json = planish({"measure", "panel.obj", "--json", "--", "-dome.ply"}).json();
  EXPECT_EQ(json["files"].size(), 2U);
  EXPECT_EQ(json["files"][1]["path"], "-dome.ply");
  EXPECT_EQ(planish({"convert", "--", "-dome.ply", "-dome.obj"}).exit_code, k_exit_done);
  EXPECT_TRUE(std::filesystem::exists("-dome.obj"));
  EXPECT_EQ(planish({"convert", "--", "a.ply", "b.ply", "c.ply"}).exit_code, k_exit_usage);
  EXPECT_EQ(planish({"--", "panel.obj"}).exit_code, k_exit_usage);
}

}  // namespace
}  // namespace planish::cli
