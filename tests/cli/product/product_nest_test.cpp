#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <planish/io/read_mesh.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "oracle/outline_gap.h"

namespace planish::cli {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::Not;

class ProductNest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    std::filesystem::create_directories("coat");
    write_mesh("coat/back.obj", make_shape("saddle", 400));
    write_mesh("coat/front.obj", make_shape("dome", 300));
  }
};

CliResult lay_out(const std::string& input, const Names& more) {
  Names args = {"flatten", input, "-o", "out", "--formats", "svg,dxf"};
  args.insert(args.end(), more.begin(), more.end());
  return planish(args);
}

/// The closed lines on a layer of a DXF file, in their order.
oracle::Loops lines_in_dxf(const std::string& path, const std::string& wanted) {
  oracle::Loops lines;
  std::istringstream file(content_of(path));
  std::string code, value, entity;
  bool is_wanted = false;
  while (std::getline(file, code) && std::getline(file, value)) {
    const int number = std::stoi(code);
    if (number == 0) {
      entity = value;
    } else if (number == 8) {
      is_wanted = value == wanted;
      if (is_wanted && entity == "POLYLINE") lines.emplace_back();
      if (is_wanted && entity == "VERTEX") lines.back().emplace_back();
    } else if (is_wanted && entity == "VERTEX" && number == 10) {
      lines.back().back().x = std::stod(value);
    } else if (is_wanted && entity == "VERTEX" && number == 20) {
      lines.back().back().y = std::stod(value);
    }
  }
  return lines;
}

/// The box of a pattern on its sheet, as garment.json says where it lies.
oracle::OutlineBox box_as_told(const nlohmann::json& placement, const std::string& folder) {
  const TriMesh flat = read_mesh(folder + "/flat.obj").mesh;
  const double angle = placement["angle"].get<double>() * std::numbers::pi / 180.0;
  oracle::Loops corners(1);
  for (const Vec3& p : flat.positions) {
    corners[0].push_back(
        {p.x * std::cos(angle) - p.y * std::sin(angle) + placement["x"].get<double>(),
         p.x * std::sin(angle) + p.y * std::cos(angle) + placement["y"].get<double>()});
  }
  return oracle::outline_box(corners);
}

