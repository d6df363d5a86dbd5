#include <algorithm>

#include <planish/io/read_mesh.h>
#include <planish/mesh/patch.h>

#include <gmock/gmock.h>

#include "cli_run.h"

namespace planish::cli {
namespace {

using testing::Contains;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class Verbs : public CliTest {};

TEST_F(Verbs, MeasureTellsFiguresAndWritesNothing) {
  const CliResult result = planish({"measure", "panel.obj"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.err, "");
  for (const char* word :
       {"vertices", "e_max", "sum_abs_defect", "bending", "ruling defect", "flattenable"}) {
    EXPECT_THAT(result.out, HasSubstr(word));
  }
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

TEST_F(Verbs, MeasureHasTheKeysOfTheContract) {
  const auto json = planish({"measure", "panel.obj", "--json"}).json();
  for (const char* key : {"vertices",       "triangles",
                          "inner_vertices", "components",
                          "boundary_loops", "euler_characteristic",
                          "e_max",          "e_avg",
                          "energy",         "sum_abs_defect",
                          "min_angle",      "roughness",
                          "flattenable",    "extent",
                          "area",           "border_length",
                          "bending",        "mean_curvature",
                          "ruling_defect",  "self_intersections",
                          "obstruction",    "problems"}) {
    EXPECT_TRUE(json.contains(key)) << key;
  }
}

TEST_F(Verbs, MeasureTellsSizesInMillimetresOfTheUnitGiven) {
  const auto json = planish({"measure", "panel.obj", "--json"}).json();
  const double area = json["area"].get<double>();
  const auto shown = [&](const std::string& unit, const std::string& name) {
    const std::string text = planish({"measure", "panel.obj", "--unit", unit}).out;
    const std::size_t at = text.find(name);
    return at == std::string::npos ? 0.0 : std::stod(text.substr(at + name.size()));
  };
  EXPECT_NEAR(shown("cm", "area "), area, 1e-3 * area);
  EXPECT_NEAR(shown("mm", "area "), 0.01 * area, 1e-5 * area);
  EXPECT_NEAR(shown("m", "area "), 1e4 * area, 10.0 * area);
  EXPECT_NEAR(shown("cm", "border length "), 10.0 * json["border_length"].get<double>(), 0.1);
  EXPECT_THAT(planish({"measure", "panel.obj", "--unit", "in"}).out, HasSubstr(" in^2\n"));
  const CliResult several = planish({"measure", "panel.obj", "panel.obj", "--unit", "m"});
  EXPECT_EQ(several.exit_code, k_exit_usage);
  EXPECT_THAT(several.err, HasSubstr("flag --unit goes with one file only"));
}

TEST_F(Verbs, TellAtOnceWhatABorderForbids) {
  write_mesh("dome.obj", make_shape("dome", 300));
  const CliResult measured = planish({"measure", "dome.obj"});
  EXPECT_EQ(measured.exit_code, k_exit_done);
  EXPECT_EQ(measured.err, "");
  EXPECT_THAT(measured.out, HasSubstr("must go at least"));
  EXPECT_THAT(measured.out, HasSubstr("Advice: the border is flat and convex"));
  EXPECT_EQ(planish({"measure", "dome.obj", "--json"}).json()["obstruction"]["blocked"], true);

  const Names evolve = {"evolve", "dome.obj", "-o", "out.obj", "--sweeps", "1"};
  const Names flatten = {"flatten", "dome.obj", "-o", "folder", "--pick", "5"};
  for (const Names& verb : {evolve, flatten}) {
    const CliResult result = planish(verb);
    EXPECT_EQ(result.exit_code, k_exit_done);
    EXPECT_THAT(result.err, StartsWith("note: the border is flat and convex"));
  }
  EXPECT_THAT(content_of("folder/report.html"), HasSubstr("put in a dart or a cut"));
}

TEST_F(Verbs, SayNothingOfABorderThatForbidsNothing) {
  EXPECT_THAT(planish({"measure", "panel.obj"}).out, Not(HasSubstr("Advice")));
  EXPECT_THAT(planish({"evolve", "panel.obj", "-o", "out.obj", "--sweeps", "1"}).err,
              Not(HasSubstr("border")));
  write_mesh("closed.stl", TriMesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                                   {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}});
  const CliResult closed = planish({"measure", "closed.stl", "--json"});
  EXPECT_EQ(closed.json()["obstruction"], nullptr);
}

TEST_F(Verbs, EvolveKeepsTrianglesOrderAndBorder) {
  const CliResult result = planish({"evolve", "panel.obj", "-o", "out.obj", "--sweeps", "3"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  const TriMesh before = read_mesh("panel.obj").mesh;
  const TriMesh after = read_mesh("out.obj").mesh;
  EXPECT_EQ(before.triangles, after.triangles);
  ASSERT_EQ(before.positions.size(), after.positions.size());
  const Patch patch(before);
  std::size_t moved = 0;
  for (Index v = 0; v < before.positions.size(); ++v) {
    const bool same = before.positions[v] == after.positions[v];
    EXPECT_TRUE(same || patch.is_inner(v)) << v;
    moved += same ? 0 : 1;
  }
  EXPECT_GT(moved, 0U);
}

TEST_F(Verbs, EvolveTellsItsRunAndWritesTheHistory) {
  const auto json = planish({"evolve", "panel.obj", "-o", "out.ply", "--sweeps", "3", "--history",
                             "history.csv", "--json"})
                        .json();
  EXPECT_EQ(json["method"], "controllable");
  EXPECT_EQ(json["sweeps"], 3);
  EXPECT_EQ(json["history"].size(), 3U);
  EXPECT_LT(json["after"]["energy"], json["before"]["energy"]);
  EXPECT_THAT(names(), ElementsAre("history.csv", "out.ply", "panel.obj"));
  const std::string csv = content_of("history.csv");
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 4);
}

TEST_F(Verbs, EvolveTakesTheOptionsOfItsMethod) {
  const auto classical = planish({"evolve", "panel.obj", "-o", "out.obj", "--method", "classical",
                                  "--lambda", "0.25", "--order", "simultaneous", "--json"});
  EXPECT_EQ(classical.exit_code, k_exit_done) << classical.err;
  EXPECT_EQ(classical.json()["method"], "classical");
  const auto negative = planish({"evolve", "panel.obj", "-o", "out.obj", "--lambda-min", "-1",
                                 "--min-angle", "2", "--max-deviation=.5"});
  EXPECT_EQ(negative.exit_code, k_exit_done) << negative.err;
  const auto other = planish(
      {"evolve", "panel.obj", "-o", "out.obj", "--solver", "trust_region", "--sweeps=2", "--json"});
  EXPECT_EQ(other.json()["options"]["solver"], "trust_region");
}

TEST_F(Verbs, EvolveMayReplaceItsInput) {
  const std::string before = content_of("panel.obj");
  EXPECT_EQ(planish({"evolve", "panel.obj", "-o", "panel.obj"}).exit_code, k_exit_done);
  EXPECT_NE(content_of("panel.obj"), before);
  EXPECT_THAT(names(), ElementsAre("panel.obj"));
}

TEST_F(Verbs, EvolveGivesTheSameOnAnyNumberOfThreads) {
  planish({"evolve", "panel.obj", "-o", "one.obj", "--threads", "1"});
  planish({"--threads", "3", "evolve", "panel.obj", "-o", "three.obj"});
  EXPECT_EQ(content_of("one.obj"), content_of("three.obj"));
}

TEST_F(Verbs, UnfoldWritesASheetOrAFlatMesh) {
  const CliResult sheet = planish({"unfold", "panel.obj", "-o", "p.svg", "--unit", "cm", "--json"});
  EXPECT_EQ(sheet.exit_code, k_exit_done) << sheet.err;
  EXPECT_EQ(sheet.json()["unit"], "cm");
  EXPECT_EQ(sheet.json()["flipped_triangles"], 0);
  EXPECT_THAT(content_of("p.svg"), HasSubstr("<svg"));

  const CliResult mesh = planish({"unfold", "panel.obj", "-o", "flat.OFF"});
  EXPECT_EQ(mesh.exit_code, k_exit_done) << mesh.err;
  EXPECT_THAT(mesh.out, HasSubstr("strain"));
  const TriMesh flat = read_mesh("flat.OFF").mesh;
  EXPECT_EQ(flat.triangles, read_mesh("panel.obj").mesh.triangles);
  for (const Vec3& p : flat.positions)
    EXPECT_EQ(p.z, 0.0);
}

TEST_F(Verbs, UnfoldWritesWhatTheExtensionNames) {
  for (const auto& [output, head] :
       {std::pair{"p.dxf", "0\nSECTION"}, {"p.PDF", "%PDF-1.6"}, {"p.plt", "IN;"}}) {
    const CliResult result = planish({"unfold", "panel.obj", "-o", output});
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    EXPECT_THAT(content_of(output), StartsWith(head));
  }
  const Names tiled = {"unfold", "panel.obj", "-o", "t.pdf", "--paper", "letter"};
  EXPECT_EQ(planish(tiled).exit_code, k_exit_done);
  EXPECT_THAT(content_of("t.pdf"), HasSubstr("(A1: row 1 of "));
}

TEST_F(Verbs, SaysWhereAPlotFileReachesBeyond16Bits) {
  const std::string note = "the .plt file reaches beyond 819 mm";
  EXPECT_THAT(planish({"unfold", "panel.obj", "-o", "p.plt"}).err, Not(HasSubstr(note)));
  EXPECT_THAT(planish({"unfold", "panel.obj", "-o", "p.plt", "--unit", "m"}).err, HasSubstr(note));
  EXPECT_THAT(planish({"unfold", "panel.obj", "-o", "p.svg", "--unit", "m"}).err,
              Not(HasSubstr(note)));
}

TEST_F(Verbs, UnfoldTakesOtherNamesForLayersAndStrokesForLetters) {
  planish({"unfold", "panel.obj", "-o", "p.dxf", "--dxf-layers", "cut=KNIFE,label=PEN", "--text",
           "strokes"});
  const std::string dxf = content_of("p.dxf");
  EXPECT_THAT(dxf, HasSubstr("\nKNIFE\n"));
  EXPECT_THAT(dxf, HasSubstr("\nPEN\n"));
  EXPECT_THAT(dxf, Not(HasSubstr("\ncut\n")));
  EXPECT_THAT(dxf, Not(HasSubstr("\nTEXT\n")));
}

TEST_F(Verbs, UnfoldTellsWhichFormatsAreSupported) {
  for (const char* output : {"p.dwg", "p", "p.svgz"}) {
    const CliResult result = planish({"unfold", "panel.obj", "-o", output, "--json"});
    EXPECT_EQ(result.exit_code, k_exit_failed);
    EXPECT_EQ(result.json()["error"]["code"], "unsupported_format");
    EXPECT_THAT(result.err, HasSubstr("use .svg, .dxf, .pdf or .plt, or .obj, .ply, .stl or .off"));
  }
}

TEST_F(Verbs, FlattenWritesTheWholeFolder) {
  const CliResult result =
      planish({"flatten", "panel.obj", "-o", "out/folder", "--pick", "5", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(
      names(),
      ElementsAre("out", "out/folder", "out/folder/as-designed.dxf", "out/folder/as-designed.pdf",
                  "out/folder/as-designed.svg", "out/folder/flat.obj", "out/folder/pattern.dxf",
                  "out/folder/pattern.pdf", "out/folder/pattern.svg", "out/folder/processed.obj",
                  "out/folder/report.html", "out/folder/report.json", "panel.obj"));
  const auto json = result.json();
  EXPECT_TRUE(json["evolve"].is_object());
  EXPECT_TRUE(json["unfold"].is_object());
  EXPECT_EQ(json["files"]["processed"], "out/folder/processed.obj");
  EXPECT_EQ(json["files"]["report_html"], "out/folder/report.html");
  EXPECT_EQ(json["files"]["pattern"], "out/folder/pattern.svg");
  EXPECT_EQ(json["files"]["pattern_dxf"], "out/folder/pattern.dxf");
  EXPECT_EQ(json["files"]["pattern_pdf"], "out/folder/pattern.pdf");
  EXPECT_EQ(json["files"]["as_designed"], "out/folder/as-designed.svg");
  EXPECT_EQ(json["files"]["as_designed_dxf"], "out/folder/as-designed.dxf");
  EXPECT_EQ(json["files"].size(), 10U);
  EXPECT_EQ(json, nlohmann::json::parse(content_of("out/folder/report.json")));
}

TEST_F(Verbs, FlattenKeepsTheDesignUnlessAskedForMore) {
  const CliResult result = planish({"flatten", "panel.obj", "-o", "out", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.err, "");
  EXPECT_EQ(read_mesh("out/processed.obj").mesh.positions, read_mesh("panel.obj").mesh.positions);
  EXPECT_THAT(names(), ElementsAre("out", "out/flat.obj", "out/pattern.dxf", "out/pattern.pdf",
                                   "out/pattern.svg", "out/processed.obj", "out/report.html",
                                   "out/report.json", "panel.obj"));
  const auto json = result.json();
  EXPECT_EQ(json["evolve"]["method"], "none");
  EXPECT_EQ(json["evolve"]["history"], nlohmann::json::array());
  EXPECT_EQ(json["evolve"]["deviation"]["max"], 0.0);
  EXPECT_LT(json["unfold"]["strain"]["p99"], json["unfold"]["unlimited_strain"]["p99"]);
  const auto least = planish({"flatten", "panel.obj", "-o", "out", "--least-stretch", "--json"});
  for (const char* figure : {"max", "p99", "rms"}) {
    EXPECT_NEAR(least.json()["unfold"]["strain"][figure],
                json["unfold"]["unlimited_strain"][figure], 1e-12);
  }
}

TEST_F(Verbs, FlattenPricesTheWaysToLessStretch) {
  const CliResult result = planish({"flatten", "panel.obj", "-o", "out", "--json"});
  const auto ways = result.json()["ways"];
  ASSERT_FALSE(ways.empty());
  for (const auto& way : ways) {
    EXPECT_TRUE(way["estimated"]);
    EXPECT_EQ(way.contains("material"), way["kind"] == "p99") << way;
    EXPECT_GE(way["deviation"]["max"], way["deviation"]["rms"]) << way;
    EXPECT_TRUE(way["folds"].is_number() && way["form_kept"].is_boolean()) << way;
  }
  EXPECT_THAT(content_of("out/report.html"), HasSubstr("Less stretch costs form"));
  const std::string text = planish({"flatten", "panel.obj", "-o", "out"}).out;
  EXPECT_THAT(text, HasSubstr("Less stretch costs form:"));
  EXPECT_THAT(text, HasSubstr("--max-rms-strain 0.5%"));
  EXPECT_THAT(text, HasSubstr("~ is an estimate"));
  // What was run is no estimate any more.
  const auto run =
      planish({"flatten", "panel.obj", "-o", "out", "--max-rms-strain", "0.5%", "--json"}).json();
  int exact = 0;
  for (const auto& way : run["ways"]) {
    if (way["estimated"]) continue;
    ++exact;
    EXPECT_EQ(way["limit"], 0.005);
    EXPECT_EQ(way["deviation"]["max"], run["evolve"]["deviation"]["max"]);
  }
  EXPECT_EQ(exact, 1);
}

TEST_F(Verbs, FlattenNotesFlagsThatSayHowToChangeWhereNothingAsksForIt) {
  const CliResult idle = planish({"flatten", "panel.obj", "-o", "out", "--border", "slide"});
  EXPECT_EQ(idle.exit_code, k_exit_done);
  EXPECT_THAT(idle.err, HasSubstr("--border says how to change the form, but nothing asks for"));
  const CliResult two =
      planish({"flatten", "panel.obj", "-o", "out", "--sweeps", "5", "--border", "slide"});
  EXPECT_THAT(two.err, HasSubstr("--border and --sweeps say how to change the form"));
  for (const char* limit : {"--max-rms-strain", "--max-strain"}) {
    const CliResult used =
        planish({"flatten", "panel.obj", "-o", "out", "--border", "slide", limit, "50%"});
    EXPECT_EQ(used.err, "") << limit;
  }
}

TEST_F(Verbs, FlattenWritesTheFormatsThatAreAskedFor) {
  const CliResult result = planish({"flatten", "panel.obj", "-o", "out", "--prefer", "smooth",
                                    "--sweeps", "1", "--formats", "plt,dxf,plt", "--paper", "a3",
                                    "--dxf-profile", "astm", "--text", "strokes", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(names(),
              ElementsAre("out", "out/as-designed.dxf", "out/as-designed.plt", "out/flat.obj",
                          "out/pattern-a3.pdf", "out/pattern.dxf", "out/pattern.plt",
                          "out/processed.obj", "out/report.html", "out/report.json", "panel.obj"));
  const auto json = result.json();
  EXPECT_EQ(json["files"]["pattern_pages"], "out/pattern-a3.pdf");
  EXPECT_FALSE(json["files"].contains("pattern"));
  EXPECT_THAT(content_of("out/pattern.dxf"), HasSubstr("Piece Name: panel"));
}

TEST_F(Verbs, FlattenWritesTheLengthsOfEdges) {
  const CliResult result = planish(
      {"flatten", "panel.obj", "-o", "out", "--edge-lengths", "--formats", "svg", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["files"]["edge_lengths"], "out/edge-lengths.csv");
  const std::string csv = content_of("out/edge-lengths.csv");
  EXPECT_THAT(csv, testing::StartsWith("loop,from_vertex,to_vertex,length,length_on_model\n0,"));
  EXPECT_EQ(std::count(csv.begin(), csv.end(), '\n'), 5) << "a panel has four corners";
}

TEST_F(Verbs, FlattenWritesWhatIsPickedAndTheDesignBesideIt) {
  const auto picked = planish({"flatten", "panel.obj", "-o", "out", "--pick", "1", "--json"});
  EXPECT_EQ(picked.exit_code, k_exit_done) << picked.err;
  EXPECT_EQ(picked.json()["evolve"]["stop"], "design_kept");
  ASSERT_EQ(picked.json()["candidates"].size(), 1U);
  EXPECT_EQ(picked.json()["candidates"][0]["name"], "as designed");
  const std::string design = content_of("out/as-designed.dxf");
  const auto flat = planish({"flatten", "panel.obj", "-o", "out", "--pick", "6", "--json"}).json();
  ASSERT_EQ(flat["candidates"].size(), 2U);
  EXPECT_EQ(flat["candidates"][1]["name"], "flat");
  EXPECT_EQ(flat["candidates"][1]["pick"], 6);
  EXPECT_TRUE(flat["candidates"][1]["result"]);
  EXPECT_EQ(flat["candidates"][1]["strain"], flat["unfold"]["strain"]);
  EXPECT_EQ(content_of("out/as-designed.dxf"), design);
  EXPECT_NE(content_of("out/pattern.dxf"), design);
}

TEST_F(Verbs, FlattenJudgesTheDesignByAMaterial) {
  const auto judged = [](const std::string& limit) {
    return planish(
        {"flatten", "panel.obj", "-o", "out", "--pick", "1", "--max-strain", limit, "--json"});
  };
  const CliResult taken = judged("50%"), not_taken = judged("0.01%");
  EXPECT_EQ(taken.exit_code, k_exit_done) << taken.err;
  EXPECT_EQ(not_taken.exit_code, k_exit_target_missed);
  for (const CliResult* result : {&taken, &not_taken}) {
    const auto json = result->json();
    EXPECT_EQ(json["evolve"]["stop"], "design_kept");
    EXPECT_EQ(json["evolve"]["deviation"]["max"], 0.0);
    EXPECT_EQ(json["unfold"]["limits"].size(), 1U);
  }
}

TEST_F(Verbs, FlattenNamesTheMaterialThatWasNamed) {
  const auto said = [](const Names& limit) {
    Names args = {"flatten", "panel.obj", "-o", "out", "--pick", "1"};
    args.insert(args.end(), limit.begin(), limit.end());
    return planish(args).out;
  };
  EXPECT_THAT(said({"--material", "NEOPRENE"}), HasSubstr("that neoprene takes"));
  EXPECT_THAT(said({"--max-strain", "10%@p99"}), Not(HasSubstr("neoprene")));
}

TEST_F(Verbs, FlattenRefusesTheNameOfAFileForItsFolder) {
  const CliResult result = planish({"flatten", "panel.obj", "-o", "vamp.PDF"});
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_THAT(result.err, HasSubstr("use \"vamp\""));
  EXPECT_FALSE(std::filesystem::exists("vamp.PDF"));
  std::filesystem::create_directory("old.pdf");
  EXPECT_EQ(planish({"flatten", "panel.obj", "-o", "old.pdf"}).exit_code, k_exit_done);
}

TEST_F(Verbs, FlattenRefusesTwoChoicesAtOnce) {
  for (const Names& more :
       {Names{"--pick", "7"}, Names{"--pick", "flat"},
        Names{"--pick", "2", "--material", "leather"}, Names{"--pick", "2", "--prefer", "flat"},
        Names{"--pick", "2", "--method", "classical"}}) {
    Names args = {"flatten", "panel.obj"};
    args.insert(args.end(), more.begin(), more.end());
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_usage) << more.back();
    EXPECT_THAT(result.err, HasSubstr("--pick")) << more.back();
  }
}

TEST_F(Verbs, FlattenHandsOutTheDesignWhereEvolvingMakesThePatternWorse) {
  ASSERT_EQ(planish({"flatten", "panel.obj", "-o", "flat", "--pick", "6"}).exit_code, k_exit_done);
  const CliResult result = planish({"flatten", "flat/processed.obj", "-o", "out", "--method",
                                    "classical", "--sweeps", "50", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_target_missed);
  EXPECT_THAT(result.err, HasSubstr("the pattern of the design was written"));
  EXPECT_GT(result.json()["rejected_strain"]["rms"], result.json()["unfold"]["strain"]["rms"]);
  EXPECT_EQ(content_of("out/processed.obj"), content_of("flat/processed.obj"));
}

TEST_F(Verbs, FlattenWritesThePatternAsTextureCoordinatesInMillimetres) {
  ASSERT_EQ(planish({"flatten", "panel.obj", "-o", "out", "--textured", "--unit", "cm"}).exit_code,
            k_exit_done);
  std::istringstream lines(content_of("out/textured.obj"));
  std::vector<Vec2> texture;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword;
    Vec2 p;
    if (words >> keyword >> p.x >> p.y && keyword == "vt") texture.push_back(p);
  }
  const TriMesh flat = read_mesh("out/flat.obj").mesh;
  ASSERT_EQ(texture.size(), flat.positions.size());
  for (std::size_t v = 0; v < texture.size(); ++v) {
    EXPECT_DOUBLE_EQ(texture[v].x, 10.0 * flat.positions[v].x);
    EXPECT_DOUBLE_EQ(texture[v].y, 10.0 * flat.positions[v].y);
  }
  EXPECT_EQ(read_mesh("out/textured.obj").mesh.positions,
            read_mesh("out/processed.obj").mesh.positions);
}

TEST_F(Verbs, FlattenNamesItsFolderAfterTheInput) {
  const CliResult result = planish({"flatten", "panel.obj", "--history", "sweeps.csv", "--unit",
                                    "in", "--colors", "paper", "--sweeps", "2"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, HasSubstr("Written into panel-pattern:\n  report.html "));
  EXPECT_THAT(result.out, HasSubstr("\n  pattern.svg, .dxf  "));
  EXPECT_THAT(result.out, HasSubstr("\n  sweeps.csv  ")) << "beside the folder, not in it";
  EXPECT_THAT(result.out, HasSubstr("\nOpen panel-pattern/report.html in a browser"));
  EXPECT_THAT(names(), Contains("panel-pattern/report.html"));
  EXPECT_THAT(names(), Contains("sweeps.csv"));
}

TEST_F(Verbs, FlattenKeepsTheFormatButForStl) {
  for (const char* format : {"ply", "stl"}) {
    const std::string input = std::string("patch.") + format;
    ASSERT_EQ(planish({"convert", "panel.obj", input}).exit_code, k_exit_done);
    ASSERT_EQ(planish({"flatten", input, "-o", format}).exit_code, k_exit_done);
  }
  EXPECT_TRUE(std::filesystem::exists("ply/processed.ply"));
  EXPECT_TRUE(std::filesystem::exists("ply/flat.ply"));
  EXPECT_TRUE(std::filesystem::exists("stl/processed.obj"));
}

TEST_F(Verbs, ConvertKeepsPositionsAndPassesTheReadersNotesOn) {
  const auto json = planish({"convert", "panel.obj", "a.ply", "--json"}).json();
  EXPECT_EQ(json["output"], "a.ply");
  EXPECT_EQ(read_mesh("a.ply").mesh.positions, read_mesh("panel.obj").mesh.positions);
  const CliResult stl = planish({"convert", "a.ply", "a.stl"});
  EXPECT_THAT(stl.err, StartsWith("note: "));
  const CliResult back = planish({"convert", "a.stl", "b.obj"});
  EXPECT_THAT(back.err, HasSubstr("note: a.stl: "));
  EXPECT_EQ(planish({"convert", "a.stl", "b.obj", "--quiet"}).err, "");
}

TEST_F(Verbs, SampleWritesEveryShapeThatItLists) {
  const auto samples = planish({"sample", "--list", "--json"}).json()["samples"];
  EXPECT_GE(samples.size(), 6U);
  for (const auto& sample : samples) {
    const std::string name = sample["name"];
    const std::string output = name + ".off";
    const CliResult result = planish({"sample", name, "--vertices", "400", "-o", output, "--json"});
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    EXPECT_EQ(result.json()["vertices"], read_mesh(output).mesh.positions.size());
    EXPECT_THAT(planish({"sample", "--list"}).out, HasSubstr(name));
  }
}

TEST_F(Verbs, FitEightyColumns) {
  for (const Names& args : {Names{"measure", "panel.obj"}, Names{"evolve", "panel.obj", "-oe.obj"},
                            Names{"unfold", "panel.obj", "-of.obj"}, Names{"flatten", "panel.obj"},
                            Names{"sample", "--list"}}) {
    std::istringstream lines(planish(args).out);
    for (std::string line; std::getline(lines, line);)
      EXPECT_LE(line.size(), 80U) << line;
  }
}

TEST_F(Verbs, TakePathsThatLookLikeFlagsBehindTwoDashes) {
  std::filesystem::rename("panel.obj", "-odd [1].obj");
  EXPECT_EQ(planish({"measure", "--", "-odd [1].obj"}).exit_code, k_exit_done);
  const CliResult result = planish({"evolve", "-o", "-out.obj", "--", "-odd [1].obj"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(names(), ElementsAre("-odd [1].obj", "-out.obj"));
}

}  // namespace
}  // namespace planish::cli
