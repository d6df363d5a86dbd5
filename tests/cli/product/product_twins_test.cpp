#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <planish/io/read_mesh.h>

#include <gmock/gmock.h>

#include "cli/cli_run.h"
#include "oracle/drawn_lines.h"
#include "support/products.h"
#include "support/twins.h"

namespace planish::cli {
namespace {

using oracle::Lines;
using testing::HasSubstr;
using testing::Not;

TriMesh sleeve() {
  return meshes::rough_grid(12, 9, 3, 0.2, 0.3);
}

TriMesh as_twin(const TriMesh& mesh) {
  return meshes::in_floats(meshes::renumbered(meshes::turned(meshes::mirrored(mesh))));
}

CliResult flatten_coat(const std::string& folder, const std::vector<std::string>& more = {}) {
  std::vector<std::string> args = {"flatten", "coat.obj", "-o", folder, "--unit", "cm"};
  args.insert(args.end(), more.begin(), more.end());
  return planish(args);
}

class ProductTwinsTest : public CliTest {
 protected:
  void SetUp() override {
    CliTest::SetUp();
    write_product("coat.obj", {{"left", sleeve(), {}},
                               {"back", make_shape("saddle", 200), {}},
                               {"right", as_twin(sleeve()), {}},
                               {"spare", meshes::renumbered(meshes::turned(sleeve())), {}}});
  }
};

long long thousandths(double millimetres) {
  return std::llround(1000.0 * millimetres);
}

/// Whether lines as they are in two files are mirror images, digit by digit.
void expect_mirrored(const Lines& first, const Lines& second) {
  ASSERT_EQ(first.size(), second.size());
  ASSERT_FALSE(first.empty());
  for (std::size_t k = 0; k < first.size(); ++k) {
    const auto &line = first[k], &image = second[k];
    ASSERT_EQ(line.size(), image.size());
    const long long sum = thousandths(line[0].x) + thousandths(image[0].x);
    for (std::size_t i = 0; i < line.size(); ++i) {
      // Both go around counter-clockwise, and end where they begin.
      const Vec2 p = line[i], q = image[image.size() - 1 - i];
      EXPECT_EQ(thousandths(p.x) + thousandths(q.x), sum) << k << " " << i;
      EXPECT_EQ(thousandths(p.y), thousandths(q.y)) << k << " " << i;
    }
  }
}

/// The lines of one layer of an SVG file.
Lines svg_layer(const std::string& path, const std::string& name) {
  const std::string svg = content_of(path);
  const std::size_t begin = svg.find("<g id=\"" + name + "\"");
  const std::size_t end = svg.find("</g>", begin);
  return oracle::lines_of_svg(svg.substr(begin, end + 4 - begin));
}

/// The lines of the PDF's last layer, "cut".
Lines pdf_cut(const std::string& path) {
  const std::string pdf = content_of(path);
  const std::size_t begin = pdf.find("/OC /L11 BDC");
  std::istringstream words(pdf.substr(begin, pdf.find("EMC", begin) - begin));
  Lines lines;
  std::vector<double> numbers;
  for (std::string word; words >> word;) {
    char* end = nullptr;
    const double number = std::strtod(word.c_str(), &end);
    if (*end == '\0') {
      numbers.push_back(number);
      continue;
    }
    if (word == "m") lines.emplace_back();
    const std::size_t points = word == "c" ? 3 : word == "m" || word == "l" ? 1 : 0;
    for (std::size_t k = points; k > 0; --k)
      lines.back().push_back(
          {numbers[numbers.size() - 2 * k], numbers[numbers.size() - 2 * k + 1]});
    if (word == "h" && !(lines.back().back() == lines.back().front()))
      lines.back().push_back(lines.back().front());
  }
  return lines;
}

TEST_F(ProductTwinsTest, WriteTheMirrorImageToTheLastDigit) {
  ASSERT_EQ(flatten_coat("out", {"--allowance", "7mm"}).exit_code, k_exit_done);
  const auto file = [](const std::string& piece, const char* kind) {
    return "out/" + piece + "/pattern." + kind;
  };
  for (const char* layer : {"cut", "seam"})
    expect_mirrored(svg_layer(file("left", "svg"), layer), svg_layer(file("right", "svg"), layer));
  expect_mirrored(pdf_cut(file("left", "pdf")), pdf_cut(file("right", "pdf")));
  const auto dxf_lines = [&](const char* piece) {
    const Lines lines = oracle::lines_of_dxf(content_of(file(piece, "dxf")));
    return Lines{lines.front(), lines.back()};  // seam and cut, the block of words between them
  };
  expect_mirrored(dxf_lines("left"), dxf_lines("right"));
  // Of the equal one they are the same.
  EXPECT_EQ(svg_layer(file("left", "svg"), "cut"), svg_layer(file("spare", "svg"), "cut"));
  // The pattern as a mesh: the same numbers with another sign, in another order.
  const auto places = [](const std::string& path, double sign) {
    std::vector<std::pair<double, double>> all;
    for (const Vec3 p : read_mesh(path).mesh.positions)
      all.emplace_back(sign * p.x, p.y);
    std::sort(all.begin(), all.end());
    return all;
  };
  EXPECT_EQ(places("out/left/flat.obj", 1.0), places("out/right/flat.obj", -1.0));
}

TEST_F(ProductTwinsTest, AreOnePieceInTheFileForApparelPrograms) {
  const Names profile = {"--formats", "dxf", "--dxf-profile", "astm", "--quantity", "2"};
  ASSERT_EQ(flatten_coat("out", profile).exit_code, k_exit_done);
  const std::string dxf = content_of("out/garment.dxf");
  EXPECT_EQ(oracle::tags_of_dxf(dxf).back().second, "EOF");
  EXPECT_THAT(dxf, HasSubstr("Piece Name: left\n"));
  EXPECT_THAT(dxf, Not(HasSubstr("Piece Name: right\n")));
  EXPECT_THAT(dxf, HasSubstr("Quantity: 4,2\n")) << "left, spare, and right mirrored";
  ASSERT_EQ(flatten_coat("plain", {"--formats", "dxf"}).exit_code, k_exit_done);
  EXPECT_FALSE(std::filesystem::exists("plain/garment.dxf")) << "generic files have no pieces";
}

TEST_F(ProductTwinsTest, SayInWordsWhoseTheyAre) {
  const CliResult result = flatten_coat("out", {"--formats", "svg"});
  EXPECT_THAT(result.err, testing::ContainsRegex("right .* mirror image of left\n"));
  EXPECT_THAT(result.err, testing::ContainsRegex("spare .* equal to left\n"));
  EXPECT_THAT(result.out, HasSubstr("Of 4 patches 2 are made from another one"));
  EXPECT_THAT(content_of("out/garment.svg"), HasSubstr("right (mirror image of left)"));
  EXPECT_THAT(content_of("out/right/report.html"), HasSubstr("mirror image of left"));
  EXPECT_THAT(content_of("out/left/report.html"), Not(HasSubstr("mirror image of")));
  // The label is that of the piece.
  EXPECT_THAT(content_of("out/right/pattern.svg"), HasSubstr(">right</text>"));
  EXPECT_THAT(content_of("out/right/pattern.svg"), Not(HasSubstr(">left</text>")));
  const auto json = nlohmann::json::parse(content_of("out/garment.json"));
  EXPECT_FALSE(json["patches"][0].contains("twin"));
  EXPECT_EQ(json["patches"][2]["twin"]["of"], "left");
  EXPECT_EQ(json["patches"][2]["twin"]["mirrored"], true);
  EXPECT_EQ(json["patches"][3]["twin"]["mirrored"], false);
  const auto report = nlohmann::json::parse(content_of("out/right/report.json"));
  EXPECT_EQ(report["twin"], json["patches"][2]["twin"]);
  EXPECT_EQ(report["name"], "right");
}

TEST_F(ProductTwinsTest, LieMirroredInTheDrawingOfTheProduct) {
  ASSERT_EQ(flatten_coat("out", {"--formats", "svg"}).exit_code, k_exit_done);
  const Lines cuts = svg_layer("out/garment.svg", "cut");
  ASSERT_EQ(cuts.size(), 4U);
  const auto outline = [](const std::vector<Vec2>& line, double sign) {
    std::vector<std::pair<long long, long long>> places;
    for (const Vec2 p : line)
      places.emplace_back(thousandths(sign * p.x), thousandths(p.y));
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    const auto [x, y] = places.front();
    long long low = y;
    for (const auto& place : places)
      low = std::min(low, place.second);
    for (auto& place : places)
      place = {place.first - x, place.second - low};
    return places;
  };
  EXPECT_EQ(outline(cuts[0], 1.0), outline(cuts[2], -1.0));
  EXPECT_EQ(outline(cuts[0], 1.0), outline(cuts[3], 1.0));
}

TEST_F(ProductTwinsTest, AreTheSameOnAnyNumberOfThreads) {
  for (const char* threads : {"1", "4"})
    ASSERT_EQ(flatten_coat(threads, {"--threads", threads}).exit_code, k_exit_done);
  for (const char* name : {"left", "back", "right", "spare"}) {
    for (const char* file : {"pattern.svg", "pattern.dxf", "processed.obj", "flat.obj"}) {
      const std::string path = std::string("/") + name + "/" + file;
      EXPECT_EQ(content_of("1" + path), content_of("4" + path)) << path;
    }
  }
}

TEST_F(ProductTwinsTest, LeaveTheOtherOneAsItIsAlone) {
  ASSERT_EQ(flatten_coat("out", {"--formats", "svg"}).exit_code, k_exit_done);
  write_mesh("left.obj", sleeve());
  ASSERT_EQ(planish({"flatten", "left.obj", "-o", "alone", "--unit", "cm", "--formats", "svg",
                     "--piece-name", "left"})
                .exit_code,
            k_exit_done);
  for (const char* file : {"/pattern.svg", "/processed.obj", "/flat.obj"})
    EXPECT_EQ(content_of(std::string("out/left") + file), content_of(std::string("alone") + file));
}

TEST_F(ProductTwinsTest, AreKeptAndMadeAnewOnResume) {
  ASSERT_EQ(flatten_coat("out").exit_code, k_exit_done);
  const std::string pattern = content_of("out/right/pattern.svg");
  const std::string picture = content_of("out/garment.svg");
  const auto kept = [&](const std::string& err) {
    std::size_t count = 0;
    for (std::size_t at = err.find("(from the earlier run)"); at != std::string::npos;
         at = err.find("(from the earlier run)", at + 1))
      ++count;
    return count;
  };
  const CliResult all = flatten_coat("out", {"--resume"});
  EXPECT_EQ(kept(all.err), 4U);
  EXPECT_THAT(all.err,
              testing::ContainsRegex("right .* mirror image of left  .from the earlier run."));
  EXPECT_EQ(content_of("out/garment.svg"), picture);
  std::filesystem::remove_all("out/right");
  EXPECT_EQ(kept(flatten_coat("out", {"--resume"}).err), 2U) << "back and spare";
  EXPECT_EQ(content_of("out/right/pattern.svg"), pattern);
  std::filesystem::remove_all("out/left");
  EXPECT_EQ(kept(flatten_coat("out", {"--resume"}).err), 3U);
  EXPECT_EQ(content_of("out/garment.svg"), picture);
}

TEST_F(ProductTwinsTest, HaveTheGrainMirroredThatIsAnAngle) {
  ASSERT_EQ(flatten_coat("out", {"--grain", "20", "--formats", "svg"}).exit_code, k_exit_done);
  const auto direction = [](const std::string& piece) {
    const Lines lines = svg_layer("out/" + piece + "/pattern.svg", "grain");
    const Vec2 along = lines.at(0).at(1) - lines.at(0).at(0);
    return along.y / along.x;
  };
  EXPECT_NEAR(direction("left"), -std::tan(20.0 * 3.14159265358979 / 180.0), 1e-3);  // y is down
  EXPECT_NEAR(direction("right"), -direction("left"), 1e-3);
  EXPECT_NEAR(direction("spare"), direction("left"), 1e-3);
}

TEST_F(ProductTwinsTest, AreWorkedOnAloneWhereTheOtherOneFails) {
  write_product("coat.obj", {{"left", meshes::fins(), {}}, {"right", meshes::fins(), {}}});
  const CliResult result = flatten_coat("out");
  EXPECT_EQ(result.exit_code, k_exit_failed);
  EXPECT_THAT(result.err, HasSubstr("could not be flattened: left, right\n"));
}

TEST_F(ProductTwinsTest, MayBeSingleTriangles) {
  const TriMesh one{{{0, 0, 0}, {30, 0, 0}, {10, 10, 25}}, {{0, 1, 2}}};
  TriMesh pair = one;
  pair.positions.push_back({0, 30, 0});  // two triangles, or all would be loose
  pair.triangles.push_back({0, 2, 3});
  write_product("coat.obj", {{"left", one, {}}, {"right", as_twin(one), {}}, {"other", pair, {}}});
  const CliResult result = flatten_coat("out");
  EXPECT_EQ(result.exit_code, k_exit_done) << result.err;
  EXPECT_THAT(result.err, testing::ContainsRegex("right .* mirror image of left\n"));
  expect_mirrored(svg_layer("out/left/pattern.svg", "cut"),
                  svg_layer("out/right/pattern.svg", "cut"));
}

TEST_F(ProductTwinsTest, KeepTheLengthsOfSeamsThatMatch) {
  // Left and right meet in the middle of the model, where x is 0.
  const TriMesh right = meshes::rough_grid(8, 6, 4, 0.2, 0.3);
  TriMesh straight = right;
  for (Vec3& p : straight.positions) {
    if (p.x < 0.5) p.x = 0.0;
  }
  write_product("coat.obj", {{"left", straight, {}}, {"right", meshes::mirrored(straight), {}}});
  const auto json = flatten_coat("out", {"--json"}).json();
  EXPECT_EQ(json["patches"][1]["twin"]["of"], "left");
  ASSERT_EQ(json["seams"].size(), 1U);
  EXPECT_LT(json["seams"][0]["difference"], 1e-9);
  EXPECT_NEAR(json["seams"][0]["sides"][1]["length"], json["seams"][0]["length_on_model"], 1e-8);
}

}  // namespace
}  // namespace planish::cli
