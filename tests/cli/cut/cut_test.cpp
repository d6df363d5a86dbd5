#include <algorithm>
#include <atomic>

#include <planish/io/read_mesh.h>
#include <planish/mesh/patch.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "mesh/split.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
}

class Cut : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_mesh("tube.obj", meshes::tube(12, 5));
    write_mesh("hill.obj", meshes::height_field(12, 8, [](double x, double y) {
                 return 4.0 - 0.1 * (x - 6.0) * (x - 6.0) - 0.1 * (y - 4.0) * (y - 4.0);
               }));
    write_text("seam.txt", "0 60\n");
    // Number 13 y + x at (x, y): from the middle of the lower side to the top, and right across.
    write_text("dart.txt", "6 58  # to the top\n");
    write_text("across.txt", "6 58 110\n");
  }
};

const Names k_fast = {"--pick", "3", "--formats", "svg"};

CliResult flatten_with(const std::string& input, const Names& more) {
  Names args = {"flatten", input, "-o", "out"};
  args.insert(args.end(), k_fast.begin(), k_fast.end());
  args.insert(args.end(), more.begin(), more.end());
  return planish(args);
}

/// Every piece of a product has a pattern, without flips and overlap.
void expect_laid_flat(const CliResult& result, std::size_t pieces) {
  const auto patches = result.json()["patches"];
  ASSERT_EQ(patches.size(), pieces);
  for (const auto& patch : patches) {
    EXPECT_EQ(patch["unfold"]["flipped_triangles"], 0);
    EXPECT_FALSE(patch["unfold"]["overlaps"]);
  }
}

