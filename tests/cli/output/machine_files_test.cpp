// Pattern files as machines, viewers and people who cut get them.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "oracle/drawn_lines.h"
#include "output/pattern_output.h"
#include "support/products.h"

namespace planish::cli {
namespace {

using testing::HasSubstr;
using testing::Not;

class MachineFiles : public CliTest {
 protected:
  static CliResult unfold(const std::string& output, const Names& more = {}) {
    Names args = {"unfold", "panel.obj", "-o", output};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  }
  static CliResult lay_out(const Names& more) {
    Names args = {"flatten", "panel.obj", "-o", "out"};
    args.insert(args.end(), more.begin(), more.end());
    return planish(args);
  }
};

std::set<int> pens_in(const std::string& plt) {
  std::set<int> pens;
  for (std::size_t at = plt.find("SP"); at != std::string::npos; at = plt.find("SP", at + 1))
    pens.insert(std::stoi(plt.substr(at + 2)));
  return pens;
}

TEST_F(MachineFiles, OfALaserHaveNoMapUnlessItIsAskedFor) {
  ASSERT_EQ(unfold("plain.svg").exit_code, k_exit_done);
  ASSERT_EQ(unfold("map.svg", {"--map"}).exit_code, k_exit_done);
  const auto has_areas = [](const std::string& path) {
    const std::string svg = content_of(path);
    std::size_t areas = 0;
    for (const oracle::XmlElement& element : oracle::XmlReader(svg).elements()) {
      if (element.name == "path" && element.attributes.at("fill") != "none") ++areas;
    }
    return areas > 0;
  };
  EXPECT_FALSE(has_areas("plain.svg"));
  EXPECT_THAT(content_of("plain.svg"), Not(HasSubstr("strain of the pattern")));
  EXPECT_TRUE(has_areas("map.svg"));
  EXPECT_THAT(content_of("map.svg"), HasSubstr("strain of the pattern"));
  ASSERT_EQ(lay_out({"--formats", "svg"}).exit_code, k_exit_done);
  EXPECT_FALSE(has_areas("out/pattern.svg"));
  EXPECT_THAT(content_of("out/report.html"), HasSubstr("id=\"strain\"")) << "the page shows it";
  EXPECT_THAT(unfold("out.dxf", {"--map"}).err, HasSubstr("--map goes with svg and pdf only"));
}

TEST_F(MachineFiles, HaveTheLayersThatAreAskedForOnly) {
  const Names wanted = {"--allowance", "8mm", "--grain", "0,1,0", "--only-layers", "cut,Grain"};
  for (const char* output : {"a.svg", "a.dxf", "a.pdf", "a.plt"})
    ASSERT_EQ(unfold(output, wanted).exit_code, k_exit_done) << output;
  const std::string svg = content_of("a.svg"), dxf = content_of("a.dxf");
  for (const char* layer : {"cut", "grain"}) {
    EXPECT_THAT(svg, HasSubstr("<g id=\"" + std::string(layer) + "\""));
    EXPECT_THAT(dxf, HasSubstr("\n8\n" + std::string(layer) + "\n"));
  }
  for (const char* layer : {"seam", "label", "annotation"}) {
    EXPECT_THAT(svg, Not(HasSubstr("<g id=\"" + std::string(layer) + "\"")));
    EXPECT_THAT(dxf, Not(HasSubstr("\n8\n" + std::string(layer) + "\n")));
  }
  EXPECT_THAT(content_of("a.pdf"), Not(HasSubstr(" Tj\n")));
  EXPECT_EQ(pens_in(content_of("a.plt")), (std::set<int>{0, 1, 2}));
  Names layout = wanted;
  layout.insert(layout.end(), {"--sheet", "900mm", "--formats", "plt,svg"});
  ASSERT_EQ(lay_out(layout).exit_code, k_exit_done);
  EXPECT_EQ(pens_in(content_of("out/layout.plt")), (std::set<int>{0, 1, 2}));
  EXPECT_THAT(content_of("out/layout.svg"), Not(HasSubstr("<text")));
  layout.insert(layout.end(), {"--nest-margin", "10mm"});
  ASSERT_EQ(lay_out(layout).exit_code, k_exit_done);
  Vec2 low = {1e9, 1e9};
  for (const auto& line : oracle::lines_of_plt(content_of("out/layout.plt"))) {
    for (const Vec2 p : line)
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
  }
  EXPECT_NEAR(low.x, 10.0, 0.2) << "(0, 0) is the corner of the sheet";
  EXPECT_NEAR(low.y, 10.0, 0.2);
}

TEST_F(MachineFiles, NameTheLayersThatThereAre) {
  const CliResult result = unfold("a.svg", {"--only-layers", "cut,notches", "--json"});
  EXPECT_EQ(result.exit_code, k_exit_usage);
  EXPECT_EQ(result.json()["error"]["code"], "unknown_name");
  const std::string message = result.json()["error"]["message"];
  EXPECT_THAT(message, HasSubstr("\"notches\""));
  for (const char* layer : {"strain", "seam", "notch", "grain", "fold", "drill", "internal",
                            "annotation", "label", "legend", "hole", "cut"})
    EXPECT_THAT(message, HasSubstr(layer));
  EXPECT_FALSE(std::filesystem::exists("a.svg"));
  EXPECT_THAT(unfold("a.svg", {"--only-layers", "strain"}).err, HasSubstr("with --map only"));
  EXPECT_THAT(unfold("a.obj", {"--only-layers", "cut"}).err, HasSubstr("--only-layers goes with"));
}

TEST_F(MachineFiles, AreNotedWhereTheirLayersAreEmpty) {
  const Names wanted = {"--allowance", "8mm", "--only-layers", "cut,notch,drill"};
  const CliResult result = unfold("a.svg", wanted);
  EXPECT_EQ(result.exit_code, k_exit_done);
  EXPECT_THAT(result.err, HasSubstr("nothing on notch, drill, only on seam, label, cut"));
  EXPECT_THAT(lay_out({"--formats", "svg", "--only-layers", "grain"}).err,
              HasSubstr("nothing on grain"));
  EXPECT_THAT(unfold("a.svg", {"--only-layers", "cut"}).err, Not(HasSubstr("nothing on")));
}

TEST_F(MachineFiles, OfPlottersBeginAtTheOriginWithEightPensAtMost) {
  std::ofstream("lines.txt") << "100 101\n";
  std::ofstream("marks.txt") << "100 drill\n";
  std::ofstream("notches.txt") << "0.25 v\n";
  const Names all = {"--allowance",   "8mm",         "--grain",      "0,1,0",
                     "--inner-lines", "lines.txt",   "--marks",      "marks.txt",
                     "--notches",     "notches.txt", "--piece-name", "front"};
  Names layout = all;
  layout.insert(layout.end(), {"--sheet", "900mm", "--formats", "plt"});
  ASSERT_EQ(lay_out(layout).exit_code, k_exit_done);
  for (const char* path : {"out/pattern.plt", "out/layout.plt"}) {
    const std::string plt = content_of(path);
    EXPECT_EQ(*pens_in(plt).rbegin(), 8) << path;
    EXPECT_THAT(plt, Not(HasSubstr("-"))) << path;
    Vec2 low = {1e9, 1e9};
    for (const auto& line : oracle::lines_of_plt(plt)) {
      for (const Vec2 p : line)
        low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    }
    EXPECT_EQ(low, Vec2{}) << path;
    EXPECT_LT(plt.find("SP2"), plt.find("SP1")) << path << ": the seam is drawn before the cut";
  }
}

TEST_F(MachineFiles, SayHowLettersBeyondLatinAreSpelled) {
  const CliResult pdf = unfold("a.pdf", {"--piece-name", "Перед"});
  EXPECT_THAT(content_of("a.pdf"), HasSubstr("(Pered) Tj"));
  EXPECT_THAT(pdf.err, HasSubstr("\"Перед\" is written as \"Pered\" in .pdf"));
  const CliResult both = lay_out({"--piece-name", "前片", "--fabric", "Größe"});
  EXPECT_THAT(both.err, HasSubstr("\"前片\" is written as \"u524Du7247\" in .pdf"));
  EXPECT_THAT(both.err, Not(HasSubstr("Größe")));
  EXPECT_THAT(content_of("out/pattern.svg"), HasSubstr(">前片</text>"));
  const CliResult apparel = unfold("a.dxf", {"--piece-name", "Μπροστά", "--dxf-profile", "aama"});
  EXPECT_THAT(apparel.err, HasSubstr("\" in .dxf"));
  EXPECT_THAT(unfold("a.svg", {"--piece-name", "Перед"}).err, Not(HasSubstr("written as")));
}

TEST_F(MachineFiles, OfEarlierRunsAreNamed) {
  const Names two_sheets = {"--quantity", "2", "--sheet", "900mmx900mm", "--formats", "svg,pdf"};
  ASSERT_EQ(lay_out(two_sheets).exit_code, k_exit_done);
  ASSERT_TRUE(std::filesystem::exists("out/layout-2.svg"));
  const CliResult again = lay_out({"--sheet", "3000mm", "--formats", "svg"});
  EXPECT_THAT(again.err, HasSubstr("layout-1.svg"));
  EXPECT_THAT(again.err, HasSubstr("layout-2.pdf"));
  EXPECT_THAT(again.err, HasSubstr("pattern.pdf"));
  EXPECT_THAT(again.err, Not(HasSubstr("layout.svg")));
  for (const auto& entry : std::filesystem::directory_iterator("out")) {
    const std::string stem = entry.path().stem().string(),
                      ending = entry.path().extension().string();
    if (stem.starts_with("layout-") ||
        (ending != ".svg" && pattern_format_of(entry.path().string())))
      std::filesystem::remove(entry.path());
  }
  EXPECT_THAT(lay_out({"--sheet", "3000mm", "--formats", "svg"}).err, Not(HasSubstr("still has")));
}

TEST_F(MachineFiles, OfThisRunAreKnownInAFolderWithASlash) {
  const std::vector<std::string> args = {"flatten", "panel.obj", "-o",
                                         "slash/",  "--formats", "svg"};
  ASSERT_EQ(planish(args).exit_code, k_exit_done);
  EXPECT_THAT(planish(args).err, Not(HasSubstr("still has")));
}

TEST_F(MachineFiles, OfPiecesThatAreNoMoreAreNamed) {
  write_product("coat.obj",
                {{"left", make_shape("saddle", 200), {}}, {"back", make_shape("dome", 200), {}}});
  write_product("less.obj",
                {{"left", make_shape("saddle", 200), {}}, {"hood", make_shape("dome", 200), {}}});
  const auto flatten = [](const std::string& input, const std::string& formats) {
    return planish({"flatten", input, "-o", "out", "--method", "controllable", "--sweeps", "1",
                    "--formats", formats});
  };
  EXPECT_THAT(flatten("coat.obj", "svg,dxf").err, Not(HasSubstr("still has")));
  const std::string err = flatten("less.obj", "svg").err;
  EXPECT_THAT(err, HasSubstr("still has back, "));
  EXPECT_THAT(err, HasSubstr("left/pattern.dxf"));
  EXPECT_THAT(err, Not(HasSubstr("left/pattern.svg")));
  EXPECT_THAT(err, Not(HasSubstr("hood/")));
}

TEST_F(MachineFiles, LongerThanAPageAreDividedAndSaySo) {
  const CliResult result = unfold("a.pdf", {"--unit", "cm"});
  ASSERT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, HasSubstr("a.pdf is divided into "));
  EXPECT_THAT(content_of("a.pdf"), Not(HasSubstr("UserUnit")));
  EXPECT_THAT(unfold("b.pdf").err, Not(HasSubstr("divided")));
  EXPECT_THAT(unfold("c.pdf", {"--paper", "a4"}).err, Not(HasSubstr("divided")));
  EXPECT_THAT(unfold("d.pdf", {"--unit", "m"}).err, HasSubstr("d.pdf has a page of more than"));
}

}  // namespace
}  // namespace planish::cli
