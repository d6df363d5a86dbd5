#include <algorithm>
#include <cmath>

#include <planish/io/read_mesh.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "io/read_drawing.h"
#include "support/meshes.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;

void write_text(const std::string& path, const std::string& text) {
  std::ofstream(path) << text;
}

/// The sheet of a pattern with something drawn behind all else.
void draw_on(const std::string& sheet, const std::string& path, const std::string& content) {
  std::string text = content_of(sheet);
  text.replace(text.rfind("</svg>"), 6, content + "</svg>");
  write_text(path, text);
}

/// The first point of the outline, as the file has it: "12.5,30.25".
std::string corner_text(const std::string& sheet, const std::string& layer) {
  const std::string text = content_of(sheet);
  const std::size_t group = text.find("<g id=\"" + layer + "\"");
  const std::size_t begin = text.find("d=\"M", group) + 4;
  return text.substr(begin, text.find_first_of("lLCA", begin) - begin);
}

class Carry : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_mesh("hill.obj", meshes::height_field(12, 8, [](double x, double y) {
                 return 1.0 + 0.5 * x - 0.02 * (x - 6.0) * (x - 6.0) - 0.03 * y * y;
               }));
    Names args = {"flatten", "hill.obj",  "-o",  "out",    "--method", "controllable", "--sweeps",
                  "3",       "--formats", "svg", "--unit", "cm",       "--allowance",  "7mm"};
    const CliResult result = planish(args);
    ASSERT_TRUE(std::filesystem::exists("out/flat.obj")) << result.err;
  }

  /// Of vertex 13 j + i of the flat mesh.
  static Vec3 at(std::size_t i, std::size_t j) {
    return read_mesh("out/flat.obj").mesh.positions[13 * j + i];
  }

  static CliResult carry(const std::string& lines, const std::string& output,
                         const Names& more = {}, bool back = false) {
    Names args = {"carry",  lines,
                  "--from", back ? "out/processed.obj" : "out/flat.obj",
                  "--to",   back ? "out/flat.obj" : "out/processed.obj",
                  "-o",     output};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  }
};