TEST_F(Cut, LetsATubeBeLaidFlat) {
  EXPECT_EQ(planish({"unfold", "tube.obj", "-o", "a.svg"}).exit_code, k_exit_failed);
  const CliResult result =
      planish({"unfold", "tube.obj", "-o", "a.svg", "--cut", "seam.txt", "--json", "--unit", "cm"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("seam.txt: cut open along 5 edges, 50.0 mm"));
  const auto json = result.json();
  EXPECT_EQ(json["cut"]["edges"], 5);
  EXPECT_EQ(json["cut"]["length"], 5.0);
  EXPECT_EQ(json["cut"]["jag"], 1.0);
  EXPECT_LT(json["strain"]["max"], 1e-9);
  EXPECT_FALSE(planish({"unfold", "panel.obj", "-o", "b.svg", "--json"}).json().contains("cut"));
}

TEST_F(Cut, LeavesSidesOfOtherLengthsAndSaysSo) {
  TriMesh tube = meshes::tube(24, 8);
  // A bulge beside the seam: its near side is stretched, the other one is not.
  for (const Index v : {3 * 24 + 1, 4 * 24 + 1, 5 * 24 + 1, 4 * 24 + 2})
    tube.positions[v] = 1.4 * tube.positions[v];
  write_mesh("bulge.obj", tube);
  write_text("bulge.txt", "0 192\n");
  const Names unfold = {"unfold", "bulge.obj", "-o", "a.svg", "--cut", "bulge.txt", "--unit", "cm"};
  const CliResult result = planish(unfold);
  EXPECT_THAT(result.err, HasSubstr("two stretches of the border meet on the model"));
  EXPECT_THAT(result.err, HasSubstr("--match-seams makes such stretches equally long"));
  Names matched = unfold;
  matched.emplace_back("--match-seams");
  EXPECT_THAT(planish(matched).err, Not(HasSubstr("two stretches")));
  EXPECT_THAT(planish({"unfold", "tube.obj", "-o", "a.svg", "--cut", "seam.txt"}).err,
              Not(HasSubstr("two stretches")));
}

TEST_F(Cut, LeavesOutLinesThatMeetNothing) {
  write_text("inside.obj", "v 3 3 2.5\nv 3 5 3\nv 4 4 3\nl 1 2\nl 3 1\n");
  const CliResult inside = planish({"flatten", "hill.obj", "-o", "out", "--unit", "cm", "--json",
                                    "--cut", "plane x=6.3", "--cut", "inside.obj"});
  EXPECT_EQ(inside.exit_code, k_exit_done) << inside.err;
  EXPECT_THAT(inside.err, HasSubstr("inside.obj:4 meets neither the border nor another cut"));
  expect_laid_flat(inside, 2);
}

TEST_F(Cut, TellsOfDrawnLinesThatEndInside) {
  write_text("two.obj", "v 6 0 2.4\nv 6.3 4.2 4\nl 1 2\nv 2 0 0.8\nv 2.3 3.2 2.4\nl 3 4\n");
  const auto told = [&](const std::string& lines) {
    return planish({"unfold", "hill.obj", "-o", "a.svg", "--unit", "cm", "--cut", lines}).err;
  };
  EXPECT_THAT(told("two.obj"), HasSubstr("the end of two.obj:3 stays free, "));
  EXPECT_THAT(told("two.obj"), HasSubstr(" from the border; so does that of 1 other line"));
  write_text("across.obj", "v 6 0 2.4\nv 6 8 2.4\nl 1 2\n");
  EXPECT_THAT(flatten_with("hill.obj", {"--cut", "across.obj"}).err, Not(HasSubstr("free")));
}

TEST_F(Cut, TakesADrawing) {
  write_text("seam.obj", "v 1.1 0 0\nv 1 0 5.2\nl 1 2\n");
  const CliResult result = planish({"unfold", "tube.obj", "-o", "a.svg", "--cut", "seam.obj"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("what is drawn is at most 0.200 mm from the surface"));
  const CliResult along =
      planish({"unfold", "tube.obj", "-o", "a.svg", "--cut", "seam.obj", "--cut-along", "edges"});
  EXPECT_THAT(along.err, HasSubstr("what is drawn is at most 0.200 mm from the vertices"));
}

TEST_F(Cut, WithADartGivesAPatternOfLessStrain) {
  const auto whole = flatten_with("hill.obj", {"--json"}).json();
  EXPECT_FALSE(whole.contains("cut"));
  const CliResult result =
      flatten_with("hill.obj", {"--json", "--cut", "dart.txt", "--cut-along", "edges"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto json = result.json();
  EXPECT_EQ(json["cut"]["edges"], 4);
  EXPECT_LT(json["unfold_before"]["strain"]["rms"],
            0.9 * whole["unfold_before"]["strain"]["rms"].get<double>());
  EXPECT_EQ(nlohmann::json::parse(content_of("out/report.json"))["cut"], json["cut"]);
}

TEST_F(Cut, KeepsNumbersForOtherFlags) {
  write_text("top.txt", "58\n");
  const CliResult result =
      planish({"evolve", "hill.obj", "-o", "a.obj", "--cut", "dart.txt", "--cut-along", "edges",
               "--fix", "top.txt", "--sweeps", "2", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["cut"]["edges"], 4);
  const TriMesh before = read_mesh("hill.obj").mesh, after = read_mesh("a.obj").mesh;
  EXPECT_EQ(after.positions.size(), before.positions.size() + 4);
  EXPECT_EQ(after.positions[58], before.positions[58]);
  // The border is what the cut made of it, and stays.
  EXPECT_EQ(after.positions[before.positions.size()], before.positions[6]);
}

TEST_F(Cut, MakesPiecesThatTheMakerNames) {
  const Names cut = {"--json", "--cut", "across.txt", "--rename"};
  const auto with = [&](const std::string& names) {
    Names more = cut;
    more.push_back(names);
    return flatten_with("hill.obj", more);
  };
  const CliResult result = with("hill-1=left side,hill-2=right side");
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto json = result.json();
  EXPECT_EQ(json["patches"][0]["name"], "left side");
  EXPECT_EQ(json["patches"][1]["name"], "right side");
  EXPECT_FALSE(content_of("out/left_side/pattern.svg").empty());
  EXPECT_THAT(with("hill-3=back").err, HasSubstr("no piece is called \"hill-3\""));
  EXPECT_THAT(with("hill-1=hill-2").err, HasSubstr("two pieces would be called \"hill-2\""));
  EXPECT_THAT(with("hill-1=").err, HasSubstr("needs OLD=NEW"));
  EXPECT_THAT(with("hill-1=a,hill-1=b").err, HasSubstr("names \"hill-1\" twice"));
  EXPECT_EQ(with("hill-1").exit_code, k_exit_usage);
  EXPECT_THAT(planish({"flatten", "panel.obj", "--rename", "panel=front"}).err,
              HasSubstr("goes with several patches"));
}

TEST_F(Cut, ThroughThePatchMakesAProduct) {
  const CliResult result = flatten_with(
      "hill.obj", {"--json", "--cut", "across.txt", "--cut-along", "edges", "--match-seams"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("hill.obj: the cut makes 2 patches"));
  const auto json = result.json();
  ASSERT_EQ(json["patches"].size(), 2U);
  EXPECT_EQ(json["patches"][0]["name"], "hill-1");
  ASSERT_EQ(json["seams"].size(), 1U);
  const auto& seam = json["seams"][0];
  EXPECT_EQ(seam["sides"][0]["vertices"], 9);
  EXPECT_LT(seam["difference"], 1e-9);
  EXPECT_EQ(json["cut"]["edges"], 8);
  EXPECT_NEAR(json["cut"]["length"].get<double>(), seam["length_on_model"].get<double>(), 1e-9);
  EXPECT_EQ(nlohmann::json::parse(content_of("out/garment.json"))["cut"], json["cut"]);
  EXPECT_TRUE(std::filesystem::exists("out/hill-2/pattern.svg"));
}

TEST_F(Cut, IsRefusedWhereItCannotBe) {
  const auto error_of = [](const std::string& text) {
    write_text("bad.txt", text);
    const CliResult result =
        planish({"unfold", "hill.obj", "-o", "a.svg", "--json", "--cut", "bad.txt"});
    EXPECT_EQ(result.exit_code, k_exit_failed) << text;
    EXPECT_FALSE(std::filesystem::exists("a.svg"));
    return result.json()["error"];
  };
  const auto along = error_of("6 19\n# the border\n5 6\n");
  EXPECT_EQ(along["code"], "misplaced_cut");
  EXPECT_EQ(along["line"], 3);
  EXPECT_EQ(along["path"], "bad.txt");
  EXPECT_EQ(along["first"], 5);
  EXPECT_EQ(error_of("57 58 59\n")["code"], "misplaced_cut");
  EXPECT_EQ(error_of("58\n")["code"], "misplaced_cut");
  EXPECT_EQ(error_of("6 999\n")["code"], "index_out_of_range");
  EXPECT_EQ(error_of("6 x\n")["code"], "bad_number");
  EXPECT_EQ(planish({"unfold", "hill.obj", "-o", "a.svg", "--cut", "none.txt"}).exit_code,
            k_exit_failed);
}

TEST_F(Cut, GoesWithOnePatchOnly) {
  write_mesh("two.obj", meshes::side_by_side(meshes::fan(6), meshes::fan(6)));
  const CliResult result = flatten_with("two.obj", {"--cut", "dart.txt"});
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_THAT(result.err, HasSubstr("--cut goes with one patch only"));
  EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST_F(Cut, GoesThroughTriangles) {
  // Not along any edge of the grid, and 0.3 short of its upper side.
  write_text("line.obj", "v 3.3 -9 1\nv 4.7 7.7 1\nl 1 2\n");
  const CliResult result = flatten_with("hill.obj", {"--json", "--cut", "line.obj"});
  EXPECT_EQ(result.exit_code, k_exit_failed) << "its ends are more than three edges away";
  write_text("line.obj", "v 3.3 -0.5 2.2\nv 4.7 7.7 2.4\nl 1 2\n");
  const CliResult cut = flatten_with("hill.obj", {"--json", "--cut", "line.obj"});
  EXPECT_EQ(cut.exit_code, k_exit_done) << cut.err;
  EXPECT_THAT(cut.err, HasSubstr("the end of line.obj:3 is"));
  EXPECT_THAT(cut.err, HasSubstr("from the border; joined"));
  const auto json = cut.json();
  ASSERT_EQ(json["patches"].size(), 2U);
  ASSERT_EQ(json["seams"].size(), 1U);
  EXPECT_GT(json["seams"][0]["sides"][0]["vertices"], 9);
}

TEST_F(Cut, TakesPlanesCreasesAndACutGraph) {
  const auto pieces = [](const std::string& input, const Names& cuts) {
    Names more = {"--json"};
    for (const std::string& cut : cuts)
      more.insert(more.end(), {"--cut", cut});
    const CliResult result = flatten_with(input, more);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    return result.json().contains("patches") ? result.json()["patches"].size() : 1U;
  };
  EXPECT_EQ(pieces("hill.obj", {"plane x=6.3"}), 2U);
  EXPECT_EQ(pieces("hill.obj", {"plane x=6.3", "plane y=0.4cm"}), 4U);
  EXPECT_EQ(pieces("tube.obj", {"open"}), 1U);
  write_mesh("roof.obj",
             meshes::height_field(8, 6, [](double x, double) { return 4.0 - std::abs(x - 4.0); }));
  EXPECT_EQ(pieces("roof.obj", {"creases 60deg"}), 2U);
  write_mesh("ring.obj", meshes::torus(12, 24));
  const CliResult ring = planish({"unfold", "ring.obj", "-o", "a.svg", "--cut", "open"});
  EXPECT_EQ(ring.exit_code, k_exit_done) << ring.err;
  const auto error_of = [](const std::string& cut) {
    return planish({"unfold", "hill.obj", "-o", "a.svg", "--cut", cut}).err;
  };
  EXPECT_THAT(error_of("plane w=1"), HasSubstr("a plane is \"plane x=0\""));
  EXPECT_THAT(error_of("plane x=99"), HasSubstr("the plane does not meet the mesh"));
  EXPECT_THAT(error_of("creases 170deg"), HasSubstr("has no creases of 170deg"));
  EXPECT_THAT(error_of("creases 0"), HasSubstr("--cut creases"));
}

TEST_F(Cut, OpensEveryPartOfAnyTopology) {
  const TriMesh ring = meshes::torus(12, 24);
  write_mesh("two.obj", meshes::side_by_side(ring, meshes::tube(8, 3)));
  const CliResult two = planish({"flatten", "two.obj", "-o", "out", "--formats", "svg", "--unit",
                                 "cm", "--cut", "open", "--json"});
  EXPECT_EQ(two.exit_code, k_exit_done) << two.err;
  EXPECT_THAT(two.err, HasSubstr("--cut open: cut along 2 lines, "));
  expect_laid_flat(two, 2);
  write_mesh("ring.obj", ring);
  const CliResult along = planish(
      {"unfold", "ring.obj", "-o", "a.obj", "--cut", "open", "--cut-along", "edges", "--json"});
  EXPECT_EQ(along.exit_code, k_exit_done) << along.err;
  EXPECT_EQ(read_mesh("a.obj").mesh.triangles.size(), ring.triangles.size());
  const CliResult as_is = planish({"unfold", "ring.obj", "-o", "a.obj"});
  EXPECT_EQ(as_is.exit_code, k_exit_failed);
  EXPECT_THAT(as_is.err, HasSubstr("--cut open"));
}

TEST_F(Cut, OpensWhatOtherLinesLeave) {
  write_mesh("ring.obj", meshes::torus(12, 24));
  const CliResult result =
      planish({"flatten", "ring.obj", "-o", "out", "--formats", "svg", "--unit", "cm", "--cut",
               "plane x=0", "--cut", "open", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["patches"].size(), 2U);
}

TEST_F(Cut, GoesRoundWhatIsToBeAvoided) {
  const auto length_of = [](const Names& more) {
    Names args = {"unfold", "tube.obj", "-o", "a.svg", "--cut", "open", "--json"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args).json()["cut"]["length"].get<double>();
  };
  EXPECT_NEAR(length_of({}), 5.0, 1e-9);
  // A ring around the tube but for one place.
  write_text("avoid.txt", "24 25 26 27 28 29 30 31 32 33 34\n");
  EXPECT_NEAR(length_of({"--avoid", "avoid.txt"}), 5.0, 1e-9);
  const CliResult idle = planish({"unfold", "tube.obj", "-o", "a.svg", "--avoid", "avoid.txt"});
  EXPECT_EQ(idle.exit_code, k_exit_usage);
  EXPECT_THAT(idle.err, HasSubstr("it needs --cut open"));
}

TEST_F(Cut, NumbersTheSidesOfADart) {
  ASSERT_EQ(flatten_with("hill.obj", {"--cut", "dart.txt", "--unit", "cm"}).exit_code, k_exit_done);
  const std::string sheet = content_of("out/pattern.svg");
  const std::size_t first = sheet.find(">seam 1<");
  ASSERT_NE(first, std::string::npos);
  EXPECT_NE(sheet.find(">seam 1<", first + 1), std::string::npos) << "on either side";
  EXPECT_THAT(sheet, Not(HasSubstr("seam 2")));
}

class SuggestCuts : public Cut {};

TEST_F(SuggestCuts, GivesCutsThatHaveTheStrainThatItTells) {
  const CliResult result =
      planish({"suggest-cuts", "hill.obj", "-o", "cuts.txt", "--apply", "cut.obj", "--picture",
               "cuts.svg", "--max-strain", "4%", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto json = result.json();
  EXPECT_TRUE(json["met"]);
  EXPECT_EQ(json["stop"], "strain_met");
  EXPECT_GT(json["strain_before"]["max"], 0.04);
  EXPECT_LE(json["strain"]["max"], 0.04);
  ASSERT_FALSE(json["cuts"].empty());
  EXPECT_EQ(json["cuts"][0]["kind"], "dart");
  EXPECT_EQ(json["files"]["cuts"], "cuts.txt");

  const auto unfolded = planish({"unfold", "hill.obj", "-o", "a.obj", "--cut", "cuts.txt",
                                 "--max-strain", "4%", "--json"})
                            .json();
  EXPECT_EQ(unfolded["strain"], json["strain"]);
  EXPECT_EQ(unfolded["cut"]["edges"], json["edges"]);
  EXPECT_EQ(unfolded["cut"]["length"], json["length"]);
  const auto applied =
      planish({"unfold", "cut.obj", "-o", "b.obj", "--max-strain", "4%", "--json"}).json();
  EXPECT_EQ(applied["strain"], json["strain"]);
  EXPECT_EQ(content_of("a.obj"), content_of("b.obj"));
  EXPECT_THAT(content_of("cuts.svg"), HasSubstr("suggested"));
}

TEST_F(SuggestCuts, TellsInWordsAndWritesNothingUnasked) {
  const CliResult met = planish({"suggest-cuts", "hill.obj", "--max-strain", "4%"});
  EXPECT_EQ(met.exit_code, k_exit_done) << met.err;
  EXPECT_THAT(met.out, HasSubstr("dart, "));
  EXPECT_THAT(met.out, HasSubstr("Met with these cuts: no edge of the pattern"));
  const CliResult leather =
      planish({"suggest-cuts", "hill.obj", "--material", "leather", "--max-cuts", "1"});
  EXPECT_THAT(leather.out, HasSubstr("99 % of the pattern's area is still strained by up to"));
  const CliResult missed =
      planish({"suggest-cuts", "hill.obj", "--max-strain", "0.01%", "--max-cuts", "1"});
  EXPECT_EQ(missed.exit_code, k_exit_done);
  EXPECT_THAT(missed.out, HasSubstr("Not met: an edge of the pattern is still strained by"));
  EXPECT_THAT(missed.out, HasSubstr("all darts of --max-cuts are there"));
  EXPECT_THAT(missed.out, HasSubstr("You can allow more darts (--max-cuts), take a material"));
  EXPECT_THAT(met.out, Not(HasSubstr("You can")));
  EXPECT_THAT(planish({"suggest-cuts", "tube.obj"}).out, HasSubstr("seam, 5.000 mm"));
  std::istringstream lines(met.out + missed.out);
  for (std::string line; std::getline(lines, line);)
    EXPECT_LE(line.size(), 80U) << line;
  EXPECT_THAT(names(), ElementsAre("across.txt", "dart.txt", "hill.obj", "panel.obj", "seam.txt",
                                   "tube.obj"));
}

TEST_F(SuggestCuts, RefusesWhatMakesNoSense) {
  const auto code_of = [](const Names& more) {
    Names args = {"suggest-cuts", "hill.obj"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args).exit_code;
  };
  EXPECT_EQ(code_of({"--max-strain", "0"}), k_exit_usage);
  EXPECT_EQ(code_of({"--max-strain", "1%", "--material", "leather"}), k_exit_usage);
  EXPECT_EQ(code_of({"--max-strain", "2mm"}), k_exit_usage);
  EXPECT_EQ(code_of({"--max-cuts", "-1"}), k_exit_usage);
  EXPECT_EQ(code_of({"-o", "a.obj", "--apply", "a.obj"}), k_exit_usage);
  EXPECT_EQ(code_of({"--picture", "a.png"}), k_exit_failed);
  EXPECT_EQ(code_of({"--apply", "a.txt"}), k_exit_failed);
  write_mesh("ring.obj", meshes::torus(8, 12));
  const CliResult ring = planish({"suggest-cuts", "ring.obj", "--max-cuts", "0", "--json"});
  ASSERT_EQ(ring.json()["cuts"].size(), 2U) << "a handle needs two";
  EXPECT_EQ(ring.json()["cuts"][1]["kind"], "seam");
}

TEST_F(SuggestCuts, CanBeInterrupted) {
  std::atomic<bool> stop = true;
  const CliResult result = planish({"suggest-cuts", "hill.obj", "-o", "cuts.txt"},
                                   {.err_is_terminal = false, .interrupted = &stop});
  EXPECT_EQ(result.exit_code, k_exit_interrupted);
  EXPECT_FALSE(std::filesystem::exists("cuts.txt"));
}

}  // namespace
}  // namespace planish::cli
