#include <planish/mesh/patch.h>

#include <gmock/gmock.h>

#include "cli_run.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

using Flags = std::vector<std::string>;

class AnnotationsFlags : public CliTest {
 protected:
  static CliResult unfold(const Flags& flags, const std::string& output = "out.dxf") {
    Flags args = {"unfold", "panel.obj", "-o", output, "--unit", "cm"};
    args.insert(args.end(), flags.begin(), flags.end());
    return planish(args);
  }
  static void write(const std::string& path, const std::string& text) {
    std::ofstream(path) << text;
  }
  static void expect_usage_error(const Flags& flags, const std::string& message,
                                 const std::string& output = "out.dxf") {
    const CliResult result = unfold(flags, output);
    EXPECT_EQ(result.exit_code, k_exit_usage) << message;
    EXPECT_THAT(result.err, HasSubstr(message));
    EXPECT_FALSE(std::filesystem::exists(output));
  }
};

TEST_F(AnnotationsFlags, ReachTheSheetOfUnfold) {
  write("notches.txt", "0.25 v\n0.5 t double\n");
  write("marks.txt", "100 drill\n");
  const CliResult result = unfold(
      {"--allowance", "10mm",         "--corners",  "round",      "--notches",    "notches.txt",
       "--grain",     "30deg",        "--marks",    "marks.txt",  "--piece-name", "front",
       "--size",      "42",           "--quantity", "2",          "--fabric",     "neoprene",
       "--note",      "one mirrored", "--date",     "2031-02-03", "--dxf-layers", "seam=SEW"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const std::string dxf = content_of("out.dxf");
  for (const char* text : {"\n8\nSEW\n", "\n8\nnotch\n", "\n8\ngrain\n", "\n8\ndrill\n",
                           "\n1\nfront\n", "\n1\nsize 42\n", "\n1\nneoprene\n",
                           "\n1\none mirrored\n", "2031-02-03", "+ 10 mm allowance"})
    EXPECT_THAT(dxf, HasSubstr(text));
}

TEST_F(AnnotationsFlags, SayThatAnInnerCornerHasNoCutLineBesideNotches) {
  // 60 by 60 without its upper right quarter; vertex 4 is the inner corner.
  write("ell.obj",
        "v 0 0 0\nv 60 0 0\nv 60 30 0\nv 0 30 0\nv 30 30 0\nv 30 60 0\nv 0 60 0\nv 30 0 0\n"
        "f 1 8 5\nf 1 5 4\nf 8 2 3\nf 8 3 5\nf 4 5 6\nf 4 6 7\n");
  write("notches.txt", "4 slit double\n");
  const CliResult result = planish({"unfold", "ell.obj", "-o", "ell.svg", "--unit", "mm",
                                    "--allowance", "10mm", "--notches", "notches.txt"});
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("2 notches are drawn on the seam line: no cut line runs beside "
                                    "the place, as the allowance fills the dart, slit or inner "
                                    "corner there"));
}

TEST_F(AnnotationsFlags, MayBeDrawnOnTheModel) {
  const TriMesh panel = make_shape("panel", 300);
  const Patch patch(panel);
  const auto text = [](Vec3 p) {
    return "v " + std::to_string(p.x) + " " + std::to_string(p.y) + " " + std::to_string(p.z) +
           "\n";
  };
  const Vec3 inside = panel.positions[patch.inner_vertices()[40]];
  const Vec3 other = panel.positions[patch.inner_vertices()[90]];
  const Vec3 border = panel.positions[patch.border_loops()[0][5]];
  write("drawn.obj", text(inside) + text(other) + "l 1 2\n");
  write("border.obj", text(border) + "p 1\n");
  const auto layer = [](const std::string& svg, const std::string& name) {
    const std::size_t begin = svg.find("<g id=\"" + name + "\"");
    return svg.substr(begin, svg.find("</g>", begin) - begin);
  };
  const CliResult result = unfold(
      {"--notches", "border.obj", "--marks", "drawn.obj", "--inner-lines", "drawn.obj"}, "out.svg");
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  const std::string svg = content_of("out.svg");
  EXPECT_THAT(layer(svg, "notch"), HasSubstr("<path"));
  EXPECT_THAT(layer(svg, "drill"), HasSubstr("<path"));
  EXPECT_THAT(layer(svg, "internal"), HasSubstr("<path"));
  const CliResult remeshed =
      planish({"flatten", "panel.obj", "-o", "out", "--unit", "cm", "--remesh", "--formats", "svg",
               "--notches", "border.obj", "--marks", "drawn.obj", "--inner-lines", "drawn.obj"});
  ASSERT_EQ(remeshed.exit_code, k_exit_done) << remeshed.err;
  EXPECT_THAT(layer(content_of("out/pattern.svg"), "internal"), HasSubstr("<path"));
  write("far.obj", "v 0 0 0\nv 1e5 0 0\nl 1 2\n");
  const CliResult far = unfold({"--inner-lines", "far.obj"}, "far.svg");
  EXPECT_EQ(far.exit_code, k_exit_failed);
  EXPECT_THAT(far.err, HasSubstr("far.obj:3: what is drawn at (0, 0, 0) is farther"));
  EXPECT_FALSE(std::filesystem::exists("far.svg"));
}

TEST_F(AnnotationsFlags, ReachEveryFileOfFlatten) {
  const CliResult result = planish({"flatten", "panel.obj", "-o", "out", "--unit", "cm", "--method",
                                    "controllable", "--formats", "svg,plt", "--allowance", "10mm",
                                    "--grain", "1,0,0", "--quantity", "3"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(content_of("out/pattern.svg"), HasSubstr("cut 3 ×"));
  EXPECT_THAT(content_of("out/pattern.plt"), HasSubstr("SP4"));
}

TEST_F(AnnotationsFlags, GiveTheSameBytesAgain) {
  const Flags flags = {"--allowance", "10mm", "--grain", "0,1,0", "--piece-name", "front"};
  ASSERT_EQ(unfold(flags, "a.pdf").exit_code, k_exit_done);
  ASSERT_EQ(unfold(flags, "b.pdf").exit_code, k_exit_done);
  EXPECT_EQ(content_of("a.pdf"), content_of("b.pdf"));
}

TEST_F(AnnotationsFlags, AreRefusedWhereTheyDoNothing) {
  expect_usage_error({"--allowance", "1cm"}, "--allowance goes with svg, dxf, pdf and plt only",
                     "flat.obj");
  expect_usage_error({"--corners", "round"}, "--corners goes with --allowance only");
  expect_usage_error({"--notch-depth", "3mm"}, "--notch-depth goes with --notches only");
}

TEST_F(AnnotationsFlags, SayHowTheyMustLook) {
  expect_usage_error({"--quantity", "2", "--mirrored", "3"},
                     "--mirrored is 3 but --quantity is 2: no more pieces than there are can be "
                     "mirrored");
  expect_usage_error({"--allowance", "10mm", "--corners", "sharp"}, "mitre, square or round");
  expect_usage_error({"--allowance", "wide"}, "must be a length");
  expect_usage_error({"--allowance", "0"}, "--allowance");
  expect_usage_error({"--allowance", "90m"}, "at most the piece's length");
  expect_usage_error({"--grain", "0,0"}, "a direction such as 0,0,1 or an angle");
  expect_usage_error({"--grain", "0,0,0"}, "a direction such as 0,0,1 or an angle");
  expect_usage_error({"--grain", "1,2,3,4"}, "a direction such as 0,0,1 or an angle");
  expect_usage_error({"--grain", "up"}, "must be an angle");
  expect_usage_error({"--quantity", "0"}, "--quantity");
}

TEST_F(AnnotationsFlags, NameTheFileThatIsAtFault) {
  write("notches.txt", "0.25 v\n0.5 q\n");
  const CliResult kind = unfold({"--notches", "notches.txt"});
  EXPECT_THAT(kind.err, HasSubstr("notches.txt:2: \"q\" is no kind of notch"));
  EXPECT_THAT(unfold({"--marks", "none.txt"}).err, HasSubstr("none.txt"));
  write("notches.txt", "1.5 v\n");
  const CliResult place = unfold({"--notches", "notches.txt", "--piece-name", "front"});
  EXPECT_EQ(place.exit_code, k_exit_failed);
  EXPECT_THAT(place.err, HasSubstr("panel.obj: piece \"front\": the notch at 1.5 of the border"));
}

}  // namespace
}  // namespace planish::cli
