#include <atomic>
#include <sstream>

#include <planish/io/read_mesh.h>
#include <planish/mesh/shapes.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "mesh/split.h"
#include "support/meshes.h"
#include "support/solids.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

class Panels : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_mesh("box.obj", meshes::finer(solids::cube(), 2));
    write_mesh("dome.obj", make_shape("dome", 400));
  }
};

TEST_F(Panels, DivideABoxIntoItsNet) {
  const CliResult result = planish(
      {"panels", "box.obj", "-o", "seams.obj", "--apply", "net.obj", "--effort", "1", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto json = result.json();
  EXPECT_EQ(json["met"], true);
  ASSERT_EQ(json["pieces"].size(), 1U);
  EXPECT_NEAR(json["pieces"][0]["area"].get<double>(), 1.0, 1e-12);
  EXPECT_NEAR(json["length"].get<double>(), 7.0 * 2.0, 1e-9);  // 12 edges, 5 of which join 6 sides
  EXPECT_EQ(json["files"]["lines"], "seams.obj");
  EXPECT_EQ(split(read_mesh("net.obj").mesh, "net").size(), 1U);

  // The lines cut the same again, in the units of the file too.
  const CliResult flat = planish({"flatten", "box.obj", "--cut", "seams.obj", "-o", "flat",
                                  "--formats", "svg", "--scale", "10", "--json"});
  ASSERT_EQ(flat.exit_code, k_exit_done) << flat.err;
  EXPECT_NEAR(flat.json()["cut"]["length"].get<double>(), 140.0, 1e-6);
  EXPECT_LT(flat.json()["unfold"]["strain"]["max"].get<double>(), 1e-9);
}

TEST_F(Panels, SayWhatThePiecesNeed) {
  const CliResult result =
      planish({"panels", "dome.obj", "--max-rms-strain", "2%", "--prefer-cuts", "short"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.out, HasSubstr("every piece keeps the limit of strain"));
  EXPECT_THAT(result.out, HasSubstr("planish flatten dome.obj --cut auto"));
  EXPECT_THAT(result.err, HasSubstr("dome.obj: 1 piece"));  // told as it was found
}

TEST_F(Panels, AreWhatFlattenMakesOfAClosedSurface) {
  const Names rest = {"--formats", "svg", "--json"};
  const auto flatten = [&](Names args) {
    args.insert(args.end(), rest.begin(), rest.end());
    return planish(args);
  };
  const CliResult unasked = flatten({"flatten", "box.obj", "-o", "unasked"});
  ASSERT_EQ(unasked.exit_code, k_exit_done) << unasked.err;
  EXPECT_THAT(unasked.err, HasSubstr("the surface is closed, so it was divided, as by --cut auto"));
  const CliResult asked = flatten({"flatten", "box.obj", "-o", "asked", "--cut", "auto"});
  ASSERT_EQ(asked.exit_code, k_exit_done) << asked.err;
  EXPECT_THAT(asked.err, HasSubstr("--cut auto: 1 piece, 14.0 mm of seam"));
  EXPECT_EQ(asked.json()["unfold"]["strain"], unasked.json()["unfold"]["strain"]);
}

TEST_F(Panels, AreMirrorImagesWhereTheProductIsItsOwn) {
  TriMesh pear = solids::sphere(1.0, 24);
  for (Vec3& p : pear.positions)
    p = {(1.0 + 0.3 * p.y) * p.x, 1.5 * p.y, 0.8 * p.z + 0.3 * p.y * p.y};
  write_mesh("pear.obj", pear);
  const Names limit = {"--max-rms-strain", "4%", "--effort", "1"};
  const auto run = [&](Names args) {
    args.insert(args.end(), limit.begin(), limit.end());
    return planish(args);
  };
  const std::string left_is_right = "pear.obj: left equals right";
  EXPECT_THAT(run({"panels", "pear.obj"}).err, HasSubstr(left_is_right));
  EXPECT_THAT(run({"panels", "pear.obj", "--symmetric", "no"}).err, Not(HasSubstr(left_is_right)));
  // Each piece is its own mirror image, or has the mirrored pattern of another one.
  const CliResult flat = run({"flatten", "pear.obj", "--cut", "auto", "--symmetric", "auto", "-o",
                              "flat", "--formats", "svg"});
  EXPECT_EQ(flat.exit_code, k_exit_done) << flat.err;
  EXPECT_THAT(flat.err, HasSubstr("pear.obj: symmetric in x=0"));
  EXPECT_THAT(flat.err, Not(HasSubstr("no mirror image was found")));
}

TEST_F(Panels, OfAStoppedSearchAreTheBestSoFar) {
  std::atomic<bool> stop = false;
  std::ostringstream out, err;
  const Names args = {"panels", "dome.obj", "-o", "lines.obj", "--effort", "1000"};
  const auto stop_after_the_first = [&](const Progress& progress) { stop = progress.share > 0.0; };
  EXPECT_EQ(run(args, out, err, {.interrupted = &stop, .on_progress = stop_after_the_first}),
            k_exit_done)
      << err.str();
  EXPECT_TRUE(stop);
  EXPECT_THAT(err.str(), HasSubstr("the search was stopped"));
  EXPECT_TRUE(std::filesystem::exists("lines.obj"));
}

TEST_F(Panels, RefuseWhatTheyCannotDo) {
  const auto refused = [](const Names& args) {
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_usage) << result.err;
    return result.err;
  };
  EXPECT_THAT(refused({"panels", "box.obj", "--effort", "0"}), HasSubstr("--effort"));
  EXPECT_THAT(refused({"panels", "box.obj", "--prefer-cuts", "long"}), HasSubstr("few"));
  EXPECT_THAT(refused({"flatten", "box.obj", "--symmetric", "x=0", "--cut", "open"}),
              HasSubstr("does not go with --cut open"));
  EXPECT_THAT(planish({"panels", "dome.obj", "--symmetric", "y=3"}).err,
              HasSubstr("error: dome.obj: the mesh is not symmetric"));
  write_mesh("fins.obj", meshes::fins());
  EXPECT_THAT(planish({"panels", "fins.obj", "--strict"}).err,
              HasSubstr("error: fins.obj: 1 edge is shared by more than two triangles"));
  const CliResult no_lines = planish({"panels", "box.obj", "-o", "lines.txt"});
  EXPECT_EQ(no_lines.exit_code, k_exit_failed);
  EXPECT_THAT(no_lines.err, HasSubstr("lines.txt: the lines are an .obj file"));
}

}  // namespace
}  // namespace planish::cli
