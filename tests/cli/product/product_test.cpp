#include <algorithm>
#include <atomic>
#include <cmath>
#include <streambuf>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "mesh/split.h"
#include "platform/path.h"
#include "shell/safe_names.h"
#include "support/meshes.h"
#include "support/products.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

NamedPatch sample(const std::string& name, const std::string& shape, std::size_t vertices) {
  return {name, make_shape(shape, vertices), {}};
}

/// A saddle cut in two along a path of its edges.
std::vector<NamedPatch> halves(std::size_t fineness = 1) {
  const std::size_t columns = 12 * fineness;
  const auto n = static_cast<double>(fineness);
  const TriMesh mesh = meshes::height_field(columns, 8 * fineness, [n](double x, double y) {
    return (0.05 * (x - 6.0 * n) * (x - 6.0 * n) - 0.06 * y * y) / n;
  });
  std::vector<Index> group;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    group.push_back(
        t / 2 % columns < 5 * fineness + t / (2 * columns) % 2 ? 0 : 1);  // the path has corners
  const std::vector<std::string> names = {"left", "right"};
  return split(mesh, group, names);
}

const Names k_svg = {"--formats", "svg"};

CliResult flatten_product(const std::string& input, const std::string& folder,
                          const Names& more = {}, const RunContext& context = {}) {
  Names args = {"flatten", input, "-o", folder};
  args.insert(args.end(), k_svg.begin(), k_svg.end());
  args.insert(args.end(), more.begin(), more.end());
  return planish(args, context);
}

/// Of the design, which stays as it is.
CliResult flatten_design(const std::string& input, const std::string& folder,
                         const Names& more = {}) {
  Names args = {"flatten", input, "-o", folder, "--pick", "1", "--formats", "svg"};
  args.insert(args.end(), more.begin(), more.end());
  return planish(args);
}

class Product : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_product("coat.obj", {sample("front", "dome", 150), sample("back/../../up", "saddle", 250),
                               sample("Front", "cylinder", 100)});
  }
};

TEST_F(Product, TellsOfEachPatchWhetherItsPatternKeepsTheLimit) {
  write_product("two.obj", {sample("round", "dome", 120), sample("tube", "cylinder", 120)});
  const Names args = {"flatten",         "two.obj", "-o",           "out",
                      "--formats",       "svg",     "--max-strain", "1%",
                      "--max-deviation", "0.01mm"};
  const CliResult result = planish(args);
  EXPECT_EQ(result.exit_code, k_exit_target_missed);
  EXPECT_THAT(result.err,
              testing::ContainsRegex("\\[no\\] round .* strain limit of 1.*% missed: "));
  EXPECT_THAT(result.err, testing::ContainsRegex("\\[ok\\] tube .* strain limit of 1.*% kept: 0"));
  EXPECT_THAT(result.out, HasSubstr("2 pieces; model in mm; 1 to look at, first\n\n  [no] round"));
  const auto json = nlohmann::json::parse(content_of("out/garment.json"));
  EXPECT_FALSE(json["patches"][0]["met"]);
  EXPECT_EQ(json["patches"][0]["checks"][0]["what"], "strain");
  EXPECT_TRUE(json["patches"][1]["met"]);
  EXPECT_TRUE(json["patches"][1]["rejected_strain"].is_null());
  EXPECT_THAT(result.err, HasSubstr("not kept by the pattern of:\n  round\n"));
  EXPECT_TRUE(std::filesystem::exists("out/round/pattern.svg"));
  Names again = args;
  again.push_back("--resume");
  EXPECT_EQ(planish(again).exit_code, k_exit_target_missed) << "of results that were there too";
  Names looser = args;
  looser[7] = "90%";
  EXPECT_EQ(planish(looser).exit_code, k_exit_done);
}

