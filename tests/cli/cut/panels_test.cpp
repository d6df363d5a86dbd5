#include <atomic>
#include <set>
#include <sstream>

#include <planish/io/read_mesh.h>
#include <planish/mesh/shapes.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "cut/panel_places.h"
#include "io/read_drawing.h"
#include "mesh/split.h"
#include "support/meshes.h"
#include "support/ringed_disk.h"
#include "support/solids.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A round box, z from -3 to 3.
TriMesh drum() {
  constexpr std::size_t rings = 7, around = 24;
  TriMesh mesh = meshes::ringed_disk(around, rings, [](double r, double) { return 7.0 - r; });
  for (Vec3& p : mesh.positions) {
    const double to_wall = std::min(1.0, 4.0 / std::max(1.0, std::hypot(p.x, p.y)));
    p = {to_wall * p.x, to_wall * p.y, std::min(p.z, 3.0)};
  }
  const auto rim = static_cast<Index>(mesh.positions.size() - around);
  const auto below = [&](Index v) { return v < rim ? static_cast<Index>(rim + around + v) : v; };
  for (Index v = 0; v < rim; ++v)
    mesh.positions.push_back({mesh.positions[v].x, mesh.positions[v].y, -mesh.positions[v].z});
  for (std::size_t t = mesh.triangles.size(); t-- > 0;) {
    const Triangle top = mesh.triangles[t];
    mesh.triangles.push_back({below(top[0]), below(top[2]), below(top[1])});
  }
  return mesh;
}

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