TEST_F(ProductNest, TellsWhereThePiecesLieInTheDrawing) {
  const CliResult result = lay_out(
      "coat", {"--sheet", "6m", "--unit", "cm", "--quantity", "2", "--grain", "30deg", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  // Lengths of the flat meshes are in centimetres, those of the layout in millimetres.
  const auto nesting = result.json()["nesting"];
  EXPECT_EQ(nesting, nlohmann::json::parse(content_of("out/garment.json"))["nesting"]);
  EXPECT_EQ(nesting["sheet_width"], 6000.0);
  EXPECT_TRUE(nesting["sheet_length"].is_null());
  EXPECT_EQ(nesting["turn"], "half");
  EXPECT_EQ(nesting["sheets"], 1);
  EXPECT_THAT(nesting["files"], ElementsAre("out/layout.svg", "out/layout.dxf"));
  ASSERT_EQ(nesting["placements"].size(), 4U);
  const auto cuts = lines_in_dxf("out/layout.dxf", "cut");
  ASSERT_EQ(cuts.size(), 4U);
  double farthest = 0.0;
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const auto box = oracle::outline_box({cuts[i]});
    farthest = std::max(farthest, box.high.x);
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GE(oracle::gap_between({cuts[i]}, {cuts[j]}, 6.0), 5.0 - 0.003);
  }
  EXPECT_NEAR(nesting["used_length"].get<double>(), farthest, 0.001);
}

TEST_F(ProductNest, PlacesAreThoseOfTheFlatMeshes) {
  const auto nesting =
      lay_out("coat", {"--sheet", "600mm", "--json", "--curve-tolerance", "0"}).json()["nesting"];
  const auto cuts = lines_in_dxf("out/layout.dxf", "cut");
  ASSERT_EQ(cuts.size(), nesting["placements"].size());
  for (std::size_t i = 0; i < cuts.size(); ++i) {
    const auto& placement = nesting["placements"][i];
    const auto told = box_as_told(placement, "out/" + placement["patch"].get<std::string>());
    const auto drawn = oracle::outline_box({cuts[i]});
    EXPECT_NEAR(told.low.x, drawn.low.x, 0.001);
    EXPECT_NEAR(told.low.y, drawn.low.y, 0.001);
    EXPECT_NEAR(told.high.x, drawn.high.x, 0.001);
    EXPECT_NEAR(told.high.y, drawn.high.y, 0.001);
  }
  EXPECT_EQ(nesting["placements"][0]["copy"], 1);
  EXPECT_EQ(nesting["placements"][0]["sheet"], 1);
}

TEST_F(ProductNest, WritesADrawingForEachSheet) {
  const auto one = lay_out("coat", {"--sheet", "600", "--json"}).json()["nesting"];
  ASSERT_TRUE(one["error"].is_null());
  double longest = 0.0;
  for (const char* name : {"back", "front"}) {
    for (const Vec3& p : read_mesh(std::string("out/") + name + "/flat.obj").mesh.positions)
      longest = std::max({longest, p.x, p.y});
  }
  const std::string side = std::to_string(1.1 * longest + 1.0);
  const CliResult result =
      lay_out("coat", {"--sheet", side + "x" + side + "mm", "--quantity", "2", "--json"});
  const auto several = result.json()["nesting"];
  ASSERT_TRUE(several["error"].is_null()) << several;
  ASSERT_GT(several["sheets"], 1);
  const auto count = several["sheets"].get<int>();
  std::size_t drawn = 0;
  for (int s = 1; s <= count; ++s)
    drawn += lines_in_dxf("out/layout-" + std::to_string(s) + ".dxf", "cut").size();
  EXPECT_EQ(drawn, 4U);
  const std::string page = content_of("out/garment.html");
  const std::string of = " of " + std::to_string(count) + "</figcaption>";
  EXPECT_THAT(page, HasSubstr("aria-label=\"sheet 1 with its pieces\""));
  EXPECT_THAT(page, HasSubstr("<figcaption>Sheet " + std::to_string(std::min(count, 6)) + of));
}

TEST_F(ProductNest, ShowsTheSheetOnThePageOfTheProduct) {
  lay_out("coat", {"--sheet", "600"});
  const std::string page = content_of("out/garment.html");
  EXPECT_THAT(page, HasSubstr("A roll of width 600.0 mm: "));
  EXPECT_THAT(page, HasSubstr("aria-label=\"sheet with its pieces\""));
  lay_out("coat", {});
  EXPECT_THAT(content_of("out/garment.html"), Not(HasSubstr("On the sheet")));
}

TEST_F(ProductNest, AsksForTheUnitWhereTheSheetIsWiderThanAnyOnSale) {
  const CliResult result = lay_out("coat", {"--sheet", "1500x3000", "--unit", "m"});
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_THAT(result.err, HasSubstr("1500 m wide"));
  EXPECT_THAT(result.err, HasSubstr("write 1500mm"));
  EXPECT_NE(lay_out("coat", {"--sheet", "1500m", "--unit", "m"}).exit_code, k_exit_usage);
}

TEST_F(ProductNest, NamesThePieceThatFitsOnNoSheetAndKeepsTheRest) {
  const CliResult result = lay_out("coat", {"--sheet", "0.5mm", "--nest-gap", "0"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("the pieces could not be laid on sheets: piece \"back\" is "));
  EXPECT_TRUE(std::filesystem::exists("out/front/pattern.svg"));
  EXPECT_FALSE(std::filesystem::exists("out/layout.svg"));
  const auto json = nlohmann::json::parse(content_of("out/garment.json"));
  EXPECT_EQ(json["nesting"]["error"]["code"], "piece_too_large");
  EXPECT_THAT(content_of("out/front/report.html"),
              HasSubstr("✗ does not fit a roll of width 0.5 mm</span>"));
}

TEST_F(ProductNest, PagesOfPatchesSayWhetherTheyFit) {
  ASSERT_EQ(lay_out("coat", {"--sheet", "600", "--allowance", "10mm"}).exit_code, k_exit_done);
  for (const std::string name : {"back", "front"}) {
    const std::string page = content_of("out/" + name + "/report.html");
    EXPECT_THAT(page, HasSubstr("✓ fits a roll of width 600.0 mm</span>"));
    EXPECT_THAT(page, HasSubstr("<dd>a roll of width 600.0 mm; alone, "));
  }
}

TEST_F(ProductNest, KeepsFinishedPatchesWhereOnlyTheSheetIsAnother) {
  ASSERT_EQ(lay_out("coat", {"--sheet", "600"}).exit_code, k_exit_done);
  const std::string before = content_of("out/layout.dxf");
  const CliResult again = lay_out("coat", {"--sheet", "600", "--resume"});
  EXPECT_THAT(again.err, HasSubstr("from the earlier run"));
  EXPECT_EQ(content_of("out/layout.dxf"), before);
  const CliResult other = lay_out("coat", {"--sheet", "900", "--turn", "free", "--resume"});
  EXPECT_THAT(other.err, HasSubstr("from the earlier run"));
  EXPECT_NE(content_of("out/layout.dxf"), before);
}

TEST_F(ProductNest, LeavesOutAndTellsWhatFailed) {
  std::ofstream("coat/bad.obj") << "v 0 0\n";
  const CliResult result = lay_out("coat", {"--sheet", "600"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.out, HasSubstr("2 pieces fit on a roll of width 600.0 mm"));
  EXPECT_THAT(result.out, HasSubstr("  without bad\n"));
  const auto json = nlohmann::json::parse(content_of("out/garment.json"));
  EXPECT_THAT(json["nesting"]["left_out"], ElementsAre("bad"));
}

TEST_F(ProductNest, LaysCopiesOfASinglePatch) {
  const CliResult result =
      lay_out("panel.obj", {"--sheet", "1m", "--quantity", "5", "--allowance", "10mm", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["nesting"]["placements"].size(), 5U);
  EXPECT_EQ(lines_in_dxf("out/layout.dxf", "seam").size(), 5U);
  EXPECT_EQ(nlohmann::json::parse(content_of("out/report.json"))["nesting"]["sheets"], 1);
  EXPECT_EQ(lay_out("panel.obj", {"--sheet", "1mm"}).exit_code, k_exit_failed);
}

TEST_F(ProductNest, LaysEachMaterialOnSheetsOfItsOwn) {
  const CliResult result =
      lay_out("coat", {"--product", "--sheet", "600", "--sheet", "wool=400mm", "--piece",
                       "back:fabric=wool", "--piece", "front:fabric=silk/satin", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto nesting = result.json()["nesting"];
  EXPECT_THAT(nesting["files"],
              ElementsAre("out/layout-wool.svg", "out/layout-wool.dxf", "out/layout-silk_satin.svg",
                          "out/layout-silk_satin.dxf"));
  ASSERT_EQ(nesting["materials"].size(), 2U);
  EXPECT_EQ(nesting["materials"][0]["material"], "wool");
  EXPECT_EQ(nesting["materials"][0]["sheet_width"], 400.0);
  EXPECT_EQ(nesting["materials"][1]["sheet_width"], 600.0);
  EXPECT_EQ(nesting["placements"][1]["sheet"], 2);
  EXPECT_EQ(lines_in_dxf("out/layout-wool.dxf", "cut").size(), 1U);
  EXPECT_NEAR(nesting["waste"].get<double>() + nesting["used_share"].get<double>(), 1.0, 1e-12);
  const std::string page = content_of("out/garment.html");
  EXPECT_NE(page.find("ool on a roll of width 400.0 mm"), std::string::npos);
}

TEST_F(ProductNest, NamesAMaterialThatNoPieceHas) {
  const CliResult result =
      lay_out("coat", {"--product", "--sheet", "600,whool=400mm", "--piece", "back:fabric=wool"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("no piece is of \"whool\""));
  EXPECT_THAT(result.err, HasSubstr("wool"));
  EXPECT_THAT(
      lay_out("coat", {"--product", "--sheet", "wool=400mm", "--piece", "back:fabric=wool"}).err,
      HasSubstr("no size for pieces without a material"));
  EXPECT_EQ(lay_out("coat", {"--sheet", "600,700"}).exit_code, k_exit_usage);
}

TEST_F(ProductNest, LaysPairsOnFoldedCloth) {
  const CliResult result =
      lay_out("coat", {"--product", "--sheet", "1000mm", "--folded-cloth", "--quantity", "2",
                       "--piece", "front:mirrored=1", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto nesting = result.json()["nesting"];
  EXPECT_EQ(nesting["folded"], true);
  EXPECT_EQ(nesting["in_holes"], false);
  EXPECT_EQ(nesting["sheet_width"], 500.0);
  EXPECT_EQ(nesting["placements"].size(), 3U) << "back twice, front once for a pair";
  EXPECT_THAT(result.err, HasSubstr("back: cut 2 copies from one layer of the folded cloth alone"));
  EXPECT_EQ(lay_out("coat", {"--sheet", "1mx1m", "--folded-cloth"}).exit_code, k_exit_usage);
  EXPECT_EQ(lay_out("coat", {"--folded-cloth"}).exit_code, k_exit_usage);
}

TEST_F(ProductNest, RefusesFlagsThatMakeNoSense) {
  const auto exit_code = [](const Names& flags) { return lay_out("coat", flags).exit_code; };
  EXPECT_EQ(exit_code({"--turn", "none"}), k_exit_usage);
  EXPECT_EQ(exit_code({"--nest-gap", "3mm"}), k_exit_usage);
  EXPECT_EQ(exit_code({"--nest-in-holes"}), k_exit_usage);
  EXPECT_EQ(exit_code({"--sheet", "wide"}), k_exit_usage);
  EXPECT_EQ(exit_code({"--sheet", "0"}), k_exit_usage);
  EXPECT_EQ(exit_code({"--sheet", "1mx"}), k_exit_usage);
  EXPECT_EQ(exit_code({"--sheet", "inf"}), k_exit_usage);
  EXPECT_EQ(exit_code({"--sheet", "1m", "--nest-gap", "-1"}), k_exit_usage);
  EXPECT_EQ(exit_code({"--sheet", "1m", "--nest-margin", "0.6m"}), k_exit_usage);
  EXPECT_EQ(exit_code({"--sheet", "1m", "--turn", "hlaf"}), k_exit_usage);
  EXPECT_THAT(lay_out("coat", {"--sheet", "1m", "--turn", "hlaf"}).err, HasSubstr("half"));
  EXPECT_FALSE(std::filesystem::exists("out"));
}

}  // namespace
}  // namespace planish::cli