TEST_F(Product, SaysWhatSheetTakesAllPieces) {
  write_product("two.obj", {sample("tube", "cylinder", 120), sample("round", "dome", 120)});
  const CliResult result = flatten_product("two.obj", "out");
  const auto json = nlohmann::json::parse(content_of("out/garment.json"));
  const std::string verdict = json["verdict"];
  EXPECT_THAT(verdict, testing::StartsWith("Needs a sheet that takes "));
  EXPECT_THAT(verdict,
              testing::EndsWith(
                  " round stretches most. No limit of stretch was given. No form was changed."));
  EXPECT_THAT(content_of("out/garment.html"), HasSubstr(verdict.substr(verdict.find(" round"))));
  EXPECT_THAT(result.out, testing::ContainsRegex("2 pieces; model in mm[^\n]*\n\nNeeds a sheet"));
  write_product("tubes.obj", {sample("tube", "cylinder", 120), sample("pipe", "cylinder", 120)});
  EXPECT_THAT(flatten_product("tubes.obj", "flat", {"--json"}).json()["verdict"],
              "Every piece lies flat but for a stretch too small to measure. No form was changed.");
  EXPECT_THAT(
      flatten_product("two.obj", "near", {"--json", "--max-strain", "50%"}).json()["verdict"],
      "No form was changed.");
}

TEST_F(Product, GivesEveryPatchAFolderInsideTheOne) {
  const CliResult result = flatten_product("coat.obj", "out");
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  for (const char* name : {"front", "back_.._.._up", "Front-2"}) {
    for (const char* file : {"pattern.svg", "processed.obj", "report.json", "job.json"})
      EXPECT_TRUE(std::filesystem::exists(std::filesystem::path("out") / name / file)) << name;
  }
  std::size_t folders = 0;
  for (const auto& entry : std::filesystem::directory_iterator("out"))
    folders += entry.is_directory() ? 1 : 0;
  EXPECT_EQ(folders, 3U);
  EXPECT_FALSE(std::filesystem::exists("up"));
  EXPECT_THAT(result.err, HasSubstr("coat.obj: 3 patches, divided by o"));
  EXPECT_THAT(result.err, HasSubstr("Front"));
  EXPECT_THAT(result.out, HasSubstr("garment.json"));
}

TEST_F(Product, MakesOfEachPatchWhatItsOwnRunMakes) {
  ASSERT_EQ(flatten_product("coat.obj", "out").exit_code, k_exit_done);
  write_mesh("front.obj", make_shape("dome", 150));
  ASSERT_EQ(flatten_product("front.obj", "alone", {"--piece-name", "front"}).exit_code,
            k_exit_done);
  for (const char* file : {"pattern.svg", "processed.obj", "flat.obj"})
    EXPECT_EQ(content_of(std::string("out/front/") + file),
              content_of(std::string("alone/") + file));
  EXPECT_FALSE(std::filesystem::exists("alone/job.json"));
}

TEST_F(Product, EndsWith3WhereTheDesignOfAPieceWasKept) {
  ASSERT_EQ(planish({"flatten", "panel.obj", "-o", "made", "--pick", "6"}).exit_code, k_exit_done);
  std::filesystem::create_directories("parts");
  std::filesystem::copy_file("made/processed.obj", "parts/flat.obj");
  write_mesh("parts/tube.obj", make_shape("cylinder", 120));
  const Names args = {"flatten",   "parts",    "-o", "out",       "--method",
                      "classical", "--sweeps", "50", "--formats", "svg"};
  const CliResult result = planish(args);
  EXPECT_EQ(result.exit_code, k_exit_target_missed);
  EXPECT_THAT(result.err, HasSubstr("the pattern of the design was written, of:\n  flat\n"));
  EXPECT_THAT(result.out, HasSubstr("[no] flat"));
  const auto piece = nlohmann::json::parse(content_of("out/garment.json"))["patches"][0];
  EXPECT_EQ(piece["checks"][0]["what"], "rejected");
  EXPECT_GT(piece["rejected_strain"]["rms"], piece["unfold"]["strain"]["rms"]);
  Names again = args;
  again.push_back("--resume");
  EXPECT_EQ(planish(again).exit_code, k_exit_target_missed) << "of results that were there too";
}