TEST_F(Carry, TakesWhatWasAddedToAPatternToItsPlace) {
  // From the first point of the outline, which is vertex 0.
  const std::string corner = corner_text("out/pattern.svg", "seam");
  const Vec3 a = at(0, 0), b = at(8, 5), on_sheet = 10.0 * (b - a);
  draw_on("out/pattern.svg", "drawn.svg",
          "<g id=\"mine\"><path d=\"M" + corner + "l" + std::to_string(on_sheet.x) + "," +
              std::to_string(-on_sheet.y) +
              "\" stroke=\"red\"/><text>no</text></g>"
              "<g style=\"display:none\"><path d=\"M0 0L1 1\"/></g>");
  const CliResult result = carry("drawn.svg", "on.obj", {"--unit", "cm", "--json"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("left out what is no line: text (1)"));
  const auto json = result.json();
  EXPECT_EQ(json["lines"], 1);
  EXPECT_NEAR(json["length_from"].get<double>(), norm(b - a), 1e-3);
  EXPECT_EQ(json["left_out"]["text"], 1);
  const DrawnLines drawn = read_obj_lines("on.obj");
  ASSERT_EQ(drawn.lines.size(), 1U);
  // Sheets have thousandths of a millimetre.
  const TriMesh form = read_mesh("out/processed.obj").mesh;
  EXPECT_LT(norm(drawn.lines[0].points.front() - form.positions[0]), 2e-4);
  EXPECT_LT(norm(drawn.lines[0].points.back() - form.positions[13 * 5 + 8]), 2e-4);
  // The same drawing on the mesh itself.
  write_text("flat-lines.obj", format_obj_lines({{{{a, b}}}, {}}));
  ASSERT_EQ(carry("flat-lines.obj", "on2.obj", {"--unit", "cm"}).exit_code, k_exit_done);
  const DrawnLines same = read_obj_lines("on2.obj");
  ASSERT_EQ(same.lines.size(), 1U);
  EXPECT_EQ(same.lines[0].points.front(), form.positions[0]);
  EXPECT_LT(norm(same.lines[0].points.back() - drawn.lines[0].points.back()), 2e-4);
}

TEST_F(Carry, ComesBackToTheSamePlaces) {
  const auto between = [](Vec3 a, Vec3 b) { return a + 0.37 * (b - a); };
  const DrawnLines drawn = {
      {{{between(at(1, 1), at(2, 1)), between(at(9, 6), at(10, 7)), between(at(3, 6), at(3, 7))}}},
      {between(at(4, 4), at(5, 5))}};
  write_text("a.obj", format_obj_lines(drawn));
  ASSERT_EQ(carry("a.obj", "b.obj", {"--unit", "cm"}).exit_code, k_exit_done);
  ASSERT_EQ(carry("b.obj", "c.obj", {"--unit", "cm"}, true).exit_code, k_exit_done);
  const DrawnLines back = read_obj_lines("c.obj");
  ASSERT_EQ(back.lines.size(), 1U);
  const auto& line = back.lines[0].points;
  EXPECT_LT(norm(line.front() - drawn.lines[0].points.front()), 1e-9);
  EXPECT_LT(norm(line.back() - drawn.lines[0].points.back()), 1e-9);
  const auto middle = std::min_element(line.begin(), line.end(), [&](Vec3 p, Vec3 q) {
    return norm(p - drawn.lines[0].points[1]) < norm(q - drawn.lines[0].points[1]);
  });
  EXPECT_LT(norm(*middle - drawn.lines[0].points[1]), 1e-9);
  ASSERT_EQ(back.points.size(), 1U);
  EXPECT_LT(norm(back.points[0] - drawn.points[0]), 1e-9);
}

TEST_F(Carry, WritesASheetThatCanBeCarriedAgain) {
  const Vec3 a = at(1, 1), b = at(9, 5);
  const DrawnLines drawn = {{{{a, b}}}, {at(4, 4)}};
  write_text("a.obj", format_obj_lines(drawn));
  ASSERT_EQ(carry("a.obj", "b.obj", {"--unit", "cm"}).exit_code, k_exit_done);
  ASSERT_EQ(carry("b.obj", "c.svg", {"--unit", "cm"}, true).exit_code, k_exit_done);
  const auto json = carry("c.svg", "d.obj", {"--unit", "cm", "--json"}).json();
  EXPECT_EQ(json["lines"], 3);  // and the two strokes of the cross that stands for the point
  EXPECT_NEAR(json["length_from"].get<double>(), norm(b - a) + 1.2, 1e-3);
  // It lies where the pattern does without an allowance.
  planish({"flatten", "hill.obj", "-o", "plain", "--method", "controllable", "--sweeps", "3",
           "--formats", "svg", "--unit", "cm", "--curve-tolerance", "0"});
  EXPECT_EQ(corner_text("c.svg", "cut"), corner_text("plain/pattern.svg", "cut"));
}

TEST_F(Carry, SaysWhatLiesOff) {
  const Vec3 a = at(6, 4), b = a + 3.0 * (at(6, 0) - a);
  write_text("a.obj", format_obj_lines({{{{a, b}}}, {a + 100.0 * (b - a)}}));
  const CliResult result = carry("a.obj", "b.obj", {"--unit", "cm"});
  EXPECT_EQ(result.exit_code, k_exit_done);
  EXPECT_THAT(result.out, HasSubstr("Left out, as it lies off out/flat.obj: "));
  EXPECT_THAT(result.out, HasSubstr("1 point"));
  const auto json = carry("a.obj", "b.obj", {"--unit", "cm", "--json"}).json();
  EXPECT_NEAR(json["outside"]["length"].get<double>() + json["length_from"].get<double>(),
              norm(b - a), 1e-9);
  EXPECT_EQ(json["outside"]["points"], 1);
}

TEST_F(Carry, RefusesToDrawOnAFlatMeshWithoutABorder) {
  write_text("closed.obj",
             "v 0 0 0\nv 4 0 0\nv 0 4 0\nv 1 1 0\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n");
  write_text("point.obj", "v 1 0.5 0\np 1\n");
  const CliResult result =
      planish({"carry", "point.obj", "--from", "closed.obj", "--to", "closed.obj", "-o", "o.svg"});
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("no border"));
  EXPECT_FALSE(std::filesystem::exists("o.svg"));
}

