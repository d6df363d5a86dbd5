// What is read of a file, alike in all verbs.

#include <cmath>
#include <fstream>

#include <planish/io/read_mesh.h>
#include <planish/mesh/repair.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "support/meshes.h"
#include "support/products.h"
#include "unit/mesh/repair/repairs.h"

namespace planish::cli {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

NamedPatch fins(const std::string& name) {
  return {name, meshes::fins(), {}};
}

NamedPatch grid(const std::string& name) {
  return {name, meshes::flat_grid(12, 8), {}};
}

class ModelFlags : public CliFolder {};

TEST_F(ModelFlags, AreThoseOfEveryVerbThatReads) {
  const nlohmann::json described = planish({"describe", "--json"}).json();
  std::size_t readers = 0;
  for (const auto& verb : described["verbs"]) {
    for (const auto& group : verb["groups"]) {
      if (group["title"] != "What is read") continue;
      ++readers;
      EXPECT_EQ(group["flags"].size(), 8U) << verb["name"];
    }
  }
  EXPECT_EQ(readers, 10U);
}

TEST_F(ModelFlags, WeldTakesAValueBehindAnEqualsSignOrNone) {
  write_mesh("panel.obj", meshes::flat_grid(12, 8));
  for (const Names& weld : {Names{"--weld"}, Names{"--weld=0.1"}, Names{"--weld=0.1mm"}}) {
    Names args = {"convert", "panel.obj", "out.obj"};
    args.insert(args.begin() + 1, weld.begin(), weld.end());
    EXPECT_EQ(planish(args).exit_code, k_exit_done) << weld[0];
  }
  const CliResult wrong = planish({"convert", "--weld=wide", "panel.obj", "out.obj"});
  EXPECT_EQ(wrong.exit_code, k_exit_usage);
  EXPECT_THAT(wrong.err, HasSubstr("--weld is \"wide\" but must be a length"));
}

TEST_F(ModelFlags, WeldSaysHowFarItJoinsAndWhatItCannot) {
  TriMesh two = meshes::flat_grid(12, 8);
  const auto first = static_cast<Index>(two.positions.size());
  for (Index v = 0; v < first; ++v)
    two.positions.push_back(two.positions[v] + Vec3{12.1, 0.0, 0.0});
  for (const Triangle t : meshes::flat_grid(12, 8).triangles)
    two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  write_mesh("two.obj", two);
  const auto said = [](const std::string& flag) {
    return planish({"convert", flag, "two.obj", "out.obj"}).err;
  };
  EXPECT_THAT(said("--weld=0.01"),
              HasSubstr("--weld joined nothing: the nearest borders of two pieces are 0.100 mm "
                        "apart, more than 0.010 mm; --weld=LENGTH"));
  EXPECT_THAT(said("--weld=0.2"), AllOf(HasSubstr("joined 8 pairs of border edges within 0.20 mm"),
                                        Not(HasSubstr("third"))));
  EXPECT_THAT(said("--weld=5"),
              AllOf(HasSubstr("within 5.0 mm; that is more than a third of a border edge at 80 "
                              "vertices"),
                    HasSubstr("make --weld less")));
  EXPECT_THAT(said("--weld=inf"), HasSubstr("third of a border edge"));
}

TEST_F(ModelFlags, NameASheetThatLiesOnAnother) {
  // The same square by 12 x 12 and by 9 x 9 cells.
  TriMesh two = meshes::flat_grid(12, 12);
  const auto first = static_cast<Index>(two.positions.size());
  const TriMesh coarser = meshes::flat_grid(9, 9);
  for (const Vec3& p : coarser.positions)
    two.positions.push_back(12.0 / 9.0 * p);
  for (const Triangle& t : coarser.triangles)
    two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
  write_mesh("two.obj", two);
  const CliResult result = planish({"flatten", "two.obj", "-o", "out"});
  EXPECT_THAT(result.err,
              HasSubstr("two-2 lies on two-1 all over; if they are one sheet, --without "
                        "two-2 leaves it out"));
  EXPECT_THAT(result.err, Not(HasSubstr("--weld")));
  const CliResult one = planish({"unfold", "two.obj", "--without", "two-2", "-o", "one.svg"});
  EXPECT_EQ(one.exit_code, k_exit_done) << one.err;
}

TEST_F(ModelFlags, JoinNamesThatAreGivenOneByOne) {
  write_product("suit.obj", {grid("front"), grid("back"), fins("helper")});
  const auto counted = [](const Names& flags) {
    Names args = {"convert", "suit.obj", "out.obj", "--json"};
    args.insert(args.end(), flags.begin(), flags.end());
    return planish(args).json()["triangles"].get<int>();
  };
  EXPECT_EQ(counted({"--only", "front,back"}), 384);
  EXPECT_EQ(counted({"--only", "front", "--only", "back"}), 384);
  EXPECT_EQ(counted({"--without", "helper"}), 384);
  EXPECT_EQ(counted({"--only", "helper"}), 3);
}

TEST_F(ModelFlags, ListTheNamesWhereOneIsNotThere) {
  write_product("suit.obj", {grid("front"), fins("helper")});
  const CliResult result = planish({"flatten", "suit.obj", "-o", "out", "--only", "frnt"});
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_THAT(result.err, HasSubstr("no piece is called frnt; there are front, helper"));
  EXPECT_EQ(planish({"flatten", "suit.obj", "-o", "out", "--only", "frnt", "--json"})
                .json()["error"]["code"],
            "unknown_name");
  EXPECT_FALSE(std::filesystem::exists("out"));
}

TEST_F(ModelFlags, LeaveOutHelpersOfAModeller) {
  write_product("suit.obj", {grid("front"), fins("fins_1"), fins("fins_2")});
  const CliResult all = planish({"flatten", "suit.obj", "-o", "all", "--formats", "svg"});
  EXPECT_EQ(all.exit_code, k_exit_failed);
  EXPECT_TRUE(std::filesystem::exists("all/front/pattern.svg"));
  EXPECT_THAT(all.err, AllOf(HasSubstr("fins_1"), HasSubstr("more than two triangles"),
                             HasSubstr("leave out with --without fins_1,fins_2")));
  const CliResult front = planish(
      {"flatten", "suit.obj", "-o", "front", "--formats", "svg", "--without", "fins_1,fins_2"});
  EXPECT_EQ(front.exit_code, k_exit_done) << front.err;
  EXPECT_TRUE(std::filesystem::exists("front/pattern.svg"));
}

TEST_F(ModelFlags, RefuseSeveralPiecesWhereOneIsWantedAndNameThem) {
  write_product("suit.obj", {grid("front"), grid("back")});
  for (const Names& args :
       {Names{"unfold", "suit.obj", "-o", "flat.svg"}, Names{"suggest-cuts", "suit.obj"},
        Names{"compare", "suit.obj"}, Names{"frontier", "suit.obj"}}) {
    const CliResult result = planish(args);
    EXPECT_EQ(result.exit_code, k_exit_failed) << args[0];
    EXPECT_THAT(result.err, AllOf(HasSubstr("holds 2 pieces (front, back)"),
                                  HasSubstr("--only NAME"), HasSubstr("planish flatten")));
  }
  EXPECT_EQ(planish({"measure", "suit.obj"}).exit_code, k_exit_done);
  EXPECT_EQ(planish({"unfold", "suit.obj", "-o", "flat.svg", "--only", "back"}).exit_code,
            k_exit_done);
}

TEST_F(ModelFlags, NameWhatIsMendedAndRefuseItWithStrict) {
  TriMesh mesh = meshes::flat_grid(12, 8);
  mesh.triangles.push_back(mesh.triangles[7]);
  write_mesh("twice.obj", mesh);
  const CliResult mended = planish({"unfold", "twice.obj", "-o", "flat.svg"});
  EXPECT_EQ(mended.exit_code, k_exit_done) << mended.err;
  EXPECT_THAT(mended.err, HasSubstr("left out 1 triangle without loss"));
  const CliResult strict = planish({"unfold", "twice.obj", "-o", "flat.svg", "--strict"});
  EXPECT_EQ(strict.exit_code, k_exit_failed);
  EXPECT_THAT(strict.err, HasSubstr("the second is left out, but not with --strict"));
}

TEST_F(ModelFlags, TellALengthThatClosesTheHoles) {
  TriMesh mesh = meshes::flat_grid(12, 8);
  mesh.triangles.erase(mesh.triangles.begin() + 50);
  write_mesh("hole.obj", mesh);
  const CliResult open = planish({"unfold", "hole.obj", "-o", "flat.svg"});
  EXPECT_EQ(open.exit_code, k_exit_done);
  const std::string flag = "--fill-holes ";
  const std::size_t at = open.err.find(flag);
  ASSERT_NE(at, std::string::npos) << open.err;
  const std::size_t begin = at + flag.size();
  const std::string length = open.err.substr(begin, open.err.find(' ', begin) - begin);
  const CliResult closed =
      planish({"unfold", "hole.obj", "-o", "flat.svg", "--fill-holes", length});
  EXPECT_EQ(closed.exit_code, k_exit_done) << length << closed.err;
  EXPECT_THAT(closed.err, HasSubstr("closed 1 hole"));
}

TEST_F(ModelFlags, TurnOverPiecesThatAreInsideOut) {
  const TriMesh mesh =
      meshes::height_field(12, 8, [](double x, double y) { return 0.02 * x * x - 0.01 * y * y; });
  std::vector<NamedPatch> strips = in_strips(mesh, 3);
  for (Triangle& t : strips[1].mesh.triangles)
    std::swap(t[1], t[2]);
  write_product("suit.obj", strips);
  const auto run = [](const std::string& folder, const Names& more) {
    Names args = {"flatten", "suit.obj", "-o", folder, "--formats", "svg"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  };
  const CliResult turned = run("turned", {});
  EXPECT_EQ(turned.exit_code, k_exit_done) << turned.err;
  EXPECT_THAT(turned.err, HasSubstr("turned over, as they were inside out against a neighbour "
                                    "along a seam: strip-2"));
  EXPECT_THAT(run("strict", {"--strict"}).err, Not(HasSubstr("turned over")));
}

/// Three strips of a saddle, the second inside out. The seams tell which one.
void write_suit_with_second_inside_out(const std::string& path) {
  const TriMesh mesh =
      meshes::height_field(12, 8, [](double x, double y) { return 0.02 * x * x - 0.01 * y * y; });
  std::vector<NamedPatch> strips = in_strips(mesh, 3);
  strips[1].mesh = turned_over(std::move(strips[1].mesh));
  write_product(path, strips);
}

TEST_F(ModelFlags, JudgeOrientationOnTheWholeFile) {
  write_suit_with_second_inside_out("suit.obj");
  planish({"flatten", "suit.obj", "-o", "whole", "--formats", "svg"});
  const CliResult one = planish(
      {"flatten", "suit.obj", "-o", "one", "--formats", "svg", "--only", "strip-2", "--json"});
  EXPECT_EQ(one.exit_code, k_exit_done) << one.err;
  EXPECT_THAT(one.err, HasSubstr("turned over, as they were inside out against a neighbour along a "
                                 "seam: strip-2 against strip-"));
  EXPECT_EQ(one.json()["unfold"]["turned"], true);
  EXPECT_EQ(read_mesh("one/processed.obj").mesh.triangles,
            read_mesh("whole/strip-2/processed.obj").mesh.triangles);
  EXPECT_THAT(content_of("one/report.html"), HasSubstr("The piece was turned over"));
  const auto garment = nlohmann::json::parse(content_of("whole/garment.json"));
  EXPECT_EQ(garment["patches"][0]["unfold"]["turned"], false);
  EXPECT_EQ(garment["patches"][1]["unfold"]["turned"], true);
  const CliResult unfolded =
      planish({"unfold", "suit.obj", "-o", "flat.obj", "--only", "strip-2", "--json"});
  EXPECT_EQ(unfolded.json()["turned"], true);
  EXPECT_THAT(planish({"unfold", "suit.obj", "-o", "flat.obj", "--only", "strip-2"}).out,
              HasSubstr("turned over: the piece was inside out"));
  EXPECT_EQ(planish({"unfold", "suit.obj", "-o", "flat.obj", "--only", "strip-1", "--json"})
                .json()["turned"],
            false);
}

TEST_F(ModelFlags, SayWhatStrictLeavesInsideOut) {
  write_suit_with_second_inside_out("suit.obj");
  const std::string advice = "leave out --strict, or turn a piece over with --only strip-2 --flip";
  const CliResult all =
      planish({"flatten", "suit.obj", "-o", "all", "--formats", "svg", "--strict"});
  EXPECT_THAT(all.err, AllOf(HasSubstr("strip-2 against strip-"), HasSubstr(advice)));
  for (const Names& args : {Names{"unfold", "suit.obj", "-o", "flat.obj"},
                            Names{"flatten", "suit.obj", "-o", "one", "--formats", "svg"}}) {
    Names strict = args;
    strict.insert(strict.end(), {"--strict", "--only", "strip-2"});
    EXPECT_THAT(planish(strict).err, HasSubstr(advice));
    strict.emplace_back("--flip");
    EXPECT_THAT(planish(strict).err, Not(HasSubstr("inside out")));
  }
}

TEST_F(ModelFlags, TakeNamesWithCommas) {
  write_product("suit.obj", {grid("Front, left"), grid("Front"), fins("left"), grid("Back")});
  const auto counted = [](const Names& flags) {
    Names args = {"convert", "suit.obj", "out.obj", "--json"};
    args.insert(args.end(), flags.begin(), flags.end());
    return planish(args).json()["triangles"].get<int>();
  };
  EXPECT_EQ(counted({"--only", "Front, left"}), 192);
  EXPECT_EQ(counted({"--only", "Front, left,left"}), 195);
  EXPECT_EQ(counted({"--only", "Front", "--only", "left"}), 195);
  EXPECT_EQ(counted({"--without", "Back,Front, left"}), 195);
}

TEST_F(ModelFlags, MayNamePiecesOfAnyOfSeveralFiles) {
  write_product("a.obj", {grid("front"), grid("back")});
  write_product("b.obj", {grid("sleeve"), grid("cuff")});
  write_product("c.obj", {grid("collar"), grid("belt")});
  for (const Names& args : {Names{"measure", "a.obj", "b.obj", "c.obj"},
                            Names{"unfold", "a.obj", "b.obj", "c.obj", "-o", "flat"}}) {
    Names some = args;
    some.insert(some.end(), {"--only", "front,cuff", "--json"});
    const CliResult result = planish(some);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    EXPECT_EQ(result.json()["files"].size(), 2U);
    EXPECT_THAT(result.err, HasSubstr("the flags take nothing of them: c.obj"));
    Names none = args;
    none.insert(none.end(), {"--only", "front,frnt"});
    const CliResult wrong = planish(none);
    EXPECT_EQ(wrong.exit_code, k_exit_usage);
    EXPECT_THAT(wrong.err, HasSubstr("no piece is called frnt; there are front, back, sleeve"));
  }
  EXPECT_EQ(planish({"measure", "a.obj", "--csv", "a.csv", "--without", "front,back"}).exit_code,
            k_exit_failed);
  std::ofstream("broken.obj") << "v 0 0\n";
  EXPECT_THAT(planish({"measure", "a.obj", "broken.obj", "--only", "front"}).err,
              HasSubstr("1 of 2 files failed"));
}

TEST_F(ModelFlags, SayWhereWeldJoinsNothing) {
  write_product("gap.obj", {{"sheet", meshes::flat_grid(4, 4), {}}});
  EXPECT_THAT(planish({"convert", "gap.obj", "out.obj", "--weld"}).err,
              HasSubstr("--weld joined nothing: there are no two borders beside each other"));
  TriMesh apart = meshes::flat_grid(4, 4);
  TriMesh other = apart;
  for (Vec3& p : other.positions)
    p.x += 4.3;
  write_mesh("apart.obj", repairs::both(apart, other));
  EXPECT_THAT(planish({"convert", "apart.obj", "out.obj", "--weld"}).err,
              HasSubstr("the nearest borders of two pieces are 0.300 mm apart"));
  write_product("names.obj", in_strips(apart, 2));
  EXPECT_THAT(planish({"convert", "names.obj", "out.obj", "--weld"}).err,
              HasSubstr("pieces of different names stay apart; --divide parts joins them too"));
}

TEST_F(ModelFlags, SayWhereNothingTellsTheOuterSideOfAWall) {
  const TriMesh sheet = meshes::flat_grid(30, 30);
  TriMesh below = turned_over(sheet);
  for (Vec3& p : below.positions)
    p.z -= 0.5;
  write_mesh("plate.obj", repairs::both(sheet, below));
  EXPECT_THAT(planish({"unfold", "plate.obj", "-o", "up.svg", "--side", "inner"}).err,
              HasSubstr("nothing tells which side is the outer one"));
}

/// A wall over half a wave, from x to x + 20.
TriMesh wave_wall(double x) {
  const auto sheet = [&](double z) {
    return meshes::height_field(20, 20, [&](double column, double) {
      const double at = (column + x - 20.0) / 20.0;
      return z + 4.0 * at * (1.0 - std::abs(at));
    });
  };
  TriMesh mesh = repairs::closed(sheet(0.5), sheet(0.0));
  for (Vec3& p : mesh.positions)
    p.x += x;
  return mesh;
}

TEST_F(ModelFlags, SayWhereSidesThatAreTakenDoNotMeet) {
  write_product("suit.obj", {{"left", wave_wall(0.0), {}}, {"right", wave_wall(20.0), {}}});
  EXPECT_THAT(planish({"convert", "suit.obj", "out.obj", "--side", "outer"}).err,
              HasSubstr("the sides of left and right that were taken do not meet"));
}

/// One half of a cushion, of that height in the middle: a grid of 12 x 8.
TriMesh cushion_half(double height) {
  return meshes::height_field(
      12, 8, [&](double x, double y) { return height * x * (12.0 - x) * y * (8.0 - y) / 576.0; });
}

TEST_F(ModelFlags, TurnOverTheHalfOfACushion) {
  write_product("cushion.obj",
                {{"top", cushion_half(2.0), {}}, {"bottom", cushion_half(-2.0), {}}});
  const CliResult turned = planish({"flatten", "cushion.obj", "-o", "out", "--formats", "svg"});
  EXPECT_THAT(turned.err, HasSubstr("along a seam: bottom"));
}

TEST_F(ModelFlags, SayWhereItIsNotKnownWhatIsInsideOut) {
  const TriMesh sheet = meshes::flat_grid(12, 8);
  write_product("facing.obj", {{"panel", sheet, {}}, {"facing", sheet, {}}});
  const CliResult flat = planish({"flatten", "facing.obj", "-o", "out", "--formats", "svg"});
  EXPECT_THAT(flat.err, Not(HasSubstr("turned over")));
  EXPECT_THAT(flat.err, HasSubstr("not known whether they are inside out: facing"));
}

TEST_F(ModelFlags, SayWhereNoWallHasTheSideAskedFor) {
  write_mesh("panel.obj", make_shape("panel", 300));
  EXPECT_THAT(planish({"unfold", "panel.obj", "-o", "up.svg", "--side", "outer"}).err,
              HasSubstr("no wall was found in panel: --side changes nothing there"));
}

TEST_F(ModelFlags, SayWhichSideIsUpAndTurnIt) {
  write_mesh("panel.obj", make_shape("panel", 300));
  const CliResult up = planish({"unfold", "panel.obj", "-o", "up.svg", "--json"});
  EXPECT_EQ(up.json()["side"], "outer");
  EXPECT_THAT(planish({"unfold", "panel.obj", "-o", "up.obj"}).out, HasSubstr("outer side up"));
  planish({"convert", "panel.obj", "over.obj", "--flip"});
  planish({"unfold", "over.obj", "-o", "over-flat.obj"});
  planish({"unfold", "panel.obj", "-o", "flipped.obj", "--flip"});
  const TriMesh over = read_mesh("over-flat.obj").mesh, flipped = read_mesh("flipped.obj").mesh;
  EXPECT_EQ(over.positions, flipped.positions);
  EXPECT_NE(flipped.positions, read_mesh("up.obj").mesh.positions);
}

}  // namespace
}  // namespace planish::cli