TEST_F(Product, HasOnePageForAllPieces) {
  const CliResult result = flatten_product("coat.obj", "out");
  EXPECT_THAT(result.out, HasSubstr("garment.html"));
  const std::string page = content_of("out/garment.html");
  for (const char* name : {"front", "back_.._.._up", "Front-2"}) {
    const std::string link = std::string(name) + "/report.html";
    EXPECT_THAT(page, HasSubstr("<a href=\"" + link + "\">"));
    EXPECT_TRUE(std::filesystem::exists("out/" + link));
  }
}

TEST_F(Product, DoesNotDependOnTheNumberOfThreads) {
  ASSERT_EQ(flatten_product("coat.obj", "one", {"--threads", "1"}).exit_code, k_exit_done);
  ASSERT_EQ(flatten_product("coat.obj", "four", {"--threads", "4"}).exit_code, k_exit_done);
  for (const char* name : {"front", "back_.._.._up", "Front-2"}) {
    for (const char* file : {"pattern.svg", "processed.obj", "flat.obj"}) {
      const std::string path = std::string(name) + "/" + file;
      EXPECT_EQ(content_of("one/" + path), content_of("four/" + path)) << path;
    }
  }
}

TEST_F(Product, TellsTheSeamsAndMakesThemMatchUnlessToldOtherwise) {
  write_product("two.obj", halves());
  const auto plain = flatten_product("two.obj", "plain", {"--json", "--no-match-seams"}).json();
  const auto matched = flatten_product("two.obj", "matched", {"--json"}).json();
  ASSERT_EQ(plain["seams"].size(), 1U);
  ASSERT_EQ(matched["seams"].size(), 1U);
  const auto& seam = matched["seams"][0];
  EXPECT_EQ(seam["sides"][0]["patch"], "left");
  EXPECT_EQ(seam["sides"][1]["patch"], "right");
  EXPECT_EQ(seam["sides"][0]["vertices"], seam["sides"][1]["vertices"]);
  EXPECT_GT(seam["sides"][0]["vertices"], 9);
  EXPECT_GT(plain["seams"][0]["difference"], 1e-3);
  EXPECT_LT(seam["difference"], 1e-9);
  EXPECT_NEAR(seam["sides"][0]["length"], seam["length_on_model"], 1e-9);
  EXPECT_TRUE(matched["patches"][0]["unfold"]["match_seams"]);
  EXPECT_LT(matched["patches"][0]["unfold"]["border_strain"], 1e-9);
  EXPECT_GT(plain["patches"][0]["unfold"]["border_strain"], 1e-6);
  EXPECT_FALSE(plain["patches"][0]["unfold"]["match_seams"]);
  flatten_product("two.obj", "asked", {"--match-seams"});
  EXPECT_EQ(content_of("asked/left/flat.obj"), content_of("matched/left/flat.obj"))
      << "the same where it is asked for";
}

TEST_F(Product, MatchesSeamsWithinALimit) {
  write_product("two.obj", halves());
  const auto free = flatten_design("two.obj", "free", {"--json"}).json();
  const double most = free["patches"][0]["unfold"]["strain"]["max"];
  const std::string limit = std::to_string(80.0 * most) + "%";
  const auto json = planish({"flatten", "two.obj", "-o", "out", "--formats", "svg", "--json",
                             "--max-strain", limit})
                        .json();
  for (const auto& patch : json["patches"]) {
    EXPECT_TRUE(patch["limits_met"]) << patch["name"];
    EXPECT_TRUE(patch["unfold"]["match_seams"]) << patch["name"];
  }
  EXPECT_LT(json["seams"][0]["difference"], 1e-6);
}

TEST_F(Product, SaysHowUnequalSidesBecomeEqual) {
  write_product("two.obj", halves(8));
  const std::string advice = "without --no-match-seams they are as long as on the model";
  EXPECT_THAT(flatten_design("two.obj", "free", {"--unit", "m", "--no-match-seams"}).out,
              HasSubstr(advice));
  EXPECT_THAT(flatten_design("two.obj", "out", {"--unit", "m"}).out, Not(HasSubstr(advice)));
  const CliResult both = flatten_design("two.obj", "both", {"--match-seams", "--no-match-seams"});
  EXPECT_EQ(both.exit_code, k_exit_usage);
  EXPECT_THAT(both.err, HasSubstr("--match-seams and --no-match-seams do not go together"));
}

