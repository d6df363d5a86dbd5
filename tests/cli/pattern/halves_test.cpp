#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A half of 12 x 20 cells that bulges about its middle, at x = 0; the ends of that are vertices 0
/// and 260.
class Halves : public CliFolder {
 protected:
  void SetUp() override {
    CliFolder::SetUp();
    write_mesh("half.obj", meshes::height_field(12, 20, [](double x, double y) {
                 return 5.0 - 0.02 * x * x - 0.03 * (y - 9.0) * (y - 9.0);
               }));
    write_mesh("twisted.obj", twisted());
  }

  static TriMesh twisted() {
    TriMesh mesh = meshes::height_field(12, 20, [](double x, double y) {
      return 5.0 - 0.02 * x * x - 0.03 * (y - 9.0) * (y - 9.0);
    });
    for (Vec3& p : mesh.positions)
      p.x += std::sin(0.5 * p.y);
    return mesh;
  }

  static std::string content(const std::string& path) {
    std::ostringstream text;
    text << std::ifstream(path).rdbuf();
    return text.str();
  }
};

TEST_F(Halves, AreLaidFlatWithAStraightFold) {
  const CliResult unfolded =
      planish({"unfold", "half.obj", "-o", "a.svg", "--unit", "cm", "--fold", "0,260"});
  EXPECT_EQ(unfolded.exit_code, k_exit_done) << unfolded.err;
  for (const Names& more : {Names{}, Names{"--match-seams"}, Names{"--max-strain", "1%"}}) {
    Names args = {"flatten", "half.obj", "-o",     "out",       "--unit", "cm",
                  "--fold",  "260,0",    "--json", "--formats", "svg"};
    args.insert(args.end(), more.begin(), more.end());
    const CliResult result = planish(args);
    EXPECT_NE(result.exit_code, k_exit_failed) << result.err;
    EXPECT_TRUE(std::filesystem::exists("out/pattern.svg"));
    std::filesystem::remove_all("out");
  }
}

TEST_F(Halves, AreOpenedOutOnSheets) {
  const Names plain = {"flatten", "half.obj", "-o",     "out",       "--unit", "cm",
                       "--sheet", "1000mm",   "--json", "--formats", "svg"};
  const double share_of_half = planish(plain).json()["nesting"]["used_share"];
  Names args = plain;
  args.insert(args.end(), {"--fold", "0,260"});
  const CliResult result = planish(args);
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto nesting = result.json()["nesting"];
  EXPECT_GT(nesting["used_share"], 1.5 * share_of_half) << "twice as wide";
  EXPECT_THAT(content("out/layout.svg"), HasSubstr("id=\"fold\""));
}

TEST_F(Halves, ThatAreNoneAreRefusedWithAWayOn) {
  const CliResult result =
      planish({"unfold", "twisted.obj", "-o", "a.svg", "--unit", "cm", "--fold", "0,260"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("is not straight"));
  EXPECT_THAT(result.err, HasSubstr("lies in one plane of the model"));
  EXPECT_THAT(result.err, Not(HasSubstr("--fix")));
  EXPECT_FALSE(std::filesystem::exists("a.svg"));
}

TEST_F(Halves, SayWhichNotchesStandOnTheSeamLine) {
  // A dart in a flat piece: two vertices of its middle are pulled apart.
  write_mesh("flat.obj", meshes::flat_grid(12, 20));
  std::ofstream("dart.txt") << "6 19 32 45 58\n";
  std::ofstream("notches.txt") << "* 50%\n";
  const CliResult result =
      planish({"unfold", "flat.obj", "-o", "a.svg", "--unit", "cm", "--cut", "dart.txt",
               "--allowance", "12mm", "--seam-notches", "notches.txt"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("drawn on the seam line"));
  EXPECT_THAT(result.err, HasSubstr("the allowance fills slits, darts or bays: "));
  EXPECT_THAT(result.err, HasSubstr("of seam line have no cut line beside them, near vertex "));
}

}  // namespace
}  // namespace planish::cli
