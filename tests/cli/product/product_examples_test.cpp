#include <filesystem>

#include <gmock/gmock.h>

#include "cli/cli_run.h"

namespace planish::cli {
namespace {

/// The products of examples/products.
class ProductExamples : public CliTest {
 protected:
  static CliResult flatten(const std::string& name, const Names& more) {
    const std::filesystem::path examples =
        std::filesystem::path(PLANISH_GOLDEN_FOLDER) / "../../examples/products";
    Names args = {"flatten", (examples / (name + ".json")).string(), "-o", "out", "--json"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  }
};

TEST_F(ProductExamples, LegFoldsItsDart) {
  const CliResult result = flatten("leg", {"--sheet", "1500mm", "--formats", "svg"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["nesting"]["placements"].size(), 4U);
  EXPECT_NE(content_of("out/back/pattern.svg").find("darts folded"), std::string::npos);
}

TEST_F(ProductExamples, ShoeFitsOnOneHide) {
  const CliResult result = flatten("shoe", {"--sheet", "600mmx400mm", "--formats", "svg"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["nesting"]["sheets"], 1);
  EXPECT_EQ(result.json()["nesting"]["placements"].size(), 6U);
}

TEST_F(ProductExamples, BagHasALayoutForEachMaterial) {
  const CliResult result =
      flatten("bag", {"--sheet", "1500mm", "--sheet", "cotton=1400mm", "--formats", "svg"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_TRUE(std::filesystem::exists("out/layout-canvas.svg"));
  EXPECT_EQ(result.json()["nesting"]["materials"][1]["sheet_width"], 1400.0);
}

TEST_F(ProductExamples, HullFitsOnSheetsOfPlywood) {
  const CliResult result =
      flatten("hull", {"--sheet", "1220mmx2440mm", "--for", "laser", "--formats", "svg"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["nesting"]["placements"].size(), 4U);
  EXPECT_EQ(result.json()["nesting"]["left_out"].size(), 0U);
}

TEST_F(ProductExamples, HatComesInFiveSizes) {
  const CliResult result = flatten("hat", {"--formats", "svg"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto json = result.json();
  EXPECT_EQ(json["patches"].size(), 15U);
  int crowns = 0;
  for (const auto& seam : json["seams"])
    crowns += seam["name"] == "crown" ? 1 : 0;
  EXPECT_EQ(crowns, 5);
  for (const char* piece : {"tip", "side", "brim"})
    EXPECT_TRUE(std::filesystem::exists("out/sizes-" + std::string(piece) + ".svg"));
}

}  // namespace
}  // namespace planish::cli
