// Results from outside: compare --with.

#include <filesystem>
#include <functional>

#include <planish/io/read_mesh.h>

#include <gmock/gmock.h>

#include "cli_run.h"
#include "model/other_methods.h"
#include "shell/failures.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// What the fake programs below were started with.
std::vector<std::string>& started() {
  static std::vector<std::string> words;
  return words;
}

using Asked = std::function<bool()>;
using Program = std::string (*)(const std::vector<std::string>&, const Asked&);

RunContext with_program(Program program) {
  RunContext context;
  context.run_program = program;
  return context;
}

/// Programs called "NAME IN OUT".
std::string lifts(const std::vector<std::string>& words, const Asked&) {
  started() = words;
  TriMesh mesh = read_mesh(words.at(1)).mesh;
  const Patch patch(mesh);
  for (const Index v : patch.inner_vertices())
    mesh.positions[v].z += 0.01;
  write_mesh(words.at(2), mesh);
  return {};
}
std::string fails(const std::vector<std::string>&, const Asked&) {
  return "ended with code 3";
}
std::string writes_nothing(const std::vector<std::string>&, const Asked&) {
  return {};
}
std::string loses_a_vertex(const std::vector<std::string>& words, const Asked&) {
  write_mesh(words.at(2), make_shape("dome", 100));
  return {};
}
std::string turns_edges(const std::vector<std::string>& words, const Asked&) {
  TriMesh mesh = read_mesh(words.at(1)).mesh;
  mesh.triangles.front() = mesh.triangles.back();
  write_mesh(words.at(2), mesh);
  return {};
}
std::string writes_words(const std::vector<std::string>& words, const Asked&) {
  put_file(words.at(2), "no mesh\n");
  return {};
}

class CompareWith : public CliTest {
 protected:
  /// The row of the only method.
  nlohmann::json run_of(const std::vector<std::string>& with, Program program = nullptr) {
    std::vector<std::string> words = {"compare", "panel.obj", "--methods", "none", "--json"};
    for (const std::string& value : with) {
      words.emplace_back("--with");
      words.push_back(value);
    }
    const auto json = planish(words, with_program(program)).json();
    return json.contains("runs") ? json["runs"][0] : json;
  }
};

TEST_F(CompareWith, JudgesAResultAsIfAMethodOfTheLibraryHadMadeIt) {
  planish({"evolve", "panel.obj", "-o", "evolved.obj", "--method", "classical"});
  auto own = run_of({"mine=evolved.obj"});
  auto theirs =
      planish({"compare", "panel.obj", "--methods", "classical", "--json"}).json()["runs"][0];
  EXPECT_EQ(own["method"], "mine");
  EXPECT_EQ(own["sweeps"], 1);
  for (const char* key : {"after", "deviation", "unfold", "verdict", "smooth", "bending_ratio"})
    EXPECT_EQ(own[key], theirs[key]) << key;
}

TEST_F(CompareWith, TakesTrianglesInAnyOrder) {
  planish({"evolve", "panel.obj", "-o", "evolved.ply"});
  TriMesh mesh = read_mesh("evolved.ply").mesh;
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  for (Triangle& t : mesh.triangles)
    std::rotate(t.begin(), t.begin() + 1, t.end());
  write_mesh("other.ply", mesh);
  EXPECT_EQ(run_of({"mine=other.ply"})["after"], run_of({"mine=evolved.ply"})["after"]);
}

