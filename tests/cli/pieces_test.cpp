#include <fstream>

#include <gmock/gmock.h>

#include "cli_run.h"
#include "support/products.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A flat box of columns by rows cells of 10 mm at a height, so that pieces share no border.
NamedPatch flat_piece(const std::string& name, std::size_t columns, std::size_t rows,
                      double height) {
  NamedPatch piece;
  piece.name = name;
  for (std::size_t j = 0; j <= rows; ++j) {
    for (std::size_t i = 0; i <= columns; ++i)
      piece.mesh.positions.push_back(
          {10.0 * static_cast<double>(i), 10.0 * static_cast<double>(j), height});
  }
  const auto at = [&](std::size_t i, std::size_t j) {
    return static_cast<Index>(j * (columns + 1) + i);
  };
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < columns; ++i) {
      piece.mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      piece.mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return piece;
}

class PiecesOfAProduct : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_product("bag.obj", {flat_piece("front", 20, 10, 0.0), flat_piece("back", 20, 10, 900.0),
                              flat_piece("strap", 30, 4, 1800.0)});
  }
  static CliResult flatten(const Names& more, const std::string& input = "bag.obj") {
    Names args = {"flatten", input, "-o", "out", "--unit", "mm", "--formats", "svg"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  }
  static std::string sheet_of(const std::string& piece) {
    return content_of("out/" + piece + "/pattern.svg");
  }
  static void expect_refused(const Names& more, int exit_code, const std::string& message) {
    const CliResult result = flatten(more);
    EXPECT_EQ(result.exit_code, exit_code) << result.err;
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists("out"));
  }
};

