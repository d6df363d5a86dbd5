#include <cmath>

#include <planish/io/read_mesh.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

void write_drawing(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// --cut with lines of all kinds.
class CutLines : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_mesh("tube.obj", meshes::tube(24, 10));
    write_mesh("sheet.obj", meshes::height_field(20, 12, [](double x, double y) {
                 return 0.05 * x * y - 0.02 * x * x;
               }));
  }

  CliResult unfolded(const std::string& mesh, const Names& lines, const Names& more = {}) {
    Names args = {"flatten", mesh, "-o", "out", "--pick", "3", "--formats", "svg", "--json"};
    for (const std::string& line : lines) {
      args.emplace_back("--cut");
      args.push_back(line);
    }
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  }

  double cut_length(const std::string& mesh, const Names& lines) {
    const CliResult result = unfolded(mesh, lines);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    return result.json()["cut"]["length"].get<double>();
  }
};

TEST_F(CutLines, GoTheShortestWayBetweenPlaces) {
  EXPECT_NEAR(cut_length("tube.obj", {"line 1,0,0 1,0,10"}), 10.0, 1e-9);
  EXPECT_NEAR(cut_length("tube.obj", {"line 0 240"}), 10.0, 1e-9);
  EXPECT_NEAR(cut_length("tube.obj", {"vertices 0 240"}), 10.0, 1e-9);
  EXPECT_NEAR(cut_length("tube.obj", {"0 240"}), 10.0, 1e-9);
  EXPECT_NEAR(cut_length("tube.obj", {"line 1,0,0 1,0,4 1,0,10"}), 10.0, 1e-9);
  EXPECT_NEAR(cut_length("tube.obj", {"straight 1,0,0 1,0,10"}), 10.0, 1e-9);
  const double dart = cut_length("sheet.obj", {"straight 10,0,-2 10,12,4 5mm"});
  EXPECT_NEAR(dart, 5.0, 1e-3) << "but for snapping";
}