TEST_F(CompareWith, LetsSeveralTakePartBesideOthersAndWritesTheirMeshes) {
  planish({"evolve", "panel.obj", "-o", "a.obj", "--method", "classical"});
  planish({"evolve", "panel.obj", "-o", "b.obj", "--method", "fairing"});
  const CliResult result = planish({"compare", "panel.obj", "--methods", "controllable", "--with",
                                    "a=a.obj", "--with", "b-2=b.obj", "-o", "out"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, HasSubstr("\ncontrollable "));
  EXPECT_THAT(result.out, HasSubstr("\na "));
  EXPECT_THAT(result.out, HasSubstr("\nb-2 "));
  EXPECT_EQ(content_of("out/panel-b-2.obj"), content_of("b.obj"));
  EXPECT_THAT(content_of("out/compare.csv"), HasSubstr("\nb-2,1,"));
}

TEST_F(CompareWith, TellsWhatBordersDid) {
  TriMesh mesh = read_mesh("panel.obj").mesh;
  for (Vec3& p : mesh.positions)
    p = 1.01 * p;
  write_mesh("larger.obj", mesh);
  EXPECT_GT(run_of({"mine=larger.obj"})["border"]["max"], 0.0);
}

TEST_F(CompareWith, TakesOfAFolderTheMeshOfEachInput) {
  std::filesystem::create_directories("patches");
  for (const char* name : {"patches/dome.obj", "patches/saddle.obj"})
    write_mesh(name, make_shape(std::filesystem::path(name).stem().string(), 200));
  planish({"evolve", "patches/dome.obj", "-o", "results/dome.obj"});
  const CliResult result = planish({"compare", "patches", "--methods", "none", "--with",
                                    "mine=results", "--csv", "figures.csv"});
  EXPECT_EQ(result.exit_code, k_exit_failed);  // there is none of the saddle
  const std::string csv = content_of("figures.csv");
  EXPECT_THAT(csv, HasSubstr("mine"));
  EXPECT_THAT(csv, HasSubstr("file_not_found"));
}

TEST_F(CompareWith, RunsAProgramOnTheInputAndLeavesNoFiles) {
  const auto run = run_of({"mine=tool {in} {out} 'two words'"}, lifts);
  EXPECT_TRUE(run["error"].is_null()) << run["error"];
  EXPECT_NEAR(run["deviation"]["max"], 0.01, 1e-12);
  ASSERT_EQ(started().size(), 4U);
  EXPECT_EQ(started()[0], "tool");
  EXPECT_EQ(started()[3], "two words");
  EXPECT_FALSE(std::filesystem::exists(std::filesystem::path(started()[1]).parent_path()));
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

TEST_F(CompareWith, GivesAProgramTheInputInItsScale) {
  const auto json = planish({"compare", "panel.obj", "--scale", "0.5", "--methods", "none",
                             "--with", "mine=tool {in} {out}", "--json"},
                            with_program(lifts))
                        .json();
  EXPECT_NEAR(json["runs"][0]["deviation"]["max"], 0.01, 1e-12);
}

TEST_F(CompareWith, HasARowThatSaysWhyAProgramFailed) {
  const std::string command = "mine=tool {in} {out}";
  const auto message_of = [&](Program program) {
    const auto run = run_of({command}, program);
    EXPECT_EQ(run["error"]["code"], "method_failed");
    return run["error"]["message"].get<std::string>();
  };
  EXPECT_THAT(message_of(fails), HasSubstr("its program tool ended with code 3"));
  EXPECT_THAT(message_of(writes_nothing), HasSubstr("wrote no mesh to {out}"));
  EXPECT_THAT(message_of(loses_a_vertex), HasSubstr("vertices, the input has"));
  EXPECT_THAT(message_of(turns_edges), HasSubstr("other triangles"));
  EXPECT_THAT(message_of(writes_words), HasSubstr("cannot be read"));
  EXPECT_THAT(message_of(nullptr), HasSubstr("cannot be started"));
}

TEST_F(CompareWith, GoesOnWithOtherMethodsWhereAProgramFails) {
  const CliResult result =
      planish({"compare", "panel.obj", "--methods", "classical", "--with", "mine=tool {in} {out}"},
              with_program(fails));
  EXPECT_EQ(result.exit_code, k_exit_done);
  EXPECT_THAT(result.err, HasSubstr("mine: "));
  EXPECT_THAT(result.out, HasSubstr("failed"));
  EXPECT_THAT(result.out, HasSubstr("\nclassical "));
}

TEST_F(CompareWith, StopsWhereTheUserAsksForItWhileAProgramRuns) {
  static std::atomic<bool> interrupted = false;
  interrupted = false;
  RunContext context = with_program([](const std::vector<std::string>&, const Asked& is_cancelled) {
    EXPECT_FALSE(is_cancelled());
    interrupted = true;
    EXPECT_TRUE(is_cancelled());
    return std::string("was ended by signal 15");
  });
  context.interrupted = &interrupted;
  const CliResult result = planish(
      {"compare", "panel.obj", "--with", "mine=tool {in} {out}", "--methods", "none"}, context);
  EXPECT_EQ(result.exit_code, k_exit_interrupted);
}

TEST_F(CompareWith, RefusesWhatIsNoRequest) {
  const auto refusal = [&](const std::string& value) {
    const CliResult result = planish({"compare", "panel.obj", "--with", value});
    EXPECT_EQ(result.exit_code, k_exit_usage) << value;
    return result.err;
  };
  EXPECT_THAT(refusal("evolved.obj"), HasSubstr("NAME=FILE or NAME=COMMAND"));
  EXPECT_THAT(refusal("mine="), HasSubstr("NAME=FILE or NAME=COMMAND"));
  EXPECT_THAT(refusal("../mine=a.obj"), HasSubstr("a name has"));
  EXPECT_THAT(refusal("auto=a.obj"), HasSubstr("there is already a method auto"));
  EXPECT_THAT(refusal("mine=tool {in}"), HasSubstr("both {in} and {out}"));
  EXPECT_THAT(refusal("mine=tool '{in} {out}"), HasSubstr("a quote is not closed"));
  EXPECT_EQ(planish({"compare", "panel.obj", "--with", "a=a.obj", "--with", "a=b.obj"}).exit_code,
            k_exit_usage);
  EXPECT_EQ(planish({"compare", "panel.obj", "--methods", "none"}).exit_code, k_exit_usage);
  put_file("fixed.txt", "3\n");
  EXPECT_EQ(
      planish({"compare", "panel.obj", "--with", "a=panel.obj", "--fix", "fixed.txt"}).exit_code,
      k_exit_usage);
}

TEST(WordsOfCommand, AreDividedAtSpacesOutsideOfQuotesAndByNothingElse) {
  EXPECT_THAT(words_of_command("  a  b\tc "), ElementsAre("a", "b", "c"));
  EXPECT_THAT(words_of_command("a 'b c' \"d 'e\""), ElementsAre("a", "b c", "d 'e"));
  EXPECT_THAT(words_of_command("a=\"b c\"d ''"), ElementsAre("a=b cd", ""));
  EXPECT_THAT(words_of_command("rm -rf $HOME; `id` | x > y \\n *"),
              ElementsAre("rm", "-rf", "$HOME;", "`id`", "|", "x", ">", "y", "\\n", "*"));
  EXPECT_THAT(words_of_command(""), IsEmpty());
  EXPECT_THROW(words_of_command("a 'b"), UsageError);
}

}  // namespace
}  // namespace planish::cli