TEST_F(PiecesOfAProduct, HaveSettingsOfTheirOwnOfWhichTheLastCounts) {
  const CliResult result =
      flatten({"--allowance", "10mm", "--piece", "front:allowance=20mm", "--piece",
               "front:allowance=25mm", "--piece", "back:allowance=none", "--corners", "round",
               "--piece", "strap:quantity=3", "--piece", "strap:note=cut on the bias"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(sheet_of("front"), HasSubstr("+ 25 mm allowance"));
  EXPECT_THAT(sheet_of("back"), Not(HasSubstr("allowance")));
  EXPECT_THAT(sheet_of("strap"), HasSubstr("+ 10 mm allowance"));
  EXPECT_THAT(sheet_of("strap"), HasSubstr("cut 3 ×"));
  EXPECT_THAT(sheet_of("strap"), HasSubstr("cut on the bias"));
  EXPECT_THAT(sheet_of("front"), Not(HasSubstr("cut on the bias")));
}

TEST_F(PiecesOfAProduct, HaveEdgesByNumberAndByName) {
  const CliResult result =
      flatten({"--allowance", "10mm", "--edge-lengths", "--piece", "front:edge.3=hem", "--piece",
               "front:allowance.hem=40mm", "--piece", "front:allowance.1=none"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(sheet_of("front"), HasSubstr("allowance 10 mm, none at edge 1, 40 mm at hem"));
  EXPECT_THAT(sheet_of("front"), HasSubstr(">hem 200.0<"));
  EXPECT_THAT(sheet_of("front"), HasSubstr(">2: 100.0<"));
  EXPECT_THAT(sheet_of("back"), HasSubstr("+ 10 mm allowance"));
}

TEST_F(PiecesOfAProduct, AreLeftOutAndGetOtherNames) {
  const CliResult result = flatten({"--piece", "strap:out", "--piece", "front:name=lid", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto patches = result.json()["patches"];
  ASSERT_EQ(patches.size(), 2U);
  EXPECT_EQ(patches[0]["name"], "lid");
  EXPECT_TRUE(std::filesystem::exists("out/lid/pattern.svg"));
}

TEST_F(PiecesOfAProduct, LieTurnedAsEachOfThemMay) {
  const auto angles = [&](const Names& more) {
    Names flags = {"--sheet", "250mm", "--turn", "none", "--json"};
    flags.insert(flags.end(), more.begin(), more.end());
    const CliResult result = flatten(flags);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    return result.json()["nesting"]["placements"];
  };
  for (const auto& placement : angles({}))
    EXPECT_EQ(placement["angle"], 0.0);
  // Across the roll it is 40 mm long instead of 300.
  for (const auto& placement : angles({"--piece", "front:turn=quarter"}))
    EXPECT_TRUE(placement["patch"] == "front" || placement["angle"] == 0.0);
}

TEST_F(PiecesOfAProduct, SayWhatIsWrongBeforeTheWork) {
  const auto usage = k_exit_usage;
  expect_refused({"--piece", "frnt:quantity=2"}, usage, "did you mean front?");
  expect_refused({"--piece", "front:quantty=2"}, usage, "did you mean quantity?");
  expect_refused({"--piece", "front"}, usage, "must be NAME:KEY=VALUE");
  expect_refused({"--piece", "front:quantity=x"}, usage, "--piece front: --quantity");
  expect_refused({"--piece", "front:allowance.hem=3mm"}, usage, "no edge is called \"hem\"");
  expect_refused(
      {"--piece", "front:edge.1=waist", "--piece", "front:hem.wiast=3mm", "--allowance", "3mm"},
      usage, "did you mean waist?");
  expect_refused({"--piece", "front:edge.1=hem", "--piece", "front:edge.2=hem"}, usage,
                 "two edges are called \"hem\"");
  expect_refused({"--piece", "front:allowance.1=3mm"}, usage, "the piece has none");
  expect_refused({"--piece", "front:mirrored=2"}, usage, "no more pieces than there are");
  expect_refused({"--piece", "front:out", "--piece", "front:size=4"}, usage, "left out");
  expect_refused({"--piece", "front:turn=half"}, usage, "turn goes with --sheet only");
  expect_refused({"--piece", "front:fold=0,50"}, k_exit_failed, "off the border");
  expect_refused({"--fold", "0,20"}, usage, "--piece NAME:fold=...");
}

TEST_F(PiecesOfAProduct, LieOnTheFoldAndAreLaidWhole) {
  const CliResult result =
      flatten({"--allowance", "10mm", "--piece", "front:fold=0,20", "--sheet", "1m"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(sheet_of("front"), HasSubstr("on the fold"));
  EXPECT_THAT(sheet_of("back"), Not(HasSubstr("on the fold")));
  EXPECT_THAT(result.out, Not(HasSubstr("back is equal")));
}

TEST_F(PiecesOfAProduct, AreToldInTheProductFileToo) {
  std::filesystem::create_directories("parts");
  write_product("parts/front.obj", {flat_piece("front", 20, 10, 0.0)});
  std::ofstream("parts/notches.txt") << "0.25 v\n";
  std::ofstream("parts/bag.json") << R"({"pieces": [{"file": "front.obj", "name": "Front",
    "allowance": "12mm", "edge.1": "hem", "allowance.hem": "30mm", "notches": "notches.txt",
    "mirrored": true, "quantity": 4, "grain": "30deg"}]})";
  const CliResult result =
      flatten({"--allowance", "5mm", "--piece", "Front:size=42"}, "parts/bag.json");
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(sheet_of("Front"), HasSubstr("allowance 12 mm, 30 mm at hem"));
  EXPECT_THAT(sheet_of("Front"), HasSubstr("size 42"));
  EXPECT_THAT(sheet_of("Front__mirrored"), HasSubstr("allowance 12 mm, 30 mm at hem"));
  EXPECT_THAT(sheet_of("Front__mirrored"), HasSubstr("cut 2 ×"));
  // What the command line says comes last.
  const CliResult other =
      flatten({"--piece", "Front:allowance=8mm", "--piece", "Front:quantity=2", "--resume"},
              "parts/bag.json");
  ASSERT_EQ(other.exit_code, k_exit_done) << other.err;
  EXPECT_THAT(sheet_of("Front"), HasSubstr("allowance 8 mm, 30 mm at hem"));
  EXPECT_THAT(sheet_of("Front"), HasSubstr("cut 1 ×"));
  std::ofstream("parts/bag.json") << R"({"pieces": [{"file": "front.obj", "alowance": "1mm"}]})";
  EXPECT_THAT(flatten({}, "parts/bag.json").err, HasSubstr("did you mean allowance?"));
}

TEST_F(PiecesOfAProduct, AreDoneAnewOnlyWhereTheirSettingsChange) {
  ASSERT_EQ(flatten({"--piece", "front:size=1"}).exit_code, k_exit_done);
  const CliResult again = flatten({"--piece", "front:size=2", "--resume"});
  ASSERT_EQ(again.exit_code, k_exit_done) << again.err;
  EXPECT_THAT(sheet_of("front"), HasSubstr("size 2"));
  EXPECT_THAT(again.out, HasSubstr("strap"));
}

/// The pages of a PDF of ours.
int pages_of(const std::string& path) {
  const std::string pdf = content_of(path);
  const std::string before = "/Type /Pages /Count ";
  const std::size_t at = pdf.find(before);
  return at == std::string::npos ? 0 : std::stoi(pdf.substr(at + before.size(), 6));
}

TEST_F(PiecesOfAProduct, LieTogetherOnPagesOfPaper) {
  const CliResult small = flatten({"--paper", "a4", "--allowance", "10mm"});
  ASSERT_EQ(small.exit_code, k_exit_done) << small.err;
  // 220 x 120 twice and 320 x 60 cover 72,000 of the 52,630 mm2 of a page.
  EXPECT_GE(pages_of("out/garment-a4.pdf"), 3);
  EXPECT_LE(pages_of("out/garment-a4.pdf"), 4);
  EXPECT_FALSE(std::filesystem::exists("out/front/pattern-a4.pdf"));
  const std::string pdf = content_of("out/garment-a4.pdf");
  for (const char* name : {"(front) Tj", "(back) Tj", "(strap) Tj"})
    EXPECT_THAT(pdf, HasSubstr(name));
  EXPECT_EQ(flatten({"--paper", "a2"}).exit_code, k_exit_done);
  EXPECT_EQ(pages_of("out/garment-a2.pdf"), 1);
  EXPECT_EQ(flatten({"--paper", "36inx48in"}).exit_code, k_exit_done);
  EXPECT_EQ(pages_of("out/garment-36inx48in.pdf"), 1);
}

TEST_F(PiecesOfAProduct, TakeMorePagesWithMoreOverlap) {
  ASSERT_EQ(flatten({"--paper", "210mmx100mm", "--page-overlap", "0"}).exit_code, k_exit_done);
  const int without = pages_of("out/garment-210mmx100mm.pdf");
  ASSERT_EQ(flatten({"--paper", "210mmx100mm", "--page-overlap", "40mm"}).exit_code, k_exit_done);
  EXPECT_GT(pages_of("out/garment-210mmx100mm.pdf"), without);
}

TEST_F(PiecesOfAProduct, RefusePaperThatIsNone) {
  expect_refused({"--paper", "36x48"}, k_exit_usage, "needs units");
  expect_refused({"--paper", "a9"}, k_exit_usage, "unknown paper a9");
  expect_refused({"--paper", "25mmx900mm"}, k_exit_usage, "take larger paper");
  expect_refused({"--paper", "a4", "--page-overlap", "190mm"}, k_exit_usage, "less overlap");
  expect_refused({"--page-overlap", "5mm"}, k_exit_usage, "goes with --paper only");
}

TEST_F(PiecesOfAProduct, AreForTheMachineThatIsNamed) {
  Names args = {"flatten", "bag.obj", "-o", "out", "--unit", "mm", "--allowance", "10mm"};
  const auto run_for = [&](const Names& more) {
    std::filesystem::remove_all("out");
    Names all = args;
    all.insert(all.end(), more.begin(), more.end());
    return planish(all);
  };
  ASSERT_EQ(run_for({"--for", "laser", "--sheet", "1m"}).exit_code, k_exit_done);
  EXPECT_TRUE(std::filesystem::exists("out/front/pattern.dxf"));
  EXPECT_FALSE(std::filesystem::exists("out/front/pattern.pdf"));
  const std::string layout = content_of("out/layout.svg");
  EXPECT_THAT(layout, HasSubstr("inkscape:label=\"strap\""));
  EXPECT_THAT(layout, HasSubstr("<g id=\"piece-3-cut\""));
  EXPECT_THAT(layout, Not(HasSubstr("<text")));
  EXPECT_THAT(layout, Not(HasSubstr("inkscape:label=\"label\"")));
  ASSERT_EQ(run_for({"--for", "laser", "--only-layers", "cut,label"}).exit_code, k_exit_done);
  EXPECT_THAT(sheet_of("front"), HasSubstr("inkscape:label=\"label\"")) << "own flags count";
  ASSERT_EQ(run_for({"--for", "apparel"}).exit_code, k_exit_done);
  EXPECT_TRUE(std::filesystem::exists("out/garment.dxf"));
  ASSERT_EQ(run_for({"--for", "plotter"}).exit_code, k_exit_done);
  EXPECT_TRUE(std::filesystem::exists("out/front/pattern.plt"));
  EXPECT_THAT(run_for({"--for", "apparel", "--formats", "svg"}).err,
              HasSubstr("--for apparel goes with dxf only"));
  EXPECT_THAT(run_for({"--for", "lazer"}).err, HasSubstr("did you mean laser?"));
}

}  // namespace
}  // namespace planish::cli