TEST_F(Product, GoesOnWithoutMatchingWhereAPieceCannotAndNamesIt) {
  // 1e8 times as long as wide: numbers cannot tell whether their ends keep their lengths.
  std::vector<NamedPatch> ribbons;
  for (const char* name : {"upper", "lower"}) {
    TriMesh ribbon = meshes::flat_grid(12, 2);
    const double y = ribbons.empty() ? 0.0 : 2.0;
    for (Vec3& p : ribbon.positions)
      p = {1e8 * p.x, p.y + y, 0.1 * p.x * (p.y + y)};
    ribbons.push_back({name, std::move(ribbon), {}});
  }
  write_product("ribbons.obj", ribbons);
  const CliResult run = flatten_design("ribbons.obj", "out");
  EXPECT_NE(run.exit_code, k_exit_failed) << run.err;
  EXPECT_THAT(run.err, HasSubstr("upper: its border cannot keep its lengths in the plane"));
  EXPECT_THAT(run.err, HasSubstr("lower: its border cannot keep its lengths in the plane"));
  EXPECT_TRUE(std::filesystem::exists("out/upper/pattern.svg"));
  EXPECT_EQ(flatten_design("ribbons.obj", "asked", {"--match-seams"}).exit_code, k_exit_failed);
}

/// What is sewn to a piece decides which of its edges keep their lengths.
TEST_F(Product, IsNotResumedWhereOtherPiecesAreSewnToIt) {
  const std::vector<NamedPatch> two = halves();
  write_product("left.obj", {two[0]});
  write_product("right.obj", {two[1]});
  const auto run = [&](const Names& inputs) {
    Names args = {"flatten"};
    args.insert(args.end(), inputs.begin(), inputs.end());
    for (const char* more : {"-o", "out", "--product", "--unit", "mm", "--formats", "svg", "--pick",
                             "1", "--resume", "--json"})
      args.emplace_back(more);
    return planish(args);
  };
  TriMesh far = two[1].mesh;
  for (Vec3& p : far.positions)
    p.z += 1000.0;
  write_product("far.obj", {{"right", far, {}}});
  EXPECT_THAT(run({"left.obj", "far.obj"}).err, Not(HasSubstr("from the earlier run")));
  EXPECT_THAT(run({"left.obj", "far.obj"}).err, HasSubstr("from the earlier run"));
  const CliResult sewn = run({"left.obj", "right.obj"});
  EXPECT_THAT(sewn.err, Not(HasSubstr("from the earlier run")));
  EXPECT_LT(sewn.json()["seams"][0]["difference"], 1e-6);
}

TEST_F(Product, FindsTheSeamsOfPatchesWithFewerVerticesInside) {
  write_product("two.obj", halves(12));
  const auto whole = flatten_product("two.obj", "whole", {"--json"}).json();
  const Names fewer = {"--json", "--remesh"};
  const auto result = flatten_product("two.obj", "out", fewer).json();
  ASSERT_EQ(result["seams"].size(), 1U);
  const auto& seam = result["seams"][0];
  EXPECT_EQ(seam["sides"][0]["vertices"], whole["seams"][0]["sides"][0]["vertices"]);
  EXPECT_EQ(seam["length_on_model"], whole["seams"][0]["length_on_model"]);
  EXPECT_LT(seam["difference"], 1e-9);
  EXPECT_LT(std::filesystem::file_size("out/left/processed.obj"),
            std::filesystem::file_size("whole/left/processed.obj"));
  Names again = fewer;
  again.push_back("--resume");
  EXPECT_EQ(flatten_product("two.obj", "out", again).json()["seams"], result["seams"]);
}

