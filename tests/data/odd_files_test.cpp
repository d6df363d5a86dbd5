// Meshes as makers have them, of the folder "odd" beside the patches: the right size, alike in
// unfold and flatten, and the way on where there is none without a flag.

#include <algorithm>
#include <string>
#include <vector>

#include <planish/core/vec.h>
#include <planish/sheet/pattern_sheet.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "io/read_drawing.h"
#include "support/test_files.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

CliResult run_on(const std::string& path, Names args, const Names& flags) {
  args.insert(args.begin() + 1, path);
  args.insert(args.end(), flags.begin(), flags.end());
  return planish(args);
}

class OddFiles : public WithOddFiles<CliFolder> {
 protected:
  static std::string odd_file(const std::string& name) { return file("odd/" + name).string(); }
};

class Products : public WithProducts<CliFolder> {};

struct Sheet {
  std::string file;
  Names flags;
  double width, height;
};

TEST_F(OddFiles, HaveTheRightSizeInUnfoldAndFlatten) {
  const std::vector<Sheet> sheets = {
      {"scan_two_texture_pages.obj", {}, 300.5, 300.4},
      {"scan_with_crumbs.obj", {}, 260.8, 200.4},
      {"split_at_texture_islands.ply", {"--weld"}, 157.0, 100.0},
      {"polysurface_two_faces.obj", {"--weld"}, 313.9, 160.0},
      {"thick_shell_2mm.obj", {"--side", "outer"}, 209.3, 150.0},
      {"thick_shell_2mm.stl", {"--side", "outer"}, 209.3, 150.0},
      {"two_sheets_2mm_apart.obj", {"--side", "outer"}, 209.3, 150.0},
      {"panel_and_helper_cubes.obj", {"--only", "suit_front"}, 209.3, 160.0},
  };
  for (const Sheet& sheet : sheets) {
    const std::string path = odd_file(sheet.file);
    SCOPED_TRACE(sheet.file);
    const CliResult unfold = run_on(path, {"unfold", "-o", "flat.svg", "--json"}, sheet.flags);
    ASSERT_EQ(unfold.exit_code, k_exit_done) << unfold.err;
    EXPECT_NEAR(unfold.json()["width"].get<double>(), sheet.width, 0.06);
    EXPECT_NEAR(unfold.json()["height"].get<double>(), sheet.height, 0.06);
    const CliResult flatten =
        run_on(path, {"flatten", "-o", "out", "--formats", "svg", "--json"}, sheet.flags);
    ASSERT_EQ(flatten.exit_code, k_exit_done) << flatten.err;
    EXPECT_NEAR(flatten.json()["unfold"]["width"].get<double>(), sheet.width, 0.06);
  }
}

TEST_F(OddFiles, NameTheWayOn) {
  const std::vector<std::pair<std::string, Names>> said = {
      {"split_at_texture_islands.ply", {"3 pieces touch along whole borders", "--weld"}},
      {"thick_shell_2mm.obj", {"a wall of 2.0 mm: --side outer or --side inner takes one side"}},
      {"two_sheets_2mm_apart.obj", {"a wall of 2.0 mm: --side outer or --side inner"}},
      {"panel_and_helper_cubes.obj", {"holds 7 pieces (suit_front, joint-0", "--only NAME"}},
  };
  for (const auto& [file, words] : said) {
    const std::string path = odd_file(file);
    const CliResult unfold = run_on(path, {"unfold", "-o", "flat.svg"}, {});
    EXPECT_EQ(unfold.exit_code, k_exit_failed) << file;
    for (const std::string& word : words)
      EXPECT_THAT(unfold.err, HasSubstr(word)) << file;
  }
}

/// Width and height of each closed line of a layer of an .svg.
std::vector<Vec2> sizes_on(const std::string& path, std::string_view layer) {
  std::vector<Vec2> sizes;
  for (const SvgLine& line : read_svg(path, k_sheet_layers).lines) {
    if (line.layer != layer) continue;
    Vec2 low = line.points.front(), high = low;
    for (const Vec2 p : line.points) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    sizes.push_back(high - low);
  }
  return sizes;
}