TEST_F(Carry, RefusesWhatItCannotCarry) {
  const auto expect = [](const CliResult& result, const std::string& text) {
    EXPECT_EQ(result.exit_code, k_exit_failed) << result.out;
    EXPECT_THAT(result.err, HasSubstr(text));
    EXPECT_FALSE(std::filesystem::exists("b.obj"));
  };
  draw_on("out/pattern.svg", "drawn.svg", "<path d=\"M90 30l5 5\"/>");
  expect(carry("drawn.svg", "b.obj"), "it fits with --unit cm");
  expect(carry("out/pattern.svg", "b.obj", {"--unit", "cm"}), "on a layer of your own");
  draw_on("out/pattern.svg", "away.svg", "<path d=\"M-90 -30l5 5\"/>");
  expect(carry("away.svg", "b.obj", {"--unit", "cm"}), "lies off out/flat.obj");
  write_text("bare.svg", "<svg><path d=\"M90 30l5 5\"/></svg>");
  expect(carry("bare.svg", "b.obj"), "no outline of the pattern");
  expect(carry("drawn.svg", "b.obj", {"--unit", "cm"}, true), "exchange --from and --to");
  expect(carry("drawn.svg", "b.svg", {"--unit", "cm"}), "a surface in space");
  expect(carry("drawn.txt", "b.obj"), "must be an .svg or an .obj file");
  write_text("a.obj", "v 0 0 0\nv 1 1 0\nl 1 2\n");
  expect(planish({"carry", "a.obj", "--from", "panel.obj", "--to", "hill.obj", "-o", "b.obj"}),
         "hill.obj: the meshes are no pair");
  EXPECT_EQ(planish({"carry", "a.obj", "--from", "hill.obj", "-o", "b.obj"}).exit_code,
            k_exit_usage);
}

TEST_F(Carry, FindsPatternsWhoseSeamLineLeavesStretchesOut) {
  // Both ends bulge; one of them, or all of an end, has no allowance.
  TriMesh bulging = meshes::flat_grid(12, 8);
  for (Vec3& p : bulging.positions)
    p.x += 0.02 * (p.x - 6.0) * p.y * (8.0 - p.y);
  write_mesh("bulging.obj", bulging);
  for (const char* bare : {"12 116 0\n", "104 0 0\n", "12 116 0\n104 0 0\n", "0 12 0\n"}) {
    write_text("bare.txt", bare);
    const CliResult made =
        planish({"flatten", "bulging.obj", "-o", "out", "--unit", "cm", "--formats", "svg",
                 "--pick", "1", "--allowance", "7mm", "--edge-allowances", "bare.txt"});
    ASSERT_EQ(made.exit_code, k_exit_done) << made.err;
    draw_on("out/pattern.svg", "drawn.svg",
            "<g id=\"mine\"><path d=\"M60,60l20,10l-5,9z\" stroke=\"#000\"/></g>");
    const CliResult result = carry("drawn.svg", "line.obj", {"--unit", "cm"});
    EXPECT_EQ(result.exit_code, k_exit_done) << bare << result.err;
    const DrawnLines lines = read_obj_lines("line.obj");
    ASSERT_EQ(lines.lines.size(), 1U);
    EXPECT_EQ(lines.lines[0].points.front(), lines.lines[0].points.back()) << "still closed";
  }
}

}  // namespace
}  // namespace planish::cli