TEST_F(Product, GoesOnWhereOnePatchIsBad) {
  const NamedPatch fins = {"fins", meshes::fins(), {}};
  write_product("coat.obj", {sample("front", "dome", 300), fins, sample("back", "saddle", 300)});
  const CliResult result = flatten_product("coat.obj", "out");
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("error: 1 of 3 patches could not be flattened: fins\n"));
  const std::string reason = "more than two triangles";
  EXPECT_NE(result.err.find(reason), std::string::npos) << result.err;
  EXPECT_EQ(result.err.find(reason), result.err.rfind(reason)) << "given once: " << result.err;
  EXPECT_TRUE(std::filesystem::exists("out/front/pattern.svg"));
  EXPECT_TRUE(std::filesystem::exists("out/back/pattern.svg"));
  EXPECT_FALSE(std::filesystem::exists("out/fins"));
  const auto json = nlohmann::json::parse(content_of("out/garment.json"));
  EXPECT_EQ(json["patches"][1]["error"]["code"], "no_inner_vertex");
  EXPECT_TRUE(json["patches"][0]["error"].is_null());
}

TEST_F(Product, WritesNothingWhereEveryPatchIsBad) {
  write_product("fins.obj", {{"one", meshes::fins(), {}}, {"two", meshes::fins(), {}}});
  const CliResult result = flatten_product("fins.obj", "out", {"--json"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("error: 2 of 2 patches could not be flattened: one, two\n"));
  EXPECT_FALSE(std::filesystem::exists("out"));
  const auto json = result.json();
  EXPECT_EQ(json["patches"][0]["error"]["code"], "no_inner_vertex");
  EXPECT_TRUE(json["nesting"].is_null());
}

TEST_F(Product, SearchesForSeamsBetweenFilesOnlyOnRequest) {
  std::filesystem::create_directories("parts");
  for (const NamedPatch& half : halves())
    write_mesh("parts/" + half.name + ".obj", half.mesh);
  const CliResult batch = flatten_product("parts", "batch");
  EXPECT_EQ(batch.exit_code, k_exit_done) << batch.err;
  EXPECT_THAT(batch.out, HasSubstr("Each file by itself; --product searches for seams"));
  EXPECT_TRUE(nlohmann::json::parse(content_of("batch/garment.json"))["seams"].empty());
  const auto product = flatten_product("parts", "product", {"--product", "--json"}).json();
  ASSERT_EQ(product["seams"].size(), 1U);
  EXPECT_EQ(product["seams"][0]["sides"][1]["patch"], "right");
}

TEST_F(Product, TakesSeveralFilesLikeThoseOfAFolder) {
  std::filesystem::create_directories("parts");
  for (const NamedPatch& half : halves())
    write_mesh("parts/" + half.name + ".obj", half.mesh);
  const CliResult folder = flatten_product("parts", "folder", {"--product", "--json"});
  const Names more = {"parts/right.obj", "--json"};
  const CliResult files =
      flatten_product("parts/left.obj", "files", {more[0], "--product", "--json"});
  ASSERT_EQ(files.exit_code, k_exit_done) << files.err;
  EXPECT_EQ(files.json()["seams"], folder.json()["seams"]);
  EXPECT_EQ(files.json()["name"], "files");
  EXPECT_EQ(content_of("files/left/pattern.svg"), content_of("folder/left/pattern.svg"));
  EXPECT_TRUE(flatten_product("parts/left.obj", "batch", more).json()["seams"].empty());
}

TEST_F(Product, TellsFilesOfOneNameApart) {
  for (const char* folder : {"a", "b"}) {
    std::filesystem::create_directory(folder);
    write_mesh(std::string(folder) + "/Cuff.obj", make_shape("dome", 100));
  }
  write_mesh("cuff.ply", make_shape("saddle", 100));
  const CliResult run = planish({"flatten", "a/Cuff.obj", "b/Cuff.obj", "cuff.ply", "-o", "out",
                                 "--json", "--sweeps", "1", "--formats", "svg"});
  ASSERT_EQ(run.exit_code, k_exit_done) << run.err;
  const auto result = run.json();
  std::vector<std::string> names;
  for (const auto& patch : result["patches"])
    names.push_back(patch["name"]);
  EXPECT_THAT(names, ElementsAre("Cuff", "Cuff-2", "cuff-3"));
  EXPECT_EQ(result["patches"][1]["source"], "b/Cuff.obj");
  for (const std::string& name : names)
    EXPECT_TRUE(std::filesystem::exists("out/" + name + "/pattern.svg")) << name;
}

TEST_F(Product, RefusesSeveralFilesWithoutAFolderAndBesideAProductFile) {
  write_mesh("a.obj", make_shape("dome", 200));
  std::ofstream("suit.json") << R"({"pieces": [{"file": "a.obj"}]})";
  const CliResult nowhere = planish({"flatten", "a.obj", "a.obj"});
  EXPECT_EQ(nowhere.exit_code, k_exit_usage);
  EXPECT_THAT(nowhere.err, HasSubstr("--output FOLDER"));
  const CliResult described = planish({"flatten", "a.obj", "suit.json", "-o", "out"});
  EXPECT_EQ(described.exit_code, k_exit_usage);
  EXPECT_THAT(described.err, HasSubstr("suit.json"));
  EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST_F(Product, FindsTheSeamsWithinAFileOfABatch) {
  std::filesystem::create_directories("parts");
  write_product("parts/one.obj", halves());
  write_product("parts/two.obj", halves());
  const auto batch = flatten_product("parts", "batch", {"--json"}).json();
  EXPECT_EQ(batch["seams"].size(), 2U);
  EXPECT_EQ(flatten_product("parts", "all", {"--json", "--product"}).json()["seams"].size(), 6U);
}

TEST_F(Product, RefusesFlagsOfSeamsForABatch) {
  std::filesystem::create_directories("parts");
  for (const NamedPatch& half : halves())
    write_mesh("parts/" + half.name + ".obj", half.mesh);
  std::ofstream("seams.txt") << "* 50%\n";
  for (const Names& flag : {Names{"--seam-notches", "seams.txt"}, {"--seam-tolerance", "1mm"}}) {
    const CliResult result = flatten_product("parts", "out", flag);
    EXPECT_EQ(result.exit_code, k_exit_usage) << flag.front();
    EXPECT_THAT(result.err, HasSubstr(flag.front()));
    EXPECT_THAT(result.err, HasSubstr("--product"));
  }
  EXPECT_FALSE(std::filesystem::exists("out"));
  EXPECT_EQ(flatten_product("parts", "out", {"--product", "--seam-notches", "seams.txt"}).exit_code,
            k_exit_done);
}

TEST_F(Product, ReadsFoldersOfMeshFiles) {
  std::filesystem::create_directories("parts");
  write_mesh("parts/a.ply", make_shape("dome", 200));
  write_mesh("parts/b.obj", make_shape("saddle", 200));
  std::ofstream("parts/c.obj") << "v 0 0\n";
  std::ofstream("parts/readme.txt") << "no mesh\n";
  const CliResult result = flatten_product("parts", "out");
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("1 of 3 patches could not be flattened: c\n"));
  EXPECT_TRUE(std::filesystem::exists("out/a/flat.ply"));
  EXPECT_TRUE(std::filesystem::exists("out/b/flat.obj"));
  std::filesystem::create_directories("none");
  EXPECT_THAT(flatten_product("none", "out2").err, HasSubstr("no mesh file"));
}

TEST_F(Product, NotesTheSizeOfEachPieceThatIsUnusualUnlessTheUnitWasGiven) {
  std::vector<NamedPatch> pieces = {sample("small", "dome", 120), sample("other", "cylinder", 120)};
  write_product("usual.obj", pieces);
  for (NamedPatch& piece : pieces) {
    for (Vec3& p : piece.mesh.positions)
      p = 0.05 * p;
  }
  write_product("two.obj", pieces);
  const auto said_of = [](const Names& more) {
    Names args = {"flatten", "-o", "out", "--formats", "svg"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args).err;
  };
  const std::string said = said_of({"two.obj"});
  EXPECT_THAT(said, HasSubstr("note: small: the pattern is 22.1 mm long; "));
  EXPECT_THAT(said, HasSubstr("with --unit cm it would be 221 mm"));
  EXPECT_THAT(said, HasSubstr("note: other: the pattern is "));
  EXPECT_THAT(said_of({"two.obj", "--unit", "mm"}), testing::Not(HasSubstr("the pattern is ")));
  EXPECT_THAT(said_of({"usual.obj"}), testing::Not(HasSubstr("the pattern is ")));
}

TEST_F(Product, NamesTheModelsOfAFolderThatItCannotRead) {
  std::filesystem::create_directory("mixed");
  for (const char* name : {"mixed/b.step", "mixed/a.GLB", "mixed/notes.txt"})
    std::ofstream(name) << "x";
  const CliResult none = planish({"flatten", "mixed", "-o", "out"});
  EXPECT_EQ(none.exit_code, k_exit_failed);
  EXPECT_THAT(none.err, HasSubstr("; of a.GLB, b.step export a mesh as OBJ or STL"));
  write_mesh("mixed/c.obj", make_shape("cylinder", 120));
  const CliResult result = planish({"flatten", "mixed", "-o", "out", "--formats", "svg"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("note: mixed: skipped a.GLB, b.step, which cannot be read"));
  EXPECT_THAT(result.err, testing::Not(HasSubstr("notes.txt")));
}

TEST_F(Product, RefusesFlagsThatGoWithTheOtherKindOfInput) {
  std::ofstream("fixed.txt") << "0\n";
  EXPECT_EQ(flatten_product("coat.obj", "out", {"--fix", "fixed.txt"}).exit_code, k_exit_usage);
  EXPECT_EQ(flatten_product("panel.obj", "out", {"--resume"}).exit_code, k_exit_usage);
  EXPECT_FALSE(std::filesystem::exists("out"));
}

/// Asks to stop as soon as a word is written.
class StopAt : public std::stringbuf {
 public:
  StopAt(std::string word, std::atomic<bool>& stop) : word_(std::move(word)), stop_(stop) {}

 protected:
  int sync() override {
    if (str().find(word_) != std::string::npos) stop_ = true;
    return 0;
  }

 private:
  std::string word_;
  std::atomic<bool>& stop_;
};

/// All that has no times in it, of a folder.
std::vector<std::string> lasting_contents(const std::string& folder) {
  std::vector<std::string> paths, contents;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
    const std::string name = utf8_of(entry.path().filename());
    const bool is_timed = name == "report.json" || name == "report.html" || name == "job.json";
    if (entry.is_regular_file() && !is_timed) paths.push_back(utf8_of(entry.path()));
  }
  std::sort(paths.begin(), paths.end());
  for (const std::string& path : paths)
    contents.push_back(path.substr(folder.size()) + "\n" + content_of(path));
  return contents;
}

TEST_F(Product, ResumesAnInterruptedRunWithTheSameResult) {
  std::filesystem::create_directories("a");
  std::filesystem::create_directories("b");
  std::filesystem::copy_file("coat.obj", "a/coat.obj");
  std::filesystem::copy_file("coat.obj", "b/coat.obj");
  const auto here = std::filesystem::current_path();
  std::filesystem::current_path(here / "a");
  ASSERT_EQ(flatten_product("coat.obj", "out").exit_code, k_exit_done);

  std::filesystem::current_path(here / "b");
  std::atomic<bool> stop = false;
  StopAt buffer("strain rms", stop);
  std::ostringstream out;
  std::ostream err(&buffer);
  Names args = {"flatten", "coat.obj", "-o", "out", "--threads", "1"};
  args.insert(args.end(), k_svg.begin(), k_svg.end());
  EXPECT_EQ(run(args, out, err, {.err_is_terminal = false, .interrupted = &stop}),
            k_exit_interrupted);
  EXPECT_THAT(buffer.str(), HasSubstr("1 of 3 patches are done"));
  EXPECT_FALSE(std::filesystem::exists("out/garment.json"));
  // The largest goes first.
  ASSERT_TRUE(std::filesystem::exists("out/back_.._.._up/job.json"));
  EXPECT_FALSE(std::filesystem::exists("out/front"));
  const auto time = std::filesystem::last_write_time("out/back_.._.._up/report.json");

  const CliResult resumed = flatten_product("coat.obj", "out", {"--resume"});
  EXPECT_EQ(resumed.exit_code, k_exit_done) << resumed.err;
  EXPECT_THAT(resumed.err, HasSubstr("from the earlier run"));
  EXPECT_EQ(std::filesystem::last_write_time("out/back_.._.._up/report.json"), time);
  EXPECT_EQ(lasting_contents("out"), lasting_contents("../a/out"));
  std::filesystem::current_path(here);
}

TEST_F(Product, ResumesOnlyWhatIsOfTheSameJob) {
  ASSERT_EQ(flatten_product("coat.obj", "out").exit_code, k_exit_done);
  const auto kept = [](const std::string& err) {
    std::size_t count = 0;
    const std::string words = "from the earlier run";
    for (std::size_t at = err.find(words); at != std::string::npos; at = err.find(words, at + 1))
      ++count;
    return count;
  };
  EXPECT_EQ(kept(flatten_product("coat.obj", "out", {"--resume"}).err), 3U);
  EXPECT_EQ(kept(flatten_product("coat.obj", "out").err), 0U);
  // A file that is not as it was written.
  std::ofstream("out/front/pattern.svg", std::ios::app) << "<!-- touched -->";
  EXPECT_EQ(kept(flatten_product("coat.obj", "out", {"--resume"}).err), 2U);
  EXPECT_THAT(content_of("out/front/pattern.svg"), Not(HasSubstr("touched")));
  // Other options.
  EXPECT_EQ(kept(flatten_product("coat.obj", "out", {"--resume", "--unit", "cm"}).err), 0U);
  // Another mesh of one of them.
  ASSERT_EQ(flatten_product("coat.obj", "out").exit_code, k_exit_done);
  write_product("coat.obj", {sample("front", "dome", 230), sample("back/../../up", "saddle", 250),
                             sample("Front", "cylinder", 100)});
  EXPECT_EQ(kept(flatten_product("coat.obj", "out", {"--resume"}).err), 2U);
}

TEST(SafeNames, LeadNowhereElseAndAreAllDifferent) {
  EXPECT_THAT(safe_names({"a", "A", "a", "a-2"}), ElementsAre("a", "A-2", "a-3", "a-2-2"));
  EXPECT_THAT(
      safe_names({"..", ".", "", "../x", "/etc/passwd", "-o", "c:\\x", "Überzug"}),
      ElementsAre("patch", "patch-2", "patch-3", "_._x", "_etc_passwd", "_o", "c__x", "Überzug"));
  EXPECT_THAT(safe_names({"con", "LPT1.txt", "garment.json"}),
              ElementsAre("con_", "LPT1.txt_", "garment.json_"));
  EXPECT_THAT(safe_names({"layout.svg", "LAYOUT-1.PDF", "front.obj"}),
              ElementsAre("layout.svg_", "LAYOUT-1.PDF_", "front.obj"));
  // Not UTF-8, an overlong slash, a surrogate; marks that turn text or cannot be seen.
  EXPECT_THAT(safe_names({"a\xff", "\xc0\xaf", "\xed\xa0\x80",
                          "\xe2\x80\xae"
                          "fdp",
                          "\xc2\x9b"
                          "1"}),
              ElementsAre("a_", "__", "___", "___fdp", "__1"));
  EXPECT_EQ(safe_names({std::string(300, 'x')}).front().size(), 80U);
  EXPECT_EQ(safe_names({std::string(79, 'x') + "Ü"}).front().size(), 79U);
}

TEST(SafeNames, NumberManyThatAreAlikeQuickly) {
  // Trying every number for every name would take some 10^9 steps.
  const std::vector<std::string> safe = safe_names(std::vector<std::string>(50'000, "?"));
  EXPECT_EQ(safe.back(), "_-50000");
}

}  // namespace
}  // namespace planish::cli