// An arc of 314.12 as it is meshed, by 200, with two windows.
TEST_F(OddFiles, KeepTheirHoles) {
  const std::string path = odd_file("windows_two_mirrored.obj");
  const CliResult flatten = run_on(path, {"flatten", "-o", "out", "--json"}, {});
  ASSERT_EQ(flatten.exit_code, k_exit_done) << flatten.err;
  EXPECT_THAT(flatten.err, HasSubstr("the patch has 2 holes, which stay"));
  EXPECT_EQ(flatten.json()["unfold"]["holes"]["count"], 2);
  EXPECT_NEAR(flatten.json()["evolve"]["before"]["border_length"].get<double>(), 1519.5, 0.05);
  const std::vector<Vec2> outer = sizes_on("out/pattern.svg", "cut");
  const std::vector<Vec2> holes = sizes_on("out/pattern.svg", "hole");
  ASSERT_EQ(outer.size(), 1U);
  ASSERT_EQ(holes.size(), 2U);
  EXPECT_NEAR(outer[0].x, 314.12, 0.01);
  EXPECT_NEAR(outer[0].y, 200.0, 0.01);
  for (const Vec2 hole : holes) {
    EXPECT_NEAR(hole.x, 62.82, 0.01);
    EXPECT_NEAR(hole.y, 60.0, 0.01);
  }
  for (const char* file : {"one_triangle_missing.obj", "dropouts_touch_at_vertex.obj"}) {
    const CliResult unfold = run_on(odd_file(file), {"unfold", "-o", "flat.svg"}, {});
    EXPECT_EQ(unfold.exit_code, k_exit_done) << unfold.err;
    EXPECT_THAT(unfold.err, HasSubstr("not meant, --fill-holes ")) << file;
  }
}

// Its least stretch has windows that cross themselves.
TEST_F(Products, AreLaidFlatInOnePieceWithAllWindows) {
  const CliResult unfold = run_on(file("car").string(), {"unfold", "-o", "car.svg", "--json"}, {});
  ASSERT_EQ(unfold.exit_code, k_exit_done) << unfold.err;
  EXPECT_EQ(unfold.json()["holes"]["count"], 10);
  EXPECT_FALSE(unfold.json()["overlaps"].get<bool>());
  EXPECT_EQ(unfold.json()["flipped_triangles"], 0);
  EXPECT_LT(unfold.json()["strain"]["rms"].get<double>(), 0.08);
}

TEST_F(OddFiles, CloseHolesThatTouch) {
  for (const char* file : {"one_triangle_missing.obj", "dropouts_touch_at_vertex.obj"}) {
    const std::string path = odd_file(file);
    const CliResult unfold =
        run_on(path, {"unfold", "-o", "flat.svg", "--json"}, {"--fill-holes", "120mm"});
    EXPECT_EQ(unfold.exit_code, k_exit_done) << unfold.err;
    EXPECT_FALSE(unfold.json()["overlaps"].get<bool>());
  }
}

TEST_F(OddFiles, AreCountedWhereCrumbsAreLeftOut) {
  const std::string path = odd_file("scan_with_crumbs.obj");
  for (const Names& verb : {Names{"measure"}, Names{"unfold", "-o", "flat.svg"}}) {
    EXPECT_THAT(run_on(path, verb, {}).err, HasSubstr("40 crumbs left out (0.28 % of the area)"))
        << verb[0];
  }
}

TEST_F(OddFiles, AreDividedWherePanelsMeet) {
  const std::string path = odd_file("three_panels_one_edge_groups.obj");
  for (const Names& flags : {Names{}, Names{"--divide", "parts"}}) {
    const CliResult result =
        run_on(path, {"flatten", "-o", "out", "--formats", "svg", "--json"}, flags);
    EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
    EXPECT_EQ(result.json()["patches"].size(), 3U);
  }
}

}  // namespace
}  // namespace planish::cli