TEST_F(Panels, HaveTheSeamsThatAreFixed) {
  write_mesh("ball.obj", solids::sphere(1.0, 16));
  const Names limit = {"--max-rms-strain", "5%", "--effort", "1", "--symmetric", "no"};
  const auto run = [&](Names args) {
    args.insert(args.end(), limit.begin(), limit.end());
    return planish(args);
  };
  const CliResult result =
      run({"panels", "ball.obj", "--seams", "plane z=0.1", "-o", "seams.obj", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const auto json = result.json();
  EXPECT_EQ(json["met"], true);
  EXPECT_GE(json["pieces"].size(), 2U);  // one on each side of the plane
  // The drawing has the line around and the others.
  const DrawnLines drawn = read_obj_lines("seams.obj");
  EXPECT_EQ(drawn.lines.size(), json["seams"].get<std::size_t>() + 1);
  for (const Vec3& p : drawn.lines.front().points)
    EXPECT_NEAR(p.z, 0.1, 1e-9);
  const CliResult flat = planish(
      {"flatten", "ball.obj", "--cut", "seams.obj", "-o", "flat", "--formats", "svg", "--json"});
  EXPECT_EQ(flat.json()["patches"].size(), json["pieces"].size()) << flat.err;
  EXPECT_EQ(run({"panels", "ball.obj", "--seams", "auto"}).exit_code, k_exit_usage);
  EXPECT_THAT(run({"panels", "ball.obj", "--seams", "plane z=10"}).err,
              HasSubstr("--seams: --cut plane z=10: the plane does not meet the mesh"));
}

TEST_F(Panels, AreFewerWhereTheFormMayChange) {
  write_mesh("dome.obj", make_shape("dome", 600));
  const auto length_and_move = [&](const Names& tolerance) {
    Names args = {"flatten",
                  "dome.obj",
                  "--cut",
                  "auto",
                  "--max-rms-strain",
                  "2%",
                  "--effort",
                  "2",
                  "-o",
                  "flat",
                  "--formats",
                  "svg",
                  "--prefer-cuts",
                  "short",
                  "--symmetric",
                  "no",
                  "--json"};
    args.insert(args.end(), tolerance.begin(), tolerance.end());
    const CliResult flat = planish(args);
    EXPECT_EQ(flat.exit_code, k_exit_done) << flat.err;
    const auto json = flat.json();
    EXPECT_EQ(json["limits_met"], true);
    return std::pair<double, double>(json["cut"]["length"], json["evolve"]["deviation"]["max"]);
  };
  const auto [stiff, unmoved] = length_and_move({});
  const auto [soft, moved] = length_and_move({"--max-deviation", "4mm"});
  EXPECT_LT(soft, 0.95 * stiff);
  EXPECT_EQ(unmoved, 0.0);
  EXPECT_LE(moved, 4.0);
}

/// A coarse mesh: matching takes much of the limit.
TEST_F(Panels, KeepFormAndLimitWithSeamsOfOneLength) {
  TriMesh pear = solids::sphere(1.0, 12);
  for (Vec3& p : pear.positions)
    p = {(1.0 + 0.3 * p.y) * p.x, 1.5 * p.y, 0.8 * p.z + 0.3 * p.y * p.y};
  write_mesh("pear.obj", pear);
  const CliResult flat = planish({"flatten", "pear.obj", "--cut", "auto", "--max-rms-strain", "3%",
                                  "--effort", "2", "--prefer-cuts", "short", "--formats", "svg",
                                  "-o", "flat", "--unit", "m", "--json"});
  ASSERT_EQ(flat.exit_code, k_exit_done) << flat.err;
  EXPECT_THAT(flat.err, Not(HasSubstr("sides of")));  // of slits, that are not equally long
  const auto json = flat.json();
  const auto pieces = json.contains("patches") ? json["patches"] : decltype(json)::array({json});
  for (const auto& piece : pieces) {
    EXPECT_EQ(piece["limits_met"], true);
    EXPECT_EQ(piece["unfold"]["match_seams"], true);
    EXPECT_EQ((piece.contains("evolve") ? piece["evolve"] : piece)["deviation"]["max"], 0.0);
  }
}

TEST_F(Panels, AreCalledByTheirPlaces) {
  write_mesh("drum.obj", drum());
  const auto flatten = [](const Names& more) {
    Names args = {"flatten", "drum.obj", "-o",       "out", "--formats",     "svg",   "--unit",
                  "cm",      "--json",   "--effort", "1",   "--prefer-cuts", "simple"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  };
  const auto names = [](const CliResult& result) {
    std::set<std::string> found;
    const auto json = result.json();
    for (const auto& patch : json["patches"])
      found.insert(patch["name"].get<std::string>());
    return found;
  };
  using Set = std::set<std::string>;
  const CliResult unasked = flatten({});
  ASSERT_EQ(unasked.exit_code, k_exit_done) << unasked.err;
  const Set all = names(unasked);
  EXPECT_TRUE(all.contains("drum-zmax") && all.contains("drum-zmin"));
  EXPECT_GT(all.size(), 2U) << "the wall";
  EXPECT_TRUE(std::filesystem::exists("out/drum-zmax/pattern.svg"));
  // Along two rims, and twice from one to the other.
  const auto json = unasked.json();
  double seams = 0.0;
  for (const auto& seam : json["seams"])
    seams += seam["length_on_model"].get<double>();
  EXPECT_NEAR(10.0 * json["cut"]["length"].get<double>(), seams, 1e-6);
  Set renamed = all, fewer = all;
  fewer.erase("drum-zmin");
  renamed.erase("drum-zmax");
  renamed.insert("crown");
  EXPECT_EQ(names(flatten({"--cut", "auto", "--rename", "drum-zmax=crown"})), renamed);
  EXPECT_EQ(names(flatten({"--cut", "auto", "--without", "drum-zmin"})), fewer);
  EXPECT_THAT(flatten({"--cut", "auto", "--without", "drum-ymin"}).err, HasSubstr("drum-ymin"));

  const CliResult told =
      planish({"panels", "drum.obj", "--effort", "1", "--prefer-cuts", "simple", "--json"});
  Set called;
  const auto pieces = told.json()["pieces"];
  for (std::size_t k = 0; k < pieces.size(); ++k) {
    const auto& place = pieces[k]["place"];
    called.insert("drum-" + (place.is_null() ? std::to_string(k + 1) : place.get<std::string>()));
  }
  EXPECT_EQ(called, all);
}

TEST_F(Panels, WithoutAClearPlaceHaveNumbers) {
  const auto square = [](const Vec3& at, const Vec3& a, const Vec3& b) {
    return NamedPatch{"", {{at, at + a, at + a + b, at + b}, {{0, 1, 2}, {0, 2, 3}}}, {}};
  };
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  const NamedPatch top = square({0, 0, 1}, x, y), bottom = square({}, y, x),
                   left = square({}, z, y), right = square(x, y, z);
  using Places = std::vector<std::string>;
  const auto places = [](const std::vector<NamedPatch>& pieces) {
    return places_of_pieces(pieces);
  };
  EXPECT_EQ(places({top, left, bottom, right}), (Places{"zmax", "xmin", "zmin", "xmax"}));
  // Two of one place; a slope; inside out; flat, so that nothing is above the middle.
  EXPECT_EQ(places({top, square({1, 0, 1}, x, y), bottom}), (Places{"", "", "zmin"}));
  EXPECT_EQ(places({square({0, 0, 0.5}, x, y + z), bottom}), (Places{"", "zmin"}));
  EXPECT_EQ(places({square({0, 0, 1}, y, x), bottom}), (Places{"", "zmin"}));
  EXPECT_EQ(places({square({}, x, y), square(x, x, y)}), (Places{"", ""}));
  NamedPatch around = top;  // down on the other side
  around.mesh.positions.insert(around.mesh.positions.end(), bottom.mesh.positions.begin(),
                               bottom.mesh.positions.end());
  around.mesh.triangles.insert(around.mesh.triangles.end(), {{4, 5, 6}, {4, 6, 7}});
  EXPECT_EQ(places({around, right}), (Places{"", "xmax"}));
  EXPECT_TRUE(is_place("ymin"));
  EXPECT_FALSE(is_place("min"));
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
