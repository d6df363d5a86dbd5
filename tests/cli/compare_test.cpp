#include <filesystem>

#include <planish/io/read_mesh.h>

#include <gmock/gmock.h>

#include "cli_run.h"
#include "support/meshes.h"
#include "support/sample_comparison.h"
#include "text/compare_text.h"

namespace planish::cli {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::StartsWith;

class Compare : public CliTest {};

void expect_eighty_columns(const std::string& text) {
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 80U) << line;
}

TEST_F(Compare, TellsOfAllMethodsAndWritesNothing) {
  const CliResult result = planish({"compare", "panel.obj", "--sweeps", "3"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  for (const CompareRun& run : runs_of_all_methods())
    EXPECT_THAT(result.out, HasSubstr("\n" + std::string(name_of(run.method)) + " "));
  EXPECT_THAT(result.out, HasSubstr("\ninput "));
  EXPECT_THAT(result.out, HasSubstr("\nBest: "));
  EXPECT_THAT(result.out, HasSubstr("Read strain first"));
  expect_eighty_columns(result.out);
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

TEST_F(Compare, TakesMethodsInTheOrderAskedFor) {
  const auto json = planish({"compare", "panel.obj", "--methods", "classical,controllable",
                             "--sweeps", "2", "--target-e-max", "1e-3", "--unit", "cm", "--json"})
                        .json();
  ASSERT_EQ(json["runs"].size(), 2U);
  EXPECT_EQ(json["runs"][0]["method"], "classical");
  EXPECT_EQ(json["runs"][1]["method"], "controllable");
  EXPECT_EQ(json["runs"][1]["sweeps"], 2);
  EXPECT_EQ(json["runs"][1]["unfold"]["unit"], "cm");
  EXPECT_TRUE(json["runs"][1]["error"].is_null());
  auto input = planish({"measure", "panel.obj", "--json"}).json();
  for (const char* of_measure : {"schema", "strain", "limits", "cautions"})
    input.erase(of_measure);
  EXPECT_EQ(json["input"], input);
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

TEST_F(Compare, WritesItsFolder) {
  const CliResult result =
      planish({"compare", "panel.obj", "--methods=controllable,classical", "-o", "out", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(names(),
              ElementsAre("out", "out/compare.csv", "out/compare.html", "out/compare.json",
                          "out/panel-classical.obj", "out/panel-controllable.obj", "panel.obj"));
  EXPECT_EQ(result.json(), nlohmann::json::parse(content_of("out/compare.json")));
  const std::string csv = content_of("out/compare.csv");
  EXPECT_THAT(csv, StartsWith("method,sweep,seconds,e_max,e_avg,energy,moved,level_vertices,"
                              "merit_before,merit,level_strain\ncontrollable,1,"));
  EXPECT_THAT(content_of("out/compare.html"), HasSubstr("<!DOCTYPE html>"));
  planish({"evolve", "panel.obj", "-o", "alone.obj", "--method", "classical"});
  EXPECT_EQ(content_of("out/panel-classical.obj"), content_of("alone.obj"));
}

TEST_F(Compare, WritesMeshesInTheFormatOfTheInputButForStl) {
  for (const char* format : {"ply", "stl"}) {
    const std::string input = std::string("patch.") + format;
    ASSERT_EQ(planish({"convert", "panel.obj", input}).exit_code, k_exit_done);
    ASSERT_EQ(planish({"compare", input, "-o", format, "--methods", "classical", "--sweeps", "1"})
                  .exit_code,
              k_exit_done);
  }
  EXPECT_THAT(names(), Contains("ply/patch-classical.ply"));
  EXPECT_THAT(names(), Contains("stl/patch-classical.obj"));
}

TEST_F(Compare, ComparesWhatIsNoDiskWithoutPatterns) {
  TriMesh tube = meshes::tube(12, 6);
  for (Vec3& p : tube.positions)
    p = (1.0 + 0.02 * dot(p, p)) * p;  // so that it is curved
  write_mesh("tube.obj", tube);
  const CliResult result = planish({"compare", "tube.obj", "-o", "out"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, HasSubstr("No patterns, so no strain: "));
  expect_eighty_columns(result.out);
  const auto json = planish({"compare", "tube.obj", "--methods", "fairing", "--json"}).json();
  EXPECT_TRUE(json["unfold_before"].is_null());
  EXPECT_TRUE(json["runs"][0]["unfold"].is_null());
  EXPECT_GT(json["runs"][0]["sweeps"], 0);
}

TEST_F(Compare, RefusesWhatNoMethodCanEvolveAndAFileInPlaceOfTheFolder) {
  write_mesh("closed.obj", meshes::tetrahedron());
  const CliResult closed = planish({"compare", "closed.obj", "-o", "out", "--json"});
  EXPECT_EQ(closed.exit_code, k_exit_failed);
  EXPECT_EQ(closed.json()["error"]["code"], "closed_surface");
  EXPECT_EQ(planish({"compare", "panel.obj", "-o", "panel.obj"}).exit_code, k_exit_failed);
  EXPECT_THAT(names(), ElementsAre("closed.obj", "panel.obj"));
}

TEST_F(Compare, NamesTheNearestMethodAndRefusesRepetition) {
  const CliResult unknown = planish({"compare", "panel.obj", "--methods", "controllable,clasical"});
  EXPECT_EQ(unknown.exit_code, k_exit_usage);
  EXPECT_THAT(unknown.err, HasSubstr("unknown method clasical; did you mean classical?"));
  const CliResult twice = planish({"compare", "panel.obj", "--methods", "classical,classical"});
  EXPECT_EQ(twice.exit_code, k_exit_usage);
  EXPECT_THAT(twice.err, HasSubstr("method classical is named twice"));
  EXPECT_EQ(planish({"compare", "panel.obj", "--methods", "classical,"}).exit_code, k_exit_usage);
}

TEST(CompareText, HasARowForAMethodThatFailedAndOneForEachOther) {
  const std::string text = compare_text(samples::comparison());
  EXPECT_THAT(text, HasSubstr("failed\n\n"));
  EXPECT_THAT(text, HasSubstr("controllable  better pattern: strain 7.6 % -> 2.6 %\n"));
  EXPECT_THAT(text, HasSubstr("classical     failed: no <weights> here\n"));
  EXPECT_THAT(text, HasSubstr("\nBest: controllable\n"));
}

TEST(CompareText, FitsEightyColumnsWithNumbersOfAnySize) {
  for (const double size : {1e-300, 1.2345e-7, 0.00123456, 0.98765, 12.3456, 98765.4321, 1.5e80}) {
    CompareReport report = samples::comparison();
    for (ComparedMethod& method : report.runs) {
      if (!method.evolve) continue;
      method.evolve->after.figures = {size, size, size, size, size, size};
      method.evolve->deviation = {size, size, size};
      method.evolve->result.seconds = size;
      method.evolve->result.stop = StopReason::converged;
      method.unfold->strain = {size, size, size};
    }
    const std::string text = compare_text(report);
    expect_eighty_columns(text);
    std::istringstream lines(text.substr(text.find("\ncontrollable ") + 1));
    std::string line;
    std::getline(lines, line);
    std::istringstream words(line);
    const std::vector<std::string> cells(std::istream_iterator<std::string>(words), {});
    EXPECT_EQ(cells.size(), 9U) << "a cell runs into the next one: " << line;
  }
}

TEST_F(Compare, MeasureWritesTheMapOfDirections) {
  const CliResult result =
      planish({"measure", "panel.obj", "--map", "m.csv", "--picture", "m.svg"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, HasSubstr("dome or cup"));
  expect_eighty_columns(result.out);
  EXPECT_THAT(names(), ElementsAre("m.csv", "m.svg", "panel.obj"));
  const std::string csv = content_of("m.csv");
  EXPECT_EQ(static_cast<std::size_t>(std::count(csv.begin(), csv.end(), '\n')),
            read_mesh("panel.obj").mesh.positions.size() + 1);
  const auto json = planish({"measure", "panel.obj", "--map", "m.csv", "--json"}).json();
  const auto counts = json["directions"];
  EXPECT_EQ(
      counts["flat"].get<int>() + counts["saddle"].get<int>() + counts["dome_or_cup"].get<int>(),
      json["inner_vertices"]);
  EXPECT_FALSE(planish({"measure", "panel.obj", "--json"}).json().contains("directions"));
}

TEST_F(Compare, MeasureRefusesOtherPicturesAndOnePlaceForTwoFiles) {
  const CliResult format = planish({"measure", "panel.obj", "--picture", "m.png", "--json"});
  EXPECT_EQ(format.exit_code, k_exit_failed);
  EXPECT_EQ(format.json()["error"]["code"], "unsupported_format");
  EXPECT_EQ(planish({"measure", "panel.obj", "--map", "m.svg", "--picture", "m.svg"}).exit_code,
            k_exit_usage);
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

}  // namespace
}  // namespace planish::cli