/// A flat square of 4, with a cap below the middle of its diagonal.
TriMesh square_with_cap(double depth) {
  return {{{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {2, 2, -depth}},
          {{0, 2, 3}, {4, 0, 1}, {2, 4, 1}, {0, 4, 2}}};
}

// Else pieces get edges without a direction, and strains of hundreds of per cent.
TEST_F(CutLines, CrossTrianglesWithoutHeight) {
  for (const double depth : {0.0, 1e-13, 1e-10, 1e-7, 1e-5, 1e-3}) {
    write_mesh("cap.obj", square_with_cap(depth));
    const CliResult result = unfolded("cap.obj", {"straight 3.5,0,0 0.5,4,0"}, {"--unit", "dm"});
    ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
    EXPECT_THAT(result.err, HasSubstr(", 500.0 mm"));
    EXPECT_EQ(result.err.find("nearly without area") != std::string::npos, depth < 1e-4);
    const auto json = result.json();
    ASSERT_EQ(json["patches"].size(), 2U);
    for (const auto& patch : json["patches"])
      EXPECT_LT(patch["unfold"]["strain"]["rms"].get<double>(), 1e-3) << depth;
  }
}

TEST_F(CutLines, SayWhatIsNoPlace) {
  for (const char* bad : {"line 1,0,0", "line 1,0 2,0,0", "line 1,0,0 no", "ring", "straight 1,0,0",
                          "straight 1,0,0 x,0,1"}) {
    const CliResult result = unfolded("tube.obj", {bad});
    EXPECT_EQ(result.exit_code, k_exit_usage) << bad << result.err;
  }
  EXPECT_THAT(unfolded("tube.obj", {"line 0 999"}).err, HasSubstr("there is no vertex 999"));
  EXPECT_THAT(unfolded("sheet.obj", {"ring 5,5,1"}).err, HasSubstr("no ring goes around"));
  EXPECT_THAT(unfolded("sheet.obj", {"rings"}).err, HasSubstr("nowhere narrower"));
}

TEST_F(CutLines, OfARingMakeTwoTubes) {
  const CliResult result = unfolded("tube.obj", {"ring 1,0,5", "line 1,0,0 1,0,10"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["patches"].size(), 2U);
}

TEST_F(CutLines, ThatRunSideBySideAreMadeOne) {
  const CliResult result = unfolded("sheet.obj", {"plane x=10", "plane x=10.01", "plane y=6"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("plane x=10.01 runs beside plane x=10 for 1"));
  EXPECT_THAT(result.err, HasSubstr("made one"));
  EXPECT_EQ(result.json()["patches"].size(), 4U);
}

TEST_F(CutLines, AlongTheBorderAreLeftOut) {
  const CliResult result = unfolded("sheet.obj", {"plane x=10", "vertices 0 5 110 236"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("vertices 0 5 110 236 runs beside the border for"));
  EXPECT_THAT(result.err, HasSubstr("nothing is cut there"));
  EXPECT_EQ(result.json()["patches"].size(), 3U);
  const CliResult all = unfolded("sheet.obj", {"plane x=10", "vertices 0 5 10 20"});
  EXPECT_THAT(all.err, HasSubstr("runs along the border"));
}

TEST_F(CutLines, JoinSmallPiecesToTheirNeighbours) {
  const Names lines = {"plane x=10", "plane x=11", "plane y=6"};
  const CliResult result = unfolded("sheet.obj", lines);
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("is joined to sheet-"));
  EXPECT_THAT(result.err, HasSubstr("between plane x=10, plane x=11, plane y=6"));
  EXPECT_THAT(result.err, HasSubstr("--keep-small keeps it"));
  const auto json = result.json();
  EXPECT_EQ(json["patches"].size(), 4U);
  const auto kept = unfolded("sheet.obj", lines, {"--keep-small"}).json();
  EXPECT_EQ(kept["patches"].size(), 6U);
}

TEST_F(CutLines, LeaveOutPiecesByName) {
  const Names lines = {"plane x=10", "plane y=6"};
  const CliResult result = unfolded("sheet.obj", lines, {"--without", "sheet-2,sheet-4"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["patches"].size(), 2U);
  EXPECT_THAT(unfolded("sheet.obj", lines, {"--without", "sheet-9"}).err,
              HasSubstr("no piece is called sheet-9; there are sheet-1"));
  EXPECT_EQ(unfolded("sheet.obj", lines, {"--without", "sheet-1,sheet-2,sheet-3"}).exit_code,
            k_exit_done);
}

TEST_F(CutLines, FollowTheTextureAndTheMaterials) {
  std::string text = "v 0 0 0\nv 4 0 0\nv 8 0 0\nv 0 4 0\nv 4 4 0\nv 8 4 1\n";
  text += "vt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\nvt 5 0\nvt 6 0\nvt 6 1\nvt 5 1\n";
  text += "usemtl a\nf 1/1 2/2 5/3 4/4\nusemtl b\nf 2/5 3/6 6/7 5/8\n";
  write_drawing("two.obj", text);
  for (const char* kind : {"uv", "groups", "materials"}) {
    const CliResult result = unfolded("two.obj", {kind}, {"--divide", "parts", "--keep-small"});
    EXPECT_EQ(result.json()["patches"].size(), 2U) << kind;
    EXPECT_THAT(result.err, HasSubstr("cut open along 1 edge, 4.00 mm"));
  }
}

TEST_F(CutLines, AreDrawnOnThePattern) {
  const Names unfold = {"unfold", "sheet.obj", "-o", "pattern.svg", "--unit", "cm"};
  ASSERT_EQ(planish(unfold).exit_code, k_exit_done);
  std::string svg = content_of("pattern.svg");
  svg.insert(svg.rfind("</svg>"),
             "<g id=\"mine\"><path d=\"M 100 0 L 100 500\" stroke=\"black\" fill=\"none\"/></g>");
  write_drawing("drawn.svg", svg);
  const CliResult result = unfolded("sheet.obj", {"drawn.svg"}, {"--unit", "cm"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_EQ(result.json()["patches"].size(), 2U) << result.err;
  write_drawing("other.svg", content_of("pattern.svg"));
  EXPECT_THAT(unfolded("sheet.obj", {"other.svg"}, {"--unit", "cm"}).err,
              HasSubstr("draw on a layer of your own"));
}

}  // namespace
}  // namespace planish::cli
