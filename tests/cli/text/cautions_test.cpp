// What the mesh cannot show is said by every verb that judges a patch.

#include <cmath>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

class CautionsOfVerbs : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    // A hull plate of one row of facets, twisted: its triangles lie flat whatever it was.
    TriMesh plate = meshes::flat_grid(20, 1);
    for (Vec3& p : plate.positions)
      p = {50.0 * p.x, 300.0 * p.y, 3.0 * (p.x - 10.0) * (p.y - 0.5)};
    write_mesh("plate.obj", plate);
    write_mesh("dome.obj", make_shape("dome", 3000));
    // Four facets of a quarter of a cylinder, R 1000.
    TriMesh quarter = meshes::flat_grid(4, 1);
    for (Vec3& p : quarter.positions) {
      const double turn = 0.125 * std::acos(-1.0) * p.x;
      p = {1000.0 * std::sin(turn), 600.0 * p.y, 1000.0 * std::cos(turn)};
    }
    write_mesh("quarter.obj", quarter);
  }
};

/// It is the only caution, as of a mesh without inner vertices.
void expect_hidden_curvature_in_json(Names args) {
  args.push_back("--json");
  const auto json = planish(args).json();
  ASSERT_EQ(json["cautions"].size(), 1U) << args.front();
  EXPECT_EQ(json["cautions"][0]["code"], "hidden_curvature") << args.front();
  EXPECT_EQ(json["cautions"][0]["inner_share"], 0.0) << args.front();
}

TEST_F(CautionsOfVerbs, AreToldByMeasureUnfoldAndFlatten) {
  for (const Names& args :
       {Names{"measure", "plate.obj"}, Names{"unfold", "plate.obj", "-o", "a.svg"},
        Names{"flatten", "plate.obj", "-o", "out"}}) {
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    EXPECT_THAT(result.out, HasSubstr("No vertex is inside the mesh")) << args.front();
    expect_hidden_curvature_in_json(args);
  }
  EXPECT_THAT(content_of("a.svg"), HasSubstr("Before cutting, see the mesh: no vertex inside"));
  EXPECT_THAT(content_of("out/pattern.svg"), HasSubstr("see the mesh: no vertex inside"));
  EXPECT_THAT(content_of("out/report.html"), HasSubstr("Cannot be judged"));
}

TEST_F(CautionsOfVerbs, ChangeWhatIsCalledFlat) {
  EXPECT_THAT(planish({"flatten", "plate.obj", "-o", "out"}).out,
              AllOf(HasSubstr("Cannot be judged: no vertex inside."),
                    Not(HasSubstr("Lies flat without stretch"))));
  EXPECT_THAT(planish({"measure", "plate.obj"}).out, HasSubstr("not known"));
  const std::string quarter = planish({"flatten", "quarter.obj", "-o", "out2"}).out;
  EXPECT_THAT(quarter, HasSubstr("keeps every length of the mesh. Facets\nturn by 22.5 degrees: up "
                                 "to 6.4 mm per metre short"));
}

TEST_F(CautionsOfVerbs, OfSeveralFilesAreNotes) {
  const CliResult measured = planish({"measure", "dome.obj", "plate.obj"});
  EXPECT_THAT(measured.err, AllOf(HasSubstr("plate.obj: No vertex is inside the mesh"),
                                  Not(HasSubstr("dome.obj: "))));
  const CliResult unfolded = planish({"unfold", "dome.obj", "plate.obj", "-o", "all"});
  EXPECT_THAT(unfolded.err, HasSubstr("plate.obj: No vertex is inside the mesh"));
  EXPECT_THAT(content_of("all/plate.svg"), HasSubstr("see the mesh: no vertex inside"));
}

TEST_F(CautionsOfVerbs, AreNotesOfVerbsThatGiveNoPattern) {
  for (const Names& args : {Names{"evolve", "plate.obj", "-o", "evolved.obj"},
                            Names{"compare", "plate.obj", "--methods", "classical"},
                            Names{"frontier", "plate.obj"}, Names{"suggest-cuts", "plate.obj"}}) {
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    EXPECT_THAT(result.err, HasSubstr("plate.obj: No vertex is inside the mesh")) << args.front();
    expect_hidden_curvature_in_json(args);
  }
  for (const Names& args : {Names{"evolve", "dome.obj", "plate.obj", "-o", "all"},
                            Names{"compare", "dome.obj", "plate.obj", "--methods", "classical"}}) {
    const CliResult result = planish(args);
    EXPECT_THAT(result.err, AllOf(HasSubstr("plate.obj: No vertex is inside the mesh"),
                                  Not(HasSubstr("dome.obj: No"))))
        << args.front();
    Names as_json = args;
    as_json.push_back("--json");
    const auto files = planish(as_json).json()["files"];
    EXPECT_EQ(files[0]["cautions"].size(), 0U) << args.front();
    EXPECT_EQ(files[1]["cautions"].size(), 1U) << args.front();
  }
}

TEST_F(CautionsOfVerbs, AreOnTheSheetOfTheDesignToo) {
  planish({"flatten", "plate.obj", "-o", "out", "--pick", "5"});
  EXPECT_THAT(content_of("out/as-designed.svg"), HasSubstr("see the mesh: no vertex inside"));
}

TEST_F(CautionsOfVerbs, GoWithNoiseThatEvolvingTakesOut) {
  TriMesh rough = meshes::rough_grid(20, 20, 7, 0.3);
  write_mesh("rough.obj", rough);
  EXPECT_THAT(planish({"evolve", "rough.obj", "-o", "a.obj", "--sweeps", "1"}).err,
              HasSubstr("look like noise"));
  EXPECT_THAT(
      planish({"evolve", "rough.obj", "-o", "a.obj", "--sweeps", "1", "--smooth-first", "9mm"}).err,
      Not(HasSubstr("look like noise")));
}

TEST_F(CautionsOfVerbs, AdviseWhatCanBeDoneWithOnePiece) {
  EXPECT_THAT(planish({"measure", "plate.obj"}).out,
              HasSubstr("mesh a piece that is one with several"));
}

TEST_F(CautionsOfVerbs, AreNoneOfASoundPatch) {
  const auto json = planish({"measure", "dome.obj", "--json"}).json();
  EXPECT_EQ(json["cautions"], nlohmann::json::array());
  EXPECT_THAT(planish({"unfold", "dome.obj", "-o", "a.svg"}).out, Not(HasSubstr("finer")));
}

}  // namespace
}  // namespace planish::cli
